"""What the particles lose the gas gets: momentum, in the right place."""

import re

import numpy as np
import pytest
from aerosolcase import AerosolCase, read_field
from foamcase import ROOT

DENSITY = 2300  # kg/m3, of the particles
RHO = 101325/(8314.47/28.96*293.15)
MU = 1.81e-5


def field(case, time, name):
    """Values in the cells of a field that was written as text."""
    text = (case.path/time/name).read_text()
    n = len(case.volumes)
    uniform = re.search(r"internalField\s+uniform\s+([^;]*);", text)
    if uniform:
        values = np.array(uniform[1].strip("()").split(), float)
        return np.tile(values, (n, 1))
    body = re.search(
        r"internalField\s+nonuniform[^(]*\((.*?)\n\)\s*;", text, re.S
    )[1]
    return np.array(re.sub("[()]", " ", body).split(), float).reshape(n, -1)


def tube(directory, particles, box, blocks, walls, more=""):
    """A short tube along x, in three dimensions, with gas at rest."""
    case = AerosolCase(directory, ROOT/"tutorials/aerosolAttenuation")
    case.particles([(x, d) for x, d, _ in particles], DENSITY)
    place = None
    for _, _, v in particles:
        text = (case.path/"constant/aerosolProperties").read_text()
        place = text.index("; }", place or text.index("particles\n("))
        text = f"{text[:place]}; velocity ({v[0]} {v[1]} {v[2]}){text[place:]}"
        place = text.index("; }", place) + 3
        (case.path/"constant/aerosolProperties").write_text(text)
    case.model("domain", f"type periodicBox; {box}")
    case.entry("system/tube", "length", 0.01)
    case.replace(
        "system/blockMeshDict", r"\(25 1 1\) simpleGrading \(1 1 1\)", blocks
    )
    case.replace("system/blockMeshDict", r"type    empty", "type patch")
    for name, other in (("left", "right"), ("right", "left")):
        if walls == "cyclic":
            case.replace(
                "system/blockMeshDict", rf"{name}\s*\{{\s*type    wall;",
                f"{name}\n{{\ntype cyclic; neighbourPatch {other};",
            )
    for name in ("U", "p", "T"):
        text = (case.path/"0"/name).read_text()
        text = text.replace("empty", "slip" if name == "U" else "zeroGradient")
        if walls == "cyclic":
            for side in ("left", "right"):
                text = re.sub(
                    rf"{side}\s*\{{[^}}]*\}}", f"{side} {{ type cyclic; }}",
                    text,
                )
        case.write(f"0/{name}", text)
    case.control("writeFormat", "ascii")
    case.control("writePrecision", "17")
    case.replace("system/controlDict", r"(?s)functions\s*\{.*\n\}", more)
    case.replace("system/fvSolution", "1e-10", "1e-14")
    case.run("blockMesh")
    case.run("postProcess", "-func", "writeCellVolumes")
    case.run("postProcess", "-func", "writeCellCentres")
    owner = (case.path/"constant/polyMesh/owner").read_text()
    case.volumes = np.ones((int(re.search(r"nCells: *(\d+)", owner)[1]), 1))
    case.volumes = field(case, "0", "V")
    case.centres = field(case, "0", "C")
    for name in ("V", "C", "Cx", "Cy", "Cz"):
        (case.path/"0"/name).unlink()
    return case


def total(case, time):
    """Momentum of the particles, without Brownian motion."""
    folder = case.path/time/"lagrangian/aerosol"
    U = read_field(folder/"U")
    if (folder/"UBrownian").exists():
        U = U - read_field(folder/"UBrownian")
    return (read_field(folder/"mass")[:, None]*U).sum(0)


def test_gas_and_particles_come_to_a_common_velocity(tmp_path):
    """A gas at rest, all particles at 1 m/s: exact, and momentum kept."""
    s, n = 1.0, 48
    tau = s/(2*np.pi*1400)
    d = np.sqrt(18*MU*tau/DENSITY)
    mass = n*DENSITY*np.pi/6*d**3
    loading = 0.3
    edge = np.sqrt(mass/(loading*RHO*0.01))
    case = tube(
        tmp_path/"case",
        [(((i + 0.5)/n*0.01, 5e-3, 5e-3), d, (1, 0, 0)) for i in range(n)],
        f"centre (5e-3 5e-3 5e-3); length (0.01 {edge} {edge});",
        "(12 1 1) simpleGrading (1 1 1)", "cyclic",
    )
    step = 1/(200*1400)
    for steps, offset in ((40, 1.5e-4), (400, 1e-6)):
        case.control("endTime", repr(steps*step))
        case.control("writeInterval", str(steps))
        case.run("acousticDEMFoam")
        time = case.times()[-1]

        U = field(case, time, "U")
        rho = field(case, time, "rho")
        scale = case.volumes.sum()/(0.01*edge**2)
        gas = (rho*U*case.volumes).sum(0)
        solid = scale*total(case, time)
        start = scale*mass

        decay = np.exp(-(1 + loading)*float(time)/tau)
        exact = loading/(1 + loading)*(1 - decay)
        print(
            f"t/tau {float(time)/tau:.2f}: gas {U[:, 0].mean()/exact - 1:+.1e},"
            f" momentum {(gas + solid)[0]/start - 1:+.1e}"
        )
        # The pressure of a cell is rounded in each step, to 2e-16 of 1e5 Pa
        impulse = steps*2e-16*101325*step/(0.01/12)
        assert abs((gas + solid)[0]/start - 1) < impulse/(loading*RHO)
        assert np.abs(U[:, 0]/exact - 1).max() < offset

        # Its kinetic energy is the work of the force, not taken from its heat
        kinetic = 0.5*U[0, 0]**2/(1005 - 8314.47/28.96)
        heated = np.abs(field(case, time, "T") - 293.15).max()
        print(f"temperature {heated:.1e} K off, kinetic energy {kinetic:.1e} K")
        assert heated < 0.01*kinetic


@pytest.mark.parametrize("represents, noise, breakage", [
    ((0, 1, 1), "none", "none"), ((0, 1, 1), "OrnsteinUhlenbeck", "none"),
    ((0, 0, 0), "none", "none"), ((1, 1, 1), "none", "shear"),
])
def test_what_is_lost_is_given(tmp_path, represents, noise, breakage):
    """A crowd with wakes and contacts in a graded mesh: its momentum, scaled
    to what it stands for, is found in the gas when it has come to rest."""
    rng = np.random.default_rng(1)
    n, edge = 150, 2.6e-4
    centre = np.array([4e-3, 5.1e-3, 4.8e-3])
    low = centre - edge/2
    case = tube(
        tmp_path/"case",
        [(low + edge*rng.random(3), d, rng.normal(size=3) + [1, 0, 0])
         for d in rng.uniform(1e-6, 4e-6, n)],
        f"centre ({centre[0]} {centre[1]} {centre[2]}); length {edge};",
        "(100 3 4) simpleGrading (3 2 0.4)", "cyclic",
    )
    case.aerosol("represents", "({} {} {})".format(*represents))
    case.model("drag", "type SchillerNaumann; slipCorrection Cunningham;")
    case.model("wake", "type Oseen; range 20;")
    case.model("contact", "type stick;")
    case.model("aggregate", "type equivalentSphere;")
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant/aerosolProperties").read_text()
        + f"\nBrownian {{ type {noise}; }}\n"
        + f"breakage {{ type {breakage};"
        + (" bond { type JKR; workOfAdhesion 1e-13; }"
           if breakage != "none" else "") + " }\n"
        + "report { breakages yes; }\n",
    )
    case.control("endTime", f"{120/(200*1400)!r}")
    case.control("writeInterval", "20")
    case.run("acousticDEMFoam")

    extent = np.where(represents, [0.01, 0.01, 0.01], edge)
    scale = np.prod(extent)/edge**3
    start = scale*total(case, "0")
    print(len(case.cloud("0")["id"]), case.table()["number"][-1])
    if breakage == "none":
        assert case.table()["number"][-1] < n
    else:
        broken = len(case.table("breakages")["time_s"])
        print(broken, "breakages,", case.table()["contacts"][-1], "contacts")
        assert broken > 0

    for time in case.times()[1:]:
        given, owed = [
            (field(case, time, f"aerosol{name}")*case.volumes).sum(0)
            for name in ("Impulse", "Debt")
        ]
        lost = start - scale*total(case, time)
        total_ = np.abs(start).max()
        off = np.abs(given + owed - lost).max()/total_
        print(f"{time} off by {off:.1e}, owed {np.abs(owed).max()/total_:.1e}")
        assert off < 1e-13
        assert np.abs(owed).max() < 0.01*total_
    assert np.abs(lost).max() > 0.5*total_

    # In the cells that the represented volume meets, nowhere else
    given = np.abs(field(case, time, "aerosolImpulse")).max(1) > 0
    aside = np.abs(case.centres - centre)[given].max(0) - extent/2
    assert np.all((aside < [0.1e-3, 2.5e-3, 2.5e-3]) | np.equal(represents, 1))
    assert np.all(case.volumes[given].sum() >= np.prod(extent)*(1 - 1e-9))
