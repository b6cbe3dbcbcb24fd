//! What an expression should be against what it is.

use crate::expr::{context::Context, number::with_unit};
use crate::names::declared::QuantityKind;
use crate::statements::{walk::parts, written::written};
use crate::values::{
    definition::Settled,
    replace::revolutions_or_radians,
    typed::{Dim, Type, Typed, correction, phrase},
};
use assur_syntax::document::{BinaryOp, Expr, ExprKind, Number};
use assur_text::diagnostic::{Diagnosis, Fix, Help};
use assur_text::language::Function;
use assur_text::source::Span;
use assur_text::units::{Dimension, lookup};

impl Context<'_> {
    /// The expression, if it is a number of this dimension.
    pub(crate) fn fit(&mut self, t: Typed, want: Dimension, what: &str, expr: &Expr) -> Option<Typed> {
        match t.ty {
            Type::Number(dim) => self.fits(dim, want, what, expr).then_some(t),
            Type::Vector(_) => {
                let help = Some("take a component, `.x` or `.y`, or `mag(…)`".to_owned());
                self.shape(what, "a number", t.ty, expr.span, help);
                None
            }
            Type::Bool => {
                self.shape(what, "a number", t.ty, expr.span, None);
                None
            }
        }
    }

    /// The expression, if it is a vector of this dimension.
    pub(crate) fn fit_vector(&mut self, t: Typed, want: Dimension, what: &str, expr: &Expr) -> Option<Typed> {
        match t.ty {
            Type::Vector(dim) => self.fits(dim, want, what, expr).then_some(t),
            Type::Number(Dim::Any) if t.pending => Some(t),
            ty => {
                let help = matches!(ty, Type::Number(_))
                    .then(|| "write `(x, y)`, or a magnitude and its direction: `… @ 90 deg`".to_owned());
                self.shape(what, "a vector", ty, expr.span, help);
                None
            }
        }
    }

    /// The expression, if it is a condition.
    pub(crate) fn fit_condition(&mut self, t: Typed, what: &str, expr: &Expr) -> Option<Typed> {
        if t.ty == Type::Bool || (t.pending && t.ty == Type::Number(Dim::Any)) {
            return Some(t);
        }
        let help = Some("compare it with something: `a < b`".to_owned());
        self.shape(what, "a condition", t.ty, expr.span, help);
        None
    }

    fn fits(&mut self, dim: Dim, want: Dimension, what: &str, expr: &Expr) -> bool {
        if dim.unify(Dim::Of(want)).is_some() {
            return true;
        }
        let (found, what, span) = (dim.known(), what.to_owned(), expr.span);
        if want == Dimension::ANGULAR_VELOCITY && found == Dimension::FREQUENCY {
            self.hertz(what, expr);
            return false;
        }
        if found == Dimension::NUMBER
            && let Some(help) = self.example(expr, want)
        {
            self.error(unit_missing(&what, want, span, None, help));
            return false;
        }
        if found == Dimension::NUMBER && self.bare_definition(want, expr) {
            return false;
        }
        let help = self
            .by_time(want, expr)
            .or_else(|| self.other_derivative(want, expr))
            .or_else(|| self.by_turn(want, found, expr))
            .or_else(|| self.column_without_unit(want, found, expr))
            .or_else(|| self.in_its_place(want, found, &what, expr));
        let mismatch = unit_mismatch(&what, &phrase(want), &phrase(found), span, help);
        let given = self.wrong_definition(expr);
        self.error(match given {
            Some(at) if !(at.start <= span.start && span.end <= at.end) => mismatch.label(at, "given here"),
            _ => mismatch,
        });
        false
    }

    /// Where a name that does not fit is defined. What does not fit because of it elsewhere is no second mistake.
    fn wrong_definition(&mut self, expr: &Expr) -> Option<Span> {
        let ExprKind::Name(name) = &expr.kind else { return None };
        let at = self.number_behind(name)?.value.span;
        self.values.definitions.settled.insert(name.clone(), Settled::Failed);
        Some(at)
    }

    /// `omega(rotor)` for `angle(rotor)`: the derivative that has the dimension.
    fn other_derivative(&mut self, want: Dimension, expr: &Expr) -> Option<String> {
        use Function::{
            Acceleration, Alpha, Angle, Displacement, Omega, Position, RelativeAcceleration,
            RelativeVelocity, Velocity,
        };
        const LADDERS: [&[Function]; 3] = [
            &[Angle, Omega, Alpha],
            &[Displacement, RelativeVelocity, RelativeAcceleration],
            &[Position, Velocity, Acceleration],
        ];
        let ExprKind::Call { function, args } = &expr.kind else { return None };
        let own = Function::named(&function.node)?;
        let ladder = LADDERS.into_iter().find(|ladder| ladder.contains(&own))?;
        ladder.iter().filter(|other| **other != own).find_map(|other| {
            let function = assur_text::source::Spanned::new(other.name().to_owned(), function.span);
            let new = Expr { kind: ExprKind::Call { function, args: args.clone() }, span: expr.span };
            let read = self.quietly(|cx| cx.read(&new))?;
            let fits = matches!(read.ty, Type::Number(dim) | Type::Vector(dim) if dim.unify(Dim::Of(want)).is_some());
            let text = written(&new).filter(|_| fits)?;
            Some(format!("write `{text}`"))
        })
    }

    /// `180 deg/6` for `pi/6`.
    fn by_turn(&self, want: Dimension, found: Dimension, expr: &Expr) -> Option<String> {
        let ExprKind::Chain(first, _) = &expr.kind else { return None };
        let is_pi = matches!(&first.kind, ExprKind::Name(name) if name == "pi")
            && !self.names.quantities.contains_key("pi");
        let angle = want == Dimension::ANGLE && found == Dimension::NUMBER && is_pi;
        let text = written(expr).filter(|_| angle)?.replacen("pi", "180 deg", 1);
        Some(format!("write `{text}`"))
    }

    /// The header of a curve in the expression whose values have no unit, with the one that is missing.
    fn column_without_unit(&self, want: Dimension, found: Dimension, expr: &Expr) -> Option<String> {
        let mut bare = None;
        parts(expr, &mut |part| {
            if let ExprKind::Call { function, .. } = &part.kind
                && let Some(curve) = self.values.curves.get(&function.node)
                && curve.value == Dimension::NUMBER
            {
                bare.get_or_insert_with(|| function.node.clone());
            }
        });
        let (name, missing) = (bare?, want.over(found));
        missing.name()?;
        let unit = self.values.usual_unit(missing);
        Some(format!(
            "the values of curve `{name}` have no unit: write it in its header, as in \
             `[{unit}]`"
        ))
    }

    /// Reports a vector where a number is due, and the like.
    pub(crate) fn shape(
        &mut self,
        what: &str,
        want: &'static str,
        ty: Type,
        span: Span,
        help: Option<String>,
    ) {
        let found = ty.shape();
        self.error(
            Diagnosis::error("mech::unit::shape", format!("{what} should be {want}, but this is {found}"))
                .primary(span, found)
                .help_if(help),
        );
    }

    /// What would make two quantities fit each other.
    pub(crate) fn correct_operands(&mut self, a: Type, b: Type, left: &Expr, right: &Expr) -> Option<String> {
        let (Type::Number(x), Type::Number(y)) = (a, b) else {
            return match (a, b) {
                (Type::Vector(_), Type::Number(_)) | (Type::Number(_), Type::Vector(_)) => {
                    Some("take a component, `.x` or `.y`, or `mag(…)` of the vector".into())
                }
                _ => None,
            };
        };
        let (x, y) = (x.known(), y.known());
        if let Some(help) = self.by_time(x, right).or_else(|| self.by_time(y, left)) {
            return Some(help);
        }
        let bare = |d: Dimension, expr: &Expr, other: Dimension| {
            let units = self.likely_units(other, expr);
            if d == Dimension::NUMBER { with_unit(expr, units.last()?) } else { None }
        };
        if let Some(text) = bare(y, right, x) {
            let part =
                part_of_stroke(left, right).map(|part| format!(", or `{part}` for a part of the stroke"));
            return Some(format!("write `{text}`{}", part.unwrap_or_default()));
        }
        if let Some(text) = bare(x, left, y) {
            return Some(format!("write `{text}` for the first operand"));
        }
        // `90 deg + 860*time`: the factor lacks the unit
        let factor = |d: Dimension, expr: &Expr, other: Dimension| {
            let want = other.over(d);
            let named = want.name()?;
            let turns = Some(named) == Dimension::ANGULAR_VELOCITY.name();
            let units = self.likely_units(if turns { Dimension::ANGULAR_VELOCITY } else { want }, expr);
            let ExprKind::Chain(first, _) = &expr.kind else { return None };
            let rest = written(expr)?.strip_prefix(written(first)?.as_str())?.to_owned();
            let factor = with_unit(first, units.first()?)?;
            let named = named.split_once(' ').map_or(named, |(_, noun)| noun);
            Some(format!("write `{factor}{rest}`: the factor needs a unit of {named}"))
        };
        if let Some(help) = factor(y, right, x).or_else(|| factor(x, left, y)) {
            return Some(help);
        }
        let name = |d: Dimension, expr: &Expr, other: Dimension| match &expr.kind {
            ExprKind::Name(name) if d == Dimension::NUMBER => {
                let names = self.names_of(other)?;
                Some(format!("write {} in place of `{name}`, as {names}", other.name()?))
            }
            _ => None,
        };
        name(y, right, x)
            .or_else(|| name(x, left, y))
            .or_else(|| correction(x, y).map(|text| text.replacen("by", "the second operand by", 1)))
    }
}

/// `4 kN @ (a - 90 deg)`, where an angle is added to `4 kN @ a`; `(F + 10 N) @ 90 deg`, where `10 N @ 90 deg` is added to a number.
pub fn direction_of_two(verb: &str, left: (&Expr, Type), right: (&Expr, Type)) -> Option<String> {
    let sign = if verb == "subtracted" { '-' } else { '+' };
    match (&left.0.kind, left.1, &right.0.kind, right.1) {
        (ExprKind::Polar(size, angle), _, _, Type::Number(d)) if d.known() == Dimension::ANGLE => {
            let (size, angle, other) = (written(size)?, written(angle)?, written(right.0)?);
            Some(format!("write `{size} @ ({angle} {sign} {other})`"))
        }
        (_, Type::Number(a), ExprKind::Polar(size, angle), Type::Vector(b)) if a.unify(b).is_some() => {
            let (first, size, angle) = (written(left.0)?, written(size)?, written(angle)?);
            Some(format!("write `({first} {sign} {size}) @ {angle}`"))
        }
        _ => None,
    }
}

/// `0.9*stroke(G)`, where a travel is compared with a number.
fn part_of_stroke(left: &Expr, right: &Expr) -> Option<String> {
    let (ExprKind::Call { function, args }, ExprKind::Number(number)) = (&left.kind, &right.kind) else {
        return None;
    };
    let is_travel = Function::named(&function.node) == Some(Function::Travel) && number.value < 1.0;
    let pair = args.first().filter(|_| is_travel).and_then(|a| written(&a.value))?;
    Some(format!("{}*stroke({pair})", number.text))
}

/// A quantity of another dimension than expected.
pub fn unit_mismatch(what: &str, want: &str, found: &str, span: Span, help: Option<String>) -> Diagnosis {
    Diagnosis::error("mech::unit::mismatch", format!("{what} should be {want}, but this is {found}"))
        .primary(span, found)
        .fixes(written_here(help.as_deref(), span))
        .help_if(help)
}

/// What a help says to write in this place, unless more than the place changes: in a header, and of two vectors.
pub fn written_here(help: Option<&str>, at: Span) -> Vec<Fix> {
    let is_here = |help: &&str| help.starts_with("write `") && !help.contains(['[', '(']);
    help.filter(is_here).map(|help| Fix::quoted(help, at)).unwrap_or_default()
}

// Numbers whose unit is missing, or does not say enough, where they stand or where they are defined.

/// A definition that is a number: `given` or `let`, and what comes after the equals sign.
struct Definition<'a> {
    word: &'static str,
    value: &'a Expr,
}

impl Context<'_> {
    /// An expression of bare numbers with the unit that is most likely: ``write `40 mm` ``.
    pub(crate) fn example(&self, expr: &Expr, want: Dimension) -> Option<Help> {
        let units = self.likely_units(want, expr);
        let texts = units.iter().map(|unit| with_unit(expr, unit)).collect::<Option<Vec<_>>>()?;
        Some(Help::write(expr.span, &texts))
    }

    /// The units that a number without one may have: that of the file or the usual one, metres for less than a millimetre, and
    /// revolutions for radians.
    pub(super) fn likely_units(&self, want: Dimension, expr: &Expr) -> Vec<String> {
        let usual = self.values.usual_unit(want);
        if want == Dimension::LENGTH && usual == "mm" && is_less_than_one(expr) {
            return vec!["m".to_owned()];
        }
        if want == Dimension::ANGULAR_VELOCITY && usual == want.si_text() {
            return vec!["rpm".to_owned(), usual];
        }
        vec![usual]
    }

    /// Reports a name in the expression that was given a number without its unit, once, where it is defined. Says
    /// whether there is one.
    pub(crate) fn bare_definition(&mut self, want: Dimension, expr: &Expr) -> bool {
        let mut names = Vec::new();
        factors(expr, &mut names);
        for name in names {
            let Some(definition) = self.number_behind(name) else { continue };
            let units = self.likely_units(want, definition.value);
            let value = |unit: &String| with_unit(definition.value, unit);
            let Some(values) = units.iter().map(value).collect::<Option<Vec<_>>>() else { continue };
            let line = |value: &String| format!("`{} {name} = {value}`", definition.word);
            let words = format!("write {}", values.iter().map(line).collect::<Vec<_>>().join(" or "));
            let (span, used) = (definition.value.span, Some(expr.span));
            let help = Help::write(span, &values).in_words(words);
            self.error(unit_missing(&format!("`{name}`"), want, span, used, help));
            // What does not fit because of it is no second mistake.
            self.values.definitions.settled.insert(name.to_owned(), Settled::Failed);
            return true;
        }
        false
    }

    fn number_behind(&self, name: &str) -> Option<Definition<'_>> {
        Some(match self.names.quantities.get(name)?.what {
            QuantityKind::Given(value) => Definition { word: "given", value },
            QuantityKind::Let(value) => Definition { word: "let", value },
            _ => return None,
        })
    }

    /// Reports revolutions or radians per time where an angular velocity is due.
    pub(crate) fn hertz(&mut self, what: String, expr: &Expr) {
        let (mut span, mut used) = (expr.span, None);
        let mut found = literal(expr).map(|number| (number.clone(), String::new()));
        let mut defined = None;
        if let (None, ExprKind::Name(name)) = (&found, &expr.kind)
            && let Some(definition) = self.number_behind(name)
            && let Some(number) = literal(definition.value)
        {
            found = Some((number.clone(), format!("{} {name} = ", definition.word)));
            (span, used) = (definition.value.span, Some(expr.span));
            defined = Some(name.clone());
        }
        let lines = found.as_ref().and_then(|(number, before)| per_time(number, before, span));
        let unit =
            found.and_then(|(number, _)| number.unit).map_or_else(|| "Hz".to_owned(), |unit| unit.node);
        let help = lines.unwrap_or_else(|| "multiply it by `1 rev`, or by `1 rad`".into());
        self.error(
            Diagnosis::error(
                "mech::unit::hertz",
                format!("{what} is an angular velocity, and `{unit}` may mean revolutions or radians"),
            )
            .primary(span, "revolutions or radians?")
            .label(used, "used here")
            .help(help),
        );
        if let Some(name) = defined {
            self.values.definitions.settled.insert(name, Settled::Failed);
        }
    }

    /// `0.5 l` where `l` is a name of the file: reported, with the product that is meant.
    pub(crate) fn implied_product(&mut self, number: &Number, at: Span) -> bool {
        let Some(word) = &number.unit else { return false };
        let is_name = self.names.quantities.contains_key(&word.node) || word.node == "pi";
        if !is_name || lookup(&word.node).is_ok() {
            return false;
        }
        let text = format!("{}*{}", number.text, word.node);
        if self.problems.reported.insert(("product", text.clone())) {
            let why = format!("`{}` is a name, not a unit: `*` is missing", word.node);
            self.error(
                Diagnosis::error("mech::unit::unknown", why)
                    .primary(at, "not a unit")
                    .help(Help::write(at, &[text]).certain()),
            );
        }
        true
    }
}

/// Whether the greatest of its numbers is below one, and not all are zero.
fn is_less_than_one(expr: &Expr) -> bool {
    let mut greatest = 0.0_f64;
    parts(expr, &mut |part| {
        if let ExprKind::Number(number) = &part.kind {
            greatest = greatest.max(number.value.abs());
        }
    });
    greatest > 0.0 && greatest < 1.0
}

/// The names that an expression is proportional to.
fn factors<'e>(expr: &'e Expr, names: &mut Vec<&'e str>) {
    match &expr.kind {
        ExprKind::Name(name) => names.push(name),
        ExprKind::Unary(_, inner) => factors(inner, names),
        ExprKind::Polar(length, _) => factors(length, names),
        ExprKind::Vector(x, y) => {
            factors(x, names);
            factors(y, names);
        }
        ExprKind::Chain(first, rest) => {
            factors(first, names);
            for (op, operand) in rest {
                if op.node != BinaryOp::Divide {
                    factors(operand, names);
                }
            }
        }
        _ => {}
    }
}

/// A number, after its sign.
fn literal(expr: &Expr) -> Option<&Number> {
    match &expr.kind {
        ExprKind::Number(number) => Some(number),
        ExprKind::Unary(_, inner) => literal(inner),
        _ => None,
    }
}

/// The two values that a number per time may mean, with their definition.
fn per_time(number: &Number, before: &str, at: Span) -> Option<Help> {
    let unit = lookup(&number.unit.as_ref()?.node).ok()?;
    let [turns, radians] = revolutions_or_radians(&number.text, &unit);
    let words = format!("write `{before}{turns}` or `{before}{radians}`");
    Some(Help::write(at, &[turns, radians]).in_words(words))
}

/// A number without a unit where a quantity is expected.
pub fn unit_missing(what: &str, want: Dimension, span: Span, used: Option<Span>, help: Help) -> Diagnosis {
    let want = want.to_string();
    // `an angle`, but not `a quantity in kg*m`
    let kind =
        want.strip_prefix("an ").or_else(|| want.strip_prefix("a ")).filter(|k| !k.starts_with("quantity"));
    let lacks = kind.map_or_else(|| format!("a unit: it is {want}"), |kind| format!("a unit of {kind}"));
    Diagnosis::error("mech::unit::missing", format!("{what} needs {lacks}"))
        .primary(span, "a number without a unit")
        .label(used, "used here")
        .help(help)
}
