//! What a call that is no function, or has arguments of the wrong kind, may mean.

use crate::expr::context::Context;
use crate::expr::results::{Call, argument_count};
use crate::names::suggestion::{not_declared, wrong_kind};
use crate::statements::written::written;
use crate::values::typed::Type;
use assur_model::model::LinkId;
use assur_syntax::document::{Arg, Expr, ExprKind, Name, Statement};
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::language::{FUNCTIONS, Function};
use assur_text::source::{Span, Spanned};

/// Functions by other names that people give them.
const ALSO: &[(Function, &[&str])] = &[
    (Function::Velocity, &["v", "vel", "speed", "velocities"]),
    (Function::Acceleration, &["a", "acc", "accel"]),
    (
        Function::Position,
        &["pos", "point", "coordinates", "location", "path", "trajectory", "locus", "displacement"],
    ),
    (Function::Omega, &["ω", "w", "angular_velocity", "angular_speed", "angvel", "rate", "velocity"]),
    (Function::Alpha, &["α", "ε", "eps", "epsilon", "angular_acceleration", "acceleration"]),
    (Function::Angle, &["φ", "ϕ", "phi", "theta", "rotation", "orientation", "position"]),
    (Function::Displacement, &["s", "x", "coordinate"]),
    (Function::Effort, &["torque", "force", "driving_torque", "moment", "motor_torque", "M"]),
    (Function::Reaction, &["force", "joint_force", "R"]),
    (Function::Mag, &["norm", "magnitude", "length", "len", "abs"]),
    (Function::Dir, &["direction", "arg"]),
    (Function::Mean, &["average", "avg"]),
    (Function::Max, &["maximum", "amax"]),
    (Function::Min, &["minimum", "amin"]),
    (Function::Sqrt, &["root", "√"]),
    (Function::Efficiency, &["η", "eta"]),
    (Function::Mass, &["m"]),
    (Function::Sticks, &["engaged", "stuck", "held"]),
    (Function::Slips, &["slipping", "slides"]),
    (Function::Stable, &["stability", "is_stable"]),
    (Function::Distance, &["dist", "gap"]),
    (Function::CurvatureRadius, &["curvature", "radius_of_curvature", "rho"]),
    (Function::CurvatureCentre, &["curvature_center", "centre_of_curvature", "center_of_curvature"]),
    (Function::InstantCentre, &["instant_center", "icr", "pole", "velocity_pole"]),
];

/// Forces inside a link by other names.
const INTERNAL: &[(&str, &str)] =
    &[("shear", "Q"), ("shear_force", "Q"), ("bending_moment", "M"), ("bending", "M"), ("axial_force", "N")];

impl Context<'_> {
    /// Reports a call of what is no function.
    pub(crate) fn no_function(&mut self, call: Call<'_>) {
        let name = &call.name.node;
        if !self.problems.reported.insert(("function", name.clone())) {
            return;
        }
        let suggestion = self.suggestion(call);
        let help = suggestion.or_else(|| near(call.name)).unwrap_or_else(|| {
            "ask for one of `position`, `velocity`, `acceleration`, `angle`, `omega`, `alpha`, `displacement`, `reaction`, \
             `moment`, `effort`, `power`, `efficiency`; the language has no others like it"
                .into()
        });
        let (name, span) = (name.clone(), call.name.span);
        let help = Some(help);
        self.error(not_declared("function", &name, None, span, help));
    }

    /// `write …` with a call that can be read.
    fn suggestion(&mut self, call: Call<'_>) -> Option<Help> {
        let write = |expr: &Expr| Some(Help::write(call.span, &[written(expr)?]));
        let name = call.name.node.as_str();
        let also = ALSO.iter().filter(|(_, others)| others.contains(&name)).map(|(function, _)| *function);
        let named = also.map(|function| called(function, call.args, call.span));
        let candidates = named.collect::<Vec<_>>();
        if let ("range" | "span", [_]) = (name, call.args) {
            let [most, least] =
                [Function::Max, Function::Min].map(|f| written(&called(f, call.args, call.span)));
            return Some(format!("write `{} - {}`", most?, least?).into());
        }
        if let Some((_, part)) = INTERNAL.iter().find(|(other, _)| *other == name) {
            let args = call.args.iter().map(|arg| written(&arg.value)).collect::<Option<Vec<_>>>()?;
            return Some(Help::write(call.span, &[format!("internal({}).{part}", args.join(", "))]));
        }
        if matches!(name, "torque" | "moment" | "driving_torque")
            && let Some(balance) = self.builder.mech.balances.first()
        {
            return Some(format!("ask for the unknown effort: `{}`", balance.name).into());
        }
        let found = candidates.iter().find(|c| self.quietly(|cx| cx.read(c)).is_some())?;
        write(found)
    }

    /// Reports what is asked of a pair or point though it belongs to a link. Whether it was.
    pub(crate) fn not_of_a_link(&mut self, call: Call<'_>, expr: &Expr) -> bool {
        let ExprKind::Name(name) = &expr.kind else { return false };
        if self.find_link(name).is_some() {
            return false;
        }
        let pair = self.find_pair(name);
        let links: Vec<LinkId> = match pair.map(|p| &self.builder.mech.pair(p).kind) {
            Some(kind) => kind.links(),
            None => self.links_with(&[name]),
        };
        let links = self.spelled(&links).into_iter().filter(|l| l != "ground");
        let lines = links.map(|l| format!("`{}({l})`", call.name.node)).collect::<Vec<_>>();
        if lines.is_empty() {
            return false;
        }
        let is = match self.names.things.get(name).filter(|_| pair.is_some()) {
            Some(declared) => declared.what.phrase(),
            None => "a point".into(),
        };
        let help = Some(format!("{is} does not turn: write {}", lines.join(" or ")));
        let declared = self.names.things.get(name).map(|d| d.span);
        let (name, wanted, span) = (name.clone(), "a link".to_owned(), expr.span);
        self.error(wrong_kind(&name, &is, &wanted, span, declared, help));
        true
    }

    /// The links that have all these points.
    fn links_with(&self, points: &[&str]) -> Vec<LinkId> {
        let all = self.builder.mech.links.iter().enumerate();
        let has = |link: &assur_model::model::Link| {
            points.iter().all(|n| link.points.iter().any(|p| p.name == **n))
        };
        all.filter(|(_, link)| has(link)).map(|(i, _)| LinkId::at(i)).collect()
    }

    /// Reports two points in place of a link.
    pub(crate) fn link_by_points(&mut self, call: Call<'_>) -> Option<()> {
        let [a, b] = call.args else { return None };
        let (ExprKind::Name(first), ExprKind::Name(second)) = (&a.value.kind, &b.value.kind) else {
            return None;
        };
        let links = self.links_with(&[first, second]);
        let lines = self.spelled(&links).into_iter().map(|l| format!("{}({l})", call.name.node));
        let usage = lines.collect::<Vec<_>>().join("` or `");
        (!usage.is_empty()).then(|| {
            let (function, takes) = (call.name.node.clone(), "one argument, a link");
            self.error(argument_count(&function, takes, 2, call.span, &usage));
        })
    }

    /// Reports links in place of the group that they form.
    pub(crate) fn group_by_links(&mut self, call: Call<'_>) -> Option<()> {
        let names = call.args.iter().map(|a| match &a.value.kind {
            ExprKind::Name(name) if self.find_link(name).is_some() => Some(name.as_str()),
            _ => None,
        });
        let names = names.collect::<Option<Vec<_>>>()?;
        let links = names.join(", ");
        let group = self.doc.statements.iter().find_map(|s| match &s.node {
            Statement::Group(g) => {
                let same =
                    g.links.len() == names.len() && g.links.iter().all(|l| names.contains(&l.node.as_str()));
                same.then(|| g.name.node.clone())
            }
            _ => None,
        });
        let function = &call.name.node;
        let help = match group {
            Some(group) => format!("write `{function}({group})`"),
            None => {
                let free = |name: &&&str| !self.names.things.contains_key(**name);
                let group = ["dyad", "bc", "group_1", "group_2"].iter().find(free)?;
                format!("add the line `group {group}: {links}`, and write `{function}({group})`")
            }
        };
        let (function, span) = (function.clone(), call.span);
        self.error(
            Diagnosis::error(
                "mech::request::arguments",
                format!("`{function}` takes a group, not the links {links}"),
            )
            .primary(span, "a group is expected")
            .help(help),
        );
        Some(())
    }

    /// Reports a vector of which the magnitude is meant, `speed(C)` of a point. Whether it was.
    pub(crate) fn speed_of_point(&mut self, call: Call<'_>) -> bool {
        let velocity = called(Function::Velocity, call.args, call.span);
        let read = self.quietly(|cx| cx.read(&velocity));
        let (Some(text), Some([arg])) = (written(&velocity), Some(call.args)) else { return false };
        if !read.is_some_and(|t| matches!(t.ty, Type::Vector(_))) {
            return false;
        }
        let (name, span) = (written(&arg.value).unwrap_or_default(), arg.value.span);
        let help = Some(format!("write `mag({text})`"));
        self.error(wrong_kind(&name, "a point", "a slider", span, None, help));
        true
    }
}

/// A call of another function with the same arguments.
fn called(function: Function, args: &[Arg], span: Span) -> Expr {
    let function = Spanned::new(function.name().to_owned(), span);
    Expr { kind: ExprKind::Call { function, args: args.to_vec() }, span }
}

/// `did you mean …?`, functions with which the name shares more than a few letters.
fn near(written: &Name) -> Option<Help> {
    let name = &written.node;
    let all = did_you_mean(name, FUNCTIONS.iter().map(|f| f.name));
    let close = |f: &&str| 2 * f.len() > name.len() && 2 * name.len() >= f.len();
    let near = all.into_iter().filter(close).map(str::to_owned).collect::<Vec<_>>();
    (!near.is_empty()).then(|| Help::did_you_mean(name, written.span, &near))
}
