# SPDX-License-Identifier: BSD-3-Clause
"""Turbulent flow of air through the four ducts of the exhaust header, by OpenFOAM and by Code_Saturne, from the files that are written
for each: the same equations, conditions and mesh. Needs Debian's package code-saturne-bin."""

import pathlib
import tempfile

import numpy as np
from paraview import simple

import harness  # before what it finds
import foam
from ducts import DUCTS
from wallflow import SCHEMES, SOLUTION, set_types, start_potential
from wallsurfaces import HEADER, load

SATURNE_FOLDER = pathlib.Path("/usr/lib/code_saturne")
SATURNE = "by Code_Saturne"
SPEED, VISCOSITY, DIAMETER = 20.0, 1.5e-5, 0.037  # in m; in mm Code_Saturne 6 diverges, whose limits have units
MM = 1000
ITERATIONS = 400
SATURNE_ITERATIONS, RELAXATION = 150, 0.7  # afterwards changes are less than 1e-4
# At inlets: those of a pipe, as Code_Saturne has them for a hydraulic diameter.
FRICTION = (1.8 * np.log10(SPEED * DIAMETER / VISCOSITY) - 1.64) ** -2 * SPEED ** 2 / 8
K, EPSILON = float(FRICTION / 0.3), float(FRICTION ** 1.5 / (0.42 * DIAMETER * 0.1))


class Header(harness.Case):
    """And each of our meshes by Code_Saturne."""

    def jobs(self, quick):
        yield from (job for job in super().jobs(quick) if job[2] in (harness.AS_IT_IS, harness.LAYERED))
        for size in self.sizes[:-1] if quick else self.sizes:
            yield harness.OURS, size, SATURNE

    def row(self, mesher, size, variant):
        if variant != SATURNE:
            return super().row(mesher, size, variant)
        began = harness.seconds_used()
        with tempfile.TemporaryDirectory() as name:
            mesher, folder = simple.CartesianMesher(Input=simple.OpenDataFile(str(HEADER)), CellSize=size), pathlib.Path(name)
            metres = simple.Transform(Input=simple.OutputPort(mesher, "Mesh"))
            metres.Transform.Scale = [1 / MM] * 3
            simple.SaveData(str(folder / "header.case"), metres)
            files = foam.Files(foam.save(metres, folder / "openfoam"))
            figures = harness.tried(lambda: drops(files, saturne(folder, files)))
        return {"mesher": harness.OURS, "size": size, "variant": variant, "cells": int(files.cells), "figures": figures,
                "seconds of the mesh": 0.0, "seconds": round(harness.seconds_used() - began, 2)}


def drops(files, pressure):
    """Of each duct: between the cells at its inlet and those at its outlet, weighted by the faces' areas."""
    areas = np.linalg.norm(files.face_centres()[1], axis=1)

    def mean(name):
        faces = files.of_patch(name)
        return np.average(pressure[files.owner[faces]], weights=areas[faces])

    return {f"drop {duct}": float(mean(inlet) - mean(outlet)) for duct, (_, inlet, outlet) in enumerate(DUCTS, 1)}


def openfoam(files, _):
    """With lengths in mm, which it does not mind: speeds and pressures are the same."""
    folder = files.folder.parents[1]
    set_types(folder, [end for _, *ends in DUCTS for end in ends])

    def field(name, dimensions, start, *conditions):
        foam.write_field(folder, name, dimensions, str(start), {
            patch: f"{condition.format(start)};" for duct in DUCTS for patch, condition in zip(duct, conditions)})

    none, fixed, zero = "zeroGradient", "fixedValue; value uniform {0}", "; value uniform 0"
    back = "inletOutlet; inletValue uniform {0}; value uniform {0}"
    field("U", "[0 1 -1 0 0 0 0]", "(0 0 0)", "noSlip", f"surfaceNormalFixedValue; refValue uniform {-SPEED}", back)
    field("p", "[0 2 -2 0 0 0 0]", 0, none, none, fixed)
    field("k", "[0 2 -2 0 0 0 0]", K, "kqRWallFunction; value uniform {0}", fixed, back)
    field("epsilon", "[0 2 -3 0 0 0 0]", EPSILON / MM, "epsilonWallFunction; value uniform {0}", fixed, back)
    field("nut", "[0 2 -1 0 0 0 0]", 0, "nutkWallFunction" + zero, "calculated" + zero, "calculated" + zero)
    foam.write(folder, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY * MM};")
    foam.write(folder, "constant/turbulenceProperties", "simulationType RAS; RAS { RASModel kEpsilon; turbulence on; printCoeffs off; }")
    foam.write(folder, "system/fvSchemes", SCHEMES)
    foam.write(folder, "system/fvSolution", SOLUTION)
    foam.control(folder, ITERATIONS)
    start_potential(folder)
    foam.run(folder, "simpleFoam")
    return drops(files, foam.read_field(folder, ITERATIONS, "p"))


def saturne(folder, files):
    """The cells' pressures. They are numbered as in the file."""
    foam.run(folder, str(SATURNE_FOLDER / "cs_preprocess"), "header.case")
    (folder / "setup.xml").write_text(setup(files))
    foam.run(folder, str(SATURNE_FOLDER / "cs_solver"))
    values = foam.run(folder, str(SATURNE_FOLDER / "cs_io_dump"), "--extract", "--section", "pressure::vals::0", "checkpoint/main")
    pressure = np.array(values.split(), float)
    assert len(pressure) == files.cells
    return pressure


def setup(files):
    """Code_Saturne's setup.xml: standard k-epsilon, second order. A part's number is its group."""
    zones, conditions = "", ""
    for number, name in enumerate(files.patches, 1):
        kind = {"wall": "wall", "inlet": "inlet", "outlet": "imposed_p_outlet"}[name.partition("_")[0]]
        zones += f'<boundary label="{name}" name="{number}" nature="{kind}">{number + 1}</boundary>'
        conditions += f'<{kind} field_id="none" label="{name}">' + {
            "wall": '<velocity_pressure choice="off"/>',
            "inlet": f'<velocity_pressure choice="norm" direction="normal"><norm>{SPEED}</norm></velocity_pressure>'
                     f'<turbulence choice="hydraulic_diameter"><hydraulic_diameter>{DIAMETER}</hydraulic_diameter></turbulence>',
            "imposed_p_outlet": '<dirichlet name="pressure">0</dirichlet>'}[kind] + f"</{kind}>"
    properties = "".join(
        f'<property choice="constant" label="{name}" name="{name}"><initial_value>{value}</initial_value></property>'
        for name, value in (("density", 1.0), ("molecular_viscosity", VISCOSITY)))
    return f"""<?xml version="1.0" encoding="utf-8"?>
<Code_Saturne_GUI case="header" study="header" version="2.0">
<analysis_control>
 <output><listing_printing_frequency>1</listing_printing_frequency></output>
 <time_parameters>
  <iterations>{SATURNE_ITERATIONS}</iterations><time_passing>-1</time_passing>
  <relaxation_coefficient>{RELAXATION}</relaxation_coefficient>
 </time_parameters>
</analysis_control>
<boundary_conditions>{zones}{conditions}</boundary_conditions>
<numerical_parameters>
 <gradient_reconstruction choice="2"/><velocity_pressure_algo choice="simple"/>
</numerical_parameters>
<physical_properties><fluid_properties>{properties}</fluid_properties>
 <gravity><gravity_x>0</gravity_x><gravity_y>0</gravity_y><gravity_z>0</gravity_z></gravity>
</physical_properties>
<solution_domain><volumic_conditions>
 <zone id="1" initialization="on" label="all_cells">all[]</zone>
</volumic_conditions></solution_domain>
<thermophysical_models>
 <thermal_scalar model="off"/>
 <turbulence model="k-epsilon">
  <initialization choice="reference_value" zone_id="1"/>
  <reference_velocity>{SPEED}</reference_velocity>
  <variable label="k" name="k"/><variable label="epsilon" name="epsilon"/>
 </turbulence>
 <velocity_pressure>
  <variable label="Pressure" name="pressure"><rhs_reconstruction>2</rhs_reconstruction></variable>
  <variable dimension="3" label="Velocity" name="velocity">
   <blending_factor>1</blending_factor><order_scheme choice="solu"/><slope_test status="off"/>
  </variable>
 </velocity_pressure>
</thermophysical_models>
</Code_Saturne_GUI>
"""


CASE = Header("runners", "Air through the exhaust header's ducts",
    "Four ducts 37 mm wide, air at 20 m/s, standard k-epsilon with wall functions, second order for velocity; the pressure drop in "
    "each duct in Pa for a density of 1 kg/m3. Each solver is the reference for the other.",
    load(str(HEADER)), (6.0, 4.5, 3.5), openfoam, layers=False, kind="values")

if __name__ == "__main__":
    harness.run(CASE)
