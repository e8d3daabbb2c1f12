//! The derivatives of a motion with dual numbers, through the generic body.

use newton_euler::Dual;
use newton_euler::linearization::Linearized;
use newton_euler::state::{Coordinates, State};

/// A number with its derivative in one direction.
pub type Derived = Dual<f64, 1>;

fn with_slope(value: f64, slope: f64) -> Derived {
    Dual {
        value,
        derivatives: [slope],
    }
}

pub fn derived(value: f64) -> Derived {
    Derived::from(value)
}

/// A number by which something is differentiated, or another one.
pub fn by(value: f64, is_it: bool) -> Derived {
    with_slope(value, f64::from(u8::from(is_it)))
}

/// The coordinates of a state, each with its derivative by one coordinate of the tangent space.
fn along<S, D>(state: &S, column: usize) -> D
where
    S: Coordinates<Scalar = f64>,
    S::Acceleration: Default,
    D: Coordinates<Scalar = Derived>,
{
    let mut coordinates = state.coordinates();
    let count = coordinates.as_ref().len();
    let (places, rates) = (places(S::GROUPS), rates(S::GROUPS));
    let mut changes = vec![0.0; count];
    if column < places {
        // what comes before the rates moves as it does at this rate
        let mut moving = coordinates;
        moving.as_mut()[count - rates..].fill(0.0);
        moving.as_mut()[count - rates + column] = 1.0;
        let at = S::from_coordinates(&moving).rates(&S::Acceleration::default());
        changes[..count - rates].copy_from_slice(&at.as_ref()[..count - rates]);
    } else {
        changes[count - rates + column - places] = 1.0;
    }
    let mut list = D::Array::default();
    for ((to, value), change) in list
        .as_mut()
        .iter_mut()
        .zip(coordinates.as_mut())
        .zip(changes)
    {
        *to = with_slope(*value, change);
    }
    D::from_coordinates(&list)
}

/// How many coordinates of the tangent space come before the rates: of an attitude three.
fn places(groups: &[usize]) -> usize {
    let groups = groups[..groups.len() / 2].iter();
    groups
        .map(|group| if *group == 4 { 3 } else { *group })
        .sum()
}

/// How many rates a state has, those of one's own with them.
fn rates(groups: &[usize]) -> usize {
    groups[groups.len() / 2..].iter().sum()
}

/// The rates of the tangent space by one of its coordinates: those of a dual state, its acceleration
/// being known. An attitude q moves as q exp(e): `e' = 2 q* (dq' - q' e / 2)`.
fn column<S, D>(
    state: &S,
    moved: &D,
    acceleration: &D::Acceleration,
    column: Option<usize>,
) -> Vec<f64>
where
    S: Coordinates<Scalar = f64>,
    D: Coordinates<Scalar = Derived>,
{
    let found = moved.rates(acceleration);
    let (found, at) = (found.as_ref(), state.coordinates());
    let (mut first, mut place, mut list) = (0, 0, Vec::new());
    for group in &S::GROUPS[..S::GROUPS.len() / 2] {
        let slopes: Vec<f64> = (first..first + group)
            .map(|i| found[i].derivatives[0])
            .collect();
        if *group == 4 {
            let q: Vec<f64> = at.as_ref()[first..first + 4].to_vec();
            let rate: Vec<f64> = (first..first + 4).map(|i| found[i].value).collect();
            let mut e = [0.0; 4];
            if let Some(part) = column
                .and_then(|column| column.checked_sub(place))
                .filter(|part| *part < 3)
            {
                e[part] = 0.5;
            }
            let swept = product(&rate, &e);
            let rest: Vec<f64> = slopes
                .iter()
                .zip(swept)
                .map(|(slope, swept)| slope - swept)
                .collect();
            let turned = product(&[-q[0], -q[1], -q[2], q[3]], &rest);
            list.extend(turned[..3].iter().map(|part| 2.0 * part));
            place += 3;
        } else {
            list.extend(slopes);
            place += group;
        }
        first += group;
    }
    list.extend(found[first..].iter().map(|rate| rate.derivatives[0]));
    list
}

/// Of quaternions, the scalar last.
fn product(a: &[f64], b: &[f64]) -> [f64; 4] {
    [
        a[3] * b[0] + a[0] * b[3] + a[1] * b[2] - a[2] * b[1],
        a[3] * b[1] - a[0] * b[2] + a[1] * b[3] + a[2] * b[0],
        a[3] * b[2] + a[0] * b[1] - a[1] * b[0] + a[2] * b[3],
        a[3] * b[3] - a[0] * b[0] - a[1] * b[1] - a[2] * b[2],
    ]
}

/// Holds A and B against dual numbers, entry by entry, to so much of the largest entry of a row;
/// what the patterns call zero is zero.
pub fn hold<L, S, D, const N: usize, const M: usize>(
    found: &L,
    state: &S,
    bound: f64,
    by_state: impl Fn(&D) -> D::Acceleration,
    by_input: impl Fn(usize) -> D::Acceleration,
) where
    L: Linearized<N, M>,
    S: Coordinates<Scalar = f64>,
    S::Acceleration: Default,
    D: Coordinates<Scalar = Derived> + State<Scalar = Derived>,
{
    let (a, b) = (found.a(), found.b());
    let columns = (0..N).map(|j| {
        let moved: D = along(state, j);
        column(state, &moved, &by_state(&moved), Some(j))
    });
    let columns: Vec<Vec<f64>> = columns.collect();
    for row in 0..N {
        let entries = columns.iter().map(|column| column[row].abs());
        let size = entries.fold(1e-3, f64::max);
        for (j, column) in columns.iter().enumerate() {
            let (entry, expected) = (a[(row, j)], column[row]);
            let what = format!(
                "{} by {}: {entry} is {expected}",
                L::STATES[row],
                L::STATES[j]
            );
            assert!((entry - expected).abs() <= bound * size, "{what}");
            assert!(L::A_PATTERN[row][j] || entry == 0.0, "{what}");
        }
    }
    for j in 0..M {
        let at: D = unmoved(state);
        let entries = column(state, &at, &by_input(j), None);
        let size = entries
            .iter()
            .fold(1e-3_f64, |size, entry| size.max(entry.abs()));
        for (row, expected) in entries.into_iter().enumerate() {
            let entry = b[(row, j)];
            let what = format!(
                "{} by {}: {entry} is {expected}",
                L::STATES[row],
                L::INPUTS[j]
            );
            assert!((entry - expected).abs() <= bound * size, "{what}");
            assert!(L::B_PATTERN[row][j] || entry == 0.0, "{what}");
        }
    }
}

/// The same state in dual numbers.
pub fn unmoved<S, D>(state: &S) -> D
where
    S: Coordinates<Scalar = f64>,
    D: Coordinates<Scalar = Derived>,
{
    let mut list = D::Array::default();
    for (to, value) in list.as_mut().iter_mut().zip(state.coordinates().as_ref()) {
        *to = with_slope(*value, 0.0);
    }
    D::from_coordinates(&list)
}
