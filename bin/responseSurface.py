"""Finds where a noisy result is largest, with few evaluations.

First a sweep of the whole range. Then, around the best point, again and again: a
few points more, a quadratic through what is near, its top. What counts as near is
the widest window in which a quadratic is not refuted by the noise, so that all
points that can tell something about the top do. The window of new points is
halved until the top is known to the tolerance, or until the noise hides what a
smaller window could show.

Coordinates are those of the unit cube. Each evaluation has a value per seed, with
the same seeds everywhere: what a seed adds to all points does not move the top,
and is taken from the noise (two-way analysis of variance).
"""

import itertools
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize
from scipy.special import chdtri

SWEEP = {1: 7, 2: 4}  # points per coordinate
DRAWS = 400


def terms(z):
    """1, z, and all products of two, for rows of z."""
    z = np.atleast_2d(z)
    d = z.shape[1]
    products = [z[:, i]*z[:, j] for i in range(d) for j in range(i, d)]
    return np.column_stack([np.ones(len(z)), z, *products])


def grid(low, high):
    """Points that fill a box, enough to tell where a quadratic is largest."""
    d = len(low)
    n = {1: 401, 2: 41, 3: 15}.get(d, 7)
    return np.array(list(itertools.product(
        *(np.linspace(a, b, n) for a, b in zip(low, high)))))


@dataclass
class Optimum:
    """The top: place and value, each with its standard error."""

    place: np.ndarray
    place_error: np.ndarray
    value: float
    error: float
    border: list  # of each coordinate: -1, 0, 1
    coefficients: np.ndarray
    low: np.ndarray  # the window of the fit
    high: np.ndarray
    points: int
    reason: str

    def fit(self, z):
        return terms((np.atleast_2d(z) - self.middle())/self.scale()) \
            @ self.coefficients

    def middle(self):
        return 0.5*(self.low + self.high)

    def scale(self):
        return 0.5*(self.high - self.low)


class Search:
    """maximise(evaluate): evaluate(rows of z) gives rows of values per seed, with
    NaN where there is none."""

    def __init__(self, evaluate, dimensions, tolerance=0.02, most=60):
        self.evaluate, self.d = evaluate, dimensions
        self.tolerance, self.most = tolerance, most
        self.z = np.empty((0, dimensions))
        self.y = None

    def add(self, wanted, apart):
        """Evaluates the points that are not yet there, nor near to one."""
        new = []
        for z in np.clip(wanted, 0, 1).round(6):
            others = np.vstack([self.z, *new]) if new else self.z
            if not len(others) or np.abs(others - z).max(axis=1).min() > apart:
                new.append(z)
        new = new[:max(0, self.most - len(self.z))]
        if not new:
            return 0
        values = np.array(self.evaluate(np.array(new)), float)
        self.z = np.vstack([self.z, new])
        self.y = values if self.y is None else np.vstack([self.y, values])
        return len(new)

    def known(self):
        """Points of which all seeds have a value."""
        whole = np.isfinite(self.y).all(axis=1)
        return self.z[whole], self.y[whole]

    def noise(self, y):
        """Standard errors: of a point beside the others, and of all together."""
        n, seeds = y.shape
        if seeds < 2:
            return 0.0, 0.0
        of_seed = y.mean(axis=0) - y.mean()
        rest = y - y.mean(axis=1, keepdims=True) - of_seed
        own = (rest**2).sum()/((n - 1)*(seeds - 1)) if n > 1 else 0
        common = max(of_seed.var(ddof=1) - own/n, 0)
        return np.sqrt(own/seeds), np.sqrt(common/seeds)

    def design(self, centre, half):
        if self.d == 1:
            steps = [[-1], [-0.5], [0], [0.5], [1]]
        elif self.d == 2:
            steps = list(itertools.product((-1, 0, 1), repeat=2))
        else:
            steps = [*itertools.product((-1, 1), repeat=self.d),
                     *np.eye(self.d), *-np.eye(self.d), np.zeros(self.d)]
        return centre + half*np.array(steps)

    def fit(self, centre, half):
        """A quadratic in the widest window that the noise allows."""
        z, y = self.known()
        mean = y.mean(axis=1)
        own, common = self.noise(y)
        fitted, narrower = None, None
        for wide in (1, 1.5, 2, 3, 4, 6, 8):
            low = np.clip(centre - wide*half*1.001, 0, 1)
            high = np.clip(centre + wide*half*1.001, 0, 1)
            near = ((z >= low) & (z <= high)).all(axis=1)
            scale, middle = 0.5*(high - low), 0.5*(high + low)
            A = terms((z[near] - middle)/scale)
            free = near.sum() - A.shape[1]
            if free < 1 or np.linalg.matrix_rank(A) < A.shape[1]:
                continue
            b = np.linalg.lstsq(A, mean[near], rcond=None)[0]
            misfit = np.sqrt(((A@b - mean[near])**2).sum()/free)
            # Without noise: what does not matter for the top
            allowed = max(own*np.sqrt(chdtri(free, 0.05)/free),
                          0.02*np.ptp(mean[near]))
            good = misfit <= allowed
            if fitted and not good:
                break
            error = max(own, misfit, 1e-300)
            covariance = error**2*np.linalg.inv(A.T@A)
            narrower = fitted
            fitted = (b, covariance, low, high, error, common, good)
            if not good or low.max() <= 0 and high.min() >= 1:
                break
        return fitted, narrower

    def largest(self, fitted):
        """Where the fit is largest in its window."""
        b, _, low, high, *_ = fitted
        middle, scale = 0.5*(low + high), 0.5*(high - low)
        points = grid(low, high)
        best = points[(terms((points - middle)/scale)@b).argmax()]
        return minimize(
            lambda z: -(terms((z - middle)/scale)@b)[0], best,
            bounds=list(zip(low, high)), method="L-BFGS-B").x

    def top(self, fitted, narrower):
        """The largest value of the fit in its window, with its errors."""
        b, covariance, low, high, _, common, _ = fitted
        middle, scale = 0.5*(low + high), 0.5*(high - low)
        points = grid(low, high)
        T = terms((points - middle)/scale)
        place = self.largest(fitted)
        random = np.random.default_rng(1)
        # A covariance of zero is none that a factorisation takes
        width, axes = np.linalg.eigh(covariance)
        draws = b + (random.normal(size=(DRAWS, len(b)))
                     * np.sqrt(np.clip(width, 0, None)))@axes.T
        spread = points[(T@draws.T).argmax(axis=0)] - place
        # With what the grid cannot resolve
        cell = scale*2/(round(len(points)**(1/self.d)) - 1)
        spread = (spread**2).mean(axis=0) + cell**2/12
        if narrower:
            # What is no quadratic has another top in another window
            spread += (self.largest(narrower) - place)**2/4
        spread = np.sqrt(spread)
        at = terms((place - middle)/scale)[0]
        value = at@b
        error = np.sqrt(at@covariance@at + common**2)
        border = [-1 if x <= 1e-6 else 1 if x >= 1 - 1e-6 else 0 for x in place]
        return Optimum(place, spread, value, error, border, b, low, high,
                       len(self.z), "")

    def maximise(self):
        n = SWEEP.get(self.d)
        if n:
            start = np.array(list(itertools.product(
                np.linspace(0, 1, n), repeat=self.d)))
            half = 1/(n - 1)
        else:
            start, half = self.design(np.full(self.d, 0.5), 0.5), 0.5
        self.add(start, 1e-6)
        z, y = self.known()
        if len(z) < 3:
            raise ValueError("too few points have a result")
        centre = z[y.mean(axis=1).argmax()]

        while True:
            new = self.add(self.design(centre, half), 0.2*half)
            fitted, narrower = self.fit(centre, half)
            if fitted is None:
                raise ValueError("too few points have a result for a fit")
            best = self.top(fitted, narrower)
            if len(self.z) >= self.most:
                best.reason = "as many points as allowed"
                return best
            moved = np.abs(best.place - centre).max()
            good = fitted[-1]
            if good and (best.place_error < self.tolerance).all() \
                    and moved <= 1.001*half:
                best.reason = "known to the tolerance"
                return best
            # What the window could show must stand out of the noise
            near = fitted[4]
            points = np.clip(self.design(best.place, half), 0, 1)
            drop = best.value - best.fit(points).min()
            if half < 0.25*self.tolerance:
                best.reason = "no smaller window"
                return best
            if not new or moved <= 0.5*half \
                    or (np.abs(best.place - 0.5) >= 0.5).any():
                if good and drop < 4*near and half < 0.2:
                    best.reason = "the noise hides more"
                    return best
                half *= 0.5
            centre = best.place
