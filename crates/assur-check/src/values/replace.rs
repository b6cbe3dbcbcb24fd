//! Values from outside in place of those of the file.

use crate::names::{
    declared::{Names, QuantityKind},
    suggestion::suggestion,
};
use crate::output::problems::Problems;
use crate::values::{
    store::{Overrides, Values},
    typed::{Dim, Type, Typed, phrase},
};
use assur_model::model::Expr;
use assur_syntax::{between_digits, readings};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use assur_text::units::{Dimension, Unit, lookup, significant};

/// Reports values for what is no `given`.
pub fn unknown_names(names: &Names<'_>, overrides: &Overrides, problems: &mut Problems) {
    for (name, _) in &overrides.values {
        match names.quantities.get(name).map(|d| (d.what, d.span)) {
            Some((QuantityKind::Given(_), _)) => {}
            Some((kind, span)) => {
                let is = kind.phrase();
                let why = format!("`{name}` is {is}, but only a `given` can be set");
                let help = matches!(kind, QuantityKind::Let(_))
                    .then(|| format!("write `given {name} = …` in the file instead of `let {name} = …`"));
                problems.error(
                    Diagnosis::error("mech::request::set_unknown", format!("`--set {name}=…`: {why}"))
                        .label(span, "declared here")
                        .help_if(help),
                );
            }
            None => unknown(names, problems, name),
        }
    }
}

fn unknown(names: &Names<'_>, problems: &mut Problems, name: &str) {
    if names.bad.contains(name) {
        return;
    }
    let given = names.quantities.iter().filter(|(_, d)| matches!(d.what, QuantityKind::Given(_)));
    let given = given.map(|(n, _)| n.as_str()).collect::<Vec<_>>();
    // it is of the command line, and has no place in the text
    let help = suggestion(name, Span::default(), &given, "`given` of this file").map(|help| help.to_string());
    let why = "the file has no `given` of that name".to_owned();
    problems.error(
        Diagnosis::error("mech::request::set_unknown", format!("`--set {name}=…`: {why}")).help_if(help),
    );
}

/// The value of a definition: that from outside where there is one, otherwise that of the file.
pub fn replaced(
    names: &Names<'_>,
    values: &Values<'_>,
    problems: &mut Problems,
    name: &str,
    written: Typed,
) -> Option<Typed> {
    if let Some((_, value)) = values.outside.fixed.filter(|(fixed, _)| *fixed == name) {
        return Some(Typed { expr: Expr::number(value), ..written });
    }
    let Some((_, text)) = values.outside.overrides.values.iter().rev().find(|(n, _)| n == name) else {
        return match values.outside.row.find(name) {
            Some((column, cell)) => Some(Typed::constant(cell.value, column.dimension)),
            None => Some(written),
        };
    };
    let declared = names.quantities.get(name).filter(|d| matches!(d.what, QuantityKind::Given(_)));
    let Some(declared) = declared.map(|d| d.span) else { return Some(written) };
    match value(name, text, written.ty, &values.usual_unit(written.ty.dimension())) {
        Ok(t) => Some(t),
        Err((why, help)) => {
            let (name, text) = (name.to_owned(), text.clone());
            problems.error(
                Diagnosis::error("mech::request::set_value", format!("`--set {name}={text}`: {why}"))
                    .label(declared, "the value it would replace")
                    .help_if(help),
            );
            None
        }
    }
}

type Why = (String, Option<String>);

/// Reads `120mm`, `-30 deg`, `0.1`.
pub fn value(name: &str, text: &str, ty: Type, usual: &str) -> Result<Typed, Why> {
    let Type::Number(want) = ty else {
        return Err((format!("it is {} in the file, but only numbers can be set", ty.shape()), None));
    };
    let write = |values: &[String]| {
        let line = |value: &String| format!("`--set {name}={}`", value.replacen(' ', "", 1));
        Some(format!("write {}", values.iter().map(line).collect::<Vec<_>>().join(" or ")))
    };
    let example = || Some(format!("write a value as in `--set {name}=120{usual}`"));
    let text = text.trim().replace('−', "-");
    let commas = between_digits(&text);
    if !commas.is_empty() {
        let readings = readings(&text, &commas);
        let why = if readings.len() > 1 { THOUSANDS } else { "use a decimal point, not a comma" };
        return Err((why.into(), write(&readings)));
    }
    let (number, word) = split(&text);
    let Ok(x) = number.parse::<f64>() else {
        return Err(("this is not a number with a unit".into(), example()));
    };
    if !x.is_finite() {
        return Err(("this is not a number".into(), None));
    }
    if word.is_empty() {
        let plain = want.unify(Dim::Of(Dimension::NUMBER)).is_some();
        if plain || x == 0.0 {
            return Ok(Typed::constant(x, if plain { Dimension::NUMBER } else { want.known() }));
        }
        let why = format!("it is {}, which needs a unit", phrase(want.known()));
        return Err((why, write(&[format!("{number} {usual}")])));
    }
    let unit = lookup(word).map_err(|error| {
        let fits = |unit: &&String| lookup(unit).is_ok_and(|u| want.unify(Dim::Of(u.dimension)).is_some());
        let units = error.nearest().iter().filter(fits);
        let units = units.map(|unit| format!("{number} {unit}")).collect::<Vec<_>>();
        (error.to_string(), if units.is_empty() { example() } else { write(&units) })
    })?;
    let Some(dim) = want.unify(Dim::Of(unit.dimension)) else {
        let found = phrase(unit.dimension);
        let why = format!("it is {} in the file, but this is {found}", phrase(want.known()));
        let rate = unit.dimension == Dimension::FREQUENCY && want.known() == Dimension::ANGULAR_VELOCITY;
        let turns = rate.then(|| revolutions_or_radians(number, &unit));
        return Err((why, turns.map_or_else(example, |values| write(&values))));
    };
    Ok(Typed::constant(unit.to_si(x), dim.known()))
}

/// Why a number with a comma is asked about.
const THOUSANDS: &str = "a comma in a number may be a decimal point or separate thousands";

/// The longest beginning that is a number, and the rest.
fn split(text: &str) -> (&str, &str) {
    let ends = text.char_indices().map(|(i, c)| i + c.len_utf8()).rev();
    let is_number = |end: &usize| {
        let start = &text[..*end];
        start.ends_with(|c: char| c.is_ascii_digit()) && start.parse::<f64>().is_ok()
    };
    let end = ends.into_iter().find(is_number).unwrap_or(0);
    (&text[..end], text[end..].trim())
}

// A rate whose angle is not said: revolutions or radians.

/// A number per time in revolutions, and in radians per second.
pub fn revolutions_or_radians(number: &str, unit: &Unit) -> [String; 2] {
    let turns = match unit.text.as_str() {
        "Hz" => "rev/s",
        _ if unit.factor < PER_MINUTE / 2.0 => "rev/h",
        _ => "rpm",
    };
    let radians = significant(unit.to_si(number.parse().unwrap_or(f64::NAN)), 12);
    [format!("{number} {turns}"), format!("{radians} rad/s")]
}

/// One per minute in one per second.
const PER_MINUTE: f64 = 1.0 / 60.0;
