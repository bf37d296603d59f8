"""A box that stands for its surroundings: no place in it is special, and its
particles drift as they do in the sound."""

import re

import numpy as np
import pytest
from aerosolcase import AerosolCase
from foamcase import ROOT

STEP = 2**-17  # s
LENGTH, FREQUENCY = 0.1226, 1400
CENTRE = 0.0521  # between an antinode and a node, were it a standing wave

AEROSOL = f"""FoamFile
{{
    version 2.0; format ascii; class dictionary; object aerosolProperties;
}}
domain {{ type periodicBox; centre ({CENTRE} 5e-3 5e-3); length 0.3e-3; }}
particles
{{
    density 2300; source list; initialVelocity gas;
    particles
    (
        {{ position ({CENTRE - 1.4e-4} 5e-3 5e-3); diameter 0.3e-6; }}
        {{ position ({CENTRE} 5e-3 5e-3); diameter 0.3e-6; }}
        {{ position ({CENTRE + 1.4e-4} 5e-3 5e-3); diameter 0.3e-6; }}
    );
}}
timeStepping {{ type eventDriven; }}
drag {{ type Stokes; slipCorrection none; }}
gravity {{ type none; }}
wake {{ type none; }}
contact {{ type none; }}
aggregate {{ type none; }}
"""


def radiating_tube(directory, sound):
    """A wave from a piston to an end that lets it out, 147 dB."""
    case = AerosolCase(directory, ROOT/"tutorials/standingWaveTube")
    case.replace("constant/acousticProperties", r"(?s)sound\s*\{.*\}", sound)
    case.replace(
        "0/U", r"left\s*\{[^}]*\}",
        f"left {{ type acousticPiston; velocityAmplitude 1.5;"
        f" frequency {FREQUENCY}; rampPeriods 3; }}",
    )
    case.replace("0/U", r"right\s*\{[^}]*\}", "right { type zeroGradient; }")
    case.replace(
        "0/p", r"right\s*\{[^}]*\}",
        "right { type waveTransmissive; psi thermo:psi; gamma 1.4;"
        " fieldInf 101325; lInf 10; value uniform 101325; }",
    )
    case.write("constant/aerosolProperties", AEROSOL)
    case.replace(
        "system/controlDict", r"(?s)functions\s*\{.*\n\}",
        "functions { history { type probes; libs (sampling); fields (rho U);"
        f" probeLocations (({CENTRE} 0.005 0.005)); }} }}",
    )
    case.control("writeFormat", "ascii")
    case.control("writePrecision", "17")
    case.control("timePrecision", "16")
    case.control("deltaT", repr(1/(100*FREQUENCY)))
    case.control("writeInterval", "100")
    case.run("blockMesh")
    return case


def test_tracers_move_with_the_mean_flux_of_mass(tmp_path):
    """Mean velocity of the mass, <rho u>/<rho>, in a plane wave that is solved
    and in its replay: the mean velocity at the place, and Stokes' drift."""
    solve = (
        f"type explicitCompressible; frequency {FREQUENCY};"
        " velocityAmplitude 1.5;"
    )
    chamber = radiating_tube(
        tmp_path/"chamber",
        f"sound {{ type untilPeriodic; startTime {20/FREQUENCY!r};"
        f" solve {{ {solve} }} }}",
    )
    chamber.control("endTime", repr(22/FREQUENCY))
    chamber.run("acousticDEMFoam")

    solved = radiating_tube(tmp_path/"solved", f"sound {{ {solve} }}")
    solved.control("endTime", repr(24/FREQUENCY))
    solved.run("acousticDEMFoam")

    replayed = radiating_tube(
        tmp_path/"replayed",
        "sound { type replay; source \"../chamber\"; }",
    )
    replayed.replace("system/controlDict", r"functions.*", "")
    replayed.control("endTime", repr(24/FREQUENCY))
    replayed.run("acousticDEMFoam")

    t, rho = solved.probes("history", "rho")
    u = solved.probes("history", "U")[1][:, 0]
    last = t > 23.005/FREQUENCY
    assert last.sum() == 100
    mean = (rho[last, 0]*u[last]).mean()/rho[last, 0].mean()
    amplitude = np.ptp(u[last])/2
    drift = amplitude**2/(2*343.2)

    for name, case in ("solved", solved), ("replayed", replayed):
        clouds = [case.cloud(time) for time in case.times()[-3:]]
        moved = np.diff([c["position"][:, 0] for c in clouds], axis=0)
        moved -= 3e-4*np.round(moved/3e-4)
        found = moved*FREQUENCY
        print(
            f"{name}: {1e3*found.mean():.4f} mm/s, the mass"
            f" {1e3*mean:.4f}, u {1e3*u[last].mean():.4f}; Stokes' drift"
            f" {1e3*drift:.4f}"
        )
        # The same all over the box
        assert np.ptp(found, axis=1).max() < 1e-6*drift
        assert found.mean() == pytest.approx(mean, abs=0.03*drift)


def contacts(case):
    """Times and ids."""
    table = case.table("contacts")
    return np.array([table[name] for name in ("time_s", "id1", "id2")]).T


def steps(log):
    """Wakes and pairs per step, of the last lines of the log."""
    return re.findall(r"(\S+) wakes on particles, (\S+) pairs", log)[-1]


@pytest.mark.parametrize("stepping", [
    "type eventDriven;", "type multipleTimeStep; kp 0.5; kc 0.1;",
])
def test_a_mean_flow_changes_nothing(tmp_path, meshed, stepping):
    """At rest, in a flow, and carried along by it: the same contacts, at the
    same cost, where the sound is the same everywhere."""
    def run(name, velocity, more=""):
        case = AerosolCase(tmp_path/name, meshed)
        case.replace(
            "constant/acousticProperties", r"(?s)type.*antinode",
            f"type travellingWave; frequency {FREQUENCY}; SPL 147;"
            f" velocity {velocity}; gas {{ c 1e12; }}",
        )
        case.replace(
            "constant/acousticProperties", "SPL 147;", "velocityAmplitude 1.5;"
        )
        case.aerosol("numberConcentration", "20e12")
        case.model("timeStepping", stepping)
        case.exact_times(STEP, 60)
        case.control("endTime", repr(60*STEP))
        case.write(
            "constant/aerosolProperties",
            (case.path/"constant"/"aerosolProperties").read_text()
            + "\nreport { contacts yes; }\n" + more,
        )
        return case, case.run("acousticDEMFoam")

    rest, log = run("rest", "(0 0 0)")
    expected = contacts(rest)
    assert len(expected) > 10

    for name, more in ("flow", ""), ("carried", "frame { velocity (5 3 1); }"):
        case, other = run(name, "(5 3 1)", more)
        assert steps(other) == steps(log)
        assert contacts(case) == pytest.approx(expected, rel=1e-6)

        # In the chamber
        a, b = (c.cloud(c.times()[-1]) for c in (rest, case))
        way = 60*STEP*np.array([5, 3, 1])
        off = b["position"] - a["position"] - way
        if not more:
            off -= 0.5e-3*np.round(off/0.5e-3)
        assert np.abs(off).max() < 1e-12
        assert np.abs(b["U"] - a["U"] - [5, 3, 1]).max() < 1e-9


@pytest.mark.parametrize("kind", ["flow", "solved"])
def test_goes_on_as_if_nothing_had_happened(tmp_path, meshed, kind):
    """Restarts in the frame of a mean flow, to the last bit, and in a sound
    that is being solved, whose last period the box remembers: forgotten, it
    would cost the drift of a period, 2 um."""
    def make(name):
        if kind == "solved":
            case = radiating_tube(
                tmp_path/name,
                f"sound {{ type explicitCompressible; frequency {FREQUENCY};"
                " velocityAmplitude 1.5; }",
            )
            case.control("writeFormat", "binary")
            case.control("deltaT", repr(STEP))
            case.control("writeInterval", "70")
        else:
            case = AerosolCase(tmp_path/name, meshed)
            case.replace(
                "constant/acousticProperties", "SPL         147;",
                "SPL 147; velocity (5 3 1);",
            )
            case.aerosol("numberConcentration", "20e12")
            case.model("timeStepping", "type eventDriven;")
            case.exact_times(STEP, 70)
        return case

    whole = make("whole")
    whole.control("endTime", repr(210*STEP))
    whole.run("acousticDEMFoam")

    parts = make("parts")
    for end in 70, 140, 210:
        parts.control("endTime", repr(end*STEP))
        parts.run("acousticDEMFoam")

    time = whole.times()[-1]
    a, b = whole.cloud(time), parts.cloud(time)
    off = np.abs(b["position"] - a["position"]).max()
    print(f"{kind}: off by {off:.1e} m after two restarts")
    if kind == "solved":
        # The sound itself goes on to rounding only
        assert off < 1e-13
    else:
        for field, values in a.items():
            assert np.array_equal(values, b[field]), field


def test_another_mean_flow_after_a_restart_moves_nothing(tmp_path, meshed):
    """Without drag a particle keeps its velocity in the chamber, whatever
    frames it is kept in, also if it goes on from the first time."""
    case = AerosolCase(tmp_path/"case", meshed)
    x0, v0 = np.array([0.0613, 1e-4, -1e-4]), np.array([0.3, 0.2, -0.1])
    case.particles([(x0, 5e-6)])
    case.replace(
        "constant/aerosolProperties", r"diameter [^;]*;",
        "diameter 5e-6; velocity (0.3 0.2 -0.1);",
    )
    for name in ("drag", "gravity", "wake", "contact"):
        case.model(name, "type none;")
    case.replace(
        "constant/acousticProperties", "SPL         147;",
        "SPL 147; velocity (5 3 1);",
    )
    case.exact_times(STEP, 10)
    for end, flow in ((10, "(5 3 1)"), (20, "(1 0 0)"), (30, "(0 0 0)")):
        case.replace(
            "constant/acousticProperties", r"velocity \([^)]*\)",
            f"velocity {flow}",
        )
        case.control("endTime", repr(end*STEP))
        case.run("acousticDEMFoam")
        cloud = case.cloud(case.times()[-1])
        off = cloud["position"][0] - x0 - end*STEP*v0
        assert np.abs(off - 5e-4*np.round(off/5e-4)).max() < 1e-15
        assert np.abs(cloud["U"][0] - v0).max() < 1e-14
