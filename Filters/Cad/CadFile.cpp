// SPDX-License-Identifier: BSD-3-Clause
#include "CadFile.h"

#include "CadProgress.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Check.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ManifoldSolidBrep.hxx>
#include <TColStd_HSequenceOfExtendedString.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_Label.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_DataMapOfShapeInteger.hxx>
#include <TopoDS_Compound.hxx>
#include <TransferBRep.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>

namespace cartesian
{

namespace
{

// Names of solids and faces by the file, by what all instances of a part share.
using NamesOfShapes = std::map<const TopoDS_TShape*, std::string>;

std::string toUtf8(const TCollection_ExtendedString& text)
{
  return TCollection_AsciiString(text).ToCString();
}

std::string nameOf(const TDF_Label& label)
{
  Handle(TDataStd_Name) name;
  return label.FindAttribute(TDataStd_Name::GetID(), name) ? toUtf8(name->Get()) : "";
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

// Collects the solids of an assembly, each instance by itself.
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
      walk(root, TopLoc_Location(), "", {});
    }
    return std::move(parts_);
  }

private:
  struct Style
  {
    std::string color;
    std::string layer;
  };

  void walk(const TDF_Label& label, const TopLoc_Location& place, const std::string& instance,
    const Style& outer)
  {
    Style style = styleOf(label);
    style.color = outer.color.empty() ? style.color : outer.color;
    style.layer = outer.layer.empty() ? style.layer : outer.layer;
    if (XCAFDoc_ShapeTool::IsReference(label))
    {
      TDF_Label product;
      XCAFDoc_ShapeTool::GetReferredShape(label, product);
      walk(product, place * XCAFDoc_ShapeTool::GetLocation(label), nameOf(label), style);
    }
    else if (XCAFDoc_ShapeTool::IsAssembly(label))
    {
      TDF_LabelSequence components;
      XCAFDoc_ShapeTool::GetComponents(label, components);
      for (const TDF_Label& component : components)
      {
        walk(component, place, "", style);
      }
    }
    else
    {
      addShape(label, place, instance, style);
    }
  }

  // A product's own name is the better one: instances are often called by numbers.
  void addShape(const TDF_Label& label, const TopLoc_Location& place, const std::string& instance,
    const Style& style)
  {
    const TopoDS_Shape shape = XCAFDoc_ShapeTool::GetShape(label);
    const std::string product = nameOf(label).empty() ? instance : nameOf(label);
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
      style.layer = toUtf8(layers->First());
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

// Of the file's entities: the reader's own way to get them (read.stepcaf.subshapes.name) crashes on some files. Faces
// of which nothing could be made are told.
class Entities
{
public:
  Entities(const Handle(XSControl_WorkSession) & session, const CadReport& report)
    : process_(session->TransferReader()->TransientProcess())
  {
    const Handle(Interface_InterfaceModel) model = session->Model();
    for (int i = 1; i <= model->NbEntities(); ++i)
    {
      const Handle(StepRepr_RepresentationItem) item =
        Handle(StepRepr_RepresentationItem)::DownCast(model->Value(i));
      const bool isFace = !item.IsNull() && item->IsKind(STANDARD_TYPE(StepShape_FaceSurface));
      if (isFace && !add(item, TopAbs_FACE))
      {
        lost_.emplace_back(model->StringLabel(item)->ToCString());
      }
      if (!item.IsNull() && item->IsKind(STANDARD_TYPE(StepShape_ManifoldSolidBrep)))
      {
        add(item, TopAbs_SOLID);
      }
    }
    if (!lost_.empty())
    {
      report.warning("Of " + std::to_string(lost_.size()) + " faces, " + lost_.front() +
        " the first of them in the file, nothing could be made: there are holes. Export the part "
        "again.");
    }
  }

  NamesOfShapes names;

private:
  // False if there is no such shape.
  bool add(const Handle(StepRepr_RepresentationItem) & item, TopAbs_ShapeEnum kind)
  {
    const TopoDS_Shape shape = TransferBRep::ShapeResult(process_, item);
    for (TopExp_Explorer part(shape, kind); !shape.IsNull() && part.More(); part.Next())
    {
      if (!item->Name().IsNull() && !item->Name()->IsEmpty())
      {
        names[part.Current().TShape().get()] = item->Name()->ToCString();
      }
    }
    return !shape.IsNull();
  }

  Handle(Transfer_TransientProcess) process_;
  std::vector<std::string> lost_;
};

Handle(TDocStd_Document) newDocument()
{
  XCAFDoc_ShapeTool::SetAutoNaming(Standard_False); // "COMPOUND" is no name
  return new TDocStd_Document("BinXCAF");
}

constexpr const char* NoShapes =
  "holds no shapes: it is empty, damaged, or of another format. Export it again.";

void checkRead(IFSelect_ReturnStatus status, const std::string& format)
{
  if (status != IFSelect_RetDone)
  {
    throw CadError("cannot be read as " + format +
      ": it is damaged, cut off, or of another format. Export it again.");
  }
}

// Notes what is wrong in the file itself, before shapes are made of it: Open CASCADE may crash on that.
void noteDamage(const Handle(Interface_InterfaceModel) & model, const CadReport& report)
{
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(Interface_Check) check = model->Check(i, Standard_True);
    if (!check.IsNull() && check->HasFailed())
    {
      report.note(std::string("Damaged in the file: ") +
        model->StringLabel(model->Value(i))->ToCString() + ", " + check->CFail(1) + ".");
      return;
    }
  }
}

CadFile readStep(const std::string& path, const CadReport& report)
{
  STEPCAFControl_Controller::Init(); // before any parameter
  STEPCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 0);
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_True);
  checkRead(reader.ReadFile(path.c_str()), "STEP");
  noteDamage(reader.Reader().WS()->Model(), report);
  report.progress(0.3);
  Handle(TDocStd_Document) document = newDocument();
  const Handle(CadProgress) progress = new CadProgress(report, 0.3, 0.5);
  if (!reader.Transfer(document, progress->Start()))
  {
    throw CadError(NoShapes);
  }
  const Entities entities(reader.Reader().WS(), report);
  return { Assembly(document, entities.names).parts(), true };
}

CadFile readIges(const std::string& path, const CadReport& report)
{
  STEPCAFControl_Controller::Init();
  IGESCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_True);
  checkRead(reader.ReadFile(path.c_str()), "IGES");
  noteDamage(reader.WS()->Model(), report);
  report.progress(0.3);
  Handle(TDocStd_Document) document = newDocument();
  const Handle(CadProgress) progress = new CadProgress(report, 0.3, 0.5);
  if (!reader.Transfer(document, progress->Start()))
  {
    throw CadError(NoShapes);
  }
  return { Assembly(document, {}).parts(), false };
}

// Null if there is none.
TopoDS_Shape shapeOfBrep(const std::string& path)
{
  TopoDS_Shape shape;
  try
  {
    std::ifstream stream;
    stream.exceptions(std::ios::failbit | std::ios::badbit); // or a cut file is read for ever
    stream.open(path);
    BRepTools::Read(shape, stream, BRep_Builder());
  }
  catch (const std::ios::failure&)
  {
    return {};
  }
  return shape;
}

CadFile readBrep(const std::string& path)
{
  const TopoDS_Shape shape = shapeOfBrep(path);
  if (shape.IsNull())
  {
    checkRead(IFSelect_RetFail, "BREP");
  }
  Handle(TDocStd_Document) document = newDocument();
  XCAFDoc_DocumentTool::ShapeTool(document->Main())->AddShape(shape, Standard_False);
  return { Assembly(document, {}).parts(), true };
}

}

CadFile readCadFile(const std::string& given, const CadReport& report)
{
  // Files that this one refers to are sought beside it.
  const std::string path = std::filesystem::absolute(given).string();
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(
    suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  CadFile file = suffix == ".igs" || suffix == ".iges" ? readIges(path, report)
    : suffix == ".brep"                                ? readBrep(path)
                                                       : readStep(path, report);
  const auto isEmpty = [](const CadPart& part) { return part.faces.empty(); };
  file.parts.erase(std::remove_if(file.parts.begin(), file.parts.end(), isEmpty), file.parts.end());
  if (file.parts.empty())
  {
    throw CadError(
      "holds neither solids nor faces: drawings, wires and points enclose nothing. Export "
      "the part as a solid.");
  }
  return file;
}

}
