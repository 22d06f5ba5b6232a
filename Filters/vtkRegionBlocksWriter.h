// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkRegionBlocksWriter
 * @brief writes an unstructured grid as VTK files with one block for each region
 *
 * Input, several processes and errors: see vtkWholeMeshWriter. A file whose name ends with .vtpc is a
 * vtkPartitionedDataSetCollection, any other a vtkMultiBlockDataSet (.vtm); blocks, in a folder beside it, have the
 * cells of one region (cell array Region) with all their arrays, and its name (field data RegionNames). A mesh
 * without regions is one block. Interfaces have the same points on both sides, bit for bit.
 *
 * @sa vtkPolyMeshWriter vtkCGNSMeshWriter
 */
#ifndef vtkRegionBlocksWriter_h
#define vtkRegionBlocksWriter_h

#include "vtkWholeMeshWriter.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkRegionBlocksWriter : public vtkWholeMeshWriter
{
public:
  static vtkRegionBlocksWriter* New();
  vtkTypeMacro(vtkRegionBlocksWriter, vtkWholeMeshWriter);

protected:
  vtkRegionBlocksWriter() = default;
  ~vtkRegionBlocksWriter() override = default;

  void WriteGrid(vtkUnstructuredGrid* grid) override;

private:
  vtkRegionBlocksWriter(const vtkRegionBlocksWriter&) = delete;
  void operator=(const vtkRegionBlocksWriter&) = delete;
};

#endif
