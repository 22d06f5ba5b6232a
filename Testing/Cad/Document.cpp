#include "Document.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Writer.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPConstruct.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TopoDS_Compound.hxx>
#include <Transfer_FinderProcess.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_LayerTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_TransferWriter.hxx>
#include <XSControl_WorkSession.hxx>

#include <stdexcept>

namespace cartesian
{

namespace
{

Handle(XCAFDoc_ShapeTool) shapesOf(const Handle(TDocStd_Document) & document)
{
  return XCAFDoc_DocumentTool::ShapeTool(document->Main());
}

void setName(const TDF_Label& label, const std::string& name)
{
  TDataStd_Name::Set(label, TCollection_ExtendedString(name.c_str(), true));
}

void set(const char* parameter, const std::string& value)
{
  if (!Interface_Static::SetCVal(parameter, value.c_str()))
  {
    throw std::runtime_error(std::string(parameter) + " cannot be " + value);
  }
}

void require(bool done, const std::string& path)
{
  if (!done)
  {
    throw std::runtime_error(path + " could not be written");
  }
}

// OCCT writes the names of products only.
void nameItems(
  STEPCAFControl_Writer& writer, const std::vector<std::pair<TopoDS_Shape, std::string>>& names)
{
  const Handle(Transfer_FinderProcess)& process =
    writer.ChangeWriter().WS()->TransferWriter()->FinderProcess();
  for (const auto& [shape, name] : names)
  {
    const Handle(StepRepr_RepresentationItem) item = STEPConstruct::FindEntity(process, shape);
    if (item.IsNull())
    {
      throw std::runtime_error("no STEP entity to be called " + name);
    }
    item->SetName(new TCollection_HAsciiString(name.c_str()));
  }
}

}

Document::Document()
{
  XCAFApp_Application::GetApplication()->NewDocument("MDTV-XCAF", document_);
}

Document::~Document()
{
  XCAFApp_Application::GetApplication()->Close(document_);
}

TDF_Label Document::add(const TopoDS_Shape& shape, const std::string& name)
{
  const TDF_Label label = shapesOf(document_)->AddShape(shape, false);
  setName(label, name);
  parts_.push_back(label);
  return label;
}

TDF_Label Document::addAssembly(const std::string& name)
{
  const TDF_Label label = shapesOf(document_)->NewShape();
  setName(label, name);
  return label;
}

void Document::place(
  const TDF_Label& assembly, const TDF_Label& part, const std::string& name, const gp_Trsf& where)
{
  setName(shapesOf(document_)->AddComponent(assembly, part, TopLoc_Location(where)), name);
  shapesOf(document_)->UpdateAssemblies();
}

void Document::nameSubshape(const TopoDS_Shape& subshape, const std::string& name)
{
  names_.emplace_back(subshape, name);
  boundaries_.emplace_back(subshape, name);
}

void Document::colour(const TopoDS_Face& face, const std::string& hexadecimal)
{
  Quantity_Color colour;
  if (!Quantity_Color::ColorFromHex(hexadecimal.c_str(), colour))
  {
    throw std::runtime_error("no colour: " + hexadecimal);
  }
  XCAFDoc_DocumentTool::ColorTool(document_->Main())
    ->SetColor(labelOf(face), colour, XCAFDoc_ColorSurf);
  boundaries_.emplace_back(face, hexadecimal);
}

void Document::putInLayer(const TopoDS_Face& face, const std::string& layer)
{
  XCAFDoc_DocumentTool::LayerTool(document_->Main())
    ->SetLayer(labelOf(face), TCollection_ExtendedString(layer.c_str(), true));
  boundaries_.emplace_back(face, layer);
}

TDF_Label Document::labelOf(const TopoDS_Face& face) const
{
  for (const TDF_Label& part : parts_)
  {
    TDF_Label label;
    if (shapesOf(document_)->FindSubShape(part, face, label))
    {
      return label;
    }
    label = shapesOf(document_)->AddSubShape(part, face);
    if (!label.IsNull())
    {
      return label;
    }
  }
  throw std::runtime_error("the face belongs to no part");
}

TopoDS_Shape Document::shape() const
{
  TDF_LabelSequence labels;
  shapesOf(document_)->GetFreeShapes(labels);
  BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (const TDF_Label& label : labels)
  {
    builder.Add(all, XCAFDoc_ShapeTool::GetShape(label));
  }
  return all;
}

void Document::writeStep(
  const std::string& path, const std::string& unit, const std::string& schema) const
{
  STEPCAFControl_Controller::Init(); // or there are no parameters
  set("write.step.unit", unit);
  set("write.step.schema", schema);
  STEPCAFControl_Writer writer;
  require(writer.Transfer(document_), path);
  nameItems(writer, names_);
  require(writer.Write(path.c_str()) == IFSelect_RetDone, path);
}

void Document::writeStepOfSeveralFiles(const std::string& path) const
{
  STEPCAFControl_Controller::Init();
  set("write.step.unit", "MM");
  set("write.step.schema", "AP214IS");
  STEPCAFControl_Writer writer;
  const char* const noPrefix = ""; // a null pointer would mean one file
  require(writer.Transfer(document_, STEPControl_AsIs, noPrefix), path);
  require(writer.Write(path.c_str()) == IFSelect_RetDone, path);
}

void Document::writeIges(const std::string& path) const
{
  IGESControl_Controller::Init();
  set("write.iges.unit", "MM");
  IGESCAFControl_Writer writer;
  require(writer.Transfer(document_), path);
  require(writer.Write(path.c_str()), path);
}

void writeIgesShape(
  const TopoDS_Shape& shape, const std::string& path, IgesForm form, const std::string& unit)
{
  IGESControl_Controller::Init();
  IGESControl_Writer writer(unit.c_str(), form == IgesForm::Solid ? 1 : 0);
  require(writer.AddShape(shape), path);
  writer.ComputeModel();
  require(writer.Write(path.c_str()), path);
}

void writeBrep(const TopoDS_Shape& shape, const std::string& path)
{
  require(BRepTools::Write(shape, path.c_str()), path);
}

}
