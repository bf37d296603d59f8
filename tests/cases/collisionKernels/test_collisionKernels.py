"""Collision kernels, measured from the contacts that a run reports.

Settling in still gas has an exact kernel, pi/4 (d1 + d2)^2 |v1 - v2|. Two sizes
at their terminal velocities pass through one another for less than one box
length, so that no pair meets twice: which pairs meet, and when, is geometry.
The indicators of pairs at random positions do not correlate, not even those of
pairs that share a particle: the number of contacts is binomial, all but Poisson.
"""

import subprocess
from pathlib import Path

import numpy as np
import pytest
from aerosoltheory import DENSITY, VISCOSITY, relaxation_time

TOOL = Path(__file__).resolve().parents[3]/"bin"/"collisionKernels"

LENGTH = 2e-3  # m
CENTRE = np.array([0.0613, 0, 0])
DIAMETERS = np.array([10e-6, 20e-6])
NUMBER = 5000  # of each
SPEED = 9.81*(1 - DENSITY/2300)*relaxation_time(DIAMETERS)
STEPS = 40
END = float(f"{0.95*LENGTH/np.ptp(SPEED):.4g}")


def apart(r, length=LENGTH):
    return r - length*np.round(r/length)


def aerosol(number=NUMBER, length=LENGTH, diameters=DIAMETERS):
    """Positions and sizes (0 or 1) of particles, none of which overlap."""
    random = np.random.default_rng(3)
    x = length*(random.random((2*number, 3)) - 0.5)
    size = np.repeat([0, 1], number)
    d = diameters[size]
    keep = np.ones(len(x), bool)
    for i in range(len(x)):
        r = np.linalg.norm(apart(x[:i] - x[i], length), axis=1)
        keep[i] = not (keep[:i] & (r <= 0.5001*(d[:i] + d[i]))).any()
    return x[keep], size[keep]


def encounters(x, size):
    """Ids of the small and the large, times and angles of all contacts."""
    small, large = np.nonzero(size == 0)[0], np.nonzero(size == 1)[0]
    touch = DIAMETERS.mean()
    met = []
    for i in small:
        r = apart(x[large] - x[i])
        near = (r[:, :2]**2).sum(axis=1) < touch**2
        half = np.sqrt(touch**2 - (r[near, :2]**2).sum(axis=1))
        # The large one falls: it comes from above, or from below, through the
        # periodic face
        way = r[near, 2] - half
        way[way < 0] += LENGTH
        met += [(i, j, w/np.ptp(SPEED), np.degrees(np.arccos(h/touch)))
                for j, w, h in zip(large[near], way, half)]
    met = np.array(met)
    return met[met[:, 2] < END]


def run_tool(case, *arguments, status=0):
    result = subprocess.run(
        [TOOL, *arguments, case], capture_output=True, text=True, check=False,
    )
    assert result.returncode == status, result.stdout + result.stderr
    return result.stdout if status == 0 else result.stderr


def kernels(text):
    """Contacts, kernel and its error by the order of the classes."""
    return [[float(word) for word in line.split()[6:9]]
            for line in text.splitlines() if " to " in line
            and not line.endswith("pairs") and "<" not in line]


def contact_rows(box):
    lines = [line.split(",") for line in (
        box.path/"postProcessing/aerosol/contacts.csv"
    ).read_text().splitlines()[1:]]
    return np.array([line[:7] for line in lines], float), [
        line[7] for line in lines
    ]


def pass_through_one_another(box, length, x, d, speed, end, steps, more=""):
    """A run in still gas of particles that fall at these speeds at first."""
    rows = [
        f"{a:.17g},{b:.17g},{c:.17g},{diameter:.17g},0,0,{-v:.17g}"
        for (a, b, c), diameter, v in zip(CENTRE + x, d, speed)
    ]
    box.write("particles.csv", "\n".join(["x,y,z,d,vx,vy,vz", *rows]) + "\n")
    box.model(
        "particles", 'density 2300;\nsource list;\nfile "particles.csv";'
    )
    box.model("domain", "type periodicBox; centre (0.0613 0 0);"
              f" length {length};")
    box.model("timeStepping", "type eventDriven;")
    box.model("wake", "type none;")
    box.model("aggregate", "type none;")
    with (box.path/"constant/aerosolProperties").open("a") as file:
        file.write("report { contacts yes; }\n" + more)
    box.replace(
        "constant/acousticProperties", r"(?s)type.*antinode", "type quiescent;"
    )

    box.control("deltaT", f"{end/steps:.17g}")
    box.control("writeInterval", str(steps))
    box.control("endTime", f"{end:.17g}")
    box.run("acousticDEMFoam")


def test_settling(box):
    x, size = aerosol()
    pass_through_one_another(
        box, LENGTH, x, DIAMETERS[size], SPEED[size], END, STEPS
    )

    met, outcomes = contact_rows(box)
    assert set(outcomes) == {"none"}
    assert (np.diff(met[:, 0]) >= 0).all()

    # Each contact is the one of geometry
    exact = encounters(x, size)
    first = met[:, 1:3].min(axis=1).astype(int)
    other = met[:, 1:3].max(axis=1).astype(int)
    print(f"{len(met)} contacts, {len(exact)} by geometry")
    assert set(zip(first, other)) == {(int(i), int(j)) for i, j in exact[:, :2]}
    assert len(met) == len(exact)
    order = np.lexsort((other, first))
    exact = exact[np.lexsort((exact[:, 1], exact[:, 0]))]
    off = np.abs(met[order, 0] - exact[:, 2])
    turned = np.abs(met[order, 6] - exact[:, 3])
    speed = np.abs(met[:, 5]/np.ptp(SPEED) - 1)
    print(f"times differ by {off.max()/END:.2g} of the run, angles by"
          f" {turned.max():.2g} degrees, speeds by {speed.max():.2g}")
    assert off.max() < 1e-6*END
    assert turned.max() < 0.1
    assert speed.max() < 1e-8

    # And their number gives the kernel
    text = run_tool(box.path)
    print(text)
    contacts, K, error = kernels(text)[0]
    expected = np.pi/4*DIAMETERS.sum()**2*np.ptp(SPEED)
    print(f"K {K:.4g} +- {error:.2g}, theory {expected:.4g} m3/s:"
          f" {(K - expected)/error:+.2f} standard deviations")
    assert contacts == len(met)
    assert error < 0.03*K
    assert K == pytest.approx(expected, abs=3*error)

    # Those of the same size never meet
    assert len(kernels(text)) == 1
    assert text.count("<") == 2


def test_inertia_in_turbulence(box):
    """Saffman and Turner's rate for fly ash."""
    length, G, end = 0.5e-3, 200, 0.25
    diameters = np.array([2e-6, 6e-6])
    x, size = aerosol(1000, length, diameters)
    box.model("gravity", "type none;")
    pass_through_one_another(
        box, length, x, diameters[size], 0*size, end, round(end*G/0.2),
        f"turbulence {{ type syntheticTurbulence; shearRate {G}; }}\n",
    )

    text = run_tool(box.path, "--classes", "1e-6,3e-6,9e-6")
    print(text)
    _, K, error = max(kernels(text))  # those of different size, mostly
    a = np.sqrt(1.3*VISCOSITY/DENSITY*G**3)
    R = diameters.mean()
    slip = a*np.ptp(relaxation_time(diameters))
    theory = 2*np.sqrt(2*np.pi)*R**2*np.hypot(slip, R*G/np.sqrt(15))
    # The modulus of an acceleration, which loses its correlation within 2/G
    error = np.hypot(error, K*np.sqrt(3*np.pi/8 - 1)*np.sqrt(2/(G*end)))
    print(f"K {K:.4g} +- {error:.2g}, theory {theory:.4g} m3/s")
    assert error < 0.12*K
    assert K == pytest.approx(theory, abs=3*error)


def test_contacts_are_not_kept_unless_asked_for(box):
    box.run("acousticDEMFoam")
    assert not list((box.path/"postProcessing/aerosol").glob("contacts*"))
    assert "contacts yes" in run_tool(box.path, status=1)


def test_aggregates(box):
    """The log of an agglomerating aerosol tells the same as its cloud."""
    with (box.path/"constant/aerosolProperties").open("a") as file:
        file.write("report { contacts yes; }\n")
    box.aerosol("numberConcentration", "2.4e13")

    # Two runs: the second one continues the tables
    box.run("acousticDEMFoam")
    first = len(contact_rows(box)[0])
    box.control("endTime", "#eval{ 2.0/$frequency }")
    box.run("acousticDEMFoam")

    met, outcomes = contact_rows(box)
    assert 0 < first < len(met)
    print(f"{len(met)} contacts of aggregates")
    assert (np.diff(met[:, 0]) >= 0).all()
    begin, end = (box.cloud(time) for time in (box.times()[0],
                                               box.times()[-1]))
    assert len(met) == len(begin["id"]) - len(end["id"]) > 50
    assert set(outcomes) == {"stick"}

    # The survivor comes first, and grows
    volume = dict(zip(begin["id"], begin["d"]**3))
    for _, one, two, d1, d2, *_ in met:
        assert volume[one] == pytest.approx(d1**3, rel=1e-8)
        assert volume.pop(two) == pytest.approx(d2**3, rel=1e-8)
        volume[one] = d1**3 + d2**3
        assert d1 >= d2*(1 - 1e-9)
    assert sorted(volume) == list(end["id"])
    assert f"{len(met)} contacts" in run_tool(box.path)


def test_tool(tmp_path):
    """Numbers that can be worked out: V = 1e-6 m3, 2 s, one class shrinks."""
    folder = tmp_path/"postProcessing/aerosol"
    folder.mkdir(parents=True)
    (folder/"agglomeration.csv").write_text(
        "time_s,number,concentration_per_m3,contacts\n"
        "0,30,30e6,0\n2,28,28e6,5\n"
    )
    (folder/"sizeDistribution.csv").write_text(
        "time_s,lower_m,upper_m,number,mass_kg\n" + "".join(
            f"{t},0,1e-6,0,0\n{t},1e-6,2e-6,{n},0\n{t},2e-6,4e-6,10,0\n"
            f"{t},4e-6,inf,0,0\n" for t, n in ((0, 20), (2, 18))
        )
    )
    (folder/"contacts.csv").write_text(
        "time_s,id1,id2,d1_m,d2_m,speed_m_per_s,angle_deg,outcome\n"
        "0.5,1,2,1.5e-6,3e-6,1,0,none\n0.5,1,2,3e-6,1.5e-6,1,0,none\n"
        "0.7,1,2,1e-6,1.5e-6,1,0,none\n0.8,1,2,1e-6,1.5e-6,1,0,none\n"
        "0.9,1,2,1e-6,3e-6,1,0,none\n"
    )
    same, cross = kernels(run_tool(tmp_path))
    squares = 2/3*(20**2 + 20*18 + 18**2)
    assert same[0] == 2 and cross[0] == 3
    assert same[1] == pytest.approx(2e-6/(0.5*(squares - 38)), rel=1e-3)
    assert cross[1] == pytest.approx(3e-6/380, rel=1e-3)
    assert cross[2] == pytest.approx(cross[1]/np.sqrt(3), rel=1e-2)

    # One class; one that divides particles; a contact that is missing
    (one,) = kernels(run_tool(tmp_path, "--classes", "1e-6,4e-6"))
    assert one[0] == 5
    assert "divides" in run_tool(tmp_path, "--classes", "1e-6,3e-6", status=1)
    with (folder/"contacts.csv").open("a") as file:
        file.write("1,1,2,1e-6,3e-6,1,0,none\n")
    assert "6 contacts" in run_tool(tmp_path, status=1)
