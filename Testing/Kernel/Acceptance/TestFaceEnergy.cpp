// SPDX-License-Identifier: BSD-3-Clause
// Energies of faces: their derivatives are those that differences give.
#include "Acceptance/FaceEnergy.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

using namespace cartesian;

namespace
{

constexpr double Step = 1e-6;
constexpr double Close = 2e-5; // relative: of central differences

struct Case
{
  FaceGeometry face{ { 0.1, -0.05, 0.02 }, { 0.2, 0.1, 1.1 } };
  CellGeometry below{ { -0.1, 0.1, -0.5 }, 0.8 };
  CellGeometry above{ { 0.2, -0.1, 0.3 }, 0.3 };
  // So far off that skewness, whose derivative takes the reach as given, does not count.
  std::vector<Vector> corners{ { -1e3, -1e3, 0 }, { 1e3, -1e3, 1e3 }, { 0, 1e3, -1e3 } };
  std::vector<std::uint32_t> ring{ 0, 1, 2 };

  Ring corner() const { return { corners.data(), ring.data(), ring.size() }; }
};

struct Result
{
  double energy;
  FaceGradient face;
  CellGradient below;
  CellGradient above;
};

Result inner(const Case& c)
{
  Result r{};
  const Gradients gradients{ &r.face, &r.below, &r.above };
  r.energy = energyOfInnerFace(c.face, c.corner(), 1, c.below, c.above, &gradients).all;
  EXPECT_EQ(r.energy, energyOfInnerFace(c.face, c.corner(), 1, c.below, c.above, nullptr).all);
  return r;
}

Result boundary(const Case& c)
{
  Result r{};
  const Gradients gradients{ &r.face, &r.below, nullptr };
  r.energy = energyOfBoundaryFace(c.face, c.corner(), 1, c.below, &gradients).all;
  EXPECT_EQ(r.energy, energyOfBoundaryFace(c.face, c.corner(), 1, c.below, nullptr).all);
  return r;
}

void expectDerivative(const Case& at, const std::function<Result(const Case&)>& energyOf,
  const std::function<double&(Case&)>& variable, double derivative)
{
  Case more = at;
  Case less = at;
  variable(more) += Step;
  variable(less) -= Step;
  const double difference = (energyOf(more).energy - energyOf(less).energy) / (2 * Step);
  EXPECT_NEAR(derivative, difference, Close * (1 + std::abs(difference)));
}

// The lengths of areas only weigh: their directions count.
Vector across(const Vector& gradient, const Vector& area)
{
  const Vector normal = unit(area);
  return minus(gradient, scaled(normal, dot(gradient, normal)));
}

Case randomCase(unsigned seed)
{
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> near(-0.1, 0.1);
  Case c;
  for (Vector* v : { &c.face.centre, &c.below.centre, &c.above.centre })
  {
    for (double& x : *v)
    {
      x += near(random);
    }
  }
  c.below.volume += near(random);
  c.above.volume += near(random);
  return c;
}

}

TEST(FaceEnergy, OfInnerFacesFallsAsItsDerivativesSay)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    const Case c = randomCase(seed);
    const Result r = inner(c);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      expectDerivative(
        c, inner, [&](Case& x) -> double& { return x.below.centre[axis]; }, r.below.centre[axis]);
      expectDerivative(
        c, inner, [&](Case& x) -> double& { return x.above.centre[axis]; }, r.above.centre[axis]);
    }
    expectDerivative(
      c, inner, [](Case& x) -> double& { return x.below.volume; }, r.below.volume);
    expectDerivative(
      c, inner, [](Case& x) -> double& { return x.above.volume; }, r.above.volume);
  }
}

TEST(FaceEnergy, OfBoundaryFacesFallsAsItsDerivativesSay)
{
  for (unsigned seed = 1; seed <= 20; ++seed)
  {
    SCOPED_TRACE(seed);
    const Case c = randomCase(seed);
    const Result r = boundary(c);
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      expectDerivative(
        c, boundary, [&](Case& x) -> double& { return x.below.centre[axis]; },
        r.below.centre[axis]);
    }
    EXPECT_EQ(r.above.volume, 0);
  }
}

TEST(FaceEnergy, DependsOnTheDirectionOfTheArea)
{
  const Case c = randomCase(3);
  const Result r = inner(c);
  const Vector turn = across({ 0.3, -0.2, 0.1 }, c.face.area);
  Case more = c;
  Case less = c;
  more.face.area = plus(c.face.area, scaled(turn, Step));
  less.face.area = minus(c.face.area, scaled(turn, Step));
  const double difference = (inner(more).energy - inner(less).energy) / (2 * Step);
  EXPECT_NEAR(dot(r.face.area, turn), difference, Close * (1 + std::abs(difference)));
}

TEST(FaceEnergy, OfACellInsideOutGrowsWithTheDistance)
{
  Case c;
  c.face.centre = { 0, 0, -0.6 };
  const double first = boundary(c).energy;
  c.face.centre = { 0, 0, -0.7 };
  EXPECT_GT(boundary(c).energy, first);
}

TEST(FaceEnergy, OfSmallSharesGrowsDownToNothingAndBeyond)
{
  double before = 0;
  EXPECT_EQ(energyOfShare(1), 0);
  for (const double share : { 0.5, 0.1, 0.01, 0.0, -0.1, -1.0 })
  {
    const double energy = energyOfShare(share);
    EXPECT_GT(energy, before);
    EXPECT_LT(derivativeOfShare(share), 0);
    before = energy;
  }
}
