//! The number of products of series that an order takes, which determines the cost of a step.

use newton_euler::prelude::*;
use newton_euler::taylor::{Plain, Products};

rigid_body!(Heavy {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1).cross(world(0, 0, -1))],
    outputs: [taylor],
});

rigid_body!(Symmetric {
    motion: rotation,
    inertia: principal(1, 1, 0.5)[kg * m ^ 2],
    moments: [weight = body(0, 0, 1).cross(world(0, 0, -5))],
    outputs: [taylor],
});

rigid_body!(Free {
    motion: rotation,
    inertia: principal(0.6, 0.8, 1)[kg * m ^ 2],
    outputs: [taylor],
});

/// Products, with those that fill registers.
fn width<const WIDTH: usize, const N: usize>(_: &Products<Plain, WIDTH, N>) -> usize {
    WIDTH
}

fn check<B, const WIDTH: usize>(expected: usize)
where
    B: Taylor<Products<Plain, 9> = Products<Plain, WIDTH, 9>>,
{
    let products = B::Products::<Plain, 9>::from(Plain);
    assert_eq!(
        width(&products),
        expected,
        "{}",
        core::any::type_name::<B>()
    );
}

/// Each rate of attitude and angular velocity is a sum in a lane: of three products at most, or of two where the body turns evenly about
/// its axis, for that is no series.
#[test]
fn sums_share_registers() {
    check::<Heavy, _>(3 * 8);
    check::<Symmetric, _>(2 * 8);
    check::<Free, _>(3 * 8);
}
