#[allow(non_snake_case, unreachable_pub)]
mod equations_of_Top {
    /// A heavy symmetric top, for any scalar.
    ///
    /// Inertia about G:
    /// - symmetric about n = (0, 0, 1), prolate: 0.001 kg m^2 about n, 0.002 across
    ///
    /// Operations:
    /// - `new`: 3 mul + 2 add + 2 div
    /// - `acceleration`: 9 mul + 4 add
    ///
    /// Skipped:
    /// - the force balance: the reaction of the support has no moment about it
    /// - products of inertia: the axes are principal
    /// - (w x J w)_z: the other two moments of inertia are equal
    /// - the angular acceleration about z: nothing turns the body about its axis of symmetry
    /// - two rows of the rotation: what turns is along z in world axes
    /// - energy, momentum, balance: not in `outputs`
    #[derive(Clone, Debug)]
    pub struct Top<T: ::newton_euler::private::Scalar> {
        params: TopParams<T>,
        coupling_x: T,
        from_length: T,
    }
    /// Parameters of [`Top`], in SI units.
    #[allow(clippy::struct_field_names)]
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct TopParams<T: ::newton_euler::private::Scalar> {
        /// `length` in m, 0.1 by default.
        pub length: T,
    }
    ::newton_euler::private::record! {
        TopParams < T > { "m" length : T = < T as ::core::default::Default > ::default()
        .constant(0.1, 0.1) }
    }
    impl<T: ::newton_euler::private::Scalar> Top<T> {
        /// The equations of motion, as evaluated.
        pub const EQUATIONS: &str = {
            const TEXT: &str = "# qx qy qz qw: attitude, a unit quaternion, from body to world axes\n# wx wy wz: angular velocity, rad / s, body axes\n# angular_x angular_y angular_z: angular acceleration, rad / s ^ 2, body axes\n# length: parameter, m\n# once, in the constructor\nproduct = 0.3 * (length * length)\ninertia_about_support_xx = 0.002 + product\ncoupling_x = (0.001 + product) / inertia_about_support_xx\nfrom_length = -5.88399 * length / inertia_about_support_xx\n# at every evaluation\n# rate at which w turns in the body: (J_1 - J_3) / J_1 w_3\nprecession = coupling_x * wz\n# (1.4), body axes: w' = J^-1 (M - w x J w)\nangular_x = wy * precession - from_length * (qy * qz + qw * qx)\nangular_y = from_length * (qx * qz - qw * qy) - wx * precession\nangular_z = 0.0";
            TEXT
        };
        /// Their operation counts, by function and stage.
        pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
            ::newton_euler::private::Operations::parameter("new", [3, 2, 2, 0, 0, 0]),
            ::newton_euler::private::Operations::state(
                "acceleration",
                [9, 4, 0, 0, 0, 0],
            ),
        ];
        /// The terms that were left out, and why.
        pub const SKIPPED: &[&str] = &[
            "the force balance: the reaction of the support has no moment about it",
            "products of inertia: the axes are principal",
            "(w x J w)_z: the other two moments of inertia are equal",
            "the angular acceleration about z: nothing turns the body about its axis of symmetry",
            "two rows of the rotation: what turns is along z in world axes",
            "energy, momentum, balance: not in `outputs`",
        ];
        /// Checks the parameters, and computes everything that depends on them alone.
        /// - `length` = 0.1 m
        ///
        /// # Errors
        /// A parameter is not finite, or no body can have the resulting mass or inertia.
        pub fn new(
            params: TopParams<T>,
        ) -> ::core::result::Result<Self, ::newton_euler::private::InvalidBody> {
            ::newton_euler::private::check_finite(&[("length", params.length)])?;
            let TopParams { length } = params;
            let mass = params.length.constant(0.3, 0.3);
            let inertia_xx = params.length.constant(0.002, 0.002);
            let inertia_zz = params.length.constant(0.001, 0.001);
            let constant = params.length.constant(-5.88399, -5.88399);
            let product = mass * (length * length);
            let inertia_about_support_xx = inertia_xx + product;
            let coupling_x = (inertia_zz + product) / inertia_about_support_xx;
            let from_length = constant * length / inertia_about_support_xx;
            ::newton_euler::private::check_derived(
                &[("`length`", coupling_x), ("`length`", from_length)],
            )?;
            ::core::result::Result::Ok(Self {
                params,
                coupling_x,
                from_length,
            })
        }
        /// The parameters of this body.
        #[must_use]
        pub fn params(&self) -> &TopParams<T> {
            &self.params
        }
    }
    impl<T: ::newton_euler::private::Scalar> ::core::default::Default for TopParams<T> {
        fn default() -> Self {
            Self {
                length: <T as ::core::default::Default>::default().constant(0.1, 0.1),
            }
        }
    }
    impl<T: ::newton_euler::private::Scalar> ::core::default::Default for Top<T> {
        fn default() -> Self {
            Self::new(<TopParams<T> as ::core::default::Default>::default())
                .expect("the defaults make a body in the precision of `f64`")
        }
    }
    impl<T: ::newton_euler::private::Scalar> ::newton_euler::private::RigidBody
    for Top<T> {
        type Scalar = T;
        type State = ::newton_euler::private::generic::Rotation<T>;
        type Input = ();
        #[allow(clippy::inline_always)]
        #[inline(always)]
        #[allow(unused_doc_comments)]
        fn acceleration(
            &self,
            _time: T,
            state: &::newton_euler::private::generic::Rotation<T>,
            _input: &(),
        ) -> ::newton_euler::private::Vector3<T> {
            let [qx, qy, qz, qw]: [T; 4] = ::core::convert::Into::into(
                state.attitude.coords,
            );
            let [wx, wy, wz]: [T; 3] = ::core::convert::Into::into(
                state.angular_velocity,
            );
            let zero = state.angular_velocity.x.constant(0.0, 0.0);
            /// rate at which w turns in the body: (J_1 - J_3) / J_1 w_3
            let precession = self.coupling_x * wz;
            /// (1.4), body axes: w' = J^-1 (M - w x J w)
            let angular_x = wy * precession - self.from_length * (qy * qz + qw * qx);
            let angular_y = self.from_length * (qx * qz - qw * qy) - wx * precession;
            ::core::convert::Into::into([angular_x, angular_y, zero])
        }
    }
    impl ::newton_euler::private::Integrate for Top<f64> {
        type Best = ::newton_euler::private::RungeKuttaPair;
    }
    impl<T: ::newton_euler::private::Scalar> ::newton_euler::private::Structured
    for Top<T> {
        const STRUCTURE: ::newton_euler::private::Structure = ::newton_euler::private::Structure {
            linear: ::newton_euler::private::Dependence::NOTHING,
            angular: ::newton_euler::private::Dependence {
                attitude: true,
                angular_velocity: true,
                world: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                body: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                ..::newton_euler::private::Dependence::NOTHING
            },
            is_force_free: true,
            keeps_spin: true,
            planes: [true, true, true],
            ..::newton_euler::private::Structure::GENERAL
        };
    }
    #[allow(clippy::inline_always)]
    impl<T: ::newton_euler::private::Scalar> ::newton_euler::private::Columns<T>
    for Top<T> {
        const COUNT: usize = 3;
        #[inline(always)]
        fn read(source: &mut impl ::newton_euler::private::Source<T>) -> Self {
            Self {
                params: ::newton_euler::private::Columns::read(source),
                coupling_x: ::newton_euler::private::Columns::read(source),
                from_length: ::newton_euler::private::Columns::read(source),
            }
        }
        #[inline(always)]
        fn write(&self, sink: &mut impl ::newton_euler::private::Sink<T>) {
            ::newton_euler::private::Columns::write(&self.params, sink);
            ::newton_euler::private::Columns::write(&self.coupling_x, sink);
            ::newton_euler::private::Columns::write(&self.from_length, sink);
        }
    }
    #[allow(clippy::inline_always)]
    impl<T: ::newton_euler::private::Scalar> ::newton_euler::private::Columns<T>
    for TopParams<T> {
        const COUNT: usize = 1;
        #[inline(always)]
        fn read(source: &mut impl ::newton_euler::private::Source<T>) -> Self {
            Self {
                length: ::newton_euler::private::Columns::read(source),
            }
        }
        #[inline(always)]
        fn write(&self, sink: &mut impl ::newton_euler::private::Sink<T>) {
            ::newton_euler::private::Columns::write(&self.length, sink);
        }
    }
    impl ::newton_euler::private::Generic for Top<f64> {
        type With<TopScalar: ::newton_euler::private::Scalar> = Top<TopScalar>;
        type Params = TopParams<f64>;
        fn build(
            params: Self::Params,
        ) -> ::core::result::Result<Self, ::newton_euler::private::InvalidBody> {
            Self::new(params)
        }
        fn parameters(&self) -> Self::Params {
            self.params
        }
    }
}
#[allow(unused_imports, unreachable_pub)]
pub use equations_of_Top::{Top, TopParams};
