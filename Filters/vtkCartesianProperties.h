// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file vtkCartesianProperties.h
 * @brief properties that a single step of the mesher shares with vtkCartesianMesher
 *
 * Each is written once, as a macro: VTK's wrappers see the methods in every class that has it, which
 * they would not in a template or a second base class. Initial values are those of Kernel/Mesher/Options.h.
 */
#ifndef vtkCartesianProperties_h
#define vtkCartesianProperties_h

#include "vtkSetGet.h" // for vtkSetMacro

#include <string> // for std::string
#include <vector> // for std::vector

/**
 * Properties of patches: vtkPatcher, vtkCartesianMesher.
 *
 * PatchMethod, one of PatchMethods, default Automatic: Automatic is Marching Cubes where it is safe and
 * Exact Fit elsewhere; ExactFit the surface itself, cut at the sides of the boxes; MarchingCubes
 * everywhere, for comparison: sharp edges are chamfered, details are lost.
 *
 * FeatureAngle, degrees, 0 to 180, default 30: edges at which the surface turns by more than this are kept.
 *
 * MergeAngle, degrees, 0 to 90, default 10: how far normals within one patch may differ. With Patch Method Exact Fit
 * nothing is merged.
 *
 * Tying, one of Tyings, default KeepNodes: how an Exact Fit box's nodes on a side shared with a Marching Cubes box
 * are treated. KeepNodes: the neighbour adopts them; MoveNodes: they move onto the neighbour's straight line
 * (equation 5).
 */
#define vtkPatchPropertiesMacro()                                                                  \
public:                                                                                            \
  enum PatchMethods                                                                                \
  {                                                                                                \
    Automatic = 0,                                                                                 \
    ExactFit = 1,                                                                                  \
    MarchingCubes = 2                                                                              \
  };                                                                                               \
  enum Tyings                                                                                      \
  {                                                                                                \
    KeepNodes = 0,                                                                                 \
    MoveNodes = 1                                                                                  \
  };                                                                                               \
  vtkSetClampMacro(PatchMethod, int, Automatic, MarchingCubes);                                    \
  vtkGetMacro(PatchMethod, int);                                                                   \
  void SetPatchMethodToAutomatic()                                                                 \
  {                                                                                                \
    this->SetPatchMethod(Automatic);                                                               \
  }                                                                                                \
  void SetPatchMethodToExactFit()                                                                  \
  {                                                                                                \
    this->SetPatchMethod(ExactFit);                                                                \
  }                                                                                                \
  void SetPatchMethodToMarchingCubes()                                                             \
  {                                                                                                \
    this->SetPatchMethod(MarchingCubes);                                                           \
  }                                                                                                \
  vtkSetMacro(FeatureAngle, double);                                                               \
  vtkGetMacro(FeatureAngle, double);                                                               \
  vtkSetMacro(MergeAngle, double);                                                                 \
  vtkGetMacro(MergeAngle, double);                                                                 \
  vtkSetClampMacro(Tying, int, KeepNodes, MoveNodes);                                              \
  vtkGetMacro(Tying, int);                                                                         \
  void SetTyingToKeepNodes()                                                                       \
  {                                                                                                \
    this->SetTying(KeepNodes);                                                                     \
  }                                                                                                \
  void SetTyingToMoveNodes()                                                                       \
  {                                                                                                \
    this->SetTying(MoveNodes);                                                                     \
  }                                                                                                \
                                                                                                   \
protected:                                                                                         \
  int PatchMethod = Automatic;                                                                     \
  double FeatureAngle = 30;                                                                        \
  double MergeAngle = 10;                                                                          \
  int Tying = KeepNodes

/**
 * Properties of cells: vtkCellAssembler, vtkCartesianMesher.
 *
 * CollapseRatio, 0 (none) to 0.3, default 0.1: edges shorter than this fraction of their box collapse, so that hardly
 * any small cells remain (4.10). Corners of boxes move onto the surface; surface nodes move along it only. On curved
 * smooth surfaces, edges up to five times as long, at most half a box, collapse too.
 *
 * SmallCells, one of SmallCellsModes, default Merge (4.10). Remove: they are left out; their inner faces become
 * boundary faces of their neighbours. Merge: they are merged into a neighbour; the volume is kept.
 *
 * MergeRatio, 0 (none) to less than 1, default 0.3: with Merge, cells smaller than this fraction of their box are
 * merged; those that strain solvers and that no neighbour can absorb are left out if smaller than a tenth of it,
 * unless the body is as thin as the cell there. With several regions, 0.15 at most.
 *
 * SmallCellRatio, 0 (only cells without volume) to less than 1, default 0.001: with Remove, cells smaller than this
 * fraction of their box are left out.
 *
 * SplitConcaveCells, default on: cells that fail an angle condition of section 3 are cut along their
 * concave edges (4.11).
 *
 * TrueVolume, default on: where small cells merge or concave ones are split, and Patch Method is Automatic, nodes of
 * curved walls move off the surface so that the mesh encloses the surface's volume; sharp edges, flat walls and
 * borders between boundaries stay.
 *
 * OptimiseNodes, default on: where small cells merge or concave ones are split, and the patches are not exact, nodes
 * of the cells at the surface move until the faces around them are within preferred quality limits; surface nodes
 * move along it. Faces that are still poor are repaired one by one: single nodes move, close nodes merge, faces are
 * joined.
 *
 * RefusedCellRatio, 0 (none) or more, default 4: where concave cells are split and the patches are not exact, cells
 * with an inverted face that cannot be repaired are left out, up to this many box volumes; other failing cells
 * (section 3, checkMesh), up to a tenth of their box. Boundaries with their own small cell ratio keep larger ones.
 */
#define vtkCellPropertiesMacro()                                                                   \
public:                                                                                            \
  enum SmallCellsModes                                                                             \
  {                                                                                                \
    Remove = 0,                                                                                    \
    Merge = 1                                                                                      \
  };                                                                                               \
  vtkSetMacro(CollapseRatio, double);                                                              \
  vtkGetMacro(CollapseRatio, double);                                                              \
  vtkSetClampMacro(SmallCells, int, Remove, Merge);                                                \
  vtkGetMacro(SmallCells, int);                                                                    \
  void SetSmallCellsToRemove()                                                                     \
  {                                                                                                \
    this->SetSmallCells(Remove);                                                                   \
  }                                                                                                \
  void SetSmallCellsToMerge()                                                                      \
  {                                                                                                \
    this->SetSmallCells(Merge);                                                                    \
  }                                                                                                \
  vtkSetMacro(MergeRatio, double);                                                                 \
  vtkGetMacro(MergeRatio, double);                                                                 \
  vtkSetMacro(SmallCellRatio, double);                                                             \
  vtkGetMacro(SmallCellRatio, double);                                                             \
  vtkSetMacro(SplitConcaveCells, bool);                                                            \
  vtkGetMacro(SplitConcaveCells, bool);                                                            \
  vtkBooleanMacro(SplitConcaveCells, bool);                                                        \
  vtkSetMacro(TrueVolume, bool);                                                                   \
  vtkGetMacro(TrueVolume, bool);                                                                   \
  vtkBooleanMacro(TrueVolume, bool);                                                               \
  vtkSetMacro(OptimiseNodes, bool);                                                                \
  vtkGetMacro(OptimiseNodes, bool);                                                                \
  vtkBooleanMacro(OptimiseNodes, bool);                                                            \
  vtkSetMacro(RefusedCellRatio, double);                                                           \
  vtkGetMacro(RefusedCellRatio, double);                                                           \
                                                                                                   \
protected:                                                                                         \
  double CollapseRatio = 0.1;                                                                      \
  int SmallCells = Merge;                                                                          \
  double MergeRatio = 0.3;                                                                         \
  double SmallCellRatio = 1e-3;                                                                    \
  bool SplitConcaveCells = true;                                                                   \
  bool TrueVolume = true;                                                                          \
  bool OptimiseNodes = true;                                                                       \
  double RefusedCellRatio = 4

/**
 * The table of boundaries: names, or patterns for several, with * for any text and ? for any character, which all of
 * its columns belong to. vtkCartesianGridAlgorithm, vtkCellAssembler.
 */
#define vtkBoundaryNamesMacro()                                                                    \
public:                                                                                            \
  void SetNumberOfBoundaryNames(int number)                                                        \
  {                                                                                                \
    this->Resize(this->BoundaryNames, number);                                                     \
  }                                                                                                \
  void SetBoundaryName(int row, const char* name)                                                  \
  {                                                                                                \
    this->SetRow(this->BoundaryNames, row, std::string(name ? name : ""));                         \
  }                                                                                                \
                                                                                                   \
protected:                                                                                         \
  std::vector<std::string> BoundaryNames

/**
 * Columns of the table of boundaries: the type that vtkPolyMeshWriter gives the patch (automatic, patch, wall, symmetry,
 * symmetryPlane, empty), and the ratio that replaces SmallCellRatio in cells whose patches are mostly on this boundary
 * (section 4.10). As many types and ratios as names, or none. "no_surface" stands for faces without a patch.
 * vtkCellAssembler, vtkCartesianMesher.
 */
#define vtkBoundarySettingsMacro()                                                                 \
public:                                                                                            \
  void SetNumberOfBoundaryTypes(int number)                                                        \
  {                                                                                                \
    this->Resize(this->BoundaryTypes, number);                                                     \
  }                                                                                                \
  void SetBoundaryType(int row, const char* type)                                                  \
  {                                                                                                \
    this->SetRow(this->BoundaryTypes, row, std::string(type ? type : ""));                         \
  }                                                                                                \
  void SetNumberOfBoundarySmallCellRatios(int number)                                              \
  {                                                                                                \
    this->Resize(this->BoundaryRatios, number);                                                    \
  }                                                                                                \
  void SetBoundarySmallCellRatio(int row, double ratio)                                            \
  {                                                                                                \
    this->SetRow(this->BoundaryRatios, row, ratio);                                                \
  }                                                                                                \
                                                                                                   \
protected:                                                                                         \
  void PrintBoundarySettings(ostream& os, vtkIndent indent)                                        \
  {                                                                                                \
    this->PrintColumn(os, indent, "BoundaryTypes", this->BoundaryTypes);                           \
    this->PrintColumn(os, indent, "BoundarySmallCellRatios", this->BoundaryRatios);                \
  }                                                                                                \
  std::vector<std::string> BoundaryTypes;                                                          \
  std::vector<double> BoundaryRatios

#endif
