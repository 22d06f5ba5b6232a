// SPDX-License-Identifier: BSD-3-Clause
// What edits of the wall improve: one number for each face and each cell, the smaller the better, of the measures that
// solvers depend on (section 3, OpenFOAM's checkMesh), and a charge for what the wall loses.
//
// Formulas take doubles, or numbers with their gradient (Gradient.h). Lengths in any unit. Terms grow without bounds, but
// their sum saturates: no measure is worth any fidelity.
#pragma once

#include "Editing/Gradient.h"
#include "Quality/CellMeasures.h"
#include "Quality/FaceMeasures.h"
#include "Quality/Limits.h"

namespace cartesian
{

// Where a term begins to cost, or costs 1.
struct Wanted
{
  static constexpr double Skewness = 1.2;
  static constexpr double Slope = 0.4; // square of the tangent of the non-orthogonality: 32 degrees
  static constexpr double FaceWeight = 0.25;
  static constexpr double VolumeRatio = 0.2;
  static constexpr double InnerCosine = 0.35;
  static constexpr double BoundarySlope = 0.5;
  static constexpr double Star = 0.15; // a face's smallest triangle, by the mean one
  static constexpr double Warp = 0.1;  // 1 - a face's area by the sum of its triangles'
  static constexpr double Turn =
    0.034; // 1 - the cosine between a wall and what it stands for: 15 degrees
  static constexpr double ShareByRatio = 7.0 / 6; // of its box's volume, by Merge Ratio
  static constexpr double LargeShare = 1.2;
  static constexpr double Determinant = 0.04;
  static constexpr double EdgeSlope = 0.5; // square of a tangent (FaceCost::addLayers): 45 degrees
  static constexpr double LayeredArea = 0.2; // of a box's side
};

// How costs of an edit are weighed.
struct ObjectiveSpec
{
  double saturation = 15;  // sums beyond this count by their logarithm; 0: all counts
  double failing = 20;     // of a face or cell beyond the limits of solvers
  double volume = 1000;    // of a box's volume that the mesh loses or gains
  double distance = 0.01;  // in boxes: of a wall that moves by so much, a half
  double sharpEdge = 200;  // of a box's edge's length of a sharp edge that goes
  double mostLost = 5;     // of charges for sharp edges, in one edit
  double mostMoved = 0.2;  // in boxes: no wall moves farther in one edit
  double mostDrift = 0.05; // in boxes: how far walls may have moved in the mean, by all edits
};

template <class Number>
struct Cost
{
  Number value;
  int fails;    // section 3, or checkMesh; 2: inverted, as seen from one of its cells
  bool strains; // solvers run, but slowly: unequal neighbours, cells with no third direction

  // Of a face, what checkMesh refuses:
  int inverted = 0; // as seen from each of its cells, and from the one to the other
  bool skew = false;
};

template <class Number>
Number squareOf(const Number& x)
{
  return x * x;
}

// max(x, 0)
template <class Number>
Number excess(const Number& x)
{
  return x > Number(0) ? x : Number(0);
}

template <class Number>
Number notBelow(const Number& x, double least)
{
  return x > Number(least) ? x : Number(least);
}

template <class Number>
Number larger(const Number& x, const Number& y)
{
  return x < y ? y : x;
}

template <class Number>
Number smaller(const Number& x, const Number& y)
{
  return x < y ? x : y;
}

// log(1 + x). Most faces cost next to nothing: for them a few terms of the series do.
template <class Number>
Number logarithmOfMore(const Number& x)
{
  constexpr double Little = 0.01;
  using std::log1p;
  return valueOf(x) < Little ? x * (Number(1) - x * (Number(0.5) - x * (1.0 / 3))) : log1p(x);
}

template <class Number>
Number saturated(const Number& sum, const ObjectiveSpec& spec)
{
  return spec.saturation > 0 ? logarithmOfMore(sum * (1 / spec.saturation)) * spec.saturation : sum;
}

// `fails`: as of Cost. To fail without being inverted is a step forward.
inline double costOfFailing(int fails, const ObjectiveSpec& spec)
{
  return fails == 2 ? 1.5 * spec.failing : fails * spec.failing;
}

// What a face that costs `cost` by one specification does by another.
inline double costBy(const ObjectiveSpec& to, const ObjectiveSpec& from, double cost, int fails)
{
  const double saturatedSum = cost - costOfFailing(fails, from);
  const double sum = from.saturation > 0
    ? std::expm1(saturatedSum / from.saturation) * from.saturation
    : saturatedSum;
  return saturated(sum, to) + costOfFailing(fails, to);
}

// What a face costs.
template <class Number>
class FaceCost
{
public:
  FaceCost(const FaceMeasures<Number>& face, const ObjectiveSpec& spec)
    : face_(face)
    , spec_(spec)
    , area_(notBelow(norm(face.area), Tiny))
    , normal_(scaled(face.area, Number(1) / area_))
    , fails_(face.star < Number(0) || face.warp > Number(EditLimits::Warp))
  {
    addShape();
  }

  // Between two cells. `corner`, `size`: as of measuresOfFace.
  template <class Corner>
  void addInner(const CellGeometryOf<Number>& below, const CellGeometryOf<Number>& above,
    std::size_t size, Corner&& corner)
  {
    const VectorOf<Number> toAbove = minus(above.centre, below.centre);
    const VectorOf<Number> toFace = minus(face_.centre, below.centre);
    const VectorOf<Number> onwards = minus(above.centre, face_.centre);
    const Number distance = notBelow(norm(toAbove), Tiny);
    const Number whole = dot(toAbove, normal_);
    const Number near = dot(toFace, normal_);
    const Number far = dot(onwards, normal_);
    const Number inversion = excess(distance * LeastHeight - whole) +
      excess(distance * LeastPart - near) + excess(distance * LeastPart - far);
    if (valueOf(inversion) > 0)
    {
      cost_ += inversion * CostOfInversion / distance;
    }
    const Number across = larger(whole, distance * LeastHeight);
    const Number nearer = larger(near, distance * LeastPart);
    const Number farther = larger(far, distance * LeastPart);
    const Number slope = excess(squareOf(distance / across) - 1.0);
    cost_ += squareOf(slope * (1 / Wanted::Slope));
    addWeight(smaller(nearer, farther), across);
    addRatio(
      smaller(below.volume, above.volume), notBelow(larger(below.volume, above.volume), Tiny));
    const Number nearSquare = dot(toFace, toFace);
    const Number farSquare = dot(onwards, onwards);
    const Number steepest = larger(nearSquare / squareOf(nearer), farSquare / squareOf(farther));
    cost_ += squareOf(squareOf(Number(Wanted::InnerCosine)) * steepest);
    const VectorOf<Number> aside = minus(toFace, scaled(toAbove, nearer / across));
    addSkewness(aside, distance * ShareOfDistance, size, corner);
    fails_ = fails_ || valueOf(slope) > EditLimits::Slope ||
      isSteep(valueOf(near), valueOf(nearSquare), EditLimits::InnerCosine) ||
      isSteep(valueOf(far), valueOf(farSquare), EditLimits::InnerCosine);
    isInverted_ = valueOf(near) < 0 || valueOf(far) < 0;
    inverted_ = int(!(valueOf(near) > 0)) + int(!(valueOf(far) > 0)) + int(!(valueOf(whole) > 0));
  }

  // Of a wall. `edge`: the length of a box's edge there; `original`: the area of what the surface has there, or zero.
  template <class Corner>
  void addWall(const CellGeometryOf<Number>& below, double edge, const Vector& original,
    std::size_t size, Corner&& corner)
  {
    const VectorOf<Number> toFace = minus(face_.centre, below.centre);
    const Number height = dot(toFace, normal_);
    const double least = LeastPart * edge;
    const Number tall = notBelow(height, least);
    cost_ += excess(Number(least) - height) * (CostOfInversion / edge);
    const VectorOf<Number> aside = minus(toFace, scaled(normal_, height));
    const Number square = dot(aside, aside);
    cost_ += squareOf(square / squareOf(tall) * (1 / Wanted::BoundarySlope));
    addSkewness(aside, tall * ShareOfHeight, size, corner);
    fails_ =
      fails_ || isSteep(valueOf(height), valueOf(dot(toFace, toFace)), EditLimits::BoundaryCosine);
    isInverted_ = valueOf(height) < 0;
    inverted_ = int(!(valueOf(height) > 0));
    if (const double length = norm(original); length > NegligibleArea * edge * edge)
    {
      const Number cosine =
        (normal_[0] * original[0] + normal_[1] * original[1] + normal_[2] * original[2]) *
        (1 / length);
      const Number turn = (Number(1) - cosine) * (1 / Wanted::Turn);
      cost_ += squareOf(turn) * smaller(Number(1), area_ * (LargeWall / (edge * edge)));
    }
  }

  // Of a wall that will have layers: the sides of thin prisms on it have the angles of its edges. These are good where the
  // way from the face's centre to an edge's middle is across the edge; small faces between large ones are not.
  template <class Corner>
  void addLayers(double edge, std::size_t size, Corner&& corner)
  {
    VectorOf<Number> p = corner(size - 1);
    for (std::size_t i = 0; i < size; ++i)
    {
      const VectorOf<Number> q = corner(i);
      const VectorOf<Number> along = minus(q, p);
      const VectorOf<Number> way = minus(scaled(plus(p, q), 0.5), face_.centre);
      const Number length = notBelow(dot(along, along), Tiny);
      const Number shift = squareOf(dot(way, along)) / length;
      const Number square = dot(way, way);
      const Number height = notBelow(square - shift, LeastOfWay * edge * edge);
      cost_ += squareOf(shift / height * (1 / Wanted::EdgeSlope));
      p = q;
    }
    const double least = Wanted::LayeredArea * edge * edge;
    cost_ += squareOf(excess(Number(least) / notBelow(area_, LeastOfWay * least) - 1.0));
  }

  Cost<Number> cost() const
  {
    const Number sum = saturated(cost_, spec_);
    const int fails = isInverted_ ? 2 : fails_ ? 1 : 0;
    return { sum + costOfFailing(fails, spec_), fails, strains_, inverted_, isSkew_ };
  }

private:
  static constexpr double LeastOfWay = 1e-3;
  static constexpr double LeastHeight = 0.15; // of the distance between centres
  static constexpr double LeastPart = 0.02;   // of that, or of a box's edge
  static constexpr double LeastRatio = 1e-3;
  static constexpr double CostOfInversion = 1e4;
  static constexpr double NegligibleArea = 1e-9; // of a box's side
  static constexpr double LargeWall = 4; // smaller ones than 1/4 of a box's side may turn more

  // Where the foot is nearer than this to the centre, by the distance, skewness costs nothing.
  static constexpr double NoSkewness = 0.4;

  void addShape()
  {
    if (valueOf(face_.star) < Wanted::Star)
    {
      cost_ += squareOf((Number(Wanted::Star) - face_.star) * (1 / Wanted::Star)) * 2.0;
      if (valueOf(face_.star) < 0)
      {
        cost_ += squareOf(smaller(Number(1), -face_.star)) * 200.0 + Number(60);
      }
    }
    cost_ += squareOf(face_.warp * (1 / Wanted::Warp));
  }

  void addWeight(const Number& nearest, const Number& across)
  {
    if (valueOf(nearest) < Wanted::FaceWeight * valueOf(across))
    {
      cost_ += squareOf(across * Wanted::FaceWeight / nearest - 1.0);
    }
    strains_ = strains_ || !(valueOf(nearest) > Limits::FaceWeight * valueOf(across));
  }

  void addRatio(const Number& smallest, const Number& largest)
  {
    if (valueOf(smallest) < Wanted::VolumeRatio * valueOf(largest))
    {
      const Number ratio = notBelow(smallest / largest, LeastRatio);
      cost_ += squareOf(Number(Wanted::VolumeRatio) / ratio - 1.0);
    }
    strains_ = strains_ || !(valueOf(smallest) > Limits::VolumeRatio * valueOf(largest));
  }

  // Whether a height has a smaller cosine than that to a line, of which the length is squared.
  static bool isSteep(double height, double square, double cosine)
  {
    return height < 0 || height * height < cosine * cosine * square;
  }

  // `least`: the reach that counts at least.
  template <class Corner>
  void addSkewness(
    const VectorOf<Number>& aside, const Number& least, std::size_t size, Corner&& corner)
  {
    const Number square = dot(aside, aside);
    if (!(valueOf(square) > squareOf(NoSkewness * valueOf(least))))
    {
      return;
    }
    const Number skewness = cartesian::skewness(size, corner, face_.centre, aside, least);
    cost_ += squareOf(squareOf(skewness * (1 / Wanted::Skewness)));
    fails_ = fails_ || !(valueOf(skewness) < Limits::Skewness);
    isSkew_ = isSkew_ || !(valueOf(skewness) < EditLimits::RefusedSkewness);
  }

  const FaceMeasures<Number>& face_;
  const ObjectiveSpec& spec_;
  Number cost_ = Number(0);
  Number area_;
  VectorOf<Number> normal_;
  bool fails_;
  bool isInverted_ = false;
  bool isSkew_ = false;
  bool strains_ = false;
  int inverted_ = 0;
};

// What a cell costs: `share`, its volume by its box's; `wanted`, of those; `determinant`, of its inner faces.
template <class Number>
Cost<Number> costOfCell(const Number& share, double wanted, const Number& determinant)
{
  constexpr double LeastShare = 0.003;
  constexpr double CostOfShare = 1e4;
  constexpr double CostOfLarge = 16;
  constexpr double LeastDeterminant = 1e-3;
  Number cost = squareOf(excess(Number(wanted) / notBelow(share, LeastShare) - 1.0));
  cost += excess(Number(LeastShare) - share) * CostOfShare;
  cost += squareOf(excess(share * (1 / Wanted::LargeShare) - 1.0)) * CostOfLarge;
  const Number flat =
    excess(Number(Wanted::Determinant) / notBelow(determinant, LeastDeterminant) - 1.0);
  using std::log1p;
  cost += log1p(flat) * 4.0;
  return { cost, 0, !(valueOf(determinant) > Limits::Determinant) };
}

}
