"""The quantities of the report, from the particles that were written; and what
a run costs."""

import re

import numpy as np
import pytest
from aerosolcase import AerosolCase

REPORT = """report
{
    thresholds  (1e-6 2.5e-6);
    collector   { type table; file "cyclone.csv"; }
    optics      { wavelength 550e-9; refractiveIndex 1.33; path 2; }
}

domain"""
TABLE = np.array([(0.5e-6, 0.02), (2e-6, 0.3), (5e-6, 0.9)])


def make(directory, meshed):
    case = AerosolCase(directory, meshed)
    case.replace("constant/aerosolProperties", "domain", REPORT)
    case.write("cyclone.csv", "diameter,efficiency\n" + "".join(
        f"{d!r},{share!r}\n" for d, share in TABLE.tolist()))
    case.aerosol("numberConcentration", "6e13")
    case.control("writeInterval", "25")
    case.exact_numbers()
    return case


def van_de_Hulst(d, wavelength, index):
    """The real part of 4 times van de Hulst's K(i rho), another way to write
    the efficiency: K(w) = 1/2 + exp(-w)/w + (exp(-w) - 1)/w^2."""
    w = 2j*np.pi*d/wavelength*(index - 1)
    return 4*(0.5 + np.exp(-w)/w + (np.exp(-w) - 1)/w**2).real


def quantities(cloud, volume):
    """By numpy."""
    d, m, n = cloud["d"], cloud["mass"], len(cloud["d"])
    order = np.sort(d)
    sums = (order**3).cumsum()
    passes = 1 - np.interp(np.log(d), np.log(TABLE[:, 0]), TABLE[:, 1])
    extinction = (van_de_Hulst(d, 550e-9, 1.33)*np.pi/4*d**2).sum()/volume
    return {
        "number_per_m3": n/volume,
        "mass_g_per_m3": 1e3*m.sum()/volume,
        "d10_m": d.mean(),
        "d32_m": (d**3).sum()/(d**2).sum(),
        "d43_m": (d**4).sum()/(d**3).sum(),
        "d50number_m": np.median(d),
        "d50volume_m": order[np.searchsorted(sums, 0.5*sums[-1])],
        "numberShareAbove_1um": (d > 1e-6).mean(),
        "numberShareAbove_2_5um": (d > 2.5e-6).mean(),
        "volumeShareAbove_1um": (d**3)[d > 1e-6].sum()/(d**3).sum(),
        "volumeShareAbove_2_5um": (d**3)[d > 2.5e-6].sum()/(d**3).sum(),
        **{f"primaries_{name}_per_m3":
           ((cloud["primaries"] >= a) & (cloud["primaries"] <= b)).sum()/volume
           for name, a, b in (("1", 1, 1), ("2", 2, 2), ("3to4", 3, 4),
                              ("5to8", 5, 8), ("9to16", 9, 16),
                              ("above16", 17, 1e9))},
        "extinction_per_m": extinction,
        "transmittance": np.exp(-2*extinction),
        "visibility_m": -np.log(0.02)/extinction,
        "penetration_number": passes.mean(),
        "penetration_mass": (m*passes).sum()/m.sum(),
        "massBehind_g_per_m3": 1e3*(m*passes).sum()/volume,
    }


def test_quantities_are_those_of_the_particles(tmp_path, meshed):
    """At all times that are written; the same on two ranks."""
    case = make(tmp_path/"one", meshed)
    case.run("acousticDEMFoam")
    table, course = case.table("quantities"), case.table()
    assert (table["time_s"] == course["time_s"]).all()
    volume = course["number"][0]/course["concentration_per_m3"][0]

    assert len(case.times()) > 2
    for time in case.times():
        row = np.argmin(np.abs(table["time_s"] - float(time)))
        expected = quantities(case.cloud(time), volume)
        assert list(table)[1:] == list(expected)
        for name, value in expected.items():
            assert table[name][row] == pytest.approx(value, rel=1e-11), name
    assert table["primaries_2_per_m3"][-1] > 0

    other = make(tmp_path/"two", meshed)
    other.run_on(2)
    file = "postProcessing/aerosol/quantities.csv"
    assert (case.path/file).read_text() == (other.path/file).read_text()


def test_extinction_of_spheres_that_are_alike(box):
    """Against the formula in complex numbers, and that of a fog by hand."""
    box.particles([((0.0613 + 1e-5*k, 0, 0), 3e-6) for k in range(5)])
    box.replace("constant/aerosolProperties", "domain",
                REPORT.replace("table; file \"cyclone.csv\"", "Lapple; d50 6e-6"))
    box.control("endTime", "0")
    box.run("acousticDEMFoam")
    table = box.table("quantities")
    expected = van_de_Hulst(3e-6, 550e-9, 1.33)*np.pi/4*9e-12
    assert table["extinction_per_m"]/table["number_per_m3"] == pytest.approx(
        expected, rel=1e-12)
    assert table["penetration_mass"] == pytest.approx(0.8, rel=1e-12)
    assert table["d32_m"] == pytest.approx(3e-6, rel=1e-12)


def test_mistakes_are_named(box):
    def said(report):
        box.write("constant/aerosolProperties", text + f"report\n{{\n{report}\n}}\n")
        log = " ".join(box.run("acousticDEMFoam", "-dry-run", status=1).split())
        return log.rsplit("FOAM FATAL", 1)[1]

    text = (box.path/"constant/aerosolProperties").read_text()
    for report, words in (
        ("quantities (d99);", "'d99'; valid quantities are"),
        ("quantities (extinction);", "needs the entry 'optics'"),
        ("quantities (d32); thresholds (1e-6);", "would be ignored"),
        ("collector { type cyclone; }", "Unknown collector 'cyclone'"),
        ("thresholds (3e-6 1e-6);", "which increase"),
        ("collector { type table; file \"nowhere.csv\"; }", "Cannot read"),
        ("optics { wavelength 550; refractiveIndex 1.33; }", "path"),
        ("costs no;", "costs"),
    ):
        message = said(report)
        assert words in message, message
        assert "aerosolProperties" in message


def test_what_a_run_costs(box):
    """Counts are those of the log; sums are right over a restart."""
    box.model("timeStepping", "type multipleTimeStep; kp 1; kc 0.1;")
    log = box.run("acousticDEMFoam")
    table = box.table("cost")
    n = table["fluidSteps"].sum()
    assert n == 100
    wakes, pairs = map(float, re.findall(
        r"(\S+) wakes on particles, (\S+) pairs", log)[-1])
    assert table["wakePairs"].sum()/n == pytest.approx(wakes, rel=1e-4)
    assert table["contactPairs"].sum()/n == pytest.approx(pairs, rel=1e-4)
    parts = sum(table[f"{name}_s"].sum() for name in (
        "gas", "particles", "coupling", "breakages", "tables"))
    assert 0 < table["particles_s"].sum() < parts < table["wall_s"].sum()
    assert 10 < table["memory_MB"][-1] < 10000

    box.control("endTime", "#eval{ 2.0/$frequency }")
    box.run("acousticDEMFoam")
    again = box.table("cost")
    assert (again["time_s"][:len(table["time_s"])] == table["time_s"]).all()
    assert (np.diff(again["time_s"]) > 0).all()
    assert again["fluidSteps"].sum() == 2*n

    box.replace("constant/aerosolProperties", "domain",
                "report { cost no; }\n\ndomain")
    file = box.path/"postProcessing/aerosol/cost.csv"
    file.unlink()
    box.control("endTime", "#eval{ 2.1/$frequency }")
    box.run("acousticDEMFoam")
    assert not file.exists()
