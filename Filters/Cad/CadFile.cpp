// SPDX-License-Identifier: BSD-3-Clause
#include "CadFile.h"

#include "CadAssembly.h"
#include "CadEncoding.h"
#include "CadProgress.h"
#include "CadReferences.h"
#include "CadTessellation.h"

#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESBasic_Name.hxx>
#include <IGESCAFControl_Reader.hxx>
#include <IGESData_IGESEntity.hxx>
#include <Interface_InterfaceModel.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <TCollection_HAsciiString.hxx>
#include <TDocStd_Document.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>

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

constexpr const char* AsTheyAre = "They are taken as they are: Deflection, Angle, Heal Tolerance, "
                                  "Glue Solids and Merge Coplanar do nothing.";

void checkRead(IFSelect_ReturnStatus status, const std::string& format)
{
  if (status != IFSelect_RetDone)
  {
    throw CadError("cannot be read as " + format +
      ": it is damaged, cut off, or of another format. Export it again.");
  }
}

// What the file is in. Open CASCADE takes UTF-8 only.
CadEncoding encodingOf(const std::string& text, CadEncoding asked, const CadReport& report)
{
  if (asked != CadEncoding::Automatic || isUtf8(text))
  {
    return asked == CadEncoding::Automatic ? CadEncoding::Utf8 : asked;
  }
  const CadEncoding guessed = guessedEncoding(text);
  report.note("The file is not in UTF-8: its names are taken to be " + nameOf(guessed) +
    ". If they are garbled, choose another Name Encoding.");
  return guessed;
}

std::string contentOf(const std::string& path)
{
  std::ostringstream content;
  content << std::ifstream(path, std::ios::binary).rdbuf();
  return content.str();
}

// Gives its text in UTF-8.
IFSelect_ReturnStatus readStepModel(STEPCAFControl_Reader& reader, const std::string& path,
  const CadOptions& options, std::string& text, const CadReport& report)
{
  text = contentOf(path);
  const CadEncoding encoding = encodingOf(text, options.encoding, report);
  if (encoding == CadEncoding::Utf8)
  {
    return reader.ReadFile(path.c_str());
  }
  text = toUtf8(text, encoding);
  std::istringstream stream(text);
  return reader.ChangeReader().ReadStream(path.c_str(), stream);
}

bool hasFaces(const std::vector<CadPart>& parts)
{
  return std::any_of(
    parts.begin(), parts.end(), [](const CadPart& part) { return !part.faces.empty(); });
}

// Throws CadError if all that the file has is elsewhere.
void tellUnread(const STEPCAFControl_Reader& reader, bool hasSome, const CadReport& report)
{
  const std::vector<std::string> unread = unreadFiles(reader);
  const std::vector<std::string> files = unread.empty() && !hasSome ? namedFiles(reader) : unread;
  if (files.empty())
  {
    return;
  }
  const std::string where =
    " in other files, which are not beside it or cannot be read: " + listOf(files) +
    ". Put them into the same folder as STEP files, or export the assembly as one file.";
  if (!hasSome)
  {
    throw CadError("has its parts" + where);
  }
  report.warning("Parts are missing: they are" + where);
}

CadFile tessellatedFile(const std::string& text, const CadReport& report)
{
  const std::string placement = unreadPlacement(text);
  if (!placement.empty())
  {
    throw CadError("holds tessellated solids (AP242)" + placement);
  }
  report.note(std::string("The file has triangles instead of exact shapes. ") + AsTheyAre);
  CadFile file;
  file.parts = tessellatedParts(text, false);
  if (!hasFaces(file.parts))
  {
    throw CadError(
      "holds triangles that belong to no solid, or is damaged. Export exact shapes (BREP).");
  }
  return file;
}

// Of products that have no exact shape, beside others that have.
void addTessellated(const std::string& text, std::vector<CadPart>& parts, const CadReport& report)
{
  std::vector<CadPart> more;
  try
  {
    more = tessellatedParts(text, true);
  }
  catch (const CadError& error)
  {
    report.warning(
      std::string("Tessellated solids (AP242) are left out. The file ") + error.what());
  }
  std::set<std::string> unique;
  for (const CadPart& part : more)
  {
    unique.insert(part.name.empty() ? "one without a name" : part.name);
  }
  const std::string names = listOf({ unique.begin(), unique.end() });
  const std::string placement = unreadPlacement(text);
  if (!more.empty() && !placement.empty())
  {
    report.warning("Left out: " + names + ", tessellated solids (AP242)" + placement);
  }
  else if (!more.empty())
  {
    report.note("Triangles instead of exact shapes have: " + names + ". " + AsTheyAre);
    std::move(more.begin(), more.end(), std::back_inserter(parts));
  }
}

CadFile readStep(const std::string& path, const CadOptions& options, const CadReport& report)
{
  STEPCAFControl_Controller::Init(); // before any parameter
  STEPCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 0);
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_True);
  std::string text;
  checkRead(readStepModel(reader, path, options, text, report), "STEP");
  const bool isTessellated = holdsTriangles(text);
  text = isTessellated ? text : std::string();
  noteDamage(reader.Reader().WS()->Model(), report);
  report.progress(0.3);
  Handle(TDocStd_Document) document = newDocument();
  const Handle(CadProgress) progress = new CadProgress(report, 0.3, 0.5);
  CadFile file;
  const bool isTransferred = reader.Transfer(document, progress->Start());
  if (isTransferred)
  {
    file.parts = partsOf(document, namesOfShapes(reader.Reader().WS(), report));
  }
  if (isTessellated && !hasFaces(file.parts))
  {
    return tessellatedFile(text, report);
  }
  if (isTessellated)
  {
    addTessellated(text, file.parts, report);
  }
  tellUnread(reader, hasFaces(file.parts), report);
  if (!isTransferred)
  {
    throw CadError(NoShapes);
  }
  return file;
}

// Entities, not the file, which counts the bytes of its texts.
void setNames(const Handle(Interface_InterfaceModel) & model, CadEncoding encoding)
{
  const auto converted = [&](const Handle(TCollection_HAsciiString) & text) {
    return new TCollection_HAsciiString(toUtf8(text->ToCString(), encoding).c_str());
  };
  for (int i = 1; i <= model->NbEntities(); ++i)
  {
    const Handle(IGESBasic_Name) name = Handle(IGESBasic_Name)::DownCast(model->Value(i));
    const Handle(IGESData_IGESEntity) entity =
      Handle(IGESData_IGESEntity)::DownCast(model->Value(i));
    if (!name.IsNull() && !name->Value().IsNull())
    {
      name->Init(name->NbPropertyValues(), converted(name->Value()));
    }
    if (!entity.IsNull() && entity->HasShortLabel())
    {
      entity->SetLabel(converted(entity->ShortLabel()), entity->SubScriptNumber());
    }
  }
}

CadFile readIges(const std::string& path, const CadOptions& options, const CadReport& report)
{
  STEPCAFControl_Controller::Init();
  IGESCAFControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  reader.SetColorMode(Standard_True);
  reader.SetNameMode(Standard_True);
  reader.SetLayerMode(Standard_True);
  const CadEncoding encoding = encodingOf(contentOf(path), options.encoding, report);
  checkRead(reader.ReadFile(path.c_str()), "IGES");
  if (encoding != CadEncoding::Utf8)
  {
    setNames(reader.WS()->Model(), encoding);
  }
  noteDamage(reader.WS()->Model(), report);
  report.progress(0.3);
  Handle(TDocStd_Document) document = newDocument();
  const Handle(CadProgress) progress = new CadProgress(report, 0.3, 0.5);
  if (!reader.Transfer(document, progress->Start()))
  {
    throw CadError(NoShapes);
  }
  CadFile file;
  tellLostGeometry(reader.WS(), report);
  file.parts = partsOf(document, {});
  file.hasTopology = false;
  return file;
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
  CadFile file;
  file.parts = partsOf(document, {});
  return file;
}

}

CadFile readCadFile(const std::string& given, const CadOptions& options, const CadReport& report)
{
  // Files that this one refers to are sought beside it.
  const std::string path = std::filesystem::absolute(given).string();
  std::string suffix = std::filesystem::path(path).extension().string();
  std::transform(
    suffix.begin(), suffix.end(), suffix.begin(), [](unsigned char c) { return std::tolower(c); });
  CadFile file = suffix == ".igs" || suffix == ".iges" ? readIges(path, options, report)
    : suffix == ".brep"                                ? readBrep(path)
                                                       : readStep(path, options, report);
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
