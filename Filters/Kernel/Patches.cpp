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

// The lines along which finer neighbours divide the sides of a box.
class SideLines
{
public:
  void find(const Boxes& boxes, const Box& box)
  {
    any_ = false;
    if (boxes.globalOf(box).nearDepth == 0)
    {
      return;
    }
    for (int axis = 0; axis < 3; ++axis)
    {
      for (const bool upper : { false, true })
      {
        Cross& cross = crosses_[2 * static_cast<std::size_t>(axis) + (upper ? 1 : 0)];
        const std::array<std::uint32_t, 4> across = facing(boxes, box, axis, upper);
        cross.plane = upper ? box.high[static_cast<std::size_t>(axis)]
                            : box.low[static_cast<std::size_t>(axis)];
        cross.u = { across[0] != across[1], across[2] != across[3] };
        cross.v = { across[0] != across[2], across[1] != across[3] };
        any_ = any_ || cross.u[0] || cross.u[1] || cross.v[0] || cross.v[1];
      }
    }
    if (any_)
    {
      const FinePoint low = boxes.fineLow(box);
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        middle_[axis] =
          planeAt(boxes.planes[axis], low[axis] + Boxes::fineSize(box, static_cast<int>(axis)) / 2);
      }
    }
  }

  // Calls visit(point) where the i-th side of a fragment, if it lies on a side of the box, crosses a
  // line there; in order.
  template <class Visitor>
  void forEachCrossing(
    const Corners& triangle, const Fragment& fragment, int i, Visitor&& visit) const
  {
    const auto n = static_cast<std::size_t>(i);
    if (!any_ || fragment.side[n] < Fragment::FirstPlane)
    {
      return;
    }
    const int axis = fragment.side[n] - Fragment::FirstPlane;
    const Point& p = fragment.corner[n];
    const Point& q = fragment.corner[i + 1 < fragment.size ? n + 1 : 0];
    for (const std::size_t side : { 2u * axis, 2u * axis + 1u })
    {
      const Cross& cross = crosses_[side];
      if (cross.plane != p[static_cast<std::size_t>(axis)])
      {
        continue;
      }
      const std::size_t u = (static_cast<std::size_t>(axis) + 1) % 3;
      const std::size_t v = (static_cast<std::size_t>(axis) + 2) % 3;
      Point atU;
      Point atV;
      const bool crossesU = crossing(triangle, p, q, u, v, cross.u, atU);
      const bool crossesV = crossing(triangle, p, q, v, u, cross.v, atV);
      const bool firstU = crossesU && (!crossesV || (atU[u] < atV[u]) == (p[u] < q[u]));
      if (firstU)
      {
        visit(atU);
      }
      if (crossesV)
      {
        visit(atV);
      }
      if (crossesU && !firstU)
      {
        visit(atU);
      }
    }
  }

private:
  // The middle lines of a side, each in two halves: whether neighbours meet there.
  struct Cross
  {
    Level plane = 0;
    std::array<bool, 2> u{}; // on the line across u: its lower and upper half along v
    std::array<bool, 2> v{};
  };

  // Where pq crosses the middle line across axis u, if that half of it is one between neighbours.
  bool crossing(const Corners& triangle, const Point& p, const Point& q, std::size_t u,
    std::size_t v, const std::array<bool, 2>& halves, Point& at) const
  {
    if ((!halves[0] && !halves[1]) || (p[u] < middle_[u]) == (q[u] < middle_[u]))
    {
      return false;
    }
    at = p;
    at[u] = middle_[u];
    at = crossLine(triangle, static_cast<int>(v), at);
    return halves[at[v] < middle_[v] ? 0 : 1];
  }

  std::array<Cross, 6> crosses_; // low x, high x, low y, ...
  Point middle_{};
  bool any_ = false;
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
    lines_.find(boxes_, box);
    const std::size_t before = part_.sizes.size();
    const std::size_t firstCorner = part_.corners.size();
    for (const std::uint32_t* triangle = begin; triangle != end; ++triangle)
    {
      const Corners corners = surface_.corners(*triangle);
      if (mayMeet(corners, box))
      {
        addPolygons(corners, clip(corners, box.low, box.high), *triangle);
      }
    }
    part_.polygonsOfBox.push_back(static_cast<std::uint32_t>(part_.sizes.size() - before));
    giveSlots(box, firstCorner);
  }

private:
  // A global box's triangles may all lie in other boxes of it.
  static bool mayMeet(const Corners& c, const Box& box)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      if (std::max({ c[0][axis], c[1][axis], c[2][axis] }) < box.low[axis] ||
        std::min({ c[0][axis], c[1][axis], c[2][axis] }) > box.high[axis])
      {
        return false;
      }
    }
    return true;
  }

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
        const auto& global = boxes_.globalOf(box).index;
        part_.uses.push_back(
          { p, rowOfPoint(p, boxes_.planes, global[1], global[2]), slot_[local] });
      }
      part_.corners[c] = slot_[local];
    }
  }

  // Rounding may let corners of a thin piece coincide: what is left of it are simple loops.
  void addPolygons(const Corners& corners, const Fragment& fragment, std::uint32_t triangle)
  {
    walk_.clear();
    for (int i = 0; i < fragment.size; ++i)
    {
      walk_.push_back(points_.add(fragment.corner[i]));
      lines_.forEachCrossing(
        corners, fragment, i, [&](const Point& p) { walk_.push_back(points_.add(p)); });
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
  SideLines lines_;
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
      const auto& global = boxes.globalOf(box).index;
      const auto [first, last] = shoeboxes.triangles(boxes.row(global[1], global[2]), global[0]);
      builder.addBox(box, first, last);
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
  return patches;
}

}
