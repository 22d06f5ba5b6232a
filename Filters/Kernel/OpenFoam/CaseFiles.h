// SPDX-License-Identifier: BSD-3-Clause
// The files of a case that are text: fields of uniform start values, dictionaries, a script.
#pragma once

#include "OpenFoam/CaseTemplates.h"
#include "OpenFoam/SolverSetup.h"

#include <functional>

namespace cartesian
{

struct FieldOfCase
{
  std::string name;
  bool isVector;
  std::string dimensions; // such as "[0 1 -1 0 0 0 0]"
  std::string start;      // value everywhere
};

// All methods throw Error (CannotWrite).
class CaseFiles
{
public:
  CaseFiles(
    std::filesystem::path folder, const CaseTemplates& templates, bool overwrites, int pieces);

  // Of a template (CaseTemplates.h).
  std::string text(const std::string& name, const CaseTemplates::Values& values = {}) const
  {
    return templates_.filled(name, values);
  }

  // Where results are, as the shell names it: `whole` of a case in one piece.
  std::string places(const std::string& whole, const std::string& ofPieces) const
  {
    return pieces_ > 1 ? ofPieces : whole;
  }

  // `path`: within the case, such as system/fvSchemes.
  void dictionary(const std::filesystem::path& path, const std::string& text,
    const char* className = "dictionary");

  bool has(const std::filesystem::path& path) const
  {
    return std::filesystem::exists(folder_ / path);
  }

  // The start of a region's field, in each piece. `condition`: a patch's entries, such as "type zeroGradient;"; a patch of
  // a constraint type, such as symmetry, has that type alone.
  void field(const MeshOfCase& mesh, const FieldOfCase& field,
    const std::function<std::string(const FoamPatch&)>& condition);

  // Allrun, of these commands, with -parallel if there are several pieces: "run PROGRAM" with its own log, "more PROGRAM"
  // another time with the same.
  void script(const std::string& commands);

  // Of a case in a folder of this one.
  CaseFiles within(const std::filesystem::path& path) const
  {
    return { folder_ / path, templates_, overwrites_, pieces_ };
  }

  void keep(const std::vector<std::filesystem::path>& kept)
  {
    kept_.insert(kept_.end(), kept.begin(), kept.end());
  }

  // Existing files that are kept.
  const std::vector<std::filesystem::path>& kept() const { return kept_; }

private:
  bool mayWrite(const std::filesystem::path& path);
  void write(const std::filesystem::path& path, const char* className,
    const std::filesystem::path& location, const std::string& text);

  std::filesystem::path folder_;
  const CaseTemplates& templates_;
  bool overwrites_;
  int pieces_;
  std::vector<std::filesystem::path> kept_;
};

// "(0 0 -20)" for a speed of 20 along minus z (FlowAround::direction).
std::string velocityAlong(int direction, double speed);

// "type <type>; value uniform <value>;"
std::string valued(const std::string& type, const std::string& value);

}
