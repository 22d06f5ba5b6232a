// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/Debts.h"

namespace cartesian
{

namespace
{

// Calls visit(face, what it owed, whether it is there) for the walls that changed, or the faces between regions; it may
// change what they owe.
template <class Visitor>
void forEachChanged(const EditMesh& mesh, bool ofWalls, Visitor&& visit)
{
  const auto isMeant = [&](const EditFace& face) {
    return !face.gone && isSurface(face) && (face.above == None) == ofWalls;
  };
  const std::size_t count = mesh.faceRecords().size();
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto& [f, was] = mesh.faceRecords()[i];
    const EditFace& is = mesh.face(f);
    const bool hasMoved = isMeant(was) != isMeant(is) || was.corners.first != is.corners.first ||
      was.centre != is.centre;
    if (hasMoved && EditMesh::isOldest(was))
    {
      visit(f, isMeant(was) ? mesh.signOf(was) * was.debt : 0, isMeant(is));
    }
  }
}

void passOnDebts(EditMesh& mesh, bool ofWalls)
{
  const ChangedDebt debt = changedDebt(mesh, ofWalls);
  forEachChanged(mesh, ofWalls, [&](std::uint32_t f, double, bool isThere) {
    if (isThere)
    {
      const double share = debt.area > 0 ? norm(mesh.face(f).area) / debt.area : 0;
      mesh.changeFace(f).debt = mesh.signOf(f) * debt.after * share;
    }
  });
}

}

ChangedDebt changedDebt(const EditMesh& mesh, bool ofWalls)
{
  ChangedDebt debt;
  forEachChanged(mesh, ofWalls, [&](std::uint32_t f, double was, bool isThere) {
    debt.before += was;
    ++debt.walls;
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
