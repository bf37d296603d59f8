"""A force on the gas: from fvOptions, or a field that others have made.

In a tube that is closed at both ends a uniform force f, from t = 0 on,
accelerates the gas in the middle by f/rho until the waves from the ends arrive.
"""

import sys
from pathlib import Path

import numpy as np
import pytest

sys.path.append(str(Path(__file__).resolve().parents[1]))
from foamcase import FoamCase  # noqa: E402

DENSITY = 101325/(8314.47/28.96*293.15)
FORCE = 2.0  # N/m3

FVOPTIONS = f"""FoamFile
{{
    version 2.0; format ascii; class dictionary; object fvOptions;
}}
push
{{
    type            vectorSemiImplicitSource;
    selectionMode   all;
    volumeMode      specific;
    injectionRateSuSp {{ U (({FORCE} 0 0) 0); }}
}}
"""

FIELD = f"""FoamFile
{{
    version 2.0; format ascii; class volVectorField; object push;
}}
dimensions      [1 -2 -2 0 0 0 0];
internalField   uniform ({FORCE} 0 0);
boundaryField
{{
    "left|right" {{ type zeroGradient; }}
    sides {{ type empty; }}
}}
"""


@pytest.mark.parametrize(
    "kind, source",
    [
        ("compressible", "fvOptions"),
        ("explicitCompressible", "fvOptions"),
        ("explicitCompressible", "field"),
    ],
)
def test_accelerates_the_gas(tmp_path, kind, source):
    case = FoamCase("standingWaveTube", tmp_path/"case")
    case.replace("constant/acousticProperties", "type +compressible",
                 f"type {kind}")
    case.replace("system/controlDict", "10.0/", "0.1/")

    if source == "fvOptions":
        case.write("constant/fvOptions", FVOPTIONS)
    else:
        case.write("0/push", FIELD)
        case.replace("constant/acousticProperties", "SPL ",
                     "force push; SPL ")
        case.replace(
            "system/controlDict", r"functions\s*\{",
            "functions { read { type readFields; libs (fieldFunctionObjects);"
            " fields (push); }",
        )

    case.run("blockMesh")
    case.run("acousticDEMFoam")

    t, U = case.probes("history", "U")
    exact = FORCE/DENSITY*t
    error = np.abs(U[:, 3] - exact).max()/exact.max()
    print(f"velocity in the middle {100*error:.3f} % off")
    assert error < 1e-3
