// SPDX-License-Identifier: BSD-3-Clause
#include "CadTessellation.h"

#include "StepProducts.h"

#include <BRep_Builder.hxx>
#include <Poly_Triangulation.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

namespace cartesian
{

namespace
{

// Entities of faces: where their parameters are, from 0.
struct FaceKind
{
  const char* type;
  std::size_t indices;   // of points in the list of coordinates; none: all in order
  std::size_t triangles; // or strips, and fans behind them
  bool hasStrips;
};

constexpr std::array<FaceKind, 4> FaceKinds{ { { "TRIANGULATED_FACE", 5, 6, false },
  { "COMPLEX_TRIANGULATED_FACE", 5, 6, true }, { "TRIANGULATED_SURFACE_SET", 4, 5, false },
  { "COMPLEX_TRIANGULATED_SURFACE_SET", 4, 5, true } } };

constexpr std::array<const char*, 3> Representations{ "TESSELLATED_SHAPE_REPRESENTATION",
  "TESSELLATED_SHAPE_REPRESENTATION_WITH_ACCURACY_PARAMETERS", "SHAPE_REPRESENTATION" };

// Exact shapes: what a product has of them, its triangles only repeat.
constexpr std::array<const char*, 6> ExactBodies{ "MANIFOLD_SOLID_BREP", "BREP_WITH_VOIDS",
  "FACETED_BREP", "SHELL_BASED_SURFACE_MODEL", "FACE_BASED_SURFACE_MODEL", "GEOMETRIC_SET" };

// What places one shape several times, or elsewhere, in ways that are not read.
constexpr std::array<const char*, 2> Placements{ "MAPPED_ITEM", "REPOSITIONED_TESSELLATED_ITEM" };

using Corners = std::array<int, 3>;

class Tessellation
{
public:
  Tessellation(const std::string& text, bool isBesideExact)
    : step_(text)
    , products_(step_)
    , isBesideExact_(isBesideExact)
  {
    for (const char* type : Representations)
    {
      for (const int number : step_.all(type))
      {
        addRepresentation(number, step_.part(number, type));
      }
    }
  }

  std::vector<CadPart> parts;

private:
  void addRepresentation(int number, const StepEntity& shape)
  {
    millimetres_ = products_.millimetresIn(valueOf(shape, 2).reference);
    const int product = products_.productOf(number);
    if (isBesideExact_ && (product == 0 || hasExactBodies(product)))
    {
      return;
    }
    const std::string name = products_.nameOf(product);
    std::vector<int> bodies;
    for (const StepValue& item : valueOf(shape, 1).list)
    {
      const StepEntity entity = first(item.reference);
      const bool isExactToo = isBesideExact_ && isBody(entity) && valueOf(entity, 2).reference != 0;
      if ((isBody(entity) || isFace(entity)) && !isExactToo)
      {
        bodies.push_back(item.reference);
      }
    }
    const std::size_t before = parts.size();
    for (const int body : bodies)
    {
      addItem(body, bodies.size() == 1 ? name : "", name);
    }
    const std::vector<CadPart> own(parts.begin() + std::ptrdiff_t(before), parts.end());
    parts.resize(before);
    for (const StepPlace& place : products_.placesOf(product))
    {
      for (CadPart part : own)
      {
        part.shape = part.shape.Moved(TopLoc_Location(place.where));
        part.instance = place.name;
        parts.push_back(std::move(part));
      }
    }
  }

  bool hasExactBodies(int product) const
  {
    const std::set<int> all = products_.representationsOf(product);
    return std::any_of(all.begin(), all.end(), [&](int representation) {
      const StepEntity shape = first(representation);
      const std::vector<StepValue>& items = valueOf(shape, 1).list;
      return std::any_of(items.begin(), items.end(), [&](const StepValue& item) {
        return std::find(ExactBodies.begin(), ExactBodies.end(), first(item.reference).type) !=
          ExactBodies.end();
      });
    });
  }

  StepEntity first(int number) const
  {
    const std::vector<StepEntity> kinds = step_.at(number);
    return kinds.empty() ? StepEntity() : kinds.front();
  }

  void addItem(int number, const std::string& name, const std::string& other)
  {
    const StepEntity item = first(number);
    const std::string& own = valueOf(item, 0).text;
    std::vector<int> faces;
    for (const StepValue& face : isBody(item) ? valueOf(item, 1).list : std::vector<StepValue>())
    {
      faces.push_back(face.reference);
    }
    addPart(!name.empty() ? name
        : own.empty()     ? other
                          : own,
      isBody(item) ? faces : std::vector<int>{ number });
  }

  static bool isBody(const StepEntity& entity)
  {
    return entity.type == "TESSELLATED_SOLID" || entity.type == "TESSELLATED_SHELL";
  }

  static bool isFace(const StepEntity& entity)
  {
    return std::any_of(FaceKinds.begin(), FaceKinds.end(),
      [&](const FaceKind& kind) { return entity.type == kind.type; });
  }

  void addPart(const std::string& name, const std::vector<int>& faces)
  {
    CadPart part;
    part.name = name;
    BRep_Builder builder;
    TopoDS_Shell shell;
    builder.MakeShell(shell);
    for (const int number : faces)
    {
      for (const FaceKind& kind : FaceKinds)
      {
        const StepEntity entity = step_.part(number, kind.type);
        const std::vector<Corners> triangles = trianglesOf(entity, kind);
        if (!triangles.empty())
        {
          TopoDS_Face face;
          builder.MakeFace(face, triangulation(valueOf(entity, 1).reference, triangles));
          builder.Add(shell, face);
          part.faces.push_back({ valueOf(entity, 0).text, "", "" });
        }
      }
    }
    TopoDS_Solid solid;
    builder.MakeSolid(solid);
    builder.Add(solid, shell);
    part.shape = solid;
    parts.push_back(std::move(part));
  }

  // By numbers of points in the list of coordinates, from 1.
  static std::vector<Corners> trianglesOf(const StepEntity& face, const FaceKind& kind)
  {
    std::vector<Corners> triangles;
    const std::vector<StepValue>& indices = valueOf(face, kind.indices).list;
    const auto add = [&](const StepValue& row, std::size_t a, std::size_t b, std::size_t c) {
      Corners corners{};
      std::size_t k = 0;
      for (const std::size_t i : { a, b, c })
      {
        const double point = row.list[i].number;
        const bool isIn = point >= 1 && point <= static_cast<double>(indices.size());
        corners[k++] = static_cast<int>(isIn ? indices[static_cast<std::size_t>(point) - 1].number
            : indices.empty()                ? point
                                             : 0);
      }
      triangles.push_back(corners);
    };
    for (const StepValue& row : valueOf(face, kind.triangles).list)
    {
      for (std::size_t i = 0; i + 2 < row.list.size(); ++i)
      {
        const std::size_t turn = i % 2; // of a strip each second one turns the other way
        add(row, i + turn, i + 1 - turn, i + 2);
      }
    }
    for (const StepValue& row :
      kind.hasStrips ? valueOf(face, kind.triangles + 1).list : std::vector<StepValue>())
    {
      for (std::size_t i = 1; i + 1 < row.list.size(); ++i)
      {
        add(row, 0, i, i + 1);
      }
    }
    return triangles;
  }

  const std::vector<gp_Pnt>& pointsOf(int coordinates)
  {
    const auto [place, isNew] = points_.try_emplace(coordinates);
    const StepEntity list = isNew ? step_.part(coordinates, "COORDINATES_LIST") : StepEntity();
    for (const StepValue& row : valueOf(list, 2).list)
    {
      if (row.list.size() != 3)
      {
        throw CadError(
          "is damaged: a point of its triangles has no three coordinates. Export it again.");
      }
      place->second.emplace_back(row.list[0].number * millimetres_,
        row.list[1].number * millimetres_, row.list[2].number * millimetres_);
    }
    return place->second;
  }

  Handle(Poly_Triangulation) triangulation(int coordinates, const std::vector<Corners>& triangles)
  {
    const std::vector<gp_Pnt>& points = pointsOf(coordinates);
    std::map<int, int> numbers; // of those that the face has
    for (const Corners& corners : triangles)
    {
      for (const int corner : corners)
      {
        if (corner < 1 || static_cast<std::size_t>(corner) > points.size())
        {
          throw CadError("is damaged: a triangle has a corner that is not there. Export it again.");
        }
        numbers.try_emplace(corner, static_cast<int>(numbers.size()) + 1);
      }
    }
    Handle(Poly_Triangulation) result = new Poly_Triangulation(
      static_cast<int>(numbers.size()), static_cast<int>(triangles.size()), Standard_False);
    for (const auto& [corner, number] : numbers)
    {
      result->SetNode(number, points[static_cast<std::size_t>(corner) - 1]);
    }
    for (std::size_t i = 0; i < triangles.size(); ++i)
    {
      result->SetTriangle(static_cast<int>(i) + 1,
        Poly_Triangle(
          numbers[triangles[i][0]], numbers[triangles[i][1]], numbers[triangles[i][2]]));
    }
    return result;
  }

  StepText step_;
  StepProducts products_;
  bool isBesideExact_;
  double millimetres_ = 1;                    // a unit of the representation in hand
  std::map<int, std::vector<gp_Pnt>> points_; // by list of coordinates
};

}

bool holdsTriangles(const std::string& text)
{
  return text.find("TRIANGULATED_FACE") != std::string::npos ||
    text.find("TRIANGULATED_SURFACE_SET") != std::string::npos;
}

std::vector<CadPart> tessellatedParts(const std::string& text, bool isBesideExact)
{
  return Tessellation(text, isBesideExact).parts;
}

std::string unreadPlacement(const std::string& text)
{
  const auto* const placement = std::find_if(Placements.begin(), Placements.end(),
    [&](const char* type) { return text.find(type) != std::string::npos; });
  return placement == Placements.end() ? ""
                                       : std::string(" placed by ") + *placement +
      ": only those that are where their points are, or where an assembly places them, can be "
      "read. "
      "Export exact shapes (BREP), or each part by itself.";
}

}
