// SPDX-License-Identifier: BSD-3-Clause
#include "CadSplines.h"

#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRep_Builder.hxx>
#include <Standard_Failure.hxx>
#include <TopoDS_Compound.hxx>

namespace cartesian
{

namespace
{

void markNeighbours(const std::vector<CadPart>& parts, std::vector<bool>& marked)
{
  TopTools_IndexedMapOfShape faces; // of parts that are marked
  for (bool isNew = true; isNew;)
  {
    isNew = false;
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      const TopTools_IndexedMapOfShape own = facesOf(parts[p].shape);
      bool isTouching = marked[p];
      for (int i = 1; i <= own.Extent() && !isTouching; ++i)
      {
        isTouching = faces.Contains(own(i));
      }
      marked[p] = isTouching;
      const int before = faces.Extent();
      for (int i = 1; i <= own.Extent() && isTouching; ++i)
      {
        faces.Add(own(i));
      }
      isNew = isNew || faces.Extent() > before;
    }
  }
}

}

std::vector<CadPart> asSplines(const std::vector<CadPart>& parts, std::vector<bool> marked)
{
  markNeighbours(parts, marked);
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  for (std::size_t p = 0; p < parts.size(); ++p)
  {
    if (marked[p])
    {
      BRep_Builder().Add(all, parts[p].shape);
    }
  }
  std::vector<CadPart> made = parts;
  try
  {
    const BRepBuilderAPI_NurbsConvert conversion(all);
    for (std::size_t p = 0; p < parts.size(); ++p)
    {
      made[p].shape = marked[p] ? conversion.ModifiedShape(parts[p].shape) : parts[p].shape;
      if (facesOf(made[p].shape).Extent() != facesOf(parts[p].shape).Extent())
      {
        return {};
      }
    }
  }
  catch (const Standard_Failure&)
  {
    return {};
  }
  return made;
}

}
