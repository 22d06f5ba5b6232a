// SPDX-License-Identifier: BSD-3-Clause
// The single table of quality limits for faces and cells, and of the margins that shaping keeps. Cosines and tangents
// are of the angles in the comments. The angles are from the paper's section 3, the rest from OpenFOAM's checkMesh
// (1912).
#pragma once

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

// Limits for shaping, stricter by a sixth of a degree than section 3: solvers do not agree on the centre of a warped
// face.
struct Refused
{
  static constexpr double BoundaryCosine = 0.00290887798436196; // 89 5/6
  static constexpr double InnerCosine = 0.261627710462944;      // 74 5/6
  static constexpr double SlopeCosine = 0.342020143325669;      // 70
  static constexpr double AspectRatio = 300;
};

// Faces beyond these angles may exceed those with another definition of a face's centre.
struct Doubtful
{
  static constexpr double BoundaryCosine = 0.173648177666930; // 80
  static constexpr double InnerCosine = 0.422618261740699;    // 65
};

// Closer to the limits of section 3 than this an angle has failed where costs are compared.
struct Failing
{
  static constexpr double BoundaryCosine = 0.1; // 84.3
  static constexpr double InnerCosine = 0.27;   // 74.3
};

// Of the sides between two stacks of layers, and of cells in these.
struct LayerLimits
{
  static constexpr double InnerAngle =
    89.999; // of a face whose pyramid has no volume, in flat prisms too
  static constexpr double FaceWeight = 0.02;
  static constexpr double CorrectionGain = 0.7;  // from trials on motorBike alone
  static constexpr double ThirdDirection = 3e-3; // a prism's base may be 300 times as long as wide
};

// About those of snappyHexMesh's cells.
struct Balanced
{
  static constexpr double FaceWeight = 0.08;
  static constexpr double VolumeRatio = 0.02;
};

// Where a measure costs 1: the preferred quality limits.
struct Fair
{
  static constexpr double Skewness = 1.6;
  static constexpr double Slope = 0.7; // square of the tangent of the non-orthogonality: 40
  static constexpr double FaceWeight = 0.12;
  static constexpr double VolumeRatio = 0.06;
  static constexpr double InnerCosine = 0.35; // of the angle of section 3: 69.5
  static constexpr double BoundarySlope = 2;  // square of its tangent: 55
  static constexpr double Share = 0.15;       // of its box's volume
  static constexpr double LargeShare = 0.6;   // not small at all
  static constexpr double Determinant = 0.02;
};

}
