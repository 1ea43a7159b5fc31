"""What the kernel's smoothing alone does to the modes of the filled shell (Eq. A.2): a radial model without particles.

  python3 inputs/studies/shell_dispersion.py [--speed 50] [--particles 930 2000 4000] [--ratio 3.0]

The liquid's energy is that of the sums in the limit of many neighbours: with f = -div u the relative density is
(S f)(r) = integral W f / integral W over the ball, its mean restored by the exact volume,
  T f = S f + mean(f - S f),   E = (rho c^2/2) integral (T f)^2 + (4 E t/2 R^2) u(R)^2 4 pi R^2,
the mass that of liquid and wall. Rayleigh-Ritz with the lowest modes of the same grid without smoothing, as many as the particles
resolve. Prints the deviation of the first modes from the roots of A.2, per cent. Numbers of the shell of inputs/shell_oscillation.prm.
"""
import argparse

import numpy as np

R, RHO, ET, SHELL = 30e-6, 1000.0, 300.0, 1300.0 * 1e-6  # m, kg/m^3, 3 G t0 in N/m, wall mass per area in kg/m^2
CELLS = 140


def roots(c, count):
    def f(q):
        j0, j1 = np.sin(q) / q, np.sin(q) / q**2 - np.cos(q) / q
        return j0 + j1 * (4 * ET / (q * RHO * c * c * R) - q * SHELL / (RHO * R))

    found, q = [], 0.02
    while len(found) < count:
        if f(q) * f(q + 0.01) < 0:
            a, b = q, q + 0.01
            for _ in range(50):
                m = 0.5 * (a + b)
                a, b = (a, m) if f(a) * f(m) <= 0 else (m, b)
            found.append(a)
        q += 0.01
    return np.array(found)


def kernel(fourth_order):
    """W over its integral, support 1, in 3D (sph_kernels.inc.h)."""
    peak = 21 / (2 * np.pi)
    if fourth_order:
        return lambda u: 50 / 17 * peak * (1 - 3.3 * u * u) * (1 - u) ** 4 * (1 + 4 * u)
    return lambda u: peak * (1 - u) ** 4 * (1 + 4 * u)


def smoothing(weight, support):
    """S of functions of the radius (over R), cell by cell."""
    h, parts = 1 / CELLS, 6
    r = (np.arange(CELLS) + 0.5) * h
    table = np.linspace(0, 1, 4001)
    y = weight(table) * table
    inner = np.concatenate([[0], np.cumsum(0.5 * (y[1:] + y[:-1])) * (table[1] - table[0])])
    shell = lambda t: np.interp(np.minimum(t / support, 1), table, inner) * 2 * np.pi / support  # noqa: E731
    out = np.zeros((CELLS, CELLS))
    for k in range(parts):
        other = (np.arange(CELLS) + (k + 0.5) / parts) * h
        out += other[None, :] / r[:, None] * (shell(r[:, None] + other[None, :]) - shell(abs(r[:, None] - other[None, :])))
    return out / out.sum(1)[:, None]


def modes(fourth_order, support, c):
    """omega R/c of the smoothed shell; support over R."""
    S, h, n = smoothing(kernel(fourth_order), support), 1 / CELLS, CELLS
    edge = np.arange(n + 1) * h
    volume = (edge[1:] ** 3 - edge[:-1] ** 3) / 3
    f = np.zeros((n, n))  # of u at the cells' outer edges
    for i in range(n):
        f[i, i] = -edge[i + 1] ** 2 / volume[i]
        if i:
            f[i, i - 1] = edge[i] ** 2 / volume[i]
    mean = np.outer(np.ones(n), volume) / volume.sum()
    T = S + mean @ (np.eye(n) - S)
    mass = RHO * R**3 * (np.minimum(edge[1:] + h / 2, 1) ** 3 - (edge[1:] - h / 2) ** 3) / 3
    mass[-1] += SHELL * R**2

    def stiffness(t):
        K = RHO * c * c * R * (f.T @ t.T @ np.diag(volume) @ t @ f)
        K[-1, -1] += 4 * ET
        return 0.5 * (K + K.T)

    d = 1 / np.sqrt(mass)
    basis = d[:, None] * np.linalg.eigh(stiffness(np.eye(n)) * d[:, None] * d[None, :])[1][:, : max(4, min(10, int(2 / support)))]
    squares = np.linalg.eigvalsh(basis.T @ stiffness(T) @ basis)
    q = np.sqrt(np.maximum(squares, 0)) * R / c
    return q[q > 0.5]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--speed", type=float, default=50.0, help="m/s")
    parser.add_argument("--particles", type=int, nargs="+", default=[930, 2000, 4000])
    parser.add_argument("--ratio", type=float, nargs="+", default=[3.0], help="support over particle spacing")
    options = parser.parse_args()
    exact = roots(options.speed, 2)
    print("kernel,particles,support_ratio,mode_1 [%],mode_2 [%]")
    for fourth_order in (False, True):
        for particles in options.particles:
            for ratio in options.ratio:
                q = modes(fourth_order, ratio * (4 * np.pi / 3 / particles) ** (1 / 3), options.speed)
                shift = 100 * (q[:2] / exact - 1)
                print(f"{'fourth_order' if fourth_order else 'wendland'},{particles},{ratio},{shift[0]:.2f},{shift[1]:.2f}")


if __name__ == "__main__":
    main()
