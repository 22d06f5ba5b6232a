// SPDX-License-Identifier: BSD-3-Clause
// Parallel bucket sort of items gathered chunk by chunk: count, scan, fill, sort.
#pragma once

#include "Base/Execution.h"
#include "Base/RawVector.h"

#include <algorithm>
#include <atomic>
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

template <class Item>
struct Buckets
{
  std::vector<std::size_t> start; // of each bucket, and the end of the last
  RawVector<Item> items;          // sorted within each bucket

  const Item* begin(std::size_t bucket) const { return items.data() + start[bucket]; }
  const Item* end(std::size_t bucket) const { return items.data() + start[bucket + 1]; }
};

// Sorts the items of all chunks into buckets, and each bucket by <. Equal items must be
// interchangeable: the result then depends on the items only, not on threads. Empties the chunks.
template <class Item, class BucketOf>
Buckets<Item> sortIntoBuckets(std::vector<std::vector<Item>>& chunkItems, std::size_t buckets,
  BucketOf&& bucketOf, Execution& execution)
{
  Buckets<Item> result;
  std::vector<std::atomic<std::size_t>> next(buckets + 1);
  execution.forEach(chunkItems.size(), 1, [&](std::size_t c, std::size_t) {
    for (const Item& item : chunkItems[c])
    {
      next[bucketOf(item)].fetch_add(1, std::memory_order_relaxed);
    }
  });
  result.start.resize(buckets + 1);
  std::size_t sum = 0;
  for (std::size_t b = 0; b <= buckets; ++b)
  {
    result.start[b] = sum;
    sum += next[b].exchange(sum);
  }
  result.items.resize(sum);
  execution.forEach(chunkItems.size(), 1, [&](std::size_t c, std::size_t) {
    for (const Item& item : chunkItems[c])
    {
      result.items[next[bucketOf(item)].fetch_add(1, std::memory_order_relaxed)] = item;
    }
    std::vector<Item>().swap(chunkItems[c]);
  });
  constexpr std::size_t BucketsAChunk = 64;
  execution.forEach(buckets, BucketsAChunk, [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b)
    {
      std::sort(result.items.begin() + result.start[b], result.items.begin() + result.start[b + 1]);
    }
  });
  return result;
}

}
