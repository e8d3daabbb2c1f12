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
