//! Lagrange's equations of a tree of bodies: a second derivation, from the kinetic energy alone.
//!
//! ```text
//! d/dt dT/dq' - dT/dq = Q        T(q, q') = sum of (m v^2 + w . J w) / 2
//! ```
//!
//! Derivatives are exact, by jets. Positions are jets in time, so velocities are their slopes, and
//! these are jets in the coordinates and rates. A free rotation has its own chart about its state,
//! `R = R_0 exp(x)`. There `x' = w` and `x'' = w'`, in the axes of the carried body, so Lagrange's
//! equations along x are the balances of moments along these axes.

pub mod jet;

use jet::{Jet, Real};

pub type Vector<N> = [N; 3];
pub type Matrix<N> = [[N; 3]; 3];

/// How a joint moves what it carries, one after the other.
#[derive(Clone, Copy)]
pub enum Part<N> {
    /// Along a direction.
    Slide(Vector<N>),
    /// About one.
    Turn(Vector<N>),
    /// About one, and so far along it for each radian.
    Screw(Vector<N>, N),
    /// In all directions, from this attitude.
    Ball(Matrix<N>),
}

impl<N> Part<N> {
    const fn freedoms(&self) -> usize {
        match self {
            Self::Ball(_) => 3,
            _ => 1,
        }
    }
}

/// A body with the joint that carries it.
pub struct Body<N> {
    pub mass: N,
    pub inertia: Matrix<N>,
    pub carrier: Option<usize>,
    /// The joint on the carrier, from its G, and on the body, from its own.
    pub place: Vector<N>,
    pub pin: Vector<N>,
    /// How the body is turned where its coordinates are zero.
    pub turned: Matrix<N>,
    pub parts: Vec<Part<N>>,
}

/// Of all coordinates, body by body: values, rates, accelerations; of what turns in all directions the
/// values are not read.
pub struct State<'a, N> {
    pub q: &'a [N],
    pub v: &'a [N],
    pub a: &'a [N],
}

/// Force, and moment about G, world axes.
pub type Load<N> = [Vector<N>; 2];

/// A place, and axes.
type Pose<N> = (Vector<Jet<N>>, Matrix<Jet<N>>);

/// What is left of Lagrange's equation of each coordinate, without what drives it; and of what size the
/// terms are.
pub fn missing<N: Real>(
    bodies: &[Body<N>],
    state: &State<'_, N>,
    loads: &[Load<N>],
    size: impl Fn(N) -> f64,
) -> Vec<(N, f64)> {
    let count = state.q.len();
    let (zero, one) = (N::from(0.0), N::from(1.0));
    let unit = |i: usize, k: usize| if i == k { one } else { zero };
    let rows = (0..count).map(|i| {
        // the first small part is the rate, the second the time, the third what makes velocities
        let momentum: Vec<Jet<N>> = (0..count)
            .map(|k| {
                let mut jet = Jet::moving(state.q[k], [zero, state.v[k], state.v[k]]);
                // e3 (q' + e1 d_ik + e2 q'')
                (jet.0[5], jet.0[6]) = (unit(i, k), state.a[k]);
                jet
            })
            .collect();
        let change = kinetic(bodies, &momentum).0[3];
        // the first small part is the coordinate
        let along: Vec<Jet<N>> = (0..count)
            .map(|k| Jet::moving(state.q[k], [unit(i, k), zero, state.v[k]]))
            .collect();
        let slope = kinetic(bodies, &along).0[1];
        let work = virtual_work(bodies, &along, loads);
        (
            change - slope - work,
            size(change) + size(slope) + size(work),
        )
    });
    rows.collect()
}

/// Where the bodies are.
fn poses<N: Real>(bodies: &[Body<N>], q: &[Jet<N>]) -> Vec<Pose<N>> {
    let zero = N::from(0.0);
    let mut all: Vec<Pose<N>> = Vec::new();
    let mut rest = q;
    for body in bodies {
        let ground = ([Jet::real(zero); 3], constant(&identity()));
        let (mut place, mut axes) = body.carrier.map_or(ground, |carrier| all[carrier]);
        place = add(place, apply(&axes, body.place.map(Jet::real)));
        axes = product(&axes, &constant(&body.turned));
        for part in &body.parts {
            let (own, others) = rest.split_at(part.freedoms());
            rest = others;
            if let Part::Slide(d) = part {
                place = add(place, apply(&axes, d.map(|d| Jet::real(d) * own[0])));
            }
            if let Part::Screw(d, pitch) = part {
                let along = Jet::real(*pitch) * own[0];
                place = add(place, apply(&axes, d.map(|d| Jet::real(d) * along)));
            }
            match part {
                Part::Turn(d) | Part::Screw(d, _) => axes = product(&axes, &turn(*d, own[0])),
                Part::Ball(start) => {
                    axes = product(&axes, &constant(start));
                    axes = product(&axes, &exponential([own[0], own[1], own[2]]));
                }
                Part::Slide(_) => {}
            }
        }
        let pin = apply(&axes, body.pin.map(|part| -Jet::real(part)));
        all.push((add(place, pin), axes));
    }
    all
}

/// Velocity of G, and angular velocity in body axes.
fn velocities<N: Real>((place, axes): &Pose<N>) -> [Vector<Jet<N>>; 2] {
    let rate = axes.map(|row| row.map(Jet::third));
    let spin = product(&transposed(axes), &rate);
    let w = [spin[2][1], spin[0][2], spin[1][0]];
    [place.map(Jet::third), w]
}

fn kinetic<N: Real>(bodies: &[Body<N>], q: &[Jet<N>]) -> Jet<N> {
    let mut twice = Jet::real(N::from(0.0));
    for (body, pose) in bodies.iter().zip(poses(bodies, q)) {
        let [v, w] = velocities(&pose);
        let spin = apply(&constant(&body.inertia), w);
        twice = twice + Jet::real(body.mass) * dot(v, v) + dot(w, spin);
    }
    twice * Jet::real(N::from(0.5))
}

/// The work of the loads as the coordinate changes that the first small part moves.
fn virtual_work<N: Real>(bodies: &[Body<N>], q: &[Jet<N>], loads: &[Load<N>]) -> N {
    let mut work = N::from(0.0);
    for ((place, axes), [force, moment]) in poses(bodies, q).iter().zip(loads) {
        let real = axes.map(|row| row.map(|entry| entry.0[0]));
        let slope = axes.map(|row| row.map(|entry| entry.0[1]));
        // dR R^T
        let turned =
            |i: usize, j: usize| (0..3).fold(N::from(0.0), |sum, k| sum + slope[i][k] * real[j][k]);
        let phi = [turned(2, 1), turned(0, 2), turned(1, 0)];
        for axis in 0..3 {
            work = work + force[axis] * place[axis].0[1] + moment[axis] * phi[axis];
        }
    }
    work
}

pub fn identity<N: Real>() -> Matrix<N> {
    let unit = |i: usize, j: usize| N::from(if i == j { 1.0 } else { 0.0 });
    std::array::from_fn(|i| std::array::from_fn(|j| unit(i, j)))
}

fn constant<N: Real>(m: &Matrix<N>) -> Matrix<Jet<N>> {
    m.map(|row| row.map(Jet::real))
}

/// `1 + s K + (1 - c) K^2`, of a unit vector.
fn turn<N: Real>(d: Vector<N>, angle: Jet<N>) -> Matrix<Jet<N>> {
    let (sine, cosine) = angle.sin_cos();
    let k = crossing(d.map(Jet::real));
    let twice = product(&k, &k);
    let bend = Jet::real(N::from(1.0)) - cosine;
    let one = constant(&identity());
    std::array::from_fn(|i| {
        std::array::from_fn(|j| one[i][j] + sine * k[i][j] + bend * twice[i][j])
    })
}

/// `1 + X + X^2 / 2 + X^3 / 6` of small parts alone: there is no more.
fn exponential<N: Real>(x: Vector<Jet<N>>) -> Matrix<Jet<N>> {
    let x = crossing(x.map(|part| part - Jet::real(part.0[0])));
    let twice = product(&x, &x);
    let thrice = product(&twice, &x);
    let (half, sixth) = (Jet::real(N::from(0.5)), N::from(1.0 / 6.0));
    // one step of Newton's: a sixth is no double
    let sixth = Jet::real(sixth + (N::from(1.0) - sixth * N::from(6.0)) * sixth);
    let one = constant(&identity());
    std::array::from_fn(|i| {
        std::array::from_fn(|j| one[i][j] + x[i][j] + half * twice[i][j] + sixth * thrice[i][j])
    })
}

fn crossing<N: Real>([x, y, z]: Vector<Jet<N>>) -> Matrix<Jet<N>> {
    let zero = Jet::real(N::from(0.0));
    [[zero, -z, y], [z, zero, -x], [-y, x, zero]]
}

fn add<N: Real>(a: Vector<Jet<N>>, b: Vector<Jet<N>>) -> Vector<Jet<N>> {
    std::array::from_fn(|i| a[i] + b[i])
}

fn dot<N: Real>(a: Vector<Jet<N>>, b: Vector<Jet<N>>) -> Jet<N> {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn apply<N: Real>(m: &Matrix<Jet<N>>, v: Vector<Jet<N>>) -> Vector<Jet<N>> {
    m.map(|row| dot(row, v))
}

fn transposed<N: Real>(m: &Matrix<Jet<N>>) -> Matrix<Jet<N>> {
    std::array::from_fn(|i| std::array::from_fn(|j| m[j][i]))
}

fn product<N: Real>(a: &Matrix<Jet<N>>, b: &Matrix<Jet<N>>) -> Matrix<Jet<N>> {
    let columns = transposed(b);
    a.map(|row| columns.map(|column| dot(row, column)))
}
