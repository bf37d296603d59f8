"""Many steps of a small box, by hand: see tests/soak."""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent/"cases"))
from aerosolcase import AerosolCase, read_field  # noqa: E402

# Dictionaries of aerosolProperties that take the place of those of the base
# case, or are added to them
MODELS = {
    "Oseen": {"timeStepping": "type eventDriven;"},
    "ProudmanPearson": {"wake": "type ProudmanPearson; range 20;"},
    "memory": {
        "timeStepping": "type eventDriven;", "wake": "type memory; range 20;",
        "drag": "type SchillerNaumann; slipCorrection Cunningham;",
    },
    "history": {
        "timeStepping": "type eventDriven;", "wake": "type history; range 20;",
        "unsteadyDrag": "type Basset;",
        "drag": "type Stokes; slipCorrection none;",
    },
    "breakage": {
        "timeStepping": "type eventDriven;",
        "aggregate": "type fractal; dimension 1.8;",
        "turbulence": "type syntheticTurbulence; shearRate 3e3;",
        "breakage": "type shear; bond { type JKR; workOfAdhesion 1e-7; }",
    },
    "Brownian": {
        "Brownian": "type OrnsteinUhlenbeck; seed 3;",
        "turbulence": "type syntheticTurbulence; dissipation 1e3;",
    },
    "bounce": {
        "timeStepping": "type eventDriven;",
        "contact": "type probability; sticking 0.1; restitution 0.8;",
    },
}

FREQUENCY = 1400  # Hz, of the base case
STEPS_PER_PERIOD = 50
ROWS = 200
MASS = 1e-12  # relative; what the rounding of so many sums may leave
MEMORY = 0.05  # relative
INTERVAL = 0.5  # s, of looking at the memory
ENOUGH = 40  # times, for the first half to be more than the beginning


def make(folder, models, steps):
    """The base case with a few hundred particles and these models."""
    case = AerosolCase(folder)
    for name, text in models.items():
        file = case.path/"constant"/"aerosolProperties"
        if f"\n{name}\n" in file.read_text():
            case.model(name, text)
        else:
            file.write_text(f"{file.read_text()}\n{name}\n{{\n{text}\n}}\n")

    step = 1/(FREQUENCY*STEPS_PER_PERIOD)
    case.control("stepsPerPeriod", str(STEPS_PER_PERIOD))
    case.control("writeInterval", str(steps))
    case.control("endTime", repr((steps + 0.1)*step))
    case.aerosol("numberConcentration", "2.4e12")
    file = case.path/"constant"/"aerosolProperties"
    file.write_text(
        f"{file.read_text()}\nreport {{ interval {steps/ROWS*step!r}; }}\n"
    )
    case.run("blockMesh")
    return case


def run(case):
    """The memory of the solver over the run, in kB."""
    memory = []
    with (case.path/"log.acousticDEMFoam").open("w") as log:
        solver = subprocess.Popen(
            ["acousticDEMFoam"], cwd=case.path, stdout=log,
            stderr=subprocess.STDOUT,
        )
        status = Path(f"/proc/{solver.pid}/status")
        while solver.poll() is None:
            lines = status.read_text().splitlines()
            memory += [int(x.split()[1]) for x in lines if x[:6] == "VmRSS:"]
            time.sleep(INTERVAL)
    assert solver.returncode == 0, f"see {case.path}/log.acousticDEMFoam"
    return memory


def check(case, memory):
    """What has to be as it was."""
    for file in sorted((case.path/"postProcessing"/"aerosol").rglob("*.csv")):
        for line in file.read_text().splitlines()[1:]:
            assert "nan" not in line, f"{file}: {line}"
            # The last bin of sizes has no upper edge
            assert file.stem == "sizeDistribution" or "inf" not in line, (
                f"{file}: {line}")

    first, last = case.times()[0], case.times()[-1]
    for file in sorted((case.path/last/"lagrangian"/"aerosol").iterdir()):
        if file.name not in ("positions", "coordinates"):
            assert np.isfinite(read_field(file)).all(), file

    then, now = case.cloud(first), case.cloud(last)
    assert now["primaries"].sum() == then["primaries"].sum()

    mass = case.table()["mass_kg"]
    assert abs(mass/mass[0] - 1).max() < MASS, mass
    assert abs(now["mass"].sum()/then["mass"].sum() - 1) < MASS

    half = len(memory)//2
    before, after = max(memory[:half]), max(memory[half:])
    assert len(memory) < ENOUGH or after < (1 + MEMORY)*before, memory

    return (
        f"{len(then['id'])} particles became {len(now['id'])}, "
        f"{int(case.table()['contacts'][-1])} contacts, "
        f"{before} kB, then {after} kB"
    )


def main(total, names):
    """Sets of models, one after the other; all of them by default."""
    unknown = set(names) - set(MODELS)
    if unknown:
        sys.exit(f"ERROR: {' '.join(unknown)}: not one of {' '.join(MODELS)}")
    names = names or list(MODELS)
    steps = max(total//len(names), ROWS)

    failed = []
    for name in names:
        folder = Path(tempfile.mkdtemp(prefix=f"soak.{name}."))
        start = time.monotonic()
        try:
            case = make(folder/"case", MODELS[name], steps)
            result = check(case, run(case))
        except AssertionError as error:
            failed.append(name)
            result = f"FAILED in {folder}: {error}"
        seconds = time.monotonic() - start
        print(f"{name}: {steps} steps, {seconds:.0f} s: {result}", flush=True)

    print(f"soak: FAILED: {', '.join(failed)}" if failed else "soak: OK")
    return bool(failed)


if __name__ == "__main__":
    sys.exit(main(int(sys.argv[1]), sys.argv[2:]))
