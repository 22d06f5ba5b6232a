// SPDX-License-Identifier: BSD-3-Clause
// The files of the folder system without which checkMesh does not run.
#pragma once

#include <filesystem>
#include <string>

namespace cartesian
{

// Writes controlDict, fvSchemes and fvSolution into `folder`/system, or the latter two into system/`region`, where they
// are missing. Throws Error: CannotWrite.
void writeLeastSystem(const std::filesystem::path& folder, const std::string& region);

// decomposeParDict: OpenFOAM 1912 reads the number of processes from it.
std::string decompositionOf(int pieces);

// Whether a file is as writeLeastSystem() has written it.
bool isLeast(const std::filesystem::path& path);

}
