"""A rotor in a flow: a blade on a shaft in a zone, whose border the shaft passes through."""

from paraview import simple


def box(x, y, z):
    return simple.Triangulate(Input=simple.Box(XLength=x, YLength=y, ZLength=z))


def parts():
    """Surfaces by name; the axis is z."""
    rotor = simple.Transform(Input=simple.Triangulate(Input=simple.Cylinder(Radius=0.8, Height=1, Resolution=24)), Transform="Transform")
    rotor.Transform.Rotate = [90, 0, 0]
    return {"blade": box(1, 0.2, 0.4), "shaft": box(0.2, 0.2, 1.6), "rotor": rotor}


def fan(size=0.3):
    """In a box of edge 4."""
    surfaces = parts()
    blocks = simple.GroupDatasets(Input=list(surfaces.values()), BlockNames=list(surfaces))
    return simple.CartesianMesher(Input=blocks, Domain="Outside", BoxFrom="Bounds", DomainBounds=[-2, 2] * 3, BoxesAlongBody=0, CellSize=size,
                                  BoundaryNames=["rotor"], BoundaryTypes=["zone"])
