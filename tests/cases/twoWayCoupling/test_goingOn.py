"""A coupled run goes on after a restart and on other numbers of ranks."""

import os
import shutil
import subprocess
from pathlib import Path

import numpy as np
import pytest
from aerosolcase import AerosolCase
from foamcase import ROOT

N = 200  # particles


def prepare(directory, end, number=N, shift=0):
    """A tube with an aerosol of which much is yet to come in each step."""
    case = AerosolCase(directory, ROOT/"tutorials/aerosolAttenuation")
    case.entry("system/tube", "omegaTau", 0.5)
    case.entry("system/tube", "massLoading", 0.3)
    case.entry("system/tube", "count", number)
    d = np.sqrt(18*1.81e-5*0.5/(2*np.pi*1400*2300))
    case.particles(
        [
            (((i + 0.5)/number*0.1226 + shift, 5e-3, 5e-3), d)
            for i in range(number)
        ]
    )
    case.model("drag", "type SchillerNaumann; slipCorrection Cunningham;")
    case.control("endTime", f"#eval{{ {end}.0/$frequency }}")
    case.control("writeInterval", "200")
    case.run("blockMesh")
    case.run("setExprFields")
    return case


@pytest.fixture(scope="module", name="whole")
def fixture_whole(tmp_path_factory):
    case = prepare(tmp_path_factory.mktemp("whole")/"case", 2)
    case.run("acousticDEMFoam")
    return case.probes("history", "p")[1][:, 0]


@pytest.mark.parametrize("forget, jump", [
    ((), 0), (("aerosolForce",), None), (("aerosolImpulse_0",), 1e-6),
])
def test_restart(tmp_path, whole, forget, jump):
    case = prepare(tmp_path/"case", 1)
    case.run("acousticDEMFoam")
    for name in forget:
        (case.path/case.times()[-1]/name).unlink()
    case.control("endTime", "#eval{ 2.0/$frequency }")
    if jump is None:
        # Half of a state is refused
        log = case.run("acousticDEMFoam", status=1)
        assert log.count("FOAM FATAL") == 1 and forget[0] in log
        return
    case.run("acousticDEMFoam")
    parts = case.probes("history", "p")[1][:, 0]

    off = np.abs(parts - whole).max()/np.abs(whole - 101325).max()
    print(f"without {forget}: {off:.1e} of the amplitude off")
    if jump:
        assert off > jump
    else:
        assert off < 1e-8


def test_begins_again_from_the_start(tmp_path, whole):
    """After a kill before anything was written but the particles at the start."""
    case = prepare(tmp_path/"case", 1)
    case.run("acousticDEMFoam")
    assert (case.path/"0"/"lagrangian").is_dir()
    shutil.rmtree(case.path/case.times()[-1])
    case.control("endTime", "#eval{ 2.0/$frequency }")
    assert "Continuing with the" in case.run("acousticDEMFoam")
    parts = case.probes("history", "p")[1][:, 0]
    assert np.array_equal(parts, whole)


@pytest.fixture(scope="module", name="scribble")
def fixture_scribble(tmp_path_factory):
    """What LD_PRELOAD must be for a program that never gets memory back."""
    sanitizer = os.environ.get("ACOUSTICDEM_PRELOAD")
    if sanitizer:  # sees more
        return sanitizer
    library = tmp_path_factory.mktemp("scribble")/"scribble.so"
    subprocess.run(
        ["cc", "-shared", "-fPIC", "-O1", "-o", library,
         Path(__file__).with_name("scribble.c")], check=True,
    )
    return library


def run_on_two_ranks(case, scribble, n="(2 1 1)", cells=()):
    """The pressures. The ranks share the mesh by n, or by the given cells."""
    head = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"
    case.write(
        "system/decomposeParDict",
        head.format("dictionary", "decomposeParDict")
        + f"numberOfSubdomains 2; method {'manual' if cells else 'simple'};"
        f" simpleCoeffs {{ n {n}; delta 0.001; }}"
        ' manualCoeffs { dataFile "cellDecomposition"; }',
    )
    case.write(
        "constant/cellDecomposition",
        head.format("labelList", "cellDecomposition")
        + f"({' '.join(map(str, cells))})",
    )
    case.run("decomposePar")
    # A rank that crashes may leave the other one waiting
    case.run(
        "timeout", "-s", "KILL", 300, "mpirun", "--oversubscribe", "-np", 2,
        "env", f"LD_PRELOAD={scribble}", "acousticDEMFoam", "-parallel",
    )
    return case.probes("history", "p")[1][:, 0]


@pytest.mark.parametrize("shared", [
    {"n": "(2 1 1)"}, {"n": "(1 2 1)"}, {"cells": [1]*25},
], ids=["along the tube", "across it", "one rank without cells"])
def test_ranks(tmp_path, whole, scribble, shared):
    parts = run_on_two_ranks(
        prepare(tmp_path/"case", 1), scribble, **shared
    )
    first = whole[:len(parts)]
    off = np.abs(parts - first).max()/np.abs(first - 101325).max()
    print(f"two ranks: {off:.1e} of the amplitude off")
    assert off < 1e-6


@pytest.mark.parametrize("stepping", [
    "type multipleTimeStep; kp 0.5; kc 0.1;", "type conventional; kc 0.1;",
])
def test_a_particle_changes_its_rank(tmp_path, scribble, stepping):
    """It oscillates, by 2.7 um, across the middle of the tube; with these two a
    particle migrates within the step."""
    def make(name):
        case = prepare(tmp_path/name, 1, N + 1, -1e-6)
        case.model("timeStepping", stepping)
        return case

    one = make("one")
    one.run("acousticDEMFoam")
    whole = one.probes("history", "p")[1][:, 0]

    parts = run_on_two_ranks(make("two"), scribble)
    off = np.abs(parts - whole).max()/np.abs(whole - 101325).max()
    print(f"{stepping} {off:.1e} of the amplitude off")
    assert off < 1e-6


def test_clouds_act_together(tmp_path, whole):
    """Two boxes with half of the concentration each, where there was one."""
    case = prepare(tmp_path/"case", 2)
    case.write(
        "constant/aerosolProperties",
        (case.path/"constant/aerosolProperties").read_text()
        + """
double      #eval{ 2*$thickness };
clouds
{
    one { domain { length ($length $thickness $double); } }
    two { domain { length ($length $double $thickness); } }
}
""",
    )
    case.run("acousticDEMFoam")
    parts = case.probes("history", "p")[1][:, 0]
    off = np.abs(parts - whole).max()/np.abs(whole - 101325).max()
    print(f"two boxes: {off:.1e} of the amplitude off")
    assert off < 1e-10


@pytest.mark.parametrize("change, message", [
    (("represents", "(0 1 2)"), "represents"),
    (("represents", "1"), "represents"),
    (("type", "threeWay"), "none and twoWay"),
])
def test_refuses(tmp_path, change, message):
    case = AerosolCase(tmp_path/"case", ROOT/"tutorials/aerosolAttenuation")
    case.run("blockMesh")
    old = {"represents": r"represents +[^;]*", "type": r"type +\$coupling"}
    case.replace(
        "constant/aerosolProperties", old[change[0]], " ".join(change)
    )
    assert message in case.run("acousticDEMFoam", status=1)


def test_refuses_a_sound_that_feels_nothing(box):
    box.write(
        "constant/aerosolProperties",
        (box.path/"constant"/"aerosolProperties").read_text()
        + "\ncoupling { type twoWay; represents (0 0 0); }\n",
    )
    assert "is not changed by forces" in box.run("acousticDEMFoam", status=1)
