#include "Support/DataFile.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace cartesian
{

namespace
{

// "7", "7/1" or "7/1/3" of an OBJ file's faces, which count from 1.
std::uint32_t pointOf(const std::string& corner)
{
  return static_cast<std::uint32_t>(std::stoul(corner) - 1);
}

}

NamedShape readData(const std::string& name)
{
  std::ifstream file(DATA_FOLDER "/" + name);
  NamedShape shape{ name, {} };
  Soup& soup = shape.soup;
  std::int32_t solids = 0;
  for (std::string line; std::getline(file, line);)
  {
    std::istringstream words(line);
    std::string key;
    words >> key;
    if (key == "solid")
    {
      ++solids;
    }
    else if (key == "vertex" || key == "v")
    {
      Vector p{};
      words >> p[0] >> p[1] >> p[2];
      soup.points.push_back(p);
    }
    else if (key == "endfacet")
    {
      const auto last = static_cast<std::uint32_t>(soup.points.size() - 1);
      soup.triangles.push_back({ last - 2, last - 1, last });
      soup.boundary.push_back(solids - 1);
    }
    else if (key == "f")
    {
      std::array<std::string, 3> corners;
      words >> corners[0] >> corners[1] >> corners[2];
      soup.triangles.push_back({ pointOf(corners[0]), pointOf(corners[1]), pointOf(corners[2]) });
    }
  }
  if (soup.triangles.empty())
  {
    throw std::runtime_error("There are no triangles in " DATA_FOLDER "/" + name);
  }
  return shape;
}

}
