#[allow(non_snake_case, unreachable_pub)]
mod equations_of_Plank {
    /// A plank thrown in a vertical plane.
    ///
    /// Operations:
    /// - `new`: 3 mul
    /// - `acceleration`: none
    /// - `kinetic_energy`: 5 mul + 2 add
    /// - `potential_energy`: 1 mul
    /// - `linear_momentum`: 2 mul
    /// - `angular_momentum`: 1 mul
    /// - `angular_momentum_about_pole`: 1 mul
    ///
    /// Skipped:
    /// - three equations out of the plane: the motion is planar
    /// - the moment of `weight`: it acts at G
    /// - position, velocity, attitude, angular velocity: the accelerations do not depend on them
    /// - balance: not in `outputs`
    #[derive(Clone, Debug)]
    pub struct Plank {
        params: PlankParams,
        inertia: f64,
        from_length: f64,
    }
    /// Parameters of [`Plank`], in SI units.
    #[allow(clippy::struct_field_names)]
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct PlankParams {
        /// `length` in m, 2 by default.
        pub length: f64,
    }
    ::newton_euler::private::record! {
        PlankParams { "m" length : f64 = 2.0 }
    }
    impl Plank {
        /// The equations of motion, as evaluated.
        pub const EQUATIONS: &str = {
            const TEXT: &str = "# linear_x linear_y: acceleration, m / s ^ 2, world axes\n# angular: angular acceleration, rad / s ^ 2\n# length: parameter, m\n# once, in the constructor\nlength_squared = length * length\ninertia = 0.3333333333333333 * length_squared\nfrom_length = 0.16666666666666666 * length_squared\n# at every evaluation\nlinear_x = 0.0\nlinear_y = -9.80665\nangular = 0.0";
            TEXT
        };
        /// Their operation counts, by function and stage.
        pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
            ::newton_euler::private::Operations::parameter("new", [3, 0, 0, 0, 0, 0]),
            ::newton_euler::private::Operations::state(
                "acceleration",
                [0, 0, 0, 0, 0, 0],
            ),
            ::newton_euler::private::Operations::state(
                "kinetic_energy",
                [5, 2, 0, 0, 0, 0],
            ),
            ::newton_euler::private::Operations::state(
                "potential_energy",
                [1, 0, 0, 0, 0, 0],
            ),
            ::newton_euler::private::Operations::state(
                "linear_momentum",
                [2, 0, 0, 0, 0, 0],
            ),
            ::newton_euler::private::Operations::state(
                "angular_momentum",
                [1, 0, 0, 0, 0, 0],
            ),
            ::newton_euler::private::Operations::state(
                "angular_momentum_about_pole",
                [1, 0, 0, 0, 0, 0],
            ),
        ];
        /// The terms that were left out, and why.
        pub const SKIPPED: &[&str] = &[
            "three equations out of the plane: the motion is planar",
            "the moment of `weight`: it acts at G",
            "position, velocity, attitude, angular velocity: the accelerations do not depend on them",
            "balance: not in `outputs`",
        ];
        /// Checks the parameters, and computes everything that depends on them alone.
        /// - `length` = 2 m
        ///
        /// # Errors
        /// A parameter is not finite, or no body can have the resulting mass or inertia.
        pub fn new(
            params: PlankParams,
        ) -> ::core::result::Result<Self, ::newton_euler::private::InvalidBody> {
            ::newton_euler::private::check_finite(&[("length", params.length)])?;
            let PlankParams { length } = params;
            let length_squared = length * length;
            let inertia = 0.3333333333333333 * length_squared;
            ::newton_euler::private::check_planar_inertia(inertia)?;
            let from_length = 0.16666666666666666 * length_squared;
            ::newton_euler::private::check_derived(
                &[("`length`", inertia), ("`length`", from_length)],
            )?;
            ::core::result::Result::Ok(Self {
                params,
                inertia,
                from_length,
            })
        }
        /// The parameters of this body.
        #[must_use]
        pub fn params(&self) -> &PlankParams {
            &self.params
        }
    }
    impl ::core::default::Default for PlankParams {
        fn default() -> Self {
            Self { length: 2.0 }
        }
    }
    impl ::core::default::Default for Plank {
        fn default() -> Self {
            Self::new(<PlankParams as ::core::default::Default>::default())
                .expect("the defaults were checked at expansion")
        }
    }
    impl ::newton_euler::private::RigidBody for Plank {
        type Scalar = f64;
        type State = ::newton_euler::private::Planar;
        type Input = ();
        #[inline]
        fn acceleration(
            &self,
            _time: f64,
            _state: &::newton_euler::private::Planar,
            _input: &(),
        ) -> ::newton_euler::private::PlanarAcceleration {
            ::newton_euler::private::PlanarAcceleration {
                linear: ::core::convert::Into::into([0.0, -9.80665]),
                angular: 0.0,
            }
        }
    }
    impl ::newton_euler::private::Integrate for Plank {
        type Best = ::newton_euler::private::RungeKuttaPair;
    }
    impl ::newton_euler::private::Energy for Plank {
        fn kinetic_energy(&self, state: &::newton_euler::private::Planar) -> f64 {
            let [vx, vy]: [f64; 2] = ::core::convert::Into::into(state.velocity);
            let w = state.angular_velocity;
            2.0 * (vx * vx + vy * vy) + self.from_length * (w * w)
        }
        fn potential_energy(
            &self,
            _time: f64,
            state: &::newton_euler::private::Planar,
            _input: &(),
        ) -> f64 {
            let [_, y]: [f64; 2] = ::core::convert::Into::into(state.position);
            39.2266 * y
        }
    }
    impl ::newton_euler::private::Momentum for Plank {
        type Linear = ::newton_euler::private::Vector2<f64>;
        type Angular = f64;
        fn linear_momentum(
            &self,
            state: &::newton_euler::private::Planar,
        ) -> ::newton_euler::private::Vector2<f64> {
            let [vx, vy]: [f64; 2] = ::core::convert::Into::into(state.velocity);
            ::core::convert::Into::into([4.0 * vx, 4.0 * vy])
        }
        fn angular_momentum(&self, state: &::newton_euler::private::Planar) -> f64 {
            let w = state.angular_velocity;
            self.inertia * w
        }
        fn angular_momentum_about_pole(
            &self,
            _time: f64,
            state: &::newton_euler::private::Planar,
        ) -> f64 {
            let w = state.angular_velocity;
            self.inertia * w
        }
    }
    impl ::newton_euler::private::Structured for Plank {
        const STRUCTURE: ::newton_euler::private::Structure = ::newton_euler::private::Structure {
            linear: ::newton_euler::private::Dependence {
                world: ::newton_euler::private::Symmetry::None,
                body: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                ..::newton_euler::private::Dependence::NOTHING
            },
            angular: ::newton_euler::private::Dependence {
                world: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                body: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                ..::newton_euler::private::Dependence::NOTHING
            },
            is_torque_free: true,
            keeps_spin: true,
            ..::newton_euler::private::Structure::GENERAL
        };
    }
}
#[allow(unused_imports, unreachable_pub)]
pub use equations_of_Plank::{Plank, PlankParams};
