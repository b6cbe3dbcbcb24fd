//! What the drives say at many positions, quantity by quantity: several positions are read off in a row.

use super::kinematics::DriveInput;
use crate::math::{Lanes, V2, Vec2};

/// Inputs of drives at any number of positions.
#[derive(Clone, Debug)]
pub struct DriveColumns {
    drives: Vec<Columns>,
    positions: usize,
}

/// The inputs of one drive, see [`DriveInput`].
#[derive(Clone, Debug)]
struct Columns {
    place: V2<Vec<f64>>,
    value: Vec<f64>,
    rate: Vec<f64>,
    acceleration: Vec<f64>,
    /// Velocity and acceleration of a driven point; nothing where it is an angle or a coordinate.
    point: Option<[V2<Vec<f64>>; 2]>,
}

impl DriveColumns {
    /// # Given
    /// `inputs` of all `drives` at the first position, at the second, and so on.
    #[must_use]
    pub fn of(inputs: &[DriveInput], drives: usize) -> Self {
        let of_drive = |drive: usize| {
            let column = |f: fn(&DriveInput) -> f64| -> Vec<f64> {
                inputs.iter().skip(drive).step_by(drives).map(f).collect()
            };
            let velocity = V2 { x: column(|d| d.velocity.x), y: column(|d| d.velocity.y) };
            let acceleration =
                V2 { x: column(|d| d.point_acceleration.x), y: column(|d| d.point_acceleration.y) };
            let point = [velocity, acceleration];
            let moves = point.iter().flat_map(|v| v.x.iter().chain(&v.y)).any(|&x| x != 0.0);
            Columns {
                place: V2 { x: column(|d| d.place.x), y: column(|d| d.place.y) },
                value: column(|d| d.value),
                rate: column(|d| d.rate),
                acceleration: column(|d| d.acceleration),
                point: moves.then_some(point),
            }
        };
        Self { drives: (0..drives).map(of_drive).collect(), positions: inputs.len() / drives.max(1) }
    }

    /// Turns a drive to the angles, rad, one per position: their sines and cosines are computed here. Speeds stay.
    pub fn set_angles(&mut self, drive: usize, angles: &[f64]) {
        let Some(Columns { place, value, .. }) = self.drives.get_mut(drive) else { return };
        let column = place.x.iter_mut().zip(&mut place.y).zip(value);
        for (((x, y), value), &angle) in column.zip(angles) {
            let direction = Vec2::direction(angle);
            (*x, *y, *value) = (direction.x, direction.y, angle);
        }
    }

    #[must_use]
    pub fn len(&self) -> usize {
        self.positions
    }

    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.positions == 0
    }

    /// All drives at one position.
    #[doc(hidden)]
    #[inline]
    pub fn read(&self, position: usize, out: &mut [DriveInput]) {
        self.read_by(out, |column, out| {
            if let Some(x) = column.get(position) {
                *out = *x;
            }
        });
    }

    /// All drives at `N` positions from the `first` on.
    #[doc(hidden)]
    #[inline(always)]
    pub fn read_lanes<const N: usize>(&self, first: usize, out: &mut [DriveInput<Lanes<N>>]) {
        self.read_by(out, |column, out| {
            if let Some(row) = column.get(first..first + N) {
                out.0.copy_from_slice(row);
            }
        });
    }

    #[inline(always)]
    fn read_by<S>(&self, out: &mut [DriveInput<S>], read: impl Fn(&[f64], &mut S)) {
        for (columns, out) in self.drives.iter().zip(out) {
            let vector = |v: &V2<Vec<f64>>, out: &mut V2<S>| {
                read(&v.x, &mut out.x);
                read(&v.y, &mut out.y);
            };
            vector(&columns.place, &mut out.place);
            read(&columns.value, &mut out.value);
            read(&columns.rate, &mut out.rate);
            read(&columns.acceleration, &mut out.acceleration);
            if let Some([velocity, acceleration]) = &columns.point {
                vector(velocity, &mut out.velocity);
                vector(acceleration, &mut out.point_acceleration);
            }
        }
    }
}
