// What two boxes tie on the side between them is the same for both; loops of chords become triangles.
#include "Patches/ChordLoops.h"
#include "Patches/SideTying.h"
#include "Support/Pipeline.h"

#include <gtest/gtest.h>

using namespace cartesian;

namespace
{

using Ends = std::pair<Point, Point>;

// How often the chords of all boxes run from one place to another, less the other way.
std::map<Ends, int> netChords(const Soup& soup, const PatchSpec& spec)
{
  Execution execution;
  const PreparedSurface prepared = prepare(soup, cellsAlongLongest(soup, 5));
  const Surface& surface = prepared.surface;
  const BoxedSurface boxed = boxSurface(prepared, {}, execution);
  const Boxes& boxes = boxed.boxes;
  const Features features = findFeatures(surface, spec.featureAngle, execution);
  const PlaneClearance clearance(surface, boxes);
  const std::vector<PatchReason> reasons = [&] {
    const Patches patches = generatePatches(surface, boxes, boxed.shoeboxes, spec, execution);
    std::vector<PatchReason> all(boxes.packed.size(), PatchReason::MarchingCubes);
    const std::vector<std::uint32_t> intersected = intersectedBoxes(boxes, execution);
    for (std::size_t n = 0; n < intersected.size(); ++n)
    {
      all[intersected[n]] = patches.reason[n];
    }
    return all;
  }();
  SurfaceCutter cutter(surface, features, boxes, &clearance);
  SideTying tying(surface, features, boxes, clearance, reasons, spec);
  std::map<Ends, int> net;
  for (const std::uint32_t b : intersectedBoxes(boxes, execution))
  {
    const Box box = boxes.box(b);
    const auto& global = boxes.globalOf(box).index;
    const auto [begin, end] = boxed.shoeboxes.triangles(boxes.row(global[1], global[2]), global[0]);
    BoxSurface piece;
    cutter.cut(box, begin, end, piece);
    tying.tie(b, piece);
    for (const Chord& chord : tying.chords())
    {
      const Point& p = piece.points[chord.from];
      const Point& q = piece.points[chord.to];
      net[{ std::min(p, q), std::max(p, q) }] += p < q ? 1 : -1;
    }
  }
  return net;
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
