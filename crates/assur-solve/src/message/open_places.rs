//! What the file leaves open: drives without position, shafts and sliders without place.

use super::format::{label, labels, links};
use crate::model::{DriveTarget, Mechanism, Pair, PairId, PairKind, TransmissionKind};
use crate::position::Model;
use crate::solve::Unpositioned;
use crate::source::Span;
use assur_text::diagnostic::Diagnosis;

/// A position depends on a drive which has none.
pub(super) fn no_position(model: &Model<'_>, drive: usize, what: Unpositioned) -> Diagnosis {
    let mechanism = model.mechanism;
    let depends = |span| vec![label("depends on the position", span)];
    let (what, mut labels) = match what {
        Unpositioned::Group(group) => {
            let group = &model.structure.motion[group];
            (format!("the position of {}", links(model, group)), labels(model, group, "moves with it"))
        }
        Unpositioned::Asked { what, place } => (what.to_owned(), depends(place)),
        Unpositioned::Force(load) => {
            ("the point of a force".to_owned(), depends(mechanism.loads[load.index()].span))
        }
        Unpositioned::Links(place) => {
            ("the position of the links in `find reactions`".to_owned(), depends(place))
        }
    };
    let drive = &mechanism.drives[drive];
    labels.push(label("a speed without a position", drive.span));
    let example = match drive.target {
        DriveTarget::Link(_) => "0 deg",
        _ => "0 m",
    };
    let help = format!(
        "write the position before the speed: `drive {} = {example} at …`; the angles and distances of a train are all zero together",
        drive.name
    );
    Diagnosis::error(
        "mech::train::no_position",
        format!("{what} depends on the position of `{}`, which is not given", drive.name),
    )
    .labels(labels)
    .help(help)
}

/// A reaction that is asked for and has no place.
pub(super) fn no_place(mechanism: &Mechanism, pair: PairId, place: Span) -> Diagnosis {
    let declared = mechanism.pair(pair);
    let mut labels = vec![label("asked for here", place), label("this pair", declared.span)];
    let unplaced = |p: &&Pair| match &p.kind {
        PairKind::Transmission(t) => t.meeting.is_none(),
        _ => false,
    };
    if let Some(law) = mechanism.pairs.iter().find(unplaced)
        && law.span != declared.span
    {
        labels.push(label("the position of its force is not given", law.span));
    }
    let mesh = meets_somewhere(mechanism);
    let help = if mesh {
        "place the axes, `wheel w1 … at O1` with a point of the ground or the carrier, and give \
         the mesh a `pressure_angle`; the torques are known without them: `moment(k, I)`"
    } else {
        "ask for torques, as in `moment(b, I)`: only the forces of meshes have known positions"
    };
    Diagnosis::error(
        "mech::train::no_place",
        format!(
            "the reaction in `{}` cannot be found: its position, or that of a force \
             on its shaft, is not given",
            declared.name
        ),
    )
    .labels(labels)
    .help(help.to_owned())
}

/// Whether a mesh has no known pitch point.
fn meets_somewhere(mechanism: &Mechanism) -> bool {
    mechanism.pairs.iter().any(|p| match &p.kind {
        PairKind::Transmission(t) => t.kind == TransmissionKind::Mesh && t.meeting.is_none(),
        _ => false,
    })
}

/// Friction on which forces press that have no place.
pub(super) fn friction_without_place(mechanism: &Mechanism, pairs: &[PairId]) -> Diagnosis {
    let mut labels: Vec<_> = pairs.iter().map(|p| label("rubs", mechanism.pair(*p).span)).collect();
    let unplaced = mechanism.pairs.iter().filter(|p| match &p.kind {
        PairKind::Transmission(t) => t.meeting.is_none(),
        _ => false,
    });
    labels.extend(unplaced.map(|p| label("the position of its force is not given", p.span)));
    let names: Vec<String> = pairs.iter().map(|id| format!("`{}`", mechanism.pair(*id).name)).collect();
    let help = if meets_somewhere(mechanism) {
        "place the axes, `wheel w1 … at O1` with a point of the ground or the carrier, and give the mesh a `pressure_angle`"
    } else {
        "leave the friction of these pairs out, and give the transmission an `efficiency`: only the forces of meshes have known \
         positions"
    };
    Diagnosis::error(
        "mech::train::no_place",
        format!(
            "the friction in {} cannot be found: the position of a force that presses \
             there is not given",
            names.join(", ")
        ),
    )
    .labels(labels)
    .help(help.to_owned())
}
