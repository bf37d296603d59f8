"""Unsteady drag in the solver: what the slip has been is kept with the particle.

In files, from rank to rank, and in a restart on another number of ranks.
"""

import numpy as np
import pytest
from aerosolcase import AerosolCase

# A power of two, of which all multiples are exact in the name of a time
STEP = 2**-17  # s


def prepare(directory, meshed, stepping, drag="type Basset;"):
    """Thirty steps of a dense aerosol, with some mergers."""
    case = AerosolCase(directory, meshed)
    case.model("timeStepping", stepping)
    case.model("wake", "type Oseen; range 15;")
    case.aerosol("numberConcentration", "6e13")
    case.aerosol("length", "(0.38e-3 0.36e-3 0.34e-3)")
    case.replace(
        "constant/aerosolProperties", "gravity\n",
        f"unsteadyDrag {{ {drag} }}\n\ngravity\n",
    )
    case.exact_times(STEP, 15)
    case.control("endTime", repr(30*STEP))
    return case


def end(case):
    """The last cloud."""
    return case.cloud(case.times()[-1])


@pytest.mark.parametrize("stepping", [
    "type eventDriven;", "type multipleTimeStep; kp 1; kc 1;",
])
def test_goes_on_anywhere(tmp_path, meshed, stepping):
    """Half of the run on one rank, the rest on two: as the whole on one."""
    whole = prepare(tmp_path/"whole", meshed, stepping)
    whole.run("acousticDEMFoam")

    parts = prepare(tmp_path/"parts", meshed, stepping)
    parts.control("endTime", repr(15*STEP))
    parts.run("acousticDEMFoam")
    parts.control("endTime", repr(30*STEP))
    log = parts.run_on(2, "-latestTime")

    assert "Continuing with the" in log
    assert "begins anew" not in log

    contacts = whole.table()["contacts"]
    print(contacts[-1], "contacts")
    assert contacts[-1] > 3

    a, b = end(whole), end(parts)
    assert len(a["id"]) < len(whole.cloud("0")["id"])
    for name, values in a.items():
        assert np.array_equal(values, b[name]), name


def test_matters(tmp_path, meshed):
    """In files and speeds; and nothing is left of it without."""
    stepping = "type eventDriven;"
    clouds = []

    for drag in ("type Basset;", "type none;"):
        case = prepare(tmp_path/drag.split()[1], meshed, stepping, drag)
        case.control("endTime", repr(15*STEP))
        case.run("acousticDEMFoam")
        clouds.append(end(case))

        written = list(case.path.rglob("history*"))
        assert bool(written) == ("Basset" in drag)

    a, b = clouds
    kept, i, j = np.intersect1d(a["id"], b["id"], return_indices=True)
    k = np.argmax(a["d"][i])
    change = a["U"][i[k]] - b["U"][j[k]]
    assert np.linalg.norm(change) > 0.05*np.linalg.norm(b["U"][j[k]])


def test_of_another_kind_begins_anew(tmp_path, meshed):
    """Histories that were written with other times are of no use."""
    case = prepare(tmp_path/"case", meshed, "type eventDriven;")
    case.control("endTime", repr(15*STEP))
    case.run("acousticDEMFoam")

    case.control("endTime", repr(20*STEP))
    case.control("writeInterval", "5")
    case.replace(
        "constant/aerosolProperties", "type Basset;",
        "type Basset; frequencies (100 10000);",
    )
    log = case.run("acousticDEMFoam")
    assert log.count("begins anew") == 1
    assert np.isfinite(end(case)["U"]).all()


def test_leaves_no_files_of_a_longer_one(tmp_path, meshed):
    """Times are written once more: with fewer numbers, there are fewer files."""
    numbers = []

    for frequencies in ("frequencies (1 1000000);", ""):
        if not numbers:
            case = prepare(
                tmp_path/"case", meshed, "type eventDriven;",
                f"type Basset; {frequencies}",
            )
        else:
            case.replace(
                "constant/aerosolProperties", r"frequencies [^;]*;", ""
            )
        case.control("startFrom", "startTime")
        case.control("endTime", repr(2*STEP))
        case.control("writeInterval", "2")
        case.run("acousticDEMFoam")
        files = case.path.glob(f"{case.times()[-1]}/**/history[0-9]*")
        numbers.append(len(list(files)))

    print(numbers, "files")
    assert 0 < numbers[1] < numbers[0]
