// SPDX-License-Identifier: BSD-3-Clause
#include "CadFile.h"

#include "CadAssembly.h"
#include "CadProgress.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

namespace cartesian
{

namespace
{

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
  return { partsOf(document, namesOfShapes(reader.Reader().WS(), report)), true };
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
  return { partsOf(document, {}), false };
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
  return { partsOf(document, {}), true };
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
