"""The cases that the fuzzer makes mistakes in: between them they have every model."""

import subprocess

HEADER = "FoamFile {{ version 2.0; format ascii; class {}; object {}; }}\n"

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
frame { velocity (0.01 0 0); }
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
