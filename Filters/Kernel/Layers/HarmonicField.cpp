// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/HarmonicField.h"

#include "Base/ForEachItem.h"
#include "Polyhedra/OffsetPlanes.h"

#include <numeric>

namespace cartesian
{

namespace
{

// Conjugate gradients, until the residual is this part of the first one.
constexpr double Tolerance = 1e-3;
constexpr int MostSteps = 200;

// Of the chunks' sums, in order.
double product(const std::vector<Vector>& a, const std::vector<Vector>& b, Execution& execution)
{
  std::vector<double> sums(chunks(a.size(), ItemsOfALoop));
  forEachItem(
    a.size(), execution, [&](std::size_t i) { sums[i / ItemsOfALoop] += dot(a[i], b[i]); });
  return std::accumulate(sums.begin(), sums.end(), 0.0);
}

}

HarmonicField::HarmonicField(std::vector<Vector> values, std::vector<std::size_t> firstLink,
  std::vector<Link> links, std::vector<double> damping,
  std::vector<const std::vector<Vector>*> fixed)
  : values_(std::move(values))
  , firstLink_(std::move(firstLink))
  , links_(std::move(links))
  , sums_(std::move(damping))
  , fixed_(std::move(fixed))
{
  for (std::size_t i = 0; i < unknowns(); ++i)
  {
    for (std::size_t l = firstLink_[i]; l < firstLink_[i + 1]; ++l)
    {
      sums_[i] += links_[l].weight;
    }
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
void HarmonicField::multiply(const Vectors& values, Vectors& result, Execution& execution) const
{
  result.resize(unknowns());
  forEachItem(unknowns(), execution, [&](std::size_t i) {
    Vector sum = scaled(values[i], sums_[i]);
    for (std::size_t l = firstLink_[i]; l < firstLink_[i + 1]; ++l)
    {
      if (links_[l].to < values.size())
      {
        sum = minus(sum, scaled(values[links_[l].to], links_[l].weight));
      }
    }
    result[i] = withinFixed(i, sum);
  });
}

void HarmonicField::solve(Execution& execution)
{
  Vectors residual;
  multiply(values_, residual, execution);
  Vectors scaledResidual(residual.size());
  const auto precondition = [&] {
    forEachItem(residual.size(), execution, [&](std::size_t i) {
      scaledResidual[i] = scaled(residual[i], sums_[i] > 0 ? 1 / sums_[i] : 0);
    });
    return product(residual, scaledResidual, execution);
  };
  double square = precondition();
  const double enough = Tolerance * Tolerance * square;
  Vectors step = scaledResidual;
  Vectors ofStep;
  for (int s = 0; s < MostSteps && square > enough; ++s)
  {
    multiply(step, ofStep, execution);
    const double length = square / product(step, ofStep, execution);
    forEachItem(step.size(), execution, [&](std::size_t i) {
      values_[i] = minus(values_[i], scaled(step[i], length));
      residual[i] = minus(residual[i], scaled(ofStep[i], length));
    });
    const double before = square;
    square = precondition();
    forEachItem(step.size(), execution,
      [&](std::size_t i) { step[i] = plus(scaledResidual[i], scaled(step[i], square / before)); });
  }
}

}
