//! Random mechanisms and poses: as they were drawn, near their dead positions, driven elsewhere, scaled and shifted.

use crate::support::change::Change;
use crate::support::generate;
use crate::support::random::Random;
use assur::internals::math::Vec2;
use assur::internals::model::{Expr, Mechanism, Positions, Value};

/// General groups cost most of the time: this share of them is kept.
const GENERAL: f64 = 0.1;

/// A mechanism at a pose.
pub struct Hard {
    pub mechanism: Mechanism,
    /// Drawn far from its dead positions, and not moved since: there is an answer.
    pub easy: bool,
}

/// The case of this number.
pub fn model(seed: u64) -> Hard {
    let mut random = Random::new(seed ^ 0x5bd1_e995_0000_0000);
    let flat = if random.chance(0.6) { random.within(0.1, 0.6) } else { 0.0 };
    let mut mechanism = generate::with_dead(seed, flat, GENERAL).mechanism;
    let mut easy = flat == 0.0;
    if random.chance(0.3) {
        easy = false;
        let way = random.sign() * libm::exp10(random.within(-9.0, 0.5));
        move_first_drive(&mut mechanism, way);
    }
    if random.chance(0.3) {
        let mut change = Change::none(&mechanism);
        change.length = libm::exp10(random.within(-4.0, 4.0));
        change.mass = libm::exp10(random.within(-4.0, 4.0));
        change.shift = Vec2::new(random.within(-3.0, 3.0), random.within(-3.0, 3.0)) * change.length;
        mechanism = change.apply(&mechanism);
    }
    Hard { mechanism, easy }
}

fn move_first_drive(mechanism: &mut Mechanism, way: f64) {
    let first = mechanism.drives.first_mut().map(|d| &mut d.positions);
    let Some(Positions::List(list)) = first else { return };
    for value in list {
        match value {
            Expr::Constant(Value::Scalar(x)) => *x += way,
            Expr::Constant(Value::Vector(v)) => *v += Vec2::new(way, 0.5 * way),
            _ => {}
        }
    }
}
