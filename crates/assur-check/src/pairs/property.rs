//! Properties of pairs.

use crate::expr::context::Context;
use crate::expr::property::{Read, Value, find, read};
use crate::statements::written::braces;
use assur_syntax::document::{Joint, JointKind, Property, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;

use assur_text::language::properties_of_pair;

/// The three ways to say how much friction there is.
pub(crate) const AMOUNTS: [&str; 3] = ["friction", "friction_circle", "equivalent_friction"];

/// The properties in the braces of a pair of the linkage. `None` where one is wrong.
pub(crate) fn read_own(cx: &mut Context<'_>, joint: &Joint) -> Option<Vec<Read>> {
    read(cx, &phrase(joint.kind.node), &joint.properties, properties_of_pair(joint.kind.node))
}

/// The properties of a pair, those from `all` included. `None` where they do not go together.
pub(crate) fn with_shared(
    cx: &mut Context<'_>,
    joint: &Joint,
    mut all: Vec<Read>,
    shared: &Shared,
) -> Option<Vec<Read>> {
    let kind = joint.kind.node;
    let own = all.len();
    let says_friction = all.iter().any(|p| AMOUNTS.contains(&p.name));
    for shared in shared.iter().filter(|s| s.0 == kind).flat_map(|s| &s.1) {
        let overruled = says_friction && AMOUNTS.contains(&shared.name);
        if !overruled && find(&all, shared.name).is_none() {
            all.push(shared.clone());
        }
    }
    // what `all` says beside a coefficient means nothing to a pair that has none
    if find(&all, "friction").is_none() {
        let beside = |p: &Read| matches!(p.name, "fit" | "groove" | "static_friction");
        let kept = all.drain(..).enumerate().filter(|(i, p)| *i < own || !beside(p));
        all = kept.map(|(_, p)| p).collect();
    }
    complete(cx, kind, joint, &all, own)?;
    Some(all)
}

/// A pair with its article.
pub(crate) fn phrase(kind: JointKind) -> String {
    match kind {
        JointKind::Revolute => "a revolute pair".into(),
        JointKind::Prismatic => "a prismatic pair".into(),
        kind => format!("a {}", kind.word()),
    }
}

/// Reports a property that needs another one, or contradicts another one.
/// The first `own` properties are those of the pair, the others those of `all` statements.
fn complete(cx: &mut Context<'_>, kind: JointKind, joint: &Joint, all: &[Read], own: usize) -> Option<()> {
    let said = all.iter().filter(|p| AMOUNTS.contains(&p.name)).collect::<Vec<_>>();
    let needs = |name: &'static str, other: &'static str, missing: &'static [&'static str]| {
        let property = find(all, name).filter(|_| find(all, other).is_none())?;
        Some((format!("`{name}` has no effect without `{other}`"), missing, property))
    };
    let missing = match kind {
        JointKind::Revolute => needs("friction", "radius", &["radius 20 mm"])
            .or_else(|| needs("equivalent_friction", "radius", &["radius 20 mm"]))
            .or_else(|| {
                let missing: &[_] = if find(all, "radius").is_some() {
                    &["friction 0.1"]
                } else {
                    &["radius 20 mm", "friction 0.1"]
                };
                needs("fit", "friction", missing)
            }),
        JointKind::Prismatic => needs("groove", "friction", &["friction 0.12"]).or_else(|| {
            let round = find(all, "groove").is_some_and(|g| g.value == Value::Word("round"));
            let missing: &[_] = if find(all, "friction").is_some() {
                &["groove round"]
            } else {
                &["friction 0.12", "groove round"]
            };
            if round { None } else { needs("fit", "groove", missing) }
        }),
        _ => None,
    };
    let missing = missing.or_else(|| needs("static_friction", "friction", &["friction 0.1"]));
    let problem = match (&said[..], missing) {
        ([_, second, ..], _) => Some((
            format!("`{}` and `{}` both give the friction", said[0].name, second.name),
            &[][..],
            *second,
        )),
        (_, missing) => missing,
    };
    let Some((message, missing, property)) = problem else { return Some(()) };
    let of_all = all.iter().position(|p| p.span == property.span).is_some_and(|i| i >= own);
    if of_all && !cx.problems.reported.insert(("property of all", property.span.start.to_string())) {
        return None;
    }
    let help = if missing.is_empty() {
        "keep one of them".into()
    } else if of_all {
        let more = braces(properties_of_all(cx, property.span), missing);
        format!("write `all {}{more}`, with its own value", kind.word())
    } else {
        let more = braces(&joint.properties, missing);
        format!("write `{}`, with its own value", more.trim())
    };
    let label = if of_all {
        "applies to all pairs of this kind".into()
    } else {
        format!("in pair `{}`", joint.name.node)
    };
    cx.error(Diagnosis::error("mech::geometry::incomplete", message).label(property.span, label).help(help));
    None
}

/// The properties of the `all` statement with one of them at this place.
fn properties_of_all<'a>(cx: &Context<'a>, span: Span) -> &'a [Property] {
    let all = cx.doc.statements.iter().filter_map(|s| match &s.node {
        Statement::All(all) => Some(&all.properties[..]),
        _ => None,
    });
    all.into_iter().find(|p| p.iter().any(|p| p.span == span)).unwrap_or_default()
}

/// What `all` statements say of each kind of joint.
pub(crate) type Shared = Vec<(JointKind, Vec<Read>)>;

/// Reads the `all` statements.
pub(crate) fn shared(cx: &mut Context<'_>) -> Shared {
    let mut shared = Shared::new();
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::All(all) = &statement.node {
            let kind = all.kind.node;
            if let Some(properties) = read(cx, &phrase(kind), &all.properties, properties_of_pair(kind)) {
                shared.push((kind, properties));
            }
        }
    }
    shared
}
