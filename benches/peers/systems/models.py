"""The systems as trees of bodies, for the peers: read from `tests/reference/systems` and from the robots of the package
example-robot-data, written as the texts that each peer reads.
"""

import json
import re
from dataclasses import dataclass
from pathlib import Path

import numpy as np
import pinocchio

ROOT = Path(__file__).resolve().parents[3]
REFERENCE = ROOT / "tests" / "reference" / "systems"
ROBOTS = Path(pinocchio.__file__).parents[4] / "share" / "example-robot-data" / "robots"
AXES = {"X": [1, 0, 0], "Y": [0, 1, 0], "Z": [0, 0, 1]}


@dataclass
class Link:
    """A body and the joint that carries it; all in axes of the joint, at its origin."""

    kind: str  # hinge, ball, free
    carrier: int  # -1 is the ground
    axis: list
    rotation: np.ndarray
    place: np.ndarray
    mass: float
    center: np.ndarray
    tensor: np.ndarray  # about the center


@dataclass
class Tree:
    name: str
    gravity: list
    links: list
    # of a file: where the center of the free body itself is, without what is welded to it
    base: np.ndarray
    # the links in the order of the joints of our state
    order: list

    @property
    def sizes(self):
        """Of positions and of rates."""
        q = {"hinge": 1, "ball": 4, "free": 7}
        v = {"hinge": 1, "ball": 3, "free": 6}
        return sum(q[link.kind] for link in self.links), sum(v[link.kind] for link in self.links)


def reference(name):
    system = json.loads((REFERENCE / f"{name}.json").read_text())["system"]
    kinds = {"Spherical": "ball", "FreeFlyer": "free"}
    links = [
        Link(
            kinds.get(joint["type"], "hinge"),
            joint["parent"],
            AXES.get(joint["type"][-1], [0, 0, 0]),
            np.array(joint["R"], float),
            np.array(joint["p"], float),
            joint["inertia"]["m"],
            np.array(joint["inertia"]["c"], float),
            np.array(joint["inertia"]["Ic"], float),
        )
        for joint in system["joints"]
    ]
    return Tree(name, system["gravity"], links, np.zeros(3), list(range(len(links))))


def straight(matrix):
    """Right angles of a file are exact, as newton-euler reads them, so that nobody multiplies by their rounding."""
    size = abs(matrix).max()
    matrix = np.where(abs(matrix) < 1e-9 * size, 0, matrix)
    return np.where(abs(abs(matrix) - 1) < 1e-15, np.sign(matrix), matrix)


def robot(name, path, free=False, locked=()):
    """As Pinocchio reads the file: bodies that are welded are one."""
    model = pinocchio.buildModelFromUrdf(str(path), *[pinocchio.JointModelFreeFlyer()] * free)
    base = np.zeros(3)
    text = path.read_text()
    root = text[text.index("<link") : text.index("</link>")]
    if "<inertial>" in root:
        origin = root[root.index("<inertial>") :].split('xyz="', 1)[1].split('"')[0]
        base = np.array(origin.split(), float)
    if locked:
        ids = [model.getJointId(joint) for joint in locked]
        model = pinocchio.buildReducedModel(model, ids, pinocchio.neutral(model))
    kinds = {"FreeFlyer": "free"}
    # joints of a file are in its order, and what is written beside it comes after them
    joints = re.findall(r'<joint name="(\w+)" type="revolute"', text)
    order = [model.getJointId(joint) - 1 for joint in joints] + [0] * free
    links = []
    for k in range(1, model.njoints):
        word = model.joints[k].shortname().removeprefix("JointModel")
        axis = [0, 0, 0] if word in kinds else AXES[word[-1]]
        frame, inertia = model.jointPlacements[k], model.inertias[k]
        links.append(
            Link(
                kinds.get(word, "hinge"), model.parents[k] - 1, axis, straight(frame.rotation), frame.translation,
                inertia.mass, inertia.lever, straight(inertia.inertia),
            )
        )  # fmt: skip
    return Tree(name, [0, 0, -9.80665], links, base, order)


def chain(count):
    """General bodies, each turning about another axis; also as a file."""
    tensor = np.array([[0.012, 0.0005, 0.0003], [0.0005, 0.013, -0.0004], [0.0003, -0.0004, 0.004]])
    links = []
    for k in range(count):
        axis = list(AXES.values())[k % 3]
        place = np.array([0.01 * (k % 3), 0.02, 0.3]) if k else np.zeros(3)
        links.append(Link("hinge", k - 1, axis, np.eye(3), place, 1.4, np.array([0.01, -0.02, 0.14]), tensor))
    return Tree(f"chain{count}", [0, 0, -9.80665], links, np.zeros(3), list(range(count)))


FILES = {
    "panda": "panda_description/urdf/panda.urdf",
    "solo12": "solo_description/robots/solo12.urdf",
    "anymal": "anymal_b_simple_description/robots/anymal.urdf",
}


def lay(folder):
    """The robots' files, where `src/robots.rs` finds them."""
    for name, path in FILES.items():
        text = (ROBOTS / path).read_text()
        if name == "anymal":
            # its root has 1 mg and an inertia that no body has
            text = re.sub(r"<inertial>\s*<mass value=\"1e-6\"/>.*?</inertial>", "", text, count=1, flags=re.DOTALL)
        (folder / f"robot_{name}.urdf").write_text(text)


def all_of_them(folder):
    """In the order of `src/lib.rs`."""
    file = lambda name: folder / f"robot_{name}.urdf"
    return [
        reference("double_pendulum"),
        reference("furuta"),
        reference("ball_double"),
        reference("satellite3w"),
        reference("ur5"),
        robot("panda", file("panda"), locked=["panda_finger_joint1", "panda_finger_joint2"]),
        robot("solo12", file("solo12"), free=True),
        robot("anymal", file("anymal"), free=True),
        chain(CHAIN),
    ]


CHAIN = 60


def words(*values):
    return " ".join(repr(float(x)) for value in values for x in np.ravel(value))


def text(tree):
    """What `tree.hpp` reads."""
    lines = [str(len(tree.links)), words(tree.gravity)]
    for link in tree.links:
        numbers = words(link.axis, link.rotation, link.place, link.mass, link.center, link.tensor)
        lines.append(f"{link.kind} {link.carrier + 1} {numbers}")
    return "\n".join(lines) + "\n"


def quaternion(rotation):
    """The scalar first."""
    x, y, z, w = pinocchio.Quaternion(rotation).coeffs()
    return w, x, y, z


def mjcf(tree):
    """What MuJoCo reads."""

    def body(k):
        link = tree.links[k]
        t = link.tensor
        inertia = words([t[0, 0], t[1, 1], t[2, 2], t[0, 1], t[0, 2], t[1, 2]])
        joint = {
            "hinge": f'<joint type="hinge" axis="{words(link.axis)}"/>',
            "ball": '<joint type="ball"/>',
            "free": "<freejoint/>",
        }[link.kind]
        carried = "".join(body(j) for j, other in enumerate(tree.links) if other.carrier == k)
        return (
            f'<body pos="{words(link.place)}" quat="{words(quaternion(link.rotation))}">{joint}'
            f'<inertial pos="{words(link.center)}" mass="{link.mass!r}" fullinertia="{inertia}"/>{carried}</body>\n'
        )

    roots = "".join(body(k) for k, link in enumerate(tree.links) if link.carrier < 0)
    return (
        # impossible inertias of a file are taken as they are
        f'<mujoco><compiler balanceinertia="false" boundmass="0"/><option gravity="{words(tree.gravity)}">'
        f'<flag contact="disable" constraint="disable"/></option><worldbody>{roots}</worldbody></mujoco>'
    )


def rpy(rotation):
    return words(pinocchio.rpy.matrixToRpy(rotation))


def urdf(tree):
    """A file of hinges, for what reads no other."""
    lines = ['<robot name="tree">', '<link name="ground"/>']
    for k, link in enumerate(tree.links):
        t = link.tensor
        lines.append(
            f'<link name="body_{k}"><inertial><origin xyz="{words(link.center)}"/><mass value="{link.mass!r}"/>'
            f'<inertia ixx="{t[0, 0]!r}" iyy="{t[1, 1]!r}" izz="{t[2, 2]!r}" ixy="{t[0, 1]!r}" ixz="{t[0, 2]!r}" iyz="{t[1, 2]!r}"/>'
            "</inertial></link>"
        )
        carrier = f"body_{link.carrier}" if link.carrier >= 0 else "ground"
        lines.append(
            f'<joint name="joint_{k}" type="revolute"><parent link="{carrier}"/><child link="body_{k}"/>'
            f'<origin xyz="{words(link.place)}" rpy="{rpy(link.rotation)}"/><axis xyz="{words(link.axis)}"/>'
            '<limit lower="-10" upper="10" effort="1000" velocity="1000"/></joint>'
        )
    return "\n".join([*lines, "</robot>"]).replace("np.float64(", "").replace(")", "") + "\n"
