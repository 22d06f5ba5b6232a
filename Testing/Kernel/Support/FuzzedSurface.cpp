#include "Support/FuzzedSurface.h"

#include "Base/Error.h"

#include <algorithm>

namespace cartesian
{

namespace
{

// Small enough for thousands of runs a minute under sanitizers.
constexpr std::size_t MostTriangles = 400;

class Bytes
{
public:
  Bytes(const std::uint8_t* begin, std::size_t size)
    : next_(begin)
    , end_(begin + size)
  {
  }

  bool any() const { return next_ != end_; }
  unsigned byte() { return any() ? *next_++ : 0; }
  unsigned below(unsigned count) { return byte() % count; }
  std::uint32_t word() { return byte() | byte() << 8 | byte() << 16 | byte() << 24; }

private:
  const std::uint8_t* next_;
  const std::uint8_t* end_;
};

Soup randomTriangles(Bytes& bytes, const std::function<double()>& coordinate)
{
  Soup soup;
  const unsigned points = 3 + bytes.below(30);
  for (unsigned i = 0; i < points; ++i)
  {
    soup.points.push_back({ coordinate(), coordinate(), coordinate() });
  }
  for (unsigned t = 1 + bytes.below(60); t > 0; --t)
  {
    soup.triangles.push_back({ bytes.below(points), bytes.below(points), bytes.below(points) });
  }
  return soup;
}

Soup shape(Bytes& bytes)
{
  switch (bytes.below(6))
  {
    case 0:
      return cube();
    case 1:
      return octahedron(1);
    case 2:
      return sphere(1 + static_cast<int>(bytes.below(3)), 1);
    case 3:
      return torus(4, 1, 0.4);
    case 4:
      return box({ 0, 0, 0 }, { 2, 1, 0.125 });
    default:
      return starPolyhedron(bytes.byte(), 1);
  }
}

void edit(Soup& soup, Bytes& bytes)
{
  const auto triangles = static_cast<unsigned>(soup.triangles.size());
  const auto points = static_cast<unsigned>(soup.points.size());
  if (triangles == 0)
  {
    return;
  }
  auto& triangle = soup.triangles[bytes.word() % triangles];
  switch (bytes.below(6))
  {
    case 0:
      std::swap(triangle, soup.triangles.back());
      soup.triangles.pop_back();
      break;
    case 1:
      std::swap(triangle[0], triangle[1]);
      break;
    case 2:
      soup.triangles.push_back(std::array<std::uint32_t, 3>(triangle));
      break;
    case 3:
      soup.points[triangle[0]] = soup.points[triangle[1]]; // shrinks to an edge
      break;
    case 4:
      triangle[bytes.below(3)] = bytes.word() % points;
      break;
    default:
      for (double& x : soup.points[bytes.word() % points])
      {
        x += (bytes.byte() - 128.0) / 64;
      }
  }
}

Soup editedShapes(Bytes& bytes)
{
  Soup soup = shape(bytes);
  for (unsigned n = bytes.below(3); n > 0; --n)
  {
    Vector by{};
    for (double& x : by)
    {
      x = (bytes.byte() - 128.0) / 64;
    }
    soup.add(shape(bytes).moved(by));
  }
  soup.boundary.clear();
  for (unsigned n = bytes.below(12); n > 0; --n)
  {
    edit(soup, bytes);
  }
  return soup;
}

Meshlines planesFrom(Bytes& bytes, unsigned width)
{
  Meshlines planes;
  for (auto& levels : planes)
  {
    levels = { 0, 2 * width + 2 };
    for (unsigned n = bytes.below(8); n > 0; --n)
    {
      levels.push_back(2 * bytes.below(width + 2));
    }
    std::sort(levels.begin(), levels.end());
    levels.erase(std::unique(levels.begin(), levels.end()), levels.end());
  }
  return planes;
}

TestOptions optionsFrom(Bytes& bytes)
{
  TestOptions options = asTheyAre(bytes.below(2) ? 1e-3 : 0);
  const unsigned choices = bytes.byte();
  options.patches.method = (choices & 2) != 0 ? PatchMethod::MarchingCubes
    : (choices & 1) != 0                      ? PatchMethod::Automatic
                                              : PatchMethod::ExactFit;
  options.smallCells.handling = (choices & 4) != 0 ? SmallCells::Merge : SmallCells::Remove;
  options.shaping.splitConcave = (choices & 8) != 0;
  return options;
}

Meshed meshFrom(Bytes& bytes, TestOptions options)
{
  const unsigned kind = bytes.below(4);
  if (kind == 0)
  {
    const unsigned width = 1 + bytes.below(12);
    const Meshlines planes = planesFrom(bytes, width);
    const Soup soup = randomTriangles(bytes, [&] { return 2.0 * bytes.below(width + 1) + 1; });
    return meshPrepared(prepareOnLevels(soup, planes), options);
  }
  options.refinement = depth(static_cast<int>(bytes.below(3)));
  const double cells = 0.5 + bytes.below(32) / 4.0;
  const Soup soup = kind == 1
    ? randomTriangles(bytes, [&] { return static_cast<double>(bytes.word()); })
    : editedShapes(bytes);
  if (soup.triangles.size() > MostTriangles)
  {
    throw Error(Fault::EmptySurface, "too many triangles for a test");
  }
  return meshOf(soup, cellsOf(std::max(soup.longest(), 1e-9) / cells), options);
}

bool isRefusal(Fault fault)
{
  return fault == Fault::EmptySurface || fault == Fault::FlawedSurface ||
    fault == Fault::BadCellSize || fault == Fault::BadParameter;
}

}

Soup editedShapes(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  return editedShapes(bytes);
}

::testing::AssertionResult meshesFromBytes(const std::uint8_t* data, std::size_t size)
{
  Bytes bytes(data, size);
  try
  {
    const TestOptions options = optionsFrom(bytes);
    const bool nodesMove =
      options.shaping.splitConcave && options.patches.method != PatchMethod::ExactFit;
    return isValid(
      meshFrom(bytes, options).mesh, nodesMove || options.smallCells.handling == SmallCells::Merge);
  }
  catch (const Error& error)
  {
    return isRefusal(error.fault) ? ::testing::AssertionSuccess()
                                  : ::testing::AssertionFailure() << error.what();
  }
}

}
