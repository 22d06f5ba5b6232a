#pragma once

#include <TDF_Label.hxx>
#include <TDocStd_Document.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>

#include <string>
#include <utility>
#include <vector>

namespace cartesian
{

// Parts and assemblies with their names, colours and layers (an XCAF document), and the files written of them.
// Lengths are millimetres; strings are UTF-8. Failures throw std::runtime_error.
class Document
{
public:
  Document();
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;
  ~Document();

  // A part that stands by itself, or that assemblies place.
  TDF_Label add(const TopoDS_Shape& shape, const std::string& name);
  TDF_Label addAssembly(const std::string& name);
  void place(const TDF_Label& assembly, const TDF_Label& part, const std::string& name,
    const gp_Trsf& where = {});

  // A face or solid of a part that was added.
  void nameSubshape(const TopoDS_Shape& subshape, const std::string& name);
  void colour(const TopoDS_Face& face, const std::string& hexadecimal);
  void putInLayer(const TopoDS_Face& face, const std::string& layer);

  // All faces and solids with what they were named, coloured ("00FF00") or put in.
  const std::vector<std::pair<TopoDS_Shape, std::string>>& boundaries() const
  {
    return boundaries_;
  }
  // All that no assembly places, with all instances.
  TopoDS_Shape shape() const;

  // Units and schemas are called as OCCT calls them ("MM", "M", "INCH"; "AP203", "AP214IS", "AP242DIS").
  void writeStep(const std::string& path, const std::string& unit = "MM",
    const std::string& schema = "AP214IS") const;
  // Each part goes into a file of its own beside this one, which refers to it.
  void writeStepOfSeveralFiles(const std::string& path) const;
  void writeIges(const std::string& path) const;

private:
  TDF_Label labelOf(const TopoDS_Face& face) const;

  Handle(TDocStd_Document) document_;
  std::vector<TDF_Label> parts_;
  std::vector<std::pair<TopoDS_Shape, std::string>> names_;
  std::vector<std::pair<TopoDS_Shape, std::string>> boundaries_;
};

enum class IgesForm
{
  Faces, // trimmed surfaces, each by itself
  Solid  // entities of a boundary representation
};
void writeIgesShape(const TopoDS_Shape& shape, const std::string& path, IgesForm form,
  const std::string& unit = "MM");
void writeBrep(const TopoDS_Shape& shape, const std::string& path);

}
