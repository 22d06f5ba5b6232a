// SPDX-License-Identifier: BSD-3-Clause
// Pictures of polygons, drawn in memory: no screen and no graphics library is needed, and the same polygons give the same
// picture everywhere.
#pragma once

#include "Base/Palette.h"
#include "Lattice/Vector.h"

#include <cstdint>
#include <vector>

namespace cartesian
{

// Looks from afar, without perspective, at some points, which fill it.
class Canvas
{
public:
  // `towards`: where the eye is, seen from the points, of which there are some.
  Canvas(std::size_t width, std::size_t height, const std::vector<Vector>& points,
    const Vector& towards);

  // Fills a polygon with a colour, shaded by its slope; hides what is behind it.
  void fill(const std::vector<Vector>& polygon, const Colour& colour);

  // Draws the edges of a polygon, where nothing hides them.
  void outline(const std::vector<Vector>& polygon, const Colour& colour);

  // A circle around a point, in front of everything; the radius in pixels.
  void circle(const Vector& point, double radius, const Colour& colour);

  // Makes everything drawn so far pale, and puts it behind what comes.
  void fade(double share);

  std::size_t width() const { return width_; }
  std::size_t height() const { return height_; }

  // Red, green and blue of each pixel, in rows from the top.
  std::vector<std::uint8_t> pixels() const;

private:
  // In samples from the top left, and a depth that is large near the eye.
  Vector project(const Vector& point) const;
  void fillTriangle(const std::array<Vector, 3>& corners, const Colour& colour);
  void drawLine(const Vector& from, const Vector& to, const Colour& colour);
  void set(std::size_t x, std::size_t y, const Colour& colour);

  static constexpr std::size_t Samples = 2; // of a pixel, along each axis

  std::size_t width_;
  std::size_t height_;
  std::size_t columns_; // of samples
  std::size_t rows_;
  Vector centre_;
  Vector right_;
  Vector up_;
  Vector towards_;
  double scale_;
  double lineLift_; // of edges, so that their own polygons do not hide them
  std::vector<float> depth_;
  std::vector<std::uint8_t> samples_;
};

}
