//! States that are deserialized, and maps of attitudes with arbitrary arguments.

use core::fmt::Debug;

use fastrand::Rng;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};
use newton_euler::attitude;
use newton_euler::state::{Hinge, Planar, PlanarTranslation, Rod, Rotation, Spatial, Translation};
use newton_euler::wrench::Wrench;
use serde::{Serialize, de::DeserializeOwned};

use super::numbers::{all, either, sane};
use super::written::{assert_round_trip, read_damaged};
use super::{Verdict, compare, exact};

/// An attitude as it is written.
#[derive(Clone, Copy, Serialize, Debug)]
struct Attitude {
    w: f64,
    x: f64,
    y: f64,
    z: f64,
}

impl Attitude {
    /// Unit but for a little, or anything.
    fn any(rng: &mut Rng) -> Self {
        let number = either(rng, 4);
        let components: [f64; 4] = all(rng, number);
        let norm = components
            .iter()
            .map(|component| component * component)
            .sum::<f64>()
            .sqrt();
        let off = 1.0 + [0.0, 1e-16, 1e-10, 4.9e-10, 5.1e-10, 1e-8, 0.1][rng.usize(..7)];
        let [w, x, y, z] = components.map(|component| component / norm * off);
        Self { w, x, y, z }
    }

    fn verdict(&self) -> Verdict {
        exact::unit(&[self.w, self.x, self.y, self.z])
    }
}

/// Each kind of state, from numbers of which its conditions are known exactly.
#[allow(
    clippy::too_many_lines,
    clippy::items_after_statements,
    reason = "seven states, each with its form, one after another"
)]
pub fn read(rng: &mut Rng) {
    let number = either(rng, 2);
    let [p, v, w]: [[f64; 3]; 3] = core::array::from_fn(|_| all(rng, number));
    let ([p2, v2], [angle, rate]) = ([[p[0], p[1]], [v[0], v[1]]], [w[0], w[1]]);
    let attitude = Attitude::any(rng);
    let finite = |numbers: &[&[f64]]| exact::finite(&numbers.concat());

    #[derive(Serialize, Debug)]
    struct RawSpatial {
        position: [f64; 3],
        attitude: Attitude,
        velocity: [f64; 3],
        angular_velocity: [f64; 3],
    }
    let raw = RawSpatial {
        position: p,
        attitude,
        velocity: v,
        angular_velocity: w,
    };
    is_read::<Spatial>(
        &raw,
        exact::all([finite(&[&p, &v, &w]), attitude.verdict()]),
        rng,
    );

    #[derive(Serialize, Debug)]
    struct RawRotation {
        attitude: Attitude,
        angular_velocity: [f64; 3],
    }
    let raw = RawRotation {
        attitude,
        angular_velocity: w,
    };
    is_read::<Rotation>(&raw, exact::all([finite(&[&w]), attitude.verdict()]), rng);

    #[derive(Serialize, Debug)]
    struct RawTranslation {
        position: [f64; 3],
        velocity: [f64; 3],
    }
    is_read::<Translation>(
        &RawTranslation {
            position: p,
            velocity: v,
        },
        finite(&[&p, &v]),
        rng,
    );

    #[derive(Serialize, Debug)]
    struct RawPlanar {
        position: [f64; 2],
        angle: f64,
        velocity: [f64; 2],
        angular_velocity: f64,
    }
    let raw = RawPlanar {
        position: p2,
        angle,
        velocity: v2,
        angular_velocity: rate,
    };
    is_read::<Planar>(&raw, finite(&[&p2, &v2, &[angle, rate]]), rng);

    #[derive(Serialize, Debug)]
    struct RawPlanarTranslation {
        position: [f64; 2],
        velocity: [f64; 2],
    }
    let raw = RawPlanarTranslation {
        position: p2,
        velocity: v2,
    };
    is_read::<PlanarTranslation>(&raw, finite(&[&p2, &v2]), rng);

    #[derive(Serialize, Debug)]
    struct RawHinge {
        angle: f64,
        angular_velocity: f64,
    }
    is_read::<Hinge>(
        &RawHinge {
            angle,
            angular_velocity: rate,
        },
        finite(&[&[angle, rate]]),
        rng,
    );

    #[derive(Serialize, Debug)]
    struct RawRod {
        position: [f64; 3],
        velocity: [f64; 3],
        axis: [f64; 3],
        axis_rate: [f64; 3],
    }
    let (axis, axis_rate) = axis_and_rate(w, rng);
    let verdict = exact::all([
        finite(&[&p, &v]),
        exact::unit(&axis),
        exact::perpendicular(&axis, &axis_rate),
    ]);
    is_read::<Rod>(
        &RawRod {
            position: p,
            velocity: v,
            axis,
            axis_rate,
        },
        verdict,
        rng,
    );
}

/// A unit vector and one perpendicular to it, each but for a little, or anything.
fn axis_and_rate(w: [f64; 3], rng: &mut Rng) -> ([f64; 3], [f64; 3]) {
    let axis: Vector3<f64> = Vector3::from(all::<3>(rng, sane)).normalize();
    let rate = if rng.u8(..4) == 0 {
        Vector3::from(w)
    } else {
        axis.cross(&Vector3::from(w))
    };
    let off = [0.0, 1e-16, 1e-10, 0.9e-9, 1.1e-9, 1e-3][rng.usize(..6)];
    let scale = super::numbers::scale(rng);
    let rate = (rate + axis * (off * rate.norm())) * scale;
    (axis.into(), rate.into())
}

/// From text, as far as text can say it, and from bytes.
fn is_read<T: Serialize + DeserializeOwned + Debug>(
    raw: &(impl Serialize + Debug),
    verdict: Verdict,
    rng: &mut Rng,
) {
    let text = serde_json::to_string(raw).expect("a value that can be written");
    compare(raw, verdict, &serde_json::from_str::<T>(&text));
    let bytes = postcard::to_allocvec(raw).expect("a value that can be written");
    let read = postcard::from_bytes::<T>(&bytes);
    compare(raw, verdict, &read);
    if let Ok(state) = read {
        assert_round_trip(&state);
        read_damaged(&state, |_| {}, rng);
    }
}

/// Maps that take anything: they return, and what is unit stays unit.
pub fn maps(rng: &mut Rng) {
    let number = either(rng, 2);
    let [w, x, y, z, a, b, c] = all(rng, number);
    let turn = Vector3::new(a, b, c);
    let _ = attitude::log(&UnitQuaternion::new_unchecked(Quaternion::new(w, x, y, z)));
    let exponential = attitude::exp(&turn);
    // an angle beyond this has no sine worth the name
    if turn.iter().all(|component| component.abs() < 1e15) {
        let off = (exponential.norm_squared() - 1.0).abs();
        assert!(off < 1e-14, "|exp({turn:?})|² is off by {off}");
        let back = attitude::log(&exponential);
        assert!(
            back.norm() <= core::f64::consts::PI + 1e-15,
            "log of {exponential:?}"
        );
    }
    let _ = attitude::normalized(&Quaternion::new(w, x, y, z));
    let _ = attitude::turned(&exponential, &turn);
    let wrench = Wrench {
        force: Vector3::new(x, y, z),
        moment: turn,
    };
    let _ = wrench.reduce();
}
