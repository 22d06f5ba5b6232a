// SPDX-License-Identifier: BSD-3-Clause
#include "Processes.h"

#include "Base/Error.h"

#include "vtkAppendPolyData.h"
#include "vtkCellArray.h"
#include "vtkCompositeDataIterator.h"
#include "vtkCompositeDataSet.h"
#include "vtkDataArray.h"
#include "vtkMultiProcessController.h"
#if VTK_MODULE_ENABLE_VTK_ParallelMPI
#include "vtkMPIController.h"
#endif
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkUnstructuredGrid.h"

#include <cstdint>

namespace cartesian
{

namespace
{

constexpr int FailureTag = 24240;
constexpr int ExchangeTag = 24241;

// Calls visit(surface, iterator) for the leaves, including null ones. Without blocks the iterator is null.
template <class Visitor>
void forEachLeaf(vtkDataObject* data, Visitor&& visit)
{
  auto* composite = vtkCompositeDataSet::SafeDownCast(data);
  if (!composite)
  {
    visit(vtkPolyData::SafeDownCast(data), nullptr);
    return;
  }
  auto leaf = vtk::TakeSmartPointer(composite->NewIterator());
  leaf->SkipEmptyNodesOff();
  for (leaf->InitTraversal(); !leaf->IsDoneWithTraversal(); leaf->GoToNextItem())
  {
    visit(vtkPolyData::SafeDownCast(composite->GetDataSet(leaf)), leaf.Get());
  }
}

// Tells whether two processes have the same surface: sizes, and a hash of points and corners.
std::vector<double> fingerprint(vtkDataObject* data)
{
  constexpr std::uint64_t Prime = 1099511628211u; // FNV-1a
  constexpr std::uint64_t LowBits = 0xffffffffu;
  std::uint64_t hash = 14695981039346656037u;
  std::vector<double> result{ 0, 0 };
  const auto add = [&](vtkDataArray* array) {
    for (vtkIdType i = 0; array && i < array->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        const double x = array->GetComponent(i, c);
        std::uint64_t bits = 0;
        static_assert(sizeof(x) == sizeof(bits));
        std::copy_n(reinterpret_cast<const unsigned char*>(&x), sizeof(x),
          reinterpret_cast<unsigned char*>(&bits));
        hash = (hash ^ bits) * Prime;
        hash ^= hash >> 29;
      }
    }
  };
  forEachLeaf(data, [&](vtkPolyData* surface, vtkCompositeDataIterator*) {
    result[0] += surface ? static_cast<double>(surface->GetNumberOfPoints()) : 0;
    result[1] += surface ? static_cast<double>(surface->GetNumberOfCells()) : 0;
    if (surface && surface->GetPoints())
    {
      add(surface->GetPoints()->GetData());
      add(surface->GetPolys()->GetConnectivityArray());
    }
  });
  result.push_back(static_cast<double>(hash & LowBits));
  result.push_back(static_cast<double>(hash >> 32));
  return result;
}

vtkSmartPointer<vtkPolyData> append(const std::vector<vtkPolyData*>& parts)
{
  vtkNew<vtkAppendPolyData> append;
  for (vtkPolyData* part : parts)
  {
    if (part && part->GetNumberOfCells() > 0)
    {
      append->AddInputData(part);
    }
  }
  if (append->GetNumberOfInputConnections(0) > 0)
  {
    append->Update();
    append->GetOutput()->SetFieldData(append->GetInput(0)->GetFieldData()); // of a block: a solid's
  }
  return append->GetOutput();
}

// Puts the parts together, leaf by leaf.
vtkSmartPointer<vtkDataObject> unite(const std::vector<vtkSmartPointer<vtkDataObject>>& parts)
{
  std::vector<std::vector<vtkPolyData*>> leaves; // of each part
  for (const auto& part : parts)
  {
    leaves.emplace_back();
    forEachLeaf(
      part, [&](vtkPolyData* leaf, vtkCompositeDataIterator*) { leaves.back().push_back(leaf); });
    if (leaves.back().size() != leaves.front().size())
    {
      throw Error(Fault::EmptySurface,
        "The surface has " + std::to_string(leaves.front().size()) +
          " blocks on the first rank, but " + std::to_string(leaves.back().size()) +
          " on another: connect a surface with the same blocks on all ranks.");
    }
  }
  vtkSmartPointer<vtkDataObject> whole;
  auto* structure = vtkCompositeDataSet::SafeDownCast(parts.front());
  vtkSmartPointer<vtkCompositeDataSet> blocks;
  if (structure)
  {
    blocks = vtk::TakeSmartPointer(structure->NewInstance());
    blocks->CopyStructure(structure);
    blocks->SetFieldData(structure->GetFieldData());
    whole = blocks;
  }
  std::size_t n = 0;
  forEachLeaf(parts.front(), [&](vtkPolyData*, vtkCompositeDataIterator* at) {
    std::vector<vtkPolyData*> ofAll;
    ofAll.reserve(leaves.size());
    for (const auto& ofPart : leaves)
    {
      ofAll.push_back(ofPart[n]);
    }
    ++n;
    const vtkSmartPointer<vtkPolyData> leaf = append(ofAll);
    if (!at)
    {
      leaf->SetFieldData(parts.front()->GetFieldData());
      whole = leaf;
    }
    else if (leaf->GetNumberOfCells() > 0)
    {
      blocks->SetDataSet(at, leaf);
    }
  });
  return whole;
}

}

Processes::Processes(int piece, int pieces)
{
  vtkMultiProcessController* all = vtkMultiProcessController::GetGlobalController();
  if (pieces > 1 && all && all->GetNumberOfProcesses() == pieces &&
    all->GetLocalProcessId() == piece)
  {
    controller_ = all;
  }
}

std::size_t Processes::ownNumber() const
{
  return controller_ ? static_cast<std::size_t>(controller_->GetLocalProcessId()) : 0;
}

std::vector<std::vector<double>> Processes::gather(const std::vector<double>& mine) const
{
  if (!controller_)
  {
    return { mine };
  }
  const auto length = static_cast<vtkIdType>(mine.size());
  const auto count = static_cast<std::size_t>(controller_->GetNumberOfProcesses());
  std::vector<vtkIdType> lengths(count);
  controller_->AllGather(&length, lengths.data(), 1);
  std::vector<vtkIdType> offsets(count);
  vtkIdType sum = 0;
  for (std::size_t i = 0; i < count; ++i)
  {
    offsets[i] = sum;
    sum += lengths[i];
  }
  std::vector<double> all(static_cast<std::size_t>(sum));
  controller_->AllGatherV(mine.data(), all.data(), length, lengths.data(), offsets.data());
  std::vector<std::vector<double>> rows;
  for (std::size_t i = 0; i < count; ++i)
  {
    const auto begin = all.begin() + offsets[i];
    rows.emplace_back(begin, begin + lengths[i]);
  }
  return rows;
}

vtkSmartPointer<vtkUnstructuredGrid> Processes::exchange(
  vtkUnstructuredGrid* mine, std::size_t process) const
{
  const int other = static_cast<int>(process);
  vtkNew<vtkUnstructuredGrid> theirs;
  // In any order, two that send at once would wait for each other.
  if (process > this->ownNumber())
  {
    controller_->Send(mine, other, ExchangeTag);
  }
  controller_->Receive(theirs, other, ExchangeTag);
  if (process < this->ownNumber())
  {
    controller_->Send(mine, other, ExchangeTag);
  }
  return theirs;
}

void Processes::tellFailure() const
{
  for (int process = 0; controller_ && process < controller_->GetNumberOfProcesses(); ++process)
  {
    const int failed = 1;
    if (process != controller_->GetLocalProcessId())
    {
      controller_->Send(&failed, 1, process, FailureTag);
    }
  }
}

void Processes::forgetFailures(const std::vector<std::size_t>& ofProcesses) const
{
  for (const std::size_t process : ofProcesses)
  {
    int failed = 0;
    if (process != this->ownNumber())
    {
      controller_->Receive(&failed, 1, static_cast<int>(process), FailureTag);
    }
  }
}

bool Processes::hasOtherFailed() const
{
  int failed = 0;
#if VTK_MODULE_ENABLE_VTK_ParallelMPI
  if (auto* controller = vtkMPIController::SafeDownCast(controller_))
  {
    int process = 0;
    controller->Iprobe(vtkMultiProcessController::ANY_SOURCE, FailureTag, &failed, &process);
  }
#endif
  return failed != 0;
}

std::vector<double> Processes::sum(const std::vector<double>& mine) const
{
  std::vector<double> sums(mine.size());
  for (const std::vector<double>& row : this->gather(mine))
  {
    for (std::size_t i = 0; i < sums.size(); ++i)
    {
      sums[i] += row[i];
    }
  }
  return sums;
}

vtkSmartPointer<vtkDataObject> Processes::whole(vtkDataObject* surface) const
{
  if (!this->areSeveral())
  {
    return surface;
  }
  const std::vector<std::vector<double>> prints = this->gather(fingerprint(surface));
  if (std::all_of(prints.begin(), prints.end(), [&](const auto& x) { return x == prints[0]; }))
  {
    return surface;
  }
  std::vector<vtkSmartPointer<vtkDataObject>> parts;
  controller_->AllGather(surface, parts);
  return unite(parts);
}

}
