// Setting a property to what it is must not make the pipeline run again, changing it must; what is
// out of range is refused or set right; all of them are printed.
#include "vtkCartesianMesher.h"
#include "vtkCellAssembler.h"
#include "vtkPatcher.h"
#include "vtkPolyMeshWriter.h"
#include "vtkRefinementRegion.h"

#include "vtkCallbackCommand.h"
#include "vtkErrorCode.h"
#include "vtkNew.h"

#include <gtest/gtest.h>

#include <functional>
#include <new>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace
{

// How many errors an object reports while `work` runs.
int errorsOf(vtkObject* object, const std::function<void()>& work)
{
  int errors = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&errors);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  const unsigned long tag = object->AddObserver(vtkCommand::ErrorEvent, count);
  work();
  object->RemoveObserver(tag);
  return errors;
}

void expectToPrint(vtkObject* object, const std::vector<std::string>& lines)
{
  std::ostringstream text;
  object->Print(text);
  for (const std::string& line : lines)
  {
    EXPECT_NE(text.str().find("  " + line + "\n"), std::string::npos)
      << "no \"" << line << "\" in\n"
      << text.str();
  }
}

// Runs any work as a filter does.
class Worker : public vtkCartesianAlgorithm
{
public:
  static Worker* New()
  {
    auto* worker = new Worker;
    worker->InitializeObjectBase();
    return worker;
  }
  vtkTypeMacro(Worker, vtkCartesianAlgorithm);

  bool Do(const std::function<void()>& work)
  {
    return this->Run(0, 1, [&](cartesian::Execution&) { work(); });
  }
};

}

TEST(Properties, NoExceptionLeavesAFilter)
{
  vtkNew<Worker> worker;
  EXPECT_TRUE(worker->Do([] {}));
  EXPECT_EQ(worker->GetErrorCode(), static_cast<unsigned long>(vtkErrorCode::NoError));
  const auto expectCode = [&](unsigned long code, const std::function<void()>& work) {
    EXPECT_EQ(errorsOf(worker, [&] { EXPECT_FALSE(worker->Do(work)); }), 1);
    EXPECT_EQ(worker->GetErrorCode(), code);
  };
  expectCode(vtkCartesianAlgorithm::OutOfMemory, [] { throw std::bad_alloc(); });
  expectCode(vtkErrorCode::UnknownError, [] { throw std::logic_error("a fault of ours"); });
  expectCode(vtkErrorCode::UnknownError, [] { throw 1; });
}

TEST(Properties, EnumsAreSetByName)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetPatchMethodToMarchingCubes();
  EXPECT_EQ(mesher->GetPatchMethod(), vtkCartesianMesher::MarchingCubes);
  EXPECT_TRUE(mesher->GetTrueVolume());
  mesher->TrueVolumeOff();
  EXPECT_FALSE(mesher->GetTrueVolume());
  mesher->SetTyingToMoveNodes();
  EXPECT_EQ(mesher->GetTying(), vtkCartesianMesher::MoveNodes);
  mesher->SetSmallCellsToRemove();
  EXPECT_EQ(mesher->GetSmallCells(), vtkCartesianMesher::Remove);
  mesher->SetPatchMethod(7);
  EXPECT_EQ(mesher->GetPatchMethod(), vtkCartesianMesher::MarchingCubes);

  vtkNew<vtkRefinementRegion> region;
  region->SetShapeToSphere();
  EXPECT_EQ(region->GetShape(), vtkRefinementRegion::Sphere);
  vtkNew<vtkPolyMeshWriter> writer;
  writer->SetFileTypeToASCII();
  EXPECT_EQ(writer->GetFileType(), VTK_ASCII);
  writer->SetRegionsAs(vtkPolyMeshWriter::Zones);
  EXPECT_EQ(writer->GetRegionsAs(), vtkPolyMeshWriter::Zones);
  writer->AddZoneRegion("rotor");
  ASSERT_EQ(writer->GetNumberOfZoneRegions(), 1);
  EXPECT_EQ(writer->GetZoneRegion(0), "rotor");
  writer->ClearZoneRegions();
  EXPECT_EQ(writer->GetNumberOfZoneRegions(), 0);
  writer->SetZoneBorders(vtkPolyMeshWriter::CyclicAMI);
  EXPECT_EQ(writer->GetZoneBorders(), vtkPolyMeshWriter::CyclicAMI);
}

TEST(Properties, MeshlinesOfEachAxisAreKeptApart)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetNumberOfMeshlinesX(2);
  mesher->SetMeshlineX(1, 1.5);
  mesher->SetNumberOfMeshlinesZ(1);
  mesher->SetMeshlineZ(0, -3.0);
  EXPECT_EQ(mesher->GetNumberOfMeshlines(0), 2);
  EXPECT_EQ(mesher->GetNumberOfMeshlines(1), 0);
  EXPECT_EQ(mesher->GetNumberOfMeshlines(2), 1);
  EXPECT_EQ(mesher->GetMeshline(0, 1), 1.5);
  EXPECT_EQ(mesher->GetMeshline(2, 0), -3.0);
}

TEST(Properties, MeshlinesThatAreNotThereAreRefused)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetNumberOfMeshlinesY(2);
  const vtkMTimeType before = mesher->GetMTime();
  const std::vector<std::function<void()>> wrong = {
    [&] { mesher->SetMeshlineY(2, 1); },
    [&] { mesher->SetMeshlineY(-1, 1); },
    [&] { mesher->SetMeshlineX(0, 1); },
    [&] { mesher->SetMeshline(3, 0, 1); },
    [&] { mesher->SetMeshline(-1, 0, 1); },
    [&] { mesher->SetNumberOfMeshlines(3, 2); },
    [&] { mesher->SetNumberOfMeshlines(0, -1); },
    [&] { mesher->GetMeshline(0, 0); },
  };
  for (std::size_t i = 0; i < wrong.size(); ++i)
  {
    EXPECT_EQ(errorsOf(mesher, wrong[i]), 1) << i;
  }
  EXPECT_EQ(mesher->GetNumberOfMeshlines(3), 0);
  EXPECT_EQ(mesher->GetMTime(), before);
}

TEST(Properties, OnlyAChangeModifies)
{
  vtkNew<vtkCartesianMesher> mesher;
  const auto setAll = [&](double length, const char* name) {
    mesher->SetNumberOfMeshlinesY(2);
    mesher->SetMeshlineY(1, length);
    mesher->SetCellSize(length);
    mesher->SetMemoryLimit(length);
    mesher->SetSmallCellRatio(length);
    mesher->SetNumberOfThreads(static_cast<int>(length));
    mesher->SetPatchMethod(vtkPatcher::ExactFit);
    mesher->SetBoundaryArray(name);
    mesher->SetNumberOfBoundaryNames(1);
    mesher->SetBoundaryName(0, name);
    mesher->SetNumberOfBoundarySmallCellRatios(1);
    mesher->SetBoundarySmallCellRatio(0, length);
  };
  setAll(2.5, "Side");
  const vtkMTimeType before = mesher->GetMTime();
  setAll(2.5, "Side");
  EXPECT_EQ(mesher->GetMTime(), before);
  const std::vector<std::function<void()>> changes = {
    [&] { mesher->SetNumberOfMeshlinesY(3); },
    [&] { mesher->SetMeshlineY(1, 3.5); },
    [&] { mesher->SetCellSize(3.5); },
    [&] { mesher->SetMemoryLimit(3.5); },
    [&] { mesher->SetSmallCellRatio(0.5); },
    [&] { mesher->SetNumberOfThreads(3); },
    [&] { mesher->SetBoundaryArray(""); },
    [&] { mesher->SetBoundaryName(0, "Other"); },
    [&] { mesher->SetBoundarySmallCellRatio(0, 3.5); },
    [&] { mesher->SetNumberOfBoundaryTypes(1); },
  };
  for (std::size_t i = 0; i < changes.size(); ++i)
  {
    const vtkMTimeType last = mesher->GetMTime();
    changes[i]();
    EXPECT_GT(mesher->GetMTime(), last) << i;
  }
}

TEST(Properties, NegativeThreadsAndMemoryBecomeAutomatic)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetNumberOfThreads(-4);
  mesher->SetMemoryLimit(-1.0);
  EXPECT_EQ(mesher->GetNumberOfThreads(), 0);
  EXPECT_EQ(mesher->GetMemoryLimit(), 0.0);
}

TEST(Properties, AllArePrinted)
{
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetNumberOfThreads(3);
  mesher->SetCellSize(0.25);
  mesher->SetNumberOfMeshlinesX(2);
  mesher->SetMeshlineX(1, 1.5);
  mesher->SetNumberOfMeshlinesZ(1);
  mesher->SetMemoryLimit(8);
  mesher->SetBoundaryArray("Side");
  mesher->SetSmallCellRatio(0.125);
  expectToPrint(mesher,
    { "NumberOfThreads: 3", "CellSize: 0.25", "MeshlinesX: 0 1.5", "MeshlinesY:", "MeshlinesZ: 0",
      "MemoryLimit: 8", "BoundaryArray: Side", "PatchMethod: 0", "SmallCellRatio: 0.125" });

  vtkNew<vtkPatcher> patcher;
  patcher->SetBoundaryArray("Side");
  expectToPrint(patcher, { "NumberOfThreads: 0", "BoundaryArray: Side", "PatchMethod: 0" });

  vtkNew<vtkCellAssembler> assembler;
  assembler->SetNumberOfBoundaryNames(2);
  assembler->SetBoundaryName(1, "inlet");
  assembler->SetNumberOfBoundaryTypes(1);
  assembler->SetBoundaryType(0, "wall");
  EXPECT_EQ(errorsOf(assembler, [&] { assembler->SetBoundaryType(1, "patch"); }), 1);
  expectToPrint(assembler,
    { "NumberOfThreads: 0", "SmallCellRatio: 0.001", "BoundaryNames:  inlet", "BoundaryTypes: wall",
      "BoundarySmallCellRatios:" });

  vtkNew<vtkPolyMeshWriter> writer;
  expectToPrint(writer,
    { "FileName: (none)", "FileType: 2", "RegionsAs: 0", "ZoneRegions: 0", "ZoneBorders: 0" });
  writer->SetFileName("case.foam");
  writer->SetFileType(0); // there is none
  expectToPrint(writer, { "FileName: case.foam", "FileType: 1" });
}
