"""Laminar flow through the exhaust header by OpenFOAM and by Code_Saturne, each from the files that are written for it: the
same mesh, density, viscosity and inlet speed give the same pressure drop in each duct, to 1 %. On demand, as it takes
minutes (4, at 40,000 cells); needs Debian's packages openfoam and code-saturne-bin. Where a duct is five
boxes wide (8), the two differ by 3 %; where it is nine, the default, by less than 0.5 %.

    pvpython Testing/Plugin/saturne.py REPOSITORY FOLDER [CELL_SIZE]
"""

import pathlib
import re
import shutil
import sys

import numpy as np
from paraview import simple

import foam
from ducts import DUCTS, SPEED

SATURNE = pathlib.Path("/usr/lib/code_saturne")
VISCOSITY = 1e-3  # m2/s, at a density of 1 kg/m3: a Reynolds number of 37 in ducts of 37 mm
STEPS, RELAXATION = 120, 0.7  # of Code_Saturne: afterwards five digits of its pressures stay as they are


def setup(whole):
    """Code_Saturne's setup.xml: central differences everywhere, as here for OpenFOAM. A part's number is its group."""
    zones, conditions = "", ""
    for number, name in enumerate(whole.patches, 1):
        kind = {"wall": "wall", "inlet": "inlet", "outlet": "imposed_p_outlet"}[name.partition("_")[0]]
        zones += f'<boundary label="{name}" name="{number}" nature="{kind}">{number + 1}</boundary>'
        conditions += f'<{kind} field_id="none" label="{name}">' + {
            "wall": '<velocity_pressure choice="off"/>',
            "inlet": f'<velocity_pressure choice="norm" direction="normal"><norm>{SPEED}</norm></velocity_pressure>',
            "imposed_p_outlet": '<dirichlet name="pressure">0</dirichlet>'}[kind] + f"</{kind}>"
    properties = "".join(
        f'<property choice="constant" label="{name}" name="{name}"><initial_value>{value}</initial_value></property>'
        for name, value in (("density", 1.0), ("molecular_viscosity", VISCOSITY)))
    return f"""<?xml version="1.0" encoding="utf-8"?>
<Code_Saturne_GUI case="header" study="header" version="2.0">
<analysis_control>
 <output><listing_printing_frequency>1</listing_printing_frequency></output>
 <time_parameters>
  <iterations>{STEPS}</iterations><time_passing>-1</time_passing>
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
 <turbulence model="off"/>
 <velocity_pressure>
  <variable label="Pressure" name="pressure"><rhs_reconstruction>2</rhs_reconstruction></variable>
  <variable dimension="3" label="Velocity" name="velocity">
   <blending_factor>1</blending_factor><order_scheme choice="centered"/><slope_test status="off"/>
  </variable>
 </velocity_pressure>
</thermophysical_models>
</Code_Saturne_GUI>
"""


def saturne(folder, whole):
    """The cells' pressures. They are numbered as in the file."""
    foam.run(folder, str(SATURNE / "cs_preprocess"), "header.case")
    (folder / "setup.xml").write_text(setup(whole))
    foam.run(folder, str(SATURNE / "cs_solver"))
    values = foam.run(folder, str(SATURNE / "cs_io_dump"), "--extract", "--section", "pressure::vals::0", "checkpoint/main")
    pressure = np.array(values.split(), float)
    assert len(pressure) == whole.cells
    return pressure


def openfoam(case):
    """The cells' pressures."""
    velocity, pressure = {}, {}
    for wall, inlet, outlet in DUCTS:
        velocity |= {wall: "noSlip;", inlet: f"surfaceNormalFixedValue; refValue uniform {-SPEED};",
                     outlet: "zeroGradient;"}
        pressure |= {wall: "zeroGradient;", inlet: "zeroGradient;", outlet: "fixedValue; value uniform 0;"}
    foam.write_field(case, "U", "[0 1 -1 0 0 0 0]", "(0 0 0)", velocity)
    foam.write_field(case, "p", "[0 2 -2 0 0 0 0]", "0", pressure)
    foam.write(case, "constant/transportProperties", f"transportModel Newtonian; nu [0 2 -1 0 0 0 0] {VISCOSITY};")
    foam.write(case, "constant/turbulenceProperties", "simulationType laminar;")
    foam.write(case, "system/fvSchemes", """
ddtSchemes { default steadyState; } gradSchemes { default Gauss linear; }
divSchemes { default none; div(phi,U) bounded Gauss linear; div((nuEff*dev2(T(grad(U))))) Gauss linear; }
laplacianSchemes { default Gauss linear corrected; } interpolationSchemes { default linear; }
snGradSchemes { default corrected; }""")
    foam.write(case, "system/fvSolution", """
solvers
{
    p { solver GAMG; smoother GaussSeidel; tolerance 1e-12; relTol 0.05; }
    U { solver smoothSolver; smoother symGaussSeidel; tolerance 1e-12; relTol 0.1; }
}
SIMPLE { consistent yes; nNonOrthogonalCorrectors 1; residualControl { p 1e-6; U 1e-7; } }
relaxationFactors { equations { U 0.9; } }""")
    foam.control(case, 1000)
    text = foam.run(case, "simpleFoam")
    steps = re.search(r"SIMPLE solution converged in (\d+) iterations", text)
    assert steps, text[-2000:]
    return foam.read_field(case, steps[1], "p")


def drops(whole, pressure):
    """Of each duct: between the cells at its inlet and those at its outlet, weighted by the faces' areas."""
    areas = np.linalg.norm(whole.face_centres()[1], axis=1)

    def mean(name):
        faces = whole.of_patch(name)
        return np.average(pressure[whole.owner[faces]], weights=areas[faces])

    return np.array([mean(inlet) - mean(outlet) for _, inlet, outlet in DUCTS])


if __name__ == "__main__":
    folder = pathlib.Path(sys.argv[2])
    size = float(sys.argv[3]) if len(sys.argv) > 3 else 4.0
    surface = pathlib.Path(sys.argv[1]) / "Data/kcl_exhaust_header_lumens.stl"
    mesher = simple.CartesianMesher(Input=simple.OpenDataFile(str(surface)), CellSize=size)
    metres = simple.Transform(Input=simple.OutputPort(mesher, "Mesh"))
    metres.Transform.Scale = [0.001] * 3
    case = foam.save(metres, folder / "openfoam")
    shutil.rmtree(folder / "saturne", ignore_errors=True)
    (folder / "saturne").mkdir()
    simple.SaveData(str(folder / "saturne/header.case"), metres)
    whole = foam.Files(case)
    print(whole.cells, "cells", flush=True)
    ours, theirs = (drops(whole, pressure) for pressure in (openfoam(case), saturne(folder / "saturne", whole)))
    for duct, (a, b) in enumerate(zip(ours, theirs), 1):
        print(f"duct {duct}: OpenFOAM {a:.5f} Pa, Code_Saturne {b:.5f} Pa, {100 * (b / a - 1):+.2f} %")
    assert (np.abs(theirs / ours - 1) < 0.01).all()
