"""The wake of an oscillating particle, quasi-steady and with its history.

`history` is the integral for a moving point force (doc/theory) by quadrature,
`memory` its expansion to second order in the displacement, `Oseen` the wake of a
slip that has always been that of this moment.
"""

import math

import air
import matplotlib.pyplot as plt
import numpy as np
import style

FREQUENCY, GAS, DIAMETER, DENSITY = 1000.0, 0.44, 8e-6, 2400.0

OMEGA = 2*np.pi*FREQUENCY
LAYER = np.sqrt(2*air.NU/OMEGA)  # m, Stokes'
RADIUS = DIAMETER/2
SLIP = GAS*abs(1 - air.response(OMEGA, DIAMETER, DENSITY))  # m/s, amplitude

erf = np.vectorize(math.erf)


def oseen(r, phase):
    """Velocity [m/s] of the gas on the axis, at r on its positive side, for the
    slip SLIP cos(phase)."""
    slip = SLIP*np.cos(phase)
    R = r/RADIUS
    Re = abs(slip)*DIAMETER/air.NU
    lee = -3/(2*R)
    front = 3*np.expm1(-0.5*R*Re)/(Re*R**2) if Re > 1e-9 else lee
    return slip*((lee if slip > 0 else front) + 1/(2*R**3))


def memory(r, phase):
    """The same to second order in the displacement (memoryWake.H)."""
    x = r/LAYER
    y = (1 + 1j)*x
    A = 2*np.exp(-y)*(1 + 1/y + 1/y**2) - 2/y**2
    B = 6/y**2 - 2*np.exp(-y)*(1 + 3/y + 3/y**2)
    P = SLIP*np.cos(phase)
    first = 3*RADIUS/(4*r)*np.real((A + B)*SLIP*np.exp(1j*phase))
    second = 3*RADIUS/(16*air.NU)*(-2*B.imag/x**2)*2*P**2
    return P*RADIUS**3/(2*r**3) - first - second


def history(r, phase, times=3000):
    """The same by the integral over the past of the slip."""
    x = (np.arange(times) + 0.5)/times
    s = 6*(x/(1 - x))**2  # omega times the time ago
    weight = 12*x/(1 - x)**3/times
    fade = np.clip((s - 60)/120, 0, 1)
    weight = weight*(1 - fade**3*(10 - 15*fade + 6*fade**2))

    past = SLIP*np.cos(phase - s)
    way = SLIP/OMEGA*(np.sin(phase) - np.sin(phase - s))
    z = (r - way)**2*OMEGA/(4*air.NU*s) + 1e-12
    F1 = (0.5*np.sqrt(np.pi/z)*erf(np.sqrt(z)) - np.exp(-z))/(2*z)
    G = (4*np.pi*air.NU*s/OMEGA)**-1.5*2*F1
    force = -6*np.pi*air.NU*RADIUS*np.sum(G*past*weight)/OMEGA
    return force + SLIP*np.cos(phase)*RADIUS**3/(2*r**3)  # with the dipole


WAKES = (
    ("Oseen (quasi-steady)", oseen, style.RED, "--"),
    ("memory", memory, style.GREEN, ":"),
    ("history", history, style.BLUE, "-"),
)


def mean_approach(r):
    """Of two of a kind in line, for each of the wakes [m/s]."""
    phases = 2*np.pi*(np.arange(48) + 0.5)/48

    # Each is in the wake of the other; by symmetry both count the same
    return [
        -2*np.mean([wake(r, phase) for phase in phases])
        for _, wake, *_ in WAKES
    ]


def figure():
    picture, (top, bottom) = plt.subplots(
        2, 1, figsize=(style.WIDTH, 6.4), layout="constrained"
    )

    near = 2*LAYER
    periods = np.linspace(0, 1.5, 121)
    top.axhline(0, color=style.GREY, lw=0.8)
    for name, wake, colour, line in WAKES:
        top.plot(
            periods, [1e3*wake(near, 2*np.pi*t) for t in periods], line,
            color=colour, label=name,
        )
    top.set(
        xlabel="time [periods]", ylabel="velocity of the gas [mm/s]",
        xlim=(0, 1.5), ylim=(-20, 10), xticks=(0, 0.5, 1, 1.5),
        title=f"two Stokes layers ({1e6*near:.0f} µm) from a particle, in line"
        " with the sound",
    )
    top.legend(loc="upper center", ncol=3, columnspacing=1.2, borderaxespad=0)

    x = np.geomspace(0.25, 6, 30)
    means = np.array([mean_approach(LAYER*one) for one in x]).T
    for mean, (name, _, colour, line) in zip(means, WAKES):
        bottom.loglog(x, 1e3*mean, line, color=colour, label=name)
    bottom.set(
        xlabel="distance [Stokes layers]", ylabel="mean approach [mm/s]",
        xlim=(0.25, 6), title="two particles of a kind in line with the sound",
        xticks=(0.25, 0.5, 1, 2, 4), xticklabels=("0.25", "0.5", "1", "2", "4"),
        yticks=(0.1, 1, 10), yticklabels=("0.1", "1", "10"),
    )
    bottom.minorticks_off()
    bottom.grid(alpha=0.3)
    picture.suptitle(
        f"{1e6*DIAMETER:g} µm, {DENSITY:g} kg/m³, in gas of {GAS:g} m/s at"
        f" {FREQUENCY:g} Hz: slip {SLIP:.2f} m/s,\namplitude of the slip"
        f" {1e6*SLIP/OMEGA:.0f} µm, Stokes layer {1e6*LAYER:.0f} µm",
        fontsize=10,
    )
    return picture
