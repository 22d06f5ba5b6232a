// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCADReader.h"

#include "Base/Error.h"
#include "Base/Execution.h"
#include "CadToVTK.h"
#include "LengthUnit.h"

#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkStringArray.h"

#include "vtksys/SystemTools.hxx"

#include <array>
#include <cmath>
#include <cstdio>

namespace
{

constexpr double MillimetresInMetre = 1000;
constexpr double SmallestAngle = 1; // degrees
constexpr double LargestAngle = 45;

// Without loss.
std::string Word(double value)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.17g", value);
  return text.data();
}

// In per cent; what floating point leaves is none.
std::string Difference(double ratio)
{
  constexpr double Noise = 1e-9;
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%+.3g %%", 100 * ratio);
  return std::abs(ratio) < Noise ? "0 %" : text.data();
}

[[noreturn]] void Refuse(const std::string& property, double value, const std::string& range)
{
  throw cartesian::Error(cartesian::Fault::BadParameter,
    property + " is " + cartesian::number(value) + ": it must be " + range + ".");
}

void CheckLength(const std::string& property, double value)
{
  if (!(value >= 0) || std::isinf(value))
  {
    Refuse(property, value, "0 or more");
  }
}

}

vtkStandardNewMacro(vtkCADReader);

vtkCADReader::vtkCADReader()
{
  this->SetNumberOfInputPorts(0);
}

vtkCADReader::~vtkCADReader()
{
  delete[] this->FileName;
}

int vtkCADReader::FillOutputPortInformation(int /*port*/, vtkInformation* info)
{
  info->Set(vtkDataObject::DATA_TYPE_NAME(), "vtkMultiBlockDataSet");
  return 1;
}

void vtkCADReader::Check() const
{
  CheckLength("Deflection", this->Deflection);
  CheckLength("Heal Tolerance", this->HealTolerance);
  CheckLength("Time Limit", this->TimeLimit);
  if (!(this->Angle >= SmallestAngle && this->Angle <= LargestAngle))
  {
    Refuse("Angle", this->Angle, "1 to 45 degrees");
  }
  if (!(this->Scale > 0) || std::isinf(this->Scale))
  {
    Refuse("Scale", this->Scale, "above 0");
  }
  if (this->LengthUnit < Metre || this->LengthUnit > Foot)
  {
    Refuse("Length Unit", this->LengthUnit, "0 to 4");
  }
  if (this->BoundaryNamesFrom < Automatic || this->BoundaryNamesFrom > Solids)
  {
    Refuse("Boundary Names From", this->BoundaryNamesFrom, "0 to 5");
  }
  if (this->NameEncoding < Guessed || this->NameEncoding > Korean)
  {
    Refuse("Name Encoding", this->NameEncoding, "0 to 10");
  }
  if (!this->FileName || !*this->FileName)
  {
    throw cartesian::Error(
      cartesian::Fault::BadParameter, "File Name is empty: choose a STEP, IGES or BREP file.");
  }
  if (!vtksys::SystemTools::FileExists(this->FileName, true))
  {
    throw cartesian::Error(cartesian::Fault::CannotRead,
      std::string(this->FileName) + " does not exist: choose a STEP, IGES or BREP file.");
  }
}

std::vector<std::string> vtkCADReader::Arguments() const
{
  const double unit = MillimetresInMetre *
    cartesian::MetresPerUnits[static_cast<std::size_t>(this->LengthUnit)] / this->Scale;
  return { this->FileName, Word(unit), Word(this->Deflection), Word(this->Angle),
    std::to_string(this->BoundaryNamesFrom), Word(this->HealTolerance),
    std::to_string(this->GlueSolids), std::to_string(this->MergeCoplanar),
    std::to_string(this->NameEncoding), std::to_string(this->KeepDamagedFaces) };
}

int vtkCADReader::RequestData(
  vtkInformation* request, vtkInformationVector** /*input*/, vtkInformationVector* output)
{
  if (IsLeftToFirstProcess(request, output))
  {
    return 1;
  }
  vtkMultiBlockDataSet* const blocks = vtkMultiBlockDataSet::GetData(output);
  if (this->TimeOfRead > this->GetMTime())
  {
    blocks->ShallowCopy(this->Read);
    return 1;
  }
  this->FoundSolids->Reset();
  this->Findings->Reset();
  this->Run(0, 1, [&](cartesian::Execution& execution) {
    this->Check();
    execution.stage("Reading the CAD file", 0, 1);
    const cartesian::CadContent content =
      cartesian::runCadProgram(this->Arguments(), this->TimeLimit, execution);
    for (const std::string& warning : content.warnings)
    {
      this->Warn(warning);
    }
    cartesian::cadBlocks(
      content, cartesian::MetresPerUnits[static_cast<std::size_t>(this->LengthUnit)], blocks);
    this->Describe(content);
    this->Read->ShallowCopy(blocks);
    this->TimeOfRead.Modified();
  });
  return 1;
}

void vtkCADReader::Describe(const cartesian::CadContent& content)
{
  for (const std::string& note : content.notes)
  {
    this->Findings->InsertNextValue(note);
  }
  for (const char* title :
    { "Solid", "Volume", "Triangles' Volume", "Area", "Triangles", "Open Edges" })
  {
    this->FoundSolids->InsertNextValue(title);
  }
  for (const cartesian::CadSolid& solid : content.solids)
  {
    const bool isSolid = solid.volume != 0;
    this->FoundSolids->InsertNextValue(solid.name);
    this->FoundSolids->InsertNextValue(isSolid ? cartesian::number(solid.volume)
        : solid.openEdges > 0                  ? "open"
                                               : "not known");
    this->FoundSolids->InsertNextValue(
      isSolid ? Difference(solid.volumeOfTriangles / solid.volume - 1) : "");
    this->FoundSolids->InsertNextValue(cartesian::number(solid.area));
    this->FoundSolids->InsertNextValue(std::to_string(solid.triangles.size() / 3));
    this->FoundSolids->InsertNextValue(std::to_string(solid.openEdges));
  }
}

vtkStringArray* vtkCADReader::GetFoundSolids()
{
  return this->FoundSolids;
}

vtkStringArray* vtkCADReader::GetFindings()
{
  return this->Findings;
}

void vtkCADReader::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << (this->FileName ? this->FileName : "(none)") << "\n";
  os << indent << "Deflection: " << this->Deflection << "\n";
  os << indent << "Angle: " << this->Angle << "\n";
  os << indent << "LengthUnit: " << this->LengthUnit << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "BoundaryNamesFrom: " << this->BoundaryNamesFrom << "\n";
  os << indent << "HealTolerance: " << this->HealTolerance << "\n";
  os << indent << "GlueSolids: " << this->GlueSolids << "\n";
  os << indent << "MergeCoplanar: " << this->MergeCoplanar << "\n";
  os << indent << "KeepDamagedFaces: " << this->KeepDamagedFaces << "\n";
  os << indent << "NameEncoding: " << this->NameEncoding << "\n";
  os << indent << "TimeLimit: " << this->TimeLimit << "\n";
}
