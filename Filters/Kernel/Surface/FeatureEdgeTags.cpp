// SPDX-License-Identifier: BSD-3-Clause
#include "Surface/FeatureEdgeTags.h"

#include "Base/Rings.h"
#include "Surface/Surface.h"

#include <algorithm>

namespace cartesian
{

namespace
{

constexpr std::size_t TrianglesAChunk = 1 << 12;
constexpr std::uint8_t Knows = 8;

FeatureEdgeTags::Line lineOf(const std::array<std::uint32_t, 3>& triangle, std::size_t edge)
{
  const auto [low, high] = std::minmax(triangle[edge], following(triangle, edge));
  return { low, high };
}

bool areAtOnePlace(std::array<std::uint32_t, 3> a, std::array<std::uint32_t, 3> b)
{
  std::sort(a.begin(), a.end());
  std::sort(b.begin(), b.end());
  return a == b;
}

// Of each triangle of the surface; those at one place follow each other.
std::vector<std::uint8_t> thoseThatKnow(const SurfaceView& view, const Surface& surface)
{
  const std::size_t count = surface.triangles.size();
  std::vector<std::uint8_t> knows(count);
  for (std::size_t begin = 0, end = 0; begin < count; begin = end)
  {
    std::uint8_t any = 0;
    do
    {
      any = std::max(any, view.knowsEdges[surface.given[end++]]);
    } while (end < count && areAtOnePlace(surface.triangles[begin], surface.triangles[end]));
    std::fill(knows.begin() + std::ptrdiff_t(begin), knows.begin() + std::ptrdiff_t(end), any);
  }
  return knows;
}

}

FeatureEdgeTags::FeatureEdgeTags(
  const SurfaceView& view, const Surface& surface, std::vector<Line> sharp, Execution& execution)
  : vertices_(surface.triangles.size())
  , bits_(surface.triangles.size())
{
  for (Line& line : sharp)
  {
    std::sort(line.begin(), line.end());
  }
  std::sort(sharp.begin(), sharp.end());
  const std::vector<std::uint8_t> knows = thoseThatKnow(view, surface);
  execution.forEach(
    surface.triangles.size(), TrianglesAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t t = begin; t < end; ++t)
      {
        vertices_[surface.given[t]] = surface.triangles[t];
        unsigned bits = knows[t] != 0 ? Knows : 0;
        for (std::size_t i = 0; bits != 0 && i < 3; ++i)
        {
          const bool isSharp =
            std::binary_search(sharp.begin(), sharp.end(), lineOf(surface.triangles[t], i));
          bits |= (isSharp ? 1u : 0u) << i;
        }
        bits_[surface.given[t]] = static_cast<std::uint8_t>(bits);
      }
    });
}

Known FeatureEdgeTags::between(std::uint32_t a, std::uint32_t b) const
{
  if (std::max(a, b) >= vertices_.size() || ((bits_[a] | bits_[b]) & Knows) == 0 ||
    areAtOnePlace(vertices_[a], vertices_[b]))
  {
    return Known::Nothing;
  }
  for (std::size_t i = 0; i < 3; ++i)
  {
    for (std::size_t j = 0; j < 3; ++j)
    {
      if (lineOf(vertices_[a], i) == lineOf(vertices_[b], j))
      {
        const bool isSharp = ((bits_[a] >> i | bits_[b] >> j) & 1) != 0;
        const bool doBothKnow = (bits_[a] & bits_[b] & Knows) != 0;
        return isSharp ? Known::Sharp : (doBothKnow ? Known::Smooth : Known::Nothing);
      }
    }
  }
  return Known::Nothing;
}

}
