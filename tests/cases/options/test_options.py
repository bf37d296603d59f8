"""Every option of the manual that no other case uses is read, and acts."""

import re

import numpy as np
import pytest


def pairs(primaries):
    """Pairs of particles that meet in the first step, off their centres."""
    rows = []
    beside = 1.9e-6 if primaries == 1 else 3.5e-6
    for i in range(12):
        x, y, z = 0.0613 - 2e-4 + 5e-5*(i % 6), -5e-5 + 1e-4*(i//6), 0
        for side in (-1, 1):
            rows.append(
                f"{{ position ({x + 2.7e-6*side:.9g} {y + beside*side:.9g} {z});"
                f" diameter 5e-6; velocity ({-0.3*side} 0 0);"
                f" primaries {primaries}; }}"
            )
    return "density 2300;\nsource list;\nparticles\n(" + "\n".join(rows) + "\n);"


def run(box, changes=(), sound=None, steps=4):
    """A few steps; changes are (dictionary, its new contents)."""
    box.control("endTime", f"#eval{{ {steps}.0/($frequency*$stepsPerPeriod) }}")
    box.control("writeInterval", str(steps))
    box.aerosol("numberConcentration", "4e11")
    for name, text in changes:
        file = box.path/"constant"/"aerosolProperties"
        if re.search(rf"(?m)^{name}$", file.read_text()):
            box.model(name, text)
        else:
            box.write(
                "constant/aerosolProperties",
                file.read_text() + f"\n{name}\n{{\n{text}\n}}\n",
            )
    if sound:
        box.replace(
            "constant/acousticProperties", r"(?s)sound\s*\{.*\}",
            f"sound {{ {sound} }}",
        )
    before = len(box.times())
    log = box.run("acousticDEMFoam")
    assert "\nEnd\n" in log and len(box.times()) > before
    return box.cloud(box.times()[-1]), log


WAVE = "type standingWave; frequency 1400; SPL 147;"
SPHERES = "type equivalentSphere;"
FRACTAL = "type fractal; dimension 1.8;"
JKR = "bond { type JKR; workOfAdhesion 1e-9; }"
RUMPF = "bond { type Rumpf; HamakerConstant 1e-25;"


@pytest.mark.parametrize("name, one, other", [
    ("contact", "type coalescence; surfaceTension 0.0728;",
     "type coalescence; surfaceTension 1e-9;"),
    ("aggregate", FRACTAL, f"{FRACTAL} prefactor 3;"),
    ("aggregate", FRACTAL, f"{FRACTAL} mobilityExponent 0.6;"),
    ("contact", "type probability; sticking 0.1; restitution 0.9;",
     "type probability; sticking 0.1; restitution 0.9; slowest 1;"),
    ("contact", "type probability; sticking 0.5; restitution 0.9;",
     "type probability; sticking 0.5; restitution 0.9; seed 2;"),
    ("timeStepping", "type eventDriven;", "type eventDriven; resolution 0.05;"),
    ("turbulence", "type syntheticTurbulence; dissipation 10;",
     "type syntheticTurbulence; dissipation 10; seed 3;"),
    ("turbulence", "type syntheticTurbulence; shearRate 2000;",
     "type syntheticTurbulence; shearRate 2000; timeScale 1e-3;"),
    ("turbulence", "type syntheticTurbulence; shearRate 2000;",
     "type syntheticTurbulence; shearRate 2000; wavelength 0.25e-3;"),
    ("Brownian", "type OrnsteinUhlenbeck;", "type OrnsteinUhlenbeck; seed 5;"),
    ("unsteadyDrag", "type Basset;",
     "type Basset; frequencies (500 50000);"),
])
def test_an_option_acts(box, tmp_path, meshed, name, one, other):
    # Contacts need particles that meet; aggregates have primaries
    meet = (
        [("particles", pairs(20 if name == "aggregate" else 1))]
        if name in ("contact", "aggregate", "timeStepping") else []
    )
    a = run(box, [*meet, (name, one)])[0]
    again = type(box)(tmp_path/"other", meshed)
    b = run(again, [*meet, (name, other)])[0]
    assert len(a["id"]) != len(b["id"]) or not np.array_equal(
        a["position"], b["position"]
    )


@pytest.mark.parametrize("text", [
    f"type drag; fragments erosion; {JKR}",
    f"type drag; fragments two; share 0.3; {RUMPF} asperity 5e-9;"
    " separation 1e-9; }",
    f"type shear; fragments erosion; {RUMPF} }}",
    "type impact; fragments two; factor 5; bond { type JKR; workOfAdhesion 0.05;"
    " YoungsModulus 70e9; PoissonRatio 0.2; }",
    "type none;",
])
def test_breakage_of_every_kind(box, text):
    run(box, [("breakage", text), ("report", "breakages yes; contacts yes;")])


@pytest.mark.parametrize("more", [
    "phase 0.5;", "origin (0.01 0 0);", "velocity (0.2 0 0);",
    "gas { meanFreePath 1e-6; }", "gas { mu 3e-5; }", "direction (1 1 0);",
])
def test_a_wave_has_these(box, tmp_path, meshed, more):
    a = run(box, sound=WAVE)[0]
    b = run(type(box)(tmp_path/"other", meshed), sound=f"{WAVE} {more}")[0]
    assert not np.array_equal(a["U"], b["U"])


def test_reports_as_often_as_is_asked_for(box):
    box.replace(
        "system/controlDict", "runTimeModifiable",
        "reportInterval 0;\n\nrunTimeModifiable",
    )
    log = run(box, steps=8)[1]
    assert len(re.findall(r"(?m)^Time = ", log)) == 8
