//! Which fields are part of the rows: those that are proved to be proportional to mass. All others
//! are loads, whatever mass the description has.

use newton_euler::prelude::*;

use super::close;

/// The row of a pendulum about its pin, by hand: m, `m c_x`, `m c_y`, J. Only the acceleration of the
/// pin relative to free fall counts, in body axes.
fn row(angle: f64, rate: f64, [x, y]: [f64; 2]) -> [f64; 4] {
    let (sine, cosine) = angle.sin_cos();
    let a = [-cosine * x - sine * y, sine * x - cosine * y];
    [0.0, a[1], -a[0], rate]
}

/// Pendulums with one field each: a body, a system with the field in its body, and one with the
/// field beside its body. Each has the expected acceleration of free fall in the rows.
macro_rules! pendulums {
    ($($name:ident [$($given:tt)*] { $($body:tt)* } [$($field:tt)*] => $fall:expr;)*) => {$(
        #[test]
        fn $name() {
            rigid_body!(Alone {
                motion: pivot(pin),
                $($given)*
                $($body)*
                points: [pin = (0.2, 0)],
                fields: [$($field)*],
                outputs: [regressor],
            });
            rigid_system!(Inside {
                motion: planar,
                $($given)*
                bodies: [a { $($body)* points: [pin = (0.2, 0)], fields: [$($field)*] }],
                joints: [turn = revolute(world(0, 0), a.pin)],
                outputs: [regressor],
            });
            rigid_system!(Beside {
                motion: planar,
                $($given)*
                bodies: [a { $($body)* points: [pin = (0.2, 0)] }],
                joints: [turn = revolute(world(0, 0), a.pin)],
                fields: [$($field)*],
                outputs: [regressor],
            });
            for (angle, rate) in [(0.3, 1.2), (-2.0, 0.0), (1.4, -0.7)] {
                let turn = Hinge { angle, angular_velocity: 0.6 };
                let expected = row(angle, rate, $fall);
                let found = Alone::default().regressor(0.0, &turn, &rate, &());
                close(found.as_slice(), &expected, 1e-14);
                let given = InsideAcceleration { turn: rate };
                let state = InsideState { turn };
                let found = Inside::default().regressor(0.0, &state, &given, &());
                close(found.a.as_slice(), &expected, 1e-14);
                let given = BesideAcceleration { turn: rate };
                let state = BesideState { turn };
                let found = Beside::default().regressor(0.0, &state, &given, &());
                close(found.a.as_slice(), &expected, 1e-14);
            }
        }
    )*};
}

pendulums! {
    weight_of_a_number []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [weight = mass * world(0, -9.81[m / s ^ 2])] => [0.0, -9.81];
    weight_written_with_the_number []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [weight = 2[kg] * world(0, -9.81[m / s ^ 2])] => [0.0, 0.0];
    a_number_of_newtons []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [weight = world(0, -19.62[N])] => [0.0, 0.0];
    a_charge [params: [q = 3[N]],]
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [field = q * world(0, 1)] => [0.0, 0.0];
    a_weight_and_a_force []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [both = mass * world(0.5[m / s ^ 2], -9.81[m / s ^ 2]) + world(0, 3[N])] => [0.5, -9.81];
    more_mass_than_the_body_has []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [more = (mass + 1[kg]) * world(0, -9.81[m / s ^ 2])] => [0.0, -9.81];
    not_linear_in_a_number []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [pull = mass * (mass / 1[kg] + 1) * world(0, -1[m / s ^ 2])] => [0.0, 0.0];
    not_linear_in_a_parameter [params: [m = 2[kg]],]
        { mass: m, inertia: 0.1[kg * m ^ 2], }
        [pull = m * (m / 1[kg] + 1) * world(0, -1[m / s ^ 2])] => [0.0, 0.0];
    on_two_branches_of_mass []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [pull = if mass < 3[kg] { mass * world(0, -1[m / s ^ 2]) }
            else { mass * world(0, -2[m / s ^ 2]) }] => [0.0, 0.0];
    on_two_branches_of_time []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [pull = if t < 1[s] { mass * world(0, -1[m / s ^ 2]) + world(0, 3[N]) }
            else { mass * world(0, -2[m / s ^ 2]) }] => [0.0, -1.0];
    a_sum_on_a_branch_of_mass [params: [m = 2[kg], load = 1[kg]],]
        { mass: m + load, inertia: 0.1[kg * m ^ 2], }
        [pull = if mass < 5[kg] { (m + load) * world(0, -1[m / s ^ 2]) }
            else { world(0, 3[N]) }] => [0.0, 0.0];
    in_steps_of_mass []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [pull = mass * world(0, -1[m / s ^ 2]) + (mass / 1[kg]).floor() * world(0, 3[N])]
            => [0.0, 0.0];
    a_table_of_time []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [pull = mass * (world(0, -1) * table(t, [0, 1][s], [3, 5][m / s ^ 2]))
            + world(0, 3[N])] => [0.0, -3.0];
    through_locals []
        {
            mass: 2[kg],
            inertia: 0.1[kg * m ^ 2],
            locals: [size = mass * 9.81[m / s ^ 2], pull = world(0, -size)],
        }
        [weight = pull] => [0.0, -9.81];
    a_ratio_to_mass_in_a_local []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], locals: [ratio = mass / 4[kg]], }
        [pull = mass * world(0, -9.81[m / s ^ 2] * ratio)] => [0.0, 0.0];
    a_sum_and_a_force [params: [m = 2[kg], load = 1[kg]],]
        { mass: m + load, inertia: 0.1[kg * m ^ 2], }
        [both = (m + load) * world(0, -9.81[m / s ^ 2]) + world(0, 3[N])] => [0.0, -9.81];
    half_of_a_mass_and_a_force [params: [m = 2[kg]],]
        { mass: 2 * m, inertia: 0.1[kg * m ^ 2], }
        [both = m * world(0, -9.81[m / s ^ 2]) + world(0, 3[N])] => [0.0, -4.905];
    a_sum_and_a_square [params: [m = 2[kg], load = 1[kg]],]
        { mass: m + load, inertia: 0.1[kg * m ^ 2], }
        [both = (m + load) * world(0, -9.81[m / s ^ 2]) + load * (load / 1[kg]) * world(0, 1[m / s ^ 2])]
            => [0.0, 0.0];
    weight_of_a_parameter [params: [m = 2[kg], g = 9.81[m / s ^ 2]],]
        { mass: m, inertia: 0.1[kg * m ^ 2], }
        [weight = mass * world(0, -g)] => [0.0, -9.81];
    weight_written_with_the_parameter [params: [m = 2[kg], g = 9.81[m / s ^ 2]],]
        { mass: m, inertia: 0.1[kg * m ^ 2], }
        [weight = m * world(0, -g) + world(0, 3[N])] => [0.0, -9.81];
    weight_of_a_sum [params: [m = 2[kg], load = 1[kg]],]
        { mass: m + load, inertia: 0.1[kg * m ^ 2], }
        [weight = mass * world(0, -9.81[m / s ^ 2]) + world(0, 3[N])] => [0.0, -9.81];
    weight_written_as_the_sum [params: [m = 2[kg], load = 1[kg]],]
        { mass: m + load, inertia: 0.1[kg * m ^ 2], }
        [weight = m * world(0, -9.81[m / s ^ 2]) + load * world(0, -9.81[m / s ^ 2])]
            => [0.0, -9.81];
    weight_of_a_part_of_the_sum [params: [m = 2[kg], load = 1[kg]],]
        { mass: m + load, inertia: 0.1[kg * m ^ 2], }
        [weight = m * world(0, -9.81[m / s ^ 2])] => [0.0, 0.0];
    weight_of_the_rest_of_a_sum [params: [m = 2[kg]],]
        { mass: m + 1[kg], inertia: 0.1[kg * m ^ 2], }
        // that of all, and a force of -1 kg g
        [weight = m * world(0, -9.81[m / s ^ 2])] => [0.0, -9.81];
    a_share_that_follows_the_sum [params: [m = 2[kg], load = 1[kg]],]
        { mass: m + load, inertia: 0.1[kg * m ^ 2], }
        [weight = mass * world(0, -9.81[m / s ^ 2] * m / load)] => [0.0, 0.0];
    weight_of_a_product [params: [density = 250[kg / m ^ 3], side = 0.2[m]],]
        { mass: density * side * side * side, inertia: 0.1[kg * m ^ 2], }
        [weight = density * side.powi(3) * world(0, -9.81[m / s ^ 2])] => [0.0, -9.81];
    a_force_that_follows_inertia [params: [j = 0.1[kg * m ^ 2]],]
        { mass: 2[kg], inertia: j, }
        [pull = mass * world(0, -9.81[m / s ^ 2] * (j / 1[kg * m ^ 2]))] => [0.0, 0.0];
    weight_of_parts []
        { inertia: compose([disc(0.1[m]).mass(2[kg]), disc(0.2[m]).mass(1[kg])]), }
        [weight = mass * world(0, -9.81[m / s ^ 2])] => [0.0, -9.81];
    away_from_the_center []
        { mass: 2[kg], inertia: 0.1[kg * m ^ 2], }
        [pull = (mass * world(0, -9.81[m / s ^ 2])).at(pin)] => [0.0, 0.0];
}

rigid_system!(OfLocals {
    motion: planar,
    bodies: [a {
        mass: 2[kg],
        inertia: 0.1[kg * m ^ 2],
        points: [pin = (0.2, 0)]
    }],
    joints: [turn = revolute(world(0, 0), a.pin)],
    locals: [size = a.mass * 9.81[m / s ^ 2], ratio = a.mass / 4[kg]],
    fields: [
        weight = world(0, -size),
        pull = mass * world(ratio * 1[m / s ^ 2], 0)
    ],
    outputs: [regressor],
});

#[test]
fn locals_of_a_system_do_not_hide_a_mass() {
    let turn = Hinge {
        angle: 0.3,
        angular_velocity: 0.6,
    };
    let rows = OfLocals::default();
    let given = OfLocalsAcceleration { turn: 1.2 };
    let rows = rows.regressor(0.0, &OfLocalsState { turn }, &given, &());
    close(rows.a.as_slice(), &row(0.3, 1.2, [0.0, -9.81]), 1e-14);
}

/// A thrust of 4 N lifts 2 kg against nothing, in a field of 3 N: a = 7 / 2 m/s^2.
macro_rules! lifted {
    ($($name:ident $mass:literal $field:expr;)*) => {$(
        rigid_body!($name {
            motion: planar_translation,
            params: [q = 3[N]],
            inputs: [thrust[N]],
            mass: $mass[kg],
            fields: [field = $field],
            forces: [engine = world(0, thrust)],
            outputs: [regressor],
        });
    )*};
}
lifted! {
    Charged 2 q * world(0, 1);
    Placeholder 1 q * world(0, 1);
}

#[test]
fn a_field_that_is_not_a_weight_is_a_load() {
    let input = ChargedInput { thrust: 4.0 };
    let state = PlanarTranslation::default();
    let motion = Charged::default().acceleration(0.0, &state, &input);
    assert_eq!(motion.as_slice(), [0.0, 3.5]);
    let input = PlaceholderInput { thrust: 4.0 };
    let rows = Placeholder::default().regressor(0.0, &state, &motion, &input);
    assert_eq!(rows.as_slice(), [0.0, 3.5]);
    // the thrust and the field
    assert_eq!((4.0 + 3.0) / rows.y, 2.0);
}
