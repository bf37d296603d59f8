"""What users do with a case besides running it once."""

import pytest

SOLVER = "acousticDEMFoam"


def short(box):
    """Twenty steps."""
    box.control("deltaT", "5e-6")
    box.control("endTime", "1e-4")
    box.control("writeInterval", "20")
    return box


@pytest.mark.parametrize(
    "model", ["drag", "gravity", "wake", "contact", "aggregate"]
)
def test_every_law_can_be_switched_off(box, model):
    box.model(model, "type none;")
    assert "\nEnd\n" in short(box).run(SOLVER)


@pytest.mark.parametrize("name, key, value", [
    ("domain", "centre", "(0.0612 0 0)"),
    ("particles", "seed", "2"),
])
def test_a_changed_source_is_not_ignored(box, name, key, value):
    short(box).run(SOLVER)
    box.control("endTime", "1")
    box.aerosol(key, value)
    log = box.run(SOLVER, status=1)
    assert f"dictionary '{name}' has changed" in " ".join(log.split())


def test_postprocessing_leaves_the_tables_alone(box):
    short(box).run(SOLVER)
    before = sorted(box.path.glob("postProcessing/aerosol/*/*"))
    content = [file.read_bytes() for file in before]
    box.run(SOLVER, "-postProcess")
    after = sorted(box.path.glob("postProcessing/aerosol/*/*"))
    assert before == after
    assert content == [file.read_bytes() for file in after]


def test_aggregates_that_outgrow_the_box_can_be_restarted(box):
    """Two of 11 um become one of 13.9, whose wakes reach 277 um."""
    box.model("gravity", "type none;")
    box.model("wake", "type Oseen; range 20;")
    box.replace(
        "constant/acousticProperties", r"(?s)type.*antinode", "type quiescent;"
    )
    box.model(
        "particles",
        "density 2300; source list; particles ("
        "{ position (0.0613 0 0); diameter 11e-6; velocity (0 0 0.1); }"
        "{ position (0.0613 0 11.5e-6); diameter 11e-6; velocity (0 0 -0.1); }"
        ");",
    )
    first = short(box).run(SOLVER)
    assert "1 of 2 particles left" in first
    assert "the largest aggregate" in " ".join(first.split())

    box.control("startFrom", "latestTime")
    box.control("endTime", "2e-4")
    assert "Continuing with the 1 particles" in box.run(SOLVER)


def test_a_run_that_has_ended_says_how_to_go_on(box):
    first = short(box).run(SOLVER)
    box.control("startFrom", "latestTime")
    again = box.run(SOLVER)
    hint = "there is nothing to do. To go on, make 'endTime' larger"
    assert hint not in first
    assert hint in again and "\nEnd\n" in again
