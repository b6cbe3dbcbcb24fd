//! Random mechanisms: a driven link, then a chain of structural groups on random earlier bodies.

use crate::support::draft::Draft;
use crate::support::random::Random;
use crate::support::reference::Reference;
use assur::internals::model::{Find, FindKind};
use assur::internals::source::Span;

/// The mechanism of this number.
pub fn mechanism(seed: u64) -> Draft {
    with_dead(seed, 0.0, 1.0)
}

/// The mechanism of this number, the first share of its groups near their dead positions, the second of its general
/// groups kept.
pub fn with_dead(seed: u64, flat: f64, general: f64) -> Draft {
    let mut draft = kinematics(seed, flat, general);
    finish(&mut draft);
    if draft.random.chance(0.6) {
        for _ in 0..6 {
            draft.add_balances();
            if Reference::new(&draft.mechanism, &draft.frames).is_some_and(|r| r.holds_well()) {
                return draft;
            }
        }
        draft.mechanism.balances.clear();
    }
    draft
}

/// Groups given alone: outer links driven at points carry them.
pub fn alone(seed: u64) -> Draft {
    let mut draft = Draft::new(Random::new(seed));
    for _ in 0..2 + draft.random.below(2) {
        draft.outer_link();
    }
    for _ in 0..1 + draft.random.below(3) {
        match draft.random.below(8) {
            0..=2 => draft.add_rrr(),
            3 => draft.add_rrp(),
            4 | 5 => draft.add_rpr(),
            6 => draft.add_rpp(),
            _ => draft.add_triad(),
        };
    }
    finish(&mut draft);
    draft
}

/// Masses, loads, and what is asked.
pub fn finish(draft: &mut Draft) {
    draft.add_masses();
    draft.add_loads();
    draft.hints();
    draft.mechanism.finds.push(Find {
        name: "reactions".into(),
        span: Span::default(),
        kind: FindKind::Reactions,
    });
}

fn kinematics(seed: u64, flat: f64, general: f64) -> Draft {
    let mut draft = Draft::new(Random::new(seed));
    (draft.flat, draft.general) = (flat, general);
    match draft.random.below(8) {
        0..=4 => draft.add_crank(),
        5 => draft.add_driven_slider(),
        6 => draft.add_elbow(),
        _ => draft.add_driven_legs(),
    };
    // near a dead position some draws come to nothing
    if draft.mechanism.drives.is_empty() {
        draft.add_crank();
    }
    for _ in 0..1 + draft.random.below(5) {
        let several = draft.mechanism.drives.len() > 2;
        let dyads_only = draft.general < 1.0 && !draft.random.chance(draft.general);
        match draft.random.below(40) {
            0..=5 => draft.add_rrr(),
            6..=9 => draft.add_rrp(),
            10..=13 => draft.add_rpr(),
            14..=16 => draft.add_prp(),
            17..=19 => draft.add_rpp(),
            20..=22 => draft.add_slot(),
            23..=26 => draft.add_contact(),
            27..=29 => draft.add_sliding_follower(),
            30 | 31 => draft.add_cylinder(),
            32 | 35 if dyads_only => draft.add_rrr(),
            32 => draft.add_roller(),
            33 | 34 => draft.add_wedge(),
            35 => draft.add_triad(),
            36 if !several => draft.add_crank(),
            37 if !several => draft.add_elbow(),
            38 if !several => draft.add_driven_slider(),
            39 if !several => draft.add_driven_legs(),
            _ => draft.add_rrr(),
        };
    }
    draft
}
