//! Conditions on parameters alone, which select between values that depend on the state.

use newton_euler::prelude::*;

mod scenes {
    newton_euler::rigid_body!(Slider {
        motion: planar_translation,
        params: [stiff = 3[N / m], limit = 2[m]],
        mass: 1[kg],
        locals: [is_stiff = if stiff > 2[N / m] { 1 } else { 0 }],
        forces: [
            spring = if stiff > 2[N / m] && limit < 3[m] {
                -stiff * position
            } else {
                1[N / m] * position
            },
            stop = if position.in_world().x < limit || !(stiff < 2[N / m]) {
                is_stiff * world(0, 1)[N]
            } else {
                -1[N * s / m] * velocity
            },
        ],
        outputs: [balance],
    });

    newton_euler::rigid_body!(Any::<T> {
        motion: planar_translation,
        params: [stiff = 3[N / m]],
        mass: 1[kg],
        forces: [spring = if stiff > 2[N / m] {
            -stiff * position
        } else {
            1[N / m] * position
        },],
    });

    newton_euler::rigid_body!(Smooth {
        motion: planar_translation,
        params: [stiff = 3[N / m]],
        mass: 1[kg],
        forces: [spring = if stiff > 2[N / m] {
            -stiff * position
        } else {
            1[N / m] * position
        },],
        outputs: [taylor],
    });
}

fn at(x: f64) -> PlanarTranslation {
    PlanarTranslation {
        position: [x, 0.0].into(),
        velocity: [0.5, 0.0].into(),
    }
}

#[test]
fn parameters_choose() {
    let loads = |stiff: f64, limit: f64, x: f64| {
        let body = scenes::Slider::new(scenes::SliderParams { stiff, limit }).unwrap();
        body.loads(0.0, &at(x), &())
            .map(|load| [load.force.x, load.force.y])
    };
    assert_eq!(loads(3.0, 2.0, 1.0), [[-3.0, 0.0], [0.0, 1.0]]);
    assert_eq!(loads(3.0, 4.0, 1.0), [[1.0, 0.0], [0.0, 1.0]]);
    assert_eq!(loads(1.0, 2.0, 4.0), [[4.0, 0.0], [-0.5, 0.0]]);
    assert_eq!(loads(1.0, 2.0, 1.0), [[1.0, 0.0], [0.0, 0.0]]);
}

#[test]
fn of_any_scalar_and_in_series() {
    for (stiff, expected) in [(3.0, -6.0), (1.0, 2.0)] {
        let any = scenes::Any::<f64>::new(scenes::AnyParams { stiff }).unwrap();
        let pull = any.acceleration(0.0, &at(2.0), &()).x;
        assert_eq!(pull.to_bits(), f64::to_bits(expected));
        let smooth = scenes::Smooth::new(scenes::SmoothParams { stiff }).unwrap();
        let rows = *smooth.series::<3>(0.0, &at(2.0), &()).coefficients();
        assert_eq!(rows[2][0].to_bits(), f64::to_bits(expected / 2.0));
    }
}
