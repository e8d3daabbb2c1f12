//! The keys of a description.

/// The keys of a description, in any order.
#[derive(Debug)]
#[non_exhaustive]
pub struct Body {
    /// The documentation of the generated type, a string: `doc: "A thrown plank."`.
    pub doc: (),
    /// The coordinates of the body: `planar`, `planar_translation`, `spatial`, `translation` or
    /// `rotation`; for a held body `pivot(P)`, `fixed_point(P)` or `fixed_axis(P, direction)`, at
    /// the world's origin or `.at(world(..))`; for a slender rod `rod(direction)` with the
    /// direction of its axis in the body, such as `rod(body(1, 0, 0))`.
    pub motion: (),
    /// The mass: `1.2[kg]`, or an expression of params, of time and of user-defined states. With
    /// `inertia: compose([..])`, the parts give the mass.
    pub mass: (),
    /// The moments of inertia, about G in body axes unless `.about(P)` follows. In the plane, and
    /// for a rod, a scalar. In space `principal(a, b, c)`, `tensor { xx, yy, zz, xy, yz, zx }`
    /// (entries of the tensor, `xy = -∫xy dm`) or `products { .. }` (positive products of inertia,
    /// `xy = +∫xy dm`).
    ///
    /// Solids have the mass of the body, and z as their axis: `cuboid(a, b, c)`,
    /// `ellipsoid(a, b, c)`, `sphere(r)`, `shell(r)`, `cylinder(r, h)`, `tube(r1, r2, h)`,
    /// `cone(r, h)`, `torus(R, r)`, `disc(r)`, `rod(l)`. Rotate them by `.along(direction)` or
    /// `.turned(axis, angle)`. `compose([cylinder(r, h).mass(m).at(P), point(m).at(Q)])` gives
    /// mass, G and inertia together.
    pub inertia: (),
    /// Constants of the surrounding Rust code, of type `f64`: `[area = crate::AREA[m ^ 2]]`.
    pub constants: (),
    /// Functions of the surrounding Rust code, with the units of their arguments and values, and
    /// optionally with derivatives:
    /// `[lift(alpha) = crate::lift[N].derivatives(crate::lift_by_alpha)]`.
    pub functions: (),
    /// Constants of a run, with or without a default: `[arm = 0.17[m], gain]`.
    pub params: (),
    /// Quantities given at each evaluation: `[thrust[N], wind = world(_, _, _)[m / s]]`.
    pub inputs: (),
    /// User-defined states, scalars integrated with the motion: `[speed[rad / s], fuel[kg]]`.
    pub states: (),
    /// The time derivatives of the states: `[speed = (command - speed) / lag]`.
    pub rates: (),
    /// Points of the body, from G in body axes, or of space:
    /// `[tip = (0.3, 0, 0), hook = world(0, 0, 2)]`. `G` is predefined.
    pub points: (),
    /// External forces `F_ext`, at G unless `.at(P)` follows:
    /// `[lift = body(0, 0, thrust).at(front)]`.
    pub forces: (),
    /// External moments `M_ext`: `[drag = body(0, 0, -c * angular_velocity.in_body().z)]`.
    pub moments: (),
    /// Forces `F_s` that joints pass to this body, written like `forces`.
    pub joint_forces: (),
    /// Moments `M_s` that joints pass to this body, written like `moments`.
    pub joint_moments: (),
    /// Constraint loads `R_v` and `M_v` on this body: a force, at G unless `.at(P)` follows, or
    /// `moment(..)`. The compiler solves for components marked `_`:
    /// `[pin = world(_, _).at(hinge)]`.
    pub reactions: (),
    /// Loads of fields, `F_f` and `M_f`:
    /// `[weight = mass * world(0, 0, -9.80665[m / s ^ 2])]`; uniform fields on charges:
    /// `[electric = world(0, 0, 3)[V / m].on([q.at(tip)])]`.
    pub fields: (),
    /// Potentials U, scalars \[J\]; their forces and moments are derived, `F = -∂U/∂R`,
    /// `K = -∂U/∂φ`: `[spring = 20[N / m] * (tip.position() - hook.position()).norm_squared()]`.
    pub potentials: (),
    /// Expressions of positions or of velocities that the motion keeps at zero, each kept by an
    /// unknown reaction: `[floor = foot.position().in_world().z]`.
    pub constraints: (),
    /// The point about which the moment balance is written: `G` (the default), a point, or
    /// `world(..)`.
    pub pole: (),
    /// Named sub-expressions: `[twist = thrust_1 - thrust_2]`.
    pub locals: (),
    /// What to generate beyond the acceleration: `[energy, balance, reactions, linearization]`, ..
    pub outputs: (),
    /// Claims about this body, which fail the build if they are false:
    /// `[hover = (acceleration.norm() == 0).given(thrust = mass * g)]`.
    pub checks: (),
}

/// The keys of the description of a system, in any order.
#[derive(Debug)]
#[non_exhaustive]
pub struct System {
    /// The documentation of the generated type, a string.
    pub doc: (),
    /// `planar` for a system in the plane; omitted in space.
    pub motion: (),
    /// `zero_pose`: all bodies and joints are drawn in one frame, at zero coordinates.
    pub drawing: (),
    /// Constants of the surrounding Rust code, of type `f64`: `[area = crate::AREA[m ^ 2]]`.
    pub constants: (),
    /// Functions of the surrounding Rust code, with the units of their arguments and values, and
    /// optionally with derivatives:
    /// `[lift(alpha) = crate::lift[N].derivatives(crate::lift_by_alpha)]`.
    pub functions: (),
    /// Constants of a run, with or without a default: `[arm = 0.17[m], gain]`.
    pub params: (),
    /// Quantities given at each evaluation: `[torque[N * m]]`.
    pub inputs: (),
    /// User-defined states, scalars integrated with the motion: `[speed[rad / s], fuel[kg]]`.
    pub states: (),
    /// The time derivatives of the states: `[speed = (command - speed) / lag]`.
    pub rates: (),
    /// Names for expressions of the whole system: `[stretch = elbow.angle - rest]`.
    pub locals: (),
    /// A file in the Unified Robot Description Format, which gives bodies and joints:
    /// `"robot.urdf"`, with a path relative to the folder of `Cargo.toml`.
    pub urdf: (),
    /// A file in the format of `MuJoCo`, which gives bodies, joints, motors and gravity:
    /// `"model.xml"`, with a path relative to the folder of `Cargo.toml`.
    pub mjcf: (),
    /// Joints of the file that are locked at a coordinate: `[finger = 0.02[m]]`.
    pub locked: (),
    /// The bodies: `[arm { mass: 1[kg], inertia: principal(1, 2, 3), points: [tip = (1, 0, 0)] }]`,
    /// each with the keys of a body except `motion`; `copies: [x = body(1, 0, 0)]` makes a body
    /// along each direction.
    pub bodies: (),
    /// The joints, which carry the bodies: `[elbow = revolute(upper.tip, lower.hinge, body(0, 0,
    /// 1))]`, from a point of the carrier to a point of the carried body. Also `cable(P, Q, length,
    /// stiffness)`, which only pulls, and `link(P, Q, length)`, which keeps a distance.
    pub joints: (),
    /// Loads along the coordinates of joints: `[motor = torque.on(elbow)]`; inverse dynamics solves
    /// for those marked `_`.
    pub drives: (),
    /// Forces between points: `[spring = tension.between(upper.tip, lower.tip)]`, positive if they
    /// pull.
    pub forces: (),
    /// Moments on bodies and between them: `[load = moment(2[N * m]).on(arm)]`.
    pub moments: (),
    /// Loads of fields, on every body, with its own `mass`:
    /// `[weight = mass * world(0, 0, -9.80665[m / s ^ 2])]`.
    pub fields: (),
    /// Energies U, scalars \[J\], of joint coordinates and of positions and axes of bodies; their
    /// forces and moments are derived: `[coil = 0.5 * stiffness * elbow.angle.powi(2)]`.
    pub potentials: (),
    /// Expressions that the motion keeps at zero, across bodies:
    /// `[mesh = shaft.angle + 3 * axle.angle, rack = slide.position - 0.05[m] * pinion.angle]`.
    pub constraints: (),
    /// What to generate beyond the accelerations: `[energy, momentum, reactions, inverse]`.
    pub outputs: (),
    /// Claims about this system, which fail the build if they are false:
    /// `[rest = (elbow.angular_acceleration == 0).given(shoulder.angle = 90[deg])]`.
    pub checks: (),
}
