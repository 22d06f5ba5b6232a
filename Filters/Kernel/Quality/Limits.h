// SPDX-License-Identifier: BSD-3-Clause
// The single table of quality limits for faces and cells; what is preferred is in WallObjective.h. The angles are from the
// paper's section 3, the rest from OpenFOAM's checkMesh (1912).
#pragma once

#include <cstddef>

namespace cartesian
{

// Limits of checkMesh and section 3: failing at or beyond these. Degrees; ratios.
struct Limits
{
  static constexpr double BoundaryAngle = 90;
  static constexpr double InnerAngle = 75;
  static constexpr double StarTriangulation = -1e-6;
  static constexpr double NonOrthogonality = 70;
  static constexpr double Skewness = 4;
  static constexpr double FaceWeight = 0.05;
  static constexpr double VolumeRatio = 0.01;
  static constexpr double Determinant = 1e-3;
  static constexpr double AspectRatio = 1000;
  static constexpr double Openness = 1e-6;
  static constexpr double TetQuality = 1e-30;
};

// OpenFOAM's own, whatever the unit of length: what it counts as failures, beside the limits above.
struct SolverLimits
{
  static constexpr std::size_t Faces = 4; // of a cell, at least
  static constexpr double PyramidVolume = -1e-15;
  static constexpr double Area = 1e-300;
  static constexpr double NonOrthogonalityCosine = 1e-15;
};

// While the wall is edited, what is closer to the limits than this has failed: solvers do not agree on the centre of a face,
// nor on areas.
struct EditLimits
{
  static constexpr double BoundaryCosine = 0.05; // 87 degrees
  static constexpr double InnerCosine = 0.265;   // 74.6
  static constexpr double Slope = 7.5;           // square of the tangent of 70 degrees
  static constexpr double Warp = 0.6;
  static constexpr double RefusedSkewness = 3.9;
  static constexpr double AspectRatio = 0.9 * Limits::AspectRatio;
};

// Of the sides between two stacks of layers, and of cells in these.
struct LayerLimits
{
  static constexpr double InnerAngle =
    89.999; // of a face whose pyramid has no volume, in flat prisms too
  static constexpr double FaceWeight = 0.02;
  static constexpr double CorrectionGain = 0.7;  // from trials on motorBike alone
  static constexpr double ThirdDirection = 3e-3; // a prism's base may be 300 times as long as wide
  static constexpr double Skewness =
    3; // of a part of the wall: where layers end, it stays a boundary face
  static constexpr double Slope = 2.6; // tangent of its non-orthogonality: 69 degrees
};

}
