// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/CaseFiles.h"

#include "OpenFoam/FoamFile.h"
#include "OpenFoam/LeastSystem.h"
#include "OpenFoam/PolyMeshFiles.h"

namespace cartesian
{

namespace fs = std::filesystem;

CaseFiles::CaseFiles(fs::path folder, const CaseTemplates& templates, bool overwrites, int pieces)
  : folder_(std::move(folder))
  , templates_(templates)
  , overwrites_(overwrites)
  , pieces_(pieces)
{
}

bool CaseFiles::mayWrite(const fs::path& path)
{
  if (!overwrites_ && fs::exists(path) && !isLeast(path))
  {
    kept_.push_back(path);
    return false;
  }
  fs::create_directories(path.parent_path());
  return true;
}

void CaseFiles::write(
  const fs::path& path, const char* className, const fs::path& location, const std::string& text)
{
  if (mayWrite(path))
  {
    FoamFile file(path, FoamFormat::Ascii, { className, location.string(), {} });
    file.text(text);
    file.close();
  }
}

void CaseFiles::dictionary(const fs::path& path, const std::string& text, const char* className)
{
  write(folder_ / path, className, path.parent_path(), text);
}

void CaseFiles::field(const MeshOfCase& mesh, const FieldOfCase& field,
  const std::function<std::string(const FoamPatch&)>& condition)
{
  std::string text = "dimensions      " + field.dimensions + ";\n\ninternalField   uniform " +
    field.start + ";\n\nboundaryField\n{\n";
  for (const FoamPatch& patch : mesh.patches)
  {
    if (patch.type != "processor")
    {
      const bool isConstraint = roleOf(patch, {}) == PatchRole::Constraint;
      text += "    " + patch.name + " { " +
        (isConstraint ? "type " + patch.type + ";" : condition(patch)) + " }\n";
    }
  }
  if (pieces_ > 1)
  {
    text += "    \"procBoundary.*\" { type processor; value uniform " + field.start + "; }\n";
  }
  const fs::path location = mesh.region.empty() ? fs::path("0") : fs::path("0") / mesh.region;
  for (int piece = 0; piece < pieces_; ++piece)
  {
    const fs::path place = pieces_ > 1 ? folderOfProcess(folder_, piece) : folder_;
    write(place / location / field.name, field.isVector ? "volVectorField" : "volScalarField",
      location, text + "}\n");
  }
}

void CaseFiles::script(const std::string& commands)
{
  const fs::path path = folder_ / "Allrun";
  if (mayWrite(path))
  {
    OutputFile file(path);
    const std::string parallel = "mpirun -n " + std::to_string(pieces_) + " \"$@\" -parallel";
    file.text(
      text("Allrun", { { "start", places("\"$@\"", parallel) }, { "commands", commands } }));
    file.close();
    fs::permissions(path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
      fs::perm_options::add);
  }
}

std::string velocityAlong(int direction, double speed)
{
  std::string text = "(";
  for (int axis = 0; axis < 3; ++axis)
  {
    const double sign = direction % 2 == 0 ? 1 : -1;
    text += (axis > 0 ? " " : "") + number(direction / 2 == axis ? sign * speed : 0);
  }
  return text + ")";
}

std::string valued(const std::string& type, const std::string& value)
{
  return "type " + type + "; value uniform " + value + ";";
}

}
