#include "Support/MeshChecker.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

namespace cartesian
{

std::vector<Face> facesOf(const MeshArrays& mesh, std::size_t cell)
{
  std::vector<Face> faces;
  if (mesh.types[cell] == MeshArrays::Hexahedron)
  {
    const Id* p = mesh.connectivity.data() + mesh.offsets[cell];
    constexpr int sides[6][4] = { { 0, 4, 7, 3 }, { 1, 2, 6, 5 }, { 0, 1, 5, 4 }, { 3, 7, 6, 2 },
      { 0, 3, 2, 1 }, { 4, 5, 6, 7 } };
    for (const auto& s : sides)
    {
      faces.push_back({ p[s[0]], p[s[1]], p[s[2]], p[s[3]] });
    }
    return faces;
  }
  auto next = static_cast<std::size_t>(mesh.faceStart[cell]);
  const Id count = mesh.faceStream.at(next++);
  for (Id f = 0; f < count; ++f)
  {
    const Id size = mesh.faceStream.at(next++);
    Face face;
    for (Id i = 0; i < size; ++i)
    {
      face.push_back(mesh.faceStream.at(next++));
    }
    faces.push_back(face);
  }
  return faces;
}

namespace
{

using Real = long double;
using Triple = std::array<Real, 3>;
using Edge = std::pair<Id, Id>;

// `volumeFraction` agrees with the volume to this part of the box.
constexpr Real RoundingOfFractions = 1e-11L;

// The mesh's volume and area agree with the surface's to this part.
constexpr double RoundingOfTotals = 1e-9;

Triple cross(const Triple& a, const Triple& b)
{
  return { a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0] };
}

Real dot(const Triple& a, const Triple& b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// The corners of a face relative to `origin`, and their mean.
class Star
{
public:
  Star(const MeshArrays& mesh, const Face& face, const double* origin)
  {
    for (const Id id : face)
    {
      const double* p = mesh.points.data() + 3 * static_cast<std::size_t>(id);
      corners_.push_back(
        { Real(p[0]) - origin[0], Real(p[1]) - origin[1], Real(p[2]) - origin[2] });
      for (int axis = 0; axis < 3; ++axis)
      {
        mean_[axis] += corners_.back()[axis] / static_cast<Real>(face.size());
      }
    }
  }

  Triple areaVector() const
  {
    Triple sum{};
    for (std::size_t i = 0; i < corners_.size(); ++i)
    {
      const Triple twice = cross(fromMean(i), fromMean((i + 1) % corners_.size()));
      for (int axis = 0; axis < 3; ++axis)
      {
        sum[axis] += twice[axis] / 2;
      }
    }
    return sum;
  }

  Real area() const
  {
    const Triple a = areaVector();
    return std::sqrt(dot(a, a));
  }

  // Of the cone to the origin.
  Real volume() const { return dot(areaVector(), mean_) / 3; }

private:
  Triple fromMean(std::size_t i) const
  {
    const Triple& p = corners_[i];
    return { p[0] - mean_[0], p[1] - mean_[1], p[2] - mean_[2] };
  }

  std::vector<Triple> corners_;
  Triple mean_{};
};

Face boundaryFace(const MeshArrays& mesh, std::size_t f)
{
  return { mesh.boundaryPoints.begin() + mesh.boundaryStart[f],
    mesh.boundaryPoints.begin() + mesh.boundaryStart[f + 1] };
}

// The same for all faces with the same points in the same order.
Face fromLeast(const Face& face)
{
  Face best = face;
  Face turned = face;
  for (std::size_t i = 1; i < face.size(); ++i)
  {
    std::rotate(turned.begin(), turned.begin() + 1, turned.end());
    best = std::min(best, turned);
  }
  return best;
}

Face reversed(const Face& face)
{
  return fromLeast({ face.rbegin(), face.rend() });
}

// Counts edges: up for one direction, down for the other.
class EdgeBalance
{
public:
  void add(const Face& face)
  {
    for (std::size_t i = 0; i < face.size(); ++i)
    {
      const Id from = face[i];
      const Id to = face[(i + 1) % face.size()];
      sums_[std::minmax(from, to)] += from < to ? 1 : -1;
    }
  }

  // An edge that is not used as often in one direction as in the other.
  const Edge* unbalanced() const
  {
    for (const auto& [edge, sum] : sums_)
    {
      if (sum != 0)
      {
        return &edge;
      }
    }
    return nullptr;
  }

private:
  std::map<Edge, int> sums_;
};

class Checker
{
public:
  Checker(const MeshArrays& mesh, bool merged)
    : mesh_(mesh)
    , merged_(merged)
  {
  }

  std::string complaints()
  {
    if (checkSizes())
    {
      for (std::size_t cell = 0; cell < mesh_.cells(); ++cell)
      {
        checkCell(cell, facesOf(mesh_, cell));
      }
      checkBoundary();
      checkShared();
      checkPoints();
    }
    return complaints_;
  }

private:
  void complain(const std::string& what)
  {
    constexpr int Most = 10;
    if (++count_ <= Most)
    {
      complaints_ += what + "\n";
    }
  }

  bool expect(bool good, const std::string& what)
  {
    if (!good)
    {
      complain(what);
    }
    return good;
  }

  bool checkSizes()
  {
    const std::size_t n = mesh_.cells();
    return expect(mesh_.offsets.size() == n + 1 && mesh_.faceStart.size() == n &&
               mesh_.globalBox.size() == 3 * n && mesh_.level.size() == 3 * n &&
               mesh_.region.size() == n &&
               (mesh_.volumeFraction.empty() || mesh_.volumeFraction.size() == n) &&
               mesh_.boundaryStart.size() == mesh_.boundaryCell.size() + 1 &&
               mesh_.boundaryIndex.size() == mesh_.boundaryCell.size() &&
               mesh_.offsets.back() == static_cast<Id>(mesh_.connectivity.size()),
             "arrays of wrong length") &&
      expect(std::is_sorted(mesh_.offsets.begin(), mesh_.offsets.end()), "offsets decrease") &&
      expect(inRange(mesh_.connectivity) && inRange(mesh_.boundaryPoints), "unknown points");
  }

  bool inRange(const std::vector<Id>& ids) const
  {
    return std::all_of(ids.begin(), ids.end(),
      [&](Id id) { return id >= 0 && id < static_cast<Id>(mesh_.points.size() / 3); });
  }

  void checkCell(std::size_t cell, const std::vector<Face>& faces)
  {
    const std::string name = "cell " + std::to_string(cell);
    const std::set<Id> points(mesh_.connectivity.begin() + mesh_.offsets[cell],
      mesh_.connectivity.begin() + mesh_.offsets[cell + 1]);
    expect(static_cast<Id>(points.size()) == mesh_.offsets[cell + 1] - mesh_.offsets[cell],
      name + " lists a point twice");
    EdgeBalance edges;
    std::set<Id> corners;
    for (const Face& face : faces)
    {
      if (!expect(face.size() >= 3 && inRange(face), name + " has a bad face"))
      {
        return;
      }
      edges.add(face);
      corners.insert(face.begin(), face.end());
      std::vector<Id>& owners = uses_[fromLeast(face)];
      expect(owners.empty() || owners.back() != static_cast<Id>(cell), name + " has a face twice");
      owners.push_back(static_cast<Id>(cell));
      const auto back = uses_.find(reversed(face));
      expect(back == uses_.end() || back->second.back() != static_cast<Id>(cell),
        name + " has a face from both sides");
    }
    expect(corners == points, name + " lists other points than its faces");
    expect(!edges.unbalanced(), name + " is not closed");
    expect(mesh_.region[cell] >= FirstRegion, name + " is in no region");
    used_.insert(points.begin(), points.end());
    checkVolume(cell, faces, name);
    checkPlace(cell, points, name);
  }

  void checkVolume(std::size_t cell, const std::vector<Face>& faces, const std::string& name)
  {
    const double* origin = mesh_.points.data() + 3 * static_cast<std::size_t>(faces[0][0]);
    Real volume = 0;
    for (const Face& face : faces)
    {
      volume += Star(mesh_, face, origin).volume();
    }
    Real whole = 1;
    Real slack = RoundingOfFractions;
    for (int axis = 0; axis < 3; ++axis)
    {
      const auto i = static_cast<std::size_t>(mesh_.globalBox[3 * cell + axis]);
      const Real global = Real(mesh_.meshlines[axis].at(i + 1)) - mesh_.meshlines[axis].at(i);
      const int level = mesh_.level[3 * cell + axis];
      whole *= std::ldexp(global, -level);
      slack +=
        level == 0 ? 0 : 2 * (planeRounding(axis) + Aside * global) / std::ldexp(global, -level);
    }
    expect(volume > 0, name + " has the volume " + std::to_string(volume / whole) + " of its box");
    expect(mesh_.volumeFraction.empty() ||
        std::abs(volume / whole - mesh_.volumeFraction[cell]) <
          slack * std::max<Real>(1, mesh_.volumeFraction[cell]),
      name + " has another volume fraction: " + std::to_string(volume / whole));
  }

  // Planes that divide boxes are levels, and step past walls in single precision, and past such as are tangent to them by a
  // part of a box (PlanePerturbation.h).
  static constexpr Real Aside = 4e-6; // of a box between meshlines

  Real planeRounding(int axis) const
  {
    const std::vector<double>& lines = mesh_.meshlines[axis];
    const double largest = std::max(std::abs(lines.front()), std::abs(lines.back()));
    return 3 * mesh_.step + largest * double(std::numeric_limits<float>::epsilon());
  }

  void checkPlace(std::size_t cell, const std::set<Id>& points, const std::string& name)
  {
    for (const Id id : points)
    {
      for (int axis = 0; axis < 3 && !merged_; ++axis)
      {
        const auto& lines = mesh_.meshlines[axis];
        const auto i = static_cast<std::size_t>(mesh_.globalBox[3 * cell + axis]);
        const double x = mesh_.points[3 * static_cast<std::size_t>(id) + axis];
        const double slack = mesh_.step; // nodes of cuts are off planes
        expect(lines[i] - slack <= x && x <= lines[i + 1] + slack, name + " leaves its box");
      }
    }
  }

  void checkBoundary()
  {
    EdgeBalance edges;
    for (std::size_t f = 0; f < mesh_.boundaryCell.size(); ++f)
    {
      const Face face = boundaryFace(mesh_, f);
      if (!expect(face.size() >= 3, "boundary face " + std::to_string(f) + " has no corners"))
      {
        continue;
      }
      edges.add(face);
      std::vector<Id>& owners = uses_[fromLeast(face)];
      const auto owner = std::find(owners.begin(), owners.end(), mesh_.boundaryCell[f]);
      if (expect(owner != owners.end(),
            "boundary face " + std::to_string(f) + " is no face of its cell, or listed twice"))
      {
        owners.erase(owner);
      }
    }
    expect(!edges.unbalanced(), "the boundary is open");
  }

  // Faces that are not boundary.
  void checkShared()
  {
    for (const auto& [face, owners] : uses_)
    {
      const auto other = uses_.find(reversed(face));
      const std::size_t others = other == uses_.end() ? 0 : other->second.size();
      if (!owners.empty())
      {
        expect(owners.size() == 1 && others == 1,
          "a face of cell " + std::to_string(owners[0]) + " is in " +
            std::to_string(owners.size()) + " cells this way round and in " +
            std::to_string(others) + " the other, and not listed as boundary");
      }
    }
  }

  void checkPoints()
  {
    std::set<std::array<double, 3>> places;
    for (std::size_t p = 0; p < mesh_.points.size() / 3; ++p)
    {
      const double* x = mesh_.points.data() + 3 * p;
      expect(std::isfinite(x[0]) && std::isfinite(x[1]) && std::isfinite(x[2]), "a point is NaN");
      expect(places.insert({ x[0], x[1], x[2] }).second,
        "point " + std::to_string(p) + " coincides with another");
      expect(used_.count(static_cast<Id>(p)) == 1, "point " + std::to_string(p) + " is unused");
    }
  }

  const MeshArrays& mesh_;
  bool merged_;
  std::map<Face, std::vector<Id>> uses_; // cells of each face that are not accounted for
  std::set<Id> used_;
  std::string complaints_;
  int count_ = 0;
};

void compare(const std::string& what, double is, double should, double slack, std::string& text)
{
  if (!(std::abs(is - should) <= slack))
  {
    text += what + " is " + ::testing::PrintToString(is) + " instead of " +
      ::testing::PrintToString(should) + ", off by " +
      ::testing::PrintToString(std::abs(is - should) / slack) + " of what is allowed\n";
  }
}

::testing::AssertionResult resultOf(const std::string& complaints)
{
  return complaints.empty() ? ::testing::AssertionSuccess()
                            : ::testing::AssertionFailure() << complaints;
}

Real volumeOfCell(const MeshArrays& mesh, std::size_t cell)
{
  const std::vector<Face> faces = facesOf(mesh, cell);
  Real volume = 0;
  for (const Face& face : faces)
  {
    volume +=
      Star(mesh, face, mesh.points.data() + 3 * static_cast<std::size_t>(faces[0][0])).volume();
  }
  return volume;
}

}

::testing::AssertionResult isValid(const MeshArrays& mesh, bool merged)
{
  return resultOf(Checker(mesh, merged).complaints());
}

double volumeOf(const MeshArrays& mesh)
{
  Real volume = 0;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    volume += volumeOfCell(mesh, cell);
  }
  return static_cast<double>(volume);
}

std::map<int, double> volumesByRegion(const MeshArrays& mesh)
{
  std::map<int, double> volumes;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    volumes[mesh.region[cell]] += static_cast<double>(volumeOfCell(mesh, cell));
  }
  return volumes;
}

std::map<std::pair<int, int>, double> areasBetweenRegions(const MeshArrays& mesh)
{
  std::map<Face, std::size_t> cellOf;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    for (const Face& face : facesOf(mesh, cell))
    {
      cellOf[fromLeast(face)] = cell;
    }
  }
  std::map<std::pair<int, int>, double> areas;
  for (const auto& [face, cell] : cellOf)
  {
    const auto beyond = cellOf.find(reversed(face));
    const int other = beyond == cellOf.end() ? OutsideRegion : mesh.region[beyond->second];
    if (mesh.region[cell] > other)
    {
      areas[{ other, mesh.region[cell] }] += static_cast<double>(
        Star(mesh, face, mesh.points.data() + 3 * static_cast<std::size_t>(face[0])).area());
    }
  }
  return areas;
}

std::map<std::array<int, 3>, std::vector<double>> volumesByBox(const MeshArrays& mesh)
{
  std::map<std::array<int, 3>, std::vector<double>> result;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    const int* box = mesh.globalBox.data() + 3 * cell;
    result[{ box[0], box[1], box[2] }].push_back(static_cast<double>(volumeOfCell(mesh, cell)));
  }
  for (auto& [box, volumes] : result)
  {
    std::sort(volumes.begin(), volumes.end());
  }
  return result;
}

double volumeSlack(const MeshArrays& mesh, const Soup& soup)
{
  return std::max(RoundingOfTotals * std::abs(soup.volume()), 2 * mesh.step * soup.area());
}

std::map<std::int32_t, double> areasByBoundary(const MeshArrays& mesh)
{
  std::map<std::int32_t, double> areas;
  for (std::size_t f = 0; f < mesh.boundaryCell.size(); ++f)
  {
    const Face face = boundaryFace(mesh, f);
    areas[mesh.boundaryIndex[f]] += static_cast<double>(
      Star(mesh, face, mesh.points.data() + 3 * static_cast<std::size_t>(face[0])).area());
  }
  return areas;
}

std::map<std::int32_t, double> areasByBoundary(const Soup& soup)
{
  std::map<std::int32_t, double> areas;
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    areas[soup.boundaryOf(t)] += soup.area(t);
  }
  return areas;
}

::testing::AssertionResult fills(const MeshArrays& mesh, const Soup& soup)
{
  std::map<std::int32_t, double> is = areasByBoundary(mesh);
  std::map<std::int32_t, double> should = areasByBoundary(soup);
  double total = 0;
  for (const auto& [index, area] : is)
  {
    total += area;
  }
  for (const auto& [index, area] : should)
  {
    is[index] += 0;
  }
  std::string text;
  compare("the volume", volumeOf(mesh), soup.volume(), volumeSlack(mesh, soup), text);
  const double slack = std::max(RoundingOfTotals * soup.area(), 2 * mesh.step * soup.edgeLength());
  compare("the boundary's area", total, soup.area(), slack, text);
  for (const auto& [index, area] : is)
  {
    compare("the area of boundary " + std::to_string(index), area, should[index], slack, text);
  }
  return resultOf(text);
}

Quality qualityOf(const MeshArrays& mesh, std::optional<int> region)
{
  CellFaces faces;
  for (std::size_t cell = 0; cell < mesh.cells(); ++cell)
  {
    if (region && mesh.region[cell] != *region)
    {
      continue;
    }
    faces.firstFace.push_back(faces.firstCorner.size());
    for (const Face& face : facesOf(mesh, cell))
    {
      faces.firstCorner.push_back(faces.corners.size());
      std::transform(face.begin(), face.end(), std::back_inserter(faces.corners),
        [](auto point) { return static_cast<std::uint32_t>(point); });
    }
  }
  faces.firstFace.push_back(faces.firstCorner.size());
  faces.firstCorner.push_back(faces.corners.size());
  Execution execution(1);
  const FaceList list = listFaces(faces, mesh.points.size() / 3, Clashes::AreBoundary, execution);
  return measureQuality(mesh.points.data(), faces, list, execution);
}

}
