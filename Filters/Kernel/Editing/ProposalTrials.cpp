// SPDX-License-Identifier: BSD-3-Clause
#include "Editing/ProposalTrials.h"

#include "Base/Rings.h"
#include "Editing/CellCut.h"
#include "Editing/EdgeArea.h"
#include "Editing/PrimitiveEdits.h"
#include "Editing/WallEdges.h"

#include <cmath>

namespace cartesian
{

namespace
{

constexpr double LeastGainOfMore = 1e-3; // of an edit that follows another
constexpr int MostRounds = 8;            // of those
constexpr std::size_t MostTries =
  128; // of nodes of a face in all of these: walls with more are rims of hundreds of points
constexpr double PartToMerge = 0.6; // of its box: smaller parts of a cut go to a neighbour
constexpr std::size_t NeighboursOfPart = 3;
constexpr double SmallWall = 0.15; // of a box's side: what is flattened
constexpr std::size_t MostFaces = 128;
constexpr double CutTolerance = 0.03; // in boxes

template <std::size_t Capacity>
FixedList<std::uint32_t, Capacity> copyOf(Items items)
{
  FixedList<std::uint32_t, Capacity> list;
  for (const std::uint32_t item : items)
  {
    list.offer(item);
  }
  return list;
}

bool isPartToMerge(const MeshView& mesh, std::uint32_t part)
{
  const EditCell& cell = mesh.cell(part);
  return !cell.gone && cell.volume <= PartToMerge * cell.boxVolume;
}

// Whether all faces around a node have it between the same two others.
bool isBetween(const MeshView& mesh, std::uint32_t n, std::uint32_t p, std::uint32_t q)
{
  const Items faces = mesh.facesAround(n);
  return std::all_of(faces.begin(), faces.end(), [&](std::uint32_t f) {
    const Items ring = mesh.cornersOf(f);
    const std::size_t i = placeOf(ring, n);
    const std::uint32_t x = preceding(ring, i);
    const std::uint32_t y = following(ring, i);
    return (x == p && y == q) || (x == q && y == p);
  });
}

}

template <class Edit>
bool ProposalTrials::applyIfGain(Edit&& edit)
{
  constexpr std::size_t EditsAPoll = 8; // one takes up to 20 ms in a cell with very many walls
  if (poll_ != nullptr && ++count_ % EditsAPoll == 0)
  {
    (*poll_)();
  }
  const double before = gainOf(mesh_, rules_.objective, box_);
  const double needed = needed_;
  const double aim = aim_;
  const MeshEditor::Mark mark = mesh_.mark();
  aim_ = before + LeastGainOfMore;
  needed_ = aim_;
  const bool isMade = edit() && updateAndValidate() && gainOf(mesh_, rules_.objective, box_) > aim_;
  isMade ? mesh_.keep(mark) : mesh_.undo(mark);
  needed_ = needed;
  aim_ = aim;
  return isMade;
}

template <class Edit>
bool ProposalTrials::applyUnchecked(Edit&& edit)
{
  const double needed = needed_;
  needed_ = NoGain;
  const bool isMade = edit();
  needed_ = needed;
  return isMade;
}

double ProposalTrials::gain(const Proposal& proposal, double least)
{
  bool isMade = false;
  return gainOrMake(proposal, least, -NoGain, isMade);
}

double ProposalTrials::gainOrMake(
  const Proposal& proposal, double least, double enough, bool& isMade)
{
  const MeshEditor::Mark mark = mesh_.mark();
  aim_ = least;
  needed_ = least;
  const double gained = apply(proposal) ? decide(mesh_, rules_, mark, box_, least) : NoGain;
  needed_ = NoGain;
  isMade = gained > enough && (proposal.kind == EditKind::Move || areAllClosed(mesh_, mark));
  if (!isMade)
  {
    mesh_.undo(mark);
  }
  return gained;
}

bool ProposalTrials::make(const Proposal& proposal, double least)
{
  bool isMade = false;
  gainOrMake(proposal, least, least, isMade);
  return isMade;
}

bool ProposalTrials::apply(const Proposal& proposal)
{
  switch (proposal.kind)
  {
    case EditKind::Collapse:
      return collapse(proposal.a, proposal.b, proposal.at) && updateAndValidate();
    case EditKind::Join:
      return applyUnchecked([&] {
        if (!join(proposal.a, proposal.b) || !updateAndValidate())
        {
          return false;
        }
        dissolveNodes(proposal.a);
        return true;
      });
    case EditKind::Merge:
      return mayMerge(mesh_, rules_, proposal.a, proposal.b) &&
        applyUnchecked([&] { return merge(proposal.a, proposal.b); });
    case EditKind::Remove:
      return rules_.mayChangeWalls && applyUnchecked([&] { return remove(proposal.a); });
    case EditKind::Move:
      if (!mayMove(mesh_, rules_, proposal.a, proposal.at))
      {
        return false;
      }
      mesh_.moveNode(proposal.a, proposal.at);
      return updateAndValidate();
    case EditKind::SplitFace:
      return splitFace(mesh_, proposal.a, proposal.b, proposal.c) != None && updateAndValidate();
    case EditKind::Flatten:
      return rules_.mayCut && applyUnchecked([&] { return flatten(proposal.a); });
    case EditKind::Cut:
      return rules_.mayCut && applyUnchecked([&] { return cut(proposal); });
  }
  return false;
}

bool ProposalTrials::collapse(std::uint32_t u, std::uint32_t v, const Vector& at)
{
  double charge = 0;
  if (!mayCollapse(mesh_, rules_, u, v, at, charge) || !collapseEdge(mesh_, u, v, at))
  {
    return false;
  }
  mesh_.delta.fidelity += charge;
  return true;
}

bool ProposalTrials::join(std::uint32_t f, std::uint32_t g)
{
  double charge = 0;
  if (!mayJoin(mesh_, rules_, f, g, charge) || !joinFaces(mesh_, f, g))
  {
    return false;
  }
  mesh_.delta.fidelity += charge;
  return true;
}

bool ProposalTrials::merge(std::uint32_t a, std::uint32_t b)
{
  const Faces ofB = copyOf<MostFaces>(mesh_.facesOf(b));
  return mergeCells(mesh_, a, b) && updateAndValidate() && joinFacesOf(a, ofB);
}

bool ProposalTrials::remove(std::uint32_t c)
{
  const Neighbours neighbours = largestNeighbours(mesh_, c);
  if (!removeCell(mesh_, c) || !updateAndValidate())
  {
    return false;
  }
  for (const std::uint32_t neighbour : neighbours)
  {
    if (!mesh_.cell(neighbour).gone)
    {
      joinFacesOf(neighbour, copyOf<MostFaces>(mesh_.facesOf(neighbour)));
    }
  }
  return true;
}

bool ProposalTrials::cut(const Proposal& proposal)
{
  CutParts parts;
  const CutPlane plane{ proposal.at, proposal.normal, CutTolerance * mesh_.cell(proposal.a).edge };
  if (!cutCell(mesh_, proposal.a, plane, parts) || !updateAndValidate())
  {
    return false;
  }
  for (std::size_t i = parts.size(); i-- > 0;)
  {
    if (!mayGainOfMerges(parts, i + 1))
    {
      return false;
    }
    mergePart(parts[i], parts);
  }
  return true;
}

// Whether what is needed can still be gained: by merges of the first parts, at most what they and their faces cost.
bool ProposalTrials::mayGainOfMerges(const CutParts& parts, std::size_t count) const
{
  double gain = gainOf(mesh_, rules_.objective, box_);
  for (std::size_t i = 0; i < count; ++i)
  {
    if (isPartToMerge(mesh_, parts[i]))
    {
      gain += mesh_.cell(parts[i]).cost;
      for (const std::uint32_t f : mesh_.facesOf(parts[i]))
      {
        gain += mesh_.face(f).cost;
      }
    }
  }
  return gain > aim_;
}

// The paper's IP patches (4.11): detail that is smaller than its box goes.
bool ProposalTrials::flatten(std::uint32_t f)
{
  const std::uint32_t c = mesh_.face(f).below;
  const double small = SmallWall * mesh_.cell(c).edge * mesh_.cell(c).edge;
  std::size_t joined = 0;
  for (bool isAny = true; isAny;)
  {
    isAny = false;
    for (const std::uint32_t g : copyOf<MostFaces>(mesh_.facesOf(c)))
    {
      if (g != f && !mesh_.face(g).gone && mesh_.isWall(g) && areAdjacent(mesh_, f, g) &&
        norm(mesh_.face(g).area) < small && join(f, g))
      {
        isAny = true;
        ++joined;
      }
    }
  }
  if (joined == 0 || !updateAndValidate())
  {
    return false;
  }
  dissolveNodes(f);
  return true;
}

// A small part of a cut becomes part of a cell that is none.
void ProposalTrials::mergePart(std::uint32_t part, const CutParts& parts)
{
  if (rules_.mostMerged == 0 || !isPartToMerge(mesh_, part))
  {
    return;
  }
  std::size_t tried = 0;
  for (const std::uint32_t neighbour : largestNeighbours(mesh_, part))
  {
    if (parts.contains(neighbour) || tried++ == NeighboursOfPart)
    {
      continue;
    }
    if (applyIfGain([&] { return applyUnchecked([&] { return merge(neighbour, part); }); }))
    {
      return;
    }
  }
}

// Joins each of these faces of a cell with another, where they lie between the same two cells and that gains. False: not
// even if all of them cost nothing then, the aim would be reached.
bool ProposalTrials::joinFacesOf(std::uint32_t c, const Faces& which)
{
  FixedList<std::pair<std::uint32_t, std::uint32_t>, 256> pairs;
  const Items faces = mesh_.facesOf(c);
  double gain = gainOf(mesh_, rules_.objective, box_);
  for (const std::uint32_t f : faces)
  {
    bool isAny = false;
    for (std::size_t i = 0; i < faces.size() && which.contains(f); ++i)
    {
      const std::uint32_t g = faces[i];
      const bool isSecond = which.contains(g) && g <= f;
      if (g != f && !isSecond && couldJoin(mesh_, f, g, c))
      {
        pairs.offer({ f, g });
        gain += mesh_.face(g).cost;
        isAny = true;
      }
    }
    gain += isAny ? mesh_.face(f).cost : 0;
  }
  if (!(gain > aim_))
  {
    return false;
  }
  for (const auto& [f, g] : pairs)
  {
    if (!mesh_.face(f).gone && !mesh_.face(g).gone && couldJoin(mesh_, f, g, c) &&
      applyIfGain([&, f = f, g = g] { return join(g, f); }))
    {
      dissolveNodes(g);
    }
  }
  return true;
}

void ProposalTrials::dissolveNodes(std::uint32_t f)
{
  std::size_t tries = 0;
  for (int round = 0; round < MostRounds && !mesh_.face(f).gone && dissolveNode(f, tries); ++round)
  {
  }
}

// A node that only lies between two others, as seen from all faces, goes where that gains.
bool ProposalTrials::dissolveNode(std::uint32_t f, std::size_t& tries)
{
  for (std::size_t i = 0; i < mesh_.face(f).corners.size; ++i)
  {
    const Items ring = mesh_.cornersOf(f);
    const std::uint32_t n = ring[i];
    const std::uint32_t p = preceding(ring, i);
    const std::uint32_t q = following(ring, i);
    if (!isBetween(mesh_, n, p, q))
    {
      continue;
    }
    if (++tries > MostTries)
    {
      return false;
    }
    const std::uint32_t to = mesh_.node(p).atWall || !mesh_.node(q).atWall ? p : q;
    if (applyIfGain(
          [&] { return collapse(n, to, placeKeepingArea(mesh_, n, to, mesh_.node(to).at)); }))
    {
      return true;
    }
  }
  return false;
}

}
