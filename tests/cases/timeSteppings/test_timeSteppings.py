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
    assert np.array_equal(one["time"], other["time"])
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
    case.replace(
        "constant/aerosolProperties", "  seed", "  initialVelocity rest; seed"
    )
    case.control("endTime", "#eval{ 0.1/$frequency }")
    case.control("writeInterval", "10")
    case.run("acousticDEMFoam")
    first, last = (case.cloud(case.times()[k]) for k in (0, -1))
    assert np.array_equal(first["position"], last["position"])
    assert not last["U"].any()
