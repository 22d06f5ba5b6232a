// SPDX-License-Identifier: BSD-3-Clause
#include "Layers/LayerHeights.h"

#include <algorithm>

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

double LayerHeights::at(double part, std::size_t k, bool isFlat) const
{
  if (isFlat)
  {
    return part * full_[k];
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
