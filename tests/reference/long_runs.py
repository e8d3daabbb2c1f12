"""Writes long_runs.json: attitudes of the free body of `asymmetric_free` after 2^-6 ... 2^24 s, from four starts.

In closed form, in 60-digit arithmetic: the body turns by Jacobi's elliptic functions (Landau & Lifshitz, par. 37), and the angle by
which it precesses about its angular momentum is a quadrature over half a period and what is left. The ends of `asymmetric_free` and
`vanzon_schofield` in trajectories.json, known by another route, are met to 38 digits.
pip install mpmath gmpy2; python3 long_runs.py > long_runs.json
"""

import json
from pathlib import Path

from mpmath import atan2, cos, ellipf, ellipfun, ellipk, floor, mp, mpf, quad, sin, sqrt

mp.dps = 60


def product(p, q):
    """Of quaternions, scalar first."""
    a, b, c, d = p
    e, f, g, h = q
    return [
        a * e - b * f - c * g - d * h,
        a * f + b * e + c * h - d * g,
        a * g - b * h + c * e + d * f,
        a * h + b * g - c * f + d * e,
    ]


def inverse(q):
    return [q[0], -q[1], -q[2], -q[3]]


def upright(m):
    """The shortest rotation that takes a vector to e3."""
    size = sqrt(sum(x * x for x in m))
    x, y, z = (component / size for component in m)
    scale = 1 / sqrt(2 * (1 + z))
    return [(1 + z) * scale, y * scale, -x * scale, mpf(0)]


class FreeBody:
    """A motion from q = 1; `turn` brings the axis that it circles to e3, by a quaternion."""

    def __init__(self, moments, rates):
        moments, rates = [mpf(x) for x in moments], [mpf(x) for x in rates]
        m = [j * w for j, w in zip(moments, rates)]
        square, energy = sum(x * x for x in m), sum(x * w for x, w in zip(m, rates))
        # the angular momentum circles the largest moment, or the smallest: (e1, e2, e3) -> (-e3, e2, e1)
        half = sqrt(mpf(1) / 2)
        self.turn = [mpf(1), mpf(0), mpf(0), mpf(0)]
        if square < energy * moments[1]:
            moments, m = moments[::-1], [-m[2], m[1], m[0]]
            self.turn = [half, mpf(0), -half, mpf(0)]
        if m[2] < 0:
            m = [m[0], -m[1], -m[2]]
            self.turn = product([mpf(0), mpf(1), mpf(0), mpf(0)], self.turn)
        a, b, c = (1 / j for j in moments)
        self.sizes = [sqrt((energy - square * c) / (a - c)), mpf(0), sqrt((energy - square * a) / (c - a))]
        self.sizes[1] = self.sizes[0] * sqrt((a - c) / (b - c))
        self.rate = self.sizes[0] * self.sizes[2] * (a - c) / self.sizes[1]
        self.modulus = self.sizes[0] * self.sizes[1] * (a - b) / (self.sizes[2] * self.rate)
        self.phase = ellipf(atan2(m[1] / self.sizes[1], m[0] / self.sizes[0]), self.modulus)
        self.moments, self.momentum, self.start = moments, sqrt(square), m
        self.half = 2 * ellipk(self.modulus)
        self.precession_of_half = self.quadrature(mpf(0), self.half)

    def at(self, u):
        names = zip(self.sizes, ("cn", "sn", "dn"))
        return [size * ellipfun(name, u, m=self.modulus) for size, name in names]

    def quadrature(self, start, end):
        """The angle of precession, over the argument of the elliptic functions."""

        def slope(u):
            m = self.at(u)
            about = m[0] ** 2 / self.moments[0] + m[1] ** 2 / self.moments[1]
            return self.momentum * about / (m[0] ** 2 + m[1] ** 2) / self.rate

        parts = 8
        return quad(slope, [start + (end - start) * k / parts for k in range(parts + 1)])

    def attitude(self, time):
        turned = self.rate * time
        halves = floor(turned / self.half)
        rest = turned - halves * self.half
        precession = halves * self.precession_of_half + self.quadrature(self.phase, self.phase + rest)
        m = self.at(self.phase + turned)
        spin = atan2(m[1], m[0]) - atan2(self.start[1], self.start[0])
        angle = (precession - spin) / 2
        about = [cos(angle), mpf(0), mpf(0), sin(angle)]
        return product(
            product(inverse(product(upright(self.start), self.turn)), about), product(upright(m), self.turn)
        )


def apart(p, q):
    return min(max(abs(x - y) for x, y in zip(p, q)), max(abs(x + y) for x, y in zip(p, q)))


def check():
    problems = json.loads(Path(__file__).with_name("trajectories.json").read_text())["problems"]
    for name in ["asymmetric_free", "vanzon_schofield"]:
        problem = problems[name]
        end = FreeBody(problem["I"], problem["w0"]).attitude(mpf(problem["T"]))
        assert apart(end, [mpf(x) for x in problem["q_ref"]]) < mpf(10) ** -38, name


def main():
    check()
    starts = [[3.0, 0.5, -0.9], [0.4, 2.1, -2.3], [-1.1, 0.7, 2.5], [1.9, -1.2, 0.8]]
    bodies = [FreeBody([0.6, 0.8, 1.0], rates) for rates in starts]
    rows = []
    for power in range(-6, 25):
        ends = [body.attitude(mpf(2) ** power) for body in bodies]
        rows.append({"time": 2.0**power, "attitudes": [[mp.nstr(x, 25) for x in q] for q in ends]})
    text = ",\n".join(json.dumps(row) for row in rows)
    print(f'{{"moments": [0.6, 0.8, 1.0], "starts": {json.dumps(starts)}, "rows": [\n{text}\n]}}')


if __name__ == "__main__":
    main()
