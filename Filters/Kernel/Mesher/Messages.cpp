// SPDX-License-Identifier: BSD-3-Clause
#include "Mesher/Messages.h"

#include "Base/Words.h"
#include "Boxes/Boxes.h"
#include "Mesher/CellsLeftOut.h"
#include "Surface/Places.h"
#include "Surface/SurfaceEdges.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace cartesian
{

namespace
{

// A warning is given if more than this part of a mesh's volume is left out.
constexpr double LargestLossUntold = 1e-3;

// Of what is left out at rims of thin things, from here on: boxes.
constexpr double LeastAtRimsTold = 0.1;

// Planes are shifted by a few levels: values next to 0 are written as 0.
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

// "1 hole" or "3 holes".
std::string counted(std::size_t count, const char* one, const char* several)
{
  return std::to_string(count) + " " + (count == 1 ? one : several);
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
  std::string text = "\n" +
    counted(leaks, "hole is wider than a box and is closed by a lid",
      "holes are wider than a box and are closed by lids") +
    " of boundary " + std::to_string(NoBoundary) +
    ". Close Gaps, as large as they are wide, gives lids names. If they should be closed "
    "otherwise, "
    "repair the surface:";
  std::size_t places = 0;
  for (const Hole& hole : holes)
  {
    if (hole.leak && places++ < MostPlaces)
    {
      text += "\n  hole " + number(hole.width * prepared.surface.lattice.step()) + " wide, of " +
        std::to_string(hole.rim.size()) + " edges, from " +
        positionOf(prepared.inspected(), hole.rim[0]) + " to " +
        positionOf(prepared.inspected(), hole.rim[hole.rim.size() / 2]);
    }
  }
  return text;
}

std::string describeCracks(const PreparedSurface& prepared)
{
  const std::vector<JoinedCracks::Edge>& joined = prepared.cracks.joined;
  if (joined.empty())
  {
    return "";
  }
  const auto widest = std::max_element(
    joined.begin(), joined.end(), [](const auto& a, const auto& b) { return a.width < b.width; });
  return counted(joined.size(), "pair of open edges along each other was joined",
           "pairs of open edges along each other were joined") +
    ": cracks at most " + number(widest->width * prepared.surface.lattice.step()) + " wide, near " +
    placeOf(prepared.surface, widest->ends[0]) + ".";
}

std::string describeContacts(const PreparedSurface& prepared)
{
  const double step = prepared.surface.lattice.step();
  std::string text;
  for (const ClosedContact& contact : prepared.contacts)
  {
    text += std::string(lineBreak(text)) + "Walls of regions " + contact.names[0] + " and " +
      contact.names[1] + " at most " + number(contact.width * step) + " apart became one: region " +
      contact.names[1] + " got about " + number(contact.closed * step * step * step) +
      " of volume in gaps and lost about " + number(contact.taken * step * step * step) +
      " where both overlapped.";
  }
  return text;
}

std::string describeRefused(const PreparedSurface& prepared)
{
  constexpr std::size_t MostPlaces = 5;
  const std::vector<Vector>& refused = prepared.repair.refused;
  if (refused.empty())
  {
    return "";
  }
  std::string text = counted(refused.size(), "group of bodies that cross or touch was not united",
                       "groups of bodies that cross or touch were not united") +
    ": in nearly coplanar faces it is uncertain what lies on which side. Unite them beforehand, "
    "move them apart, or "
    "let them overlap by more, if the mesh shows flaws near";
  for (std::size_t i = 0; i < std::min(refused.size(), MostPlaces); ++i)
  {
    text += (i > 0 ? ", " : " ") + placeOf(prepared.surface, refused[i]);
  }
  return text + (refused.size() > MostPlaces ? ", ..." : ".");
}

// The first of some triangles that are left out, as text to append.
std::string firstOf(const std::vector<DroppedTriangle>& triangles, const Surface& surface,
  const std::vector<Id>& cells)
{
  const DroppedTriangle& first = triangles.front();
  Vector middle{ 0, 0, 0 };
  for (const std::uint32_t v : first.vertices)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      middle[axis] += double(surface.vertices[v][axis]) / 3;
    }
  }
  return (triangles.size() == 1 ? ": " : ", such as ") +
    nameOfCell(cells[surface.given[first.triangle]]) + " at " + placeOf(surface, middle) + ".";
}

// Of walls, on either side, or of the triangles of one region.
std::set<std::int32_t> boundariesOf(const Surface& surface)
{
  std::set<std::int32_t> boundaries;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    if (!namesAVertexTwice(surface.triangles[t]))
    {
      boundaries.insert(surface.walls.boundary(surface.boundary[t]));
      if (surface.walls.any())
      {
        boundaries.insert(surface.walls.boundaryInFront(surface.boundary[t]));
      }
    }
  }
  return boundaries;
}

std::string listOf(const std::vector<std::int32_t>& boundaries,
  const std::map<std::int32_t, std::string>& names, const std::string& reason)
{
  constexpr std::size_t MostNames = 30;
  if (boundaries.empty())
  {
    return "";
  }
  std::string list;
  for (std::size_t i = 0; i < std::min(boundaries.size(), MostNames); ++i)
  {
    const auto name = names.find(boundaries[i]);
    list +=
      (i == 0 ? "" : ", ") + (name == names.end() ? std::to_string(boundaries[i]) : name->second);
  }
  return counted(boundaries.size(), "boundary has", "boundaries have") + " no faces in the mesh (" +
    reason + "): " + list + (boundaries.size() > MostNames ? ", ..." : "") +
    ". Correct the surface if faces are expected there.";
}

// Boundaries without a face in the mesh, and why.
std::string describeVanished(
  const PreparedSurface& prepared, const std::map<std::int32_t, std::string>& names)
{
  const std::set<std::int32_t> left = boundariesOf(prepared.surface);
  std::map<std::int32_t, std::size_t> duplicates;
  for (const DroppedTriangle& dropped : prepared.repair.duplicates)
  {
    ++duplicates[prepared.inspected().boundary[dropped.triangle]];
  }
  std::vector<std::int32_t> doubled;
  std::vector<std::int32_t> covered;
  for (const auto& [boundary, triangles] : prepared.boundariesGiven)
  {
    if (left.count(boundary) == 0)
    {
      (duplicates[boundary] == triangles ? doubled : covered).push_back(boundary);
    }
  }
  const std::string first = listOf(doubled, names,
    "all triangles are duplicates, as in a body written twice, between touching bodies or, if "
    "Sheets is Leave Out, in a sheet");
  const std::string second =
    listOf(covered, names, "inside other bodies, on their walls, or outside the meshed space");
  return first + (first.empty() || second.empty() ? "" : "\n") + second;
}

// Open surfaces that are taken for sheets, and those that are not though they look like some.
std::string describeOpenSheets(
  const PreparedSurface& prepared, const std::map<std::int32_t, std::string>& names)
{
  constexpr std::size_t MostPlaces = 5;
  const OpenSheets& sheets = prepared.openSheets;
  const double step = prepared.surface.lattice.step();
  std::string text = sheets.boundNothing == 0
    ? ""
    : counted(sheets.boundNothing, "open surface looks like a sheet, but is",
        "open surfaces look like sheets, but are") +
      " all that there is, and so closed by lids: add the walls around, or set Domain to Outside "
      "to mesh the space around.";
  if (sheets.all.empty())
  {
    return text;
  }
  text += lineBreak(text) +
    counted(
      sheets.all.size(), "open surface is kept as a sheet", "open surfaces are kept as sheets") +
    ": both sides are walls. Set Sheets to Leave Out to close open surfaces by lids instead; the "
    "Boundary Type baffle "
    "makes sheets of a boundary in any case, and gives their backs a boundary of their own:";
  for (std::size_t i = 0; i < std::min(sheets.all.size(), MostPlaces); ++i)
  {
    const OpenSheet& sheet = sheets.all[i];
    const auto name = names.find(sheet.boundary);
    text += "\n  area " + number(sheet.area * step * step) + ", of boundary " +
      (name == names.end() ? std::to_string(sheet.boundary) : name->second) + ", near " +
      placeOf(prepared.surface, sheet.place);
  }
  return text;
}

// What of an open surface is next to the fluid.
std::string describeFluid(
  const PreparedSurface& prepared, const std::map<std::int32_t, std::string>& names)
{
  if (!prepared.fluid)
  {
    return {};
  }
  const ReachedFluid& fluid = *prepared.fluid;
  const std::string open = counted(fluid.openEdges, "open edge", "open edges");
  if (fluid.seenFrom == DomainSide::NoSide)
  {
    return "The surface has " + open +
      ", but closes around what the Keep Points reach: that is meshed. What is open elsewhere does "
      "not matter, and what has cells on both sides is a sheet.";
  }
  const auto side = static_cast<std::size_t>(fluid.seenFrom) - 1;
  const auto name = names.find(fluid.terrain);
  return "Boundary " + (name == names.end() ? std::to_string(fluid.terrain) : name->second) +
    ", with " + open + ", divides the box of the domain: what is meshed is on its side towards " +
    (side % 2 == 0 ? "-" : "+") + "xyz"[side / 2] +
    ". To mesh another part of the box, give a Keep Point there.";
}

// How many of them each boundary has, those with most first.
std::string countsByBoundary(
  const std::vector<CellLeftOut>& cells, const std::map<std::int32_t, std::string>& names)
{
  constexpr std::size_t MostBoundaries = 5;
  std::map<std::int32_t, std::size_t> counts;
  for (const CellLeftOut& cell : cells)
  {
    ++counts[cell.boundary];
  }
  std::vector<std::pair<std::int32_t, std::size_t>> order(counts.begin(), counts.end());
  std::stable_sort(
    order.begin(), order.end(), [](const auto& x, const auto& y) { return x.second > y.second; });
  std::string text;
  for (std::size_t i = 0; i < std::min(order.size(), MostBoundaries); ++i)
  {
    const auto name = names.find(order[i].first);
    text += name == names.end()
      ? ""
      : (text.empty() ? " Next to " : ", ") + name->second + ": " + std::to_string(order[i].second);
  }
  return text + (text.empty() ? "" : ".");
}

// Nothing where that hardly changes the volume.
std::string describeLeftOut(const Assembly& a, const std::map<std::int32_t, std::string>& names)
{
  constexpr double Percent = 100;
  const double share = shareLeftOut(a);
  if (share <= LargestLossUntold)
  {
    return "";
  }
  std::vector<CellLeftOut> cells = cellsLeftOut(a);
  std::stable_sort(cells.begin(), cells.end(),
    [](const CellLeftOut& x, const CellLeftOut& y) { return x.volume > y.volume; });
  std::vector<std::uint32_t> boxes;
  boxes.reserve(cells.size());
  for (const CellLeftOut& cell : cells)
  {
    boxes.push_back(cell.box);
  }
  const std::size_t refused = a.edits.overlapping.size();
  const std::size_t fragments = a.separate.fragments.size();
  return counted(cells.size(), "cell is", "cells are") + " left out, " +
    number(std::round(share * Percent * 100) / 100) + " % of the volume: " +
    std::to_string(cells.size() - std::min(cells.size(), refused + fragments)) +
    " too small to keep, " + std::to_string(refused) +
    " failing (solvers would reject them) and beyond repair, " + std::to_string(fragments) +
    " cut off from the rest by the grid." + countsByBoundary(cells, names) +
    " To keep them, use a smaller Cell Size or a larger Refinement Depth. The largest:" +
    places(a.boxes, boxes);
}

std::string describeRims(const Assembly& a)
{
  const LeftOutAtRims rims = leftOutAtRims(a);
  if (rims.boxes < LeastAtRimsTold)
  {
    return "";
  }
  const Box box = a.boxes.box(rims.largest);
  Point middle{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    middle[axis] = box.low[axis] + (box.high[axis] - box.low[axis]) / 2;
  }
  return "At rims of fins and sheets " +
    counted(rims.pieces, "piece of a cell was left out, ", "pieces of cells were left out, ") +
    number(std::round(rims.boxes * 10) / 10) + " boxes in all (the largest at " +
    position(a.boxes.lattice, middle) +
    "): solvers would reject them. Where the shape of these rims matters, use a smaller Cell Size "
    "or a larger Refinement Depth.";
}

std::string describeOverlapping(const Assembly& a)
{
  const std::vector<std::uint32_t>& overlapping = a.overlapping;
  return overlapping.empty() ? ""
                             : "No case can be written: " +
      counted(overlapping.size(), "cell overlaps another", "cells overlap others") +
      " because the surface intersects itself. Repair it there, or choose another Cell Size:" +
      places(a.boxes, overlapping);
}

std::string describeNothing(const Assembly& assembly, const Options& options)
{
  const WallMesh& wall = assembly.wall;
  const bool onlySlivers = std::all_of(
    wall.cells.begin(), wall.cells.end() - 1, [](const Cell& cell) { return cell.sliver; });
  if (onlySlivers)
  {
    const std::string flaws = describeFlaws(assembly);
    return "There is nothing to mesh: the surface encloses no volume, or is open everywhere. "
           "Connect a closed surface." +
      (flaws.empty() ? "" : "\n" + flaws);
  }
  const std::string all = "There is nothing left to mesh: all " + std::to_string(wall.size()) +
    " cells are smaller than " +
    (options.smallCells.handling == SmallCells::Merge
        ? "a tenth of Merge Ratio (" + number(options.shaping.strandedRatio())
        : "Small Cell Ratio (" + number(options.smallCells.ratio)) +
    " of the volume of their boxes)";
  return assembly.edits.overlapping.empty()
    ? all + ". Choose a smaller ratio or a smaller Cell Size."
    : all +
      ", or are failing cells, which solvers would reject. Choose a smaller Cell Size, or set "
      "Refused Cell Ratio to 0 to keep them.";
}

}

std::string describeFlaws(const PreparedSurface& prepared, const std::vector<Id>& cells,
  const std::map<std::int32_t, std::string>& names)
{
  const SurfaceRepair& repair = prepared.repair;
  const SurfaceCheck& check = repair.check;
  std::string text;
  if (!check.places.empty())
  {
    text = "The surface has " + counted(check.openEdges, "open edge", "open edges") + ", " +
      counted(check.nonManifoldEdges, "edge", "edges") + " shared by more than two triangles and " +
      counted(
        check.inconsistentEdges, "inconsistently oriented edge:", "inconsistently oriented edges:");
  }
  for (const SurfaceCheck::FlawedEdge& place : check.places)
  {
    text += std::string("\n  ") + place.what + " edge from " +
      positionOf(prepared.inspected(), place.edge[0]) + " to " +
      positionOf(prepared.inspected(), place.edge[1]) + " of " +
      nameOfCell(cells[prepared.inspected().given[place.triangle]]);
  }
  text += text.empty() ? "" : "\nRepair the surface there if the mesh shows flaws.";
  if (const std::string fluid = describeFluid(prepared, names); !fluid.empty())
  {
    text += lineBreak(text) + fluid;
  }
  if (const std::string sheets = describeOpenSheets(prepared, names); !sheets.empty())
  {
    text += lineBreak(text) + sheets;
  }
  if (!repair.duplicates.empty())
  {
    text += lineBreak(text) +
      counted(repair.duplicates.size(), "duplicate triangle is", "duplicate triangles are") +
      " left out" + firstOf(repair.duplicates, prepared.inspected(), cells);
  }
  if (const std::string vanished = describeVanished(prepared, names); !vanished.empty())
  {
    text += lineBreak(text) + vanished;
  }
  if (const std::string cracks = describeCracks(prepared); !cracks.empty())
  {
    text += lineBreak(text) + cracks;
  }
  if (const std::string contacts = describeContacts(prepared); !contacts.empty())
  {
    text += lineBreak(text) + contacts;
  }
  if (!repair.loose.empty())
  {
    text += lineBreak(text) +
      counted(repair.loose.size(), "triangle shares no edge with others and is left out",
        "triangles share no edge with others and are left out") +
      firstOf(repair.loose, prepared.inspected(), cells);
  }
  if (const std::string refused = describeRefused(prepared); !refused.empty())
  {
    text += lineBreak(text) + refused;
  }
  if (const std::size_t closed = repair.holes.size() - repair.leaks())
  {
    const auto hole = std::find_if(
      repair.holes.begin(), repair.holes.end(), [](const Hole& one) { return !one.leak; });
    text += lineBreak(text) +
      counted(
        closed, "hole narrower than a box was closed", "holes narrower than a box were closed") +
      (closed == 1 ? ": at " : ", the first at ") + positionOf(prepared.inspected(), hole->rim[0]) +
      ".";
  }
  return text + describeLeaks(prepared);
}

std::string describeOverhang(const PreparedSurface& prepared)
{
  std::string text;
  const bool isMeant = prepared.surface.around.inside();
  for (int axis = 0; !isMeant && axis < 3; ++axis)
  {
    const auto& planes = prepared.planes[axis];
    const Lattice& lattice = prepared.surface.lattice;
    if (lattice.vertex(axis, prepared.bounds.low[axis]) < planes.front() ||
      lattice.vertex(axis, prepared.bounds.high[axis]) > planes.back())
    {
      text += std::string(text.empty() ? "" : " ") + "The surface extends beyond Meshlines " +
        "XYZ"[axis] + ": the mesh is cut off there. Extend them to mesh all of it.";
    }
  }
  return text;
}

std::string describeTiny(const PreparedSurface& prepared, const Options& options)
{
  double longest = 0;
  for (int axis = 0; axis < 3; ++axis)
  {
    longest = std::max(longest, prepared.bounds.high[axis] - prepared.bounds.low[axis]);
  }
  const double smallest = std::ldexp(
    options.grid.cellSize, -std::clamp(refinementOf(options).deepest(), 0, DeepestLevel));
  if (!(longest < smallest))
  {
    return {};
  }
  return "The surface is smaller than a cell: its longest side is " + number(longest) +
    ", the smallest cells are asked to be " + number(smallest) + " (" +
    number(std::round(10 * smallest / longest) / 10) +
    " times as long). Choose a smaller Cell Size; if the surface is in another unit, correct "
    "Length Unit "
    "or Scale where it is read.";
}

std::string describeShortfall(const DomainSpec& domain, const FlowRefinement& flow)
{
  if (flow.hasAlong(domain.boxesAlong))
  {
    return {};
  }
  const double least = flow.length / domain.boxesAlong; // the requested size
  return "Boxes Along Body is " + std::to_string(domain.boxesAlong) + ", but only " +
    number(std::floor(flow.length / flow.size)) +
    " fit along the surface: boxes can be halved at most " + std::to_string(DeepestLevel) +
    " times. Choose a Cell Size of " + number(least * (1 << DeepestLevel)) +
    " or less, or closer Meshlines.";
}

std::string describeFlaws(
  const Assembly& assembly, const std::map<std::int32_t, std::string>& names)
{
  std::string text;
  const std::vector<std::uint32_t> rebuilt = rebuiltBoxes(assembly);
  if (!rebuilt.empty())
  {
    text = "The surface does not close in or next to " + counted(rebuilt.size(), "box", "boxes") +
      " (parts cross or overlap). Marching Cubes rebuilt the patches there from the inside/outside "
      "status of box corners. Repair the surface there if the mesh shows flaws:" +
      places(assembly.boxes, rebuilt);
  }
  if (const std::vector<std::uint32_t> flawed = flawedBoxes(assembly); !flawed.empty())
  {
    text += lineBreak(text) +
      counted(flawed.size(),
        "box still does not close and is left out of the mesh. Repair the surface there:",
        "boxes still do not close and are left out of the mesh. Repair the surface there:") +
      places(assembly.boxes, flawed);
  }
  const std::string leftOut = describeLeftOut(assembly, names);
  text += leftOut.empty() ? "" : lineBreak(text) + leftOut;
  const std::string rims = describeRims(assembly);
  text += rims.empty() ? "" : lineBreak(text) + rims;
  const std::string overlapping = describeOverlapping(assembly);
  text += overlapping.empty() ? "" : lineBreak(text) + overlapping;
  return text;
}

Error nothingToMesh(const Assembly& assembly, const Options& options)
{
  const auto& planes = assembly.boxes.planes;
  const bool isOneBox =
    std::all_of(planes.begin(), planes.end(), [](const auto& lines) { return lines.size() == 2; });
  if (isOneBox && options.grid.cellSize > 0)
  {
    return { Fault::BadCellSize,
      "There is nothing to mesh: Cell Size " + number(options.grid.cellSize) +
        " is larger than the surface. Choose a smaller one." };
  }
  return { Fault::FlawedSurface, describeNothing(assembly, options) };
}

}
