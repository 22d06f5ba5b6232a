// What two boxes tie on the side between them is the same for both; loops of chords become triangles.
#include "Patches/ChordLoops.h"
#include "Patches/SideTying.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

using namespace cartesian;

namespace
{

using Ends = std::pair<Point, Point>;

// A surface in five boxes along its longest side, and what ties it.
struct Tied
{
  Tied(const Soup& soup, const PatchSpec& spec)
    : prepared(prepare(soup, cellsAlongLongest(soup, 5)))
    , boxed(boxSurface(prepared, {}, execution))
    , features(findFeatures(prepared.surface, spec.featureAngle, execution))
    , clearance(prepared.surface, boxed.boxes.planes)
    , reasons(boxed.boxes.packed.size(), PatchReason::MarchingCubes)
    , intersected(intersectedBoxes(boxed.boxes, execution))
  {
    const Patches patches =
      generatePatches(prepared.surface, boxed.boxes, boxed.shoeboxes, spec, execution);
    for (std::size_t n = 0; n < intersected.size(); ++n)
    {
      reasons[intersected[n]] = patches.reason[n];
    }
  }

  SideTying tying(const PatchSpec& spec) const
  {
    return { prepared.surface, features, boxed.boxes, clearance, reasons, spec };
  }

  // Calls visit(box, the surface in it).
  template <class Visitor>
  void forEachBox(Visitor&& visit)
  {
    SurfaceCutter cutter(prepared.surface, features, boxed.boxes, &clearance);
    for (const std::uint32_t b : intersected)
    {
      const Box box = boxed.boxes.box(b);
      const auto& global = boxed.boxes.globalOf(box).index;
      const auto [begin, end] =
        boxed.shoeboxes.triangles(boxed.boxes.row(global[1], global[2]), global[0]);
      BoxSurface piece;
      cutter.cut(box, begin, end, piece);
      visit(b, piece);
    }
  }

  Execution execution;
  PreparedSurface prepared;
  BoxedSurface boxed;
  Features features;
  PlaneClearance clearance;
  std::vector<PatchReason> reasons;
  std::vector<std::uint32_t> intersected;
};

// How often the chords of all boxes run from one place to another, less the other way.
std::map<Ends, int> netChords(const Soup& soup, const PatchSpec& spec)
{
  Tied tied(soup, spec);
  SideTying tying = tied.tying(spec);
  std::map<Ends, int> net;
  tied.forEachBox([&](std::uint32_t b, BoxSurface& piece) {
    tying.tie(b, piece);
    for (const Chord& chord : tying.chords())
    {
      const Point& p = piece.points[chord.from];
      const Point& q = piece.points[chord.to];
      net[{ std::min(p, q), std::max(p, q) }] += p < q ? 1 : -1;
    }
  });
  return net;
}

// The most by which a part of a polyline differs from its share of the whole (equation 5), in levels.
double offProportion(const std::vector<Point>& before, const std::vector<Point>& after)
{
  double whole = 0;
  double wholeAfter = 0;
  for (std::size_t i = 1; i < before.size(); ++i)
  {
    whole += norm(minus(before[i], before[i - 1]));
    wholeAfter += norm(minus(after[i], after[i - 1]));
  }
  double most = 0;
  for (std::size_t i = 1; i < before.size(); ++i)
  {
    const double part = norm(minus(before[i], before[i - 1])) / whole * wholeAfter;
    most = std::max(most, std::abs(norm(minus(after[i], after[i - 1])) - part));
  }
  return most;
}

// Each node at the nearest place on the straight line between the ends.
std::vector<Point> projected(const std::vector<Point>& polyline)
{
  const Vector chord = minus(polyline.back(), polyline.front());
  std::vector<Point> result = polyline;
  for (std::size_t i = 1; i + 1 < result.size(); ++i)
  {
    const double along = dot(minus(polyline[i], polyline.front()), chord) / dot(chord, chord);
    for (std::size_t a = 0; a < 3; ++a)
    {
      result[i][a] = static_cast<Level>(polyline.front()[a] + std::lround(along * chord[a]));
    }
  }
  return result;
}

// The polylines of a box with nodes that moved, before and after.
std::vector<std::array<std::vector<Point>, 2>> movedPolylines(
  const BoxSurface& before, const BoxSurface& after, const std::vector<Chord>& chords)
{
  std::map<std::uint32_t, std::uint32_t> next; // of nodes, where one end of the chord moved
  const auto moved = [&](std::uint32_t node) { return before.points[node] != after.points[node]; };
  std::vector<std::uint32_t> starts;
  for (const Chord& chord : chords)
  {
    if (moved(chord.from))
    {
      next[chord.from] = chord.to;
    }
    else if (moved(chord.to))
    {
      starts.push_back(chord.from);
      starts.push_back(chord.to);
    }
  }
  std::vector<std::array<std::vector<Point>, 2>> polylines;
  for (std::size_t s = 0; s < starts.size(); s += 2)
  {
    std::array<std::vector<Point>, 2>& polyline = polylines.emplace_back(); // was, is
    const auto add = [&](std::uint32_t node) {
      polyline[0].push_back(before.points[node]);
      polyline[1].push_back(after.points[node]);
    };
    add(starts[s]);
    add(starts[s + 1]);
    for (std::uint32_t node = starts[s + 1]; moved(node); add(node))
    {
      node = next.at(node);
    }
  }
  return polylines;
}

}

TEST(SideTying, BothBoxesOfASideAgree)
{
  for (const Soup& soup : { sphere(12, 1).turned(), blockWithTubes().turned() })
  {
    for (const Tying method : { Tying::KeepNodes, Tying::MoveNodes })
    {
      PatchSpec spec;
      spec.tying = method;
      const std::map<Ends, int> net = netChords(soup, spec);
      EXPECT_FALSE(net.empty());
      for (const auto& chord : net)
      {
        EXPECT_EQ(chord.second, 0);
      }
    }
  }
}

// Equation 5: between boxes of different methods, nodes move so that each part has the share of the straight
// line that it had of the polyline; where all methods are the same, none moves.
TEST(SideTying, NodesMoveInProportion)
{
  Soup soup = sphere(8, 1); // smooth, but for a border where it is cut exactly
  for (std::size_t t = 0; t < soup.triangles.size(); ++t)
  {
    soup.boundary.push_back(soup.points[soup.triangles[t][0]][0] > 0.2 ? 1 : 0);
  }
  PatchSpec keep;
  keep.tying = Tying::KeepNodes;
  keep.mergeAngle = 1;
  PatchSpec move = keep;
  move.tying = Tying::MoveNodes;
  std::size_t polylines = 0;
  double mostWithout = 0; // if only the line were straightened, each node at its nearest place
  for (const PatchMethod method : { move.method, PatchMethod::ExactFit })
  {
    keep.method = move.method = method;
    Tied tied(soup, move);
    SideTying keeping = tied.tying(keep);
    SideTying moving = tied.tying(move);
    polylines = method == PatchMethod::ExactFit ? 0 : polylines;
    tied.forEachBox([&](std::uint32_t b, BoxSurface& piece) {
      BoxSurface moved = piece;
      keeping.tie(b, piece);
      moving.tie(b, moved);
      for (const auto& [before, after] : movedPolylines(piece, moved, moving.chords()))
      {
        ++polylines;
        EXPECT_LT(offProportion(before, after), 4.0 * double(before.size())) << "levels";
        mostWithout = std::max(mostWithout, offProportion(before, projected(before)));
      }
    });
    EXPECT_EQ(polylines > 0, method != PatchMethod::ExactFit);
  }
  EXPECT_GT(mostWithout, 1e4) << "the polylines would have had these shares anyway";
}

// Two squares that share a corner.
TEST(ChordLoops, LoopsThatTouchStayApart)
{
  ChordLoops loops;
  const auto add = [&](double x, double y) {
    loops.nodes.push_back(
      { static_cast<std::uint32_t>(loops.nodes.size()), { x, y, 0 }, { 0, 0, 1 }, 0 });
  };
  add(0, 0);
  add(1, 0);
  add(1, 1);
  add(0, 1);
  add(-1, 0);
  add(-1, -1);
  add(0, -1);
  struct Arrow
  {
    std::uint32_t from;
    std::uint32_t to;
  };
  const std::vector<Arrow> chords{ { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 4 }, { 4, 5 },
    { 5, 6 }, { 6, 0 } };
  std::size_t triangles = 0;
  double twice = 0;
  loops.forEachTriangle(
    chords, [&](const std::array<std::uint32_t, 3>& corners, const Vector& normal) {
      ++triangles;
      EXPECT_EQ(normal, (Vector{ 0, 0, 1 }));
      const Vector& p = loops.nodes[corners[0]].at;
      twice += cross(minus(loops.nodes[corners[1]].at, p), minus(loops.nodes[corners[2]].at, p))[2];
    });
  EXPECT_EQ(triangles, 4u);
  EXPECT_EQ(twice, 4);
}
