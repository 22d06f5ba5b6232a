// SPDX-License-Identifier: BSD-3-Clause
// What is wrong with the user's input: what, where, what to do.
#pragma once

#include <array>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace cartesian
{

// Codes are public: the filters pass them on as ErrorCode (vtkCartesianAlgorithm.h).
enum class Fault
{
  EmptySurface = 1,  // no triangles
  BadCoordinate = 2, // NaN, infinite, or beyond what the lattice can hold
  BadCellSize = 3,   // zero, negative, NaN, or below the lattice's resolution
  BadMeshlines = 4,  // not increasing, fewer than two, or away from the surface
  TooManyBoxes = 5,  // the estimate exceeds the memory limit
  MissingArray = 6,  // an array is not there or has the wrong length or type
  FlawedSurface = 7, // open or inconsistent: meshed as far as possible
  BadParameter = 8,  // out of its range
  Stopped = 9,       // by the user
  OutOfMemory = 10,
  BadMesh = 11,     // cells to write that overlap, are turned inside out, or too many
  CannotWrite = 12, // a file cannot be written
};

// A number for a message: as long as it needs to be, at most six digits.
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
