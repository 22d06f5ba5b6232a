// The filters as parts of a pipeline: when they run, what they report on the way, how they stop.
#include "vtkCartesianBoxer.h"
#include "vtkCartesianMesher.h"
#include "vtkCellAssembler.h"
#include "vtkPatcher.h"

#include "vtkCallbackCommand.h"
#include "vtkCell.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"
#include "vtkUnstructuredGrid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <thread>
#include <vector>

namespace
{

struct Report
{
  double progress;
  std::string text;
  std::thread::id thread;
};

// All that an algorithm reports; asks it to stop when its progress gets to `stopAt`.
class Observer
{
public:
  Observer(vtkAlgorithm* algorithm, double stopAt)
    : stopAt_(stopAt)
  {
    command_->SetClientData(this);
    command_->SetCallback([](vtkObject* caller, unsigned long, void* self, void*) {
      static_cast<Observer*>(self)->hear(vtkAlgorithm::SafeDownCast(caller));
    });
    algorithm->AddObserver(vtkCommand::ProgressEvent, command_);
  }

  const std::vector<Report>& reports() const { return reports_; }

private:
  void hear(vtkAlgorithm* algorithm)
  {
    const char* text = algorithm->GetProgressText();
    reports_.push_back({ algorithm->GetProgress(), text ? text : "", std::this_thread::get_id() });
    if (algorithm->GetProgress() >= stopAt_)
    {
      algorithm->SetAbortExecute(1);
    }
  }

  vtkNew<vtkCallbackCommand> command_;
  double stopAt_;
  std::vector<Report> reports_;
};

constexpr double Never = 2;

vtkNew<vtkSphereSource> sphere()
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(40);
  source->SetPhiResolution(40);
  return source;
}

vtkUnstructuredGrid* mesh(vtkAlgorithm* filter)
{
  return vtkUnstructuredGrid::SafeDownCast(filter->GetOutputDataObject(0));
}

vtkPolyData* boundary(vtkAlgorithm* filter)
{
  return vtkPolyData::SafeDownCast(filter->GetOutputDataObject(1));
}

}

TEST(Pipeline, RunsAgainOnlyAfterAChange)
{
  const auto source = sphere();
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetInputConnection(source->GetOutputPort());
  int runs = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&runs);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*) { ++*static_cast<int*>(data); });
  mesher->AddObserver(vtkCommand::StartEvent, count);

  mesher->Update();
  mesher->Update();
  mesher->SetCellSize(mesher->GetCellSize());
  mesher->Update(1);
  EXPECT_EQ(runs, 1);
  const vtkIdType cells = mesh(mesher)->GetNumberOfCells();

  mesher->SetCellSize(0.1);
  mesher->Update();
  EXPECT_EQ(runs, 2);
  EXPECT_LT(mesh(mesher)->GetNumberOfCells(), cells);

  mesher->SetNumberOfMeshlinesX(2);
  mesher->SetMeshlineX(0, -1);
  mesher->SetMeshlineX(1, 1);
  mesher->Update();
  EXPECT_EQ(runs, 3);
  EXPECT_LE(mesh(mesher)->GetNumberOfCells(), 100);

  mesher->SetNumberOfMeshlinesX(0);
  mesher->SetCellSize(0);
  mesher->Update();
  EXPECT_EQ(runs, 4);
  EXPECT_EQ(mesh(mesher)->GetNumberOfCells(), cells);

  source->SetRadius(2);
  mesher->Update();
  EXPECT_EQ(runs, 5);
}

TEST(Pipeline, ErrorsGoWhenTheirCauseGoes)
{
  const auto source = sphere();
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetInputConnection(source->GetOutputPort());
  mesher->SetCellSize(-1);
  mesher->Update();
  EXPECT_EQ(mesher->GetErrorCode(), vtkCartesianAlgorithm::BadCellSize);
  EXPECT_EQ(mesh(mesher)->GetNumberOfCells(), 0);
  mesher->SetCellSize(0.1);
  mesher->Update();
  EXPECT_EQ(mesher->GetErrorCode(), 0U);
  EXPECT_GT(mesh(mesher)->GetNumberOfCells(), 0);
  mesher->SetSmallCellRatio(1);
  mesher->Update();
  EXPECT_EQ(mesher->GetErrorCode(), vtkCartesianAlgorithm::BadParameter);
  EXPECT_EQ(mesh(mesher)->GetNumberOfCells(), 0);
  EXPECT_EQ(boundary(mesher)->GetNumberOfCells(), 0);
}

TEST(Pipeline, ProgressGrowsAndNamesTheStages)
{
  const auto source = sphere();
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetInputConnection(source->GetOutputPort());
  mesher->SetNumberOfThreads(4);
  const Observer observer(mesher, Never);
  mesher->Update();

  std::vector<std::string> stages;
  double last = 0;
  for (const Report& report : observer.reports())
  {
    EXPECT_GE(report.progress, last) << report.text;
    EXPECT_EQ(report.thread, std::this_thread::get_id());
    last = report.progress;
    // VTK itself reports the beginning and the end, with the text of then.
    if (!report.text.empty() && (stages.empty() || stages.back() != report.text))
    {
      stages.push_back(report.text);
    }
  }
  EXPECT_EQ(last, 1);
  const std::vector<std::string> expected = { "Scaling and Dual Levels", "Defects of the surface",
    "Boxes", "Patches", "Common sides of boxes", "Inner faces", "Cells", "Opening of the wall",
    "Edits of the wall", "Closing of the wall", "Checks of cells", "Numbering",
    "Writing the mesh" };
  EXPECT_EQ(stages, expected);
}

TEST(Pipeline, EveryFilterReportsProgress)
{
  const auto source = sphere();
  vtkNew<vtkCartesianBoxer> boxer;
  boxer->SetInputConnection(source->GetOutputPort());
  vtkNew<vtkPatcher> patcher;
  patcher->SetInputConnection(0, source->GetOutputPort());
  patcher->SetInputConnection(1, boxer->GetOutputPort());
  vtkNew<vtkCellAssembler> assembler;
  assembler->SetInputConnection(0, boxer->GetOutputPort());
  assembler->SetInputConnection(1, patcher->GetOutputPort());
  for (vtkAlgorithm* filter : std::vector<vtkAlgorithm*>{ boxer, patcher, assembler })
  {
    const Observer observer(filter, Never);
    filter->Update();
    EXPECT_GE(observer.reports().size(), 4U) << filter->GetClassName();
    double last = 0;
    for (const Report& report : observer.reports())
    {
      EXPECT_GE(report.progress, last) << filter->GetClassName() << ": " << report.text;
      last = report.progress;
    }
    EXPECT_LT(observer.reports()[2].progress, 0.2) << filter->GetClassName();
    filter->RemoveAllObservers();
  }
}

// Their offsets were bytes, in 1/64 of a global box, and nothing said so.
TEST(Pipeline, BoxesOfEarlierVersionsAreRead)
{
  const auto source = sphere();
  vtkNew<vtkCartesianBoxer> boxer;
  boxer->SetInputConnection(source->GetOutputPort());
  boxer->SetCellSize(0.3);
  boxer->SetRefinementDepth(2);
  boxer->Update();
  auto* boxes = vtkUnstructuredGrid::SafeDownCast(boxer->GetOutputDataObject(0));
  vtkNew<vtkUnstructuredGrid> earlier;
  earlier->ShallowCopy(boxes);
  vtkNew<vtkUnsignedCharArray> offsets;
  offsets->DeepCopy(boxes->GetCellData()->GetArray("Offset"));
  offsets->SetName("Offset");
  earlier->GetCellData()->AddArray(offsets);
  ASSERT_TRUE(earlier->GetFieldData()->HasArray("PartsPerBox"));
  earlier->GetFieldData()->RemoveArray("PartsPerBox");
  ASSERT_EQ(earlier->GetCellData()->GetArray("Offset")->GetDataType(), VTK_UNSIGNED_CHAR);

  std::vector<vtkSmartPointer<vtkUnstructuredGrid>> meshes;
  for (vtkUnstructuredGrid* given : { boxes, earlier.Get() })
  {
    vtkNew<vtkPatcher> patcher;
    patcher->SetInputConnection(0, source->GetOutputPort());
    patcher->SetInputDataObject(1, given);
    vtkNew<vtkCellAssembler> assembler;
    assembler->SetInputDataObject(0, given);
    assembler->SetInputConnection(1, patcher->GetOutputPort());
    assembler->Update();
    meshes.push_back(vtkUnstructuredGrid::SafeDownCast(assembler->GetOutputDataObject(0)));
  }
  ASSERT_GT(meshes[0]->GetNumberOfCells(), 100);
  ASSERT_EQ(meshes[1]->GetNumberOfCells(), meshes[0]->GetNumberOfCells());
  ASSERT_EQ(meshes[1]->GetNumberOfPoints(), meshes[0]->GetNumberOfPoints());
  for (vtkIdType i = 0; i < meshes[0]->GetNumberOfPoints(); ++i)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      ASSERT_EQ(meshes[1]->GetPoint(i)[axis], meshes[0]->GetPoint(i)[axis]);
    }
  }
}

TEST(Pipeline, StopsWhereverItIsAskedTo)
{
  const auto source = sphere();
  for (const double stopAt : { 0.0, 0.05, 0.2, 0.3, 0.52, 0.6, 0.7, 0.85, 0.9 })
  {
    vtkNew<vtkCartesianMesher> mesher;
    mesher->SetInputConnection(source->GetOutputPort());
    const Observer observer(mesher, stopAt);
    mesher->Update();
    EXPECT_EQ(mesher->GetErrorCode(), vtkCartesianAlgorithm::Stopped) << stopAt;
    EXPECT_EQ(mesh(mesher)->GetNumberOfCells(), 0) << stopAt;
    EXPECT_EQ(mesh(mesher)->GetNumberOfPoints(), 0) << stopAt;
    EXPECT_EQ(boundary(mesher)->GetNumberOfCells(), 0) << stopAt;

    mesher->RemoveAllObservers();
    mesher->SetAbortExecute(0);
    mesher->Modified();
    mesher->Update();
    EXPECT_EQ(mesher->GetErrorCode(), 0U) << stopAt;
    EXPECT_GT(mesh(mesher)->GetNumberOfCells(), 0) << stopAt;
  }
}

TEST(Pipeline, OutputsHaveTheirTypesAndArrays)
{
  const auto source = sphere();
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetInputConnection(source->GetOutputPort());
  mesher->SetCellSize(0.2);
  mesher->Update();
  ASSERT_TRUE(mesh(mesher));
  ASSERT_TRUE(boundary(mesher));
  EXPECT_EQ(mesh(mesher)->GetPoints()->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(boundary(mesher)->GetPoints()->GetDataType(), VTK_DOUBLE);
  vtkCellData* cells = mesh(mesher)->GetCellData();
  ASSERT_TRUE(cells->GetArray("GlobalBox"));
  EXPECT_STREQ(cells->GetArray("GlobalBox")->GetComponentName(2), "K");
  EXPECT_EQ(cells->GetArray("Region")->GetDataType(), VTK_INT);
  EXPECT_EQ(cells->GetArray("VolumeFraction")->GetDataType(), VTK_DOUBLE);
  EXPECT_EQ(boundary(mesher)->GetCellData()->GetArray("BoundaryId")->GetDataType(), VTK_INT);
  EXPECT_TRUE(vtkIdTypeArray::SafeDownCast(boundary(mesher)->GetCellData()->GetArray("OwnerCell")));
  EXPECT_TRUE(
    vtkIdTypeArray::SafeDownCast(boundary(mesher)->GetPointData()->GetArray("MeshPointId")));
}

// So large that each loop over cells, faces and points of the boundary has several chunks.
TEST(Pipeline, BoundaryDependsOnNoThreads)
{
  vtkNew<vtkSphereSource> source;
  source->SetThetaResolution(60);
  source->SetPhiResolution(60);
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetInputConnection(source->GetOutputPort());
  mesher->SetCellSize(1.0 / 54);
  std::vector<std::vector<double>> outputs;
  for (const int threads : { 1, 3 })
  {
    mesher->SetNumberOfThreads(threads);
    mesher->Update();
    EXPECT_GT(mesh(mesher)->GetNumberOfCells(), 1 << 16);
    EXPECT_GT(boundary(mesher)->GetNumberOfPoints(), 4096);
    std::vector<double>& values = outputs.emplace_back();
    for (vtkDataArray* array : { boundary(mesher)->GetPoints()->GetData(),
           boundary(mesher)->GetPointData()->GetArray("MeshPointId"),
           boundary(mesher)->GetCellData()->GetArray("OwnerCell"),
           boundary(mesher)->GetPolys()->GetConnectivityArray(),
           mesh(mesher)->GetCellData()->GetArray("CellId"),
           mesh(mesher)->GetFieldData()->GetArray("BoundaryOfFaces") })
    {
      for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i)
      {
        values.push_back(array->GetComponent(i / array->GetNumberOfComponents(),
          static_cast<int>(i % array->GetNumberOfComponents())));
      }
    }
  }
  EXPECT_EQ(outputs[0], outputs[1]);
}

// Rows of CellId, face and boundary, each once, in order; the faces are those of the boundary.
TEST(Pipeline, BoundaryOfFacesNamesEachFaceOnce)
{
  const auto source = sphere();
  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetInputConnection(source->GetOutputPort());
  mesher->SetCellSize(0.2);
  mesher->Update();
  auto* rows =
    vtkIdTypeArray::SafeDownCast(mesh(mesher)->GetFieldData()->GetAbstractArray("BoundaryOfFaces"));
  ASSERT_TRUE(rows);
  ASSERT_EQ(rows->GetNumberOfTuples(), boundary(mesher)->GetNumberOfPolys());
  vtkDataArray* ids = mesh(mesher)->GetCellData()->GetArray("CellId");
  std::vector<vtkIdType> place(static_cast<std::size_t>(mesh(mesher)->GetNumberOfCells()));
  for (vtkIdType c = 0; c < mesh(mesher)->GetNumberOfCells(); ++c)
  {
    place.at(static_cast<std::size_t>(ids->GetComponent(c, 0))) = c;
  }
  for (vtkIdType r = 0; r < rows->GetNumberOfTuples(); ++r)
  {
    const vtkIdType cell = rows->GetTypedComponent(r, 0);
    const vtkIdType face = rows->GetTypedComponent(r, 1);
    EXPECT_EQ(cell, boundary(mesher)->GetCellData()->GetArray("OwnerCell")->GetComponent(r, 0));
    EXPECT_LT(
      face, mesh(mesher)->GetCell(place.at(static_cast<std::size_t>(cell)))->GetNumberOfFaces());
    EXPECT_TRUE(r == 0 || cell > rows->GetTypedComponent(r - 1, 0) ||
      (cell == rows->GetTypedComponent(r - 1, 0) && face > rows->GetTypedComponent(r - 1, 1)));
  }
}

// The share that users need at y+ 1. Slivers that were removed expose a third of such a wall.
TEST(Pipeline, ThinLayersOnARoundWallAreWhole)
{
  constexpr double Box = 1.0 / 40;
  for (const double first : { 1e-2, 1e-3, 1e-4 })
  {
    vtkNew<vtkSphereSource> source;
    source->SetThetaResolution(64);
    source->SetPhiResolution(64);
    vtkNew<vtkCartesianMesher> mesher;
    mesher->SetInputConnection(source->GetOutputPort());
    mesher->SetCellSize(Box);
    mesher->SetLayers(12);
    mesher->SetFirstLayerThickness(first * Box);
    mesher->Update();
    vtkDataArray* const whole = mesh(mesher)->GetFieldData()->GetArray("WholeStacks");
    ASSERT_NE(whole, nullptr);
    EXPECT_GE(whole->GetTuple1(0), 0.97) << first;
  }
}
