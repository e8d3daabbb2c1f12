/// A crank that drives a slider by a rod: a closed loop.
///
/// Joints:
/// - `bearing`: revolute from the ground to `crank`
/// - `big_end`: revolute from `crank` to `rod`
/// - `guide`: prismatic from the ground to `slider`
/// - `small_end`: revolute from `rod` to `slider`, closes a loop
///
/// Operations:
/// - `acceleration`: 42 mul + 19 add + 2 div + 4 trig + 2 other
/// - `reactions`: 69 mul + 35 add + 2 div + 6 trig + 2 other
/// - `violations`: 8 mul + 8 add + 4 trig
/// - `check`: 26 mul + 19 add + 2 div + 4 sqrt + 5 trig + 18 other
/// - `project`: 32 mul + 21 add + 2 div + 4 sqrt + 5 trig + 16 other
///
/// Skipped:
/// - energy, momentum, balance, inverse, mass_matrix, jacobian: not in `outputs`
///
/// # Singular configurations
///
/// Where the constraints do not determine their reactions, `acceleration` is NaN, and `reactions`, if requested, returns an error.
#[derive(Clone, Debug, Default)]
pub struct SliderCrank {}
/// Inputs of [`SliderCrank`] at each evaluation, in SI units.
#[allow(clippy::struct_field_names)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SliderCrankInput {
    /// `torque` in N * m.
    pub torque: f64,
}
::newton_euler::private::record! {
    SliderCrankInput { "N * m" torque : f64 }
}
::newton_euler::private::system_state! {
    #[doc = " The state of [`SliderCrank`]: the state of each joint."] SliderCrankState
    #[doc = " The acceleration of [`SliderCrank`]: the acceleration of each joint."]
    SliderCrankAcceleration { #[doc = " The joint `bearing`."] bearing : Hinge #[doc =
    " The joint `bearing`."] => f64, #[doc = " The joint `big_end`."] big_end : Hinge
    #[doc = " The joint `big_end`."] => f64, #[doc = " The joint `guide`."] guide : Slide
    #[doc = " The joint `guide`."] => f64 }
}
impl SliderCrank {
    /// The equations of motion, as evaluated.
    pub const EQUATIONS: &str = {
        const TEXT: &str = "# bearing_angle big_end_angle: angle, rad\n# bearing_w big_end_w: angular velocity, rad / s\n# guide_a: acceleration, m / s ^ 2\n# bearing_alpha big_end_alpha: angular acceleration, rad / s ^ 2\n# torque: input, N * m\n(sine_bearing, cosine_bearing) = sin_cos(bearing_angle)\n# w of each body, in its axes: of its carrier, and of its joint\nw_rod = bearing_w + big_end_w\n# angle of each body from the ground\nangle_rod = bearing_angle + big_end_angle\narm_crank_x = 0.05 * cosine_bearing\narm_crank_y = 0.05 * sine_bearing\n(sine_rod, cosine_rod) = sin_cos(angle_rod)\narm_rod_x = 0.18 * cosine_rod\narm_rod_y = 0.18 * sine_rod\n# S r = w' x r + w x (w x r): what an arm r adds to a\nminus_sweep_crank_xx = bearing_w * bearing_w\nminus_sweep_rod_xx = w_rod * w_rod\nminus_small_end_1_to_balance = arm_crank_x * minus_sweep_crank_xx + arm_rod_x * minus_sweep_rod_xx\nminus_small_end_2_to_balance = arm_crank_y * minus_sweep_crank_xx + arm_rod_y * minus_sweep_rod_xx\nsmall_end_1_by_loop_1 = arm_crank_x * arm_rod_y - arm_crank_y * arm_rod_x\ncoupling_bearing_big_end = 0.13333333333333333 * (arm_crank_x * arm_rod_x + arm_crank_y * arm_rod_y)\n# load on a joint by the acceleration of the independent joint\nmomentum_bearing = arm_crank_x * coupling_bearing_big_end - 0.003 * arm_rod_x\nmomentum_big_end = 0.00264 * arm_crank_x - arm_rod_x * coupling_bearing_big_end\n# inertia that the independent joint moves\ninertia_loop_1 = arm_crank_x * momentum_big_end - arm_rod_x * momentum_bearing\n# 1 over it, or NaN if it is only rounding error: there, constraints are dependent\ninverse_inertia_loop_1 = 1 / inertia_loop_1\nfixed_bearing = inverse_inertia_loop_1 * (minus_small_end_2_to_balance * momentum_big_end)\nminus_fixed_big_end = inverse_inertia_loop_1 * (minus_small_end_2_to_balance * momentum_bearing)\nminus_small_end_1_to_balance_1 = arm_crank_y * fixed_bearing - arm_rod_y * minus_fixed_big_end + minus_small_end_1_to_balance\nmomentum_guide = 0.3 * small_end_1_by_loop_1\ninertia_loop_2 = inertia_loop_1 + small_end_1_by_loop_1 * momentum_guide\ninverse_inertia_loop_2 = 1 / inertia_loop_2\ndriving_loop_2 = arm_rod_x * (torque + 0.13333333333333333 * (minus_sweep_rod_xx * small_end_1_by_loop_1)) + 0.13333333333333333 * (arm_crank_x * (minus_sweep_crank_xx * small_end_1_by_loop_1))\nguide_a = inverse_inertia_loop_2 * (small_end_1_by_loop_1 * driving_loop_2 - inertia_loop_1 * minus_small_end_1_to_balance_1)\nminus_acceleration_loop_1 = inverse_inertia_loop_2 * (minus_small_end_1_to_balance_1 * momentum_guide + driving_loop_2)\nbearing_alpha = fixed_bearing + arm_rod_x * minus_acceleration_loop_1\nminus_alpha_total_rod = minus_fixed_big_end + arm_crank_x * minus_acceleration_loop_1\nminus_big_end_alpha = bearing_alpha + minus_alpha_total_rod\nbig_end_alpha = -minus_big_end_alpha";
        TEXT
    };
    /// Their operation counts, by function and stage.
    pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
        ::newton_euler::private::Operations::state("acceleration", [42, 19, 2, 0, 4, 2]),
        ::newton_euler::private::Operations::state("reactions", [69, 35, 2, 0, 6, 2]),
        ::newton_euler::private::Operations::state("violations", [8, 8, 0, 0, 4, 0]),
        ::newton_euler::private::Operations::state("check", [26, 19, 2, 4, 5, 18]),
        ::newton_euler::private::Operations::state("project", [32, 21, 2, 4, 5, 16]),
    ];
    /// The terms that were left out, and why.
    pub const SKIPPED: &[&str] = &[
        "energy, momentum, balance, inverse, mass_matrix, jacobian: not in `outputs`",
    ];
}
impl ::newton_euler::private::RigidBody for SliderCrank {
    type Scalar = f64;
    type State = SliderCrankState;
    type Input = SliderCrankInput;
    #[inline]
    #[allow(unused_doc_comments)]
    fn acceleration(
        &self,
        _time: f64,
        state: &SliderCrankState,
        input: &SliderCrankInput,
    ) -> SliderCrankAcceleration {
        let SliderCrankInput { torque } = *input;
        let bearing_angle = state.bearing.angle;
        let bearing_w = state.bearing.angular_velocity;
        let big_end_angle = state.big_end.angle;
        let big_end_w = state.big_end.angular_velocity;
        let (sine_bearing, cosine_bearing) = ::newton_euler::private::math::sin_cos(
            bearing_angle,
        );
        /// w of each body, in its axes: of its carrier, and of its joint
        let w_rod = bearing_w + big_end_w;
        /// angle of each body from the ground
        let angle_rod = bearing_angle + big_end_angle;
        let arm_crank_x = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let (sine_rod, cosine_rod) = ::newton_euler::private::math::sin_cos(angle_rod);
        let arm_rod_x = 0.18 * cosine_rod;
        let arm_rod_y = 0.18 * sine_rod;
        /// S r = w' x r + w x (w x r): what an arm r adds to a
        let minus_sweep_crank_xx = bearing_w * bearing_w;
        let minus_sweep_rod_xx = w_rod * w_rod;
        let minus_small_end_1_to_balance = arm_crank_x * minus_sweep_crank_xx
            + arm_rod_x * minus_sweep_rod_xx;
        let minus_small_end_2_to_balance = arm_crank_y * minus_sweep_crank_xx
            + arm_rod_y * minus_sweep_rod_xx;
        let small_end_1_by_loop_1 = arm_crank_x * arm_rod_y - arm_crank_y * arm_rod_x;
        let coupling_bearing_big_end = 0.13333333333333333
            * (arm_crank_x * arm_rod_x + arm_crank_y * arm_rod_y);
        /// load on a joint by the acceleration of the independent joint
        let momentum_bearing = arm_crank_x * coupling_bearing_big_end
            - 0.003 * arm_rod_x;
        let momentum_big_end = 0.00264 * arm_crank_x
            - arm_rod_x * coupling_bearing_big_end;
        /// inertia that the independent joint moves
        let inertia_loop_1 = arm_crank_x * momentum_big_end
            - arm_rod_x * momentum_bearing;
        /// 1 over it, or NaN if it is only rounding error: there, constraints are dependent
        let inverse_inertia_loop_1 = ::newton_euler::private::determined(
            inertia_loop_1,
            0.0001038,
        );
        let fixed_bearing = inverse_inertia_loop_1
            * (minus_small_end_2_to_balance * momentum_big_end);
        let minus_fixed_big_end = inverse_inertia_loop_1
            * (minus_small_end_2_to_balance * momentum_bearing);
        let minus_small_end_1_to_balance_1 = arm_crank_y * fixed_bearing
            - arm_rod_y * minus_fixed_big_end + minus_small_end_1_to_balance;
        let momentum_guide = 0.3 * small_end_1_by_loop_1;
        let inertia_loop_2 = inertia_loop_1 + small_end_1_by_loop_1 * momentum_guide;
        let inverse_inertia_loop_2 = ::newton_euler::private::determined(
            inertia_loop_2,
            0.0001524,
        );
        let driving_loop_2 = arm_rod_x
            * (torque
                + 0.13333333333333333 * (minus_sweep_rod_xx * small_end_1_by_loop_1))
            + 0.13333333333333333
                * (arm_crank_x * (minus_sweep_crank_xx * small_end_1_by_loop_1));
        let guide_a = inverse_inertia_loop_2
            * (small_end_1_by_loop_1 * driving_loop_2
                - inertia_loop_1 * minus_small_end_1_to_balance_1);
        let minus_acceleration_loop_1 = inverse_inertia_loop_2
            * (minus_small_end_1_to_balance_1 * momentum_guide + driving_loop_2);
        let bearing_alpha = fixed_bearing + arm_rod_x * minus_acceleration_loop_1;
        let minus_alpha_total_rod = minus_fixed_big_end
            + arm_crank_x * minus_acceleration_loop_1;
        let minus_big_end_alpha = bearing_alpha + minus_alpha_total_rod;
        let big_end_alpha = -minus_big_end_alpha;
        SliderCrankAcceleration {
            bearing: bearing_alpha,
            big_end: big_end_alpha,
            guide: guide_a,
        }
    }
    #[cold]
    fn lost_load(
        &self,
        _time: f64,
        _state: &SliderCrankState,
        input: &SliderCrankInput,
    ) -> ::core::option::Option<&'static str> {
        let SliderCrankInput { torque } = *input;
        ::newton_euler::private::lost_load(&[("motor", &[torque])])
    }
}
impl ::newton_euler::private::Integrate for SliderCrank {
    type Best = ::newton_euler::private::Projected<
        ::newton_euler::private::RungeKuttaPair,
    >;
}
impl ::newton_euler::private::Constrained for SliderCrank {
    type Violations = [::newton_euler::private::Violation; 2];
    #[allow(unused_doc_comments)]
    fn violations(
        &self,
        _time: f64,
        state: &SliderCrankState,
        _input: &SliderCrankInput,
    ) -> [::newton_euler::private::Violation; 2] {
        let bearing_angle = state.bearing.angle;
        let bearing_w = state.bearing.angular_velocity;
        let big_end_angle = state.big_end.angle;
        let big_end_w = state.big_end.angular_velocity;
        let guide_position = state.guide.position;
        let guide_v = state.guide.velocity;
        let (sine_bearing, cosine_bearing) = ::newton_euler::private::math::sin_cos(
            bearing_angle,
        );
        /// w of each body, in its axes: of its carrier, and of its joint
        let w_rod = bearing_w + big_end_w;
        /// angle of each body from the ground
        let angle_rod = bearing_angle + big_end_angle;
        let arm_crank_x = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let minus_v_rod_x = bearing_w * arm_crank_y;
        let v_rod_y = bearing_w * arm_crank_x;
        let (sine_rod, cosine_rod) = ::newton_euler::private::math::sin_cos(angle_rod);
        let arm_rod_x = 0.18 * cosine_rod;
        let arm_rod_y = 0.18 * sine_rod;
        let w_rod_arm_rod_y = w_rod * arm_rod_y;
        let w_rod_arm_rod_x = w_rod * arm_rod_x;
        let minus_small_end_2_by_bearing = arm_crank_x + arm_rod_x;
        let small_end_1_by_bearing = arm_crank_y + arm_rod_y;
        let sum = minus_v_rod_x + w_rod_arm_rod_y;
        let minus_small_end_2_rate = v_rod_y + w_rod_arm_rod_x;
        let small_end_1_gap = guide_position - minus_small_end_2_by_bearing;
        let small_end_1_rate = guide_v + sum;
        [
            ::newton_euler::private::Violation {
                name: "small_end_1",
                position: ::core::option::Option::Some(small_end_1_gap),
                velocity: small_end_1_rate,
            },
            ::newton_euler::private::Violation {
                name: "small_end_2",
                position: ::core::option::Option::Some(-small_end_1_by_bearing),
                velocity: -minus_small_end_2_rate,
            },
        ]
    }
    #[allow(unused_doc_comments)]
    fn check(
        &self,
        _time: f64,
        state: &SliderCrankState,
        _input: &SliderCrankInput,
    ) -> ::core::result::Result<(), ::newton_euler::private::Inconsistent> {
        let bearing_angle = state.bearing.angle;
        let bearing_w = state.bearing.angular_velocity;
        let big_end_angle = state.big_end.angle;
        let big_end_w = state.big_end.angular_velocity;
        let guide_position = state.guide.position;
        let guide_v = state.guide.velocity;
        let (sine_bearing, cosine_bearing) = ::newton_euler::private::math::sin_cos(
            bearing_angle,
        );
        /// w of each body, in its axes: of its carrier, and of its joint
        let w_rod = bearing_w + big_end_w;
        /// angle of each body from the ground
        let angle_rod = bearing_angle + big_end_angle;
        let arm_crank_x = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let minus_v_rod_x = bearing_w * arm_crank_y;
        let v_rod_y = bearing_w * arm_crank_x;
        let (sine_rod, cosine_rod) = ::newton_euler::private::math::sin_cos(angle_rod);
        let arm_rod_x = 0.18 * cosine_rod;
        let arm_rod_y = 0.18 * sine_rod;
        let w_rod_arm_rod_y = w_rod * arm_rod_y;
        let w_rod_arm_rod_x = w_rod * arm_rod_x;
        let minus_small_end_2_by_bearing = arm_crank_x + arm_rod_x;
        let small_end_1_by_bearing = arm_crank_y + arm_rod_y;
        let sum = minus_v_rod_x + w_rod_arm_rod_y;
        let minus_small_end_2_rate = v_rod_y + w_rod_arm_rod_x;
        let small_end_1_gap = guide_position - minus_small_end_2_by_bearing;
        let small_end_1_rate = guide_v + sum;
        let minus_small_end_2_by_big_end = minus_small_end_2_by_bearing - arm_crank_x;
        let small_end_1_by_big_end = small_end_1_by_bearing - arm_crank_y;
        let product = 0.024 * ::newton_euler::private::math::cos(big_end_angle);
        /// inertia of a body with all that it carries
        let coupling_crank_zy = product + 0.02;
        let inertia_crank_zz = 0.05 * (product + coupling_crank_zy) + 0.00464;
        let twice_kinetic_energy = bearing_w * bearing_w * inertia_crank_zz
            + 0.00264 * (big_end_w * big_end_w) + 0.3 * (guide_v * guide_v);
        let turning_inertia = inertia_crank_zz + 0.00264;
        let inverse_mass_small_end_2 = minus_small_end_2_by_bearing
            * (minus_small_end_2_by_bearing / inertia_crank_zz)
            + 378.7878787878788
                * (minus_small_end_2_by_big_end * minus_small_end_2_by_big_end);
        let max = ::newton_euler::private::math::max(
            small_end_1_by_bearing * (small_end_1_by_bearing / inertia_crank_zz)
                + 378.7878787878788 * (small_end_1_by_big_end * small_end_1_by_big_end)
                + 3.3333333333333335,
            inverse_mass_small_end_2,
        );
        let max_1 = ::newton_euler::private::math::max(inverse_mass_small_end_2, max);
        ::newton_euler::private::check(
            &[
                ::newton_euler::private::Size {
                    name: "small_end_1",
                    position: ::core::option::Option::Some((
                        small_end_1_gap,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(guide_position),
                                ::newton_euler::private::math::abs(
                                    minus_small_end_2_by_bearing,
                                ),
                            ),
                            ::newton_euler::private::math::sqrt(turning_inertia * max),
                        ),
                    )),
                    velocity: (
                        small_end_1_rate,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(guide_v),
                                ::newton_euler::private::math::abs(sum),
                            ),
                            ::newton_euler::private::math::sqrt(
                                twice_kinetic_energy * max,
                            ),
                        ),
                    ),
                },
                ::newton_euler::private::Size {
                    name: "small_end_2",
                    position: ::core::option::Option::Some((
                        -small_end_1_by_bearing,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(arm_crank_y),
                                ::newton_euler::private::math::abs(arm_rod_y),
                            ),
                            ::newton_euler::private::math::sqrt(turning_inertia * max_1),
                        ),
                    )),
                    velocity: (
                        -minus_small_end_2_rate,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(v_rod_y),
                                ::newton_euler::private::math::abs(w_rod_arm_rod_x),
                            ),
                            ::newton_euler::private::math::sqrt(
                                twice_kinetic_energy * max_1,
                            ),
                        ),
                    ),
                },
            ],
        )
    }
    fn project(
        &self,
        time: f64,
        state: &mut SliderCrankState,
        input: &SliderCrankInput,
    ) -> ::core::result::Result<(), ::newton_euler::private::Inconsistent> {
        ::newton_euler::private::project(
            state,
            |state: &SliderCrankState| ::newton_euler::private::Kept::rows(
                self,
                time,
                state,
                input,
            ),
        )
    }
    fn dependent(
        &self,
        time: f64,
        state: &SliderCrankState,
        input: &SliderCrankInput,
    ) -> ::core::option::Option<&'static str> {
        ::newton_euler::private::dependent(
            &::newton_euler::private::Kept::rows(self, time, state, input),
        )
    }
}
impl ::newton_euler::private::Kept<2> for SliderCrank {
    #[allow(unused_doc_comments)]
    fn rows(
        &self,
        _time: f64,
        state: &SliderCrankState,
        _input: &SliderCrankInput,
    ) -> [::newton_euler::private::Row<
        <SliderCrankState as ::newton_euler::private::State>::Rate,
        2,
    >; 2] {
        let bearing_angle = state.bearing.angle;
        let bearing_w = state.bearing.angular_velocity;
        let big_end_angle = state.big_end.angle;
        let big_end_w = state.big_end.angular_velocity;
        let guide_position = state.guide.position;
        let guide_v = state.guide.velocity;
        let (sine_bearing, cosine_bearing) = ::newton_euler::private::math::sin_cos(
            bearing_angle,
        );
        /// w of each body, in its axes: of its carrier, and of its joint
        let w_rod = bearing_w + big_end_w;
        /// angle of each body from the ground
        let angle_rod = bearing_angle + big_end_angle;
        let arm_crank_x = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let minus_v_rod_x = bearing_w * arm_crank_y;
        let v_rod_y = bearing_w * arm_crank_x;
        let (sine_rod, cosine_rod) = ::newton_euler::private::math::sin_cos(angle_rod);
        let arm_rod_x = 0.18 * cosine_rod;
        let arm_rod_y = 0.18 * sine_rod;
        let w_rod_arm_rod_y = w_rod * arm_rod_y;
        let w_rod_arm_rod_x = w_rod * arm_rod_x;
        let minus_small_end_2_by_bearing = arm_crank_x + arm_rod_x;
        let small_end_1_by_bearing = arm_crank_y + arm_rod_y;
        let sum = minus_v_rod_x + w_rod_arm_rod_y;
        let minus_small_end_2_rate = v_rod_y + w_rod_arm_rod_x;
        let small_end_1_gap = guide_position - minus_small_end_2_by_bearing;
        let small_end_1_rate = guide_v + sum;
        let minus_small_end_2_by_big_end = minus_small_end_2_by_bearing - arm_crank_x;
        let small_end_1_by_big_end = small_end_1_by_bearing - arm_crank_y;
        let product = 0.024 * ::newton_euler::private::math::cos(big_end_angle);
        /// inertia of a body with all that it carries
        let coupling_crank_zy = product + 0.02;
        let inertia_crank_zz = 0.05 * (product + coupling_crank_zy) + 0.00464;
        let twice_kinetic_energy = bearing_w * bearing_w * inertia_crank_zz
            + 0.00264 * (big_end_w * big_end_w) + 0.3 * (guide_v * guide_v);
        let turning_inertia = inertia_crank_zz + 0.00264;
        let ratio = small_end_1_by_bearing / inertia_crank_zz;
        let ratio_1 = minus_small_end_2_by_bearing / inertia_crank_zz;
        let inverse_mass_small_end_1 = small_end_1_by_bearing * ratio
            + 378.7878787878788 * (small_end_1_by_big_end * small_end_1_by_big_end)
            + 3.3333333333333335;
        let product_1 = 378.7878787878788
            * (minus_small_end_2_by_big_end * small_end_1_by_big_end);
        let inverse_mass_small_end_2 = minus_small_end_2_by_bearing * ratio_1
            + 378.7878787878788
                * (minus_small_end_2_by_big_end * minus_small_end_2_by_big_end);
        [
            ::newton_euler::private::Row {
                name: "small_end_1",
                position: ::core::option::Option::Some((
                    small_end_1_gap,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(guide_position),
                            ::newton_euler::private::math::abs(
                                minus_small_end_2_by_bearing,
                            ),
                        ),
                        ::newton_euler::private::math::sqrt(
                            turning_inertia * inverse_mass_small_end_1,
                        ),
                    ),
                )),
                velocity: (
                    small_end_1_rate,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(guide_v),
                            ::newton_euler::private::math::abs(sum),
                        ),
                        ::newton_euler::private::math::sqrt(
                            twice_kinetic_energy * inverse_mass_small_end_1,
                        ),
                    ),
                ),
                shift: ::newton_euler::private::State::rate(
                    &SliderCrankState {
                        bearing: ::newton_euler::private::generic::Hinge {
                            angular_velocity: ratio,
                            ..state.bearing
                        },
                        big_end: ::newton_euler::private::generic::Hinge {
                            angular_velocity: 378.7878787878788 * small_end_1_by_big_end,
                            ..state.big_end
                        },
                        guide: ::newton_euler::private::generic::Slide {
                            velocity: 3.3333333333333335,
                            ..state.guide
                        },
                    },
                    &::core::default::Default::default(),
                ),
                push: ::newton_euler::private::State::rate(
                    &SliderCrankState {
                        bearing: ::newton_euler::private::generic::Hinge {
                            angular_velocity: ::core::default::Default::default(),
                            ..state.bearing
                        },
                        big_end: ::newton_euler::private::generic::Hinge {
                            angular_velocity: ::core::default::Default::default(),
                            ..state.big_end
                        },
                        guide: ::newton_euler::private::generic::Slide {
                            velocity: ::core::default::Default::default(),
                            ..state.guide
                        },
                    },
                    &SliderCrankAcceleration {
                        bearing: ratio,
                        big_end: 378.7878787878788 * small_end_1_by_big_end,
                        guide: 3.3333333333333335,
                    },
                ),
                coupling: [
                    inverse_mass_small_end_1,
                    -(small_end_1_by_bearing * ratio_1 + product_1),
                ],
                follows: false,
            },
            ::newton_euler::private::Row {
                name: "small_end_2",
                position: ::core::option::Option::Some((
                    -small_end_1_by_bearing,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(arm_crank_y),
                            ::newton_euler::private::math::abs(arm_rod_y),
                        ),
                        ::newton_euler::private::math::sqrt(
                            turning_inertia * inverse_mass_small_end_2,
                        ),
                    ),
                )),
                velocity: (
                    -minus_small_end_2_rate,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(v_rod_y),
                            ::newton_euler::private::math::abs(w_rod_arm_rod_x),
                        ),
                        ::newton_euler::private::math::sqrt(
                            twice_kinetic_energy * inverse_mass_small_end_2,
                        ),
                    ),
                ),
                shift: ::newton_euler::private::State::rate(
                    &SliderCrankState {
                        bearing: ::newton_euler::private::generic::Hinge {
                            angular_velocity: -ratio_1,
                            ..state.bearing
                        },
                        big_end: ::newton_euler::private::generic::Hinge {
                            angular_velocity: -378.7878787878788
                                * minus_small_end_2_by_big_end,
                            ..state.big_end
                        },
                        guide: ::newton_euler::private::generic::Slide {
                            velocity: 0.0,
                            ..state.guide
                        },
                    },
                    &::core::default::Default::default(),
                ),
                push: ::newton_euler::private::State::rate(
                    &SliderCrankState {
                        bearing: ::newton_euler::private::generic::Hinge {
                            angular_velocity: ::core::default::Default::default(),
                            ..state.bearing
                        },
                        big_end: ::newton_euler::private::generic::Hinge {
                            angular_velocity: ::core::default::Default::default(),
                            ..state.big_end
                        },
                        guide: ::newton_euler::private::generic::Slide {
                            velocity: ::core::default::Default::default(),
                            ..state.guide
                        },
                    },
                    &SliderCrankAcceleration {
                        bearing: -ratio_1,
                        big_end: -378.7878787878788 * minus_small_end_2_by_big_end,
                        guide: 0.0,
                    },
                ),
                coupling: [
                    -(product_1 + minus_small_end_2_by_bearing * ratio),
                    inverse_mass_small_end_2,
                ],
                follows: false,
            },
        ]
    }
}
impl ::newton_euler::private::Reactions for SliderCrank {
    type Reactions = SliderCrankReactions;
    #[allow(unused_doc_comments)]
    fn reactions(
        &self,
        _time: f64,
        state: &SliderCrankState,
        input: &SliderCrankInput,
    ) -> SliderCrankReactions {
        let SliderCrankInput { torque } = *input;
        let bearing_angle = state.bearing.angle;
        let bearing_w = state.bearing.angular_velocity;
        let big_end_angle = state.big_end.angle;
        let big_end_w = state.big_end.angular_velocity;
        let (sine_bearing, cosine_bearing) = ::newton_euler::private::math::sin_cos(
            bearing_angle,
        );
        let (sine_big_end, cosine_big_end) = ::newton_euler::private::math::sin_cos(
            big_end_angle,
        );
        /// w of each body, in its axes: of its carrier, and of its joint
        let w_rod = bearing_w + big_end_w;
        /// angle of each body from the ground
        let angle_rod = bearing_angle + big_end_angle;
        let arm_crank_x = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let (sine_rod, cosine_rod) = ::newton_euler::private::math::sin_cos(angle_rod);
        let arm_rod_x = 0.18 * cosine_rod;
        let arm_rod_y = 0.18 * sine_rod;
        /// S r = w' x r + w x (w x r): what an arm r adds to a
        let minus_sweep_crank_xx = bearing_w * bearing_w;
        let a_crank_at_rod_x = -0.05 * minus_sweep_crank_xx;
        let minus_sweep_rod_xx = w_rod * w_rod;
        let minus_small_end_1_to_balance = arm_crank_x * minus_sweep_crank_xx
            + arm_rod_x * minus_sweep_rod_xx;
        let minus_small_end_2_to_balance = arm_crank_y * minus_sweep_crank_xx
            + arm_rod_y * minus_sweep_rod_xx;
        let small_end_1_by_loop_1 = arm_crank_x * arm_rod_y - arm_crank_y * arm_rod_x;
        let coupling_bearing_big_end = 0.13333333333333333
            * (arm_crank_x * arm_rod_x + arm_crank_y * arm_rod_y);
        /// load on a joint by the acceleration of the independent joint
        let momentum_bearing = arm_crank_x * coupling_bearing_big_end
            - 0.003 * arm_rod_x;
        let momentum_big_end = 0.00264 * arm_crank_x
            - arm_rod_x * coupling_bearing_big_end;
        /// inertia that the independent joint moves
        let inertia_loop_1 = arm_crank_x * momentum_big_end
            - arm_rod_x * momentum_bearing;
        /// 1 over it, or NaN if it is only rounding error: there, constraints are dependent
        let inverse_inertia_loop_1 = ::newton_euler::private::determined(
            inertia_loop_1,
            0.0001038,
        );
        let fixed_bearing = inverse_inertia_loop_1
            * (minus_small_end_2_to_balance * momentum_big_end);
        let minus_fixed_big_end = inverse_inertia_loop_1
            * (minus_small_end_2_to_balance * momentum_bearing);
        let minus_small_end_1_to_balance_1 = arm_crank_y * fixed_bearing
            - arm_rod_y * minus_fixed_big_end + minus_small_end_1_to_balance;
        let momentum_guide = 0.3 * small_end_1_by_loop_1;
        let inertia_loop_2 = inertia_loop_1 + small_end_1_by_loop_1 * momentum_guide;
        let inverse_inertia_loop_2 = ::newton_euler::private::determined(
            inertia_loop_2,
            0.0001524,
        );
        let driving_loop_2 = arm_rod_x
            * (torque
                + 0.13333333333333333 * (minus_sweep_rod_xx * small_end_1_by_loop_1))
            + 0.13333333333333333
                * (arm_crank_x * (minus_sweep_crank_xx * small_end_1_by_loop_1));
        let guide_a = inverse_inertia_loop_2
            * (small_end_1_by_loop_1 * driving_loop_2
                - inertia_loop_1 * minus_small_end_1_to_balance_1);
        let minus_acceleration_loop_1 = inverse_inertia_loop_2
            * (minus_small_end_1_to_balance_1 * momentum_guide + driving_loop_2);
        let bearing_alpha = fixed_bearing + arm_rod_x * minus_acceleration_loop_1;
        let minus_alpha_total_rod = minus_fixed_big_end
            + arm_crank_x * minus_acceleration_loop_1;
        let minus_big_end_alpha = bearing_alpha + minus_alpha_total_rod;
        let product = 0.05 * bearing_alpha;
        /// a of each body, with those of joints, relative to free fall
        let a_total_rod_x = cosine_big_end * a_crank_at_rod_x + sine_big_end * product;
        let a_total_rod_y = cosine_big_end * product - sine_big_end * a_crank_at_rod_x;
        /// w' of each body, with the accelerations of joints
        let alpha_total_rod = bearing_alpha - minus_big_end_alpha;
        /// moment and force of each joint, in the axes of a body
        let joint_force_slider_x = 0.3 * guide_a;
        let joint_moment_rod = 0.00264 * alpha_total_rod + 0.024 * a_total_rod_y;
        let joint_force_rod_x = 0.4 * a_total_rod_x - 0.024 * minus_sweep_rod_xx;
        let joint_force_rod_y = 0.4 * a_total_rod_y + 0.024 * alpha_total_rod;
        let joint_force_rod_on_crank_y = cosine_big_end * joint_force_rod_y
            + sine_big_end * joint_force_rod_x;
        let joint_moment_crank = joint_moment_rod + 0.05 * joint_force_rod_on_crank_y
            + 0.002 * bearing_alpha;
        let lacking_bearing = joint_moment_crank - torque;
        let difference = lacking_bearing - joint_moment_rod;
        let difference_1 = arm_crank_x * joint_moment_rod - arm_rod_x * difference;
        let small_end_force_x = inverse_inertia_loop_2
            * (momentum_guide * difference_1 + inertia_loop_1 * joint_force_slider_x);
        let difference_2 = difference - arm_crank_y * small_end_force_x;
        let difference_3 = joint_moment_rod - arm_rod_y * small_end_force_x;
        let small_end_force_y = inverse_inertia_loop_1
            * (momentum_bearing * difference_3 - momentum_big_end * difference_2);
        SliderCrankReactions {
            small_end: ::newton_euler::private::PlanarWrench {
                force: [small_end_force_x, small_end_force_y].into(),
                moment: 0.0,
            },
        }
    }
}
/// The loads of the joints of [`SliderCrank`] on the bodies that they carry, at the joints' points on these bodies, world axes; drives included.
#[allow(clippy::struct_field_names)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct SliderCrankReactions {
    /// `small_end`
    pub small_end: ::newton_euler::private::PlanarWrench,
}
