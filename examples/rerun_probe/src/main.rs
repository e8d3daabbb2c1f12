//! A motion as a recording of Rerun: the pose of a probe, its path, and curves of its spin and its
//! energy.
//!
//! `rerun probe.rrd` shows it. With `.spawn()` in place of `.memory()` the viewer opens by itself, and
//! shows the motion while it is computed.
//!
//! Asserts: the recording holds each sample once, in single precision.
//!
//! `cargo run --manifest-path examples/rerun_probe/Cargo.toml [probe.rrd]`

use newton_euler::prelude::*;
use rerun::components::Translation3D;
use rerun::log::{Chunk, LogMsg};
use rerun::{Boxes3D, LineStrips3D, Quaternion, RecordingStream, Scalars, Transform3D};

rigid_body!(Probe {
    doc: "A probe thrown from the ground, spinning about its intermediate axis.",
    motion: spatial,
    mass: 85[kg],
    inertia: principal(12, 14, 20)[kg * m ^ 2],
    fields: [weight = mass * world(0, 0, -1.62[m / s ^ 2])],
    outputs: [energy],
});

/// The time between samples \[s\].
const STEP: f64 = 0.02;

/// Single precision, in which Rerun has positions.
fn single<const N: usize>(values: [f64; N]) -> [f32; N] {
    values.map(|value| value as f32)
}

/// Logs a motion: what does not change first, and then the samples.
fn record(
    recording: &RecordingStream,
    probe: &Probe,
    samples: &[Sample<Spatial>],
) -> Result<(), rerun::RecordingStreamError> {
    let hull = Boxes3D::from_half_sizes([[0.6, 0.5, 0.3]]);
    recording.log_static("probe/hull", &hull)?;
    let path = samples
        .iter()
        .map(|sample| single(sample.state.position.into()));
    let path = LineStrips3D::new([path.collect::<Vec<[f32; 3]>>()]);
    recording.log_static("path", &path)?;
    for Sample { time, state, .. } in samples {
        recording.set_duration_secs("time", *time);
        let turn = Quaternion::from_xyzw(single(state.attitude.coords.into()));
        let place = single(state.position.into());
        recording.log(
            "probe",
            &Transform3D::from_translation_rotation(place, turn),
        )?;
        let spin: [f64; 3] = state.angular_velocity.into();
        recording.log("spin", &Scalars::new(spin))?;
        let energy = probe.kinetic_energy(state) + probe.potential_energy(*time, state, &());
        recording.log("energy", &Scalars::single(energy))?;
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let probe = Probe::default();
    let thrown = Spatial {
        velocity: [3.0, 0.0, 8.0].into(),
        angular_velocity: [0.02, 2.0, 0.01].into(),
        ..Spatial::default()
    };
    let samples = probe.integrate(&thrown).samples(9.8, STEP);
    let samples = samples.collect::<Result<Vec<_>, _>>()?;

    let new = || rerun::RecordingStreamBuilder::new("newton-euler");
    if let Some(file) = std::env::args().nth(1) {
        record(&new().save(file)?, &probe, &samples)?;
    }
    let (recording, storage) = new().memory()?;
    record(&recording, &probe, &samples)?;

    let mut recorded = Vec::new();
    for message in &storage.take() {
        if let LogMsg::ArrowMsg(_, rows) = message {
            let chunk = Chunk::from_arrow_msg(rows)?;
            let places = Transform3D::descriptor_translation().component;
            let places = chunk.iter_component::<Translation3D>(places);
            recorded.extend(places.flat_map(|places| places.as_slice().to_vec()));
        }
    }
    assert_eq!(recorded.len(), samples.len());
    for (place, sample) in recorded.iter().zip(&samples) {
        let expected: [f32; 3] = single(sample.state.position.into());
        assert_eq!(place.0.0, expected);
    }
    println!(
        "{} samples, the last at {:.2} m",
        samples.len(),
        recorded[recorded.len() - 1].z()
    );
    Ok(())
}
