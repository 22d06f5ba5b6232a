// SPDX-License-Identifier: BSD-3-Clause
// Errors for the user: what is wrong, where, and what to do about it.
#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace cartesian
{

// The codes are public: the filters pass them on as ErrorCode (vtkCartesianAlgorithm.h).
enum class Fault
{
  EmptySurface = 1,  // no triangles
  BadCoordinate = 2, // NaN, infinite, or too large for the lattice
  BadCellSize = 3,   // zero, negative, NaN, or below the lattice's resolution
  BadMeshlines = 4,  // not increasing, fewer than two, or missing the surface
  TooManyBoxes = 5,  // the estimate exceeds the memory limit
  MissingArray = 6,  // an array is missing, or has the wrong length or type
  FlawedSurface = 7, // so flawed that there is nothing to mesh
  BadParameter = 8,  // out of range
  Stopped = 9,       // by the user
  OutOfMemory = 10,
  BadMesh = 11,     // its cells overlap, are inside out, or are too many to write
  CannotWrite = 12, // a file cannot be written
  CannotRead = 13,
};

// Formats a number for a message, with at most six significant digits.
inline std::string number(double x)
{
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.6g", x);
  return text.data();
}

struct Error : std::runtime_error
{
  Error(Fault what, const std::string& message)
    : std::runtime_error(message)
    , fault(what)
  {
  }
  Fault fault;
};

}
