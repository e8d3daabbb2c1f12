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
        const TEXT: &str = "(sine_bearing, cosine_bearing) = sin_cos(bearing_angle)\nw_rod = bearing_w + big_end_w\nsum = bearing_angle + big_end_angle\nshare_big_end = 0.05 * cosine_bearing\narm_crank_y = 0.05 * sine_bearing\n(sin_sum, cos_sum) = sin_cos(sum)\narm_rod_x = 0.18 * cos_sum\narm_rod_y = 0.18 * sin_sum\nminus_sweep_crank_xx = bearing_w * bearing_w\nminus_sweep_rod_xx = w_rod * w_rod\nsum_1 = share_big_end * minus_sweep_crank_xx + arm_rod_x * minus_sweep_rod_xx\nsum_2 = arm_crank_y * minus_sweep_crank_xx + arm_rod_y * minus_sweep_rod_xx\ndifference = share_big_end * arm_rod_y - arm_crank_y * arm_rod_x\nproduct = 0.13333333333333333 * (share_big_end * arm_rod_x + arm_crank_y * arm_rod_y)\nmomentum_bearing = share_big_end * product - 0.003 * arm_rod_x\nmomentum_big_end = 0.00264 * share_big_end - arm_rod_x * product\ninertia_loop_1 = share_big_end * momentum_big_end - arm_rod_x * momentum_bearing\ninverse_inertia_loop_1 = 1 / inertia_loop_1\nproduct_1 = inverse_inertia_loop_1 * (sum_2 * momentum_big_end)\nproduct_2 = inverse_inertia_loop_1 * (sum_2 * momentum_bearing)\nsum_3 = arm_crank_y * product_1 - arm_rod_y * product_2 + sum_1\nmomentum_guide = 0.3 * difference\ninertia_loop_2 = inertia_loop_1 + difference * momentum_guide\ninverse_inertia_loop_2 = 1 / inertia_loop_2\nsum_4 = arm_rod_x * (torque + 0.13333333333333333 * (minus_sweep_rod_xx * difference)) + 0.13333333333333333 * (share_big_end * (minus_sweep_crank_xx * difference))\nguide_a = inverse_inertia_loop_2 * (difference * sum_4 - inertia_loop_1 * sum_3)\nproduct_3 = inverse_inertia_loop_2 * (sum_3 * momentum_guide + sum_4)\nbearing_alpha = product_1 + arm_rod_x * product_3\nsum_5 = product_2 + share_big_end * product_3\nsum_6 = bearing_alpha + sum_5\nbig_end_alpha = -sum_6";
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
        let w_rod = bearing_w + big_end_w;
        let sum = bearing_angle + big_end_angle;
        let share_big_end = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let (sin_sum, cos_sum) = ::newton_euler::private::math::sin_cos(sum);
        let arm_rod_x = 0.18 * cos_sum;
        let arm_rod_y = 0.18 * sin_sum;
        let minus_sweep_crank_xx = bearing_w * bearing_w;
        let minus_sweep_rod_xx = w_rod * w_rod;
        let sum_1 = share_big_end * minus_sweep_crank_xx
            + arm_rod_x * minus_sweep_rod_xx;
        let sum_2 = arm_crank_y * minus_sweep_crank_xx + arm_rod_y * minus_sweep_rod_xx;
        let difference = share_big_end * arm_rod_y - arm_crank_y * arm_rod_x;
        let product = 0.13333333333333333
            * (share_big_end * arm_rod_x + arm_crank_y * arm_rod_y);
        let momentum_bearing = share_big_end * product - 0.003 * arm_rod_x;
        let momentum_big_end = 0.00264 * share_big_end - arm_rod_x * product;
        let inertia_loop_1 = share_big_end * momentum_big_end
            - arm_rod_x * momentum_bearing;
        let inverse_inertia_loop_1 = ::newton_euler::private::determined(
            inertia_loop_1,
            0.0001038,
        );
        let product_1 = inverse_inertia_loop_1 * (sum_2 * momentum_big_end);
        let product_2 = inverse_inertia_loop_1 * (sum_2 * momentum_bearing);
        let sum_3 = arm_crank_y * product_1 - arm_rod_y * product_2 + sum_1;
        let momentum_guide = 0.3 * difference;
        let inertia_loop_2 = inertia_loop_1 + difference * momentum_guide;
        let inverse_inertia_loop_2 = ::newton_euler::private::determined(
            inertia_loop_2,
            0.0001524,
        );
        let sum_4 = arm_rod_x
            * (torque + 0.13333333333333333 * (minus_sweep_rod_xx * difference))
            + 0.13333333333333333
                * (share_big_end * (minus_sweep_crank_xx * difference));
        let guide_a = inverse_inertia_loop_2
            * (difference * sum_4 - inertia_loop_1 * sum_3);
        let product_3 = inverse_inertia_loop_2 * (sum_3 * momentum_guide + sum_4);
        let bearing_alpha = product_1 + arm_rod_x * product_3;
        let sum_5 = product_2 + share_big_end * product_3;
        let sum_6 = bearing_alpha + sum_5;
        let big_end_alpha = -sum_6;
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
        let w_rod = bearing_w + big_end_w;
        let sum = bearing_angle + big_end_angle;
        let share_big_end = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let bearing_w_arm_crank_y = bearing_w * arm_crank_y;
        let bearing_w_share_big_end = bearing_w * share_big_end;
        let (sin_sum, cos_sum) = ::newton_euler::private::math::sin_cos(sum);
        let arm_rod_x = 0.18 * cos_sum;
        let arm_rod_y = 0.18 * sin_sum;
        let w_rod_arm_rod_y = w_rod * arm_rod_y;
        let w_rod_arm_rod_x = w_rod * arm_rod_x;
        let sum_1 = share_big_end + arm_rod_x;
        let sum_2 = arm_crank_y + arm_rod_y;
        let sum_3 = bearing_w_arm_crank_y + w_rod_arm_rod_y;
        let sum_4 = bearing_w_share_big_end + w_rod_arm_rod_x;
        let difference = guide_position - sum_1;
        let sum_5 = guide_v + sum_3;
        [
            ::newton_euler::private::Violation {
                name: "small_end_1",
                position: ::core::option::Option::Some(difference),
                velocity: sum_5,
            },
            ::newton_euler::private::Violation {
                name: "small_end_2",
                position: ::core::option::Option::Some(-sum_2),
                velocity: -sum_4,
            },
        ]
    }
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
        let w_rod = bearing_w + big_end_w;
        let sum = bearing_angle + big_end_angle;
        let share_big_end = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let bearing_w_arm_crank_y = bearing_w * arm_crank_y;
        let bearing_w_share_big_end = bearing_w * share_big_end;
        let (sin_sum, cos_sum) = ::newton_euler::private::math::sin_cos(sum);
        let arm_rod_x = 0.18 * cos_sum;
        let arm_rod_y = 0.18 * sin_sum;
        let w_rod_arm_rod_y = w_rod * arm_rod_y;
        let w_rod_arm_rod_x = w_rod * arm_rod_x;
        let sum_1 = share_big_end + arm_rod_x;
        let sum_2 = arm_crank_y + arm_rod_y;
        let sum_3 = bearing_w_arm_crank_y + w_rod_arm_rod_y;
        let sum_4 = bearing_w_share_big_end + w_rod_arm_rod_x;
        let difference = guide_position - sum_1;
        let sum_5 = guide_v + sum_3;
        let difference_1 = sum_1 - share_big_end;
        let difference_2 = sum_2 - arm_crank_y;
        let product = 0.024 * ::newton_euler::private::math::cos(big_end_angle);
        let coupling_crank_zy = product + 0.02;
        let inertia_crank_zz = 0.05 * (product + coupling_crank_zy) + 0.00464;
        let sum_6 = bearing_w * bearing_w * inertia_crank_zz
            + 0.00264 * (big_end_w * big_end_w) + 0.3 * (guide_v * guide_v);
        let sum_7 = inertia_crank_zz + 0.00264;
        let sum_8 = sum_1 * (sum_1 / inertia_crank_zz)
            + 378.7878787878788 * (difference_1 * difference_1);
        let max = ::newton_euler::private::math::max(
            sum_2 * (sum_2 / inertia_crank_zz)
                + 378.7878787878788 * (difference_2 * difference_2) + 3.3333333333333335,
            sum_8,
        );
        let max_1 = ::newton_euler::private::math::max(sum_8, max);
        ::newton_euler::private::check(
            &[
                ::newton_euler::private::Size {
                    name: "small_end_1",
                    position: ::core::option::Option::Some((
                        difference,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(guide_position),
                                ::newton_euler::private::math::abs(sum_1),
                            ),
                            ::newton_euler::private::math::sqrt(sum_7 * max),
                        ),
                    )),
                    velocity: (
                        sum_5,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(guide_v),
                                ::newton_euler::private::math::abs(sum_3),
                            ),
                            ::newton_euler::private::math::sqrt(sum_6 * max),
                        ),
                    ),
                },
                ::newton_euler::private::Size {
                    name: "small_end_2",
                    position: ::core::option::Option::Some((
                        -sum_2,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(arm_crank_y),
                                ::newton_euler::private::math::abs(arm_rod_y),
                            ),
                            ::newton_euler::private::math::sqrt(sum_7 * max_1),
                        ),
                    )),
                    velocity: (
                        -sum_4,
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::max(
                                ::newton_euler::private::math::abs(bearing_w_share_big_end),
                                ::newton_euler::private::math::abs(w_rod_arm_rod_x),
                            ),
                            ::newton_euler::private::math::sqrt(sum_6 * max_1),
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
        let w_rod = bearing_w + big_end_w;
        let sum = bearing_angle + big_end_angle;
        let share_big_end = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let bearing_w_arm_crank_y = bearing_w * arm_crank_y;
        let bearing_w_share_big_end = bearing_w * share_big_end;
        let (sin_sum, cos_sum) = ::newton_euler::private::math::sin_cos(sum);
        let arm_rod_x = 0.18 * cos_sum;
        let arm_rod_y = 0.18 * sin_sum;
        let w_rod_arm_rod_y = w_rod * arm_rod_y;
        let w_rod_arm_rod_x = w_rod * arm_rod_x;
        let sum_1 = share_big_end + arm_rod_x;
        let sum_2 = arm_crank_y + arm_rod_y;
        let sum_3 = bearing_w_arm_crank_y + w_rod_arm_rod_y;
        let sum_4 = bearing_w_share_big_end + w_rod_arm_rod_x;
        let difference = guide_position - sum_1;
        let sum_5 = guide_v + sum_3;
        let difference_1 = sum_1 - share_big_end;
        let difference_2 = sum_2 - arm_crank_y;
        let product = 0.024 * ::newton_euler::private::math::cos(big_end_angle);
        let coupling_crank_zy = product + 0.02;
        let inertia_crank_zz = 0.05 * (product + coupling_crank_zy) + 0.00464;
        let sum_6 = bearing_w * bearing_w * inertia_crank_zz
            + 0.00264 * (big_end_w * big_end_w) + 0.3 * (guide_v * guide_v);
        let sum_7 = inertia_crank_zz + 0.00264;
        let ratio = sum_2 / inertia_crank_zz;
        let ratio_1 = sum_1 / inertia_crank_zz;
        let sum_8 = sum_2 * ratio + 378.7878787878788 * (difference_2 * difference_2)
            + 3.3333333333333335;
        let product_1 = 378.7878787878788 * (difference_1 * difference_2);
        let sum_9 = sum_1 * ratio_1 + 378.7878787878788 * (difference_1 * difference_1);
        [
            ::newton_euler::private::Row {
                name: "small_end_1",
                position: ::core::option::Option::Some((
                    difference,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(guide_position),
                            ::newton_euler::private::math::abs(sum_1),
                        ),
                        ::newton_euler::private::math::sqrt(sum_7 * sum_8),
                    ),
                )),
                velocity: (
                    sum_5,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(guide_v),
                            ::newton_euler::private::math::abs(sum_3),
                        ),
                        ::newton_euler::private::math::sqrt(sum_6 * sum_8),
                    ),
                ),
                shift: ::newton_euler::private::State::rate(
                    &SliderCrankState {
                        bearing: ::newton_euler::private::generic::Hinge {
                            angular_velocity: ratio,
                            ..state.bearing
                        },
                        big_end: ::newton_euler::private::generic::Hinge {
                            angular_velocity: 378.7878787878788 * difference_2,
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
                        big_end: 378.7878787878788 * difference_2,
                        guide: 3.3333333333333335,
                    },
                ),
                coupling: [sum_8, -(sum_2 * ratio_1 + product_1)],
                follows: false,
            },
            ::newton_euler::private::Row {
                name: "small_end_2",
                position: ::core::option::Option::Some((
                    -sum_2,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(arm_crank_y),
                            ::newton_euler::private::math::abs(arm_rod_y),
                        ),
                        ::newton_euler::private::math::sqrt(sum_7 * sum_9),
                    ),
                )),
                velocity: (
                    -sum_4,
                    ::newton_euler::private::math::max(
                        ::newton_euler::private::math::max(
                            ::newton_euler::private::math::abs(bearing_w_share_big_end),
                            ::newton_euler::private::math::abs(w_rod_arm_rod_x),
                        ),
                        ::newton_euler::private::math::sqrt(sum_6 * sum_9),
                    ),
                ),
                shift: ::newton_euler::private::State::rate(
                    &SliderCrankState {
                        bearing: ::newton_euler::private::generic::Hinge {
                            angular_velocity: -ratio_1,
                            ..state.bearing
                        },
                        big_end: ::newton_euler::private::generic::Hinge {
                            angular_velocity: -378.7878787878788 * difference_1,
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
                        big_end: -378.7878787878788 * difference_1,
                        guide: 0.0,
                    },
                ),
                coupling: [-(product_1 + sum_1 * ratio), sum_9],
                follows: false,
            },
        ]
    }
}
impl ::newton_euler::private::Reactions for SliderCrank {
    type Reactions = SliderCrankReactions;
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
        let w_rod = bearing_w + big_end_w;
        let sum = bearing_angle + big_end_angle;
        let share_big_end = 0.05 * cosine_bearing;
        let arm_crank_y = 0.05 * sine_bearing;
        let (sin_sum, cos_sum) = ::newton_euler::private::math::sin_cos(sum);
        let arm_rod_x = 0.18 * cos_sum;
        let arm_rod_y = 0.18 * sin_sum;
        let minus_sweep_crank_xx = bearing_w * bearing_w;
        let product = -0.05 * minus_sweep_crank_xx;
        let minus_sweep_rod_xx = w_rod * w_rod;
        let sum_1 = share_big_end * minus_sweep_crank_xx
            + arm_rod_x * minus_sweep_rod_xx;
        let sum_2 = arm_crank_y * minus_sweep_crank_xx + arm_rod_y * minus_sweep_rod_xx;
        let difference = share_big_end * arm_rod_y - arm_crank_y * arm_rod_x;
        let product_1 = 0.13333333333333333
            * (share_big_end * arm_rod_x + arm_crank_y * arm_rod_y);
        let momentum_bearing = share_big_end * product_1 - 0.003 * arm_rod_x;
        let momentum_big_end = 0.00264 * share_big_end - arm_rod_x * product_1;
        let inertia_loop_1 = share_big_end * momentum_big_end
            - arm_rod_x * momentum_bearing;
        let inverse_inertia_loop_1 = ::newton_euler::private::determined(
            inertia_loop_1,
            0.0001038,
        );
        let product_2 = inverse_inertia_loop_1 * (sum_2 * momentum_big_end);
        let product_3 = inverse_inertia_loop_1 * (sum_2 * momentum_bearing);
        let sum_3 = arm_crank_y * product_2 - arm_rod_y * product_3 + sum_1;
        let momentum_guide = 0.3 * difference;
        let inertia_loop_2 = inertia_loop_1 + difference * momentum_guide;
        let inverse_inertia_loop_2 = ::newton_euler::private::determined(
            inertia_loop_2,
            0.0001524,
        );
        let sum_4 = arm_rod_x
            * (torque + 0.13333333333333333 * (minus_sweep_rod_xx * difference))
            + 0.13333333333333333
                * (share_big_end * (minus_sweep_crank_xx * difference));
        let guide_a = inverse_inertia_loop_2
            * (difference * sum_4 - inertia_loop_1 * sum_3);
        let product_4 = inverse_inertia_loop_2 * (sum_3 * momentum_guide + sum_4);
        let bearing_alpha = product_2 + arm_rod_x * product_4;
        let sum_5 = product_3 + share_big_end * product_4;
        let sum_6 = bearing_alpha + sum_5;
        let product_5 = 0.05 * bearing_alpha;
        let sum_7 = cosine_big_end * product + sine_big_end * product_5;
        let difference_1 = cosine_big_end * product_5 - sine_big_end * product;
        let difference_2 = bearing_alpha - sum_6;
        let product_6 = 0.3 * guide_a;
        let sum_8 = 0.00264 * difference_2 + 0.024 * difference_1;
        let difference_3 = 0.4 * sum_7 - 0.024 * minus_sweep_rod_xx;
        let sum_9 = 0.4 * difference_1 + 0.024 * difference_2;
        let sum_10 = cosine_big_end * sum_9 + sine_big_end * difference_3;
        let sum_11 = sum_8 + 0.05 * sum_10 + 0.002 * bearing_alpha;
        let difference_4 = sum_11 - torque;
        let difference_5 = difference_4 - sum_8;
        let difference_6 = share_big_end * sum_8 - arm_rod_x * difference_5;
        let small_end_force_x = inverse_inertia_loop_2
            * (momentum_guide * difference_6 + inertia_loop_1 * product_6);
        let difference_7 = difference_5 - arm_crank_y * small_end_force_x;
        let difference_8 = sum_8 - arm_rod_y * small_end_force_x;
        let small_end_force_y = inverse_inertia_loop_1
            * (momentum_bearing * difference_8 - momentum_big_end * difference_7);
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
