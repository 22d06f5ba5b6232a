// SPDX-License-Identifier: BSD-3-Clause
#include "Report/ReportPage.h"

#include <cctype>
#include <cmath>
#include <sstream>

namespace cartesian
{

namespace
{

constexpr const char* Style = R"(
body { font: 15px/1.45 system-ui, sans-serif; color: #222; max-width: 980px; margin: 24px auto; padding: 0 16px; }
h1 { font-size: 24px; } h2 { font-size: 18px; margin-top: 32px; }
.verdict { font-size: 19px; padding: 10px 14px; border-left: 6px solid; }
.good { border-color: #2a8c4a; background: #eef8f1; } .bad { border-color: #c02020; background: #fcefef; }
table { border-collapse: collapse; width: 100%; } th { text-align: left; }
td, th { padding: 3px 10px 3px 0; border-bottom: 1px solid #ddd; vertical-align: top; }
.patch { display: inline-block; width: 12px; height: 12px; margin-right: 7px; border: 1px solid #888; }
figure { margin: 0 0 20px; } img { max-width: 100%; border: 1px solid #ddd; } figcaption { color: #555; }
.histograms { display: grid; grid-template-columns: repeat(auto-fit, minmax(400px, 1fr)); gap: 12px; }
svg { width: 100%; font: 11px system-ui, sans-serif; } svg .name { font-size: 13px; font-weight: 600; }
rect { fill: #5b8db8; stroke: #fff; stroke-width: .5; } line.axis { stroke: #333; } line.grid { stroke: #ddd; }
line.limit { stroke: #c02020; stroke-width: 1.5; } text.limit { fill: #c02020; }
li { white-space: pre-wrap; overflow-wrap: anywhere; }
)";

std::string escapedCharacter(char c)
{
  switch (c)
  {
    case '&':
      return "&amp;";
    case '<':
      return "&lt;";
    case '>':
      return "&gt;";
    case '"':
      return "&quot;";
    case '\'':
      return "&#39;";
    default:
      return std::iscntrl(static_cast<unsigned char>(c)) != 0 && c != '\n' ? " "
                                                                           : std::string(1, c);
  }
}

std::string hexadecimal(const Colour& colour)
{
  constexpr const char* Digits = "0123456789abcdef";
  std::string text = "#";
  for (const double share : colour)
  {
    const auto byte = static_cast<unsigned int>(std::lround(255 * share));
    text += Digits[byte / 16];
    text += Digits[byte % 16];
  }
  return text;
}

void write(const ReportTable& table, std::ostream& page)
{
  page << "<h2>" << escaped(table.title) << "</h2>\n<table>\n<tr>";
  for (const std::string& head : table.heads)
  {
    page << "<th>" << escaped(head) << "</th>";
  }
  page << "</tr>\n";
  for (std::size_t row = 0; row < table.rows.size(); ++row)
  {
    page << "<tr>";
    for (std::size_t column = 0; column < table.rows[row].size(); ++column)
    {
      page << "<td>";
      if (column == 0 && row < table.colours.size())
      {
        page << R"(<span class="patch" style="background:)" << hexadecimal(table.colours[row])
             << R"("></span>)";
      }
      page << escaped(table.rows[row][column]) << "</td>";
    }
    page << "</tr>\n";
  }
  page << "</table>\n";
}

void write(const ReportList& list, std::ostream& page)
{
  page << "<h2>" << escaped(list.title) << "</h2>\n<ul>\n";
  for (const std::string& line : list.lines)
  {
    page << "<li>" << escaped(line) << "</li>\n";
  }
  page << "</ul>\n";
}

void write(const std::vector<ReportHistogram>& histograms, std::ostream& page)
{
  page << "<h2>Histograms</h2>\n<p>Cells by value; heights are logarithmic.</p>\n"
          "<div class=\"histograms\">\n";
  for (const ReportHistogram& histogram : histograms)
  {
    page << drawing(histogram);
  }
  page << "</div>\n";
}

}

std::string escaped(const std::string& text)
{
  std::string result;
  for (const char c : text)
  {
    result += escapedCharacter(c);
  }
  return result;
}

std::string html(const ReportPage& report)
{
  std::ostringstream page;
  page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n<title>"
       << escaped(report.title) << "</title>\n<style>" << Style << "</style>\n</head>\n<body>\n<h1>"
       << escaped(report.title) << "</h1>\n<p class=\"verdict " << (report.isGood ? "good" : "bad")
       << "\">" << escaped(report.verdict) << "</p>\n";
  for (const std::string& line : report.lines)
  {
    page << "<div>" << escaped(line) << "</div>\n";
  }
  for (const ReportPicture& picture : report.pictures)
  {
    page << "<figure><img alt=\"" << escaped(picture.caption) << "\" src=\"data:image/png;base64,"
         << picture.png << "\"/><figcaption>" << escaped(picture.caption)
         << "</figcaption></figure>\n";
  }
  for (const ReportTable& table : report.tables)
  {
    write(table, page);
  }
  if (!report.histograms.empty())
  {
    write(report.histograms, page);
  }
  for (const ReportList& list : report.lists)
  {
    write(list, page);
  }
  page << "</body>\n</html>\n";
  return page.str();
}

}
