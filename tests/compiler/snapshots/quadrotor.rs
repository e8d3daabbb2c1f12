#[allow(non_snake_case, unreachable_pub)]
mod equations_of_Quadrotor {
    /// A quadrotor in a plus configuration; rotors 1 and 3 spin about -z.
    ///
    /// Inertia about G:
    /// - symmetric about n = (0, 0, 1), oblate: 0.0224 kg m^2 about n, 0.0123 across
    ///
    /// Operations:
    /// - `new`: 2 mul
    /// - `acceleration`: 16 mul + 15 add
    ///
    /// Skipped:
    /// - products of inertia: the axes are principal
    /// - (w x J w)_z: the other two moments of inertia are equal
    /// - the moment of `weight`: it acts at G
    /// - two columns of the rotation: what turns is along z in body axes
    /// - position, velocity: the accelerations do not depend on them
    /// - energy, momentum, balance: not in `outputs`
    #[derive(Clone, Debug)]
    pub struct Quadrotor {
        params: QuadrotorParams,
        from_arm: f64,
        from_drag_ratio: f64,
    }
    /// Parameters of [`Quadrotor`], in SI units.
    #[allow(clippy::struct_field_names)]
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct QuadrotorParams {
        /// `arm` in m, 0.17 by default.
        pub arm: f64,
        /// `drag_ratio` in m, 0.016 by default.
        pub drag_ratio: f64,
    }
    ::newton_euler::private::record! {
        QuadrotorParams { "m" arm : f64 = 0.17, "m" drag_ratio : f64 = 0.016 }
    }
    /// Inputs of [`Quadrotor`] at each evaluation, in SI units.
    #[allow(clippy::struct_field_names)]
    #[derive(Clone, Copy, Debug, Default, PartialEq)]
    pub struct QuadrotorInput {
        /// `thrust_1` in N.
        pub thrust_1: f64,
        /// `thrust_2` in N.
        pub thrust_2: f64,
        /// `thrust_3` in N.
        pub thrust_3: f64,
        /// `thrust_4` in N.
        pub thrust_4: f64,
    }
    ::newton_euler::private::record! {
        QuadrotorInput { "N" thrust_1 : f64, "N" thrust_2 : f64, "N" thrust_3 : f64, "N"
        thrust_4 : f64 }
    }
    impl Quadrotor {
        /// The equations of motion, as evaluated.
        pub const EQUATIONS: &str = {
            const TEXT: &str = "# qx qy qz qw: attitude, a unit quaternion, from body to world axes\n# wx wy wz: angular velocity, rad / s, body axes\n# linear_x linear_y linear_z: acceleration, m / s ^ 2, world axes\n# angular_x angular_y angular_z: angular acceleration, rad / s ^ 2, body axes\n# arm: parameter, m\n# drag_ratio: parameter, m\n# thrust_1: input, N\n# thrust_2: input, N\n# thrust_3: input, N\n# thrust_4: input, N\n# once, in the constructor\nfrom_arm = 81.30081300813008 * arm\nfrom_drag_ratio = 44.642857142857146 * drag_ratio\n# at every evaluation\ntwist = thrust_1 - thrust_2 + thrust_3 - thrust_4\n# what is fixed in the body: sum of F / m, body axes\nspecific_force_z = 0.8333333333333334 * (thrust_1 + thrust_2 + thrust_3 + thrust_4)\ndoubled_z = 2.0 * specific_force_z\n# s = q x 2 v, to turn v: v + w s + q x s\nswing_x = qy * doubled_z\nminus_swing_y = qx * doubled_z\n# (1.3), world axes: a = sum of F / m\nlinear_x = qw * swing_x + qz * minus_swing_y\nlinear_y = qz * swing_x - qw * minus_swing_y\nlinear_z = specific_force_z - (qx * minus_swing_y + qy * swing_x) - 9.80665\n# rate at which w turns in the body: (J_1 - J_3) / J_1 w_3\nprecession = -0.8211382113821138 * wz\n# (1.4), body axes: w' = J^-1 (M - w x J w)\nangular_x = wy * precession + from_arm * (thrust_2 - thrust_4)\nangular_y = from_arm * (thrust_3 - thrust_1) - wx * precession\nangular_z = from_drag_ratio * twist";
            TEXT
        };
        /// Their operation counts, by function and stage.
        pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
            ::newton_euler::private::Operations::parameter("new", [2, 0, 0, 0, 0, 0]),
            ::newton_euler::private::Operations::state(
                "acceleration",
                [16, 15, 0, 0, 0, 0],
            ),
        ];
        /// The terms that were left out, and why.
        pub const SKIPPED: &[&str] = &[
            "products of inertia: the axes are principal",
            "(w x J w)_z: the other two moments of inertia are equal",
            "the moment of `weight`: it acts at G",
            "two columns of the rotation: what turns is along z in body axes",
            "position, velocity: the accelerations do not depend on them",
            "energy, momentum, balance: not in `outputs`",
        ];
        /// Checks the parameters, and computes everything that depends on them alone.
        /// - `arm` = 0.17 m
        /// - `drag_ratio` = 0.016 m
        ///
        /// # Errors
        /// A parameter is not finite, or no body can have the resulting mass or inertia.
        pub fn new(
            params: QuadrotorParams,
        ) -> ::core::result::Result<Self, ::newton_euler::private::InvalidBody> {
            ::newton_euler::private::check_finite(
                &[("arm", params.arm), ("drag_ratio", params.drag_ratio)],
            )?;
            let QuadrotorParams { arm, drag_ratio } = params;
            let from_arm = 81.30081300813008 * arm;
            let from_drag_ratio = 44.642857142857146 * drag_ratio;
            ::newton_euler::private::check_derived(
                &[("`arm`", from_arm), ("`drag_ratio`", from_drag_ratio)],
            )?;
            ::core::result::Result::Ok(Self {
                params,
                from_arm,
                from_drag_ratio,
            })
        }
        /// The parameters of this body.
        #[must_use]
        pub fn params(&self) -> &QuadrotorParams {
            &self.params
        }
    }
    impl ::core::default::Default for QuadrotorParams {
        fn default() -> Self {
            Self {
                arm: 0.17,
                drag_ratio: 0.016,
            }
        }
    }
    impl ::core::default::Default for Quadrotor {
        fn default() -> Self {
            Self::new(<QuadrotorParams as ::core::default::Default>::default())
                .expect("the defaults were checked at expansion")
        }
    }
    impl ::newton_euler::private::RigidBody for Quadrotor {
        type Scalar = f64;
        type State = ::newton_euler::private::Spatial;
        type Input = QuadrotorInput;
        #[inline]
        #[allow(unused_doc_comments)]
        fn acceleration(
            &self,
            _time: f64,
            state: &::newton_euler::private::Spatial,
            input: &QuadrotorInput,
        ) -> ::newton_euler::private::SpatialAcceleration {
            let QuadrotorInput { thrust_1, thrust_2, thrust_3, thrust_4 } = *input;
            let [qx, qy, qz, qw]: [f64; 4] = ::core::convert::Into::into(
                state.attitude.coords,
            );
            let [wx, wy, wz]: [f64; 3] = ::core::convert::Into::into(
                state.angular_velocity,
            );
            let twist = thrust_1 - thrust_2 + thrust_3 - thrust_4;
            /// what is fixed in the body: sum of F / m, body axes
            let specific_force_z = 0.8333333333333334
                * (thrust_1 + thrust_2 + thrust_3 + thrust_4);
            let doubled_z = 2.0 * specific_force_z;
            /// s = q x 2 v, to turn v: v + w s + q x s
            let swing_x = qy * doubled_z;
            let minus_swing_y = qx * doubled_z;
            /// (1.3), world axes: a = sum of F / m
            let linear_x = qw * swing_x + qz * minus_swing_y;
            let linear_y = qz * swing_x - qw * minus_swing_y;
            let linear_z = specific_force_z - (qx * minus_swing_y + qy * swing_x)
                - 9.80665;
            /// rate at which w turns in the body: (J_1 - J_3) / J_1 w_3
            let precession = -0.8211382113821138 * wz;
            /// (1.4), body axes: w' = J^-1 (M - w x J w)
            let angular_x = wy * precession + self.from_arm * (thrust_2 - thrust_4);
            let angular_y = self.from_arm * (thrust_3 - thrust_1) - wx * precession;
            let angular_z = self.from_drag_ratio * twist;
            ::newton_euler::private::SpatialAcceleration {
                linear: ::core::convert::Into::into([linear_x, linear_y, linear_z]),
                angular: ::core::convert::Into::into([angular_x, angular_y, angular_z]),
            }
        }
        #[cold]
        fn lost_load(
            &self,
            _time: f64,
            _state: &::newton_euler::private::Spatial,
            input: &QuadrotorInput,
        ) -> ::core::option::Option<&'static str> {
            let QuadrotorParams { drag_ratio, .. } = self.params;
            let QuadrotorInput { thrust_1, thrust_2, thrust_3, thrust_4 } = *input;
            let twist = thrust_1 - thrust_2 + thrust_3 - thrust_4;
            ::newton_euler::private::lost_load(
                &[
                    ("lift_1", &[thrust_1]),
                    ("lift_2", &[thrust_2]),
                    ("lift_3", &[thrust_3]),
                    ("lift_4", &[thrust_4]),
                    ("drag", &[drag_ratio * twist]),
                ],
            )
        }
    }
    impl ::newton_euler::private::Integrate for Quadrotor {
        type Best = ::newton_euler::private::RungeKuttaPair;
    }
    impl ::newton_euler::private::Structured for Quadrotor {
        const STRUCTURE: ::newton_euler::private::Structure = ::newton_euler::private::Structure {
            linear: ::newton_euler::private::Dependence {
                attitude: true,
                input: true,
                world: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                body: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                ..::newton_euler::private::Dependence::NOTHING
            },
            angular: ::newton_euler::private::Dependence {
                angular_velocity: true,
                input: true,
                body: ::newton_euler::private::Symmetry::None,
                ..::newton_euler::private::Dependence::NOTHING
            },
            ..::newton_euler::private::Structure::GENERAL
        };
    }
}
#[allow(unused_imports, unreachable_pub)]
pub use equations_of_Quadrotor::{Quadrotor, QuadrotorParams, QuadrotorInput};
