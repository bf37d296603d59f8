"""Mistakes in a case: the solver says where and what, and does not run.

Each row of the tables is a change of the base case: the file, what is
replaced there (a regular expression) by what, and what the solver must say.
"""

import re
import shutil

import pytest
from aerosolcase import AerosolCase

ACOUSTIC = "constant/acousticProperties"
AEROSOL = "constant/aerosolProperties"
CONTROL = "system/controlDict"

SOURCE = r"(?s)source +distribution;.*?seed +1;"
LOGNORMAL = r"type +lognormal;[^}]*"
SIZE = r"size\s*\{[^}]*\}"
NUMBER = r"numberConcentration [^;]*;"


def listed(*particles):
    """The text of a list of particles, in place of the distribution."""
    return "source list; particles (" + " ".join(
        f"{{ position {position}; diameter {diameter}; }}"
        for position, diameter in particles
    ) + ");"


BAD = {
    # Missing
    "noDensity": (AEROSOL, r"density [^;]*;", "", "Entry 'density' not found"),
    "noLength": (AEROSOL, r"length [^;]*;", "", "Entry 'length' not found"),
    "noCentre": (AEROSOL, r"centre [^;]*;", "", "Entry 'centre' not found"),
    "noSize": (AEROSOL, SIZE, "", "Entry 'size' not found"),
    "noMedian": (AEROSOL, r"median [^;]*;", "", "Entry 'median' not found"),
    "noKc": (AEROSOL, r"kc [^;]*;", "", "Entry 'kc' not found"),
    "noGravity": (AEROSOL, r"value [^;]*;", "", "Entry 'value' not found"),
    "noSlip": (
        AEROSOL, r"slipCorrection [^;]*;", "",
        "Entry 'slipCorrection' not found",
    ),
    "noType": (AEROSOL, r"type +Stokes;", "", "Entry 'type' not found"),
    "noFrequency": (
        ACOUSTIC, r"frequency [^;]*;", "", "Entry 'frequency' not found",
    ),
    "noLevel": (
        ACOUSTIC, r"SPL [^;]*;", "",
        "exactly one of the entries SPL .* and velocityAmplitude",
    ),

    # Of another name now
    "carried": (
        AEROSOL, "domain", "carried { velocity (1 0 0); }\n\ndomain",
        "Dictionary 'carried' is named 'frame' now",
    ),

    # Too much, or too little
    "twoLevels": (
        ACOUSTIC, "SPL", "velocityAmplitude 1; SPL",
        "exactly one of the entries SPL .* and velocityAmplitude",
    ),
    "twoNumbers": (
        AEROSOL, NUMBER, "numberConcentration 1e12; count 100;",
        "from one of .*numberConcentration massConcentration count.* has both"
        " 'numberConcentration' and 'count'",
    ),
    "rangeAndTolerance": (
        AEROSOL, r"range +20;", "range 20; tolerance 5e-3;",
        "either 'range' .* or 'tolerance' .* or neither .* has both",
    ),
    "noNumber": (
        AEROSOL, NUMBER, "",
        "from one of .*numberConcentration massConcentration count.* has"
        " neither of them",
    ),

    # Out of range
    "negativeDensity": (
        AEROSOL, "2300", "-2300", "'density' .* is -2300, .* positive",
    ),
    "negativeLength": (
        AEROSOL, r"0\.5e-3", "-1", "'length' .* is .*-1.*, .* positive",
    ),
    "flatBox": (
        AEROSOL, r"length +0\.5e-3", "length (5e-4 5e-4 0)",
        "'length' .* is .* positive",
    ),
    "negativeMedian": (
        AEROSOL, r"1\.5e-6", "-1e-6", "'median' .* is -1e-06, .* positive",
    ),
    "negativeDiameter": (
        AEROSOL, SOURCE, listed(("(0.0613 0 0)", "-1e-6")),
        "'diameter' .* is -1e-06, .* positive",
    ),
    "negativeFrequency": (
        ACOUSTIC, "1400", "-1400", "'frequency' .* is -1400, .* positive",
    ),
    "negativeAmplitude": (
        ACOUSTIC, "SPL +147", "velocityAmplitude -1",
        "'velocityAmplitude' .* is -1, .* zero or more",
    ),
    "negativeRange": (
        AEROSOL, "range +20", "range -20", "'range' .* is -20, .* positive",
    ),
    "zeroTolerance": (
        AEROSOL, "range +20", "tolerance 0", "'tolerance' .* is 0, .* positive",
    ),
    "zeroKc": (AEROSOL, r"kc +0\.1", "kc 0", "'kc' .* is 0, .* positive"),
    "negativeKp": (AEROSOL, r"kp +1", "kp -1", "'kp' .* is -1, .* positive"),
    "frequencies": (
        AEROSOL, r"\ngravity",
        "\nunsteadyDrag { type Basset; frequencies (20 140); }\ngravity",
        "'frequencies' are .*20 140.* must be two numbers .* 10 times",
    ),
    "GSD": (AEROSOL, r"GSD +1\.8", "GSD 0.5", "'GSD' .* is 0.5, .* than 1"),
    "maxBelowMin": (
        AEROSOL, "max +10e-6", "max 0.1e-6", "'min' .* less than 'max'",
    ),
    "micrometres": (
        AEROSOL, r"median +1\.5e-6", "median 1.5",
        "less than one in a million .* in metres",
    ),
    "zeroCount": (
        AEROSOL, NUMBER, "count 0;", "'count' .* is 0, .* positive",
    ),
    "halfAParticle": (
        AEROSOL, NUMBER, "count 10.5;", "10.5, .* whole number",
    ),
    "noneInTheBox": (
        AEROSOL, r"6\.4e12", "1e3", "whole number from 1 .*numberConcentr",
    ),
    "crowd": (AEROSOL, r"6\.4e12", "1e17", "no more than 10 %"),
    "zeroDirection": (
        ACOUSTIC, "SPL", "direction (0 0 0); SPL", "'direction' .* zero vector",
    ),
    "negativeGas": (
        ACOUSTIC, "SPL", "gas { mu -1; } SPL", "'mu' .* is -1, .* positive",
    ),

    "fractalLine": (
        AEROSOL, r"type +equivalentSphere;", "type fractal; dimension 1;",
        "'dimension' .* is 1, .* above 1, up to 3",
    ),
    "fractalDrag": (
        AEROSOL, r"type +equivalentSphere;",
        "type fractal; dimension 1.8; mobilityExponent 2;",
        "'mobilityExponent' .* is 2, .* 1/3 to 1",
    ),
    "breakageWithoutBond": (
        AEROSOL, "aggregate", "breakage { type drag; }\naggregate",
        "Entry 'bond' not found",
    ),
    "breakageShare": (
        AEROSOL, "aggregate",
        "breakage { type shear; fragments two; share 0.7;"
        " bond { type JKR; workOfAdhesion 0.05; } }\naggregate",
        "'share' .* is 0.7, .* not be above 0.5",
    ),
    "negativeAdhesion": (
        AEROSOL, r"type +stick;",
        "type criticalVelocity; workOfAdhesion -1; YoungsModulus 70e9;",
        "'workOfAdhesion' .* is -1, .* positive",
    ),
    "noModulus": (
        AEROSOL, r"type +stick;",
        "type criticalVelocity; workOfAdhesion 0.05;",
        "Entry 'YoungsModulus' not found",
    ),
    "PoissonRatio": (
        AEROSOL, r"type +stick;",
        "type criticalVelocity; workOfAdhesion 0.05; YoungsModulus 70e9;"
        " PoissonRatio 0.6;",
        "'PoissonRatio' .* is 0.6, .* not be above 0.5",
    ),
    "certainty": (
        AEROSOL, r"type +stick;", "type probability; sticking 1.1;",
        "'sticking' .* is 1.1, .* from 0 to 1",
    ),
    "gainOfEnergy": (
        AEROSOL, r"type +stick;",
        "type probability; sticking 0.5; restitution 2;",
        "'restitution' .* is 2, .* from 0 to 1",
    ),
    "typoInContact": (
        AEROSOL, r"type +stick;",
        "type probability; sticking 0.5; restitutoin 1;",
        r"Unknown .* 'restitutoin' .* restitution",
    ),
    "bounceInBrownianMotion": (
        AEROSOL, r"contact\s*\{\s*type +stick;",
        "Brownian { type OrnsteinUhlenbeck; }\n"
        "contact { type probability; sticking 0.5; restitution 1;",
        "bounce cannot have Brownian motion",
    ),
    "bounceWithoutAggregate": (
        AEROSOL, r"(?s)contact\s*\{.*equivalentSphere;",
        "contact { type probability; sticking 0.5; restitution 1; }\n"
        "aggregate { type none;",
        "'probability' .* bounce or stick, .* 'aggregate' is none",
    ),

    "turbulenceTwice": (
        AEROSOL, r"domain",
        "turbulence { type syntheticTurbulence; dissipation 1; shearRate 9; }"
        "\ndomain",
        "exactly one of 'dissipation' .*, 'shearRate' .* and 'meanFlow yes'",
    ),
    "turbulenceOfNothing": (
        AEROSOL, r"domain",
        "turbulence { type syntheticTurbulence; meanFlow no; }\ndomain",
        "exactly one of 'dissipation' .*, 'shearRate' .* and 'meanFlow yes'",
    ),
    "turbulenceBeyondNumbers": (
        AEROSOL, r"domain",
        "turbulence { type syntheticTurbulence; dissipation 1e300; }\ndomain",
        "'dissipation' .* is 1e.*300, but must be from .* to",
    ),
    "turbulenceOfNoTime": (
        AEROSOL, r"domain",
        "turbulence { type syntheticTurbulence; dissipation 1; timeScale 1e-30; }"
        "\ndomain",
        "'timeScale' .* is 1e-30, but must be from .* to",
    ),
    "turbulenceOfNoLength": (
        AEROSOL, r"domain",
        "turbulence { type syntheticTurbulence; dissipation 1;"
        " wavelength 1e-9; }\ndomain",
        "'wavelength' .* is 1e-09, but must be from .* to",
    ),
    "turbulenceSlowerThanItsWaves": (
        AEROSOL, r"domain",
        "turbulence { type syntheticTurbulence; dissipation 1;"
        " accelerationFactor 1e-3; }\ndomain",
        "'accelerationFactor' .* is 0.001, but the waves have .* 'wavelength'",
    ),
    "turbulenceOfAnUnknownMeanFlow": (
        AEROSOL, r"domain",
        "turbulence { type syntheticTurbulence; meanFlow yes; }\ndomain",
        "'meanFlow' .* is not known .* 'replay' .* or give 'shearRate'",
    ),
    "turbulenceInAnOddDomain": (
        AEROSOL, r"domain\s*\{([^}]*)length [^;]*;",
        "turbulence { type syntheticTurbulence; dissipation 1; }\n"
        "domain { type periodicBox; centre (0.0613 0 0);"
        " length (1.33e-3 1.5e-3 1e-3);",
        "No isotropic turbulence of waves of 0.001 m .* 'wavelength'",
    ),

    # Wrong dimensions, not numbers
    "dimensions": (
        ACOUSTIC, "1400", "[0 1 0 0 0 0 0] 1400",
        r"'frequency' .* \[0 1 0 0 0 0 0\], .* \[0 0 -1 0 0 0 0\]",
    ),
    "vectorDimensions": (
        ACOUSTIC, "SPL", "origin [0 0 0 0 0 0 0] (0 0 0); SPL",
        r"'origin' .* \[0 0 0 0 0 0 0\], .* \[0 1 0 0 0 0 0\]",
    ),
    "word": (ACOUSTIC, "1400", "high", "'frequency' .* is 'high', .* number"),
    "wordForCount": (AEROSOL, NUMBER, "count many;", "'count' .* is 'many', .* number"),
    "wordForCentre": (
        AEROSOL, r"centre +\([^)]*\)", "centre here",
        "'centre' .* is 'here', .* one vector",
    ),
    "wordForLength": (
        AEROSOL, r"length +0\.5e-3", "length long",
        "'length' .* is 'long', .* one number, for a cube, or",
    ),
    "wordForGravity": (
        AEROSOL, r"value +\([^)]*\)", "value down",
        "'value' of .*gravity.* is 'down', .* one vector, such as",
    ),
    "numberForGravity": (
        AEROSOL, r"value +\([^)]*\)", "value -9.81",
        "'value' of .*gravity.* is '-9.81', .* one vector, such as",
    ),
    "numberForCentre": (
        AEROSOL, r"centre +\([^)]*\)", "centre 0.0613",
        "'centre' of .*domain.* is '0.0613', .* one vector, such as",
    ),
    "twoComponents": (
        AEROSOL, r"length +0\.5e-3", "length (5e-4 5e-4)",
        r"'length' .* is .*0\.0005 0\.0005.*, .* \(Lx Ly Lz\)",
    ),
    "nan": (ACOUSTIC, "1400", "nan", "'frequency' .* is 'nan', .* number"),
    "inf": (AEROSOL, "2300", "inf", "'density' .* is 'inf', .* number"),
    "lengthOfThree": (
        AEROSOL, r"length +0\.5e-3", "length 5e-4 1e-3 5e-4",
        r"'length' .* is .0\.0005 0\.001 0\.0005., .* \(Lx Ly Lz\)",
    ),
    "vectorAndMore": (
        ACOUSTIC, "SPL", "velocity (1 0 0) 2; SPL",
        "'velocity' .* must be one vector, such as .*, and nothing after it",
    ),
    "infLength": (AEROSOL, r"0\.5e-3", "inf", "'length' of .* is 'inf', .* number"),
    "infInCentre": (
        AEROSOL, r"0\.0613 0 0", "inf 0 0", "'centre' .* is .*inf 0 0.* one vector",
    ),
    "nothing": (ACOUSTIC, "1400", "", "'frequency' .* one number"),
    "twoValues": (ACOUSTIC, "1400", "1400 Hz", "'frequency' .* one number"),

    # Unknown models
    "domain": (
        AEROSOL, "periodicBox", "sphere", "Unknown .*sphere.*periodicBox",
    ),
    "source": (
        AEROSOL, SOURCE, "source magic;",
        "Unknown .*magic.*distribution.*list",
    ),
    "size": (
        AEROSOL, "lognormal", "gaussian", "Unknown .*gaussian.*lognormal",
    ),
    "timeStepping": (
        AEROSOL, "multipleTimeStep", "slow",
        "Unknown .*slow.*conventional.*multipleTimeStep",
    ),
    "drag": (
        AEROSOL, "type +Stokes", "type Newton", "Unknown .*Newton.*Stokes",
    ),
    "noDictionary": (
        AEROSOL, r"\ngravity", "\ncoupling twoWay;\ngravity",
        "'coupling' .* must be a dictionary",
    ),
    "unsteadyDrag": (
        AEROSOL, r"\ngravity", "\nunsteadyDrag { type Maxey; }\ngravity",
        "Unknown .*Maxey.*Basset.*none",
    ),
    "slipCorrection": (
        AEROSOL, "Cunningham", "Millikan", "Unknown .*Millikan.*Cunningham",
    ),
    "wake": (AEROSOL, "Oseen", "Lamb", "Unknown .*Lamb.*Oseen"),
    "gravity": (
        AEROSOL, "type +uniform", "type lunar", "Unknown .*lunar.*uniform",
    ),
    "contact": (AEROSOL, "stick", "glue", "Unknown .*glue.*stick"),
    "aggregate": (
        AEROSOL, "equivalentSphere", "chain", "Unknown .*chain.*equivalentSph",
    ),
    "sound": (
        ACOUSTIC, "standingWave", "noise", "Unknown .*noise.*standingWave",
    ),
    "initialVelocity": (
        AEROSOL, "seed", "initialVelocity fast; seed",
        "'initialVelocity' .* 'fast', .* gas or rest",
    ),

    # Places
    "boxOutside": (
        AEROSOL, r"0\.0613 0 0", "0 0 0", "leaves the mesh.* make the mesh larger",
    ),
    "boxForWakes": (
        AEROSOL, "range +20", "range 60",
        "range of the wakes smaller, by 'range' in .* 'wake'",
    ),
    "boxForTolerance": (
        AEROSOL, "range +20", "tolerance 1e-3",
        "range of the wakes smaller, by a larger 'tolerance' or by a fixed"
        " 'range' in .* 'wake'",
    ),
    "toleranceOfLength": (
        AEROSOL, "range +20", "tolerance [0 1 0 0 0 0 0] 1e-3",
        "'tolerance' .* has the dimensions",
    ),
    "boxForParticles": (
        AEROSOL, "max +10e-6", "max 1e-3", "largest particles, .* do not fit",
    ),
    "overlap": (
        AEROSOL, SOURCE,
        listed(("(0.0613 0 0)", "2e-6"), ("(0.0613 1e-6 0)", "2e-6")),
        "overlap: number 1 .* number 2",
    ),
    "overlapAcrossFaces": (
        AEROSOL, SOURCE,
        listed(
            ("(0.0613  0.2499e-3 0)", "2e-6"), ("(0.0613 -0.2499e-3 0)", "2e-6")
        ),
        "overlap: .* image",
    ),
    "listOutside": (
        AEROSOL, SOURCE, listed(("(0 0 0)", "2e-6")),
        "number 1 .* outside of the domain",
    ),
    "emptyList": (
        AEROSOL, SOURCE, listed(), "list 'particles' .* is empty",
    ),
    "listWithoutPlace": (
        AEROSOL, SOURCE, "source list; particles ({ diameter 1e-6; });",
        "Entry 'position' not found",
    ),
    "noListFile": (
        AEROSOL, SOURCE, 'source list; file "none.csv";',
        "Cannot read .*none.csv.* 'file'",
    ),
    "noHistogramFile": (
        AEROSOL, LOGNORMAL, 'type histogram; file "none.csv";',
        "Cannot read .*none.csv.* 'file'",
    ),
    "histogramNeither": (
        AEROSOL, LOGNORMAL, "type histogram;",
        "either 'bins' or 'file', .* neither",
    ),
    "histogramOverlaps": (
        AEROSOL, LOGNORMAL,
        "type histogram; bins ((1e-6 3e-6 1) (2e-6 4e-6 1));",
        "number 2 of 'bins', .* not overlap",
    ),

    # Entries that nobody reads
    "typoInTolerance": (
        AEROSOL, "range +20", "tolerence 1",
        "Unknown .* 'tolerence' .* tolerance",
    ),
    "negativeSeed": (
        AEROSOL, r"\bseed [^;]*;", "seed -1;",
        "'seed' .* is -1, .* whole number, 0 or more",
    ),
    "typoInSeed": (AEROSOL, r"\bseed\b", "sed", "Unknown .* 'sed' .* seed"),
    "typoInSound": (
        ACOUSTIC, "SPL", "directon (0 1 0); SPL",
        "Unknown .* 'directon' .* direction",
    ),
    "typoInGas": (
        ACOUSTIC, "SPL", "gas { rh 1.2; } SPL", "Unknown .* 'rh' .* rho",
    ),
    "typoInReport": (
        AEROSOL, "domain", "report { intervall 1; }\ndomain",
        r"Unknown .* 'intervall' .*\(interval",
    ),
    "unknownDictionary": (
        AEROSOL, "domain", "reprt { interval 1; }\ndomain",
        "Unknown .* 'reprt' .* report",
    ),
    "kpAboveOne": (AEROSOL, r"kp +[0-9.]+", "kp 1000", "'kp' .* not above 1"),
    "kcAboveOne": (AEROSOL, r"kc +[0-9.]+", "kc 100", "'kc' .* not above 1"),

    # Entries of a model that is not in use
    "rangeOfNoWake": (
        AEROSOL, "type +Oseen", "type none",
        r"Unknown entry 'range' .*valid entries are 1\(type\)",
    ),
    "valueOfNoGravity": (
        AEROSOL, "type +uniform", "type none", "Unknown entry 'value'",
    ),
    "slipOfNoDrag": (
        AEROSOL, "type +Stokes", "type none", "Unknown entry 'slipCorrection'",
    ),
    "entryOfNoContact": (
        AEROSOL, "type +stick;", "type none; sticking 1;",
        "Unknown entry 'sticking'",
    ),
    "entryOfNoCoupling": (
        AEROSOL, "domain", "coupling { type none; range 1; }\ndomain",
        "Unknown entry 'range'",
    ),
    "entryOfNoTurbulence": (
        AEROSOL, "domain", "turbulence { type none; seed 1; }\ndomain",
        "Unknown entry 'seed'",
    ),
    "medianOfOneSize": (
        AEROSOL, "type +lognormal;", "type monodisperse; diameter 1e-6;",
        "Unknown entry 'median' .*diameter",
    ),
    "sizeOfAList": (
        AEROSOL, "source +distribution;",
        "source list; particles ({ position (0.0613 0 0); diameter 1e-6; });",
        "Unknown entry 'size' .*particles file",
    ),
    "dictionaryBesideTheSound": (
        ACOUSTIC, "sound", "gas { T 300; }\nsound",
        "Unknown dictionary 'gas' .*sound",
    ),

    # Not a dictionary
    "gasIsANumber": (
        ACOUSTIC, "SPL", "gas 1.2; SPL", "'gas' .* must be a dictionary",
    ),
    "reportIsANumber": (
        AEROSOL, "domain", "report 1;\ndomain", "'report' .* be a dictionary",
    ),
    "sizeBinsIsAList": (
        AEROSOL, "domain", "report { sizeBins (1e-7 1e-5 8); }\ndomain",
        "'sizeBins' .* must be a dictionary",
    ),
    "numberIsADictionary": (
        ACOUSTIC, r"frequency +1400;", "frequency { a 1400; }",
        "'frequency' of .*sound.* must be a value",
    ),

    # Semicolons that are missing
    "afterANumber": (ACOUSTIC, "1400;", "1400", "'frequency' .* one number"),
    "afterAVector": (
        AEROSOL, r"\(0\.0613 0 0\);", "(0.0613 0 0)", "'centre' .* one vector",
    ),
    "afterADirection": (
        ACOUSTIC, "SPL", "direction (1 0 0) phase 0; SPL",
        "'direction' .* one vector",
    ),
    "afterAWord": (AEROSOL, "Cunningham;", "Cunningham 1;", "excess tokens"),

    # What cannot be
    "highLevel": (ACOUSTIC, r"SPL +147", "SPL 196", "'SPL' .* is 196, .*above 185"),
    "twoDigitsTooMany": (
        ACOUSTIC, r"SPL +147", "SPL 14700", "'SPL' .* is 14700, .*above 185",
    ),
    "supersonic": (
        ACOUSTIC, "SPL +147", "velocityAmplitude 1000",
        "'velocityAmplitude' .* is 1000, .*above 122",
    ),
    "supersonicFlow": (
        ACOUSTIC, "SPL", "velocity (0 1e200 0); SPL",
        "'velocity' .*faster than sound",
    ),
    "degreesCelsius": (
        ACOUSTIC, "SPL", "gas { T 20; } SPL", "is 20 K, .*Celsius",
    ),
    "bar": (
        ACOUSTIC, "SPL", "gas { p 1.013; } SPL", "is 1.013 Pa, .*in bar",
    ),
    "gaugePressure": (
        ACOUSTIC, "SPL", "gas { p 0; } SPL", "'p' .* is 0, .* positive",
    ),
    "pressureAndDensity": (
        ACOUSTIC, "SPL", "gas { p 1e5; rho 1.2; } SPL", "either 'p' or 'rho'",
    ),
    "manyParticles": (
        AEROSOL, NUMBER, "count 2000000000;",
        "2000000000 particles need .* of memory, .* 'count'",
    ),

    # Numbers that no double holds, or whose powers are none
    "hugeGravity": (AEROSOL, r"-9\.81", "1e400", "'value' on line"),
    "hugeLevel": (ACOUSTIC, r"SPL +147", "SPL 147000", "'SPL' .* is 147000"),
    "hugeFrequency": (ACOUSTIC, "1400", "1e400", "frequency|1e400"),
    "hugeLength": (AEROSOL, r"0\.5e-3", "1e200", "leaves the mesh"),
    "hugeEndTime": (CONTROL, r"endTime +#[^}]*\}", "endTime 1e400", "endTime|1e400"),

    # Times
    "noStep": (CONTROL, r"deltaT +#[^}]*\}", "deltaT 0", "'deltaT' is 0 s, .*positive"),
    "stepBack": (
        CONTROL, r"deltaT +#[^}]*\}", "deltaT -1e-6", "'deltaT' is -1e-06 s",
    ),
    "shortStep": (
        CONTROL, r"deltaT +#[^}]*\}",
        "deltaT 1e-6; startTime 1e12; startFrom startTime",
        "too short",
    ),

    # What cannot be seen
    "mark": (AEROSOL, "tolerance|range", "\ufeffrange", r"<U\+FEFF>range"),
    "hardSpace": (AEROSOL, "Cunningham", "Cunningham\u00a0", r"<U\+00A0>"),

    # Reports and files
    "interval": (
        AEROSOL, "domain", "report { interval 0; }\ndomain",
        "'interval' .* is 0, .* positive",
    ),
    "sizeBins": (
        AEROSOL, "domain",
        "report { sizeBins { min 1e-5; max 1e-6; } }\ndomain",
        "sizeBins .* max must be above min",
    ),
    "sizeBinsEntry": (
        AEROSOL, "domain", "report { sizeBins { count 10; } }\ndomain",
        "Unknown entry 'count' .*min max n",
    ),
    "asciiDigits": (
        CONTROL, r"binary;\s*writePrecision +16", "ascii; writePrecision 6",
        "writePrecision 6 .*writePrecision +16",
    ),
}

DICTIONARIES = [
    "domain", "particles", "timeStepping", "drag", "gravity", "wake",
    "contact", "aggregate", "sound",
]


def check_refusal(log, file, message, kind="IO ERROR"):
    """One error, that says where and what; no run, and no stack trace."""
    assert log.count("FOAM FATAL") == 1, log[-3000:]
    assert not re.search(r"sigFpe|sigSegv|[Ss]egmentation|^#\d", log, re.M), log
    assert "Starting time loop" not in log

    error = " ".join(log[log.index("FOAM FATAL"):].split())
    assert error.startswith(f"FOAM FATAL {kind}"), error
    assert re.search(message, error, re.I), error

    if file:
        where = re.search(rf"file: (?:\S+/)?{file}\S* (at|from) line (\d+)", error)
        assert where and int(where[2]) > 0, error


@pytest.mark.parametrize("row", BAD.values(), ids=BAD.keys())
def test_is_refused(box, row):
    file, pattern, text, message = row
    box.replace(file, pattern, text)
    check_refusal(box.run("acousticDEMFoam", status=1), file, message)


@pytest.mark.parametrize("name", DICTIONARIES)
def test_needs_the_dictionary(box, name):
    file = ACOUSTIC if name == "sound" else AEROSOL
    box.replace(file, rf"(?ms)^{name}\n\{{.*?^\}}", "")
    log = box.run("acousticDEMFoam", status=1)

    # That of a file as a whole has no lines
    check_refusal(log, None, f"'{name}' not found")
    assert re.search(rf"file: (?:{box.path}/)?{file}", log)


def test_wakes_without_slip_have_no_default_range(box):
    """Neither sound nor gravity say how far they should act."""
    box.replace(ACOUSTIC, r"(?s)type.*antinode", "type quiescent;")
    box.replace(AEROSOL, r"range +20;", "")
    box.replace(AEROSOL, r"type +uniform;\s*value[^;]*;", "type none;")
    log = box.run("acousticDEMFoam", status=1)
    check_refusal(log, AEROSOL, "no default: .* is zero: give 'range'")


def test_wakes_without_drag_have_no_default_range(box):
    box.replace(ACOUSTIC, r"(?s)type.*antinode", "type quiescent;")
    box.replace(AEROSOL, r"range +20;", "")
    box.replace(AEROSOL, r"type +Stokes;[^}]*", "type none;")
    log = box.run("acousticDEMFoam", status=1)
    check_refusal(log, AEROSOL, "no default: .* without drag: give 'range'")


@pytest.mark.parametrize("wake", ["type Oseen;", "type Oseen; tolerance 1;"])
def test_ranges_need_the_level_of_the_sound(tmp_path, wake):
    """What is solved on the mesh is not known before."""
    case = AerosolCase(tmp_path/"case", "flyAshChamber")
    case.run("blockMesh")
    case.replace(ACOUSTIC, r"SPL +[^;]*;", "")
    case.model("wake", wake)
    log = case.run("acousticDEMFoam", status=1)
    check_refusal(log, AEROSOL, "'SPL' or .* or give 'range'")


def test_the_base_case_runs(box):
    assert "End" in box.run("acousticDEMFoam")


def test_needs_acousticProperties(box):
    (box.path/ACOUSTIC).unlink()
    log = box.run("acousticDEMFoam", status=1)
    check_refusal(log, None, "cannot find .*acousticProperties", kind="ERROR")


def test_cells_of_a_table(box):
    """In a table of numbers the error is in the table's own line."""
    box.write("sizes.csv", "lower,upper,count\n1e-6,2e-6,1\n2e-6,nan,1\n")
    box.replace(AEROSOL, LOGNORMAL, 'type histogram; file "sizes.csv";')
    log = box.run("acousticDEMFoam", status=1)
    check_refusal(log, "sizes.csv", "'nan' is not a finite number")
    assert "at line 3" in log


@pytest.mark.parametrize(
    "lost, message",
    [
        ("uniform/aerosolState", "without the file .*aerosolState"),
        ("lagrangian/aerosol/d", "'d' .* 0 values, .* 800 particles"),
    ],
)
def test_a_lost_file_of_a_restart(box, lost, message):
    box.control("writeInterval", "1000")
    box.run("acousticDEMFoam")
    (box.path/"0"/lost).unlink()
    box.control("startFrom", "startTime")
    log = box.run("acousticDEMFoam", status=1)
    log = log[log.rindex("Create time"):]
    check_refusal(log, None, message, kind="")


def test_a_lost_cloud_of_a_restart(box):
    """Not a new aerosol where the old one has not been written completely."""
    box.run("acousticDEMFoam")
    last = box.path/box.times()[-1]
    shutil.rmtree(last/"lagrangian")
    (last/"uniform/aerosolState").unlink()

    log = box.run("acousticDEMFoam", status=1)
    log = log[log.rindex("Create time"):]
    check_refusal(log, None, f"no particles, .* remove .*{last.name}", "ERROR")
