// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkCartesianGridAlgorithm
 * @brief the grid around a surface and its refinement
 *
 * What vtkCartesianBoxer, vtkCartesianMesher and vtkSurfaceInspector have in common: the properties of the grid
 * (sections 4.1 to 4.6 of the paper), estimates of the mesh size, and the steps from the surface to the divided grid.
 *
 * Input port 0: a closed surface (vtkPolyData, or blocks of it, which are boundaries). Port 1, optional, many: closed
 * surfaces (vtkPolyData, or blocks of them), each around a refinement zone. Port 2, optional: a data set of any kind, or
 * blocks of them, with the SizeArray.
 *
 * The boxes lie between meshlines: planes across x, y and z. They are CellSize apart, starting at
 * the surface's bounding box, or where the user puts them. The global boxes between them may be
 * halved again and again, along one, two or three axes: into the fewest boxes that cover what is
 * inside or intersected at the refinement level allowed there, balanced between neighbours.
 *
 * Errors: EmptySurface, BadCoordinate, BadCellSize, BadMeshlines, TooManyBoxes,
 * MissingArray, BadParameter (a refinement level, a block, an unknown boundary); FlawedSurface (a
 * refinement zone is no closed surface).
 *
 * @sa vtkCartesianBoxer vtkCartesianMesher vtkSurfaceInspector
 */
#ifndef vtkCartesianGridAlgorithm_h
#define vtkCartesianGridAlgorithm_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro
#include "vtkCartesianProperties.h"          // for vtkBoundaryNamesMacro

#include "vtkBoundingBox.h"  // for vtkBoundingBox
#include "vtkNew.h"          // for vtkNew
#include "vtkSmartPointer.h" // for vtkSmartPointer

#include <array>   // for std::array
#include <cstdint> // for std::int32_t
#include <map>     // for std::map
#include <memory>  // for std::unique_ptr
#include <set>     // for std::set
#include <string>  // for std::string
#include <vector>  // for std::vector

class vtkPolyData;
class vtkStringArray;

namespace cartesian
{
struct AskedSizes;
struct BoundarySettings;
class Decomposition;
struct DomainSpec;
class Execution;
struct ExpectedRow;
struct FlowRefinement;
struct Options;
struct PreparedSurface;
struct RefinementSpec;
class SurfaceFromVTK;
struct SurfaceView;
}

class VTKCARTESIANMESHERFILTERS_EXPORT vtkCartesianGridAlgorithm : public vtkCartesianAlgorithm
{
public:
  vtkTypeMacro(vtkCartesianGridAlgorithm, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  vtkBoundaryNamesMacro();

public:
  ///@{
  /**
   * Edge length of a box, in units of the surface; 0, the default, means 1/50 of the longest side of the
   * surface's bounding box. Meshlines override it along their axis.
   */
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /**
   * Positions of the planes between boxes along x, y and z, in units of the surface: none (the default, CellSize
   * applies), or at least two, increasing.
   */
  void SetNumberOfMeshlinesX(int number) { this->SetNumberOfMeshlines(0, number); }
  void SetNumberOfMeshlinesY(int number) { this->SetNumberOfMeshlines(1, number); }
  void SetNumberOfMeshlinesZ(int number) { this->SetNumberOfMeshlines(2, number); }
  void SetMeshlineX(int i, double position) { this->SetMeshline(0, i, position); }
  void SetMeshlineY(int i, double position) { this->SetMeshline(1, i, position); }
  void SetMeshlineZ(int i, double position) { this->SetMeshline(2, i, position); }
  ///@}

  ///@{
  /**
   * The same with the axis as a number: 0, 1, 2 for x, y, z. An index out of range is an error.
   */
  void SetNumberOfMeshlines(int axis, int number);
  int GetNumberOfMeshlines(int axis);
  void SetMeshline(int axis, int i, double position);
  double GetMeshline(int axis, int i);
  ///@}

  ///@{
  /**
   * Cell array of the surface with the number or name of each triangle's boundary. Default: empty, which means
   * the blocks of the surface, or the named solids of an STL file, if there are several, otherwise one boundary.
   */
  vtkSetMacro(BoundaryArray, std::string);
  vtkGetMacro(BoundaryArray, std::string);
  ///@}

  /**
   * Updates the surface and adds field data to `result`: the numbers (BoundaryIds) and names (BoundaryNames) of
   * its boundaries. On an error, `result` is unchanged.
   */
  void DescribeBoundaries(vtkDataObject* result);

  /**
   * Updates the surface and estimates, in a fraction of the meshing time, the size of the mesh: boxes, cells,
   * and bytes of memory. All 0 on an error. Warns of flaws of the surface.
   */
  double* EstimateSize() VTK_SIZEHINT(3);

  /**
   * Lengths of the surface's bounding box along x, y and z, as a text; empty without a surface.
   */
  const char* GetSurfaceSize();

  /**
   * For the current inputs, rows of four texts: the headings; then the box size and estimates of boxes, cells
   * and memory. The sizes are CellSize, in a row that begins with an arrow, and 1/25, 1/50, 1/100 and 1/200 of
   * the longest side. Empty without a surface, or if meshing would end in an error.
   */
  vtkStringArray* GetExpectedBoxes();

  /**
   * Until something changes, GetExpectedBoxes() gives only the row of CellSize, which takes a fraction of the
   * time.
   */
  void ExpectCellSizeAlone();

  ///@{
  /**
   * Refinement level at the surface: how many times boxes that it passes through may be halved along each axis,
   * unless a block or a boundary overrides it: 0 (the default) to 6.
   */
  vtkSetMacro(RefinementDepth, int);
  vtkGetMacro(RefinementDepth, int);
  ///@}

  ///@{
  /**
   * Minimum number of boxes of one size between a smaller size and the next larger one (snappyHexMesh's
   * nCellsBetweenLevels): 1 to 10. 0, the default: 3 with vtkCartesianMesher's Domain Outside, otherwise 1.
   */
  vtkSetMacro(TransitionLayers, int);
  vtkGetMacro(TransitionLayers, int);
  ///@}

  ///@{
  /**
   * Whether boxes are halved along x, y and z alike, which takes more of them: solvers that refine hexahedra need it
   * (vtkPolyMeshWriter.h). Default: off.
   */
  vtkSetMacro(IsotropicLevels, bool);
  vtkGetMacro(IsotropicLevels, bool);
  vtkBooleanMacro(IsotropicLevels, bool);
  ///@}

  ///@{
  /**
   * Axes across which opposite sides of the grid are periodic (vtkPeriodicBoundaries.h), the sum of 1 (x), 2 (y) and 4
   * (z): boxes are halved as if, beyond each end, those at the other end followed, with as many transition layers. 0,
   * the default: none.
   */
  vtkSetClampMacro(PeriodicSides, int, 0, 7);
  vtkGetMacro(PeriodicSides, int);
  void SetPeriodicSidesToNone() { this->SetPeriodicSides(0); }
  void SetPeriodicSidesToX() { this->SetPeriodicSides(1); }
  void SetPeriodicSidesToY() { this->SetPeriodicSides(2); }
  void SetPeriodicSidesToXandY() { this->SetPeriodicSides(3); }
  void SetPeriodicSidesToZ() { this->SetPeriodicSides(4); }
  void SetPeriodicSidesToXandZ() { this->SetPeriodicSides(5); }
  void SetPeriodicSidesToYandZ() { this->SetPeriodicSides(6); }
  void SetPeriodicSidesToAll() { this->SetPeriodicSides(7); }
  ///@}

  ///@{
  /**
   * Blocks of boxes with refinement levels of their own; later rows override earlier ones. First and last box
   * along each axis (whole numbers from 0, both included), the level allowed where the surface passes, and the
   * level forced everywhere in the block, 0 to 12 (section 4.6).
   */
  void SetNumberOfRefinementBlocks(int number);
  void SetRefinementBlock(int row, double firstI, double lastI, double firstJ, double lastJ,
    double firstK, double lastK, double allowed, double forced);
  ///@}

  ///@{
  /**
   * Refinement along boundaries, applied after blocks: the number of the boundary, the level of boxes that it
   * passes through (0 to 12), the blending distance (layers of boxes at each forced level; 0: no blending), and 1
   * if blending starts one level lower, otherwise 0.
   */
  void SetNumberOfBoundaryRefinements(int number);
  void SetBoundaryRefinement(
    int row, double boundary, double depth, double blendLayers, double blendBelow);
  ///@}

  ///@{
  /**
   * Refinement zones like the closed surfaces on input port 1, one per row: "box", "sphere", "cylinderX",
   * "cylinderY" or "cylinderZ", which fills the box given by its lower corner and its lengths (more than 0;
   * units of the surface); and the refinement level, 0 to 12.
   */
  void SetNumberOfRefinementShapes(int number);
  void SetRefinementShape(int row, const char* shape);
  void SetNumberOfRefinementPositions(int number);
  void SetRefinementPosition(int row, double x, double y, double z);
  void SetNumberOfRefinementLengths(int number);
  void SetRefinementLength(int row, double x, double y, double z);
  void SetNumberOfRefinementShapeDepths(int number);
  void SetRefinementShapeDepth(int row, int depth);
  ///@}

  /**
   * Removes all connections of input port 1.
   */
  void RemoveAllRefinementRegions() { this->RemoveAllInputConnections(1); }

  ///@{
  /**
   * Refinement level (0 to 12) of global boxes that the boundaries in the table of names pass through, without blending, unless a row of
   * SetBoundaryRefinement sets it; negative: as if they were not in the table.
   */
  void SetNumberOfBoundaryDepths(int number) { this->Resize(this->BoundaryDepths, number); }
  void SetBoundaryDepth(int row, int depth) { this->SetRow(this->BoundaryDepths, row, depth); }
  ///@}

  ///@{
  /**
   * Deprecated since 0.1.0: boundaries by name that are refined to RefinedBoundaryDepth (0 to 12, default 1) unless a
   * row says otherwise. BoundaryNames and BoundaryDepths replace it; a warning says so.
   */
  void SetRefinedBoundaryArrayStatus(const char* name, int chosen);
  void ChooseNoRefinedBoundaries();
  vtkSetMacro(RefinedBoundaryDepth, int);
  vtkGetMacro(RefinedBoundaryDepth, int);
  ///@}

  ///@{
  /**
   * Refinement level of boxes inside or touching closed surfaces on input port 1 that have none of their own
   * (field data RegionDepth); 0 to 12, default 1. Applied last; only ever refines.
   */
  vtkSetMacro(RegionDepth, int);
  vtkGetMacro(RegionDepth, int);
  ///@}

  ///@{
  /**
   * Refinement by the shape of the surface; it only ever refines. Boxes are halved until the surface turns by at
   * most CurvatureAngle in each (degrees, 0 to 180; default 0, off), sharp edges excepted; boxes at sharp edges
   * to level FeatureDepth (0 to 12, default 0); and until CellsAcrossGaps of them (0 to 124, default 0, off) fit
   * between walls that face each other. LargestDepth (0 to 12, default 3) limits angle and gaps. Edges are sharp
   * beyond 30 degrees; in vtkCartesianMesher, beyond FeatureAngle.
   */
  vtkSetMacro(CurvatureAngle, double);
  vtkGetMacro(CurvatureAngle, double);
  vtkSetMacro(FeatureDepth, int);
  vtkGetMacro(FeatureDepth, int);
  vtkSetMacro(CellsAcrossGaps, int);
  vtkGetMacro(CellsAcrossGaps, int);
  vtkSetMacro(LargestDepth, int);
  vtkGetMacro(LargestDepth, int);
  ///@}

  ///@{
  /**
   * Name of a point or cell array, of the data on input port 2 if connected, otherwise of the surface, that
   * limits the edge length of boxes, in units of the surface: boxes are halved until none is longer, or to
   * LargestDepth. Values that are not positive are ignored. Default: empty, none.
   */
  vtkSetMacro(SizeArray, std::string);
  vtkGetMacro(SizeArray, std::string);
  void RemoveSizeField() { this->RemoveAllInputConnections(2); }
  ///@}

  ///@{
  /**
   * Memory that the mesh may need, in GiB, by an estimate made before meshing; beyond it, the error is
   * TooManyBoxes. 0, the default, means three quarters of this machine's memory.
   */
  vtkSetClampMacro(MemoryLimit, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkCartesianGridAlgorithm();
  ~vtkCartesianGridAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;

  /**
   * The options that the properties set, except refinement and what depends on the surface's boundaries.
   */
  virtual cartesian::Options MakeOptions();

  /**
   * What GetSurfaceSize() says of the longest side after the lengths; by default, nothing.
   */
  virtual std::string NoteOfLength(double /*longest*/) { return {}; }

  /**
   * Is called with all options whenever an estimate begins; null: none are known.
   */
  virtual void BeginEstimate(const cartesian::Options* /*options*/) {}

  /**
   * Adds the options that depend on the surface's boundaries, except refinement.
   */
  virtual void AddBoundaryOptions(
    const cartesian::SurfaceFromVTK& surface, cartesian::Options& options);

  /**
   * The table of boundaries, with the names that the surface from Read() has.
   */
  virtual cartesian::BoundarySettings Boundaries() const;

  /**
   * The surface with its boundaries and regions.
   */
  virtual cartesian::SurfaceFromVTK Read(vtkDataObject* surface) const;

  /**
   * The same, with the sides of the box around it if the outside is meshed, and what closes gaps.
   */
  cartesian::SurfaceFromVTK ReadWithSides(vtkDataObject* data);

  /**
   * How often boxes at the surface may be halved, as all boundaries' depths and sizes by shape say; checked elsewhere.
   */
  int DepthAtSurface(
    const cartesian::SurfaceFromVTK& source, const cartesian::Options& options) const;

  /**
   * Adds what closes gaps, if the options say that they are.
   */
  void AddGaps(cartesian::SurfaceFromVTK& surface);

  /**
   * The surface on the lattice, checked; flaws are reported. `parts`: number of parts in which the mesh is
   * made; none may need more memory than allowed.
   */
  cartesian::PreparedSurface Prepare(
    const cartesian::SurfaceFromVTK& surface, cartesian::Execution& execution, int parts = 1);

  /**
   * Lists all defects of the surface in `defects`; those that may affect the mesh are reported.
   */
  void Inspect(const cartesian::PreparedSurface& prepared, const cartesian::SurfaceFromVTK& surface,
    vtkPolyData* defects, cartesian::Execution& execution);

  /**
   * Divides the grid; table rows that extend beyond it are reported. `source`, from which `prepared` was made, is
   * borrowed; `regions` are from Regions(), `sizes` from ReadSizes().
   */
  std::unique_ptr<cartesian::Decomposition> Divide(const cartesian::SurfaceFromVTK& source,
    const cartesian::PreparedSurface& prepared,
    const std::vector<vtkSmartPointer<vtkDataObject>>& regions, cartesian::AskedSizes sizes,
    cartesian::Execution& execution);

  /**
   * The sizes in the SizeArray; `field` is the input of port 2, or null.
   */
  cartesian::AskedSizes ReadSizes(
    vtkDataObject* surface, const cartesian::SurfaceFromVTK& source, vtkDataObject* field) const;

  /**
   * The inputs of port 1.
   */
  static std::vector<vtkSmartPointer<vtkDataObject>> Regions(vtkInformationVector* input);

  /**
   * Update the surface, which may be null, and all other inputs.
   */
  vtkDataObject* UpdatedSurface();
  void UpdateOptionalInputs();

  /**
   * Bounds of the current surface; invalid without one.
   */
  vtkBoundingBox BoundsOfInput();

  /**
   * Whether box sizes around bodies are those of FlowRefinement.h, because the user sets no others.
   */
  bool RefinesFlow(const cartesian::DomainSpec& domain) const;

  /**
   * The current inputs of port 1.
   */
  std::vector<vtkSmartPointer<vtkDataObject>> OptionalRegions();

  /**
   * A closed surface around a refinement zone, with its own level or RegionDepth.
   */
  struct RegionSurface;

  ///@{
  /**
   * All options, by the current properties and inputs, for the surface.
   */
  struct Asked;
  Asked Ask(const cartesian::SurfaceFromVTK& surface);
  ///@}

  double CellSize = 0;
  std::array<std::vector<double>, 3> Meshlines;
  std::string BoundaryArray;
  int RefinementDepth = 0;
  int TransitionLayers = 0;
  bool IsotropicLevels = false;
  int PeriodicSides = 0;
  std::vector<std::array<double, 8>> RefinementBlocks;
  std::vector<std::array<double, 4>> BoundaryRefinements;
  std::vector<int> BoundaryDepths;
  std::set<std::string> RefinedBoundaries;
  int RefinedBoundaryDepth = 1;
  int RegionDepth = 1;
  std::vector<std::string> RefinementShapes;
  std::vector<std::array<double, 3>> RefinementPositions;
  std::vector<std::array<double, 3>> RefinementLengths;
  std::vector<int> RefinementShapeDepths;
  double CurvatureAngle = 0;
  int FeatureDepth = 0;
  int CellsAcrossGaps = 0;
  int LargestDepth = 3;
  std::string SizeArray;
  double MemoryLimit = 0;

private:
  vtkCartesianGridAlgorithm(const vtkCartesianGridAlgorithm&) = delete;
  void operator=(const vtkCartesianGridAlgorithm&) = delete;

  bool HasMeshline(int axis, int i);
  cartesian::RefinementSpec MakeSpec(const cartesian::SurfaceFromVTK& surface) const;
  vtkMTimeType LastChange(); // of this or an input
  using Estimate = std::vector<cartesian::ExpectedRow>(
    const cartesian::SurfaceView&, const cartesian::Options&, cartesian::Execution&);
  void Expect(Estimate* estimate);

  // Given ones, then the shapes.
  std::vector<RegionSurface> RegionSurfaces(
    const std::vector<vtkSmartPointer<vtkDataObject>>& given) const;
  // Empty if the user sets other box sizes.
  cartesian::FlowRefinement FlowOf(
    const cartesian::SurfaceFromVTK& source, const cartesian::Options& options) const;
  void AddFlowRefinement(const cartesian::SurfaceFromVTK& source, cartesian::Options& options,
    std::vector<RegionSurface>& regions) const;
  void AddRefinement(const cartesian::SurfaceFromVTK& source, std::vector<RegionSurface>& regions,
    cartesian::AskedSizes sizes, cartesian::Options& options);

  vtkMTimeType ExpectedTime = 0;
  vtkNew<vtkStringArray> ExpectedBoxes;
  std::string SurfaceSize;
  std::array<double, 3> EstimatedSize{};
};

#endif
