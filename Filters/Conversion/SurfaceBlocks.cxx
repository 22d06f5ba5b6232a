// SPDX-License-Identifier: BSD-3-Clause
#include "SurfaceBlocks.h"

#include "Base/Error.h"

#include "vtkCompositeDataSet.h"
#include "vtkInformation.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPartitionedDataSet.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkPolyData.h"

namespace cartesian
{

namespace
{

void collect(
  vtkDataObject* data, const std::string& name, bool isTop, std::vector<SurfaceBlock>& blocks);

// The i-th block of another. Of the one at the top it is a block at the top.
void collectPart(vtkDataObject* data, const std::string& name, std::size_t i, bool isTop,
  std::vector<SurfaceBlock>& blocks)
{
  const std::size_t before = blocks.size();
  collect(data, name, false, blocks);
  for (std::size_t b = before; isTop && b < blocks.size(); ++b)
  {
    blocks[b].top = i;
    blocks[b].topName = name;
  }
}

std::string nameIn(vtkInformation* information, const std::string& parent)
{
  const char* name = information ? information->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? name : parent;
}

void collectBlocks(vtkMultiBlockDataSet* data, const std::string& parent, bool isTop,
  std::vector<SurfaceBlock>& blocks)
{
  for (unsigned i = 0; i < data->GetNumberOfBlocks(); ++i)
  {
    // GetMetaData() would create some.
    vtkInformation* information = data->HasMetaData(i) ? data->GetMetaData(i) : nullptr;
    collectPart(data->GetBlock(i), nameIn(information, parent), i, isTop, blocks);
  }
}

void collectPartitions(vtkPartitionedDataSet* data, const std::string& parent, bool isTop,
  std::vector<SurfaceBlock>& blocks)
{
  for (unsigned i = 0; i < data->GetNumberOfPartitions(); ++i)
  {
    vtkInformation* information = data->HasMetaData(i) ? data->GetMetaData(i) : nullptr;
    collectPart(data->GetPartitionAsDataObject(i), nameIn(information, parent), i, isTop, blocks);
  }
}

void collectDataSets(
  vtkPartitionedDataSetCollection* data, bool isTop, std::vector<SurfaceBlock>& blocks)
{
  for (unsigned i = 0; i < data->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkInformation* information = data->HasMetaData(i) ? data->GetMetaData(i) : nullptr;
    collectPart(data->GetPartitionedDataSet(i), nameIn(information, ""), i, isTop, blocks);
  }
}

void collect(
  vtkDataObject* data, const std::string& name, bool isTop, std::vector<SurfaceBlock>& blocks)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    if (surface->GetPoints() && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
    {
      blocks.push_back({ surface, name, 0, name });
    }
  }
  else if (auto* multi = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    collectBlocks(multi, name, isTop, blocks);
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    collectDataSets(collection, isTop, blocks);
  }
  else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(data))
  {
    collectPartitions(partitions, name, isTop, blocks);
  }
  else if (data) // blocks may be empty
  {
    throw Error(Fault::EmptySurface,
      (name.empty() ? "The input" : "Block \"" + name + "\"") + " is a " + data->GetClassName() +
        ", not a surface: apply Extract Surface to it, or leave it out with Extract Block.");
  }
}

}

std::vector<SurfaceBlock> surfaceBlocks(vtkDataObject* input)
{
  std::vector<SurfaceBlock> blocks;
  collect(input, "", true, blocks);
  if (blocks.empty())
  {
    throw Error(
      Fault::EmptySurface, "The surface has no polygons: connect a closed triangulated surface.");
  }
  return blocks;
}

}
