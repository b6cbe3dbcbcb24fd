//! Properties in the braces of pairs, springs and machine elements.

use crate::expr::{
    context::Context,
    positive::{Want, not_negative, positive},
};
use crate::names::suggestion::suggestion;
use crate::statements::written::written;
use assur_syntax::document::{Definition, Expr, ExprKind, Property, Statement};
use assur_text::diagnostic::{Diagnosis, Help};
use assur_text::source::Span;

use assur_text::language::PROPERTIES;
pub(crate) use assur_text::language::{Property as Spec, PropertyValue as Takes};
use assur_text::units::Dimension;

/// Other usual words and symbols for properties.
const USUAL: &[(&str, &str)] = &[
    ("mu", "friction"),
    ("µ", "friction"),
    ("μ", "friction"),
    ("f", "friction"),
    ("coefficient", "friction"),
    ("friction_coefficient", "friction"),
    ("mu0", "static_friction"),
    ("friction_static", "static_friction"),
    ("turns", "turning"),
    ("sense", "turning"),
    ("max_torque", "capacity"),
    ("k", "stiffness"),
    ("c", "stiffness"),
    ("rate", "stiffness"),
    ("spring_rate", "stiffness"),
    ("constant", "stiffness"),
    ("b", "damping"),
    ("damper", "damping"),
    ("rest_length", "free_length"),
    ("natural_length", "free_length"),
    ("unstretched", "free_length"),
    ("l0", "free_length"),
    ("length", "free_length"),
    ("rest_angle", "free_angle"),
    ("eta", "efficiency"),
    ("η", "efficiency"),
    ("pitch", "lead"),
    ("inner", "internal"),
    ("inside", "internal"),
    ("intern", "internal"),
    ("ring", "internal"),
    ("alpha", "pressure_angle"),
    ("α", "pressure_angle"),
    ("r", "radius"),
    ("R", "radius"),
    ("e", "restitution"),
    ("bounce", "restitution"),
    ("delta", "fluctuation"),
    ("δ", "fluctuation"),
    ("irregularity", "fluctuation"),
    ("rho", "density"),
    ("ρ", "density"),
    ("contact_angle", "wrap"),
    ("wrap_angle", "wrap"),
    ("axis_distance", "centre_distance"),
    ("center_distance", "centre_distance"),
    ("distance", "centre_distance"),
    ("preload", "pretension"),
    ("tension", "pretension"),
    ("torque", "capacity"),
    ("max_torque", "capacity"),
    ("force", "load"),
    ("pull", "load"),
    ("base_circle", "base_radius"),
    ("eccentricity", "offset"),
    ("cross", "crossed"),
    ("threads", "starts"),
    ("stages", "starts"),
    ("x", "shift"),
    ("slots_number", "slots"),
    ("position", "plane"),
    ("free_length", "free_angle"),
    ("free_angle", "free_length"),
];

/// Properties of textbooks that another one follows from: of the value, and the words for it.
const CONVERTED: &[(&str, &str, Convert)] = &[
    ("friction_angle", "friction", |value| format!("tan({value})")),
    ("diameter", "radius", |value| format!("{value}/2")),
    ("outer_diameter", "outer", |value| format!("{value}/2")),
    ("inner_diameter", "inner", |value| format!("{value}/2")),
    ("loss", "efficiency", |value| format!("1 - {value}")),
    ("losses", "efficiency", |value| format!("1 - {value}")),
];

type Convert = fn(&str) -> String;

/// The property that others write in other words, with its value.
fn converted(property: &Property, known: &[&str]) -> Option<Help> {
    let name = property.name.node.as_str();
    let (_, ours, convert) =
        CONVERTED.iter().find(|(other, ours, _)| *other == name && known.contains(ours))?;
    let value = written(property.values.first()?)?;
    let line = format!("{ours} {}", convert(&value));
    Some(Help::write(property.span, &[line]))
}

/// What is said in another place of the language, or not at all.
fn elsewhere(cx: &Context<'_>, what: &str, property: &Property, properties: &[Property]) -> Option<String> {
    let value = property.values.first().and_then(written);
    Some(match property.name.node.as_str() {
        "preload" | "pretension" | "initial_force" if what == "a spring" => {
            let stiffness = properties.iter().find(|p| p.name.node == "stiffness")?;
            let stiffness = written(stiffness.values.first()?)?;
            format!(
                "write `free_length`: the length of the spring under this force, plus {0}/({stiffness}) if it is \
                 pressed, minus {0}/({stiffness}) if it is pulled",
                value?
            )
        }
        "stiffness" | "damping" if what.ends_with("pair") => {
            "write a spring or damper as a statement, as in `spring k in B { stiffness 2 N*m }`, with the name of the \
             pair"
                .into()
        }
        "backlash" | "play" => "pairs and gears have no play: leave it out".into(),
        "external" | "outer" if what == "a mesh" => "leave it out: wheels mesh from outside without `internal`".into(),
        "mass" | "inertia" if cx.names.things.is_empty() => return None,
        _ => return None,
    })
}

/// A property that is as it should be.
#[derive(Clone, Debug)]
pub(crate) struct Read {
    pub name: &'static str,
    /// Its value in SI.
    pub value: Value,
    pub span: Span,
}

/// The value of a property, in SI.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Value {
    /// None, or a block of its own.
    Flag,
    Number(f64),
    Two([f64; 2]),
    Word(&'static str),
}

impl Read {
    /// The number, zero where it has none.
    pub(crate) fn number(&self) -> f64 {
        if let Value::Number(x) = self.value { x } else { 0.0 }
    }
}

/// The property of that name.
pub(crate) fn find<'a>(list: &'a [Read], name: &str) -> Option<&'a Read> {
    debug_assert!(PROPERTIES.iter().any(|(_, all)| all.iter().any(|p| p.name == name)), "{name}");
    list.iter().find(|p| p.name == name)
}

/// Reads the properties of a statement; `what` is what they stand in, with its article. Reports those that are unknown,
/// repeated or wrong. `None` where any of them is.
pub(crate) fn read(
    cx: &mut Context<'_>,
    what: &str,
    properties: &[Property],
    specs: &[Spec],
) -> Option<Vec<Read>> {
    read_beside(cx, what, properties, specs, &[])
}

/// The same where other words may stand beside the properties: one of them may have been meant.
pub(crate) fn read_beside(
    cx: &mut Context<'_>,
    what: &str,
    properties: &[Property],
    specs: &[Spec],
    others: &[&str],
) -> Option<Vec<Read>> {
    let mut all = Some(Vec::<Read>::new());
    for (i, property) in properties.iter().enumerate() {
        if property.name.node.is_empty() {
            // it could not be read, which is reported
            all = None;
            continue;
        }
        if let Some(first) = properties[..i].iter().find(|p| p.name.node == property.name.node) {
            let what = format!("`{}`", property.name.node);
            cx.error(given_twice(&what, property.span, first.span));
            all = None;
            continue;
        }
        let one = one(cx, what, (property, properties), specs, others);
        all = all.zip(one).map(|(mut all, one)| {
            all.push(one);
            all
        });
    }
    all
}

fn one(
    cx: &mut Context<'_>,
    what: &str,
    (property, properties): (&Property, &[Property]),
    specs: &[Spec],
    others: &[&str],
) -> Option<Read> {
    let name = &property.name.node;
    let Some(spec) = specs.iter().find(|s| s.name == name.as_str()) else {
        let known = specs.iter().map(|s| s.name).chain(others.iter().copied()).collect::<Vec<_>>();
        let usual = USUAL.iter().find(|(other, ours)| *other == name.as_str() && known.contains(ours));
        // what `all` says is read for every kind of pair
        if !cx.problems.reported.insert(("property", property.name.span.start.to_string())) {
            return None;
        }
        let said = elsewhere(cx, what, property, properties).map(Help::from);
        let help = said.or_else(|| converted(property, &known));
        let help = help
            .or_else(|| {
                usual.map(|(_, ours)| Help::did_you_mean(name, property.name.span, &[(*ours).to_owned()]))
            })
            .or_else(|| suggestion(name, property.name.span, &known, "properties"))
            .unwrap_or_else(|| format!("leave the braces out: {what} has no properties").into());
        let (what, name, span) = (what.to_owned(), name.clone(), property.name.span);
        cx.error(
            Diagnosis::error("mech::geometry::unknown_property", format!("{what} has no property `{name}`"))
                .label(span, "not known here")
                .help(help),
        );
        return None;
    };
    let is_block = matches!(spec.takes, Takes::Block(_));
    if !property.properties.is_empty() && !is_block {
        return wrong(cx, property, spec, "a value", "properties in braces");
    }
    let phrase = format!("`{name}`");
    let value = match (spec.takes, property.values.as_slice()) {
        (Takes::Flag | Takes::FlagOr(_), []) => Value::Flag,
        (Takes::FlagOr(words), values) => match values {
            [x] if word(x, words).is_some() => Value::Word(word(x, words)?),
            _ => return wrong(cx, property, spec, &spec.takes.to_string(), &count(values)),
        },
        (Takes::Flag, _) => return wrong(cx, property, spec, "no value", "a value"),
        (Takes::Any(d), [x]) => Value::Number(cx.scalar_constant(x, &Want(d), &phrase)?),
        (Takes::Positive(d), [x]) => Value::Number(positive(cx, x, d, &phrase)?),
        (Takes::NotNegative(d), [x]) => Value::Number(not_negative(cx, x, d, &phrase)?),
        (Takes::Word(words, d), [x]) => match word(x, words) {
            Some(word) => Value::Word(word),
            None if is_unknown_word(cx, x) => {
                let list = words.iter().map(|w| format!("`{w}`")).collect::<Vec<_>>().join(", ");
                return wrong(cx, property, spec, &format!("{list} or a value"), "another word");
            }
            None => Value::Number(positive(cx, x, d, &phrase)?),
        },
        (Takes::Two(d), [a, b]) => {
            let a = cx.scalar_constant(a, &Want(d), &phrase);
            let b = cx.scalar_constant(b, &Want(d), &phrase);
            Value::Two([a?, b?])
        }
        (Takes::Two(_), [only]) if written(only).is_some() => {
            let value = written(only)?;
            let second = match spec.name {
                "contacts" => vec![format!("-{value}, {value}")],
                _ => vec![format!("{value}, 0"), format!("{value}, -{value}")],
            };
            let lines = second.iter().map(|two| format!("{name} {two}")).collect::<Vec<_>>();
            cx.error(
                Diagnosis::error("mech::geometry::property_value", format!("`{name}` takes two values"))
                    .label(property.span, "one value")
                    .help(Help::write(property.span, &lines)),
            );
            return None;
        }
        (Takes::Two(_), values) => {
            return wrong(cx, property, spec, "two values", &count(values));
        }
        (Takes::Block(specs), []) => {
            read(cx, &phrase, &property.properties, specs)?;
            Value::Flag
        }
        (_, values) => return wrong(cx, property, spec, "one value", &count(values)),
    };
    Some(Read { name: spec.name, value, span: property.span })
}

fn count(values: &[Expr]) -> String {
    match values.len() {
        0 => "no value".into(),
        1 => "one value".into(),
        n => format!("{n} values"),
    }
}

fn wrong<T>(cx: &mut Context<'_>, property: &Property, spec: &Spec, wants: &str, got: &str) -> Option<T> {
    cx.error(
        Diagnosis::error("mech::geometry::property_value", format!("`{}` takes {wants}", property.name.node))
            .label(property.span, got)
            .help(format!("write `{}`", spec.example))
            .quoted(property.span),
    );
    None
}

/// The word that stands alone as a value.
fn word(expr: &Expr, words: &[&'static str]) -> Option<&'static str> {
    let ExprKind::Name(name) = &expr.kind else { return None };
    words.iter().copied().find(|w| *w == name.as_str())
}

/// A word that is no quantity of the file either.
fn is_unknown_word(cx: &Context<'_>, expr: &Expr) -> bool {
    matches!(&expr.kind, ExprKind::Name(name)
        if name != "pi" && !cx.names.quantities.contains_key(name) && !cx.names.bad.contains(name))
}

impl Context<'_> {
    /// The name of the only `given` of a dimension.
    pub(crate) fn only_given(&mut self, dimension: Dimension) -> Option<String> {
        let doc = self.doc;
        let fits = self.quietly(|cx| {
            let givens = doc.statements.iter().filter_map(|s| match &s.node {
                Statement::Given(given) => Some(given),
                _ => None,
            });
            let mut fits = |d: &&Definition| cx.scalar_constant(&d.value, &Want(dimension), "").is_some();
            givens.filter(&mut fits).map(|d| d.name.node.clone()).collect::<Vec<_>>()
        });
        if let [only] = &fits[..] { Some(only.clone()) } else { None }
    }
}

/// Something that can be given once is given again.
pub fn given_twice(what: &str, again: Span, first: Span) -> Diagnosis {
    Diagnosis::error("mech::geometry::stated_twice", format!("{what} is given twice"))
        .primary(again, "given again here")
        .label(first, "first given here")
        .help("keep one of the two")
        .left_out("the second one", again)
}
