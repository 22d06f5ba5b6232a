// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/KeptParts.h"

#include "Base/Error.h"
#include "Cells/ConnectedCells.h"
#include "Surface/LineCrossings.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

// The fine interval that holds a level, which is between the first plane and the last.
std::int64_t fineAt(const Meshlines& planes, std::size_t axis, Level level)
{
  const std::int64_t i = intervalOf(planes[axis], level);
  std::int64_t part = 0;
  for (std::int64_t step = FinePerBox / 2; step > 0; step /= 2)
  {
    part += planeAt(planes, axis, static_cast<std::size_t>(i), part + step) <= level ? step : 0;
  }
  return i * FinePerBox + part;
}

// Elements are boxes, for hexahedra, then cells.
class Parts
{
public:
  Parts(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const WallMesh& wall, Execution& execution)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , nodes_(nodes)
    , wall_(wall)
    , parts_(unitedHexahedra(boxes, sides, wall, execution))
    , isKept_(boxes.packed.size() + wall.size())
  {
    uniteAcrossSides();
  }

  void keep(const KeepPoint& point) { isKept_[parts_.find(elementAt(point))] = 1; }

  // Throws Error: BadParameter.
  void requireEnclosed(const std::vector<KeepPoint>& points)
  {
    for (const std::uint32_t element : elementsAtEnds())
    {
      const std::uint32_t part = parts_.find(element);
      for (const KeepPoint& point : points)
      {
        if (parts_.find(elementAt(point)) == part)
        {
          throw Error(Fault::BadParameter,
            point.name +
              " lies in open space: the surface does not enclose the space around it. Move the "
              "point, or set Domain to Outside to mesh a box around the surface.");
        }
      }
    }
  }

  // That a part which stays contains; points must have been kept.
  std::optional<ReachedPoint> leak(const PartsToKeep& which)
  {
    for (std::size_t out = 0; out < which.keepOut.size(); ++out)
    {
      const KeepPoint& point = which.keepOut[out];
      if (point.isBeyond || !point.winding.inside())
      {
        continue;
      }
      const std::uint32_t part = parts_.find(elementAt(point));
      if (which.points.empty())
      {
        return ReachedPoint{ out, None };
      }
      const auto from = std::find_if(which.points.begin(), which.points.end(),
        [&](const KeepPoint& kept) { return parts_.find(elementAt(kept)) == part; });
      if (from != which.points.end())
      {
        return ReachedPoint{ out, static_cast<std::size_t>(from - which.points.begin()) };
      }
    }
    return std::nullopt;
  }

  KeptParts result()
  {
    KeptParts kept;
    std::set<std::uint32_t> leftOut;
    const auto isKept = [&](std::uint32_t element) {
      const std::uint32_t part = parts_.find(element);
      if (isKept_[part] == 0)
      {
        leftOut.insert(part);
      }
      return isKept_[part] != 0;
    };
    kept.droppedPatches.resize(patches_.size());
    std::vector<std::uint8_t> corners(boxes_.packed.size()); // of boxes that stay
    std::vector<std::uint8_t> stays(boxes_.packed.size());
    for (std::uint32_t b = 0; b < boxes_.packed.size(); ++b)
    {
      const std::uint32_t n = sides_.polyhedralOrdinal(b);
      corners[b] = boxes_.packed[b].corners;
      stays[b] = n == None && isKept(b) ? 1 : 0;
      for (std::uint32_t c = firstCell(n); c < endCell(n); ++c)
      {
        if (isKept(cellElement(c)))
        {
          stays[b] = 1;
        }
        else
        {
          dropPatches(c, kept.droppedPatches);
          corners[b] = static_cast<std::uint8_t>(corners[b] & ~cornersOf(b, c));
        }
      }
    }
    keepEmptyBoxes(stays);
    for (std::uint32_t b = 0; b < stays.size(); ++b)
    {
      if (stays[b] != 0)
      {
        kept.boxes.push_back(b);
        kept.corners.push_back(corners[b]);
      }
    }
    kept.leftOut = leftOut.size();
    return kept;
  }

private:
  std::uint32_t cellElement(std::uint32_t c) const
  {
    return static_cast<std::uint32_t>(boxes_.packed.size()) + c;
  }

  std::uint32_t firstCell(std::uint32_t n) const
  {
    return n == None ? 0 : static_cast<std::uint32_t>(wall_.boxStart[n]);
  }
  std::uint32_t endCell(std::uint32_t n) const
  {
    return n == None ? 0 : static_cast<std::uint32_t>(wall_.boxStart[n + 1]);
  }

  bool isHexahedron(std::uint32_t box) const
  {
    return box != None && sides_.polyhedralOrdinal(box) == None;
  }

  // Calls visit(face, below, above) for all faces of sides: their elements, or None.
  template <class Visitor>
  void forEachFace(Visitor&& visit) const
  {
    const WallFaces& faces = wall_.faces;
    const auto element = [&](CellKey cell) {
      return cell == None               ? std::uint32_t(None)
        : cartesian::isHexahedron(cell) ? boxOfHexahedron(cell)
                                        : cellElement(cell);
    };
    for (std::size_t s = 0; s < sides_.common.size(); ++s)
    {
      for (std::uint32_t f = faces.sideStart[s]; f < faces.sideStart[s + 1]; ++f)
      {
        visit(sides_.common[s], element(faces.cells[f][0]), element(faces.cells[f][1]));
      }
    }
  }

  void uniteAcrossSides()
  {
    forEachFace([&](const Side&, std::uint32_t below, std::uint32_t above) {
      if (below != None && above != None)
      {
        parts_.unite(below, above);
      }
    });
  }

  // With a face on an end of the grid.
  std::vector<std::uint32_t> elementsAtEnds() const
  {
    std::vector<std::uint32_t> found;
    for (std::uint32_t b = 0; b < boxes_.packed.size(); ++b)
    {
      for (std::size_t axis = 0; isHexahedron(b) && axis < 3; ++axis)
      {
        const auto end = static_cast<std::int64_t>(boxes_.planes[axis].size() - 1) * FinePerBox;
        const std::int64_t low = boxes_.fineLow(boxes_.packed[b])[axis];
        if (low == 0 || low + Boxes::fineSize(boxes_.packed[b], static_cast<int>(axis)) == end)
        {
          found.push_back(b);
        }
      }
    }
    forEachFace([&](const Side& side, std::uint32_t below, std::uint32_t above) {
      const std::uint32_t inside = below == None ? above : below;
      if ((side.low == None || side.high == None) && inside != None)
      {
        found.push_back(inside);
      }
    });
    return found;
  }

  std::uint32_t elementAt(const KeepPoint& point) const
  {
    std::uint32_t box = None;
    const auto isBeyond = [&](std::size_t axis) {
      return point.at[axis] < boxes_.planes[axis].front() ||
        point.at[axis] >= boxes_.planes[axis].back();
    };
    if (!isBeyond(0) && !isBeyond(1) && !isBeyond(2))
    {
      std::int64_t step = 0;
      box =
        boxes_.boxAt({ fineAt(boxes_.planes, 0, point.at[0]), fineAt(boxes_.planes, 1, point.at[1]),
                       fineAt(boxes_.planes, 2, point.at[2]) },
          0, step);
    }
    if (isHexahedron(box))
    {
      return box;
    }
    const std::uint32_t n = box == None ? None : sides_.polyhedralOrdinal(box);
    for (std::uint32_t c = firstCell(n); c < endCell(n); ++c)
    {
      if (isInCell(point.at, c))
      {
        return cellElement(c);
      }
    }
    throw Error(Fault::BadParameter,
      point.name +
        " lies so close to the surface that no cell contains it: move it away from the surface, "
        "or choose a smaller Cell Size.");
  }

  // By the crossings of the cell's faces with a line along x.
  bool isInCell(const Point& at, std::uint32_t c) const
  {
    bool isIn = false;
    wall_.forEachUse(c, [&](const FaceUse& use) {
      std::vector<Point> corners;
      wall_.faces.forEachNode(use, [&](std::uint32_t node) { corners.push_back(nodes_.at[node]); });
      for (std::size_t i = 1; i + 1 < corners.size(); ++i)
      {
        forEachLineCrossing({ corners[0], corners[i], corners[i + 1] }, RowsAlong[0], { at[1] },
          { at[2] },
          [&](std::size_t, std::size_t, const Point& p, bool) { isIn = isIn != (p[0] < at[0]); });
      }
    });
    return isIn;
  }

  void dropPatches(std::uint32_t c, std::vector<std::uint8_t>& dropped) const
  {
    wall_.forEachUse(c, [&](const FaceUse& use) {
      if (wall_.faces.isPatch(use.face))
      {
        dropped[use.face] = 1;
      }
    });
  }

  // Corners of a box that are nodes of one of its cells, as bits.
  unsigned cornersOf(std::uint32_t b, std::uint32_t c) const
  {
    const Box box = boxes_.box(b);
    unsigned bits = 0;
    wall_.forEachNodeOf(c, [&](std::uint32_t node) {
      for (unsigned corner = 0; corner < 8; ++corner)
      {
        bits |= nodes_.at[node] == cornerOf(box, corner) ? 1U << corner : 0;
      }
    });
    return bits;
  }

  // Those without a cell stay beside others, as they have no part of their own.
  void keepEmptyBoxes(std::vector<std::uint8_t>& stays) const
  {
    std::vector<std::uint32_t> beside;
    for (const Side& side : sides_.common)
    {
      for (const auto& [one, other] : { std::pair(side.low, side.high), { side.high, side.low } })
      {
        const std::uint32_t n = one == None ? None : sides_.polyhedralOrdinal(one);
        if (n != None && firstCell(n) == endCell(n) && other != None && stays[other] != 0)
        {
          beside.push_back(one);
        }
      }
    }
    for (const std::uint32_t box : beside)
    {
      stays[box] = 1;
    }
  }

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  const Nodes& nodes_;
  const WallMesh& wall_;
  ConcurrentSets parts_;
  std::vector<std::uint8_t> isKept_; // of the elements that stand for parts
};

void keepBoxes(const KeptParts& kept, Boxes& boxes, Execution& execution)
{
  RawVector<PackedBox> packed;
  RawVector<GlobalBox> globals;
  std::vector<std::size_t> rowStart(boxes.rowStart.size());
  packed.reserve(kept.boxes.size());
  std::size_t next = 0; // in kept.boxes
  for (std::size_t row = 0; row + 1 < rowStart.size(); ++row)
  {
    rowStart[row] = globals.size();
    for (std::size_t g = boxes.rowStart[row]; g < boxes.rowStart[row + 1]; ++g)
    {
      GlobalBox global = boxes.globals[g];
      global.firstBox = static_cast<std::uint32_t>(packed.size());
      for (; next < kept.boxes.size() && kept.boxes[next] < boxes.globals[g + 1].firstBox; ++next)
      {
        PackedBox box = boxes.packed[kept.boxes[next]];
        box.global = static_cast<std::uint32_t>(globals.size());
        box.corners = kept.corners[next];
        packed.push_back(box);
      }
      if (global.firstBox < packed.size())
      {
        globals.push_back(global);
      }
    }
  }
  rowStart.back() = globals.size();
  GlobalBox end = boxes.globals.back();
  end.firstBox = static_cast<std::uint32_t>(packed.size());
  globals.push_back(end);
  boxes.packed = std::move(packed);
  boxes.globals = std::move(globals);
  boxes.rowStart = std::move(rowStart);
  boxes.plantTree(execution);
}

// `intersected`: the boxes that patches.boxStart is about, by their old numbers.
void keepPatches(
  const KeptParts& kept, const std::vector<std::uint32_t>& intersected, Patches& patches)
{
  Patches result;
  std::vector<std::uint32_t> newPoint(patches.points.size(), None);
  result.start.push_back(0);
  result.boxStart.push_back(0);
  for (std::size_t n = 0; n < intersected.size(); ++n)
  {
    if (!std::binary_search(kept.boxes.begin(), kept.boxes.end(), intersected[n]))
    {
      continue;
    }
    for (std::size_t p = patches.boxStart[n]; p < patches.boxStart[n + 1]; ++p)
    {
      if (kept.droppedPatches[p] != 0)
      {
        continue;
      }
      for (std::size_t i = patches.start[p]; i < patches.start[p + 1]; ++i)
      {
        newPoint[patches.corners[i]] = 0;
        result.corners.push_back(patches.corners[i]);
      }
      result.start.push_back(result.corners.size());
      result.triangle.push_back(patches.triangle[p]);
      result.boundary.push_back(patches.boundary[p]);
    }
    result.boxStart.push_back(result.triangle.size());
    result.reason.push_back(patches.reason[n]);
    result.missing.push_back(patches.missing.empty() ? 0 : patches.missing[n]);
  }
  for (std::size_t i = 0; i < newPoint.size(); ++i)
  {
    if (newPoint[i] != None)
    {
      newPoint[i] = static_cast<std::uint32_t>(result.points.size());
      result.points.push_back(patches.points[i]);
      result.kinds.push_back(patches.kinds[i]);
    }
  }
  for (std::uint32_t& corner : result.corners)
  {
    corner = newPoint[corner];
  }
  result.knowsEdges = patches.knowsEdges;
  result.walls = std::move(patches.walls);
  result.enclosed = std::move(patches.enclosed);
  patches = std::move(result);
}

}

KeptParts findKeptParts(const PartsToKeep& which, const Boxes& boxes, const Patches& patches,
  const Sides& sides, const Nodes& nodes, const WallMesh& wall, Execution& execution)
{
  Parts parts(boxes, patches, sides, nodes, wall, execution);
  for (const KeepPoint& point : which.points)
  {
    parts.keep(point);
  }
  KeptParts kept;
  kept.leak = parts.leak(which);
  if (kept.leak || which.points.empty())
  {
    return kept;
  }
  if (which.isEnclosed)
  {
    parts.requireEnclosed(which.points);
  }
  return parts.result();
}

void keepOnly(const KeptParts& parts, Boxes& boxes, Patches& patches, Execution& execution)
{
  keepPatches(parts, intersectedBoxes(boxes, execution), patches);
  keepBoxes(parts, boxes, execution);
}

}
