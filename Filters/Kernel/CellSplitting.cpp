#include "CellSplitting.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 16;

// A cell tries as many cuts for a start, the worst concave edges first.
constexpr std::size_t MostCandidates = 8;

// Cells of more faces stay whole: the time to look for a cut grows with the square of their number.
constexpr std::size_t MostFaces = 1000;

// Edges bent by less than this (as a sine) are flat.
constexpr double LeastBend = 1e-3;

// A part smaller than this part of the cell is no use.
constexpr double LeastPart = 1e-3;

// An edge bent by more (in radians) is worth a cut that helps nothing by itself.
constexpr double LeastWorthyBend = 0.1;

// Concave edges belong to one feature where they run within 45 degrees of each other.
constexpr double ContinuesCosine = 0.707;

// Ends a search that never came to rest; a cell is cut some ten times at most.
constexpr int MostRounds = 100;

struct ConcaveEdge
{
  std::uint32_t from;
  std::uint32_t to;
  std::array<std::uint32_t, 2> faces;
  double bend;    // the interior angle beyond 180 degrees, in radians
  Vector along;   // of length 1
  Vector inwards; // halves the interior angle; of length 1
  double length;
  bool failing; // one of its faces fails its condition
};

struct Proposal
{
  CellKey key;
  double area = 0; // of the faces at fault
  CellView view;
  std::vector<CellCut> cuts; // the fittest last
};

std::vector<ConcaveEdge> concaveEdges(const Polyhedron& cell, const CellShape& shape)
{
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> faceOf; // by directed edge
  for (std::uint32_t f = 0; f < cell.faces(); ++f)
  {
    for (std::uint32_t i = cell.start[f]; i < cell.start[f + 1]; ++i)
    {
      const std::uint32_t next = i + 1 < cell.start[f + 1] ? i + 1 : cell.start[f];
      faceOf[{ cell.corners[i], cell.corners[next] }] = f;
    }
  }
  std::vector<ConcaveEdge> edges;
  for (const auto& [edge, f] : faceOf)
  {
    const auto other = faceOf.find({ edge.second, edge.first });
    if (edge.first > edge.second || other == faceOf.end())
    {
      continue;
    }
    const Vector n1 = unit(shape.faces[f].area);
    const Vector n2 = unit(shape.faces[other->second].area);
    const Vector whole = minus(cell.nodes[edge.second], cell.nodes[edge.first]);
    const Vector along = unit(whole);
    const double sine = dot(cross(n1, n2), along);
    const double cosine = dot(n1, n2);
    if (sine > -LeastBend && !(cosine < 0 && sine < LeastBend))
    {
      continue;
    }
    ConcaveEdge e;
    e.from = edge.first;
    e.to = edge.second;
    e.faces = { f, other->second };
    e.bend = -std::atan2(sine, cosine);
    e.bend += e.bend < 0 ? 2 * 3.14159265358979 : 0;
    e.along = along;
    // Both the sum of the normals and that of the ways into the faces point out of the cell.
    const Vector ways = plus(cross(n1, along), cross(along, n2));
    e.inwards = unit(scaled(plus(plus(n1, n2), ways), -1));
    e.length = norm(whole);
    e.failing = isAtFault(cell, shape, f) || isAtFault(cell, shape, other->second);
    edges.push_back(e);
  }
  std::sort(edges.begin(), edges.end(), [](const ConcaveEdge& x, const ConcaveEdge& y) {
    const auto a = static_cast<float>(x.bend); // equal but for rounding is equal
    const auto b = static_cast<float>(y.bend);
    return a != b ? a > b : std::make_pair(x.from, x.to) < std::make_pair(y.from, y.to);
  });
  return edges;
}

// The plane through the edge that halves the angle, averaged over the concave edges that continue it
// at both ends (equation 6).
CutPlane planeThrough(
  const ConcaveEdge& worst, const std::vector<ConcaveEdge>& edges, const Polyhedron& cell)
{
  Vector inwards = scaled(worst.inwards, worst.length);
  std::set<std::uint32_t> nodes{ worst.from, worst.to };
  for (bool grown = true; grown;)
  {
    grown = false;
    for (const ConcaveEdge& e : edges)
    {
      const bool continues = (nodes.count(e.from) + nodes.count(e.to)) == 1;
      if (continues && std::abs(dot(e.along, worst.along)) > ContinuesCosine)
      {
        inwards = plus(inwards, scaled(e.inwards, e.length));
        nodes.insert(e.from);
        nodes.insert(e.to);
        grown = true;
      }
    }
  }
  CutPlane plane;
  plane.at = cell.nodes[worst.from];
  plane.normal = unit(cross(worst.along, inwards));
  plane.through = { worst.from, worst.to };
  return plane;
}

// The parts' fitness, or nothing where one is smaller than `least`.
std::optional<Fitness> fitnessAfter(const CellView& view, const CellCut& cut, double least)
{
  std::vector<Polyhedron> parts;
  std::vector<CellShape> shapes(cut.parts);
  for (std::uint32_t p = 0; p < cut.parts; ++p)
  {
    parts.push_back(partOf(view.shape, cut, p));
    measure(parts[p], shapes[p]);
    if (!(shapes[p].volume > least))
    {
      return {};
    }
  }
  Fitness sum;
  std::vector<Beyond> beyond;
  std::vector<std::uint8_t> counts;
  for (std::uint32_t p = 0; p < cut.parts; ++p)
  {
    beyond.clear();
    counts.clear();
    for (const CellCut::Face& face : cut.faces) // in the order of partOf
    {
      const bool inner = face.source == CellCut::NoSource;
      if (face.below == p || (inner && face.above == p))
      {
        const CellShape& other = shapes[face.below == p ? face.above : face.below];
        beyond.push_back(inner ? Beyond{ other.centre, other.volume } : view.beyond[face.source]);
        counts.push_back(face.below == p ? 1 : 0);
      }
    }
    sum += fitnessOf(parts[p], shapes[p], beyond, counts);
  }
  return sum;
}

// The cuts of one cell that are tried, and the best of them.
class Search
{
public:
  // `leastVolume`: of a part.
  Search(const CellView& view, const CellShape& shape, double leastVolume)
    : view_(view)
    , cell_(view.shape)
    , shape_(shape)
    , leastVolume_(leastVolume)
    , before_(fitnessOf(view.shape, shape, view.beyond))
    , best_(before_)
    , edges_(concaveEdges(view.shape, shape))
  {
  }

  // Cuts that help, the fittest last. Where none does, one along the worst concave edge that does no
  // harm: without concave edges nothing of the boundary fails.
  std::vector<CellCut> run()
  {
    const std::vector<std::size_t> candidates = this->candidates();
    for (const std::size_t i : candidates)
    {
      attempt(planeThrough(edges_[i], edges_, cell_), edges_[i].bend > LeastWorthyBend);
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
      for (const std::size_t i : candidates)
      {
        if (cuts_.empty())
        {
          attempt(planeOf(edges_[i], k), false);
        }
      }
    }
    if (cuts_.empty())
    {
      halve();
    }
    if (cuts_.empty() && hasFallback_ && before_.faults[Fitness::BoundaryAngle] > 0)
    {
      cuts_.push_back(std::move(fallback_));
    }
    return std::move(cuts_);
  }

private:
  // Across the centre, or half-way to a face at fault, which is nearer to the centre of its part then.
  void halve()
  {
    for (std::size_t face = 0; face < cell_.faces(); ++face)
    {
      if (!isAtFault(cell_, shape_, face))
      {
        continue;
      }
      for (const double share : { 0.0, 0.5 })
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          CutPlane plane;
          plane.at =
            plus(shape_.centre, scaled(minus(shape_.faces[face].centre, shape_.centre), share));
          plane.normal = { 0, 0, 0 };
          plane.normal[axis] = 1;
          attempt(plane, false);
        }
      }
    }
  }

  // The worst edges, and those of faces that fail.
  std::vector<std::size_t> candidates() const
  {
    std::vector<std::size_t> result;
    std::size_t ofFailing = 0;
    for (std::size_t i = 0; i < edges_.size(); ++i)
    {
      const bool more = edges_[i].failing && ofFailing < MostCandidates;
      if (i < MostCandidates || more)
      {
        result.push_back(i);
      }
      ofFailing += i >= MostCandidates && more ? 1 : 0;
    }
    return result;
  }

  // The plane of one of the edge's faces.
  CutPlane planeOf(const ConcaveEdge& edge, std::size_t face) const
  {
    CutPlane plane;
    plane.at = cell_.nodes[edge.from];
    plane.normal = unit(shape_.faces[edge.faces[face]].area);
    plane.through = { edge.from, edge.to };
    return plane;
  }

  void attempt(const CutPlane& plane, bool worthy)
  {
    if (best_.count() == 0 || !cutCell(cell_, plane, trial_))
    {
      return;
    }
    const std::optional<Fitness> after =
      fitnessAfter(view_, trial_, std::max(LeastPart * shape_.volume, leastVolume_));
    if (after && after->weight() < best_.weight())
    {
      best_ = *after;
      cuts_.push_back(std::move(trial_));
      trial_ = {};
    }
    else if (after && worthy && !hasFallback_ && after->weight() <= before_.weight())
    {
      hasFallback_ = true;
      std::swap(fallback_, trial_);
    }
  }

  const CellView& view_;
  const Polyhedron& cell_;
  const CellShape& shape_;
  double leastVolume_;
  Fitness before_;
  Fitness best_;
  std::vector<ConcaveEdge> edges_;
  std::vector<CellCut> cuts_;
  CellCut trial_;
  CellCut fallback_;
  bool hasFallback_ = false;
};

void propose(const CellComplex& cells, double leastFraction, Proposal& proposal)
{
  cells.view({ proposal.key }, proposal.view);
  if (proposal.view.shape.faces() > MostFaces)
  {
    return;
  }
  cells.lookBeyond(proposal.key, proposal.view);
  CellShape shape;
  measure(proposal.view.shape, shape);
  proposal.area = fitnessOf(proposal.view.shape, shape, proposal.view.beyond).area;
  const double least = leastFraction * cells.volumeOfBox(proposal.key);
  proposal.cuts = Search(proposal.view, shape, least).run();
}

bool isThin(const CellComplex& cells, CellKey key)
{
  Polyhedron polyhedron;
  CellShape shape;
  cells.shape(key, polyhedron);
  measure(polyhedron, shape);
  return isThin(shape);
}

bool fails(const CellComplex& cells, CellKey key)
{
  return cells.isAlive(key) && cells.isAtFault(key);
}

class Splitter
{
public:
  Splitter(CellComplex& cells, double leastFraction, Execution& execution)
    : cells_(cells)
    , leastFraction_(leastFraction)
    , execution_(execution)
  {
  }

  Splitting run(std::vector<CellKey> failing)
  {
    for (int round = 0; !failing.empty() && round < MostRounds; ++round)
    {
      std::vector<Proposal> proposals = propose(failing);
      taken_.clear();
      next_.clear();
      for (const Proposal& proposal : proposals)
      {
        execution_.poll();
        carryOut(proposal);
      }
      failing.clear();
      for (const CellKey key : next_)
      {
        failed_.erase(key);
        if (fails(cells_, key))
        {
          failing.push_back(key);
        }
      }
    }
    failed_.insert(failing.begin(), failing.end());
    result_.failed.assign(failed_.begin(), failed_.end());
    return result_;
  }

private:
  // Those with most at fault first.
  std::vector<Proposal> propose(const std::vector<CellKey>& failing) const
  {
    std::vector<Proposal> proposals(failing.size());
    execution_.forEach(failing.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        proposals[i].key = failing[i];
        cartesian::propose(cells_, leastFraction_, proposals[i]);
      }
    });
    std::sort(proposals.begin(), proposals.end(), [](const Proposal& x, const Proposal& y) {
      const auto a = static_cast<float>(x.area);
      const auto b = static_cast<float>(y.area);
      return a != b ? a > b : x.key < y.key;
    });
    return proposals;
  }

  bool isTaken(CellKey key) const { return taken_.count(key) > 0; }

  // The fittest cut that spoils no cell beyond; in the next round, if another cut has changed one.
  void carryOut(const Proposal& proposal)
  {
    cells_.open(proposal.key);
    for (auto cut = proposal.cuts.rbegin(); cut != proposal.cuts.rend(); ++cut)
    {
      const std::vector<CellKey> touched = cells_.touchedBy(proposal.key, proposal.view, *cut);
      if (std::any_of(touched.begin(), touched.end(), [&](CellKey k) { return isTaken(k); }))
      {
        next_.insert(proposal.key);
        return;
      }
      if (!cells_.meetsNode(touched, proposal.view, *cut) &&
        std::none_of(
          touched.begin() + 1, touched.end(), [&](CellKey k) { return isThin(cells_, k); }))
      {
        taken_.insert(touched.begin(), touched.end());
        next_.insert(touched.begin(), touched.end());
        std::vector<CellKey> parts;
        cells_.cut(proposal.key, proposal.view, *cut, parts);
        next_.insert(parts.begin(), parts.end());
        ++result_.cellsSplit;
        return;
      }
    }
    failed_.insert(proposal.key);
  }

  CellComplex& cells_;
  double leastFraction_;
  Execution& execution_;
  Splitting result_;
  std::set<CellKey> failed_;
  std::set<CellKey> taken_; // changed in this round
  std::set<CellKey> next_;  // to be looked at in the next
};

}

Splitting splitCells(
  CellComplex& cells, std::vector<CellKey> failing, double leastFraction, Execution& execution)
{
  return Splitter(cells, leastFraction, execution).run(std::move(failing));
}

}
