"""Where the arm of `ur5.json` is after half a second under its drives: `python3 motions.py > ur5_motion.json`, after
`pip install mpmath gmpy2`.

Newton's and Euler's laws link by link from the base to the tip and back, the mass matrix by unit accelerations, in 50-digit arithmetic;
steps and extrapolation are those of `../flights.py`. The motion is computed twice, with steps of different lengths; the digits in which
the two agree are counted, and those in which the power of the drives is the change of energy.
"""

import json
import sys
from pathlib import Path

import gmpy2
from gmpy2 import cos, mpfr as mpf, sin

HERE = Path(__file__).parent
sys.path.append(str(HERE.parent))
import flights
from flights import added, cross, dot, scaled

# of fifty digits, and faster than those of mpmath
gmpy2.get_context().precision = 166
flights.mpf, flights.COLUMNS = mpf, 14
SECONDS = mpf("0.5")


def exact(values):
    """Decimals as they are written, and a number of turned axes that is nearly whole as that."""
    if isinstance(values, list):
        return [exact(value) for value in values]
    number = mpf(repr(values) if isinstance(values, float) else values)
    return mpf(int(gmpy2.rint(number))) if abs(number - int(gmpy2.rint(number))) < mpf("1e-14") else number


def times(rows, vector):
    return [dot(row, vector) for row in rows]


def transposed(rows):
    return [list(column) for column in zip(*rows)]


def solved(rows, right):
    """Of a mass matrix: no pivot vanishes."""
    rows = [[*row, value] for row, value in zip(rows, right)]
    for k, pivot in enumerate(rows):
        for row in rows[k + 1 :]:
            factor = row[k] / pivot[k]
            row[k:] = [a - factor * b for a, b in zip(row[k:], pivot[k:])]
    found = []
    for k in reversed(range(len(rows))):
        *row, value = rows[k]
        found.insert(0, (value - dot(row[k + 1 :], found)) / row[k])
    return found


class Arm:
    def __init__(self, file):
        system = file["system"]
        self.gravity, self.links = exact(system["gravity"]), system["joints"]
        for link in self.links:
            link["axis"] = [mpf(int(letter == link["type"][1])) for letter in "XYZ"]
            link["R"], link["p"] = exact(link["R"]), exact(link["p"])
            inertia = link["inertia"]
            # the file has 0.24999999999999994 for a quarter, which descriptions have
            link["c"] = [mpf(repr(round(x, 12))) for x in inertia["c"]]
            link["m"], link["J"] = mpf(repr(inertia["m"])), exact(inertia["Ic"])

    def frames(self, q):
        """Of each link: its axes in those of its carrier, as rows of the carrier."""
        found = []
        for link, angle in zip(self.links, q):
            s, c, e = sin(angle), cos(angle), link["axis"]
            columns = []
            for k in range(3):
                unit = [mpf(int(j == k)) for j in range(3)]
                along = scaled((1 - c) * e[k], e)
                columns.append(added(scaled(c, unit), scaled(s, cross(e, unit)), along))
            turned = [times(link["R"], column) for column in columns]
            found.append(transposed(turned))
        return found

    def torques(self, frames, v, a, gravity):
        """Of the drives, by which the joints have the accelerations a."""
        w, alpha, linear = [mpf(0)] * 3, [mpf(0)] * 3, scaled(-1, gravity)
        balances = []
        for link, frame, rate, acceleration in zip(self.links, frames, v, a):
            p, e, back = link["p"], link["axis"], transposed(frame)
            linear = times(back, added(linear, cross(alpha, p), cross(w, cross(w, p))))
            w, alpha = times(back, w), times(back, alpha)
            spin = scaled(rate, e)
            alpha = added(alpha, cross(w, spin), scaled(acceleration, e))
            w = added(w, spin)
            c, inertia = link["c"], link["J"]
            force = scaled(link["m"], added(linear, cross(alpha, c), cross(w, cross(w, c))))
            moment = added(times(inertia, alpha), cross(w, times(inertia, w)), cross(c, force))
            balances.append((force, moment))
        force, moment, found = [mpf(0)] * 3, [mpf(0)] * 3, []
        for place in reversed(range(len(self.links))):
            own = balances[place]
            force, moment = added(own[0], force), added(own[1], moment)
            link, frame = self.links[place], frames[place]
            found.append(dot(link["axis"], moment))
            force, moment = times(frame, force), times(frame, moment)
            moment = added(moment, cross(link["p"], force))
        return found[::-1]

    def accelerations(self, q, v, drives):
        frames, count = self.frames(q), len(q)
        still, none = [mpf(0)] * count, [mpf(0)] * 3
        bias = self.torques(frames, v, still, self.gravity)
        unit = lambda k: [mpf(int(j == k)) for j in range(count)]
        mass = [self.torques(frames, still, unit(k), none) for k in range(count)]
        return solved(mass, added(drives, scaled(-1, bias)))

    def energy(self, q, v):
        frames, count = self.frames(q), len(q)
        still = [mpf(0)] * count
        kinetic = dot(v, self.torques(frames, still, v, [mpf(0)] * 3)) / 2
        axes, at, potential = [[mpf(int(j == k)) for j in range(3)] for k in range(3)], [mpf(0)] * 3, mpf(0)
        for link, frame in zip(self.links, frames):
            at = added(at, times(axes, link["p"]))
            axes = transposed([times(axes, column) for column in transposed(frame)])
            potential -= link["m"] * dot(self.gravity, added(at, times(axes, link["c"])))
        return kinetic + potential


def text(values):
    return [f"{value:.30g}" for value in values]


def main():
    file = json.loads((HERE / "ur5.json").read_text())
    arm = Arm(file)
    q, v, drives = [[mpf(x) for x in file[key]] for key in ["q", "v", "drives"]]
    known = [mpf(x) for x in file["acceleration"]]
    off = max(abs(a - b) for a, b in zip(arm.accelerations(q, v, drives), known)) / max(map(abs, known))
    assert off < mpf("1e-16"), off

    def rates(y):
        return [*y[6:], *arm.accelerations(y[:6], y[6:], drives)]

    coarse, fine = [flights.end(rates, [*q, *v], SECONDS, mpf(1) / steps) for steps in STEPS]
    agreed = max(abs(a - b) / abs(b) for a, b in zip(coarse, fine))
    work = dot(drives, added(fine[:6], scaled(-1, q)))
    gained = arm.energy(fine[:6], fine[6:]) - arm.energy(q, v)
    print(
        json.dumps(
            {
                "T": str(float(SECONDS)),
                "q": text(fine[:6]),
                "v": text(fine[6:]),
                "difference_of_two_step_sizes": f"{agreed:.3g}",
                "energy_less_work": f"{(gained - work) / gained:.3g}",
                "accelerations_at_start": f"{off:.3g}",
                "provenance": "motions.py",
            },
            indent=1,
        )
    )


STEPS = [36, 48]

if __name__ == "__main__":
    main()
