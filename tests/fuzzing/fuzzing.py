"""Cases with one mistake or a few: what the fuzzer does, and how it judges.

A case is one of the bases below, which between them have every model. Mistakes
are made in the text of its files, as by a hand that slips. A run passes if it
ends well, with numbers in its tables, or with one fatal error that names a file
of the case. It fails by a signal, by an exception or a stack of addresses, and
if it does not end.
"""

import os
import random
import re
import shutil
import subprocess
from pathlib import Path

HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"

#: Time for a run, and what is said of one that takes longer
SECONDS = 20
LATE = "does not end"

MESH = """scale 1;
vertices
(
    (0 0 0) ({length} 0 0) ({length} 0.01 0) (0 0.01 0)
    (0 0 0.01) ({length} 0 0.01) ({length} 0.01 0.01) (0 0.01 0.01)
);
blocks (hex (0 1 2 3 4 5 6 7) ({cells} 1 1) simpleGrading (1 1 1));
boundary
(
    left {{ type patch; faces ((0 4 7 3)); }}
    right {{ type patch; faces ((1 2 6 5)); }}
    sides
    {{
        type empty;
        faces ((0 3 2 1) (4 5 6 7) (0 1 5 4) (3 7 6 2));
    }}
);
"""

CONTROL = """application acousticDEMFoam;
startFrom latestTime;
startTime 0;
stopAt endTime;
endTime 4e-5;
deltaT 2e-5;
writeControl timeStep;
writeInterval 2;
purgeWrite 0;
writeFormat ascii;
writePrecision 16;
writeCompression off;
timeFormat general;
timePrecision 16;
runTimeModifiable false;
reportInterval 0;
functions
{
    level
    {
        type soundPressureLevel;
        libs ("libacousticDEMFunctionObjects.so");
        frequency 1400;
        harmonics 2;
        writeControl timeStep;
        writeInterval 2;
        probeLocations ((0.06 0.005 0.005));
    }
}
"""

SCHEMES = """ddtSchemes { default backward 1; }
gradSchemes { default Gauss linear; }
divSchemes { default Gauss linear; }
laplacianSchemes { default Gauss linear corrected; }
interpolationSchemes { default linear; }
snGradSchemes { default corrected; }
"""

SOLUTION = """solvers
{
    "rho.*" { solver diagonal; }
    "(p|U|e).*"
    {
        solver PBiCGStab; preconditioner DILU; tolerance 1e-10; relTol 0;
    }
}
PIMPLE { nOuterCorrectors 2; nCorrectors 1; }
"""

THERMO = """thermoType
{
    type hePsiThermo; mixture pureMixture; transport const; thermo hConst;
    equationOfState perfectGas; specie specie; energy sensibleInternalEnergy;
}
mixture
{
    specie { molWeight 28.96; }
    thermodynamics { Cp 1005; Hf 0; }
    transport { mu 1.81e-5; Pr 0.71; }
}
"""

VELOCITY = """dimensions [0 1 -1 0 0 0 0];
internalField uniform (0 0 0);
boundaryField
{
    left
    {
        type acousticPiston; velocityAmplitude 0.2; frequency 1400;
        phase 0.5; rampPeriods 3; startTime 0; direction (1 0 0);
        value uniform (0 0 0);
    }
    right { type zeroGradient; }
    sides { type empty; }
}
"""

PRESSURE = """dimensions [1 -1 -2 0 0 0 0];
internalField uniform 101325;
boundaryField
{
    left { type fixedFluxExtrapolatedPressure; value uniform 101325; }
    right
    {
        type waveTransmissive; psi thermo:psi; gamma 1.4; fieldInf 101325;
        lInf 1; value uniform 101325;
    }
    sides { type empty; }
}
"""

DRIVEN = """dimensions [1 -1 -2 0 0 0 0];
internalField uniform 101325;
boundaryField
{
    left
    {
        type acousticPressure; ambient 101325; pressureAmplitude 20;
        frequency table ((0 1400) (1 1400)); rampPeriods 2;
        value uniform 101325;
    }
    right { type zeroGradient; }
    sides { type empty; }
}
"""

TEMPERATURE = """dimensions [0 0 0 1 0 0 0];
internalField uniform 293.15;
boundaryField
{
    left { type zeroGradient; }
    right { type fixedValue; value uniform 293.15; }
    sides { type empty; }
}
"""

DOMAIN = "domain { type periodicBox; centre (0.0613 0.005 0.005); length "

BASES = {
    # Every kind of time stepping, wake, contact, aggregate, breakage and source
    "formula": {
        "constant/acousticProperties": """sound
{
    type standingWave; frequency 1400; SPL 147; direction (1 0 0);
    origin (0 0 0); phase 0; velocity (0.01 0 0);
    gas { T 293.15; p 101325; mu 1.81e-5; c 343; meanFreePath 66e-9; }
}
""",
        "constant/aerosolProperties": DOMAIN + """1e-3; }
particles
{
    density 2300; source distribution; initialVelocity gas; seed 1;
    numberConcentration 1e11;
    size { type lognormal; median 1.5e-6; GSD 1.8; min 0.5e-6; max 10e-6; }
}
timeStepping { type eventDriven; resolution 0.25; }
drag { type SchillerNaumann; slipCorrection Cunningham; }
gravity { type uniform; value (0 0 -9.81); }
wake { type Oseen; tolerance 5e-2; }
contact
{
    type probability; sticking 0.5; restitution 0.9; slowest 1e-6; seed 1;
}
aggregate { type equivalentSphere; }
turbulence
{
    type syntheticTurbulence; shearRate 200; wavelength 1e-3; timeScale 0.01;
    seed 3;
}
carried { velocity (0.01 0 0); }
report
{
    interval 2e-5; sizeBins { min 1e-7; max 4e-5; n 8; }
    contacts yes; breakages yes;
}
""",
    },
    "table": {
        "constant/acousticProperties": """sound
{
    type travellingWave; frequency 1400; velocityAmplitude 1.5;
    direction (1 1 0); gas { rho 1.2; }
}
""",
        "constant/aerosolProperties": DOMAIN + """(1e-3 1e-3 2e-3); }
particles { density 2300; source list; file "constant/particles.csv"; }
timeStepping { type multipleTimeStep; kp 1; kc 0.5; }
drag { type Stokes; slipCorrection none; }
gravity { type none; }
wake { type ProudmanPearson; range 20; }
Brownian { type OrnsteinUhlenbeck; seed 3; }
contact { type coalescence; surfaceTension 0.07; }
aggregate { type fractal; dimension 2; prefactor 1.3; mobilityExponent 0.5; }
breakage
{
    type shear; fragments two; share 0.4;
    bond
    {
        type Rumpf; HamakerConstant 1e-19; asperity 10e-9; separation 0.4e-9;
    }
}
""",
        "constant/particles.csv": (
            "x,y,z,d,primaries\n"
            + "".join(
                f"{0.0611 + 4e-5*i:.6g},0.005,{0.0045 + 9e-5*i:.6g},"
                f"{(1 + i)*1e-6:.3g},{1 + i}\n" for i in range(9)
            )
        ),
    },
    "clouds": {
        "constant/acousticProperties": """sound
{
    type quiescent; velocity (0.1 0 0);
}
""",
        "constant/aerosolProperties": DOMAIN + """1e-3; }
particles
{
    density 2300; source distribution; count 60; seed 1; initialVelocity rest;
    size { type histogram; file "constant/sizes.csv"; }
}
timeStepping { type conventional; kc 0.5; }
drag { type Oseen; slipCorrection Cunningham; }
gravity { type uniform; value (0 0 -9.81); }
wake { type Oseen; range 20; }
contact { type criticalVelocity; workOfAdhesion 0.05; YoungsModulus 70e9; }
aggregate { type equivalentSphere; }
breakage
{
    type impact; factor 3;
    bond
    {
        type JKR; workOfAdhesion 0.05; YoungsModulus 70e9; PoissonRatio 0.2;
    }
}
clouds
{
    here { }
    there
    {
        domain { centre (0.03 0.005 0.005); }
        particles { seed 2; size { type monodisperse; diameter 2e-6; } }
        wake { type none; }
    }
}
""",
        "constant/sizes.csv": (
            "# measured\nlower,upper,count\n0.5e-6,1e-6,120\n1e-6,4e-6,80\n"
        ),
    },
    "solved": {
        "constant/acousticProperties": """sound
{
    type explicitCompressible; frequency 1400; SPL 130;
    control
    {
        place point; point (0.06 0.005 0.005); tolerance 0.2;
        patches (left); periodicTolerance 1e-3; rampPeriods 3;
    }
}
""",
        "constant/aerosolProperties": DOMAIN + """4e-3; }
particles
{
    density 2300; source list; initialVelocity rest;
    particles
    (
        { position (0.0613 0.0045 0.005); diameter 1e-6; primaries 2; }
        { position (0.0613 0.0055 0.005); diameter 5e-6; }
    );
}
timeStepping { type eventDriven; }
drag { type Stokes; slipCorrection Cunningham; }
unsteadyDrag { type Basset; frequencies (140 14000); }
gravity { type uniform; value (0 0 -9.81); }
wake { type history; range 20; }
contact { type stick; }
aggregate { type equivalentSphere; }
coupling { type twoWay; represents (0 1 1); }
""",
        "constant/thermophysicalProperties": THERMO,
        "0/U": VELOCITY,
        "0/p": PRESSURE,
        "0/T": TEMPERATURE,
    },
    "periodic": {
        "constant/acousticProperties": """sound
{
    type untilPeriodic;
    solve { type compressible; frequency 1400; SPL 120; logSolvers no; }
    tolerance 1e-3; startTime 2e-5; harmonics 2; harmonicTolerance 1e-3;
    resolveEvery 0;
}
""",
        "constant/aerosolProperties": DOMAIN + """2e-3; }
particles
{
    density 2300; source distribution; count 20; seed 1; initialVelocity gas;
    size { type monodisperse; diameter 2e-6; }
}
timeStepping { type eventDriven; }
drag { type Stokes; slipCorrection Cunningham; }
gravity { type none; }
wake { type memory; range 20; }
contact { type stick; }
aggregate { type equivalentSphere; }
report { interval 4e-5; }
""",
        "constant/thermophysicalProperties": THERMO,
        "constant/turbulenceProperties": "simulationType laminar;\n",
        "0/U": "\n".join(
            (
                "dimensions [0 1 -1 0 0 0 0];",
                "internalField uniform (0 0 0);",
                "boundaryField",
                "{",
                "    left { type zeroGradient; }",
                "    right { type fixedValue; value uniform (0 0 0); }",
                "    sides { type empty; }",
                "}\n",
            )
        ),
        "0/p": DRIVEN,
        "0/T": TEMPERATURE,
    },
}

NUMBERS = [
    "0", "-1", "1", "1e-300", "1e300", "1e400", "-1e400", "1e200", "-1e30",
    "1e-30", "1e30", "nan", "inf", "-inf", "3.7", "2147483648", "1e10",
    "99999999999999999999", "0x10", "1,5", "1.2.3", "1e", "--1", "-0",
]

WORDS = ["none", "yes", "no", "stick", "foo", "Stokes", "Oseen", "uniform", "on"]

OTHERS = ["(1 2 3)", "()", "{ a 1; }", '"text"', "[0 1 0 0 0 0 0] 1", "$undefined"]

#: Numbers of these decide how long a run is
COSTLY = re.compile(
    r"(kp|kc|resolution|count|numberConcentration|endTime|deltaT|shearRate"
    r"|tolerance|range|length|timeScale|velocity\w*|value|frequenc\w+|T|rho|mu|c"
    r"|SPL|density|diameter|median|max|surfaceTension|writeInterval|interval)\b"
)


class Mutation:
    """A change of a text, made at random; `done` tells what it was."""

    def __init__(self, chance, text):
        self.chance = chance
        self.text = text
        self.done = ""

    def cut(self, match, new, what):
        """Put a text in the place of a match."""
        old = match.group(0)
        self.text = self.text[:match.start()] + new + self.text[match.end():]
        self.done = f"{what}: {old[:60]!r} -> {new[:60]!r}"

    def pick(self, pattern):
        """One of the places that fit."""
        found = list(re.finditer(pattern, self.text, re.M))
        return self.chance.choice(found) if found else None

    ENTRY = r"\b[A-Za-z]\w*\s+(?:\([^()]*\)|[^\s(){};][^(){};]*);"
    BLOCK = r"\b[A-Za-z]\w*\s*\{[^{}]*\}"
    NUMBER = r"(?<![\w.\"/])-?\d[\d.]*(?:[eE][-+]?\d+)?(?![\w.])"
    WORD = r"\b[A-Za-z]\w{2,}\b"

    def delete_entry(self):
        match = self.pick(self.chance.choice([self.ENTRY, self.BLOCK]))
        return match and self.cut(match, "", "deleted")

    def repeat_entry(self):
        match = self.pick(self.chance.choice([self.ENTRY, self.BLOCK]))
        return match and self.cut(match, match[0] + " " + match[0], "twice")

    def misspell(self):
        match = self.pick(self.WORD)
        if match:
            word = match[0]
            i = self.chance.randrange(len(word) - 1)
            new = self.chance.choice([
                word[:i] + word[i + 1:],
                word[:i] + word[i + 1] + word[i] + word[i + 2:],
                word[:i] + "x" + word[i:],
                word.upper(),
            ])
            self.cut(match, new, "misspelt")

    def number(self):
        match = self.pick(self.NUMBER)
        if match:
            value = self.chance.choice(
                NUMBERS
                + [f"-{match[0]}", f"{match[0]}e3", f"{match[0]}e-3", f"{match[0]}0"]
            )
            self.cut(match, value, "number")

    def kind(self):
        match = self.pick(r"(\b[A-Za-z]\w*\s+)(?:\([^()]*\)|[^\s(){};]+);")
        if match:
            value = self.chance.choice(WORDS + OTHERS + NUMBERS)
            self.cut(match, f"{match[1]}{value};", "value")

    def dictionary(self):
        if self.chance.random() < 0.5:
            match = self.pick(self.BLOCK)
            if match:
                name = re.match(r"\w+", match[0])[0]
                self.cut(match, f"{name} 1.2;", "a value for a dictionary")
        else:
            match = self.pick(self.ENTRY)
            if match:
                name = re.match(r"\w+", match[0])[0]
                self.cut(match, f"{name} {{ a 1; }}", "a dictionary for a value")

    def punctuation(self):
        match = self.pick(r"[;{}()]")
        return match and self.cut(
            match, self.chance.choice(["", "", "", match[0]*2, "{", "}", ")", ";"]),
            "punctuation",
        )

    def insert(self):
        match = self.pick(r"[;{}]")
        return match and self.cut(
            match,
            match[0] + self.chance.choice([
                " unknown 1;", " unknown { type none; }", " #include \"none\"",
                " type none;", " range 20;", "\xa0", "\ufeff", "\0", " ;", " 5;",
                " $none;", " #calc \"1/0\";", " /* ", " \"",
            ]),
            "inserted",
        )

    def end(self):
        i = self.chance.randrange(len(self.text))
        self.done = f"cut off after {i} characters"
        self.text = self.text[:i]

    def mark(self):
        self.text = "\ufeff" + self.text
        self.done = "byte order mark"

    def change(self):
        kinds = (
            [self.number]*8 + [self.kind]*4 + [self.misspell]*3
            + [self.delete_entry]*2 + [self.repeat_entry]
            + [self.dictionary]*3 + [self.punctuation]*4 + [self.insert]*2
            + [self.end, self.mark]
        )
        while not self.done:
            self.chance.choice(kinds)()
        return self.text


def write(case, name, text):
    """A file of a case; dictionaries with their header."""
    file = case/name
    file.parent.mkdir(parents=True, exist_ok=True)
    kind = {"U": "volVectorField", "p": "volScalarField", "T": "volScalarField"}
    header = (
        "" if name.endswith(".csv")
        else HEADER.format(kind.get(file.name, "dictionary"), file.name)
    )
    file.write_bytes((header + text).encode("utf-8"))


def make_bases(folder):
    """The base cases, with their meshes, in a folder."""
    for name, files in BASES.items():
        case = folder/name
        write(case, "system/controlDict", CONTROL)
        write(case, "system/fvSchemes", SCHEMES)
        write(case, "system/fvSolution", SOLUTION)
        write(
            case, "system/blockMeshDict", MESH.format(length=0.1226, cells=25)
        )
        for file, text in files.items():
            write(case, file, text)
        subprocess.run(
            ["blockMesh"], cwd=case, check=True, capture_output=True
        )


def mutate(case, base, chance):
    """Make mistakes in a copy of a base; returns what they are."""
    files = dict(BASES[base])
    files["system/controlDict"] = CONTROL

    if chance.random() < 0.02:
        name = chance.choice([f for f in files if f.startswith("constant")])
        (case/name).unlink()
        kind = chance.choice(["link", "folder", "nothing", "empty"])
        if kind == "link":
            (case/name).symlink_to("nowhere")
        elif kind == "folder":
            (case/name).mkdir()
        elif kind == "empty":
            (case/name).write_text("")
        return [f"{name}: {kind}"]

    # The files of this solver more often than those of OpenFOAM
    names = [
        name for name in files
        for _ in range(3 if "Properties" in name and "t" in name[:3] else 1)
    ]
    done = []
    for _ in range(chance.choice([1, 1, 1, 2])):
        name = chance.choice(names)
        mutation = Mutation(chance, files[name])
        files[name] = mutation.change()
        done.append(f"{name}: {mutation.done}")
        write(case, name, files[name])

    return done


NAMES = re.compile(
    r"(acoustic|aerosol|thermophysical|turbulence)Properties|controlDict"
    r"|\b0/[UpT]\b|\.csv|fvSchemes|fvSolution|polyMesh|driveFactor"
)


def judge(case, status, log):
    """What is wrong with a run, empty if nothing is."""
    fatal = len(re.findall(r"FOAM FATAL|FOAM FATAL IO", log))

    if status is None:
        return LATE
    if status not in (0, 1):
        return f"ends with {status}"
    if re.search(r"^#\d+ |terminate called|Traceback|dumped", log, re.M):
        return "a stack of addresses"
    if status == 1:
        if fatal != 1:
            return f"ends with 1 and {fatal} fatal errors"
        if not NAMES.search(log[log.index("FOAM FATAL"):]):
            return "the error names no file"
        return ""
    if fatal or "\nEnd\n" not in log:
        return "ends with 0, but not well"

    for table in case.glob("postProcessing/*/*/*.dat"):
        if re.search(r"\b(nan|inf)\b", table.read_text(errors="replace"), re.I):
            return f"numbers that are none in {table.name}"
    for field in case.glob("[0-9]*/*"):
        if field.is_file() and re.search(
            rb"[\s(](-?nan|-?inf)[\s)]", field.read_bytes()
        ):
            return f"numbers that are none in {field.name}"
    return ""


def solve(case):
    """Run a case; returns what is wrong. The log is in the file log."""
    with (case/"log").open("wb") as log:
        try:
            status = subprocess.run(
                ["acousticDEMFoam"], cwd=case, stdin=subprocess.DEVNULL,
                env=dict(os.environ, PWD=str(case)),
                stdout=log, stderr=subprocess.STDOUT, check=False,
                timeout=SECONDS,
            ).returncode
        except subprocess.TimeoutExpired:
            status = None

    text = (case/"log").read_text(errors="replace")
    return judge(case, status, text)


def run(folder, seed, number, keep=None):
    """Make and run one case; returns its base, what was done, what is wrong."""
    chance = random.Random(f"{seed} {number}")
    base = chance.choice(sorted(BASES))
    case = folder/f"case{seed}.{number}"
    shutil.copytree(folder/base, case, ignore=shutil.ignore_patterns("log*"))

    done = mutate(case, base, chance)
    wrong = solve(case)

    # More to compute than there is time for is no fault
    if (
        wrong == LATE
        and "Starting time loop" in (case/"log").read_text(errors="replace")
        and any(COSTLY.search(text) or "controlDict" in text for text in done)
    ):
        wrong = ""
        done.append("(long)")

    if wrong and keep:
        target = Path(keep)/case.name
        shutil.rmtree(target, ignore_errors=True)
        shutil.move(case, target)
    shutil.rmtree(case, ignore_errors=True)

    return base, done, wrong
