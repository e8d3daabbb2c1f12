//! Eigenvalues and eigenvectors of a symmetric matrix of numbers.
//!
//! A repeated eigenvalue of a matrix of rational entries is rational, and so is the direction of
//! the other eigenvector: both are found exactly. Eigenvalues count as equal only if that is
//! proved. Three different ones come from Jacobi's method at [`WORKING`] bits.

use super::exact::Number;
use super::float::Float;

/// A symmetric matrix, by rows.
pub type Matrix = [[Number; 3]; 3];

/// The bits of the iteration. Even if two eigenvalues agree to 60 digits, doubles are rounded
/// correctly.
const WORKING: usize = 512;
/// The most sweeps through the three planes. After 8 sweeps, each further one doubles the digits.
const SWEEPS: usize = 24;
/// The correct bits of the result.
const RIGHT: usize = 480;
/// A component of a unit vector below `2^-SMALL` may be zero.
const SMALL: isize = 200;

/// A symmetric matrix in its principal axes.
#[derive(Clone, Debug)]
pub enum Spectrum {
    /// `lambda 1`, a multiple of the unit matrix.
    Spherical(Number),
    Symmetric(Box<Symmetry>),
    General(Box<PrincipalAxes>),
}

/// Three different eigenvalues and their unit eigenvectors, which are right-handed. Each is the one
/// nearest to the coordinate axis with its index.
#[derive(Clone, Debug)]
pub struct PrincipalAxes {
    pub moments: [Number; 3],
    pub axes: [[Number; 3]; 3],
}

/// `across 1 + (along - across) n n`, where n is a unit vector.
#[derive(Clone, Debug)]
pub struct Symmetry {
    pub across: Number,
    pub along: Number,
    /// A vector along n; its largest component is one.
    pub axis: [Number; 3],
}

impl Spectrum {
    pub fn of(matrix: &Matrix) -> Self {
        if let Some(symmetry) = Symmetry::of(matrix) {
            return Self::Symmetric(Box::new(symmetry));
        }
        if !is_diagonal(matrix) {
            return Self::General(Box::new(jacobi(matrix)));
        }
        let moments = [0, 1, 2].map(|i| matrix[i][i].clone());
        if moments[0] == moments[1] {
            let [_, _, lambda] = moments;
            return Self::Spherical(lambda);
        }
        Self::General(Box::new(PrincipalAxes {
            moments,
            axes: [0, 1, 2].map(unit),
        }))
    }
}

impl Symmetry {
    /// The symmetry of a matrix with two equal eigenvalues and a third.
    pub fn of(matrix: &Matrix) -> Option<Self> {
        if !is_diagonal(matrix) {
            return Self::around(matrix, repeated(matrix)?);
        }
        let equal = |k: &usize| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            matrix[i][i] == matrix[j][j]
        };
        let mut axes = (0..3).filter(equal);
        let (Some(k), None) = (axes.next(), axes.next()) else {
            return None;
        };
        let other = (k + 2) % 3;
        Some(Self {
            across: matrix[other][other].clone(),
            along: matrix[k][k].clone(),
            axis: unit(k),
        })
    }

    /// If `across` is a double eigenvalue, `matrix - across 1` is a dyad: its largest column has
    /// the direction of the axis.
    fn around(matrix: &Matrix, across: Number) -> Option<Self> {
        let rest = |i: usize, k: usize| {
            if i == k {
                matrix[i][i].clone() - across.clone()
            } else {
                matrix[i][k].clone()
            }
        };
        let k = (0..3).max_by_key(|k| (rest(*k, *k).abs(), 2 - k))?;
        if rest(k, k).is_zero() {
            return None;
        }
        let (axis, _) = scaled(&[0, 1, 2].map(|i| rest(i, k)));
        let along = (0..3).fold(across.clone(), |sum, i| sum + rest(i, i));
        Some(Self {
            across,
            along,
            axis,
        })
    }
}

pub fn is_diagonal(matrix: &Matrix) -> bool {
    [(0, 1), (1, 2), (2, 0)]
        .iter()
        .all(|(i, k)| matrix[*i][*k].is_zero())
}

fn unit(k: usize) -> [Number; 3] {
    core::array::from_fn(|i| Number::integer(i64::from(i == k)))
}

/// A vector divided by its largest component, and that component.
pub fn scaled(vector: &[Number; 3]) -> ([Number; 3], Number) {
    let mut largest = vector[0].clone();
    for component in vector {
        if component.abs() > largest.abs() {
            largest = component.clone();
        }
    }
    let over = |component: &Number| component.checked_div(&largest);
    let ratios = vector
        .each_ref()
        .map(|component| over(component).unwrap_or_else(Number::zero));
    (ratios, largest)
}

/// The repeated eigenvalue of a non-diagonal matrix, if it has one. Such a matrix is
/// `lambda 1 + delta n n`, so lambda is what remains of the diagonal after subtracting
/// `delta n_i^2 = (delta n_i n_j) (delta n_k n_i) / (delta n_j n_k)`.
fn repeated(matrix: &Matrix) -> Option<Number> {
    let product = |i: usize, j: usize| &matrix[i][j];
    let zeros = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| product(i, j).is_zero());
    let lambda = |i: usize| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let square = product(i, j).clone() * product(k, i).clone();
        Some(matrix[i][i].clone() - square.checked_div(product(j, k))?)
    };
    match zeros {
        [false, false, false] => {
            let [x, y, z] = [lambda(0)?, lambda(1)?, lambda(2)?];
            (x == y && y == z).then_some(z)
        }
        // n lies in a coordinate plane, and `across` belongs to the normal of that plane: the rest
        // of the block is singular
        [false, true, true] | [true, false, true] | [true, true, false] => {
            let i = zeros.iter().position(|zero| !zero)?;
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let across = matrix[k][k].clone();
            let (a, b) = (
                matrix[i][i].clone() - across.clone(),
                matrix[j][j].clone() - across.clone(),
            );
            let square = product(i, j).clone() * product(i, j).clone();
            let other = square.checked_div(&b)?;
            (a == other).then_some(across)
        }
        _ => None,
    }
}

/// Rotates pairs of axes, each by at most 45 degrees, so that the product of inertia between them
/// vanishes, until none remains.
fn jacobi(matrix: &Matrix) -> PrincipalAxes {
    let mut j = [0, 1, 2].map(|i| [0, 1, 2].map(|k| matrix[i][k].to_float(WORKING)));
    let mut axes =
        [0, 1, 2].map(|i| [0, 1, 2].map(|k| Number::integer(i64::from(i == k)).to_float(WORKING)));
    for _ in 0..SWEEPS {
        let mut done = true;
        for (a, b) in [(0, 1), (1, 2), (2, 0)] {
            if let Some((cosine, sine)) = annihilating(&j, a, b) {
                done = false;
                for row in &mut j {
                    turn(row, a, b, &cosine, &sine);
                }
                j = transposed(j);
                for row in &mut j {
                    turn(row, a, b, &cosine, &sine);
                }
                for row in &mut axes {
                    turn(row, a, b, &cosine, &sine);
                }
            }
        }
        if done {
            break;
        }
    }
    let [x, y, z] = j;
    let ([x, _, _], [_, y, _], [_, _, z]) = (x, y, z);
    let measured = |float| Number::measured(float, RIGHT);
    let axes = transposed(axes).map(|axis| related(matrix, axis.map(measured)));
    nearest(&[x, y, z].map(measured), &axes)
}

/// An eigenvector n with what is known exactly about it: a component that is zero, and two
/// components that are equal up to sign.
fn related(matrix: &Matrix, mut n: [Number; 3]) -> [Number; 3] {
    let is_small = |number: &Number| number.abs() < Number::power_of_two(-SMALL);
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let (to_j, to_k) = (&matrix[i][j], &matrix[i][k]);
        let is_equal = matrix[j][j] == matrix[k][k] && to_j.abs() == to_k.abs();
        if n[i].is_zero() || to_j.is_zero() && to_k.is_zero() {
            if is_small(&n[i]) {
                n[i] = Number::zero();
            }
            // the eigenvectors of a block [[a, b], [b, a]] are (1, 1) and (1, -1)
            if n[i].is_zero() && to_j == to_k && is_equal && !is_small(&n[j]) {
                let opposite = n[j].is_negative() != n[k].is_negative();
                n[k] = if opposite {
                    -n[j].clone()
                } else {
                    n[j].clone()
                };
            }
        } else if !is_small(&n[i]) {
            // exchanging j and k, up to sign, leaves J unchanged, and so n
            if is_equal && !is_small(&n[j]) {
                n[k] = (to_k.clone() / to_j.clone()) * n[j].clone();
            }
        } else if let Some(ratio) = zero_component(matrix, i)
            // n must be this eigenvector, not one perpendicular to it
            && is_small(&(n[k].clone() - n[j].clone() * ratio.clone()))
        {
            n[i] = Number::zero();
            n[k] = n[j].clone() * ratio;
        }
    }
    n
}

/// `n_k / n_j` of an eigenvector with `n_i = 0`, if there is one and i is not itself a principal
/// axis: `(J n)_i = 0` leaves only one direction.
fn zero_component(matrix: &Matrix, i: usize) -> Option<Number> {
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    let ratio = (-matrix[i][j].clone()).checked_div(&matrix[i][k])?;
    let along = |row: usize| matrix[row][j].clone() + matrix[row][k].clone() * ratio.clone();
    (along(j) * ratio.clone() - along(k))
        .is_zero()
        .then_some(ratio)
}

/// Cosine and sine of the rotation that makes the entry `(a, b)` vanish, unless it is negligible
/// compared with the diagonal.
fn annihilating(j: &[[Float; 3]; 3], a: usize, b: usize) -> Option<(Float, Float)> {
    let zero = Float::ZERO;
    let product = j[a][b].clone();
    let size = j.iter().flatten().fold(zero.clone(), |largest, entry| {
        largest.max(magnitude(entry.clone()))
    });
    let negligible = size >> (WORKING - 16).cast_signed();
    if magnitude(product.clone()) <= negligible {
        return None;
    }
    let half = (j[b][b].clone() - j[a][a].clone()) >> 1;
    let hypotenuse = (half.clone() * half.clone() + product.clone() * product.clone()).sqrt();
    let tangent = if half < zero {
        product / (half - hypotenuse)
    } else {
        product / (half + hypotenuse)
    };
    let one = Number::one().to_float(WORKING);
    let cosine = one.clone() / (one + tangent.clone() * tangent.clone()).sqrt();
    let sine = tangent * cosine.clone();
    Some((cosine, sine))
}

fn magnitude(a: Float) -> Float {
    if a < Float::ZERO { -a } else { a }
}

/// Rotates the entries `a` and `b` of a row.
fn turn(row: &mut [Float; 3], a: usize, b: usize, cosine: &Float, sine: &Float) {
    let (x, y) = (row[a].clone(), row[b].clone());
    row[a] = cosine * &x - sine * &y;
    row[b] = sine * &x + cosine * &y;
}

fn transposed([x, y, z]: [[Float; 3]; 3]) -> [[Float; 3]; 3] {
    let ([a, b, c], [d, e, f], [g, h, i]) = (x, y, z);
    [[a, d, g], [b, e, h], [c, f, i]]
}

/// Assigns each axis to the nearest coordinate axis and makes it point that way. If they are then
/// left-handed, the one whose direction is least certain is reversed.
fn nearest(moments: &[Number; 3], axes: &[[Number; 3]; 3]) -> PrincipalAxes {
    const ORDERS: [[usize; 3]; 6] = [
        [0, 1, 2],
        [1, 2, 0],
        [2, 0, 1],
        [1, 0, 2],
        [0, 2, 1],
        [2, 1, 0],
    ];
    let nearness = |order: &[usize; 3]| {
        (0..3)
            .map(|place| axes[order[place]][place].abs())
            .fold(Number::zero(), |sum, cosine| sum + cosine)
    };
    let mut best = ORDERS[0];
    for order in ORDERS {
        let more = nearness(&order) - nearness(&best);
        if more.is_positive() && !more.is_undecided() {
            best = order;
        }
    }
    let moments = best.map(|k| moments[k].clone());
    let mut axes = best.map(|k| axes[k].clone());
    for (place, axis) in axes.iter_mut().enumerate() {
        if axis[place].is_negative() {
            *axis = axis.clone().map(|component| -component);
        }
    }
    if triple_product(&axes).is_negative()
        && let Some(place) = (0..3).min_by_key(|place| axes[*place][*place].abs())
    {
        axes[place] = axes[place].clone().map(|component| -component);
    }
    PrincipalAxes { moments, axes }
}

fn triple_product(m: &[[Number; 3]; 3]) -> Number {
    (0..3).fold(Number::zero(), |sum, i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        let minor = m[1][j].clone() * m[2][k].clone() - m[1][k].clone() * m[2][j].clone();
        sum + m[0][i].clone() * minor
    })
}
