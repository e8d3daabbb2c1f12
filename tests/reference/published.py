"""Writes published.json: ends of problems that others have published, by the extrapolation of flights.py.

Each motion is computed twice, with steps of different lengths; the digits in which the two agree are counted.
pip install mpmath gmpy2; python3 published.py > published.json
"""

import json

from flights import added, cross, digits, dot, euler, extrapolated, free_flight, number, scaled, to_body, turning
from mpmath import ellipfun, mp, mpf, pi, sin, sqrt

FOOT = mpf("0.3048")
SLUG = mpf("4.4482216152605") / FOOT
BRICK = [mpf(x) * SLUG * FOOT**2 for x in ("0.001894220", "0.006211019", "0.007194665")]
RATES = [mpf(rate) * pi / 180 for rate in (10, 20, 30)]


def rotation(moments, moment):
    """Rates of attitude and angular velocity, under a moment in body axes that depends on time."""

    def rates(t, y):
        q, w = y[:4], y[4:]
        return [*turning(q, w), *euler(moments, moment(t), w)]

    return rates


def unloaded(t):
    return [mpf(0)] * 3


def tumbling_brick():
    """NESC atmospheric check-case 2: a brick without loads."""
    return rotation(BRICK, unloaded), [1, 0, 0, 0, *RATES], [0, 30], "1/2"


def falling_brick():
    """NESC atmospheric check-case 3: the brick falls from 30,000 ft, damped by the air that turns with the Earth."""
    mass, area = mpf("0.155404754") * SLUG, mpf("0.22222") * FOOT**2
    span, chord = mpf("0.33333") * FOOT, mpf("0.66667") * FOOT
    mu, j2, radius = mpf("3.986004418e14"), mpf("1.08262982e-3"), mpf(6378137)
    earth = [mpf(0), mpf(0), mpf("7.292115e-5")]

    def density(height):
        """The US Standard Atmosphere of 1976 below 11 km."""
        datum = mpf(6356766)
        kelvin = mpf("288.15") - mpf("0.0065") * datum * height / (datum + height)
        exponent = mpf("9.80665") * mpf("28.9644") / (mpf("8314.32") * mpf("0.0065")) - 1
        return mpf("1.225") * (kelvin / mpf("288.15")) ** exponent

    def loads(p, q, v, w):
        square = dot(p, p)
        distance = sqrt(square)
        ratio, sine = mpf(3) / 2 * j2 * radius**2 / square, p[2] ** 2 / square
        polar = [1 - 5 * sine, 1 - 5 * sine, 3 - 5 * sine]
        weight = [-mu * mass / (square * distance) * x * (1 + ratio * k) for x, k in zip(p, polar)]
        wind = added(v, scaled(-1, cross(earth, p)))
        turns = added(w, scaled(-1, to_body(q, earth)))
        pressure = density(distance - radius) * sqrt(dot(wind, wind)) * area / 4
        return weight, [-pressure * l**2 * x for l, x in zip((span, chord, span), turns)]

    flight = free_flight(loads, mass, BRICK)
    half, away = sqrt(mpf(1) / 2), radius + 30000 * FOOT
    start = [away, 0, 0, half, 0, -half, 0, 0, earth[2] * away, 0, *RATES]
    return lambda t, y: flight(y), start, [0, 30], "1/2"


def detest_b5():
    """DETEST B5 as a body: y = (5/9 w1, 4/3 w2, 2/5 w3) has y1' = y2 y3, y2' = -y1 y3, y3' = -0.51 y1 y2."""
    rates = rotation([mpf(25), mpf(42), mpf(18)], unloaded)
    return rates, [1, 0, 0, 0, 0, mpf("0.75"), mpf("2.5")], [0, 20], "1/4"


def benchmark(moment, times):
    """y = (4/5 w1, 1/2 w2, 2/5 w3) has y1' = -2 y2 y3, y2' = 1.25 y1 y3, y3' = -0.5 y1 y2 + f; f is 1/15 of the moment."""
    rates = rotation([mpf(2), mpf(5), mpf(6)], lambda t: [mpf(0), mpf(0), moment(t)])
    return rates, [1, 0, 0, 0, mpf("1.25"), 0, mpf("2.25")], times, "1/8"


def rigid_body():
    """The rigid body of ODEProblemLibrary.jl, f = 0."""
    return benchmark(lambda t: mpf(0), [0, 20])


def rigid_body_driven():
    """The rigid body of SciMLBenchmarks, f = 0.25 sin(t)^2."""
    return benchmark(lambda t: mpf("3.75") * sin(t) ** 2, [0, 10])


def rigid_body_pushed():
    """EULR of Hairer, Norsett and Wanner, f = 0.25 sin(t)^2 from 3 pi to 4 pi and else 0."""
    pushes = lambda t: 3 * pi < t < 4 * pi
    return benchmark(lambda t: mpf("3.75") * sin(t) ** 2 if pushes(t) else mpf(0), [0, 3 * pi, 4 * pi, 20])


def end(rates, start, times, step):
    """From one time to the next, over which the rates are smooth; time is one more coordinate."""

    def with_time(z):
        return [mpf(1), *rates(z[0], z[1:])]

    y = [mpf(x) for x in start]
    for begin, until in zip(times, times[1:]):
        steps = round((until - begin) / step) or 1
        z = [mpf(begin), *y]
        for _ in range(steps):
            z = extrapolated(with_time, z, mpf(until - begin) / steps)
        y = z[1:]
    return y


def check(b5):
    """The other route to one of them: y = (sn t, cn t, dn t)."""
    scales = mpf(5) / 9, mpf(4) / 3, mpf(2) / 5
    for name, scale, rate in zip(("sn", "cn", "dn"), scales, b5["end"][4:]):
        assert abs(ellipfun(name, 20, m=mpf("0.51")) - scale * mpf(rate)) < mpf(10) ** -36


def main():
    problems = {}
    for motion in [tumbling_brick, falling_brick, detest_b5, rigid_body, rigid_body_driven, rigid_body_pushed]:
        rates, start, times, step = motion()
        coarse = end(rates, start, times, number(step))
        fine = end(rates, start, times, number(step) * 3 / 4)
        words = lambda y: [mp.nstr(mpf(x), 40) for x in y]
        problems[motion.__name__] = {
            "note": " ".join(motion.__doc__.split()),
            "T": times[-1],
            "start": words(start),
            "end": words(fine),
            "digits_agreed": digits(coarse, fine),
        }
    check(problems["detest_b5"])
    model = "position, attitude (scalar first, body to world), velocity, angular velocity (body axes), as far as there are; SI units"
    print(json.dumps({"model": model, "problems": problems}, indent=1))


if __name__ == "__main__":
    main()
