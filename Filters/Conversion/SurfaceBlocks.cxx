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

void collect(vtkDataObject* data, const std::string& name, std::vector<SurfaceBlock>& blocks);

std::string nameIn(vtkInformation* information, const std::string& parent)
{
  const char* name = information ? information->Get(vtkCompositeDataSet::NAME()) : nullptr;
  return name && *name ? name : parent;
}

void collectBlocks(
  vtkMultiBlockDataSet* data, const std::string& parent, std::vector<SurfaceBlock>& blocks)
{
  for (unsigned i = 0; i < data->GetNumberOfBlocks(); ++i)
  {
    // GetMetaData() would create some.
    vtkInformation* information = data->HasMetaData(i) ? data->GetMetaData(i) : nullptr;
    collect(data->GetBlock(i), nameIn(information, parent), blocks);
  }
}

void collectPartitions(
  vtkPartitionedDataSet* data, const std::string& parent, std::vector<SurfaceBlock>& blocks)
{
  for (unsigned i = 0; i < data->GetNumberOfPartitions(); ++i)
  {
    vtkInformation* information = data->HasMetaData(i) ? data->GetMetaData(i) : nullptr;
    collect(data->GetPartitionAsDataObject(i), nameIn(information, parent), blocks);
  }
}

void collectDataSets(vtkPartitionedDataSetCollection* data, std::vector<SurfaceBlock>& blocks)
{
  for (unsigned i = 0; i < data->GetNumberOfPartitionedDataSets(); ++i)
  {
    vtkInformation* information = data->HasMetaData(i) ? data->GetMetaData(i) : nullptr;
    collectPartitions(data->GetPartitionedDataSet(i), nameIn(information, ""), blocks);
  }
}

void collect(vtkDataObject* data, const std::string& name, std::vector<SurfaceBlock>& blocks)
{
  if (auto* surface = vtkPolyData::SafeDownCast(data))
  {
    if (surface->GetPoints() && surface->GetNumberOfPolys() + surface->GetNumberOfStrips() > 0)
    {
      blocks.push_back({ surface, name });
    }
  }
  else if (auto* multi = vtkMultiBlockDataSet::SafeDownCast(data))
  {
    collectBlocks(multi, name, blocks);
  }
  else if (auto* collection = vtkPartitionedDataSetCollection::SafeDownCast(data))
  {
    collectDataSets(collection, blocks);
  }
  else if (auto* partitions = vtkPartitionedDataSet::SafeDownCast(data))
  {
    collectPartitions(partitions, name, blocks);
  }
  else if (data) // blocks may be empty
  {
    throw Error(Fault::EmptySurface,
      (name.empty() ? "The input" : "Block \"" + name + "\"") + " is a " + data->GetClassName() +
        ", no surface: take its surface (Extract Surface), or take it out (Extract Block).");
  }
}

}

std::vector<SurfaceBlock> surfaceBlocks(vtkDataObject* input)
{
  std::vector<SurfaceBlock> blocks;
  collect(input, "", blocks);
  if (blocks.empty())
  {
    throw Error(
      Fault::EmptySurface, "The surface has no polygons: connect a closed triangulated surface.");
  }
  return blocks;
}

}
