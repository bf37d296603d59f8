"""Every tutorial runs: all that its Allrun does, for a few steps."""

import re
from pathlib import Path

import pytest
from foamcase import FoamCase

TUTORIALS = sorted(
    Path(__file__).resolve().parents[3].glob("tutorials/*/Allrun")
)


def steps(allrun):
    """What an Allrun runs before it shows the results."""
    return [
        line.split()[1:]
        for line in allrun.read_text().splitlines()
        if line.startswith("runApplication") and "PYTHON" not in line
    ]


@pytest.mark.parametrize("allrun", TUTORIALS, ids=lambda f: f.parent.name)
def test_runs(tmp_path, allrun):
    case = FoamCase(allrun.parent, tmp_path/"case")
    control = (case.path/"system/controlDict").read_text()
    deltaT = re.search(r"^deltaT +([^;]*);", control, re.M)[1]
    value = re.sub(r"[{}]", " ", deltaT.replace("#eval", ""))

    # Defined before it is used
    case.replace("system/controlDict", r"(?m)^endTime [^;]*;", "")
    case.replace(
        "system/controlDict", r"(?m)^deltaT [^;]*;",
        f"deltaT {deltaT};\nendTime #eval{{ 3*({value}) }};",
    )

    commands = steps(allrun)
    assert ["acousticDEMFoam"] in commands
    for command in commands:
        log = case.run(*command)
        assert "End" in log

    log = (case.path/"log.acousticDEMFoam").read_text()
    assert log.rstrip().endswith("End")

    # Ours: those of function objects that miss the end of the run do not count
    assert not re.search(r"FOAM Warning.*\n.*(aerosol|acoustics)::", log), log
