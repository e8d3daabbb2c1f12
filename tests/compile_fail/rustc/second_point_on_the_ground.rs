use newton_euler::rigid_system;

// written the other way round, and beside a mistake that is one of its own
rigid_system!(FourBar {
    motion: planar,
    bodies: [
        crank { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [o = (-0.05, 0), a = (0.05, 0)] },
        coupler { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [a = (-0.175, 0), b = (0.175, 0)] },
        rocker { mass: 1[kg], inertia: 1[kg * m ^ 2], points: [b = (0.125, 0), c = (-0.125, 0)] },
    ],
    joints: [
        o = revolute(world(0, 0), crank.o),
        a = revolute(crank.a, coupler.a),
        b = revolute(coupler.b, rocker.b),
        c = revolute(rocker.c, world(0.3, 0)),
    ],
});

fn main() {
    use newton_euler::prelude::*;
    fn closes<B: Constrained>(_: &B) {}
    closes(&FourBar);
    let _ = FourBar.acceleration(0.0, &FourBarState::default(), &());
}
