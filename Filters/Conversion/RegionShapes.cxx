// SPDX-License-Identifier: BSD-3-Clause
#include "RegionShapes.h"

#include "Base/Error.h"

#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <cctype>

namespace cartesian
{

namespace
{

constexpr int Facets = 64; // once around

std::string inLowerCase(const std::string& text)
{
  std::string lower = text;
  std::transform(lower.begin(), lower.end(), lower.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return lower;
}

// All between -1/2 and 1/2; a cylinder along y.
vtkSmartPointer<vtkPolyDataAlgorithm> shapeOfUnitSize(const std::string& name)
{
  const std::string shape = inLowerCase(name);
  if (shape == "box")
  {
    return vtkSmartPointer<vtkCubeSource>::New();
  }
  if (shape == "sphere")
  {
    const auto sphere = vtkSmartPointer<vtkSphereSource>::New();
    sphere->SetThetaResolution(Facets);
    sphere->SetPhiResolution(Facets / 2);
    return sphere;
  }
  if (shape == "cylinderx" || shape == "cylindery" || shape == "cylinderz")
  {
    const auto cylinder = vtkSmartPointer<vtkCylinderSource>::New();
    cylinder->SetResolution(Facets);
    return cylinder;
  }
  throw Error(Fault::BadParameter,
    "Refinement Shapes has \"" + name +
      "\": choose one of box, sphere, cylinderX, cylinderY, cylinderZ.");
}

}

vtkSmartPointer<vtkPolyData> shapeInBox(const std::string& shape,
  const std::array<double, 3>& position, const std::array<double, 3>& lengths)
{
  const auto source = shapeOfUnitSize(shape);
  if (!(*std::min_element(lengths.begin(), lengths.end()) > 0))
  {
    throw Error(
      Fault::BadParameter, "All Refinement Lengths must be more than 0: a shape needs a volume.");
  }
  vtkNew<vtkTransform> place;
  place->Translate(
    position[0] + lengths[0] / 2, position[1] + lengths[1] / 2, position[2] + lengths[2] / 2);
  place->Scale(lengths.data());
  if (inLowerCase(shape) == "cylinderx")
  {
    place->RotateZ(90);
  }
  if (inLowerCase(shape) == "cylinderz")
  {
    place->RotateX(90);
  }
  vtkNew<vtkTransformPolyDataFilter> filter;
  filter->SetInputConnection(source->GetOutputPort());
  filter->SetTransform(place);
  filter->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  filter->Update();
  return filter->GetOutput();
}

}
