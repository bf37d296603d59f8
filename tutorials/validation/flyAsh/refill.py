"""Where a population balance agrees with the DEM, and where it does not.

A crowd in gas that swings alike everywhere, without wakes and gravity: spheres
move to and fro on lines. Twice the same aerosol:

  refilled      after each period all have new places at random; then a pair's
                path, as long as the relative motion from peak to peak, is swept
                once in each period: refill = 1 in smoluchowski.orthokinetic
  left alone    what is on the paths is met in the first period, and no more

The kernel is measured by bin/collisionKernels from the contacts of the first
seeds, refilled; the population balance with it must follow N(t) of the others,
and so must the balance with the kernel of theory. Neither knows that particles
that are left alone stop.
"""

import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import smoluchowski

HERE = Path(__file__).resolve().parent
sys.path.append(str(HERE.parents[2]/"bin"))
import acousticDEM  # noqa: E402

TOOL = HERE.parents[2]/"bin"/"collisionKernels"

FREQUENCY = 1400  # Hz
U0 = 1.5  # m/s
CONCENTRATION = 1.6e13  # 1/m3: about one in a hundred meets per period
MEDIAN, GSD, SMALLEST, LARGEST = 2e-6, 1.6, 0.5e-6, 6e-6  # m
EDGES = smoluchowski.sections(SMALLEST, 4*LARGEST)
# A kernel that is constant in a class is too coarse if these are few
CLASSES = EDGES[np.linspace(0, len(EDGES) - 1, 19).round().astype(int)]
PERIOD = 1/FREQUENCY


def length(number):
    return (number/CONCENTRATION)**(1/3)


def places(random, d, L):
    """At random, and none of which overlaps another."""
    x = L*random.random((len(d), 3))
    while True:
        i, j = np.triu_indices(len(d), 1)
        r = x[i] - x[j]
        r -= L*np.round(r/L)
        touch = (r**2).sum(axis=1) <= (0.5001*(d[i] + d[j]))**2
        again = np.unique(i[touch])
        if not again.size:
            return x
        x[again] = L*random.random((len(again), 3))


def diameters(random, number):
    d = np.empty(0)
    while len(d) < number:
        more = np.exp(random.normal(np.log(MEDIAN), np.log(GSD), number))
        d = np.append(d, more[(more > SMALLEST) & (more < LARGEST)])
    return d[:number]


class Box:
    """A case in which the spheres begin on their periodic orbits."""

    def __init__(self, base, folder, number, periods):
        shutil.rmtree(folder, ignore_errors=True)
        shutil.copytree(base, folder)
        self.folder = folder
        self.length = length(number)
        self.dictionary("constant/acousticProperties", f"""
            // An infinite wavelength: the same velocity everywhere
            sound {{ type travellingWave; frequency {FREQUENCY};
                velocityAmplitude {U0}; gas {{ c 1e12; }} }}
        """)
        self.dictionary("constant/aerosolProperties", f"""
            domain {{ type periodicBox; centre (0.07 0 0);
                length {self.length:.17g}; }}
            particles {{ density 2300; source list; file "particles.csv"; }}
            timeStepping {{ type eventDriven; }}
            drag {{ type Stokes; slipCorrection Cunningham; }}
            gravity {{ type none; }}
            wake {{ type none; }}
            contact {{ type stick; }}
            aggregate {{ type equivalentSphere; }}
            report {{ contacts yes; }}
        """)
        self.dictionary("system/controlDict", f"""
            application acousticDEMFoam;
            startFrom startTime; startTime 0; stopAt endTime;
            endTime {periods*PERIOD:.17g}; deltaT {PERIOD/50:.17g};
            writeControl timeStep; writeInterval {50*periods};
            writeFormat ascii; writePrecision 16; timePrecision 12;
            runTimeModifiable no;
        """)

    def dictionary(self, name, text):
        (self.folder/name).write_text(
            "FoamFile { version 2.0; format ascii; class dictionary; object "
            f"{Path(name).name}; }}\n" + re.sub(r"(?m)^ {12}", "", text)
        )

    def run(self, x, d):
        """Times, numbers, contacts as (time, d1, d2) and the last diameters."""
        for left in (self.folder/"postProcessing", *self.folder.glob("[0-9]*")):
            shutil.rmtree(left, ignore_errors=True)
        omega = 2*np.pi*FREQUENCY
        v = U0*np.imag(1/(1 + 1j*omega*smoluchowski.relaxation_time(d)))
        x = x + [0.07, 0, 0] - 0.5*self.length
        np.savetxt(
            self.folder/"particles.csv",
            np.column_stack([x, d, v, 0*v, 0*v]),
            fmt="%.17g", delimiter=",", header="x,y,z,d,vx,vy,vz", comments="",
        )
        name = self.folder/"log.acousticDEMFoam"
        with name.open("w") as log:
            done = subprocess.run(
                ["acousticDEMFoam"], cwd=self.folder, stdout=log, stderr=log,
                stdin=subprocess.DEVNULL, check=False,
            )
        if done.returncode:
            raise RuntimeError(f"acousticDEMFoam failed: see {name}")
        tables = self.folder/"postProcessing"/"aerosol"
        course = acousticDEM.csv(tables/"agglomeration.csv")
        met = acousticDEM.csv(tables/"contacts.csv")
        t, N = course["time_s"], course["number"]
        contacts = np.array([met["time_s"], met["d1_m"], met["d2_m"]]).T
        file = max(self.folder.glob("[0-9]*/lagrangian/aerosol/d"),
                   key=lambda file: float(file.parts[-4]))
        values = re.search(r"(?m)^\d+\s*\(([^)]*)\)", file.read_text())[1]
        return t, N, contacts, np.array(values.split(), float)


def counts(d):
    return np.histogram(d, EDGES)[0]


def refilled(base, folder, number, periods, seed):
    """Counts in the sections after each period; tables for collisionKernels."""
    random = np.random.default_rng(seed)
    d = diameters(random, number)
    box = Box(base, folder, number, 1)
    course, contacts = [counts(d)], []
    for k in range(periods):
        _, _, met, d = box.run(places(random, d, box.length), d)
        met[:, 0] += k*PERIOD
        contacts.append(met)
        course.append(counts(d))
    write_tables(folder, np.array(course), np.vstack(contacts), box.length**3)
    return np.array(course)


def write_tables(folder, course, contacts, volume):
    """What bin/collisionKernels reads, of all periods together."""
    target = folder/"postProcessing"/"aerosol"
    shutil.rmtree(target)
    target.mkdir()
    t = PERIOD*np.arange(len(course))
    N = course.sum(axis=1)

    def write(name, header, *columns):
        np.savetxt(target/f"{name}.csv", np.column_stack(columns), "%.17g", ",",
                   header=header, comments="")

    write("agglomeration", "time_s,number,concentration_per_m3,contacts",
          t, N, N/volume, N[0] - N)
    edges = np.concatenate([[0], EDGES, [np.inf]])
    n = len(edges) - 1
    number = np.pad(course, ((0, 0), (1, 1)))
    write("sizeDistribution", "time_s,lower_m,upper_m,number,mass_kg",
          np.repeat(t, n), np.tile(edges[:-1], len(t)),
          np.tile(edges[1:], len(t)), number.ravel(), 0*number.ravel())
    write("contacts", "time_s,d1_m,d2_m", contacts)


def measure(folder):
    """Contacts and exposure of each pair of classes, by bin/collisionKernels.

    The kernel is the one over the other; without contacts the tool gives the
    bound, three over the exposure.
    """
    edges = ",".join(f"{e:.17g}" for e in CLASSES)
    printed = subprocess.run(
        [sys.executable, TOOL, "--classes", edges, folder], check=True,
        stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True,
    ).stdout
    n = len(CLASSES) - 1
    contacts, exposure = np.zeros((n, n)), np.zeros((n, n))
    rows = [line for line in printed.splitlines() if line.count(" to ") == 2]
    for i, j, row in zip(*np.triu_indices(n), rows):
        # Two classes, contacts, and the kernel if there were pairs
        found = re.match(r"(?: +\S+ to +\S+){2} +(\d+) *(.*)", row)
        number, kernel = int(found[1]), found[2]
        if number:
            exposure[i, j] = number/float(kernel.split()[0])
        elif "<" in kernel:
            exposure[i, j] = 3/float(kernel.split("<")[1])
        contacts[i, j] = number
    return contacts, exposure


def mean_kernel(folders):
    """Symmetric; zero where there were no pairs."""
    contacts, exposure = np.sum([measure(folder) for folder in folders], axis=0)
    K = np.divide(contacts, exposure, out=np.zeros_like(contacts),
                  where=exposure > 0)
    return K + np.triu(K, 1).T


def left_alone(base, folder, number, periods, seed):
    random = np.random.default_rng(seed)
    d = diameters(random, number)
    box = Box(base, folder, number, periods)
    _, N, _, _ = box.run(places(random, d, box.length), d)
    return N


def balance(kernel, n, periods):
    model = smoluchowski.PopulationBalance(EDGES, kernel)
    n = model.solve(n, PERIOD*np.arange(periods + 1))
    return n.sum(axis=1)/n[0].sum()


def study(results, base, seeds, number, periods, jobs):
    """Runs what is not there yet; returns the figure and what is in it."""
    def kept(kind, seed, run):
        folder = results/f"{kind}_N{number}_P{periods}_seed{seed}"
        file = folder/"course.txt"
        if not file.exists():
            course = run(base, folder, number, periods, seed)
            # Whole, or not there: also where this is interrupted
            new = file.with_suffix(".new")
            np.savetxt(new, course, fmt="%d")
            new.replace(file)
        return np.loadtxt(file), folder

    results.mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(jobs) as pool:
        full = [pool.submit(kept, "refilled", seed, refilled)
                for seed in range(1, 2*seeds + 1)]
        alone = [pool.submit(kept, "alone", seed, left_alone)
                 for seed in range(1, seeds + 1)]
        full = [job.result() for job in full]
        alone = np.array([job.result()[0] for job in alone])

    # The kernel from the second half of the seeds, N(t) from the first
    K = mean_kernel([folder for _, folder in full[seeds:]])
    course = np.array([counts for counts, _ in full[:seeds]])
    N = course.sum(axis=2)
    n0 = course[:, 0].mean(axis=0)/length(number)**3

    measured = balance(smoluchowski.tabulated(CLASSES, K), n0, periods)
    theory = balance(smoluchowski.orthokinetic(FREQUENCY, U0, 1), n0, periods)
    dem = N/N[:, :1]
    error = dem.std(axis=0, ddof=1)/np.sqrt(seeds) if seeds > 1 \
        else np.sqrt(1 - dem[0])/np.sqrt(N[0, 0])
    rest = alone/alone[:, :1]

    print(f"{number} particles, {seeds} seeds each\n\n"
          "period   DEM, refilled       balance, K measured  K of theory"
          "   DEM, left alone")
    for k in np.unique(np.linspace(0, periods, 7).round().astype(int)):
        print(f"{k:6d}   {dem[:, k].mean():.4f} +- {error[k]:.4f}"
              f"{measured[k]:15.4f}{theory[k]:18.4f}"
              f"{rest[:, k].mean():16.4f}")

    figure, axes = plt.subplots(figsize=(6, 4))
    t = np.arange(periods + 1)
    axes.plot(t, theory, color="0.6",
              label="population balance, kernel of theory")
    axes.plot(t, measured, "k--",
              label="population balance, kernel measured in other seeds")
    axes.errorbar(t[::3], dem.mean(axis=0)[::3], error[::3], fmt="o", ms=4,
                  capsize=2, color="C0", label="DEM, refilled each period")
    axes.plot(t, rest.mean(axis=0), color="C3", label="DEM, left alone")
    axes.set_ylim(0, 1.02)
    axes.set_xlabel("periods")
    axes.set_ylabel("$N/N_0$")
    axes.grid(alpha=0.3)
    axes.legend(frameon=False, fontsize=8)
    return figure, {"DEM": dem, "error": error, "measured": measured,
                    "theory": theory, "alone": rest}
