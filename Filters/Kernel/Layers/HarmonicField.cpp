// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/HarmonicField.h"

#include "Polyhedra/OffsetPlanes.h"

namespace cartesian
{

namespace
{

// Conjugate gradients, until the residual is this part of the first one.
constexpr double Tolerance = 1e-3;
constexpr int MostSteps = 200;

double product(const std::vector<Vector>& a, const std::vector<Vector>& b)
{
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    sum += dot(a[i], b[i]);
  }
  return sum;
}

}

HarmonicField::HarmonicField(std::vector<Vector> values, std::vector<Link> links,
  std::vector<double> damping, std::vector<const std::vector<Vector>*> fixed)
  : values_(std::move(values))
  , links_(std::move(links))
  , firstLink_(damping.size() + 1)
  , sums_(std::move(damping))
  , fixed_(std::move(fixed))
{
  for (const Link& link : links_)
  {
    ++firstLink_[link.from + 1];
    sums_[link.from] += link.weight;
  }
  for (std::size_t i = 0; i < unknowns(); ++i)
  {
    firstLink_[i + 1] += firstLink_[i];
  }
}

bool HarmonicField::hold(std::size_t unknown)
{
  static const std::vector<Vector> allAxes{ { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
  const bool isNew = fixed_[unknown] != &allAxes;
  fixed_[unknown] = &allAxes;
  values_[unknown] = {};
  return isNew;
}

Vector HarmonicField::withinFixed(std::size_t i, const Vector& v) const
{
  return fixed_[i] ? within(*fixed_[i], v) : v;
}

// Of each unknown the sum of the weighted differences to its neighbours, without what is fixed.
HarmonicField::Vectors HarmonicField::times(const Vectors& values) const
{
  Vectors result(unknowns());
  for (std::size_t i = 0; i < unknowns(); ++i)
  {
    Vector sum = scaled(values[i], sums_[i]);
    for (std::size_t l = firstLink_[i]; l < firstLink_[i + 1]; ++l)
    {
      if (links_[l].to < values.size())
      {
        sum = minus(sum, scaled(values[links_[l].to], links_[l].weight));
      }
    }
    result[i] = withinFixed(i, sum);
  }
  return result;
}

void HarmonicField::solve()
{
  Vectors residual = times(values_);
  Vectors scaledResidual(residual.size());
  const auto precondition = [&] {
    for (std::size_t i = 0; i < residual.size(); ++i)
    {
      scaledResidual[i] = scaled(residual[i], sums_[i] > 0 ? 1 / sums_[i] : 0);
    }
    return product(residual, scaledResidual);
  };
  double square = precondition();
  const double enough = Tolerance * Tolerance * square;
  Vectors step = scaledResidual;
  for (int s = 0; s < MostSteps && square > enough; ++s)
  {
    const Vectors ofStep = times(step);
    const double length = square / product(step, ofStep);
    for (std::size_t i = 0; i < step.size(); ++i)
    {
      values_[i] = minus(values_[i], scaled(step[i], length));
      residual[i] = minus(residual[i], scaled(ofStep[i], length));
    }
    const double before = square;
    square = precondition();
    for (std::size_t i = 0; i < step.size(); ++i)
    {
      step[i] = plus(scaledResidual[i], scaled(step[i], square / before));
    }
  }
}

}
