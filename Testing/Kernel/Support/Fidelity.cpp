#include "Support/Fidelity.h"

#include "Support/MeshChecker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>

namespace cartesian
{

namespace
{

constexpr double KeptWithin = 0.1;    // of a box
constexpr double SampleLength = 0.2;  // of edges, in boxes
constexpr double LeaningDegrees = 45; // more than this
constexpr double EquallyNear = 1e-3;  // boxes
constexpr double RoundingDegrees = 1e-6;

using Triple = std::array<Vector, 3>;

Vector nearestOnSegment(const Vector& a, const Vector& b, const Vector& p)
{
  const Vector along = minus(b, a);
  const double square = dot(along, along);
  const double t = square > 0 ? std::clamp(dot(minus(p, a), along) / square, 0.0, 1.0) : 0;
  return plus(a, scaled(along, t));
}

// A triangle without area is a line.
double distanceFrom(const Triple& triangle, const Vector& p)
{
  const Vector normal = cross(minus(triangle[1], triangle[0]), minus(triangle[2], triangle[0]));
  double distance = std::numeric_limits<double>::infinity();
  bool isAbove = norm(normal) > 0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Vector& a = triangle[i];
    const Vector& b = triangle[(i + 1) % 3];
    distance = std::min(distance, norm(minus(p, nearestOnSegment(a, b, p))));
    isAbove = isAbove && dot(cross(normal, minus(b, a)), minus(p, a)) >= 0;
  }
  return isAbove ? std::abs(dot(minus(p, triangle[0]), unit(normal))) : distance;
}

// Triangles in a tree of boxes around halves of them.
class TrianglesNearby
{
public:
  explicit TrianglesNearby(std::vector<Triple> triangles)
    : triangles_(std::move(triangles))
  {
    if (!triangles_.empty())
    {
      build(0, triangles_.size());
    }
  }

  double distance(const Vector& p) const
  {
    double least = std::numeric_limits<double>::infinity();
    visit(p, least,
      [&](const Triple& triangle) { least = std::min(least, distanceFrom(triangle, p)); });
    return least;
  }

  // The largest cosine between the normal and those of triangles that are no farther away than `most`.
  double cosine(const Vector& p, const Vector& normal, double most) const
  {
    double largest = -1;
    visit(p, most, [&](const Triple& t) {
      if (distanceFrom(t, p) <= most)
      {
        largest = std::max(largest, dot(normal, unit(cross(minus(t[1], t[0]), minus(t[2], t[0])))));
      }
    });
    return largest;
  }

private:
  struct Node
  {
    Vector low;
    Vector high;
    std::size_t begin; // of triangles
    std::size_t end;
    std::size_t second = 0; // the first half follows; 0: there are none
  };

  void build(std::size_t begin, std::size_t end)
  {
    const std::size_t number = nodes_.size();
    nodes_.push_back({ triangles_[begin][0], triangles_[begin][0], begin, end });
    for (std::size_t t = begin; t < end; ++t)
    {
      for (const Vector& p : triangles_[t])
      {
        for (std::size_t axis = 0; axis < 3; ++axis)
        {
          nodes_[number].low[axis] = std::min(nodes_[number].low[axis], p[axis]);
          nodes_[number].high[axis] = std::max(nodes_[number].high[axis], p[axis]);
        }
      }
    }
    if (end - begin <= 4)
    {
      return;
    }
    const Vector size = minus(nodes_[number].high, nodes_[number].low);
    const auto axis =
      static_cast<std::size_t>(std::max_element(size.begin(), size.end()) - size.begin());
    const std::size_t middle = begin + (end - begin) / 2;
    const auto at = [&](std::size_t t) {
      return triangles_.begin() + static_cast<std::ptrdiff_t>(t);
    };
    const auto place = [&](const Triple& t) { return t[0][axis] + t[1][axis] + t[2][axis]; };
    std::nth_element(at(begin), at(middle), at(end),
      [&](const Triple& s, const Triple& t) { return place(s) < place(t); });
    build(begin, middle);
    nodes_[number].second = nodes_.size();
    build(middle, end);
  }

  // Those in boxes that are no farther away than `most`, which may fall meanwhile.
  template <class Visitor>
  void visit(const Vector& p, const double& most, Visitor&& see, std::size_t number = 0) const
  {
    if (nodes_.empty() || distanceToBox(nodes_[number], p) > most)
    {
      return;
    }
    const Node& node = nodes_[number];
    if (node.second == 0)
    {
      std::for_each(triangles_.begin() + static_cast<std::ptrdiff_t>(node.begin),
        triangles_.begin() + static_cast<std::ptrdiff_t>(node.end), see);
      return;
    }
    const bool isFirst =
      distanceToBox(nodes_[number + 1], p) <= distanceToBox(nodes_[node.second], p);
    visit(p, most, see, isFirst ? number + 1 : node.second);
    visit(p, most, see, isFirst ? node.second : number + 1);
  }

  static double distanceToBox(const Node& node, const Vector& p)
  {
    Vector off{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      off[axis] = std::max({ 0.0, node.low[axis] - p[axis], p[axis] - node.high[axis] });
    }
    return norm(off);
  }

  std::vector<Triple> triangles_;
  std::vector<Node> nodes_;
};

// A face at the boundary: of the mesh, or a triangle of the surface.
struct ShellFace
{
  std::vector<Id> corners; // numbers of points
  Vector centre{};
  Vector area{}; // out of what the surface encloses
};

// Those of one or the other, and how they meet.
class Shell
{
public:
  explicit Shell(std::vector<Vector> points)
    : points_(std::move(points))
  {
  }

  void add(std::vector<Id> corners)
  {
    ShellFace wall;
    for (const Id corner : corners)
    {
      wall.centre = plus(wall.centre, scaled(at(corner), 1 / double(corners.size())));
    }
    for (std::size_t i = 0; i < corners.size(); ++i)
    {
      const Vector from = minus(at(corners[i]), wall.centre);
      const Vector to = minus(at(corners[(i + 1) % corners.size()]), wall.centre);
      wall.area = plus(wall.area, scaled(cross(from, to), 0.5));
    }
    wall.corners = std::move(corners);
    all_.push_back(std::move(wall));
  }

  const std::vector<ShellFace>& all() const { return all_; }
  const Vector& at(Id point) const { return points_[static_cast<std::size_t>(point)]; }

  // Cut into triangles about their centres, or as they are.
  std::vector<Triple> triangles() const
  {
    std::vector<Triple> found;
    for (const ShellFace& wall : all_)
    {
      const std::size_t size = wall.corners.size();
      if (size == 3)
      {
        found.push_back({ at(wall.corners[0]), at(wall.corners[1]), at(wall.corners[2]) });
      }
      for (std::size_t i = 0; size > 3 && i < size; ++i)
      {
        found.push_back({ wall.centre, at(wall.corners[i]), at(wall.corners[(i + 1) % size]) });
      }
    }
    return found;
  }

  // Edges at which two turn by more than this, or not exactly two meet.
  std::vector<std::array<Vector, 2>> sharpEdges(double degrees) const
  {
    std::map<std::pair<Id, Id>, std::vector<const ShellFace*>> around;
    for (const ShellFace& wall : all_)
    {
      for (std::size_t i = 0; i < wall.corners.size(); ++i)
      {
        around[std::minmax(wall.corners[i], wall.corners[(i + 1) % wall.corners.size()])].push_back(
          &wall);
      }
    }
    std::vector<std::array<Vector, 2>> found;
    for (const auto& [edge, walls] : around)
    {
      if (walls.size() != 2 ||
        dot(unit(walls[0]->area), unit(walls[1]->area)) < std::cos(radians(degrees)))
      {
        found.push_back({ at(edge.first), at(edge.second) });
      }
    }
    return found;
  }

private:
  std::vector<Vector> points_;
  std::vector<ShellFace> all_;
};

Shell shellOf(const Soup& soup)
{
  Shell shell(soup.points);
  for (const auto& t : soup.triangles)
  {
    shell.add({ Id(t[0]), Id(t[1]), Id(t[2]) });
  }
  return shell;
}

// The boundary's faces, but for those of boundaries that the surface does not have; turned, where the mesh is
// around it.
Shell shellOf(
  const MeshArrays& mesh, const std::map<std::int32_t, double>& boundaries, bool isAround)
{
  std::vector<Vector> points;
  for (std::size_t i = 0; i < mesh.points.size(); i += 3)
  {
    points.push_back({ mesh.points[i], mesh.points[i + 1], mesh.points[i + 2] });
  }
  Shell shell(std::move(points));
  for (std::size_t f = 0; f < mesh.boundaryIndex.size(); ++f)
  {
    if (boundaries.count(mesh.boundaryIndex[f]) > 0)
    {
      std::vector<Id> corners(mesh.boundaryPoints.begin() + mesh.boundaryStart[f],
        mesh.boundaryPoints.begin() + mesh.boundaryStart[f + 1]);
      if (isAround)
      {
        std::reverse(corners.begin(), corners.end());
      }
      shell.add(std::move(corners));
    }
  }
  return shell;
}

std::map<std::int32_t, double> areasOf(const Soup& soup)
{
  std::map<std::int32_t, double> areas;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    areas[soup.boundaryOf(t)] += soup.area(t);
  }
  return areas;
}

std::map<std::int32_t, double> areaErrors(
  const MeshArrays& mesh, const Shell& shell, std::map<std::int32_t, double> expected)
{
  std::map<std::int32_t, double> found = expected;
  std::for_each(found.begin(), found.end(), [](auto& of) { of.second = -1; });
  auto face = shell.all().begin();
  for (const std::int32_t boundary : mesh.boundaryIndex)
  {
    if (expected.count(boundary) > 0)
    {
      found[boundary] += norm((face++)->area) / expected[boundary];
    }
  }
  return found;
}

// Places all over a triangle, no more than a box apart.
void addPlaces(const Triple& t, double box, std::vector<Vector>& places)
{
  const double longest =
    std::max({ norm(minus(t[1], t[0])), norm(minus(t[2], t[1])), norm(minus(t[0], t[2])) });
  const int steps = static_cast<int>(std::ceil(longest / box)) + 1;
  for (int i = 0; i <= steps; ++i)
  {
    for (int k = 0; i + k <= steps; ++k)
    {
      const Vector along = scaled(minus(t[1], t[0]), double(i) / steps);
      places.push_back(plus(t[0], plus(along, scaled(minus(t[2], t[0]), double(k) / steps))));
    }
  }
}

double edgesKept(const Shell& surface, const Shell& boundary, double box, double featureAngle)
{
  std::vector<Triple> edges;
  for (const auto& [from, to] : boundary.sharpEdges(featureAngle / 2))
  {
    edges.push_back({ from, to, to });
  }
  const TrianglesNearby nearby(std::move(edges));
  double all = 0;
  double kept = 0;
  for (const auto& [from, to] : surface.sharpEdges(featureAngle + RoundingDegrees))
  {
    const double length = norm(minus(to, from));
    const int pieces = static_cast<int>(std::ceil(length / (SampleLength * box)));
    for (int i = 0; i < pieces; ++i)
    {
      const Vector place = plus(from, scaled(minus(to, from), (i + 0.5) / pieces));
      all += length / pieces;
      kept += nearby.distance(place) <= KeptWithin * box ? length / pieces : 0;
    }
  }
  return all > 0 ? kept / all : 1;
}

}

double Fidelity::worstArea() const
{
  return std::accumulate(areas.begin(), areas.end(), 0.0,
    [](double worst, const auto& of) { return std::max(worst, std::abs(of.second)); });
}

Fidelity fidelityOf(const MeshArrays& mesh, const Soup& soup, double box, double featureAngle,
  const std::optional<Bounds>& around)
{
  const std::map<std::int32_t, double> areas = areasOf(soup);
  const Shell surface = shellOf(soup);
  const Shell boundary = shellOf(mesh, areas, around.has_value());
  Fidelity found;
  double whole = volumeOf(mesh);
  if (around)
  {
    const Vector size = minus(around->high, around->low);
    whole = size[0] * size[1] * size[2] - whole;
  }
  found.volume = whole / soup.volume() - 1;
  found.areas = areaErrors(mesh, boundary, areas);

  const std::vector<Triple> triangles = surface.triangles();
  const TrianglesNearby ofSurface(triangles);
  const double leaning = std::cos(radians(LeaningDegrees));
  std::set<Id> corners;
  for (const ShellFace& wall : boundary.all())
  {
    const double off = ofSurface.distance(wall.centre);
    found.boundaryOff = std::max(found.boundaryOff, off / box);
    corners.insert(wall.corners.begin(), wall.corners.end());
    found.leaning +=
      ofSurface.cosine(wall.centre, unit(wall.area), off + EquallyNear * box) < leaning ? 1 : 0;
  }
  for (const Id corner : corners)
  {
    found.boundaryOff = std::max(found.boundaryOff, ofSurface.distance(boundary.at(corner)) / box);
  }
  const TrianglesNearby ofBoundary(boundary.triangles());
  std::vector<Vector> places;
  std::for_each(triangles.begin(), triangles.end(),
    [&](const Triple& triangle) { addPlaces(triangle, box, places); });
  for (const Vector& place : places)
  {
    found.surfaceOff = std::max(found.surfaceOff, ofBoundary.distance(place) / box);
  }
  found.edgesKept = edgesKept(surface, boundary, box, featureAngle);
  return found;
}

}
