"""Writes src/wrenfold/generated.rs: the general body of benches/acceleration, as wrenfold derives and prints it.

pip install wrenfold==0.5.3 && python src/wrenfold/generate.py
"""

from pathlib import Path

import wrenfold as wf
from wrenfold import sym


def exact(*decimals):
    """Numbers in units of 1e-5."""
    return [sym.rational(round(decimal * 100000), 100000) for decimal in decimals]


MASS, GRAVITY = exact(3.2, 9.80665)
NOZZLE = sym.vector(*exact(0.1, -0.2, 0.05))
INERTIA = sym.matrix([exact(1.3, -0.12, 0.07), exact(-0.12, 1.7, -0.05), exact(0.07, -0.05, 2.1)])


def cross(a, b):
    return sym.vector(
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    )


def inverse(m):
    """By cofactors; the columns of m are a, b, c."""
    a, b, c = (sym.vector(m[0, j], m[1, j], m[2, j]) for j in range(3))
    rows = [cross(b, c), cross(c, a), cross(a, b)]
    volume = sum((a[i] * rows[0][i] for i in range(3)), sym.integer(0))
    return sym.matrix([[row[j] / volume for j in range(3)] for row in rows])


def turned(attitude, v):
    """v + w s + q x s with s = 2 q x v, for the unit quaternion of components x, y, z, w."""
    q = sym.vector(attitude[0], attitude[1], attitude[2])
    s = cross(q, v * 2)
    return v + s * attitude[3] + cross(q, s)


def acceleration(attitude: wf.Vector4, angular_velocity: wf.Vector3, force: wf.Vector3):
    w = angular_velocity
    moment = cross(NOZZLE, force) - cross(w, INERTIA * w)
    return [
        wf.OutputArg(turned(attitude, force / MASS) - sym.vector(0, 0, GRAVITY), name="linear"),
        wf.OutputArg(inverse(INERTIA) * moment, name="angular"),
    ]


if __name__ == "__main__":
    generated = wf.generate_function(acceleration, wf.RustGenerator())
    # as what it is compared with
    generated = generated.replace("#[inline]", "#[inline(always)]")
    Path(__file__).with_name("generated.rs").write_text(generated)
