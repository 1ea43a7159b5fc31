"""Iterations of conjugate gradients on the Morris friction of benchmark_stokes (12 096 particles, 18 of 21 layers free) by preconditioner, to 1e-6 of the forces.

  python3 benchmarks/stokes_preconditioners.py        prints a table, half a minute of CPU time

Own numpy code in double precision; particles are drawn and evened out anew, so that the diagonal takes 49 where the program takes 53.
"""
import numpy as np

LENGTHS, SUPPORT = np.array([24, 24, 21]), 2.44
N = int(LENGTHS.prod())
PLACES = np.stack([np.arange(N) % 24, np.arange(N) // 24 % 24, np.arange(N) // 576], axis=1)
FREE = PLACES[:, 2] >= 3


def pairs(x):
    """i, j, r and weight of all neighbours."""
    def number(cell):
        return cell[:, 0] + 24 * (cell[:, 1] + 24 * cell[:, 2])
    cell = np.floor(x % LENGTHS).astype(int)
    order = np.argsort(number(cell), kind="stable")
    start = np.searchsorted(number(cell)[order], np.arange(N + 1))
    found = []
    for step in np.ndindex(7, 7, 7):
        other = number((cell + np.array(step) - 3) % LENGTHS)
        for k in range(np.diff(start).max()):
            i = np.nonzero(start[other] + k < start[other + 1])[0]
            j = order[start[other[i]] + k]
            r = x[j] - x[i]
            r -= LENGTHS * np.round(r / LENGTHS)
            near = (i != j) & ((r * r).sum(axis=1) < SUPPORT**2)
            found.append((i[near], j[near], r[near]))
    i, j, r = (np.concatenate(part) for part in zip(*found))
    return i, j, r, 210 / (np.pi * SUPPORT**5) * (1 - np.sqrt((r * r).sum(axis=1)) / SUPPORT) ** 3


class Friction:
    def __init__(self, i, j, w):
        self.i, self.j, self.w = i, j, 2 * w
        self.diagonal = np.bincount(i, self.w, N) + np.where(FREE, 0, 1e6)

    def times(self, v):
        return np.stack([self.diagonal * one - np.bincount(self.i, self.w * one[self.j], N) for one in v.T], axis=1)


def chebyshev(A, products, most):
    """A polynomial in D^-1 A with that many products, for eigenvalues from 0.1 to `most`."""
    middle, half = (most + 0.1) / 2, (most - 0.1) / 2
    sigma, D = middle / half, A.diagonal[:, None]

    def apply(r):
        rho, step = 1 / sigma, r / D / middle
        z = step.copy()
        for _ in range(products):
            after = 1 / (2 * sigma - rho)
            step = after * rho * step + 2 * after / half * (r - A.times(z)) / D
            z, rho = z + step, after
        return z
    return apply


def two_levels(A, size):
    """Diagonal, and an even motion of every block of `size` places."""
    blocks = -(-LENGTHS // size)
    at = PLACES // size
    block = at[:, 0] + blocks[0] * (at[:, 1] + blocks[1] * at[:, 2])
    coarse = np.zeros((blocks.prod(), blocks.prod()))
    free = FREE[A.i] & FREE[A.j]
    np.add.at(coarse, (block[A.i[free]], block[A.j[free]]), -A.w[free])
    np.add.at(coarse, (block[FREE], block[FREE]), A.diagonal[FREE])
    used = np.diag(coarse) > 0
    inverse = np.zeros_like(coarse)
    inverse[np.ix_(used, used)] = np.linalg.inv(coarse[np.ix_(used, used)])

    def apply(r):
        z = r / A.diagonal[:, None]
        for d in range(3):
            z[FREE, d] += (inverse @ np.bincount(block[FREE], r[FREE, d], blocks.prod()))[block[FREE]]
        return z
    return apply


def iterations(A, precondition):
    r = np.random.default_rng(2).random((N, 3)) - 0.5 + [1, 0, 0]
    z = precondition(r)
    p, rz, least, count = z, (r * z).sum(), 1e-12 * (r * r).sum(), 0
    while (r * r).sum() > least:
        q = A.times(p)
        r = r - rz / (p * q).sum() * q
        z = precondition(r)
        p, rz, count = z + (r * z).sum() / rz * p, (r * z).sum(), count + 1
    return count


def main():
    x = PLACES + 0.25 + 0.5 * np.random.default_rng(1).random((N, 3))
    for _ in range(5):
        i, _, r, w = pairs(x)
        x = x - 0.15 * np.stack([np.bincount(i, w * one, N) for one in r.T], axis=1)
    i, j, _, w = pairs(x)
    A = Friction(i, j, w)
    v = np.random.default_rng(3).random((N, 1))
    for _ in range(40):
        v = A.times(v) / A.diagonal[:, None]
        largest = abs(v).max()
        v /= largest
    print("preconditioner: iterations, products")
    count = iterations(A, lambda r: r / A.diagonal[:, None])
    print(f"diagonal: {count}, {count}")
    for more in (1, 2, 3):
        count = iterations(A, chebyshev(A, more, 1.02 * largest))
        print(f"Chebyshev, {more} products more: {count}, {(more + 1) * count}")
    for size in ((6, 6, 7), (4, 4, 3), (3, 3, 3)):
        count = iterations(A, two_levels(A, np.array(size)))
        print(f"blocks of {' x '.join(str(one) for one in size)} move too: {count}, {count}")


if __name__ == "__main__":
    main()
