use newton_euler::prelude::*;

rigid_system!(Pair {
    motion: planar,
    bodies: [
        upper { mass: 2[kg], inertia: 1[kg * m ^ 2], points: [tip = (0, 1)[m]] },
        lower { mass: 2[kg], inertia: 1[kg * m ^ 2] },
    ],
    joints: [shoulder = revolute(world(0, 0), upper.G), elbow = revolute(upper.tip, lower.G)],
});

fn driven(_: &impl DrivenEnergy) {}
fn jacobian(_: &impl Jacobian) {}

fn main() {
    let (pair, state) = (Pair::default(), PairState::default());
    let acceleration = pair.acceleration(0.0, &state, &());
    let _ = pair.residual(0.0, &state, &acceleration, &(), &());
    let _ = pair.potential_energy(0.0, &state, &());
    let _ = pair.angular_momentum(&state);
    let _ = pair.reactions(0.0, &state, &());
    let _ = pair.inverse(0.0, &state, &acceleration, &());
    let _ = pair.inertial_parameters();
    let _ = pair.path(&state);
    let _ = pair.series::<5>(0.0, &state, &());
    let _ = pair.linearize(0.0, &state, &());
    let _ = pair.sensitivity(0.0, &state, &());
    let _ = pair.mass_matrix(0.0, &state, &());
    let _ = pair.jacobian(0.0, &state, &());
    driven(&pair);
    jacobian(&pair);
}
