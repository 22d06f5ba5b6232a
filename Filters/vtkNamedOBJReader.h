// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNamedOBJReader
 * @brief reads an OBJ file with named groups
 *
 * Output: that of vtkOBJReader, with the cell array BoundaryId (int), the group of each face, and field data
 * BoundaryIds (int) and BoundaryNames (string), the numbers that occur and their names. Groups with the same name are
 * one boundary; those without a name and faces before the first group are the boundary "unnamed". If no group has a
 * name, objects take their place.
 *
 * @sa vtkCartesianMesher vtkNamedSTLReader
 */
#ifndef vtkNamedOBJReader_h
#define vtkNamedOBJReader_h

#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkOBJReader.h"

class VTKCARTESIANMESHERFILTERS_EXPORT vtkNamedOBJReader : public vtkOBJReader
{
public:
  static vtkNamedOBJReader* New();
  vtkTypeMacro(vtkNamedOBJReader, vtkOBJReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * 1 if the file has faces in a group or, without such groups, in an object with a name, else 0.
   */
  static int CanReadFile(const char* name);

protected:
  vtkNamedOBJReader() = default;
  ~vtkNamedOBJReader() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  vtkNamedOBJReader(const vtkNamedOBJReader&) = delete;
  void operator=(const vtkNamedOBJReader&) = delete;
};

#endif
