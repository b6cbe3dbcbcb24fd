//! What is asked for that cannot be answered at any position.

use super::error::{SolveError, label};
use super::format::{four, short};
use crate::answer::every_query;
use crate::position::Model;
use miette::LabeledSpan;

use crate::model::{Drive, DriveTarget, Expr, Mechanism, PairKind, Positions, Value};
use crate::plan::{Level, contact_in, is_follower};
use crate::source::Span;
use crate::structure::GroupKind;

/// Constructs that are understood and cannot be solved yet, each kind once.
pub(crate) fn not_supported(mechanism: &Mechanism) -> Vec<SolveError> {
    let mut kinds: Vec<(&str, Vec<LabeledSpan>)> = Vec::new();
    for unsupported in &mechanism.unsupported {
        let mark = label("not supported yet", unsupported.span);
        match kinds.iter_mut().find(|k| k.0 == unsupported.what) {
            Some((_, marks)) => marks.push(mark),
            None => kinds.push((&unsupported.what, vec![mark])),
        }
    }
    kinds
        .into_iter()
        .map(|(what, labels)| SolveError::NotSupportedYet { what: what.to_owned(), labels })
        .collect()
}

/// Contacts of designed cams that do not move their follower, or carry forces in a way that no step knows.
pub(crate) fn cams(model: &Model<'_>) -> Vec<SolveError> {
    let (mechanism, structure) = (model.mechanism, model.structure);
    let mut found = Vec::new();
    let mut refuse = |pair: crate::model::PairId, what: &str| {
        let mark = label("not supported yet", mechanism.pair(pair).span);
        found.push(SolveError::NotSupportedYet { what: what.to_owned(), labels: vec![mark] });
    };
    for group in &structure.motion {
        if let Some((block, _, contact)) = contact_in(mechanism, structure, group)
            && !is_follower(group, block, contact)
        {
            refuse(contact.pair, "a cam that does not move the follower by itself");
            return found;
        }
    }
    for group in structure.forces.iter().filter(|_| model.plan.effects.forces) {
        let Some((_, _, contact)) = contact_in(mechanism, structure, group) else { continue };
        let with_disk = group.bodies.iter().any(|b| b.0 == contact.disk.index());
        let general = !matches!(group.kind, GroupKind::Dyad(_));
        if general || with_disk && contact.face.is_some() {
            refuse(contact.pair, "forces that go through the contact of a cam in this way");
        }
    }
    found
}

/// Velocities and accelerations of a mechanism whose drives have no speed.
pub(crate) fn missing_speeds(model: &Model<'_>) -> Option<SolveError> {
    let (mechanism, effects) = (model.mechanism, model.plan.effects);
    let allowed = match (effects.moving, effects.timed) {
        (_, true) => return None,
        (true, false) => Level::Velocities,
        (false, false) => Level::Positions,
    };
    let drive = mechanism.drives.first()?;
    let mut needed = allowed;
    let mut places: Vec<Span> = Vec::new();
    let mut ask = |level: Level, span: Span| {
        if level > allowed {
            needed = needed.max(level);
            places.push(span);
        }
    };
    every_query(mechanism, &mut |query, span| ask(query.facts().level, span));
    for load in mechanism.loads.iter().filter(|_| effects.forces) {
        if load.is_against_motion() {
            ask(Level::Velocities, load.span);
        }
    }
    places.dedup();
    if places.is_empty() {
        return None;
    }
    let (written, speed) = written(mechanism, drive);
    let name = &drive.name;
    let (what, needs, help) = if needed == Level::Velocities {
        let sense = match drive.target {
            _ if speed.ends_with(')') => String::new(),
            _ if speed.ends_with("rpm") => {
                format!("; for velocities as ratios a sense is enough: `drive {name}{written} turning ccw`")
            }
            _ => format!(
                "; for velocities as ratios a sense is enough: `drive {name}{written} moving forward`"
            ),
        };
        ("a velocity", "a speed or a sense", format!("write `drive {name}{written} at {speed}`{sense}"))
    } else {
        ("an acceleration", "a speed", format!("write `drive {name}{written} at {speed}`"))
    };
    let mut labels: Vec<LabeledSpan> =
        places.into_iter().filter(|s| *s != Span::default()).map(|s| label("needed here", s)).collect();
    labels.push(label(format!("without {needs}"), drive.span));
    Some(SolveError::NeedsSpeed { what, needs, help, labels })
}

/// Dampers and loads that depend on speeds, while no drive has one: what is to be said of them.
pub(crate) fn unit_speeds(model: &Model<'_>) -> Option<SolveError> {
    let (mechanism, effects) = (model.mechanism, model.plan.effects);
    let drive = mechanism.drives.first().filter(|_| effects.forces && !effects.timed)?;
    let (written, speed) = written(mechanism, drive);
    let help = format!("give it a speed: `drive {}{written} at {speed}`", drive.name);
    let dampers = mechanism.springs.iter().filter(|s| s.damping > 0.0);
    let dampers = dampers.map(|s| (format!("`{}`", s.name), s.span));
    if !effects.moving {
        let labels: Vec<LabeledSpan> =
            dampers.map(|(_, span)| label("against which motion?", span)).collect();
        return (!labels.is_empty()).then_some(SolveError::NoDamping { help, labels });
    }
    let fast = mechanism.loads.iter().filter(|load| takes_speeds(mechanism, load.value()));
    let named = |name: &Option<String>| name.as_ref().map_or("a load".to_owned(), |n| format!("`{n}`"));
    let all: Vec<(String, Span)> = dampers.chain(fast.map(|l| (named(&l.name), l.span))).collect();
    let (_, first) = all.first()?;
    let names: Vec<&str> = all.iter().map(|(name, _)| name.as_str()).collect();
    let mut labels = vec![label("takes speeds", *first)];
    labels.extend(all.iter().skip(1).map(|(_, span)| label("and this", *span)));
    labels.push(label("a sense alone", drive.span));
    let unit = if speed.ends_with("rpm") { "1 rad/s" } else { "1 m/s" };
    Some(SolveError::UnitSpeed {
        what: names.join(" and "),
        hangs: if names.len() == 1 { "hangs" } else { "hang" },
        unit: format!("{unit} of `{}`", drive.name),
        help,
        labels,
    })
}

/// Whether a value depends on speeds, through quantities of the file too.
fn takes_speeds(mechanism: &Mechanism, value: &Expr) -> bool {
    let mut found = false;
    value.parts(&mut |part| {
        found |= match part {
            Expr::Quantity(id) => {
                mechanism.quantities.get(id.index()).is_some_and(|q| takes_speeds(mechanism, &q.expr))
            }
            Expr::Query(query) => query.facts().level > Level::Positions,
            _ => false,
        };
    });
    found
}

/// The positions of a drive as they may have been written, and a speed for it.
fn written(mechanism: &Mechanism, drive: &Drive) -> (String, &'static str) {
    let (turns, speed) = match drive.target {
        DriveTarget::Link(_) => (true, "60 rpm"),
        DriveTarget::Pair(pair) if matches!(mechanism.pair(pair).kind, PairKind::Revolute(_)) => {
            (true, "60 rpm")
        }
        DriveTarget::Pair(_) => (false, "0.1 m/s"),
        DriveTarget::Point(..) => (false, "(0.1 m/s, 0)"),
    };
    if let Some(text) = &drive.written {
        return (format!(" = {text}"), speed);
    }
    let value = |e: &Expr| match e {
        Expr::Constant(Value::Scalar(x)) if turns => Some(format!("{} deg", short(x.to_degrees()))),
        Expr::Constant(Value::Scalar(x)) => Some(format!("{} mm", four(x * 1e3))),
        _ => None,
    };
    let text = match &drive.positions {
        Positions::List(list) => {
            list.iter().map(value).collect::<Option<Vec<_>>>().map(|values| values.join(", "))
        }
        Positions::Range { from, to, steps } => {
            value(from).zip(value(to)).map(|(from, to)| format!("{from} .. {to} in {steps} steps"))
        }
        Positions::None => None,
    };
    (format!(" = {}", text.unwrap_or_else(|| "…".to_owned())), speed)
}
