"""What wakes take from a path that is swept: pairs, by brute force.

Two spheres in a gas that swings alike everywhere, each in the wake of the other,
by the formula of the solver: the flow of Oseen by its slip against the
undisturbed gas (src/aerosol/laws/wake/OseenWake), and no farther than by
default, where it fades out. All is relative to the gas. Runge and Kutta's fourth
order, in steps that are short against relaxation times, period and time to
contact; contacts are those of the chords.

  stroke   from one end of the relative swing to the other, half a period, among
           small ones at random: share of the volume 2A pi R^2 that is captured
  sheet    swinging and settling, down upon small ones at random: share of the
           area 4AR + pi R^2
  fall     settling without sound: the classic efficiency of collision

The first one of a pair is the larger. The population balance then has its kernel
times the share of the stroke.
"""

from functools import lru_cache

import matplotlib.pyplot as plt
import numpy as np
import smoluchowski

NU = smoluchowski.AIR.viscosity/smoluchowski.AIR.density
# Of the diameters of the study, on which the default range depends
MEAN = 1.78e-6
GRAVITY = 9.81*(1 - smoluchowski.AIR.density/2300)


def drag(d, speed):
    """Schiller and Naumann."""
    return 1 + 0.15*(d*speed/NU)**0.687


def oseen(s, U, a, reach=np.inf, nu=NU):
    """Disturbance at s from a sphere with the slip U: OseenWake.C, in numpy."""
    distance = np.sqrt((s**2).sum(axis=0))
    speed = np.sqrt((U**2).sum(axis=0)) + 1e-30
    along = (U*s).sum(axis=0)/distance
    upstream = np.maximum(speed - along, 0)
    chi = 0.5/nu*np.maximum(distance, a)*upstream
    E = np.exp(-chi)
    sink = np.where(chi < 1e-3, 1 - chi*(0.5 - chi/6),
                    -np.expm1(-chi)/np.maximum(chi, 1e-3))
    q = np.minimum(a/distance, 1)
    dipole = 0.25*q**3
    radial = 2*dipole*along + 0.75*q*(upstream*sink - (speed + along)*E)
    transverse = dipole + 0.75*q*E
    w = (radial + transverse*along)/distance*s - transverse*U
    s = np.clip(2*(distance/reach)**2 - 1, 0, 1)
    return w*(1 - s**3*(10 - s*(15 - 6*s)))


@lru_cache(maxsize=None)
def orbit(d, tau, omega, u0):
    """Harmonics 1 to 19 of the velocity relative to the gas, if left alone."""
    parts = int(np.ceil(2*np.pi/omega/256/tau))
    n = 256*parts
    h = 2*np.pi/omega/n

    def rate(t, v):
        return omega*u0*np.sin(omega*t) - drag(d, abs(v))/tau*v

    v, samples = 0.0, np.empty(n)
    for k in range(12*n):
        samples[k % n] = v
        t = k*h
        k1 = rate(t, v)
        k2 = rate(t + 0.5*h, v + 0.5*h*k1)
        k3 = rate(t + 0.5*h, v + 0.5*h*k2)
        v += h/6*(k1 + 2*k2 + 2*k3 + rate(t + h, v + h*k3))
    return np.fft.rfft(samples)[1:20]/n


class Pairs:
    """Pairs of diameters d1, d2 in a sound, or in none: frequency zero.

    State: x2 - x1, v1 and v2 relative to the gas, components first.
    wake: none; Oseen, by slips against the undisturbed gas; or disturbed, by
    those against the gas with the wake of the other in it (the improved
    superposition of Wang, Ayala and Grabowski, J. Atmos. Sci. 62, 2005).
    """

    def __init__(self, d1, d2, frequency, u0, wake="Oseen", gravity=0.0,
                 density=2300, fine=1.0):
        self.d = np.array([d1, d2])
        self.omega, self.u0 = 2*np.pi*frequency, u0
        self.wake, self.g, self.fine = wake, gravity, fine
        self.tau = smoluchowski.relaxation_time(self.d, density)
        self.R = 0.5*(d1 + d2)
        self.nu = NU
        self.reach = self.ranges() if frequency else [np.inf, np.inf]

    def ranges(self, mean=MEAN):
        """The default ranges of wakes, see slipBound.H."""
        s = self.omega*self.tau
        U = self.u0*s/np.sqrt(1 + s**2) + self.tau*self.g
        tolerance = 0.25*self.omega*mean
        half = 0.5*U/self.omega
        return np.minimum(0.75*self.d*U/tolerance,
                          half + np.sqrt(half**2 + 3*NU/self.omega))

    def wakes(self, r, v):
        """At 1 of 2, at 2 of 1."""
        a = 0.5*self.d
        w = [0*r, 0*r]
        if self.wake == "none":
            return w
        for _ in range(1 if self.wake == "Oseen" else 8):
            slip = [-v[k] if self.wake == "Oseen" else w[k] - v[k]
                    for k in (0, 1)]
            w = [oseen(-r, slip[1], a[1], self.reach[1], self.nu),
                 oseen(r, slip[0], a[0], self.reach[0], self.nu)]
        return w

    def rate(self, t, y):
        r, v = y[:3], (y[3:6], y[6:9])
        w = self.wakes(r, v)
        out = np.empty_like(y)
        out[:3] = v[1] - v[0]
        for k in (0, 1):
            slip = w[k] - v[k]
            speed = np.sqrt((slip**2).sum(axis=0))
            out[3 + 3*k:6 + 3*k] = slip*drag(self.d[k], speed)/self.tau[k]
            out[3 + 3*k] += self.omega*self.u0*np.sin(self.omega*t)
            out[5 + 3*k] -= self.g
        return out

    def orbits(self, t):
        """Velocities relative to the gas, and places, far apart; along x."""
        harmonic = np.arange(1, 20)
        turn = np.exp(1j*self.omega*np.multiply.outer(harmonic, t))
        c = np.array([orbit(d, tau, self.omega, self.u0)
                      for d, tau in zip(self.d, self.tau)])
        return (2*np.real(np.tensordot(c, turn, 1)),
                2*np.real(np.tensordot(c/(1j*self.omega*harmonic), turn, 1)))

    def step(self, t, y, h):
        k1 = self.rate(t, y)
        k2 = self.rate(t + 0.5*h, y + 0.5*h*k1)
        k3 = self.rate(t + 0.5*h, y + 0.5*h*k2)
        k4 = self.rate(t + h, y + h*k3)
        return y + h/6*(k1 + 2*k2 + 2*k3 + k4)

    def captured(self, t, y, end, gone=None):
        """Times of contact, or NaN, of the pairs y that start at t."""
        n = y.shape[1]
        when = np.full(n, np.nan)
        index, t = np.arange(n), np.broadcast_to(t, n).astype(float)
        end = np.broadcast_to(end, n)
        longest = 0.7*self.tau.min()/self.fine
        if self.omega:
            longest = min(longest, 2*np.pi/self.omega/50/self.fine)
        while index.size:
            speed = np.sqrt(((y[6:] - y[3:6])**2).sum(axis=0)) + 1e-30
            distance = np.sqrt((y[:3]**2).sum(axis=0))
            h = np.minimum(longest, 0.15/self.fine*distance/speed)
            h = np.minimum(h, end[index] - t)
            new = self.step(t, y, h)
            way = new[:3] - y[:3]
            b = (y[:3]*way).sum(axis=0)
            c = (way**2).sum(axis=0) + 1e-60
            nearest = y[:3] + np.clip(-b/c, 0, 1)*way
            met = (nearest**2).sum(axis=0) < self.R**2
            # Where the chord enters the sphere
            root = np.sqrt(np.maximum(b**2 - c*(distance**2 - self.R**2), 0))
            when[index[met]] = (t + h*np.clip((-b - root)/c, 0, 1))[met]
            t, y = t + h, new
            on = ~met & (t < end[index]*(1 - 1e-12))
            if gone is not None:
                on &= ~gone(y)
            index, t, y = index[on], t[on], y[:, on]
        return when


def stratified(random, *cells):
    """One point in each cell of a unit square or cube, at random."""
    grid = np.meshgrid(*(np.arange(n) for n in cells), indexing="ij")
    return [(g.ravel() + random.random(g.size))/n for g, n in zip(grid, cells)]


def stroke(pairs, cells=(48, 32), wide=1.5, long=2.0, seed=1):
    """Volume that is captured in a stroke, and the one that is swept."""
    T = 2*np.pi/pairs.omega
    t = np.linspace(0, T, 4001)
    relative = np.diff(pairs.orbits(t)[0], axis=0)[0]
    k = np.nonzero((relative[:-1] < 0) & (relative[1:] >= 0))[0][0]
    start = t[k] - relative[k]*(t[1] - t[0])/(relative[k + 1] - relative[k])
    v, x = pairs.orbits(start + np.array([0, 0.5*T]))
    swing = np.diff(np.diff(x, axis=0)[0])[0]
    R = pairs.R
    x, b = stratified(np.random.default_rng(seed), *cells)
    length = swing + 2*long*R
    x, b = long*R - length*x, wide*R*np.sqrt(b)
    apart = x**2 + b**2 > R**2
    x, b = x[apart], b[apart]
    y = np.zeros((9, x.size))
    y[0], y[1], y[3], y[6] = x, b, v[0, 0], v[1, 0]
    met = np.isfinite(pairs.captured(start, y, start + 0.5*T))
    cell = np.pi*(wide*R)**2*length/np.prod(cells)
    return met.sum()*cell, np.pi*R**2*swing


def fall(pairs, cells=200, far=50, wide=1.2):
    """Share of the cross-section pi R^2 that meets; the first one is larger."""
    w = pairs.tau*pairs.g
    edges = np.linspace(0, wide*pairs.R, cells + 1)
    y = np.zeros((9, cells))
    y[0] = 0.5*(edges[1:] + edges[:-1])
    y[2] = -far*pairs.R
    y[5], y[8] = -w[0], -w[1]
    end = 3*far*pairs.R/(w[0] - w[1])
    met = np.isfinite(pairs.captured(
        0, y, end, lambda y: y[2] > 5*pairs.R
    ))
    return np.diff(edges**2)[met].sum()/pairs.R**2


def sheet(pairs, cells, depth, x, y, seed=1):
    """Area that meets of the plane through which the small ones rise, and 4AR + pi R^2.

    They start at random phases from random mean places, depth below the larger
    one, beside it by x[0] to x[1] and by less than y, and as much on the other
    sides. Also where from those came that met.
    """
    T = 2*np.pi/pairs.omega
    w = pairs.tau*pairs.g
    p, q, below, phase = stratified(np.random.default_rng(seed), *cells, 1, 1)
    t = T*phase
    v, place = pairs.orbits(t)
    swing = 0.5*np.ptp(np.diff(pairs.orbits(np.linspace(0, T, 401))[1], axis=0))
    p, q = x[0] + (x[1] - x[0])*p, y*q
    state = np.zeros((9, t.size))
    state[0] = p + place[1] - place[0]
    state[1] = q
    state[2] = -depth - (w[0] - w[1])*T*below
    state[3], state[6] = v
    state[5], state[8] = -w[0], -w[1]
    met = np.isfinite(pairs.captured(
        t, state, 4*depth/(w[0] - w[1]), lambda y: y[2] > depth
    ))
    return (met.mean()*4*(x[1] - x[0])*y, 4*swing*pairs.R + np.pi*pairs.R**2,
            np.array([p[met], q[met]]))


def shares(sizes, frequency, u0, wake="Oseen", **options):
    """Of the stroke; on the diagonal that of the size and 1.1 times less."""
    n = len(sizes)
    E = np.empty((n, n))
    for i in range(n):
        for j in range(i + 1):
            other = sizes[j] if j < i else sizes[i]/1.1
            captured, swept = stroke(
                Pairs(sizes[i], other, frequency, u0, wake), **options
            )
            E[i, j] = E[j, i] = captured/swept
    return E


def interpolated(sizes, E):
    """Linear in the logarithms of both; beyond the table the last holds."""
    x, n = np.log(sizes), len(sizes)

    def place(d):
        y = np.clip(np.log(d), x[0], x[-1])
        i = np.clip(np.searchsorted(x, y) - 1, 0, n - 2)
        return i, (y - x[i])/(x[i + 1] - x[i])

    def factor(d1, d2):
        (i, s), (j, t) = place(d1), place(d2)
        return ((1 - s)*((1 - t)*E[i, j] + t*E[i, j + 1])
                + s*((1 - t)*E[i + 1, j] + t*E[i + 1, j + 1]))

    return factor


# Total efficiencies of the DEM without wakes and with Oseen's, from
# doc/validation.md, in per cent, with their errors: of boxes 18 mm high (five
# and three seeds), and of turbulence of 10 m2/s3, five seeds
DEM = {"settling": ((17.7, 0.6), (14.0, 0.9)),
       "turbulence": ((72.9, 1.7), (48.6, 1.9))}

SIZES = 1e-6*np.array([0.3, 0.5, 1, 1.5, 2, 3, 5, 8, 12])
SHOWN = 1e-6*np.array([0.5, 1, 1.5, 2, 3, 5, 8])


def print_shares(E, sizes):
    print("   d [um]" + "".join(f"{1e6*d:8g}" for d in SHOWN))
    at = np.searchsorted(sizes, SHOWN*(1 - 1e-9))
    for row, i in enumerate(at):
        print(f"{1e6*SHOWN[row]:9g}" + "".join(
            f"{E[i, j]:8.3f}" for j in at[:row]
        ))


def print_falls():
    print("\nSettling without sound, d1, d2 [um], density: wake of the solver,"
          " by slips in the disturbed gas")
    for d1, d2, density in ((5, 2, 2300), (8, 5, 2300), (20, 10, 1000)):
        E = [fall(Pairs(1e-6*d1, 1e-6*d2, 0, 0, wake, 9.81, density))
             for wake in ("Oseen", "disturbed")]
        print(f"{d1:6g}{d2:6g}{density:8g}{E[0]:8.3f}{E[1]:8.3f}")


def study(case, balance):
    """Prints the tables; returns the figure.

    balance(kernel): total and PM2.5 efficiency in per cent of the case.
    """
    frequency = case["frequency"]
    u0 = smoluchowski.velocity_amplitude(case["SPL"])
    print("Share of the swept path that is captured in a stroke, wake of Oseen")
    E = shares(SIZES, frequency, u0)
    print_shares(E, SIZES)

    print("\nThe same for some d1, d2 [um]: none, solver, by slips in the"
          " disturbed gas")
    few = [(1.5, 0.5), (3, 1.5), (5, 1), (5, 2), (8, 3)]
    for d1, d2 in few:
        print(f"{d1:6g}{d2:6g}", *(
            f"{np.divide(*stroke(Pairs(1e-6*d1, 1e-6*d2, frequency, u0, wake))):7.3f}"
            for wake in ("none", "Oseen", "disturbed")
        ))
    print_falls()

    # All come from there: sheet(pair, (80, 20), 185e-6, (0, 500e-6), 40e-6)
    pair = Pairs(5e-6, 2e-6, frequency, u0, "Oseen", GRAVITY, fine=0.4)
    area, whole, found = sheet(pair, (24, 16), 185e-6, (240e-6, 300e-6), 16e-6)
    n = found.shape[1]
    print("\nSwinging and settling, 5 and 2 um: share of the area 4AR + pi R^2"
          f" {area/whole:.2f} +- {area/whole/np.sqrt(n):.2f}; they come from"
          f" x = {1e6*found[0].min():.0f} to {1e6*found[0].max():.0f} um,"
          f" y up to {1e6*found[1].max():.0f} um")

    factor = interpolated(SIZES, E)
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.8))
    for k, d in enumerate((2e-6, 3e-6, 5e-6, 8e-6)):
        i = np.searchsorted(SIZES, d*(1 - 1e-9))
        left.plot(1e6*SIZES[:i], E[i, :i], "o-", ms=4, color=f"C{k}",
                  label=f"{1e6*d:g} um")
    left.set_xscale("log")
    left.set_xticks([0.3, 0.5, 1, 2, 5], labels=["0.3", "0.5", "1", "2", "5"])
    left.set_xticks([], minor=True)
    left.set_ylim(0, 1)
    left.set_xlabel("diameter of the smaller one [um]")
    left.set_ylabel("share of the swept path that is captured")
    left.legend(frameon=False, fontsize=8, title="larger one")
    left.grid(alpha=0.3)

    print("\nPopulation balance, total and PM2.5 [%]: without wakes, with the"
          " share of the stroke")
    for color, name, kernel in (
        ("0.4", "settling", smoluchowski.settling_sheet(frequency, u0)),
        ("C0", "turbulence", smoluchowski.orthokinetic(frequency, u0)),
    ):
        refill = np.array([0, 0.05, 0.2, 0.4, 0.6, 0.8, 1])
        both = np.array([[
            balance(lambda a, b, s=s: s*kernel(a, b)),
            balance(lambda a, b, s=s: s*kernel(a, b)*factor(a, b)),
        ] for s in refill])
        none, wakes = both[:, :, 0].T
        label = {"settling": "settling alone", "turbulence": "full refill"}[name]
        print(f"{label:16}{both[-1, 0, 0]:7.1f} ({both[-1, 0, 1]:.1f})"
              f"{both[-1, 1, 0]:7.1f} ({both[-1, 1, 1]:.1f})")
        (x, dx), (y, dy) = DEM[name]
        expected = [np.interp(x + s*dx, none, wakes) for s in (-1, 0, 1)]
        print(f"   weakened to the {x} +- {dx} of the DEM without wakes, by"
              f" {np.interp(x, none, refill):.2f}: {expected[1]:.1f}"
              f" ({expected[0]:.1f} to {expected[2]:.1f}), PM2.5"
              f" {np.interp(x, none, both[:, 1, 1]):.1f}; DEM {y} +- {dy}")
        right.plot(none, wakes, color=color, label=f"balance, {label}, times"
                   " 0 to 1")
        right.errorbar(x, y, dy, dx, "s", color=color, capsize=2, ms=5,
                       label=f"DEM, {name}")
    right.plot([0, 90], [0, 90], "k:", lw=1)
    right.set_xlabel("efficiency without wakes [%]")
    right.set_ylabel("with the wake of Oseen [%]")
    right.legend(frameon=False, fontsize=8)
    right.grid(alpha=0.3)
    return figure
