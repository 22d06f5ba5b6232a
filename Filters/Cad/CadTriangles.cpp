// SPDX-License-Identifier: BSD-3-Clause
#include "CadTriangles.h"

#include "CadEdges.h"
#include "CadFlat.h"
#include "CadGaps.h"
#include "CadMeasures.h"
#include "CadProgress.h"
#include "CadSplines.h"
#include "CadWeld.h"

#include <BRepBndLib.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <IMeshTools_Parameters.hxx>
#include <Poly_Triangulation.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <unordered_map>
#include <utility>

namespace cartesian
{

namespace
{

// Without one that is asked for: of the longest side of all parts' box.
constexpr double DeflectionOfSize = 1e-3;

// A part with open edges or faces without triangles is tried again so often, each time with half the deflection.
constexpr int MostTries = 3;

TopoDS_Compound together(const std::vector<CadPart>& parts)
{
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  for (const CadPart& part : parts)
  {
    BRep_Builder().Add(all, part.shape);
  }
  return all;
}

double longestSide(const TopoDS_Shape& shape)
{
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  if (box.IsVoid())
  {
    return 0;
  }
  const gp_XYZ sides = box.CornerMax().XYZ() - box.CornerMin().XYZ();
  return std::max({ sides.X(), sides.Y(), sides.Z() });
}

void mesh(
  const TopoDS_Shape& shape, double deflection, double angle, const Message_ProgressRange& progress)
{
  IMeshTools_Parameters parameters;
  parameters.Deflection = deflection;
  parameters.Angle = angle * M_PI / 180;
  parameters.InParallel = Standard_True;
  // Without inner points it is four times as fast, and far off.
  parameters.InternalVerticesMode = Standard_True;
  BRepMesh_IncrementalMesh(shape, parameters, progress);
}

std::string numberText(double x)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.6g", x);
  return text.data();
}

// Signed, of six times the tetrahedron to the origin.
double determinant(const gp_XYZ& a, const gp_XYZ& b, const gp_XYZ& c)
{
  return a.Dot(b.Crossed(c));
}

class Triangulation
{
public:
  Triangulation(CadWeld& weld, const CadPart& part, const TopoDS_Shape& exact,
    const std::vector<std::int32_t>& boundary, double unit)
    : weld_(weld)
    , part_(part)
    , exact_(exact)
    , unit_(unit)
  {
    solid_.name = part.name;
    solid_.isOpenBody = part.shape.ShapeType() == TopAbs_SOLID ? 0 : 1;
    addFaces(boundary);
    addLines(boundary);
    solid_.openEdges = countOpen();
    if (!solid_.points.empty())
    {
      measure();
    }
  }

  CadSolid& solid() { return solid_; }
  // Faces without triangles, by their numbers in the part.
  const std::vector<int>& lacking() const { return lacking_; }

private:
  std::int64_t local(std::int64_t node)
  {
    const auto [place, isNew] = numbers_.emplace(node, static_cast<std::int64_t>(numbers_.size()));
    if (isNew)
    {
      const gp_Pnt& point = weld_.points()[static_cast<std::size_t>(node)];
      for (const double x : { point.X(), point.Y(), point.Z() })
      {
        solid_.points.push_back(x / unit_);
      }
    }
    return place->second;
  }

  void addFaces(const std::vector<std::int32_t>& boundary)
  {
    const TopTools_IndexedMapOfShape faces = facesOf(part_.shape);
    for (int i = 1; i <= faces.Extent(); ++i)
    {
      if (!addFace(TopoDS::Face(faces(i)), boundary[static_cast<std::size_t>(i - 1)]))
      {
        lacking_.push_back(i);
      }
    }
  }

  // False if it has no triangles.
  bool addFace(const TopoDS_Face& face, std::int32_t boundary)
  {
    TopLoc_Location place;
    const Handle(Poly_Triangulation) triangles = BRep_Tool::Triangulation(face, place);
    const std::vector<std::int64_t> nodes = weld_.nodesOf(face);
    const bool isTurned =
      (face.Orientation() == TopAbs_REVERSED) != place.Transformation().IsNegative();
    for (int t = 1; !nodes.empty() && t <= triangles->NbTriangles(); ++t)
    {
      std::array<int, 3> corners;
      triangles->Triangle(t).Get(corners[0], corners[1], corners[2]);
      if (isTurned)
      {
        std::swap(corners[1], corners[2]);
      }
      std::array<std::int64_t, 3> of;
      for (std::size_t c = 0; c < 3; ++c)
      {
        of[c] = nodes[static_cast<std::size_t>(corners[c] - 1)];
      }
      if (of[0] == of[1] || of[1] == of[2] || of[2] == of[0])
      {
        continue; // at a pole
      }
      for (const std::int64_t node : of)
      {
        solid_.triangles.push_back(local(node));
      }
      solid_.boundary.push_back(boundary);
    }
    return !nodes.empty() && triangles->NbTriangles() > 0;
  }

  void addLines(const std::vector<std::int32_t>& boundary)
  {
    const CadEdges edges(part_.shape);
    const TopTools_IndexedMapOfShape faces = facesOf(part_.shape);
    TopTools_IndexedMapOfShape known;
    for (int i = 1; i <= faces.Extent(); ++i)
    {
      for (TopExp_Explorer edge(faces(i), TopAbs_EDGE); edge.More(); edge.Next())
      {
        const int before = known.Extent();
        if (known.Add(edge.Current()) > before)
        {
          addLine(edges, edge.Current(), boundary[static_cast<std::size_t>(i - 1)]);
        }
      }
    }
  }

  void addLine(const CadEdges& edges, const TopoDS_Shape& edge, std::int32_t boundary)
  {
    const CadWeld::Line* const line = weld_.lineOf(edge);
    for (std::size_t i = 0; line && i + 1 < line->points.size(); ++i)
    {
      if (line->points[i] != line->points[i + 1] &&
        edges.isSharpAt(edge, (line->parameters[i] + line->parameters[i + 1]) / 2))
      {
        solid_.lines.push_back(local(line->points[i]));
        solid_.lines.push_back(local(line->points[i + 1]));
        solid_.boundaryOfLine.push_back(boundary);
      }
    }
  }

  // Edges that triangles do not pass alike in both directions.
  std::int32_t countOpen() const
  {
    std::vector<std::pair<std::int64_t, std::int64_t>> uses;
    std::vector<std::int64_t> const& t = solid_.triangles;
    for (std::size_t i = 0; i < t.size(); ++i)
    {
      const std::int64_t a = t[i];
      const std::int64_t b = t[i % 3 == 2 ? i - 2 : i + 1];
      uses.emplace_back(2 * std::min(a, b) + (a > b), std::max(a, b));
    }
    const auto edgeOf = [](const auto& use) { return std::make_pair(use.first / 2, use.second); };
    std::sort(uses.begin(), uses.end(),
      [&](const auto& a, const auto& b) { return edgeOf(a) < edgeOf(b); });
    std::int32_t open = 0;
    for (std::size_t i = 0; i < uses.size();)
    {
      int sum = 0;
      const auto edge = edgeOf(uses[i]);
      for (; i < uses.size() && edgeOf(uses[i]) == edge; ++i)
      {
        sum += uses[i].first % 2 == 0 ? 1 : -1;
      }
      open += sum != 0;
    }
    return open;
  }

  void measure()
  {
    for (std::size_t i = 0; i < solid_.triangles.size(); i += 3)
    {
      const gp_XYZ origin(solid_.points[0], solid_.points[1], solid_.points[2]);
      solid_.volumeOfTriangles +=
        determinant(at(i) - origin, at(i + 1) - origin, at(i + 2) - origin) / 6;
    }
    if (isTessellated(part_.shape))
    {
      measureTriangles();
      return;
    }
    solid_.area = areaOf(exact_) / (unit_ * unit_);
    if (part_.shape.ShapeType() != TopAbs_SOLID)
    {
      return;
    }
    const CadVolume exact = volumeOf(exact_);
    solid_.volume = exact.isCertain ? std::abs(exact.value) / (unit_ * unit_ * unit_) : 0;
    if (exact.value < 0)
    {
      turnOver();
    }
  }

  // Which are all that there is.
  void measureTriangles()
  {
    solid_.knowsEdges = 0;
    for (std::size_t i = 0; i < solid_.triangles.size(); i += 3)
    {
      solid_.area += ((at(i + 1) - at(i)) ^ (at(i + 2) - at(i))).Modulus() / 2;
    }
    if (solid_.volumeOfTriangles < 0)
    {
      turnOver();
    }
    solid_.volume = solid_.openEdges == 0 ? solid_.volumeOfTriangles : 0;
  }

  // A triangle's corner.
  gp_XYZ at(std::size_t corner) const
  {
    const double* p = solid_.points.data() + 3 * solid_.triangles[corner];
    return { p[0], p[1], p[2] };
  }

  // A solid that the file has inside out.
  void turnOver()
  {
    solid_.volumeOfTriangles = -solid_.volumeOfTriangles;
    for (std::size_t i = 0; i < solid_.triangles.size(); i += 3)
    {
      std::swap(solid_.triangles[i + 1], solid_.triangles[i + 2]);
    }
  }

  CadWeld& weld_;
  const CadPart& part_;
  const TopoDS_Shape& exact_; // to measure: the same, before its surfaces became B-splines
  double unit_;
  CadSolid solid_;
  std::unordered_map<std::int64_t, std::int64_t> numbers_; // of points, in this solid
  std::vector<int> lacking_;
};

// Triangles of all parts.
struct Attempt
{
  std::vector<CadPart> parts; // of which they are
  std::vector<CadSolid> solids;
  std::vector<std::vector<int>> lacking; // faces of each part that have no triangles
  std::vector<bool> isFlawed;            // of each part
  double deflection = 0;                 // in the unit of the result
  // Faces without triangles, edges that are open though those of the shapes are not, wrong volumes.
  int flaws = 0;
};

// Whether triangles enclose as much as a closed shape, except for what they may cut off. True if it is not known how much.
bool enclosesAll(const CadSolid& solid, double deflection)
{
  return solid.volume == 0 ||
    std::abs(solid.volumeOfTriangles - solid.volume) <= 2 * solid.area * deflection;
}

// `deflection`: in the unit of the result.
Attempt weldAll(const std::vector<CadPart>& tried, const std::vector<CadPart>& exact,
  const CadBoundaries& boundaries, const CadOptions& options, double deflection)
{
  Attempt attempt;
  attempt.parts = tried;
  attempt.deflection = deflection;
  CadWeld weld;
  for (std::size_t p = 0; p < tried.size(); ++p)
  {
    Triangulation triangulation(weld, tried[p], exact[p].shape, boundaries.ofFace[p], options.unit);
    const bool isClosed = freeEdges(tried[p].shape).IsEmpty();
    const int flaws = static_cast<int>(triangulation.lacking().size()) +
      (isClosed ? triangulation.solid().openEdges : 0) +
      (isClosed && !enclosesAll(triangulation.solid(), deflection));
    attempt.flaws += flaws;
    attempt.isFlawed.push_back(flaws > 0);
    attempt.lacking.push_back(triangulation.lacking());
    attempt.solids.push_back(std::move(triangulation.solid()));
  }
  return attempt;
}

// Where faces have no triangles, and the surface is open because of them.
void refuseDamaged(
  const std::vector<CadPart>& parts, const Attempt& attempt, const CadOptions& options)
{
  for (std::size_t p = 0; p < parts.size() && !options.keepsDamaged; ++p)
  {
    const CadSolid& solid = attempt.solids[p];
    const bool isWhole = !freeEdges(parts[p].shape).IsEmpty() || solid.openEdges == 0;
    if (isWhole)
    {
      continue;
    }
    const std::string what =
      " of " + solid.name + " (" + std::to_string(parts[p].faces.size()) + " faces) ";
    const std::string where = attempt.lacking[p].empty()
      ? "has faces" + what + "whose triangles do not meet, at " +
        placeOf(parts[p].shape, options.unit)
      : "has a face of which no triangles can be made: number " +
        std::to_string(attempt.lacking[p].front()) + what + "at " +
        placeOf(facesOf(parts[p].shape)(attempt.lacking[p].front()), options.unit);
    throw CadError(where + ". " + std::to_string(solid.openEdges) +
      " edges stay open there. Export the part again, or in another format; or switch on Keep "
      "Damaged Faces to "
      "take it as it is.");
  }
}

// Which faces are flat now, by number in their parts.
void tellFlat(const std::vector<CadPart>& parts, const std::vector<std::vector<int>>& faces,
  const std::vector<std::vector<bool>>& isFlat, const CadOptions& options, const CadReport& report)
{
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    for (std::size_t i = 0; i < faces[p].size(); ++i)
    {
      if (isFlat[p][i])
      {
        report.note(
          "Made flat between its edges, as no triangles can be made of it otherwise: face " +
          std::to_string(faces[p][i]) + " of " + parts[p].name + " at " +
          placeOf(facesOf(parts[p].shape)(faces[p][i]), options.unit) + ".");
      }
    }
  }
}

std::string adviceFor(const CadPart& open, const CadOptions& options)
{
  const double gap = widestGap(open.shape) / options.unit;
  if (gap > 0)
  {
    return "Gaps of up to " + numberText(gap) +
      " are between its faces: set a larger Heal Tolerance, or export the part as a solid.";
  }
  return open.shape.ShapeType() == TopAbs_SOLID
    ? "There are no gaps to close: a face is missing. Export the part again."
    : "There are no gaps to close: it is a sheet. If it is meant, it can be a boundary of type "
      "baffle; else export the part as a solid.";
}

// What the user must know of a part.
void tell(const CadPart& part, const CadSolid& solid, double deflection, const CadOptions& options,
  const CadReport& report)
{
  const std::string where = solid.name + " at " + placeOf(part.shape, options.unit);
  const int free = freeEdges(part.shape).Extent();
  if (free > 0)
  {
    report.warning(where + " is open: " + std::to_string(free) +
      " edges bound one face only, so it encloses nothing. " + adviceFor(part, options));
  }
  else if (solid.openEdges > 0)
  {
    report.warning(where +
      " is closed, but its triangles are not: " + std::to_string(solid.openEdges) +
      " of their edges are open: faces are damaged. Export the part again, or in another format.");
  }
  if (free == 0 && solid.volume == 0)
  {
    report.note("The exact volume of " + where +
      " is not known: two ways to integrate it disagree, so the triangles cannot be compared with "
      "it.");
  }
  if (free == 0 && !enclosesAll(solid, deflection))
  {
    report.warning("The triangles of " + where + " enclose " + numberText(solid.volumeOfTriangles) +
      ", the exact shape " + numberText(solid.volume) +
      ": a face is wrong. Choose a smaller Deflection, or export the part again.");
  }
}

// Parts of damaged files.
void dropEmpty(std::vector<CadSolid>& solids, const CadReport& report)
{
  for (const CadSolid& solid : solids)
  {
    if (solid.triangles.empty())
    {
      report.warning(
        solid.name + " is left out: none of its faces can be triangulated. Export the part again.");
    }
  }
  const auto isEmpty = [](const CadSolid& solid) { return solid.triangles.empty(); };
  solids.erase(std::remove_if(solids.begin(), solids.end(), isEmpty), solids.end());
  if (solids.empty())
  {
    throw CadError("holds no face that can be triangulated. Export the part again.");
  }
}

}

std::vector<CadSolid> trianglesOf(const std::vector<CadPart>& parts,
  const CadBoundaries& boundaries, const CadOptions& options, const CadReport& report)
{
  Attempt attempt = weldAll(parts, parts, boundaries, options, 0);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    const CadSolid& solid = attempt.solids[p];
    if (solid.openEdges > 0)
    {
      report.warning(solid.name + " at " + placeOf(parts[p].shape, options.unit) +
        " is open: triangles are all that the file has of it, and " +
        std::to_string(solid.openEdges) +
        " of their edges have no neighbour. Export the exact shape (BREP) instead of a tessellated "
        "one.");
    }
  }
  return std::move(attempt.solids);
}

double deflectionOf(const std::vector<CadPart>& parts, const CadOptions& options)
{
  return options.deflection > 0 ? options.deflection
                                : DeflectionOfSize * longestSide(together(parts)) / options.unit;
}

int gapsOf(const CadPart& part, double deflection, const CadOptions& options)
{
  CadPart copy = part;
  copy.shape = BRepBuilderAPI_Copy(part.shape, Standard_False).Shape();
  mesh(copy.shape, deflection * options.unit, options.angle, Message_ProgressRange());
  CadWeld weld;
  Triangulation triangulation(
    weld, copy, copy.shape, std::vector<std::int32_t>(copy.faces.size()), options.unit);
  return static_cast<int>(triangulation.lacking().size()) + triangulation.solid().openEdges;
}

std::vector<CadSolid> triangulate(const std::vector<CadPart>& parts,
  const CadBoundaries& boundaries, const CadOptions& options, const CadReport& report)
{
  // In the unit of the result: given back as an option, it makes the same triangles, bit for bit.
  const double asked = deflectionOf(parts, options);
  if (!(asked > 0))
  {
    throw CadError("holds shapes without extent only. Export the part again.");
  }
  Attempt best;
  // Measures what is `exact`. Whether it is the best so far.
  const auto attempt = [&](const std::vector<CadPart>& tried, const std::vector<CadPart>& exact,
                         double deflection) {
    const TopoDS_Compound all = together(tried);
    BRepTools::Clean(all); // of triangles that came with the file, or were made before
    const Handle(CadProgress) progress = new CadProgress(report, 0.7, 0.95);
    mesh(all, deflection * options.unit, options.angle, progress->Start());
    Attempt made = weldAll(tried, exact, boundaries, options, deflection);
    const bool isBest = best.solids.empty() || made.flaws < best.flaws;
    if (isBest)
    {
      best = std::move(made);
    }
    return isBest;
  };
  for (int i = 0; i < MostTries && (i == 0 || best.flaws > 0); ++i)
  {
    attempt(parts, parts, std::ldexp(asked, -i));
  }
  if (best.flaws > 0)
  {
    if (const std::vector<CadPart> splines = asSplines(parts, best.isFlawed); !splines.empty())
    {
      attempt(splines, parts, asked);
    }
  }
  const std::vector<std::vector<int>> lacking = best.lacking;
  const double distance = asked * options.unit;
  std::vector<std::vector<bool>> isFlat;
  const std::vector<CadPart> flat = withFlatFaces(parts, lacking, distance, isFlat);
  if (!flat.empty() && attempt(withFlatFaces(best.parts, lacking, distance, isFlat), flat, asked))
  {
    tellFlat(parts, lacking, isFlat, options, report);
  }
  refuseDamaged(parts, best, options);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    tell(parts[p], best.solids[p], best.deflection, options, report);
    best.solids[p].deflection = asked;
  }
  dropEmpty(best.solids, report);
  return std::move(best.solids);
}

}
