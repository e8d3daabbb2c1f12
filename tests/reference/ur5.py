"""A quarter of a second of the motion of the arm of systems/ur5.json under its constant drives, in 23 digits: writes ur5.json.

Newton's and Euler's equations of each body give the drives; with unit accelerations, the matrix of masses. Steps by
extrapolation of the midpoint rule; the start is held to the accelerations of systems/ur5.json.
"""

import json
from pathlib import Path

from mpmath import cos, lu_solve, matrix, mp, mpf, sin

mp.dps = 40
FOLDER = Path(__file__).parent
SYSTEM = json.loads((FOLDER / "systems" / "ur5.json").read_text(), parse_float=mpf, parse_int=mpf)
JOINTS = SYSTEM["system"]["joints"]
GRAVITY = SYSTEM["system"]["gravity"]
AXIS = ["XYZ".index(joint["type"][1]) for joint in JOINTS]
N = len(JOINTS)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def plus(*vectors):
    return [sum(parts) for parts in zip(*vectors)]


def times(m, v):
    return [sum(m[i][j] * v[j] for j in range(3)) for i in range(3)]


def back(m, v):
    return [sum(m[j][i] * v[j] for j in range(3)) for i in range(3)]


def turned(joint, axis, angle):
    """From the axes of the body to those of its carrier."""
    s, c = sin(angle), cos(angle)
    i, j = (axis + 1) % 3, (axis + 2) % 3
    turn = [[mpf(r == k) for k in range(3)] for r in range(3)]
    turn[i][i] = turn[j][j] = c
    turn[i][j], turn[j][i] = -s, s
    return [[sum(joint["R"][r][m] * turn[m][k] for m in range(3)) for k in range(3)] for r in range(3)]


def drives(turns, v, a, gravity):
    """Outwards the accelerations, inwards the loads."""
    w, u = [mpf(0)] * 3, [mpf(0)] * 3
    x = [-g for g in gravity]
    loads = []
    for k, joint in enumerate(JOINTS):
        place, turn = joint["p"], turns[k]
        x = back(turn, plus(x, cross(u, place), cross(w, cross(w, place))))
        w, u = back(turn, w), back(turn, u)
        spin = [v[k] if i == AXIS[k] else mpf(0) for i in range(3)]
        u = plus(u, cross(w, spin), [a[k] if i == AXIS[k] else mpf(0) for i in range(3)])
        w = plus(w, spin)
        body = joint["inertia"]
        c, tensor = body["c"], body["Ic"]
        force = [body["m"] * part for part in plus(x, cross(u, c), cross(w, cross(w, c)))]
        loads.append((force, plus(times(tensor, u), cross(w, times(tensor, w)), cross(c, force))))
    found = [mpf(0)] * N
    force, moment = [mpf(0)] * 3, [mpf(0)] * 3
    for k in reversed(range(N)):
        force, moment = plus(loads[k][0], force), plus(loads[k][1], moment)
        found[k] = moment[AXIS[k]]
        force, moment = times(turns[k], force), times(turns[k], moment)
        moment = plus(moment, cross(JOINTS[k]["p"], force))
    return found


def rates(y):
    q, v = y[:N], y[N:]
    turns = [turned(joint, axis, angle) for joint, axis, angle in zip(JOINTS, AXIS, q)]
    rest, none = [mpf(0)] * N, [mpf(0)] * 3
    bias = drives(turns, v, rest, GRAVITY)
    mass = matrix(N, N)
    for k in range(N):
        column = drives(turns, rest, [mpf(i == k) for i in range(N)], none)
        for i in range(N):
            mass[i, k] = column[i]
    return list(v) + list(lu_solve(mass, matrix([d - b for d, b in zip(DRIVES, bias)])))


def step(y, h, order=11):
    """Gragg's rule with 2, 4, 6, .. parts, extrapolated."""
    first, table = rates(y), []
    for k in range(1, order + 1):
        parts = 2 * k
        d = h / parts
        before, now = y, [a + d * b for a, b in zip(y, first)]
        for _ in range(parts - 1):
            before, now = now, [a + 2 * d * b for a, b in zip(before, rates(now))]
        row = [[(a + b + d * c) / 2 for a, b, c in zip(before, now, rates(now))]]
        for j in range(1, k):
            ratio = (mpf(k) / (k - j)) ** 2 - 1
            row.append([a + (a - b) / ratio for a, b in zip(row[j - 1], table[-1][j - 1])])
        table.append(row)
    return table[-1][-1]


def moved(y, seconds, steps):
    for _ in range(steps):
        y = step(y, mpf(seconds) / steps)
    return y


SECONDS = 0.25
DRIVES = [mpf(d) for d in SYSTEM["drives"]]
START = [mpf(x) for x in SYSTEM["q"] + SYSTEM["v"]]

if __name__ == "__main__":
    known = [mpf(x) for x in SYSTEM["acceleration"]]
    assert max(abs(a - b) for a, b in zip(rates(START)[N:], known)) < mpf(10) ** -25
    ends = [moved(START, SECONDS, steps) for steps in (9, 13)]
    difference = max(abs(a - b) for a, b in zip(*ends))
    print("difference of two sizes of steps:", mp.nstr(difference, 3))
    assert difference < mpf(10) ** -20
    numbers = [mp.nstr(x, 23) for x in ends[1]]
    end = {"T": str(SECONDS), "q": numbers[:N], "v": numbers[N:]}
    (FOLDER / "ur5.json").write_text(json.dumps(end, indent=1) + "\n")
