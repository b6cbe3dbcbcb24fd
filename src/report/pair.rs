//! Pairs as an author writes them.

use assur_model::model::{LinkId, Mechanism, PairKind, Profile};

/// The ends of a pair: `piston.C - ground.guide`.
pub(super) fn pair_text(mechanism: &Mechanism, kind: &PairKind) -> String {
    let name = |link: LinkId| mechanism.link(link).name.as_str();
    match kind {
        PairKind::Revolute(pins) => {
            let alike = pins.windows(2).all(|two| two[0].name == two[1].name);
            let pins = pins.iter().map(|p| {
                if alike { name(p.link).to_owned() } else { format!("{}.{}", name(p.link), p.name) }
            });
            pins.collect::<Vec<_>>().join(" - ")
        }
        PairKind::Prismatic(g) | PairKind::Slot(g) => {
            let slider = format!("{}.{}", name(g.slider), g.point_name);
            let line = format!("{}.{}", name(g.guide), g.line_name);
            if g.guide_first { format!("{line} - {slider}") } else { format!("{slider} - {line}") }
        }
        PairKind::Contact { first, second, .. } => {
            format!("{} - {}", profile_text(mechanism, first), profile_text(mechanism, second))
        }
        PairKind::Cylinder { from, to, .. } => {
            format!("{}.{} - {}.{}", name(from.link), from.name, name(to.link), to.name)
        }
        PairKind::Transmission(t) => t.ends.join(" - "),
    }
}

/// `cam.rim`
pub(super) fn profile_text(mechanism: &Mechanism, profile: &Profile) -> String {
    format!("{}.{}", mechanism.link(profile.link).name, profile.name)
}
