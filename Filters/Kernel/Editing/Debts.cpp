// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/Debts.h"

#include "Editing/FixedList.h"

namespace cartesian
{

namespace
{

constexpr std::size_t Most = 256;

// Calls visit(face, what it owed, whether it is there) for the walls that changed, or the faces between regions.
template <class Visitor>
void forEachChanged(const EditMesh& mesh, bool ofWalls, Visitor&& visit)
{
  const auto isMeant = [&](const EditFace& face) {
    return !face.gone && isSurface(face) && (face.above == None) == ofWalls;
  };
  FixedList<std::uint32_t, Most> seen;
  for (const auto& [f, was] : mesh.faceRecords())
  {
    const EditFace& is = mesh.face(f);
    const bool hasMoved = isMeant(was) != isMeant(is) || was.corners.first != is.corners.first ||
      was.centre != is.centre;
    if (!seen.contains(f) && seen.add(f) && hasMoved)
    {
      visit(f, isMeant(was) ? mesh.signOf(was) * was.debt : 0, isMeant(is));
    }
  }
}

void passOnDebts(EditMesh& mesh, bool ofWalls)
{
  const ChangedDebt debt = changedDebt(mesh, ofWalls);
  FixedList<std::uint32_t, Most> walls;
  forEachChanged(mesh, ofWalls, [&](std::uint32_t f, double, bool isThere) {
    if (isThere)
    {
      walls.add(f);
    }
  });
  for (const std::uint32_t f : walls)
  {
    const double share = debt.area > 0 ? norm(mesh.face(f).area) / debt.area : 0;
    mesh.changeFace(f).debt = mesh.signOf(f) * debt.after * share;
  }
}

}

ChangedDebt changedDebt(const EditMesh& mesh, bool ofWalls)
{
  ChangedDebt debt;
  forEachChanged(mesh, ofWalls, [&](std::uint32_t f, double was, bool isThere) {
    debt.before += was;
    debt.area += isThere ? norm(mesh.face(f).area) : 0;
  });
  debt.after = debt.before - (ofWalls ? mesh.ledger.volume : mesh.ledger.across);
  return debt;
}

void passOnDebts(EditMesh& mesh)
{
  passOnDebts(mesh, true);
  if (mesh.ledger.across != 0)
  {
    passOnDebts(mesh, false);
  }
}

}
