#!/usr/bin/env python3
"""Fly ash in intense sound, against the measurement: one figure per command.

  levels       efficiency over the sound level, at 1400 Hz
  frequencies  efficiency over the frequency, at 147 dB
  decay        number over time, at 1400 Hz
  models       which physics does what, at 149 dB: wakes, bouncing, ...
  sensitivity  how much the assumed aerosol matters: median, GSD, concentration
  boxes        how much the size of the box and the time step matter
  refill       the DEM and a population balance, where they agree and where not
  capture      pairs by brute force: what wakes take from the paths

Each runs the cases that it needs by bin/study, as many at a time as there are
cores, and keeps them in results/: those that are there already are not run again,
and a study that was interrupted, or that is to go on for longer, goes on. README.md
says how long the figures take.
"""

import argparse
import os
import shutil
import subprocess
import sys
from pathlib import Path

# First, since it finds a Python that has the others
from cases import MODELS, POINT, Runner, at, least_count

import capture
import matplotlib.pyplot as plt
import numpy as np
import refill
import smoluchowski
import studyRuns

HERE = Path(__file__).resolve().parent

# CIESC Journal, 2009: at 1400 Hz and 147 dB, share of the particles that are
# gone. The residence time is not known to us; 4 s are assumed.
MEASURED = {"frequency": 1400, "SPL": 147, "total": 0.684, "PM2.5": 0.756}

SENSITIVITY = {
    "median": (1e-6, 1.5e-6, 2e-6, 3e-6),
    "GSD": (1.6, 1.8, 2.0),
    "concentration": (1.2e11, 2.4e11, 4.8e11),
}

ASPECTS = (1, 2, 4, 6, 12, 24, 48)


def mean_error(values, number):
    """Mean of the seeds (rows) and its standard error.

    One or two seeds do not tell: then it is the error that contacts by chance
    (Poisson) give to shares of so many particles that are gone.
    """
    values = np.asarray(values, float)
    mean, n = values.mean(axis=0), len(values)
    if n > 2:
        return mean, values.std(axis=0, ddof=1)/np.sqrt(n)
    return mean, np.sqrt(np.abs(mean)/(number*n))


def efficiencies(tables, end):
    """(total, error), (PM2.5, error) of the seeds, in per cent."""
    number = tables[0]["number"][0]
    return [
        100*np.array(mean_error([at(table, end, name) for table in tables],
                                number))
        for name in ("efficiency", "efficiency_PM2_5")
    ]


def print_table(title, labels, cases, tables, end):
    width = max(len(title), max(map(len, labels)))
    print(f"{title:{width}}  particles seeds      box [mm]"
          "   total [%]        PM2.5 [%]")
    for label, case, ensemble in zip(labels, cases, tables):
        (N, dN), (P, dP) = efficiencies(ensemble, end)
        box = 1e3*(case["count"]/case["concentration"]/case["aspect"])**(1/3)
        box = f"{box:.2f} x {case['aspect']*box:.2f}"
        print(f"{label:{width}}  {case['count']:9d} {len(ensemble):5d}"
              f"  {box:>12}{N:8.2f} +- {dN:4.2f}{P:9.2f} +- {dP:4.2f}")


def balance(case, end, kernel=smoluchowski.orthokinetic):
    """The same by a population balance; by default, with full refill."""
    edges = smoluchowski.sections(0.3e-6, 60e-6)
    n = case["concentration"]*smoluchowski.lognormal(
        edges, case["median"], case["GSD"], 0.3e-6, 10e-6
    )
    model = smoluchowski.PopulationBalance(
        edges, kernel(
            case["frequency"], smoluchowski.velocity_amplitude(case["SPL"])
        )
    )
    times = np.linspace(0, end, 41)
    n = model.solve(n, times)
    small = model.d <= 2.5e-6
    return times, n.sum(axis=1), n[:, small].sum(axis=1)


def points(axes, x, ensembles, end, **style):
    """Total and PM2.5 with their standard errors."""
    (N, dN), (P, dP) = np.transpose(
        [efficiencies(tables, end) for tables in ensembles], (1, 2, 0)
    )
    label = style.pop("label", "")
    axes.errorbar(x, N, dN, fmt="o-", capsize=2, ms=4, label=label, **style)
    axes.errorbar(x, P, dP, fmt="s--", capsize=2, ms=4, mfc="white", **style)


def measured(axes, x):
    axes.plot(x, 100*MEASURED["total"], "*", color="k", ms=11, zorder=5,
              label="measured")
    axes.plot(x, 100*MEASURED["PM2.5"], "*", color="k", mfc="white", ms=11,
              zorder=5)


# Bounds of a population balance, and their colours
REFILL = {
    "full refill": (smoluchowski.orthokinetic, "0.7"),
    "settling alone": (smoluchowski.settling_sheet, "0.4"),
}


def refilled(axes, x, cases, end):
    """Population balances, over x."""
    for name, (kernel, color) in REFILL.items():
        _, N, P = zip(*(balance(case, end, kernel) for case in cases))
        N, P = np.array(N), np.array(P)
        axes.plot(x, 100*(1 - N[:, -1]/N[:, 0]), color=color, lw=1,
                  label=f"population balance, {name}")
        axes.plot(x, 100*(1 - P[:, -1]/P[:, 0]), color=color, ls="--", lw=1)
        print(f"population balance, {name}: total [%]",
              *np.round(100*(1 - N[:, -1]/N[:, 0]), 1), " PM2.5 [%]",
              *np.round(100*(1 - P[:, -1]/P[:, 0]), 1))


class Studies:
    """One figure each."""

    def __init__(self, options):
        self.options = options
        self.runner = Runner(options)

    def cases(self, variants):
        """Cases that differ from the point, in boxes that are large enough."""
        made = []
        for variant in variants:
            case = {**POINT, "count": self.options.particles,
                    "aspect": self.options.aspect,
                    "stepsPerPeriod": self.options.steps,
                    "concentration": self.options.concentration, **variant}
            case["count"] = max(case["count"], least_count(case))
            made.append(case)
        return made

    def save(self, figure, name):
        figure.tight_layout()
        target = self.runner.results/f"{name}.png"
        figure.savefig(target, dpi=100)
        print(f"\nWrote {target}")

    def note(self, axes):
        axes.grid(alpha=0.3)
        axes.set_ylabel(f"efficiency after {self.options.time:g} s [%]")
        axes.set_ylim(bottom=0)

    def over(self, key, values, label, figure_name):
        """Efficiency over the level or the frequency, a curve per model."""
        others = {"SPL": self.options.levels or [147],
                  "frequency": [1400]}
        other = "frequency" if key == "SPL" else "SPL"
        curves = [(model, value) for model in self.options.models
                  for value in others[other]]
        cases = self.cases(
            {"model": model, key: x, other: value}
            for model, value in curves for x in values
        )
        tables = self.runner.all(cases)
        print_table(
            "case", [f"{case['model']} {case['frequency']:g} Hz"
                     f" {case['SPL']:g} dB" for case in cases],
            cases, tables, self.options.time,
        )
        figure, axes = plt.subplots(figsize=(6, 4))
        n = len(values)
        for k, (model, value) in enumerate(curves):
            name = model if len(others[other]) == 1 else \
                f"{model}, {value:g} dB"
            points(axes, values, tables[k*n:(k + 1)*n], self.options.time,
                   color=f"C{k}", label=name)
        refilled(axes, values, cases[:n], self.options.time)
        measured(axes, MEASURED[key])
        self.note(axes)
        axes.set_xlabel(label)
        axes.set_title("filled: all particles; open: up to 2.5 um", fontsize=9)
        axes.legend(frameon=False, fontsize=8)
        self.save(figure, figure_name)

    def levels(self):
        levels = self.options.levels or [130, 135, 140, 144, 147, 149]
        self.options.levels = None
        self.over("SPL", levels, "sound level [dB]", "levels")

    def frequencies(self):
        frequencies = self.options.frequencies or [700, 1000, 1400, 2000, 3000]
        self.over("frequency", frequencies, "frequency [Hz]", "frequencies")

    def decay(self):
        end = self.options.time
        levels = self.options.levels or [147]
        cases = self.cases({"model": model, "SPL": level}
                           for model in self.options.models
                           for level in levels)
        ensembles = self.runner.all(cases)
        labels = [f"{c['model']}, {c['SPL']:g} dB" for c in cases]
        print_table("case", labels, cases, ensembles, end)

        figure, axes = plt.subplots(figsize=(6, 4))
        print("\nRate of -ln(N/N0) [1/s] in the first and the second half;"
              " equal if the decay is exponential")
        for k, (label, tables) in enumerate(zip(labels, ensembles)):
            t = np.linspace(0, end, 81)
            gone = np.array([[at(table, s) for s in t] for table in tables])
            number = tables[0]["number"][0]
            mean, error = mean_error(gone, number)
            axes.plot(t, 1 - mean, color=f"C{k}", label=label)
            axes.fill_between(t, 1 - mean - error, 1 - mean + error,
                              color=f"C{k}", alpha=0.25, lw=0)
            halves = -np.diff(np.log(1 - gone[:, ::40]), axis=1)
            (a, b), (da, db) = np.array(mean_error(halves, number))/(0.5*end)
            print(f"{label:28}{a:8.4f} +- {da:.4f}{b:8.4f} +- {db:.4f}")
        for level in levels:
            for name, (kernel, color) in REFILL.items():
                t, n, _ = balance({**cases[0], "SPL": level}, end, kernel)
                axes.plot(t, n/n[0], color=color, lw=1,
                          label=f"population balance, {name}, {level:g} dB")
        t = np.linspace(0, end)
        axes.plot(t, (1 - MEASURED["total"])**(t/4), "k:",
                  label="exponential through the measured point")
        axes.plot(4, 1 - MEASURED["total"], "k*", ms=11, clip_on=False)
        axes.set_xlim(0, end)
        axes.set_yscale("log")
        axes.yaxis.set_major_formatter("{x:g}")
        axes.yaxis.set_minor_formatter("{x:g}")
        axes.set_xlabel("time [s]")
        axes.set_ylabel("$N/N_0$")
        axes.grid(alpha=0.3, which="both")
        axes.legend(frameon=False, fontsize=8)
        self.save(figure, "decay")

    def models(self):
        level = (self.options.levels or [149])[0]
        cases = self.cases({"model": model, "SPL": level}
                           for model in self.options.models)
        tables = self.runner.all(cases)
        labels = [case["model"] for case in cases]
        end = self.options.time
        print_table(f"1400 Hz, {level:g} dB", labels, cases, tables, end)

        figure, axes = plt.subplots(figsize=(6, 0.32*len(cases) + 1.6))
        y = np.arange(len(cases))
        (N, dN), (P, dP) = np.transpose(
            [efficiencies(t, end) for t in tables], (1, 2, 0)
        )
        axes.barh(y - 0.2, N, 0.38, xerr=dN, color="C0", label="all particles",
                  error_kw={"lw": 1})
        axes.barh(y + 0.2, P, 0.38, xerr=dP, color="C1", label="up to 2.5 um",
                  error_kw={"lw": 1})
        axes.set_yticks(y, labels)
        axes.invert_yaxis()
        axes.grid(alpha=0.3, axis="x")
        axes.set_xlabel(f"efficiency after {end:g} s at {level:g} dB [%]")
        axes.legend(frameon=False, fontsize=8)
        self.save(figure, "models")

    def sensitivity(self):
        model = self.options.models[0]
        cases = self.cases({"model": model, key: value}
                           for key, values in SENSITIVITY.items()
                           for value in values)
        tables = self.runner.all(cases)
        end = self.options.time
        labels = [f"{key} {value:g}" for key, values in SENSITIVITY.items()
                  for value in values]
        print_table(model, labels, cases, tables, end)

        # Units, and titles
        shown = {"median": (1e6, "median [um]"), "GSD": (1, "GSD"),
                 "concentration": (1e-11, "concentration [1e11/m3]")}
        figure, axes = plt.subplots(1, 3, figsize=(9, 3.3), sharey=True)
        k = 0
        for panel, (key, values) in zip(axes, SENSITIVITY.items()):
            n = len(values)
            unit, title = shown[key]
            x = unit*np.array(values)
            points(panel, x, tables[k:k + n], end, color="C0", label=model)
            refilled(panel, x, cases[k:k + n], end)
            measured(panel, unit*POINT[key])
            self.note(panel)
            panel.set_xlabel(title)
            k += n
        for panel in axes[1:]:
            panel.set_ylabel("")
        axes[1].legend(frameon=False, fontsize=7, loc="center left",
                       bbox_to_anchor=(0, 0.48))
        self.save(figure, "sensitivity")

    def boxes(self):
        models, end = self.options.models, self.options.time
        wide = self.options.particles/POINT["aspect"]
        variants = [
            *({"count": round(wide*a), "aspect": a} for a in ASPECTS),
            {"count": self.options.particles, "aspect": 1},
            {"count": 4*self.options.particles, "aspect": 1},
            {"stepsPerPeriod": 2*self.options.steps},
        ]
        cases = self.cases({"model": model, **variant}
                           for model in models for variant in variants)
        tables = self.runner.all(cases)
        height = [1e3*(case["count"]/case["concentration"]*case["aspect"]**2)
                  ** (1/3) for case in cases]
        labels = [
            f"{case['model']}, {case['stepsPerPeriod']} steps per period"
            for case in cases
        ]
        print_table("case", labels, cases, tables, end)

        figure, axes = plt.subplots(figsize=(6, 4))
        n = len(ASPECTS)
        for k, model in enumerate(models):
            start = k*len(variants)
            for label, marker, first, last in (
                (model, "o-", 0, n), (f"{model}, cubes", "^:", n, n + 2),
                (f"{model}, half the time step", "x", n + 2, n + 3),
            ):
                part = slice(start + first, start + last)
                N, dN = np.transpose(
                    [efficiencies(t, end)[0] for t in tables[part]]
                )
                axes.errorbar(height[part], N, dN, fmt=marker, capsize=2,
                              color=f"C{k}", mfc="white", label=label)
        _, N, _ = balance(POINT, end, smoluchowski.settling_sheet)
        axes.axhline(100*(1 - N[-1]/N[0]), color="0.4", lw=1,
                     label="population balance, settling alone")
        axes.set_xscale("log")
        axes.xaxis.set_major_formatter("{x:g}")
        axes.set_xlabel("height of the box [mm]")
        axes.set_title("all particles, 1400 Hz, 147 dB", fontsize=9)
        self.note(axes)
        axes.legend(frameon=False, fontsize=8)
        self.save(figure, "boxes")

    def refill(self):
        figure, _ = refill.study(
            self.runner.results/"refill", self.runner.base(),
            self.options.seeds, self.options.particles, self.options.periods,
            self.options.jobs,
        )
        self.save(figure, "refill")

    def capture(self):
        """At the point; without the solver."""
        def efficiency(kernel):
            _, N, P = balance(POINT, self.options.time, lambda *_: kernel)
            return [100*(1 - n[-1]/n[0]) for n in (N, P)]

        self.runner.results.mkdir(parents=True, exist_ok=True)
        self.save(capture.study(POINT, efficiency), "capture")


DEFAULT_MODELS = {
    "levels": ["Brownian", "Oseen"],
    "frequencies": ["Brownian", "Oseen"],
    "decay": ["none", "Brownian", "Oseen"],
    "models": ["none", "Brownian", "Oseen", "OseenBrownian",
               "ProudmanPearson", "memory", "history", "noneBounce",
               "OseenBounce", "OseenSoftBounce", "historyBounce"],
    "sensitivity": ["Oseen"],
    "boxes": ["none", "Brownian", "Oseen"],
    "refill": [],
    "capture": [],
}


def positive(text):
    value = float(text)
    if not 0 < value < np.inf:
        raise ValueError
    return value


def count(text):
    value = int(text)
    if value < 1:
        raise ValueError
    return value


def numbers(text):
    return [positive(word) for word in text.split(",")]


def main():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawTextHelpFormatter
    )
    parser.add_argument("figure", choices=DEFAULT_MODELS)
    parser.add_argument("--seeds", type=count, default=5)
    parser.add_argument("--particles", type=count, default=1000,
                        help="in a box, or more if it must be wider")
    parser.add_argument("--aspect", type=positive, default=POINT["aspect"],
                        help="height of the box over its width")
    parser.add_argument("--concentration", type=positive,
                        default=POINT["concentration"], help="[1/m3]")
    parser.add_argument("--time", type=positive, default=4, help="[s]")
    parser.add_argument("--levels", type=numbers, help="[dB], such as 140,147")
    parser.add_argument("--frequencies", type=numbers, help="[Hz]")
    parser.add_argument("--models", type=lambda text: text.split(","),
                        help="of: " + " ".join(MODELS))
    parser.add_argument("--steps", type=count, default=50, help="per period")
    parser.add_argument("--periods", type=count, default=60, help="of refill")
    parser.add_argument("--jobs", type=count, default=os.cpu_count(),
                        help="cases that run at a time")
    parser.add_argument("--results", default=HERE/"results")
    parser.add_argument("--slim", action="store_true",
                        help="keep tables only, no particles")
    parser.add_argument("--anew", action="store_true", help="throw away runs of"
                        " which model or case has been another one")
    options = parser.parse_args()

    if shutil.which("acousticDEMFoam") is None:
        sys.exit("ERROR: first source the environment: . bin/environment")
    options.models = options.models or DEFAULT_MODELS[options.figure]
    for model in options.models:
        if model not in MODELS:
            sys.exit(f"ERROR: no model {model}; there are {' '.join(MODELS)}")

    try:
        getattr(Studies(options), options.figure)()
    except (subprocess.CalledProcessError, RuntimeError, OSError,
            studyRuns.StudyError, studyRuns.EntryError) as error:
        sys.exit(f"ERROR: {error}")


if __name__ == "__main__":
    main()
