// Prints a hash of every array of many meshes, one mesh a line: two builds of the kernel whose output is
// the same make the same meshes, bit for bit.
#include "Base/Error.h"
#include "Support/DataFile.h"
#include "Support/Pipeline.h"

#include <cstring>
#include <iostream>
#include <sstream>

using namespace cartesian;

namespace
{

// FNV-1a, 64 bits.
class Hash
{
public:
  template <class Value>
  Hash& add(const std::vector<Value>& values)
  {
    for (const Value& value : values)
    {
      std::array<unsigned char, sizeof(Value)> bytes;
      std::memcpy(bytes.data(), &value, sizeof(Value));
      for (const unsigned char byte : bytes)
      {
        value_ = (value_ ^ byte) * 0x100000001b3U;
      }
    }
    return *this;
  }

  std::uint64_t value() const { return value_; }

private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

std::uint64_t hashOf(const Soup& soup)
{
  return Hash().add(soup.points).add(soup.triangles).add(soup.boundary).value();
}

std::uint64_t hashOf(const MeshArrays& mesh)
{
  Hash hash;
  hash.add(mesh.points).add(mesh.offsets).add(mesh.connectivity).add(mesh.types);
  hash.add(mesh.faceStart).add(mesh.faceStream);
  hash.add(mesh.globalBox).add(mesh.level).add(mesh.region).add(mesh.volumeFraction);
  hash.add(mesh.boundaryStart).add(mesh.boundaryPoints);
  hash.add(mesh.boundaryCell).add(mesh.boundaryIndex);
  return hash.value();
}

std::string describe(const Soup& soup, double cells, const TestOptions& options)
{
  std::ostringstream text;
  try
  {
    const Meshed meshed = meshOf(soup, cellsAlongLongest(soup, cells), options);
    text << meshed.mesh.cells() << " cells, " << std::hex << hashOf(meshed.mesh);
  }
  catch (const Error& error)
  {
    text << error.what();
  }
  return text.str();
}

void print(const NamedShape& shape, double cells, int levels)
{
  TestOptions options;
  options.refinement = depth(levels);
  options.threads = Execution::AllCores;
  for (const PatchMethod method :
    { PatchMethod::Automatic, PatchMethod::ExactFit, PatchMethod::MarchingCubes })
  {
    options.patches.method = method;
    std::cout << shape.name << ' ' << std::hex << hashOf(shape.soup) << std::dec << ", depth "
              << levels << ", method " << static_cast<int>(method) << ": "
              << describe(shape.soup, cells, options) << std::endl;
  }
}

}

int main()
{
  std::vector<NamedShape> small = cleanShapes();
  small.push_back({ "KleinBottle", kleinBottle(12) });
  for (const NamedShape& shape : small)
  {
    print(shape, 12, 0);
    print(shape, 7, 2);
  }
  for (const char* const name : { "cino_spot.obj", "kcl_exhaust_header_lumens.stl",
         "tm_featuretype_occ.stl", "tm_not_convex.obj" })
  {
    const NamedShape shape = readData(name);
    print(shape, 40, 0);
    print(shape, 12, 2);
  }
}
