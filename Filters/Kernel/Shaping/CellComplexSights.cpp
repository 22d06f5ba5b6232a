// SPDX-License-Identifier: BSD-3-Clause
#include "Acceptance/CellCost.h"
#include "Shaping/CellComplex.h"

namespace cartesian
{

// Whether the sights of its faces are as it is now.
bool CellComplex::isSeen(CellKey key) const
{
  const OpenCell* cell = opened(key);
  return !cell || !cell->changed || cell->isSeen;
}

// Whether accept(below, above) holds for all its inner faces; false where that is not known.
template <class Accept>
bool CellComplex::allSights(CellKey key, Accept&& accept) const
{
  const OpenCell* open = opened(key);
  const bool changed = open && open->changed;
  if (!changed && key >= cells_.size())
  {
    return false;
  }
  bool sure = changed ? open->isPlain && open->isSeen : whole_.known.isPlain[key] != 0;
  forEachFace(key, [&](const FaceUse& use) {
    const CellKey other = sure ? across(use) : None;
    if (other == None)
    {
      return;
    }
    // A face that has become a shaped one since is not among these, nor is one that a removed cell exposes.
    sure = isAlive(other) && isSeen(other) &&
      (!isShaped(use.face) || use.face - firstShaped() < sightsOfShaped_.size());
    if (sure)
    {
      const auto& [below, above] = isShaped(use.face) ? sightsOfShaped_[use.face - firstShaped()]
                                                      : whole_.sights[use.face - firstInner()];
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
  sightsOfShaped_.resize(shaped_.size());
  const auto look = [&](CellKey key, OpenCell& cell) {
    if (!cell.changed || cell.isSeen || !cell.alive || cell.removed)
    {
      return;
    }
    const CellShape& measures = measured(key);
    const bool atFault = isAnyAtFault(scratch_.polyhedron, measures);
    cell.fault = atFault ? IsAtFault::Yes : IsAtFault::No;
    cell.isPlain =
      !atFault && isPlain(scratch_.polyhedron, measures) && isEasy(scratch_.polyhedron, measures);
    cell.isSeen = true;
    noteSights(key, measures, whole_.sights, sightsOfShaped_);
  };
  for (std::size_t i = 0; i < openOf_.size(); ++i)
  {
    if (openOf_[i] != None)
    {
      look(static_cast<CellKey>(firstOfSlab_ + i), open_[openOf_[i]]);
    }
  }
  for (const auto& [key, open] : openOfOther_)
  {
    look(key, open_[open]);
  }
}

void CellComplex::noteSights(
  CellKey key, const CellShape& measures, Sights& given, Sights& ofShaped) const
{
  const Point origin = boxes_.lowOf(boxOf(key));
  std::size_t i = 0;
  forEachFace(key, [&](const FaceUse& use) {
    const FaceShape& face = measures.faces[i++];
    if (isPatch(use.face))
    {
      return;
    }
    std::array<CentreOffset, 2>& sights =
      isShaped(use.face) ? ofShaped[use.face - firstShaped()] : given[use.face - firstInner()];
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
