"""Impulsive period of a box by IS 1893-2 beside the modes of its walls as plates, with numpy and scipy alone.

    python3 benches/peers/box_frame.py

The wall across the motion is a plate of bicubic elements (Bogner, Fox and Schmit 1966), clamped at the base and free at the top, half of it by
symmetry. `clamped` holds its vertical edge; `frame` joins it to the wall along the motion, which turns with it by the same angle and, since both
walls across move the same way, has its deflection zero in the middle. Mass: the walls' own, and on the wall across the impulsive pressure of a
rigid wall, 0.866 (1 - (z/H)^2) tanh(0.866 r) rho H. The mode is that with the largest effective mass of the wall across.

Columns: elements, periods by the formula, of the clamped wall and of the frame, their ratios. docs/theory/two-masses.md has them, and so has page
`two-masses` of the verification manual.
"""

from math import pi, sqrt, tanh

import numpy as np
from scipy.linalg import eigh

BOXES = [(6, 3, 3), (6, 6, 3), (6, 12, 3), (12, 3, 3), (12, 6, 3), (12, 12, 3), (18, 9, 4), (9, 9, 6), (6, 6, 6), (20, 20, 5)]
THICKNESS, MODULUS, POISSON, WALL, WATER, G = 0.4, 25e9, 0.2, 2400.0, 1000.0, 9.81
POINTS, WEIGHTS = np.polynomial.legendre.leggauss(4)
POINTS, WEIGHTS = (POINTS + 1) / 2, WEIGHTS / 2


def hermite(t, h):
    """Cubic functions of deflection and slope at both ends, with two derivatives."""
    value = np.array([1 - 3 * t**2 + 2 * t**3, h * (t - 2 * t**2 + t**3), 3 * t**2 - 2 * t**3, h * (t**3 - t**2)])
    first = np.array([6 * t**2 - 6 * t, h * (1 - 4 * t + 3 * t**2), 6 * t - 6 * t**2, h * (3 * t**2 - 2 * t)]) / h
    second = np.array([12 * t - 6, h * (6 * t - 4), 6 - 12 * t, h * (6 * t - 2)]) / h**2
    return value, first, second


class Plate:
    """Stiffness, mass and load of a wall from its middle (x = 0) to the corner."""

    def __init__(self, half, height, mass, load, n):
        self.n = n
        size = 4 * (n + 1) ** 2
        self.k, self.m, self.f = np.zeros((size, size)), np.zeros((size, size)), np.zeros(size)
        rigidity = MODULUS * THICKNESS**3 / 12 / (1 - POISSON**2)
        hx, self.hz = half / n, height / n
        for i in range(n):
            for j in range(n):
                own = [self.at(i + a, j + b, u, v) for a in (0, 1) for u in (0, 1) for b in (0, 1) for v in (0, 1)]
                grid = np.ix_(own, own)
                for x, wx in zip(POINTS, WEIGHTS):
                    fx = hermite(x, hx)
                    for z, wz in zip(POINTS, WEIGHTS):
                        fz, at = hermite(z, self.hz), (j + z) * self.hz
                        w, xx, zz, xz = (np.outer(fx[a], fz[b]).ravel() for a, b in ((0, 0), (2, 0), (0, 2), (1, 1)))
                        weight = wx * wz * hx * self.hz
                        bending = np.outer(xx, xx) + np.outer(zz, zz) + POISSON * (np.outer(xx, zz) + np.outer(zz, xx))
                        self.k[grid] += weight * rigidity * (bending + 2 * (1 - POISSON) * np.outer(xz, xz))
                        self.m[grid] += weight * mass(at) * np.outer(w, w)
                        self.f[own] += weight * load(at) * w

    def at(self, i, j, slope_x, slope_z):
        return 4 * (i * (self.n + 1) + j) + 2 * slope_x + slope_z

    def edge(self, i, slope_x):
        return {self.at(i, j, slope_x, v) for j in range(self.n + 1) for v in (0, 1)}

    def base(self):
        return {self.at(i, 0, u, v) for i in range(self.n + 1) for u in (0, 1) for v in (0, 1)}


def mode(k, m, one, free):
    """Period of the mode with the largest effective mass."""
    grid = np.ix_(free, free)
    squares, shapes = eigh(k[grid], m[grid], subset_by_index=[0, 11])
    masses = (shapes.T @ (m @ one)[free]) ** 2
    return 2 * pi / sqrt(squares[int(np.argmax(masses))])


def periods(length, breadth, depth, n):
    """Formula, mode of the clamped wall, mode of the frame [s]."""
    height, r = depth + 0.5, length / depth
    liquid = WATER * length * breadth * depth * tanh(0.866 * r) / (0.866 * r)
    arm = (0.5 - 0.09375 * r if r < 1.333 else 0.375) * depth
    wall = WALL * THICKNESS * height * breadth
    load = (liquid / 2 + wall) * G / (breadth * depth)
    place = (arm * liquid / 2 + wall * depth / 2) / (liquid / 2 + wall)
    water = lambda z: 0.866 * (1 - (z / depth) ** 2) * tanh(0.866 * r) * WATER * depth if z < depth else 0.0
    across = Plate(breadth / 2, height, lambda z: WALL * THICKNESS + water(z), lambda z: load if z < depth else 0.0, n)
    along = Plate(length / 2, height, lambda z: WALL * THICKNESS, lambda z: 0.0, n)
    size = len(across.f)
    held = across.base() | across.edge(0, 1) | across.edge(n, 0)
    one = np.zeros(size)
    one[[across.at(i, j, 0, 0) for i in range(n + 1) for j in range(n + 1)]] = 1.0
    free = sorted(set(range(size)) - held - across.edge(n, 1))
    deflection = np.zeros(size)
    deflection[free] = np.linalg.solve(across.k[np.ix_(free, free)], across.f[free])
    row = min(int(place / across.hz), n - 1)
    shape = hermite(place / across.hz - row, across.hz)[0]
    nodes = [across.at(0, row + b, 0, v) for b in (0, 1) for v in (0, 1)]
    formula = 2 * pi * sqrt(shape @ deflection[nodes] / G)
    clamped = mode(across.k, across.m, one, free)
    zero = np.zeros((size, size))
    k, m = np.block([[across.k, zero], [zero, along.k]]), np.block([[across.m, zero], [zero, along.m]])
    turn, gone = np.eye(2 * size), set(held)
    gone |= {size + i for i in along.base() | along.edge(0, 0) | along.edge(n, 0)}
    for j in range(n + 1):
        for v in (0, 1):
            follower = size + along.at(n, j, 1, v)
            turn[follower] = 0.0
            turn[follower, across.at(n, j, 1, v)] = -1.0
            gone.add(follower)
    free = sorted(set(range(2 * size)) - gone)
    frame = mode(turn.T @ k @ turn, turn.T @ m @ turn, np.concatenate([one, np.zeros(size)]), free)
    return formula, clamped, frame


if __name__ == "__main__":
    for box in BOXES:
        # Elements end at the surface, where the load ends.
        for n in (int(2 * box[2] + 1), 14):
            formula, clamped, frame = periods(*box, n)
            print(f"{box} {n:3d}  T {formula:.5f}  clamped {clamped:.5f}  frame {frame:.5f} s  {formula / clamped:.3f}  {clamped / frame:.3f}")
