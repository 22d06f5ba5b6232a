// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class vtkFiniteVolumeQuality
 * @brief measures how suitable a mesh is for finite-volume solvers
 *
 * Input: any unstructured grid of linear cells, including polyhedra with outward faces. Outputs: port 0 "Mesh", the
 * grid with the arrays below on its cells; port 1 "Faces" (vtkPolyData), each face once with the arrays below that
 * are measured on faces, and Owner and Neighbour (id type; -1 on the boundary), the cells on both sides; port 2
 * "Failing Cells", those of the Mesh that fail any measure but TetQuality, which solvers need for particles only. Faces
 * are counter-clockwise from outside their owner; inner faces come first, in upper-triangular order; points are the
 * grid's.
 *
 * All have Failures (unsigned int): the sum of the codes of all measures whose value is at or beyond the limit; 0
 * for cells and faces that pass. Other arrays are doubles. A cell has the worst value of its faces; where there is
 * nothing to measure, the best. The first seven are the conditions of the paper's section 3; the rest, Openness and
 * Volume are those of checkMesh (OpenFOAM 1912), with its definitions and limits.
 *
 * | Array             | On faces too | Limit  | Code | What is measured                              |
 * |-------------------|--------------|--------|------|-----------------------------------------------|
 * | Volume            |              | > 0    | 1    | volume of the cell                            |
 * | Openness          |              | < 1e-6 | 2    | sum of the face vectors (equation 2) by their sizes |
 * | OpenEdges         |              | < 1    | 4    | edges where the cell has a gap                |
 * | BoundaryAngle     | yes          | < 90   | 8    | degrees between the line from the cell's centre to a boundary face's and its outward normal |
 * | InnerAngle        | yes          | < 75   | 16   | the same for inner faces                      |
 * | StarTriangulation | yes          | > -1e-6 | 32  | smallest triangle of the face's star by the mean one; negative: inverted |
 * | NonOrthogonality  | yes          | < 70   | 64   | degrees between the line from cell centre to cell centre and the face's normal |
 * | Skewness          | yes          | < 4    | 128  | how far that line misses the face's centre, by the face's size |
 * | FaceWeight        | yes          | > 0.05 | 256  | distances of both centres from the face, the smaller by their sum |
 * | VolumeRatio       | yes          | > 0.01 | 512  | volumes of both cells, the smaller by the larger |
 * | Determinant       |              | > 1e-3 | 1024 | of the normals' tensor over inner faces; 1 for a cube |
 * | AspectRatio       |              | < 1000 | 2048 | largest by smallest sum of face areas across an axis, or area by volume^(2/3) |
 * | TetQuality        | yes          | > 1e-30 | 4096 | of an edge, the face's centre and the cell's; 1 is regular |
 * | Concavity         |              | none   |      | degrees beyond 180 inside the cell at its most concave edge; coplanar faces are not concave |
 *
 * Field data of all: Cells, FailingCells, ConcaveCells (Concavity of a degree or more),
 * TotalVolume, BoundaryArea, and for each array above its name with Failures (a number of cells)
 * and with Max or Min before it, the worst of all cells.
 *
 * Cells of layers (cell array Layer above 0) do not fail in Determinant and AspectRatio, nor in InnerAngle below 89.999.
 *
 * Cells of less than three dimensions have NaN and no failures. On several processes each measures its own part of
 * the mesh and requests a layer of ghost cells, which count as neighbours only; without them, faces between parts are
 * boundary. The field data cover all parts.
 *
 * Errors: BadMesh (cells with curved edges, or too many points).
 *
 * @sa vtkCartesianMesher
 */
#ifndef vtkFiniteVolumeQuality_h
#define vtkFiniteVolumeQuality_h

#include "vtkCartesianAlgorithm.h"
#include "vtkCartesianMesherFiltersModule.h" // for the export macro

class VTKCARTESIANMESHERFILTERS_EXPORT vtkFiniteVolumeQuality : public vtkCartesianAlgorithm
{
public:
  static vtkFiniteVolumeQuality* New();
  vtkTypeMacro(vtkFiniteVolumeQuality, vtkCartesianAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Limits at which measures fail; defaults as in the table above. The others cannot be changed.
   */
  vtkSetMacro(OpennessLimit, double);
  vtkGetMacro(OpennessLimit, double);
  vtkSetMacro(BoundaryAngleLimit, double);
  vtkGetMacro(BoundaryAngleLimit, double);
  vtkSetMacro(InnerAngleLimit, double);
  vtkGetMacro(InnerAngleLimit, double);
  vtkSetMacro(NonOrthogonalityLimit, double);
  vtkGetMacro(NonOrthogonalityLimit, double);
  vtkSetMacro(SkewnessLimit, double);
  vtkGetMacro(SkewnessLimit, double);
  vtkSetMacro(FaceWeightLimit, double);
  vtkGetMacro(FaceWeightLimit, double);
  vtkSetMacro(VolumeRatioLimit, double);
  vtkGetMacro(VolumeRatioLimit, double);
  vtkSetMacro(DeterminantLimit, double);
  vtkGetMacro(DeterminantLimit, double);
  vtkSetMacro(AspectRatioLimit, double);
  vtkGetMacro(AspectRatioLimit, double);
  ///@}

  /**
   * After an update the name of the measure, except TetQuality, that most cells fail or, where none fails, that whose
   * worst value is nearest to its limit; on all processes the same.
   */
  const char* GetWorstMeasure() const { return this->WorstMeasure; }

protected:
  vtkFiniteVolumeQuality();
  ~vtkFiniteVolumeQuality() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  double OpennessLimit = 1e-6;
  double BoundaryAngleLimit = 90;
  double InnerAngleLimit = 75;
  double NonOrthogonalityLimit = 70;
  double SkewnessLimit = 4;
  double FaceWeightLimit = 0.05;
  double VolumeRatioLimit = 0.01;
  double DeterminantLimit = 0.001;
  double AspectRatioLimit = 1000;

private:
  const char* WorstMeasure = "Skewness";

  vtkFiniteVolumeQuality(const vtkFiniteVolumeQuality&) = delete;
  void operator=(const vtkFiniteVolumeQuality&) = delete;
};

#endif
