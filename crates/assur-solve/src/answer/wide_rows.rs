//! Numbers of positions side by side, written row by row where the columns have them.

use crate::math::{Scalar, V2, Vec2};
use crate::position::{DriveValue, F64x8, State, WIDTH};
use assur_text::units::Conversion;

/// Writes rows of numbers.
#[inline(always)]
pub(super) fn numbers(
    rows: &[State<F64x8>],
    out: &mut [f64],
    unit: Conversion,
    of: impl Fn(&State<F64x8>) -> F64x8,
) {
    for (state, out) in rows.iter().zip(out.chunks_mut(WIDTH)) {
        let x = of(state);
        put(out, &x, &x, unit);
    }
}

/// Writes rows of vectors.
#[inline(always)]
pub(super) fn vectors(
    rows: &[State<F64x8>],
    (x, y): (&mut [f64], &mut [f64]),
    unit: Conversion,
    of: impl Fn(&State<F64x8>) -> V2<F64x8>,
) {
    for (state, (x, y)) in rows.iter().zip(x.chunks_mut(WIDTH).zip(y.chunks_mut(WIDTH))) {
        let v = of(state);
        put(x, &v.x, &v.y, unit);
        put(y, &v.y, &v.x, unit);
    }
}

/// Writes a row of numbers. Half a vector does not exist.
#[inline(always)]
fn put(out: &mut [f64], x: &F64x8, beside: &F64x8, unit: Conversion) {
    let row = match unit {
        Conversion::None => *x,
        Conversion::Times(n) => *x * F64x8::of(n),
        Conversion::Over(factor) => *x / F64x8::of(factor),
    };
    let mut row = row;
    for (x, beside) in row.0.iter_mut().zip(beside.0) {
        *x = if beside.abs() < f64::INFINITY { *x } else { f64::NAN };
    }
    write_row(out, &row);
}

/// Writes a row of numbers, as far as there are places.
#[inline(always)]
pub(crate) fn write_row(out: &mut [f64], row: &F64x8) {
    // nearly always whole: in stores of vectors
    if let Ok(out) = <&mut [f64; WIDTH]>::try_from(&mut *out) {
        out.iter_mut().zip(row.0).for_each(|(out, x)| *out = finite(x));
    } else {
        out.iter_mut().zip(row.0).for_each(|(out, x)| *out = finite(x));
    }
}

/// An answer that is not a number does not exist.
#[inline]
#[must_use]
pub const fn finite(x: f64) -> f64 {
    if x.abs() < f64::INFINITY { x } else { f64::NAN }
}

/// The values of one of the drives, position by position.
pub(crate) fn of_drive(
    values: &[DriveValue],
    drives: usize,
    drive: usize,
) -> impl DoubleEndedIterator<Item = &DriveValue> {
    values.chunks_exact(drives.max(1)).map(move |values| &values[drive])
}

/// Writes the values of a drive: numbers, or vectors in two columns.
pub(super) fn write_drive<'v>(
    values: impl Iterator<Item = &'v DriveValue>,
    unit: Conversion,
    first: &mut [f64],
    second: Option<&mut [f64]>,
) {
    let Some(second) = second else {
        for (value, out) in values.zip(first) {
            let x = if let DriveValue::Scalar(x) = value { *x } else { f64::NAN };
            *out = finite(unit.of(x));
        }
        return;
    };
    for (value, (x, y)) in values.zip(first.iter_mut().zip(second)) {
        let p = if let DriveValue::Point(p) = value { *p } else { Vec2::new(f64::NAN, f64::NAN) };
        (*x, *y) = (finite(unit.of(p.x)), finite(unit.of(p.y)));
    }
}
