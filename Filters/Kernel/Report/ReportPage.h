// SPDX-License-Identifier: BSD-3-Clause
// The report of a mesh: one page of HTML that needs no other file.
#pragma once

#include "Base/Palette.h"
#include "Quality/Histogram.h"

#include <string>
#include <vector>

namespace cartesian
{

struct ReportPicture
{
  std::string caption;
  std::string png; // in base 64
};

struct ReportHistogram
{
  std::string name;
  std::string limit; // in words, or empty
  double limitAt = 0;
  bool hasLimit = false;
  Histogram histogram;
};

// Texts are plain: the page escapes them.
struct ReportTable
{
  std::string title;
  std::vector<std::string> heads;
  std::vector<std::vector<std::string>> rows;
  std::vector<Colour> colours = {}; // a patch in front of each row, or none
};

struct ReportList
{
  std::string title;
  std::vector<std::string> lines;
};

struct ReportPage
{
  std::string title;
  std::string verdict;
  bool isGood = true;
  std::vector<std::string> lines; // below the verdict
  std::vector<ReportPicture> pictures;
  std::vector<ReportTable> tables;
  std::vector<ReportHistogram> histograms;
  std::vector<ReportList> lists;
};

// & < > " and ' as HTML has them; control characters, which it cannot have, as spaces.
std::string escaped(const std::string& text);

// An SVG element: bars with logarithmic heights, and the limit as a line with its name.
std::string drawing(const ReportHistogram& histogram);

std::string html(const ReportPage& report);

}
