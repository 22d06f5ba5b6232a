#include "Mesher/Mesher.h"

#include "Base/Error.h"
#include "Collapse/EdgeCollapse.h"
#include "Collapse/WarpedHexahedra.h"
#include "Lattice/Vector.h"
#include "Parts/Decomposition.h"

#include <algorithm>
#include <cmath>
#include <functional>

namespace cartesian
{

namespace
{

// Planes step aside by a few levels: what is next to 0 is written as 0.
std::string position(const Lattice& lattice, const Point& p)
{
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
  {
    const double x = lattice.position(axis, p[static_cast<std::size_t>(axis)]);
    text += (axis == 0 ? "(" : ", ") + number(std::abs(x) < 4 * lattice.step() ? 0 : x);
  }
  return text + ")";
}

std::string positionOf(const Surface& surface, std::uint32_t vertex)
{
  return position(surface.lattice, surface.vertices[vertex]);
}

const char* lineBreak(const std::string& text)
{
  return text.empty() ? "" : "\n";
}

// The first few of these boxes, as text to append.
std::string places(const Boxes& boxes, const std::vector<std::uint32_t>& which)
{
  constexpr std::size_t MostPlaces = 5;
  std::string text;
  for (std::size_t i = 0; i < std::min(which.size(), MostPlaces); ++i)
  {
    const Box box = boxes.box(which[i]);
    const auto& global = boxes.globalOf(box).index;
    text += "\n  in global box " + std::to_string(global[0]) + ", " + std::to_string(global[1]) +
      ", " + std::to_string(global[2]) + ", from " + position(boxes.lattice, box.low) + " to " +
      position(boxes.lattice, box.high);
  }
  return text;
}

// The holes that are left, as text to append.
std::string describeLeaks(const PreparedSurface& prepared)
{
  constexpr std::size_t MostPlaces = 5;
  const std::vector<Hole>& holes = prepared.repair.holes;
  const std::size_t leaks = prepared.repair.leaks();
  if (leaks == 0)
  {
    return "";
  }
  std::string text = "\n" + std::to_string(leaks) +
    " holes are wider than a box; lids close them, of boundary " + std::to_string(NoBoundary) + ":";
  std::size_t places = 0;
  for (const Hole& hole : holes)
  {
    if (hole.leak && places++ < MostPlaces)
    {
      text += "\n  hole " + number(hole.width * prepared.surface.lattice.step()) + " wide, of " +
        std::to_string(hole.rim.size()) + " edges, from " +
        positionOf(prepared.surface, hole.rim[0]) + " to " +
        positionOf(prepared.surface, hole.rim[hole.rim.size() / 2]);
    }
  }
  return text;
}

void checkRatio(double ratio)
{
  if (!(ratio >= 0 && ratio < 1))
  {
    throw Error(Fault::BadParameter,
      "Small Cell Ratio is " + number(ratio) + ": it must be from 0 to less than 1.");
  }
}

}

void planStages(const CellSpec& spec, Execution& execution)
{
  execution.leaveOut(spec.collapseRatio > 0 ? AfterShortEdges : AfterCells,
    shapesCells(spec) ? AfterShortEdges : AfterShaping);
}

PreparedSurface prepareSurface(const SurfaceView& view, const GridSpec& grid, double memoryLimit,
  Execution& execution, int parts)
{
  execution.stage("Scaling and Dual Levels", 0, AfterSurface);
  PreparedSurface prepared;
  prepared.bounds = boundsOf(view);
  const Lattice lattice(domainOf(grid, prepared.bounds));
  checkGrid(grid, prepared.bounds, memoryLimit);
  prepared.planes = onLattice(grid, prepared.bounds, lattice);
  prepared.surface = onLattice(view, lattice, execution);
  prepared.memoryLimit = memoryLimit;
  MeshEstimate estimate = estimateMesh(prepared.surface, prepared.planes);
  estimate.inside /= parts;
  estimate.intersected /= parts;
  checkMemory(estimate, memoryLimit);
  prepared.trianglesGiven = prepared.surface.triangles.size();
  prepared.repair = repair(prepared.surface, prepared.planes, execution);
  return prepared;
}

std::string describeFlaws(const PreparedSurface& prepared, const std::vector<Id>& cells)
{
  const SurfaceRepair& repair = prepared.repair;
  const SurfaceCheck& check = repair.check;
  std::string text;
  if (!check.places.empty())
  {
    text = "The surface has " + std::to_string(check.openEdges) + " open edges, " +
      std::to_string(check.nonManifoldEdges) + " edges of more than two triangles and " +
      std::to_string(check.inconsistentEdges) + " inconsistently oriented edges:";
  }
  for (const SurfaceCheck::FlawedEdge& place : check.places)
  {
    text += std::string("\n  ") + place.what + " edge from " +
      positionOf(prepared.surface, place.edge[0]) + " to " +
      positionOf(prepared.surface, place.edge[1]) + " of cell " +
      std::to_string(cells[place.triangle]);
  }
  if (!repair.duplicates.empty())
  {
    text += lineBreak(text) + std::to_string(repair.duplicates.size()) +
      " triangles were there before, and are left out.";
  }
  if (!repair.loose.empty())
  {
    text += lineBreak(text) + std::to_string(repair.loose.size()) +
      " triangles share no edge with others, and are left out.";
  }
  if (const std::size_t closed = repair.holes.size() - repair.leaks())
  {
    text += lineBreak(text) + std::to_string(closed) + " holes narrower than a box were closed.";
  }
  return text + describeLeaks(prepared);
}

std::string describeOverhang(const PreparedSurface& prepared)
{
  std::string text;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto& planes = prepared.planes[axis];
    const Lattice& lattice = prepared.surface.lattice;
    if (lattice.vertex(axis, prepared.bounds.low[axis]) < planes.front() ||
      lattice.vertex(axis, prepared.bounds.high[axis]) > planes.back())
    {
      text += std::string(text.empty() ? "" : " ") + "The surface reaches beyond the Meshlines " +
        "XYZ"[axis] + ", which cut the mesh off there.";
    }
  }
  return text;
}

BoxedSurface boxSurface(
  const PreparedSurface& prepared, const RefinementSpec& spec, Execution& execution)
{
  execution.stage("Boxes", AfterSurface, AfterBoxes);
  Decomposition decomposition(
    prepared.surface, prepared.planes, spec, prepared.memoryLimit, {}, execution);
  Boxes boxes = decomposition.boxes(decomposition.allLayers(), execution);
  return { std::move(boxes), decomposition.takeShoeboxes(), decomposition.warnings() };
}

Assembly::Assembly(
  const Boxes& boxes, const Patches& patches, const CellSpec& spec, Execution& execution)
  : boxes_(boxes)
  , patches_(&patches)
  , smallCellRatio_(spec.smallCellRatio)
{
  checkRatio(spec.smallCellRatio);
  if (spec.boundaryRatios)
  {
    for (const BoundaryRatio& own : *spec.boundaryRatios)
    {
      checkRatio(own.ratio);
    }
  }
  if (!(spec.refusedCellRatio >= 0))
  {
    throw Error(Fault::BadParameter,
      "Refused Cell Ratio is " + number(spec.refusedCellRatio) + ": it must not be negative.");
  }
  if (!(spec.collapseRatio >= 0 && spec.collapseRatio <= MostCollapseRatio))
  {
    throw Error(Fault::BadParameter,
      "Collapse Ratio is " + number(spec.collapseRatio) + ": it must be from 0 to " +
        number(MostCollapseRatio) + ".");
  }
  execution.stage("Common sides of boxes", AfterPatches, AfterSides);
  sides_ = findSides(boxes, execution);
  std::vector<std::uint8_t> flawed = findFlawed(execution);
  rebuildFlawed(flawed, execution);
  if (spec.collapseRatio > 0)
  {
    collapse(flawed, spec, execution);
  }
  else
  {
    cells_ = assemble(spec, execution);
  }
  if (shapesCells(spec))
  {
    execution.stage("Shaping of cells", AfterShortEdges, AfterShaping);
    shaping_ = shapeCells(boxes, *patches_, sides_, nodes_, inner_, cells_, spec, execution);
  }
  execution.stage("Numbering", AfterShaping, AfterNumbering);
  mesh_ = std::make_unique<OutputMesh>(
    MeshParts{ boxes, *patches_, sides_, nodes_, inner_, cells_ }, execution);
  const Layers all = boxes.allLayers();
  if (mesh_->cellCount() == 0 && boxes.core.begin == all.begin && boxes.core.end == all.end)
  {
    throw Error(Fault::FlawedSurface, describeNothing());
  }
}

std::string Assembly::describeNothing() const
{
  const bool onlySlivers = std::all_of(
    cells_.all.begin(), cells_.all.end() - 1, [](const Cell& cell) { return cell.sliver; });
  if (onlySlivers)
  {
    return "There is nothing to mesh: the surface encloses no volume, or is open everywhere." +
      describeFlaws();
  }
  const std::string all = "There is nothing left to mesh: all " + std::to_string(cells_.size()) +
    " cells are smaller than the Small Cell Ratio allows (" + number(smallCellRatio_) +
    " of their boxes)";
  return shaping_.refusedCellsRemoved == 0
    ? all + ". Choose a smaller ratio or a smaller Cell Size."
    : all +
      ", or of a shape that solvers refuse. Choose a smaller Cell Size, or a Refused Cell Ratio of "
      "0 to keep them.";
}

void Assembly::findInnerFaces(Execution& execution)
{
  nodes_ = findNodes(boxes_, *patches_, sides_, execution);
  execution.stage("Inner faces", AfterSides, AfterInnerFaces);
  inner_ = generateInnerFaces(boxes_, *patches_, sides_, nodes_, execution);
}

std::vector<std::uint8_t> Assembly::findFlawed(Execution& execution)
{
  findInnerFaces(execution);
  execution.stage("Cells", AfterInnerFaces, AfterCells);
  return cartesian::findFlawed(boxes_, *patches_, sides_, nodes_, inner_, execution);
}

Cells Assembly::assemble(const CellSpec& spec, Execution& execution) const
{
  return assembleCells(boxes_, *patches_, sides_, nodes_, inner_, spec, execution);
}

// Each time the boxes that still are flawed keep less.
void Assembly::rebuildFlawed(std::vector<std::uint8_t>& flawed, Execution& execution)
{
  std::vector<std::uint8_t> rebuilt(sides_.polyhedral.size());
  for (const GivenUp givenUp : { GivenUp::Nothing, GivenUp::Chords, GivenUp::Crossings })
  {
    if (std::find(flawed.begin(), flawed.end(), 1) == flawed.end())
    {
      break;
    }
    execution.stage("Flawed boxes", AfterCells, AfterCells);
    RebuiltPatches next =
      rebuildFlawedBoxes(boxes_, *patches_, sides_, nodes_, inner_, flawed, givenUp, execution);
    for (std::size_t n = 0; n < rebuilt.size(); ++n)
    {
      rebuilt[n] = rebuilt[n] | next.boxes[n];
    }
    rebuilt_ = std::move(next);
    patches_ = &rebuilt_.patches;
    flawed = findFlawed(execution);
  }
  rebuilt_.boxes.swap(rebuilt);
}

// Where the surface has a crease, a cell that was to become flat may end on its other side: without
// it the mesh would be too large. Such boxes keep their edges; returns whether there are new ones.
bool Assembly::keepTurned(std::vector<std::uint8_t>& keeps, const Cells& cells) const
{
  constexpr double RoundingLevels = 2;
  bool any = false;
  for (std::size_t n = 0; n < keeps.size(); ++n)
  {
    const Box box = boxes_.box(sides_.polyhedral[n]);
    const Vector size = minus(box.high, box.low);
    const double height = *std::min_element(size.begin(), size.end());
    const auto first = cells.all.begin();
    const bool turned = std::any_of(first + std::ptrdiff_t(cells.boxStart[n]),
      first + std::ptrdiff_t(cells.boxStart[n + 1]),
      [&](const Cell& cell) { return cell.volumeFraction * height < -RoundingLevels; });
    any = any || (turned && keeps[n] == 0);
    keeps[n] = keeps[n] | (turned ? 1 : 0);
  }
  return any;
}

// First between the seams, then across them (EdgeCollapse.h). Boxes whose faces would not close any more
// keep their edges; what changes for that changes nothing beyond the seams.
void Assembly::collapse(
  const std::vector<std::uint8_t>& flawed, const CellSpec& spec, Execution& execution)
{
  const Patches& before = *patches_;
  EdgeCollapseSpec between{ spec.collapseRatio, spec.featureAngle, isExact(before), flawed, false };
  EdgeCollapseSpec across = between;
  across.acrossSeams = true;
  execution.stage("Short edges", AfterCells, AfterShortEdges);
  patches_ = &collapsed_;
  const auto closes = [&](EdgeCollapseSpec& edges, const std::vector<std::uint8_t>& now) {
    std::transform(
      edges.keeps.begin(), edges.keeps.end(), now.begin(), edges.keeps.begin(), std::bit_or<>());
    return now == flawed;
  };
  collapsed_ = before;
  for (bool done = false; !done;)
  {
    done = true;
    if (collapseShortEdges(boxes_, sides_, between, collapsed_, nodes_, inner_, execution) > 0)
    {
      done = closes(
        between, cartesian::findFlawed(boxes_, collapsed_, sides_, nodes_, inner_, execution));
      done = !(between.exact && keepTurned(between.keeps, assemble(spec, execution))) && done;
    }
    if (done)
    {
      const std::size_t collapsed =
        collapseShortEdges(boxes_, sides_, across, collapsed_, nodes_, inner_, execution);
      cells_ = assemble(spec, execution);
      done = collapsed == 0 || closes(across, cells_.flawed);
      done = !(collapsed > 0 && across.exact && keepTurned(across.keeps, cells_)) && done;
    }
    if (!done)
    {
      collapsed_ = before;
      findInnerFaces(execution);
    }
  }
  nodes_.warped = warpedHexahedra(boxes_, sides_, nodes_, execution);
}

std::size_t Assembly::rebuiltBoxes() const
{
  std::size_t count = 0;
  for (std::size_t n = 0; n < rebuilt_.boxes.size(); ++n)
  {
    count += rebuilt_.boxes[n] && boxes_.isCore(boxes_.packed[sides_.polyhedral[n]]);
  }
  return count;
}

std::vector<std::uint32_t> Assembly::flawedBoxes() const
{
  std::vector<std::uint32_t> flawed;
  for (std::size_t n = 0; n < cells_.flawed.size(); ++n)
  {
    if (cells_.flawed[n] && boxes_.isCore(boxes_.packed[sides_.polyhedral[n]]))
    {
      flawed.push_back(sides_.polyhedral[n]);
    }
  }
  return flawed;
}

std::string Assembly::describeFlaws() const
{
  std::vector<std::uint32_t> rebuilt;
  for (std::size_t n = 0; n < rebuilt_.boxes.size(); ++n)
  {
    if (rebuilt_.boxes[n] != 0)
    {
      rebuilt.push_back(sides_.polyhedral[n]);
    }
  }
  std::string text;
  if (!rebuilt.empty())
  {
    text = "The surface does not close in or next to " + std::to_string(rebuilt.size()) +
      " boxes (parts cross or overlap); Marching Cubes made patches from the statuses there:" +
      places(boxes_, rebuilt);
  }
  if (const std::vector<std::uint32_t> flawed = flawedBoxes(); !flawed.empty())
  {
    text += lineBreak(text) + std::to_string(flawed.size()) +
      " boxes do not close even so; they are left out of the mesh:" + places(boxes_, flawed);
  }
  return text;
}

std::vector<std::pair<const char*, double>> Assembly::statistics() const
{
  const auto isInner = [](const Cells& cells, const FaceOfCell& face) {
    const bool shaped =
      face.kind() == FaceOfCell::Kind::Shaped || face.kind() == FaceOfCell::Kind::TurnedShaped;
    return face.kind() != FaceOfCell::Kind::Patch &&
      !(shaped && cells.shaped.cells[face.index][face.turned() ? 0 : 1] == None);
  };
  const std::uint32_t first = boxes_.firstBoxOf(boxes_.core.begin);
  const std::uint32_t last = boxes_.firstBoxOf(boxes_.core.end);
  double removed = 0;
  double isolated = 0;
  for (std::size_t c = 0; c < cells_.size(); ++c)
  {
    const Cell& cell = cells_.all[c];
    if (cell.box < first || cell.box >= last)
    {
      continue;
    }
    bool hasInnerFace = false;
    for (std::size_t f = cell.firstFace; f < cells_.all[c + 1].firstFace && !hasInnerFace; ++f)
    {
      hasInnerFace = isInner(cells_, cells_.faces[f]);
    }
    removed += cell.removed;
    isolated += !hasInnerFace && !cell.removed;
  }
  double hexahedra = last - first;
  const double boxes = hexahedra;
  double intersected = 0;
  double patches = 0;
  std::array<double, PatchReasons> because{};
  for (std::size_t n = 0; n < sides_.polyhedral.size(); ++n)
  {
    const bool isCore = sides_.polyhedral[n] >= first && sides_.polyhedral[n] < last;
    hexahedra -= isCore;
    const std::uint32_t box = sides_.patchBox[n];
    if (isCore && box != None)
    {
      ++intersected;
      ++because[static_cast<std::size_t>(patches_->reason[box])];
      patches += static_cast<double>(patches_->boxStart[box + 1] - patches_->boxStart[box]);
    }
  }
  const auto cells = static_cast<double>(mesh_->cellCount());
  const auto carved = static_cast<double>(shaping_.partsCarved);
  const auto refused = static_cast<double>(shaping_.refusedCellsRemoved);
  const auto boxesBecause = [&](PatchReason reason) {
    return because[static_cast<std::size_t>(reason)];
  };
  return {
    { "Cells", cells },
    { "Hexahedra", hexahedra },
    { "Polyhedra", cells - hexahedra },
    { "Points", static_cast<double>(mesh_->ownPointCount()) },
    { "BoundaryFaces", static_cast<double>(mesh_->boundary().size()) },
    { "BoxesInside", boxes - intersected },
    { "BoxesIntersected", intersected },
    { "BoxesByMarchingCubes", boxesBecause(PatchReason::MarchingCubes) },
    { "BoxesByExactFit", intersected - boxesBecause(PatchReason::MarchingCubes) },
    { "BoxesEdgeCrossedTwice", boxesBecause(PatchReason::EdgeCrossedTwice) },
    { "BoxesClosedPolyline", boxesBecause(PatchReason::ClosedPolyline) },
    { "BoxesSharpFeature", boxesBecause(PatchReason::SharpFeature) },
    { "BoxesSeveralBoundaries", boxesBecause(PatchReason::SeveralBoundaries) },
    { "BoxesNotDiscs", boxesBecause(PatchReason::NotDiscs) },
    { "BoxesRebuilt", static_cast<double>(rebuiltBoxes()) },
    { "BoxesFlawed", static_cast<double>(flawedBoxes().size()) },
    { "Patches", patches },
    { "CellsSplit", static_cast<double>(shaping_.cellsSplit) },
    { "CellsWithJoinedFaces", static_cast<double>(shaping_.cellsMended) },
    { "SmallCellsMerged", static_cast<double>(shaping_.cellsMerged) },
    { "SmallCellsRemoved", removed - carved - refused },
    { "RefusedPartsCarved", carved },
    { "RefusedCellsRemoved", refused },
    { "IsolatedCells", isolated },
    { "VoidsInsideCells", static_cast<double>(cells_.voids) },
    { "FoldsLeftOut", static_cast<double>(cells_.folds) },
    { "BoundaryAngleFailures", static_cast<double>(mesh_->failures().boundaryAngle) },
    { "InnerAngleFailures", static_cast<double>(mesh_->failures().innerAngle) },
    { "OpennessFailures", static_cast<double>(mesh_->failures().open) },
    { "VolumeFailures", static_cast<double>(mesh_->failures().negativeVolume) },
  };
}

}
