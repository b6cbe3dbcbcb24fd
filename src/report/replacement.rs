//! Lower pairs in place of higher ones, as `check` shows them.

use super::document::{Report, Section, Table};
use super::pair::{pair_text, profile_text};
use assur_model::model::{LinkId, PairKind, Profile, ProfileShape};
use assur_solve::solve::Model;
use assur_text::units::Dimension;

/// One row per higher pair.
pub(super) fn section(model: &Model<'_>, report: &mut Report) {
    let mut table = Table::of_words(&["pair", "joins", "replaced by"]);
    for pair in &model.mechanism.pairs {
        let by = match &pair.kind {
            PairKind::Slot(g) => format!(
                "an imaginary block hinged on `{}` that slides along `{}`",
                point(model, g.slider, &g.point_name),
                point(model, g.guide, &g.line_name)
            ),
            PairKind::Contact { first, second, internal } => contact(model, first, second, *internal),
            PairKind::Revolute(_)
            | PairKind::Prismatic(_)
            | PairKind::Cylinder { .. }
            | PairKind::Transmission(_) => continue,
        };
        table.row(vec![pair.name.clone(), pair_text(model.mechanism, &pair.kind), by]);
    }
    let mut section = Section::new("Equivalent linkages of higher pairs");
    section.table(table);
    report.section(section);
}

fn point(model: &Model<'_>, link: LinkId, name: &str) -> String {
    format!("{}.{name}", model.mechanism.link(link).name)
}

fn contact(model: &Model<'_>, first: &Profile, second: &Profile, internal: bool) -> String {
    let length = |x: f64| {
        let display = model.mechanism.display_of(Dimension::LENGTH);
        display.text(assur_model::model::Value::Scalar(x), 6)
    };
    let radius = |p: &Profile| match p.shape {
        ProfileShape::Point(_) => Some(0.0),
        ProfileShape::Circle(_, r) => Some(r),
        ProfileShape::Line(..) | ProfileShape::Rim(_) => None,
    };
    let block = |round: &Profile, line: &Profile, r: f64| {
        let (round, line) = (profile_text(model.mechanism, round), profile_text(model.mechanism, line));
        let away = if r > 0.0 { format!(" at a distance of {}", length(r)) } else { String::new() };
        let centre = if r > 0.0 { "in the centre of" } else { "on" };
        format!("an imaginary block hinged {centre} `{round}` that slides along `{line}`{away}")
    };
    let cam = |p: &Profile| matches!(p.shape, ProfileShape::Rim(_));
    let rubbed = if cam(first) { Some((first, second)) } else { cam(second).then_some((second, first)) };
    if let Some((cam, follower)) = rubbed {
        let (cam, tip) = (profile_text(model.mechanism, cam), profile_text(model.mechanism, follower));
        return match follower.shape {
            ProfileShape::Line(..) => {
                format!("an imaginary block hinged on `{cam}` at the contact point that slides along `{tip}`")
            }
            _ => format!("an imaginary block hinged on `{tip}` that slides along the tangent of `{cam}`"),
        };
    }
    match (radius(first), radius(second)) {
        (Some(a), Some(b)) => {
            let distance = if internal { (a - b).abs() } else { a + b };
            format!("an imaginary rod of {} between the centres", length(distance))
        }
        (Some(r), None) => block(first, second, r),
        (None, Some(r)) => block(second, first, r),
        (None, None) => "nothing: two lines".to_owned(),
    }
}
