//! The thing that fits where another kind of thing is named: the only one, or the one that has most to do with it.

use crate::expr::context::Context;
use crate::names::declared::ThingKind;
use crate::statements::written::{end_text, line_of, write_one};
use assur_syntax::document::{End, Joint, JointKind, Member, Name, Statement};

/// More things than these are not listed.
const MOST: usize = 6;
/// More lines than these are not offered.
const LINES: usize = 3;

impl Context<'_> {
    /// What to write in place of a name of another kind.
    pub(crate) fn fitting(
        &self,
        name: &Name,
        kind: &str,
        fits: &impl Fn(ThingKind) -> bool,
    ) -> Option<String> {
        if let Some(joint) = self.joint_around(name) {
            return write_one(&self.joints_meant(joint, &name.node, fits));
        }
        let (best, only) = self.best(&name.node, fits);
        match best.as_slice() {
            [] => None,
            [one] if only => Some(format!("write `{one}`: the only {kind}")),
            [one] => Some(format!("write `{one}`: the {kind} that belongs to it")),
            [..] if best.len() <= MOST => {
                let names = best.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>();
                Some(format!("the {kind}s are {}", names.join(", ")))
            }
            _ => None,
        }
    }

    /// The things that fit and share most with a thing, and whether they are all that fit.
    fn best(&self, name: &str, fits: &impl Fn(ThingKind) -> bool) -> (Vec<&str>, bool) {
        let all = self.names.things.iter().filter(|(other, d)| fits(d.what) && other.as_str() != name);
        let all = all.map(|(other, _)| other.as_str()).collect::<Vec<_>>();
        let of_name = self.parts_of(name);
        let shared = |other: &&str| self.parts_of(other).iter().filter(|part| of_name.contains(part)).count();
        let most = all.iter().map(shared).max().unwrap_or(0);
        let best = all.iter().copied().filter(|other| shared(other) == most).collect::<Vec<_>>();
        let only = best.len() == all.len();
        (best, only)
    }

    /// The names that belong to a thing: itself, what it joins, and what is in its braces.
    fn parts_of<'n>(&'n self, name: &'n str) -> Vec<&'n str> {
        let mut parts = vec![name];
        for statement in &self.doc.statements {
            match &statement.node {
                Statement::Joint(joint) if joint.name.node == name => {
                    parts.extend(joint.ends.iter().map(head));
                }
                Statement::Group(group) if group.name.node == name => {
                    parts.extend(group.links.iter().map(|link| link.node.as_str()));
                }
                Statement::Link(link) if link.name.node == name => parts.extend(members(&link.body)),
                Statement::Shaft(shaft) if shaft.name.node == name => parts.extend(members(&shaft.body)),
                Statement::Shaft(shaft) if members(&shaft.body).any(|wheel| wheel == name) => {
                    parts.push(&shaft.name.node);
                }
                _ => {}
            }
        }
        parts
    }

    /// The joint in which a name is an end.
    fn joint_around(&self, name: &Name) -> Option<&Joint> {
        self.doc.statements.iter().find_map(|s| match &s.node {
            Statement::Joint(joint) => {
                let is_end = |end: &End| matches!(end, End::At(path) if path.head.span == name.span);
                joint.ends.iter().any(is_end).then_some(joint)
            }
            _ => None,
        })
    }

    /// Whether an earlier end of the joint around a name is wrong too: its help has the whole line.
    pub(crate) fn follows_wrong_end(&self, name: &Name, fits: &impl Fn(ThingKind) -> bool) -> bool {
        let Some(joint) = self.joint_around(name).filter(|joint| alike(joint)) else { return false };
        let before = joint.ends.iter().take_while(|end| end.span().start < name.span.start);
        let wrong = |end: &End| self.names.things.get(head(end)).is_some_and(|d| !fits(d.what));
        before.into_iter().any(wrong)
    }

    /// The lines of a joint with what fits at each end.
    fn joints_meant(&self, joint: &Joint, name: &str, fits: &impl Fn(ThingKind) -> bool) -> Vec<String> {
        let mut choices: Vec<Vec<String>> = vec![Vec::new()];
        for end in &joint.ends {
            let other = !alike(joint) && head(end) != name;
            let ok = other
                || self.names.things.get(head(end)).is_none_or(|d| fits(d.what))
                || head(end) == "ground";
            let names = if ok { vec![end_text(end)] } else { self.ends_for(head(end), fits) };
            let with = |before: &Vec<String>| {
                let one = |name: &String| before.iter().cloned().chain([name.clone()]).collect::<Vec<_>>();
                names.iter().map(one).collect::<Vec<_>>()
            };
            choices = choices.iter().flat_map(with).collect();
        }
        if choices.len() > LINES {
            return Vec::new();
        }
        let line = |names: &Vec<String>| {
            let at = |end: &End| joint.ends.iter().position(|other| other.span() == end.span());
            line_of(joint, |end| at(end).and_then(|i| names.get(i)).cloned().unwrap_or_default())
        };
        choices.iter().map(line).collect()
    }

    fn ends_for(&self, name: &str, fits: &impl Fn(ThingKind) -> bool) -> Vec<String> {
        self.best(name, fits).0.into_iter().map(str::to_owned).collect()
    }

    /// The shaft of that name as the slider that it may be: `slider nut { mass 1500 kg }`.
    pub(crate) fn as_slider(&self, name: &str) -> Option<String> {
        let shaft = self.doc.statements.iter().find_map(|s| match &s.node {
            Statement::Shaft(shaft) if shaft.name.node == name => Some(shaft),
            _ => None,
        })?;
        let mass = shaft.body.iter().all(|m| matches!(m.node, Member::Mass(_) | Member::Weight(_)));
        (mass && shaft.on.is_none())
            .then(|| format!("a nut slides: declare it as `slider {name}` in place of `shaft {name}`"))
    }
}

/// Whether both ends are things of the same kinds.
fn alike(joint: &Joint) -> bool {
    use JointKind::{Rack, Rope, Screw, Worm};
    !matches!(joint.kind.node, Rack | Rope | Screw | Worm)
}

/// What an end names first.
fn head(end: &End) -> &str {
    match end {
        End::At(path) => &path.head.node,
        End::Over(name) | End::Under(name) => &name.node,
    }
}

/// The wheels and cams in the braces of a link or a shaft.
fn members(body: &[assur_text::source::Spanned<Member>]) -> impl Iterator<Item = &str> {
    body.iter().filter_map(|member| match &member.node {
        Member::Wheel(wheel) => Some(wheel.name.node.as_str()),
        Member::Profile(profile) => Some(profile.of.node.as_str()),
        _ => None,
    })
}
