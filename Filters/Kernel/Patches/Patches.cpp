// SPDX-License-Identifier: BSD-3-Clause
#include "Patches/Patches.h"

#include "Base/Error.h"
#include "Patches/NearTriangles.h"
#include "Patches/PatchBuilder.h"
#include "Patches/VolumeGap.h"
#include "Surface/Components.h"

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 128;

// The surface in the boxes of a chunk, one box after the other.
class SurfacePieces
{
public:
  // `withPolygons`: false where Marching Cubes makes polygons of its own.
  void append(const BoxSurface& piece, bool withPolygons)
  {
    const std::size_t polygons = withPolygons ? piece.sizes.size() : 0;
    const std::size_t corners = withPolygons ? piece.corners.size() : 0;
    counts_.push_back(
      { piece.points.size(), piece.kinds.size(), polygons, corners, piece.segments.size() });
    insert(all_.points, piece.points, piece.points.size());
    insert(all_.kinds, piece.kinds, piece.kinds.size());
    insert(all_.sizes, piece.sizes, polygons);
    insert(all_.triangles, piece.triangles, polygons);
    insert(all_.corners, piece.corners, corners);
    insert(all_.segments, piece.segments, piece.segments.size());
  }

  // Boxes come in the order in which they were appended.
  void readNext(BoxSurface& piece)
  {
    const PieceSizes& n = counts_[next_++];
    const auto copy = [](const auto& from, std::size_t begin, std::size_t count, auto& to) {
      to.assign(from.begin() + std::ptrdiff_t(begin), from.begin() + std::ptrdiff_t(begin + count));
    };
    copy(all_.points, at_.points, n.points, piece.points);
    copy(all_.kinds, at_.kinds, n.kinds, piece.kinds);
    copy(all_.sizes, at_.polygons, n.polygons, piece.sizes);
    copy(all_.triangles, at_.polygons, n.polygons, piece.triangles);
    copy(all_.corners, at_.corners, n.corners, piece.corners);
    copy(all_.segments, at_.segments, n.segments, piece.segments);
    at_ = { at_.points + n.points, at_.kinds + n.kinds, at_.polygons + n.polygons,
      at_.corners + n.corners, at_.segments + n.segments };
  }

private:
  struct PieceSizes
  {
    std::size_t points;
    std::size_t kinds;
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
  std::vector<PieceSizes> counts_;
  std::size_t next_ = 0;
  PieceSizes at_{};
};

// Where each chunk starts in the whole.
struct Offsets
{
  std::vector<std::size_t> polygon;
  std::vector<std::size_t> corner;
  std::vector<std::size_t> slot;

  explicit Offsets(const std::vector<PatchChunk>& ofChunk)
  {
    for (const PatchChunk& chunk : ofChunk)
    {
      polygon.push_back(chunk.sizes.size());
      corner.push_back(chunk.corners.size());
      slot.push_back(chunk.uses.size());
    }
    polygon.push_back(0);
    corner.push_back(0);
    slot.push_back(0);
    scan(polygon);
    scan(corner);
    scan(slot);
  }
};

void copyChunk(const PatchChunk& chunk, std::size_t index, const Offsets& offsets,
  const Numbering& numbering, const Surface& surface, Patches& patches)
{
  std::size_t polygon = offsets.polygon[index];
  std::size_t corner = offsets.corner[index];
  std::size_t box = index * BoxesAChunk;
  std::size_t firstOfBox = polygon;
  for (const std::uint32_t count : chunk.polygonsOfBox)
  {
    patches.boxStart[box++] = firstOfBox;
    firstOfBox += count;
  }
  for (std::size_t i = 0; i < chunk.sizes.size(); ++i, ++polygon)
  {
    patches.start[polygon] = corner;
    corner += chunk.sizes[i];
    patches.triangle[polygon] = chunk.triangles[i];
    patches.boundary[polygon] = surface.boundary[chunk.triangles[i]];
  }
  corner = offsets.corner[index];
  for (const std::uint32_t slot : chunk.corners)
  {
    patches.corners[corner++] = numbering.ofSlot[offsets.slot[index] + slot];
  }
}

// A point is of the highest kind that it has in any box.
void findKinds(const std::vector<PatchChunk>& ofChunk, const Offsets& offsets,
  const Numbering& numbering, Patches& patches)
{
  patches.kinds.assign(numbering.points.size(), PointKind::OnSurface);
  for (std::size_t i = 0; i < ofChunk.size(); ++i)
  {
    for (const PatchChunk::Feature& feature : ofChunk[i].features)
    {
      raise(patches.kinds[numbering.ofSlot[offsets.slot[i] + feature.slot]], feature.kind);
    }
  }
}

void checkSpec(const PatchSpec& spec, const Surface& surface)
{
  requireInRange(PatchSpec::FeatureAngles, spec.featureAngle, "Feature Angle");
  requireInRange(PatchSpec::MergeAngles, spec.mergeAngle, "Merge Angle");
  if (surface.walls.any() && spec.method == PatchMethod::MarchingCubes)
  {
    throw Error(Fault::BadParameter,
      "Patch Method Marching Cubes cannot represent where several regions meet: choose Automatic "
      "or Exact Fit.");
  }
}

class PatchGenerator
{
public:
  PatchGenerator(
    const Surface& surface, const Boxes& boxes, const PatchSpec& spec, Execution& execution)
    : surface_(surface)
    , boxes_(boxes)
    , spec_(spec)
    , execution_(execution)
    , features_(findFeatures(surface, spec.featureAngle, execution))
    , clearance_(surface, boxes.planes)
    , intersected_(intersectedBoxes(boxes, execution))
    , reasons_(boxes.packed.size(), PatchReason::MarchingCubes)
    , behind_(spec.method == PatchMethod::Automatic ? intersected_.size() : 0)
  {
  }

  Patches generate(const Shoeboxes& shoeboxes)
  {
    const std::size_t count = intersected_.size();
    const NodeTriangles ofNodes(surface_, boxes_, shoeboxes, execution_);
    std::vector<SurfacePieces> pieces(chunks(count, BoxesAChunk));
    execution_.nextLoop(0.42);
    execution_.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
      cut(ofNodes, begin, end, pieces[begin / BoxesAChunk]);
    });
    std::vector<PatchChunk> ofChunk(pieces.size());
    execution_.nextLoop(0.95);
    execution_.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
      PatchBuilder builder(
        surface_, features_, boxes_, clearance_, reasons_, spec_, ofChunk[begin / BoxesAChunk]);
      SurfacePieces chunk;
      std::swap(chunk, pieces[begin / BoxesAChunk]); // frees their memory early
      BoxSurface piece;
      for (std::size_t n = begin; n < end; ++n)
      {
        execution_.poll();
        chunk.readNext(piece);
        builder.addBox(intersected_[n], piece);
      }
    });
    Patches patches = join(ofChunk);
    findMissing(patches);
    return patches;
  }

private:
  // Cuts the surface in the intersected boxes [begin, end), and chooses the method for each.
  void cut(const NodeTriangles& ofNodes, std::size_t begin, std::size_t end, SurfacePieces& pieces)
  {
    SurfaceCutter cutter(
      surface_, features_, boxes_, spec_.method == PatchMethod::ExactFit ? nullptr : &clearance_);
    PatchChooser chooser(surface_, features_, spec_.featureAngle);
    NearTriangles near(surface_, boxes_, ofNodes);
    BoxSurface piece;
    for (std::size_t n = begin; n < end; ++n)
    {
      execution_.poll();
      const Box box = boxes_.box(intersected_[n]);
      const auto [first, last] = near.of(box);
      cutter.cut(box, first, last, piece);
      PatchReason& reason = reasons_[intersected_[n]];
      if (spec_.method != PatchMethod::MarchingCubes)
      {
        reason = spec_.method == PatchMethod::ExactFit
          ? PatchReason::ExactFitChosen
          : chooser.choose(behindFirst(intersected_[n], box, piece), piece);
      }
      if (spec_.method == PatchMethod::Automatic && reason == PatchReason::MarchingCubes)
      {
        behind_[n] = spaceBehind(box, piece);
      }
      pieces.append(piece, reason != PatchReason::MarchingCubes);
    }
  }

  // With several regions, a corner counts as inside where it is behind the first of the walls: if the box
  // has others, it is no box for Marching Cubes anyway.
  Box behindFirst(std::uint32_t b, Box box, const BoxSurface& piece) const
  {
    if (!surface_.walls.any() || piece.triangles.empty())
    {
      return box;
    }
    const std::int32_t behind = surface_.walls.behind(surface_.boundary[piece.triangles[0]]);
    unsigned bits = 0;
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      bits |= static_cast<unsigned>(boxes_.regionAt(b, corner) == behind) << corner;
    }
    box.corners = static_cast<std::uint8_t>(bits);
    return box;
  }

  // Numbers the points and puts all chunks together.
  Patches join(std::vector<PatchChunk>& ofChunk)
  {
    const Offsets offsets(ofChunk);
    std::vector<std::vector<PointUse>> uses(ofChunk.size());
    for (std::size_t i = 0; i < ofChunk.size(); ++i)
    {
      uses[i].swap(ofChunk[i].uses);
    }
    offsetSlots(uses);
    Numbering numbering = numberPoints(uses, pointRows(boxes_.planes), execution_);

    Patches patches;
    patches.start.resize(offsets.polygon.back() + 1);
    patches.start.back() = offsets.corner.back();
    patches.triangle.resize(offsets.polygon.back());
    patches.boundary.resize(offsets.polygon.back());
    patches.corners.resize(offsets.corner.back());
    patches.boxStart.resize(intersected_.size() + 1);
    patches.boxStart.back() = offsets.polygon.back();
    execution_.forEach(ofChunk.size(), 1, [&](std::size_t i, std::size_t) {
      copyChunk(ofChunk[i], i, offsets, numbering, surface_, patches);
    });
    findKinds(ofChunk, offsets, numbering, patches);
    patches.points.swap(numbering.points);
    patches.knowsEdges = surface_.knownEdges != nullptr;
    patches.walls = surface_.walls;
    patches.enclosed = enclosedVolumes(surface_, execution_);
    patches.surfaceVolume = boxes_.core.contains(0) ? surfaceVolume() : 0;
    patches.reason.resize(intersected_.size());
    execution_.forEach(intersected_.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        patches.reason[n] = reasons_[intersected_[n]];
      }
    });
    return patches;
  }

  // Exact Fit misses almost no volume.
  void findMissing(Patches& patches) const
  {
    patches.missing.resize(intersected_.size());
    execution_.forEach(behind_.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t n = begin; n < end; ++n)
      {
        if (patches.reason[n] == PatchReason::MarchingCubes)
        {
          patches.missing[n] =
            missingBy(behind_[n], spaceBehind(boxes_.box(intersected_[n]), patches, n));
        }
      }
    });
  }

  // Where bodies reach beyond a flow domain it is not known.
  double surfaceVolume() const
  {
    if (surface_.around == Winding{})
    {
      return volumeOf(surface_);
    }
    double domain = 1;
    bool reachesBeyond = false;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto& planes = boxes_.planes[axis];
      domain *= (planes.back() - planes.front()) * surface_.lattice.step();
      reachesBeyond = reachesBeyond ||
        std::any_of(surface_.vertices.begin(), surface_.vertices.end(),
          [&](const Point& p) { return p[axis] < planes.front() || p[axis] > planes.back(); });
    }
    return reachesBeyond ? 0 : domain + volumeOf(surface_);
  }

  const Surface& surface_;
  const Boxes& boxes_;
  const PatchSpec& spec_;
  Execution& execution_;
  const Features features_;
  const PlaneClearance clearance_;
  const std::vector<std::uint32_t> intersected_;
  std::vector<PatchReason> reasons_; // of all boxes
  std::vector<double> behind_; // of intersected boxes with chords: the space behind the surface
};

}

bool isExact(const Patches& patches)
{
  return std::find(patches.reason.begin(), patches.reason.end(), PatchReason::ExactFitChosen) !=
    patches.reason.end();
}

Patches generatePatches(const Surface& surface, const Boxes& boxes, const Shoeboxes& shoeboxes,
  const PatchSpec& spec, Execution& execution)
{
  checkSpec(spec, surface);
  return PatchGenerator(surface, boxes, spec, execution).generate(shoeboxes);
}

}
