// Names as words, colours of categories, and vectors whose new elements nobody sets.
#include "Base/Palette.h"
#include "Base/RawVector.h"
#include "Base/Words.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace cartesian;

TEST(Words, BeginAtCapitalsButAbbreviationsAreOne)
{
  EXPECT_EQ(wordsOf("NonOrthogonality"), "Non Orthogonality");
  EXPECT_EQ(wordsOf("NamedSTLReader"), "Named STL Reader");
  EXPECT_EQ(wordsOf("ReadSTL"), "Read STL");
  EXPECT_EQ(wordsOf("CellsAcrossGaps"), "Cells Across Gaps");
  EXPECT_EQ(wordsOf("volume"), "volume");
  EXPECT_EQ(wordsOf(""), "");
}

TEST(Palette, HuesAreTheColoursOfTheWheel)
{
  const std::array<Colour, 6> wheel{ { { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { 0, 1, 1 },
    { 0, 0, 1 }, { 1, 0, 1 } } };
  for (std::size_t i = 0; i < wheel.size(); ++i)
  {
    const double hue = static_cast<double>(i) / 6;
    const Colour pure = colourOfHue(hue, 1, 1);
    const Colour pale = colourOfHue(hue, 0.5, 0.5);
    for (std::size_t c = 0; c < 3; ++c)
    {
      EXPECT_NEAR(pure[c], wheel[i][c], 1e-12) << i;
      EXPECT_NEAR(pale[c], 0.25 + 0.25 * wheel[i][c], 1e-12)
        << i; // half of the way to white, half as bright
    }
  }
  EXPECT_EQ(colourOfHue(0.3, 0, 1), (Colour{ 1, 1, 1 }));
}

// 24: eight hues in three shades.
TEST(Palette, TellsTwoDozenBoundariesApart)
{
  constexpr double Least = 0.05; // of a colour's component
  for (std::size_t i = 0; i < 24; ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const Colour a = colourOfBoundary(i);
      const Colour b = colourOfBoundary(j);
      EXPECT_GT(
        std::max({ std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2]) }), Least)
        << i << ", " << j;
    }
  }
}

TEST(RawVector, KeepsWhatItHad)
{
  RawVector<int> some{ 1, 2, 3 };
  some.resize(1000);
  some.push_back(4);
  EXPECT_EQ(some.size(), 1001U);
  EXPECT_EQ(some[0] + 10 * some[1] + 100 * some[2] + 1000 * some.back(), 4321);
}
