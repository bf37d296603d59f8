"""Attenuation and dispersion of sound in an aerosol, against theory.

Reads the pressure at the wall of each run, s*/ for one omega tau each, and clean/
in which the particles do nothing to the gas; writes aerosolAttenuation.png.

Particles of the relaxation time tau and of the mass m per mass of gas follow
the gas by Stokes' drag, and the gas feels that (Temkin and Dobbins 1966, the
part of the momentum). A standing wave of the frequency w0 in clean gas has

    w^2 (1 + m/(1 - i w tau)) = w0^2,     p ~ exp(-i w t).

Particles act as they move: of those that stand at random, m is the mean with the
weight 2 sin^2(pi x/length), the square of the gas's velocity over its mean.
"""

import os
import pathlib
import re
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{HERE}/../..") + "/bin")
try:
    import runTables  # finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import numpy as np  # noqa: E402


def tube(case):
    """The numbers of system/tube that need no evaluation."""
    return {
        name: float(value) for name, value in re.findall(
            r"^(\w+)\s+([-+.\deE]+)\s*;", (case/"system/tube").read_text(), re.M
        )
    }


def read(case):
    """Times [s] and pressures [Pa] at the wall."""
    data = runTables.series(case/"postProcessing/history", "p")
    return data[:, 0], data[:, 1]


def loading(case):
    """Mass of the particles per mass of gas, as the standing wave feels it."""
    file = case/"0/lagrangian/aerosol/position"
    if not file.exists():
        runTables.fail(f"there is no {file}: has the case been run?")
    content = file.read_bytes()
    size = re.search(rb"^(\d+)\s*\(", content, re.M)
    n = int(size[1])
    if re.search(rb"format\s+binary", content):
        places = np.frombuffer(content, float, 3*n, size.end())
    else:
        text = re.sub(rb"[()]", b" ", content[size.end():])
        places = np.array(text.split()[:3*n], float)

    numbers = tube(case)
    wave = np.sin(np.pi*places[::3]/numbers["length"])
    return numbers["massLoading"]*2*np.mean(wave**2)


def frequencies(w0, m, tau):
    """The wave's complex frequency, and the rate of the mode that only decays:
    roots of -i tau w^3 + (1 + m) w^2 + i tau w0^2 w - w0^2."""
    roots = np.roots([-1j*tau, 1 + m, 1j*tau*w0**2, -w0**2])
    return roots[roots.real.argmax()], -roots[np.abs(roots.real).argmin()].imag


def measure(t, p, guess, decay=None):
    """The complex frequency of what oscillates, by least squares. Beside it
    there are its second harmonic, a mean that drifts, and what just decays."""
    t = t - t[0]

    def parts(w):
        wave = np.exp(-1j*w*t)
        columns = [np.ones_like(t), t/t[-1], wave.real, wave.imag,
                   (wave**2).real, (wave**2).imag]
        if decay is not None:
            columns.append(np.exp(-decay*t))
        A = np.array(columns).T
        fit = np.linalg.lstsq(A, p, rcond=None)[0]
        return p - A@fit, (fit[2] + 1j*fit[3]).conj()*wave

    # Gauss and Newton: how the wave changes with its frequency
    w = guess
    for _ in range(20):
        rest, wave = parts(w)
        change = -1j*t*wave
        A = np.array([change.real, -change.imag, wave.real, wave.imag,
                      np.ones_like(t)]).T
        step = np.linalg.lstsq(A, rest, rcond=None)[0]
        w = w + step[0] + 1j*step[1]
    return w


def analyse(case, w0=None):
    """Complex frequency in a run, and by theory if that of clean gas is given"""
    numbers = tube(case)
    t, p = read(case)
    period = 1/numbers["frequency"]
    guess = 2*np.pi*numbers["frequency"] + 0j

    late = t > 2*period
    if t[-1] < 3.5*period:
        runTables.fail(f"{case} ended after {t[-1]/period:.2g} periods")

    if w0 is None:
        return measure(t[late], p[late], guess)

    s = numbers["omegaTau"]
    tau = s/(2*np.pi*numbers["frequency"])
    w, decay = frequencies(w0, loading(case), tau)
    return measure(t[late], p[late], w, decay), w


def main():
    import matplotlib.pyplot as plt

    runs = sorted(
        (run for run in HERE.glob("s*/") if runTables.is_time(run.name[1:])),
        key=lambda run: float(run.name[1:]),
    )
    if not runs:
        runTables.fail(f"there are no runs in {HERE}: ./Allrun makes them")
    w0 = analyse(HERE/"clean")
    m = loading(runs[0])

    print("omega tau   damping per period [%]    change of frequency [%]\n"
          "              computed  theory          computed  theory")
    rows = []
    for run in runs:
        w, exact = analyse(run, w0)
        s = tube(run)["omegaTau"]
        row = [s]
        for value in (w, exact):
            row += [100*2*np.pi*(w0.imag - value.imag)/w0.real,
                    100*(value.real/w0.real - 1)]
        rows.append(row)
        print(f"{s:9g}{row[1]:13.4f}{row[3]:9.4f}{row[2]:17.4f}{row[4]:9.4f}")
    rows = np.array(rows).T

    s = np.logspace(-1.3, 1.3, 100)
    exact = np.array([frequencies(w0, m, x/w0.real)[0] for x in s])
    figure, (left, right) = plt.subplots(
        1, 2, figsize=(7, 3.6), layout="constrained"
    )
    for axes, theory, computed, label in (
        (left, 100*2*np.pi*(w0.imag - exact.imag)/w0.real, rows[1],
         "amplitude lost per period [%]"),
        (right, 100*(exact.real/w0.real - 1), rows[2],
         "change of the frequency [%]"),
    ):
        axes.semilogx(s, theory, color="0.6", label="theory")
        axes.semilogx(rows[0], computed, "o", color="C0", label="computed")
        axes.set_xlabel(r"$\omega\tau$")
        axes.set_ylabel(label)
        axes.xaxis.set_major_formatter("{x:g}")
    left.legend()
    figure.suptitle(f"Sound in an aerosol of {m:g} times the mass of the gas")
    runTables.save(figure, HERE/"aerosolAttenuation.png")


if __name__ == "__main__":
    main()
