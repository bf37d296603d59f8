"""The cases of the study: what varies in them; bin/study runs and keeps them."""

import os
import shutil
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{HERE.parents[2]}") + "/bin")
try:
    import runTables  # noqa: F401, finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import acousticDEM  # noqa: E402
import numpy as np  # noqa: E402
import smoluchowski  # noqa: E402
import studyRuns  # noqa: E402

# The variants of the models: dictionaries of constant/aerosolProperties in place
# of those of ALL. A new one is a line here, and --models takes its name.
ALL = {
    "drag": "type SchillerNaumann; slipCorrection Cunningham;",
    "gravity": "type uniform; value (0 0 -9.81);",
    "wake": "type none;",
    "contact": "type stick;",
    "aggregate": "type equivalentSphere;",
}
BOUNCE = "type criticalVelocity; workOfAdhesion 0.05; YoungsModulus 70e9;"
SOFT = "type criticalVelocity; workOfAdhesion 0.1; YoungsModulus 5e9;"
IMPACTS = ("type impact; bond { type JKR; workOfAdhesion 0.05;"
           " YoungsModulus 70e9; }")
DRAG = "type drag; bond { type JKR; workOfAdhesion 0.05; }"
EDDIES = "type syntheticTurbulence; dissipation {};"
MODELS = {
    "none": {},
    "noGravity": {"gravity": "type none;"},
    "Brownian": {"Brownian": "type OrnsteinUhlenbeck;"},
    "Oseen": {"wake": "type Oseen;"},
    "OseenNoGravity": {"wake": "type Oseen;", "gravity": "type none;"},
    "ProudmanPearson": {"wake": "type ProudmanPearson;"},
    "memory": {"wake": "type memory;"},
    "history": {"wake": "type history;"},
    # What is below 0.05 m/s is left out: shows how much that matters
    "memoryNear": {"wake": "type memory; tolerance 0.05;"},
    "OseenBrownian": {
        "wake": "type Oseen;", "Brownian": "type OrnsteinUhlenbeck;"
    },
    "memoryBrownian": {
        "wake": "type memory;", "Brownian": "type OrnsteinUhlenbeck;"
    },
    "historyBrownian": {
        "wake": "type history;", "Brownian": "type OrnsteinUhlenbeck;"
    },
    # Turbulence, by what it dissipates, m2/s3
    "turbulence1": {"turbulence": EDDIES.format(1)},
    "turbulence10": {"turbulence": EDDIES.format(10)},
    "turbulence100": {"turbulence": EDDIES.format(100)},
    "OseenTurbulence10": {
        "wake": "type Oseen;", "turbulence": EDDIES.format(10)
    },
    "historyTurbulence10": {
        "wake": "type history;", "turbulence": EDDIES.format(10)
    },
    "turbulence10Bounce": {
        "turbulence": EDDIES.format(10), "contact": BOUNCE
    },
    "noneBounce": {"contact": BOUNCE},
    "OseenBounce": {"wake": "type Oseen;", "contact": BOUNCE},
    "OseenSoftBounce": {"wake": "type Oseen;", "contact": SOFT},
    "memoryBounce": {"wake": "type memory;", "contact": BOUNCE},
    "historyBounce": {"wake": "type history;", "contact": BOUNCE},
    # Aggregates break: by drag, and by impacts
    "noneDragBreakage": {"breakage": DRAG},
    "noneImpacts": {"breakage": IMPACTS},
    "OseenImpacts": {"wake": "type Oseen;", "breakage": IMPACTS},
    "historyImpacts": {"wake": "type history;", "breakage": IMPACTS},
    "turbulence10Impacts": {
        "turbulence": EDDIES.format(10), "breakage": IMPACTS
    },
    "turbulence10SoftBounce": {
        "turbulence": EDDIES.format(10), "contact": SOFT
    },
}

# The measured point, and the aerosol that is assumed with it
POINT = {
    "model": "Oseen",
    "frequency": 1400,          # Hz
    "SPL": 147,                 # dB
    "count": 1000,
    "concentration": 2.4e11,    # 1/m3
    "median": 1.5e-6,           # m
    "GSD": 1.8,
    "aspect": 6,                # height over width of the box: see boxes
    "stepsPerPeriod": 50,
}


def least_count(case):
    """Particles for a box twice as wide as wakes and paths are long."""
    omega = 2*np.pi*case["frequency"]
    nu = smoluchowski.AIR.viscosity/smoluchowski.AIR.density
    swing = smoluchowski.velocity_amplitude(case["SPL"])/omega
    wake = MODELS[case["model"]].get("wake", "")
    layers = 4*np.sqrt(2*nu/omega)
    far = "memory" in wake or "history" in wake
    reach = layers + 2*swing if far else max(layers, 2*swing)
    width = 2.02*reach
    return int(np.ceil(case["concentration"]*case["aspect"]*width**3))


def values_of(case, seed, end):
    """What differs from the case in case/: names of entries, and values."""
    steps = case["frequency"]*case["stepsPerPeriod"]
    values = {"model": case["model"]}
    for key, value in case.items():
        named = ("frequency", "SPL", "count")
        if key != "model" and (key in named or value != POINT[key]):
            values[f"system/study:{key}"] = f"{value:.12g}"
    values["system/study:seed"] = str(seed)
    values["system/study:endTime"] = f"{round(end*steps)/steps:.12g}"
    return values


def levels():
    """Of the models: the dictionaries that each of them sets."""
    return {name: {f"constant/models:{key}": f"{{ {entries} }}"
                   for key, entries in {**ALL, **variant}.items()}
            for name, variant in MODELS.items()}


class Runner:
    """Runs cases in parallel, and keeps them."""

    def __init__(self, options):
        self.options = options
        self.results = Path(options.results).resolve()

    def base(self):
        """The case with its mesh, made once."""
        base = self.results/"mesh"
        if not (base/"constant"/"polyMesh"/"owner").exists():
            shutil.rmtree(base, ignore_errors=True)
            shutil.copytree(
                HERE/"case", base,
                ignore=shutil.ignore_patterns("[0-9]*", "log.*", "polyMesh")
            )
            with (base/"log.blockMesh").open("w") as log:
                subprocess.run(["blockMesh"], cwd=base, stdout=log, stderr=log,
                               check=True)
        return base

    def all(self, cases):
        """Tables of all seeds of all cases, in their order."""
        study = studyRuns.Study(
            HERE/"case", self.results, self.options.jobs,
            levels={"model": levels()}, anew=self.options.anew,
            slim=self.options.slim)
        jobs = [(k, seed) for seed in range(1, self.options.seeds + 1)
                for k in range(len(cases))]
        start = time.perf_counter()
        runs = study.run([values_of(cases[k], seed, self.options.time)
                          for k, seed in jobs])
        failed = [f"{run.label()}: {run.reason}" for run in runs
                  if run.state != "done"]
        print(f"{study.computed} runs in {time.perf_counter() - start:.0f} s,"
              f" {len(jobs) - study.computed} were there already")
        if failed:
            sys.exit("ERROR: " + "\n       ".join(failed))
        seconds = sum(run.seconds for run in runs)
        print(f"All of them together take {seconds:.0f} s of one core\n")

        tables = [[] for _ in cases]
        for (k, _), run in zip(jobs, runs):
            tables[k].append(acousticDEM.columns(run.folder))
        return tables


def at(table, end, name="efficiency"):
    """The last value up to a time."""
    k = np.searchsorted(table["time_s"], end*(1 + 1e-9), side="right") - 1
    return table[name][k]
