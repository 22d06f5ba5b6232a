// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkWholeMeshWriter
 * @brief base of writers that want every face of a mesh once, with its boundary
 *
 * Input: a vtkUnstructuredGrid of cells with a volume, polyhedra included; cells of lower dimension
 * and ghost cells are left out. Cells need not be turned right side out, but the faces of each must
 * agree with each other.
 *
 * On several processes the first gathers the pieces and writes them; points of the same coordinates
 * are then one.
 *
 * Errors (GetErrorCode): vtkErrorCode::NoFileNameError; BadMesh, CannotWrite, OutOfMemory of
 * vtkCartesianAlgorithm. Then what was there before is as it was.
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
   * Writes the whole mesh, on one process; may throw cartesian::Error. WriteGrid finds its faces, and leaves them
   * to WriteMesh, which need not leave anything of them: a subclass has one of the two.
   */
  virtual void WriteGrid(vtkUnstructuredGrid* grid);
  virtual void WriteMesh(cartesian::WholeMesh& /*whole*/) {}

  bool HasFileName() const { return this->FileName && *this->FileName; }

  /**
   * Runs the action; what it throws becomes the error code. Returns whether it threw nothing.
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
