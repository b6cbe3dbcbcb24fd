//! Geneva wheels: their motion is a law of the crank's angle.

use super::geneva_step::GenevaStep;
use super::planned::Plan;
use super::step::MotionStep;
use crate::model::{GenevaPair, Mechanism};
use crate::structure::{BodyOrigin, Group, Structure};

/// The wheel whose block belongs to a group, with the block's slot.
pub fn geneva_in<'m>(
    mechanism: &'m Mechanism,
    structure: &Structure,
    group: &Group,
) -> Option<(usize, &'m GenevaPair)> {
    group.bodies.iter().find_map(|b| match structure.replaced.bodies[b.0].origin {
        BodyOrigin::Imaginary(pair) => Some((b.0, mechanism.genevas.iter().find(|g| g.pair == pair)?)),
        BodyOrigin::Link(_) => None,
    })
}

/// Whether a group is a wheel that its crank moves: the wheel and the block, nothing else.
pub fn is_wheel(group: &Group, block: usize, pair: &GenevaPair) -> bool {
    group.is_dyad_of(pair.wheel, block)
}

/// The step of a group that is a wheel moved by its crank.
pub(super) fn step(
    mechanism: &Mechanism,
    structure: &Structure,
    group: &Group,
    branch: usize,
    plan: &mut Plan,
) -> Option<MotionStep> {
    let (block, pair) = geneva_in(mechanism, structure, group)?;
    if !is_wheel(group, block, pair) {
        return None;
    }
    plan.genevas.push(GenevaStep { pair: *pair, block });
    Some(MotionStep::Geneva { branch, geneva: plan.genevas.len() - 1 })
}
