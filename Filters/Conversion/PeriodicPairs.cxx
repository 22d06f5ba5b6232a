// SPDX-License-Identifier: BSD-3-Clause
#include "PeriodicPairs.h"

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkNew.h"
#include "vtkUnstructuredGrid.h"

namespace cartesian
{

namespace
{

constexpr int Components = 12;

vtkDoubleArray* rowsOf(vtkUnstructuredGrid* grid)
{
  auto* rows = grid
    ? vtkDoubleArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray(PeriodicPairs))
    : nullptr;
  return rows && rows->GetNumberOfComponents() == Components ? rows : nullptr;
}

}

std::vector<PeriodicPair> readPeriodicPairs(vtkUnstructuredGrid* grid)
{
  std::vector<PeriodicPair> pairs;
  vtkDoubleArray* const rows = rowsOf(grid);
  for (vtkIdType i = 0; rows && i < rows->GetNumberOfTuples(); ++i)
  {
    const double* const row = rows->GetPointer(Components * i);
    PeriodicPair pair{ { static_cast<long long>(row[0]), static_cast<long long>(row[1]) }, {} };
    pair.motion.translation = { row[2], row[3], row[4] };
    pair.motion.axis = { row[5], row[6], row[7] };
    pair.motion.centre = { row[8], row[9], row[10] };
    pair.motion.angle = row[11];
    pairs.push_back(pair);
  }
  return pairs;
}

void addPeriodicPair(const PeriodicPair& pair, vtkUnstructuredGrid* grid)
{
  vtkNew<vtkDoubleArray> rows;
  if (vtkDoubleArray* const before = rowsOf(grid))
  {
    rows->DeepCopy(before);
  }
  rows->SetName(PeriodicPairs);
  rows->SetNumberOfComponents(Components);
  const SideMotion& m = pair.motion;
  const std::array<double, Components> row{ static_cast<double>(pair.boundary[0]),
    static_cast<double>(pair.boundary[1]), m.translation[0], m.translation[1], m.translation[2],
    m.axis[0], m.axis[1], m.axis[2], m.centre[0], m.centre[1], m.centre[2], m.angle };
  rows->InsertNextTuple(row.data());
  grid->GetFieldData()->AddArray(rows);
}

}
