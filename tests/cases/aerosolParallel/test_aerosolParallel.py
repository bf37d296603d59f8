"""The aerosol is the same, to the last bit, on any number of ranks.

The box lies inside one cell of the mesh, so that all ranks but one own no part
of it there; the particles are shared out over all ranks nevertheless.
"""

import numpy as np
import pytest
from aerosolcase import AerosolCase

STEPPINGS = {
    "conventional": "type conventional; kc 0.5;",
    "multipleTimeStep": "type multipleTimeStep; kp 1; kc 0.1;",
    "eventDriven": "type eventDriven;",
    "eventDriven Brownian": "type eventDriven;",
    "eventDriven memory turbulence": "type eventDriven;",
    "eventDriven history": "type eventDriven;",
}
WAKES = {
    "memory": "type memory; range 20;",
    "history": "type history; tolerance 1;",
}


def run_on(case, ranks, *times):
    """The final cloud and the tables, as text; from the given times."""
    if ranks == 1:
        case.run("acousticDEMFoam")
    else:
        case.run_on(ranks, *times)

    times = [name for name in case.times() if float(name) > 0]
    tables = sorted((case.path/"postProcessing"/"aerosol").rglob("*.csv"))

    return case.cloud(times[-1]), [
        (table.name, table.read_text()) for table in tables
        if table.stem != "cost"  # which has seconds
    ]


def assert_same(reference, other):
    cloud, tables = reference

    for name, values in other[0].items():
        assert np.array_equal(values, cloud[name]), name
    assert other[1] == tables


@pytest.fixture(scope="module", params=STEPPINGS, name="stepping")
def fixture_stepping(request, tmp_path_factory, meshed):
    """How a case is made, and what one rank makes of it."""

    def make(name):
        case = AerosolCase(tmp_path_factory.mktemp(name)/"case", meshed)
        case.model("timeStepping", STEPPINGS[request.param])
        words = set(request.param.split()) & set(WAKES)
        case.model("wake", WAKES.get("".join(words), "type Oseen; range 20;"))
        case.model("drag", "type SchillerNaumann; slipCorrection Cunningham;")
        case.write(
            "constant/aerosolProperties",
            (case.path/"constant"/"aerosolProperties").read_text()
            + "\nreport { contacts yes; interval 1e-4; }\n",
        )
        if "Brownian" in request.param:
            case.write(
                "constant/aerosolProperties",
                (case.path/"constant"/"aerosolProperties").read_text()
                + "\nBrownian { type OrnsteinUhlenbeck; seed 3; }\n",
            )
        case.aerosol("length", "(0.38e-3 0.36e-3 0.34e-3)")
        case.aerosol("numberConcentration", "3e13")
        if "history" in request.param:
            # Where not all that is in range is near the path
            case.aerosol("length", "(0.72e-3 0.7e-3 0.68e-3)")
            case.aerosol("numberConcentration", "6e12")
        if "turbulence" in request.param:
            case.control("stepsPerPeriod", "50")
            case.write(
                "constant/aerosolProperties",
                (case.path/"constant"/"aerosolProperties").read_text()
                + "\nturbulence { type syntheticTurbulence; shearRate 3e3; }\n",
            )
        if request.param == "conventional":
            case.aerosol("min", "2e-6")
            case.aerosol("max", "7e-6")
            case.control("endTime", "#eval{ 0.1/$frequency }")
            case.control("writeInterval", "10")
        case.exact_numbers()
        return case

    return make, run_on(make("serial"), 1)


@pytest.mark.parametrize("ranks", [2, 3, 4])
def test_is_that_of_one_rank(stepping, ranks):
    make, serial = stepping

    contacts = dict(serial[1])["contacts.csv"].count("\n") - 1
    print(contacts, "contacts")
    assert contacts > 0

    assert_same(serial, run_on(make(f"ranks{ranks}"), ranks))


def test_ranges_by_default(tmp_path, meshed):
    """Wakes act as far as the sizes and the sound say."""
    clouds = []

    for ranks in (1, 3):
        case = AerosolCase(tmp_path/f"ranks{ranks}", meshed)
        case.model("timeStepping", STEPPINGS["eventDriven"])
        case.model("wake", "type Oseen;")
        case.aerosol("numberConcentration", "2e13")
        case.replace(
            "constant/aerosolProperties", "domain",
            "report { contacts yes; }\n\ndomain",
        )
        clouds.append(run_on(case, ranks))

    assert_same(*clouds)


@pytest.mark.parametrize("wake, drag", [
    ("type none;", "type SchillerNaumann; slipCorrection Cunningham;"),
    ("type Oseen; range 20;", "type Stokes; slipCorrection Cunningham;"),
])
def test_where_most_particles_rest(tmp_path, meshed, wake, drag):
    """A thin aerosol, in which eventDriven looks ahead."""
    clouds = []

    for ranks in (1, 2, 3):
        case = AerosolCase(tmp_path/f"ranks{ranks}", meshed)
        case.model("timeStepping", STEPPINGS["eventDriven"])
        case.model("wake", wake)
        case.model("drag", drag)
        case.aerosol("length", "(2e-3 1.4e-3 1.6e-3)")
        case.aerosol("numberConcentration", "3e11")
        case.control("stepsPerPeriod", "50")
        case.control("endTime", "#eval{ 6.0/$frequency }")
        case.replace(
            "constant/aerosolProperties", "domain",
            "report { contacts yes; }\n\ndomain",
        )
        clouds.append(run_on(case, ranks))

        log = "".join(file.read_text() for file in case.path.glob("log*"))
        assert "    ahead     " in log

    for other in clouds[1:]:
        assert_same(clouds[0], other)

    assert dict(clouds[0][1])["contacts.csv"].count(",stick") > 0


@pytest.mark.parametrize("stepping", ["eventDriven", "multipleTimeStep"])
def test_bounces(tmp_path, meshed, stepping):
    """A fifth of those that touch stick, at random; the others bounce."""
    clouds = []

    for ranks in (1, 3):
        case = AerosolCase(tmp_path/f"ranks{ranks}", meshed)
        case.model("timeStepping", STEPPINGS[stepping])
        case.model("wake", "type none;")
        case.model(
            "contact", "type probability; sticking 0.2; restitution 0.8;"
        )
        case.aerosol("length", "(0.38e-3 0.36e-3 0.34e-3)")
        case.aerosol("numberConcentration", "6e13")
        case.replace(
            "constant/aerosolProperties", "domain",
            "report { contacts yes; }\n\ndomain",
        )
        clouds.append(run_on(case, ranks))

    assert_same(*clouds)

    contacts = dict(clouds[0][1])["contacts.csv"]
    print(
        contacts.count(",stick"), "stick,", contacts.count(",bounce"), "bounce"
    )
    assert contacts.count(",bounce") > 10
    assert contacts.count(",stick") > 3


@pytest.mark.parametrize("stepping", [
    STEPPINGS["eventDriven"],
    # Several particle steps to each fluid step, that lists are made anew
    "type multipleTimeStep; kp 0.002; kc 0.1;",
])
def test_ranks_without_particles(tmp_path, meshed, stepping):
    """Three particles in one corner of the box, which settle and meet."""
    clouds = []

    for ranks in (1, 4):
        case = AerosolCase(tmp_path/f"ranks{ranks}", meshed)
        case.model("timeStepping", stepping)
        case.aerosol("length", "0.5e-3")
        case.particles(
            [
                ((61.06e-3, -0.24e-3, -0.24e-3), 8e-6),
                ((61.06e-3, 0.24e-3, -0.2402e-3), 6e-6),
                ((61.07e-3, -0.24e-3, -0.235e-3), 5e-6),
            ]
        )
        case.write(
            "constant/aerosolProperties",
            (case.path/"constant"/"aerosolProperties").read_text()
            + "\nreport { contacts yes; }\n",
        )
        clouds.append(run_on(case, ranks))

    assert_same(*clouds)


@pytest.mark.parametrize("stepping", [
    STEPPINGS["eventDriven"], STEPPINGS["multipleTimeStep"]
])
def test_a_rank_that_runs_empty(tmp_path, meshed, stepping):
    """Two on either side of the middle meet; a rank loses its only particle."""
    clouds = []

    for ranks in (1, 2, 4):
        case = AerosolCase(tmp_path/f"ranks{ranks}", meshed)
        case.model("timeStepping", stepping)
        case.aerosol("length", "0.5e-3")
        case.particles(
            [
                ((61.293e-3, -0.5e-6, -0.5e-6), 8e-6),
                ((61.307e-3, 0.5e-6, 0.5e-6), 4e-6),
            ]
        )
        clouds.append(run_on(case, ranks))
        assert case.table()["contacts"][-1] == 1

    assert clouds[0][0]["d"].size == 1
    for other in clouds[1:]:
        assert_same(clouds[0], other)


def test_ranks_that_feel_no_wakes(tmp_path, meshed):
    """Two close together, and one far away, on a rank of its own or not."""
    clouds = []

    for ranks in (1, 2):
        case = AerosolCase(tmp_path/f"ranks{ranks}", meshed)
        case.model("timeStepping", STEPPINGS["eventDriven"])
        case.aerosol("length", "0.5e-3")
        case.particles(
            [
                ((61.1e-3, -0.1e-3, -0.1e-3), 8e-6),
                ((61.14e-3, -0.1e-3, -0.1e-3), 8e-6),
                ((61.45e-3, 0.1e-3, 0.1e-3), 2e-6),
            ]
        )
        clouds.append(run_on(case, ranks))

    assert_same(*clouds)


@pytest.mark.parametrize("aggregate", [
    "type equivalentSphere;", "type fractal; dimension 1.8;",
])
def test_continues_on_other_ranks(tmp_path, meshed, aggregate):
    """Half of a run on one rank, the other half on three."""
    step = 2**-17  # exact in the name of a time
    clouds = []

    for name in ("whole", "parts"):
        case = AerosolCase(tmp_path/name, meshed)
        case.model("timeStepping", STEPPINGS["eventDriven"])
        case.model("aggregate", aggregate)
        case.aerosol("numberConcentration", "30e12")
        case.exact_times(step, 10)
        case.control("endTime", repr((20 if name == "whole" else 10)*step))
        case.run("acousticDEMFoam")

        if name == "parts":
            case.control("endTime", repr(20*step))
            run_on(case, 3, "-latestTime")

        clouds.append(case.cloud(case.times()[-1]))
        contacts = case.table()["contacts"][-1]
        print(contacts, "contacts")
        assert contacts > 3

    for name, values in clouds[0].items():
        assert np.array_equal(values, clouds[1][name]), name


def test_noise_continues_on_ranks_without_particles(tmp_path, meshed):
    """Decomposed, there is no time of a rank that has none, nor its number."""
    step = 2**-17
    clouds = []

    for name in ("whole", "parts"):
        case = AerosolCase(tmp_path/name, meshed)
        case.model("timeStepping", STEPPINGS["eventDriven"])
        case.replace(
            "constant/aerosolProperties", "gravity\n",
            "Brownian { type OrnsteinUhlenbeck; seed 3; }\n\ngravity\n",
        )
        case.particles(
            [
                ((61.4e-3, 0.2e-3, 0.2e-3), 1e-6),
                ((61.45e-3, 0.21e-3, 0.2e-3), 2e-6),
            ]
        )
        case.exact_times(step, 10)
        case.control("endTime", repr((20 if name == "whole" else 10)*step))
        case.run("acousticDEMFoam")

        if name == "parts":
            case.control("endTime", repr(20*step))
            run_on(case, 4, "-latestTime")
        clouds.append(case.cloud(case.times()[-1]))

    for name, values in clouds[0].items():
        assert np.array_equal(values, clouds[1][name]), name
