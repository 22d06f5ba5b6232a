// SPDX-License-Identifier: BSD-3-Clause
#include "ReportPictures.h"

#include "Report/Canvas.h"

#include "vtkBase64Utilities.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkPNGWriter.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <limits>

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

Bounds3 boundsOf(const DrawnMesh& mesh, std::size_t firstCorner, std::size_t endCorner)
{
  constexpr double Infinity = std::numeric_limits<double>::infinity();
  Bounds3 box{ { Infinity, Infinity, Infinity }, { -Infinity, -Infinity, -Infinity } };
  for (std::size_t i = firstCorner; i < endCorner; ++i)
  {
    const Vector at = pointOf(mesh, mesh.cells.corners[i]);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      box.low[axis] = std::min(box.low[axis], at[axis]);
      box.high[axis] = std::max(box.high[axis], at[axis]);
    }
  }
  return box;
}

Bounds3 boundsOf(const DrawnMesh& mesh)
{
  return boundsOf(mesh, 0, mesh.cells.corners.size());
}

Bounds3 boundsOfCell(const DrawnMesh& mesh, std::size_t cell)
{
  return boundsOf(mesh, mesh.cells.firstCorner[mesh.cells.firstFace[cell]],
    mesh.cells.firstCorner[mesh.cells.firstFace[cell + 1]]);
}

Vector middleOf(const Bounds3& box)
{
  return scaled(plus(box.low, box.high), 0.5);
}

// Faces, filled first: edges are hidden by all of them.
struct DrawnFace
{
  std::size_t face; // of the cells
  Colour colour;
};

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

std::vector<DrawnFace> boundaryOf(const DrawnMesh& mesh)
{
  std::vector<DrawnFace> drawn;
  const std::size_t inner = mesh.faces.neighbour.size();
  for (std::size_t f = inner; f < mesh.faces.face.size(); ++f)
  {
    drawn.push_back({ mesh.faces.face[f], mesh.colours[f - inner] });
  }
  return drawn;
}

}

ReportPicture pictureOfBoundary(const DrawnMesh& mesh)
{
  Canvas canvas(Width, Height, boundsOf(mesh), FromCorner);
  draw(mesh, boundaryOf(mesh), canvas);
  return { "The boundary, in the colours of the table of boundaries", pngOf(canvas) };
}

ReportPicture pictureOfCut(const DrawnMesh& mesh)
{
  const Bounds3 box = boundsOf(mesh);
  const Vector sides = minus(box.high, box.low);
  const auto axis = static_cast<std::size_t>(
    std::min_element(sides.begin(), sides.end()) - sides.begin());
  std::vector<bool> isKept;
  for (std::size_t cell = 0; cell < mesh.cells.cellCount(); ++cell)
  {
    const bool hasFaces = mesh.cells.firstFace[cell] < mesh.cells.firstFace[cell + 1];
    const double middle = hasFaces ? middleOf(boundsOfCell(mesh, cell))[axis] : 0;
    isKept.push_back(hasFaces && (axis == 1 ? middle >= middleOf(box)[1] : middle <= middleOf(box)[axis]));
  }
  std::vector<DrawnFace> drawn;
  const std::size_t inner = mesh.faces.neighbour.size();
  for (std::size_t f = 0; f < mesh.faces.face.size(); ++f)
  {
    const bool owner = isKept[mesh.faces.owner[f]];
    if (f < inner ? owner != isKept[mesh.faces.neighbour[f]] : owner)
    {
      drawn.push_back({ mesh.faces.face[f], f < inner ? CutColour : mesh.colours[f - inner] });
    }
  }
  Vector towards = scaled(FromCorner, 0.3);
  towards[axis] = axis == 1 ? -1 : 1;
  Canvas canvas(Width, Height, box, towards);
  draw(mesh, drawn, canvas);
  return { std::string("Whole cells on one side of the middle, along ") + "xyz"[axis], pngOf(canvas) };
}

ReportPicture pictureOfCells(const DrawnMesh& mesh, const std::vector<std::uint32_t>& which)
{
  constexpr double Pale = 0.75;
  constexpr std::size_t MostCircles = 40;
  constexpr double Radius = 11;
  Canvas canvas(Width, Height, boundsOf(mesh), FromCorner);
  draw(mesh, boundaryOf(mesh), canvas);
  canvas.fade(Pale);
  std::vector<DrawnFace> drawn;
  for (const std::uint32_t cell : which)
  {
    for (std::size_t f = mesh.cells.firstFace[cell]; f < mesh.cells.firstFace[cell + 1]; ++f)
    {
      drawn.push_back({ f, Red });
    }
  }
  draw(mesh, drawn, canvas);
  for (std::size_t i = 0; i < std::min(which.size(), MostCircles); ++i)
  {
    canvas.circle(middleOf(boundsOfCell(mesh, which[i])), Radius, Red);
  }
  return { "", pngOf(canvas) };
}

}
