#include "SmallCells.h"

#include <algorithm>
#include <set>

namespace cartesian
{

namespace
{

constexpr std::size_t CellsAChunk = 256;

constexpr int MostRounds = 100;

struct Merging
{
  CellKey key;
  double volume; // of its box's
  bool fails;    // an angle condition
  CellKey into = None;
};

double failing(const CellComplex& cells, CellKey key)
{
  Polyhedron polyhedron;
  CellShape shape;
  cells.shape(key, polyhedron);
  measure(polyhedron, shape);
  return failingArea(polyhedron, shape);
}

// The best neighbour, or None.
CellKey choose(const CellComplex& cells, CellKey key, bool small)
{
  const double alone = failing(cells, key);
  Polyhedron polyhedron;
  CellShape shape;
  for (const auto& [other, area] : cells.neighbours(key))
  {
    cells.shapeOfBoth(other, key, polyhedron);
    measure(polyhedron, shape);
    const double together = failingArea(polyhedron, shape);
    const double apart = alone + failing(cells, other);
    if (together == 0 || (small ? together <= apart : together < apart))
    {
      return other;
    }
  }
  return None;
}

}

std::size_t mergeSmallCells(CellComplex& cells, double ratio, Execution& execution)
{
  std::size_t merged = 0;
  std::vector<CellKey> keys = cells.polyhedra();
  for (int round = 0; !keys.empty() && round < MostRounds; ++round)
  {
    std::vector<Merging> all(keys.size());
    execution.forEach(keys.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      Polyhedron polyhedron;
      CellShape shape;
      for (std::size_t i = begin; i < end; ++i)
      {
        cells.shape(keys[i], polyhedron);
        measure(polyhedron, shape);
        all[i] = { keys[i], shape.volume / cells.volumeOfBox(keys[i]), failingArea(polyhedron, shape) > 0 };
      }
    });
    all.erase(
      std::remove_if(all.begin(), all.end(), [&](const Merging& m) { return m.volume >= ratio && !m.fails; }),
      all.end());
    for (const Merging& merging : all)
    {
      for (const auto& [other, area] : cells.neighbours(merging.key))
      {
        cells.open(other);
      }
    }
    execution.forEach(all.size(), CellsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        all[i].into = choose(cells, all[i].key, all[i].volume < ratio);
      }
    });
    std::sort(all.begin(), all.end(), [](const Merging& x, const Merging& y) {
      return x.volume != y.volume ? x.volume < y.volume : x.key < y.key;
    });
    std::set<CellKey> taken;
    std::set<CellKey> next;
    for (const Merging& merging : all)
    {
      if (merging.into == None)
      {
        continue;
      }
      if (taken.count(merging.key) || taken.count(merging.into))
      {
        next.insert(merging.key);
        continue;
      }
      taken.insert({ merging.key, merging.into });
      cells.merge(merging.key, merging.into);
      next.insert(merging.into);
      ++merged;
    }
    keys.clear();
    std::copy_if(next.begin(), next.end(), std::back_inserter(keys),
      [&](CellKey key) { return cells.isAlive(key); });
  }
  return merged;
}

}
