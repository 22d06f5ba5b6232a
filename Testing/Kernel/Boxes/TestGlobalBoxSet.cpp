// Sets of global boxes against one bit for each box.
#include "Boxes/GlobalBoxSet.h"

#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <random>

using namespace cartesian;

namespace
{

using Index = std::array<std::int64_t, 3>;

template <class Visitor>
void forEachBox(const Index& size, Visitor&& visit)
{
  for (std::int64_t k = 0; k < size[2]; ++k)
  {
    for (std::int64_t j = 0; j < size[1]; ++j)
    {
      for (std::int64_t i = 0; i < size[0]; ++i)
      {
        visit(Index{ i, j, k });
      }
    }
  }
}

bool isNear(const std::vector<Index>& boxes, const Index& box, std::int64_t layers)
{
  for (const Index& other : boxes)
  {
    if (std::abs(other[0] - box[0]) <= layers && std::abs(other[1] - box[1]) <= layers &&
      std::abs(other[2] - box[2]) <= layers)
    {
      return true;
    }
  }
  return false;
}

}

TEST(GlobalBoxSet, ContainsAndGrowsAsItShould)
{
  std::mt19937 random(1);
  for (const Index& size : { Index{ 9, 7, 5 }, Index{ 1, 6, 8 }, Index{ 12, 1, 1 } })
  {
    for (const unsigned sparsity : { 2u, 10u, 100u })
    {
      GlobalBoxSet set(size[0], size[1], size[2]);
      std::vector<Index> boxes;
      forEachBox(size, [&](const Index& box) {
        if (random() % sparsity == 0)
        {
          set.insert(box[0], box[1], box[2]);
          boxes.push_back(box);
        }
      });
      for (std::int64_t layers = 0; layers < 4; ++layers)
      {
        const GlobalBoxSet grown = set.grown(layers);
        forEachBox(size, [&](const Index& box) {
          ASSERT_EQ(grown.contains(box[0], box[1], box[2]), isNear(boxes, box, layers));
        });
      }
    }
  }
}
