"""Accelerations of the models of this folder by MuJoCo (pip install mujoco), for `reference.json`:

    python3 tests/mjcf/reference.py

MuJoCo gives the mass matrix, the forces that are not of constraints, and the Jacobians of the places
that are held together; contacts, limits and the softness of constraints are left out, and what holds is
solved for here. Of a free body its center of mass is told, as the systems have it.
"""

import json
import os

import mujoco
import numpy as np

FOLDER = os.path.dirname(os.path.abspath(__file__))
MODELS = ("arm", "quadruped", "swing", "linkage", "coupled", "classes")
LOCKED = {"swing": {"held": 0.05}}
NAMES = {"linkage": {"crank": "crank_joint"}, "swing": {"": "body_3_joint"}}
INPUTS = {
    "arm": ["pan_motor", "slip_motor"],
    "quadruped": ["thigh_1_motor", "motor_2"],
    "classes": (
        "law servo loose brake tuned strong firm slack paced inner same plain bare nearest beside reset braked".split()
    ),
    "coupled": (
        "turn servo squeeze spindle brake law pull haul shift still whirl pace push wind tighten".split()
    ),
}


def ends(model, data, closing):
    """The places on both bodies that a connection or a weld holds together."""
    is_weld = model.eq_type[closing] == mujoco.mjtEq.mjEQ_WELD
    places = []
    for body, at in zip((model.eq_obj1id[closing], model.eq_obj2id[closing]), (3, 0) if is_weld else (0, 3)):
        local = model.eq_data[closing][at : at + 3]
        places.append(data.xpos[body] + data.xmat[body].reshape(3, 3) @ local)
    return places


def is_turned(model, closing):
    """Whether a connection or a weld holds rotations: a weld does, unless it has no torque."""
    return model.eq_type[closing] == mujoco.mjtEq.mjEQ_WELD and model.eq_data[closing][10] != 0


def held(model, data, closing):
    """Jacobian, and what it gives without accelerations, of a connection or a weld."""
    first, second = model.eq_obj1id[closing], model.eq_obj2id[closing]
    size = model.nv
    is_weld = is_turned(model, closing)
    places = ends(model, data, closing)
    if is_weld:
        places[0] = places[1]
    rows, rates = [], []
    for body, place, sign in ((first, places[0], 1), (second, places[1], -1)):
        move, turn = np.zeros((3, size)), np.zeros((3, size))
        mujoco.mj_jac(model, data, move, turn, place, body)
        move_rate, turn_rate = np.zeros((3, size)), np.zeros((3, size))
        mujoco.mj_jacDot(model, data, move_rate, turn_rate, place, body)
        rows.append(sign * np.vstack([move, turn] if is_weld else [move]))
        rates.append(sign * np.vstack([move_rate, turn_rate] if is_weld else [move_rate]))
    return sum(rows), sum(rates) @ data.qvel


def coupled(model, data, closing):
    """Gap, Jacobian, and what it gives without accelerations, of joints or fixed tendons that follow others."""
    first, second = model.eq_obj1id[closing], model.eq_obj2id[closing]

    def length(number):
        row = np.zeros(model.nv)
        if model.eq_type[closing] == mujoco.mjtEq.mjEQ_JOINT:
            row[model.jnt_dofadr[number]] = 1
            at = model.jnt_qposadr[number]
            return data.qpos[at] - model.qpos0[at], row
        start = model.tendon_adr[number]
        for part in range(start, start + model.tendon_num[number]):
            row[model.jnt_dofadr[model.wrap_objid[part]]] = model.wrap_prm[part]
        return data.ten_length[number] - model.tendon_length0[number], row

    (own, row), (other, led) = length(first), length(second)
    polynomial = np.polynomial.Polynomial(model.eq_data[closing][:5])
    slope, bend = polynomial.deriv()(other), polynomial.deriv(2)(other)
    return own - polynomial(other), row - slope * led, -bend * (led @ data.qvel) ** 2


COUPLED = (int(mujoco.mjtEq.mjEQ_JOINT), int(mujoco.mjtEq.mjEQ_TENDON))


def assembled(model, data, closings):
    """Moves coordinates, then rates, to where what is held together is."""
    for _ in range(50):
        mujoco.mj_forward(model, data)
        gaps, rows = [], []
        for closing in closings:
            if int(model.eq_type[closing]) in COUPLED:
                gap, row, _ = coupled(model, data, closing)
                gaps.append([gap])
                rows.append(row[None, :])
                continue
            row, _ = held(model, data, closing)
            first, second = model.eq_obj1id[closing], model.eq_obj2id[closing]
            turns = [data.xmat[body].reshape(3, 3) for body in (first, second)]
            places = ends(model, data, closing)
            gaps.append(places[0] - places[1])
            if is_turned(model, closing):
                turn = np.zeros(9)
                mujoco.mju_quat2Mat(turn, model.eq_data[closing][6:10])
                off = turns[0] @ turn.reshape(3, 3) @ turns[1].T
                gaps.append(0.5 * np.array([off[2, 1] - off[1, 2], off[0, 2] - off[2, 0], off[1, 0] - off[0, 1]]))
            rows.append(row)
        step = -np.linalg.lstsq(np.vstack(rows), np.concatenate(gaps), rcond=None)[0]
        mujoco.mj_integratePos(model, data.qpos, step, 1.0)
        if np.abs(step).max() < 1e-15:
            break
    rows = np.vstack([kept(model, data, closing)[0] for closing in closings])
    data.qvel[:] -= np.linalg.lstsq(rows, rows @ data.qvel, rcond=None)[0]


def kept(model, data, closing):
    if int(model.eq_type[closing]) in COUPLED:
        _, row, rate = coupled(model, data, closing)
        return row[None, :], np.array([rate])
    return held(model, data, closing)


def accelerations(model, data, name):
    mujoco.mj_forward(model, data)
    size = model.nv
    mass = np.zeros((size, size))
    mujoco.mj_fullM(model, data, mass)
    force = data.qfrc_passive + data.qfrc_actuator - data.qfrc_bias
    free = np.array([i for i in range(size) if model.joint(model.dof_jntid[i]).name not in LOCKED.get(name, {})])
    closings = [i for i in range(model.neq) if model.eq_active0[i]]
    found = np.zeros(size)
    if closings:
        parts = [kept(model, data, closing) for closing in closings]
        rows, rates = np.vstack([part[0] for part in parts]), np.concatenate([part[1] for part in parts])
        count = len(rates)
        whole = np.block([[mass, rows.T], [rows, np.zeros((count, count))]])
        found[:] = np.linalg.solve(whole, np.concatenate([force, -rates]))[:size]
    else:
        found[free] = np.linalg.solve(mass[np.ix_(free, free)], force[free])
    return found


def told(model, data, name, found):
    """State and acceleration of each joint."""
    state, acceleration = {}, {}
    for number in range(model.njnt):
        joint = model.joint(number)
        if joint.name in LOCKED.get(name, {}):
            continue
        word = NAMES.get(name, {}).get(joint.name, joint.name)
        at, dof, kind = model.jnt_qposadr[number], model.jnt_dofadr[number], model.jnt_type[number]
        quaternion = lambda start: dict(zip("wxyz", data.qpos[start : start + 4].tolist()))
        if kind == mujoco.mjtJoint.mjJNT_FREE:
            body = model.jnt_bodyid[number]
            turn = data.xmat[body].reshape(3, 3)
            center, spin = model.body_ipos[body], data.qvel[dof + 3 : dof + 6]
            push, turned = found[dof : dof + 3], found[dof + 3 : dof + 6]
            cross = np.cross
            state[word] = {
                "position": (data.xpos[body] + turn @ center).tolist(),
                "attitude": quaternion(at + 3),
                "velocity": (data.qvel[dof : dof + 3] + turn @ cross(spin, center)).tolist(),
                "angular_velocity": spin.tolist(),
            }
            inner = cross(turned, center) + cross(spin, cross(spin, center))
            acceleration[word] = {"linear": (push + turn @ inner).tolist(), "angular": turned.tolist()}
        elif kind == mujoco.mjtJoint.mjJNT_BALL:
            state[word] = {"attitude": quaternion(at), "angular_velocity": data.qvel[dof : dof + 3].tolist()}
            acceleration[word] = found[dof : dof + 3].tolist()
        else:
            names = ("position", "velocity") if kind == mujoco.mjtJoint.mjJNT_SLIDE else ("angle", "angular_velocity")
            state[word] = dict(zip(names, (float(data.qpos[at]), float(data.qvel[dof]))))
            acceleration[word] = float(found[dof])
    return state, acceleration


def rows(name, random):
    model = mujoco.MjModel.from_xml_path(os.path.join(FOLDER, f"{name}.xml"))
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONTACT | mujoco.mjtDisableBit.mjDSBL_LIMIT
    model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CLAMPCTRL
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    closings = [i for i in range(model.neq) if model.eq_active0[i]]
    for _ in range(10):
        mujoco.mj_resetData(model, data)
        mujoco.mj_integratePos(model, data.qpos, random.uniform(-0.6, 0.6, model.nv), 1.0)
        data.qvel[:] = random.uniform(-1.5, 1.5, model.nv)
        data.ctrl[:] = random.uniform(-2, 2, model.nu)
        for joint, value in LOCKED.get(name, {}).items():
            data.qpos[model.joint(joint).qposadr] = value
            data.qvel[model.joint(joint).dofadr] = 0
        if closings:
            assembled(model, data, closings)
        found = accelerations(model, data, name)
        state, acceleration = told(model, data, name, found)
        inputs = dict(zip(INPUTS.get(name, []), data.ctrl.tolist()))
        yield {"state": state, "input": inputs, "acceleration": acceleration}


if __name__ == "__main__":
    generator = np.random.default_rng(5)
    whole = {name: list(rows(name, generator)) for name in MODELS}
    whole["origin"] = f"MuJoCo {mujoco.__version__}, by reference.py"
    with open(os.path.join(FOLDER, "reference.json"), "w", encoding="utf-8") as file:
        json.dump(whole, file, indent=1)
        file.write("\n")
