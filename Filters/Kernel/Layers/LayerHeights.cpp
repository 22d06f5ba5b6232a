// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayerHeights.h"

#include <algorithm>
#include <cmath>

namespace cartesian
{

namespace
{

constexpr double LeastOfALayer = 0.5; // of the requested one

}

LayerHeights::LayerHeights(const WallLayerSpec& spec)
  : full_(heightsOfLayers(spec))
{
  const double first = full_[1];
  const double last = 1 - full_[layers() - 1];
  grown_ = last > first ? std::max(0.0, (LeastOfALayer * last - first) / (last - first)) : 1;
  kept_ = last > first ? blend(grown_, layers()) : 1;
}

double LayerHeights::blend(double t, std::size_t k) const
{
  return t * full_[k] + (1 - t) * double(k) * full_[1];
}

std::size_t LayerHeights::layersIn(double part, bool isFlat) const
{
  constexpr double Rounding = 1e-9;
  if (part <= 0 || !isFlat)
  {
    return part <= 0 ? 0 : layers();
  }
  const auto above = std::upper_bound(full_.begin(), full_.end(), part + Rounding);
  return static_cast<std::size_t>(above - full_.begin()) - 1;
}

double LayerHeights::fitting(double part, bool isFlat) const
{
  return isFlat ? full_[layersIn(part, isFlat)] : part;
}

// The centre of a cell of width w whose height goes from h - d / 2 to h + d / 2 lies w d / (12 h) aside.
std::size_t LayerHeights::layersBelow(std::size_t least, std::size_t most, double slenderness) const
{
  if (least == most)
  {
    return most;
  }
  const double differs = full_[most] - full_[least];
  const double mean = (full_[most] + full_[least]) / 2;
  const double highest =
    std::min(full_[least] - differs, mean - std::sqrt(slenderness * differs / 6));
  const auto above = std::upper_bound(full_.begin(), full_.end(), highest);
  return above == full_.begin() ? 0 : static_cast<std::size_t>(above - full_.begin()) - 1;
}

double LayerHeights::at(double part, std::size_t k, bool isFlat) const
{
  if (isFlat)
  {
    return std::min(part, full_[k]);
  }
  if (part >= kept_)
  {
    const double t = kept_ < 1 ? grown_ + (part - kept_) / (1 - kept_) * (1 - grown_) : 1;
    return blend(t, k);
  }
  if (part > LeastOfALayer)
  {
    const double t = (part - LeastOfALayer) / (kept_ - LeastOfALayer);
    return t * blend(grown_, k) + (1 - t) * LeastOfALayer * full_[k];
  }
  return part * full_[k];
}

}
