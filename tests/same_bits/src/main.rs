//! Results to the bit: the same numbers in every build and on every processor.
//!
//! Only integrated series have two possible results: with fused operations, where these are
//! dispatched and the processor has them, and without. `docs/trust.md` says what is promised, and
//! where this was run.

mod bits;
mod by_hand;
#[cfg(feature = "ensemble")]
mod ensembles;
mod evaluations;
#[path = "../../kinds/mod.rs"]
mod kinds;
mod motions;
#[path = "../../handwritten/mod.rs"]
mod systems;

use bits::Bits;
use newton_euler::integrate::{Classical4, Midpoint, Tsitouras5, Verner9};

/// Compares what is computed with what is on record, and shows all that is another.
#[track_caller]
fn check<const N: usize>(rows: [(&str, Bits, u64); N]) {
    let others = rows
        .iter()
        .filter(|(_, found, recorded)| found.0 != *recorded);
    let shown: Vec<String> = others
        .map(|(name, found, recorded)| {
            format!("{name}: {:#018x}, on record {recorded:#018x}", found.0)
        })
        .collect();
    assert!(shown.is_empty(), "other bits\n{}", shown.join("\n"));
}

#[test]
fn evaluations_in_double_precision() {
    check([
        ("craft", evaluations::craft::<f64>(), 0x7049_699f_a2aa_f179),
        (
            "turning",
            evaluations::turning::<f64>(),
            0xe9fd_c8b4_d620_155a,
        ),
        ("top", evaluations::top::<f64>(), 0x2e07_565c_a44c_6ec1),
        ("rotor", evaluations::rotor::<f64>(), 0xa9a4_5451_1997_7055),
        ("wave", evaluations::wave::<f64>(), 0xd1d1_029f_6fae_b91c),
        (
            "bubble",
            evaluations::bubble::<f64>(),
            0x0860_9692_3218_531b,
        ),
        ("slopes", evaluations::slopes(), 0x95bc_1c05_7fe2_a4e7),
        ("plank", evaluations::plank::<f64>(), 0x8172_029b_2adb_bf59),
        (
            "slider",
            evaluations::slider::<f64>(),
            0x51ad_26e3_61f3_593b,
        ),
        (
            "pendulum",
            evaluations::pendulum::<f64>(),
            0xbf9f_0807_4978_5b3f,
        ),
        ("stick", evaluations::stick::<f64>(), 0x1157_5e2a_a861_cca9),
        ("quadrotor", evaluations::quadrotor(), 0xd081_dab8_d534_eff6),
        ("dipole", evaluations::dipole(), 0xee06_4e41_2311_91a0),
        ("bead", evaluations::bead(), 0x037b_208a_284d_9b78),
    ]);
}

#[test]
fn evaluations_in_single_precision() {
    check([
        ("craft", evaluations::craft::<f32>(), 0xbd37_9038_ecf8_cac2),
        (
            "turning",
            evaluations::turning::<f32>(),
            0x7e6d_a729_dd3b_4a69,
        ),
        ("top", evaluations::top::<f32>(), 0x9ac7_c314_edc5_4af1),
        ("rotor", evaluations::rotor::<f32>(), 0xa208_924d_51b6_cca9),
        ("wave", evaluations::wave::<f32>(), 0x8aff_067c_bae2_a0fd),
        (
            "bubble",
            evaluations::bubble::<f32>(),
            0xbed2_b339_8a9c_aafd,
        ),
        ("plank", evaluations::plank::<f32>(), 0x6bf1_3811_3881_f426),
        (
            "slider",
            evaluations::slider::<f32>(),
            0xf288_a254_184b_f5fb,
        ),
        (
            "pendulum",
            evaluations::pendulum::<f32>(),
            0x97e0_6ace_1208_fecf,
        ),
        ("stick", evaluations::stick::<f32>(), 0xf46a_fb28_1a23_c5bd),
    ]);
}

#[test]
fn steps_over_any_scalar() {
    check([
        ("f64", motions::steps_of::<f64>(), 0x4fee_e768_859c_6e22),
        ("f32", motions::steps_of::<f32>(), 0xc9ea_af31_5c91_d158),
    ]);
}

#[test]
fn motions_in_equal_steps() {
    check([
        ("Midpoint", motions::fixed(Midpoint), 0xbaee_a3c9_a1a1_bb16),
        (
            "Classical4",
            motions::fixed(Classical4),
            0x4c43_de97_6250_2bdb,
        ),
        (
            "Tsitouras5",
            motions::fixed(Tsitouras5),
            0x83cc_5137_1211_f838,
        ),
        (
            "DormandPrince8",
            motions::of_order_eight(),
            0x5ade_df52_ce98_fb49,
        ),
        ("Verner9", motions::fixed(Verner9), 0xd956_be07_df80_f753),
    ]);
}

#[test]
fn motions_by_tolerance() {
    check([
        ("DOP853", motions::adaptive(), 0x84cd_ac2c_b8f2_b16d),
        (
            "Verner 9(8)",
            motions::of_order_nine(),
            0x6f3e_d93d_1745_5d18,
        ),
        (
            "on constraints",
            motions::projected(),
            0xb6ef_e045_12e7_95f2,
        ),
        (
            "controller, events",
            motions::controlled(),
            0x88cb_60c9_6392_a610,
        ),
    ]);
}

/// States with a field for each joint.
#[test]
fn motions_of_systems() {
    check([
        ("by steps", motions::systems(), 0xca33_eb0d_3a76_ff5f),
        (
            "by one step along a series",
            motions::series_of_a_system(),
            0x8a0b_1c27_85c0_5aaf,
        ),
    ]);
}

/// A step for itself has no fused operations.
#[test]
fn closed_forms_and_single_series() {
    check([
        (
            "closed forms",
            motions::closed_forms(),
            0x1902_bdb1_a095_05a9,
        ),
        (
            "closed forms of systems",
            motions::closed_forms_of_systems(),
            0xf2c3_f281_94ab_b4bf,
        ),
        (
            "steps along series",
            motions::series_steps(),
            0x3dbe_1e19_c328_5c55,
        ),
    ]);
}

#[test]
fn motions_along_series() {
    #[cfg(all(feature = "dispatch", target_arch = "x86_64"))]
    let is_fused = is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma");
    #[cfg(not(all(feature = "dispatch", target_arch = "x86_64")))]
    let is_fused = false;
    if is_fused {
        check([("fused", motions::series(), 0xe48b_3913_95a1_2969)]);
    } else {
        check([("rounded each", motions::series(), 0x8a22_7f57_0475_5a78)]);
    }
}

#[cfg(feature = "ensemble")]
#[test]
fn ensembles_of_bodies() {
    check_ensembles(ensembles::bodies, 0xe64d_5eb2_3497_f4e1);
}

/// Optimized, these take minutes to compile.
#[cfg(all(feature = "ensemble", any(debug_assertions, feature = "whole")))]
#[test]
fn ensembles_of_further_bodies() {
    check_ensembles(ensembles::further_bodies, 0xacfd_092e_48f0_6cc3);
}

#[cfg(all(feature = "ensemble", any(debug_assertions, feature = "whole")))]
#[test]
fn ensembles_of_systems() {
    check_ensembles(ensembles::systems, 0x0e20_b6c4_38d9_1602);
}

/// Not optimized, a step of order eight in eight lanes of what has every function takes two to
/// three megabytes of stack.
#[cfg(feature = "ensemble")]
fn check_ensembles(moved: fn() -> Vec<(newton_euler::lanes::Width, Bits)>, recorded: u64) {
    let thread = std::thread::Builder::new().stack_size(8 << 20);
    let all = thread.spawn(moved).expect("a thread");
    for (width, bits) in all.join().expect("ensembles") {
        println!("{width:?}");
        check([("ensembles", bits, recorded)]);
    }
}

#[test]
fn by_hand() {
    check([
        ("inertia", by_hand::inertia(), 0x34e2_9b0d_679d_c13a),
        ("attitudes", by_hand::attitudes(), 0x2f07_6904_c72a_4b9b),
        ("wrenches", by_hand::wrenches(), 0x848d_91a7_63ab_66df),
        ("elliptic", by_hand::elliptic(), 0xa250_dd1b_129d_1dc5),
    ]);
}
