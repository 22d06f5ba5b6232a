// SPDX-License-Identifier: BSD-3-Clause
#include "OpenFoam/Substances.h"

#include "Base/Range.h"
#include "OpenFoam/Rows.h"

#include <algorithm>
#include <utility>

namespace cartesian
{

namespace
{

const Substance& propertiesOf(Material material)
{
  static const std::vector<std::pair<Material, Substance>> all = {
    { Material::Air, { "air", true, 1.2, 1005, 0.0257, 1.5e-5, 0.71 } },
    { Material::Water, { "water", true, 998, 4182, 0.598, 1.004e-6, 7.0 } },
    { Material::Aluminium, { "aluminium", false, 2700, 897, 237, 0, 0 } },
    { Material::Copper, { "copper", false, 8960, 385, 401, 0, 0 } },
    { Material::Steel, { "steel", false, 7850, 460, 50, 0, 0 } },
  };
  return std::find_if(all.begin(), all.end(), [&](const auto& each) {
    return each.first == material;
  })->second;
}

const RegionMaterial* rowOf(const SolverSetup& setup, const MeshOfCase& mesh)
{
  return rowFor(setup.materials, &RegionMaterial::region, mesh.region);
}

Material materialOf(const RegionMaterial* row, bool isFluid)
{
  return row && row->material != Material::ByKind ? row->material
    : isFluid                                     ? Material::Air
                                                  : Material::Steel;
}

void requireInRange(const RegionMaterial& row)
{
  for (const auto& [value, what] : { std::pair(row.density, "Material Densities"),
         std::pair(row.heatCapacity, "Material Heat Capacities"),
         std::pair(row.conductivity, "Material Conductivities"),
         std::pair(row.viscosity, "Material Viscosities") })
  {
    if (value != -1)
    {
      requireInRange(moreThan(0), value, std::string(what) + ": of region " + row.region);
    }
  }
}

}

Substance substanceOf(const SolverSetup& setup, const MeshOfCase& mesh)
{
  const RegionMaterial* const row = rowOf(setup, mesh);
  Substance substance = propertiesOf(materialOf(row, mesh.isFluid));
  if (!row || row->material == Material::ByKind)
  {
    substance.viscosity = setup.viscosity;
  }
  if (!row)
  {
    return substance;
  }
  const auto take = [](double& of, double value) { of = value > 0 ? value : of; };
  take(substance.density, row->density);
  take(substance.heatCapacity, row->heatCapacity);
  take(substance.viscosity, row->viscosity);
  if (row->conductivity > 0)
  {
    substance.conductivity = row->conductivity;
    substance.prandtl =
      substance.viscosity * substance.density * substance.heatCapacity / row->conductivity;
  }
  return substance;
}

double heatSourceOf(const SolverSetup& setup, const MeshOfCase& mesh)
{
  const RegionMaterial* const row = rowOf(setup, mesh);
  return row ? row->heatSource : 0;
}

void requireSuitableMaterials(const SolverSetup& setup, const std::vector<MeshOfCase>& meshes)
{
  if (!setup.materials.empty() && setup.solver != Solver::ConjugateHeat)
  {
    throw Error(Fault::BadParameter,
      "Materials: only Conjugate Heat has regions of materials. Nothing is written: remove the "
      "rows, "
      "and give Density and Viscosity instead, or set Solver Setup to Conjugate Heat.");
  }
  requireRowsFit(namesOf(setup.materials, &RegionMaterial::region),
    namesOf(meshes, &MeshOfCase::region), "Materials", "region");
  for (const RegionMaterial& row : setup.materials)
  {
    requireInRange(row);
  }
  for (const MeshOfCase& mesh : meshes)
  {
    const RegionMaterial* const row = rowOf(setup, mesh);
    const Substance& substance = propertiesOf(materialOf(row, mesh.isFluid));
    if (substance.isFluid != mesh.isFluid)
    {
      throw Error(Fault::BadParameter,
        "Materials: region " + mesh.region + " is " + (mesh.isFluid ? "fluid" : "solid") +
          ", but " + substance.name +
          " is not. Nothing is written: choose another material, or begin the "
          "region's name with " +
          (substance.isFluid ? "fluid" : "solid") + ".");
    }
    if (row && !mesh.isFluid && row->viscosity > 0)
    {
      throw Error(Fault::BadParameter,
        "Materials: region " + mesh.region +
          " is solid and has no viscosity. Nothing is written: set it to -1.");
    }
  }
}

}
