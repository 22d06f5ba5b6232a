// SPDX-License-Identifier: BSD-3-Clause
// The processes (MPI ranks) that make a mesh together, each a piece of it.
#pragma once

#include "vtkSmartPointer.h"

#include <cstddef>
#include <cstring>
#include <type_traits>
#include <vector>

class vtkDataObject;
class vtkMultiProcessController;
class vtkUnstructuredGrid;

namespace cartesian
{

class Processes
{
public:
  // This process alone.
  Processes() = default;

  // The processes of the global controller, if each is asked for the piece with its number. Then all of them must
  // call the functions below, equally often.
  Processes(int piece, int pieces);

  bool areSeveral() const { return controller_ != nullptr; }
  std::size_t ownNumber() const;

  // The numbers of each process, in order.
  std::vector<std::vector<double>> gather(const std::vector<double>& mine) const;

  // The rows of all processes, each of which may have some of them or all, in the order of processes. A row is numbers only.
  template <class Row>
  std::vector<Row> all(const std::vector<Row>& mine) const
  {
    static_assert(std::is_trivially_copyable_v<Row> && sizeof(Row) % sizeof(double) == 0);
    if (!areSeveral())
    {
      return mine;
    }
    std::vector<double> numbers(mine.size() * (sizeof(Row) / sizeof(double)));
    std::memcpy(numbers.data(), mine.data(), mine.size() * sizeof(Row));
    std::vector<Row> rows;
    for (const std::vector<double>& theirs : gather(numbers))
    {
      const std::size_t before = rows.size();
      rows.resize(before + theirs.size() * sizeof(double) / sizeof(Row));
      std::memcpy(rows.data() + before, theirs.data(), theirs.size() * sizeof(double));
    }
    return rows;
  }

  // The sums over all processes, each of which has as many numbers.
  std::vector<double> sum(const std::vector<double>& mine) const;

  // Gives a grid to another process for one of its; both must call this, and each its others in ascending order.
  vtkSmartPointer<vtkUnstructuredGrid> exchange(
    vtkUnstructuredGrid* mine, std::size_t process) const;

  // Tells the others that this process failed, so that they need not go on; all must call
  // forgetFailures() after they have gathered who failed.
  void tellFailure() const;
  void forgetFailures(const std::vector<std::size_t>& ofProcesses) const;

  // Whether one of the others has told so.
  bool hasOtherFailed() const;

  // The whole surface, in one piece or in blocks, the same on all processes. Beforehand each process may
  // have all of it, or one of them, or each may have a part, in the same blocks.
  // Throws Error (EmptySurface): the blocks differ.
  vtkSmartPointer<vtkDataObject> whole(vtkDataObject* surface) const;

private:
  vtkMultiProcessController* controller_ = nullptr;
};

}
