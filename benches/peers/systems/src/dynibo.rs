//! dynibo: a Rust library that reads a file and walks its tree.

use std::ffi::{CStr, c_char, c_void};
use std::slice;
use std::time::Instant;

use ::dynibo::Robot;

/// # Safety
/// The path must end with a zero byte.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn make(path: *const c_char) -> *mut c_void {
    // SAFETY: as above
    let path = unsafe { CStr::from_ptr(path) };
    let robot = Robot::from_urdf(path.to_str().expect("a path")).expect("a robot of hinges");
    Box::into_raw(Box::new(robot)).cast()
}

/// The time in ns of this many rounds over all states.
///
/// # Safety
/// The robot must come from [`make`], and the lists must be as long as its joints and the states
/// require.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn run(
    robot: *mut c_void,
    states: usize,
    q: *const f64,
    v: *const f64,
    drives: *const f64,
    found: *mut f64,
    rounds: usize,
) -> f64 {
    // SAFETY: as above
    let robot = unsafe { &mut *robot.cast::<Robot>() };
    let joints = robot.joint_count();
    // SAFETY: as above
    let [q, v, drives] =
        unsafe { [q, v, drives].map(|list| slice::from_raw_parts(list, states * joints)) };
    // SAFETY: as above
    let found = unsafe { slice::from_raw_parts_mut(found, states * joints) };
    let of = |k: usize| k * joints..(k + 1) * joints;
    let start = Instant::now();
    for _ in 0..rounds {
        for k in 0..states {
            let (q, v, drives) = (&q[of(k)], &v[of(k)], &drives[of(k)]);
            let found = &mut found[of(k)];
            robot
                .forward_dynamics(q, v, drives, &[], found)
                .expect("not singular");
        }
    }
    start.elapsed().as_secs_f64() * 1e9
}
