// SPDX-License-Identifier: BSD-3-Clause
#include "Cells/Cells.h"

#include "Base/Error.h"
#include "Base/Sorting.h"
#include "Cells/BoxVolumes.h"
#include "Quality/Limits.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t BoxesAChunk = 128;
constexpr std::size_t MostCornersAdded = 2; // by edits: times as many

// The cells of a chunk of boxes.
struct CellChunk
{
  std::vector<Cell> cells;
  std::vector<FaceUse> uses;
  std::vector<std::uint32_t> cellsOfBox;
  std::vector<std::uint8_t> flawed;
  std::size_t voids = 0;
  std::size_t folds = 0;
};

// Makes the cells of one box after the other.
class BoxAssembler
{
public:
  BoxAssembler(const Boxes& boxes, const Patches& patches, const Sides& sides, const Nodes& nodes,
    const InnerFaces& inner)
    : boxes_(boxes)
    , patches_(patches)
    , sides_(sides)
    , faces_(patches, sides, inner)
    , volumes_(patches, nodes)
  {
  }

  // Whether the faces of a box close around each region in it, without volumes that overlap.
  bool closes(std::size_t n)
  {
    listRegions(n);
    return std::all_of(
      regions_.begin(), regions_.end(), [&](std::int32_t region) { return closes(n, region); });
  }

  void addBox(std::size_t n, const SmallCellSpec& spec, CellChunk& chunk)
  {
    const std::size_t before = chunk.cells.size();
    const std::size_t usesBefore = chunk.uses.size();
    listRegions(n);
    const bool closed = std::all_of(regions_.begin(), regions_.end(),
      [&](std::int32_t region) { return addCells(n, region, spec, chunk); });
    chunk.flawed.push_back(closed ? 0 : 1);
    if (!closed)
    {
      chunk.cells.resize(before);
      chunk.uses.resize(usesBefore);
    }
    chunk.cellsOfBox.push_back(static_cast<std::uint32_t>(chunk.cells.size() - before));
  }

private:
  // Those that the n-th polyhedral box has a part of.
  void listRegions(std::size_t n)
  {
    regions_.assign(1, FirstRegion);
    if (!patches_.walls.any())
    {
      return;
    }
    regions_.clear();
    for (unsigned corner = 0; corner < 8; ++corner)
    {
      regions_.push_back(boxes_.regionAt(sides_.polyhedral[n], corner));
    }
    const std::uint32_t box = sides_.patchBox[n];
    for (std::size_t p = box == None ? 0 : patches_.boxStart[box];
         box != None && p < patches_.boxStart[box + 1]; ++p)
    {
      regions_.push_back(patches_.walls.behind(patches_.boundary[p]));
      regions_.push_back(patches_.walls.front(patches_.boundary[p]));
    }
    std::sort(regions_.begin(), regions_.end());
    regions_.erase(std::unique(regions_.begin(), regions_.end()), regions_.end());
    regions_.erase(std::remove(regions_.begin(), regions_.end(), OutsideRegion), regions_.end());
  }

  bool closes(std::size_t n, std::int32_t region)
  {
    if (!faces_.gather(n, region) || faces_.anyPatchTwice())
    {
      return false;
    }
    if (!faces_.hasSharedEdges())
    {
      return true;
    }
    findVolumes(n);
    return !volumes_.anyFaceTwice(faces_);
  }

  bool addCells(std::size_t n, std::int32_t region, const SmallCellSpec& spec, CellChunk& chunk)
  {
    if (!closes(n, region))
    {
      return false;
    }
    if (!faces_.hasSharedEdges()) // else closes() has found the volumes
    {
      findVolumes(n);
    }
    const bool counts = boxes_.isCore(boxes_.packed[sides_.polyhedral[n]]);
    chunk.voids += counts ? volumes_.voids() : 0;
    chunk.folds += counts ? volumes_.folds() : 0;
    writeCells(sides_.polyhedral[n], region, spec, chunk);
    return true;
  }

  void findVolumes(std::size_t n) { volumes_.find(faces_, boxes_.lowOf(sides_.polyhedral[n])); }

  void writeCells(
    std::uint32_t boxIndex, std::int32_t region, const SmallCellSpec& spec, CellChunk& chunk)
  {
    const double ofBox = volumeOf(boxes_.box(boxIndex));
    for (const Shell& shell : volumes_.shells())
    {
      if (shell.faces.empty())
      {
        continue;
      }
      Cell cell;
      cell.box = boxIndex;
      cell.boundary = volumes_.mainBoundary(faces_, shell);
      cell.region = region;
      cell.volumeFraction = shell.volume / ofBox;
      cell.firstUse = chunk.uses.size();
      cell.sliver = shell.volume < 0 || shell.isSliver();
      cell.removed = !mustStay(shell, cell.sliver) &&
        (cell.sliver ||
          (spec.handling == SmallCells::Remove &&
            (shell.faces.size() < SolverLimits::Faces ||
              cell.volumeFraction < ratioOf(spec, cell.boundary, spec.ratio))));
      chunk.cells.push_back(cell);
      for (const std::uint32_t f : shell.faces)
      {
        chunk.uses.push_back(faces_[f]);
      }
    }
  }

  // At an interface, whatever its size: another region's cell would lose its neighbour. Except if it lies flat
  // between another region and outside: that region's cell ends there.
  bool mustStay(const Shell& shell, bool isSliver) const
  {
    if (!patches_.walls.any())
    {
      return false;
    }
    std::size_t interfaces = 0;
    std::size_t inner = 0;
    for (const std::uint32_t f : shell.faces)
    {
      inner += faces_.isPatch(f) ? 0 : 1;
      interfaces +=
        faces_.isPatch(f) && patches_.walls.isInterface(patches_.boundary[faces_[f].face]) ? 1 : 0;
    }
    const bool isBetween = isSliver && inner == 0 && interfaces == 1 && shell.faces.size() > 1;
    return interfaces > 0 && !isBetween;
  }

  const Boxes& boxes_;
  const Patches& patches_;
  const Sides& sides_;
  BoxFaces faces_;
  BoxVolumes volumes_;
  std::vector<std::int32_t> regions_;
};

// The cells of all chunks, without faces.
WallMesh join(const std::vector<CellChunk>& ofChunk, std::size_t boxes, Execution& execution)
{
  std::vector<std::size_t> cell;
  std::vector<std::size_t> use;
  WallMesh result;
  for (const CellChunk& chunk : ofChunk)
  {
    cell.push_back(chunk.cells.size());
    use.push_back(chunk.uses.size());
    result.voids += chunk.voids;
    result.folds += chunk.folds;
  }
  const std::size_t cells = scan(cell);
  const std::size_t uses = scan(use);
  result.cells.resize(cells + 1);
  result.cells.back().firstUse = uses;
  result.uses.resize(uses);
  result.boxStart.resize(boxes + 1);
  result.boxStart.back() = cells;
  result.flawed.resize(boxes);
  execution.forEach(ofChunk.size(), 1, [&](std::size_t i, std::size_t) {
    const CellChunk& chunk = ofChunk[i];
    std::copy(chunk.uses.begin(), chunk.uses.end(), result.uses.begin() + std::ptrdiff_t(use[i]));
    std::copy(chunk.flawed.begin(), chunk.flawed.end(),
      result.flawed.begin() + std::ptrdiff_t(i * BoxesAChunk));
    for (std::size_t c = 0; c < chunk.cells.size(); ++c)
    {
      result.cells[cell[i] + c] = chunk.cells[c];
      result.cells[cell[i] + c].firstUse += use[i];
    }
    std::size_t next = cell[i];
    for (std::size_t n = 0; n < chunk.cellsOfBox.size(); ++n)
    {
      result.boxStart[i * BoxesAChunk + n] = next;
      next += chunk.cellsOfBox[n];
    }
  });
  return result;
}

// Patches, then the faces of sides, without cells.
WallFaces facesOf(const Patches& patches, const InnerFaces& inner)
{
  WallFaces faces;
  const std::size_t count = patches.size() + inner.size();
  const std::size_t corners = patches.corners.size() + inner.nodes.size();
  faces.reserve(count, corners);
  faces.start.clear();
  for (const std::size_t start : patches.start)
  {
    faces.start.push_back(static_cast<std::uint32_t>(start));
  }
  for (std::size_t f = 0; f < inner.size(); ++f)
  {
    faces.start.push_back(static_cast<std::uint32_t>(patches.corners.size() + inner.start[f + 1]));
  }
  faces.corners.assign(patches.corners.begin(), patches.corners.end());
  faces.corners.insert(faces.corners.end(), inner.nodes.begin(), inner.nodes.end());
  faces.cells.assign(count, { None, None });
  faces.boundary.assign(patches.boundary.begin(), patches.boundary.end());
  faces.boundary.resize(count, NoBoundary);
  for (const std::size_t first : inner.sideStart)
  {
    faces.sideStart.push_back(static_cast<std::uint32_t>(patches.size() + first));
  }
  return faces;
}

// The cells on either side of the faces; where there is none, the wall that a face belongs to.
void findCellsOfFaces(
  const Patches& patches, const Sides& sides, WallMesh& wall, Execution& execution)
{
  WallFaces& faces = wall.faces;
  execution.forEach(wall.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t c = begin; c < end; ++c)
    {
      wall.forEachUse(c,
        [&](const FaceUse& use) { faces.cells[use.face][use.turned] = static_cast<CellKey>(c); });
    }
  });
  const auto findBeyond = [&](std::uint32_t box, std::uint32_t f, CellKey& cell) {
    if (cell != None)
    {
      return;
    }
    if (box != None && sides.polyhedralOrdinal(box) == None)
    {
      cell = keyOfHexahedron(box);
    }
    else
    {
      faces.boundary[f] = boundaryBeyond(patches, sides, box);
    }
  };
  execution.forEach(sides.common.size(), BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t s = begin; s < end; ++s)
    {
      for (std::uint32_t f = faces.sideStart[s]; f < faces.sideStart[s + 1]; ++f)
      {
        findBeyond(sides.common[s].low, f, faces.cells[f][0]);
        findBeyond(sides.common[s].high, f, faces.cells[f][1]);
      }
    }
  });
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

std::int32_t boundaryBeyond(const Patches& patches, const Sides& sides, std::uint32_t box)
{
  const std::uint32_t n = sides.polyhedralOrdinal(box);
  const std::uint32_t of = n == None ? None : sides.patchBox[n];
  return of == None || patches.boxStart[of] == patches.boxStart[of + 1]
    ? NoBoundary
    : patches.boundary[patches.boxStart[of]];
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
      execution.poll();
      flawed[n] = assembler.closes(n) ? 0 : 1;
    }
  });
  return flawed;
}

WallMesh assembleCells(const Boxes& boxes, const Patches& patches, const Sides& sides,
  const Nodes& nodes, const InnerFaces& inner, const SmallCellSpec& spec, Execution& execution)
{
  if (MostCornersAdded * (patches.corners.size() + inner.nodes.size()) > None ||
    boxes.packed.size() > EndOfKeys - FirstHexahedron)
  {
    throw Error(Fault::TooManyBoxes,
      "The mesh has more boxes or boundary faces than can be numbered: choose a larger Cell Size.");
  }
  const std::size_t count = sides.polyhedral.size();
  std::vector<CellChunk> ofChunk(chunks(count, BoxesAChunk));
  execution.nextLoop(0.95);
  execution.forEach(count, BoxesAChunk, [&](std::size_t begin, std::size_t end) {
    BoxAssembler assembler(boxes, patches, sides, nodes, inner);
    for (std::size_t n = begin; n < end; ++n)
    {
      execution.poll();
      assembler.addBox(n, spec, ofChunk[begin / BoxesAChunk]);
    }
  });
  WallMesh wall = join(ofChunk, count, execution);
  wall.faces = facesOf(patches, inner);
  findCellsOfFaces(patches, sides, wall, execution);
  return wall;
}

}
