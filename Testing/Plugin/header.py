"""On demand: gas and solid of the exhaust header as two regions, as an OpenFOAM case that is then checked.

    pvpython Testing/Plugin/header.py FOLDER_OF_SURFACES CELL_SIZE [DEPTH]
"""

import pathlib
import sys
import tempfile

from paraview import simple

import foam

surfaces, size = pathlib.Path(sys.argv[1]), float(sys.argv[2])
depth = int(sys.argv[3]) if len(sys.argv) > 3 else 0
gas, solid = (simple.NamedSTLReader(FileName=str(surfaces / f"kcl_exhaust_header_{name}.stl"))
              for name in ("lumens", "fused"))
both = simple.GroupDatasets(Input=[gas, solid], BlockNames=["gas", "solid"])
mesher = simple.CartesianMesher(Input=both, RegionsFrom="Blocks", ContactTolerance=2, CellSize=size,
                                RefinementDepth=depth)
with tempfile.TemporaryDirectory() as folder:
    folder = foam.save(simple.OutputPort(mesher, "Mesh"), folder)
    for region in "gas", "solid":
        check = foam.CheckMesh(folder, "-region", region)
        print(region, check.figures, *check.failures, "Mesh OK" if check.ok else "FAILED", sep="\n  ")
