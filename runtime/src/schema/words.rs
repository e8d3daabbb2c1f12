//! The words of values: motions, joints, outputs, names, functions and methods.

use super::language;

language! {
    /// The motions of a body.
    Motions {
        "In a plane: position of G and an angle." planar;
        "In a plane, without rotation." planar_translation;
        "In space: position of G and attitude." spatial;
        "In space, without rotation." translation;
        "Rotation about G; G stays at the world's origin." rotation;
        "`pivot(P)`: in the plane, rotation about a held point." pivot;
        "`fixed_point(P)`: in space, rotation about a held point." fixed_point;
        "`fixed_axis(P, direction)`: in space, rotation about a held axis." fixed_axis;
        "`rod(direction)`: a slender rod, without rotation about its axis." rod;
    }
}

language! {
    /// The kinds of joints, between a point `P` of the carrier and a point `Q` of the carried body.
    Joints {
        "`revolute(P, Q, direction)`, in the plane `revolute(P, Q)`: a hinge." revolute;
        "`prismatic(P, Q, direction)`: a slide." prismatic;
        "`cylindrical(P, Q, direction)`: slides along and turns about a direction." cylindrical;
        "`pin_in_slot(P, Q, direction)`: in the plane, slides along a slot and turns." pin_in_slot;
        "`screw(P, Q, direction, pitch)`, with the pitch in meters per radian." screw;
        "`universal(P, Q, direction_1, direction_2)`: the first is fixed in the carrier." universal;
        "`spherical(P, Q)`: a ball joint." spherical;
        "`planar(P, Q, normal)`: slides across the normal and turns about it." planar;
        "`weld(P, Q)`: no motion." weld;
        "`free(body)`: no joint, with the coordinates of the body's G." free;
        "`rotation(body)`: rotation about G; G stays at the world's origin." rotation;
        "`translation(body)`: translation without rotation." translation planar_translation;
        "`cable(P, Q, length, stiffness)`: it only pulls." cable;
        "`link(P, Q, length)`: a massless rod, which keeps a distance." link;
    }
}

language! {
    /// The outputs of a body.
    Outputs {
        "Kinetic and potential energy." energy;
        "Linear and angular momentum." momentum;
        "The balances (1.3) and (1.4): loads and residuals." balance;
        "The unknown reactions." reactions;
        "The drives of a given motion." inverse;
        "The motion in closed form." flow;
        "The motion as a power series in time." taylor;
        "`x' = A x + B u`, in blocks." linearization;
        "The derivatives of the accelerations by the params." sensitivity;
        "The loads of a motion as linear functions of mass, first moment and inertia." regressor;
        "The accelerations as a `const fn` of arrays." constant;
    }
}

language! {
    /// The outputs of a system.
    SystemOutputs {
        "Kinetic and potential energy." energy;
        "Linear and angular momentum." momentum;
        "The balances (1.3) and (1.4) of each body: loads and residuals." balance;
        "The loads of the joints: `reactions`, or `reactions(elbow)` for named ones." reactions;
        "The drives of a given motion." inverse;
        "The motion in closed form." flow;
        "The motion as a power series in time." taylor;
        "The mass matrix." mass_matrix;
        "`jacobian(body.P)`: the velocity of a point by the rates of the joints." jacobian;
        "`x' = A x + B u`, in blocks." linearization;
        "The derivatives of the accelerations by the params." sensitivity;
        "The loads of a motion as linear functions of mass, first moment and inertia." regressor;
        "The accelerations as a `const fn` of arrays." constant;
    }
}

language! {
    /// The words that begin an expression.
    Words {
        "The time \\[s\\]." t;
        "The mass \\[kg\\]." mass;
        "The center of mass, a point." G;
        "The position of G \\[m\\]." position;
        "The velocity of G \\[m/s\\]." velocity;
        "The quaternion from body to world axes; in the plane the angle." attitude;
        "The angular velocity \\[rad/s\\]: a vector, in the plane a scalar." angular_velocity;
        "The acceleration of G \\[m/s²\\]." acceleration;
        "The angular acceleration \\[rad/s²\\]." angular_acceleration;
        "The unit vector along a rod." axis;
        "The rate of the unit vector along a rod \\[1/s\\]." axis_rate;
        "`world(x, y, z)`: a vector or a point by its components in world axes." world;
        "`body(x, y, z)`: a vector by its components in body axes." body;
        "`turned(axis, angle)`: the attitude of a claim." turned;
        "π" PI;
        "2 π" TAU;
        "`moment(vector)`: a moment, where a load can be a force or a moment." moment;
        "`table(x, [x_1, ..], [y_1, ..])`: interpolation in a table." table;
        "`principal(a, b, c)`: moments of inertia about the body axes." principal;
        "`tensor { xx, yy, zz, xy, yz, zx }`: entries of the tensor, `xy = -∫xy dm`." tensor;
        "`products { .. }`: positive products of inertia, `xy = +∫xy dm`." products;
        "`compose([..])`: mass, G and inertia from parts." compose;
        "`point(mass)`: a part without extent." point;
        "`cuboid(a, b, c)`, with edges along x, y and z." cuboid;
        "`ellipsoid(a, b, c)`, with semi-axes along x, y and z." ellipsoid;
        "`sphere(r)`: solid." sphere;
        "`shell(r)`: a hollow sphere with a thin wall." shell;
        "`cylinder(r, h)`, with its axis along z." cylinder;
        "`tube(r1, r2, h)`, with its axis along z." tube;
        "`cone(r, h)`, with its axis along z." cone;
        "`torus(R, r)`, with its axis along z." torus;
        "`disc(r)`: thin, with its axis along z." disc;
        "`rod(l)`: thin, along z." rod;
        "`drawing: zero_pose`: all bodies and joints are drawn in one frame." zero_pose;
        "An acceleration of which a claim says something." linear angular;
    }
}

language! {
    /// The words behind a dot.
    Members {
        "`b.body(x, y, z)`: a vector by its components in the axes of the body `b`." body;
        "A component." x y z;
        "A component of a quaternion." w i j k;
        "The center of mass, a point." G;
        "The mass \\[kg\\]." mass;
        "The position \\[m\\]." position;
        "The velocity \\[m/s\\]." velocity;
        "The acceleration \\[m/s²\\]." acceleration;
        "The attitude." attitude;
        "The angle \\[rad\\]." angle angle_1 angle_2;
        "The angular velocity \\[rad/s\\]." angular_velocity angular_velocity_1 angular_velocity_2;
        "The angular acceleration \\[rad/s²\\]."
            angular_acceleration angular_acceleration_1 angular_acceleration_2;
        "`vector.in_body()`: its components in body axes." in_body;
        "`vector.in_world()`: its components in world axes." in_world;
        "`a.cross(b)`" cross;
        "`a.dot(b)`" dot;
        "The length of a vector." norm;
        "The square of the length of a vector." norm_squared;
        "The direction of a vector." normalize;
        "A function of a scalar, as in Rust's `f64`."
            sqrt cbrt exp ln sin cos tan asin acos atan sinh cosh tanh abs signum floor ceil recip;
        "A function of two scalars, as in Rust's `f64`." atan2 powf hypot min max;
        "`x.powi(n)`, with a whole number." powi;
        "`x.clamp(low, high)`" clamp;
        "`force.at(P)`: the point of action." at;
        "`load.on(joint)`, `field.on([q.at(P)])`: what a load acts on." on;
        "`tension.between(P, Q)`, `moment(v).between(a, b)`: equal and opposite loads." between;
        "`joint.turned(..)`: the frame of the carried body at zero." turned;
        "`solid.along(direction)`: the direction of its axis." along;
        "`inertia.about(P)`: the point of reference." about;
        "`joint.driven(motion)`: a prescribed motion." driven;
        "`joint.armature(inertia)`: the inertia of a motor." armature;
        "`input.moving`: an input that is given with its rate and acceleration." moving;
        "`claim.given(name = value)`: the state of a claim." given;
        "A cubic table, instead of a linear one." cubic;
        "A table that goes on beyond its ends." extrapolated;
        "An acceleration of a claim." linear angular;
    }
}
