// SPDX-License-Identifier: BSD-3-Clause
#include "PlainObj.h"

#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkFloatArray.h"
#include "vtkIdTypeArray.h"
#include "vtkNew.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "vtksys/FStream.hxx"

#include <algorithm>
#include <atomic>
#include <charconv>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace cartesian
{

namespace
{

constexpr std::size_t BytesAChunk = 1 << 16;

// What the lines of a chunk hold.
struct ObjLines
{
  std::vector<double> points;
  std::vector<vtkIdType> corners; // from 0
  std::vector<vtkIdType> sizes;   // of faces
  std::vector<vtkIdType> groups;  // lines before each face
  vtkIdType groupLines = 0;
  vtkIdType lastPoint = -1; // of the corners
};

// The words of a line, in order.
class LineWords
{
public:
  explicit LineWords(std::string_view line)
    : rest_(line)
  {
  }

  // Empty: there are no more.
  std::string_view next()
  {
    constexpr std::string_view space = " \t\r\v\f";
    rest_.remove_prefix(std::min(rest_.find_first_not_of(space), rest_.size()));
    const std::string_view word = rest_.substr(0, rest_.find_first_of(space));
    rest_.remove_prefix(word.size());
    return word;
  }

  // Whether the next word is a number, and nothing but that.
  template <class Value>
  bool read(Value& value)
  {
    const std::string_view word = next();
    const char* const end = word.data() + word.size();
    const auto [stop, error] = std::from_chars(word.data(), end, value);
    return error == std::errc() && stop == end;
  }

  bool isAtEnd() { return next().empty(); }

private:
  std::string_view rest_;
};

bool readVertex(LineWords& words, ObjLines& lines)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    double at = 0;
    if (!words.read(at) || !std::isfinite(at))
    {
      return false;
    }
    lines.points.push_back(at);
  }
  return words.isAtEnd();
}

bool readFace(LineWords words, ObjLines& lines)
{
  const std::size_t before = lines.corners.size();
  for (LineWords rest = words; !rest.isAtEnd(); words = rest)
  {
    vtkIdType number = 0;
    if (!words.read(number) || number < 1)
    {
      return false;
    }
    lines.corners.push_back(number - 1);
    lines.lastPoint = std::max(lines.lastPoint, number - 1);
  }
  lines.sizes.push_back(static_cast<vtkIdType>(lines.corners.size() - before));
  lines.groups.push_back(lines.groupLines);
  return lines.sizes.back() >= 3;
}

// Whether the line is plain.
bool readLine(std::string_view line, ObjLines& lines)
{
  LineWords words(line);
  const std::string_view keyword = words.next();
  if (keyword == "v")
  {
    return readVertex(words, lines);
  }
  if (keyword == "f")
  {
    return readFace(words, lines);
  }
  lines.groupLines += keyword == "g" ? 1 : 0;
  // A line that ends so goes on in the next.
  return (keyword.empty() || keyword[0] == '#' || keyword == "g" || keyword == "o" ||
           keyword == "s") &&
    line.find('\\') == std::string_view::npos;
}

// Where the first line begins that begins at a place or after it.
std::size_t lineFrom(const std::string& text, std::size_t place)
{
  const std::size_t end = place == 0 ? 0 : text.find('\n', place - 1);
  return place == 0 ? 0 : end == std::string::npos ? text.size() : end + 1;
}

// Of each chunk; none: a line is not plain.
std::vector<ObjLines> readLines(const std::string& text, Execution& execution)
{
  std::vector<ObjLines> parts(chunks(text.size(), BytesAChunk));
  std::atomic<bool> isPlain{ true };
  execution.forEach(text.size(), BytesAChunk, [&](std::size_t begin, std::size_t end) {
    const std::size_t last = lineFrom(text, end);
    for (std::size_t at = lineFrom(text, begin); at < last && isPlain;)
    {
      const std::size_t next = lineFrom(text, at + 1);
      const std::string_view line = std::string_view(text).substr(at, next - at);
      if (!readLine(line.substr(0, line.find('\n')), parts[begin / BytesAChunk]))
      {
        isPlain = false;
      }
      at = next;
    }
  });
  return isPlain ? std::move(parts) : std::vector<ObjLines>();
}

// Where what each chunk holds begins in all.
struct ObjPlace
{
  std::size_t point = 0; // three numbers each
  std::size_t corner = 0;
  std::size_t face = 0;
  vtkIdType group = 0;
};

// And the ends.
std::vector<ObjPlace> placesOf(const std::vector<ObjLines>& parts)
{
  std::vector<ObjPlace> places{ {} };
  for (const ObjLines& part : parts)
  {
    const ObjPlace& at = places.back();
    places.push_back({ at.point + part.points.size(), at.corner + part.corners.size(),
      at.face + part.sizes.size(), at.group + part.groupLines });
  }
  return places;
}

// The number of the group of the first faces, before which there may be no line of one.
vtkIdType firstGroup(const std::vector<ObjLines>& parts, const std::vector<ObjPlace>& places)
{
  for (std::size_t i = 0; i < parts.size(); ++i)
  {
    if (!parts[i].groups.empty())
    {
      return places[i].group + parts[i].groups.front() == 0 ? 0 : 1;
    }
  }
  return 0;
}

std::string contentOf(const char* file)
{
  vtksys::ifstream stream(file, std::ios::binary);
  std::string text;
  stream.seekg(0, std::ios::end);
  if (const auto size = stream.tellg(); stream && size > 0)
  {
    text.resize(static_cast<std::size_t>(size));
    stream.seekg(0);
    stream.read(text.data(), size);
  }
  return stream ? text : std::string();
}

}

bool readPlainObj(const char* file, vtkPolyData* surface, Execution& execution)
{
  const std::vector<ObjLines> parts =
    file ? readLines(contentOf(file), execution) : std::vector<ObjLines>();
  const std::vector<ObjPlace> places = placesOf(parts);
  const ObjPlace& all = places.back();
  const auto pointCount = static_cast<vtkIdType>(all.point / 3);
  if (all.face == 0 || std::any_of(parts.begin(), parts.end(), [&](const ObjLines& part) {
        return part.lastPoint >= pointCount;
      }))
  {
    return false;
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->SetNumberOfPoints(pointCount);
  vtkNew<vtkIdTypeArray> offsets;
  offsets->SetNumberOfValues(static_cast<vtkIdType>(all.face) + 1);
  offsets->SetValue(static_cast<vtkIdType>(all.face), static_cast<vtkIdType>(all.corner));
  vtkNew<vtkIdTypeArray> corners;
  corners->SetNumberOfValues(static_cast<vtkIdType>(all.corner));
  vtkNew<vtkFloatArray> groups;
  groups->SetName("GroupIds");
  groups->SetNumberOfValues(static_cast<vtkIdType>(all.face));
  auto* const xyz = static_cast<double*>(points->GetVoidPointer(0));
  const vtkIdType first = firstGroup(parts, places);
  execution.forEach(parts.size(), 1, [&](std::size_t i, std::size_t) {
    const ObjLines& part = parts[i];
    const ObjPlace& at = places[i];
    std::copy(part.points.begin(), part.points.end(), xyz + at.point);
    std::copy(part.corners.begin(), part.corners.end(), corners->GetPointer(0) + at.corner);
    auto face = static_cast<vtkIdType>(at.face);
    auto offset = static_cast<vtkIdType>(at.corner);
    for (std::size_t f = 0; f < part.sizes.size(); ++f, ++face)
    {
      offsets->SetValue(face, offset);
      offset += part.sizes[f];
      groups->SetValue(face, static_cast<float>(at.group + part.groups[f] - first));
    }
  });
  vtkNew<vtkCellArray> polygons;
  polygons->SetData(offsets, corners);
  surface->SetPoints(points);
  surface->SetPolys(polygons);
  surface->GetCellData()->AddArray(groups);
  return true;
}

}
