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
        bond { type Rumpf; HamakerConstant 2e-27; }
    """,
}


def make(directory, meshed, law, steps):
    case = AerosolCase(directory, meshed)
    case.model("timeStepping", "type eventDriven;")
    case.model("aggregate", "type fractal; dimension 1.8;")
    # Denser for impacts, that aggregates meet
    case.aerosol("numberConcentration", "80e12" if law == "impact" else "40e12")
    # The strain of a standing wave is zero at its velocity antinode
    if law == "shear":
        case.aerosol("centre", "(0.0521 0 0)")
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
    """As text."""
    file = case.path/f"postProcessing/aerosol/{name}.csv"
    return [line.split(",") for line in file.read_text().splitlines()[1:]]


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
    events = [(float(row[0]), 0, row[1], row[4], row) for row in breakages]
    events += [(float(row[0]), 1, row[1], row[2], row) for row in contacts]
    for _, met, one, other, row in sorted(events, key=lambda event: event[:2]):
        one, other = int(one), int(other)
        if not met:
            assert int(row[3]) == there[one]
            assert other not in there and other >= n
            there[one] -= int(row[6])
            there[other] = int(row[6])
        else:
            there[one] += there.pop(other)

    assert there == dict(zip(last["id"], last["primaries"]))
    assert last["primaries"].sum() == n

    broken = [int(row[4]) for row in breakages]
    assert broken == list(range(n, n + len(broken)))

    table = whole.table()
    volume = (first["d"]**3).sum()
    print(f"{law}: {len(contacts)} contacts, {len(broken)} breakages; mass and"
          f" volume changed by {np.ptp(table['mass_kg'])/table['mass_kg'][0]:.1g} and"
          f" {(last['d']**3).sum()/volume - 1:.1g}")
    assert len(broken) > 5
    assert np.ptp(table["mass_kg"]) < 1e-13*table["mass_kg"][0]
    assert (last["d"]**3).sum() == pytest.approx(volume, rel=1e-13)


@pytest.mark.parametrize("stepping", [
    "type conventional; kc 0.1;", "type multipleTimeStep; kc 0.1; kp 0.02;",
    "type eventDriven;",
])
def test_breaks_though_it_moves_on(tmp_path, meshed, stepping):
    """Who is hit hard on one rank, and merges softly on another one in a later
    part of the same step, breaks at the end of that step."""
    found = []
    for ranks in (1, 2):
        case = AerosolCase(tmp_path/str(ranks), meshed)
        case.exact_times(STEP, 2)
        case.control("endTime", repr(2*STEP))
        case.entry("constant/acousticProperties", "SPL", 40)
        case.model("timeStepping", stepping)
        case.model(
            "domain", "type periodicBox; centre (0.0613 0 0);"
            " length (5e-4 6e-4 4e-4);"
        )
        case.model("particles", """density 2400; source list; particles
            (
                { position (0.0613 -4e-6 0); diameter 4e-6; primaries 100;
                  velocity (0 3 0); }
                { position (0.0613 3e-6 0); diameter 5e-6; primaries 100;
                  velocity (0 0 0); }
                { position (0.0613 11.35e-6 0); diameter 8e-6; primaries 20000;
                  velocity (0 0 0); }
            );""")
        case.model("drag", "type Stokes; slipCorrection none;")
        case.model("gravity", "type none;")
        case.model("wake", "type none;")
        case.write(
            "constant/aerosolProperties",
            (case.path/"constant"/"aerosolProperties").read_text()
            + "breakage { type impact; bond { type JKR; workOfAdhesion 0.05;"
            " YoungsModulus 70e9; } }\n"
            + "report { contacts yes; breakages yes; }\n",
        )
        if ranks == 1:
            case.run("acousticDEMFoam")
        else:
            case.run_on(ranks)
        found.append((rows(case, "contacts"), rows(case, "breakages"),
                      case.cloud(case.times()[-1])))

    one, two = found
    assert len(one[0]) == 2 and len(one[1]) == 1
    assert {float(row[0]) <= STEP for row in one[0]} == {True}
    assert float(one[1][0][0]) == pytest.approx(STEP)
    assert two[:2] == one[:2]
    for name, values in one[2].items():
        assert np.array_equal(values, two[2][name]), name
