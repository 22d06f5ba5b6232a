# SPDX-License-Identifier: BSD-3-Clause
"""Two solids that touch: meshes by each mesher, and conduction in both by chtMultiRegionSimpleFoam."""

import pathlib
import tempfile

import numpy as np
from paraview import simple

import harness  # before what it finds
import foam
import snappy
from conduction import Walls, exact
from conduction import SCHEMES
from wallsurfaces import polydata

REGIONS, INTERFACE = ("inner", "outer"), "interface"
SWEEPS = 200  # of the solver over both solids
SOLUTION = """solvers { h { solver PCG; preconditioner DIC; tolerance 1e-12; relTol 0.001; } }
SIMPLE { nNonOrthogonalCorrectors 5; } relaxationFactors { equations { h 1; } }"""
SOLID = """thermoType {{ type heSolidThermo; mixture pureMixture; transport constIso; thermo hConst; equationOfState rhoConst;
specie specie; energy sensibleEnthalpy; }}
mixture {{ specie {{ molWeight 1; }} transport {{ kappa {}; }} thermodynamics {{ Hf 0; Cp 1; }} equationOfState {{ rho 1; }} }}"""
COUPLED = "compressible::turbulentTemperatureCoupledBaffleMixed; Tnbr T; kappaMethod solidThermo; value uniform 300;"
START = 300.0  # K: OpenFOAM takes no temperatures about 0


class Case(harness.Case):
    """`surface` has the solids "inner" and "outer", where each ends, and "interface", with normals out of the inner one.
    `places`: a point in each. `temperatures`, functions of points by region, and `flow`, the vectors of heat flow; as if not turned."""

    def __init__(self, *of, places, conductivities, temperatures, flow):
        super().__init__(*of, None, layers=False)
        self.places, self.conductivities, self.temperatures, self.flow = np.array(places), conductivities, temperatures, flow

    def row(self, mesher, size, variant):
        turn = harness.rotation(harness.TURNS.get(variant, 0))
        surface, began = harness.turned(self.surface, turn), harness.seconds_used()
        with tempfile.TemporaryDirectory() as folder:
            if mesher == harness.OURS:
                ours(surface, size, folder, harness.grid_moved(surface, size) if variant == harness.MOVED else {})
            else:
                theirs(surface, size, folder, self.places @ turn.T)
            seconds = harness.seconds_used() - began
            parts = [foam.Files(folder, region) for region in REGIONS]
            figures = harness.tried(lambda: self.errors(pathlib.Path(folder), parts, turn))
        return {"mesher": mesher, "size": size, "variant": variant, "cells": int(sum(part.cells for part in parts)), "figures": figures,
                "seconds of the mesh": round(seconds, 2), "seconds": round(harness.seconds_used() - began, 2)}

    def errors(self, folder, parts, turn):
        exactly = [lambda p, of=of: of(p @ turn) for of in self.temperatures]
        solve(folder, parts, exactly, self.conductivities)
        found = [foam.read_field(folder, SWEEPS, f"{region}/T") - START for region in REGIONS]
        span = np.ptp(np.concatenate([of(Walls(files).feet) for of, files in zip(exactly, parts)]))
        off = np.concatenate([np.abs(values - of(files.centres())) for values, of, files in zip(found, exactly, parts)]) / span
        walls = [Walls(files, name) for files, name in zip(parts, ("inner_to_outer", "outer_to_inner"))]
        (low, near), (high, beyond) = (
            (values[wall.owner], wall.height / conductivity) for values, wall, conductivity in zip(found, walls, self.conductivities))
        wall = walls[0]
        flow = (low - high) / (near + beyond)
        exact_flow = np.einsum("ij,ij->i", self.flow(wall.at @ turn) @ turn.T, wall.normals)
        mean = np.average(exact_flow, weights=wall.sizes)
        return {"mean error": float(np.average(off, weights=np.concatenate([files.volumes() for files in parts]))),
                "largest error": float(off.max()),
                "heat flow": float(np.average(flow, weights=wall.sizes) / mean - 1),
                "flow by face": float(np.average(np.abs(flow - exact_flow), weights=wall.sizes) / abs(mean))}


def ours(surface, size, folder, properties):
    interface = surface.of([INTERFACE], INTERFACE).corners
    blocks = []
    for region, shared in zip(REGIONS, (interface, interface[:, ::-1])):
        corners = np.concatenate([surface.corners[surface.solids == surface.names.index(region)], shared])
        blocks.append(simple.TrivialProducer())
        data = polydata(corners.reshape(-1, 3), np.arange(3 * len(corners)).reshape(-1, 3))
        blocks[-1].SMProxy.GetClientSideObject().SetOutput(data)
    both = simple.GroupDatasets(Input=blocks, BlockNames=list(REGIONS))
    mesher = simple.CartesianMesher(Input=both, RegionsFrom="Blocks", CellSize=size, NumberOfThreads=1, **properties)
    foam.save(simple.OutputPort(mesher, "Mesh"), folder)


def theirs(surface, size, folder, places):
    """Both sides of a zone of faces, split into a mesh of each."""
    folder = pathlib.Path(folder)
    walls = surface.of(list(REGIONS), "surface")
    low, high = walls.bounds()
    cells = ((high - low) / size).astype(int) + 2
    low = low - size / 2
    snappy.write_case(folder, low.tolist(), (low + size * cells).tolist(), cells.tolist(), places.tolist(), features=True)
    for name, part in ("surface", walls), (INTERFACE, surface.of([INTERFACE], INTERFACE)):
        part.write(folder / "constant" / "triSurface" / f"{name}.stl")
    path = folder / "system" / "snappyHexMeshDict"
    text = path.read_text()
    for region in REGIONS:
        text = text.replace(" none)", f" {region})", 1)
    for before, added in (("geometry {", " interface.stl { type triSurfaceMesh; name interface; }"),
            ("refinementSurfaces {", " interface { level (0 0); }"), ("features (", '{ file "interface.eMesh"; level 0; } ')):
        text = text.replace(before, before + added)
    path.write_text(text)
    path = folder / "system" / "surfaceFeatureExtractDict"
    text = path.read_text()
    path.write_text(text + text[text.index("surface.stl"):].replace("surface.stl", "interface.stl"))
    for command in "blockMesh", "surfaceFeatureExtract", "snappyHexMesh -overwrite", "splitMeshRegions -cellZones -overwrite":
        foam.run(folder, *command.split())


def solve(folder, parts, temperatures, conductivities):
    foam.write(folder, "constant/g", "dimensions [0 1 -2 0 0 0 0]; value (0 0 0);", "uniformDimensionedVectorField")
    foam.write(folder, "constant/regionProperties", f"regions ( fluid () solid ({' '.join(REGIONS)}) );")
    foam.control(folder, SWEEPS)
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", "")
    for region, files, temperature, conductivity in zip(REGIONS, parts, temperatures, conductivities):
        foam.write(folder, f"system/{region}/fvSchemes", SCHEMES)
        foam.write(folder, f"system/{region}/fvSolution", SOLUTION)
        foam.write(folder, f"constant/{region}/thermophysicalProperties", SOLID.format(conductivity))
        foam.write(folder, f"constant/{region}/radiationProperties", "radiation off; radiationModel none;")
        walls = [name for name, (kind, _, _) in files.patches.items() if kind != "mappedWall"]
        foam.write_field(folder, f"{region}/T", "[0 0 0 1 0 0 0]", str(START), {
            '".*"': "zeroGradient;", '".*_to_.*"': COUPLED, **exact(files, walls, lambda p: START + temperature(p))})
        foam.write_field(folder, f"{region}/p", "[1 -1 -2 0 0 0 0]", "1e5", {'".*"': "calculated; value uniform 1e5;"})
    foam.run(folder, "chtMultiRegionSimpleFoam")
