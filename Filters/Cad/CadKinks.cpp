// SPDX-License-Identifier: BSD-3-Clause
#include "CadKinks.h"

#include "CadTriangles.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_History.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeUpgrade_ShapeDivideContinuity.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

#include <optional>
#include <utility>

namespace cartesian
{

namespace
{

// Whether the face's surface is not smooth inside.
bool isKinked(const TopoDS_Face& face)
{
  const BRepAdaptor_Surface surface(face);
  return surface.UContinuity() == GeomAbs_C0 || surface.VContinuity() == GeomAbs_C0;
}

int countKinked(const TopTools_IndexedMapOfShape& faces)
{
  int count = 0;
  for (int i = 1; i <= faces.Extent(); ++i)
  {
    count += isKinked(TopoDS::Face(faces(i)));
  }
  return count;
}

// Nothing where it would open the part.
std::optional<CadPart> divided(const CadPart& part, const TopTools_IndexedMapOfShape& faces)
{
  ShapeUpgrade_ShapeDivideContinuity division(part.shape);
  division.SetSurfaceCriterion(GeomAbs_C1);
  division.Perform();
  const TopoDS_Shape shape = division.Result();
  if (shape.IsNull() || shape.ShapeType() != part.shape.ShapeType() ||
    freeEdges(shape).Extent() > freeEdges(part.shape).Extent())
  {
    return {};
  }
  FaceHistory history;
  history.add(part);
  for (int i = 1; i <= faces.Extent(); ++i)
  {
    const TopoDS_Shape image = division.GetContext()->Apply(faces(i));
    const TopTools_IndexedMapOfShape images = facesOf(image);
    for (int k = 1; k <= images.Extent(); ++k)
    {
      history.follow(faces(i), images(k));
    }
  }
  return CadPart{ shape, part.name, history.of(shape), part.instance };
}

// Divided faces may be so thin at an end that Open CASCADE cannot triangulate them.
bool opensTriangles(
  const CadPart& divided, const CadPart& part, double deflection, const CadOptions& options)
{
  return gapsOf(divided, deflection, options) > 0 && gapsOf(part, deflection, options) == 0;
}

}

void divideAtKinks(std::vector<CadPart>& parts, const CadOptions& options, const CadReport& report)
{
  int count = 0;
  const double deflection = deflectionOf(parts, options);
  for (CadPart& part : parts)
  {
    const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
    const int kinked = countKinked(faces);
    std::optional<CadPart> pieces = kinked > 0 ? divided(part, faces) : std::nullopt;
    if (pieces && opensTriangles(*pieces, part, deflection, options))
    {
      report.note("Not divided along kinks: " + part.name + " at " +
        placeOf(part.shape, options.unit) +
        ", whose triangles would be open. Kinks are no sharp edges there.");
    }
    else if (pieces)
    {
      part = std::move(*pieces);
      count += kinked;
    }
  }
  if (count > 0)
  {
    report.note("Divided: " + std::to_string(count) + " faces, along the kinks inside them.");
  }
}

}
