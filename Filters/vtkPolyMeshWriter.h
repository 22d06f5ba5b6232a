// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolyMeshWriter
 * @brief writes an unstructured grid as an OpenFOAM case
 *
 * Input, several processes and errors: see vtkWholeMeshWriter.
 *
 * `FileName` (case.foam) is created empty if it is not there; its folder is the case. What is
 * written into it, and what becomes of a mesh that was there, says Kernel/OpenFoam/PolyMeshFiles.h: faces in
 * upper triangular order, no file of anybody else's is lost.
 *
 * Patches: the boundaries of a mesh of vtkCartesianMesher or vtkCellAssembler, which carries them in
 * the cell array CellId and the field data array BoundaryOfFaces through all filters that leave
 * cells as they are. A patch has the name that the field data arrays BoundaryNames (strings) and
 * BoundaryIds (numbers) give its boundary, else boundary_(id); faces without a boundary are in
 * the patch no_surface. A grid from elsewhere has one patch, boundary. A patch has the type that the
 * field data array BoundaryTypes (strings, beside BoundaryIds) gives its boundary; where that is
 * empty or missing, the type that a mesh being replaced has there, else patch where the name starts with inlet,
 * outlet or cyclic, else wall.
 *
 * Where the field data array RegionNames and the cell array Region tell that cells are of several regions,
 * `RegionsAs` says what these become: Meshes (the default), one for each, constant/(region)/polyMesh, with
 * patches (region)_to_(other) of type mappedWall, and constant/regionProperties; or Zones, one mesh in which
 * each is a cellZone. Of the former, `ZoneRegions` are cellZones of another one's mesh, in a faceZone or between
 * cyclicAMI patches (`ZoneBorders`).
 *
 * With several `Pieces`, the case is decomposed, as decomposePar would make it of that mesh: each piece is in
 * processor(N)/constant/polyMesh, with processor patches and the addressing files, which number the mesh that is
 * written otherwise. Several processes write a piece each; a single one asks its input for one piece
 * after the other, and has no more than one in memory. The input has the global ids of vtkCartesianMesher.
 * Of several regions all are meshes, processor(N)/constant/(region)/polyMesh, or all are zones.
 *
 * Around bodies, the set-up for a solver takes the flow's direction from the field data array FlowDirection (three
 * components) of vtkCartesianMesher.
 *
 * @sa vtkCartesianMesher vtkOpenFOAMReader
 */
#ifndef vtkPolyMeshWriter_h
#define vtkPolyMeshWriter_h

#include "vtkWholeMeshWriter.h"

#include <filesystem> // for names of files
#include <memory>     // for unique_ptr
#include <string>     // for names of regions
#include <vector>     // for lists of files

class vtkUnstructuredGrid;

namespace cartesian
{
struct FoamMesh;
class PolyMeshFiles;
struct SolverSetup;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkPolyMeshWriter : public vtkWholeMeshWriter
{
public:
  static vtkPolyMeshWriter* New();
  vtkTypeMacro(vtkPolyMeshWriter, vtkWholeMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * VTK_ASCII (1) or VTK_BINARY (2, the default): how points and faces are written. Both read back
   * equal.
   */
  vtkSetClampMacro(FileType, int, VTK_ASCII, VTK_BINARY);
  vtkGetMacro(FileType, int);
  void SetFileTypeToASCII() { this->SetFileType(VTK_ASCII); }
  void SetFileTypeToBinary() { this->SetFileType(VTK_BINARY); }
  ///@}

  /**
   * What several regions can become.
   */
  enum RegionKind
  {
    Meshes = 0, // one each
    Zones = 1   // cellZones of one mesh
  };

  ///@{
  /**
   * What several regions become.
   */
  vtkSetClampMacro(RegionsAs, int, Meshes, Zones);
  vtkGetMacro(RegionsAs, int);
  ///@}

  ///@{
  /**
   * Names of regions that are cellZones of a mesh, as porous media and rotating parts are, where the others are
   * meshes: of the first other region that they touch. None by default.
   */
  void AddZoneRegion(const std::string& name);
  void ClearZoneRegions();
  int GetNumberOfZoneRegions();
  std::string GetZoneRegion(int i);
  ///@}

  /**
   * What can be between a zone and other cells of its mesh.
   */
  enum ZoneBorder
  {
    FaceZones = 0, // inner faces
    CyclicAMI = 1  // two patches
  };

  ///@{
  /**
   * What is between a zone and other cells of its mesh: inner faces in a faceZone (the default), or two patches of
   * type cyclicAMI with points of their own.
   */
  vtkSetClampMacro(ZoneBorders, int, FaceZones, CyclicAMI);
  vtkGetMacro(ZoneBorders, int);
  ///@}

  ///@{
  /**
   * Of how many pieces the case is: 1, the default, for a mesh that is whole. On several processes, else as many
   * as these.
   */
  vtkSetClampMacro(Pieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(Pieces, int);
  ///@}

  ///@{
  /**
   * What coordinates are multiplied by: the metres that a unit of the surface is, as OpenFOAM counts in metres. More
   * than 0, default 1.
   */
  vtkSetMacro(Scale, double);
  vtkGetMacro(Scale, double);
  ///@}

  /**
   * Solvers that a case can be set up for.
   */
  enum SolverSetups
  {
    None = 0,
    Incompressible = 1, // simpleFoam
    ConjugateHeat = 2   // chtMultiRegionSimpleFoam
  };

  ///@{
  /**
   * What is written for a solver beside the mesh (Kernel/OpenFoam/SolverSetup.h): nothing, the default; for
   * simpleFoam; or, of several regions, for chtMultiRegionSimpleFoam. Error BadParameter, with nothing written: no
   * boundary is an inlet or an outlet.
   */
  vtkSetClampMacro(SolverSetup, int, None, ConjugateHeat);
  vtkGetMacro(SolverSetup, int);
  ///@}

  ///@{
  /**
   * Of that set-up: 0, the default, for kOmegaSST, 1 for laminar flow; the speed at inlets (m/s, more than 0,
   * default 10); the kinematic viscosity (m2/s, more than 0, default 1.5e-5); the temperature of what flows in (K, default
   * 350); how many iterations the solver makes (default 500); and whether files that are there are overwritten, which else
   * stay (default off).
   */
  vtkSetClampMacro(Turbulence, int, 0, 1);
  vtkGetMacro(Turbulence, int);
  vtkSetMacro(Speed, double);
  vtkGetMacro(Speed, double);
  vtkSetMacro(Viscosity, double);
  vtkGetMacro(Viscosity, double);
  vtkSetMacro(InletTemperature, double);
  vtkGetMacro(InletTemperature, double);
  vtkSetMacro(Iterations, int);
  vtkGetMacro(Iterations, int);
  vtkSetMacro(OverwriteSetup, bool);
  vtkGetMacro(OverwriteSetup, bool);
  vtkBooleanMacro(OverwriteSetup, bool);
  ///@}

  /**
   * Writes piece `number` of `Pieces`, in order from 0; the case is there after the last. For callers that make
   * the pieces themselves, on one process.
   */
  void WritePiece(vtkUnstructuredGrid* piece, int number);

protected:
  vtkPolyMeshWriter();
  ~vtkPolyMeshWriter() override;

  vtkTypeBool ProcessRequest(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  void WriteData() override;
  void WriteMesh(cartesian::WholeMesh& whole) override;

  int FileType = VTK_BINARY;
  int RegionsAs = Meshes;
  std::vector<std::string> ZoneRegions;
  int ZoneBorders = FaceZones;
  int Pieces = 1;
  double Scale = 1;
  int SolverSetup = None;
  int Turbulence = 0;
  double Speed = 10;
  double Viscosity = 1.5e-5;
  double InletTemperature = 350;
  int Iterations = 500;
  bool OverwriteSetup = false;

private:
  vtkPolyMeshWriter(const vtkPolyMeshWriter&) = delete;
  void operator=(const vtkPolyMeshWriter&) = delete;

  /**
   * Of a decomposed case: the piece of this process, or piece `number` of its only process.
   */
  void WriteOwnPiece(vtkUnstructuredGrid* grid);
  void AddPiece(vtkUnstructuredGrid* grid, int number);
  void TryToAdd(vtkUnstructuredGrid* grid, int number);
  void FinishPieces(vtkUnstructuredGrid* grid);

  void CheckDecomposition(int processes);
  void CheckNumbers() const;
  cartesian::SolverSetup MakeSetup() const;
  void WriteSolverCase(const cartesian::PolyMeshFiles& files, const cartesian::FoamMesh* whole,
    vtkUnstructuredGrid* grid);
  void WarnOfKept(const std::vector<std::filesystem::path>& kept);
  void WarnOfLongNames(vtkUnstructuredGrid* grid);

  struct PiecesSoFar;
  std::unique_ptr<PiecesSoFar> SoFar;
};

#endif
