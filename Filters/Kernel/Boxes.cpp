#include "Boxes.h"

#include "InOut.h"

#include <bitset>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr std::size_t RowsAChunk = 16;

// Peak memory, measured on a sphere and on the surfaces in Data/ (see Testing/Benchmark).
constexpr double BytesOfAnInsideBox = 260;
constexpr double BytesOfAnIntersectedBox = 2600;
constexpr double BytesOfATriangle = 150;

// Walks the boxes of the grid row by row.
class Generator
{
public:
  Generator(const Meshlines& planes, const Shoeboxes& shoeboxes, const InOut& inOut, bool closed)
    : planes_(planes)
    , shoeboxes_(shoeboxes)
    , inOut_(inOut)
    , closed_(closed)
  {
  }

  // Calls visit(i, status) for the boxes of a row that are kept.
  template <class Visitor>
  void forEachBox(std::uint32_t j, std::uint32_t k, Visitor&& visit) const
  {
    const std::size_t row = j + k * (planes_[1].size() - 1);
    std::uint32_t next = 0;
    for (std::size_t b = shoeboxes_.rowStart[row]; b < shoeboxes_.rowStart[row + 1]; ++b)
    {
      const std::uint32_t i = shoeboxes_.column[b];
      visitGap(next, i, j, k, visit);
      visit(i, BoxStatus::Intersected);
      next = i + 1;
    }
    visitGap(next, static_cast<std::uint32_t>(planes_[0].size() - 1), j, k, visit);
  }

  Box box(std::uint32_t i, std::uint32_t j, std::uint32_t k, BoxStatus status) const
  {
    Box b;
    b.low = { planes_[0][i], planes_[1][j], planes_[2][k] };
    b.high = { planes_[0][i + 1], planes_[1][j + 1], planes_[2][k + 1] };
    b.global = { i, j, k };
    b.corners = status == BoxStatus::Inside ? AllCorners : inOut_.corners(i, j, k);
    b.status = status;
    return b;
  }

private:
  // Boxes [begin, end) of a row, which no triangle passes through: on a closed surface all of
  // them have the status of any of their corners.
  template <class Visitor>
  void visitGap(
    std::uint32_t begin, std::uint32_t end, std::uint32_t j, std::uint32_t k, Visitor& visit) const
  {
    if (begin >= end || (closed_ && !inOut_.inside(begin, j, k)))
    {
      return;
    }
    for (std::uint32_t i = begin; i < end; ++i)
    {
      if (closed_ || std::bitset<8>(inOut_.corners(i, j, k)).count() > 4)
      {
        visit(i, BoxStatus::Inside);
      }
    }
  }

  const Meshlines& planes_;
  const Shoeboxes& shoeboxes_;
  const InOut& inOut_;
  bool closed_;
};

double spacing(const std::vector<Level>& planes, double level)
{
  const auto last = static_cast<std::int64_t>(planes.size()) - 2;
  const std::int64_t i =
    std::clamp<std::int64_t>(intervalOf(planes, static_cast<Level>(level)), 0, last);
  return double(planes[i + 1]) - planes[i];
}

// Boxes that a triangle passes through, taking the spacing around its middle.
double boxesOfTriangle(const Corners& c, const Meshlines& planes)
{
  std::array<double, 3> h;
  std::array<double, 3> u;
  std::array<double, 3> v;
  for (int axis = 0; axis < 3; ++axis)
  {
    h[axis] = spacing(planes[axis], (double(c[0][axis]) + c[1][axis] + c[2][axis]) / 3);
    u[axis] = (double(c[1][axis]) - c[0][axis]) / h[axis];
    v[axis] = (double(c[2][axis]) - c[0][axis]) / h[axis];
  }
  double sum = 0;
  for (int a = 0; a < 3; ++a)
  {
    const int b = (a + 1) % 3;
    sum += std::abs(u[a] * v[b] - u[b] * v[a]) / 2;
  }
  return sum;
}

}

Boxes generateBoxes(const Surface& surface, const SurfaceCheck& check, const Meshlines& planes,
  const SurfaceRows& rows, Execution& execution)
{
  const InOut inOut(surface, check, planes, rows.crossings, execution);
  const Generator generator(planes, rows.shoeboxes, inOut, check.closed());

  Boxes result;
  result.lattice = surface.lattice;
  result.planes = planes;
  result.closed = check.closed();
  const std::size_t rowsAlongY = planes[1].size() - 1;
  const std::size_t rowCount = rowsAlongY * (planes[2].size() - 1);
  result.rowStart.assign(rowCount + 1, 0);
  const auto forEachRow = [&](auto&& visit) {
    execution.forEach(rowCount, RowsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t row = begin; row < end; ++row)
      {
        visit(row, std::uint32_t(row % rowsAlongY), std::uint32_t(row / rowsAlongY));
      }
    });
  };
  forEachRow([&](std::size_t row, std::uint32_t j, std::uint32_t k) {
    generator.forEachBox(
      j, k, [&](std::uint32_t, BoxStatus) { ++result.rowStart[row]; });
  });
  result.boxes.resize(scan(result.rowStart));
  forEachRow([&](std::size_t row, std::uint32_t j, std::uint32_t k) {
    std::size_t next = result.rowStart[row];
    generator.forEachBox(j, k, [&](std::uint32_t i, BoxStatus status) {
      result.boxes[next++] = generator.box(i, j, k, status);
    });
  });
  return result;
}

Estimate estimateMesh(const Surface& surface, const Meshlines& planes)
{
  double intersected = 0;
  Bounds bounds = Bounds::none();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const Corners c = surface.corners(t);
    intersected += boxesOfTriangle(c, planes);
    for (int axis = 0; axis < 3; ++axis)
    {
      bounds.include(axis, c[0][axis]);
      bounds.include(axis, c[1][axis]);
      bounds.include(axis, c[2][axis]);
    }
  }
  double all = 1;
  double extent = 1;
  for (int axis = 0; axis < 3; ++axis)
  {
    all *= static_cast<double>(planes[axis].size() - 1);
    extent *= std::max(2.0, bounds.high[axis] - bounds.low[axis]) * surface.lattice.step();
  }
  const double inside = all * std::min(1.0, std::abs(volumeOf(surface)) / extent);
  return { inside + intersected,
    inside * BytesOfAnInsideBox + intersected * BytesOfAnIntersectedBox +
      static_cast<double>(surface.triangles.size()) * BytesOfATriangle };
}

}
