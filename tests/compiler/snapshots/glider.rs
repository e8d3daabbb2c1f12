#[allow(non_snake_case, unreachable_pub)]
mod equations_of_Glider {
    /// A body that swings about a point, braked, with the series of its motion.
    ///
    /// Inertia about G:
    /// - general: three different principal moments
    /// - 0.02 kg m^2 about (1, 0, 0)
    /// - 0.03 kg m^2 about (0, 1, 0)
    /// - 0.04 kg m^2 about (0, 0, 1)
    ///
    /// Operations:
    /// - `new`: 4 mul
    /// - `acceleration`: 18 mul + 8 add + 1 sqrt
    ///
    /// Skipped:
    /// - the force balance: the reaction of the support has no moment about it
    /// - products of inertia: the axes are principal
    /// - (w x J w)_y: the other two moments of inertia are equal
    /// - two rows of the rotation: what turns is along z in world axes
    /// - energy, momentum, balance: not in `outputs`
    ///
    /// `integrate` takes Runge–Kutta steps, which are faster than its series; `.method(TaylorSeries { tolerance })` selects series.
    #[derive(Clone, Debug)]
    pub struct Glider {
        params: GliderParams,
        from_drag: f64,
        from_drag_1: f64,
        from_drag_2: f64,
        from_drag_3: f64,
    }
    /// Parameters of [`Glider`], in SI units.
    #[allow(clippy::struct_field_names)]
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub struct GliderParams {
        /// `drag` in N * m * s ^ 2, 0.02 by default.
        pub drag: f64,
    }
    ::newton_euler::private::record! {
        GliderParams { "N * m * s ^ 2" drag : f64 = 0.02 }
    }
    impl Glider {
        /// The equations of motion, as evaluated.
        pub const EQUATIONS: &str = {
            const TEXT: &str = "# qx qy qz qw: attitude, a unit quaternion, from body to world axes\n# wx wy wz: angular velocity, rad / s, body axes\n# angular_x angular_y angular_z: angular acceleration, rad / s ^ 2, body axes\n# drag: parameter, N * m * s ^ 2\n# once, in the constructor\nfrom_drag = 25.0 * drag\nfrom_drag_1 = 20.0 * drag\nfrom_drag_2 = -20.0 * drag\nfrom_drag_3 = -25.0 * drag\n# at every evaluation\nnorm = sqrt(wx * wx + wy * wy + wz * wz)\n# rate at which w turns in the body: (J_1 - J_3) / J_1 w_3\nprecession = -0.25 * wy\n# (1.4), body axes: w' = J^-1 (M - w x J w)\nangular_x = -(from_drag * (wx * norm) + 49.03325 * (qy * qz + qw * qx) + wz * precession)\nangular_y = 39.2266 * (qx * qz - qw * qy) - from_drag_1 * (wy * norm)\nangular_z = wx * precession - from_drag * (wz * norm)";
            TEXT
        };
        /// Their operation counts, by function and stage.
        pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
            ::newton_euler::private::Operations::parameter("new", [4, 0, 0, 0, 0, 0]),
            ::newton_euler::private::Operations::state(
                "acceleration",
                [18, 8, 0, 1, 0, 0],
            ),
        ];
        /// The terms that were left out, and why.
        pub const SKIPPED: &[&str] = &[
            "the force balance: the reaction of the support has no moment about it",
            "products of inertia: the axes are principal",
            "(w x J w)_y: the other two moments of inertia are equal",
            "two rows of the rotation: what turns is along z in world axes",
            "energy, momentum, balance: not in `outputs`",
        ];
        /// Checks the parameters, and computes everything that depends on them alone.
        /// - `drag` = 0.02 N * m * s ^ 2
        ///
        /// # Errors
        /// A parameter is not finite, or no body can have the resulting mass or inertia.
        pub fn new(
            params: GliderParams,
        ) -> ::core::result::Result<Self, ::newton_euler::private::InvalidBody> {
            ::newton_euler::private::check_finite(&[("drag", params.drag)])?;
            let GliderParams { drag } = params;
            let from_drag = 25.0 * drag;
            let from_drag_1 = 20.0 * drag;
            let from_drag_2 = -20.0 * drag;
            let from_drag_3 = -25.0 * drag;
            ::newton_euler::private::check_derived(
                &[
                    ("`drag`", from_drag),
                    ("`drag`", from_drag_1),
                    ("`drag`", from_drag_2),
                    ("`drag`", from_drag_3),
                ],
            )?;
            ::core::result::Result::Ok(Self {
                params,
                from_drag,
                from_drag_1,
                from_drag_2,
                from_drag_3,
            })
        }
        /// The parameters of this body.
        #[must_use]
        pub fn params(&self) -> &GliderParams {
            &self.params
        }
    }
    impl ::core::default::Default for GliderParams {
        fn default() -> Self {
            Self { drag: 0.02 }
        }
    }
    impl ::core::default::Default for Glider {
        fn default() -> Self {
            Self::new(<GliderParams as ::core::default::Default>::default())
                .expect("the defaults were checked at expansion")
        }
    }
    impl ::newton_euler::private::RigidBody for Glider {
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
            let norm = ::newton_euler::private::math::sqrt(wx * wx + wy * wy + wz * wz);
            /// rate at which w turns in the body: (J_1 - J_3) / J_1 w_3
            let precession = -0.25 * wy;
            /// (1.4), body axes: w' = J^-1 (M - w x J w)
            let angular_x = -(self.from_drag * (wx * norm)
                + 49.03325 * (qy * qz + qw * qx) + wz * precession);
            let angular_y = 39.2266 * (qx * qz - qw * qy)
                - self.from_drag_1 * (wy * norm);
            let angular_z = wx * precession - self.from_drag * (wz * norm);
            ::core::convert::Into::into([angular_x, angular_y, angular_z])
        }
    }
    impl ::newton_euler::private::Integrate for Glider {
        type Best = ::newton_euler::private::RungeKuttaPair;
    }
    impl ::newton_euler::private::Taylor for Glider {
        type Products<A: ::newton_euler::private::Arithmetic, const COUNT: usize> = ::newton_euler::private::Products<
            A,
            36,
            COUNT,
        >;
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
            let norm = ::newton_euler::private::math::sqrt(wx * wx + wy * wy + wz * wz);
            let ratio = 0.5 / norm;
            products
                .start::<
                    0,
                    16,
                    2,
                >([
                    [(0.5, qy, wz), (-0.5, qz, wy)],
                    [(0.5, qw, wx), (0.0, 0.0, 0.0)],
                    [(0.5, qz, wx), (-0.5, qx, wz)],
                    [(0.5, qw, wy), (0.0, 0.0, 0.0)],
                    [(0.5, qx, wy), (-0.5, qy, wx)],
                    [(0.5, qw, wz), (0.0, 0.0, 0.0)],
                    [(-0.5, qz, wz), (-0.5, qx, wx)],
                    [(-0.5, qy, wy), (0.0, 0.0, 0.0)],
                    [(ratio, wx, wx), (ratio, wy, wy)],
                    [(ratio, wz, wz), (-ratio, 0.0, 0.0)],
                    [(49.03325, qy, qz), (49.03325, qw, qx)],
                    [(39.2266, qx, qz), (-39.2266, qw, qy)],
                    [(0.25, wy, wz), (0.0, 0.0, 0.0)],
                    [(0.25, wx, wy), (0.0, 0.0, 0.0)],
                    [(0.0, 0.0, 0.0); 2],
                    [(0.0, 0.0, 0.0); 2],
                ]);
            products
                .start::<
                    32,
                    4,
                    1,
                >([
                    [(self.from_drag_3, wx, norm)],
                    [(self.from_drag_2, wy, norm)],
                    [(self.from_drag_3, wz, norm)],
                    [(0.0, 0.0, 0.0); 1],
                ]);
            series.start(state);
            let mut rates = products
                .times(
                    [
                        0.5 * (qy * wz - qz * wy + qw * wx),
                        0.5 * (qz * wx - qx * wz + qw * wy),
                        0.5 * (qx * wy - qy * wx + qw * wz),
                        -0.5 * (qx * wx + qy * wy + qz * wz),
                        0.25 * (wy * wz)
                            - (self.from_drag * (wx * norm)
                                + 49.03325 * (qy * qz + qw * qx)),
                        39.2266 * (qx * qz - qw * qy) - self.from_drag_1 * (wy * norm),
                        -(self.from_drag * (wz * norm) + 0.25 * (wx * wy)),
                        0.0,
                    ],
                    1.0,
                );
            for n in 1..COUNT - 1 {
                let [qx_n, qy_n, qz_n, qw_n, wx_n, wy_n, wz_n, ..] = series
                    .extend(products, n, rates);
                let [qx_rate_n_1, qx_rate_n_2, qy_rate_n_1, qy_rate_n_2, qz_rate_n_1,
                qz_rate_n_2, qw_rate_n_1, qw_rate_n_2, norm_n_1, norm_n_2, qy_qz_terms_n,
                qx_qz_terms_n, wy_wz_n, wx_wy_n, ..] = products
                    .terms::<
                        0,
                        16,
                        2,
                    >(
                        n,
                        [
                            [(qy_n, wz_n), (qz_n, wy_n)],
                            [(qw_n, wx_n), (0.0, 0.0)],
                            [(qz_n, wx_n), (qx_n, wz_n)],
                            [(qw_n, wy_n), (0.0, 0.0)],
                            [(qx_n, wy_n), (qy_n, wx_n)],
                            [(qw_n, wz_n), (0.0, 0.0)],
                            [(qz_n, wz_n), (qx_n, wx_n)],
                            [(qy_n, wy_n), (0.0, 0.0)],
                            [(wx_n, wx_n), (wy_n, wy_n)],
                            [(wz_n, wz_n), (0.0, 0.0)],
                            [(qy_n, qz_n), (qw_n, qx_n)],
                            [(qx_n, qz_n), (qw_n, qy_n)],
                            [(wy_n, wz_n), (0.0, 0.0)],
                            [(wx_n, wy_n), (0.0, 0.0)],
                            [(0.0, 0.0); 2],
                            [(0.0, 0.0); 2],
                        ],
                    );
                let qx_rate_n = qx_rate_n_1 + qx_rate_n_2;
                let qy_rate_n = qy_rate_n_1 + qy_rate_n_2;
                let qz_rate_n = qz_rate_n_1 + qz_rate_n_2;
                let qw_rate_n = qw_rate_n_1 + qw_rate_n_2;
                let norm_n = norm_n_1 + norm_n_2;
                let [wx_rate_terms_n, wy_rate_terms_n, wz_rate_terms_n, ..] = products
                    .terms::<
                        32,
                        4,
                        1,
                    >(
                        n,
                        [
                            [(wx_n, norm_n)],
                            [(wy_n, norm_n)],
                            [(wz_n, norm_n)],
                            [(0.0, 0.0); 1],
                        ],
                    );
                products.complete(n, &[(25, norm_n)], &[(25, norm_n)]);
                rates = [
                    qx_rate_n,
                    qy_rate_n,
                    qz_rate_n,
                    qw_rate_n,
                    wx_rate_terms_n - qy_qz_terms_n + wy_wz_n,
                    qx_qz_terms_n + wy_rate_terms_n,
                    wz_rate_terms_n - wx_wy_n,
                    0.0,
                ];
            }
            series.extend(products, COUNT - 1, rates);
        }
    }
    impl ::newton_euler::private::Structured for Glider {
        const STRUCTURE: ::newton_euler::private::Structure = ::newton_euler::private::Structure {
            linear: ::newton_euler::private::Dependence::NOTHING,
            angular: ::newton_euler::private::Dependence {
                attitude: true,
                angular_velocity: true,
                world: ::newton_euler::private::Symmetry::About([0.0, 0.0, 1.0]),
                body: ::newton_euler::private::Symmetry::None,
                ..::newton_euler::private::Dependence::NOTHING
            },
            is_force_free: true,
            planes: [true, true, true],
            ..::newton_euler::private::Structure::GENERAL
        };
    }
}
#[allow(unused_imports, unreachable_pub)]
pub use equations_of_Glider::{Glider, GliderParams};
