//! Names that are taken already: what may be meant in place of the second.

use crate::names::{declared::QuantityKind, lookalikes::Scope};
use crate::statements::written::{end_text, line_of, text, written};
use assur_syntax::document::{
    Balance, End, ExpectAt, ExprKind, Joint, LoadKind, Name, Place, Pose, Site, Statement, Turn,
};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Collection;
use assur_text::source::Span;
use indexmap::IndexSet;

impl Scope<'_, '_> {
    /// Reports a second pose of one name. A pose that is named elsewhere and declared nowhere is the one meant.
    pub(crate) fn pose_taken(&mut self, pose: &Pose, first: Span) {
        let statements = || self.doc.statements.iter().map(|s| &s.node);
        let declared =
            |name: &str| statements().any(|s| matches!(s, Statement::Pose(p) if p.name.node == name));
        let asked = statements().filter_map(|s| match s {
            Statement::Expect(e) => match &e.at {
                Some(ExpectAt::Pose(name)) => Some(name.node.as_str()),
                _ => None,
            },
            _ => None,
        });
        let open = asked.filter(|n| n.parse::<usize>().is_err() && !declared(n)).collect::<IndexSet<_>>();
        let missing = only(&open);
        let help = missing.as_ref().map(|name| {
            let line = pose_line(name, pose).unwrap_or_else(|| format!("pose {name} at …"));
            format!("write `{line}`; `{name}` is asked for but not declared")
        });
        self.taken("pose", &pose.name, first, help, missing);
    }

    /// Reports a second quantity of one name, with the one that is asked for and declared nowhere.
    pub(crate) fn quantity_taken(&mut self, name: &Name, what: QuantityKind<'_>, first: Span) {
        let missing = match what {
            QuantityKind::Load(..) | QuantityKind::Brake(_) | QuantityKind::Balance(..) => {
                self.asked_and_open()
            }
            _ => None,
        };
        let help = missing.as_ref().map(|open| {
            let line = match what {
                QuantityKind::Balance(_, balance) => balance_line(open, balance),
                _ => None,
            };
            let how = line.map_or_else(|| "use this name here".into(), |line| format!("write `{line}`"));
            format!("{how}; `{open}` is asked for but not declared")
        });
        self.taken("quantity", name, first, help, missing);
    }

    /// The only name that stands alone in a `find` or `expect` and is no quantity.
    fn asked_and_open(&self) -> Option<String> {
        let statements = || self.doc.statements.iter().map(|s| &s.node);
        let declares = |s: &Statement, name: &str| match s {
            Statement::Given(d) | Statement::Let(d) => d.name.node == name,
            Statement::Load(l) => l.name.as_ref().is_some_and(|n| n.node == name),
            Statement::Balance(b) => b.name.node == name,
            Statement::Brake(b) => b.name.node == name,
            Statement::Flywheel(f) => f.name.node == name,
            Statement::Curve(c) => c.name.node == name,
            Statement::Find(f) => f.items.iter().any(|i| i.name.as_ref().is_some_and(|n| n.node == name)),
            Statement::Variants(v) => v.columns.iter().any(|c| c.name.node == name),
            Statement::Bad(bad) => bad.names.iter().any(|n| n == name),
            _ => false,
        };
        let asked = statements().flat_map(|s| match s {
            Statement::Find(f) => f.items.iter().map(|i| &i.value).collect::<Vec<_>>(),
            Statement::Expect(e) => vec![&e.what],
            _ => Vec::new(),
        });
        let names = asked.filter_map(|e| match &e.kind {
            ExprKind::Name(name) => Some(name.as_str()),
            _ => None,
        });
        let open = names.filter(|n| Collection::named(n).is_none() && !statements().any(|s| declares(s, n)));
        only(&open.collect::<IndexSet<_>>())
    }

    /// Reports a second pair of one name; one that says the same as the first is too much.
    pub(crate) fn joint_taken(&mut self, joint: &Joint, first: Span) {
        let spelled = |j: &Joint| line_of(j, end_text);
        let again = self.doc.statements.iter().any(|s| match &s.node {
            Statement::Joint(other) => other.name.span == first && spelled(other) == spelled(joint),
            _ => false,
        });
        let help = again.then(|| "leave this line out: it repeats the other line".to_owned());
        self.taken("thing", &joint.name, first, help, None);
    }

    /// Reports a slider where an idler is declared; whether it is one.
    pub(crate) fn over_slider(&mut self, joint: &Joint, name: &Name) -> bool {
        let is_slider = |s: &Statement| matches!(s, Statement::Slider(s) if s.name.node == name.node);
        if !self.doc.statements.iter().any(|s| is_slider(&s.node)) {
            return false;
        }
        let line = line_of(joint, |end| match end {
            End::Over(n) if n.span == name.span => format!("under({})", n.node),
            end => end_text(end),
        });
        self.error(
            Diagnosis::error(
                "mech::train::rope_end",
                format!("`{}` is a slider: a rope cannot run over it", name.node),
            )
            .primary(name.span, "this slider")
            .help(format!("write `{line}` for a movable pulley on it")),
        );
        self.names.bad.insert(joint.name.node.clone());
        true
    }

    fn taken(
        &mut self,
        class: &'static str,
        name: &Name,
        first: Span,
        help: Option<String>,
        missing: Option<String>,
    ) {
        // what is asked of the missing one is no second mistake
        self.names.bad.extend(missing);
        self.twice(class, name, first, help);
    }

    /// Reports a second declaration. A name of this class that is used and declared nowhere may be the one meant.
    pub(crate) fn twice(&mut self, class: &'static str, name: &Name, first: Span, help: Option<String>) {
        self.problems.twice.insert(class);
        self.error(crate::names::suggestion::duplicate(name, first, help));
    }
}

fn only(names: &IndexSet<&str>) -> Option<String> {
    names.first().filter(|_| names.len() == 1).map(|n| (*n).to_owned())
}

fn pose_line(name: &str, pose: &Pose) -> Option<String> {
    let settings = pose.settings.iter().map(|s| {
        let sense = match s.value.sense.as_ref().map(|s| s.node) {
            Some(Turn::Cw) => " cw",
            Some(Turn::Ccw) => " ccw",
            None => "",
        };
        Some(format!("{} = {}{sense}", text(&s.target), written(&s.value.value)?))
    });
    Some(format!("pose {name} at {}", settings.collect::<Option<Vec<_>>>()?.join(", ")))
}

fn balance_line(name: &str, balance: &Balance) -> Option<String> {
    let word = if balance.kind.node == LoadKind::Torque { "torque" } else { "force" };
    let site = match &balance.site {
        Site::Pair(pair) => format!("in {}", pair.node),
        Site::Pin(pin) => format!("at {}", pin.node),
        Site::Segment { link, from, to } => format!("on {} from {} to {}", link.node, from.node, to.node),
        Site::Link { link, at: None } => format!("on {}", link.node),
        Site::Link { link, at: Some(Place::Point(point)) } => format!("on {} at {}", link.node, point.node),
        Site::Link { link, at: Some(Place::Ground(place)) } => {
            format!("on {} at {}", link.node, written(place)?)
        }
    };
    let along = match &balance.along {
        Some(along) => format!(" along {}", written(along)?),
        None => String::new(),
    };
    let frame = balance.frame.as_ref().map_or_else(String::new, |f| format!(" in {}", f.node));
    Some(format!("balance {word} {name} {site}{along}{frame}"))
}
