// A model of the rule that ties do not exist: numbers c0 + c1 e + c2 e^2 + c3 e^3 with e positive
// and smaller than any number. Planes perpendicular to axis a are shifted by e^(a + 1).
#pragma once

#include "Lattice/Lattice.h"

namespace cartesian
{

template <class Number>
struct Germ
{
  std::array<Number, 4> c{};

  Germ() = default;
  Germ(const Number& constant) // NOLINT: converts on purpose
  {
    c[0] = constant;
  }

  static Germ plane(int axis, Level level)
  {
    Germ g{ Number(level) };
    g.c[axis + 1] = 1;
    return g;
  }

  Germ operator+(const Germ& o) const
  {
    Germ g = *this;
    for (std::size_t i = 0; i < 4; ++i)
    {
      g.c[i] += o.c[i];
    }
    return g;
  }

  Germ operator*(const Number& by) const
  {
    Germ g = *this;
    for (Number& x : g.c)
    {
      x *= by;
    }
    return g;
  }

  Germ operator-(const Germ& o) const { return *this + o * Number(-1); }

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

  bool operator<(const Germ& o) const { return (*this - o).sign() < 0; }
};

}
