// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkWholeMeshWriter
 * @brief base of writers that need every face of a mesh once, with its boundary
 *
 * Input: a vtkUnstructuredGrid of cells with a volume, polyhedra included; cells of lower dimension and ghost cells
 * are left out. Cells may be inside out, but the faces of each must be oriented consistently.
 *
 * On several processes the first gathers the pieces and writes them, with coincident points merged.
 *
 * Errors (GetErrorCode): vtkErrorCode::NoFileNameError; BadMesh, CannotWrite, OutOfMemory of vtkCartesianAlgorithm.
 * Existing files are then unchanged.
 *
 * @sa vtkPolyMeshWriter vtkCGNSMeshWriter vtkEnSightMeshWriter vtkFluentMeshWriter
 */
#ifndef vtkWholeMeshWriter_h
#define vtkWholeMeshWriter_h

#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkSmartPointer.h"                 // for vtkSmartPointer
#include "vtkWriter.h"

#include <functional> // for what may throw

class vtkUnstructuredGrid;

namespace cartesian
{
struct WholeMesh;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkWholeMeshWriter : public vtkWriter
{
public:
  vtkTypeMacro(vtkWholeMeshWriter, vtkWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Name of the file.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkWholeMeshWriter() = default;
  ~vtkWholeMeshWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  void WriteData() override;

  /**
   * Writes the whole mesh, on one process; may throw cartesian::Error. WriteGrid finds its faces and passes them to
   * WriteMesh, which may consume them: a subclass overrides one of the two.
   */
  virtual void WriteGrid(vtkUnstructuredGrid* grid);
  virtual void WriteMesh(cartesian::WholeMesh& /*whole*/) {}

  bool HasFileName() const { return this->FileName && *this->FileName; }

  /**
   * Runs the action; an exception becomes the error code. Returns whether it threw nothing.
   */
  bool Try(const std::function<void()>& action);

  char* FileName = nullptr;

private:
  vtkWholeMeshWriter(const vtkWholeMeshWriter&) = delete;
  void operator=(const vtkWholeMeshWriter&) = delete;

  /**
   * The whole mesh on the first process, null on the others.
   */
  vtkSmartPointer<vtkUnstructuredGrid> Gather();
};

#endif
