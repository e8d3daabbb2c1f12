"""Accelerations of systems beside those of Pinocchio, of CasADi's code, of MuJoCo and of dynibo, in one process on one core:

    pip install pin casadi mujoco example-robot-data==6.0.0
    taskset --cpu-list 0 python3 benches/peers/systems/compare.py

All are checked for the same accelerations in the same states, then timed in turn in short batches; the least time of each counts, since
other work on the machine only adds. Of names of systems as words, only these. `--motions` times `integrate` and an
ensemble in a build without flags beside a native one; `--build` builds what is timed first, which takes some minutes; `generated/` has the C that CasADi
wrote, except for the long chain.
"""

import ctypes
import os
import subprocess
import sys
from importlib.metadata import version
from pathlib import Path

import casadi
import mujoco
import numpy as np
import pinocchio

import models

HERE = Path(__file__).resolve().parent
TARGET = models.ROOT / "target"
BUILT = TARGET / "peers"
STATES = 16
# ns of a batch, batches
BATCH, BATCHES = 100e3, 400


def build():
    """All libraries, by the compilers that are there."""
    BUILT.mkdir(parents=True, exist_ok=True)
    models.lay(BUILT)
    prefix = Path(pinocchio.__file__).parents[4]
    boost = ["-DBOOST_MPL_LIMIT_LIST_SIZE=30", "-DBOOST_MPL_CFG_NO_PREPROCESSED_HEADERS"]
    symbols, engine = Path(casadi.__file__).parent, Path(mujoco.__file__).parent
    includes = [f"-I{prefix}/include", f"-I{symbols}/include", f"-I{symbols}/include/eigen3"]
    linked = [f"-L{symbols}", "-lcasadi", f"-Wl,-rpath,{symbols}"]
    native = ["-O3", "-march=native", "-DNDEBUG", "-w", "-shared", "-fPIC"]

    def run(*words, **settings):
        subprocess.run([str(word) for word in words], check=True, **settings)

    run("g++", "-std=c++17", "-O1", "-w", *boost, *includes, HERE / "casadi.cpp", "-o", BUILT / "casadi", *linked)
    run("g++", "-std=c++17", *native, *boost, *includes, HERE / "pinocchio.cpp", "-o", BUILT / "libpinocchio.so")
    library = next(engine.glob("libmujoco.so.*"))
    run("gcc", *native, f"-I{engine}/include", HERE / "mujoco.c", "-o", BUILT / "libmujoco.so", library, f"-Wl,-rpath,{engine}")
    for tree in models.all_of_them(BUILT):
        name = tree.name
        (BUILT / f"{name}.txt").write_text(models.text(tree))
        (BUILT / f"{name}.xml").write_text(models.mjcf(tree))
        (BUILT / f"{name}.urdf").write_text(models.urdf(tree))
        kept = HERE / "generated" / f"{name}.c"
        if not kept.exists():
            kept = BUILT / f"{name}.c"
            run(BUILT / "casadi", f"{name}.txt", name, cwd=BUILT)
        run("gcc", *native, f"-DNAME={name}", HERE / "generated.c", kept, "-lm", "-o", BUILT / f"lib{name}.so")
    for target, flags in [(TARGET, ""), (TARGET / "native", "-C target-cpu=native")]:
        settings = {"CARGO_TARGET_DIR": str(target), "RUSTFLAGS": flags}
        run("cargo", "build", "--release", cwd=HERE, env=os.environ | settings)


# Numbers of states.


def rotation(q):
    """Of a quaternion with the scalar last."""
    return pinocchio.Quaternion(*(float(q[k]) for k in [3, 0, 1, 2])).matrix()


class States:
    """Random states of a tree, as Pinocchio has them: of free and ball joints velocities in body axes; with drives."""

    def __init__(self, tree, seed=1):
        random = np.random.default_rng(seed)
        nq, nv = tree.sizes
        self.tree = tree
        self.q = np.zeros((STATES, nq))
        self.v = random.uniform(-2, 2, (STATES, nv))
        self.drives = random.uniform(-0.5, 0.5, (STATES, nv))
        for q in self.q:
            for kind, at, _ in self.parts():
                if kind == "free":
                    q[at : at + 3] = random.uniform(-1, 1, 3)
                    at += 3
                if kind == "hinge":
                    q[at] = random.uniform(-1.5, 1.5)
                else:
                    attitude = random.normal(size=4)
                    q[at : at + 4] = attitude / np.linalg.norm(attitude)
        for kind, _, at in self.parts():
            if kind != "hinge":
                self.drives[:, at : at + (6 if kind == "free" else 3)] = 0
        if len(tree.links) == models.CHAIN or tree.name == "double_pendulum":
            self.drives[:] = 0
        if tree.name == "furuta":
            self.drives[:, 1] = 0

    def parts(self):
        """Each joint with where its positions and its rates begin."""
        q, v = 0, 0
        for link in self.tree.links:
            yield link.kind, q, v
            q += {"hinge": 1, "ball": 4, "free": 7}[link.kind]
            v += {"hinge": 1, "ball": 3, "free": 6}[link.kind]

    def of_a_free_base(self, accelerations, place):
        """What Pinocchio calls the acceleration of a free base, as that of one of its points, in world axes."""
        found = accelerations.copy()
        if self.tree.links[0].kind == "free":
            for q, v, a in zip(self.q, self.v, found):
                w, angular = v[3:6], a[3:6].copy()
                at = a[:3] + np.cross(w, v[:3]) + np.cross(angular, place) + np.cross(w, np.cross(w, place))
                a[:3] = rotation(q[3:7]) @ at
        return found

    def ours(self):
        """Coordinates; a free body's are of its center, in world axes."""
        q, v = self.q.copy(), self.v.copy()
        if self.tree.links[0].kind == "free":
            for p, rate in zip(q, v):
                turn, center = rotation(p[3:7]), self.tree.base
                rate[:3] = turn @ (rate[:3] + np.cross(rate[3:6], center))
                p[:3] += turn @ center
        return np.ascontiguousarray(np.hstack([q[:, self.places(0)], v[:, self.places(1)]]))

    def places(self, which):
        """Where the positions (0) or rates (1) of our joints are, in the order of our state."""
        starts = [part[1:][which] for part in self.parts()] + [self.tree.sizes[which]]
        return [place for k in self.tree.order for place in range(starts[k], starts[k + 1])]

    def mujoco(self):
        """The scalar first; the velocity of a free body in world axes."""
        q, v = self.q.copy(), self.v.copy()
        for kind, at, rate in self.parts():
            if kind == "free":
                for p, x in zip(self.q, v):
                    x[:3] = rotation(p[3:7]) @ x[:3]
                at += 3
            if kind != "hinge":
                q[:, at : at + 4] = self.q[:, [at + 3, at, at + 1, at + 2]]
        return q, v


# The programs.


def pointer(numbers):
    return numbers.ctypes.data_as(ctypes.POINTER(ctypes.c_double))


def library(path):
    loaded = ctypes.CDLL(str(path))
    for name in ["run", "acceleration", "integrate", "ensemble"]:
        if hasattr(loaded, name):
            getattr(loaded, name).restype = ctypes.c_double
    if hasattr(loaded, "make"):
        loaded.make.restype = ctypes.c_void_p
    return loaded


class Ours:
    def __init__(self, states, place, target):
        self.states, self.place = states, place
        self.library = library(target / "release" / "libnewton_euler_peers_systems.so")
        self.numbers, self.found = states.ours(), np.zeros_like(states.v)
        self.drives = np.ascontiguousarray(states.drives[:, states.places(1)])

    def run(self, rounds):
        lists = pointer(self.numbers), pointer(self.drives), pointer(self.found)
        return self.library.acceleration(ctypes.c_size_t(self.place), ctypes.c_size_t(STATES), *lists, ctypes.c_size_t(rounds))

    def integrate(self, rounds):
        """The ns of a motion of 0.05 s from the first state, by the default method and tolerance."""
        lists = pointer(self.numbers), pointer(self.drives)
        return self.library.integrate(ctypes.c_size_t(self.place), *lists, ctypes.c_size_t(rounds)) / rounds

    def operations(self):
        counts = (ctypes.c_uint32 * 5)()
        self.library.operations(ctypes.c_size_t(self.place), counts)
        return list(counts)

    def right(self, accelerations):
        right = self.states.of_a_free_base(accelerations, self.states.tree.base)
        return right[:, self.states.places(1)]


class Pinocchio:
    def __init__(self, states, in_world):
        self.states, self.in_world = states, in_world
        self.library = library(BUILT / "libpinocchio.so")
        self.made = ctypes.c_void_p(self.library.make(str(BUILT / f"{states.tree.name}.txt").encode()))
        self.found = np.zeros_like(states.v)

    def run(self, rounds):
        states = self.states
        lists = [pointer(x) for x in [states.q, states.v, states.drives, self.found]]
        return self.library.run(self.made, self.in_world, STATES, *lists, rounds)

    def right(self, accelerations):
        return accelerations


class CasADi:
    def __init__(self, states):
        self.states = states
        self.library = library(BUILT / f"lib{states.tree.name}.so")
        self.found = np.zeros_like(states.v)

    def run(self, rounds):
        states = self.states
        lists = [pointer(x) for x in [states.q, states.v, states.drives, self.found]]
        return self.library.run(*states.tree.sizes, STATES, *lists, rounds)

    def operations(self):
        """mul, add, div, sqrt, trig of the C."""
        name = f"{self.states.tree.name}.c"
        kept = HERE / "generated" / name
        text = (kept if kept.exists() else BUILT / name).read_text()
        text = text[text.index("casadi_f0(") :]
        lines = [line.split("=", 1)[1] for line in text.split("\n") if line.startswith("  a") and "=" in line]
        lines = [line for line in lines if "arg[" not in line]
        # `a=(-b)` is folded into what reads it
        signs = ["*", "+", "/", "sqrt(", "sin(", "cos("]
        counts = [sum(sign in line for line in lines) for sign in signs]
        counts[1] += sum("-a" in line and not line.startswith("(-") for line in lines)
        counts[0] += sum("casadi_sq(" in line for line in lines)
        return [*counts[:4], counts[4] + counts[5]]

    def right(self, accelerations):
        return accelerations


class MuJoCo:
    def __init__(self, states):
        self.states = states
        self.library = library(BUILT / "libmujoco.so")
        self.made = ctypes.c_void_p(self.library.make(str(BUILT / f"{states.tree.name}.xml").encode()))
        self.q, self.v = states.mujoco()
        self.found = np.zeros_like(states.v)

    def run(self, rounds):
        lists = [pointer(x) for x in [self.q, self.v, self.states.drives, self.found]]
        return self.library.run(self.made, STATES, *lists, rounds)

    def right(self, accelerations):
        return self.states.of_a_free_base(accelerations, np.zeros(3))


class Dynibo:
    """What it falls by is fixed: it is checked with that."""

    def __init__(self, states):
        self.states = states
        self.library = library(TARGET / "release" / "libnewton_euler_peers_systems.so")
        self.made = ctypes.c_void_p(self.library.make(str(BUILT / f"{states.tree.name}.urdf").encode()))
        self.found = np.zeros_like(states.v)

    def run(self, rounds):
        states = self.states
        lists = [pointer(x) for x in [states.q, states.v, states.drives, self.found]]
        return self.library.run(self.made, ctypes.c_size_t(STATES), *lists, ctypes.c_size_t(rounds))

    def right(self, _):
        model = pinocchio.buildModelFromUrdf(str(BUILT / f"{self.states.tree.name}.urdf"))
        model.gravity.linear = np.array([0, 0, -9.80665])
        data = model.createData()
        states = zip(self.states.q, self.states.v, self.states.drives)
        return np.array([pinocchio.aba(model, data, q, v, drives) for q, v, drives in states])


# The table.


def programs(place, tree):
    states = States(tree)
    yield "ours", Ours(states, place, TARGET)
    yield "ours, native", Ours(states, place, TARGET / "native")
    yield "CasADi", CasADi(states)
    yield "ABA, body axes", Pinocchio(states, 0)
    yield "ABA, world axes", Pinocchio(states, 1)
    yield "mj_forward", MuJoCo(states)
    if all(link.kind == "hinge" for link in tree.links):
        yield "dynibo", Dynibo(states)


def checked(all_of_tree):
    """The largest difference of each from Pinocchio's, over the largest acceleration of the state."""
    reference = all_of_tree["ABA, body axes"]
    reference.run(1)
    for name, program in all_of_tree.items():
        right = program.right(reference.found)
        program.run(1)
        size = abs(right).max(axis=1, keepdims=True)
        yield name, (abs(program.found - right) / size).max()


def timed(all_of_tree):
    """The least ns of one acceleration, of batches in turn."""
    rounds = {name: max(1, int(BATCH / program.run(1))) for name, program in all_of_tree.items()}
    least = dict.fromkeys(all_of_tree, float("inf"))
    for _ in range(BATCHES):
        for name, program in all_of_tree.items():
            least[name] = min(least[name], program.run(rounds[name]) / rounds[name] / STATES)
    return least


def over_native(runs):
    """The least times of the two builds, in turn, and their ratio."""
    least = [float("inf")] * 2
    for _ in range(BATCHES // 4):
        least = [min(time, run()) for time, run in zip(least, runs)]
    return f"{least[0]:.0f} and {least[1]:.0f} ns: {least[0] / least[1]:.2f}"


def motions(trees):
    """What a build without flags takes over a native one."""
    for place, tree in enumerate(trees):
        builds = [Ours(States(tree), place, target) for target in [TARGET, TARGET / "native"]]
        rounds = max(1, int(BATCH / builds[0].integrate(2)))
        print(f"integrate, {tree.name}: " + over_native([lambda b=b: b.integrate(rounds) for b in builds]))
    print("a step of an ensemble of arms: " + over_native([build.library.ensemble for build in builds]))


def counted(counts):
    mul, add, div, sqrt, trig = counts
    return f"{mul + add + div + sqrt} + {trig}"


def main(words):
    if "--build" in words:
        build()
    processor = next(line.split(":")[1].strip() for line in open("/proc/cpuinfo") if line.startswith("model name"))
    names = ["pin", "casadi", "mujoco"]
    print(f"{processor}; " + ", ".join(f"{name} {version(name)}" for name in names))
    rows, trees = [], models.all_of_them(BUILT)
    if "--motions" in words:
        return motions(trees)
    for place, tree in enumerate(trees):
        if words and not words[0].startswith("-") and tree.name not in words:
            continue
        all_of_tree = dict(programs(place, tree))
        differences = dict(checked(all_of_tree))
        print(f"\n{tree.name}: " + ", ".join(f"{name} {value:.0e}" for name, value in differences.items()))
        assert all(value < 1e-9 for value in differences.values()), "these are not the same accelerations"
        least = timed(all_of_tree)
        print("  " + ", ".join(f"{name} {value:.1f}" for name, value in least.items()))
        rows.append((tree.name, all_of_tree, least))
    print("\n| system | operations + sines and cosines, ours | CasADi | " + " | ".join(["ours", "native", "CasADi", "Pinocchio", "MuJoCo", "dynibo"]) + " | over CasADi | over Pinocchio |")
    for name, all_of_tree, least in rows:
        aba = min(least["ABA, body axes"], least["ABA, world axes"])
        ours, native, generated = least["ours"], least["ours, native"], least["CasADi"]
        columns = [ours, native, generated, aba, least["mj_forward"]]
        numbers = " | ".join(f"{x:.1f}" if x < 100 else f"{x:.0f}" for x in columns)
        dynibo = f"{least['dynibo']:.0f}" if "dynibo" in least else ""
        print(f"| {name} | {counted(all_of_tree['ours'].operations())} | {counted(all_of_tree['CasADi'].operations())} | {numbers} | {dynibo} | {native / generated:.2f} | {native / aba:.3f} |")


if __name__ == "__main__":
    main(sys.argv[1:])
