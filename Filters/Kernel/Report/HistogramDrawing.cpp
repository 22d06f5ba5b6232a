// SPDX-License-Identifier: BSD-3-Clause
#include "Base/Error.h"
#include "Report/ReportPage.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr double Width = 460;
constexpr double Height = 230;
constexpr double Left = 56;
constexpr double Right = 16;
constexpr double Top = 24;
constexpr double Bottom = 40;

// So that a single cell can be seen.
constexpr double LeastCount = 0.5;

// Up to five round numbers in a range.
std::vector<double> ticks(ValueRange range)
{
  const double rough = (range.high - range.low) / 5;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double factor : { 5.0, 2.0, 1.0 })
  {
    step = factor * power >= rough ? factor * power : step;
  }
  std::vector<double> result;
  for (double i = std::ceil(range.low / step); i * step <= range.high; ++i)
  {
    result.push_back(i * step);
  }
  return result;
}

class Drawing
{
public:
  explicit Drawing(const ReportHistogram& of)
    : of_(of)
    , axis_(of.histogram.range)
  {
    const std::vector<std::size_t>& counts = of.histogram.counts;
    most_ = static_cast<double>(
      std::max<std::size_t>(2, *std::max_element(counts.begin(), counts.end())));
    if (of.hasLimit)
    {
      axis_ = { std::min(axis_.low, of.limitAt), std::max(axis_.high, of.limitAt) };
    }
    svg_.precision(6);
  }

  std::string run()
  {
    svg_ << R"(<svg viewBox="0 0 )" << Width << " " << Height << R"(" role="img" aria-label=")"
         << escaped(of_.name) << R"(">
<text x=")"
         << Left << R"(" y="14" class="name">)" << escaped(of_.name) << "</text>\n";
    drawCounts();
    drawBars();
    drawAxis();
    drawLimit();
    svg_ << "</svg>\n";
    return svg_.str();
  }

private:
  double x(double value) const
  {
    return Left + (Width - Left - Right) * (value - axis_.low) / (axis_.high - axis_.low);
  }
  double y(double count) const
  {
    const double share =
      std::log(std::max(count, LeastCount) / LeastCount) / std::log(most_ / LeastCount);
    return Height - Bottom - (Height - Top - Bottom) * share;
  }
  void text(double x, double y, const char* anchor, const std::string& words)
  {
    svg_ << "<text x=\"" << x << "\" y=\"" << y << "\" text-anchor=\"" << anchor << "\">"
         << escaped(words) << "</text>\n";
  }
  void line(double x1, double y1, double x2, double y2, const char* kind)
  {
    svg_ << "<line x1=\"" << x1 << "\" y1=\"" << y1 << "\" x2=\"" << x2 << "\" y2=\"" << y2
         << "\" class=\"" << kind << "\"/>\n";
  }

  void drawCounts()
  {
    double count = 1;
    while (count <= most_)
    {
      line(Left, y(count), Width - Right, y(count), "grid");
      text(Left - 6, y(count) + 4, "end", number(count));
      count *= 10;
    }
    svg_ << "<text transform=\"translate(12," << (Height - Bottom + Top) / 2
         << ") rotate(-90)\" text-anchor=\"middle\">cells</text>\n";
  }

  void drawBars()
  {
    const Histogram& histogram = of_.histogram;
    for (std::size_t bin = 0; bin < histogram.counts.size(); ++bin)
    {
      if (const auto count = static_cast<double>(histogram.counts[bin]); count > 0)
      {
        const double from = x(histogram.edge(bin));
        svg_ << "<rect x=\"" << from << "\" y=\"" << y(count) << "\" width=\""
             << x(histogram.edge(bin + 1)) - from << "\" height=\"" << Height - Bottom - y(count)
             << "\"><title>" << number(histogram.edge(bin)) << " to "
             << number(histogram.edge(bin + 1)) << ": " << histogram.counts[bin]
             << "</title></rect>\n";
      }
    }
  }

  void drawAxis()
  {
    line(Left, Height - Bottom, Width - Right, Height - Bottom, "axis");
    for (const double value : ticks(axis_))
    {
      line(x(value), Height - Bottom, x(value), Height - Bottom + 4, "axis");
      text(x(value), Height - Bottom + 17, "middle", number(value));
    }
  }

  void drawLimit()
  {
    if (of_.hasLimit)
    {
      const double at = x(of_.limitAt);
      const bool isRight = at > (Left + Width - Right) / 2;
      line(at, Top - 6, at, Height - Bottom, "limit");
      svg_ << "<text x=\"" << at + (isRight ? -5 : 5) << "\" y=\"" << Top + 6
           << R"(" class="limit" text-anchor=")" << (isRight ? "end" : "start") << "\">"
           << escaped(of_.limit) << "</text>\n";
    }
  }

  const ReportHistogram& of_;
  ValueRange axis_;
  double most_;
  std::ostringstream svg_;
};

}

std::string drawing(const ReportHistogram& histogram)
{
  return Drawing(histogram).run();
}

}
