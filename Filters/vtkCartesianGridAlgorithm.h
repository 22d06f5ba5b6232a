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
   * Length of a box's edges, in the surface's units; 0, the default, means 1/50 of the longest
   * side of the surface's bounding box. Meshlines win over it in their direction.
   */
  vtkSetMacro(CellSize, double);
  vtkGetMacro(CellSize, double);
  ///@}

  ///@{
  /**
   * Positions of the planes between boxes across x, y and z, in the surface's units: none (the
   * default, CellSize applies), or two or more that increase.
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
   * Cell array of the surface that numbers its boundaries, or names them. Empty, the default: the
   * blocks of the surface, or the solids that an STL file names, if there are several, else one
   * boundary.
   */
  vtkSetMacro(BoundaryArray, std::string);
  vtkGetMacro(BoundaryArray, std::string);
  ///@}

  /**
   * Updates the surface and gives `result` field data: the numbers (BoundaryIds) and the names
   * (BoundaryNames) of its boundaries. On an error it stays as it is.
   */
  void DescribeBoundaries(vtkDataObject* result);

  /**
   * Updates the surface and estimates, in a fraction of the time that the mesh takes, how large it will be:
   * the number of boxes, of cells, and the bytes of memory that it takes. All 0 on an error.
   */
  double* EstimateSize() VTK_SIZEHINT(3);

  /**
   * Lengths of the surface's bounding box along x, y and z, as a text; empty without a surface.
   */
  const char* GetSurfaceSize();

  /**
   * For the inputs as they are now, rows of four texts: what the columns are called; then the size of boxes, and about
   * how many boxes and cells there will be, and how much memory they take. The sizes are CellSize, in a row that begins
   * with an arrow, and the longest side by 25, 50, 100 and 200. Empty without a surface, or if the mesh would be
   * refused.
   */
  vtkStringArray* GetExpectedBoxes();

  /**
   * Until something changes, GetExpectedBoxes() gives the row of CellSize alone, which takes a fraction of the time.
   */
  void ExpectCellSizeAlone();

  ///@{
  /**
   * How often global boxes that the surface passes through may be halved along each axis, unless
   * a block or a boundary says otherwise: 0, the default, to 6.
   */
  vtkSetMacro(RefinementDepth, int);
  vtkGetMacro(RefinementDepth, int);
  ///@}

  ///@{
  /**
   * How many boxes of a level there are at least between one and boxes that are twice as large, as snappyHexMesh's
   * nCellsBetweenLevels: 1 to 10. 0, the default: 3 where vtkCartesianMesher meshes what is outside, else 1.
   */
  vtkSetMacro(TransitionLayers, int);
  vtkGetMacro(TransitionLayers, int);
  ///@}

  ///@{
  /**
   * Blocks of global boxes with depths of their own; later ones win. First and last box along each
   * axis (whole numbers from 0, both included), allowed depth (where the surface passes), forced
   * depth (everywhere in the block), 0 to 6.
   */
  void SetNumberOfRefinementBlocks(int number);
  void SetRefinementBlock(int row, double firstI, double lastI, double firstJ, double lastJ,
    double firstK, double lastK, double allowed, double forced);
  ///@}

  ///@{
  /**
   * Depth along boundaries, applied after blocks: the boundary, the depth of global boxes that it
   * passes through (0 to 6), the number of layers at each forced depth (0: no blending), 1 for
   * blending from depth - 1 on, else 0.
   */
  void SetNumberOfBoundaryRefinements(int number);
  void SetBoundaryRefinement(
    int row, double boundary, double depth, double blendLayers, double blendBelow);
  ///@}

  ///@{
  /**
   * Shapes, a row each, in which boxes are halved as in closed surfaces on input port 1: "box", "sphere", "cylinderX",
   * "cylinderY" or "cylinderZ", which fills a box given by its low corner and its lengths (more than 0; units of the
   * surface); and the depth, 0 to 6.
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
   * Takes all connections of input port 1 away.
   */
  void RemoveAllRefinementRegions() { this->RemoveAllInputConnections(1); }

  ///@{
  /**
   * Refinement level (0 to 6) of global boxes that the boundaries in the table of names pass through, without blending, unless a row of
   * SetBoundaryRefinement sets it; negative: as if they were not in the table.
   */
  void SetNumberOfBoundaryDepths(int number) { this->Resize(this->BoundaryDepths, number); }
  void SetBoundaryDepth(int row, int depth) { this->SetRow(this->BoundaryDepths, row, depth); }
  ///@}

  ///@{
  /**
   * Deprecated since 0.1.0: boundaries by name that are refined to RefinedBoundaryDepth (0 to 6, default 1) unless a
   * row says otherwise. BoundaryNames and BoundaryDepths replace it; a warning says so.
   */
  void SetRefinedBoundaryArrayStatus(const char* name, int chosen);
  void ChooseNoRefinedBoundaries();
  vtkSetMacro(RefinedBoundaryDepth, int);
  vtkGetMacro(RefinedBoundaryDepth, int);
  ///@}

  ///@{
  /**
   * Depth, allowed and forced, of global boxes in or at closed surfaces on input port 1 that have
   * none of their own (field data RegionDepth); 0 to 6, default 1. Applied last; only ever refines.
   */
  vtkSetMacro(RegionDepth, int);
  vtkGetMacro(RegionDepth, int);
  ///@}

  ///@{
  /**
   * Depths that the surface asks for by its shape; they only ever refine. Boxes are divided until the surface
   * turns by at most CurvatureAngle in each (degrees, 0 to 180; 0, the default: never), but for sharp edges;
   * boxes at sharp edges to FeatureDepth (0 to 6, default 0); and until CellsAcrossGaps of them (0 to 64,
   * default 0) fit between walls that face each other. Angle and gaps end at LargestDepth (0 to 6, default
   * 3). Edges are sharp beyond 30 degrees; in vtkCartesianMesher, beyond FeatureAngle.
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
   * A point or cell array, of the data on input port 2 if there are any, else of the surface, that says how long
   * the edges of boxes may be where it is, in the surface's units: boxes are divided until they are as small, or to
   * LargestDepth. Values that are not positive ask for nothing. Empty, the default: none.
   */
  vtkSetMacro(SizeArray, std::string);
  vtkGetMacro(SizeArray, std::string);
  void RemoveSizeField() { this->RemoveAllInputConnections(2); }
  ///@}

  ///@{
  /**
   * Memory that the mesh may need by an estimate made first, in GiB; beyond it the filter refuses
   * with TooManyBoxes. 0, the default, means three quarters of this machine's memory.
   */
  vtkSetClampMacro(MemoryLimit, double, 0, VTK_DOUBLE_MAX);
  vtkGetMacro(MemoryLimit, double);
  ///@}

protected:
  vtkCartesianGridAlgorithm();
  ~vtkCartesianGridAlgorithm() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  /**
   * What the properties say; refinement, which takes the surface's boundaries, and small cell ratios of
   * boundaries are left out.
   */
  virtual cartesian::Options MakeOptions();

  /**
   * Adds what the properties say about the surface's boundaries, but for refinement.
   */
  virtual void AddBoundaryOptions(
    const cartesian::SurfaceFromVTK& surface, cartesian::Options& options);

  /**
   * The table of boundaries, as the surface that Read() gives has them.
   */
  virtual cartesian::BoundarySettings Boundaries() const;

  /**
   * The surface with its boundaries and regions.
   */
  virtual cartesian::SurfaceFromVTK Read(vtkDataObject* surface) const;

  /**
   * The same with the sides of the box that is around it, if what is outside is meshed.
   */
  cartesian::SurfaceFromVTK ReadWithSides(vtkDataObject* data);

  /**
   * The surface on the lattice, checked; flaws are reported. `parts`: in how many parts the mesh is
   * made, none of which may take more than the memory allowed.
   */
  cartesian::PreparedSurface Prepare(
    const cartesian::SurfaceFromVTK& surface, cartesian::Execution& execution, int parts = 1);

  /**
   * All defects of the surface into `defects`; what the mesh may suffer from is reported.
   */
  void Inspect(const cartesian::PreparedSurface& prepared, const cartesian::SurfaceFromVTK& surface,
    vtkPolyData* defects, cartesian::Execution& execution);

  /**
   * How the grid is divided; rows of tables that reach beyond it are reported. `source` is what
   * `prepared` was made from and is borrowed, `regions` what Regions() gives, `sizes` what
   * ReadSizes() does.
   */
  std::unique_ptr<cartesian::Decomposition> Divide(const cartesian::SurfaceFromVTK& source,
    const cartesian::PreparedSurface& prepared,
    const std::vector<vtkSmartPointer<vtkDataObject>>& regions, cartesian::AskedSizes sizes,
    cartesian::Execution& execution);

  /**
   * What the SizeArray asks for: `field` is the input of port 2, or null.
   */
  cartesian::AskedSizes ReadSizes(
    vtkDataObject* surface, const cartesian::SurfaceFromVTK& source, vtkDataObject* field) const;

  /**
   * The inputs of port 1.
   */
  static std::vector<vtkSmartPointer<vtkDataObject>> Regions(vtkInformationVector* input);

  /**
   * The surface, brought up to date, or null; and all other inputs.
   */
  vtkDataObject* UpdatedSurface();
  void UpdateOptionalInputs();

  /**
   * Of the surface as it is now; not valid without one.
   */
  vtkBoundingBox BoundsOfInput();

  /**
   * Whether boxes around bodies have the sizes of FlowRefinement.h, as the user asks for no others.
   */
  bool RefinesFlow(const cartesian::DomainSpec& domain) const;

  /**
   * The inputs of port 1, as they are now.
   */
  std::vector<vtkSmartPointer<vtkDataObject>> OptionalRegions();

  double CellSize = 0;
  std::array<std::vector<double>, 3> Meshlines;
  std::string BoundaryArray;
  int RefinementDepth = 0;
  int TransitionLayers = 0;
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
  cartesian::RefinementSpec MakeSpec(const std::map<std::int32_t, std::string>& names) const;
  vtkMTimeType LastChange(); // of this or an input
  using Estimate = std::vector<cartesian::ExpectedRow>(
    const cartesian::SurfaceView&, const cartesian::Options&, cartesian::Execution&);
  void Expect(Estimate* estimate);

  // A closed surface around a region to refine, with its own depth or RegionDepth; of the given ones and the shapes.
  struct RegionSurface;
  std::vector<RegionSurface> RegionSurfaces(
    const std::vector<vtkSmartPointer<vtkDataObject>>& given) const;
  // Nothing, where the user asks for other boxes.
  cartesian::FlowRefinement FlowOf(
    const cartesian::SurfaceFromVTK& source, const cartesian::Options& options) const;
  void AddFlowRefinement(const cartesian::SurfaceFromVTK& source, cartesian::Options& options,
    std::vector<RegionSurface>& regions) const;
  void AddRefinement(const cartesian::SurfaceFromVTK& source, std::vector<RegionSurface>& regions,
    cartesian::AskedSizes sizes, cartesian::Options& options);

  // What the properties and the inputs, as they are, say about the surface.
  struct Asked;
  Asked Ask(const cartesian::SurfaceFromVTK& surface);

  vtkMTimeType ExpectedTime = 0;
  vtkNew<vtkStringArray> ExpectedBoxes;
  std::string SurfaceSize;
  std::array<double, 3> EstimatedSize{};
};

#endif
