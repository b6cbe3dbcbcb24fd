//! Names that stand for no quantity, and what may be meant.

use crate::expr::context::Context;
use crate::names::declared::QuantityKind;
use crate::names::suggestion::{not_declared, suggestion, wrong_kind};
use crate::statements::walk;
use crate::statements::written::text;
use assur_model::model::{LinkId, PairKind};
use assur_syntax::document::{ExprKind, Name, Statement};
use assur_syntax::skeleton;
use assur_text::diagnostic::{Help, did_you_mean};
use assur_text::language::Function;
use assur_text::units::{Dimension, lookup};
use std::collections::BTreeSet;

/// Greek letters as they are called.
pub(crate) const GREEK: &[(&str, &str)] = &[
    ("π", "pi"),
    ("α", "alpha"),
    ("β", "beta"),
    ("γ", "gamma"),
    ("δ", "delta"),
    ("ε", "epsilon"),
    ("η", "eta"),
    ("θ", "theta"),
    ("λ", "lambda"),
    ("μ", "mu"),
    ("µ", "mu"),
    ("ρ", "rho"),
    ("σ", "sigma"),
    ("τ", "tau"),
    ("φ", "phi"),
    ("ϕ", "phi"),
    ("ψ", "psi"),
    ("ω", "omega"),
];

impl Context<'_> {
    /// The line that makes a name an unknown effort, where the file has none and the name is usual for one.
    fn no_balance(&self, name: &str) -> Option<String> {
        let is_balance = |s: &Statement| matches!(s, Statement::Balance(_));
        let torque = name.starts_with('M') || name.starts_with('T');
        if !(torque || name.starts_with('F')) || self.doc.statements.iter().any(|s| is_balance(&s.node)) {
            return None;
        }
        let [drive] = self.drive_statements()[..] else { return None };
        let on = text(&drive.target);
        let line = match (self.drive_dimension(drive) == Dimension::ANGLE, self.find_link(&on)) {
            (true, Some(_)) if torque => format!("balance torque {name} on {on}"),
            (false, None) if !torque && drive.target.tail.is_none() => {
                format!("balance force {name} in {on}")
            }
            (true, Some(_)) => format!("balance force {name} {} along 0 deg", self.on_guided()?),
            _ => return None,
        };
        Some(format!("for an unknown effort add the line `{line}`"))
    }

    /// The only link that slides on the ground, with its point on the guide.
    fn on_guided(&self) -> Option<String> {
        let mut guides = self.builder.mech.pairs.iter().filter_map(|p| match &p.kind {
            PairKind::Prismatic(g) if g.guide == LinkId::GROUND => Some(g),
            _ => None,
        });
        let only = guides.next().filter(|_| guides.next().is_none())?;
        Some(format!("on {} at {}", self.builder.mech.link(only.slider).name, only.point_name))
    }

    /// `find velocities`: functions stand for one thing each.
    fn results_by_name(&self, name: &str) -> Option<String> {
        let functions: &[Function] = match name.to_lowercase().trim_end_matches("ies").trim_end_matches('s') {
            "position" | "displacement" | "coordinate" => &[Function::Position],
            "velocity" | "velocit" | "speed" => &[Function::Velocity],
            "acceleration" => &[Function::Acceleration],
            "everything" | "all" => &[Function::Position, Function::Velocity, Function::Acceleration],
            "force" => return Some("write `reactions`".into()),
            _ => return None,
        };
        let (link, point) =
            self.builder.mech.links.iter().rev().find_map(|l| Some((&l.name, &l.points.first()?.name)))?;
        let calls =
            functions.iter().map(|f| format!("{}({link}.{point})", f.name())).collect::<Vec<_>>().join(", ");
        Some(format!("ask for one point each, as in `{calls}`"))
    }

    /// The time of a motion by another name; of a file that has none, what makes it one.
    fn time_by_other_name(&self, name: &Name) -> Option<Help> {
        let line = "the line `simulate 2 s in 20 steps`";
        match name.node.as_str() {
            "t" | "T" if self.names.simulates => Some(Help::write(name.span, &["time".to_owned()])),
            "t" => Some(format!("{}; the time of a motion is `time`, with {line}", unit_apart("t")?).into()),
            "time" => Some(format!("a motion has a `time`: add {line}").into()),
            _ => None,
        }
    }

    /// The only `given` that nothing uses, where its name and this one are both short.
    fn only_unused_given(&self, name: &Name) -> Option<Help> {
        /// The letters of a symbol.
        const SHORT: usize = 2;
        let mut used = BTreeSet::new();
        for statement in &self.doc.statements {
            walk::expressions(&statement.node, &mut |expr| {
                walk::parts(expr, &mut |part| {
                    if let ExprKind::Name(name) = &part.kind {
                        used.insert(name.as_str());
                    }
                });
            });
        }
        let given = self.names.quantities.iter().filter(|(_, d)| matches!(d.what, QuantityKind::Given(_)));
        let mut idle = given.map(|(name, _)| name).filter(|name| !used.contains(name.as_str()));
        let only = idle.next().filter(|_| idle.next().is_none())?;
        // a name that looks the same is reported as that
        let alike = self.names.quantities.keys().any(|known| skeleton(known) == skeleton(&name.node));
        if alike {
            return None;
        }
        let short = |name: &str| name.chars().count() <= SHORT;
        (short(only) && short(&name.node)).then(|| {
            let words =
                format!("write `{only}`, which nothing uses yet, or declare `given {} = …`", name.node);
            Help::write(name.span, std::slice::from_ref(only)).in_words(words)
        })
    }

    /// Reports a name that stands for no quantity.
    pub(crate) fn no_quantity(&mut self, name: &Name) {
        self.names.note_thing(name);
        let bad = self.names.bad.contains(&name.node) || self.problems.twice.contains("quantity");
        if bad || !self.problems.reported.insert(("quantity", name.node.clone())) {
            return;
        }
        let thing = self.names.things.get(&name.node).map(|d| (d.what.phrase(), Some(d.span), d.what));
        let error = if let Some((is, declared, what)) = thing {
            wrong_kind(
                &name.node,
                &is,
                "a quantity",
                name.span,
                declared,
                crate::names::declared::ask_of(what, &name.node),
            )
        } else {
            let all = self.names.quantities.keys().map(String::as_str).collect::<Vec<_>>();
            // names of the file come before the constant, unless it differs from that in its capitals alone
            let is_pi = name.node.eq_ignore_ascii_case("pi");
            let alone = is_pi || did_you_mean(&name.node, all.iter().copied()).is_empty();
            let pi = || {
                let near = alone && !did_you_mean(&name.node, ["pi"]).is_empty();
                near.then(|| Help::did_you_mean(&name.node, name.span, &["pi".to_owned()]))
            };
            let unit = || if alone { unit_apart(&name.node) } else { None };
            let effort = || if alone { self.no_balance(&name.node) } else { None };
            let results = || if alone { self.results_by_name(&name.node) } else { None };
            let listed = suggestion(&name.node, name.span, &all, "quantities");
            let listed = listed.map(|help| match help.fixes() {
                [] => beside_a_list(&help, name),
                _ => help,
            });
            let greek = |name: &Name| {
                let latin = GREEK.iter().find(|(letter, _)| *letter == name.node)?.1;
                let known = latin == "pi" || self.names.quantities.contains_key(latin);
                known.then(|| Help::write(name.span, &[latin.to_owned()]))
            };
            let time = || if alone { self.time_by_other_name(name) } else { None };
            let unused = || self.only_unused_given(name);
            let help = greek(name).or_else(unused).or_else(pi).or_else(time);
            let help = help.or_else(|| unit().or_else(effort).or_else(results).map(Help::from));
            let alone = || self.function_alone(&name.node, name.span).map(Help::from);
            let help = help.or_else(alone).or(listed);
            let (name, span) = (name.node.clone(), name.span);
            not_declared("quantity", &name, None, span, help)
        };
        self.error(error);
    }
}

/// What a name may be that is near none of those that there are: a unit with a slip, or a value to be given.
fn beside_a_list(list: &Help, name: &Name) -> Help {
    let nearest = lookup(&name.node).err().map(|error| error.nearest().to_vec()).unwrap_or_default();
    match nearest.first().filter(|_| name.node.chars().count() > 2) {
        Some(unit) => Help::write(name.span, std::slice::from_ref(unit))
            .in_words(format!("write `{unit}` if the unit is meant; {list}")),
        None => format!("{list}; a new one is a line `given {} = …`", name.node).into(),
    }
}

/// What to say of a unit that stands by itself where a quantity is due: `60 N * m`, `20 m/s2`.
fn unit_apart(name: &str) -> Option<String> {
    let letters = name.trim_end_matches(|c: char| c.is_ascii_digit());
    let power = &name[letters.len()..];
    if lookup(letters).is_err() {
        return None;
    }
    let one_word = "a number and its unit are written as `60 N*m` or `2 m/s^2`";
    Some(match power {
        "" => format!("`{name}` is a unit; {one_word}, without blanks in the unit"),
        _ => format!("the unit is `{letters}^{power}`; {one_word}"),
    })
}
