// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianMesher
 * @brief meshes the inside of a closed surface
 *
 * Input: a closed surface (vtkPolyData). Outputs: port 0 "Mesh" (vtkUnstructuredGrid), port 1
 * "Boundary" (vtkPolyData), the faces of the mesh that only one cell has; their arrays are those of
 * vtkCellAssembler, the errors those of all three filters. Port 2 "Defects" (vtkPolyData): see
 * vtkSurfaceInspector.
 *
 * vtkCartesianBoxer, vtkPatcher and vtkCellAssembler in one, with the same result bit for bit: the
 * boxer's properties are inherited, the other two's repeated here.
 *
 * Asked for a piece of the mesh, by its rank or by a writer that streams, it makes that piece only: a
 * slab of the grid. Pieces have global ids (cells: CellId, points: GlobalPointIds); together they are
 * the whole mesh, bit for bit. Defects come with piece 0. Every rank has the whole surface,
 * which may come whole or distributed; ghost cells, where asked for, are vtkGhostCellsGenerator's.
 * With SmallCells Merge, SplitConcaveCells, a CollapseRatio, or InPieces off, piece 0 is the whole mesh.
 *
 * @sa vtkCartesianBoxer vtkPatcher vtkCellAssembler vtkSurfaceInspector
 */
#ifndef vtkCartesianMesher_h
#define vtkCartesianMesher_h

#include "vtkCartesianBoxer.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

namespace cartesian
{
struct CellSpec;
struct MeshPiece;
class Processes;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianMesher : public vtkCartesianBoxer
{
public:
  static vtkCartesianMesher* New();
  vtkTypeMacro(vtkCartesianMesher, vtkCartesianBoxer);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * See vtkPatcher.
   */
  vtkSetClampMacro(PatchMethod, int, 0, 2);
  vtkGetMacro(PatchMethod, int);
  vtkSetMacro(FeatureAngle, double);
  vtkGetMacro(FeatureAngle, double);
  vtkSetMacro(MergeAngle, double);
  vtkGetMacro(MergeAngle, double);
  vtkSetClampMacro(Tying, int, 0, 1);
  vtkGetMacro(Tying, int);
  ///@}

  ///@{
  /**
   * Edges shorter than this fraction of their box collapse, so that hardly any small cell is left
   * (4.10): 0 (none) to 0.3; default 0.1. Corners of boxes move onto the surface; nodes of the surface
   * move along it only.
   */
  vtkSetMacro(CollapseRatio, double);
  vtkGetMacro(CollapseRatio, double);
  ///@}

  /**
   * What becomes of small cells (4.10); default Merge.
   */
  enum SmallCellsModes
  {
    Remove = 0, ///< left out; their inner faces become boundary faces of their neighbours
    Merge = 1   ///< a part of the neighbour across the largest area; the volume is kept
  };

  ///@{
  vtkSetClampMacro(SmallCells, int, Remove, Merge);
  vtkGetMacro(SmallCells, int);
  ///@}

  ///@{
  /**
   * With Merge: cells smaller than this fraction of their box are merged: 0 (none) to less than 1;
   * default 0.015.
   */
  vtkSetMacro(MergeRatio, double);
  vtkGetMacro(MergeRatio, double);
  ///@}

  ///@{
  /**
   * Cut cells that fail an angle condition of section 3 along their concave edges (4.11); default
   * on.
   */
  vtkSetMacro(SplitConcaveCells, bool);
  vtkGetMacro(SplitConcaveCells, bool);
  vtkBooleanMacro(SplitConcaveCells, bool);
  ///@}

  ///@{
  /**
   * See vtkCellAssembler.
   */
  vtkSetMacro(SmallCellRatio, double);
  vtkGetMacro(SmallCellRatio, double);
  vtkSetMacro(RefusedCellRatio, double);
  vtkGetMacro(RefusedCellRatio, double);
  ///@}

  ///@{
  /**
   * Whether each rank makes a piece of the mesh; off: the first rank makes all of it. Default: on.
   */
  vtkSetMacro(InPieces, bool);
  vtkGetMacro(InPieces, bool);
  vtkBooleanMacro(InPieces, bool);
  ///@}

  /**
   * In how many pieces the mesh has to be made, one after the other, so that none takes more than
   * MemoryLimit by an estimate; 1 where it cannot be made in pieces. 0 after an error, such as TooManyBoxes where none is small enough.
   */
  int EstimateNumberOfPieces();

  ///@{
  /**
   * See vtkCellAssembler.
   */
  void SetNumberOfBoundaryNames(int number) { this->Resize(this->BoundaryNames, number); }
  void SetBoundaryName(int row, const char* name);
  void SetNumberOfBoundaryTypes(int number) { this->Resize(this->BoundaryTypes, number); }
  void SetBoundaryType(int row, const char* type);
  void SetNumberOfBoundarySmallCellRatios(int number)
  {
    this->Resize(this->BoundaryRatios, number);
  }
  void SetBoundarySmallCellRatio(int row, double ratio);
  ///@}

protected:
  vtkCartesianMesher();
  ~vtkCartesianMesher() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  int PatchMethod = 0;
  double FeatureAngle = 30;
  double MergeAngle = 10;
  int Tying = 0;
  double CollapseRatio = 0.1;
  int SmallCells = Merge;
  double MergeRatio = 0.015;
  double SmallCellRatio = 1e-3;
  bool SplitConcaveCells = true;
  double RefusedCellRatio = 2.5;
  bool InPieces = true;
  std::vector<std::string> BoundaryNames;
  std::vector<std::string> BoundaryTypes;
  std::vector<double> BoundaryRatios;

private:
  vtkCartesianMesher(const vtkCartesianMesher&) = delete;
  void operator=(const vtkCartesianMesher&) = delete;

  struct Task;
  struct Piece;

  cartesian::CellSpec MakeCellSpec();
  bool IsMadeInPieces();
  void Begin(Task& task, const Piece& piece, const cartesian::Processes& processes,
    vtkInformationVector** input, vtkInformationVector* output, cartesian::Execution& execution);
  void Make(const Task& task, Piece& piece, cartesian::Execution& execution);
  void CountPiecesBefore(Task& task, const Piece& piece, cartesian::Execution& execution);
  void RequestPieceAlone(Piece& piece, vtkInformationVector** input, vtkInformationVector* output);
  void RequestPieceOfProcess(Piece& piece, const cartesian::Processes& processes,
    vtkInformationVector** input, vtkInformationVector* output);
  void Write(const Task& task, const Piece& piece, const cartesian::MeshPiece& place,
    vtkInformationVector* output, cartesian::Execution& execution);

  std::unique_ptr<Task> Kept; // from piece to piece, where this process makes all
};

#endif
