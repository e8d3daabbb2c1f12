#[allow(non_snake_case, unreachable_pub)]
mod equations_of_Towed {
    /// A sledge on a rope that pulls with a constant force: its motion in closed form.
    ///
    /// Closed form:
    /// - G moves on a parabola
    /// - the angle is that of a pendulum, by elliptic functions
    ///
    /// Operations:
    /// - `new`: 5 mul + 1 sqrt + 2 trig
    /// - `acceleration`: 2 mul + 1 add + 2 trig
    ///
    /// Skipped:
    /// - three equations out of the plane: the motion is planar
    /// - position, velocity, angular velocity: the accelerations do not depend on them
    /// - energy, momentum, balance: not in `outputs`
    #[derive(Clone, Debug)]
    pub struct Towed {
        params: TowedParams,
        linear_x: f64,
        from_pull: f64,
        from_pull_1: f64,
        swing_rate: f64,
        hanging: f64,
    }
    /// Parameters of [`Towed`], in SI units.
    #[allow(clippy::struct_field_names)]
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct TowedParams {
        /// `pull` in N, 40 by default.
        pub pull: f64,
    }
    ::newton_euler::private::record! {
        TowedParams { "N" pull : f64 = 40.0 }
    }
    impl Towed {
        /// The equations of motion, as evaluated.
        pub const EQUATIONS: &str = {
            const TEXT: &str = "# angle: angle, rad\n# linear_x linear_y: acceleration, m / s ^ 2, world axes\n# angular: angular acceleration, rad / s ^ 2\n# pull: parameter, N\n# once, in the constructor\n# (1.3), world axes: a = sum of F / m\nlinear_x = 0.08333333333333333 * pull\nfrom_pull = 0.25 * pull\nproduct = -0.05 * pull\nfrom_pull_1 = 0.05 * pull\nswing_rate = sqrt(hypot(product, - 0.25 * pull))\nhanging = atan2(product, from_pull)\n# at every evaluation\n(sine, cosine) = sin_cos(angle)\n# (1.4): w' = M / J\nangular = -(from_pull * sine + from_pull_1 * cosine)\nlinear_y = 0.0";
            TEXT
        };
        /// Their operation counts, by function and stage.
        pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
            ::newton_euler::private::Operations::parameter("new", [5, 0, 0, 1, 2, 0]),
            ::newton_euler::private::Operations::state(
                "acceleration",
                [2, 1, 0, 0, 2, 0],
            ),
        ];
        /// The terms that were left out, and why.
        pub const SKIPPED: &[&str] = &[
            "three equations out of the plane: the motion is planar",
            "position, velocity, angular velocity: the accelerations do not depend on them",
            "energy, momentum, balance: not in `outputs`",
        ];
        /// Checks the parameters, and computes everything that depends on them alone.
        /// - `pull` = 40 N
        ///
        /// # Errors
        /// A parameter is not finite, or no body can have the resulting mass or inertia.
        pub fn new(
            params: TowedParams,
        ) -> ::core::result::Result<Self, ::newton_euler::private::InvalidBody> {
            ::newton_euler::private::check_finite(&[("pull", params.pull)])?;
            let TowedParams { pull } = params;
            /// (1.3), world axes: a = sum of F / m
            let linear_x = 0.08333333333333333 * pull;
            let from_pull = 0.25 * pull;
            let product = -0.05 * pull;
            let from_pull_1 = 0.05 * pull;
            let swing_rate = ::newton_euler::private::math::sqrt(
                ::newton_euler::private::math::hypot(product, -0.25 * pull),
            );
            let hanging = ::newton_euler::private::math::atan2(product, from_pull);
            ::newton_euler::private::check_derived(
                &[
                    ("`pull`", linear_x),
                    ("`pull`", from_pull),
                    ("`pull`", from_pull_1),
                    ("`pull`", swing_rate),
                    ("`pull`", hanging),
                ],
            )?;
            ::core::result::Result::Ok(Self {
                params,
                linear_x,
                from_pull,
                from_pull_1,
                swing_rate,
                hanging,
            })
        }
        /// The parameters of this body.
        #[must_use]
        pub fn params(&self) -> &TowedParams {
            &self.params
        }
    }
    impl ::core::default::Default for TowedParams {
        fn default() -> Self {
            Self { pull: 40.0 }
        }
    }
    impl ::core::default::Default for Towed {
        fn default() -> Self {
            Self::new(<TowedParams as ::core::default::Default>::default())
                .expect("the defaults were checked at expansion")
        }
    }
    impl ::newton_euler::private::RigidBody for Towed {
        type Scalar = f64;
        type State = ::newton_euler::private::Planar;
        type Input = ();
        #[inline]
        #[allow(unused_doc_comments)]
        fn acceleration(
            &self,
            _time: f64,
            state: &::newton_euler::private::Planar,
            _input: &(),
        ) -> ::newton_euler::private::PlanarAcceleration {
            let angle = state.angle;
            let (sine, cosine) = ::newton_euler::private::math::sin_cos(angle);
            /// (1.4): w' = M / J
            let angular = -(self.from_pull * sine + self.from_pull_1 * cosine);
            ::newton_euler::private::PlanarAcceleration {
                linear: ::core::convert::Into::into([self.linear_x, 0.0]),
                angular: angular,
            }
        }
    }
    impl ::newton_euler::private::Integrate for Towed {
        type Best = ::newton_euler::private::ClosedForm;
    }
    impl ::newton_euler::private::Flow for Towed {
        type Path = ::newton_euler::private::Flight<
            ::newton_euler::private::Pendulum,
            2,
        >;
        fn path(
            &self,
            state: &::newton_euler::private::Planar,
        ) -> ::newton_euler::private::Flight<::newton_euler::private::Pendulum, 2> {
            ::newton_euler::private::Flight {
                center: ::newton_euler::private::Parabola {
                    position: state.position,
                    velocity: state.velocity,
                    acceleration: ::core::convert::Into::into([self.linear_x, 0.0]),
                },
                rotation: ::newton_euler::private::Pendulum::new(
                    self.swing_rate,
                    self.hanging,
                    &::newton_euler::private::Hinge {
                        angle: state.angle,
                        angular_velocity: state.angular_velocity,
                    },
                ),
            }
        }
    }
    impl ::newton_euler::private::Structured for Towed {
        const STRUCTURE: ::newton_euler::private::Structure = ::newton_euler::private::Structure {
            linear: ::newton_euler::private::Dependence {
                world: ::newton_euler::private::Symmetry::None,
                body: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                ..::newton_euler::private::Dependence::NOTHING
            },
            angular: ::newton_euler::private::Dependence {
                attitude: true,
                world: ::newton_euler::private::Symmetry::None,
                body: ::newton_euler::private::Symmetry::None,
                ..::newton_euler::private::Dependence::NOTHING
            },
            ..::newton_euler::private::Structure::GENERAL
        };
    }
}
#[allow(unused_imports, unreachable_pub)]
pub use equations_of_Towed::{Towed, TowedParams};
