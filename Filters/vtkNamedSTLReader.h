// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkNamedSTLReader
 * @brief reads an STL file with named solids
 *
 * Output: that of vtkSTLReader, with the solids numbered in the cell array STLSolidLabeling, and field data
 * BoundaryIds (int) and BoundaryNames (string), the numbers that occur and their names. Solids with the same name are
 * one boundary; those without a name are the boundary "unnamed". Names are UTF-8; other bytes in the file are read as
 * Latin-1.
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkNamedSTLReader_h
#define vtkNamedSTLReader_h

#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkSTLReader.h"

#include <functional> // for ways to copy
#include <string>     // for names of files

class vtkPolyData;

class VTKCARTESIANMESHERFILTERS_EXPORT vtkNamedSTLReader : public vtkSTLReader
{
public:
  static vtkNamedSTLReader* New();
  vtkTypeMacro(vtkNamedSTLReader, vtkSTLReader);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * 1 if the file is ASCII STL and at least one of its first two solids has a name; or if vtkSTLReader would not read it,
   * because of a name (not ASCII, or long), because words are not in the lines where it looks for them, or because the
   * header of a binary file begins with "solid"; or if a binary file holds fewer triangles than its header says; else 0.
   */
  static int CanReadFile(const char* name);

protected:
  vtkNamedSTLReader();
  ~vtkNamedSTLReader() override = default;

  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

private:
  /**
   * Says why with an error; 0.
   */
  int Refuse(unsigned long code, const std::string& why);

  int ReadCopy(const std::function<bool(const std::string&)>& write, vtkPolyData* surface);

  vtkNamedSTLReader(const vtkNamedSTLReader&) = delete;
  void operator=(const vtkNamedSTLReader&) = delete;
};

#endif
