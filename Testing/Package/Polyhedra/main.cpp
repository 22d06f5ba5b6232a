// Prints the quality of the mesh of an OpenFOAM case: case-quality CASE [REGION]
#include "OpenFoam/PolyMeshReader.h"
#include "Quality/SolverCheck.h"

#include <iostream>

using namespace cartesian;

namespace
{

void print(const PolyMesh& mesh)
{
  Execution execution(Execution::AllCores);
  const double* const points = mesh.points.data();
  const Quality quality = measureQuality(points, mesh.cells, mesh.faces, execution);
  for (const SummaryValue& entry : summarise(quality, mesh.faces))
  {
    std::cout << entry.name << ' ' << entry.value << '\n';
  }

  const CheckedCells all{ std::vector<std::uint32_t>(mesh.cells.cellCount(), 0) };
  const std::vector<bool> isSeen(mesh.faces.owner.size() - mesh.faces.neighbour.size(), true);
  const Findings found =
    checkForSolver(points, mesh.cells, mesh.faces, all, isSeen, execution).ofRegions.front();
  std::cout << (failuresIn(found) == 0 ? "Mesh OK\n" : "checkMesh refuses it\n");
}

}

int main(int count, char** arguments)
{
  if (count < 2)
  {
    std::cerr << "usage: case-quality CASE [REGION]\n";
    return 2;
  }
  try
  {
    const std::string region = count > 2 ? arguments[2] : "";
    print(readPolyMesh(std::filesystem::path(arguments[1]) / "constant" / region / "polyMesh"));
  }
  catch (const std::exception& error)
  {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
