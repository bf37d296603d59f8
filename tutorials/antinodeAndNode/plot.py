"""Where in a standing wave an aerosol agglomerates; antinodeAndNode.png."""

import os
import pathlib
import re
import sys

case = pathlib.Path(__file__).resolve().parent
sys.path.append(os.environ.get("ACOUSTICDEM_DIR", f"{case}/../..") + "/bin")
try:
    import runTables  # finds a Python that has what follows
except ImportError:
    sys.exit("ERROR: first source the environment: . bin/environment")

import matplotlib.pyplot as plt  # noqa: E402
import numpy as np  # noqa: E402

text = (case/"system/places").read_text()
NUMBER = {
    name: float(value) for name, value in
    re.findall(r"^(\w+)\s+([-+.\deE]+)\s*;", text, re.M)
}
LENGTH = NUMBER["soundSpeed"]/NUMBER["frequency"]  # m, of a wave
PLACES = {  # in wavelengths
    name: float(value) for name, value in
    re.findall(r"^(\w+)\s+#eval\{ ([\d.]+)\*\$wavelength \};", text, re.M)
    if name != "length"
}
tables = {
    name: runTables.columns(case, name, "agglomeration") for name in PLACES
}
u0 = np.sqrt(2)*20e-6*10**(NUMBER["SPL"]/20)/(1.204*NUMBER["soundSpeed"])

figure, (top, bottom) = plt.subplots(
    2, 1, figsize=(7, 6.4), layout="constrained"
)
print("place          [mm]   u0 [m/s]   particles   efficiency [%]")

for number, (name, place) in enumerate(PLACES.items()):
    table = tables[name]
    efficiency = 100*table["efficiency"]
    colour = plt.cm.viridis(0.95*number/(len(PLACES) - 1))
    top.plot(1e3*table["time_s"], efficiency, color=colour, label=name)
    bottom.plot(1e3*place*LENGTH, efficiency[-1], "o", color=colour, ms=8,
                clip_on=False)
    print(f"{name:13s}{1e3*place*LENGTH:6.1f}"
          f"{u0*abs(np.sin(2*np.pi*place)):11.3f}{table['number'][-1]:12.0f}"
          f"{efficiency[-1]:17.2f}")

top.set_xlabel("time [ms]")
top.set_ylabel("agglomeration efficiency [%]")
top.legend()

x = np.linspace(0.22, 0.53, 200)*LENGTH
wave = bottom.twinx()
wave.plot(1e3*x, u0*np.abs(np.sin(2*np.pi*x/LENGTH)), color="0.6")
wave.set_ylabel("velocity amplitude [m/s]", color="0.5")
wave.set_ylim(bottom=0)
bottom.set_xlabel("distance from the pressure antinode [mm]")
bottom.set_ylabel("efficiency at the end [%]")
bottom.set_ylim(bottom=0)
wave.grid(False)

runTables.save(figure, case/"antinodeAndNode.png")
