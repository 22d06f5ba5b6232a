// The page of a report, and its pictures.

#include "Report/Canvas.h"
#include "Report/ReportPage.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace cartesian;

namespace
{

constexpr std::size_t Side = 60;
constexpr Colour Red{ 1, 0, 0 };
constexpr Colour Blue{ 0, 0, 1 };

std::vector<Vector> square(double half, double z)
{
  return { { -half, -half, z }, { half, -half, z }, { half, half, z }, { -half, half, z } };
}

Canvas fromAbove()
{
  return { Side, Side, square(1, 0), { 0, 0, 1 } };
}

Colour colourAt(const Canvas& canvas, std::size_t x, std::size_t y)
{
  const std::vector<std::uint8_t> pixels = canvas.pixels();
  const std::size_t first = 3 * (y * canvas.width() + x);
  return { pixels[first] / 255.0, pixels[first + 1] / 255.0, pixels[first + 2] / 255.0 };
}

std::size_t countOf(const std::string& text, const std::string& part)
{
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
  {
    ++count;
  }
  return count;
}

}

TEST(Canvas, NearFacesHideFarOnesInAnyOrder)
{
  for (const bool nearFirst : { true, false })
  {
    Canvas canvas = fromAbove();
    canvas.fill(square(nearFirst ? 0.5 : 1, nearFirst ? 1 : 0), nearFirst ? Red : Blue);
    canvas.fill(square(nearFirst ? 1 : 0.5, nearFirst ? 0 : 1), nearFirst ? Blue : Red);
    EXPECT_EQ(colourAt(canvas, Side / 2, Side / 2), Red);
    EXPECT_EQ(colourAt(canvas, Side / 8, Side / 2), Blue);
    EXPECT_EQ(colourAt(canvas, 0, 0), (Colour{ 1, 1, 1 }));
  }
}

TEST(Canvas, WhatComesAfterFadingIsInFront)
{
  Canvas canvas = fromAbove();
  canvas.fill(square(1, 1), Blue);
  canvas.fade(0.5);
  canvas.fill(square(0.5, -1), Red);
  EXPECT_EQ(colourAt(canvas, Side / 2, Side / 2), Red);
  EXPECT_NEAR(colourAt(canvas, Side / 8, Side / 2)[0], 0.5, 0.01);
}

TEST(Canvas, EdgesAreSeenUnlessHidden)
{
  Canvas canvas = fromAbove();
  canvas.fill(square(1, 0), Blue);
  canvas.outline(square(0.5, -1), Red);
  Canvas same = fromAbove();
  same.fill(square(1, 0), Blue);
  EXPECT_EQ(canvas.pixels(), same.pixels());
  canvas.outline(square(0.5, 0), Red);
  EXPECT_NE(canvas.pixels(), same.pixels());
}

TEST(Canvas, DrawsWhatHasNoExtent)
{
  Canvas canvas(Side, Side, { { 1, 2, 3 } }, { 1, 1, 1 });
  canvas.fill({ { 1, 2, 3 }, { 1, 2, 3 }, { 1, 2, 3 } }, Red);
  canvas.outline({ { 1, 2, 3 }, { 1, 2, 3 } }, Red);
  canvas.circle({ 1, 2, 3 }, 1000, Red);
  canvas.fill({ { 1, 2, std::nan("") }, { 1, 9, 3 }, { 1, 2, 9 } }, Red);
  canvas.outline({ { 1, 2, std::nan("") }, { 1, 9, 3 } }, Red);
  EXPECT_EQ(canvas.pixels().size(), 3 * Side * Side);
}

TEST(ReportPage, TextsAreEscaped)
{
  EXPECT_EQ(escaped("<b>'a' & \"b\"\x01"), "&lt;b&gt;&#39;a&#39; &amp; &quot;b&quot; ");
  ReportPage page;
  page.title = page.verdict = "<t>";
  page.lines = { "<l>" };
  page.pictures = { { "<p>", "" } };
  page.tables = { { "<h>", { "<head>x" }, { { "<cell>" } } } };
  page.lists = { { "<list>", { "<item>" } } };
  page.histograms = { { "<name>", "<limit>", 1, true, histogramOf({ 0, 1 }, { 0, 1 }, 2) } };
  const std::string text = html(page);
  for (const char* tag :
    { "<t>", "<l>", "<h>", "<head>x", "<cell>", "<list>", "<item>", "<name>", "<limit>" })
  {
    EXPECT_EQ(countOf(text, tag), 0) << tag;
    EXPECT_GE(countOf(text, escaped(tag)), 1) << tag;
  }
}

TEST(ReportPage, HistogramsShowEachBinAndTheLimit)
{
  ReportHistogram histogram{ "Skewness", "limit: at most 4", 4, true,
    histogramOf({ 0, 0, 0.9, 2 }, { 0, 2 }, 4) };
  const std::string svg = drawing(histogram);
  EXPECT_EQ(countOf(svg, "<rect"), 3); // one bin is empty
  EXPECT_EQ(countOf(svg, "0 to 0.5: 2<"), 1);
  EXPECT_EQ(countOf(svg, "1.5 to 2: 1<"), 1);
  EXPECT_EQ(
    countOf(svg, "<line") - countOf(svg, "class=\"grid\"") - countOf(svg, "class=\"axis\""), 1);
  EXPECT_EQ(countOf(svg, ">limit: at most 4<"), 1);
  EXPECT_EQ(countOf(svg, "nan") + countOf(svg, "inf"), 0);
  histogram.hasLimit = false;
  EXPECT_EQ(countOf(drawing(histogram), "limit"), 0);
}
