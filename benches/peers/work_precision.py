"""heyoka and MuJoCo on the problems of the example `work_precision`, one core, in the same columns:

    pip install heyoka mujoco
    taskset --cpu-list 0 python3 benches/peers/work_precision.py target/measures/peers.csv
    taskset --cpu-list 0 target/release/examples/work_precision --full target/measures/peers.csv

With the word `systems`, those alone; `--systems` tells the same to the example. Likewise `ensembles` and `--ensembles`.

heyoka: error control with its default order for each tolerance, `compact_mode` off, one integrator for all runs of a tolerance; building it
is not timed. In batches each member has its own steps. MuJoCo: fixed steps, what it can describe: bodies that turn freely or on
a ball joint, a hinge, and systems. What a call from Python costs without a step is taken off. Medians of rounds in which all are run in
turn. The equations of systems are those that one would write by hand, of the arm the articulated-body algorithm in symbols, in
`compact_mode`, which builds sooner and makes slower code.
"""

import itertools
import json
import sys
from importlib.metadata import version
from pathlib import Path
from statistics import median
from time import process_time

import heyoka as hy
import mujoco
import numpy as np

REFERENCE = Path(__file__).parents[2] / "tests" / "reference"
ROUNDS = 31
# no single time is taken over less; what takes longer is left out [s]
SHORTEST, LONGEST = 200e-6, 30e-3
TOLERANCES = [10 ** (-k / 2) for k in range(2, 32)]
MEMBERS = 8


# The equations, in symbols of heyoka; attitudes have the scalar first.


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def rotation(q):
    s, x, y, z = q
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - s * z), 2 * (x * z + s * y)],
        [2 * (x * y + s * z), 1 - 2 * (x * x + z * z), 2 * (y * z - s * x)],
        [2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y)],
    ]


def turning(q, w):
    s, x, y, z = q
    p, r, t = w
    return [
        -0.5 * (x * p + y * r + z * t),
        0.5 * (s * p + y * t - z * r),
        0.5 * (s * r + z * p - x * t),
        0.5 * (s * t + x * r - y * p),
    ]


def euler(inertia, moment, w):
    """Written out, the gyroscopic term by products: as few operations as there can be."""
    a, b, c = inertia
    gyroscopic = [(b - c) / a * (w[1] * w[2]), (c - a) / b * (w[2] * w[0]), (a - b) / c * (w[0] * w[1])]
    return [g if m is None else g + m / j for g, m, j in zip(gyroscopic, moment, inertia)]


def top(inertia, weight):
    """A body on a point, its weight times the distance to it along body z; without weight, free."""
    q, w = hy.make_vars(*"sxyz"), hy.make_vars("p", "r", "t")
    s, x, y, z = q
    moment = [2 * weight * (y * z + s * x), 2 * weight * (s * y - x * z), None] if weight else [None] * 3
    return list(zip([*q, *w], [*turning(q, w), *euler(inertia, moment, w)]))


def pendulum():
    angle, rate = hy.make_vars("angle", "rate")
    return [(angle, rate), (rate, -40 / 3 * hy.sin(angle))]


def flight(loads, mass, inertia):
    r, q, v, w = (hy.make_vars(*names) for names in [("rx", "ry", "rz"), "sxyz", ("vx", "vy", "vz"), ("p", "q", "t")])
    force, moment = loads(r, rotation(q), v, w)
    return list(zip([*r, *q, *v, *w], [*v, *turning(q, w), *[f / mass for f in force], *euler(inertia, moment, w)]))


def quadrotor():
    front, left, back, right = 3.1, 2.9, 3.0, 3.2
    rotors = [0.17 * (left - right), 0.17 * (back - front), 0.016 * (front - left + back - right)]

    def loads(r, axes, v, w):
        speed, lift = hy.sqrt(dot(v, v)), front + left + back + right
        force = [axes[i][2] * lift - 0.08 * speed * v[i] for i in range(3)]
        force[2] -= 1.2 * 9.80665
        return force, [m - 0.01 * rate for m, rate in zip(rotors, w)]

    return flight(loads, 1.2, [0.0123, 0.0117, 0.0224])


# Tolerances of heyoka are relative to the largest number of a state, so that numbers are to be of one size.
SATELLITE = np.repeat([7e6, 1.0, 7.5e3, 4e-3], [3, 4, 3, 3])


def in_units(units, equations):
    symbols = {symbol: float(unit) * symbol for (symbol, _), unit in zip(equations, units)}
    return [(symbol, hy.subs(rate, symbols) / float(unit)) for (symbol, rate), unit in zip(equations, units)]


def satellite():
    mu, mass, inertia = 3.986004418e14, 500.0, [120.0, 150.0, 90.0]

    def loads(r, axes, v, w):
        square = dot(r, r)
        cube = square**-1.5
        fifth = 3 * mu * cube / square
        n = [dot(r, [row[i] for row in axes]) for i in range(3)]
        turned = [j * x for j, x in zip(inertia, n)]
        radial = fifth * (2.5 * dot(n, turned) / square - 0.5 * sum(inertia)) - mu * mass * cube
        force = [radial * r[i] - fifth * dot(axes[i], turned) for i in range(3)]
        return force, [fifth * m for m in cross(n, turned)]

    return in_units(SATELLITE, flight(loads, mass, inertia))


# Systems, of `tests/reference/systems`.


def system(name):
    return json.loads((REFERENCE / "systems" / f"{name}.json").read_text())


def double_pendulum():
    one, two, v, w = hy.make_vars("one", "two", "v", "w")
    lower, across, gravity = 0.015 + 0.8 * 0.22**2, 0.8 * 0.6 * 0.22, 9.80665
    swept, mixed = across * hy.sin(two), lower + across * hy.cos(two)
    outer = 0.8 * 0.22 * gravity * hy.cos(one + two)
    inner = (1.2 * 0.28 + 0.8 * 0.6) * gravity * hy.cos(one)
    first, second = swept * w * (2 * v + w) - inner - outer, -swept * v * v - outer
    whole = 0.04 + 1.2 * 0.28**2 + 0.8 * 0.6**2 + lower + 2 * across * hy.cos(two)
    divisor = whole * lower - mixed * mixed
    return [(one, v), (two, w), (v, (lower * first - mixed * second) / divisor), (w, (whole * second - mixed * first) / divisor)]


WHEELS = np.repeat([0.02, 1.0, 2e3, 2e-3, 0.05, 200.0], [3, 4, 3, 3, 3, 3])


def wheels(drives):
    """A gyrostat: positions, attitude, angles, then velocities, of the hub and of the wheels."""
    r, q, angles = hy.make_vars("rx", "ry", "rz"), hy.make_vars(*"sxyz"), hy.make_vars("ax", "ay", "az")
    v, w, spins = hy.make_vars("vx", "vy", "vz"), hy.make_vars("p", "q", "t"), hy.make_vars("sx", "sy", "sz")
    spin, mass, wheel = 0.035, 132.0, 4.0
    center = np.full(3, 0.3 * wheel / mass)
    about = lambda arm: arm @ arm * np.eye(3) - np.outer(arm, arm)
    inertia = np.diag([12.0, 14.0, 9.0]) - mass * about(center)
    for axis in np.eye(3):
        inertia += np.diag(0.02 + (spin - 0.02) * axis) + wheel * about(0.3 * axis)
    inverse = np.linalg.inv(inertia - spin * np.eye(3))
    momentum = [dot(list(map(float, row)), w) + spin * s for row, s in zip(inertia, spins)]
    moment = [-g - u for g, u in zip(cross(w, momentum), map(float, drives))]
    angular = [dot(list(map(float, row)), moment) for row in inverse]
    center = list(map(float, center))
    swept = [a + b for a, b in zip(cross(angular, center), cross(w, cross(w, center)))]
    linear = [-dot(row, swept) for row in rotation(q)]
    driven = [float(u) / spin - a for u, a in zip(drives, angular)]
    equations = list(zip([*r, *q, *angles, *v, *w, *spins], [*v, *turning(q, w), *spins, *linear, *angular, *driven]))
    return in_units(WHEELS, equations)


def skew(a):
    x, y, z = a
    return np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]], dtype=object)


def arm(file, drives):
    """The articulated-body algorithm (R. Featherstone, Rigid Body Dynamics Algorithms, table 7.1), in blocks of three."""
    links = file["system"]["joints"]
    angles = hy.make_vars(*[f"angle_{k}" for k in range(len(links))])
    rates = hy.make_vars(*[f"rate_{k}" for k in range(len(links))])
    none = np.zeros(3, dtype=object)
    w, v, motions, known = none, none, [], []
    for link, angle, rate in zip(links, angles, rates):
        axis = np.array(["XYZ".index(link["type"][1]) == k for k in range(3)], dtype=object) * 1.0
        turn = np.outer(axis, axis) + hy.cos(angle) * (np.eye(3) - np.outer(axis, axis)) + hy.sin(angle) * skew(axis)
        back = (np.round(np.array(link["R"]), 12).astype(object) @ turn).T
        arm = np.array(link["p"], dtype=object)
        v = back @ (v + np.array(cross(w, arm)))
        w = back @ w
        spin = rate * axis
        swept = np.array(cross(w, spin)), np.array(cross(v, spin))
        w = w + spin
        mass, center = link["inertia"]["m"], skew(np.round(link["inertia"]["c"], 12).astype(object))
        a = np.array(link["inertia"]["Ic"], dtype=object) - mass * center @ center
        b, c = mass * center, mass * np.eye(3).astype(object)
        angular, linear = a @ w + b @ v, b.T @ w + c @ v
        bias = np.array(cross(w, angular)) + np.array(cross(v, linear)), np.array(cross(w, linear))
        motions.append((axis, back, arm, swept))
        known.append([a, b, c, *bias])
    solved = []
    for k in reversed(range(len(links))):
        axis, back, arm, (swept_w, swept_v) = motions[k]
        a, b, c, angular, linear = known[k]
        upper, lower = a @ axis, b.T @ axis
        inverse = 1.0 / (axis @ upper)
        rest = float(drives[k]) - axis @ angular
        solved.append((upper, lower, inverse, rest))
        if k:
            a, b, c = (x - inverse * np.outer(y, z) for x, y, z in [(a, upper, upper), (b, upper, lower), (c, lower, lower)])
            angular = angular + a @ swept_w + b @ swept_v + rest * inverse * upper
            linear = linear + b.T @ swept_w + c @ swept_v + rest * inverse * lower
            a, b, c = (back.T @ x @ back for x in [a, b, c])
            angular, linear, at = back.T @ angular, back.T @ linear, skew(arm)
            carried = [a + at @ b.T - b @ at - at @ c @ at, b + at @ c, c, angular + at @ linear, linear]
            known[k - 1] = [x + y for x, y in zip(known[k - 1], carried)]
    angular, linear, found = none, np.array([-x for x in file["system"]["gravity"]], dtype=object), []
    for (axis, back, arm, (swept_w, swept_v)), (upper, lower, inverse, rest) in zip(motions, reversed(solved)):
        linear = back @ (linear + np.array(cross(angular, arm))) + swept_v
        angular = back @ angular + swept_w
        found.append(inverse * (rest - upper @ angular - lower @ linear))
        angular = angular + found[-1] * axis
    return list(zip([*angles, *rates], [*rates, *found]))


def tree(file):
    """What MuJoCo reads."""
    links = file["system"]["joints"]
    words = lambda values: " ".join(repr(float(x)) for x in np.ravel(values))

    def body(k):
        link, inertia = links[k], links[k]["inertia"]
        turn, t = np.round(np.array(link["R"]), 12), np.array(inertia["Ic"])
        axis = words([letter == link["type"][1] for letter in "XYZ"])
        joint = "<freejoint/>" if link["type"] == "FreeFlyer" else f'<joint type="hinge" axis="{axis}"/>'
        carried = "".join(body(j) for j, other in enumerate(links) if other["parent"] == k)
        axes = words([turn[:, 0], turn[:, 1]])
        center, tensor = words(np.round(inertia["c"], 12)), words([t[0, 0], t[1, 1], t[2, 2]])
        return (
            f'<body pos="{words(link["p"])}" xyaxes="{axes}">{joint}'
            f'<inertial pos="{center}" mass="{inertia["m"]!r}" diaginertia="{tensor}"/>{carried}</body>'
        )

    return (
        f'<mujoco><option gravity="{words(file["system"]["gravity"])}"><flag contact="disable" constraint="disable"/></option>'
        f"<worldbody>{body(0)}</worldbody></mujoco>"
    )


# Starts and ends.


def numbers(values):
    return np.array([float(value) for value in values])


class Problem:
    """Equations, start, end and the places of what makes an error."""

    def __init__(self, name, equations, seconds, start, end, model=None, units=1.0):
        self.name, self.equations, self.seconds, self.model = name, equations, seconds, model
        self.start, self.end, self.units = numbers(start) / units, numbers(end) / units, units
        self.drives, self.settings, self.tolerances = 0.0, {}, TOLERANCES

    def error(self, state):
        if len(state) == 2:
            angle, rate = state - self.end
            return max(abs(angle / 2), abs(rate / self.end[1]))
        attitude, *vectors = [slice(0, 4), slice(4, 7)] if len(state) == 7 else [slice(3, 7), slice(0, 3), slice(7, 10), slice(10, 13)]
        q, right = state[attitude], self.end[attitude]
        errors = [np.linalg.norm(state[v] - self.end[v]) / np.linalg.norm(self.end[v]) for v in vectors]
        return max(min(abs(q - right).max(), abs(q + right).max()), *errors)


def relative(one, right):
    return np.linalg.norm(one - right) / np.linalg.norm(right)


class System(Problem):
    """Of hinges, or of a hub and its wheels."""

    # each takes up to half a minute of building
    def __init__(self, *words, drives=0.0, settings=()):
        super().__init__(*words)
        self.drives, self.settings, self.tolerances = drives, dict(settings), TOLERANCES[::4]

    def error(self, state):
        right = self.end
        if len(state) == 19:
            vectors = [slice(0, 3), slice(7, 10), slice(10, 13), slice(13, 16), slice(16, 19)]
            q = [min(abs(state[3:7] - right[3:7]).max(), abs(state[3:7] + right[3:7]).max())]
            return max(q + [relative(state[v], right[v]) for v in vectors])
        half = len(state) // 2
        return max(abs(state[:half] - right[:half]).max() / 2, relative(state[half:], right[half:]))


def systems():
    listed = lambda file: [float(x) for x in file["q"] + file["v"]]
    file = system("double_pendulum")
    last = file["trajectory"]
    yield System("double_pendulum", double_pendulum(), float(last["T"]), listed(file), listed(last), tree(file))

    def of_world(file):
        """The scalar first, and the velocity in world axes."""
        q, v = numbers(file["q"]), numbers(file["v"])
        attitude = q[[6, 3, 4, 5]]
        velocity = np.array(rotation(attitude)) @ v[:3]
        return [*q[:3], *attitude, *q[7:], *velocity, *v[3:]]

    file = system("satellite3w")
    last, drives = file["trajectory"], numbers(file["drives"])
    ends = of_world(file), of_world(last)
    yield System("satellite_wheels", wheels(drives[6:]), float(last["T"]), *ends, tree(file), WHEELS, drives=drives)
    file, last = system("ur5"), system("ur5_motion")
    drives = numbers(file["drives"])
    ends, compact = (listed(file), listed(last)), {"compact_mode": True}
    yield System("six_axis_arm", arm(file, drives), float(last["T"]), *ends, tree(file), drives=drives, settings=compact)


def problems():
    file = json.loads((REFERENCE / "trajectories.json").read_text())["problems"]
    flights = json.loads((REFERENCE / "flights.json").read_text())["problems"]
    for name in ["symmetric_free", "asymmetric_free", "dzhanibekov", "lagrange_nutation", "heavy_asym", "pendulum_planar"]:
        problem = file[name]
        end, seconds = (problem["at_T_10"], 10.0) if "at_T_10" in problem else (problem, problem["T"])
        weight = problem["k"] * problem["c"][2]
        start = problem["q0"] + problem["w0"]
        inertia = problem["I"]
        yield Problem(name, top(inertia, weight), seconds, start, end["q_ref"] + end["w_ref"], ball(inertia, weight))
    hanging = file["pendulum_planar"]
    yield Problem("pendulum", pendulum(), hanging["T"], [2.5, 0], [hanging["theta_T"], hanging["w_ref"][0]], hinge())
    for name, equations, units in [("quadrotor", quadrotor(), 1.0), ("satellite", satellite(), SATELLITE)]:
        flown = flights[name]
        yield Problem(name, equations, flown["T"], flown["start"], flown["end"], units=units)


# The programs. A run is a function; before it, what is taken off.


class Heyoka:
    def __init__(self, problem, tolerance):
        self.problem = problem
        self.integrator = hy.taylor_adaptive(problem.equations, problem.start, tol=tolerance, **problem.settings)

    def run(self, seconds=None):
        self.integrator.time = 0.0
        self.integrator.state[:] = self.problem.start
        self.integrator.propagate_until(self.problem.seconds if seconds is None else seconds)

    def idle(self):
        self.run(0.0)

    def error(self):
        self.run()
        return self.problem.error(self.integrator.state)


class Batch:
    """Several bodies, the k-th begins with an angular velocity greater by k/64n; the error is the greatest of them."""

    def __init__(self, problem, tolerance):
        self.problem = problem
        self.start = np.repeat(problem.start[:, None], MEMBERS, axis=1)
        self.start[4:] *= 1 + np.arange(MEMBERS) / MEMBERS / 64
        # registers of 256 bits are its default; those of 512 are faster where they have their full width
        self.integrator = hy.taylor_adaptive_batch(problem.equations, self.start, tol=tolerance, force_avx512=True)

    def run(self, seconds=None):
        self.integrator.set_time(0.0)
        self.integrator.state[:] = self.start
        self.integrator.propagate_until(self.problem.seconds if seconds is None else seconds)

    def idle(self):
        self.run(0.0)

    def error(self):
        self.run()
        first = self.problem.error(self.integrator.state[:, 0])
        others = [self.alone(k) for k in range(1, MEMBERS)]
        return max(first, *others)

    def alone(self, k):
        """The error of another member, by the same program with its smallest tolerance."""
        fine = hy.taylor_adaptive(self.problem.equations, self.start[:, k], tol=1e-17)
        fine.propagate_until(self.problem.seconds)
        right = Problem("", None, 0, self.start[:, k], fine.state)
        return right.error(self.integrator.state[:, k])


def model(joint, inertia, offset, mass, gravity):
    return f"""
    <mujoco>
      <option gravity="0 0 {-gravity}"><flag contact="disable"/></option>
      <worldbody><body>
        {joint}
        <inertial pos="0 0 {offset!r}" mass="{mass!r}" diaginertia="{' '.join(map(repr, inertia))}"/>
      </body></worldbody>
    </mujoco>"""


def ball(inertia, weight):
    """A heavy body near its support: of its inertia little is due to the distance."""
    mass, gravity = 1000.0, 10.0 if weight else 0.0
    offset = weight / (mass * 10.0)
    a, b, c = inertia
    steiner = mass * offset**2
    return model('<joint type="ball"/>', [a - steiner, b - steiner, c], offset, mass, gravity)


def hinge():
    return model('<joint type="hinge" axis="1 0 0"/>', [0.14, 0.14, 0.1], -0.4, 1.0, 10.0)


class MuJoCo:
    def __init__(self, problem, integrator, steps):
        self.problem, self.steps = problem, steps
        self.model = mujoco.MjModel.from_xml_string(problem.model)
        self.model.opt.integrator = integrator
        self.model.opt.timestep = problem.seconds / steps
        self.data = mujoco.MjData(self.model)

    def set(self):
        self.data.time = 0.0
        start = self.problem.start * self.problem.units
        self.data.qpos[:], self.data.qvel[:] = start[: self.model.nq], start[self.model.nq :]
        self.data.qfrc_applied[:] = self.problem.drives

    def run(self):
        self.set()
        mujoco.mj_step(self.model, self.data, nstep=self.steps)

    def idle(self):
        self.set()

    def error(self):
        self.run()
        return self.problem.error(np.concatenate([self.data.qpos, self.data.qvel]) / self.problem.units)


# Times.


def time(run, repeats):
    start = process_time()
    for _ in range(repeats):
        run()
    return (process_time() - start) / repeats


def swept(method, make, efforts):
    """Runs from coarse to fine, until they take too long or errors fall no more."""
    best, since = float("inf"), 0
    for effort in efforts:
        run = make(effort)
        error = run.error()
        seconds = min(time(run.run, 1) for _ in range(3))
        if error < 1:
            yield method, effort, run, error, max(1, int(SHORTEST / seconds))
        since = 0 if error < 0.7 * best else since + 1
        best = min(best, error)
        if seconds > LONGEST or (best < 1e-8 and since >= 4):
            return


def measured(name, share, runs, write):
    """All in turn; `share` simulated seconds of bodies are in each."""
    runs = list(runs)
    times = [[] for _ in runs]
    for _ in range(ROUNDS):
        for (_, _, run, _, repeats), collected in zip(runs, times):
            collected.append(time(run.run, repeats) - time(run.idle, repeats))
    for (method, effort, _, error, _), collected in zip(runs, times):
        write(f'"{name}","{method}",{effort:e},{median(collected) * 1e9 / share:.3f},{error:.3e}')


def main(path, only=None):
    # of steps that are too long MuJoCo warns; they are left out
    mujoco.set_mju_user_warning(lambda _: None)
    lines = ["problem,method,effort,ns_per_second,error"]
    print(f"heyoka {version('heyoka')}, lanes for doubles here: {hy.recommended_simd_size(float)}; MuJoCo {mujoco.__version__}")
    steps = [s for k in range(2, 22) for s in (1 << k, 3 << (k - 1))]
    integrators = [("MuJoCo, RK4", mujoco.mjtIntegrator.mjINT_RK4), ("MuJoCo, implicitfast", mujoco.mjtIntegrator.mjINT_IMPLICITFAST)]
    bodies = [] if only == "systems" else problems()
    for problem in bodies if only == "ensembles" else itertools.chain(systems(), bodies):
        is_batched = problem.name in ["lagrange_nutation", "heavy_asym"]
        if is_batched:
            batches = swept(f"heyoka, {MEMBERS} in a batch", lambda tolerance: Batch(problem, tolerance), TOLERANCES)
            name = f"{problem.name}, ensembles"
            measured(name, problem.seconds * MEMBERS, batches, lines.append)
        if only == "ensembles":
            continue
        runs = [swept("heyoka", lambda tolerance: Heyoka(problem, tolerance), problem.tolerances)]
        if problem.model:
            for name, integrator in integrators:
                runs.append(swept(name, lambda count, integrator=integrator: MuJoCo(problem, integrator, count), steps))
        measured(problem.name, problem.seconds, itertools.chain(*runs), lines.append)
        print(f"{problem.name}: done")
    Path(path).parent.mkdir(parents=True, exist_ok=True)
    Path(path).write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
