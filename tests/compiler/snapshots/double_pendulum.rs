/// Two arms in the plane, hinged to each other and to the ground.
///
/// Joints:
/// - `shoulder`: revolute from the ground to `upper`
/// - `elbow`: revolute from `upper` to `lower`
///
/// Operations:
/// - `acceleration`: 21 mul + 8 add + 1 div + 4 trig
///
/// Skipped:
/// - the mass of `upper` in its own balances: `shoulder` cannot tell it from a mass of the ground on its axis
/// - the mass of `lower` in its own balances: `elbow` cannot tell it from a mass of `upper` on its axis
/// - the weight of each body: the ground accelerates against it instead
/// - energy, momentum, balance, reactions, inverse, mass_matrix, jacobian: not in `outputs`
#[derive(Clone, Debug, Default)]
#[allow(unreachable_pub)]
pub struct DoublePendulum {}
::newton_euler::private::system_state! {
    #[doc = " The state of [`DoublePendulum`]: the state of each joint."]
    DoublePendulumState #[doc =
    " The acceleration of [`DoublePendulum`]: the acceleration of each joint."]
    DoublePendulumAcceleration { #[doc = " The joint `shoulder`."] shoulder : Hinge #[doc
    = " The joint `shoulder`."] => f64, #[doc = " The joint `elbow`."] elbow : Hinge
    #[doc = " The joint `elbow`."] => f64 }
}
impl DoublePendulum {
    /// The equations of motion, as evaluated.
    pub const EQUATIONS: &str = {
        const TEXT: &str = "# shoulder_angle elbow_angle: angle, rad\n# shoulder_w elbow_w: angular velocity, rad / s\n# shoulder_alpha elbow_alpha: angular acceleration, rad / s ^ 2\n(sine_shoulder, cosine_shoulder) = sin_cos(shoulder_angle)\n(sine_elbow, cosine_elbow) = sin_cos(elbow_angle)\n# w of each body, in its axes: of its carrier, and of its joint\nw_lower = shoulder_w + elbow_w\n# w' and a of each body while no joint accelerates, relative to free fall\na_upper_y = 9.80665 * cosine_shoulder\n# S r = w' x r + w x (w x r): what an arm r adds to a\nminus_sweep_upper_xx = shoulder_w * shoulder_w\nminus_sweep_lower_xx = w_lower * w_lower\na_lower_x = 9.80665 * sine_shoulder - 0.6 * minus_sweep_upper_xx\n# inertia of a body with all that it carries, while the joints move freely\ncoupling_lower_zy = 0.176 * cosine_elbow\n# q'' = own - share . a, a of the carrier\nlinear_share_elbow_y = 18.615040953090098 * coupling_lower_zy\n# the same inertia while the joint gives way\nminus_mass_lower_yielding_yy = coupling_lower_zy * linear_share_elbow_y\n# moment and force that a body needs beyond its loads, with all that it carries\nmoment_lower = 0.176 * (cosine_elbow * a_upper_y - sine_elbow * a_lower_x)\nminus_force_lower_yielding_y = 0.176 * (sine_elbow * minus_sweep_lower_xx) + linear_share_elbow_y * moment_lower\nmoment_upper = 0.816 * a_upper_y - 0.6 * minus_force_lower_yielding_y\n# 1 / J of each joint, J with all that it carries\ninverse_inertia_shoulder = 1.0 / (0.42208 - 0.36 * minus_mass_lower_yielding_yy)\n# acceleration of each joint if its carrier does not accelerate\nminus_own_shoulder = moment_upper * inverse_inertia_shoulder\nelbow_alpha = minus_own_shoulder + 0.6 * (linear_share_elbow_y * minus_own_shoulder) - 18.615040953090098 * moment_lower\nshoulder_alpha = -minus_own_shoulder";
        TEXT
    };
    /// Their operation counts, by function and stage.
    pub const OPERATIONS: &[::newton_euler::private::Operations] = &[
        ::newton_euler::private::Operations::state("acceleration", [21, 8, 1, 0, 4, 0]),
    ];
    /// The terms that were left out, and why.
    pub const SKIPPED: &[&str] = &[
        "the mass of `upper` in its own balances: `shoulder` cannot tell it from a mass of the ground on its axis",
        "the mass of `lower` in its own balances: `elbow` cannot tell it from a mass of `upper` on its axis",
        "the weight of each body: the ground accelerates against it instead",
        "energy, momentum, balance, reactions, inverse, mass_matrix, jacobian: not in `outputs`",
    ];
}
impl ::newton_euler::private::RigidBody for DoublePendulum {
    type Scalar = f64;
    type State = DoublePendulumState;
    type Input = ();
    #[inline]
    #[allow(unused_doc_comments)]
    fn acceleration(
        &self,
        _time: f64,
        state: &DoublePendulumState,
        _input: &(),
    ) -> DoublePendulumAcceleration {
        let shoulder_angle = state.shoulder.angle;
        let shoulder_w = state.shoulder.angular_velocity;
        let elbow_angle = state.elbow.angle;
        let elbow_w = state.elbow.angular_velocity;
        let (sine_shoulder, cosine_shoulder) = ::newton_euler::private::math::sin_cos(
            shoulder_angle,
        );
        let (sine_elbow, cosine_elbow) = ::newton_euler::private::math::sin_cos(
            elbow_angle,
        );
        /// w of each body, in its axes: of its carrier, and of its joint
        let w_lower = shoulder_w + elbow_w;
        /// w' and a of each body while no joint accelerates, relative to free fall
        let a_upper_y = 9.80665 * cosine_shoulder;
        /// S r = w' x r + w x (w x r): what an arm r adds to a
        let minus_sweep_upper_xx = shoulder_w * shoulder_w;
        let minus_sweep_lower_xx = w_lower * w_lower;
        let a_lower_x = 9.80665 * sine_shoulder - 0.6 * minus_sweep_upper_xx;
        /// inertia of a body with all that it carries, while the joints move freely
        let coupling_lower_zy = 0.176 * cosine_elbow;
        /// q'' = own - share . a, a of the carrier
        let linear_share_elbow_y = 18.615040953090098 * coupling_lower_zy;
        /// the same inertia while the joint gives way
        let minus_mass_lower_yielding_yy = coupling_lower_zy * linear_share_elbow_y;
        /// moment and force that a body needs beyond its loads, with all that it carries
        let moment_lower = 0.176 * (cosine_elbow * a_upper_y - sine_elbow * a_lower_x);
        let minus_force_lower_yielding_y = 0.176 * (sine_elbow * minus_sweep_lower_xx)
            + linear_share_elbow_y * moment_lower;
        let moment_upper = 0.816 * a_upper_y - 0.6 * minus_force_lower_yielding_y;
        /// 1 / J of each joint, J with all that it carries
        let inverse_inertia_shoulder = 1.0
            / (0.42208 - 0.36 * minus_mass_lower_yielding_yy);
        /// acceleration of each joint if its carrier does not accelerate
        let minus_own_shoulder = moment_upper * inverse_inertia_shoulder;
        let elbow_alpha = minus_own_shoulder
            + 0.6 * (linear_share_elbow_y * minus_own_shoulder)
            - 18.615040953090098 * moment_lower;
        let shoulder_alpha = -minus_own_shoulder;
        DoublePendulumAcceleration {
            shoulder: shoulder_alpha,
            elbow: elbow_alpha,
        }
    }
}
impl ::newton_euler::private::Integrate for DoublePendulum {
    type Best = ::newton_euler::private::RungeKuttaPair;
}
