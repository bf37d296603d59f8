"""A particle in air of 20 degrees, as in doc and in the solver's defaults."""

import numpy as np

DENSITY, VISCOSITY, SOUND_SPEED, FREE_PATH = 1.204, 1.81e-5, 343.2, 66e-9


def relaxation_time(d, particle_density=2300):
    """Stokes drag with the slip correction of Cunningham."""
    Kn = 2*FREE_PATH/d
    slip = 1 + Kn*(1.257 + 0.4*np.exp(-1.1/Kn))
    return particle_density*d**2*slip/(18*VISCOSITY)


def velocity_amplitude(SPL):
    return np.sqrt(2)*20e-6*10**(SPL/20)/(DENSITY*SOUND_SPEED)
