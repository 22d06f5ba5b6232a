// SPDX-License-Identifier: BSD-3-Clause
#include "CadKinks.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRepTools_History.hxx>
#include <ShapeBuild_ReShape.hxx>
#include <ShapeUpgrade_ShapeDivideContinuity.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>

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

// False where it would open the part.
bool divide(CadPart& part, const TopTools_IndexedMapOfShape& faces)
{
  ShapeUpgrade_ShapeDivideContinuity division(part.shape);
  division.SetSurfaceCriterion(GeomAbs_C1);
  division.Perform();
  const TopoDS_Shape divided = division.Result();
  if (divided.IsNull() || divided.ShapeType() != part.shape.ShapeType() ||
    freeEdges(divided).Extent() > freeEdges(part.shape).Extent())
  {
    return false;
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
  part.shape = divided;
  part.faces = history.of(divided);
  return true;
}

}

void divideAtKinks(std::vector<CadPart>& parts, const CadReport& report)
{
  int divided = 0;
  for (CadPart& part : parts)
  {
    const TopTools_IndexedMapOfShape faces = facesOf(part.shape);
    const int kinked = countKinked(faces);
    divided += kinked > 0 && divide(part, faces) ? kinked : 0;
  }
  if (divided > 0)
  {
    report.note("Divided: " + std::to_string(divided) + " faces, along the kinks inside them.");
  }
}

}
