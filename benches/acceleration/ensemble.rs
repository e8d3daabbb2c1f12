//! Many bodies at a time: an ensemble, compared with nalgebra in a loop over an array of structs.

use std::hint::black_box;

use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::ensemble::Ensemble;
use newton_euler::lanes::Width;
use newton_euler::prelude::*;

use crate::bodies::{General, GeneralInput};
use crate::by_hand::{Space, full};
use crate::memory::bandwidth;
use crate::paired::paired;
use crate::table::{Table, Traffic};

/// The number of bodies, and where they fit on a processor with 32 to 48 KB, 1 MB and 32 MB of
/// cache.
const SIZES: [(u32, &str); 4] = [
    (1 << 7, "L1"),
    (1 << 11, "L2"),
    (1 << 15, "L3"),
    (1 << 19, "memory"),
];

/// The bytes per body that are moved to or from memory: attitude, angular velocity and force are
/// read, and the acceleration is written.
const OURS: usize = 8 * (4 + 3 + 3 + 6);

/// The same for an array of structs: what is not read is in the same cache lines.
const BY_HAND: usize =
    size_of::<Spatial>() + size_of::<Vector3<f64>>() + size_of::<SpatialAcceleration>();

fn state(x: f64) -> Spatial {
    Spatial {
        position: Vector3::new(x.sin(), x.cos(), 0.3),
        attitude: UnitQuaternion::new_normalize(Quaternion::new(1.0, x.sin(), x.cos(), 0.2)),
        velocity: Vector3::new(1.0, x.sin(), 0.0),
        angular_velocity: Vector3::new(x.cos(), 1.0, x.sin()),
    }
}

fn force(x: f64) -> Vector3<f64> {
    Vector3::new(1.0, (x * 0.3).sin(), 9.0)
}

pub fn measure(table: &mut Table) {
    for (count, place) in SIZES {
        of_size(table, count, place);
    }
}

/// All members, in every width that the processor has.
fn of_size(table: &mut Table, count: u32, place: &str) {
    let xs = || (0..count).map(|i| f64::from(i) * 0.37);
    let loop_by_hand = Loop {
        body: Space::new(full()),
        states: xs().map(state).collect(),
        forces: xs().map(force).collect(),
    };
    let mut ensemble = Ensemble::new(&General::<f64>::default(), xs().map(state));
    for (index, &force) in loop_by_hand.forces.iter().enumerate() {
        ensemble.inputs_mut().set(index, &GeneralInput { force });
    }

    let mut ours = ensemble.accelerations(0.0);
    let mut by_hand = vec![SpatialAcceleration::default(); ensemble.len()];
    loop_by_hand.accelerate(&mut by_hand);
    for (one, other) in ours.iter().zip(&by_hand) {
        let distance = (one.linear - other.linear).norm() + (one.angular - other.angular).norm();
        assert!(distance < 1e-13, "the two differ by {distance:e}");
    }

    let traffic = Traffic {
        bytes: [OURS, BY_HAND],
        bandwidth: bandwidth(OURS * ensemble.len()),
    };
    for width in Width::ALL.into_iter().filter(|width| width.is_there()) {
        ensemble.set_width(width);
        let times = paired(
            count,
            || {
                black_box(&ensemble).accelerate(0.0, &mut ours);
                black_box(&ours);
            },
            || loop_by_hand.accelerate(&mut by_hand),
        );
        let lanes = width.lanes();
        let what = format!("ensemble of {count} ({place}), lanes: {lanes}");
        let reach = match (place, width) {
            ("L1", Width::Four) => Some(0.45),
            ("L1", Width::Eight) => Some(0.25),
            _ => None,
        };
        table.row_with_traffic(what, times, reach, traffic);
    }
}

/// What one would write without the library.
struct Loop {
    body: Space,
    states: Vec<Spatial>,
    forces: Vec<Vector3<f64>>,
}

impl Loop {
    fn accelerate(&self, results: &mut [SpatialAcceleration]) {
        let cases = black_box(&self.states).iter().zip(black_box(&self.forces));
        for ((state, force), result) in cases.zip(&mut *results) {
            *result = self.body.acceleration(0.0, state, force);
        }
        black_box(results);
    }
}
