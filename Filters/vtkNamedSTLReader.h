// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNamedSTLReader
 * @brief reads an STL file that names its solids
 *
 * Output: what vtkSTLReader gives, the solids numbered in the cell array STLSolidLabeling, and field
 * data BoundaryIds (int) and BoundaryNames (string): the numbers that occur and their names. Solids
 * of one name are one boundary; so are those without one, "unnamed".
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkNamedSTLReader_h
#define vtkNamedSTLReader_h

#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkSTLReader.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkNamedSTLReader : public vtkSTLReader
{
public:
  static vtkNamedSTLReader* New();
  vtkTypeMacro(vtkNamedSTLReader, vtkSTLReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * 1 if the file is ASCII STL and at least one of its first two solids has a name, else 0.
   */
  static int CanReadFile(const char* name);

protected:
  vtkNamedSTLReader();
  ~vtkNamedSTLReader() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkNamedSTLReader(const vtkNamedSTLReader&) = delete;
  void operator=(const vtkNamedSTLReader&) = delete;
};

#endif
