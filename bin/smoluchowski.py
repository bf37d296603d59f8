"""A population balance: Smoluchowski's equation by sections of volume.

    dn_k/dt = sum over pairs (i, j) of K_ij n_i n_j (1 - delta_ij/2) x
              [share of v_i + v_j at k - (k = i) - (k = j)]

The fixed pivots of Kumar and Ramkrishna (Chem. Eng. Sci. 51, 1311, 1996): a
particle between two pivots is shared out to them so that number and volume are
kept. Numbers are per m3, kernels in m3/s, sizes in m.
"""

from dataclasses import dataclass

import numpy as np


@dataclass(frozen=True)
class Gas:
    """By default air of 20 degrees."""

    density: float = 1.204  # kg/m3
    viscosity: float = 1.81e-5  # Pa s
    sound_speed: float = 343.2  # m/s
    free_path: float = 66e-9  # m


AIR = Gas()


class PopulationBalance:
    """Sections between edges of diameters; kernel(d1, d2) of arrays."""

    def __init__(self, edges, kernel):
        self.edges = np.asarray(edges, float)
        self.d = np.sqrt(self.edges[1:]*self.edges[:-1])
        v = self.d**3
        n = len(v)
        self.i, self.j = np.triu_indices(n)
        sum_v = v[self.i] + v[self.j]

        # The pivots below and above the sum, and the share of the lower one;
        # at the upper end only volume can be kept
        self.below = np.searchsorted(v, sum_v*(1 + 1e-12)) - 1
        self.above = np.minimum(self.below + 1, n - 1)
        inside = self.below < self.above
        width = np.where(inside, v[self.above] - v[self.below], 1)
        self.share = np.where(
            inside, (v[self.above] - sum_v)/width, sum_v/v[-1]
        )
        self.rest = np.where(inside, 1 - self.share, 0)

        self.K = np.broadcast_to(
            kernel(self.d[self.i], self.d[self.j]), sum_v.shape
        )*np.where(self.i == self.j, 0.5, 1)

    def rate(self, n):
        events = self.K*n[self.i]*n[self.j]
        m = len(n)
        return (
            np.bincount(self.below, self.share*events, m)
            + np.bincount(self.above, self.rest*events, m)
            - np.bincount(self.i, events, m)
            - np.bincount(self.j, events, m)
        )

    def solve(self, n, times, change=0.02):
        """Numbers in the sections at the times, of which the first is the start.

        Runge-Kutta of fourth order; the total changes by less than the given
        share in a step.
        """
        result = [np.array(n, float)]
        for start, end in zip(times[:-1], times[1:]):
            n, t = result[-1], start
            while t < end:
                loss = -self.rate(n).sum()/n.sum()
                left = end - t
                steps = np.ceil(left*loss/change) if loss > 0 else 1
                h = left/max(steps, 1)
                k1 = self.rate(n)
                k2 = self.rate(n + 0.5*h*k1)
                k3 = self.rate(n + 0.5*h*k2)
                k4 = self.rate(n + h*k3)
                n = n + h/6*(k1 + 2*k2 + 2*k3 + k4)
                t = end if steps <= 1 else t + h
            result.append(n)
        return np.array(result)


def sections(smallest, largest, per_doubling=6):
    """Edges of diameters, so many sections for each doubling of the volume."""
    n = int(np.ceil(3*np.log2(largest/smallest)*per_doubling))
    return smallest*2**(np.arange(n + 1)/(3*per_doubling))


def relaxation_time(d, density=2300, gas=AIR):
    """Stokes drag with Cunningham's slip correction."""
    Kn = 2*gas.free_path/d
    slip = 1 + Kn*(1.257 + 0.4*np.exp(-1.1/Kn))
    return density*d**2*slip/(18*gas.viscosity)


def velocity_amplitude(SPL, gas=AIR):
    return np.sqrt(2)*20e-6*10**(SPL/20)/(gas.density*gas.sound_speed)


def relative_response(d1, d2, frequency, density=2300, gas=AIR):
    """Relative velocity of two spheres over that of the gas, its amplitude."""
    omega = 2*np.pi*frequency
    H1 = 1/(1 + 1j*omega*relaxation_time(d1, density, gas))
    H2 = 1/(1 + 1j*omega*relaxation_time(d2, density, gas))
    return np.abs(H1 - H2)


def orthokinetic(frequency, u0, refill=2, density=2300, gas=AIR):
    """Kernel of spheres that follow the gas each in its own way.

    refill: how often per period the path of a pair, as long as the relative
    motion from peak to peak, meets particles that were not there before; 2 is
    the formula of the textbooks, pi/4 (d1 + d2)^2 (2/pi) u12.
    """
    def kernel(d1, d2):
        u12 = u0*relative_response(d1, d2, frequency, density, gas)
        return refill*0.25*(d1 + d2)**2*u12

    return kernel


def settling_sheet(frequency, u0, gravity=9.81, across=1, dissipation=0,
                   density=2300, gas=AIR):
    """Kernel of spheres that swing and settle, and do nothing else.

    The relative path is a zigzag, dense where a pair settles by less than its
    distance of contact R per period: a sheet, as wide as the relative motion is
    from peak to peak, 2 A, and 2 R thick, that sinks with the relative settling
    speed w into what it has not met before,

        K = (4 A R + pi R^2) w,

    and at most what full refill would give. Only the part of the settling that is
    across the sound, a share of w, moves the sheet. Turbulence of so much
    dissipation [m2/s3] moves its ends against each other, on average by
    sqrt(4 dissipation/(15 viscosity)) 2 A/pi.
    """
    omega = 2*np.pi*frequency
    full = orthokinetic(frequency, u0, density=density, gas=gas)
    shear = np.sqrt(4*dissipation*gas.density/(15*gas.viscosity))

    def kernel(d1, d2):
        tau1 = relaxation_time(d1, density, gas)
        tau2 = relaxation_time(d2, density, gas)
        R = 0.5*(d1 + d2)
        A = u0/omega*relative_response(d1, d2, frequency, density, gas)
        w = gravity*np.abs(tau1 - tau2)
        v = np.hypot(across*w, shear*2*A/np.pi)
        return np.minimum(4*A*R*v, full(d1, d2)) + np.pi*R**2*w

    return kernel


def refilled(through, refill, frequency, u0, **conditions):
    """Kernel of what is refilled, and let through by the wakes:

        K = through min(K_sheet + refill K_full, K_full + pi R^2 w),

    with the kernels above; through and refill are calibrated.
    """
    full = orthokinetic(frequency, u0, density=conditions.get("density", 2300),
                        gas=conditions.get("gas", AIR))
    sheet = settling_sheet(frequency, u0, **conditions)
    still = settling_sheet(frequency, 0, **conditions)

    def kernel(d1, d2):
        most = full(d1, d2)
        return through*np.minimum(sheet(d1, d2) + refill*most,
                                  most + still(d1, d2))

    return kernel


def tabulated(edges, K):
    """Kernel of a table for classes of diameters; beyond them the last holds."""
    edges, K = np.asarray(edges), np.asarray(K)

    def which(d):
        return np.clip(np.searchsorted(edges, d) - 1, 0, len(K) - 1)

    return lambda d1, d2: K[which(d1), which(d2)]


def lognormal(edges, median, GSD, smallest, largest):
    """Shares of the sections, of a distribution that is cut off."""
    erf = np.vectorize(__import__("math").erf)
    cut = np.clip(edges, smallest, largest)
    cumulated = erf(np.log(cut/median)/np.log(GSD)/np.sqrt(2))
    share = np.diff(cumulated)
    return share/share.sum()
