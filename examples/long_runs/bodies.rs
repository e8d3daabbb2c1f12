//! The bodies, described; energy and momentum are what is watched.

use newton_euler::rigid_body;

rigid_body!(FreeBody {
    doc: "No load: `asymmetric_free` of the reference numbers.",
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    outputs: [energy, momentum, taylor],
});

rigid_body!(LagrangeTop {
    doc: "Symmetric, on its tip: `lagrange_nutation` of the reference numbers.",
    motion: fixed_point(tip),
    mass: 5[kg],
    inertia: principal(1, 1, 0.5)[kg * m ^ 2].about(tip),
    points: [tip = (0, 0, -0.1[m])],
    pole: tip,
    fields: [weight = mass * world(0, 0, -10[m / s ^ 2])],
    outputs: [energy, momentum, flow, taylor],
});

rigid_body!(HeavyTop {
    doc: "Not symmetric: its motion is chaotic, but keeps energy and vertical angular momentum.",
    motion: fixed_point(tip),
    mass: 5[kg],
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2].about(tip),
    points: [tip = (0, 0, -0.1[m])],
    pole: tip,
    fields: [weight = mass * world(0, 0, -2[m / s ^ 2])],
    outputs: [energy, momentum, taylor],
});
