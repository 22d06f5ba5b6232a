// SPDX-License-Identifier: BSD-3-Clause
#include "Report/Canvas.h"

#include "Base/Rings.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cartesian
{

namespace
{

constexpr float Farthest = -std::numeric_limits<float>::infinity();
constexpr double Margin = 0.94;   // of the picture that the points may fill
constexpr double LineLift = 1e-3; // of the extent
constexpr double Ambient = 0.5;   // light from everywhere

std::uint8_t byteOf(double share)
{
  return static_cast<std::uint8_t>(std::lround(255 * std::clamp(share, 0.0, 1.0)));
}

}

Canvas::Canvas(
  std::size_t width, std::size_t height, const std::vector<Vector>& points, const Vector& towards)
  : width_(width)
  , height_(height)
  , columns_(Samples * width)
  , rows_(Samples * height)
  , towards_(unit(towards))
  , depth_(columns_ * rows_, Farthest)
  , samples_(3 * columns_ * rows_, 255)
{
  const Vector vertical = std::abs(towards_[2]) < 0.9 ? Vector{ 0, 0, 1 } : Vector{ 0, 1, 0 };
  right_ = unit(cross(vertical, towards_));
  up_ = cross(towards_, right_);
  const std::array<Vector, 3> axes{ right_, up_, towards_ };
  Vector extent;
  centre_ = points.front();
  for (std::size_t a = 0; a < axes.size(); ++a)
  {
    double low = 0;
    double high = 0;
    for (const Vector& point : points)
    {
      const double at = dot(minus(point, points.front()), axes[a]);
      low = std::min(low, at);
      high = std::max(high, at);
    }
    extent[a] = high > low ? high - low : 1;
    centre_ = plus(centre_, scaled(axes[a], (low + high) / 2));
  }
  scale_ = Margin *
    std::min(static_cast<double>(columns_) / extent[0], static_cast<double>(rows_) / extent[1]);
  lineLift_ = LineLift * norm(extent);
}

Vector Canvas::project(const Vector& point) const
{
  const Vector at = minus(point, centre_);
  return { static_cast<double>(columns_) / 2 + scale_ * dot(at, right_),
    static_cast<double>(rows_) / 2 - scale_ * dot(at, up_), dot(at, towards_) };
}

void Canvas::set(std::size_t x, std::size_t y, const Colour& colour)
{
  std::uint8_t* sample = &samples_[3 * (y * columns_ + x)];
  std::transform(colour.begin(), colour.end(), sample, byteOf);
}

void Canvas::fill(const std::vector<Vector>& polygon, const Colour& colour)
{
  Vector mean{ 0, 0, 0 };
  Vector area{ 0, 0, 0 };
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    const Vector& next = following(polygon, i);
    mean = plus(mean, scaled(polygon[i], 1.0 / static_cast<double>(polygon.size())));
    area = plus(area, cross(minus(polygon[i], polygon[0]), minus(next, polygon[0])));
  }
  const double size = norm(area);
  const double light = size > 0 ? std::abs(dot(area, towards_)) / size : 0;
  Colour shaded;
  std::transform(colour.begin(), colour.end(), shaded.begin(),
    [&](double c) { return c * (Ambient + (1 - Ambient) * light); });
  const Vector middle = project(mean);
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    fillTriangle({ middle, project(polygon[i]), project(following(polygon, i)) }, shaded);
  }
}

void Canvas::fillTriangle(const std::array<Vector, 3>& corners, const Colour& colour)
{
  const auto& [a, b, c] = corners;
  const double area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  if (!(std::abs(area) > 0) || !std::isfinite(area))
  {
    return;
  }
  const auto first = [](double low) { return static_cast<std::size_t>(std::max(0.0, low)); };
  const auto end = [](double high, std::size_t most) {
    return static_cast<std::size_t>(std::clamp(high + 1, 0.0, static_cast<double>(most)));
  };
  for (std::size_t y = first(std::min({ a[1], b[1], c[1] }));
       y < end(std::max({ a[1], b[1], c[1] }), rows_); ++y)
  {
    for (std::size_t x = first(std::min({ a[0], b[0], c[0] }));
         x < end(std::max({ a[0], b[0], c[0] }), columns_); ++x)
    {
      const double px = static_cast<double>(x) + 0.5 - a[0];
      const double py = static_cast<double>(y) + 0.5 - a[1];
      const double v = (px * (c[1] - a[1]) - (c[0] - a[0]) * py) / area;
      const double w = ((b[0] - a[0]) * py - px * (b[1] - a[1])) / area;
      const auto z = static_cast<float>(a[2] + v * (b[2] - a[2]) + w * (c[2] - a[2]));
      if (v >= 0 && w >= 0 && v + w <= 1 && z > depth_[y * columns_ + x])
      {
        depth_[y * columns_ + x] = z;
        set(x, y, colour);
      }
    }
  }
}

void Canvas::outline(const std::vector<Vector>& polygon, const Colour& colour)
{
  for (std::size_t i = 0; i < polygon.size(); ++i)
  {
    drawLine(project(polygon[i]), project(following(polygon, i)), colour);
  }
}

void Canvas::drawLine(const Vector& from, const Vector& to, const Colour& colour)
{
  const double length = std::max(std::abs(to[0] - from[0]), std::abs(to[1] - from[1]));
  if (!(length < static_cast<double>(2 * (columns_ + rows_)))) // of a point that is not a number
  {
    return;
  }
  const auto steps = static_cast<std::size_t>(std::ceil(length)) + 1;
  for (std::size_t i = 0; i <= steps; ++i)
  {
    const Vector at =
      plus(from, scaled(minus(to, from), static_cast<double>(i) / static_cast<double>(steps)));
    if (at[0] >= 0 && at[1] >= 0 && at[0] < static_cast<double>(columns_) &&
      at[1] < static_cast<double>(rows_))
    {
      const auto x = static_cast<std::size_t>(at[0]);
      const auto y = static_cast<std::size_t>(at[1]);
      if (at[2] + lineLift_ > depth_[y * columns_ + x])
      {
        set(x, y, colour);
      }
    }
  }
}

void Canvas::circle(const Vector& point, double radius, const Colour& colour)
{
  constexpr std::size_t Corners = 48;
  const Vector centre = project(point);
  for (const double ring : { radius, radius + 0.5, radius + 1 })
  {
    for (std::size_t i = 0; i < Corners; ++i)
    {
      const auto at = [&](std::size_t corner) {
        const double angle = 2 * Pi * static_cast<double>(corner) / Corners;
        const double reach = static_cast<double>(Samples) * ring;
        return Vector{ centre[0] + reach * std::cos(angle), centre[1] + reach * std::sin(angle),
          std::numeric_limits<double>::max() };
      };
      drawLine(at(i), at(i + 1), colour);
    }
  }
}

void Canvas::fade(double share)
{
  std::fill(depth_.begin(), depth_.end(), Farthest);
  std::transform(samples_.begin(), samples_.end(), samples_.begin(), [&](std::uint8_t sample) {
    return static_cast<std::uint8_t>(std::lround(255 - (1 - share) * (255 - sample)));
  });
}

std::vector<std::uint8_t> Canvas::pixels() const
{
  std::vector<std::uint8_t> result;
  result.reserve(3 * width_ * height_);
  for (std::size_t y = 0; y < height_; ++y)
  {
    for (std::size_t x = 0; x < width_; ++x)
    {
      for (std::size_t c = 0; c < 3; ++c)
      {
        std::size_t sum = 0;
        for (std::size_t i = 0; i < Samples * Samples; ++i)
        {
          const std::size_t row = Samples * y + i / Samples;
          sum += samples_[3 * (row * columns_ + Samples * x + i % Samples) + c];
        }
        result.push_back(static_cast<std::uint8_t>(sum / (Samples * Samples)));
      }
    }
  }
  return result;
}

}
