// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Cells.h"

#include "Base/DisjointSets.h"
#include "Base/EdgeTable.h"
#include "Base/Error.h"
#include "Base/ObjectPool.h"
#include "Lattice/Vector.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 512;

// A cell less thick than this part of a lattice step, on average, is rounding and not a volume.
constexpr double ThinnestCell = 0.01;

// Triangles between lattice points have at least half a square step, or none.
constexpr double LeastArea = 0.5;

// Area vector and volume of the cone to the origin, by star triangulation (equation 1).
struct FaceMeasure
{
  double area = 0;
  double volume = 0;
};

// One use of an edge by a face of the box.
struct FaceEdge
{
  std::uint32_t lower;
  std::uint32_t upper;
  std::uint32_t face;
  int direction;

  bool operator<(const FaceEdge& other) const
  {
    return lower != other.lower ? lower < other.lower
                                : (upper != other.upper ? upper < other.upper : face < other.face);
  }
  bool sameEdge(const FaceEdge& other) const
  {
    return lower == other.lower && upper == other.upper;
  }
};

struct Part
{
  std::vector<Cell> cells;
  std::vector<FaceRef> faces;
  std::vector<std::uint32_t> cellsOfBox;
  std::vector<std::uint8_t> flawed;
  std::size_t voids = 0;
  std::size_t folds = 0;
};

// Separates the volumes of one box. Keeps its storage from box to box.
class BoxAssembler
{
public:
  BoxAssembler(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const InnerFaces& inner)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , nodes_(nodes)
    , inner_(inner)
  {
  }

  // Whether the faces of a box close.
  bool closes(std::size_t n)
  {
    if (!gatherFaces(n) || !joinFaces() || anyPatchTwice())
    {
      return false;
    }
    if (shared_.empty())
    {
      return true;
    }
    separate(n);
    return !anyFaceTwice();
  }

  void addBox(std::size_t n, const SmallCellSpec& spec, Part& part)
  {
    const std::size_t before = part.cells.size();
    const bool closed = closes(n);
    part.flawed.push_back(closed ? 0 : 1);
    if (closed)
    {
      if (shared_.empty())
      {
        separate(n);
      }
      const bool counts = boxes_.isCore(boxes_.packed[sides_.polyhedral[n]]);
      part.voids += counts ? voids_ : 0;
      part.folds += counts ? folds_ : 0;
      emit(sides_.polyhedral[n], spec, part);
    }
    part.cellsOfBox.push_back(static_cast<std::uint32_t>(part.cells.size() - before));
  }

private:
  // A connected set of faces: closed, hence the boundary of a volume or of a hole in one.
  struct Shell
  {
    std::vector<std::uint32_t> faces;
    double volume = 0;
    double area = 0; // of all its faces
    bool hasInnerFace = false;

    void clear()
    {
      faces.clear();
      volume = 0;
      area = 0;
      hasInnerFace = false;
    }
  };

  // Of a face of the box, as its array has them.
  struct Corners
  {
    const std::uint32_t* first;
    const std::uint32_t* last;
    bool turned;

    std::size_t size() const { return static_cast<std::size_t>(last - first); }
  };

  // Counter-clockwise from outside.
  template <class Visitor>
  void forEachCorner(std::size_t face, Visitor&& visit) const
  {
    const Corners& corners = corners_[face];
    if (corners.turned)
    {
      for (const std::uint32_t* corner = corners.last; corner != corners.first; --corner)
      {
        visit(corner[-1]);
      }
    }
    else
    {
      std::for_each(corners.first, corners.last, visit);
    }
  }

  // Calls visit(lower node, upper node, whether it runs up, seen from outside).
  template <class Visitor>
  void forEachEdge(std::size_t face, Visitor&& visit) const
  {
    const Corners& corners = corners_[face];
    std::uint32_t from = corners.last[-1];
    for (const std::uint32_t* to = corners.first; to != corners.last; ++to)
    {
      visit(std::min(from, *to), std::max(from, *to), (from < *to) != corners.turned);
      from = *to;
    }
  }

  std::uint32_t firstCorner(std::size_t face) const
  {
    return corners_[face].turned ? corners_[face].last[-1] : *corners_[face].first;
  }

  // All faces of the box; false where one of its sides is flawed.
  bool gatherFaces(std::size_t n)
  {
    faces_.clear();
    corners_.clear();
    if (const std::uint32_t box = sides_.patchBox[n]; box != None)
    {
      for (std::size_t p = patches_.boxStart[box]; p < patches_.boxStart[box + 1]; ++p)
      {
        addFace(FaceRef(p, FaceRef::Kind::Patch));
      }
    }
    bool whole = true;
    for (std::size_t i = sides_.boxStart[n]; i < sides_.boxStart[n + 1]; ++i)
    {
      const auto [side, upper] = sides_.ofBox[i];
      whole = whole && !inner_.flawed[side];
      for (std::size_t f = inner_.sideStart[side]; f < inner_.sideStart[side + 1]; ++f)
      {
        addFace(FaceRef(f, upper ? FaceRef::Kind::Inner : FaceRef::Kind::TurnedInner));
      }
    }
    return whole;
  }

  void addFace(const FaceRef& face)
  {
    const bool patch = face.kind() == FaceRef::Kind::Patch;
    const std::size_t* const at = (patch ? patches_.start : inner_.start).data() + face.index;
    const std::uint32_t* const nodes = (patch ? patches_.corners : inner_.nodes).data();
    corners_.push_back({ nodes + at[0], nodes + at[1], face.turned() });
    faces_.push_back(face);
  }

  // Finds the volumes once faces are joined.
  void separate(std::size_t n)
  {
    measureFaces(boxes_.lowOf(sides_.polyhedral[n]));
    findShells();
    voids_ = fillVoids();
    folds_ = dropFolds();
  }

  // Joins faces that share an edge; false where an edge is not run through as often one way as
  // the other. Volumes that only touch in an edge stay apart where each closes by itself.
  bool joinFaces()
  {
    shared_.clear();
    if (joinInPairs())
    {
      return true;
    }
    listEdges();
    sets_.reset(faces_.size());
    for (std::size_t i = 0; i < edges_.size();)
    {
      std::size_t end = i;
      int sum = 0;
      for (; end < edges_.size() && edges_[end].sameEdge(edges_[i]); ++end)
      {
        sum += edges_[end].direction;
      }
      if (sum != 0)
      {
        return false;
      }
      if (end - i == 2)
      {
        sets_.unite(edges_[i].face, edges_[i + 1].face);
      }
      else
      {
        shared_.emplace_back(i, end);
      }
      i = end;
    }
    joinFlatCells();
    joinAtSharedEdges();
    return true;
  }

  // Where each edge has two faces, one each way, as nearly everywhere: false elsewhere.
  bool joinInPairs()
  {
    sets_.reset(faces_.size());
    firstAtEdge_.reset(std::accumulate(corners_.begin(), corners_.end(), std::size_t(0),
      [](std::size_t sum, const Corners& corners) { return sum + corners.size(); }));
    std::size_t single = 0;
    bool paired = true;
    for (std::uint32_t f = 0; f < faces_.size() && paired; ++f)
    {
      forEachEdge(f, [&](std::uint32_t lower, std::uint32_t upper, bool up) {
        std::uint32_t& first = firstAtEdge_.at(lower, upper);
        if (first == EdgeTable::Fresh)
        {
          first = 2 * f + (up ? 1 : 0);
          ++single;
        }
        else if (first == Paired || (first % 2 == 1) == up)
        {
          paired = false;
        }
        else
        {
          sets_.unite(f, first / 2);
          first = Paired;
          --single;
        }
      });
    }
    return paired && single == 0;
  }

  // A patch that lies on an inner face (ShortEdges.h) is a cell without volume with it, whatever else
  // has its edges.
  void joinFlatCells()
  {
    if (shared_.empty())
    {
      return;
    }
    cycles_.clear();
    for (std::uint32_t face = 0; face < faces_.size(); ++face)
    {
      const bool patch = faces_[face].kind() == FaceRef::Kind::Patch;
      cycles_.emplace_back(cycleOf(face, patch), face);
    }
    std::sort(cycles_.begin(), cycles_.end());
    for (std::size_t i = 0; i + 1 < cycles_.size(); ++i)
    {
      const std::uint32_t f = cycles_[i].second;
      const std::uint32_t g = cycles_[i + 1].second;
      const bool patch = faces_[f].kind() == FaceRef::Kind::Patch;
      const bool other = faces_[g].kind() == FaceRef::Kind::Patch;
      if (cycles_[i].first == cycles_[i + 1].first && patch != other)
      {
        sets_.unite(f, g);
      }
    }
  }

  void listEdges()
  {
    edges_.clear();
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
    {
      forEachEdge(f, [&](std::uint32_t lower, std::uint32_t upper, bool up) {
        edges_.push_back({ lower, upper, f, up ? 1 : -1 });
      });
    }
    std::sort(edges_.begin(), edges_.end());
  }

  // Edges of more than two faces: those of a volume that is not closed without the others' faces
  // belong together. Repeats, as joining at one edge may close another.
  void joinAtSharedEdges()
  {
    for (bool changed = true; changed;)
    {
      changed = false;
      for (const auto& [begin, end] : shared_)
      {
        for (std::size_t i = begin; i < end; ++i)
        {
          int sum = 0;
          for (std::size_t j = begin; j < end; ++j)
          {
            sum +=
              sets_.find(edges_[j].face) == sets_.find(edges_[i].face) ? edges_[j].direction : 0;
          }
          if (sum != 0)
          {
            for (std::size_t j = begin; j < end; ++j)
            {
              sets_.unite(edges_[i].face, edges_[j].face);
            }
            changed = true;
            break;
          }
        }
      }
    }
  }

  void measureFaces(const Point& origin)
  {
    measures_.clear();
    for (std::size_t f = 0; f < faces_.size(); ++f)
    {
      ring_.clear();
      Vector mean{ 0, 0, 0 };
      forEachCorner(f, [&](std::uint32_t node) {
        ring_.push_back(minus(nodes_.at[node], origin));
        mean = plus(mean, ring_.back());
      });
      for (double& x : mean)
      {
        x /= static_cast<double>(ring_.size());
      }
      measures_.push_back(measure(mean));
    }
  }

  FaceMeasure measure(const Vector& mean) const
  {
    Vector area{ 0, 0, 0 };
    FaceMeasure m;
    for (std::size_t i = 0; i < ring_.size(); ++i)
    {
      const Vector& p = ring_[i];
      const Vector& q = ring_[i + 1 < ring_.size() ? i + 1 : 0];
      const Vector twice = cross({ p[0] - mean[0], p[1] - mean[1], p[2] - mean[2] },
        { q[0] - mean[0], q[1] - mean[1], q[2] - mean[2] });
      for (int axis = 0; axis < 3; ++axis)
      {
        area[axis] += twice[axis] / 2;
      }
      m.volume += dot(twice, mean) / 6;
    }
    m.area = std::sqrt(dot(area, area));
    return m;
  }

  void findShells()
  {
    pool_.release(shells_);
    shellOf_.assign(faces_.size(), None);
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
    {
      const std::uint32_t r = sets_.find(f);
      if (shellOf_[r] == None)
      {
        shellOf_[r] = static_cast<std::uint32_t>(shells_.size());
        shells_.push_back(pool_.acquire());
        shells_.back().clear();
      }
      Shell& shell = shells_[shellOf_[r]];
      shell.faces.push_back(f);
      shell.volume += measures_[f].volume;
      shell.area += measures_[f].area;
      shell.hasInnerFace = shell.hasInnerFace || faces_[f].kind() != FaceRef::Kind::Patch;
    }
  }

  // Of no volume, either way round, but that of rounding.
  static bool isSliver(const Shell& shell)
  {
    return !(std::abs(shell.volume) > ThinnestCell * std::max(shell.area / 2, LeastArea));
  }

  // A closed piece of surface in this box that encloses no part of the domain is a hole of the
  // cell around it.
  std::size_t fillVoids()
  {
    std::size_t voids = 0;
    for (Shell& shell : shells_)
    {
      if (shell.volume >= 0 || shell.hasInnerFace || isSliver(shell))
      {
        continue;
      }
      if (Shell* around = shellAround(shell))
      {
        around->faces.insert(around->faces.end(), shell.faces.begin(), shell.faces.end());
        around->volume += shell.volume;
        shell.faces.clear();
        ++voids;
      }
    }
    return voids;
  }

  // Two patches of one volume with the same corners that run the opposite way are a wall without
  // thickness inside it: they bound nothing, and both go. All their edges have other faces too.
  std::size_t dropFolds()
  {
    if (shared_.empty())
    {
      return 0;
    }
    std::size_t folds = 0;
    for (Shell& shell : shells_)
    {
      listCycles(shell.faces);
      dropped_.clear();
      std::ptrdiff_t twin = 0; // patches with the same corners before this one
      for (std::size_t i = 0; i < cycles_.size(); ++i)
      {
        // A patch may be there several times, where parts overlap: each takes one opposite with it.
        const bool again = i > 0 && cycles_[i].first == cycles_[i - 1].first;
        twin = again ? twin + 1 : 0;
        const std::vector<std::uint32_t> opposite = cycleOf(cycles_[i].second, true);
        const auto found = std::lower_bound(
          cycles_.begin(), cycles_.end(), std::make_pair(opposite, std::uint32_t(0)));
        if (cycles_.end() - found > twin && (found + twin)->first == opposite)
        {
          dropped_.push_back(cycles_[i].second);
        }
      }
      const auto gone = [&](std::uint32_t face) {
        return std::find(dropped_.begin(), dropped_.end(), face) != dropped_.end();
      };
      shell.faces.erase(
        std::remove_if(shell.faces.begin(), shell.faces.end(), gone), shell.faces.end());
      folds += dropped_.size() / 2;
    }
    return folds;
  }

  // The patches among these faces, sorted by their corners.
  void listCycles(const std::vector<std::uint32_t>& faces)
  {
    cycles_.clear();
    for (const std::uint32_t face : faces)
    {
      if (faces_[face].kind() == FaceRef::Kind::Patch)
      {
        cycles_.emplace_back(cycleOf(face, false), face);
      }
    }
    std::sort(cycles_.begin(), cycles_.end());
  }

  // Parts that overlap share walls that face the same way: there are several volumes in one place.
  // Where as many face the other way, walls only touch.
  bool anyPatchTwice()
  {
    if (shared_.empty())
    {
      return false;
    }
    std::vector<std::uint32_t> all(faces_.size());
    std::iota(all.begin(), all.end(), 0);
    listCycles(all);
    const auto count = [&](const std::vector<std::uint32_t>& cycle) {
      const auto begin =
        std::lower_bound(cycles_.begin(), cycles_.end(), std::make_pair(cycle, std::uint32_t(0)));
      const auto end = std::upper_bound(begin, cycles_.end(), std::make_pair(cycle, None));
      return end - begin;
    };
    return std::any_of(cycles_.begin(), cycles_.end(), [&](const auto& patch) {
      return count(patch.first) > count(cycleOf(patch.second, true)) + 1;
    });
  }

  // Where parts overlap, a volume may be left with a face on both sides of it.
  bool anyFaceTwice()
  {
    for (const Shell& shell : shells_)
    {
      if (shell.faces.size() == 2) // of no volume
      {
        continue;
      }
      cycles_.clear();
      for (const std::uint32_t face : shell.faces)
      {
        cycles_.emplace_back(std::min(cycleOf(face, false), cycleOf(face, true)), face);
      }
      std::sort(cycles_.begin(), cycles_.end());
      const auto twice = std::adjacent_find(cycles_.begin(), cycles_.end(),
        [](const auto& a, const auto& b) { return a.first == b.first; });
      if (twice != cycles_.end())
      {
        return true;
      }
    }
    return false;
  }

  // The corners of a face from the lowest on, as it runs or the other way.
  std::vector<std::uint32_t> cycleOf(std::uint32_t face, bool opposite) const
  {
    std::vector<std::uint32_t> cycle(corners_[face].first, corners_[face].last);
    if (opposite != corners_[face].turned)
    {
      std::reverse(cycle.begin(), cycle.end());
    }
    std::rotate(cycle.begin(), std::min_element(cycle.begin(), cycle.end()), cycle.end());
    return cycle;
  }

  // The smallest volume that a void lies in.
  Shell* shellAround(const Shell& inner)
  {
    Shell* best = nullptr;
    const Point& from = nodes_.at[firstCorner(inner.faces.front())];
    for (Shell& shell : shells_)
    {
      if (shell.volume > 0 && (!best || shell.volume < best->volume) &&
        std::abs(solidAngle(shell, from)) > HalfAround)
      {
        best = &shell;
      }
    }
    return best;
  }

  // Of a shell seen from a point: 4 pi from inside, 0 from outside.
  double solidAngle(const Shell& shell, const Point& from)
  {
    double sum = 0;
    for (const std::uint32_t f : shell.faces)
    {
      ring_.clear();
      forEachCorner(f, [&](std::uint32_t node) { ring_.push_back(minus(nodes_.at[node], from)); });
      for (std::size_t i = 1; i + 1 < ring_.size(); ++i)
      {
        const Vector& a = ring_[0];
        const Vector& b = ring_[i];
        const Vector& c = ring_[i + 1];
        const double la = std::sqrt(dot(a, a));
        const double lb = std::sqrt(dot(b, b));
        const double lc = std::sqrt(dot(c, c));
        sum += 2 *
          std::atan2(
            dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
      }
    }
    return sum;
  }

  void emit(std::uint32_t boxIndex, const SmallCellSpec& spec, Part& part)
  {
    const Box box = boxes_.box(boxIndex);
    const Vector size = minus(box.high, box.low);
    for (const Shell& shell : shells_)
    {
      if (shell.faces.empty())
      {
        continue;
      }
      Cell cell;
      cell.box = boxIndex;
      cell.boundary = mainBoundary(shell);
      cell.volumeFraction = shell.volume / (size[0] * size[1] * size[2]);
      cell.firstFace = part.faces.size();
      cell.sliver = shell.volume < 0 || isSliver(shell);
      cell.removed = cell.sliver ||
        (spec.handling == SmallCells::Remove &&
          cell.volumeFraction < ratioOf(spec, cell.boundary, spec.ratio));
      part.cells.push_back(cell);
      for (const std::uint32_t f : shell.faces)
      {
        part.faces.push_back(faces_[f]);
      }
    }
  }

  // The boundary index that has the largest area of patches in the shell.
  std::int32_t mainBoundary(const Shell& shell)
  {
    areas_.clear();
    for (const std::uint32_t f : shell.faces)
    {
      if (faces_[f].kind() == FaceRef::Kind::Patch)
      {
        areas_.emplace_back(patches_.boundary[faces_[f].index], measures_[f].area);
      }
    }
    if (areas_.size() > 1)
    {
      std::sort(areas_.begin(), areas_.end());
    }
    std::int32_t best = NoBoundary;
    double most = -1;
    for (std::size_t i = 0; i < areas_.size();)
    {
      const std::int32_t boundary = areas_[i].first;
      double sum = 0;
      for (; i < areas_.size() && areas_[i].first == boundary; ++i)
      {
        sum += areas_[i].second;
      }
      if (sum > most)
      {
        most = sum;
        best = boundary;
      }
    }
    return best;
  }

  // Instead of twice a face and a direction.
  static constexpr std::uint32_t Paired = EdgeTable::Fresh - 1;

  // A solid angle beyond this is that of a point inside.
  static constexpr double HalfAround = 2 * Pi;

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
  const InnerFaces& inner_;
  std::vector<FaceRef> faces_;
  std::vector<Corners> corners_; // of each face
  std::vector<FaceEdge> edges_;
  EdgeTable firstAtEdge_; // the first face at each edge and how it runs, then Paired
  DisjointSets sets_;     // of the box's faces
  std::vector<std::pair<std::size_t, std::size_t>> shared_;
  std::vector<FaceMeasure> measures_;
  std::vector<Vector> ring_;
  std::vector<Shell> shells_;
  ObjectPool<Shell> pool_;
  std::size_t voids_ = 0; // of the volumes that separate has found
  std::size_t folds_ = 0;
  std::vector<std::uint32_t> shellOf_;
  std::vector<std::pair<std::int32_t, double>> areas_;
  std::vector<std::pair<std::vector<std::uint32_t>, std::uint32_t>> cycles_;
  std::vector<std::uint32_t> dropped_;
};

Cells join(const std::vector<Part>& parts, std::size_t boxes, Execution& execution)
{
  std::vector<std::size_t> cell;
  std::vector<std::size_t> face;
  Cells result;
  for (const Part& part : parts)
  {
    cell.push_back(part.cells.size());
    face.push_back(part.faces.size());
    result.voids += part.voids;
    result.folds += part.folds;
  }
  const std::size_t cells = scan(cell);
  const std::size_t faces = scan(face);
  result.cells.resize(cells + 1);
  result.cells.back().firstFace = faces;
  result.faces.resize(faces, FaceRef(0, FaceRef::Kind::Patch));
  result.boxStart.resize(boxes + 1);
  result.boxStart.back() = cells;
  result.flawed.resize(boxes);
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) {
    const Part& part = parts[i];
    std::copy(part.faces.begin(), part.faces.end(), result.faces.begin() + std::ptrdiff_t(face[i]));
    std::copy(part.flawed.begin(), part.flawed.end(),
      result.flawed.begin() + std::ptrdiff_t(i * BoxesAChunk));
    for (std::size_t c = 0; c < part.cells.size(); ++c)
    {
      result.cells[cell[i] + c] = part.cells[c];
      result.cells[cell[i] + c].firstFace += face[i];
    }
    std::size_t next = cell[i];
    for (std::size_t n = 0; n < part.cellsOfBox.size(); ++n)
    {
      result.boxStart[i * BoxesAChunk + n] = next;
      next += part.cellsOfBox[n];
    }
  });
  return result;
}

}

double ratioOf(const SmallCellSpec& spec, std::int32_t boundary, double otherwise)
{
  for (const BoundaryRatio& own : spec.boundaryRatios)
  {
    if (own.boundary == boundary)
    {
      return own.ratio;
    }
  }
  return otherwise;
}

void findCellsOfInnerFaces(const InnerFaces& inner, Cells& cells, Execution& execution)
{
  cells.ofInnerFace.assign(inner.size(), { None, None });
  execution.forEach(cells.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      for (std::size_t f = cells.cells[c].firstFace; f < cells.cells[c + 1].firstFace; ++f)
      {
        const FaceRef& face = cells.faces[f];
        if (face.kind() == FaceRef::Kind::Inner || face.kind() == FaceRef::Kind::TurnedInner)
        {
          cells.ofInnerFace[face.index][face.turned() ? 1 : 0] = static_cast<std::uint32_t>(c);
        }
      }
    }
  });
}

std::vector<std::uint8_t> findFlawed(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, Execution& execution)
{
  std::vector<std::uint8_t> flawed(sides.polyhedral.size());
  execution.nextLoop(0.95);
  execution.forEach(flawed.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    BoxAssembler assembler(boxes, patches, sides, nodes, inner);
    for (std::size_t n = begin; n < end; ++n)
    {
      flawed[n] = assembler.closes(n) ? 0 : 1;
    }
  });
  return flawed;
}

Cells assembleCells(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const SmallCellSpec& spec, Execution& execution)
{
  if (std::max(patches.size(), inner.size()) > FaceRef::MostFaces)
  {
    throw Error(Fault::TooManyBoxes,
      "The boundary has more than " + std::to_string(FaceRef::MostFaces) +
        " faces: choose larger cells.");
  }
  const std::size_t count = sides.polyhedral.size();
  std::vector<Part> parts(chunks(count, BoxesAChunk));
  execution.nextLoop(0.95);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    BoxAssembler assembler(boxes, patches, sides, nodes, inner);
    for (std::size_t n = begin; n < end; ++n)
    {
      assembler.addBox(n, spec, parts[begin / BoxesAChunk]);
    }
  });
  Cells cells = join(parts, count, execution);
  findCellsOfInnerFaces(inner, cells, execution);
  return cells;
}

}
