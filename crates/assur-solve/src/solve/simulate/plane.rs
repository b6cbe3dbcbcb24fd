//! Forces against the motion at points that move in the plane. Each is two elements, of the velocities along x and y, which are held or
//! slide together. The force acts against the velocity of a point that slides. A point begins to slide in the direction of its
//! acceleration.

use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::sliding_sense::Slipping;
use crate::math::Vec2;
use crate::plan::{Opposing, Path, Plan};
use crate::position::State;
use crate::solve::failure::Halt;

/// A speed below this part of the greatest speed of the run is zero: a point turns ever faster before it comes to rest.
const NONE: f64 = 1e-8;
/// A point that begins to slide keeps its direction up to the speed that its friction gives it in this part of a run: below, the equation
/// of its direction is too stiff.
const BEGIN: f64 = 1e-8;
/// The rest of a velocity that was removed, over the greatest speed of the run.
const ROUNDING: f64 = 1e-11;
/// The least speed, m/s, that has a direction.
const LEAST: f64 = 1e-100;
/// Where a point comes to rest the rates change by less than this part of the greatest so far.
const LITTLE: f64 = 1e-6;
/// So often at most a direction is turned to the acceleration.
const TURNS: usize = 8;
/// Halvings of the range of a factor.
const HALVINGS: usize = 80;

/// Both elements of the force to which one of them belongs.
pub(super) fn rows(plan: &Plan, element: usize) -> Option<[usize; 2]> {
    let DissipativeElement::Load(load) = DissipativeElement::of(plan, element) else { return None };
    let Some((_, Path::Plane(axis))) = load.point else { return None };
    Some([element - axis, element - axis + 1])
}

/// What goes together with an element.
pub(super) fn together(plan: &Plan, element: usize) -> impl Iterator<Item = usize> {
    let [first, second] = rows(plan, element).unwrap_or([element; 2]);
    first..=second
}

fn velocity(state: &State, load: &Opposing) -> Vec2 {
    load.point.map_or(Vec2::zero(), |(at, _)| state.motion.bodies[load.body].velocity(at))
}

impl Slipping {
    /// Lets points in the plane go on by their velocities.
    pub fn let_points_pass(&mut self, elements: &[usize]) {
        self.passes = true;
        for &element in elements {
            (self.senses[element], self.along[element]) = (1.0, Vec2::zero());
        }
    }
}

impl Equations<'_, '_> {
    /// Whether a point is so slow, in the state that was moved last, that it may be held.
    pub fn is_slow(&self, slipping: &Slipping, load: &Opposing) -> bool {
        velocity(&self.trial, load).norm() <= NONE * slipping.fastest * self.extent()
    }

    /// How far a point is from turning back within a step: its speed in the direction in which the step began, over the size.
    pub fn plane_room(&self, slipping: &Slipping, element: usize, load: &Opposing) -> f64 {
        let before = velocity(&self.accepted.1, load);
        let slow = before.norm() <= NONE * slipping.fastest * self.extent();
        let begun = slipping.along[element].unit().filter(|_| slow).or_else(|| before.unit());
        velocity(&self.trial, load).dot(begun.unwrap_or_default()) / self.extent()
    }

    /// Whether a way takes both elements of a force alike, and one that slides has a direction.
    pub fn is_whole(&self, slipping: &Slipping, element: usize) -> bool {
        let Some([x, y]) = rows(self.model.plan, element) else { return true };
        let senses = [slipping.senses[x], slipping.senses[y]];
        senses == [0.0; 2] || senses == [1.0; 2] && slipping.along[x] != Vec2::zero()
    }

    /// Lets a point that has begun to slide go by its velocity, where a step has ended at this state.
    pub fn let_go_on(&self, slipping: &mut Slipping) {
        for element in DissipativeElement::inner(self.model.plan)..slipping.senses.len() {
            let DissipativeElement::Load(load) = DissipativeElement::of(self.model.plan, element) else {
                continue;
            };
            let begun = velocity(&self.trial, load).norm() > slipping.along[element].norm();
            if slipping.senses[element] != 0.0 && begun {
                slipping.along[element] = Vec2::zero();
            }
        }
    }

    /// Removes the rest of the velocity of each point that slides and is slow enough to be at rest, since its next direction does not
    /// depend on it. Returns their elements.
    pub fn stop_in_plane(&mut self, slipping: &mut Slipping, (t, y): (f64, &mut [f64])) -> Vec<usize> {
        let plan = self.model.plan;
        if !slipping.begun || slipping.passes || plan.opposing.is_empty() {
            return Vec::new();
        }
        self.set_position(t, y);
        self.reduced.run_motion(plan, &mut self.trial);
        let slow = |(element, load): (usize, &Opposing)| {
            let slides = rows(plan, element).is_some() && slipping.senses[element] != 0.0;
            (slides && self.is_slow(slipping, load)).then_some(element)
        };
        let loads = (DissipativeElement::inner(plan)..).zip(&plan.opposing);
        let all: Vec<usize> = loads.filter_map(slow).collect();
        if all.is_empty() {
            return all;
        }
        let mut basis = self.basis(&[]);
        let mut slow = all.clone();
        slow.retain(|&element| self.is_independent(element, &mut basis));
        let held = std::mem::replace(&mut slipping.held, slow);
        let rests = std::mem::replace(&mut slipping.rests, false);
        self.find_slopes_at(slipping, (t, y));
        let (n, came) = (self.order(), y.to_vec());
        let stopped = self.stop_held(slipping, y).is_ok();
        (slipping.held, slipping.rests) = (held, rests);
        let most = LITTLE * slipping.fastest * self.extent().max(1.0);
        let little = |(now, before): (&f64, &f64)| (now - before).abs() <= most;
        if stopped && y[n..2 * n].iter().zip(&came[n..2 * n]).all(little) {
            return all;
        }
        // next to a singular position it rests for an instant alone, while the links move
        y.copy_from_slice(&came);
        slipping.let_points_pass(&all);
        Vec::new()
    }

    /// Finds in which direction a point begins to slide that a force can no longer hold, where everything was evaluated.
    ///
    /// With the effort φ that would hold it, its greatest value κ and the mass B of the point it accelerates by μ d, |d| = 1:
    /// (μ B + κ) d = −φ.
    pub fn aim(&self, slipping: &mut Slipping, element: usize) {
        let Some([x, y]) = rows(self.model.plan, element) else { return };
        let DissipativeElement::Load(load) = DissipativeElement::of(self.model.plan, element) else { return };
        if slipping.senses[x] != 0.0 {
            return;
        }
        let kappa = self.greatest_of_load(load.load).max(0.0);
        let pull = Vec2::new(-slipping.efforts[x], -slipping.efforts[y]);
        let places = [x, y].map(|row| slipping.held.iter().position(|held| *held == row));
        let (size, direction) = (pull.norm(), pull.unit().unwrap_or_default());
        let mut speed = LEAST;
        let along = match places {
            [Some(x), Some(y)] if size > kappa => {
                let [a, b, _, d] = self.mass_of(slipping, [x, y]);
                let root = |mu: f64| {
                    let (a, b, d) = (mu * a + kappa, mu * b, mu * d + kappa);
                    Vec2::new(d * pull.x - b * pull.y, a * pull.y - b * pull.x) * (1.0 / (a * d - b * b))
                };
                speed = BEGIN * (self.last - self.from) * 2.0 * kappa / (a + d);
                let least = 0.5 * (a + d - ((a - d).powi(2) + 4.0 * b * b).sqrt());
                let (mut low, mut high) = (0.0, (size - kappa) / least.max(f64::MIN_POSITIVE));
                for _ in 0..HALVINGS {
                    let middle = 0.5 * (low + high);
                    if root(middle).norm() > 1.0 { low = middle } else { high = middle }
                }
                root(low).unit().unwrap_or(direction)
            }
            _ => direction,
        };
        // next to a singular position the mass has no digits
        let along = if along.dot(along).is_finite() { along } else { direction };
        let least = (ROUNDING * slipping.fastest * self.extent()).max(LEAST);
        let along = along * if speed.is_finite() { speed.max(least) } else { least };
        (slipping.along[x], slipping.along[y]) = (along, along);
    }

    /// Turns the direction in which a point begins to slide to its acceleration, where that goes back: next to a singular position, or
    /// where others hold it in part, what would hold it does not tell the direction.
    ///
    /// # Errors
    /// There are no accelerations.
    pub fn turn_along(&mut self, slipping: &mut Slipping, element: usize) -> Result<(), Halt> {
        let plan = self.model.plan;
        let Some([x, y]) = rows(plan, element).filter(|[x, _]| *x == element) else { return Ok(()) };
        for _ in 0..TURNS {
            let [a_x, a_y] = [x, y].map(|row| DissipativeElement::of(plan, row).acceleration(&self.trial));
            let (a, along) = (Vec2::new(a_x, a_y), slipping.along[x]);
            let Some(direction) = a.unit().filter(|_| slipping.senses[x] != 0.0 && a.dot(along) < 0.0) else {
                break;
            };
            let along = direction * along.norm();
            (slipping.along[x], slipping.along[y]) = (along, along);
            self.slipping_accelerations(slipping)?;
        }
        Ok(())
    }

    /// The mass of a point at which two efforts hold, where all others hold too: a block of the inverse of their matrix.
    fn mass_of(&self, slipping: &mut Slipping, [x, y]: [usize; 2]) -> [f64; 4] {
        let (n, count) = (self.order(), slipping.held.len() + self.closed.len());
        let mut column = |at: usize| {
            let mut column = vec![0.0; count];
            column[at] = 1.0;
            slipping.matrix.solve(&mut column);
            [x, y].map(|row| column[row] * slipping.units[n + row] * slipping.units[n + at])
        };
        let ([a, c], [b, d]) = (column(x), column(y));
        [a, b, c, d]
    }
}
