//! Twenty carts in a row between two walls, connected by springs: a state of forty numbers, and a
//! motion in closed form.

use std::f64::consts::PI;

use newton_euler::integrate::{ClosedForm, Integrate};
use newton_euler::prelude::*;
use newton_euler::taylor::{Arithmetic, Products, Series};

newton_euler::private::system_state! {
    /// The state of a [`Chain`].
    ChainState
    /// The acceleration of a [`Chain`].
    ChainAcceleration {
        link_1: Slide => f64,
        link_2: Slide => f64,
        link_3: Slide => f64,
        link_4: Slide => f64,
        link_5: Slide => f64,
        link_6: Slide => f64,
        link_7: Slide => f64,
        link_8: Slide => f64,
        link_9: Slide => f64,
        link_10: Slide => f64,
        link_11: Slide => f64,
        link_12: Slide => f64,
        link_13: Slide => f64,
        link_14: Slide => f64,
        link_15: Slide => f64,
        link_16: Slide => f64,
        link_17: Slide => f64,
        link_18: Slide => f64,
        link_19: Slide => f64,
        link_20: Slide => f64,
    }
}

pub const CARTS: usize = 20;

impl ChainState {
    /// Of all carts.
    pub fn of(carts: &[Slide; CARTS]) -> Self {
        let [
            link_1,
            link_2,
            link_3,
            link_4,
            link_5,
            link_6,
            link_7,
            link_8,
            link_9,
            link_10,
            link_11,
            link_12,
            link_13,
            link_14,
            link_15,
            link_16,
            link_17,
            link_18,
            link_19,
            link_20,
        ] = *carts;
        Self {
            link_1,
            link_2,
            link_3,
            link_4,
            link_5,
            link_6,
            link_7,
            link_8,
            link_9,
            link_10,
            link_11,
            link_12,
            link_13,
            link_14,
            link_15,
            link_16,
            link_17,
            link_18,
            link_19,
            link_20,
        }
    }

    /// All carts.
    pub fn carts(&self) -> [Slide; CARTS] {
        let Self {
            link_1,
            link_2,
            link_3,
            link_4,
            link_5,
            link_6,
            link_7,
            link_8,
            link_9,
            link_10,
            link_11,
            link_12,
            link_13,
            link_14,
            link_15,
            link_16,
            link_17,
            link_18,
            link_19,
            link_20,
        } = *self;
        [
            link_1, link_2, link_3, link_4, link_5, link_6, link_7, link_8, link_9, link_10,
            link_11, link_12, link_13, link_14, link_15, link_16, link_17, link_18, link_19,
            link_20,
        ]
    }
}

/// A cart is pulled by its neighbors.
fn pulls(positions: [f64; CARTS]) -> [f64; CARTS] {
    let at = |place: Option<usize>| place.and_then(|place| positions.get(place)).copied();
    std::array::from_fn(|k| {
        let [before, after] =
            [at(k.checked_sub(1)), at(Some(k + 1))].map(Option::unwrap_or_default);
        before + after - 2.0 * positions[k]
    })
}

#[derive(Clone, Copy, Debug, Default)]
pub struct Chain;

impl RigidBody for Chain {
    type Scalar = f64;
    type State = ChainState;
    type Input = ();

    fn acceleration(&self, _time: f64, state: &ChainState, (): &()) -> ChainAcceleration {
        let [
            link_1,
            link_2,
            link_3,
            link_4,
            link_5,
            link_6,
            link_7,
            link_8,
            link_9,
            link_10,
            link_11,
            link_12,
            link_13,
            link_14,
            link_15,
            link_16,
            link_17,
            link_18,
            link_19,
            link_20,
        ] = pulls(state.carts().map(|cart| cart.position));
        ChainAcceleration {
            link_1,
            link_2,
            link_3,
            link_4,
            link_5,
            link_6,
            link_7,
            link_8,
            link_9,
            link_10,
            link_11,
            link_12,
            link_13,
            link_14,
            link_15,
            link_16,
            link_17,
            link_18,
            link_19,
            link_20,
        }
    }
}

impl Integrate for Chain {
    type Best = ClosedForm;
}

impl Taylor for Chain {
    type Products<A: Arithmetic, const N: usize> = Products<A, 1, N>;

    fn expand<A: Arithmetic, const N: usize>(
        &self,
        _time: f64,
        state: &ChainState,
        (): &(),
        products: &mut Products<A, 1, N>,
        series: &mut Series<ChainState, N>,
    ) {
        series.start(state);
        for n in 1..N {
            let mut rates = [0.0; 2 * CARTS];
            let last = series.coefficients()[n - 1].0;
            let (positions, velocities) = last.split_at(CARTS);
            let positions = positions.try_into().unwrap_or([0.0; CARTS]);
            rates[..CARTS].copy_from_slice(velocities);
            rates[CARTS..].copy_from_slice(&pulls(positions));
            series.extend(products, n, rates);
        }
    }
}

/// The sum of its modes, at a start.
#[derive(Clone, Copy, Debug)]
pub struct ChainPath([Slide; CARTS]);

impl Flow for Chain {
    type Path = ChainPath;

    fn path(&self, state: &ChainState) -> ChainPath {
        ChainPath(state.carts())
    }
}

#[expect(clippy::cast_precision_loss, reason = "small")]
impl newton_euler::exact::Path for ChainPath {
    type State = ChainState;

    fn at(&self, time: f64) -> ChainState {
        let step = PI / (CARTS + 1) as f64;
        let mut carts = [Slide::default(); CARTS];
        for mode in 1..=CARTS {
            let shape = |k: usize| (step * ((mode * (k + 1)) as f64)).sin();
            let rate = 2.0 * (0.5 * step * mode as f64).sin();
            let share = |part: fn(&Slide) -> f64| -> f64 {
                let parts = self.0.iter().enumerate();
                parts.map(|(k, cart)| shape(k) * part(cart)).sum::<f64>() * 2.0 / (CARTS + 1) as f64
            };
            let (there, moving) = (share(|cart| cart.position), share(|cart| cart.velocity));
            let (sine, cosine) = (rate * time).sin_cos();
            for (k, cart) in carts.iter_mut().enumerate() {
                cart.position += shape(k) * (there * cosine + moving / rate * sine);
                cart.velocity += shape(k) * (moving * cosine - there * rate * sine);
            }
        }
        ChainState::of(&carts)
    }

    fn pace(&self, _time: f64) -> f64 {
        0.5
    }
}
