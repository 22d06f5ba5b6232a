// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkPolyMeshWriter
 * @brief writes an unstructured grid as an OpenFOAM case
 *
 * Input, several processes and errors: see vtkWholeMeshWriter.
 *
 * `FileName` (case.foam) is created empty if missing; its folder is the case. Kernel/OpenFoam/PolyMeshFiles.h
 * describes what is written into it and how an existing mesh is treated: faces are in upper triangular order, and no
 * foreign file is lost.
 *
 * Patches: the boundaries of a mesh of vtkCartesianMesher or vtkCellAssembler, which pass in the cell array CellId
 * and the field data array BoundaryOfFaces through all filters that do not change cells. A patch has the name that
 * the field data arrays BoundaryNames (strings) and BoundaryIds (numbers) give its boundary, else boundary_(id);
 * faces without a boundary are in the patch no_surface. Any other grid has one patch, boundary. A patch has the type
 * that the field data array BoundaryTypes (strings, one for each of BoundaryIds) gives its boundary; where that is
 * empty or missing, the type in the mesh that is replaced, else patch if the name starts with inlet, outlet or
 * cyclic, else wall.
 *
 * If the field data array RegionNames and the cell array Region define several regions, `RegionsAs` selects how they
 * are written: Meshes (the default), one for each, constant/(region)/polyMesh, with patches (region)_to_(other) of
 * type mappedWall, and constant/regionProperties; or Zones, one mesh in which each is a cellZone. With Meshes,
 * `ZoneRegions` are cellZones in another region's mesh, within a faceZone or between cyclicAMI patches
 * (`ZoneBorders`).
 *
 * With several `Pieces`, the case is decomposed, as decomposePar would do: each piece is in
 * processor(N)/constant/polyMesh, with processor patches and the addressing files, which refer to the undecomposed
 * mesh. Several processes write a piece each; a single one requests the pieces from its input one by one, and holds
 * no more than one in memory. The input has the global ids of vtkCartesianMesher. Several regions are all meshes,
 * processor(N)/constant/(region)/polyMesh, or all zones.
 *
 * A whole mesh with vtkCartesianMesher's field data array IsotropicLevels has files of levels, by which solvers refine it
 * (Kernel/OpenFoam/RefinementLevels.h), from the cell arrays Level, VolumeFraction and Layer; some faces at walls are
 * divided so that refinement can be undone (Kernel/OpenFoam/ThirdEdges.h).
 *
 * Around bodies, the solver set-up takes the flow direction from the field data array FlowDirection (three
 * components) of vtkCartesianMesher.
 *
 * @sa vtkCartesianMesher vtkOpenFOAMReader
 */
#ifndef vtkPolyMeshWriter_h
#define vtkPolyMeshWriter_h

#include "vtkWholeMeshWriter.h"

#include <array>      // for points
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

/**
 * A column of a table: SetNumberOf...s(int rows), then Set...(int row, value); a missing row is an error.
 */
#define vtkTableColumnMacro(One, Several, Type, Argument)                                          \
  void SetNumberOf##Several(int number)                                                            \
  {                                                                                                \
    this->Several.resize(number > 0 ? static_cast<std::size_t>(number) : 0, Type{});               \
    this->Modified();                                                                              \
  }                                                                                                \
  void Set##One(int row, Argument value)                                                           \
  {                                                                                                \
    if (row < 0 || static_cast<std::size_t>(row) >= this->Several.size())                          \
    {                                                                                              \
      vtkErrorMacro("There is no row " << row << ": set the number of rows first.");               \
      return;                                                                                      \
    }                                                                                              \
    this->Several[static_cast<std::size_t>(row)] = value;                                          \
    this->Modified();                                                                              \
  }

/**
 * The same of points or vectors.
 */
#define vtkTablePointsMacro(One, Several)                                                          \
  void SetNumberOf##Several(int number)                                                            \
  {                                                                                                \
    this->Several.resize(number > 0 ? static_cast<std::size_t>(number) : 0);                       \
    this->Modified();                                                                              \
  }                                                                                                \
  void Set##One(int row, double x, double y, double z)                                             \
  {                                                                                                \
    if (row < 0 || static_cast<std::size_t>(row) >= this->Several.size())                          \
    {                                                                                              \
      vtkErrorMacro("There is no row " << row << ": set the number of rows first.");               \
      return;                                                                                      \
    }                                                                                              \
    this->Several[static_cast<std::size_t>(row)] = { x, y, z };                                    \
    this->Modified();                                                                              \
  }

class VTKCARTESIANMESHERFILTERS_EXPORT vtkPolyMeshWriter : public vtkWholeMeshWriter
{
public:
  static vtkPolyMeshWriter* New();
  vtkTypeMacro(vtkPolyMeshWriter, vtkWholeMeshWriter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * VTK_ASCII (1) or VTK_BINARY (2, the default): how points and faces are written. Both are lossless.
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
   * How several regions are written.
   */
  vtkSetClampMacro(RegionsAs, int, Meshes, Zones);
  vtkGetMacro(RegionsAs, int);
  ///@}

  ///@{
  /**
   * Names of regions that are cellZones, such as porous media and rotating parts, where the others are meshes: in the
   * mesh of the first other region that they touch. None by default.
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
   * What lies between a zone and other cells of its mesh: inner faces in a faceZone (the default), or two patches of
   * type cyclicAMI with separate points.
   */
  vtkSetClampMacro(ZoneBorders, int, FaceZones, CyclicAMI);
  vtkGetMacro(ZoneBorders, int);
  ///@}

  ///@{
  /**
   * Number of pieces of the case: 1, the default, for an undecomposed case. On several processes, 1 or their number.
   */
  vtkSetClampMacro(Pieces, int, 1, VTK_INT_MAX);
  vtkGetMacro(Pieces, int);
  ///@}

  ///@{
  /**
   * Factor for coordinates: the length of a surface unit in metres, which OpenFOAM expects. 0, the default: what the mesh
   * says (field data MetresPerUnit), or 1.
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
    ConjugateHeat = 2,  // chtMultiRegionSimpleFoam
    Transient = 3       // pimpleFoam
  };

  ///@{
  /**
   * Solver files written beside the mesh (Kernel/OpenFoam/SolverSetup.h): none, the default; for simpleFoam or
   * pimpleFoam; or, with several regions, for chtMultiRegionSimpleFoam. Error BadParameter, with nothing written, if no boundary is an
   * inlet or an outlet.
   */
  vtkSetClampMacro(SolverSetup, int, None, Transient);
  vtkGetMacro(SolverSetup, int);
  ///@}

  ///@{
  /**
   * Options of that set-up: 0, the default, for kOmegaSST, 1 for laminar flow; the speed at inlets (m/s) and
   * the kinematic viscosity (m2/s), where 0, the default, means those that the mesh's layers were made for (Target Y
   * Plus), else 10 and 1.5e-5; the density (kg/m3, default 1.2) that turns mass flows and pressures of one mesh into
   * what these solvers know; the inlet temperature (K, default 350);
   * the number of solver iterations, of heat the most; 0, the default, means 500 of the flow and up to 20000 of heat; and whether existing files are overwritten or kept (default:
   * kept).
   */
  vtkSetClampMacro(Turbulence, int, 0, 1);
  vtkGetMacro(Turbulence, int);
  vtkSetMacro(Speed, double);
  vtkGetMacro(Speed, double);
  vtkSetMacro(Viscosity, double);
  vtkGetMacro(Viscosity, double);
  vtkSetMacro(Density, double);
  vtkGetMacro(Density, double);
  vtkSetMacro(InletTemperature, double);
  vtkGetMacro(InletTemperature, double);
  vtkSetMacro(Iterations, int);
  vtkGetMacro(Iterations, int);
  vtkSetMacro(OverwriteSetup, bool);
  vtkGetMacro(OverwriteSetup, bool);
  vtkBooleanMacro(OverwriteSetup, bool);
  ///@}

  ///@{
  /**
   * Times of Transient, s: the end (default 1), how often results are written (0, the default: ten times), and the time
   * step (0, the default: that of the Courant number, at most 1 by default).
   */
  vtkSetMacro(EndTime, double);
  vtkGetMacro(EndTime, double);
  vtkSetMacro(WriteInterval, double);
  vtkGetMacro(WriteInterval, double);
  vtkSetMacro(TimeStep, double);
  vtkGetMacro(TimeStep, double);
  vtkSetMacro(CourantNumber, double);
  vtkGetMacro(CourantNumber, double);
  ///@}

  ///@{
  /**
   * Conditions by boundary, a table (Kernel/OpenFoam/ConditionRows.h has units and signs): names or patterns (* any text, ?
   * any character); the flow: automatic, speed, volume flow, mass flow or pressure, and its value; heat: automatic,
   * temperature or heat flux, and its value; intensity and length of turbulence (-1: as without). Columns are as long as the
   * first, or empty. Error BadParameter, with nothing written, which names the boundary: a row fits none, or not this one.
   */
  vtkTableColumnMacro(ConditionBoundary, ConditionBoundaries, std::string, const char*);
  vtkTableColumnMacro(ConditionFlow, ConditionFlows, std::string, const char*);
  vtkTableColumnMacro(ConditionFlowValue, ConditionFlowValues, double, double);
  vtkTableColumnMacro(ConditionHeat, ConditionHeats, std::string, const char*);
  vtkTableColumnMacro(ConditionHeatValue, ConditionHeatValues, double, double);
  vtkTableColumnMacro(ConditionTurbulenceIntensity, ConditionTurbulenceIntensities, double, double);
  vtkTableColumnMacro(ConditionTurbulenceLength, ConditionTurbulenceLengths, double, double);
  ///@}

  ///@{
  /**
   * Materials by region, a table for ConjugateHeat: names or patterns; the material: automatic (air in fluid regions, steel
   * in solid ones), air, water, aluminium, copper or steel; density, heat capacity, conductivity and kinematic viscosity
   * instead of the material's (-1: the material's); and the heat, W, that comes into being in the region. Columns and errors
   * as above.
   */
  vtkTableColumnMacro(MaterialRegion, MaterialRegions, std::string, const char*);
  vtkTableColumnMacro(Material, Materials, std::string, const char*);
  vtkTableColumnMacro(MaterialDensity, MaterialDensities, double, double);
  vtkTableColumnMacro(MaterialHeatCapacity, MaterialHeatCapacities, double, double);
  vtkTableColumnMacro(MaterialConductivity, MaterialConductivities, double, double);
  vtkTableColumnMacro(MaterialViscosity, MaterialViscosities, double, double);
  vtkTableColumnMacro(HeatSource, HeatSources, double, double);
  ///@}

  ///@{
  /**
   * Zones that turn, a table for Incompressible and Transient (Kernel/OpenFoam/Rotations.h): names or patterns of cellZones; the
   * speed in revolutions per minute, right-handed about the axis; a point of the axis, m, and its direction; and boundaries in the
   * zone that do not turn along: automatic (those that are outside it too), none, or names and patterns with spaces between
   * them. Columns and errors as above. Not in a decomposed case.
   */
  vtkTableColumnMacro(RotationZone, RotationZones, std::string, const char*);
  vtkTableColumnMacro(RotationSpeed, RotationSpeeds, double, double);
  vtkTablePointsMacro(RotationOrigin, RotationOrigins);
  vtkTablePointsMacro(RotationAxis, RotationAxes);
  vtkTableColumnMacro(StillBoundary, StillBoundaries, std::string, const char*);
  ///@}

  ///@{
  /**
   * A folder with templates of that set-up (Kernel/OpenFoam/Templates/README.md), which replace the library's own of the
   * same names; empty, the default: none. Error BadParameter, with nothing written, if it cannot be read, or if a file
   * or a placeholder in it does not exist.
   */
  vtkSetMacro(CaseTemplates, std::string);
  vtkGetMacro(CaseTemplates, std::string);
  ///@}

  /**
   * Writes piece `number` of `Pieces`, in order from 0; the case is complete after the last. For callers that make
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
  double Scale = 0;
  int SolverSetup = None;
  int Turbulence = 0;
  double Speed = 0;
  double Viscosity = 0;
  double Density = 1.2;
  double InletTemperature = 350;
  double EndTime = 1;
  double WriteInterval = 0;
  double TimeStep = 0;
  double CourantNumber = 1;
  std::vector<std::string> ConditionBoundaries;
  std::vector<std::string> ConditionFlows;
  std::vector<double> ConditionFlowValues;
  std::vector<std::string> ConditionHeats;
  std::vector<double> ConditionHeatValues;
  std::vector<double> ConditionTurbulenceIntensities;
  std::vector<double> ConditionTurbulenceLengths;
  std::vector<std::string> MaterialRegions;
  std::vector<std::string> Materials;
  std::vector<double> MaterialDensities;
  std::vector<double> MaterialHeatCapacities;
  std::vector<double> MaterialConductivities;
  std::vector<double> MaterialViscosities;
  std::vector<double> HeatSources;
  std::vector<std::string> RotationZones;
  std::vector<double> RotationSpeeds;
  std::vector<std::array<double, 3>> RotationOrigins;
  std::vector<std::array<double, 3>> RotationAxes;
  std::vector<std::string> StillBoundaries;
  int Iterations = 0;
  bool OverwriteSetup = false;
  std::string CaseTemplates;

private:
  vtkPolyMeshWriter(const vtkPolyMeshWriter&) = delete;
  void operator=(const vtkPolyMeshWriter&) = delete;

  /**
   * In a decomposed case: the piece of this process, or piece `number` of its only process.
   */
  void WriteOwnPiece(vtkUnstructuredGrid* grid);
  void AddPiece(vtkUnstructuredGrid* grid, int number);
  void TryToAdd(vtkUnstructuredGrid* grid, int number);
  void FinishPieces(vtkUnstructuredGrid* grid);

  void CheckDecomposition(vtkUnstructuredGrid* grid, int processes);
  void CheckNumbers();
  double ScaleOfMesh(); // Scale, or what 0 stands for
  cartesian::SolverSetup MakeSetup();
  void AddTables(cartesian::SolverSetup& setup) const;
  void WriteSolverCase(const cartesian::PolyMeshFiles& files, const cartesian::FoamMesh* whole,
    vtkUnstructuredGrid* grid);
  void WarnOfKept(const std::vector<std::filesystem::path>& kept);
  void WarnOfLongNames(vtkUnstructuredGrid* grid);

  struct PiecesSoFar;
  std::unique_ptr<PiecesSoFar> SoFar;
};

#endif
