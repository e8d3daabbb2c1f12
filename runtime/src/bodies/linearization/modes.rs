//! The modes of a linear motion: the eigenvalues of A.

use nalgebra::allocator::Allocator;
use nalgebra::{Complex, Const, DefaultAllocator, DimDiff, DimSub, SMatrix, SVector, Schur, U1};

use super::balanced::Balanced;
use super::coupled::{coupled, part};
use super::orthogonal::{Turning, orthogonalize};
use super::resolvent::distance;

/// A mode of a linear motion, `x ~ exp(eigenvalue t)`: an oscillation, from a pair of eigenvalues,
/// or pure growth or decay.
///
/// ```
/// use newton_euler::linearization::Mode;
/// use newton_euler::nalgebra::Complex;
///
/// let swing = Mode { eigenvalue: Complex::new(-0.3, 0.4), is_neutral: false };
/// assert_eq!([swing.natural_frequency(), swing.damping_ratio()], [0.5, 0.6]);
/// assert!((swing.period().unwrap() - 15.707963267948966).abs() < 1e-14);
/// assert!((swing.time_to_half().unwrap() - 2.0_f64.ln() / 0.3).abs() < 1e-15);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// The eigenvalue \[1/s\]; of a pair, the one with positive imaginary part. The real part is
    /// zero where it is rounding: then the mode neither grows nor decays, as far as doubles tell.
    pub eigenvalue: Complex<f64>,
    /// Whether the eigenvalue is zero to rounding: the motion neither returns nor departs
    /// exponentially. Positions and headings that nothing holds are neutral.
    pub is_neutral: bool,
}

impl Mode {
    /// The magnitude of the eigenvalue \[rad/s\].
    #[must_use]
    pub fn natural_frequency(&self) -> f64 {
        libm::hypot(self.eigenvalue.re, self.eigenvalue.im)
    }

    /// One for critical damping, negative for growth; 1 or -1 for a mode without oscillation, zero
    /// for an oscillation that neither grows nor decays, and NaN for a neutral mode.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        (0.0 - self.eigenvalue.re) / self.natural_frequency()
    }

    /// The period of an oscillation \[s\].
    #[must_use]
    pub fn period(&self) -> Option<f64> {
        let rate = self.eigenvalue.im;
        (rate > 0.0).then(|| core::f64::consts::TAU / rate)
    }

    /// The time in which a decaying mode halves \[s\]; `None` for a mode that grows, and for one that
    /// does neither to rounding.
    #[must_use]
    pub fn time_to_half(&self) -> Option<f64> {
        let rate = -self.eigenvalue.re;
        (rate > 0.0).then(|| core::f64::consts::LN_2 / rate)
    }

    /// The time in which a growing mode doubles \[s\]; `None` for a mode that decays, and for one
    /// that does neither to rounding.
    #[must_use]
    pub fn time_to_double(&self) -> Option<f64> {
        let rate = self.eigenvalue.re;
        (rate > 0.0).then(|| core::f64::consts::LN_2 / rate)
    }
}

/// The modes of a motion, at most N, the fastest first, neutral ones last.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modes<const N: usize> {
    all: [Mode; N],
    count: usize,
}

impl<const N: usize> core::ops::Deref for Modes<N> {
    type Target = [Mode];

    fn deref(&self) -> &[Mode] {
        &self.all[..self.count]
    }
}

impl<const N: usize> Modes<N> {
    /// The number of eigenvalues that are zero to rounding.
    #[must_use]
    pub fn neutral(&self) -> usize {
        self.iter().filter(|mode| mode.is_neutral).count()
    }

    /// Whether all modes except neutral ones decay. Oscillations without damping do not, nor do
    /// those whose decay is lost in rounding.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        let mut moving = self.iter().filter(|mode| !mode.is_neutral);
        moving.all(|mode| mode.eigenvalue.re < 0.0)
    }

    /// The modes of the first rows and columns of a matrix, which is known to a fraction of its norm,
    /// apart from rounding. Parts that do not have an effect on each other and back have their own
    /// modes, so that the rounding of a fast one does not hide a slow one. `None` if the matrix is not
    /// finite.
    pub(super) fn of(matrix: &SMatrix<f64, N, N>, size: usize, noise: f64) -> Option<Self>
    where
        Const<N>: DimSub<U1>,
        DefaultAllocator:
            Allocator<Const<N>, DimDiff<Const<N>, U1>> + Allocator<DimDiff<Const<N>, U1>>,
    {
        if !matrix.iter().all(|entry| entry.is_finite()) {
            return None;
        }
        let mut modes = Self {
            all: [Mode {
                eigenvalue: Complex::new(0.0, 0.0),
                is_neutral: true,
            }; N],
            count: 0,
        };
        let mut neutral = 0;
        let parts = coupled(matrix, size);
        for first in (0..size).filter(|number| parts[*number] == *number) {
            let (matrix, size) = part(matrix, |number| number < size && parts[number] == first);
            neutral += modes.add_moving(&matrix, size, noise)?;
        }
        modes.all[..modes.count].sort_unstable_by(|a, b| {
            let order = b.natural_frequency().total_cmp(&a.natural_frequency());
            order.then(a.eigenvalue.re.total_cmp(&b.eigenvalue.re))
        });
        modes.count += neutral;
        Some(modes)
    }

    /// Adds the modes of a part, apart from its neutral directions, of which it returns the number.
    fn add_moving(&mut self, part: &SMatrix<f64, N, N>, size: usize, noise: f64) -> Option<usize>
    where
        Const<N>: DimSub<U1>,
        DefaultAllocator:
            Allocator<Const<N>, DimDiff<Const<N>, U1>> + Allocator<DimDiff<Const<N>, U1>>,
    {
        let Balanced { matrix, scale, .. } = Balanced::of(part)?;
        let count = f64::from(u32::try_from(size).unwrap_or(u32::MAX));
        let rounding = (ROUNDING * count + noise) * matrix.norm();
        let (rest, moving) = without_neutral(matrix, size, NEUTRAL + noise);
        let values = eigenvalues(rest, moving)?;
        for value in values.iter().take(moving).filter(|value| value.im >= 0.0) {
            let mut value = *value;
            if is_undamped(&rest, moving, value, rounding) {
                value.re = 0.0;
            }
            self.all[self.count] = Mode {
                eigenvalue: value * scale,
                is_neutral: value.re == 0.0 && value.im == 0.0,
            };
            self.count += 1;
        }
        Some(size - moving)
    }
}

/// Iterations for each eigenvalue; three are common.
const ITERATIONS: usize = 60;

/// Failing iterations restart in other axes, because shifts may stall on orthogonal matrices. The
/// axes are mirrored across planes that no symmetry of a motion has.
const MIRRORS: [f64; 4] = [1.618, 2.414, 3.303, 4.236];

/// Eigenvalues by the Schur form of the first rows and columns, each at its place on the diagonal.
fn eigenvalues<const N: usize>(
    mut matrix: SMatrix<f64, N, N>,
    size: usize,
) -> Option<SVector<Complex<f64>, N>>
where
    Const<N>: DimSub<U1>,
    DefaultAllocator: Allocator<Const<N>, DimDiff<Const<N>, U1>> + Allocator<DimDiff<Const<N>, U1>>,
{
    for pitch in MIRRORS {
        let schur = Schur::<f64, Const<N>>::try_new(matrix, f64::EPSILON, ITERATIONS * N);
        if let Some(schur) = schur {
            return Some(schur.complex_eigenvalues().map(at_a_double_root));
        }
        let mut angle = 1.0;
        let normal = SVector::<f64, N>::from_fn(|row, _| {
            angle += pitch;
            if row < size { libm::sin(angle) } else { 0.0 }
        });
        let normal = normal / normal.norm();
        let mirror = SMatrix::identity() - normal * normal.transpose() * 2.0;
        matrix = mirror * matrix * mirror;
    }
    None
}

/// The roots of a block that rounding makes real are given as NaN off the real axis: there the two
/// are one, to the root of rounding.
fn at_a_double_root(mut value: Complex<f64>) -> Complex<f64> {
    if value.im.is_nan() {
        value.im = 0.0;
    }
    value
}

/// The rounding errors of the Schur form are those of a change of the balanced matrix by at most
/// this fraction of its norm, times its size (J. H. Wilkinson, The Algebraic Eigenvalue Problem, 8).
const ROUNDING: f64 = 10.0 * f64::EPSILON;

/// Whether the real part of an eigenvalue is rounding: whether a change of the matrix within
/// rounding gives it any value down to zero. The eigenvalues of all such matrices are the
/// pseudospectrum of this one; an eigenvalue that is sensitive moves far in it. One point on the way
/// distinguishes the eigenvalue from others at the same frequency.
fn is_undamped<const N: usize>(
    matrix: &SMatrix<f64, N, N>,
    size: usize,
    value: Complex<f64>,
    rounding: f64,
) -> bool {
    [0.0, 0.5].into_iter().all(|part| {
        let point = Complex::new(part * value.re, value.im);
        distance(matrix, size, point) <= rounding
    })
}

/// A singular value below this fraction of the largest counts as zero.
const NEUTRAL: f64 = 1e-13;

/// A column of a matrix, and the combination of columns that produced it.
#[derive(Clone, Copy)]
struct Column<const N: usize> {
    entries: SVector<f64, N>,
    of: SVector<f64, N>,
}

impl<const N: usize> Turning for Column<N> {
    fn dot(&self, other: &Self) -> f64 {
        self.entries.dot(&other.entries)
    }

    fn sum(&self, cosine: f64, other: &Self, sine: f64) -> Self {
        Self {
            entries: self.entries * cosine + other.entries * sine,
            of: self.of * cosine + other.of * sine,
        }
    }
}

/// An orthonormal basis V with the columns of `matrix V`, orthogonal. The columns that are
/// zero to `rounding` come last; also returns the number of the others.
fn basis<const N: usize>(
    matrix: &SMatrix<f64, N, N>,
    size: usize,
    rounding: f64,
) -> ([Column<N>; N], usize) {
    let mut columns = core::array::from_fn(|number| Column {
        entries: matrix.column(number).into_owned(),
        of: unit(number),
    });
    let some = &mut columns[..size];
    orthogonalize(some);
    some.sort_unstable_by(|a, b| b.dot(b).total_cmp(&a.dot(a)));
    let floor = some
        .first()
        .map_or(0.0, |first| rounding * rounding * first.dot(first));
    let rank = some
        .iter()
        .filter(|column| column.dot(column) > floor)
        .count();
    (columns, rank)
}

/// A matrix with its zero eigenvalues removed, and its size. The null space gives neutral
/// directions, and so do directions that move only along it (the staircase of V.
/// Kublanovskaya). Each step is a rank test. It recognizes zeros that would otherwise come out as
/// roots of rounding errors, such as those of a train without brakes.
fn without_neutral<const N: usize>(
    mut matrix: SMatrix<f64, N, N>,
    mut size: usize,
    rounding: f64,
) -> (SMatrix<f64, N, N>, usize) {
    let largest = matrix.amax();
    loop {
        let (columns, rank) = basis(&matrix, size, rounding);
        if rank == size {
            return (matrix, size);
        }
        matrix = SMatrix::zeros();
        size = rank;
        for row in 0..rank {
            for column in 0..rank {
                matrix[(row, column)] = columns[row].of.dot(&columns[column].entries);
            }
        }
        // the rest is rounding
        if matrix.amax() <= rounding * largest {
            return (SMatrix::zeros(), 0);
        }
    }
}

/// A matrix restricted to the directions that some rows permit, and their number. The directions are
/// known to a fraction `noise` of their length.
pub(super) fn restricted<const N: usize>(
    matrix: &SMatrix<f64, N, N>,
    rows: &SMatrix<f64, N, N>,
    noise: f64,
) -> (SMatrix<f64, N, N>, usize) {
    let (columns, rank) = basis(rows, N, ROWS);
    let permitted = &columns[rank..];
    // noise in a balanced matrix would be as large as what it is balanced with (D. Watkins, A case
    // where balancing is harmful)
    let from = |along: &Column<N>| matrix.tr_mul(&along.of).norm();
    let is_noise = |entry: f64, image: &SVector<f64, N>, along: &Column<N>| {
        rank > 0 && entry.abs() <= noise * (image.norm() + from(along))
    };
    let mut inside = SMatrix::zeros();
    for (number, to) in permitted.iter().enumerate() {
        let image = matrix * to.of;
        for (row, along) in permitted.iter().enumerate() {
            let entry = along.of.dot(&image);
            if !is_noise(entry, &image, along) {
                inside[(row, number)] = entry;
            }
        }
    }
    (inside, permitted.len())
}

fn unit<const N: usize>(number: usize) -> SVector<f64, N> {
    SVector::from_fn(|row, _| f64::from(u8::from(row == number)))
}

/// A row below this fraction of the largest is ignored.
const ROWS: f64 = 1e-9;
