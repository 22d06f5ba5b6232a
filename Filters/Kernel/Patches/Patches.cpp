// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/Patches.h"

#include "Base/Error.h"
#include "Base/Loops.h"
#include "Patches/Simplification.h"
#include "Patches/Tying.h"

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 512;

// The surface in the boxes of a chunk, one box after the other.
class Pieces
{
public:
  // Without polygons, where Marching Cubes will make others.
  void append(const BoxSurface& piece, bool withPolygons)
  {
    const std::size_t polygons = withPolygons ? piece.sizes.size() : 0;
    const std::size_t corners = withPolygons ? piece.corners.size() : 0;
    counts_.push_back({ piece.points.size(), polygons, corners, piece.segments.size() });
    insert(all_.points, piece.points, piece.points.size());
    insert(all_.sizes, piece.sizes, polygons);
    insert(all_.triangles, piece.triangles, polygons);
    insert(all_.corners, piece.corners, corners);
    insert(all_.segments, piece.segments, piece.segments.size());
  }

  // The boxes in the order in which they were appended.
  void readNext(BoxSurface& piece)
  {
    const Counts& n = counts_[next_++];
    const auto copy = [](const auto& from, std::size_t begin, std::size_t count, auto& to) {
      to.assign(from.begin() + std::ptrdiff_t(begin), from.begin() + std::ptrdiff_t(begin + count));
    };
    copy(all_.points, at_.points, n.points, piece.points);
    copy(all_.sizes, at_.polygons, n.polygons, piece.sizes);
    copy(all_.triangles, at_.polygons, n.polygons, piece.triangles);
    copy(all_.corners, at_.corners, n.corners, piece.corners);
    copy(all_.segments, at_.segments, n.segments, piece.segments);
    at_ = { at_.points + n.points, at_.polygons + n.polygons, at_.corners + n.corners,
      at_.segments + n.segments };
  }

private:
  struct Counts
  {
    std::size_t points;
    std::size_t polygons;
    std::size_t corners;
    std::size_t segments;
  };

  template <class Item>
  static void insert(std::vector<Item>& to, const std::vector<Item>& from, std::size_t count)
  {
    to.insert(to.end(), from.begin(), from.begin() + std::ptrdiff_t(count));
  }

  BoxSurface all_;
  std::vector<Counts> counts_;
  std::size_t next_ = 0;
  Counts at_{};
};

// The polygons of a chunk of boxes. Corners are slots: points of this chunk, one a box and place.
struct Part
{
  std::vector<PointUse> uses;
  std::vector<std::uint32_t> sizes;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> polygonsOfBox;
};

// Makes the patches of one box after the other.
class PartBuilder
{
public:
  PartBuilder(const Surface& surface, const Features& features, const Boxes& boxes,
    const Clearance& clearance, const std::vector<PatchReason>& reasons, const PatchSpec& spec,
    Part& part)
    : features_(features)
    , boxes_(boxes)
    , reasons_(reasons)
    , tying_(surface, features, boxes, clearance, reasons, spec)
    , simplification_(surface, boxes, clearance, spec)
    , part_(part)
  {
  }

  void addBox(std::uint32_t b, BoxSurface& piece)
  {
    const std::size_t before = part_.sizes.size();
    const std::size_t firstCorner = part_.corners.size();
    if (reasons_[b] == PatchReason::ExactFitChosen)
    {
      copyPolygons(piece);
    }
    else
    {
      tying_.tie(b, piece);
      const Box box = boxes_.box(b);
      simplification_.begin(box, piece.points);
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
    part_.polygonsOfBox.push_back(static_cast<std::uint32_t>(part_.sizes.size() - before));
    giveSlots(boxes_.packed[b], piece.points, firstCorner);
  }

private:
  void addPolygon(const std::uint32_t* begin, const std::uint32_t* end, std::uint32_t triangle)
  {
    part_.corners.insert(part_.corners.end(), begin, end);
    part_.sizes.push_back(static_cast<std::uint32_t>(end - begin));
    part_.triangles.push_back(triangle);
  }

  void copyPolygons(const BoxSurface& piece)
  {
    part_.corners.insert(part_.corners.end(), piece.corners.begin(), piece.corners.end());
    part_.sizes.insert(part_.sizes.end(), piece.sizes.begin(), piece.sizes.end());
    part_.triangles.insert(part_.triangles.end(), piece.triangles.begin(), piece.triangles.end());
  }

  void simplifyPolygons(const BoxSurface& piece)
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

  // Marching Cubes: the chords form loops, and these fall into triangles.
  void addTriangles(const Box& box, const BoxSurface& piece)
  {
    const std::vector<Chord>& chords = tying_.chords();
    nodes_.assign(piece.points.size(), LoopNode{ 0, { 0, 0, 0 }, { 0, 0, 0 }, 0 });
    triangleAt_.resize(piece.points.size());
    leaving_.assign(piece.points.size(), None);
    sameFrom_.resize(chords.size());
    for (std::uint32_t c = 0; c < chords.size(); ++c)
    {
      const Chord& chord = chords[c];
      LoopNode& from = nodes_[chord.from];
      from.normal = plus(from.normal, features_.normal[chord.firstTriangle]);
      LoopNode& to = nodes_[chord.to];
      to.normal = plus(to.normal, features_.normal[chord.lastTriangle]);
      triangleAt_[chord.from] = chord.firstTriangle;
      sameFrom_[c] = leaving_[chord.from];
      leaving_[chord.from] = c;
    }
    for (const Chord& chord : chords)
    {
      LoopNode& node = nodes_[chord.from];
      node.id = chord.from;
      node.at = minus(piece.points[chord.from], box.low);
      node.normal = unit(node.normal);
      node.planes = planesOf(box, piece.points[chord.from]);
    }
    for (const Chord& first : chords)
    {
      walk_.clear();
      for (std::uint32_t at = first.from; leaving_[at] != None;)
      {
        walk_.push_back(at);
        const std::uint32_t c = leaving_[at];
        leaving_[at] = sameFrom_[c];
        at = chords[c].to;
      }
      forEachSimpleLoop(walk_,
        [&](const std::uint32_t* begin, const std::uint32_t* end) { triangulate(begin, end); });
    }
  }

  void triangulate(const std::uint32_t* begin, const std::uint32_t* end)
  {
    loop_.clear();
    for (const std::uint32_t* node = begin; node != end; ++node)
    {
      loop_.push_back(nodes_[*node]);
    }
    for (const auto& t : triangulation_.triangulate(loop_))
    {
      const std::array<std::uint32_t, 3> ids = { loop_[t[0]].id, loop_[t[1]].id, loop_[t[2]].id };
      const Vector normal =
        unit(cross(minus(loop_[t[1]].at, loop_[t[0]].at), minus(loop_[t[2]].at, loop_[t[0]].at)));
      simplification_.add(ids.data(), ids.data() + 3, mostAlike(ids, normal), normal);
    }
  }

  // Of the surface's triangles at the corners of a patch.
  std::uint32_t mostAlike(const std::array<std::uint32_t, 3>& ids, const Vector& normal) const
  {
    std::uint32_t best = triangleAt_[ids[0]];
    for (const std::uint32_t id : ids)
    {
      const std::uint32_t triangle = triangleAt_[id];
      if (dot(features_.normal[triangle], normal) > dot(features_.normal[best], normal))
      {
        best = triangle;
      }
    }
    return best;
  }

  // Turns the box's own numbers of corners into slots, leaving out points that no polygon kept.
  void giveSlots(const PackedBox& box, const std::vector<Point>& points, std::size_t firstCorner)
  {
    slot_.assign(points.size(), None);
    for (std::size_t c = firstCorner; c < part_.corners.size(); ++c)
    {
      const std::uint32_t local = part_.corners[c];
      if (slot_[local] == None)
      {
        const Point& p = points[local];
        slot_[local] = static_cast<std::uint32_t>(part_.uses.size());
        const auto& global = boxes_.globalOf(box).index;
        part_.uses.push_back(
          { p, rowOfPoint(p, boxes_.planes, global[1], global[2]), slot_[local] });
      }
      part_.corners[c] = slot_[local];
    }
  }

  const Features& features_;
  const Boxes& boxes_;
  const std::vector<PatchReason>& reasons_;
  SideTying tying_;
  Simplification simplification_;
  LoopTriangulation triangulation_;
  Part& part_;
  std::vector<LoopNode> nodes_; // of each point that a chord leaves
  std::vector<LoopNode> loop_;
  std::vector<std::uint32_t> triangleAt_; // of the surface, of each point that a chord leaves
  std::vector<std::uint32_t> leaving_;    // first chord that leaves each point, and
  std::vector<std::uint32_t> sameFrom_;   // the next one that leaves the same point
  std::vector<std::uint32_t> walk_;
  std::vector<std::uint32_t> slot_;
};

// Where each part starts in the whole.
struct Offsets
{
  std::vector<std::size_t> polygon;
  std::vector<std::size_t> corner;
  std::vector<std::size_t> slot;

  explicit Offsets(const std::vector<Part>& parts)
  {
    for (const Part& part : parts)
    {
      polygon.push_back(part.sizes.size());
      corner.push_back(part.corners.size());
      slot.push_back(part.uses.size());
    }
    polygon.push_back(0);
    corner.push_back(0);
    slot.push_back(0);
    scan(polygon);
    scan(corner);
    scan(slot);
  }
};

void copyPart(const Part& part, std::size_t index, const Offsets& offsets,
  const Numbering& numbering, const Surface& surface, Patches& patches)
{
  std::size_t polygon = offsets.polygon[index];
  std::size_t corner = offsets.corner[index];
  std::size_t box = index * BoxesAChunk;
  std::size_t firstOfBox = polygon;
  for (const std::uint32_t count : part.polygonsOfBox)
  {
    patches.boxStart[box++] = firstOfBox;
    firstOfBox += count;
  }
  for (std::size_t i = 0; i < part.sizes.size(); ++i, ++polygon)
  {
    patches.start[polygon] = corner;
    corner += part.sizes[i];
    patches.triangle[polygon] = part.triangles[i];
    patches.boundary[polygon] = surface.boundary[part.triangles[i]];
  }
  corner = offsets.corner[index];
  for (const std::uint32_t slot : part.corners)
  {
    patches.corners[corner++] = numbering.ofSlot[offsets.slot[index] + slot];
  }
}

void checkSpec(const PatchSpec& spec)
{
  requireInRange(PatchSpec::FeatureAngles, spec.featureAngle, "Feature Angle");
  requireInRange(PatchSpec::MergeAngles, spec.mergeAngle, "Merge Angle");
}

// The surface in the intersected boxes [begin, end), and the method for each.
void cutPieces(const Surface& surface, const Features& features, const Boxes& boxes,
  const Clearance& clearance, const Shoeboxes& shoeboxes, const PatchSpec& spec,
  const std::vector<std::uint32_t>& intersected, std::size_t begin, std::size_t end, Pieces& pieces,
  std::vector<PatchReason>& reasons)
{
  SurfaceCutter cutter(
    surface, features, boxes, spec.method == PatchMethod::ExactFit ? nullptr : &clearance);
  PatchChooser chooser(surface, features, spec.featureAngle);
  BoxSurface piece;
  for (std::size_t n = begin; n < end; ++n)
  {
    const Box box = boxes.box(intersected[n]);
    const auto& global = boxes.globalOf(box).index;
    const auto [first, last] = shoeboxes.triangles(boxes.row(global[1], global[2]), global[0]);
    cutter.cut(box, first, last, piece);
    PatchReason& reason = reasons[intersected[n]];
    if (spec.method != PatchMethod::MarchingCubes)
    {
      reason = spec.method == PatchMethod::ExactFit ? PatchReason::ExactFitChosen
                                                    : chooser.choose(box, piece);
    }
    pieces.append(piece, reason != PatchReason::MarchingCubes);
  }
}

}

bool isExact(const Patches& patches)
{
  return std::find(patches.reason.begin(), patches.reason.end(), PatchReason::ExactFitChosen) !=
    patches.reason.end();
}

Patches generatePatches(const Surface& surface, const Boxes& boxes, const Shoeboxes& shoeboxes,
  const PatchSpec& spec, Execution& execution)
{
  checkSpec(spec);
  const Features features = findFeatures(surface, spec.featureAngle, execution);
  const Clearance clearance(surface, boxes);
  const std::vector<std::uint32_t> intersected = intersectedBoxes(boxes, execution);
  const std::size_t count = intersected.size();
  std::vector<Pieces> pieces(chunks(count, BoxesAChunk));
  std::vector<PatchReason> reasons(boxes.packed.size(), PatchReason::MarchingCubes);
  execution.nextLoop(0.42);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    cutPieces(surface, features, boxes, clearance, shoeboxes, spec, intersected, begin, end,
      pieces[begin / BoxesAChunk], reasons);
  });
  std::vector<Part> parts(pieces.size());
  execution.nextLoop(0.95);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    PartBuilder builder(
      surface, features, boxes, clearance, reasons, spec, parts[begin / BoxesAChunk]);
    Pieces chunk;
    std::swap(chunk, pieces[begin / BoxesAChunk]); // its memory goes with it
    BoxSurface piece;
    for (std::size_t n = begin; n < end; ++n)
    {
      chunk.readNext(piece);
      builder.addBox(intersected[n], piece);
    }
  });

  const Offsets offsets(parts);
  std::vector<std::vector<PointUse>> uses(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    uses[i].swap(parts[i].uses);
  }
  offsetSlots(uses);
  Numbering numbering = numberPoints(uses, pointRows(boxes.planes), execution);

  Patches patches;
  patches.start.resize(offsets.polygon.back() + 1);
  patches.start.back() = offsets.corner.back();
  patches.triangle.resize(offsets.polygon.back());
  patches.boundary.resize(offsets.polygon.back());
  patches.corners.resize(offsets.corner.back());
  patches.boxStart.resize(count + 1);
  patches.boxStart.back() = offsets.polygon.back();
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) {
    copyPart(parts[i], i, offsets, numbering, surface, patches);
  });
  patches.points.swap(numbering.points);
  patches.reason.reserve(count);
  for (const std::uint32_t box : intersected)
  {
    patches.reason.push_back(reasons[box]);
  }
  return patches;
}

}
