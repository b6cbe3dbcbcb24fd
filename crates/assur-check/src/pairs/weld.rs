//! Welds: links that are one body.

use crate::expr::context::Context;
use crate::expr::property::{Read, find};
use crate::names::declared::ThingKind;
use crate::pairs::pair::{Joined, pins};
use crate::statements::written::{end_text, line_of};
use assur_model::model::PairKind;
use assur_syntax::document::{End, Joint, JointKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Spanned;

/// A weld of points. `properties` is absent where one of them has an error.
pub(crate) fn weld(
    cx: &mut Context<'_>,
    joint: &Joint,
    ends: &[Joined],
    properties: Option<&[Read]>,
) -> Option<PairKind> {
    let pins = pins(cx, joint, ends)?;
    let angle = find(properties.unwrap_or_default(), "angle");
    if let (Some(angle), true) = (angle, pins.len() > 2) {
        let name = &joint.name.node;
        let error = Diagnosis::error(
            "mech::geometry::incomplete",
            format!("`angle` is that of one link against another, but `{name}` joins {}", pins.len()),
        )
        .label(angle.span, "of which link?")
        .help("write one `weld` for each two links, each with its own `angle`");
        cx.error(error);
        return None;
    }
    Some(PairKind::Weld { pins, angle: angle.map_or(0.0, Read::number) })
}

/// Reports what turns or slides in a train: it has no points to weld.
pub(crate) fn no_shafts(cx: &mut Context<'_>, joint: &Joint) -> Option<()> {
    let of_train = |end: &End| {
        let End::At(path) = end else { return None };
        match cx.names.things.get(&path.head.node)?.what {
            kind @ (ThingKind::Shaft | ThingKind::Wheel | ThingKind::Slider) => Some((path.span(), kind)),
            _ => None,
        }
    };
    let found: Vec<_> = joint.ends.iter().filter_map(of_train).collect();
    let Some(&(span, kind)) = found.first() else { return Some(()) };
    let turns = found.len() == 2 && joint.ends.len() == 2 && found.iter().all(|f| f.1 != ThingKind::Slider);
    let clutch = Joint {
        kind: Spanned::new(JointKind::Clutch, joint.kind.span),
        properties: Vec::new(),
        ..joint.clone()
    };
    let help = match turns {
        true => format!("use a clutch: write `{} {{ capacity 40 N*m }}`", line_of(&clutch, end_text)),
        false => "name links with points: what belongs to a train is joined by wheels, ropes and clutches"
            .to_owned(),
    };
    cx.error(
        Diagnosis::error("mech::geometry::no_weld", format!("a weld joins links, not {}", kind.phrase()))
            .label(span, kind.phrase())
            .help(help),
    );
    None
}
