//! Coordinates of what parts: a motion has the freedom that it has with all such contacts open, and those that are closed at the first
//! instant say where it begins.

use super::structure;
use crate::math::Vec2;
use crate::model::{
    Axis, Drive, DriveTarget, Expr, LinkId, Mechanism, PairId, PairKind, Positions, Profile, ProfileShape,
};
use assur_text::source::Span;

/// So many starts at most are found.
const MOST: usize = 3;

/// Enters a start for each freedom that no statement gives and that contacts which part take away while they are closed.
pub fn start_what_parts(mech: &mut Mechanism) {
    let parts = |kind: &PairKind| matches!(kind, PairKind::Contact { parts: true, .. });
    let parting = mech.pairs.iter().filter(|pair| parts(&pair.kind)).count();
    if parting == 0 || structure(mech).is_ok() {
        return;
    }
    let candidates = candidates(mech);
    for count in 1..=parting.min(MOST) {
        if let Some(found) = combination(mech, &candidates, count) {
            mech.touching.extend(mech.drives.len()..mech.drives.len() + count);
            mech.drives.extend(found);
            return;
        }
    }
}

/// The first of so many starts with which the mechanism is determinate.
fn combination(mech: &Mechanism, candidates: &[Drive], count: usize) -> Option<Vec<Drive>> {
    let mut chosen: Vec<usize> = (0..count).collect();
    loop {
        if candidates.len() < count {
            return None;
        }
        let mut trial = mech.clone();
        trial.drives.extend(chosen.iter().map(|i| candidates[*i].clone()));
        if structure(&trial).is_ok() {
            return Some(chosen.iter().map(|i| candidates[*i].clone()).collect());
        }
        let last = (0..count).rev().find(|i| chosen[*i] < candidates.len() - count + i)?;
        chosen[last] += 1;
        for i in last + 1..count {
            chosen[i] = chosen[i - 1] + 1;
        }
    }
}

/// Coordinates of the links that carry such contacts, as far as nothing gives them: those of their guides and hinges, then where a
/// profile is and the angle.
fn candidates(mech: &Mechanism) -> Vec<Drive> {
    let mut found: Vec<Drive> = Vec::new();
    for pair in &mech.pairs {
        let PairKind::Contact { first, second, parts: true, .. } = &pair.kind else { continue };
        for profile in [first, second].into_iter().filter(|profile| profile.link != LinkId::GROUND) {
            let (link, at) = (profile.link, place(profile));
            let name = &mech.link(link).name;
            for (index, own) in mech.pairs.iter().enumerate() {
                match &own.kind {
                    PairKind::Prismatic(guide) if [guide.slider, guide.guide].contains(&link) => {
                        let target = DriveTarget::Pair(PairId::at(index));
                        found.push(drive(own.name.clone(), target, pair.span));
                    }
                    PairKind::Revolute(pins) if pins.iter().any(|pin| pin.link == link) => {
                        found.push(drive(name.clone(), DriveTarget::Link(link), pair.span));
                    }
                    _ => {}
                }
            }
            let axes = [(Axis::X, "x"), (Axis::Y, "y")].map(|(axis, letter)| {
                drive(
                    format!("{name}.{}.{letter}", profile.name),
                    DriveTarget::Place(link, at, axis),
                    pair.span,
                )
            });
            found.extend(axes);
            found.push(drive(name.clone(), DriveTarget::Link(link), pair.span));
        }
    }
    let mut seen: Vec<DriveTarget> = mech.drives.iter().map(|drive| drive.target).collect();
    found.retain(|drive| {
        let fresh = !seen.contains(&drive.target);
        seen.push(drive.target);
        fresh
    });
    found
}

/// A point of a profile, in the frame of its link.
const fn place(profile: &Profile) -> Vec2 {
    match profile.shape {
        ProfileShape::Point(at) | ProfileShape::Circle(at, _) | ProfileShape::Line(at, _) => at,
        ProfileShape::Rim(_) => Vec2::new(0.0, 0.0),
    }
}

fn drive(name: String, target: DriveTarget, span: Span) -> Drive {
    Drive {
        name,
        span,
        target,
        positions: Positions::List(vec![Expr::number(0.0)]),
        written: None,
        speed: Some(Expr::number(0.0)),
        acceleration: None,
        sense: None,
        free: true,
        sought: None,
        of_time: false,
    }
}
