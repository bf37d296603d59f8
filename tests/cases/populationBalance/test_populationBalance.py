"""The population balance, against exact solutions and against the DEM."""

import csv
import json
import subprocess
import sys

import numpy as np
import pytest
from foamcase import ROOT

sys.path.insert(0, str(ROOT/"bin"))
import smoluchowski  # noqa: E402

T = np.linspace(0, 2, 5)


def exponential(per_doubling, kernel):
    """From n(v) = exp(-v): numbers over T, volumes of the pivots."""
    edges = smoluchowski.sections(0.01, 10, per_doubling)
    v = edges**3
    model = smoluchowski.PopulationBalance(edges, kernel)
    n = model.solve(np.exp(-v[:-1]) - np.exp(-v[1:]), T)
    return n, model.d**3


def orders(errors):
    return np.log2(np.array(errors[:-1])/errors[1:])


def test_constant_kernel():
    """N = N0/(1 + K N0 t/2), and exp(-v) stays exponential in v."""
    errors = []
    for per_doubling in (2, 4, 8):
        n, v = exponential(per_doubling, lambda d1, d2: 3.0 + 0*d1)
        N, M, M2 = n.sum(axis=1), n@v, n@v**2
        exact = N[0]/(1 + 1.5*N[0]*T)
        print(f"{per_doubling}: N0/N {N[0]/N[-1]:.2f},"
              f" N {abs(N/exact - 1).max():.1e},"
              f" volume {abs(M/M[0] - 1).max():.0e}")
        assert N == pytest.approx(exact, rel=1e-7)
        assert M == pytest.approx(M[0], rel=1e-12)

        # Second moment: dM2/dt = K M^2; numbers above a size
        errors.append(M2[-1]/(M2[0] + 3*M[0]**2*T[-1]) - 1)
        tail = n[-1][v > 8].sum()/N[-1]
        edge = np.sqrt(v[v > 8][0]*v[v <= 8][-1])
        print(f"   M2 {errors[-1]:.2e}, tail {tail/np.exp(-edge/4) - 1:.1e}")
    assert abs(errors[-1]) < 3e-3
    assert orders(errors) == pytest.approx(2, abs=0.2)
    assert tail == pytest.approx(np.exp(-edge/4), rel=0.03)


def test_sum_kernel():
    """N = N0 exp(-B V t) and M2 = M2(0) exp(2 B V t), V = total volume."""
    B, errors = 0.4, []
    for per_doubling in (2, 4, 8):
        n, v = exponential(per_doubling, lambda d1, d2: B*(d1**3 + d2**3))
        N, M, M2 = n.sum(axis=1), n@v, n@v**2
        exact = N[0]*np.exp(-B*M[0]*T)
        print(f"{per_doubling}: N0/N {N[0]/N[-1]:.2f},"
              f" N {abs(N/exact - 1).max():.1e},"
              f" volume {abs(M/M[0] - 1).max():.0e}")
        assert N == pytest.approx(exact, rel=1e-6)
        assert M == pytest.approx(M[0], rel=1e-9)
        errors.append(M2[-1]/(M2[0]*np.exp(2*B*M[0]*T[-1])) - 1)
        print(f"   M2 {errors[-1]:.2e}")
    assert abs(errors[-1]) < 0.02
    assert orders(errors) == pytest.approx(2, abs=0.2)


def test_orthokinetic_kernel():
    """1 and 5 um at 1.4 kHz and 147 dB, 2300 kg/m3: 2.2e-11 m3/s."""
    kernel = smoluchowski.orthokinetic(
        1400, smoluchowski.velocity_amplitude(147)
    )
    d = np.array([1e-6, 2e-6])
    assert kernel(d, np.array([5e-6, 5e-6])) == pytest.approx(
        [2.2e-11, 2.6e-11], rel=0.03
    )
    assert kernel(2e-6, 2e-6) == 0


def test_kernel_of_a_sheet_that_settles():
    """Without sound that of settling; with it, the volume of the zigzag."""
    d1, d2 = np.array([1e-6]), np.array([5e-6])
    tau = smoluchowski.relaxation_time
    w = 9.81*(tau(5e-6) - tau(1e-6))
    still = smoluchowski.settling_sheet(1400, 0)(d1, d2)
    assert still == pytest.approx(np.pi*(3e-6)**2*w, rel=1e-12)

    # The path of the larger one, seen by the smaller, leaves a channel behind:
    # its cross-section, from points at random half way
    omega, u0 = 2*np.pi*1400, 1.5
    H = 1/(1 + 1j*omega*tau(5e-6)) - 1/(1 + 1j*omega*tau(1e-6))
    t = np.linspace(0, 40/1400, 40*400)
    path = np.column_stack([
        np.real(H*u0/(1j*omega)*np.exp(1j*omega*t)), -w*t
    ])
    random = np.random.default_rng(1)
    middle, span = path[len(t)//2], np.array([4e-4, 1e-5, 1e-5])
    near = middle[[0, 0, 1]]*[0, 0, 1] + span*(random.random((3000, 3)) - 0.5)
    met = np.array([
        ((path[:, 0] - x)**2 + y**2 + (path[:, 1] - z)**2).min() < 9e-12
        for x, y, z in near
    ])
    area = met.mean()*span[0]*span[1]
    kernel = smoluchowski.settling_sheet(1400, u0)(d1, d2)[0]
    assert kernel/w == pytest.approx(area, rel=0.08)


def test_table_of_a_kernel():
    edges = np.array([1.0, 2, 4])
    kernel = smoluchowski.tabulated(edges, np.array([[1, 2], [2, 3]]))
    small, large = np.array([1.5, 1.5, 3, 9]), np.array([1.2, 3, 3, 0.5])
    assert (kernel(small, large) == [1, 2, 3, 2]).all()


def test_shares_of_a_lognormal():
    edges = smoluchowski.sections(0.3e-6, 10e-6)
    share = smoluchowski.lognormal(edges, 1.5e-6, 1.8, 0.3e-6, 10e-6)
    d = np.sqrt(edges[1:]*edges[:-1])
    assert share.sum() == pytest.approx(1, rel=1e-12)
    assert np.exp(share@np.log(d)) == pytest.approx(1.5e-6, rel=0.01)


def test_kernel_of_what_is_refilled():
    """Between the sheet that settles and full refill; a share is let through."""
    d1, d2 = np.array([1e-6, 2e-6]), np.array([5e-6, 2e-6])
    u0 = smoluchowski.velocity_amplitude(147)

    def kernel(through, refill, **conditions):
        return smoluchowski.refilled(through, refill, 1400, u0,
                                     **conditions)(d1, d2)

    full = smoluchowski.orthokinetic(1400, u0)(d1, d2)
    sheet = smoluchowski.settling_sheet(1400, u0)(d1, d2)
    still = smoluchowski.settling_sheet(1400, 0)(d1, d2)
    assert kernel(1, 0) == pytest.approx(sheet)
    assert kernel(1, 1) == pytest.approx(full + still)
    assert kernel(0.3, 0.1) == pytest.approx(0.3*(sheet + 0.1*full))
    # Along the sound nothing is refilled; nor without gravity
    assert kernel(1, 0, across=0) == pytest.approx(still)
    assert kernel(1, 0, gravity=0) == pytest.approx(0, abs=1e-30)
    # Turbulence of 0.03 and 1 m2/s3 refills a share of 0.16 and 0.9
    share = [kernel(1, 0, gravity=0, dissipation=e)[0]/full[0]
             for e in (0.03, 1, 100)]
    assert share == pytest.approx([0.16, 0.9, 1], rel=0.05)


LOG = """
Sound: standingWave; frequency {f}; SPL {L};
    frequency {f} Hz, wavelength 0.2 m
Gas: density 1.204 kg/m3, viscosity 1.81e-05 Pa s, temperature 293.15 K, sound speed 343.2 m/s, mean free path 6.6e-08 m
Models
    particles    distribution; density 2300; seed 1;
    gravity      uniform; value ( 0 0 -9.81 );
Relative displacement of the smallest and the largest particle 0.0003 m (peak to peak) where the gas oscillates with {u:.9g} m/s, Stokes layer 8e-05 m
"""  # noqa: E501


def made_up_study(folder, through, refill, noise=0.0, held_back=1.0):
    """Runs that follow a balance, of which those between are stretched."""
    random = np.random.default_rng(2)
    edges = smoluchowski.sections(0.3e-6, 30e-6, 6)
    n0 = 2.4e11*smoluchowski.lognormal(edges, 1.5e-6, 1.8, 0.3e-6, 10e-6)
    times = np.linspace(0, 4, 41)
    for i, f in enumerate((700, 1400, 2800)):
        for j, L in enumerate((140, 144, 148)):
            u = smoluchowski.velocity_amplitude(L)
            N = smoluchowski.PopulationBalance(edges, smoluchowski.refilled(
                through, refill, f, u)).solve(n0, times, 0.05).sum(axis=1)
            for seed in (1, 2, 3):
                gone = (1 - N/N[0])*(1 + noise*random.normal())
                gone *= held_back if (i + j) % 2 else 1
                run = folder/"runs"/f"f{f}_L{L}_s{seed}"
                tables = run/"postProcessing"/"aerosol"
                tables.mkdir(parents=True)
                (run/"log.acousticDEMFoam").write_text(
                    LOG.format(f=f, L=L, u=u))
                values = {"frequency": f, "SPL": L, "seed": seed}
                (run/"run.json").write_text(
                    json.dumps({"state": "done", "values": values}))
                (tables/"agglomeration.csv").write_text(
                    "time_s,number,concentration_per_m3\n" + "".join(
                        f"{t:.6g},{6000*(1 - g):.12g},{2.4e11*(1 - g):.12g}\n"
                        for t, g in zip(times, gone)))
                (tables/"sizeDistribution.csv").write_text(
                    "time_s,lower_m,upper_m,number,mass_kg\n" + "".join(
                        f"0,{a:.17g},{b:.17g},{6000*n/2.4e11:.12g},0\n"
                        for a, b, n in zip(edges, edges[1:], n0)))


def command(*arguments, status=0):
    done = subprocess.run(
        [sys.executable, ROOT/"bin"/"populationBalance", *map(str, arguments)],
        stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
    assert done.returncode == status, done.stdout
    return done.stdout


@pytest.mark.parametrize("through, refill", [(0.7, 0.0), (0.4, 0.2)])
def test_calibration_finds_what_is_there(tmp_path, through, refill):
    made_up_study(tmp_path, through, refill, 0.03)
    said = command(tmp_path, "--map", "frequency=500:4000:5:log",
                   "--times", "1,4")
    print(said)
    words = said.split("through ")[1].split()
    assert float(words[0]) == pytest.approx(through, rel=0.15)
    assert float(words[4]) == pytest.approx(refill, abs=0.03)
    assert "beyond the runs, where nothing is checked: frequency 500 Hz," in said

    with (tmp_path/"populationBalanceCheck.csv").open() as file:
        rows = list(csv.DictReader(file))
    held = [row for row in rows if row["held_back"] == "1"]
    assert len(rows) == 9 and len(held) == 4
    for row in held:
        assert float(row["efficiency"]) == pytest.approx(
            float(row["efficiency_DEM"]), rel=0.1)
    with (tmp_path/"populationBalance.csv").open() as file:
        assert len(list(csv.DictReader(file))) == 2*5*21
    page = (tmp_path/"populationBalance.html").read_text()
    assert "held back" in page and "data:image/png" in page


def test_what_it_has_not_seen_shows_how_far_off_it_is(tmp_path):
    made_up_study(tmp_path, 0.5, 0.05, 0.0, 2.0)
    said = command(tmp_path, "--map", "frequency=1000", "SPL=140")
    mean = float(said.split("held back: mean efficiency ")[1].split()[0])
    off = float(said.split("held back")[-1].split("on average by ")[1]
                .split(";")[0])
    assert off == pytest.approx(-0.5*mean, rel=0.1)


def test_what_is_wrong_with_a_study_is_said(tmp_path):
    assert "has no complete run" in command(tmp_path, status=1)
    made_up_study(tmp_path, 0.5, 0.05)
    for arguments, message in (
        (("--times", "0"), "--times 0: write times above 0"),
        (("--map", "seed=1"), "--map seed: a map has frequency and SPL"),
        (("--map", "SPL=a"), "'a' are no numbers"),
        (("--cloud", "b"), "no cloud b; there is aerosol"),
    ):
        said = command(tmp_path, *arguments, status=1)
        assert said.startswith("ERROR: ") and message in said, said
    (tmp_path/"runs"/"f700_L140_s1"/"log.acousticDEMFoam").write_text("")
    assert "does not say which gas there is" in command(tmp_path, status=1)
