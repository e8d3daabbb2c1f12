#[allow(non_snake_case, unreachable_pub)]
mod equations_of_Gyroscope {
    /// A heavy symmetric top, with the series of its motion in axes that do not spin with it.
    ///
    /// Operations:
    /// - `new`: 1 mul + 6 add + 4 div
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
    pub struct Gyroscope {
        params: GyroscopeParams,
        coupling_x: f64,
        from_across: f64,
        from_across_1: f64,
        from_rotor_across: f64,
        from_rotor_across_1: f64,
    }
    /// Parameters of [`Gyroscope`], in SI units.
    #[allow(clippy::struct_field_names)]
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct GyroscopeParams {
        /// `rotor` in kg * m ^ 2, 0.0005 by default.
        pub rotor: f64,
        /// `across` in kg * m ^ 2, 0.0004 by default.
        pub across: f64,
    }
    ::newton_euler::private::record! {
        GyroscopeParams { "kg * m ^ 2" rotor : f64 = 0.0005, "kg * m ^ 2" across : f64 =
        0.0004 }
    }
    impl Gyroscope {
        /// The equations of motion, as evaluated.
        pub const EQUATIONS: &str = {
            const TEXT: &str = "# qx qy qz qw: attitude, a unit quaternion, from body to world axes\n# wx wy wz: angular velocity, rad / s, body axes\n# angular_x angular_y angular_z: angular acceleration, rad / s ^ 2, body axes\n# rotor: parameter, kg * m ^ 2\n# across: parameter, kg * m ^ 2\n# once, in the constructor\ninertia_about_support_xx = 0.0005 + across\nfrom_rotor_across = rotor / (rotor + 2.0 * inertia_about_support_xx - rotor)\ncoupling_x = (across - rotor + 0.0005) / inertia_about_support_xx\nfrom_across = 0.196133 / inertia_about_support_xx\nfrom_across_1 = -0.196133 / inertia_about_support_xx\nfrom_rotor_across_1 = 1.0 - from_rotor_across\n# at every evaluation\n# rate at which w turns in the body: (J_1 - J_3) / J_1 w_3\nprecession = coupling_x * wz\n# (1.4), body axes: w' = J^-1 (M - w x J w)\nangular_x = wy * precession + from_across * (qy * qz + qw * qx)\nangular_y = from_across_1 * (qx * qz - qw * qy) - wx * precession\nangular_z = 0.0";
            TEXT
        };
        /// Their operation counts, by function and stage.
        pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
            ::newton_euler::private::Operations::parameter("new", [1, 6, 4, 0, 0, 0]),
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
        /// - `rotor` = 0.0005 kg * m ^ 2
        /// - `across` = 0.0004 kg * m ^ 2
        ///
        /// # Errors
        /// A parameter is not finite, or no body can have the resulting mass or inertia.
        pub fn new(
            params: GyroscopeParams,
        ) -> ::core::result::Result<Self, ::newton_euler::private::InvalidBody> {
            ::newton_euler::private::check_finite(
                &[("rotor", params.rotor), ("across", params.across)],
            )?;
            let GyroscopeParams { rotor, across } = params;
            let inertia_about_support_xx = 0.0005 + across;
            let from_rotor_across = rotor
                / (rotor + 2.0 * inertia_about_support_xx - rotor);
            ::newton_euler::private::check_inertia([
                across,
                across,
                rotor,
                0.0,
                0.0,
                0.0,
            ])?;
            let coupling_x = (across - rotor + 0.0005) / inertia_about_support_xx;
            let from_across = 0.196133 / inertia_about_support_xx;
            let from_across_1 = -0.196133 / inertia_about_support_xx;
            let from_rotor_across_1 = 1.0 - from_rotor_across;
            ::newton_euler::private::check_derived(
                &[
                    ("`rotor`, `across`", coupling_x),
                    ("`across`", from_across),
                    ("`across`", from_across_1),
                    ("`rotor`, `across`", from_rotor_across),
                    ("`rotor`, `across`", from_rotor_across_1),
                ],
            )?;
            ::core::result::Result::Ok(Self {
                params,
                coupling_x,
                from_across,
                from_across_1,
                from_rotor_across,
                from_rotor_across_1,
            })
        }
        /// The parameters of this body.
        #[must_use]
        pub fn params(&self) -> &GyroscopeParams {
            &self.params
        }
    }
    impl ::core::default::Default for GyroscopeParams {
        fn default() -> Self {
            Self {
                rotor: 0.0005,
                across: 0.0004,
            }
        }
    }
    impl ::core::default::Default for Gyroscope {
        fn default() -> Self {
            Self::new(<GyroscopeParams as ::core::default::Default>::default())
                .expect("the defaults were checked at expansion")
        }
    }
    impl ::newton_euler::private::RigidBody for Gyroscope {
        type Scalar = f64;
        type State = ::newton_euler::private::Rotation;
        type Input = ();
        #[inline]
        #[allow(unused_doc_comments)]
        fn acceleration(
            &self,
            _time: f64,
            state: &::newton_euler::private::Rotation,
            _input: &(),
        ) -> ::newton_euler::private::Vector3<f64> {
            let [qx, qy, qz, qw]: [f64; 4] = ::core::convert::Into::into(
                state.attitude.coords,
            );
            let [wx, wy, wz]: [f64; 3] = ::core::convert::Into::into(
                state.angular_velocity,
            );
            /// rate at which w turns in the body: (J_1 - J_3) / J_1 w_3
            let precession = self.coupling_x * wz;
            /// (1.4), body axes: w' = J^-1 (M - w x J w)
            let angular_x = wy * precession + self.from_across * (qy * qz + qw * qx);
            let angular_y = self.from_across_1 * (qx * qz - qw * qy) - wx * precession;
            ::core::convert::Into::into([angular_x, angular_y, 0.0])
        }
    }
    impl ::newton_euler::private::Integrate for Gyroscope {
        type Best = ::newton_euler::private::TaylorSeries;
    }
    impl ::newton_euler::private::Taylor for Gyroscope {
        type Products<A: ::newton_euler::private::Arithmetic, const COUNT: usize> = ::newton_euler::private::Products<
            A,
            16,
            COUNT,
        >;
        fn axes(
            &self,
            time: f64,
            state: &::newton_euler::private::Rotation,
        ) -> ::newton_euler::private::Axes {
            let [_, _, wz]: [f64; 3] = ::core::convert::Into::into(
                state.angular_velocity,
            );
            ::newton_euler::private::Axes::despun(
                time,
                [0.0, 0.0, 1.0],
                self.from_rotor_across_1 * wz,
            )
        }
        #[allow(unused_doc_comments)]
        #[allow(clippy::inline_always)]
        #[inline(always)]
        fn expand<A: ::newton_euler::private::Arithmetic, const COUNT: usize>(
            &self,
            _time: f64,
            state: &::newton_euler::private::Rotation,
            _input: &(),
            products: &mut Self::Products<A, COUNT>,
            series: &mut ::newton_euler::private::Series<
                ::newton_euler::private::Rotation,
                COUNT,
            >,
        ) {
            let [qx, qy, qz, qw]: [f64; 4] = ::core::convert::Into::into(
                state.attitude.coords,
            );
            let [wx, wy, wz]: [f64; 3] = ::core::convert::Into::into(
                state.angular_velocity,
            );
            let wx_wz = wx * wz;
            let wy_wz = wy * wz;
            /// rate at which w turns in the body: (J_1 - J_3) / J_1 w_3
            let precession = self.coupling_x * wz;
            let spin = self.from_rotor_across_1 * wz;
            let axes_spin = self.from_rotor_across * wz;
            let difference = precession - spin;
            let product = 0.5 * axes_spin;
            let product_1 = -0.5 * axes_spin;
            let minus_difference = -difference;
            products
                .start::<
                    0,
                    8,
                    2,
                >([
                    [(-0.5, qz, wy), (0.5, qw, wx)],
                    [(0.5, qz, wx), (0.5, qw, wy)],
                    [(0.5, qx, wy), (-0.5, qy, wx)],
                    [(-0.5, qx, wx), (-0.5, qy, wy)],
                    [(self.from_across, qy, qz), (self.from_across, qw, qx)],
                    [(self.from_across_1, qx, qz), (self.from_across, qw, qy)],
                    [(0.0, 0.0, 0.0), (0.0, 0.0, 0.0)],
                    [(0.0, 0.0, 0.0); 2],
                ]);
            series.start(state);
            let mut rates = products
                .times(
                    [
                        0.5 * (self.from_rotor_across * (qy * wz) - qz * wy + qw * wx),
                        0.5 * (qz * wx - self.from_rotor_across * (qx * wz) + qw * wy),
                        0.5 * (qx * wy - qy * wx + self.from_rotor_across * (qw * wz)),
                        -0.5 * (qx * wx + qy * wy + self.from_rotor_across * (qz * wz)),
                        self.from_across * (qy * qz + qw * qx) + self.coupling_x * wy_wz
                            - self.from_rotor_across_1 * wy_wz,
                        self.from_across_1 * (qx * qz - qw * qy)
                            - self.coupling_x * wx_wz + self.from_rotor_across_1 * wx_wz,
                        0.0,
                        0.0,
                    ],
                    1.0,
                );
            for n in 1..COUNT - 1 {
                let [qx_n, qy_n, qz_n, qw_n, wx_n, wy_n, _, ..] = series
                    .extend(products, n, rates);
                let sums = products
                    .terms::<
                        0,
                        8,
                        2,
                    >(
                        n,
                        [
                            [(qz_n, wy_n), (qw_n, wx_n)],
                            [(qz_n, wx_n), (qw_n, wy_n)],
                            [(qx_n, wy_n), (qy_n, wx_n)],
                            [(qx_n, wx_n), (qy_n, wy_n)],
                            [(qy_n, qz_n), (qw_n, qx_n)],
                            [(qx_n, qz_n), (qw_n, qy_n)],
                            [(0.0, 0.0), (0.0, 0.0)],
                            [(0.0, 0.0); 2],
                        ],
                    );
                rates = products
                    .plus(
                        sums,
                        [
                            [(product, qy_n)],
                            [(product_1, qx_n)],
                            [(product, qw_n)],
                            [(product_1, qz_n)],
                            [(difference, wy_n)],
                            [(minus_difference, wx_n)],
                            [(0.0, 0.0)],
                            [(0.0, 0.0); 1],
                        ],
                    );
            }
            series.extend(products, COUNT - 1, rates);
        }
    }
    impl ::newton_euler::private::Structured for Gyroscope {
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
}
#[allow(unused_imports, unreachable_pub)]
pub use equations_of_Gyroscope::{Gyroscope, GyroscopeParams};
