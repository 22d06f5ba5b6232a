// A model of how ties are broken (simulation of simplicity): numbers c0 + c1 e + c2 e^2 + c3 e^3,
// with a positive e that is smaller than any number. Planes perpendicular to axis a are shifted by
// e^(a + 1).
#pragma once

#include "Lattice/Lattice.h"

namespace cartesian
{

template <class Number>
struct Perturbed
{
  std::array<Number, 4> c{};

  Perturbed() = default;
  Perturbed(const Number& constant) // NOLINT: converts on purpose
  {
    c[0] = constant;
  }

  static Perturbed plane(int axis, Level level)
  {
    Perturbed g{ Number(level) };
    g.c[axis + 1] = 1;
    return g;
  }

  Perturbed operator+(const Perturbed& o) const
  {
    Perturbed g = *this;
    for (std::size_t i = 0; i < 4; ++i)
    {
      g.c[i] += o.c[i];
    }
    return g;
  }

  Perturbed operator*(const Number& by) const
  {
    Perturbed g = *this;
    for (Number& x : g.c)
    {
      x *= by;
    }
    return g;
  }

  Perturbed operator-(const Perturbed& o) const { return *this + o * Number(-1); }

  int sign() const
  {
    for (const Number& x : c)
    {
      if (x != 0)
      {
        return x > 0 ? 1 : -1;
      }
    }
    return 0;
  }

  bool operator<(const Perturbed& o) const { return (*this - o).sign() < 0; }
};

}
