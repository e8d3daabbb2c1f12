"""Writes axial_torque.json: end states of bodies that are symmetric about e_3, under a constant moment N e_3 in the body.

Euler's equations and q' = q w/2, by Taylor series of order 60 in 60-digit arithmetic; the inputs are doubles, the attitude is made unit
exactly. Steps of two lengths agree to the digits that are written to stderr, and so do the confluent hypergeometric functions that solve the equations, in 120-digit
arithmetic, where their parameter is no more than a thousand; where the body turns by more than 200 rad, these alone are used.
pip install mpmath gmpy2 python-flint; python3 axial_torque.py > axial_torque.json
"""

import json
import math
import random
import sys
from multiprocessing import Pool

from flint import acb, arb, ctx
from mpmath import mp, mpc, mpf, sqrt

mp.dps = 60
ORDER = 60


def series(excess, acceleration, q, w, h):
    """The coefficients of q, w1, w2, scaled by h^n; w3 is linear."""
    q, w1, w2 = [[x] for x in q], [w[0]], [w[1]]
    rates = [w[2], h * acceleration]

    def convolved(x, y, n):
        return sum((x[j] * y[n - j] for j in range(n + 1)), mpf(0))

    def spun(x, n):
        return rates[0] * x[n] + (rates[1] * x[n - 1] if n else 0)

    for n in range(ORDER):
        f = h / (n + 1)
        d, third = lambda x, y: convolved(x, y, n), [spun(c, n) for c in q]
        next_q = [
            -f / 2 * (d(q[1], w1) + d(q[2], w2) + third[3]),
            f / 2 * (d(q[0], w1) - d(q[3], w2) + third[2]),
            f / 2 * (d(q[0], w2) + d(q[3], w1) - third[1]),
            f / 2 * (d(q[1], w2) - d(q[2], w1) + third[0]),
        ]
        next_w = [f * excess * spun(w2, n), -f * excess * spun(w1, n)]
        for x, y in zip(q + [w1, w2], next_q + next_w):
            x.append(y)
    return q + [w1, w2]


def stepped(given, radians):
    """Steps that turn by no more than so many rad."""
    excess, acceleration, _, q, w, end = given
    time = mpf(0)
    while time != end:
        rate = sqrt(w[0] ** 2 + w[1] ** 2 + w[2] ** 2) + 2 * sqrt(abs(acceleration))
        h = end - time
        if abs(h) * rate > radians:
            h = mp.sign(h) * radians / rate
        parts = [sum(reversed(x)) for x in series(excess, acceleration, q, w, h)]
        q, w = parts[:4], [*parts[4:], w[2] + acceleration * h]
        time = end if h == end - time else time + h
    return q, w


def kummer(a, b, z):
    """By Arb: balls, to 110 digits."""
    for digits in (130, 260, 1000, 4000):
        ctx.dps = digits
        ball = lambda x: arb(mp.nstr(x, 140))
        value = acb(ball(z.real), ball(z.imag)).hypgeom_1f1(
            acb(ball(a.real), ball(a.imag)), acb(ball(b)))
        if value.rel_accuracy_bits() > 370:
            return mpc(*(mpf(part.mid().str(130, radius=False)) for part in (value.real, value.imag)))
    raise ValueError((a, b, z))


def parameters(a, tau):
    """alpha and beta of P' = P (i g + k tau/2), a = g^2: one at tau = 0."""
    x, first = -1j * tau * tau / 2, mpc(0, -a / 2)
    turn = mp.expj(tau * tau / 4)
    return turn * kummer(first, mpf(1) / 2, x), turn * sqrt(a) * tau * kummer(1 + first, mpf(3) / 2, x)


def product(p, q):
    """Of quaternions s, x, y, z."""
    (a, b, c, d), (s, x, y, z) = p, q
    return [a * s - b * x - c * y - d * z, a * x + b * s + c * z - d * y,
            a * y + c * s + d * x - b * z, a * z + d * s + b * y - c * x]


def by_kummer(given):
    excess, acceleration, ratio, q, w, time = given
    sign = 1 if acceleration > 0 else -1
    rate, torque = sign * w[2], abs(acceleration)
    across = sqrt(w[0] ** 2 + w[1] ** 2)
    spin = (rate + torque * time / 2) * time
    if across:
        b = ratio * torque
        a, root = across**2 / b / 4, sqrt(b)
        ends = [parameters(a, (ratio * rate + b * t) / root) for t in (0, time)]
        quaternions = [[x.real, y.real, y.imag, x.imag] for x, y in ends]
        s, x, y, z = product([quaternions[0][0], *(-c for c in quaternions[0][1:])], quaternions[1])
        ax, ay = w[0] / across, w[1] / across
        q = product(q, [s, ax * x - sign * ay * y, ay * x + sign * ax * y, sign * z])
        angle = excess * spin
    else:
        angle = spin
    q = product(q, [mp.cos(angle / 2), 0, 0, sign * mp.sin(angle / 2)])
    c, s = mp.cos(excess * spin), sign * mp.sin(excess * spin)
    return q, [c * w[0] + s * w[1], c * w[1] - s * w[0], w[2] + acceleration * time]


def end(case):
    mp.dps = 120
    across, along = (mpf(x) for x in case["moments"])
    q, w, time = [mpf(x) for x in case["attitude"]], [mpf(x) for x in case["angular_velocity"]], mpf(case["time"])
    norm = sqrt(sum(x * x for x in q))
    acceleration = mpf(case["torque"]) / along
    given = ((across - along) / across, acceleration, along / across, [x / norm for x in q], w, time)
    # of parameters up to a thousand
    slow = (w[0] ** 2 + w[1] ** 2) * across > 4000 * abs(mpf(case["torque"]))
    closed = None if slow else by_kummer(given)
    last = w[2] + acceleration * time
    angle = sqrt(w[0] ** 2 + w[1] ** 2 + w[2] ** 2 + last**2) * abs(time)
    if angle > 200 and closed:
        return closed
    mp.dps = 60
    one, other = stepped(given, mpf(2)), stepped(given, mpf("1.4"))
    distance = lambda a, b: max(abs(x - y) for x, y in zip(a[0] + a[1], b[0] + b[1]))
    digits = [int(-mp.log10(distance(other, x) + mpf(10) ** -60)) for x in (one, closed) if x]
    print(case["kind"], *digits, file=sys.stderr)
    if min(digits) < 32:
        raise ValueError(case)
    return other


def cases():
    pick = random.Random(7)

    def case(kind, moments, torque, rates, time, attitude=(0.5, -0.1, 0.7, 0.4)):
        norm = math.sqrt(sum(x * x for x in attitude))
        return {"kind": kind, "moments": moments, "torque": torque, "attitude": [x / norm for x in attitude],
                "angular_velocity": rates, "time": time}

    for _ in range(16):
        along = pick.uniform(0.1, 1.9)
        yield case("random", [1.0 + pick.random(), along], pick.gauss(0, 3), [pick.gauss(0, 3) for _ in range(3)],
                   pick.uniform(-9, 9), [pick.gauss(0, 1) for _ in range(4)])
    for spin in (0.0, 3.0, -40.0, 200.0):
        yield case("of any spin", [1.0, 0.5], 5.0, [0.5, 0.3, spin], 4.0)
        yield case("of any spin", [1.0, 1.7], -0.5, [0.5, 0.3, spin], -4.0)
    for torque in (1e-300, 1e-18, 1e-12, 1e-8, -1e-4, 1e-2, 300.0, -1e6):
        yield case("of any torque", [0.8, 1.3], torque, [0.5, -1.3, 2.0], 3.0 if abs(torque) < 1e5 else 0.02)
    for along in (1.0, 1e-6, 1e-3, 1.999):
        yield case("of any shape", [1.0, along], along, [0.5, 0.3, 2.5], 3.0)
    # from spin to spin the other way, with any wobble
    for across in (0.0, 1e-160, 1e-9, 1e-3, 0.3, 1.0, 3.0, 6.0, 9.0, 12.0, 30.0):
        yield case("reverses", [1.0, 0.6], -1.0, [0.6 * across, 0.8 * across, 40.0], 48.0)
        yield case("reverses", [1.0, 1.4], 1.0, [-0.8 * across, 0.6 * across, -13.0], 40.0)
    # w^2 = 81 b, on both sides; and a start, or an end, where series meet expansions
    for off in (-1e-3, -1e-9, 1e-9, 1e-3):
        yield case("hardly slow", [1.0, 0.5], 1.0, [0.0, 9.0 * (1 + off), -5.0], 6.0)
        yield case("begins at the edge", [1.0, 0.5], 1.0, [0.7, 0.2, -18.0 * (1 + off)], 19.0)
        yield case("ends at the edge", [1.0, 0.5], 1.0, [0.7, 0.2, -1.0], 9.5 * (1 + off))
    # hardly at all: w^2/4b from 1e3 to 1e10
    for torque in (1e-9, 1e-5, 1e-2):
        yield case("hardly swept", [1.0, 0.5], torque, [6.0, 3.0, -20 * torque], 20.0)
    # before and after
    for rates, time in (([0.2, 0.1, 30.0], 1e-6), ([0.2, 0.1, 0.1], -1e-9), ([4.0, 1.0, 30.0], 3.0), ([4.0, 1.0, -30.0], -3.0),
                        ([2.0, 1.0, -30.0], 3.0), ([2.0, 1.0, 3.0], -16.0)):
        yield case("on one side", [1.0, 0.8], 2.0, rates, time)
    # long: 1e3 to 1e12 rad
    for time in (60.0, 300.0, 3e3, -1e4, 1e6):
        yield case("for long", [1.0, 0.7], 1.0, [0.4, 0.9, -3.0], time)
    yield case("for long", [1.0, 0.7], 1e-9, [0.4, 0.9, -3.0], -100.0)
    yield case("for long", [1.3, 0.7], 1.0, [20.0, 9.0, -30.0], 6e4)


def written(case):
    q, w = end(case)
    decimal = lambda x: mp.nstr(x, 25, min_fixed=1, max_fixed=0)
    return {**case, "end_attitude": [decimal(x) for x in q], "end_angular_velocity": [decimal(x) for x in w]}


if __name__ == "__main__":
    with Pool() as pool:
        print("[\n" + ",\n".join(map(json.dumps, pool.map(written, cases(), chunksize=1))) + "\n]")
