//! Members of one ensemble on MPI ranks: where thrown stones land, with air drag.
//!
//! Each rank takes a shard of the members, which are functions of their index, and moves it. The
//! first rank gathers the statistics of all shards. They are exact, so the mean has the same bits
//! on any number of ranks.
//!
//! Asserts: the merged statistics are those of all members on one rank.
//!
//! `mpirun -n 2 cargo run --release --manifest-path examples/mpi_ensemble/Cargo.toml`

use std::time::Instant;

use mpi::traits::{Communicator as _, CommunicatorCollectives as _, Root as _};
use newton_euler::columns::Named as _;
use newton_euler::ensemble::{Ensemble, Statistics, shard};
use newton_euler::prelude::*;
use newton_euler::state::generic;

rigid_body!(Stone::<T> {
    doc: "A stone in the drag of air.",
    motion: translation,
    params: [drag = 0.01[kg / m]],
    mass: 0.5[kg],
    fields: [weight = mass * world(0, 0, -9.80665[m / s ^ 2])],
    forces: [air = -drag * velocity.norm() * velocity],
});

/// The number of members.
const MEMBERS: u64 = 100_000;

type State = generic::Translation<f64>;

/// A number in [0, 1) from an index: the golden ratio spreads them evenly.
fn spread(index: u64, kind: u64) -> f64 {
    let bits = (index + 1)
        .wrapping_mul(0x9e37_79b9_7f4a_7c15 ^ (kind << 1))
        .rotate_left(29);
    f64::from(u32::try_from(bits >> 32).expect("32 bits")) / 4_294_967_296.0
}

fn member(index: u64) -> (StoneParams<f64>, State) {
    let params = StoneParams {
        drag: 0.008 + 0.004 * spread(index, 1),
    };
    let velocity = [30.0, 2.0 * spread(index, 2) - 1.0, 25.0 + spread(index, 3)];
    (
        params,
        State {
            velocity: velocity.into(),
            ..State::default()
        },
    )
}

/// The statistics of some members after four seconds.
fn moved(members: std::ops::Range<u64>) -> Statistics<State> {
    let mut all = Statistics::new();
    for first in members.clone().step_by(4096) {
        let block = first..members.end.min(first + 4096);
        let stones = Ensemble::<Stone<f64>>::with_params(block.map(member));
        let mut stones = stones.expect("all stones have mass");
        stones
            .integrate()
            .tolerance(1e-9)
            .to(4.0)
            .expect("a smooth motion");
        all.merge(&stones.statistics());
    }
    all
}

fn main() {
    let universe = mpi::initialize().expect("MPI");
    let world = universe.world();
    let [rank, size] = [world.rank(), world.size()].map(|n| u64::try_from(n).expect("positive"));
    let (members, clock) = (shard(MEMBERS, rank, size), Instant::now());
    let statistics = moved(members.clone());
    let (count, time) = (members.end - members.start, clock.elapsed());
    let own = serde_json::to_vec(&statistics).expect("numbers");
    let bytes = own.len();

    // texts of different lengths: padded with spaces to the longest
    let mut longest = 0_u64;
    let length = u64::try_from(own.len()).expect("short");
    world.all_reduce_into(
        &length,
        &mut longest,
        mpi::collective::SystemOperation::max(),
    );
    let longest = usize::try_from(longest).expect("short");
    let mut padded = own;
    padded.resize(longest, b' ');
    let root = world.process_at_rank(0);
    if rank != 0 {
        root.gather_into(&padded);
        return;
    }
    let mut gathered = vec![0_u8; longest * usize::try_from(size).expect("few")];
    root.gather_into_root(&padded, &mut gathered);
    let mut all = Statistics::<State>::new();
    for text in gathered.chunks(longest) {
        all.merge(&serde_json::from_slice(text).expect("as written"));
    }

    let each = time.as_nanos() / u128::from(count);
    println!("{MEMBERS} stones on {size} ranks, {each} ns each, {bytes} bytes a rank");
    let names = State::NAMES.to_string();
    for (name, moments) in names.split(',').zip(all.columns()) {
        let (mean, variance) = (moments.mean(), moments.variance());
        let (mean, variance) = (mean.expect("members"), variance.expect("members"));
        println!(
            "{name:>11}: {mean:>24e} ± {:.4e}, bits {:016x}",
            variance.sqrt(),
            mean.to_bits()
        );
    }
    assert_eq!(all, moved(0..MEMBERS), "the same bits on one rank");
}
