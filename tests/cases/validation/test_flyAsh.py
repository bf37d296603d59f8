"""The study of fly ash, reduced: its figures, and that it goes on."""

import os
import re
import shutil
import subprocess

import pytest
from foamcase import ROOT

# A copy: what runs may leave there should not be in the repository
FILES = shutil.ignore_patterns("results", "__pycache__", "[0-9]*", "log.*")


@pytest.fixture(name="study", scope="module")
def fixture_study(tmp_path_factory):
    root = tmp_path_factory.mktemp("validation")
    folder = root/"tutorials"/"validation"/"flyAsh"
    shutil.copytree(ROOT/"tutorials"/"validation"/"flyAsh", folder,
                    ignore=FILES)
    (root/"bin").mkdir()
    (root/"bin"/"collisionKernels").symlink_to(ROOT/"bin"/"collisionKernels")

    def run(*arguments, status=0):
        result = subprocess.run(
            ["bash", "-c", '. "$0"/bin/environment && exec "$@"', ROOT,
             folder/"study.py", *arguments],
            cwd="/", env=os.environ, stdin=subprocess.DEVNULL, text=True,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
        )
        assert result.returncode == status, result.stdout
        return result.stdout

    run.results = folder/"results"
    return run


BOX = ("--particles", "60", "--aspect", "1")
SMALL = (*BOX, "--time", "0.02", "--seeds", "2")


def rows(printed):
    """Label, total and its error of the table."""
    return re.findall(
        r"(?m)^(\S.*?) +\d+ +\d+ +[.\d]+ x [.\d]+ +([.\d]+) \+- +([.\d]+)", printed
    )


def test_levels_and_once_more(study):
    command = ("levels", *SMALL, "--levels", "140,149", "--models", "Oseen")
    first = study(*command)
    assert "4 runs" in first
    assert (study.results/"levels.png").stat().st_size > 5000
    table = rows(first)
    assert [row[0] for row in table] == [
        f"Oseen 1400 Hz {level} dB" for level in (140, 149)
    ]
    again = study(*command)
    assert "0 runs" in again
    assert rows(again) == table

    # One model more, at one of the levels
    assert "2 runs" in study(
        "models", *SMALL, "--levels", "149", "--models", "Oseen,OseenBounce"
    )
    assert (study.results/"models.png").exists()


def test_decay_of_one(study):
    """The first seed of the above, by itself."""
    printed = study("decay", *BOX, "--time", "0.02", "--seeds", "1",
                    "--levels", "149", "--models", "Oseen")
    assert "first and the second half" in printed
    assert (study.results/"decay.png").exists()


def test_goes_on_where_it_was_interrupted(study, tmp_path):
    """And for longer: the same table as without interruption."""
    command = ("levels", *BOX, "--seeds", "1", "--levels", "140",
               "--models", "none")
    study(*command, "--time", "0.27")
    (folder,) = study.results.glob(
        "runs/model=none_frequency=1400_SPL=140_count=60_*_seed=1")
    # The beginning, 0.25 s and the end
    assert len(list(folder.glob("[0-9]*"))) == 3
    printed = study(*command, "--time", "0.3")
    assert "goes on from 0.27 s" in printed
    table = rows(printed)
    whole = study(*command, "--time", "0.3", "--results", tmp_path/"whole")
    assert rows(whole) == table


def test_another_model_of_the_same_name_is_not_mixed(study):
    command = ("decay", *SMALL, "--seeds", "1", "--levels", "140",
               "--models", "noGravity")
    assert "1 runs" in study(*command)
    file = study.results.parent/"cases.py"
    text = file.read_text()
    file.write_text(text.replace("SchillerNaumann", "Stokes"))
    try:
        assert "--anew" in study(*command, status=1)
        assert "1 runs" in study(*command, "--anew")
    finally:
        file.write_text(text)


def test_what_is_wrong_is_said(study):
    assert "no model wrong" in study("levels", "--models", "wrong", status=1)
    file = study.results.parent/"cases.py"
    text = file.read_text()
    file.write_text(text.replace("type ProudmanPearson;", "type unknown;"))
    try:
        printed = study("models", *SMALL, "--seeds", "1", "--models",
                        "ProudmanPearson,none", status=1)
        assert "log.acousticDEMFoam" in printed
    finally:
        file.write_text(text)


def test_refill(study):
    """The balance follows what is refilled; what is left alone stops."""
    printed = study("refill", "--particles", "1000", "--seeds", "1",
                    "--periods", "4")
    last = printed.splitlines()[-3].split()
    assert last[0] == "4", printed
    dem, error, measured, theory, alone = (
        float(last[k]) for k in (1, 3, 4, 5, 6)
    )
    print(last)

    # Each contact is of Poisson's: 1000 particles, one in twenty of which
    # merge, and as many for the kernel
    deviation = (0.05/1000)**0.5
    assert dem == pytest.approx(theory, abs=3*deviation)
    assert dem == pytest.approx(measured, abs=3*2**0.5*deviation)
    assert 1 - alone < 0.5*(1 - dem)
    assert error < 4*deviation
