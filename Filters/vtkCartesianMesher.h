// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianMesher
 * @brief meshes the inside of a closed surface
 *
 * Input: a closed surface (vtkPolyData). Outputs: port 0 "Mesh" (vtkUnstructuredGrid), port 1
 * "Boundary" (vtkPolyData), the faces that belong to only one cell; arrays as in vtkCellAssembler, errors as in all
 * three filters. Port 2 "Defects" (vtkPolyData): see
 * vtkSurfaceInspector; none with several regions. Port 3 "Interfaces" (vtkPolyData): the faces between
 * two regions, with the arrays that Conversion/MeshToVTK.h lists.
 *
 * vtkCartesianBoxer, vtkPatcher and vtkCellAssembler in one, with the same result bit for bit: the properties of
 * the grid are inherited, those shared with the other two are in vtkCartesianProperties.h.
 *
 * If a piece is requested, by a rank or a streaming writer, only that piece is made: a slab of the grid. Pieces have
 * global ids (cells: CellId, points: GlobalPointIds); together they are the whole mesh, bit for bit. Defects come with
 * piece 0. Every rank holds the whole surface, which may arrive whole or distributed; requested ghost cells come from
 * vtkGhostCellsGenerator. With InPieces off, piece 0 is the whole mesh.
 *
 * @sa vtkCartesianBoxer vtkPatcher vtkCellAssembler vtkSurfaceInspector
 */
#ifndef vtkCartesianMesher_h
#define vtkCartesianMesher_h

#include "vtkCartesianGridAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkCartesianProperties.h"          // for vtkPatchPropertiesMacro

#include "vtkStringArray.h" // for vtkStringArray

#include <cstdint> // for std::int32_t
#include <memory>  // for std::unique_ptr
#include <utility> // for std::pair
#include <vector>  // for std::vector

namespace cartesian
{
struct BoundarySettings;
struct MeshPiece;
class Processes;
}

class vtkUnstructuredGrid;

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianMesher : public vtkCartesianGridAlgorithm
{
public:
  static vtkCartesianMesher* New();
  vtkTypeMacro(vtkCartesianMesher, vtkCartesianGridAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkPatchPropertiesMacro();
  vtkCellPropertiesMacro();
  vtkBoundarySettingsMacro();

public:
  /**
   * What defines the regions of the mesh; default One.
   */
  enum RegionSources
  {
    One = 0,    // there is one
    Blocks = 1, // each block of the surface at the top is one
    Array = 2,  // triangles with the same value of RegionArray are one
  };

  ///@{
  /**
   * Boundary layers: number of prisms stacked on each wall face; default 0, none. -1, automatic: as many as lead from
   * the First Layer Thickness, at the Layer Expansion Ratio, to the Last Layer, at most 50. A boundary is a wall unless
   * its type is patch, symmetry, symmetryPlane or empty, or, without a type, its name begins with inlet, outlet,
   * cyclic or symmetry.
   */
  vtkSetMacro(Layers, int);
  vtkGetMacro(Layers, int);
  ///@}

  ///@{
  /**
   * Ratio of the thickness of each layer to that of the layer below it: 1 to 3, default 1.2.
   */
  vtkSetMacro(LayerExpansionRatio, double);
  vtkGetMacro(LayerExpansionRatio, double);
  ///@}

  ///@{
  /**
   * Thickness of the layer at the wall, or else of all layers together, in units of the surface. Both 0, the
   * default: the total is a third of the local box size.
   */
  vtkSetMacro(FirstLayerThickness, double);
  vtkGetMacro(FirstLayerThickness, double);
  vtkSetMacro(LayersThickness, double);
  vtkGetMacro(LayersThickness, double);
  ///@}

  ///@{
  /**
   * With an automatic number of layers: the thickness of the last one by the box beside it; 0.01 to 1, default 0.1.
   */
  vtkSetMacro(LastLayer, double);
  vtkGetMacro(LastLayer, double);
  ///@}

  ///@{
  /**
   * With layers: boxes in which a wall turns by more than 30 degrees, except at sharp edges, are halved up to twice more,
   * until it does not. Default on.
   */
  vtkSetMacro(RefineForLayers, bool);
  vtkGetMacro(RefineForLayers, bool);
  vtkBooleanMacro(RefineForLayers, bool);
  ///@}

  ///@{
  /**
   * Without thicknesses: the layer at the wall is twice as thick as the distance at which y+ has this value, in the
   * turbulent boundary layer of a flat plate (Kernel/Surface/WallFlow.h); default 0, not given. Speed and kinematic viscosity
   * are in m/s and m2/s (see LengthUnit), more than 0, default 10 and 1.5e-5; the flow's length is in units of the surface,
   * default 0, its longest side.
   */
  vtkSetMacro(TargetYPlus, double);
  vtkGetMacro(TargetYPlus, double);
  vtkSetMacro(FlowSpeed, double);
  vtkGetMacro(FlowSpeed, double);
  vtkSetMacro(FlowViscosity, double);
  vtkGetMacro(FlowViscosity, double);
  vtkSetMacro(FlowLength, double);
  vtkGetMacro(FlowLength, double);
  ///@}

  enum LengthUnits
  {
    FromInput,
    Metre,
    Centimetre,
    Millimetre,
    Inch,
    Foot
  };

  ///@{
  /**
   * The unit of the surface, for the speed and viscosity of the flow. Default FromInput: the field data array MetresPerUnit
   * of the surface or a block, which vtkCADReader writes; without that, metres. Where it is not the metre, the mesh has
   * that array too.
   */
  vtkSetClampMacro(LengthUnit, int, FromInput, Foot);
  vtkGetMacro(LengthUnit, int);
  ///@}

  ///@{
  /**
   * Names of the regions with layers, on their boundary and on their side of interfaces; default: none, which
   * means all regions.
   */
  void SetNumberOfLayerRegions(int number) { this->Resize(this->LayerRegions, number); }
  void SetLayerRegion(int row, const char* name)
  {
    this->SetRow(this->LayerRegions, row, std::string(name ? name : ""));
  }
  ///@}

  ///@{
  /**
   * Total thickness of the layers on the boundaries in the table of names (SetBoundaryName), whatever their
   * type, in units of the surface. 0: no layers; negative: the general setting. As many as names, or none.
   */
  void SetNumberOfBoundaryLayersThicknesses(int number)
  {
    this->Resize(this->BoundaryLayers, number);
  }
  void SetBoundaryLayersThickness(int row, double thickness)
  {
    this->SetRow(this->BoundaryLayers, row, thickness);
  }
  ///@}

  ///@{
  /**
   * Name of those boundaries in the mesh: all that a row applies to, and any other with that name, are merged
   * into one boundary. Empty: they keep their names. As many as names, or none.
   */
  void SetNumberOfBoundaryMergedNames(int number)
  {
    this->Resize(this->BoundaryMergedNames, number);
  }
  void SetBoundaryMergedName(int row, const char* name)
  {
    this->SetRow(this->BoundaryMergedNames, row, std::string(name ? name : ""));
  }
  ///@}

  ///@{
  /**
   * Maximum number of cells, to within 5 %: if there would be more, CurvatureAngle, the box size in gaps
   * (CellsAcrossGaps) and the sizes of the SizeArray are enlarged by one factor until the cells fit, which
   * usually needs a second meshing pass. Default 0: no limit. With a budget, each piece or rank makes the whole
   * mesh and keeps its part.
   */
  vtkSetClampMacro(CellBudget, int, 0, VTK_INT_MAX);
  vtkGetMacro(CellBudget, int);
  ///@}

  ///@{
  /**
   * Each region needs a closed surface. Regions may touch, in common planes or along the same triangles, or lie
   * inside one another; where they overlap, the first listed wins. Interfaces are conformal: cells of two
   * regions share faces.
   */
  vtkSetClampMacro(RegionsFrom, int, One, Array);
  vtkGetMacro(RegionsFrom, int);
  void SetRegionsFromToOne() { this->SetRegionsFrom(One); }
  void SetRegionsFromToBlocks() { this->SetRegionsFrom(Blocks); }
  void SetRegionsFromToArray() { this->SetRegionsFrom(Array); }
  ///@}

  ///@{
  /**
   * Cell array of the surface with the number or name of each triangle's region; regions are listed in the order
   * in which they first appear.
   */
  vtkSetMacro(RegionArray, std::string);
  vtkGetMacro(RegionArray, std::string);
  ///@}

  /**
   * What is meshed; default Inside.
   */
  enum Domains
  {
    Inside = 0,  // what the surface encloses
    Outside = 1, // a box without what the surface encloses; then there is one region
    AroundPoints =
      2, // what the surface encloses around KeepPoints, in bodies or between them; one region
  };

  ///@{
  /**
   * With Outside, the sides of the box are boundaries (see SideNames). Bodies that extend beyond the box are cut
   * off there. Meshlines override the box along their axis.
   */
  vtkSetClampMacro(Domain, int, Inside, AroundPoints);
  vtkGetMacro(Domain, int);
  void SetDomainToInside() { this->SetDomain(Inside); }
  void SetDomainToOutside() { this->SetDomain(Outside); }
  void SetDomainToAroundPoints() { this->SetDomain(AroundPoints); }
  ///@}

  ///@{
  /**
   * Points, in units of the surface: connected parts of the domain that contain none of them are left out.
   * Default: none, and all parts stay. With points, each piece or rank makes the whole mesh and keeps its part.
   * BadParameter: a point lies on the surface or outside the domain.
   */
  void SetNumberOfKeepPoints(int number) { this->Resize(this->KeepPoints, number); }
  void SetKeepPoint(int row, double x, double y, double z)
  {
    this->SetRow(this->KeepPoints, row, { x, y, z });
  }
  const std::vector<std::array<double, 3>>& GetKeepPoints() const { return this->KeepPoints; }
  ///@}

  ///@{
  /**
   * Points, in units of the surface, that no part which is meshed may contain. They may lie beyond the grid. Default: none.
   * BadParameter: one is reached; Defects then has the shortest way there and its gaps (DefectKind 20 and 21).
   */
  void SetNumberOfKeepOut(int number) { this->Resize(this->KeepOut, number); }
  void SetKeepOut(int row, double x, double y, double z)
  {
    this->SetRow(this->KeepOut, row, { x, y, z });
  }
  const std::vector<std::array<double, 3>>& GetKeepOut() const { return this->KeepOut; }
  ///@}

  ///@{
  /**
   * What defines the box: 0, the default, the surface; 1 DomainBounds.
   */
  vtkSetClampMacro(BoxFrom, int, 0, 1);
  vtkGetMacro(BoxFrom, int);
  void SetBoxFromToSurface() { this->SetBoxFrom(0); }
  void SetBoxFromToBounds() { this->SetBoxFrom(1); }
  ///@}

  ///@{
  /**
   * Minimum and maximum x, y and z of the box, in units of the surface.
   */
  vtkSetVector6Macro(DomainBounds, double);
  vtkGetVector6Macro(DomainBounds, double);
  ///@}

  ///@{
  /**
   * Flow direction: 0 to 5 for plus x (the default), minus x, plus y, ...; and the distance from the surface to
   * the inlet, the outlet and the sides of the box, as multiples of the longest side of the surface's bounding
   * box; 0 or more, default 3, 5, 3.
   */
  vtkSetClampMacro(FlowDirection, int, 0, 5);
  vtkGetMacro(FlowDirection, int);
  void SetFlowDirectionToPlusX() { this->SetFlowDirection(0); }
  void SetFlowDirectionToMinusX() { this->SetFlowDirection(1); }
  void SetFlowDirectionToPlusY() { this->SetFlowDirection(2); }
  void SetFlowDirectionToMinusY() { this->SetFlowDirection(3); }
  void SetFlowDirectionToPlusZ() { this->SetFlowDirection(4); }
  void SetFlowDirectionToMinusZ() { this->SetFlowDirection(5); }
  vtkSetMacro(LengthsBefore, double);
  vtkGetMacro(LengthsBefore, double);
  vtkSetMacro(LengthsBehind, double);
  vtkGetMacro(LengthsBehind, double);
  vtkSetMacro(LengthsBeside, double);
  vtkGetMacro(LengthsBeside, double);
  ///@}

  ///@{
  /**
   * Side of the box on which the body stands: 0, the default, none; 1 to 6 low x, high x, low y, ... It is a
   * wall, the other sides are patches, unless the table of boundaries sets their types.
   */
  vtkSetClampMacro(Ground, int, 0, 6);
  vtkGetMacro(Ground, int);
  void SetGroundToNone() { this->SetGround(0); }
  void SetGroundToxMin() { this->SetGround(1); }
  void SetGroundToxMax() { this->SetGround(2); }
  void SetGroundToyMin() { this->SetGround(3); }
  void SetGroundToyMax() { this->SetGround(4); }
  void SetGroundTozMin() { this->SetGround(5); }
  void SetGroundTozMax() { this->SetGround(6); }
  ///@}

  ///@{
  /**
   * Half model: the axis (1 to 3) across which only the upper half is meshed, from the middle of the surface's
   * bounding box; the side there is a symmetryPlane unless the table of boundaries sets its type. Default 0:
   * none.
   */
  vtkSetClampMacro(Half, int, 0, 3);
  vtkGetMacro(Half, int);
  void SetHalfToNone() { this->SetHalf(0); }
  void SetHalfToAcrossX() { this->SetHalf(1); }
  void SetHalfToAcrossY() { this->SetHalf(2); }
  void SetHalfToAcrossZ() { this->SetHalf(3); }
  ///@}

  ///@{
  /**
   * Names of the box sides: 0, xMin to zMax; 1, the default, by FlowDirection: inlet, outlet, ground, symmetry
   * (of a half model), and all others together as sides.
   */
  vtkSetClampMacro(SideNames, int, 0, 1);
  vtkGetMacro(SideNames, int);
  void SetSideNamesToAxes() { this->SetSideNames(0); }
  void SetSideNamesToFlow() { this->SetSideNames(1); }
  ///@}

  ///@{
  /**
   * With Outside and RefinementDepth 0: boxes that the surface passes through are halved until at least this
   * many fit along its longest side, at most 12 times; without refinement zones of the user's, boxes around the
   * body are one level coarser and those in its wake two. 0 to 1000, default 60; 0: no such refinement.
   */
  vtkSetMacro(BoxesAlongBody, int);
  vtkGetMacro(BoxesAlongBody, int);
  ///@}

  /**
   * That refinement for the current surface, in rows of four texts: the place, the refinement level, and two
   * corners of the zone; the first row has the headings. Empty if there is none.
   */
  vtkStringArray* GetFlowZones();

  /**
   * With Outside, a note if the surface is clearly longer along another axis than along FlowDirection, unless it stands on
   * the Ground along that axis. Empty if there is nothing to note.
   */
  const char* GetDomainNote();

  /**
   * Of the last mesh, or of this process's piece, headings and a row of four texts: the number of cells, how many a solver would
   * refuse, and the worst skewness and non-orthogonality, at walls only if there are no layers. Empty before.
   */
  vtkStringArray* GetMade() { return this->Made; }

  /**
   * Of the layers that are asked for: the thickness of the first one, their number and their total thickness, for boxes of
   * the largest depth that boundaries ask for; in units of the surface and millimetres; empty without layers.
   */
  vtkStringArray* GetExpectedLayers();

  ///@{
  /**
   * Walls of two regions that face each other at most this far apart become one wall, that of the region listed
   * first. In units of the surface; default 0: only walls that touch become one.
   */
  vtkSetMacro(ContactTolerance, double);
  vtkGetMacro(ContactTolerance, double);
  ///@}

  ///@{
  /**
   * Open edges of the surface that run along each other at most this far apart are joined. In units of the surface; default 0: a
   * hundredth of the smallest box there.
   */
  vtkSetMacro(CrackWidth, double);
  vtkGetMacro(CrackWidth, double);
  ///@}

  ///@{
  /**
   * Holes of the surface that are wider than the smallest box there, but no wider than this, are closed by boundaries gap_1,
   * gap_2 and so on.
   * In units of the surface; default 0: none is.
   */
  vtkSetMacro(CloseGaps, double);
  vtkGetMacro(CloseGaps, double);
  ///@}

  ///@{
  /**
   * Sheets without thickness, whose triangles the surface has twice, and open surfaces: 0, the default, each side of
   * the former is a wall, and of the latter if they would enclose next to nothing; 1, the former are ignored, the
   * latter are closed; 2, each side is a wall.
   */
  vtkSetClampMacro(Sheets, int, 0, 2);
  vtkGetMacro(Sheets, int);
  void SetSheetsToKeep() { this->SetSheets(2); }
  void SetSheetsToLeaveOut() { this->SetSheets(1); }
  void SetSheetsToAutomatic() { this->SetSheets(0); }
  ///@}

  ///@{
  /**
   * Whether each rank makes a piece of the mesh; if off, the first rank makes all of it. Default: on.
   */
  vtkSetMacro(InPieces, bool);
  vtkGetMacro(InPieces, bool);
  vtkBooleanMacro(InPieces, bool);
  ///@}

  /**
   * Number of pieces in which the mesh has to be made, one after the other, so that none needs more than
   * MemoryLimit by an estimate; 1 if it cannot be made in pieces. 0 after an error, such as TooManyBoxes if no
   * piece is small enough.
   */
  int EstimateNumberOfPieces();

protected:
  vtkCartesianMesher();
  ~vtkCartesianMesher() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  cartesian::Options MakeOptions() override;
  double MetresInUnit();
  std::string NoteOfLength(double longest) override;
  void BeginEstimate(const cartesian::Options* options) override;
  void AddBoundaryOptions(
    const cartesian::SurfaceFromVTK& surface, cartesian::Options& options) override;
  cartesian::BoundarySettings Boundaries() const override;
  cartesian::SurfaceFromVTK Read(vtkDataObject* data) const override;

  bool InPieces = true;
  int RegionsFrom = One;
  std::string RegionArray;
  double CrackWidth = 0;
  double CloseGaps = 0;
  double ContactTolerance = 0;
  int Sheets = 0;
  int Layers = 0;
  double LayerExpansionRatio = 1.2;
  double FirstLayerThickness = 0;
  double LayersThickness = 0;
  double LastLayer = 0.1;
  bool RefineForLayers = true;
  int LengthUnit = FromInput;
  double TargetYPlus = 0;
  double FlowSpeed = 10;
  double FlowViscosity = 1.5e-5;
  double FlowLength = 0;
  std::vector<std::string> LayerRegions;
  std::vector<double> BoundaryLayers;
  std::vector<std::string> BoundaryMergedNames;
  std::vector<std::pair<std::int32_t, std::int32_t>>
    Baffles;                       // their boundaries, and those of their backs
  std::vector<std::int32_t> Zones; // their boundaries
  int CellBudget = 0;
  int Domain = Inside;
  std::vector<std::array<double, 3>> KeepPoints;
  std::vector<std::array<double, 3>> KeepOut;
  int BoxFrom = 0;
  double DomainBounds[6] = { 0, 1, 0, 1, 0, 1 };
  int FlowDirection = 0;
  double LengthsBefore = 3;
  double LengthsBehind = 5;
  double LengthsBeside = 3;
  int Ground = 0;
  int Half = 0;
  int SideNames = 1;
  int BoxesAlongBody = 60;
  std::string DomainNote;
  vtkNew<vtkStringArray> FlowZones;
  vtkNew<vtkStringArray> ExpectedLayers;
  vtkNew<vtkStringArray> Made;

private:
  vtkCartesianMesher(const vtkCartesianMesher&) = delete;
  void operator=(const vtkCartesianMesher&) = delete;

  struct Task;
  struct Piece;
  struct WholeMesh;

  // As the user gave them: Boundaries() are those of a surface whose boundaries have merged.
  cartesian::BoundarySettings GivenBoundaries() const;

  void AddTypesOfSides(Task& task) const;
  void WarnOfSymmetries(const Task& task);
  void AddBaffles(Task& task);
  void AddZones(Task& task);
  // What can only be made of a whole mesh: then pieces are cut out of one.
  bool NeedsWholeMesh() const
  {
    return this->Layers > 0 || this->CellBudget > 0 || !this->KeepPoints.empty() ||
      !this->KeepOut.empty();
  }
  void Begin(Task& task, const Piece& piece, const cartesian::Processes& processes,
    vtkInformationVector** input, vtkInformationVector* output, cartesian::Execution& execution);
  static void Make(const Task& task, Piece& piece, cartesian::Execution& execution);
  static void CountPiecesBefore(Task& task, const Piece& piece, cartesian::Execution& execution);
  void RequestPieceAlone(Piece& piece, vtkInformationVector** input, vtkInformationVector* output);
  static unsigned long CodeOfAll(
    const std::vector<std::vector<double>>& counts, const cartesian::Processes& processes);
  void RequestPieceOfProcess(Piece& piece, const cartesian::Processes& processes,
    vtkInformationVector** input, vtkInformationVector* output);
  void RequestCutPiece(const Piece& piece, const cartesian::Processes& processes,
    vtkInformationVector** input, vtkInformationVector* output);
  bool MakeWholeMesh(WholeMesh& whole, int pieces, const cartesian::Processes& processes,
    vtkInformationVector** input);
  vtkMTimeType TimeWith(vtkInformationVector** input);
  void Write(const Task& task, const Piece& piece, const cartesian::MeshPiece& place,
    vtkInformationVector* output, cartesian::Execution& execution);
  void WarnOfLosses(const Task& task, const Piece& piece, vtkUnstructuredGrid* mesh,
    cartesian::Execution& execution);

  std::unique_ptr<Task> Kept; // from piece to piece, where this process makes all
  std::unique_ptr<WholeMesh> KeptWhole;
};

#endif
