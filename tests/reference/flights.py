"""End states of bodies in flight, to 25 digits and more: `python3 flights.py > flights.json`, after `pip install mpmath gmpy2`.

The modified midpoint rule in 70-digit arithmetic, extrapolated from 2, 4, ... 40 substeps to order 40 (W. Gragg, SIAM J. Numer.
Anal. 2 (1965) 384). Each motion is computed twice, with steps of different lengths; the digits in which the two agree are counted, and
those of `heavy_asym`, of which `trajectories.json` has the end by another route.
"""

import json
from pathlib import Path

from mpmath import matrix, mp, mpf, norm, sqrt

mp.dps = 70
COLUMNS = 20


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def scaled(factor, a):
    return [factor * x for x in a]


def added(*vectors):
    return [sum(parts) for parts in zip(*vectors)]


def to_world(q, v):
    """v + 2 (s u + q x u), u = q x v; of an attitude with the scalar s first."""
    s, axis = q[0], q[1:]
    u = cross(axis, v)
    return added(v, scaled(2 * s, u), scaled(2, cross(axis, u)))


def to_body(q, v):
    return to_world([q[0], -q[1], -q[2], -q[3]], v)


def turning(q, w):
    """q (0, w) / 2"""
    s, axis = q[0], q[1:]
    return scaled(mpf(1) / 2, [-dot(axis, w), *added(scaled(s, w), cross(axis, w))])


def euler(inertia, moment, w):
    momentum = [j * rate for j, rate in zip(inertia, w)]
    return [m / j for m, j in zip(added(moment, scaled(-1, cross(w, momentum))), inertia)]


def free_flight(loads, mass, inertia):
    """Rates of position, attitude, velocity and angular velocity, under a force in world axes and a moment in body axes."""

    def rates(y):
        p, q, v, w = y[:3], y[3:7], y[7:10], y[10:]
        force, moment = loads(p, q, v, w)
        return [*v, *turning(q, w), *scaled(1 / mass, force), *euler(inertia, moment, w)]

    return rates


def quadrotor():
    """Four unequal rotors, drag of the body by the square of its speed and of its turning by the rate."""
    mass, inertia = mpf("1.2"), [mpf("0.0123"), mpf("0.0117"), mpf("0.0224")]
    arm, ratio, thrusts = mpf("0.17"), mpf("0.016"), [mpf("3.1"), mpf("2.9"), mpf(3), mpf("3.2")]
    front, left, back, right = thrusts
    rotors = [arm * (left - right), arm * (back - front), ratio * (front - left + back - right)]

    def loads(p, q, v, w):
        drag = scaled(-mpf("0.08") * sqrt(dot(v, v)), v)
        lift = to_world(q, [0, 0, sum(thrusts)])
        weight = [0, 0, -mpf("9.80665") * mass]
        return added(drag, lift, weight), added(rotors, scaled(-mpf("0.01"), w))

    start = [0, 0, 0, 1, 0, 0, 0, 3, -2, 1, mpf("0.5"), mpf("-0.3"), mpf("0.8")]
    return free_flight(loads, mass, inertia), start, 10, "1/20"


def satellite():
    """The example `satellite`, tumbling on an inclined orbit."""
    mass, inertia, mu = mpf(500), [mpf(120), mpf(150), mpf(90)], mpf("3.986004418e14")

    def loads(p, q, v, w):
        square = dot(p, p)
        distance = sqrt(square)
        n = to_body(q, p)
        turned = [j * x for j, x in zip(inertia, n)]
        along, cube = dot(n, turned), square * distance
        radial = -mu * mass / cube + mu * (15 * along / square - 3 * sum(inertia)) / (2 * cube * square)
        force = added(scaled(radial, p), scaled(-3 * mu / (cube * square), to_world(q, turned)))
        return force, scaled(3 * mu / (cube * square), cross(n, turned))

    start = [7000000, 0, 0, 1, 0, 0, 0, 0, 6000, 4500, mpf("0.004"), mpf("0.001"), mpf("-0.002")]
    return free_flight(loads, mass, inertia), start, 5000, "25"


def heavy_asym():
    """A heavy top, to be checked by `trajectories.json`."""
    inertia = [mpf(0.6), mpf(0.8), mpf(1)]

    def rates(y):
        q, w = y[:4], y[4:]
        moment = cross(to_body(q, [0, 0, 1]), [0, 0, 1])
        return [*turning(q, w), *euler(inertia, moment, w)]

    return rates, [1, 0, 0, 0, 3, mpf(0.5), mpf(-0.9)], 10, "1/4"


def midpoint(rates, y, step, substeps):
    h = step / substeps
    before, now = y, added(y, scaled(h, rates(y)))
    for _ in range(substeps - 1):
        before, now = now, added(before, scaled(2 * h, rates(now)))
    return scaled(mpf(1) / 2, added(before, now, scaled(h, rates(now))))


def extrapolated(rates, y, step):
    counts = [2 * k for k in range(1, COLUMNS + 1)]
    row = [midpoint(rates, y, step, count) for count in counts]
    for column in range(1, COLUMNS):
        for k in range(COLUMNS - column):
            fine, coarse = counts[k + column] ** 2, counts[k] ** 2
            row[k] = added(row[k + 1], scaled(mpf(coarse) / (fine - coarse), added(row[k + 1], scaled(-1, row[k]))))
    return row[0]


def end(rates, start, seconds, step):
    steps, y = round(seconds / step), [mpf(x) for x in start]
    for _ in range(steps):
        y = extrapolated(rates, y, mpf(seconds) / steps)
    return y


def number(fraction):
    numerator, _, denominator = fraction.partition("/")
    return mpf(numerator) / mpf(denominator or 1)


def digits(one, other):
    """Digits of the vectors of a state in which two computations agree, each vector relative to its length."""
    lengths = [3, 4, 3, 3] if len(one) == 13 else [4, 3]
    worst, first = mpf(0), 0
    for length in lengths:
        a, b = matrix(one[first : first + length]), matrix(other[first : first + length])
        worst, first = max(worst, norm(a - b) / norm(b)), first + length
    return int(-mp.log10(worst)) if worst else mp.dps


def computed(motion):
    rates, start, seconds, step = motion()
    coarse = end(rates, start, seconds, number(step))
    fine = end(rates, start, seconds, number(step) * 3 / 4)
    return start, seconds, fine, digits(coarse, fine)


def main():
    _, _, top, agreed = computed(heavy_asym)
    known = json.loads(Path(__file__).with_name("trajectories.json").read_text())["problems"]["heavy_asym"]
    known = [mpf(x) for x in known["q_ref"] + known["w_ref"]]
    checked = min(agreed, digits(top, known))

    flights = {}
    for motion in [quadrotor, satellite]:
        start, seconds, y, agreed = computed(motion)
        words = lambda y: [mp.nstr(x, 40) for x in y]
        flights[motion.__name__] = {
            "note": " ".join(motion.__doc__.split()),
            "T": seconds,
            "start": words(mpf(x) for x in start),
            "end": words(y),
            "digits_agreed": agreed,
        }
    model = "position, attitude (scalar first, body to world), velocity, angular velocity (body axes); SI units"
    print(json.dumps({"model": model, "digits_of_heavy_asym": checked, "problems": flights}, indent=1))


if __name__ == "__main__":
    main()
