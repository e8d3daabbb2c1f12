"""Writes gyrostats.json: end states of bodies with a rotor, thrown in a uniform field.

The laws of Newton and Euler of the base and of the rotor, each by itself, with the force and the moment between them as unknowns, by
extrapolation of the midpoint rule of order 24 in 40-digit arithmetic; the inputs are doubles. Steps of two lengths agree to the digits
that are written to stderr. pip install mpmath; python3 gyrostats.py > gyrostats.json
"""

import json
import sys

from mpmath import inverse, matrix, mp, mpf

mp.dps = 40
END = 10
ORDER = 12


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(*vectors):
    return [sum(parts, mpf(0)) for parts in zip(*vectors)]


def times(s, a):
    return [s * x for x in a]


def turned(q, a):
    """From the base to the world; the scalar of q is first."""
    twice = times(2, cross(q[1:], a))
    return plus(a, times(q[0], twice), cross(q[1:], twice))


def skew(a):
    return [[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]]


def law(body):
    """The rates of (r, q, v, w, angle, rate), all vectors but r and v in the axes of the base.

    Unknowns: a, w', rate', the force F on the rotor at its center d, and the moment M on it.
    """
    m, n = mpf(body["masses"][0]), mpf(body["masses"][1])
    inertia, rotor = [[mpf(x) for x in row] for row in body["moments"]]
    d, e = [mpf(x) for x in body["place"]], [mpf(x) for x in body["axis"]]
    g, drive = [mpf(x) for x in body["field"]], mpf(body["drive"])
    rows = matrix(13, 13)
    arm = skew(d)
    for i in range(3):
        # m a + F = m g
        rows[i, i], rows[i, 7 + i] = m, 1
        # n (a + w' x d) - F = n g - n w x (w x d)
        rows[3 + i, i], rows[3 + i, 7 + i] = n, -1
        # J w' + M + d x F = -w x J w
        rows[6 + i, 3 + i], rows[6 + i, 10 + i] = inertia[i], 1
        # R (w' + rate' e) - M = -w x R (w + rate e)
        rows[9 + i, 3 + i], rows[9 + i, 6], rows[9 + i, 10 + i] = rotor[i], rotor[i] * e[i], -1
        # M . e = drive
        rows[12, 10 + i] = e[i]
        for j in range(3):
            rows[3 + i, 3 + j] = -n * arm[i][j]
            rows[6 + i, 7 + j] = arm[i][j]
    solve = inverse(rows)

    def rates(y):
        q, v, w, rate = y[3:7], y[7:10], y[10:13], y[14]
        back = [q[0]] + times(-1, q[1:])
        seen = turned(back, g)
        spun = plus(w, times(rate, e))
        of_base = cross(w, [x * y for x, y in zip(inertia, w)])
        of_rotor = cross(w, [x * y for x, y in zip(rotor, spun)])
        drawn = cross(w, cross(w, d))
        right = times(m, seen) + times(n, plus(seen, times(-1, drawn)))
        right += times(-1, of_base) + times(-1, of_rotor) + [drive]
        found = [mp.fdot(solve[i, :], right) for i in range(7)]
        turning = [-sum(a * b for a, b in zip(q[1:], w))]
        turning += plus(times(q[0], w), cross(q[1:], w))
        return v + times(mpf(1) / 2, turning) + turned(q, found[:3]) + found[3:6] + [rate, found[6]]

    return rates


def extrapolated(f, y, step):
    """One step, by midpoint rules of 2, 4, .. 2 ORDER parts (Gragg, Bulirsch and Stoer)."""
    table = []
    for k in range(1, ORDER + 1):
        parts = 2 * k
        h = step / parts
        before, now = y, plus(y, times(h, f(y)))
        for _ in range(parts - 1):
            before, now = now, plus(before, times(2 * h, f(now)))
        row = [times(mpf(1) / 2, plus(before, now, times(h, f(now))))]
        for j, last in enumerate(table):
            ratio = mpf(parts * parts) / (2 * (k - 1 - j)) ** 2
            row.append([a + (a - b) / (ratio - 1) for a, b in zip(row[-1], last)])
        table = row
    return table[-1]


def end(body, steps):
    f, y = law(body), [mpf(x) for x in body["start"]]
    for _ in range(steps):
        y = extrapolated(f, y, mpf(END) / steps)
    return y


def main():
    start = [1.0, -2.0, 3.0, 0.5, 0.5, -0.5, 0.5, 0.25, 1.5, -0.75, 0.4, -0.3, 0.7, 0.125, 6.5]
    bodies = {
        "boom": {
            "masses": ["50", "3"],
            "moments": [["11.6", "11.6", "9"], ["0.4", "0.4", "0.6"]],
            "place": ["0", "0", "0.7"],
            "axis": ["0", "0", "1"],
            "field": ["0", "0.5", "-9.80665"],
            "drive": "0.02",
        },
        "free": {
            "masses": ["8", "2"],
            "moments": [["0.5", "0.9", "0.9"], ["0.03", "0.02", "0.02"]],
            "place": ["-0.2", "0", "0"],
            "axis": ["1", "0", "0"],
            "field": ["0", "0", "0"],
            "drive": "0",
        },
    }
    for name, body in bodies.items():
        body["start"], body["time"] = start, END
        coarse, fine = end(body, 60), end(body, 80)
        difference = max(abs(a - b) for a, b in zip(coarse, fine))
        print(name, mp.nstr(difference, 3), file=sys.stderr)
        body["end"] = [mp.nstr(x, 30) for x in fine]
    json.dump(bodies, sys.stdout, indent=1)


main()
