"""Layers in several regions: each has its own on its side of an interface, whose faces stay the same for both."""

import tempfile

import numpy as np
from paraview import simple
from vtkmodules.util.numpy_support import vtk_to_numpy

import foam
from pipeline import Messages

GAS, SOLID = 0.5, 7.5  # volumes of a duct through a block, and of what is left of that
COUNT = 3


def box(low, high):
    source = simple.Box(XLength=high[0] - low[0], YLength=high[1] - low[1], ZLength=high[2] - low[2],
                        Center=[(a + b) / 2 for a, b in zip(low, high)])
    return simple.Triangulate(Input=source)


assembly = simple.GroupDatasets(BlockNames=["gas", "solid"],
    Input=[box([-0.25, -0.25, -1], [0.25, 0.25, 1]), box([-1, -1, -1], [1, 1, 1])])


def mesher(**properties):
    return simple.CartesianMesher(Input=assembly, RegionsFrom="Blocks", CellSize=0.13, Layers=COUNT, **properties)


def arrays(filter, *names):
    data = filter.GetOutputDataObject(0).GetCellData()
    return [vtk_to_numpy(data.GetArray(name)) for name in names]


def check(proxy, with_layers):
    proxy.UpdatePipeline()
    filter = proxy.GetClientSideObject()
    region, number, layer = arrays(filter, "Region", "CellId", "Layer")
    assert sorted(number) == list(range(len(number)))
    assert set(region[layer > 0]) == set(with_layers), set(region[layer > 0])
    # The cells at the interface are those of the wall's layers, where there are any.
    data = filter.GetOutputDataObject(3).GetCellData()
    of = np.argsort(number)
    for side in "Owner", "Neighbour":
        cells, regions = (vtk_to_numpy(data.GetArray(side + name)) for name in ("Cell", "Region"))
        assert len(cells) > 0 and (region[of[cells]] == regions).all()
        has = np.isin(regions, with_layers)
        share = (layer[of[cells]] == np.where(has, 1, 0)).mean()
        assert share > 0.95, (side, share)
    coverage = filter.GetOutputDataObject(0).GetFieldData().GetArray("LayerCoverage").GetValue(0)
    assert coverage > 0.85, coverage  # ends of layers do not count
    between = []
    with tempfile.TemporaryDirectory() as folder:
        foam.save(proxy, folder)
        for name, exact in ("gas", GAS), ("solid", SOLID):
            files = foam.Files(folder, name)
            files.check()
            assert abs(files.volumes().sum() - exact) < 1e-5, files.volumes().sum()
            between += [count for patch, (kind, _, count) in files.patches.items() if kind == "mappedWall"]
            measured = foam.CheckMesh(folder, "-region", name)
            assert measured.ok, measured.text
    assert len(between) == 2 and between[0] == between[1] == len(cells), between
    print(f"{len(number)} cells, {(layer > 0).sum()} of layers, {coverage:.4g} covered")


check(mesher(), [1, 2])
check(mesher(LayerRegions=["gas"]), [1])
check(mesher(LayerRegions=["solid"]), [2])

with Messages() as said:
    mesher(LayerRegions=["air"]).UpdatePipeline()
assert '"air", which is not a region: choose from gas, solid.' in str(said), str(said)
