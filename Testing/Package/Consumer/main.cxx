// Meshes a ball of radius 1 with the installed library, and measures the mesh.
#include "vtkCartesianMesher.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkFiniteVolumeQuality.h"
#include "vtkNew.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"

#include <cmath>
#include <iostream>

int main()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(1);
  sphere->SetThetaResolution(60);
  sphere->SetPhiResolution(60);

  vtkNew<vtkCartesianMesher> mesher;
  mesher->SetInputConnection(sphere->GetOutputPort());
  mesher->SetCellSize(0.1);

  vtkNew<vtkFiniteVolumeQuality> quality;
  quality->SetInputConnection(mesher->GetOutputPort());
  quality->Update();

  auto* mesh = vtkUnstructuredGrid::SafeDownCast(quality->GetOutputDataObject(0));
  const double volume = mesh->GetFieldData()->GetArray("TotalVolume")->GetComponent(0, 0);
  std::cout << mesh->GetNumberOfCells() << " cells, volume " << volume << '\n';

  const double exact = 4.0 / 3.0 * std::acos(-1.0);
  const bool asExpected = mesher->GetErrorCode() == 0 && mesh->GetNumberOfCells() > 4000 &&
    std::abs(volume - exact) < 0.02 * exact;
  return asExpected ? 0 : 1;
}
