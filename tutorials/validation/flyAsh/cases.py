"""The cases of the study: what varies in them, and running and keeping them."""

import os
import re
import shutil
import subprocess
import sys
import threading
import time
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{HERE.parents[2]}") + "/bin")
try:
    import runTables  # finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import numpy as np  # noqa: E402
import smoluchowski  # noqa: E402

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
    nu = smoluchowski.VISCOSITY/smoluchowski.DENSITY
    swing = smoluchowski.velocity_amplitude(case["SPL"])/omega
    wake = MODELS[case["model"]].get("wake", "")
    layers = 4*np.sqrt(2*nu/omega)
    far = "memory" in wake or "history" in wake
    reach = layers + 2*swing if far else max(layers, 2*swing)
    width = 2.02*reach
    return int(np.ceil(case["concentration"]*case["aspect"]*width**3))


def name_of(case):
    words = [case["model"], f"{case['frequency']:g}Hz", f"{case['SPL']:g}dB",
             f"N{case['count']}"]
    for key, text in (
        ("concentration", f"{case['concentration']:.3g}"),
        ("median", f"median{1e6*case['median']:g}um"),
        ("GSD", f"GSD{case['GSD']:g}"),
        ("aspect", f"aspect{case['aspect']:g}"),
        ("stepsPerPeriod", f"T{case['stepsPerPeriod']}"),
    ):
        if case[key] != POINT[key]:
            words.append(text)
    return "_".join(words)


def header(name):
    return ("FoamFile\n{\n    version 2.0; format ascii; class dictionary;"
            f" object {name};\n}}\n\n")


def files_of(case, seed, end):
    """What differs from the case in case/."""
    numbers = {key: value for key, value in case.items() if key != "model"}
    numbers.update(seed=seed, endTime=end)
    models = {**ALL, **MODELS[case["model"]]}
    return {
        "system/study": header("study") + "".join(
            f"{key} {value:.12g};\n" for key, value in numbers.items()
        ),
        "constant/models": header("models") + "".join(
            f"{key} {{ {entries} }}\n" for key, entries in models.items()
        ),
    }


def read_tables(folder):
    """Columns by name of agglomeration.dat, of all runs; later ones count."""
    found = runTables.tables(folder, "aerosol", "agglomeration")
    if not any(table.rows for table in found):
        return {}
    rows, sources = runTables.joined(found)
    return dict(zip(sources[-1].names(), rows.T))


def core_seconds(folder):
    """What a case has taken, with all that interrupted it."""
    log = folder/"log.acousticDEMFoam"
    if not log.exists():
        return 0
    log = log.read_text(errors="replace")
    t = [float(s) for s in re.findall(r"ExecutionTime = ([.\d]+)", log)]
    return sum(a for a, b in zip(t, [*t[1:], 0]) if b < a)


class Runner:
    """Runs cases in parallel, and keeps them."""

    def __init__(self, options):
        self.options = options
        self.results = Path(options.results).resolve()
        self.lock = threading.Lock()

    def base(self):
        """The case with its mesh, made once."""
        base = self.results/"mesh"
        base.parent.mkdir(parents=True, exist_ok=True)
        if not (base/"constant"/"polyMesh"/"owner").exists():
            shutil.rmtree(base, ignore_errors=True)
            shutil.copytree(
                HERE/"case", base,
                ignore=shutil.ignore_patterns("[0-9]*", "log.*", "polyMesh")
            )
            self.execute(base, "blockMesh")
        return base

    @staticmethod
    def execute(folder, program):
        with (folder/f"log.{program}").open("a") as log:
            done = subprocess.run([program], cwd=folder, stdout=log, stderr=log,
                                  stdin=subprocess.DEVNULL, check=False)
        if done.returncode:
            raise RuntimeError(f"{program} failed: see {folder}/log.{program}")

    def folder(self, case, seed):
        return self.results/name_of(case)/f"seed{seed}"

    def last_time(self, folder):
        table = read_tables(folder)
        return table["time"][-1] if table else -1

    def run(self, case, seed):
        """The table of a case; it is run if, or as far as, it is not there."""
        folder = self.folder(case, seed)
        end = self.options.time
        steps = case["frequency"]*case["stepsPerPeriod"]
        last = round(end*steps)/steps
        files = files_of(case, seed, last)

        def without_end(text):
            return re.sub(r"endTime.*", "", text)

        kept = (folder/"constant"/"polyMesh").exists() and all(
            (folder/name).exists()
            and without_end((folder/name).read_text()) == without_end(text)
            for name, text in files.items()
        )
        if kept and self.last_time(folder) > last - 1.5/steps:
            return read_tables(folder), False

        if not kept:
            shutil.rmtree(folder, ignore_errors=True)
            shutil.copytree(self.results/"mesh", folder)
        for name, text in files.items():
            (folder/name).write_text(text)

        self.execute(folder, "acousticDEMFoam")
        if self.last_time(folder) < 0:
            raise RuntimeError(f"acousticDEMFoam left no table in {folder}")
        for left in folder.glob("[0-9]*"):
            if self.options.slim:
                shutil.rmtree(left)
        return read_tables(folder), True

    def all(self, cases):
        """Tables of all seeds of all cases, in their order."""
        self.base()
        jobs = [(k, seed) for seed in range(1, self.options.seeds + 1)
                for k in range(len(cases))]
        tables = [[] for _ in cases]
        done, new, failed = 0, 0, []
        start = time.perf_counter()

        def work(job):
            nonlocal done, new
            k, seed = job
            label = f"{name_of(cases[k])} seed {seed}"
            try:
                table, fresh = self.run(cases[k], seed)
            except RuntimeError as error:
                with self.lock:
                    done += 1
                    failed.append(str(error))
                    print(f"[{done}/{len(jobs)}] {label}: FAILED",
                          flush=True)
                return
            with self.lock:
                done += 1
                new += fresh
                tables[k].append(table)
                if fresh:
                    print(f"[{done}/{len(jobs)}] {label}: "
                          f"{100*at(table, self.options.time):.2f} %",
                          flush=True)

        with ThreadPoolExecutor(self.options.jobs) as pool:
            list(pool.map(work, jobs))

        print(f"{new} runs in {time.perf_counter() - start:.0f} s,"
              f" {len(jobs) - new - len(failed)} were there already")
        if failed:
            sys.exit("ERROR: " + "\n       ".join(failed))
        seconds = sum(core_seconds(self.folder(cases[k], seed))
                      for k, seed in jobs)
        print(f"All of them together take {seconds:.0f} s of one core\n")
        return tables


def at(table, end, name="efficiency"):
    """The last value up to a time."""
    k = np.searchsorted(table["time"], end*(1 + 1e-9), side="right") - 1
    return table[name][k]
