// SPDX-License-Identifier: BSD-3-Clause
#include "ReportPictures.h"

#include "Base/Error.h"
#include "Polyhedra/CellGeometry.h"
#include "Report/Canvas.h"

#include "vtkBase64Utilities.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cartesian
{

namespace
{

constexpr std::size_t Width = 940;
constexpr std::size_t Height = 620;

// With more, lines would be all that is seen.
constexpr std::size_t MostFacesWithEdges = 60000;

constexpr Colour EdgeColour{ 0.25, 0.25, 0.25 };
constexpr Colour CutColour{ 0.86, 0.88, 0.92 };
constexpr Colour Red{ 0.85, 0.1, 0.1 };
constexpr Vector FromCorner{ 0.8, -1, 0.7 };

// Of the size of bodies: what is seen of the domain around them.
constexpr double AroundBodies = 1.2;
constexpr double AroundCut = 1.8;

std::string inBase64(const std::vector<unsigned char>& bytes)
{
  std::string text(bytes.size() / 3 * 4 + 8, '\0');
  const auto size = vtkBase64Utilities::Encode(bytes.data(),
    static_cast<unsigned long>(bytes.size()), reinterpret_cast<unsigned char*>(text.data()));
  text.resize(size);
  return text;
}

std::string pngOf(const Canvas& canvas)
{
  const std::vector<std::uint8_t> pixels = canvas.pixels();
  vtkNew<vtkImageData> image;
  image->SetDimensions(static_cast<int>(canvas.width()), static_cast<int>(canvas.height()), 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  auto* scalars = static_cast<unsigned char*>(image->GetScalarPointer());
  const std::size_t row = 3 * canvas.width();
  for (std::size_t y = 0; y < canvas.height(); ++y) // VTK's first row is the lowest
  {
    std::copy_n(&pixels[y * row], row, scalars + (canvas.height() - 1 - y) * row);
  }
  vtkNew<vtkPNGWriter> writer;
  writer->WriteToMemoryOn();
  writer->SetInputData(image);
  writer->Write();
  vtkUnsignedCharArray* bytes = writer->GetResult();
  return inBase64({ bytes->GetPointer(0), bytes->GetPointer(0) + bytes->GetNumberOfValues() });
}

Vector pointOf(const DrawnMesh& mesh, std::uint32_t point)
{
  const double* p = mesh.points + 3 * static_cast<std::size_t>(point);
  return { p[0], p[1], p[2] };
}

// `face`: of the cells.
std::vector<Vector> polygonOf(const DrawnMesh& mesh, std::size_t face)
{
  std::vector<Vector> polygon;
  for (std::size_t i = mesh.cells.firstCorner[face]; i < mesh.cells.firstCorner[face + 1]; ++i)
  {
    polygon.push_back(pointOf(mesh, mesh.cells.corners[i]));
  }
  return polygon;
}

// Of the box around a cell.
Vector middleOf(const DrawnMesh& mesh, std::size_t cell)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Vector low{ Infinity, Infinity, Infinity };
  Vector high = scaled(low, -1);
  for (std::size_t i = mesh.cells.firstCorner[mesh.cells.firstFace[cell]];
       i < mesh.cells.firstCorner[mesh.cells.firstFace[cell + 1]]; ++i)
  {
    const Vector at = pointOf(mesh, mesh.cells.corners[i]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      low[axis] = std::min(low[axis], at[axis]);
      high[axis] = std::max(high[axis], at[axis]);
    }
  }
  return scaled(plus(low, high), 0.5);
}

// Faces, filled first: edges are hidden by all of them.
struct DrawnFace
{
  std::size_t face; // of the cells
  Colour colour;
};

struct Box
{
  explicit Box(const std::vector<Vector>& points)
    : low(points.front())
    , high(points.front())
  {
    for (const Vector& point : points)
    {
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
    }
  }

  Vector middle() const { return scaled(plus(low, high), 0.5); }

  // Of the box made larger around its middle.
  std::vector<Vector> corners(double factor) const
  {
    std::vector<Vector> result;
    for (std::size_t corner = 0; corner < 8; ++corner)
    {
      Vector at = middle();
      for (std::size_t axis = 0; axis < 3; ++axis)
      {
        at[axis] += (corner >> axis & 1U ? factor : -factor) * (high[axis] - low[axis]) / 2;
      }
      result.push_back(at);
    }
    return result;
  }

  Vector low;
  Vector high;
};

std::vector<Vector> pointsOf(const DrawnMesh& mesh, const std::vector<DrawnFace>& drawn)
{
  std::vector<Vector> points;
  for (const DrawnFace& face : drawn)
  {
    const std::vector<Vector> polygon = polygonOf(mesh, face.face);
    points.insert(points.end(), polygon.begin(), polygon.end());
  }
  return points;
}

// Of a mesh around bodies: the points of its boundary that are not on the sides of the domain; or none.
std::vector<Vector> pointsOfBodies(const DrawnMesh& mesh)
{
  std::vector<DrawnFace> boundary;
  for (std::size_t f = mesh.faces.neighbour.size(); mesh.flow && f < mesh.faces.face.size(); ++f)
  {
    boundary.push_back({ mesh.faces.face[f], {} });
  }
  std::vector<Vector> points = pointsOf(mesh, boundary);
  if (points.empty())
  {
    return points;
  }
  const Box domain(points);
  points.erase(std::remove_if(points.begin(), points.end(),
                 [&](const Vector& point) {
                   bool isOnSide = false;
                   for (std::size_t axis = 0; axis < 3; ++axis)
                   {
                     isOnSide = isOnSide || point[axis] == domain.low[axis] ||
                       point[axis] == domain.high[axis];
                   }
                   return isOnSide;
                 }),
    points.end());
  return points;
}

// Sees all that is drawn; of a mesh around bodies, these and `around` times their size.
Canvas canvasFor(
  const DrawnMesh& mesh, const std::vector<DrawnFace>& drawn, const Vector& towards, double around)
{
  const std::vector<Vector> bodies = pointsOfBodies(mesh);
  return { Width, Height, bodies.empty() ? pointsOf(mesh, drawn) : Box(bodies).corners(around),
    towards };
}

void draw(const DrawnMesh& mesh, const std::vector<DrawnFace>& drawn, Canvas& canvas)
{
  for (const DrawnFace& face : drawn)
  {
    canvas.fill(polygonOf(mesh, face.face), face.colour);
  }
  for (std::size_t i = 0; drawn.size() <= MostFacesWithEdges && i < drawn.size(); ++i)
  {
    canvas.outline(polygonOf(mesh, drawn[i].face), EdgeColour);
  }
}

// As seen from there: around bodies without the sides of the domain that would hide them.
std::vector<DrawnFace> boundaryOf(const DrawnMesh& mesh, const Vector& towards)
{
  std::vector<DrawnFace> drawn;
  const std::size_t inner = mesh.faces.neighbour.size();
  for (std::size_t f = inner; f < mesh.faces.face.size(); ++f)
  {
    const std::vector<Vector> polygon = polygonOf(mesh, mesh.faces.face[f]);
    const auto corner = [&](std::size_t i) { return polygon[i]; };
    if (!mesh.flow || dot(measureFace(polygon.size(), corner).area, towards) <= 0)
    {
      drawn.push_back({ mesh.faces.face[f], mesh.colours[f - inner] });
    }
  }
  return drawn;
}

struct Cut
{
  std::size_t axis;
  double at;
};

// Across the most material: of planes along each axis, nearer to the middle where others are not much better.
class CutSearch
{
public:
  explicit CutSearch(const DrawnMesh& mesh)
    : mesh_(mesh)
  {
    for (std::size_t cell = 0; cell < mesh.cells.cellCount(); ++cell)
    {
      const bool hasFaces = mesh.cells.firstFace[cell] < mesh.cells.firstFace[cell + 1];
      middles_.push_back(hasFaces ? middleOf(mesh, cell) : Vector{ 0, 0, 0 });
    }
  }

  const std::vector<Vector>& middles() const { return middles_; }

  Cut run() const
  {
    if (const std::vector<Vector> bodies = pointsOfBodies(mesh_); !bodies.empty())
    {
      const std::size_t axis = std::abs((*mesh_.flow)[1]) < 0.5 ? 1 : 0;
      return { axis, Box(bodies).middle()[axis] };
    }
    constexpr double Better = 1.1;
    Cut best{ 0, 0 };
    double most = -1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const auto [low, high] = ends(axis);
      const std::vector<double> areas = sections(axis, low, high);
      for (const double share : { 0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8 })
      {
        const double area = areas[static_cast<std::size_t>(std::lround(10 * share))];
        if (area > Better * most)
        {
          most = area;
          best = { axis, low + share * (high - low) };
        }
      }
    }
    return best;
  }

private:
  std::pair<double, double> ends(std::size_t axis) const
  {
    const auto [low, high] = std::minmax_element(middles_.begin(), middles_.end(),
      [&](const Vector& a, const Vector& b) { return a[axis] < b[axis]; });
    return { (*low)[axis], (*high)[axis] };
  }

  // The area of the faces between cells on both sides of planes at each tenth of the way.
  std::vector<double> sections(std::size_t axis, double low, double high) const
  {
    std::vector<double> areas(11);
    for (std::size_t f = 0; f < mesh_.faces.neighbour.size(); ++f)
    {
      const auto [from, to] =
        std::minmax(middles_[mesh_.faces.owner[f]][axis], middles_[mesh_.faces.neighbour[f]][axis]);
      const std::vector<Vector> polygon = polygonOf(mesh_, mesh_.faces.face[f]);
      for (std::size_t i = 1; i < 10; ++i)
      {
        const double at = low + static_cast<double>(i) / 10 * (high - low);
        if (from <= at && at < to)
        {
          const auto corner = [&](std::size_t c) { return polygon[c]; };
          areas[i] += std::abs(measureFace(polygon.size(), corner).area[axis]);
        }
      }
    }
    return areas;
  }

  const DrawnMesh& mesh_;
  std::vector<Vector> middles_; // of cells
};

}

ReportPicture pictureOfBoundary(const DrawnMesh& mesh)
{
  const std::vector<DrawnFace> drawn = boundaryOf(mesh, FromCorner);
  Canvas canvas = canvasFor(mesh, drawn, FromCorner, AroundBodies);
  draw(mesh, drawn, canvas);
  return { "The boundary, in the colours of the table of boundaries", pngOf(canvas) };
}

ReportPicture pictureOfCut(const DrawnMesh& mesh)
{
  const CutSearch search(mesh);
  const auto [axis, at] = search.run();
  const double side = axis == 1 ? -1 : 1; // of the eye
  const auto isKept = [&, axis = axis, at = at](std::size_t cell) {
    return side * (search.middles()[cell][axis] - at) <= 0;
  };
  std::vector<DrawnFace> drawn;
  const std::size_t inner = mesh.faces.neighbour.size();
  for (std::size_t f = 0; f < mesh.faces.face.size(); ++f)
  {
    const bool owner = isKept(mesh.faces.owner[f]);
    if (f < inner ? owner != isKept(mesh.faces.neighbour[f]) : owner)
    {
      drawn.push_back({ mesh.faces.face[f], f < inner ? CutColour : mesh.colours[f - inner] });
    }
  }
  Vector towards = scaled(FromCorner, 0.3);
  towards[axis] = side;
  Canvas canvas = canvasFor(mesh, drawn, towards, AroundCut);
  draw(mesh, drawn, canvas);
  return { std::string("Whole cells up to ") + "xyz"[axis] + " = " + number(at), pngOf(canvas) };
}

ReportPicture pictureOfCells(const DrawnMesh& mesh, const std::vector<std::uint32_t>& which)
{
  constexpr double Pale = 0.75;
  constexpr std::size_t MostCircles = 40;
  constexpr double Radius = 11;
  std::vector<DrawnFace> drawn = boundaryOf(mesh, FromCorner);
  Canvas canvas = canvasFor(mesh, drawn, FromCorner, AroundBodies);
  draw(mesh, drawn, canvas);
  canvas.fade(Pale);
  drawn.clear();
  for (const std::uint32_t cell : which)
  {
    for (std::size_t f = mesh.cells.firstFace[cell]; f < mesh.cells.firstFace[cell + 1]; ++f)
    {
      drawn.push_back({ f, Red });
    }
  }
  draw(mesh, drawn, canvas);
  for (std::size_t i = 0; which.size() <= MostCircles && i < which.size(); ++i)
  {
    canvas.circle(middleOf(mesh, which[i]), Radius, Red);
  }
  return { "", pngOf(canvas) };
}

}
