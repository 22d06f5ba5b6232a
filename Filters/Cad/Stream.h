// SPDX-License-Identifier: BSD-3-Clause
// What the program read-cad writes into its pipe, and vtkCADReader reads from it: records, each a letter (Record),
// its length in bytes (8), and that many bytes. Numbers are as in memory: both run on one machine.
#pragma once

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

namespace cartesian
{

enum class Record : char
{
  Progress = 'P', // part done, 0 to 1
  Note = 'N',     // a sentence: what was found or done
  Warning = 'W',  // a sentence: what the user must know
  Damage = 'D',   // a sentence: what is wrong in the file, if reading ends early
  Error = 'E',    // a sentence: why there is no result
  Names = 'B',    // of all boundaries, by number
  Solid = 'S',    // a CadSolid
  End = 'Z'       // the result is whole
};

// Bytes of values, in order.
class Packer
{
public:
  template <typename T>
  void add(const T& value)
  {
    const auto* begin = reinterpret_cast<const char*>(&value);
    bytes_.insert(bytes_.end(), begin, begin + sizeof value);
  }

  void add(const std::string& text)
  {
    add(std::uint64_t(text.size()));
    bytes_.insert(bytes_.end(), text.begin(), text.end());
  }

  template <typename T>
  void add(const std::vector<T>& values)
  {
    add(std::uint64_t(values.size()));
    const auto* begin = reinterpret_cast<const char*>(values.data());
    bytes_.insert(bytes_.end(), begin, begin + values.size() * sizeof(T));
  }

  void add(const std::vector<std::string>& texts)
  {
    add(std::uint64_t(texts.size()));
    for (const std::string& text : texts)
    {
      add(text);
    }
  }

  const std::vector<char>& bytes() const { return bytes_; }

private:
  std::vector<char> bytes_;
};

// The values again. Throws std::runtime_error where bytes are missing.
class Unpacker
{
public:
  Unpacker(const char* begin, std::size_t size)
    : at_(begin)
    , end_(begin + size)
  {
  }

  template <typename T>
  void get(T& value)
  {
    copy(&value, 1);
  }

  void get(std::string& text)
  {
    text.resize(count(1));
    copy(text.data(), text.size());
  }

  template <typename T>
  void get(std::vector<T>& values)
  {
    values.resize(count(sizeof(T)));
    copy(values.data(), values.size());
  }

  void get(std::vector<std::string>& texts)
  {
    texts.resize(count(1));
    for (std::string& text : texts)
    {
      get(text);
    }
  }

private:
  // Of values of that size, of which there cannot be more than bytes.
  std::size_t count(std::size_t size)
  {
    std::uint64_t number = 0;
    get(number);
    if (number > std::uint64_t(end_ - at_) / size)
    {
      throw std::runtime_error("a record is cut off");
    }
    return static_cast<std::size_t>(number);
  }

  template <typename T>
  void copy(T* to, std::size_t number)
  {
    const std::size_t size = number * sizeof(T);
    if (size > std::size_t(end_ - at_))
    {
      throw std::runtime_error("a record is cut off");
    }
    if (size > 0)
    {
      std::memcpy(to, at_, size);
    }
    at_ += size;
  }

  const char* at_;
  const char* end_;
};

// Triangles of one solid. Lengths are in the unit asked for.
struct CadSolid
{
  std::string name;
  std::vector<double> points;          // x, y, z
  std::vector<std::int64_t> triangles; // three points each, counter-clockwise seen from outside
  std::vector<std::int32_t> boundary;  // of each triangle
  std::vector<std::int64_t> lines;     // sharp edges, two points each
  std::vector<std::int32_t> boundaryOfLine;
  double volume = 0;           // of the exact shape; 0 if it is open, or not known
  double area = 0;             // of the exact shape
  std::uint8_t knowsEdges = 1; // 0: angles tell which are sharp
  double deflection = 0;
  double volumeOfTriangles = 0;
  std::int32_t openEdges = 0;  // of triangles that lack a neighbour
  std::uint8_t isOpenBody = 0; // 1: faces that form no solid

  // For Packer and Unpacker alike.
  template <typename Visit>
  void visit(Visit&& with)
  {
    with(name);
    with(points);
    with(triangles);
    with(boundary);
    with(lines);
    with(boundaryOfLine);
    with(volume);
    with(area);
    with(knowsEdges);
    with(volumeOfTriangles);
    with(deflection);
    with(openEdges);
    with(isOpenBody);
  }
};

}
