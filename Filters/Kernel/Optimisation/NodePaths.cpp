// SPDX-License-Identifier: BSD-3-Clause
#include "Optimisation/NodePaths.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// How far nodes may move, as a part of the box's edge.
constexpr double FarthestWay = 0.5;

// How far nodes may leave the surface, and its edges, as parts of the box's edge.
constexpr double MostFromSurface = 0.01;
constexpr double MostFromEdge = 0.004;

// An edge of the surface that turns by more at a node has a corner there: cosine of 15 degrees.
constexpr double LeastCosineOfLine = 0.966;

// A border between boundaries in a plane alone shows how large they are: where its radius of curvature is less than this
// many of the box's edges, all its corners stay.
constexpr double TightRadius = 1.5;
constexpr double LeastCosineInPlane = 0.99996; // of normals: half a degree

}

NodePaths::NodePaths(const NodeMesh& mesh, double leastCosine)
  : ends_(mesh.ends)
  , paths_(mesh.nodes.at.size())
  , start_(mesh.nodes.at.size() + 1)
  , legsOf_(mesh.nodes.at.size(), None)
{
  listUses(mesh);
  for (std::uint32_t node = 0; node < mesh.nodes.at.size(); ++node)
  {
    if (mesh.nodes.mayMove[node])
    {
      paths_[node] = pathOf(mesh, node, leastCosine);
    }
  }
}

void NodePaths::listUses(const NodeMesh& mesh)
{
  const auto forEachUse = [&](auto&& visit) {
    for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    {
      for (std::uint32_t i = mesh.faces.start[f]; mesh.isWall(f) && i < mesh.faces.stop[f]; ++i)
      {
        if (mesh.nodes.mayMove[mesh.faces.corners[i]])
        {
          visit(f, i);
        }
      }
    }
  };
  forEachUse([&](std::size_t f, std::uint32_t i) {
    start_[mesh.faces.corners[i] + 1] += mesh.isInterface(f) ? 2 : 1;
  });
  for (std::size_t n = 0; n < mesh.nodes.at.size(); ++n)
  {
    start_[n + 1] += start_[n];
  }
  uses_.resize(start_.back());
  std::vector<std::uint32_t> next(start_.begin(), start_.end() - 1);
  const std::vector<double> edges = mesh.edgesAtFaces();
  forEachUse([&](std::size_t f, std::uint32_t i) {
    const std::uint32_t begin = mesh.faces.start[f];
    const std::uint32_t end = mesh.faces.stop[f];
    const FaceGeometry face = measureFace(end - begin,
      [&](std::size_t k) -> const Vector& { return mesh.nodes.at[mesh.faces.corners[begin + k]]; });
    const bool isInterface = mesh.isInterface(f);
    const Use use{ mesh.faces.corners[i > begin ? i - 1 : end - 1],
      mesh.faces.corners[i + 1 < end ? i + 1 : begin], unit(face.area), mesh.faces.boundary[f],
      mesh.cells.region[mesh.faces.cells[f][0]], isInterface, edges[f] };
    uses_[next[mesh.faces.corners[i]]++] = use;
    if (isInterface)
    {
      uses_[next[mesh.faces.corners[i]]++] = { use.after, use.before, scaled(use.normal, -1),
        use.boundary, mesh.cells.region[mesh.faces.cells[f][1]], true, edges[f] };
    }
  });
  for (std::size_t n = 0; n < mesh.nodes.at.size(); ++n)
  {
    std::stable_sort(uses_.begin() + std::ptrdiff_t(start_[n]),
      uses_.begin() + std::ptrdiff_t(start_[n + 1]),
      [](const Use& a, const Use& b) { return a.region < b.region; });
  }
}

NodePaths::Sheet NodePaths::sheetOf(const Use* begin, const Use* end, double leastCosine)
{
  Sheet sheet;
  for (const Use* use = begin; use != end; ++use)
  {
    sheet.mean = plus(sheet.mean, use->normal);
    const Use* const next =
      std::find_if(begin, end, [&](const Use& other) { return other.before == use->after; });
    if (next == end)
    {
      sheet.closes = false;
      return sheet;
    }
    if (next->boundary != use->boundary || dot(next->normal, use->normal) < leastCosine)
    {
      sheet.sharp.push_back(use->after);
    }
    sheet.isSmooth = sheet.isSmooth && std::all_of(begin, use, [&](const Use& o) {
      return dot(o.normal, use->normal) >= leastCosine;
    });
    sheet.isFlat = sheet.isFlat && dot(begin->normal, use->normal) >= LeastCosineInPlane;
    sheet.edge = std::min(sheet.edge, use->edge);
    sheet.isInterface = sheet.isInterface && use->isInterface;
  }
  return sheet;
}

bool NodePaths::areTheSame(const Sheet& a, const Sheet& b)
{
  return b.closes &&
    (a.sharp.empty() && b.sharp.empty()
        ? a.isInterface && b.isInterface
        : std::is_permutation(a.sharp.begin(), a.sharp.end(), b.sharp.begin(), b.sharp.end()));
}

bool NodePaths::hasCorner(const Sheet& sheet, const Vector& ahead, const Vector& back)
{
  const Vector one = unit(ahead);
  const Vector other = unit(back);
  return dot(one, other) > -LeastCosineOfLine ||
    (sheet.isFlat &&
      (norm(ahead) + norm(back)) / 2 < norm(cross(one, other)) * TightRadius * sheet.edge);
}

NodePath NodePaths::pathOf(const NodeMesh& mesh, std::uint32_t node, double leastCosine)
{
  const Use* next = uses_.data() + start_[node];
  const Use* const end = uses_.data() + start_[node + 1];
  if (next == end)
  {
    return { NodePath::Kind::Free, {} };
  }
  const auto nextSheet = [&] {
    const Use* const begin = next;
    next = std::find_if(begin, end, [&](const Use& use) { return use.region != begin->region; });
    return sheetOf(begin, next, leastCosine);
  };
  const Sheet sheet = nextSheet();
  bool same = sheet.closes;
  while (same && next != end)
  {
    same = areTheSame(sheet, nextSheet());
  }
  if (!same)
  {
    return {};
  }
  if (sheet.sharp.empty() && sheet.isSmooth)
  {
    return { NodePath::Kind::Plane, unit(sheet.mean) };
  }
  if (sheet.sharp.size() != 2)
  {
    return {};
  }
  const Vector ahead = minus(mesh.nodes.at[sheet.sharp[0]], mesh.nodes.at[node]);
  const Vector back = minus(mesh.nodes.at[sheet.sharp[1]], mesh.nodes.at[node]);
  if (hasCorner(sheet, ahead, back))
  {
    return {};
  }
  legsOf_[node] = static_cast<std::uint32_t>(legs_.size());
  legs_.push_back({ unit(ahead), unit(back) });
  return { NodePath::Kind::Line, unit(minus(unit(ahead), unit(back))) };
}

bool NodePaths::allows(std::size_t node, const Vector& from, const Vector& to, double edge) const
{
  const Vector way = minus(to, from);
  bool isInGrid = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    isInGrid = isInGrid && to[axis] > ends_[0][axis] && to[axis] < ends_[1][axis];
  }
  if (!isInGrid || norm(way) > FarthestWay * edge)
  {
    return false;
  }
  if (paths_[node].kind == NodePath::Kind::Line)
  {
    const auto& legs = legs_[legsOf_[node]];
    const Vector& leg = dot(way, legs[0]) > 0 ? legs[0] : legs[1];
    return norm(cross(way, leg)) <= MostFromEdge * edge;
  }
  for (std::uint32_t u = start_[node]; u < start_[node + 1]; ++u)
  {
    if (std::abs(dot(way, uses_[u].normal)) > MostFromSurface * edge)
    {
      return false;
    }
  }
  return true;
}

}
