# SPDX-License-Identifier: BSD-3-Clause
"""OpenFOAM's snappyHexMesh: the case that it needs, with the defaults of its tutorials."""

import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "Plugin"))
import foam  # noqa: E402

QUALITY = """
    maxNonOrtho 65; maxBoundarySkewness 20; maxInternalSkewness 4; maxConcave 80; minVol 1e-30;
    minTetQuality 1e-30; minArea -1; minTwist 0.02; minDeterminant 0.001; minFaceWeight 0.05;
    minVolRatio 0.01; minTriangleTwist -1; nSmoothScale 4; errorReduction 0.75;
    relaxed { maxNonOrtho 75; minTetQuality -1e30; }"""

LAYERS = """
    nGrow 0; featureAngle 60; nRelaxIter 3; nSmoothSurfaceNormals 1; nSmoothNormals 3;
    slipFeatureAngle 30; nRelaxedIter 20; nSmoothThickness 10; maxFaceThicknessRatio 0.5; maxThicknessToMedialRatio 0.3;
    minMedialAxisAngle 90; nBufferCellsNoExtrude 0; nLayerIter 50;"""


# Of the block, by its corners: low and high x, y, z.
SIDES = "(0 4 7 3)", "(1 2 6 5)", "(0 1 5 4)", "(3 7 6 2)", "(0 3 2 1)", "(4 5 6 7)"


def write_block(folder, low, high, cells, sides=()):
    """The background: a box of equal cells. `sides`: names of its sides, or none."""
    corners = "".join(f"({x} {y} {z})\n" for z in (low[2], high[2])
        for x, y in ((low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])))
    boundary = "".join(f"{name} {{ type patch; faces ({' '.join(face for of, face in zip(sides, SIDES) if of == name)}); }}\n"
        for name in dict.fromkeys(sides))
    foam.write(folder, "system/blockMeshDict", f"""
        vertices ({corners});
        blocks (hex (0 1 2 3 4 5 6 7) ({cells[0]} {cells[1]} {cells[2]}) simpleGrading (1 1 1));
        boundary ({boundary});""")


def write_case(folder, low, high, cells, inside, level=0, regions=(), features=False, layers=None, sides=(), fine=(), between=1,
               zone=None):
    """For constant/triSurface/surface.stl. `inside`: a point in each part to mesh; `regions`: the names of
    the file's solids, if these shall be patches; `features`: whether to snap to surface.eMesh beside it,
    which surfaceFeatureExtract writes; `layers`: how many on all but inlets, outlets and symmetry planes, their ratio, and the height
    of the first; `fine`: the regions that have the level, if not all; `between`: cells of one size before the next; `zone`: a box
    (low, high) and its level."""
    write_block(folder, low, high, cells, sides)
    foam.write(folder, "system/controlDict", f"""
        application snappyHexMesh; startFrom startTime; startTime 0; stopAt endTime; endTime 1; deltaT 1;
        writeControl timeStep; writeInterval 1; writePrecision 17;
        writeFormat {"ascii" if features else "binary"};""")
    foam.write(folder, "system/fvSchemes", "ddtSchemes {} gradSchemes {} divSchemes {} "
        "laplacianSchemes {} interpolationSchemes {} snGradSchemes {}")
    foam.write(folder, "system/fvSolution", "")
    foam.write(folder, "system/surfaceFeatureExtractDict", "surface.stl { extractionMethod "
        "extractFromSurface; extractFromSurfaceCoeffs { includedAngle 150; } writeObj no; }")
    points = [f"({p[0]!r} {p[1]!r} {p[2]!r})" for p in inside]
    where = f"locationInMesh {points[0]};" if len(points) == 1 else \
        f"locationsInMesh ({' '.join(f'({point} none)' for point in points)});"
    edges = f'{{ file "surface.eMesh"; level {0 if fine else level}; }}' if features else ""
    named = f"regions {{ {' '.join(f'{name} {{ name {name}; }}' for name in regions)} }}" if regions else ""
    explicit = """nFeatureSnapIter 10; implicitFeatureSnap false; explicitFeatureSnap true;
        multiRegionFeatureSnap true;""" if features else ""
    count, ratio, first = layers or (0, 1, 0)
    walls = [name for name in regions if not name.startswith(("inlet", "outlet", "symmetry"))] if regions else ['"surface.*"']
    refined = f"level (0 0); regions {{ {' '.join(f'{name} {{ level ({level} {level}); }}' for name in fine)} }}" if fine else \
        f"level ({level} {level});"
    box = "zone { type searchableBox; min (%r %r %r); max (%r %r %r); }" % (*zone[0], *zone[1]) if zone else ""
    boxed = f"zone {{ mode inside; levels ((1e15 {zone[2]})); }}" if zone else ""
    thick = " ".join(f"{wall} {{ nSurfaceLayers {count}; }}" for wall in walls)
    foam.write(folder, "system/snappyHexMeshDict", f"""
        castellatedMesh true; snap true; addLayers {str(count > 0).lower()};
        geometry {{ surface.stl {{ type triSurfaceMesh; name surface; {named} }} {box} }}
        castellatedMeshControls
        {{
            maxLocalCells 100000000; maxGlobalCells 100000000; minRefinementCells 10;
            nCellsBetweenLevels {between}; resolveFeatureAngle 30; allowFreeStandingZoneFaces true;
            features ({edges}); refinementRegions {{ {boxed} }}
            refinementSurfaces {{ surface {{ {refined} }} }}
            {where}
        }}
        snapControls {{ nSmoothPatch 3; tolerance 2.0; nSolveIter 30; nRelaxIter 5; {explicit} }}
        addLayersControls
        {{
            relativeSizes false; layers {{ {thick} }} expansionRatio {ratio};
            firstLayerThickness {first}; minThickness {0.2 * first}; {LAYERS}
        }}
        meshQualityControls {{ {QUALITY} }}
        mergeTolerance 1e-6;""")
