/// A satellite with a full inertia tensor and three control torques.
///
/// Inertia about G:
/// - general: three different principal moments
/// - 1.2632222351870954 kg m^2 about (0.9640971019872585, 0.2574035429737975, -0.0652701616690663)
/// - 1.7216177256690326 kg m^2 about (-0.24331279444312418, 0.9547247344063412, 0.17117115870677302)
/// - 2.115160039143872 kg m^2 about (0.10637510047021183, -0.14914455262354595, 0.9830769249772241)
///
/// Operations:
/// - `acceleration`: 23 mul + 17 add
/// - `applied`: 18 mul + 12 add
/// - `residual`: 42 mul + 33 add
/// - `loads`: 18 mul + 12 add
///
/// Skipped:
/// - the force balance: the motion of G is not modeled
/// - lambda w of J w: it is along w, and not in w x J w
/// - attitude: the accelerations do not depend on it
/// - energy, momentum: not in `outputs`
#[derive(Clone, Debug, Default)]
#[allow(unreachable_pub)]
pub struct Satellite {}
/// Inputs of [`Satellite`] at each evaluation, in SI units.
#[allow(clippy::struct_field_names)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SatelliteInput {
    /// `torque` in N * m, body axes.
    pub torque: ::newton_euler::private::Vector3<f64>,
}
::newton_euler::private::record! {
    SatelliteInput { "N * m" torque : ::newton_euler::private::Vector3 < f64 > }
}
impl Satellite {
    /// The equations of motion, as evaluated.
    pub const EQUATIONS: &str = {
        const TEXT: &str = "# wx wy wz: angular velocity, rad / s, body axes\n# angular_x angular_y angular_z: angular acceleration, rad / s ^ 2, body axes\n# torque_x torque_y torque_z: input, N * m, body axes\n# (J - lambda 1) w, body axes\nrelative_momentum_x = 0.07 * wz - (0.8 * wx + 0.12 * wy)\nminus_relative_momentum_y = 0.12 * wx + 0.4 * wy + 0.05 * wz\nrelative_momentum_z = 0.07 * wx - 0.05 * wy\n# M - w x J w about G, body axes\nnet_moment_x = torque_x - (wy * relative_momentum_z + wz * minus_relative_momentum_y)\nnet_moment_y = torque_y - (wz * relative_momentum_x - wx * relative_momentum_z)\nnet_moment_z = wx * minus_relative_momentum_y + wy * relative_momentum_x + torque_z\n# (1.4), body axes: w' = J^-1 (M - w x J w)\nangular_x = 0.7755401063473637 * net_moment_x + 0.054021504254329326 * net_moment_y - 0.02456511058647571 * net_moment_z\nangular_y = 0.054021504254329326 * net_moment_x + 0.5924104677805748 * net_moment_y + 0.01230429432915509 * net_moment_z\nangular_z = 0.01230429432915509 * net_moment_y - 0.02456511058647571 * net_moment_x + 0.4773022725988148 * net_moment_z";
        TEXT
    };
    /// Their operation counts, by function and stage.
    pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
        ::newton_euler::private::Operations::state("acceleration", [23, 17, 0, 0, 0, 0]),
        ::newton_euler::private::Operations::state("applied", [18, 12, 0, 0, 0, 0]),
        ::newton_euler::private::Operations::state("residual", [42, 33, 0, 0, 0, 0]),
        ::newton_euler::private::Operations::state("loads", [18, 12, 0, 0, 0, 0]),
    ];
    /// The terms that were left out, and why.
    pub const SKIPPED: &[&str] = &[
        "the force balance: the motion of G is not modeled",
        "lambda w of J w: it is along w, and not in w x J w",
        "attitude: the accelerations do not depend on it",
        "energy, momentum: not in `outputs`",
    ];
}
impl ::newton_euler::private::RigidBody for Satellite {
    type Scalar = f64;
    type State = ::newton_euler::private::Rotation;
    type Input = SatelliteInput;
    #[inline]
    #[allow(unused_doc_comments)]
    fn acceleration(
        &self,
        _time: f64,
        state: &::newton_euler::private::Rotation,
        input: &SatelliteInput,
    ) -> ::newton_euler::private::Vector3<f64> {
        let SatelliteInput { torque } = *input;
        let [torque_x, torque_y, torque_z]: [f64; 3] = ::core::convert::Into::into(
            torque,
        );
        let [wx, wy, wz]: [f64; 3] = ::core::convert::Into::into(state.angular_velocity);
        /// (J - lambda 1) w, body axes
        let relative_momentum_x = 0.07 * wz - (0.8 * wx + 0.12 * wy);
        let minus_relative_momentum_y = 0.12 * wx + 0.4 * wy + 0.05 * wz;
        let relative_momentum_z = 0.07 * wx - 0.05 * wy;
        /// M - w x J w about G, body axes
        let net_moment_x = torque_x
            - (wy * relative_momentum_z + wz * minus_relative_momentum_y);
        let net_moment_y = torque_y
            - (wz * relative_momentum_x - wx * relative_momentum_z);
        let net_moment_z = wx * minus_relative_momentum_y + wy * relative_momentum_x
            + torque_z;
        /// (1.4), body axes: w' = J^-1 (M - w x J w)
        let angular_x = 0.7755401063473637 * net_moment_x
            + 0.054021504254329326 * net_moment_y - 0.02456511058647571 * net_moment_z;
        let angular_y = 0.054021504254329326 * net_moment_x
            + 0.5924104677805748 * net_moment_y + 0.01230429432915509 * net_moment_z;
        let angular_z = 0.01230429432915509 * net_moment_y
            - 0.02456511058647571 * net_moment_x + 0.4773022725988148 * net_moment_z;
        ::core::convert::Into::into([angular_x, angular_y, angular_z])
    }
    #[cold]
    fn lost_load(
        &self,
        _time: f64,
        _state: &::newton_euler::private::Rotation,
        input: &SatelliteInput,
    ) -> ::core::option::Option<&'static str> {
        let SatelliteInput { torque } = *input;
        let [torque_x, torque_y, torque_z]: [f64; 3] = ::core::convert::Into::into(
            torque,
        );
        ::newton_euler::private::lost_load(
            &[("control", &[torque_x, torque_y, torque_z])],
        )
    }
}
impl ::newton_euler::private::Integrate for Satellite {
    type Best = ::newton_euler::private::RungeKuttaPair;
}
impl ::newton_euler::private::Balance for Satellite {
    type Wrench = ::newton_euler::private::Vector3<f64>;
    type Reactions = ();
    type Loads = [::newton_euler::private::Load; 1];
    #[allow(unused_doc_comments)]
    fn applied(
        &self,
        _time: f64,
        state: &::newton_euler::private::Rotation,
        input: &SatelliteInput,
    ) -> ::newton_euler::private::Vector3<f64> {
        let SatelliteInput { torque } = *input;
        let [torque_x, torque_y, torque_z]: [f64; 3] = ::core::convert::Into::into(
            torque,
        );
        let [qx, qy, qz, qw]: [f64; 4] = ::core::convert::Into::into(
            state.attitude.coords,
        );
        let doubled_x = 2.0 * torque_x;
        let doubled_y = 2.0 * torque_y;
        let doubled_z = 2.0 * torque_z;
        /// s = q x 2 v, to turn v: v + w s + q x s
        let swing_x = qy * doubled_z - qz * doubled_y;
        let swing_y = qz * doubled_x - qx * doubled_z;
        let swing_z = qx * doubled_y - qy * doubled_x;
        /// sum of the moments, world axes
        let moment_x = qy * swing_z - qz * swing_y + qw * swing_x + torque_x;
        let moment_y = qz * swing_x - qx * swing_z + qw * swing_y + torque_y;
        let moment_z = qx * swing_y - qy * swing_x + qw * swing_z + torque_z;
        ::core::convert::Into::into([moment_x, moment_y, moment_z])
    }
    #[allow(unused_doc_comments)]
    fn residual(
        &self,
        _time: f64,
        state: &::newton_euler::private::Rotation,
        acceleration: &::newton_euler::private::Vector3<f64>,
        _reactions: &(),
        input: &SatelliteInput,
    ) -> ::newton_euler::private::Vector3<f64> {
        let SatelliteInput { torque } = *input;
        let [torque_x, torque_y, torque_z]: [f64; 3] = ::core::convert::Into::into(
            torque,
        );
        let [qx, qy, qz, qw]: [f64; 4] = ::core::convert::Into::into(
            state.attitude.coords,
        );
        let [wx, wy, wz]: [f64; 3] = ::core::convert::Into::into(state.angular_velocity);
        let [alpha_x, alpha_y, alpha_z]: [f64; 3] = ::core::convert::Into::into(
            (*acceleration),
        );
        /// J w, body axes
        let momentum_x = 1.3 * wx - 0.12 * wy + 0.07 * wz;
        let momentum_y = 1.7 * wy - 0.12 * wx - 0.05 * wz;
        let momentum_z = 0.07 * wx - 0.05 * wy + 2.1 * wz;
        let turned_x = torque_x
            - (wy * momentum_z - wz * momentum_y
                + (1.3 * alpha_x - 0.12 * alpha_y + 0.07 * alpha_z));
        let turned_y = torque_y
            - (wz * momentum_x - wx * momentum_z
                + (1.7 * alpha_y - 0.12 * alpha_x - 0.05 * alpha_z));
        let turned_z = torque_z
            - (wx * momentum_y - wy * momentum_x
                + (0.07 * alpha_x - 0.05 * alpha_y + 2.1 * alpha_z));
        let doubled_x = 2.0 * turned_x;
        let doubled_y = 2.0 * turned_y;
        let doubled_z = 2.0 * turned_z;
        /// s = q x 2 v, to turn v: v + w s + q x s
        let swing_x = qy * doubled_z - qz * doubled_y;
        let swing_y = qz * doubled_x - qx * doubled_z;
        let swing_z = qx * doubled_y - qy * doubled_x;
        /// sum of the moments, world axes
        let moment_x = qy * swing_z - qz * swing_y + qw * swing_x + turned_x;
        let moment_y = qz * swing_x - qx * swing_z + qw * swing_y + turned_y;
        let moment_z = qx * swing_y - qy * swing_x + qw * swing_z + turned_z;
        ::core::convert::Into::into([moment_x, moment_y, moment_z])
    }
    #[allow(unused_doc_comments)]
    fn loads(
        &self,
        _time: f64,
        state: &::newton_euler::private::Rotation,
        input: &SatelliteInput,
    ) -> [::newton_euler::private::Load; 1] {
        let SatelliteInput { torque } = *input;
        let [torque_x, torque_y, torque_z]: [f64; 3] = ::core::convert::Into::into(
            torque,
        );
        let [qx, qy, qz, qw]: [f64; 4] = ::core::convert::Into::into(
            state.attitude.coords,
        );
        let doubled_x = 2.0 * torque_x;
        let doubled_y = 2.0 * torque_y;
        let doubled_z = 2.0 * torque_z;
        /// s = q x 2 v, to turn v: v + w s + q x s
        let swing_x = qy * doubled_z - qz * doubled_y;
        let swing_y = qz * doubled_x - qx * doubled_z;
        let swing_z = qx * doubled_y - qy * doubled_x;
        [
            ::newton_euler::private::Load {
                name: "control",
                family: ::newton_euler::private::Family::External,
                force: ::core::convert::Into::into([0.0, 0.0, 0.0]),
                point: ::core::convert::Into::into([0.0, 0.0, 0.0]),
                moment: ::core::convert::Into::into([
                    qy * swing_z - qz * swing_y + qw * swing_x + torque_x,
                    qz * swing_x - qx * swing_z + qw * swing_y + torque_y,
                    qx * swing_y - qy * swing_x + qw * swing_z + torque_z,
                ]),
            },
        ]
    }
}
impl ::newton_euler::private::Structured for Satellite {
    const STRUCTURE: ::newton_euler::private::Structure = ::newton_euler::private::Structure {
        linear: ::newton_euler::private::Dependence::NOTHING,
        angular: ::newton_euler::private::Dependence {
            angular_velocity: true,
            input: true,
            body: ::newton_euler::private::Symmetry::None,
            ..::newton_euler::private::Dependence::NOTHING
        },
        is_force_free: true,
        ..::newton_euler::private::Structure::GENERAL
    };
}
