"""The population balance of the validation, against exact solutions."""

import sys

import numpy as np
import pytest
from foamcase import ROOT

sys.path.insert(0, str(ROOT/"tutorials"/"validation"/"flyAsh"))
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
