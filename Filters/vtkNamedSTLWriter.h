// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNamedSTLWriter
 * @brief writes an STL file with a named solid for each boundary
 *
 * Input: a surface (vtkPolyData). If it has boundaries with names (the cell array BoundaryName, or BoundaryId or
 * STLSolidLabeling with the field data BoundaryIds and BoundaryNames), the file is in ASCII, whatever FileType says: binary
 * STL has no names. Coordinates are written without loss; an existing file is replaced when the new one is complete.
 * Otherwise the file is that of vtkSTLWriter.
 *
 * Errors (GetErrorCode): those of vtkSTLWriter; MissingArray, CannotWrite of vtkCartesianAlgorithm.
 *
 * @sa vtkNamedSTLReader vtkSplitSurface
 */
#ifndef vtkNamedSTLWriter_h
#define vtkNamedSTLWriter_h

#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkSTLWriter.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkNamedSTLWriter : public vtkSTLWriter
{
public:
  static vtkNamedSTLWriter* New();
  vtkTypeMacro(vtkNamedSTLWriter, vtkSTLWriter);

protected:
  vtkNamedSTLWriter() = default;
  ~vtkNamedSTLWriter() override = default;

  void WriteData() override;

private:
  vtkNamedSTLWriter(const vtkNamedSTLWriter&) = delete;
  void operator=(const vtkNamedSTLWriter&) = delete;
};

#endif
