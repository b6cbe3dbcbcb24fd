//! Forces against the motion at points that move in the plane: two elements, of the velocities along x and y, that are held together or
//! slide together. What slides is pulled against its velocity; what begins to slide, in the direction in which it accelerates.

use super::dissipative::DissipativeElement;
use super::equations::Equations;
use super::sliding_sense::Slipping;
use crate::math::Vec2;
use crate::plan::{Opposing, Path, Plan};
use crate::position::State;

/// A speed below this part of the greatest so far is none: a point that comes to rest turns ever faster before.
const NONE: f64 = 1e-8;
/// What begins to slide keeps its direction up to the speed that its friction gives it in this part of a run: before, its direction is
/// stiff beyond all measure.
const BEGIN: f64 = 1e-8;
/// A speed that is none, m/s, where nothing presses.
const LEAST: f64 = 1e-100;
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

impl Equations<'_, '_> {
    /// Whether a point is so slow, in the state that was moved last, that it may be held.
    pub fn is_slow(&self, slipping: &Slipping, load: &Opposing) -> bool {
        velocity(&self.trial, load).norm() <= NONE * slipping.fastest * self.extent()
    }

    /// How far a point is from turning back within a step: its speed in the direction in which the step began, over the size.
    pub fn plane_room(&self, slipping: &Slipping, element: usize, load: &Opposing) -> f64 {
        let before = velocity(&self.accepted.1, load);
        let slow = before.norm() <= NONE * slipping.fastest * self.extent();
        let begun = if slow { slipping.along[element].unit() } else { before.unit() };
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
        let along = along * speed.max(LEAST);
        (slipping.along[x], slipping.along[y]) = (along, along);
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
