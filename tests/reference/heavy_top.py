"""Writes heavy_top.json: end states of symmetric bodies under the moment k Gamma x e_3, Gamma = R(q)^T e_z.

With "axis" and "up", e_3 is along that vector of the body and e_z along that vector of the world. By Taylor series of order 50 in 50-digit arithmetic; the inputs are doubles, the attitude is made unit exactly. What the step leaves of
energy and of the vertical angular momentum is checked.   pip install mpmath gmpy2; python3 heavy_top.py > heavy_top.json
"""

import json
import math
import random

from mpmath import mp, mpf, sqrt

mp.dps = 50
ORDER = 50


def series(a, e, q, w, h):
    """The coefficients of q and w1, w2, Gamma, scaled by h^n."""
    q, g = [[x] for x in q], [[x] for x in vertical(q)]
    w1, w2, w3 = [w[0]], [w[1]], w[2]

    def convolved(x, y, n):
        return sum((x[j] * y[n - j] for j in range(n + 1)), mpf(0))

    for n in range(ORDER):
        f = h / (n + 1)
        spin = [f * w3 / 2 * c[n] for c in q]
        d = lambda x, y: convolved(x, y, n)
        next_q = [
            -f / 2 * (d(q[1], w1) + d(q[2], w2)) - spin[3],
            f / 2 * (d(q[0], w1) - d(q[3], w2)) + spin[2],
            f / 2 * (d(q[0], w2) + d(q[3], w1)) - spin[1],
            f / 2 * (d(q[1], w2) - d(q[2], w1)) + spin[0],
        ]
        next_g = [
            f * (w3 * g[1][n] - d(g[2], w2)),
            f * (d(g[2], w1) - w3 * g[0][n]),
            f * (d(g[0], w2) - d(g[1], w1)),
        ]
        w1.append(f * (e * w3 * w2[n] + a * g[1][n]))
        w2.append(f * (-e * w3 * w1[n] - a * g[0][n]))
        for x, y in zip(q + g, next_q + next_g):
            x.append(y)
    return q + [w1, w2]


def vertical(q):
    s, x, y, z = q
    return [2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y)]


def conserved(a, p, q, w):
    g = vertical(q)
    return w[0] ** 2 / 2 + w[1] ** 2 / 2 + a * g[2], w[0] * g[0] + w[1] * g[1] + p * g[2]


def times(p, q):
    a, b, c, d = p
    w, x, y, z = q
    return [a * w - b * x - c * y - d * z, a * x + b * w + c * z - d * y,
            a * y - b * z + c * w + d * x, a * z + b * y - c * x + d * w]


def conjugate(q):
    return [q[0], -q[1], -q[2], -q[3]]


def to_third(vector):
    """A rotation of a vector, not opposite to the third axis, to it."""
    x, y, z = (mpf(part) for part in vector)
    length = sqrt(x * x + y * y + z * z)
    above = length + z
    root = sqrt(2 * length * above)
    return [above / root, y / root, -x / root, mpf(0)]


def turned(q, vector):
    return times(times(q, [mpf(0), *vector]), conjugate(q))[1:]


def end(case):
    if "axis" in case:
        world, body = to_third(case["up"]), to_third(case["axis"])
        q = times(times(world, [mpf(x) for x in case["attitude"]]), conjugate(body))
        w = turned(body, [mpf(x) for x in case["angular_velocity"]])
        plain = {name: case[name] for name in ("moments", "couple", "time")}
        q, w = end({**plain, "attitude": q, "angular_velocity": w})
        return times(times(conjugate(world), q), body), turned(conjugate(body), w)
    across, along = (mpf(x) for x in case["moments"])
    a, e, p = mpf(case["couple"]) / across, (across - along) / across, along / across
    q = [mpf(x) for x in case["attitude"]]
    norm = sqrt(sum(x * x for x in q))
    q, w = [x / norm for x in q], [mpf(x) for x in case["angular_velocity"]]
    before = conserved(a, p * w[2], q, w)
    rest = mpf(case["time"])
    while rest != 0:
        rows = series(a, e, q, w, mpf(1) if rest > 0 else mpf(-1))
        reach = lambda n: max(abs(r[n]) for r in rows) ** (mpf(-1) / n)
        h = min(reach(ORDER), reach(ORDER - 1)) * mpf(10) ** (mpf(-46) / ORDER)
        h = min(h, abs(rest)) * (1 if rest > 0 else -1)
        rest -= h
        sums = []
        for row in rows:
            total = mpf(0)
            for c in reversed(row):
                total = total * abs(h) + c
            sums.append(total)
        q, w = sums[:4], [sums[4], sums[5], w[2]]
    after = conserved(a, p * w[2], q, w)
    assert max(abs(x - y) for x, y in zip(before, after)) < mpf(10) ** -36 * (1 + abs(before[0]) + abs(before[1]))
    assert abs(sum(x * x for x in q) - 1) < mpf(10) ** -38
    return q, w


def cases():
    pick = random.Random(5)

    def case(kind, moments, couple, attitude, rates, time):
        return {"kind": kind, "moments": moments, "couple": couple, "attitude": attitude,
                "angular_velocity": rates, "time": time}

    def tilted(angle, turn=0.3, heading=0.7):
        c, s = math.cos(angle / 2), math.sin(angle / 2)
        half, rest = (turn + heading) / 2, (turn - heading) / 2
        return [c * math.cos(half), s * math.cos(rest), s * math.sin(rest), c * math.sin(half)]

    def anything(size=1.0):
        return [pick.gauss(0, size) for _ in range(3)]

    for _ in range(16):
        attitude = [pick.gauss(0, 1) for _ in range(4)]
        norm = math.sqrt(sum(x * x for x in attitude))
        yield case("random", [pick.uniform(0.5, 2), pick.uniform(0.1, 0.9)], pick.uniform(0.1, 5),
                   [x / norm for x in attitude], anything(3), pick.uniform(-9, 9))
    for spin in (0.0, 3.0, -40.0, 200.0):
        yield case("of any spin", [1.0, 0.5], 5.0, tilted(1.0), [0.5, 0.3, spin], 4.0)
    for couple in (0.0, 1e-12, 1e-4, 300.0):
        yield case("of any weight", [0.8, 1.3], couple, tilted(1.0), [0.5, -1.3, 2.0], 3.0)
    for along in (1.0, 1e-6, 1.999):
        yield case("of any shape", [1.0, along], 2.0, tilted(2.0), [0.5, 0.3, 2.5], 5.0)
    # upright, and hanging, with a push
    for attitude in ([1.0, 0.0, 0.0, 0.0], [0.6, 0.0, 0.0, 0.8], [0.0, 1.0, 0.0, 0.0], [0.0, 0.6, -0.8, 0.0]):
        for rates in ([0.4, -0.1, 3.0], [2.0, 1.0, -9.0], [1e-7, 0.0, 6.0], [3.0, 0.5, 0.0]):
            yield case("begins on the vertical", [1.0, 0.5], 2.5, attitude, rates, 6.0)
    for tilt in (1e-3, 1e-8):
        for spin in (20.0, 4.5, 4.4, 1.0):
            yield case("nearly upright", [1.0, 0.5], 1.25, tilted(tilt), [0.0, tilt, spin], 5.0)
        yield case("nearly hanging", [1.0, 0.5], 1.25, tilted(math.pi - tilt), [0.0, tilt, 2.0], 9.0)
    # C w3 = 2 sqrt(k A): the spin from which a top sleeps
    for tilt in (0.3, 1e-2, 1e-5):
        yield case("critical spin", [1.0, 0.5], 1.0, tilted(tilt), [0.0, 0.0, 4.0], 8.0)
    # l_z = p and energy of the upright body: w.Gamma = p (1 - u), |w|^2 = 2 a (1 - u)
    for off in (0.0, 1e-3, -1e-6, 1e-9, -1e-12):
        angle, p = 1.1, 1.0
        size = math.sqrt(2 * (1 - math.cos(angle)))
        along = p * (1 - math.cos(angle)) / math.sin(angle)
        across = math.sqrt(size * size - along * along)
        rates = [along * (1 + off), across, 2 * p]
        yield case("near the separatrix", [1.0, 0.5], 1.0, [math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0],
                   [-rates[0], -rates[1], rates[2]], 7.0)
        yield case("near the separatrix", [1.0, 0.5], 1.0, [math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0],
                   [-rates[0], rates[1], rates[2]], 7.0)
    # steady: A W^2 cos - C w3 W + k = 0
    for off in (0.0, 1e-12, 1e-8, 1e-4):
        tilt, spin = 0.7, 12.0
        c = math.cos(tilt)
        p = 0.5 * spin
        for slow in (False, True):
            root = math.sqrt(p * p - 4 * 5.0 * c)
            rate = (p - root) / (2 * c) if slow else (p + root) / (2 * c)
            yield case("nearly steady", [1.0, 0.5], 5.0, [math.cos(tilt / 2), math.sin(tilt / 2), 0.0, 0.0],
                       [0.0, rate * math.sin(tilt) * (1 + off), spin], 6.0)
    # planar pendulums, swinging and going round, and spherical ones
    for rates in ([0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [5.0, 0.0, 0.0], [0.0, 0.8, 0.0], [1e-9, 0.8, 0.0]):
        yield case("pendulum", [1.0, 0.5], 2.0, [math.cos(1.0), math.sin(1.0), 0.0, 0.0], rates, 9.0)
    # through the poles, and past them
    for off in (0.0, 1e-3, 1e-7, -1e-11):
        for pole in (1.0, -1.0):
            angle, p = 1.2, 1.5
            u = math.cos(angle)
            # w.Gamma + p u = pole p
            along = p * (pole - u) / math.sin(angle)
            yield case("past the vertical", [1.0, 0.5], 0.7, [math.cos(angle / 2), 0.0, math.sin(angle / 2), 0.0],
                       [-along * (1 + off), 3.0, 2 * p], 7.0)
    # released next to the vertical, at rest and spinning
    for tilt in (1e-5, 6e-9, 1e-9, 1e-12, 1e-15, 1e-20):
        for spin, heading in ((0.0, 0.7), (0.0, -2.5), (1e-9, 0.7), (0.3, 2.0), (-2.5, 0.1)):
            fall = 0.7 * math.log(1 / max(tilt, 1e-15)) + 2
            yield case("released next to upright", [1.0, 0.5], 1.25, tilted(tilt, heading=heading), [0.0, 0.0, spin],
                       -fall if heading < 0 else fall)
        yield case("released next to hanging", [1.0, 0.5], 1.25,
                   [math.sin(tilt / 2), math.cos(tilt / 2), 0.0, 0.0], [0.0, 0.0, 1e-3], 9.0)
    # of any axes: the tilt is what these doubles leave
    for axis, up in (([1.0, 0.0, 0.0], [0.0, 0.0, 1.0]), ([0.0, 1.0, 0.0], [0.0, -1.0, 0.0]),
                     ([2 / 3, -1 / 3, 2 / 3], [3.0, 4.0, 12.0])):
        for tilt in (1e-6, 1e-10, 1e-13, 1e-15):
            upright = times(times(conjugate(to_third(up)), [mpf(x) for x in tilted(tilt)]), to_third(axis))
            length = math.hypot(*up)
            yield {**case("released next to upright", [length, 0.5], 1.25 * length, [float(x) for x in upright],
                          [0.0, 0.0, 0.0], 0.9 * math.log(1 / tilt) + 2), "axis": axis, "up": up}


def written(case):
    q, w = end(case)
    decimal = lambda x: mp.nstr(x, 25, min_fixed=1, max_fixed=0)
    return {**case, "end_attitude": [decimal(x) for x in q], "end_angular_velocity": [decimal(x) for x in w]}


if __name__ == "__main__":
    print("[\n" + ",\n".join(json.dumps(written(case)) for case in cases()) + "\n]")
