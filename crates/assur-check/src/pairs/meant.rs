//! The line that may be meant where the ends of a pair do not name what it joins.

use crate::expr::context::Context;
use crate::names::declared::Inside;
use crate::statements::written::braces;
use assur_model::model::LinkId;
use assur_syntax::document::{Body, End, Joint, JointKind, Member, Path, Statement};
use assur_text::source::Span;

/// More choices than these say nothing.
const MOST: usize = 3;

impl Context<'_> {
    /// The braces of a link as written.
    fn body(&self, link: LinkId) -> Option<&Body> {
        let name = &self.builder.mech.link(link).name;
        self.doc.statements.iter().find_map(|s| match &s.node {
            Statement::Ground(g) if link == LinkId::GROUND => Some(&g.body),
            Statement::Link(l) if l.name.node == *name => Some(&l.body),
            _ => None,
        })
    }

    /// The points of a link where its masses sit.
    fn mass_points(&self, link: LinkId) -> impl Iterator<Item = &str> {
        self.body(link).into_iter().flatten().filter_map(|m| match &m.node {
            Member::Mass(at) | Member::Weight(at) => at.at.as_ref().map(|n| n.node.as_str()),
            _ => None,
        })
    }

    /// Whether a pair, other than that with its name at `but`, names a part of a link.
    fn in_pair(&self, link: LinkId, part: &str, but: Option<Span>) -> bool {
        let owner = &self.builder.mech.link(link).name;
        self.doc.statements.iter().any(|s| match &s.node {
            Statement::Joint(joint) if Some(joint.name.span) != but => {
                joint.ends.iter().any(|end| match end {
                    End::At(path) => {
                        path.head.node == *owner && path.tail.as_ref().unwrap_or(&joint.name).node == part
                    }
                    _ => false,
                })
            }
            _ => false,
        })
    }

    /// The points of a link that no pair but that at `but` names and where no mass sits.
    pub(crate) fn free_points(&self, link: LinkId, but: Option<Span>) -> Vec<&str> {
        let Some(inside) = self.names.inside.get(link.index()) else { return Vec::new() };
        let free = |p: &&str| !self.mass_points(link).any(|at| at == *p) && !self.in_pair(link, p, but);
        inside.points.keys().map(String::as_str).filter(free).collect()
    }

    /// The point of a link that a load or a mass without a place may be meant for: one that nothing else uses, else the
    /// mass centre, else the first.
    pub(crate) fn point_meant(&self, link: LinkId) -> Option<&str> {
        let first = || self.names.inside.get(link.index())?.points.keys().next().map(String::as_str);
        self.free_points(link, None).first().copied().or_else(|| self.mass_points(link).next()).or_else(first)
    }

    /// The lines that a pair of this kind between the links of `joint` may be: each end with a part that fits. Empty
    /// where there are too many.
    pub(crate) fn lines_meant(&self, joint: &Joint, kind: JointKind) -> Vec<String> {
        let [End::At(a), End::At(b)] = joint.ends.as_slice() else { return Vec::new() };
        let (Some(first), Some(second)) = (self.end(joint, a), self.end(joint, b)) else { return Vec::new() };
        if first.link == second.link {
            return Vec::new();
        }
        let both = |a: Vec<String>, b: &[String]| {
            a.iter().flat_map(|a| b.iter().map(move |b| format!("{a} - {b}"))).collect::<Vec<_>>()
        };
        let ends = match kind {
            JointKind::Prismatic | JointKind::Slot => {
                let mut ends = both(first.points(), &second.lines());
                ends.extend(both(first.lines(), &second.points()));
                ends
            }
            JointKind::Contact => {
                let mut ends = both(first.circles(), &second.circles());
                ends.extend(both(first.circles(), &second.flat()));
                ends.extend(both(first.flat(), &second.circles()));
                ends
            }
            JointKind::Revolute | JointKind::Cylinder => both(first.points(), &second.points()),
            _ => Vec::new(),
        };
        if ends.len() > MOST {
            return Vec::new();
        }
        let line =
            |ends| format!("{} {}: {ends}{}", kind.word(), joint.name.node, braces(&joint.properties, &[]));
        ends.into_iter().map(line).collect()
    }

    fn end<'e>(&'e self, joint: &'e Joint, path: &'e Path) -> Option<MeantEnd<'e>> {
        let link = self.find_link(&path.head.node)?;
        let inside = self.names.inside.get(link.index())?;
        Some(MeantEnd { cx: self, joint, path, link, inside })
    }
}

/// An end of a pair, with what its link has.
struct MeantEnd<'a> {
    cx: &'a Context<'a>,
    joint: &'a Joint,
    path: &'a Path,
    link: LinkId,
    inside: &'a Inside,
}

impl MeantEnd<'_> {
    /// The part that is named, where the link has it.
    fn named(&self, all: impl Fn(&str) -> bool) -> Option<&str> {
        let part = self.path.tail.as_ref().unwrap_or(&self.joint.name).node.as_str();
        all(part).then_some(part)
    }

    fn spelled(&self, part: &str) -> String {
        if self.path.tail.is_none() && part == self.joint.name.node {
            return self.path.head.node.clone();
        }
        format!("{}.{part}", self.path.head.node)
    }

    fn points(&self) -> Vec<String> {
        let points = &self.inside.points;
        if let Some(part) = self.named(|p| points.contains_key(p)) {
            return vec![self.spelled(part)];
        }
        match points.keys().next() {
            Some(only) if points.len() == 1 => vec![self.spelled(only)],
            _ => {
                let free = self.cx.free_points(self.link, Some(self.joint.name.span));
                free.into_iter().map(|p| self.spelled(p)).collect()
            }
        }
    }

    fn lines(&self) -> Vec<String> {
        let lines = &self.inside.lines;
        if let Some(part) = self.named(|p| lines.contains_key(p)) {
            return vec![self.spelled(part)];
        }
        lines.keys().map(|l| self.spelled(l)).collect()
    }

    fn circles(&self) -> Vec<String> {
        let circles = &self.inside.circles;
        if let Some(part) = self.named(|p| circles.contains_key(p)) {
            return vec![self.spelled(part)];
        }
        circles.keys().map(|c| self.spelled(c)).collect()
    }

    /// What a circle may touch beside another circle: lines, or else points.
    fn flat(&self) -> Vec<String> {
        let lines = self.lines();
        if lines.is_empty() && self.inside.circles.is_empty() { self.points() } else { lines }
    }
}
