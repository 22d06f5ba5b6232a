#pragma once

#include "Document.h"
#include "Facts.h"

#include <functional>
#include <map>
#include <string>

namespace cartesian
{

// Where the files go, and what is exactly true of them.
class Folder
{
public:
  explicit Folder(const std::string& path)
    : path_(path)
  {
  }

  // Checks the facts, then writes the file.
  void step(const std::string& file, const Document& document, const Facts& facts,
    const std::string& unit = "MM", const std::string& schema = "AP214IS");
  void stepOfSeveralFiles(const std::string& file, const Document& document, const Facts& facts);
  void iges(const std::string& file, const Document& document, const Facts& facts);
  void iges(const std::string& file, const TopoDS_Shape& shape, IgesForm form, const Facts& facts,
    const std::string& unit = "MM");
  void brep(const std::string& file, const TopoDS_Shape& shape, const Facts& facts);
  // The facts are those before the damage.
  void damaged(const std::string& file, const TopoDS_Shape& shape, const Facts& facts,
    const std::function<void()>& damage);
  // The same facts in other words: all of *what* replaced.
  void copy(
    const std::string& file, const std::string& to, const std::string& what, const std::string& by);
  // A file with nothing to mesh: readers say so.
  void text(const std::string& file, const std::string& content);

  // facts.json: one line a file.
  void writeFacts() const;

private:
  std::string path_;
  std::map<std::string, std::string> facts_;
};

// One function a part; comments there say what it is for.
using Part = void (*)(Folder&);
extern const std::map<std::string, Part> NamedParts, Assemblies, Solids, Surfaces, Curved, Variants,
  Damaged;

}
