// SPDX-License-Identifier: BSD-3-Clause
// OpenFOAM's file constant/polyMesh/boundary: the patches and their entries, which users may edit.
#pragma once

#include "Sections/SideMotion.h"

#include <filesystem>
#include <string>
#include <vector>

namespace cartesian
{

// The patch of another region's mesh that has the same faces; no names: there is none.
struct FoamSample
{
  std::string region = {};
  std::string patch = {};
};

// The processes between which a patch of a piece lies (FoamPieces.h); none: it is no such patch.
struct FoamProcesses
{
  int own = -1;
  int other = -1;
};

struct FoamPatch
{
  std::string name;             // an OpenFOAM word (foamWord), different from all others
  std::size_t count;            // number of faces; none only in a piece
  std::string type = {};        // one of foamTypes(); empty: as in the existing file, else by name
  FoamSample sample = {};       // a new patch that has one is a mappedWall
  FoamProcesses processes = {}; // a new patch that has them is a processor
  std::string
    partner = {}; // that patch is the other of a pair: a cyclicAMI, unless the type is cyclic
  SideMotion motion = {}; // ... with a type: from this patch to that one
  int pair = 0;           // ... the number of the pair, from one; negative on its second side
  double area = 0;        // m2; 0: not known, as of a piece
};

// The types of patches that need no further entries.
const std::vector<std::string>& foamTypes();

// OpenFOAM reads words of up to 1,023 characters; this leaves room for numbers that make equal ones unique.
constexpr std::size_t LongestWord = 1000;

// The name with each character that OpenFOAM does not allow in words replaced by an underscore, cut off after
// LongestWord.
std::string foamWord(const std::string& name);

// Whether flow passes through a boundary, by its name: it begins with inlet, outlet or cyclic, in any case. All
// others are walls, unless they are symmetries.
bool isOpening(const std::string& name);

// Whether a boundary is a symmetry, by its name: it begins with symmetry, in upper or lower case.
bool isSymmetry(const std::string& name);

// The kind of a boundary for solvers other than OpenFOAM's: by its type or, without one, by its name.
enum class BoundaryKind
{
  Wall,
  Symmetry,
  Inlet,
  Outlet,
  Opening // another
};

BoundaryKind kindOf(const FoamPatch& patch);

// Of several regions: fluid or solid, as its name begins, in any case; else fluid if flow passes through one of its
// patches, by type or, without one, by name.
bool isFluid(const std::string& region, const std::vector<FoamPatch>& patches);

// The entries of each patch, the text between its brackets.
class FoamBoundary
{
public:
  // Patches without a type get the one that follows from their names.
  explicit FoamBoundary(const std::vector<FoamPatch>& patches);

  // Reads a file. There are no patches if it holds anything but patches with plain entries.
  explicit FoamBoundary(const std::filesystem::path& path);

  bool hasNamesOf(const std::vector<FoamPatch>& patches) const;

  // The same patches with the types that they have in the file.
  std::vector<FoamPatch> typed(const std::vector<FoamPatch>& patches) const;

  // The file's list of patches, with faces numbered from `start`. Entries stay as they are, except for the
  // numbers of faces, and for the type where `patches` have one.
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
