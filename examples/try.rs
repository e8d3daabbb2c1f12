//! try
use newton_euler::prelude::*;
use newton_euler::rigid_body;

rigid_body!(Quadrotor {
    doc: "A quadrotor in a plus configuration; rotors 1 and 3 spin about -z.",
    motion: spatial,
    params: [arm = 0.17[m], drag_ratio = 0.016[m]],
    inputs: [thrust_1[N], thrust_2[N], thrust_3[N], thrust_4[N]],
    mass: 1.2[kg],
    inertia: principal(0.0123, 0.0123, 0.0224)[kg * m ^ 2],
    points: [
        front = (arm, 0, 0),
        left = (0, arm, 0),
        back = (-arm, 0, 0),
        right = (0, -arm, 0),
    ],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift_1 = body(0, 0, thrust_1).at(front),
        lift_2 = body(0, 0, thrust_2).at(left),
        lift_3 = body(0, 0, thrust_3).at(back),
        lift_4 = body(0, 0, thrust_4).at(right),
    ],
    locals: [twist = thrust_1 - thrust_2 + thrust_3 - thrust_4],
    moments: [drag = body(0, 0, drag_ratio * twist)],
});

fn main() {
    let q = Quadrotor::default();
    let a = q.acceleration(0.0, &Spatial::default(), &QuadrotorInput::default());
    println!("{a:?}");
    println!("{}", Quadrotor::EQUATIONS);
}
