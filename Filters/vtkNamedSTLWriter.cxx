// SPDX-License-Identifier: BSD-3-Clause
#include "vtkNamedSTLWriter.h"

#include "Base/OutputFile.h"
#include "Lattice/Vector.h"
#include "ReportErrors.h"
#include "SurfaceFromVTK.h"

#include "vtkCellData.h"
#include "vtkErrorCode.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <map>
#include <vector>

vtkStandardNewMacro(vtkNamedSTLWriter);

namespace
{

// Of the arrays of boundaries that this module's filters give, the one that keeps names by itself.
constexpr const char* NameArray = "BoundaryName";

class SolidsFile
{
public:
  SolidsFile(
    const std::filesystem::path& path, const cartesian::SurfaceView& view, bool inSinglePrecision)
    : file_(path)
    , view_(view)
    , inSinglePrecision_(inSinglePrecision)
  {
  }

  void write(const std::string& name, const std::vector<std::size_t>& triangles)
  {
    file_.text("solid " + name + "\n");
    for (const std::size_t t : triangles)
    {
      WriteTriangle(t);
    }
    file_.text("endsolid " + name + "\n");
  }

  void close() { file_.close(); }

private:
  void WriteTriangle(std::size_t t)
  {
    const auto c = view_.corners(t);
    file_.text(" facet normal");
    for (const double x :
      cartesian::unit(cartesian::cross(cartesian::minus(c[1], c[0]), cartesian::minus(c[2], c[0]))))
    {
      file_.text(" ");
      file_.decimal(static_cast<float>(x));
    }
    file_.text("\n  outer loop\n");
    for (const cartesian::Vector& corner : c)
    {
      file_.text("   vertex");
      for (const double x : corner)
      {
        file_.text(" ");
        inSinglePrecision_ ? file_.decimal(static_cast<float>(x)) : file_.decimal(x);
      }
      file_.text("\n");
    }
    file_.text("  endloop\n endfacet\n");
  }

  cartesian::OutputFile file_;
  const cartesian::SurfaceView& view_;
  bool inSinglePrecision_;
};

void WriteSolids(
  const cartesian::SurfaceFromVTK& surface, bool inSinglePrecision, const std::string& name)
{
  const cartesian::SurfaceView view = surface.view();
  std::map<std::int32_t, std::vector<std::size_t>> triangles;
  for (std::size_t t = 0; t < view.triangleCount; ++t)
  {
    triangles[view.boundary[t]].push_back(t);
  }
  cartesian::replaceFiles({ name }, [&](const std::vector<std::filesystem::path>& unfinished) {
    SolidsFile file(unfinished.front(), view, inSinglePrecision);
    for (const auto& [boundary, ofBoundary] : triangles)
    {
      file.write(surface.names().at(boundary), ofBoundary);
    }
    file.close();
  });
}

}

void vtkNamedSTLWriter::WriteData()
{
  vtkPolyData* input = this->GetInput();
  if (!this->FileName || input->GetNumberOfCells() == 0)
  {
    this->Superclass::WriteData();
    return;
  }
  const auto write = [&] {
    const bool hasNames = input->GetCellData()->HasArray(NameArray) != 0;
    const cartesian::SurfaceFromVTK surface(
      input, hasNames ? NameArray : cartesian::AutomaticBoundaries);
    const auto& [boundary, name] = *surface.names().begin();
    if (surface.names().size() == 1 && name == cartesian::unnamedBoundary(boundary))
    {
      this->Superclass::WriteData();
      return;
    }
    WriteSolids(surface, input->GetPoints()->GetDataType() == VTK_FLOAT, this->FileName);
  };
  cartesian::reportErrors(write, [this](unsigned long code, const std::string& message) {
    this->SetErrorCode(code);
    vtkErrorMacro(<< message);
  });
}
