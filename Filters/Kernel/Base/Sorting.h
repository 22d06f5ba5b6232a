// SPDX-License-Identifier: BSD-3-Clause
// Parallel sorts: of all items by <, and into buckets (count, scan, fill, sort). Equal items must be interchangeable: the
// results then depend on the items only, not on threads.
#pragma once

#include "Base/Execution.h"
#include "Base/RawVector.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <vector>

namespace cartesian
{

// Exclusive prefix sum, in place: turns counts into the start of each bucket. Returns the total.
template <class Integer>
Integer scan(std::vector<Integer>& counts)
{
  Integer sum = 0;
  for (Integer& count : counts)
  {
    const Integer here = count;
    count = sum;
    sum += here;
  }
  return sum;
}

// In order, each once.
template <class Item>
std::vector<Item> sortedUnique(std::vector<Item> list)
{
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

// What chunks have found, in their order.
template <class Item>
std::vector<Item> concatenated(const std::vector<std::vector<Item>>& parts)
{
  std::vector<Item> all;
  all.reserve(std::accumulate(parts.begin(), parts.end(), std::size_t(0),
    [](std::size_t sum, const std::vector<Item>& part) { return sum + part.size(); }));
  for (const std::vector<Item>& part : parts)
  {
    all.insert(all.end(), part.begin(), part.end());
  }
  return all;
}

// Sorts parts between values that divide a sample of the items into equal numbers.
template <class Item>
class SampleSort
{
public:
  static constexpr std::size_t ItemsAChunk = 1 << 12;

  SampleSort(Item* items, std::size_t count, Execution& execution)
    : items_(items)
    , count_(count)
    , parts_(std::min(count / ItemsAChunk, MostParts))
    , execution_(execution)
  {
  }

  void run()
  {
    if (parts_ < 2)
    {
      std::sort(items_, items_ + count_);
      return;
    }
    findEnds();
    assign();
    sortParts();
  }

private:
  static constexpr std::size_t MostParts = 256;
  static constexpr std::size_t SamplesAPart = 16;

  void findEnds()
  {
    std::vector<Item> samples;
    const std::size_t step = count_ / (parts_ * SamplesAPart);
    for (std::size_t i = 0; i < count_; i += step)
    {
      samples.push_back(items_[i]);
    }
    std::sort(samples.begin(), samples.end());
    for (std::size_t part = 1; part < parts_; ++part)
    {
      ends_.push_back(samples[part * samples.size() / parts_]);
    }
  }

  void assign()
  {
    partOf_.resize(count_);
    next_.assign(parts_ * chunks(count_, ItemsAChunk) + 1, 0);
    execution_.forEach(count_, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        partOf_[i] = static_cast<std::uint8_t>(
          std::upper_bound(ends_.begin(), ends_.end(), items_[i]) - ends_.begin());
        ++nextOf(partOf_[i], begin);
      }
    });
    scan(next_);
  }

  void sortParts()
  {
    std::vector<std::size_t> start;
    for (std::size_t part = 0; part <= parts_; ++part)
    {
      start.push_back(nextOf(part, 0));
    }
    RawVector<Item> sorted(count_);
    execution_.forEach(count_, ItemsAChunk, [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i)
      {
        sorted[nextOf(partOf_[i], begin)++] = items_[i];
      }
    });
    execution_.forEach(parts_, 1, [&](std::size_t part, std::size_t) {
      Item* const first = sorted.data() + start[part];
      Item* const last = sorted.data() + start[part + 1];
      std::sort(first, last);
      std::copy(first, last, items_ + start[part]);
    });
  }

  // Where the next item of a part goes, of those in the chunk that begins there.
  std::size_t& nextOf(std::size_t part, std::size_t begin)
  {
    return next_[part * chunks(count_, ItemsAChunk) + begin / ItemsAChunk];
  }

  Item* items_;
  std::size_t count_;
  std::size_t parts_;
  Execution& execution_;
  std::vector<Item> ends_; // of all parts but the last
  RawVector<std::uint8_t> partOf_;
  std::vector<std::size_t> next_;
};

template <class Vector>
void sortAll(Vector& items, Execution& execution)
{
  SampleSort<typename Vector::value_type>(items.data(), items.size(), execution).run();
}

template <class Item>
struct Buckets
{
  std::vector<std::size_t> start; // of each bucket, and the end of the last
  RawVector<Item> items;          // sorted within each bucket

  const Item* begin(std::size_t bucket) const { return items.data() + start[bucket]; }
  const Item* end(std::size_t bucket) const { return items.data() + start[bucket + 1]; }
};

template <class Item>
void sortEachBucket(Buckets<Item>& buckets, Execution& execution)
{
  constexpr std::size_t ItemsAChunk = 1 << 12;
  constexpr std::size_t ManyItems = 1 << 14; // in one bucket
  const std::vector<std::size_t>& start = buckets.start;
  std::vector<std::vector<std::size_t>> large(chunks(buckets.items.size(), ItemsAChunk));
  execution.forEach(buckets.items.size(), ItemsAChunk, [&](std::size_t begin, std::size_t end) {
    const auto first = std::lower_bound(start.begin(), start.end(), begin);
    for (auto b = static_cast<std::size_t>(first - start.begin()); start[b] < end; ++b)
    {
      if (start[b + 1] - start[b] > ManyItems)
      {
        large[begin / ItemsAChunk].push_back(b);
        continue;
      }
      std::sort(buckets.items.data() + start[b], buckets.items.data() + start[b + 1]);
    }
  });
  for (const std::vector<std::size_t>& ofChunk : large)
  {
    for (const std::size_t b : ofChunk)
    {
      SampleSort<Item>(buckets.items.data() + start[b], start[b + 1] - start[b], execution).run();
    }
  }
}

// Sorts items into buckets, and each bucket by <. visit(begin, end, add) calls add(bucket, item) for all items of the things
// from begin to end; it is called twice for each chunk, then done(begin, end) once.
template <class Item, class Visit, class Done>
Buckets<Item> fillBuckets(std::size_t count, std::size_t grain, std::size_t buckets, Visit&& visit,
  Done&& done, Execution& execution)
{
  Buckets<Item> result;
  std::vector<std::atomic<std::size_t>> next(buckets + 1);
  execution.forEach(count, grain, [&](std::size_t begin, std::size_t end) {
    visit(begin, end, [&](std::size_t bucket, const Item&) {
      next[bucket].fetch_add(1, std::memory_order_relaxed);
    });
  });
  result.start.resize(buckets + 1);
  std::size_t sum = 0;
  for (std::size_t b = 0; b <= buckets; ++b)
  {
    result.start[b] = sum;
    sum += next[b].load(std::memory_order_relaxed);
    next[b].store(result.start[b], std::memory_order_relaxed);
  }
  result.items.resize(sum);
  execution.forEach(count, grain, [&](std::size_t begin, std::size_t end) {
    visit(begin, end, [&](std::size_t bucket, const Item& item) {
      result.items[next[bucket].fetch_add(1, std::memory_order_relaxed)] = item;
    });
    done(begin, end);
  });
  sortEachBucket(result, execution);
  return result;
}

template <class Item, class Visit>
Buckets<Item> fillBuckets(
  std::size_t count, std::size_t grain, std::size_t buckets, Visit&& visit, Execution& execution)
{
  return fillBuckets<Item>(
    count, grain, buckets, visit, [](std::size_t, std::size_t) {}, execution);
}

// The same of items gathered chunk by chunk. Empties the chunks.
template <class Item, class BucketOf>
Buckets<Item> sortIntoBuckets(std::vector<std::vector<Item>>& chunkItems, std::size_t buckets,
  BucketOf&& bucketOf, Execution& execution)
{
  return fillBuckets<Item>(
    chunkItems.size(), 1, buckets,
    [&](std::size_t c, std::size_t, auto&& add) {
      for (const Item& item : chunkItems[c])
      {
        add(bucketOf(item), item);
      }
    },
    [&](std::size_t c, std::size_t) { std::vector<Item>().swap(chunkItems[c]); }, execution);
}

}
