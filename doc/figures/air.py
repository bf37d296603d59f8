"""Air of 20 degrees, fly ash, and a particle in sound (doc/theory)."""

import numpy as np

VISCOSITY, DENSITY, SOUND_SPEED = 1.81e-5, 1.204, 343.2  # Pa s, kg/m3, m/s
FREE_PATH = 66e-9  # m
GRAVITY = 9.81  # m/s2
FLY_ASH = 2300.0  # kg/m3
NU = VISCOSITY/DENSITY  # m2/s


def velocity_amplitude(level):
    """Of the gas [m/s], at a velocity antinode; the level in dB is rms."""
    return np.sqrt(2)*20e-6*10**(level/20)/(DENSITY*SOUND_SPEED)


def relaxation_time(d, density=FLY_ASH):
    """Of Stokes' drag with Cunningham's slip correction [s]."""
    Kn = 2*FREE_PATH/d
    return density*d**2*(1 + Kn*(1.257 + 0.4*np.exp(-1.1/Kn)))/(18*VISCOSITY)


def response(omega, d, density=FLY_ASH):
    """Velocity of the particle over that of the gas, phasors, exp(i w t)."""
    return 1/(1 + 1j*omega*relaxation_time(d, density))
