"""What the tests of the aerosol read: its tables, and the files of its cloud."""

import re
import sys
from pathlib import Path

import numpy as np
from foamcase import ROOT, FoamCase

sys.path.append(str(ROOT/"bin"))
from acousticDEM import csv  # noqa: E402

BASE = Path(__file__).resolve().parent/"analyticBox"


class AerosolCase(FoamCase):
    """A case with a cloud; by default tests/cases/analyticBox."""

    def __init__(self, directory, source=BASE):
        super().__init__(source, directory)

    def entry(self, name, key, value):
        """Change the value of the only entry of that name in a file."""
        file = self.path/name
        content, n = re.subn(
            rf"(?m)^(\s*{key}\s+)[^;]*;",
            lambda match: f"{match[1]}{value};",
            file.read_text(),
        )
        assert n == 1, f"{name} has {n} entries {key}"
        file.write_text(content)

    def aerosol(self, key, value):
        self.entry("constant/aerosolProperties", key, value)

    def control(self, key, value):
        self.entry("system/controlDict", key, value)

    def model(self, name, text):
        """Replace the contents of a dictionary of aerosolProperties."""
        self.replace(
            "constant/aerosolProperties",
            rf"(?ms)^{name}\n\{{.*?^\}}",
            f"{name}\n{{\n{text}\n}}",
        )

    def particles(self, rows, density=2300):
        """Replace the particles by a list of (position, diameter)."""
        entries = "\n".join(
            "{{ position ({:.17g} {:.17g} {:.17g}); diameter {:.17g}; }}"
            .format(*x, d) for x, d in rows
        )
        self.model(
            "particles",
            f"density {density};\nsource list;\nparticles\n({entries}\n);",
        )

    def exact_times(self, step, interval):
        """Steps of a power of two, whose multiples the names of times keep."""
        self.control("deltaT", repr(step))
        self.control("writeInterval", str(interval))
        self.control("timePrecision", "16")
        self.exact_numbers()

    def exact_numbers(self):
        """17 digits, which decomposePar and reconstructPar need."""
        self.replace(
            "system/controlDict", r"writePrecision\s+16", "writePrecision 17"
        )

    def run_on(self, ranks, *times):
        """The solver on some ranks, put together; from the given times."""
        self.write(
            "system/decomposeParDict",
            f"""FoamFile
{{
    version 2.0; format ascii; class dictionary; object decomposeParDict;
}}
numberOfSubdomains {ranks};
method  simple;
simpleCoeffs {{ n (1 {ranks} 1); delta 0.001; }}
""",
        )
        self.run("decomposePar", "-force", *times)

        # Without fields, decomposePar makes no time for a rank whose part of
        # the mesh has no particles; OpenFOAM then refuses to start
        for part in self.path.glob("processor*"):
            for name in self.times():
                (part/name).mkdir(exist_ok=True)

        log = self.run(
            "mpirun", "--oversubscribe", "-np", ranks,
            "acousticDEMFoam", "-parallel",
        )
        self.run("reconstructPar", "-latestTime")
        return log

    def times(self):
        """Names of the time directories, in order of time."""
        return sorted(
            (d.name for d in self.path.iterdir()
             if re.fullmatch(r"[0-9.e+-]+", d.name)),
            key=float,
        )

    def table(self, name="agglomeration", cloud="aerosol"):
        """Columns by name."""
        return csv(self.path/"postProcessing"/cloud/f"{name}.csv")

    def cloud(self, time, cloud="aerosol"):
        """The particles of a time, by name of the quantity, in order of ids."""
        folder = self.path/time/"lagrangian"/cloud
        fields = {
            name: read_field(folder/name)
            for name in ("id", "primaries", "d", "mass", "position", "U")
        }
        order = np.argsort(fields["id"])
        return {name: field[order] for name, field in fields.items()}


def read_field(file):
    """The values of an OpenFOAM field of labels, scalars or vectors."""
    content = file.read_bytes()
    kind = re.search(rb"class\s+(\w+)Field", content)[1].decode()
    binary = re.search(rb"format\s+binary", content)
    size = re.search(rb"\}[^}]*?^(\d+)\s*", content, re.M | re.S)
    n = int(size[1])
    width = 3 if kind == "vector" else 1

    if binary:
        values = np.frombuffer(
            content, np.int32 if kind == "label" else float,
            n*width, size.end() + 1,
        )
    else:
        text = content[size.end():].split(b"//")[0]
        values = np.array(
            re.sub(rb"[(){}]", b" ", text).split(),
            int if kind == "label" else float,
        )
        if text.startswith(b"{"):  # all alike
            values = np.tile(values, n)

    assert len(values) == n*width, file
    return values.reshape(n, width) if width > 1 else values
