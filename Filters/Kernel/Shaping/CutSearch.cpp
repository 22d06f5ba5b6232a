// SPDX-License-Identifier: BSD-3-Clause
#include "Shaping/CutSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

// A cell tries as many cuts for a start, the worst concave edges first; and is halved at as many faces, the
// largest first.
constexpr std::size_t MostCandidates = 8;

constexpr std::uint32_t None = ~std::uint32_t(0);

// Cells of more faces stay whole: the time to look for a cut grows with the square of their number.
constexpr std::size_t MostFaces = 100;

// Edges bent by less than this (as a sine) are flat.
constexpr double LeastBend = 1e-3;

// An edge bent by more (in radians) is worth a cut that helps nothing by itself.
constexpr double LeastWorthyBend = 0.1;

// Concave edges belong to one feature where they run within 45 degrees of each other.
constexpr double ContinuesCosine = 0.707;

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

// From a lower to a higher node: the face that runs along it, and that which runs against it.
struct EdgeOfCell
{
  std::uint32_t from;
  std::uint32_t to;
  std::array<std::uint32_t, 2> faces;
};

// Those with both faces, in order; of several faces the last counts.
std::vector<EdgeOfCell> edgesOf(const Polyhedron& cell)
{
  std::vector<std::array<std::uint32_t, 4>> runs; // lower and higher node, whether against, face
  runs.reserve(cell.corners.size());
  for (std::uint32_t f = 0; f < cell.faces(); ++f)
  {
    std::uint32_t from = cell.corners[cell.start[f + 1] - 1];
    for (std::uint32_t i = cell.start[f]; i < cell.start[f + 1]; ++i)
    {
      const std::uint32_t to = cell.corners[i];
      runs.push_back({ std::min(from, to), std::max(from, to), from > to ? 1U : 0U, f });
      from = to;
    }
  }
  std::sort(runs.begin(), runs.end());
  std::vector<EdgeOfCell> edges;
  for (auto run = runs.begin(); run != runs.end();)
  {
    std::array<std::uint32_t, 2> faces{ None, None };
    const auto first = run;
    for (; run != runs.end() && (*run)[0] == (*first)[0] && (*run)[1] == (*first)[1]; ++run)
    {
      faces[(*run)[2]] = (*run)[3];
    }
    if (faces[0] != None && faces[1] != None)
    {
      edges.push_back({ (*first)[0], (*first)[1], faces });
    }
  }
  return edges;
}

std::vector<ConcaveEdge> concaveEdges(const Polyhedron& cell, const CellShape& shape)
{
  std::vector<ConcaveEdge> edges;
  for (const EdgeOfCell& edge : edgesOf(cell))
  {
    const Vector n1 = unit(shape.faces[edge.faces[0]].area);
    const Vector n2 = unit(shape.faces[edge.faces[1]].area);
    const Vector whole = minus(cell.nodes[edge.to], cell.nodes[edge.from]);
    const Vector along = unit(whole);
    const double sine = dot(cross(n1, n2), along);
    const double cosine = dot(n1, n2);
    if (sine > -LeastBend && !(cosine < 0 && sine < LeastBend))
    {
      continue;
    }
    ConcaveEdge e;
    e.from = edge.from;
    e.to = edge.to;
    e.faces = edge.faces;
    e.bend = -std::atan2(sine, cosine);
    e.bend += e.bend < 0 ? 2 * Pi : 0;
    e.along = along;
    // Both the sum of the normals and that of the ways into the faces point out of the cell.
    const Vector ways = plus(cross(n1, along), cross(along, n2));
    e.inwards = unit(scaled(plus(plus(n1, n2), ways), -1));
    e.length = norm(whole);
    e.failing = isAtFault(cell, shape, e.faces[0]) || isAtFault(cell, shape, e.faces[1]);
    edges.push_back(e);
  }
  std::sort(edges.begin(), edges.end(), [](const ConcaveEdge& x, const ConcaveEdge& y) {
    const auto a = static_cast<float>(x.bend); // equal up to rounding counts as equal
    const auto b = static_cast<float>(y.bend);
    return a != b ? a > b : std::make_pair(x.from, x.to) < std::make_pair(y.from, y.to);
  });
  return edges;
}

// The plane through the edge that halves the angle, averaged over the concave edges that continue it
// at both ends (equation 6).
CutPlane planeThrough(const ConcaveEdge& worst, const std::vector<ConcaveEdge>& edges,
  const Polyhedron& cell, double turn)
{
  Vector inwards = scaled(worst.inwards, worst.length);
  std::vector<std::uint32_t> nodes{ worst.from, worst.to };
  const auto has = [&](std::uint32_t node) {
    return std::find(nodes.begin(), nodes.end(), node) != nodes.end();
  };
  for (bool grown = true; grown;)
  {
    grown = false;
    for (const ConcaveEdge& e : edges)
    {
      const bool startsHere = has(e.from);
      if (startsHere != has(e.to) && std::abs(dot(e.along, worst.along)) > ContinuesCosine)
      {
        inwards = plus(inwards, scaled(e.inwards, e.length));
        nodes.push_back(startsHere ? e.to : e.from);
        grown = true;
      }
    }
  }
  CutPlane plane;
  plane.at = cell.nodes[worst.from];
  plane.normal = unit(cross(worst.along, inwards));
  if (turn != 0)
  {
    plane.normal = unit(plus(scaled(plane.normal, std::cos(turn)),
      scaled(cross(worst.along, plane.normal), std::sin(turn))));
  }
  plane.through = { worst.from, worst.to };
  return plane;
}

// The cuts of one cell that are tried, and the best of them.
class Search
{
public:
  Search(const CellView& view, const CellShape& shape, const CellFaults& before, const Judge& judge,
    const Turns& turns)
    : cell_(view.shape)
    , shape_(shape)
    , judge_(judge)
    , turns_(turns)
    , before_(before)
    , best_(before)
    , edges_(concaveEdges(view.shape, shape))
  {
  }

  FoundCuts run()
  {
    const std::vector<std::size_t> candidates = this->candidates();
    for (const double turn : turns_)
    {
      for (const std::size_t i : candidates)
      {
        attempt(planeThrough(edges_[i], edges_, cell_, turn), edges_[i].bend > LeastWorthyBend);
      }
    }
    for (std::size_t k = 0; k < 2; ++k)
    {
      for (const std::size_t i : candidates)
      {
        if (found_.helpful.empty())
        {
          attempt(planeOf(edges_[i], k), false);
        }
      }
    }
    if (found_.helpful.empty())
    {
      halve();
    }
    return std::move(found_);
  }

private:
  // Across the centre, or half-way to a face at fault, which is nearer to the centre of its part then.
  void halve()
  {
    const std::vector<std::size_t> faces = largestAtFault();
    if (!faces.empty())
    {
      halveAt(shape_.centre);
    }
    for (const std::size_t face : faces)
    {
      halveAt(plus(shape_.centre, scaled(minus(shape_.faces[face].centre, shape_.centre), 0.5)));
    }
  }

  std::vector<std::size_t> largestAtFault() const
  {
    std::vector<std::size_t> faces;
    for (std::size_t face = 0; face < cell_.faces(); ++face)
    {
      if (isAtFault(cell_, shape_, face))
      {
        faces.push_back(face);
      }
    }
    // Equal up to rounding counts as equal.
    const auto areaOf = [&](std::size_t face) { return float(norm(shape_.faces[face].area)); };
    std::stable_sort(faces.begin(), faces.end(),
      [&](std::size_t f, std::size_t g) { return areaOf(f) > areaOf(g); });
    faces.resize(std::min(faces.size(), MostCandidates));
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  void halveAt(const Vector& at)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      CutPlane plane;
      plane.at = at;
      plane.normal = { 0, 0, 0 };
      plane.normal[axis] = 1;
      attempt(plane, false);
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
    if (best_.weight() == 0 || !cutCell(cell_, plane, trial_))
    {
      return;
    }
    const std::optional<CellFaults> after = judge_(trial_);
    if (after && after->weight() < best_.weight())
    {
      best_ = *after;
      found_.helpful.push_back(std::move(trial_));
      trial_ = {};
    }
    else if (after && worthy && !found_.harmless && after->weight() <= before_.weight())
    {
      found_.harmless = std::move(trial_);
      trial_ = {};
    }
  }

  const Polyhedron& cell_;
  const CellShape& shape_;
  const Judge& judge_;
  const Turns& turns_;
  CellFaults before_;
  CellFaults best_;
  std::vector<ConcaveEdge> edges_;
  FoundCuts found_;
  CellCut trial_;
};

}

bool CutParts::make(const CellCut& cut, double least)
{
  cut_ = &cut;
  parts.resize(cut.parts);
  shapes.resize(cut.parts);
  smallest = std::numeric_limits<double>::infinity();
  for (std::uint32_t p = 0; p < cut.parts; ++p)
  {
    takePart(view_.shape, cut, p, parts[p]);
    measurePart(p);
    smallest = std::min(smallest, shapes[p].volume);
    if (!(shapes[p].volume > least))
    {
      return false;
    }
  }
  return true;
}

// Faces that are whole are measured already.
void CutParts::measurePart(std::size_t part)
{
  std::vector<FaceShape>& faces = shapes[part].faces;
  faces.clear();
  forEachFace(part, [&](const CellCut::Face& face, bool isCut) {
    const CellCut::FaceCorners corners = cut_->cornersOf(face);
    const auto isWhole = [&] {
      const Ring whole = ringOf(view_.shape, face.source);
      return std::equal(corners.begin(), corners.end(), whole.corners, whole.corners + whole.size);
    };
    faces.push_back(
      !isCut && isWhole() ? shape_.faces[face.source] : measure(ringOf(parts[part], faces.size())));
  });
  measureVolume(shapes[part]);
}

double CutParts::largestAspect() const
{
  double aspect = 1;
  for (const CellShape& shape : shapes)
  {
    double area = 0;
    for (const FaceShape& face : shape.faces)
    {
      area += norm(face.area);
    }
    aspect = std::max(aspect, area / (6 * std::pow(std::max(shape.volume, Tiny), 2.0 / 3)));
  }
  return aspect;
}

// visit(face, whether it is the cut), in the order of partOf.
template <class Visitor>
void CutParts::forEachFace(std::size_t part, Visitor&& visit) const
{
  for (const CellCut::Face& face : cut_->faces)
  {
    const bool isCut = face.source == CellCut::NoSource;
    if (face.below == part || (isCut && face.above == part))
    {
      visit(face, isCut);
    }
  }
}

CellFaults CutParts::faults()
{
  CellFaults sum;
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    beyond_.clear();
    counts_.clear();
    forEachFace(p, [&](const CellCut::Face& face, bool isCut) {
      const CellShape& other = shapes[isCut && face.below == p ? face.above : face.below];
      beyond_.push_back(
        isCut ? NeighbourCell{ other.centre, other.volume } : view_.beyond[face.source]);
      counts_.push_back(face.below == p ? 1 : 0);
    });
    sum += faultsOf(parts[p], shapes[p], beyond_, counts_);
  }
  return sum;
}

CellFaults CutParts::faultsAlone(std::size_t part) const
{
  Polyhedron alone = parts[part];
  std::vector<NeighbourCell> beyond;
  forEachFace(part, [&](const CellCut::Face& face, bool isCut) {
    alone.isBoundary[beyond.size()] = isCut || view_.shape.isBoundary[face.source];
    beyond.push_back(isCut ? NeighbourCell{} : view_.beyond[face.source]);
  });
  return faultsOf(alone, shapes[part], beyond);
}

FoundCuts searchCuts(const CellView& view, const CellShape& shape, const CellFaults& before,
  const Judge& judge, const Turns& turns)
{
  if (view.shape.faces() > MostFaces)
  {
    return {};
  }
  return Search(view, shape, before, judge, turns).run();
}

}
