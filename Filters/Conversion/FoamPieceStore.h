// SPDX-License-Identifier: BSD-3-Clause
// A piece of a mesh in a file while the others are made, so that memory holds only one.
#pragma once

#include "OpenFoam/FoamPieces.h"

#include <filesystem>

namespace cartesian
{

class FoamPieceStore
{
public:
  // Throws Error (CannotWrite).
  FoamPieceStore(const FoamPiece& piece, std::filesystem::path file);

  // Removes the file.
  ~FoamPieceStore();

  FoamPieceStore(FoamPieceStore&& other) noexcept;
  FoamPieceStore& operator=(FoamPieceStore&&) = delete;
  FoamPieceStore(const FoamPieceStore&) = delete;
  FoamPieceStore& operator=(const FoamPieceStore&) = delete;

  // Throws Error (CannotWrite).
  FoamPiece load() const;

private:
  std::filesystem::path file_;
};

}
