"""On demand: the gas of the exhaust header, and gas and solid as two regions, as OpenFOAM cases that are then checked.

    pvpython Testing/Plugin/header.py FOLDER_OF_SURFACES CELL_SIZE [DEPTH]
"""

import pathlib
import sys
import tempfile
import time

from paraview import simple

import foam

surfaces, size = pathlib.Path(sys.argv[1]), float(sys.argv[2])
depth = int(sys.argv[3]) if len(sys.argv) > 3 else 0
gas, solid = (simple.NamedSTLReader(FileName=str(surfaces / f"kcl_exhaust_header_{name}.stl"))
              for name in ("lumens", "fused"))


def report(folder, *options):
    check = foam.CheckMesh(folder, *options)
    print(check.figures, *check.failures, "Mesh OK" if check.ok else "FAILED", sep="\n  ")


alone = simple.CartesianMesher(Input=gas, CellSize=size, RefinementDepth=depth, NumberOfThreads=1)
gas.UpdatePipeline()
began = time.process_time()
alone.UpdatePipeline()
fields = alone.GetClientSideObject().GetOutputDataObject(0).GetFieldData()
marching, exact = (fields.GetArray(f"BoxesBy{method}").GetValue(0) for method in ("MarchingCubes", "ExactFit"))
print(f"gas alone, {time.process_time() - began:.1f} s of CPU, Marching Cubes in {100 * marching / (marching + exact):.0f} % of the boxes cut")
with tempfile.TemporaryDirectory() as folder:
    report(foam.save(simple.OutputPort(alone, "Mesh"), folder))

both = simple.GroupDatasets(Input=[gas, solid], BlockNames=["gas", "solid"])
mesher = simple.CartesianMesher(Input=both, RegionsFrom="Blocks", ContactTolerance=2, CellSize=size,
                                RefinementDepth=depth)
with tempfile.TemporaryDirectory() as folder:
    folder = foam.save(simple.OutputPort(mesher, "Mesh"), folder)
    for region in "gas", "solid":
        print(region)
        report(folder, "-region", region)
