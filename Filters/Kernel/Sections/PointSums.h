// SPDX-License-Identifier: BSD-3-Clause
// New points as sums of given ones, for which linear fields are exact.
#pragma once

#include "Base/Sorting.h"
#include "Sections/FaceFans.h"

namespace cartesian
{

struct PointSums
{
  std::vector<std::size_t> first; // term of each new point, and the end
  std::vector<std::uint32_t> point;
  std::vector<double> weight;
};

struct Term
{
  std::uint32_t point;
  double weight;

  bool operator<(const Term& other) const { return point < other.point; }
};

// Terms of one point are added.
inline void merge(std::vector<Term>& terms)
{
  std::stable_sort(terms.begin(), terms.end());
  auto last = terms.begin();
  for (auto term = terms.begin(); term != terms.end(); ++term)
  {
    if (term == terms.begin())
    {
      continue;
    }
    if (term->point == last->point)
    {
      last->weight += term->weight;
    }
    else
    {
      *++last = *term;
    }
  }
  terms.erase(terms.empty() ? terms.end() : last + 1, terms.end());
}

// That of measureFace: a third of the corners' mean, and of each star triangle its two corners by its area.
inline void addFace(
  const FaceCorners& faces, std::size_t face, double factor, std::vector<Term>& terms)
{
  const std::size_t size = faces.size(face);
  if (size == 3)
  {
    for (std::size_t i = 0; i < size; ++i)
    {
      terms.push_back({ faces.id(face, i), factor / 3 });
    }
    return;
  }
  std::vector<double> areas;
  double sum = 0;
  forEachStarTriangle(
    size, [&](std::size_t i) { return faces.corner(face, i); },
    [&](const Vector&, const Vector&, const Vector& triangle) {
      areas.push_back(norm(triangle));
      sum += areas.back();
    });
  const auto count = static_cast<double>(size);
  for (std::size_t i = 0; i < size; ++i)
  {
    const double weight =
      sum < Tiny ? 1 / count : 1 / (3 * count) + (areas[i] + areas[(i + 1) % size]) / (3 * sum);
    terms.push_back({ faces.id(face, i), factor * weight });
  }
}

// Of `count` points. `makeFinder()` gives, for each thread's part, a find(place, terms) that sets the terms of one.
template <class MakeFinder>
PointSums pointSums(std::size_t count, Execution& execution, MakeFinder&& makeFinder)
{
  constexpr std::size_t PlacesAChunk = 1024;
  std::vector<std::vector<Term>> terms(chunks(count, PlacesAChunk));
  PointSums sums;
  sums.first.assign(count + 1, 0);
  execution.forEach(count, PlacesAChunk, [&](std::size_t begin, std::size_t end) {
    auto find = makeFinder();
    std::vector<Term> found;
    for (std::size_t place = begin; place < end; ++place)
    {
      find(place, found);
      sums.first[place] = found.size();
      std::vector<Term>& all = terms[begin / PlacesAChunk];
      all.insert(all.end(), found.begin(), found.end());
    }
  });
  const std::size_t total = scan(sums.first);
  sums.point.reserve(total);
  sums.weight.reserve(total);
  for (const std::vector<Term>& part : terms)
  {
    for (const Term& term : part)
    {
      sums.point.push_back(term.point);
      sums.weight.push_back(term.weight);
    }
  }
  return sums;
}

}
