"""Mistakes that are not in one entry alone: files, fields, sources, meshes."""

import re
import shutil
import sys
from pathlib import Path

import pytest
from aerosolcase import AerosolCase
from test_badInput import ACOUSTIC, AEROSOL, CONTROL, SOURCE, check_refusal

sys.path.append(str(Path(__file__).resolve().parents[2]/"fuzzing"))

import fuzzing  # noqa: E402
from bases import HEADER  # noqa: E402

SOLVER = "acousticDEMFoam"


def copied(base, directory):
    """A copy of a case with its fields."""
    case = AerosolCase(directory/"case", base)
    shutil.copytree(base/"0", case.path/"0")
    return case


@pytest.fixture(scope="session", name="bases")
def fixture_bases(tmp_path_factory):
    folder = tmp_path_factory.mktemp("bases")
    fuzzing.make_bases(folder)
    return folder


@pytest.fixture(name="tube")
def fixture_tube(tmp_path, bases):
    """A piston, a radiating end, level control; sound that is solved."""
    return copied(bases/"solved", tmp_path)


def flat(log):
    return " ".join(log.split())


def test_a_dictionary_for_a_value(box):
    """One message, and no stack."""
    box.replace(AEROSOL, r"type +Oseen;", "type { Oseen; }")
    log = box.run(SOLVER, status=1)
    check_refusal(log, None, f"'type' of .*{AEROSOL}.wake.* must be a value")


# Something else in the place of a file

@pytest.mark.parametrize("kind", ["link", "folder"])
@pytest.mark.parametrize("file", [ACOUSTIC, AEROSOL])
def test_no_file(box, file, kind):
    (box.path/file).unlink()
    if kind == "link":
        (box.path/file).symlink_to("nowhere")
    else:
        (box.path/file).mkdir()
    check_refusal(box.run(SOLVER, status=1), None, rf"{file}\W* is no file .* {kind}")


def test_a_table_that_is_a_folder(box):
    (box.path/"list.csv").mkdir()
    box.replace(AEROSOL, SOURCE, 'source list; file "list.csv";')
    check_refusal(box.run(SOLVER, status=1), AEROSOL, "it is no file")


# Tables

def test_a_table_saved_by_a_spreadsheet_is_read(box):
    """Byte order mark, carriage returns, and empty lines."""
    (box.path/"list.csv").write_bytes(
        b"\xef\xbb\xbfx,y,z,d\r\n\r\n0.0613,0,0,1e-6\r\n"
    )
    box.replace(AEROSOL, SOURCE, 'source list; file "list.csv";')
    assert "Aerosol: 1 particles" in box.run(SOLVER, "-dry-run")


@pytest.mark.parametrize("content, message", [
    (b"x,y,z,d\n0.0613,0,0,1e400\n", "line 2.*|'1e400' is not a finite number"),
    (b"x,y,z,d\n0.0613,0,0," + 400*b"9" + b"\n", "9' is not a finite number"),
    ("x,y,z,d\n0.0613,0,0,1e-6\n".encode("utf-16"), "UTF-16"),
    ("x,y,z,\u00a0d\n".encode(), r"not 'x,y,z,<U\+00A0>d'"),
    ("x,y,z,d\n0.0613,0,\u22121e-6,1e-6\n".encode(), r"'<U\+2212>1e-6' is not"),
])
def test_cells_that_are_no_numbers(box, content, message):
    (box.path/"list.csv").write_bytes(content)
    box.replace(AEROSOL, SOURCE, 'source list; file "list.csv";')
    check_refusal(box.run(SOLVER, status=1), "list.csv", message)


# The gas

@pytest.mark.parametrize("file, value, message", [
    ("0/p", "0", "0 Pa, .* gauge pressure"),
    ("0/p", "-100", "-100 Pa, .* gauge pressure"),
    ("0/p", "1.013", "in bar"),
    ("0/T", "20", "20 K, .*Celsius"),
    ("0/T", "0", "0 K, .*Celsius"),
    ("0/p", "1e400", "1e400|bad|ill defined"),
])
def test_gas_that_is_none(tube, file, value, message):
    tube.replace(file, r"internalField[^;]*;", f"internalField uniform {value};")
    log = tube.run(SOLVER, status=1)
    check_refusal(log, None, message)
    assert file in log[log.index("FATAL"):]
    assert "diverged" not in log


def test_gas_by_its_temperature(box):
    box.replace(ACOUSTIC, "SPL", "gas { T 423.15; } SPL")
    log = box.run(SOLVER, "-dry-run")
    gas = re.search(
        r"\nGas: density (\S+) kg/m3, viscosity (\S+) Pa s, temperature 423.15 K,"
        r" sound speed (\S+) m/s, mean free path (\S+) m,"
        r" heat capacity (\S+) J/kg/K, conductivity (\S+) W/m/K\n", log
    )
    assert log.lower().count("gas: ") == 1
    assert [float(x) for x in gas.groups()] == pytest.approx(
        [0.834, 2.38e-5, 411, 105e-9, 1017, 0.0348], rel=0.02
    )
    assert float(re.search(r"wavelength (\S+) m", log)[1]) == pytest.approx(
        0.2938, rel=1e-3
    )


# What must agree

def test_a_source_of_another_frequency(tube):
    tube.replace("0/U", "frequency 1400", "frequency 1450")
    log = tube.run(SOLVER, status=1)
    check_refusal(log, ACOUSTIC, "left .*1450 Hz, .*control is 1400 Hz")

    tube.replace(ACOUSTIC, r"control\s*\{[^}]*\}", "")
    log = flat(tube.run(SOLVER))
    log = log[log.rindex("Create time"):]
    assert re.search(r"1450 Hz, but 'frequency' in \S+sound is 1400 Hz", log)
    assert re.search(r"1450 Hz, but 'frequency' of the function object level", log)


def test_a_period_that_no_source_has(tmp_path, bases):
    case = copied(bases/"periodic", tmp_path)
    case.replace("0/p", r"table[^;]*;", "1450;")
    case.replace(ACOUSTIC, "startTime 2e-5;", "")
    log = case.run(SOLVER, status=1)
    check_refusal(log, ACOUSTIC, "1450 Hz, .*periodic is 1400 Hz: .*startTime")


@pytest.mark.parametrize("file, pattern, text, message", [
    ("0/p", "gamma 1.4", "gamma 1.2", "'gamma' .* is 1.2, but Cp/Cv .* 1.39"),
    ("0/p", "fieldInf 101325", "fieldInf 1e5", "'fieldInf' .* 100000 Pa, but"),
])
def test_openings_that_do_not_fit_the_gas(tube, file, pattern, text, message):
    tube.replace(file, pattern, text)
    assert re.search(message, flat(tube.run(SOLVER)))


def test_another_ambient_pressure(tmp_path, bases):
    case = copied(bases/"periodic", tmp_path)
    case.replace("0/p", "ambient 101325", "ambient 1e5")
    assert "'ambient' of the source at the patch left" in flat(case.run(SOLVER))


@pytest.mark.parametrize("pattern, text, message", [
    ("frequency 1400;", "frequency 1400", "'frequency' .* goes on with 'phase"),
    ("velocityAmplitude 0.2", "velocityAmplitude 0.2 0.2", "goes on with '0.2'"),
    (r"\(0 0 0\);\n    \}", "(0 0 0) 1;\n    }", "'value' .* goes on with '1'"),
    ("rampPeriods", "rampPeriod", "Unknown entry 'rampPeriod' .*rampPeriods"),
    ("velocityAmplitude 0.2", "velocityAmplitude 900", "speed of sound, 343"),
    ("frequency 1400", "frequency 0", "must be positive"),
])
def test_sources(tube, pattern, text, message):
    tube.replace("0/U", pattern, text)
    log = tube.run(SOLVER, status=1)
    check_refusal(log, None, message)
    assert "0/U" in log[log.index("FATAL"):]


# The function object

def test_a_level_of_no_field(tube):
    tube.replace(CONTROL, "harmonics 2;", "harmonics 2; p pressure; U velocity;")
    log = flat(tube.run(SOLVER))
    assert log.count("has nothing to do") == 1
    assert "no pressure 'pressure' or no velocity 'velocity'" in log


def test_an_unknown_entry_of_the_level(tube):
    tube.replace(CONTROL, "harmonics 2;", "harmonic 2;")
    assert "Unknown entry 'harmonic'" in flat(tube.run(SOLVER))


# Times

def test_an_end_that_is_never_reached(box):
    """Until it is stopped, and without a time that no clock has."""
    box.replace(CONTROL, r"endTime +#[^}]*\}", "endTime 1e20; reportInterval 0")
    box.replace(CONTROL, r"stopAt +endTime", "stopAt nextWrite")
    assert "\nEnd\n" in box.run(SOLVER)


# Meshes

def bent(case, cells="10 10 1"):
    """Three quarters of a square."""
    points = [(x, y, z) for z in (0, 1) for y in (0, 1, 2) for x in (0, 1, 2)]
    at = {p: i for i, p in enumerate(points)}

    def block(x, y):
        corners = [
            (x + i, y + j, z) for z in (0, 1) for i, j in
            ((0, 0), (1, 0), (1, 1), (0, 1))
        ]
        return " ".join(str(at[c]) for c in corners)

    case.write("system/blockMeshDict", HEADER.format(
        "dictionary", "blockMeshDict"
    ) + "scale 0.01; vertices (" + " ".join(
        f"({x} {y} {z})" for x, y, z in points
    ) + ");\nblocks (" + "".join(
        f"hex ({block(x, y)}) ({cells}) simpleGrading (1 1 1)\n"
        for x, y in ((0, 0), (1, 0), (0, 1))
    ) + ");\ndefaultPatch { name walls; type wall; }\nboundary ();\n")
    case.run("blockMesh")


@pytest.mark.parametrize("centre", ["(0.015 0.015 0.005)", "(0.01 0.01 0.005)"])
def test_a_box_beside_the_cells(box, centre):
    """Within the box around the mesh, but not, or not all, in the mesh."""
    bent(box)
    box.replace(AEROSOL, r"centre [^;]*;", f"centre {centre};")
    log = box.run(SOLVER, status=1)
    check_refusal(log, AEROSOL, "leaves the mesh, .* not of the shape of a box")


def test_a_box_is_carried_to_the_wall(box):
    """The leg ends at 1 cm, the box around the mesh at 2 cm."""
    bent(box)
    box.replace(AEROSOL, r"centre [^;]*;", "centre (0.015 0.005 0.005);")
    box.replace(AEROSOL, "domain", "frame { velocity (0 0.5 0); }\ndomain")
    log = box.run(SOLVER, "-dry-run")
    end = re.search(r"domain moves, and leaves the mesh at (\S+) s", log)[1]
    assert float(end) == pytest.approx((0.01 - 0.005 - 0.25e-3)/0.5, rel=1e-5)


def test_cells_are_as_long_as_they_are_along_the_mesh(tube):
    """A tube that is turned has no larger cells, nor has a wide one."""
    def cells(*turn):
        tube.run("blockMesh")
        if turn:
            tube.run("transformPoints", "-rotate", *turn)
        log = tube.run(SOLVER, "-dry-run")
        return float(re.findall(r"(\S+) cells per wavelength", log)[-1])

    (tube.path/AEROSOL).unlink()
    tube.replace(ACOUSTIC, r"control\s*\{[^}]*\}", "")
    tube.replace("system/blockMeshDict", "type empty", "type wall")
    tube.replace("0/U", r"sides \{[^}]*\}", "sides { type slip; }")
    for field in "p", "T":
        tube.replace(f"0/{field}", r"sides \{[^}]*\}", "sides { type zeroGradient; }")

    straight = cells()
    assert straight == pytest.approx(50, rel=0.01)
    assert cells("((1 0 0) (0.8 0.6 0))") == pytest.approx(straight, rel=1e-3)


# Errors of OpenFOAM that name no file

def test_a_function_object_that_overflows(tmp_path, bases):
    case = AerosolCase(tmp_path/"case", bases/"table")
    case.replace(CONTROL, r"\(\(0\.06 0\.005", "((0.06 1e300")
    log = case.run(SOLVER, status=1)
    assert "running the function objects of " in log[log.index("FATAL"):]
    assert "system/controlDict" in log[log.index("FATAL"):]


def test_a_table_of_a_source_that_goes_back(tmp_path, bases):
    case = copied(bases/"periodic", tmp_path)
    case.replace("0/p", r"\(1 1400\)", "(-1 1400)")
    log = case.run(SOLVER, status=1)
    assert "This was while reading 0/p" in log[log.index("FATAL"):]
