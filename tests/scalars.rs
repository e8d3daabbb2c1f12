//! Bodies that are generic over their scalar.

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::state::generic;
use newton_euler::{Dual, Scalar, prelude::*};

rigid_body!(Craft::<T> {
    doc: "Everything that a generic body can have.",
    motion: spatial,
    params: [
        arm = 0.17[m],
        drag_ratio = 0.016[m],
        wind = world(1, 0.5, -0.3)[m / s]
    ],
    inputs: [thrust[N], tilt],
    mass: 1.2[kg],
    inertia: tensor {
        xx: 0.0123,
        yy: 0.0131,
        zz: 0.0224,
        xy: 0.0005,
        yz: -0.0004,
        zx: 0.0002,
    }[kg * m ^ 2],
    points: [front = (arm, 0, 0)],
    locals: [relative = velocity - wind],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [
        lift = body(0, thrust * tilt.sin(), thrust * tilt.cos()).at(front),
        drag = -0.03 * relative.norm() * relative,
        push = if position.in_world().z < 0 && thrust > 0 {
            world(0, 0, 5)
        } else {
            world(0, 0, 0.5)
        },
    ],
    moments: [twist = body(0, 0, drag_ratio * thrust)],
    outputs: [energy, momentum, balance],
});

#[test]
fn single() {
    let body = Craft::<f32>::default();
    let state = generic::Spatial::<f32> {
        velocity: Vector3::new(1.0, 2.0, 3.0),
        ..Default::default()
    };
    let a = body.acceleration(
        0.0,
        &state,
        &CraftInput {
            thrust: 3.0,
            tilt: 0.1,
        },
    );
    let body = Craft::<f64>::default();
    let state = generic::Spatial::<f64> {
        velocity: Vector3::new(1.0, 2.0, 3.0),
        ..Default::default()
    };
    let b = body.acceleration(
        0.0,
        &state,
        &CraftInput {
            thrust: 3.0,
            tilt: 0.1,
        },
    );
    println!("{a:?} {b:?}");
    println!("{}", Craft::<f64>::EQUATIONS);
    let _ = (
        Quaternion::new(1.0, 0.0, 0.0, 0.0),
        UnitQuaternion::<f64>::identity(),
        Dual::<f64, 2>::variable(1.0, 1).sin(),
    );
}

#[test]
fn columns() {
    use newton_euler::columns::{Columns, Generic, Sink, Source};
    struct List(Vec<f64>);
    impl Source<f64> for List {
        fn take(&mut self) -> f64 {
            self.0.remove(0)
        }
    }
    impl Sink<f64> for List {
        fn put(&mut self, x: f64) {
            self.0.push(x)
        }
    }
    let body = Craft::<f64>::default();
    let mut list = List(vec![]);
    body.write(&mut list);
    println!("{:?} {}", list.0, <Craft<f64> as Columns<f64>>::COUNT);
    let again = <Craft<f64> as Columns<f64>>::read(&mut list);
    println!("{:?}", again);
    let _ = <Craft<f64> as Generic>::build(body.parameters()).unwrap();
}
