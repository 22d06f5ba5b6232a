// Writes the tests' named shapes as STL files, for wallcells.py; but for those that single precision spoils.
#include "Support/Shapes.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iostream>
#include <set>

using namespace cartesian;

namespace
{

// Coordinates of STL are rounded by less than this part of the shape.
constexpr double MostRounding = 1e-6;

bool fitsSinglePrecision(const Soup& soup)
{
  double largest = 0;
  for (const Vector& p : soup.points)
  {
    for (const double x : p)
    {
      largest = std::max(largest, std::abs(x - double(static_cast<float>(x))));
    }
  }
  return largest < MostRounding * soup.longest();
}

void write(const Soup& soup, const std::filesystem::path& path)
{
  std::ofstream file(path);
  file << std::setprecision(9);
  const std::set<std::int32_t> boundaries(soup.boundary.begin(), soup.boundary.end());
  for (const std::int32_t boundary : boundaries.empty() ? std::set<std::int32_t>{ 0 } : boundaries)
  {
    file << "solid boundary_" << boundary << '\n';
    for (std::size_t t = 0; t < soup.triangles.size(); ++t)
    {
      if (soup.boundaryOf(t) != boundary)
      {
        continue;
      }
      file << "facet normal 0 0 0\nouter loop\n";
      for (const std::uint32_t corner : soup.triangles[t])
      {
        const Vector& p = soup.points[corner];
        file << "vertex " << p[0] << ' ' << p[1] << ' ' << p[2] << '\n';
      }
      file << "endloop\nendfacet\n";
    }
    file << "endsolid boundary_" << boundary << '\n';
  }
}

}

int main(int argc, char** argv)
{
  if (argc != 2)
  {
    std::cerr << "usage: NamedShapes FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder(argv[1]);
  std::filesystem::create_directories(folder);
  for (const NamedShape& shape : cleanShapes())
  {
    if (fitsSinglePrecision(shape.soup))
    {
      write(shape.soup, folder / (shape.name + ".stl"));
    }
  }
  return 0;
}
