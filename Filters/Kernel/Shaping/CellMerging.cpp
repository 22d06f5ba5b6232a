// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CellMerging.h"

#include "Acceptance/CellCost.h"
#include "Polyhedra/CellGeometry.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace cartesian
{

namespace
{

// One merge may make another possible next to it: examined again this often.
constexpr int MostRounds = 4;

// As many neighbours are tried, those that share most area.
constexpr std::size_t MostNeighbours = 8;
constexpr std::size_t MostNeighboursOfSmall = 3;
constexpr std::size_t MostNeighboursOfPoor = 4;

// A union that costs so much more before its faces are joined at small angles is no better after.
constexpr double MostOfJoins = 500;

// Where no face of the result costs more, no other neighbour is tried.
constexpr double FairCost = 1;

// The cost of a lost cell, by its share of its box: it resolved something.
constexpr double CostOfCell = 10;

// Cells of a fine box that are smaller than this part of a neighbour join it in groups, up to this share of
// their box.
constexpr double LeastVolumeRatio = 0.06;
constexpr double LargestOfGroup = 0.6;

// Cells below this part of their box become simpler where they cannot join a neighbour otherwise.
constexpr double LeastShare = 0.11;

// No cell grows beyond this part of its box.
constexpr double MostShare = 1.6;

// If nothing narrower helps, faces of a failing cell are joined up to these angles, in degrees.
constexpr double WideBoundaryAngle = 60;
constexpr double WideInnerAngle = 90;

// Of its faces except those towards a cell; ends where that is more than `most`.
double costAround(const MeasuredCell& cell, CellKey butFor, double most)
{
  double cost = 0;
  for (std::size_t f = 0; f < cell.across.size() && cost <= most; ++f)
  {
    cost += cell.across[f] == butFor ? 0 : costOfFace(cell.shape, cell.measures, f, cell.beyond[f]);
  }
  return cost;
}

// One with fewer failing faces is better than one that gains more.
bool isBetter(const CellUnion& a, const CellUnion& b)
{
  // Equal up to rounding counts as equal: sums depend on the order of the surface's triangles.
  const bool gainsMore = static_cast<float>(a.gain) > static_cast<float>(b.gain);
  return !b.of ||
    (a.verdict.refused != b.verdict.refused ? a.verdict.refused < b.verdict.refused : gainsMore);
}

}

void CellMerger::mergeSmall()
{
  std::vector<CellKey> keys =
    at_.merged == 0 ? cells_.polyhedra() : cells_.polyhedraChangedSince(at_.merged);
  at_.merged = cells_.mark();
  mergeGroups(keys);
  run(std::move(keys), [&](CellKey key, bool acts) {
    const bool small = isSmall(key);
    if (acts && small)
    {
      mergeBest(key, verdictOf(key), MostNeighboursOfSmall, Accepted::SmallMerge);
    }
    return std::make_pair(small, cells_.share(key));
  });
}

void CellMerger::improve()
{
  std::vector<CellKey> keys =
    at_.improved == 0 ? cells_.polyhedra() : cells_.polyhedraChangedSince(at_.improved);
  at_.improved = cells_.mark();
  run(std::move(keys), [&](CellKey key, bool acts) {
    const Verdict own = !isSmall(key) && cells_.isSurelyGood(key) ? Verdict{} : verdictOf(key);
    const bool isPoor = own.worst > PoorCost || own.refused > 0;
    if (acts && isPoor)
    {
      mergeBest(
        key, own, own.refused > 0 ? MostNeighbours : MostNeighboursOfPoor, Accepted::PoorMerge);
    }
    return std::make_pair(isPoor, -own.worst);
  });
}

bool CellMerger::improve(CellKey key)
{
  const Verdict own = verdictOf(key);
  const bool improved =
    own.worst > PoorCost && mergeBest(key, own, MostNeighbours, Accepted::SmallMerge);
  return improved || own.refused == 0;
}

bool CellMerger::isFailing(CellKey key)
{
  if (verdictOf(key).refused > 0)
  {
    return true;
  }
  for (std::size_t f = 0; f < scratch_.cell.across.size(); ++f) // as verdictOf has left it
  {
    if (!scratch_.cell.shape.isBoundary[f] &&
      isUnbalanced(scratch_.cell.measures, f, scratch_.cell.beyond[f]))
    {
      return true;
    }
  }
  return false;
}

std::vector<CellKey> CellMerger::lookedAfter(bool looksAtOthers) const
{
  std::vector<CellKey> all = cells_.polyhedra();
  if (looksAtOthers)
  {
    const std::vector<CellKey> others = cells_.othersTouched();
    all.insert(all.end(), others.begin(), others.end());
  }
  return all;
}

// Only cells that have changed since, or failed then, are examined again.
std::vector<CellKey> CellMerger::refused(bool looksAtOthers)
{
  std::vector<CellKey> keys = lookedAfter(looksAtOthers);
  if (at_.refused > 0)
  {
    std::vector<CellKey> again = cells_.allChangedSince(at_.refused);
    again.insert(again.end(), refused_.begin(), refused_.end());
    std::sort(again.begin(), again.end());
    keys.erase(std::remove_if(keys.begin(), keys.end(),
                 [&](CellKey key) { return !std::binary_search(again.begin(), again.end(), key); }),
      keys.end());
  }
  at_.refused = cells_.mark();
  keys.erase(
    std::remove_if(keys.begin(), keys.end(),
      [&](CellKey key) { return cells_.isSurelyAccepted(key) || verdictOf(key).refused == 0; }),
    keys.end());
  refused_ = keys;
  return keys;
}

// look(key, whether to act): whether it is a candidate, and its rank: the lowest first.
template <class Look>
void CellMerger::run(std::vector<CellKey> keys, Look&& look)
{
  for (int round = 0; round < MostRounds && !keys.empty(); ++round)
  {
    const std::uint32_t mark = cells_.mark();
    std::vector<std::pair<float, CellKey>> candidates; // equal up to rounding counts as equal
    for (const CellKey key : keys)
    {
      execution_.poll();
      if (const auto [is, rank] = look(key, false); is)
      {
        candidates.emplace_back(static_cast<float>(rank), key);
      }
    }
    std::sort(candidates.begin(), candidates.end());
    for (std::size_t i = 0; i < candidates.size(); ++i)
    {
      execution_.reach(round == 0 ? double(i) / double(candidates.size()) : 1);
      if (cells_.isAlive(candidates[i].second))
      {
        look(candidates[i].second, true);
      }
    }
    keys = cells_.polyhedraChangedSince(mark);
  }
}

// Small cells side by side on one neighbour, or cells of a fine box each on one of a coarse box: each alone
// would leave a step there, all together none.
void CellMerger::mergeGroups(const std::vector<CellKey>& keys)
{
  std::map<CellKey, std::vector<CellKey>> byLargest;
  for (const CellKey key : keys)
  {
    execution_.poll();
    if (cells_.share(key) < LargestOfGroup && (isSmall(key) || mayBeOfFineBox(key)))
    {
      const auto neighbours = cells_.neighbours(key);
      const CellKey into = neighbours.empty() ? None : neighbours.front().first;
      if (into != None && !isSmall(into) && (isSmall(key) || isFineNextTo(key, into)))
      {
        std::vector<CellKey>& group = byLargest[into];
        group.resize(std::max<std::size_t>(group.size(), 1), into);
        group.push_back(key);
      }
    }
  }
  for (const auto& [into, group] : byLargest)
  {
    execution_.poll();
    if (group.size() > 2 && cells_.mayMerge(group) && !cells_.wouldStraddleStages(group))
    {
      mergeGroup(group);
    }
  }
}

// If that is better than each alone.
void CellMerger::mergeGroup(const std::vector<CellKey>& keys)
{
  forgetViews(1);
  cells_.open(keys.front());
  Verdict before;
  for (const CellKey& key : keys)
  {
    before += verdictOf(key, keys.data(), &key);
  }
  tryOut(viewOf(0, keys), before, Accepted::SmallMerge, spec_.joins, false);
  if (best_.of)
  {
    apply(best_);
  }
}

bool CellMerger::isSmall(CellKey key) const
{
  return cells_.share(key) < spec_.ratio;
}

bool CellMerger::isFineNextTo(CellKey key, CellKey other) const
{
  return cells_.volume(key) < LeastVolumeRatio * cells_.volume(other);
}

// Before its neighbours are measured.
bool CellMerger::mayBeOfFineBox(CellKey key) const
{
  return cells_.anyBeyond(key, [&](CellKey other) { return isFineNextTo(key, other); });
}

// But for its faces towards the cells from `begin` to `end`.
Verdict CellMerger::verdictOf(CellKey key, const CellKey* begin, const CellKey* end)
{
  MeasuredCell& cell = scratch_.cell;
  cells_.lookAround(key, cell);
  scratch_.counts.clear();
  for (const CellKey other : cell.across)
  {
    scratch_.counts.push_back(std::find(begin, end, other) == end ? 1 : 0);
  }
  return evaluateCell(cell.shape, cell.measures, cell.beyond, cells_.share(key), scratch_.counts);
}

// Of the cell last examined by verdictOf. Returns whether there was a better one.
bool CellMerger::mergeBest(
  CellKey key, const Verdict& own, std::size_t mostNeighbours, const Acceptance& acceptance)
{
  trying_.joinAcross(own.refused > 0 ? -1 : cells_.featureCosine());
  std::swap(own_, scratch_.cell);
  scratch_.neighbours.clear();
  for (const auto& [other, area] : neighboursOf(own_))
  {
    scratch_.neighbours.push_back({ other, {} });
  }
  forgetViews(1 + scratch_.neighbours.size());
  findBest(key, own, mostNeighbours, acceptance, spec_.joins, false);
  if (spec_.simplifies)
  {
    simplifyBest(key, own, mostNeighbours, acceptance);
  }
  if (!best_.of)
  {
    return false;
  }
  apply(best_);
  return true;
}

// Makes room for as many.
void CellMerger::forgetViews(std::size_t count)
{
  best_.of = nullptr;
  scratch_.views.resize(std::max(scratch_.views.size(), count));
  for (std::size_t i = 0; i < count; ++i)
  {
    scratch_.views[i].keys.clear();
  }
}

UnionView& CellMerger::viewOf(std::size_t place, const std::vector<CellKey>& keys)
{
  UnionView& view = scratch_.views[place];
  if (view.keys.empty())
  {
    view.keys = keys;
    trying_.look(view);
  }
  return view;
}

// Cells that fail, strain solvers or are very small, and for which nothing better is found.
void CellMerger::simplifyBest(
  CellKey key, const Verdict& own, std::size_t mostNeighbours, const Acceptance& acceptance)
{
  const auto isMended = [&] { return best_.of && best_.verdict.refused == 0; };
  if (isMended() || (own.invalid > 0 && !bendsInvalid_))
  {
    return;
  }
  cells_.open(key);
  if (own.refused > 0 || cells_.share(key) < LeastShare)
  {
    findBest(key, own, mostNeighbours, acceptance, spec_.joins, true);
  }
  else if (own.worst > PoorCost)
  {
    tryOut(viewOf(0, { key }), own, acceptance, spec_.joins, true);
  }
  if (own.refused > 0 && !isMended())
  {
    findBest(key, own, mostNeighbours, acceptance,
      { std::cos(radians(WideBoundaryAngle)), std::cos(radians(WideInnerAngle)) }, true);
  }
}

// Among the cell alone, if it may become simpler, and with each of its neighbours.
void CellMerger::findBest(CellKey key, const Verdict& own, std::size_t mostNeighbours,
  const Acceptance& acceptance, const JoinSpec& joins, bool simplifies)
{
  if (simplifies)
  {
    tryOut(viewOf(0, { key }), own, acceptance, joins, true);
  }
  const bool mustMerge = own.refused > 0 || isSmall(key);
  std::size_t tried = 0;
  for (const bool straddles : { false, true })
  {
    for (Neighbour& neighbour : scratch_.neighbours)
    {
      if (!spec_.merges || tried == mostNeighbours || (straddles && (!mustMerge || best_.of)) ||
        (best_.of && best_.verdict.worst < FairCost && best_.verdict.refused == 0))
      {
        break;
      }
      if (cells_.mayMerge({ key, neighbour.key }) &&
        cells_.wouldStraddleStages({ key, neighbour.key }) == straddles &&
        cells_.share(key) + cells_.share(neighbour.key) <= MostShare)
      {
        ++tried;
        tryWith(neighbour, key, own, acceptance, joins, simplifies);
      }
    }
  }
}

void CellMerger::tryWith(Neighbour& neighbour, CellKey key, const Verdict& own,
  const Acceptance& acceptance, const JoinSpec& joins, bool simplifies)
{
  const CellKey other = neighbour.key;
  cells_.open(other); // a hexahedron has no faces of its own
  const bool grows = cells_.volume(key) > cells_.volume(other);
  const std::vector<CellKey> keys{ grows ? key : other, grows ? other : key };
  if (!neighbour.verdict)
  {
    neighbour.verdict = verdictOf(other, &key, &key + 1);
  }
  Verdict before = own;
  before += *neighbour.verdict;
  before.cost -= CostOfCell * cells_.share(keys[1]);
  const double most = before.cost + MostOfJoins;
  if (simplifies || costTogether(key, other, most) <= most)
  {
    const auto place = static_cast<std::size_t>(&neighbour - scratch_.neighbours.data()) + 1;
    tryOut(viewOf(place, keys), before, acceptance, joins, simplifies);
  }
}

// About what the faces of the two cells looked around last would cost as they are, as those of one.
double CellMerger::costTogether(CellKey key, CellKey other, double most)
{
  const double own = own_.measures.volume;
  const double others = scratch_.cell.measures.volume;
  const Vector between = cells_.between(key, other);
  const Vector ownCentre = own_.measures.centre;
  const Vector centre = scaled(
    plus(scaled(ownCentre, own), scaled(plus(scratch_.cell.measures.centre, between), others)),
    1 / std::max(own + others, Tiny));
  own_.measures.volume = scratch_.cell.measures.volume = own + others;
  own_.measures.centre = centre;
  scratch_.cell.measures.centre = minus(centre, between);
  double cost = costAround(own_, other, most);
  cost += cost > most ? 0 : costAround(scratch_.cell, key, most - cost);
  own_.measures.volume = own;
  own_.measures.centre = ownCentre;
  return cost;
}

// Keeps the better one. `before`: the costs of each alone.
void CellMerger::tryOut(UnionView& of, const Verdict& before, const Acceptance& acceptance,
  const JoinSpec& joins, bool simplifies)
{
  scratch_.trial.of = &of;
  trying_.tryOut(scratch_.trial, joins, simplifies ? Never : before.cost + MostOfJoins);
  if (simplifies)
  {
    trying_.simplify(scratch_.trial);
  }
  if (gain(before, scratch_.trial.verdict) > acceptance.leastGain)
  {
    scratch_.trial.verdict.costBeyond = trying_.costBeyond(scratch_.trial);
  }
  scratch_.trial.gain = gain(before, scratch_.trial.verdict);
  if (accepts(acceptance, before, scratch_.trial.verdict) && isBetter(scratch_.trial, best_) &&
    trying_.isSound(scratch_.trial))
  {
    std::swap(best_, scratch_.trial);
  }
}

void CellMerger::apply(const CellUnion& chosen)
{
  const UnionView& of = *chosen.of;
  const CellKey into = of.keys.front();
  for (const CellKey other : of.view.across)
  {
    if (other != None)
    {
      cells_.open(other);
    }
  }
  for (std::size_t i = 1; i < of.keys.size(); ++i)
  {
    merged_ += cells_.counts(of.keys[i]);
    cells_.merge(of.keys[i], into);
  }
  simplified_ += of.keys.size() == 1 ? cells_.counts(into) : 0;
  cells_.join(into, of.view, chosen.joined);
}

}
