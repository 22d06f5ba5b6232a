#include "Patches.h"

#include "Loops.h"
#include "Numbering.h"

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 512;

// The polygons of a chunk of boxes. Corners are slots: points of this chunk, one a box and place.
struct Part
{
  std::vector<PointUse> uses;
  std::vector<std::uint32_t> sizes;
  std::vector<std::uint32_t> corners;
  std::vector<std::uint32_t> triangles;
  std::vector<std::uint32_t> polygonsOfBox;
};

class PartBuilder
{
public:
  PartBuilder(const Surface& surface, const Boxes& boxes, Part& part)
    : surface_(surface)
    , boxes_(boxes)
    , part_(part)
  {
  }

  void addBox(const Box& box, const std::uint32_t* begin, const std::uint32_t* end)
  {
    points_.clear();
    const std::size_t before = part_.sizes.size();
    const std::size_t firstCorner = part_.corners.size();
    for (const std::uint32_t* triangle = begin; triangle != end; ++triangle)
    {
      addPolygons(clip(surface_.corners(*triangle), box.low, box.high), *triangle);
    }
    part_.polygonsOfBox.push_back(static_cast<std::uint32_t>(part_.sizes.size() - before));
    giveSlots(box, firstCorner);
  }

private:
  // Turns the box's own numbers of corners into slots, leaving out points that no polygon kept.
  void giveSlots(const Box& box, std::size_t firstCorner)
  {
    constexpr std::uint32_t None = ~0u;
    slot_.assign(points_.points().size(), None);
    for (std::size_t c = firstCorner; c < part_.corners.size(); ++c)
    {
      const std::uint32_t local = part_.corners[c];
      if (slot_[local] == None)
      {
        const Point& p = points_.points()[local];
        slot_[local] = static_cast<std::uint32_t>(part_.uses.size());
        part_.uses.push_back(
          { p, rowOfPoint(p, boxes_.planes, box.global[1], box.global[2]), slot_[local] });
      }
      part_.corners[c] = slot_[local];
    }
  }

  // Rounding may let corners of a thin piece coincide: what is left of it are simple loops.
  void addPolygons(const Fragment& fragment, std::uint32_t triangle)
  {
    walk_.clear();
    for (int i = 0; i < fragment.size; ++i)
    {
      walk_.push_back(points_.add(fragment.corner[i]));
    }
    forEachSimpleLoop(walk_, [&](const std::uint32_t* begin, const std::uint32_t* end) {
      part_.corners.insert(part_.corners.end(), begin, end);
      part_.sizes.push_back(static_cast<std::uint32_t>(end - begin));
      part_.triangles.push_back(triangle);
    });
  }

  const Surface& surface_;
  const Boxes& boxes_;
  Part& part_;
  LocalPoints points_;
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

}

std::vector<std::uint32_t> intersectedBoxes(const Boxes& boxes)
{
  std::vector<std::uint32_t> result;
  for (std::size_t b = 0; b < boxes.boxes.size(); ++b)
  {
    if (boxes.boxes[b].status == BoxStatus::Intersected)
    {
      result.push_back(static_cast<std::uint32_t>(b));
    }
  }
  return result;
}

Patches generatePatches(
  const Surface& surface, const Boxes& boxes, const Shoeboxes& shoeboxes, Execution& execution)
{
  const std::vector<std::uint32_t> intersected = intersectedBoxes(boxes);
  const std::size_t count = intersected.size();
  std::vector<Part> parts(chunks(count, BoxesAChunk));
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    PartBuilder builder(surface, boxes, parts[begin / BoxesAChunk]);
    for (std::size_t n = begin; n < end; ++n)
    {
      const Box& box = boxes.boxes[intersected[n]];
      const auto [first, last] =
        shoeboxes.triangles(boxes.row(box.global[1], box.global[2]), box.global[0]);
      builder.addBox(box, first, last);
    }
  });

  const Offsets offsets(parts);
  std::vector<std::vector<PointUse>> uses(parts.size());
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    for (PointUse& use : parts[i].uses)
    {
      use.slot += static_cast<std::uint32_t>(offsets.slot[i]);
    }
    uses[i].swap(parts[i].uses);
  }
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
  return patches;
}

}
