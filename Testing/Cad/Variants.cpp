// One part in other sizes, schemas, files and orientations, and files with nothing in them.
#include "Parts.h"
#include "Shapes.h"

#include <BRepBuilderAPI_MakeEdge.hxx>

namespace cartesian
{

namespace
{

void write(Folder& folder, const std::string& file, double size, const std::string& schema)
{
  Document document;
  document.add(boxWithHole(size, size, size, size / 4), "block");
  Facts facts;
  facts.solids = { boxWithHoleFacts("block", size, size, size, size / 4) };
  facts.faces = 7;
  folder.step(file, document, facts, "MM", schema);
}

void sizes(Folder& folder)
{
  write(folder, "tiny.step", 1e-3, "AP214IS");
  write(folder, "huge.step", 1e6, "AP214IS");
}

void schemas(Folder& folder)
{
  write(folder, "ap203.step", 10, "AP203");
  write(folder, "ap214.step", 10, "AP214IS");
  write(folder, "ap242.step", 10, "AP242DIS");
}

void fileNames(Folder& folder)
{
  write(folder, "Gehäuse mit Loch.step", 10, "AP214IS");
  write(folder, "CAPITALS.STP", 10, "AP214IS");
}

// Its volume is negative until it is turned.
void insideOut(Folder& folder)
{
  const SolidFacts solid = boxFacts("", 10, 10, 10);
  Facts facts;
  facts.solids = { { "", -solid.volume, solid.area } };
  facts.faces = 6;
  folder.brep("inside_out.brep", box(gp::Origin(), { 10, 10, 10 }).Reversed(), facts);
}

void nothing(Folder& folder)
{
  Document document;
  document.add(BRepBuilderAPI_MakeEdge(gp_Pnt(0, 0, 0), gp_Pnt(1, 0, 0)).Shape(), "line");
  folder.step("only_a_line.step", document, {});
  folder.text("empty.step", "");
  folder.text("empty.igs", "");
  folder.text("empty.brep", "");
  folder.text("text.step", "This is no STEP file.\n");
  folder.text("text.igs", "This is no IGES file.\n");
  folder.text("text.brep", "This is no BREP file.\n");
  folder.text("no_data.step",
    "ISO-10303-21;\nHEADER;\nFILE_DESCRIPTION((''),'2;1');\nFILE_NAME('','',(''),(''),'','','');\n"
    "FILE_SCHEMA(('CONFIG_CONTROL_DESIGN'));\nENDSEC;\nDATA;\nENDSEC;\nEND-ISO-10303-21;\n");
}

}

const std::map<std::string, Part> Variants = { { "sizes", sizes }, { "schemas", schemas },
  { "file names", fileNames }, { "inside out", insideOut }, { "nothing", nothing } };

}
