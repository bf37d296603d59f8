"""Eddies in the place of the mean flow: Rayleigh's streaming between plates.

The sound is replayed from fields that are written here, by formulas.
"""

import re

import numpy as np
import pytest
from aerosolcase import AerosolCase

FREQUENCY = 1400
WAVE_NUMBER = 2*np.pi*FREQUENCY/343.2
HALF_GAP = 0.01  # m, that of the mesh
STREAMING = 3*1.53**2/(8*343.2)  # m/s
LOW, HIGH = np.array([0.051, -0.01, -0.01]), np.array([0.071, 0.01, 0.01])
CENTRE, LENGTH = np.array([0.053, 0.004, 0.001]), 0.5e-3

STEP = 2**-17  # s, exact in the name of a time


def streaming(x):
    """Mean velocity outside of the layers, and the square of its gradient."""
    eta = x[..., 1]/HALF_GAP
    s, c = (f(2*WAVE_NUMBER*x[..., 0]) for f in (np.sin, np.cos))
    kh = WAVE_NUMBER*HALF_GAP
    u = STREAMING*np.stack(
        [-(1 - 3*eta**2)*s/2, kh*(eta - eta**3)*c, 0*s], axis=-1
    )
    gradient = STREAMING/HALF_GAP*np.array([
        -kh*(1 - 3*eta**2)*c, kh*(1 - 3*eta**2)*c,
        3*eta*s, -2*kh**2*(eta - eta**3)*s,
    ])
    return u, (gradient**2).sum(0)


def velocity(x, factor=1):
    return factor*streaming(x)[0]


def middles(low, high, n):
    """Of cells, x first."""
    axes = [a + (b - a)*(np.arange(m) + 0.5)/m for a, b, m in zip(low, high, n)]
    z, y, x = np.meshgrid(*axes[::-1], indexing="ij")
    return np.stack([x, y, z], axis=-1).reshape(-1, 3)


def write(case, name, values):
    case.write(
        f"0/{name}",
        "FoamFile { version 2.0; format ascii; class volVectorField;"
        f" object {name}; }}\n"
        "dimensions [0 1 -1 0 0 0 0];\n"
        f"internalField nonuniform List<vector> {len(values)}\n(\n"
        + "\n".join("({!r} {!r} {!r})".format(*map(float, u)) for u in values)
        + "\n);\nboundaryField { walls { type zeroGradient; } }\n",
    )


def prepare(directory, meshed, mean, more="meanFlow yes;", cells=(8, 8, 8)):
    """Twenty steps in that mean flow at the middles of the cells."""
    case = AerosolCase(directory, meshed)
    case.replace("system/blockMeshDict", r"\(4 4 4\)", "({} {} {})".format(*cells))
    case.run("blockMesh")
    (case.path/"0").mkdir(exist_ok=True)
    values = mean(middles(LOW, HIGH, cells))
    write(case, "UMean", values)
    write(case, "UCos1", 0*values)
    write(case, "USin1", 0*values + [1, 0, 0])
    case.replace(
        "constant/acousticProperties", r"(?s)sound\s*\{.*\}",
        f"sound {{ type replay; frequency {FREQUENCY}; }}",
    )
    case.aerosol("centre", "({} {} {})".format(*CENTRE))
    case.aerosol("numberConcentration", "30e12")
    case.model("timeStepping", "type eventDriven;")
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant"/"aerosolProperties").read_text()
        + f"\nturbulence {{ type syntheticTurbulence; {more} }}\n",
    )
    case.exact_times(STEP, 10)
    case.control("endTime", repr(20*STEP))
    return case


def gradients(log):
    """Of the mean flow, and of the eddies."""
    return [float(x) for x in re.findall(r"rms gradient (\S+) 1/s", log)]


# The box within a cell, and with four cells across
@pytest.mark.parametrize("cells", [(8, 8, 8), (8, 160, 2)])
def test_is_that_of_rayleighs_streaming(tmp_path, meshed, cells):
    case = prepare(tmp_path/"case", meshed, velocity, cells=cells)
    case.control("endTime", repr(STEP))
    found = gradients(case.run("acousticDEMFoam"))

    box = middles(CENTRE - LENGTH/2, CENTRE + LENGTH/2, (20, 20, 1))
    exact = np.sqrt(streaming(box)[1].mean())
    there = np.sqrt(streaming(CENTRE)[1])
    print(
        f"streaming, cells {cells}: gradient {found[0]} 1/s,"
        f" {exact:.6g} in the box by theory ({there:.6g} in the middle):"
        f" {100*(found[0]/exact - 1):.3f} % off"
    )
    assert found[0] == found[1] == pytest.approx(exact, rel=2e-3)


def test_depends_on_neither_ranks_nor_restarts(tmp_path, meshed):
    # Strong, so that it matters within so few steps
    def mean(x):
        return velocity(x, 1e4)

    whole = prepare(tmp_path/"whole", meshed, mean)
    log = whole.run("acousticDEMFoam")

    parts = prepare(tmp_path/"parts", meshed, mean)
    parts.control("endTime", repr(10*STEP))
    first = parts.run_on(2)
    assert (parts.path/"processor1"/"0"/"UMean").exists()
    parts.control("endTime", repr(20*STEP))
    second = parts.run("acousticDEMFoam")
    assert "Continuing with the" in second

    assert gradients(log)[0] > 1e3
    assert gradients(first) == gradients(second) == gradients(log)
    for name in whole.times()[1:]:
        a, b = whole.cloud(name), parts.cloud(name)
        for field, values in a.items():
            assert np.array_equal(values, b[field]), (name, field)


def test_leaves_the_mean_velocity_but_not_its_gradient(tmp_path, meshed):
    """Particles that follow the gas, with eddies that hardly move it."""
    def mean(x):
        return velocity(x, 1e3)

    def spread(more):
        case = prepare(tmp_path/more.split()[0], meshed, mean, more)
        case.model(
            "particles",
            "density 2300; source list; particles (" + " ".join(
                f"{{ position ({x} {y} {z}); diameter 2e-8; }}"
                for x, y, z in CENTRE + LENGTH/2*np.array(
                    [[0, -0.9, 0], [0, 0.9, 0], [0, 0, 0.5]]
                )
            ) + ");",
        )
        case.model("wake", "type none;")
        case.control("endTime", repr(STEP))
        case.control("writeInterval", "1")
        case.run("acousticDEMFoam")
        u = case.cloud(case.times()[-1])["U"]
        return abs(u[1] - u[0]).max(), u[2]

    # Waves of 0.1 um have hardly a velocity, and the box has no gradient
    with_eddies, u = spread("meanFlow yes; wavelength 1e-7;")
    without, other = spread(
        "shearRate 1; wavelength 1e-7; accelerationFactor 0;"
    )
    gradient = np.sqrt(streaming(CENTRE)[1])*1e3
    print(
        f"from end to end {with_eddies:.2e} and {without:.2e} m/s; with the"
        f" gradient {gradient*LENGTH:.2e}"
    )
    assert max(with_eddies, without) < 1e-3*gradient*LENGTH
    # All swing by 0.1 mm in the gradient, if it is there
    assert u == pytest.approx(other, abs=1.2e-4*gradient)


def refused(case, what):
    log = " ".join(case.run("acousticDEMFoam", status=1).split())
    assert log.count("FOAM FATAL") == 1 and re.search(what, log), log[-2000:]


@pytest.mark.parametrize("sound, message", [
    ("representative", "steady velocity gradient of 1000 1/s"),
    ("resolved", "at opposite faces of the domain"),
])
def test_is_not_a_steady_shear(tmp_path, meshed, sound, message):
    """Images would have the velocity of the particle, not that of the gas."""
    case = AerosolCase(tmp_path/"case", meshed)
    case.replace(
        "constant/acousticProperties", r"(?s)sound\s*\{.*\}",
        "sound { type linearShear; shearRate 1000; }",
    )
    case.aerosol("length", f"0.5e-3; sound {sound}")
    refused(case, message + ".*aerosolProperties")


def test_needs_a_gradient(tmp_path, meshed):
    refused(
        prepare(tmp_path/"case", meshed, lambda x: 0*x + [0.3, 0.1, 0]),
        "'meanFlow' of .*turbulence\" is yes, but .* has no gradient in the"
        " domain. .* UMean of .* 'replay' .* or give 'shearRate'"
        " file: .*aerosolProperties",
    )


def test_needs_the_mean_flow(tmp_path, meshed):
    case = prepare(tmp_path/"case", meshed, velocity)
    (case.path/"0"/"UMean").unlink()
    refused(case, "No time directory of .* has a field UMean")


@pytest.mark.parametrize("wake", ["memory", "history"])
def test_is_no_swing_for_wakes(tmp_path, meshed, wake):
    """Two particles: the same in gas that moves across the sound, with it."""
    def separation(model, mean, more=""):
        case = AerosolCase(tmp_path/f"{model}{mean}{len(more)}", meshed)
        case.replace("constant/aerosolProperties", "domain", f"{more}\ndomain")
        case.model("wake", f"type {model};" + " range 15;"*(model != "none"))
        case.model("timeStepping", "type eventDriven;")
        case.model("gravity", "type none;")
        case.model("contact", "type none;")
        middle = np.array([0.0613, 0, 0])
        case.particles([
            (middle, 10e-6), (middle + [60e-6, 80e-6, 0], 4e-6),
        ])
        case.replace("constant/acousticProperties", "standing", "travelling")
        case.entry(
            "constant/acousticProperties", "SPL",
            f"147; direction (0 1 0); velocity ({mean} 0 0)",
        )
        case.control("endTime", "#eval{ 5.0/$frequency }")
        case.run("acousticDEMFoam")
        x = case.cloud(case.times()[-1])["position"]
        return (x[1] - x[0] + 0.25e-3) % 0.5e-3 - 0.25e-3

    rest, alone = separation(wake, 0), separation("none", 0)
    error = np.linalg.norm([
        separation(wake, 1) - rest,
        separation(wake, 1, "frame { velocity (1 0 0); }") - rest,
        separation(wake, 0, "frame { velocity (0.5 0 0); }") - rest,
    ])
    wakes = np.linalg.norm(rest - alone)
    print(f"{wake}: {wakes} m by the wakes, {error} m more in a mean flow")
    assert wakes > 1e-6
    assert error < 1e-6*wakes
