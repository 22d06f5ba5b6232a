// SPDX-License-Identifier: BSD-3-Clause
#include "DefectsToVTK.h"

#include "FieldData.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <array>
#include <utility>

namespace cartesian
{

namespace
{

constexpr std::array<std::pair<DefectKind, const char*>, 12> CountNames = { {
  { DefectKind::OpenEdge, "OpenEdges" },
  { DefectKind::NonManifoldEdge, "NonManifoldEdges" },
  { DefectKind::InconsistentEdge, "InconsistentEdges" },
  { DefectKind::DegenerateTriangle, "DegenerateTriangles" },
  { DefectKind::DuplicateTriangle, "DuplicateTriangles" },
  { DefectKind::FoldedTriangle, "FoldedTriangles" },
  { DefectKind::OverlappedTriangle, "OverlappedTriangles" },
  { DefectKind::Intersection, "Intersections" },
  { DefectKind::SmallComponent, "TrianglesOfSmallComponents" },
  { DefectKind::Hole, "Holes" },
  { DefectKind::Leak, "Leaks" },
  { DefectKind::ClosedContact, "TrianglesOfClosedContacts" },
} };

class DefectWriter
{
public:
  DefectWriter(const SurfaceDefects& defects, const std::vector<vtkIdType>& surfaceCells)
    : defects_(defects)
    , surfaceCells_(surfaceCells)
  {
    kind_->SetName("DefectKind");
    cell_->SetName("SurfaceCell");
    other_->SetName("OtherCell");
    width_->SetName("Width");
  }

  void write(vtkPolyData* output)
  {
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    for (const Vector& p : defects_.points)
    {
      points->InsertNextPoint(p.data());
    }
    // VTK numbers the lines of a vtkPolyData before its polygons.
    vtkNew<vtkCellArray> lines;
    vtkNew<vtkCellArray> polygons;
    writeCells(false, lines);
    writeCells(true, polygons);
    output->SetPoints(points);
    output->SetLines(lines);
    output->SetPolys(polygons);
    output->GetCellData()->SetScalars(kind_);
    output->GetCellData()->AddArray(cell_);
    output->GetCellData()->AddArray(other_);
    output->GetCellData()->AddArray(width_);
  }

private:
  void writeCells(bool polygons, vtkCellArray* cells)
  {
    vtkIdType point = 0;
    for (const Defect& defect : defects_.defects)
    {
      if (defect.polygon == polygons)
      {
        cells->InsertNextCell(static_cast<int>(defect.size));
        for (std::uint32_t i = 0; i < defect.size; ++i)
        {
          cells->InsertCellPoint(point + i);
        }
        kind_->InsertNextValue(static_cast<int>(defect.kind));
        const vtkIdType cell = cellOf(defect.triangle);
        const vtkIdType other = cellOf(defect.other);
        const bool swaps = other >= 0 && other < cell; // of a pair the lower comes first
        cell_->InsertNextValue(swaps ? other : cell);
        other_->InsertNextValue(swaps ? cell : other);
        width_->InsertNextValue(defect.width);
      }
      point += defect.size;
    }
  }

  vtkIdType cellOf(std::uint32_t triangle) const
  {
    return triangle == SurfaceDefects::None ? -1 : surfaceCells_[triangle];
  }

  const SurfaceDefects& defects_;
  const std::vector<vtkIdType>& surfaceCells_;
  vtkNew<vtkIntArray> kind_;
  vtkNew<vtkIdTypeArray> cell_;
  vtkNew<vtkIdTypeArray> other_;
  vtkNew<vtkDoubleArray> width_;
};

}

void toVTK(
  const SurfaceDefects& defects, const std::vector<vtkIdType>& surfaceCells, vtkPolyData* output)
{
  DefectWriter(defects, surfaceCells).write(output);
  for (const auto& [kind, name] : CountNames)
  {
    setField(output, name, { static_cast<double>(defects.counts[static_cast<std::size_t>(kind)]) });
  }
  setField(output, "Components", { static_cast<double>(defects.components) });
  setField(output, "TrianglesNotCompared", { static_cast<double>(defects.notCompared) });
}

}
