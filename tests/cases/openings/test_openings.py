"""Conditions that users put at an opening work with explicitCompressible, or are
refused by their names; with and without sources of momentum."""

import re
import shutil

import pytest
from foamcase import FoamCase

PISTON = (
    "left { type acousticPiston; velocityAmplitude 0.02; frequency 1400;"
    " value uniform (0 0 0); }"
)
WAVE = "type waveTransmissive; psi thermo:psi; gamma 1.4;"
PRESSURE = f"{WAVE} fieldInf 101325; lInf 10; value uniform 101325;"
AMBIENT = "type fixedValue; value uniform 101325;"
ZERO = "value uniform (0 0 0);"
FLOW = "type zeroGradient;"

PUSH = """FoamFile { version 2.0; format ascii; class dictionary; object fvOptions; }
push
{
    type vectorSemiImplicitSource; active %s; selectionMode all;
    volumeMode specific; injectionRateSuSp { U ((100 0 0) 0); }
}
"""


@pytest.fixture(scope="module", name="tube")
def fixture_tube(tmp_path_factory):
    case = FoamCase("standingWaveTube", tmp_path_factory.mktemp("tube")/"case")
    case.replace(
        "constant/acousticProperties", r"(?s)sound\s*\{.*\}",
        "sound { type explicitCompressible; frequency 1400; }",
    )
    case.replace("system/controlDict", "10.0/", "0.25/")
    case.replace(
        "system/controlDict", r"writeInterval +\$stepsPerPeriod",
        "writeInterval 50",
    )
    case.replace("system/controlDict", r"(?s)functions\s*\{.*\n\}", "")
    case.replace("0/U", r"left\s*\{[^}]*\}", PISTON)
    case.run("blockMesh")
    return case


def solve(tube, directory, p, U, T=FLOW, options=None, status=0):
    case = FoamCase.__new__(FoamCase)
    case.path = directory
    shutil.copytree(tube.path, directory, ignore=shutil.ignore_patterns("log.*"))
    for field, condition in (("p", p), ("U", U), ("T", T)):
        case.replace(
            f"0/{field}", r"right\s*\{[^}]*\}", f"right {{ {condition} }}"
        )
    if options:
        case.write("constant/fvOptions", PUSH % options)
    log = " ".join(case.run("acousticDEMFoam", status=status).split())
    assert "printStack" not in log
    return case, log


@pytest.mark.parametrize("p, U, T", [
    (AMBIENT, f"type pressureInletOutletVelocity; {ZERO}",
     "type inletOutlet; inletValue uniform 293.15; value uniform 293.15;"),
    ("type totalPressure; p0 uniform 101325; value uniform 101325;",
     f"type inletOutlet; inletValue uniform (0 0 0); {ZERO}",
     "type totalTemperature; gamma 1.4; T0 uniform 293.15;"
     " value uniform 293.15;"),
    (AMBIENT, f"type freestream; freestreamValue uniform (0 0 0); {ZERO}", FLOW),
    (PRESSURE, f"type advective; {ZERO}", FLOW),
])
def test_openings_work(tmp_path, tube, p, U, T):
    solve(tube, tmp_path/"case", p, U, T)


@pytest.mark.parametrize("p, U, names", [
    ("type freestreamPressure; freestreamValue uniform 101325;"
     " value uniform 101325;", FLOW, ("freestreamPressure of p", "not finite")),
    (f"type advective; {'value uniform 101325;'}", FLOW, ("advective", "of p")),
    (AMBIENT, f"type mappedVelocityFluxFixedValue; phi flux; {ZERO}",
     ("mappedVelocityFluxFixedValue",)),
    (AMBIENT, f"type inletOutlet; phi flux; inletValue uniform (0 0 0); {ZERO}",
     ("inletOutlet of U at the patch right", "flux")),
])
def test_others_are_refused_by_name(tmp_path, tube, p, U, names):
    log = solve(tube, tmp_path/"case", p, U, status=1)[1]
    for name in names:
        assert name in log


def test_sources_act_at_a_radiating_end(tmp_path, tube):
    """And one that is not active changes nothing, to the bit."""
    def velocity(name, options, U):
        case = solve(tube, tmp_path/name, PRESSURE, U, options=options)[0]
        last = max(
            (d for d in case.path.iterdir() if re.fullmatch(r"[\d.e-]+", d.name)),
            key=lambda d: float(d.name),
        )
        return (last/"U").read_text().split("boundaryField")[0]

    wave = f"{WAVE} {ZERO}"
    none = velocity("none", None, wave)
    assert velocity("no", "no", wave) == none
    pushed = velocity("yes", "yes", wave)
    assert pushed != none
    # The condition of the velocity does not matter where the sound goes out
    assert velocity("zeroGradient", "yes", FLOW) == pushed
