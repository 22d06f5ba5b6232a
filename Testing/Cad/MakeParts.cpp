// make-cad-parts FOLDER: CAD files whose volumes, areas and names are known exactly, and facts.json with these.
#include "Parts.h"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <stdexcept>

namespace cartesian
{

namespace
{

void make(Folder& folder, const std::map<std::string, Part>& parts)
{
  for (const auto& [name, part] : parts)
  {
    try
    {
      part(folder);
    }
    catch (const Standard_Failure& failure)
    {
      throw std::runtime_error(name + ": " + failure.GetMessageString());
    }
    catch (const std::exception& error)
    {
      throw std::runtime_error(name + ": " + error.what());
    }
  }
}

}

void Folder::step(const std::string& file, const Document& document, const Facts& facts,
  const std::string& unit, const std::string& schema)
{
  check(facts, document.shape(), document.boundaries());
  document.writeStep(path_ + "/" + file, unit, schema);
  facts_[file] = json(facts);
}

void Folder::stepOfSeveralFiles(
  const std::string& file, const Document& document, const Facts& facts)
{
  check(facts, document.shape(), document.boundaries());
  document.writeStepOfSeveralFiles(path_ + "/" + file);
  facts_[file] = json(facts);
}

void Folder::iges(const std::string& file, const Document& document, const Facts& facts)
{
  check(facts, document.shape(), document.boundaries());
  document.writeIges(path_ + "/" + file);
  facts_[file] = json(facts);
}

void Folder::iges(const std::string& file, const TopoDS_Shape& shape, IgesForm form,
  const Facts& facts, const std::string& unit)
{
  check(facts, shape);
  writeIgesShape(shape, path_ + "/" + file, form, unit);
  facts_[file] = json(facts);
}

void Folder::brep(const std::string& file, const TopoDS_Shape& shape, const Facts& facts)
{
  check(facts, shape);
  writeBrep(shape, path_ + "/" + file);
  facts_[file] = json(facts);
}

void Folder::damaged(const std::string& file, const TopoDS_Shape& shape, const Facts& facts,
  const std::function<void()>& damage)
{
  check(facts, shape);
  damage();
  writeBrep(shape, path_ + "/" + file);
  facts_[file] = json(facts);
}

void Folder::copy(
  const std::string& file, const std::string& to, const std::string& what, const std::string& by)
{
  std::ostringstream content;
  content << std::ifstream(path_ + "/" + file).rdbuf();
  std::string text = content.str();
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at))
  {
    text.replace(at, what.size(), by);
    at += by.size();
  }
  std::ofstream(path_ + "/" + to) << text;
  facts_[to] = facts_[file];
}

void Folder::text(const std::string& file, const std::string& content)
{
  std::ofstream(path_ + "/" + file) << content;
  facts_[file] = json({});
}

void Folder::writeFacts() const
{
  std::ofstream stream(path_ + "/facts.json");
  const char* separator = "{\n";
  for (const auto& [file, facts] : facts_)
  {
    stream << separator << '"' << file << "\": " << facts;
    separator = ",\n";
  }
  stream << "\n}\n";
  if (!stream.flush())
  {
    throw std::runtime_error(path_ + "/facts.json could not be written");
  }
}

}

int main(int count, char** arguments)
{
  using namespace cartesian;
  if (count != 2)
  {
    std::cerr << "usage: make-cad-parts FOLDER\n";
    return EXIT_FAILURE;
  }
  try
  {
    Message::DefaultMessenger()->ChangePrinters().Clear(); // statistics of every file
    std::filesystem::create_directories(arguments[1]);
    // OCCT writes files of parts to their place by an absolute path only.
    Folder folder(std::filesystem::absolute(arguments[1]).string());
    for (const auto& parts :
      { NamedParts, Assemblies, Solids, Surfaces, Curved, Variants, Damaged })
    {
      make(folder, parts);
    }
    folder.writeFacts();
  }
  catch (const std::exception& error)
  {
    std::cerr << "make-cad-parts: " << error.what() << '\n';
    return EXIT_FAILURE;
  }
  return EXIT_SUCCESS;
}
