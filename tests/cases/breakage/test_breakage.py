"""Aggregates that merge and break: who is who, on any ranks, and going on."""

import numpy as np
import pytest
from aerosolcase import AerosolCase

STEP = 2**-17  # s, exact in the name of a time

LAWS = {
    # Very weak bonds: the drag on such small ones, and more so the strain of a
    # sound, would not break real ones
    "drag": "type drag; bond { type JKR; workOfAdhesion 1e-6; }",
    # Softer than any solid, that impacts in sound break nearly all
    "impact": """
        type impact; fragments two; share 0.3; factor 0.1;
        bond { type JKR; workOfAdhesion 1e-3; YoungsModulus 1e9; }
    """,
    "shear": """
        type shear; fragments two; share 0.4;
        bond { type Rumpf; HamakerConstant 1e-28; }
    """,
}


def make(directory, meshed, law, steps):
    case = AerosolCase(directory, meshed)
    case.model("timeStepping", "type eventDriven;")
    case.model("aggregate", "type fractal; dimension 1.8;")
    # Denser for impacts, that aggregates meet
    case.aerosol("numberConcentration", "80e12" if law == "impact" else "40e12")
    case.exact_times(STEP, 15)
    case.control("endTime", repr(steps*STEP))
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant"/"aerosolProperties").read_text()
        + f"\nbreakage {{ {LAWS[law]} }}\n"
        + "report { contacts yes; breakages yes; }\n",
    )
    return case


def rows(case, name):
    """Those of all runs in their order, as text."""
    runs = sorted(
        (case.path/"postProcessing/aerosol").iterdir(),
        key=lambda path: float(path.name),
    )
    return [
        line.split()
        for run in runs for line in (run/f"{name}.dat").read_text().splitlines()
        if not line.startswith("#")
    ]


@pytest.mark.parametrize("law", LAWS)
def test_keeps_account(tmp_path, meshed, law):
    """Half of a run on one rank, the other half on three; all that was there
    is there, and everybody has one name."""
    whole = make(tmp_path/"whole", meshed, law, 30)
    whole.run("acousticDEMFoam")

    parts = make(tmp_path/"parts", meshed, law, 15)
    parts.run("acousticDEMFoam")
    parts.control("endTime", repr(30*STEP))
    parts.run_on(3, "-latestTime")

    first = whole.cloud("0")
    last = whole.cloud(whole.times()[-1])
    again = parts.cloud(parts.times()[-1])

    for name, values in last.items():
        assert np.array_equal(values, again[name]), name

    contacts = rows(whole, "contacts")
    breakages = rows(whole, "breakages")
    assert rows(parts, "contacts") == contacts
    assert rows(parts, "breakages") == breakages

    # From the tables alone: who is there, with how many primaries
    n = len(first["id"])
    there = dict.fromkeys(first["id"], 1)
    # A piece that is put onto a neighbour meets it at once
    events = [(float(row[0]), 0, row) for row in breakages]
    events += [(float(row[0]), 1, row) for row in contacts]
    for _, met, row in sorted(events, key=lambda event: event[:2]):
        one, other = int(row[1]), int(row[2])
        if not met:
            assert int(row[5]) == there[one]
            assert other not in there and other >= n
            there[one] -= int(row[6])
            there[other] = int(row[6])
        else:
            there[one] += there.pop(other)

    assert there == dict(zip(last["id"], last["primaries"]))
    assert last["primaries"].sum() == n

    broken = [int(row[2]) for row in breakages]
    assert broken == list(range(n, n + len(broken)))

    table = whole.table()
    volume = (first["d"]**3).sum()
    print(f"{law}: {len(contacts)} contacts, {len(broken)} breakages; mass and"
          f" volume changed by {np.ptp(table['mass'])/table['mass'][0]:.1g} and"
          f" {(last['d']**3).sum()/volume - 1:.1g}")
    assert len(broken) > 5
    assert np.ptp(table["mass"]) < 1e-13*table["mass"][0]
    assert (last["d"]**3).sum() == pytest.approx(volume, rel=1e-13)
