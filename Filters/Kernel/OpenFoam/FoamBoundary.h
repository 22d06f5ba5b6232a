// SPDX-License-Identifier: BSD-3-Clause
// OpenFOAM's file constant/polyMesh/boundary: the patches, and what the user wrote about them.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace cartesian
{

struct FoamPatch
{
  std::string name;  // distinct words (foamWord)
  std::size_t count; // faces, one or more
  std::string
    type = {}; // one of foamTypes(), or empty: as a file that is there says, else by the name
};

// Types of patches that need no entries of their own.
const std::vector<std::string>& foamTypes();

// The name with an underscore for each character that OpenFOAM does not allow in words.
std::string foamWord(const std::string& name);

// The entries of each patch, the text between its brackets.
class FoamBoundary
{
public:
  // Patches without a type: wall where the name starts with "wall" or "Wall", else patch.
  explicit FoamBoundary(const std::vector<FoamPatch>& patches);

  // What a file says; no patches if it holds anything but patches of plain entries.
  explicit FoamBoundary(const std::filesystem::path& path);

  bool hasNamesOf(const std::vector<FoamPatch>& patches) const;

  // The file's list of patches; their faces follow each other from `start`. Other entries than the
  // numbers of faces, and the type where `patches` have one, stay as they are.
  std::string text(const std::vector<FoamPatch>& patches, std::size_t start) const;

private:
  struct Patch
  {
    std::string name;
    std::string entries;
  };

  std::vector<Patch> patches_;
};

}
