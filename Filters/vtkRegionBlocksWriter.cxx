// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRegionBlocksWriter.h"

#include "Base/Error.h"

#include "vtkCellData.h"
#include "vtkCompositeDataSet.h"
#include "vtkDummyController.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkIntArray.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkObjectFactory.h"
#include "vtkPartitionedDataSetCollection.h"
#include "vtkStringArray.h"
#include "vtkThreshold.h"
#include "vtkUnstructuredGrid.h"
#include "vtkXMLMultiBlockDataWriter.h"
#include "vtkXMLPartitionedDataSetCollectionWriter.h"

#include <set>
#include <string>
#include <utility>
#include <vector>

vtkStandardNewMacro(vtkRegionBlocksWriter);

namespace
{

using Blocks = std::vector<std::pair<std::string, vtkSmartPointer<vtkUnstructuredGrid>>>;

std::string NameOf(vtkUnstructuredGrid* grid, int region)
{
  auto* names = vtkStringArray::SafeDownCast(grid->GetFieldData()->GetAbstractArray("RegionNames"));
  const bool isNamed = names && region > 0 && region <= names->GetNumberOfValues();
  return isNamed ? std::string(names->GetValue(region - 1)) : "region_" + std::to_string(region);
}

// In order of their numbers.
Blocks BlocksOf(vtkUnstructuredGrid* grid)
{
  auto* regions = vtkIntArray::SafeDownCast(grid->GetCellData()->GetArray("Region"));
  std::set<int> numbers;
  for (vtkIdType cell = 0; regions && cell < grid->GetNumberOfCells(); ++cell)
  {
    numbers.insert(regions->GetValue(cell));
  }
  if (numbers.size() < 2)
  {
    return { { NameOf(grid, numbers.empty() ? 1 : *numbers.begin()), grid } };
  }
  Blocks blocks;
  for (const int region : numbers)
  {
    vtkNew<vtkThreshold> own;
    own->SetInputData(grid);
    own->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_CELLS, "Region");
    own->SetThresholdFunction(vtkThreshold::THRESHOLD_BETWEEN);
    own->SetLowerThreshold(region);
    own->SetUpperThreshold(region);
    own->Update();
    blocks.emplace_back(NameOf(grid, region), own->GetOutput());
  }
  return blocks;
}

vtkSmartPointer<vtkDataObject> MultiBlock(const Blocks& blocks)
{
  auto all = vtkSmartPointer<vtkMultiBlockDataSet>::New();
  for (unsigned int i = 0; i < blocks.size(); ++i)
  {
    all->SetBlock(i, blocks[i].second);
    all->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), blocks[i].first.c_str());
  }
  return all;
}

vtkSmartPointer<vtkDataObject> Collection(const Blocks& blocks)
{
  auto all = vtkSmartPointer<vtkPartitionedDataSetCollection>::New();
  for (unsigned int i = 0; i < blocks.size(); ++i)
  {
    all->SetPartition(i, 0, blocks[i].second);
    all->GetMetaData(i)->Set(vtkCompositeDataSet::NAME(), blocks[i].first.c_str());
  }
  return all;
}

template <class Writer>
bool WriteBlocks(Writer* writer, vtkDataObject* blocks, const char* name)
{
  writer->SetInputDataObject(blocks);
  writer->SetFileName(name);
  writer->SetDataModeToBinary(); // ParaView 5.11 on Debian 12 cannot read back appended data
  return writer->Write() != 0 && writer->GetErrorCode() == vtkErrorCode::NoError;
}

bool WriteMultiBlock(const Blocks& blocks, const char* name)
{
  vtkNew<vtkXMLMultiBlockDataWriter> writer;
  return WriteBlocks(writer.Get(), MultiBlock(blocks), name);
}

bool WriteCollection(const Blocks& blocks, const char* name)
{
  vtkNew<vtkXMLPartitionedDataSetCollectionWriter> writer;
  vtkNew<vtkDummyController> alone; // other processes do not write
  writer->SetController(alone);
  return WriteBlocks(writer.Get(), Collection(blocks), name);
}

}

void vtkRegionBlocksWriter::WriteGrid(vtkUnstructuredGrid* grid)
{
  if (grid->GetNumberOfCells() == 0)
  {
    throw cartesian::Error(
      cartesian::Fault::BadMesh, "There are no cells to write: connect a mesh.");
  }
  const Blocks blocks = BlocksOf(grid);
  this->UpdateProgress(0.5);
  const std::string name = this->FileName;
  constexpr const char* OfCollections = ".vtpc";
  const bool isCollection = name.size() > 5 && name.compare(name.size() - 5, 5, OfCollections) == 0;
  const bool isWritten = isCollection ? WriteCollection(blocks, this->FileName)
                                      : WriteMultiBlock(blocks, this->FileName);
  if (!isWritten)
  {
    throw cartesian::Error(cartesian::Fault::CannotWrite,
      "Cannot write " + name + ": choose another folder, or free disk space.");
  }
}
