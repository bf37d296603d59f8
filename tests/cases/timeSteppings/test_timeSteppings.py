"""The time steppings agree about who meets whom."""

import numpy as np
import pytest
from aerosolcase import AerosolCase

STEPPINGS = {
    "conventional": "type conventional; kc 0.1;",
    "multipleTimeStep": "type multipleTimeStep; kp 1; kc 0.1;",
}


@pytest.mark.parametrize("wake", ["type none;", "type Oseen; range 20;"])
def test_same_contacts(tmp_path, meshed, wake):
    tables, clouds = {}, {}

    for name, text in STEPPINGS.items():
        case = AerosolCase(tmp_path/name, meshed)
        case.model("timeStepping", text)
        case.model("wake", wake)
        case.aerosol("min", "1e-6")
        case.aerosol("numberConcentration", "80e12")
        case.aerosol("length", "0.3e-3")
        case.aerosol("max", "5e-6")
        case.control("endTime", "#eval{ 0.3/$frequency }")
        case.control("writeInterval", "10")
        case.run("acousticDEMFoam")
        tables[name] = case.table()
        clouds[name] = case.cloud(case.times()[-1])

    one, other = tables.values()
    print("contacts", one["contacts"], other["contacts"])
    assert np.array_equal(one["time_s"], other["time_s"])
    assert one["contacts"][-1] > 10
    assert np.abs(one["contacts"] - other["contacts"]).max() <= 2

    # Not only as many, but the same: of the survivors nearly all
    ids = [set(cloud["id"]) for cloud in clouds.values()]
    assert len(ids[0] ^ ids[1]) <= 4

    # What neither has merged otherwise moves alike: the gas's own displacement
    # is 174 um. At 100, 200 and 400 steps a period the median is 63, 16 and
    # 4 nm without wakes, 223, 78 and 31 nm with them.
    common = sorted(ids[0] & ids[1])
    rows = [np.searchsorted(cloud["id"], common) for cloud in clouds.values()]
    d, x = (
        [cloud[field][row] for cloud, row in zip(clouds.values(), rows)]
        for field in ("d", "position")
    )
    alike = d[0] == d[1]
    assert alike.mean() > 0.98
    apart = np.linalg.norm(x[0] - x[1], axis=1)[alike]
    print("apart, median and largest", np.median(apart), apart.max())
    assert np.median(apart) < (1e-7 if "none" in wake else 4e-7)


@pytest.mark.parametrize("wake", ["type none;", "type Oseen; range 20;"])
@pytest.mark.parametrize("stepping", ["type eventDriven;", *STEPPINGS.values()])
def test_without_drag_all_go_straight_on(tmp_path, meshed, stepping, wake):
    case = AerosolCase(tmp_path/"case", meshed)
    case.model("timeStepping", stepping)
    case.model("wake", wake)
    case.model("drag", "type none;")
    case.model("gravity", "type none;")
    case.model("contact", "type none;")
    x = np.array([0.0613, 0, 0]) + 1e-5*np.arange(-9, 11, 2)[:, None]
    v = np.array([0.3, -0.2, 0.1])*np.arange(10)[:, None]
    case.model("particles", "density 2300; source list; particles (" + "".join(
        "{{ position ({:.17g} {:.17g} {:.17g}); diameter 5e-6;"
        " velocity ({:.17g} {:.17g} {:.17g}); }}\n".format(*a, *b)
        for a, b in zip(x, v)
    ) + ");")
    case.control("endTime", "#eval{ 0.1/$frequency }")
    case.control("writeInterval", "10")
    case.run("acousticDEMFoam")
    last = case.cloud(case.times()[-1])
    way = last["position"] - x - 0.1/1400*v
    assert np.abs(way - 0.5e-3*np.round(way/0.5e-3)).max() < 1e-14
    assert np.abs(last["U"] - v).max() < 1e-14


@pytest.mark.parametrize("stepping", [
    "type eventDriven;", STEPPINGS["multipleTimeStep"],
], ids=["eventDriven", "multipleTimeStep"])
@pytest.mark.parametrize("wake, alike", [
    ("none", False), ("Oseen", False), ("none", True),
])
def test_a_step_is_shorter_than_the_box(box, stepping, wake, alike):
    """Also the first one, from rest: else the search for neighbours among all
    periodic images on the way would have no end."""
    if alike:
        box.replace(
            "constant/aerosolProperties", r"lognormal;[^}]*\}",
            "monodisperse; diameter 2e-6; }",
        )
    box.model("timeStepping", stepping)
    box.model(
        "wake", "type Oseen; range 20;" if wake == "Oseen" else "type none;"
    )
    box.model("gravity", "type uniform; value (0 0 -2147483648);")
    log = box.run("timeout", 120, "acousticDEMFoam", status=1)
    assert log.count("FOAM FATAL") == 1
    assert "which is more than the shortest edge of the domain" in log
