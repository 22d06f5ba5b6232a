// SPDX-License-Identifier: BSD-3-Clause
// The processes (ranks of MPI) that make a mesh together, each a piece of it.
#pragma once

#include "vtkSmartPointer.h"

#include <cstddef>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;

namespace cartesian
{

class Processes
{
public:
  // This one alone.
  Processes() = default;

  // Those of the global controller, if each of them is asked for the piece of its own number: all call
  // the functions below then, each as often as the others.
  Processes(int piece, int pieces);

  bool areSeveral() const { return controller_ != nullptr; }
  std::size_t ownNumber() const;

  // Of each process, in order, its numbers.
  std::vector<std::vector<double>> gather(const std::vector<double>& mine) const;

  // Of all processes together; each has as many numbers.
  std::vector<double> sum(const std::vector<double>& mine) const;

  // A surface, in one piece or in blocks, as a whole: the same on all processes. It may be there on each
  // of them, or on one, or they may have a part of it each, in the same blocks.
  // Throws Error (EmptySurface): blocks are not the same.
  vtkSmartPointer<vtkDataObject> whole(vtkDataObject* surface) const;

private:
  vtkMultiProcessController* controller_ = nullptr;
};

}
