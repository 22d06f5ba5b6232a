// SPDX-License-Identifier: BSD-3-Clause
#include "CadAssembly.h"

#include "CadNames.h"

#include <BRep_Builder.hxx>
#include <Quantity_Color.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

namespace cartesian
{

namespace
{

// What Open CASCADE calls a product without a name.
constexpr const char* NameByTranslator = "Open CASCADE STEP translator";

std::string textOf(const TCollection_ExtendedString& text)
{
  return TCollection_AsciiString(text).ToCString();
}

std::string nameOf(const TDF_Label& label)
{
  Handle(TDataStd_Name) name;
  const std::string text =
    label.FindAttribute(TDataStd_Name::GetID(), name) ? textOf(name->Get()) : "";
  return text.rfind(NameByTranslator, 0) == 0 ? "" : text;
}

std::string hexadecimal(const Quantity_Color& color)
{
  return TCollection_AsciiString(Quantity_Color::ColorToHex(color, Standard_False)).ToCString();
}

TopTools_IndexedMapOfShape solidsOf(const TopoDS_Shape& shape)
{
  TopTools_IndexedMapOfShape solids;
  TopExp::MapShapes(shape, TopAbs_SOLID, solids);
  return solids;
}

class Assembly
{
public:
  Assembly(const Handle(TDocStd_Document) & document, const NamesOfShapes& names)
    : shapes_(XCAFDoc_DocumentTool::ShapeTool(document->Main()))
    , colors_(XCAFDoc_DocumentTool::ColorTool(document->Main()))
    , layers_(XCAFDoc_DocumentTool::LayerTool(document->Main()))
    , names_(names)
  {
  }

  std::vector<CadPart> parts()
  {
    TDF_LabelSequence roots;
    shapes_->GetFreeShapes(roots);
    for (const TDF_Label& root : roots)
    {
      walk(root, TopLoc_Location(), {}, {});
    }
    return std::move(parts_);
  }

private:
  struct Style
  {
    std::string color;
    std::string layer;
  };

  // A product that holds more than its solid, such as axes or a sheet, is an assembly of shapes without names: theirs are
  // those of what holds them.
  struct Names
  {
    std::string instance;
    std::string product;
  };

  void walk(
    const TDF_Label& label, const TopLoc_Location& place, const Names& names, const Style& outer)
  {
    Style style = styleOf(label);
    style.color = outer.color.empty() ? style.color : outer.color;
    style.layer = outer.layer.empty() ? style.layer : outer.layer;
    if (XCAFDoc_ShapeTool::IsReference(label))
    {
      TDF_Label product;
      XCAFDoc_ShapeTool::GetReferredShape(label, product);
      const std::string own = nameOf(label);
      const bool isUnnamed = own.empty() && nameOf(product).empty();
      walk(product, place * XCAFDoc_ShapeTool::GetLocation(label),
        { isUnnamed ? names.instance : own, isNumbered(own) ? names.product : own }, style);
    }
    else if (XCAFDoc_ShapeTool::IsAssembly(label))
    {
      const std::string product = nameOf(label).empty() ? names.product : nameOf(label);
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      for (const TDF_Label& component : components)
      {
        walk(component, place, { names.instance, product }, style);
      }
    }
    else
    {
      addShape(label, place, names, style);
    }
  }

  // A product's own name is the better one: instances are often called by numbers.
  void addShape(
    const TDF_Label& label, const TopLoc_Location& place, const Names& names, const Style& style)
  {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    const std::string& instance = names.instance;
    const std::string product = nameOf(label).empty() ? names.product : nameOf(label);
    const TopTools_IndexedMapOfShape solids = solidsOf(shape);
    for (int i = 1; i <= solids.Extent(); ++i)
    {
      // Of a single solid, the product's name is the better one.
      const std::string own = solids.Extent() > 1 ? nameOfSubshape(solids(i)) : "";
      addPart(solids(i), place, own.empty() ? product : own, instance, style);
    }
    TopoDS_Compound loose;
    BRep_Builder().MakeCompound(loose);
    bool isLoose = false;
    for (TopExp_Explorer face(shape, TopAbs_FACE, TopAbs_SOLID); face.More(); face.Next())
    {
      BRep_Builder().Add(loose, face.Current());
      isLoose = true;
    }
    if (isLoose)
    {
      addPart(loose, place, product, instance, style);
    }
  }

  void addPart(const TopoDS_Shape& shape, const TopLoc_Location& place, const std::string& name,
    const std::string& instance, const Style& outer)
  {
    CadPart part{ shape.Moved(place), name, {}, instance };
    const Style style = styleOfShape(shape, outer);
    const TopTools_IndexedMapOfShape faces = facesOf(shape);
    for (int i = 1; i <= faces.Extent(); ++i)
    {
      const Style own = styleOfShape(faces(i), style);
      part.faces.push_back({ nameOfSubshape(faces(i)), own.color, own.layer });
    }
    parts_.push_back(std::move(part));
  }

  std::string nameOfSubshape(const TopoDS_Shape& shape) const
  {
    const auto named = names_.find(shape.TShape().get());
    TDF_Label label;
    return named != names_.end()                                                     ? named->second
      : shapes_->Search(shape, label, Standard_False, Standard_False, Standard_True) ? nameOf(label)
                                                                                     : "";
  }

  Style styleOf(const TDF_Label& label) const
  {
    Style style;
    Quantity_Color color;
    for (const XCAFDoc_ColorType type : { XCAFDoc_ColorSurf, XCAFDoc_ColorGen })
    {
      if (style.color.empty() && colors_->GetColor(label, type, color))
      {
        style.color = hexadecimal(color);
      }
    }
    Handle(TColStd_HSequenceOfExtendedString) layers;
    if (layers_->GetLayers(label, layers) && layers->Length() > 0)
    {
      style.layer = textOf(layers->First());
    }
    return style;
  }

  Style styleOfShape(const TopoDS_Shape& shape, const Style& outer) const
  {
    TDF_Label label;
    const Style own = shapes_->Search(shape, label, Standard_False, Standard_False, Standard_True)
      ? styleOf(label)
      : Style();
    return { own.color.empty() ? outer.color : own.color,
      own.layer.empty() ? outer.layer : own.layer };
  }

  Handle(XCAFDoc_ShapeTool) shapes_;
  Handle(XCAFDoc_ColorTool) colors_;
  Handle(XCAFDoc_LayerTool) layers_;
  const NamesOfShapes& names_;
  std::vector<CadPart> parts_;
};

}

std::vector<CadPart> partsOf(const Handle(TDocStd_Document) & document, const NamesOfShapes& names)
{
  return Assembly(document, names).parts();
}

}
