// SPDX-License-Identifier: BSD-3-Clause
// What a loop of edits (EditLoop.h) remembers while it runs. A thread keeps the memory from loop to loop.
#pragma once

#include "Editing/Marks.h"
#include "Editing/Proposals.h"

#include <cstring>
#include <vector>

namespace cartesian
{

// Failed proposals, by what they were and the versions of the cells that they look at. A later one may push one out.
class FailedProposals
{
public:
  FailedProposals()
    : entries_(Size)
  {
  }

  void begin() { ++last_; }

  // Whether it has failed; else it is noted as if it had.
  bool contains(const Proposal& proposal, std::uint32_t version)
  {
    const std::uint64_t key = keyOf(proposal);
    Entry& entry = entries_[key >> Shift];
    const bool isKnown = entry.key == key && entry.version == version && entry.last == last_;
    entry = { key, version, last_ };
    return isKnown;
  }

private:
  struct Entry
  {
    std::uint64_t key = 0;
    std::uint32_t version = 0;
    std::uint32_t last = 0;
  };

  static constexpr std::size_t Size = std::size_t(1) << 16;
  static constexpr unsigned Shift = 64 - 16;

  static std::uint64_t keyOf(const Proposal& proposal)
  {
    constexpr std::uint64_t Odd = 0x9E3779B97F4A7C15U;
    std::uint64_t key = static_cast<std::uint64_t>(proposal.kind) + 1;
    const auto mix = [&](std::uint64_t part) { key = (key ^ part) * Odd + (key >> 29); };
    mix(proposal.a);
    mix(proposal.b);
    mix(proposal.c);
    for (const Vector* v : { &proposal.at, &proposal.normal })
    {
      for (const double x : *v)
      {
        std::uint64_t bits = 0;
        std::memcpy(&bits, &x, sizeof(bits));
        mix(bits);
      }
    }
    return key;
  }

  std::vector<Entry> entries_;
  std::uint32_t last_ = 0;
};

struct LoopMemory
{
  void begin()
  {
    here.begin();
    failed.begin();
    failedFaces.begin();
    failedCells.begin();
    hopelessFaces.begin();
    hopelessCells.begin();
    versions.begin();
  }

  Marks here; // cells that are looked at
  FailedProposals failed;
  ValuesByNumber<float> failedFaces; // what they cost when nothing helped
  ValuesByNumber<float> failedCells;
  Marks hopelessFaces; // nothing helped them once
  Marks hopelessCells;
  ValuesByNumber<std::uint32_t> versions; // of cells
};

}
