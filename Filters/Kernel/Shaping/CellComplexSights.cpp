// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/CellCost.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

// Whether the sights of its faces are as it is now.
bool CellComplex::isSeen(CellKey key) const
{
  const OpenCell* cell = opened(key);
  return !cell || !cell->changed || cell->known.isSeen;
}

// Whether accept(below, above) holds for all its inner faces; false where that is not known.
template <class Accept>
bool CellComplex::allSights(CellKey key, Accept&& accept) const
{
  const OpenCell* open = opened(key);
  const bool changed = open && open->changed;
  if (!changed && !isOfWall(key))
  {
    return false;
  }
  bool sure = changed ? open->known.isPlain && open->known.isSeen : whole_.known.isPlain[key] != 0;
  forEachFace(key, [&](const FaceUse& use) {
    const CellKey other = sure ? across(use) : None;
    if (other == None)
    {
      return;
    }
    // A face that has become a shaped one since is not among these, nor is one that a removed cell exposes.
    sure = isAlive(other) && isSeen(other) &&
      (!isMadeHere(use.face) || use.face - firstMade() < madeFaces_.sights.size());
    if (sure)
    {
      const auto& [below, above] = isMadeHere(use.face)
        ? madeFaces_.sights[use.face - firstMade()]
        : whole_.sights[use.face - whole_.mesh.faces.firstOfSides()];
      sure = accept(below, above);
    }
  });
  return sure;
}

bool CellComplex::isSurelyAccepted(CellKey key) const
{
  return allSights(key, [](const CentreOffset& below, const CentreOffset& above) {
    return cartesian::isSurelyAccepted(below, above);
  });
}

bool CellComplex::isSurelyGood(CellKey key) const
{
  return allSights(key, [](const CentreOffset& below, const CentreOffset& above) {
    return cartesian::isSurelyGood(below, above);
  });
}

void CellComplex::lookAtChanged()
{
  madeFaces_.sights.resize(madeFaces_.all.size());
  open_.forEach([&](CellKey key, const OpenCell& open) {
    if (!open.changed || open.known.isSeen || !open.alive || open.removed)
    {
      return;
    }
    OpenCell& cell = *opened(key);
    const CellShape& measures = measured(key);
    const bool atFault = isAnyAtFault(scratch_.polyhedron, measures);
    cell.known.fault = atFault ? IsAtFault::Yes : IsAtFault::No;
    cell.known.isPlain =
      !atFault && isPlain(scratch_.polyhedron, measures) && isEasy(scratch_.polyhedron, measures);
    cell.known.isSeen = true;
    noteSights(key, measures, whole_.sights, madeFaces_.sights);
  });
}

void CellComplex::noteSights(
  CellKey key, const CellShape& measures, Sights& given, Sights& ofMade) const
{
  const Point origin = whole_.boxes.lowOf(boxOf(key));
  std::size_t i = 0;
  forEachFace(key, [&](const FaceUse& use) {
    const FaceShape& face = measures.faces[i++];
    if (whole_.mesh.faces.isPatch(use.face))
    {
      return;
    }
    std::array<CentreOffset, 2>& sights = isMadeHere(use.face)
      ? ofMade[use.face - firstMade()]
      : given[use.face - whole_.mesh.faces.firstOfSides()];
    sights[use.turned] = centreOffsetOf(measures.centre, face.centre, face.area);
    const CellKey other = across(use);
    if (other != None && !hasFaces(other))
    {
      sights[1 - use.turned] =
        centreOffsetOf(placeAndVolume(other, origin).centre, face.centre, scaled(face.area, -1));
    }
  });
}

}
