// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/PatchBuilder.h"

namespace cartesian
{

PatchBuilder::PatchBuilder(const Surface& surface, const Features& features, const Boxes& boxes,
  const PlaneClearance& clearance, const std::vector<PatchReason>& reasons, const PatchSpec& spec,
  PatchChunk& chunk)
  : features_(features)
  , boxes_(boxes)
  , reasons_(reasons)
  , tying_(surface, features, boxes, clearance, reasons, spec)
  , simplification_(surface, boxes, clearance, spec)
  , chunk_(chunk)
{
}

void PatchBuilder::addBox(std::uint32_t b, BoxSurface& piece)
{
  const std::size_t before = chunk_.sizes.size();
  const std::size_t firstCorner = chunk_.corners.size();
  const bool isExact = reasons_[b] == PatchReason::ExactFitChosen;
  if (isExact)
  {
    copyPolygons(piece);
  }
  else
  {
    tying_.tie(b, piece);
    const Box box = boxes_.box(b);
    simplification_.begin(box, piece);
    if (reasons_[b] == PatchReason::MarchingCubes)
    {
      addTriangles(box, piece);
    }
    else
    {
      simplifyPolygons(piece);
    }
    simplification_.merge();
    simplification_.forEach([&](const std::uint32_t* begin, const std::uint32_t* end,
                              std::uint32_t triangle) { addPolygon(begin, end, triangle); });
  }
  chunk_.polygonsOfBox.push_back(static_cast<std::uint32_t>(chunk_.sizes.size() - before));
  giveSlots(
    boxes_.packed[b], piece.points, isExact ? piece.kinds : simplification_.kinds(), firstCorner);
}

void PatchBuilder::addPolygon(
  const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t triangle)
{
  chunk_.corners.insert(chunk_.corners.end(), begin, end);
  chunk_.sizes.push_back(static_cast<std::uint32_t>(end - begin));
  chunk_.triangles.push_back(triangle);
}

void PatchBuilder::copyPolygons(const BoxSurface& piece)
{
  chunk_.corners.insert(chunk_.corners.end(), piece.corners.begin(), piece.corners.end());
  chunk_.sizes.insert(chunk_.sizes.end(), piece.sizes.begin(), piece.sizes.end());
  chunk_.triangles.insert(chunk_.triangles.end(), piece.triangles.begin(), piece.triangles.end());
}

void PatchBuilder::simplifyPolygons(const BoxSurface& piece)
{
  const std::uint32_t* corner = piece.corners.data();
  for (std::size_t i = 0; i < piece.sizes.size(); ++i)
  {
    const std::uint32_t triangle = piece.triangles[i];
    simplification_.add(corner, corner + piece.sizes[i], triangle, features_.normal[triangle]);
    corner += piece.sizes[i];
  }
  simplification_.removeTied(tying_);
  simplification_.removeInner();
}

// Makes the ends of chords nodes of loops: their normals are the mean of the chords' triangles there.
void PatchBuilder::listLoopNodes(const Box& box, const BoxSurface& piece)
{
  const std::vector<Chord>& chords = tying_.chords();
  std::vector<LoopNode>& nodes = loops_.nodes;
  nodes.assign(piece.points.size(), LoopNode{ 0, { 0, 0, 0 }, { 0, 0, 0 }, 0 });
  triangleAt_.resize(piece.points.size());
  for (const Chord& chord : chords)
  {
    LoopNode& from = nodes[chord.from];
    from.normal = plus(from.normal, features_.normal[chord.firstTriangle]);
    LoopNode& to = nodes[chord.to];
    to.normal = plus(to.normal, features_.normal[chord.lastTriangle]);
    triangleAt_[chord.from] = chord.firstTriangle;
  }
  for (const Chord& chord : chords)
  {
    LoopNode& node = nodes[chord.from];
    node.id = chord.from;
    node.at = minus(piece.points[chord.from], box.low);
    node.normal = unit(node.normal);
    node.planes = planesOf(box, piece.points[chord.from]);
  }
}

// Marching Cubes: triangles between the loops of chords.
void PatchBuilder::addTriangles(const Box& box, const BoxSurface& piece)
{
  listLoopNodes(box, piece);
  loops_.forEachTriangle(
    tying_.chords(), [&](const std::array<std::uint32_t, 3>& points, const Vector& normal) {
      simplification_.add(points.data(), points.data() + 3, mostAlike(points, normal), normal);
    });
}

// The one whose normal is most alike, of the surface's triangles at the corners of a patch.
std::uint32_t PatchBuilder::mostAlike(
  const std::array<std::uint32_t, 3>& points, const Vector& normal) const
{
  std::uint32_t best = triangleAt_[points[0]];
  for (const std::uint32_t point : points)
  {
    const std::uint32_t triangle = triangleAt_[point];
    if (dot(features_.normal[triangle], normal) > dot(features_.normal[best], normal))
    {
      best = triangle;
    }
  }
  return best;
}

// Turns the indices of points in the box into slots; points that no polygon kept get none.
void PatchBuilder::giveSlots(const PackedBox& box, const std::vector<Point>& points,
  const std::vector<PointKind>& kinds, std::size_t firstCorner)
{
  slot_.assign(points.size(), None);
  for (std::size_t c = firstCorner; c < chunk_.corners.size(); ++c)
  {
    const std::uint32_t local = chunk_.corners[c];
    if (slot_[local] == None)
    {
      const Point& p = points[local];
      slot_[local] = static_cast<std::uint32_t>(chunk_.uses.size());
      const auto& global = boxes_.globalOf(box).index;
      chunk_.uses.push_back(
        { p, rowOfPoint(p, boxes_.planes, global[1], global[2]), slot_[local] });
      if (!kinds.empty() && kinds[local] != PointKind::OnSurface)
      {
        chunk_.features.push_back({ slot_[local], kinds[local] });
      }
    }
    chunk_.corners[c] = slot_[local];
  }
}

}
