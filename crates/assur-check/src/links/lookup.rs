//! From names to ids and places.

use crate::expr::context::Context;
use crate::links::missing_guide::missing_guide;
use crate::names::{
    declared::{Inside, ThingKind},
    suggestion::{not_declared, suggestion, wrong_kind},
};
use assur_math::math::Vec2;
use assur_model::model::{Circle, Guide, Line, LinkId, Pair, PairId, PairKind, Point};
use assur_syntax::document::{End, JointKind, Name, Statement};
use assur_text::diagnostic::{Diagnosis, Help, did_you_mean};
use assur_text::language::Function;
use assur_text::source::Span;
use indexmap::IndexSet;

/// The pairs that join links of a linkage; all others are transmissions.
pub fn is_linkage_pair(kind: JointKind) -> bool {
    use JointKind::{Contact, Cylinder, Prismatic, Revolute, Slot, Weld};
    matches!(kind, Revolute | Prismatic | Slot | Contact | Cylinder | Weld)
}

/// Whether a thing is a pair of a linkage.
pub(crate) fn is_pair(kind: ThingKind) -> bool {
    matches!(kind, ThingKind::Joint(kind) if is_linkage_pair(kind))
}

impl Context<'_> {
    /// The link of that name; `ground` too. Reports a name that is not one of a link.
    pub fn link(&mut self, name: &Name) -> Option<LinkId> {
        self.names.note_thing(name);
        let found = self.find_link(&name.node);
        if found.is_none() {
            self.no_thing(name, "link", "a link", |kind| {
                matches!(kind, ThingKind::Link | ThingKind::Shaft | ThingKind::Slider)
            });
        }
        found
    }

    /// The link of that name, nothing said where there is none.
    pub fn find_link(&self, name: &str) -> Option<LinkId> {
        self.names.links.get(name).copied()
    }

    /// The link that this very statement declares; `None` for the second of two of one name, reported already.
    pub fn own_link(&self, name: &Name) -> Option<LinkId> {
        self.find_link(&name.node).filter(|id| self.builder.mech.link(*id).span == name.span)
    }

    /// Whether the name's first declaration is this one; a second is reported with the names, and left out.
    pub(crate) fn is_own(&self, name: &Name) -> bool {
        self.names.things.get(&name.node).is_some_and(|d| d.span == name.span)
    }

    /// Whether all pairs of the linkage are in the mechanism: none has an error, no statement is unreadable. Where it is
    /// not so, something that seems unjoined may be joined.
    pub(crate) fn pairs_complete(&self) -> bool {
        let is_pair = |s: &Statement| matches!(s, Statement::Joint(j) if is_linkage_pair(j.kind.node));
        let is_bad = |s: &Statement| matches!(s, Statement::Bad(_));
        let statements = || self.doc.statements.iter().map(|s| &s.node);
        let joined = self
            .builder
            .mech
            .pairs
            .iter()
            .filter(|p| p.bearing.is_none() && !matches!(p.kind, PairKind::Transmission(_)));
        statements().filter(|s| is_pair(s)).count() == joined.count() && !statements().any(is_bad)
    }

    /// The names of links, each as code.
    pub(crate) fn spelled(&self, links: &[LinkId]) -> Vec<String> {
        links.iter().map(|l| self.builder.mech.link(*l).name.clone()).collect()
    }

    /// The pair of that name. Reports a name that is not one of a pair; silent where the pair has an error. Only once
    /// the pairs are in the mechanism.
    pub fn pair(&mut self, name: &Name) -> Option<PairId> {
        self.names.note_thing(name);
        let found = self.find_pair(&name.node);
        if found.is_none() {
            // what is declared as one and is not in the mechanism has an error
            self.no_thing(name, "pair", "a pair", |kind| matches!(kind, ThingKind::Joint(_)));
        }
        found
    }

    /// The pair of that name in the mechanism, nothing said where there is none.
    pub fn find_pair(&self, name: &str) -> Option<PairId> {
        self.names.pairs.get(name).copied()
    }

    /// The asserted group of that name, as its place in `Mechanism::groups`.
    pub fn group(&mut self, name: &Name) -> Option<usize> {
        self.names.note_thing(name);
        let found = self.builder.mech.groups.iter().position(|g| g.name == name.node);
        if found.is_none() {
            self.no_thing(name, "group", "a group", |kind| kind == ThingKind::Group);
        }
        found
    }

    /// A point of a link, in its frame. Silent where the point is declared with an error. Only once the links have
    /// their points.
    pub fn point(&mut self, link: LinkId, name: &Name) -> Option<Vec2> {
        let found = self.place_of_point(link, &name.node);
        self.known_inside(found, link, name, "point")
    }

    /// Where a link has the point of that name, nothing said where it has none.
    pub(crate) fn place_of_point(&self, link: LinkId, name: &str) -> Option<Vec2> {
        let points = &self.builder.mech.link(link).points;
        let named = |p: &&Point| p.name == name;
        // those with an error are left out: it stands where it is declared, or before
        let declared = self.names.inside.get(link.index()).and_then(|i| i.points.get_index_of(name));
        let near = declared.and_then(|at| points[..points.len().min(at + 1)].iter().rev().find(named));
        near.or_else(|| points.iter().find(named)).map(|p| p.at)
    }

    /// A line of a link.
    pub fn line(&mut self, link: LinkId, name: &Name) -> Option<Line> {
        let found = self.builder.mech.link(link).lines.iter().find(|l| l.name == name.node).cloned();
        self.known_inside(found, link, name, "line")
    }

    /// A circle of a link.
    pub fn circle(&mut self, link: LinkId, name: &Name) -> Option<Circle> {
        let found = self.builder.mech.link(link).circles.iter().find(|c| c.name == name.node).cloned();
        self.known_inside(found, link, name, "circle")
    }

    /// What a link calls by this name: `point`, `line` or `circle`, as declared, errors or not.
    pub fn kind_inside(&self, link: LinkId, name: &str) -> Option<&'static str> {
        let inside = self.names.inside.get(link.index())?;
        [("point", &inside.points), ("line", &inside.lines), ("circle", &inside.circles)]
            .into_iter()
            .find_map(|(kind, list)| list.contains_key(name).then_some(kind))
    }

    /// Reports a name that this link does not declare, and passes the rest on.
    fn known_inside<T>(
        &mut self,
        found: Option<T>,
        link: LinkId,
        name: &Name,
        kind: &'static str,
    ) -> Option<T> {
        self.names.note_inside(link, name);
        if found.is_some() {
            return found;
        }
        let owner = self.builder.mech.link(link).name.clone();
        if let Some(is) = self.kind_inside(link, &name.node) {
            if is != kind {
                self.error(wrong_kind(
                    &format!("{owner}.{}", name.node),
                    &format!("a {is}"),
                    &format!("a {kind}"),
                    name.span,
                    None,
                    None,
                ));
            }
            return None;
        }
        let inside = self.names.inside.get(link.index())?;
        if inside.bad.contains(&name.node)
            || self.names.bad.contains(&name.node)
            || self.problems.twice.contains("point")
        {
            return None;
        }
        let list = match kind {
            "point" => &inside.points,
            "line" => &inside.lines,
            _ => &inside.circles,
        };
        let all = list.keys().map(String::as_str).collect::<Vec<_>>();
        let asks = Function::named(&name.node).is_some_and(|f| f.row().is_result());
        let help = match kind {
            "point" if asks && !matches!(owner.as_str(), "ground") => {
                Some(format!("a quantity is a function: write `{}({owner})`", name.node).into())
            }
            _ => suggestion(&name.node, name.span, &all, &format!("{kind}s of {owner}")),
        };
        if self.problems.reported.insert((kind, format!("{owner}.{}", name.node))) {
            let (name, span, owner) = (name.node.clone(), name.span, Some(owner));
            self.error(not_declared(kind, &name, owner, span, help));
        }
        None
    }

    /// Reports that a name is not one of this kind of thing, unless it may be one that has an error.
    pub(crate) fn no_thing(
        &mut self,
        name: &Name,
        kind: &'static str,
        wanted: &str,
        fits: impl Fn(ThingKind) -> bool,
    ) {
        self.names.note_thing(name);
        if let Some(declared) = self.names.things.get(&name.node) {
            if !fits(declared.what) && !self.names.bad.contains(&name.node) {
                if self.follows_wrong_end(name, &fits) {
                    return;
                }
                let (is, declared) = (declared.what.phrase(), Some(declared.span));
                let of_link = if kind == "pair" { self.pair_meant(name, &fits) } else { None };
                let slider = if kind == "slider or link" { self.as_slider(&name.node) } else { None };
                // a shaft that should be a slider is meant everywhere
                if slider.is_some() {
                    self.names.bad.insert(name.node.clone());
                }
                let help = of_link.or(slider).or_else(|| self.fitting(name, kind, &fits));
                self.error(wrong_kind(&name.node, &is, wanted, name.span, declared, help));
            }
            return;
        }
        let is_silent = self.names.bad.contains(&name.node) || self.problems.twice.contains("thing");
        // one name, whatever it is taken for
        let is_new = self.problems.reported.insert(("thing", name.node.clone()));
        if is_silent || !self.problems.reported.insert((kind, name.node.clone())) || !is_new {
            return;
        }
        let ground = (kind == "link").then_some("ground");
        let all = self.names.things.iter().filter(|(_, d)| fits(d.what)).map(|(n, _)| n.as_str());
        let all = ground.into_iter().chain(all).collect::<Vec<_>>();
        let near = !did_you_mean(&name.node, all.iter().copied()).is_empty();
        let mesh = if kind == "pair" && !near { missing_mesh(self, &name.node) } else { None };
        let kinds = kind.replace(", ", "s, ").replace(" or ", "s or ") + "s";
        let listed = || suggestion(&name.node, name.span, &all, &kinds);
        let wants_pair = kind.split(" or ").any(|kind| kind == "pair");
        let guide = if wants_pair && !near { missing_guide(self, &name.node) } else { None };
        let help = mesh.or(guide).map(Help::from).or_else(listed);
        let (name, span) = (name.node.clone(), name.span);
        self.error(not_declared(kind, &name, None, span, help));
    }

    /// The pair that may be meant by another thing: of a wheel its transmission, of a link that of its links.
    fn pair_meant(&self, name: &Name, fits: &impl Fn(ThingKind) -> bool) -> Option<String> {
        let is = self.names.things.get(&name.node).map(|d| d.what);
        match is {
            Some(ThingKind::Wheel | ThingKind::Group | ThingKind::Cam) => self.fitting(name, "pair", fits),
            _ => self.pairs_of(&name.node),
        }
    }

    /// The pairs of a link where one of them is due: the only one in which it slides, else all.
    fn pairs_of(&self, link: &str) -> Option<String> {
        let link = self.find_link(link)?;
        let joins = |pair: &&Pair| pair.kind.links().contains(&link);
        let slides = |pair: &&Pair| {
            matches!(pair.kind, PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. })
        };
        let all: Vec<&Pair> = self.builder.mech.pairs.iter().filter(joins).collect();
        let sliding: Vec<&Pair> = all.iter().copied().filter(slides).collect();
        match (sliding.as_slice(), all.as_slice()) {
            (_, []) => None,
            ([only], _) => Some(format!("write `{}`: the pair in which it slides", only.name)),
            _ => {
                let names: Vec<String> = all.iter().map(|pair| format!("`{}`", pair.name)).collect();
                Some(format!("its pairs are {}", names.join(", ")))
            }
        }
    }

    /// The point that a name alone stands for: the pin or named point of the pair of that name, or the points of that
    /// name where a pin joins all of them. Reports what is unknown or ambiguous.
    pub fn point_of_shared_name(&mut self, name: &Name) -> Option<(LinkId, Vec2)> {
        if matches!(self.names.things.get(&name.node), Some(d) if is_pair(d.what)) {
            self.names.note_thing(name);
        }
        self.names.note_points(name);
        let own = self.find_pair(&name.node).and_then(|id| place_of_pair(&self.builder.mech.pair(id).kind));
        let bearers = self.bearers(&name.node);
        let first = own.or_else(|| bearers.first().copied());
        let Some(first) = first else {
            return self.no_point(name);
        };
        let joined = self.builder.joined_with(first);
        if bearers.iter().all(|b| joined.contains(b)) {
            return Some(first);
        }
        if !self.pairs_complete() {
            return None;
        }
        let spelled =
            |&(link, _): &(LinkId, Vec2)| format!("`{}.{}`", self.builder.mech.link(link).name, name.node);
        let choices = bearers.iter().map(spelled).collect::<Vec<_>>().join(" or ");
        let message = format!("several points have the name `{}`, and no pin joins them", name.node);
        let diagnosis = Diagnosis::error("mech::name::ambiguous_point", message)
            .primary(name.span, "the link is missing");
        self.error(match bearers.as_slice() {
            // where a pin may be missing, it is not known which point is meant
            [a, b] => {
                let [a, b] = [a, b].map(|&(link, _)| &self.builder.mech.link(link).name);
                let joins = if self.names.things.contains_key(&name.node) {
                    format!("`{}` joins other points; to join these points, write it", name.node)
                } else {
                    "if a hinge is missing, add".to_owned()
                };
                diagnosis.help(format!("write {choices}; {joins} `revolute {}: {a} - {b}`", name.node))
            }
            _ => diagnosis.help(format!("write {choices}")).quoted(name.span),
        });
        None
    }

    /// All points of a name, with their links.
    fn bearers(&self, name: &str) -> Vec<(LinkId, Vec2)> {
        let mut bearers = self.bearers_as_declared(name).collect::<Vec<_>>();
        bearers.sort_unstable_by_key(|b| b.0);
        bearers
    }

    /// As [`Self::bearers`], in the order declared.
    pub(crate) fn bearers_as_declared<'c>(
        &'c self,
        name: &'c str,
    ) -> impl Iterator<Item = (LinkId, Vec2)> + use<'c> {
        let links = self.names.bearers.get(name).into_iter().flatten();
        links.filter_map(move |&link| Some((link, self.place_of_point(link, name)?)))
    }

    fn no_point(&mut self, name: &Name) -> Option<(LinkId, Vec2)> {
        let declared = |i: &Inside| i.points.contains_key(&name.node) || i.bad.contains(&name.node);
        let pair = self.names.things.get(&name.node).map(|d| d.what);
        let pair = pair.filter(|kind| is_pair(*kind));
        if self.find_pair(&name.node).is_some() {
            let is = pair.map_or_else(|| "a pair".into(), ThingKind::phrase);
            self.error(wrong_kind(
                &name.node,
                &format!("{is} without a point of its own"),
                "a point",
                name.span,
                self.names.things.get(&name.node).map(|d| d.span),
                Some("write the link before its point: `rod.C`".into()),
            ));
            return None;
        }
        let silent =
            pair.is_some() || self.names.bad.contains(&name.node) || self.problems.twice.contains("point");
        if silent
            || self.names.inside.iter().any(declared)
            || !self.problems.reported.insert(("point", name.node.clone()))
        {
            return None;
        }
        if let Some(link) = self.find_link(&name.node) {
            self.link_for_point(name, link);
            return None;
        }
        let all = self.names.inside.iter().flat_map(|i| i.points.keys()).map(String::as_str);
        let all = all.collect::<IndexSet<_>>().into_iter().collect::<Vec<_>>();
        let help = suggestion(&name.node, name.span, &all, "points");
        let (name, span) = (name.node.clone(), name.span);
        self.error(not_declared("point", &name, None, span, help));
        None
    }
}

impl Context<'_> {
    /// Reports a link where a point is due.
    fn link_for_point(&mut self, name: &Name, link: LinkId) {
        let points = self.names.inside.get(link.index()).map(|i| &i.points);
        let point = points.and_then(|p| p.last()).map(|(point, _)| point.clone());
        let help = point.map(|point| format!("write one of its points: `{}.{point}`", name.node));
        let thing = self.names.things.get(&name.node).filter(|d| d.what != ThingKind::Link);
        let (is, declared, help) = match thing.map(|d| (d.what, d.span)) {
            // a wheel turns with its shaft
            Some((what, span)) => (what.phrase(), span, crate::names::declared::ask_of(what, &name.node)),
            None => ("a link".into(), self.builder.mech.link(link).span, help),
        };
        self.error(wrong_kind(
            &name.node,
            &is,
            "a point",
            name.span,
            (declared != Span::default()).then_some(declared),
            help,
        ));
    }
}

/// What kind of pair it is, with its article.
pub const fn kind_phrase(kind: &PairKind) -> &'static str {
    match kind {
        PairKind::Revolute(_) => "a revolute pair",
        PairKind::Prismatic(_) => "a prismatic pair",
        PairKind::Slot(_) => "a slot",
        PairKind::Contact { .. } => "a contact",
        PairKind::Cylinder { .. } => "a cylinder",
        PairKind::Weld { .. } => "a weld",
        PairKind::Transmission(t) => t.kind.phrase(),
    }
}

/// The point a pair stands for: its pin, or the point on the line.
pub fn place_of_pair(kind: &PairKind) -> Option<(LinkId, Vec2)> {
    match kind {
        PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => pins.first().map(|p| (p.link, p.at)),
        PairKind::Prismatic(Guide { slider, point, .. }) | PairKind::Slot(Guide { slider, point, .. }) => {
            Some((*slider, *point))
        }
        PairKind::Contact { .. } | PairKind::Cylinder { .. } | PairKind::Transmission(_) => None,
    }
}

// The mesh that may be meant by a pair that is not declared.

/// The mesh that is missing: of the only wheel that no transmission names, with the only planet.
pub(crate) fn missing_mesh(cx: &Context<'_>, name: &str) -> Option<String> {
    let named = |wheel: &str| {
        cx.doc.statements.iter().any(|s| match &s.node {
            Statement::Joint(joint) => {
                joint.ends.iter().any(|e| matches!(e, End::At(path) if path.head.node == wheel))
            }
            _ => false,
        })
    };
    let mut alone = cx.builder.mech.wheels.iter().filter(|w| !named(&w.name));
    let odd = alone.next().filter(|_| alone.next().is_none())?;
    let planet = |link: &str| {
        let shafts = cx.doc.statements.iter();
        shafts
            .into_iter()
            .any(|s| matches!(&s.node, Statement::Shaft(s) if s.name.node == link && s.on.is_some()))
    };
    let mut planets = cx
        .builder
        .mech
        .wheels
        .iter()
        .filter(|w| w.link != odd.link && planet(&cx.builder.mech.link(w.link).name));
    let with = planets.next().filter(|_| planets.next().is_none())?;
    Some(format!("`{0}` meshes with no wheel: add the line `mesh {name}: {0} - {1}`", odd.name, with.name))
}
