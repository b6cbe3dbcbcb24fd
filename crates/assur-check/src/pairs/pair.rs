//! Pairs between links.

use crate::expr::context::Context;
use crate::links::lookup::is_linkage_pair;
use crate::names::declared::Inside;
use crate::names::suggestion::{not_declared, wrong_kind};
use crate::pairs::prismatic::guide;
use crate::pairs::property::{Shared, phrase, read_own as read, shared, with_shared};
use crate::pairs::{contact, friction, weld};
use crate::statements::written::{end_text, line_of, write_one};
use assur_math::math::Vec2;
use assur_model::model::{Friction, GroupAssertion, LinkId, Pair, PairId, PairKind, Pin};
use assur_syntax::document::{End, Group, Joint, JointKind, Name, Path, Statement};
use assur_syntax::skeleton;
use assur_text::diagnostic::{Diagnosis, Help, Undeclared};
use assur_text::source::Span;

/// Enters all pairs of the linkage into the mechanism.
pub(crate) fn pairs(cx: &mut Context<'_>) {
    let doc = cx.doc;
    let shared = shared(cx);
    for statement in &doc.statements {
        let Statement::Joint(joint) = &statement.node else { continue };
        if !cx.is_own(&joint.name) {
            continue;
        }
        if !is_linkage_pair(joint.kind.node) {
            continue;
        }
        if let Some((kind, law, at_rest)) = pair(cx, joint, &shared) {
            let id = PairId::at(cx.builder.mech.pairs.len());
            cx.builder.hinges.enter(&kind, id);
            cx.builder.hinges.enter_guide(&kind, id);
            let (name, span) = (joint.name.node.clone(), joint.name.span);
            cx.names.pairs.entry(name.clone()).or_insert(id);
            let (friction, stated) = law.unzip();
            cx.builder.mech.pairs.push(Pair { name, span, kind, friction, bearing: None });
            cx.builder.mech.stated_friction.extend(stated.flatten().map(|stated| (id, stated)));
            cx.builder.mech.friction_at_rest.extend(at_rest.map(|friction| (id, friction)));
        }
    }
}

fn pair(
    cx: &mut Context<'_>,
    joint: &Joint,
    shared: &Shared,
) -> Option<(PairKind, Option<friction::Law>, Option<Friction>)> {
    let read = read(cx, joint);
    let ends = ends(cx, joint)?;
    let hinge = if joint.kind.node == JointKind::Revolute { Some(revolute(cx, joint, &ends)?) } else { None };
    let properties = read.and_then(|own| with_shared(cx, joint, own, shared));
    let kind = match joint.kind.node {
        JointKind::Revolute => hinge,
        JointKind::Prismatic | JointKind::Slot => guide(cx, joint, &ends, properties.as_deref()),
        JointKind::Contact => contact::contact(cx, joint, &ends, properties.as_deref()),
        JointKind::Weld => weld::weld(cx, joint, &ends, properties.as_deref()),
        _ => cylinder(cx, joint, &ends),
    };
    let friction = properties.map(|p| {
        let moving = friction::law(cx, joint, &p);
        (moving, friction::at_rest(cx, &p, moving.map(|(law, _)| law)))
    });
    let (moving, at_rest) = friction?;
    Some((kind?, moving, at_rest))
}

/// An end of a joint: a link and the name of a part of it.
pub(crate) struct Joined {
    pub link: LinkId,
    /// Its part, with the place where it is named; the pair's name where the part is not.
    pub part: Name,
    pub span: Span,
    /// Only the link is named.
    pub implied: bool,
}

/// The ends of a pair; `None` where a link is unknown, joined with itself, or where there are too many.
fn ends(cx: &mut Context<'_>, joint: &Joint) -> Option<Vec<Joined>> {
    let most = if matches!(joint.kind.node, JointKind::Revolute | JointKind::Weld) { usize::MAX } else { 2 };
    if joint.kind.node == JointKind::Weld {
        weld::no_shafts(cx, joint)?;
    }
    if let Some(third) = joint.ends.get(most) {
        let got = format!("{} of them", joint.ends.len());
        cx.error(
            Diagnosis::error(
                "mech::geometry::wrong_ends",
                format!("{} joins two links, not {got}", phrase(joint.kind.node)),
            )
            .label(third.span(), &got)
            .help("write one statement for each pair of two links"),
        );
        return None;
    }
    points_for_links(cx, joint)?;
    let joined = joint.ends.iter().map(|end| joined(cx, joint, end)).collect::<Vec<_>>();
    let joined = joined.into_iter().collect::<Option<Vec<_>>>()?;
    for (i, end) in joined.iter().enumerate() {
        if let Some(first) = joined[..i].iter().find(|e| e.link == end.link) {
            let help = other_link(cx, joint, end.link)
                .unwrap_or_else(|| "name another link at one of the two ends: a link is rigid".into());
            cx.error(joined_with_itself(
                help,
                joint.kind.node.word(),
                &joint.name.node,
                &cx.builder.mech.link(end.link).name,
                first.span,
                end.span,
            ));
            return None;
        }
    }
    Some(joined)
}

/// Reports points where links are due, once, with the line that has their links.
fn points_for_links(cx: &mut Context<'_>, joint: &Joint) -> Option<()> {
    let point = |end: &End| match end {
        End::At(path) if path.tail.is_none() => {
            let name = &path.head.node;
            let unknown = cx.find_link(name).is_none()
                && !cx.names.things.contains_key(name)
                && !cx.names.bad.contains(name);
            let owners = cx.names.bearers.get(name).filter(|_| unknown)?;
            Some((path.head.clone(), owners.clone()))
        }
        _ => None,
    };
    let found = joint.ends.iter().filter_map(point).collect::<Vec<_>>();
    let Some((first, owners)) = found.first() else { return Some(()) };
    let others = |end: &End| match end {
        End::At(path) if point(end).is_none() => cx.find_link(&path.head.node),
        _ => None,
    };
    let taken = joint.ends.iter().filter_map(others).collect::<Vec<_>>();
    let owner = |end: &End| {
        let (name, owners) = point(end)?;
        let mut free = owners.iter().filter(|link| !taken.contains(link));
        let only = free.next().filter(|_| free.next().is_none())?;
        Some(format!("{}.{}", cx.builder.mech.link(*only).name, name.node))
    };
    let known = joint.ends.iter().all(|end| point(end).is_none() || owner(end).is_some());
    let line = line_of(joint, |end| owner(end).unwrap_or_else(|| end_text(end)));
    let of = cx.spelled(owners).iter().map(|link| format!("`{link}`")).collect::<Vec<_>>().join(" and ");
    let help = if known {
        format!("write `{line}`")
    } else {
        format!("write its link before it: it is a point of {of}")
    };
    let error = wrong_kind(&first.node, &format!("a point of {of}"), "a link", first.span, None, Some(help));
    cx.error(error);
    None
}

/// The line of a hinge between a link that is named twice and the only other one that has the point of its name.
fn other_link(cx: &Context<'_>, joint: &Joint, link: LinkId) -> Option<String> {
    let name = &joint.name.node;
    let links = cx.names.inside.iter().zip(&cx.builder.mech.links).enumerate();
    let mut others = links.filter(|(i, (inside, _))| *i != link.index() && inside.points.contains_key(name));
    let (_, (_, other)) = others.next()?;
    if joint.kind.node != JointKind::Revolute || joint.ends.len() != 2 || others.next().is_some() {
        return None;
    }
    let line = line_of(joint, |end| {
        let first = end.span() == joint.ends[0].span();
        if first { end_text(end) } else { other.name.clone() }
    });
    Some(format!("`{}` has a point `{name}`: write `{line}`", other.name))
}

fn joined(cx: &mut Context<'_>, joint: &Joint, end: &End) -> Option<Joined> {
    let path = match end {
        End::At(path) => path,
        End::Over(name) | End::Under(name) => {
            cx.error(
                Diagnosis::error(
                    "mech::geometry::wrong_ends",
                    format!("{} joins links, not a pulley", phrase(joint.kind.node)),
                )
                .label(name.span, "a pulley")
                .help("`over` and `under` belong to a rope"),
            );
            return None;
        }
    };
    let link = cx.link(&path.head)?;
    let part = path.tail.as_ref().unwrap_or(&joint.name).clone();
    Some(Joined { link, part, span: path.span(), implied: path.tail.is_none() })
}

/// The point of an end.
pub(crate) fn point(cx: &mut Context<'_>, joint: &Joint, end: &Joined) -> Option<Pin> {
    if !end.implied || cx.kind_inside(end.link, &end.part.node).is_some() {
        not_on_line(cx, joint, end)?;
        not_of_its_name(cx, joint, end)?;
        let at = cx.point(end.link, &end.part)?;
        return Some(Pin { link: end.link, name: end.part.node.clone(), at });
    }
    nothing_to_join(cx, joint, end, "point");
    None
}

/// Reports a line at the end of a hinge.
fn not_on_line(cx: &mut Context<'_>, joint: &Joint, end: &Joined) -> Option<()> {
    let on_line =
        joint.kind.node == JointKind::Revolute && cx.kind_inside(end.link, &end.part.node) == Some("line");
    let lines = if on_line { cx.lines_meant(joint, JointKind::Prismatic) } else { Vec::new() };
    let Some(help) = write_one(&lines) else { return Some(()) };
    let got = format!("a point and the line `{}`", end.part.node);
    cx.error(
        Diagnosis::error(
            "mech::geometry::wrong_ends",
            format!("{} joins two points, not {got}", phrase(joint.kind.node)),
        )
        .label(end.span, &got)
        .help(format!("{help}: a point on a line")),
    );
    None
}

/// Reports a point that a link does not have, where it has one of the pair's name.
fn not_of_its_name(cx: &mut Context<'_>, joint: &Joint, end: &Joined) -> Option<()> {
    let (name, part) = (&joint.name.node, &end.part);
    let inside = &cx.names.inside[end.link.index()];
    let is_known = cx.kind_inside(end.link, &part.node).is_some() || inside.bad.contains(&part.node);
    if is_known || !inside.points.contains_key(name) || cx.names.bad.contains(&part.node) {
        return Some(());
    }
    let owner = cx.builder.mech.link(end.link).name.clone();
    let words = format!("the pair is called as the point `{name}` of `{owner}`: write `{owner}.{name}`");
    let help = Some(Help::write(part.span, std::slice::from_ref(name)).in_words(words));
    cx.error(not_declared("point", &part.node, Some(owner), part.span, help));
    None
}

/// Reports that a link named alone has nothing of the pair's name.
pub(crate) fn nothing_to_join(cx: &mut Context<'_>, joint: &Joint, end: &Joined, what: &str) {
    let name = &end.part.node;
    let inside = &cx.names.inside[end.link.index()];
    if inside.bad.contains(name) || cx.names.bad.contains(name) {
        return;
    }
    if !cx.problems.reported.insert(("end of a pair", joint.name.node.clone())) {
        return; // one name is wrong, at both ends
    }
    let inside = &cx.names.inside[end.link.index()];
    let link = cx.builder.mech.link(end.link).name.clone();
    let lookalike = inside.points.keys().find(|p| skeleton(p) == skeleton(name)).cloned();
    let elsewhere = (what == "point")
        .then(|| missing_on_ground(cx, joint, end).or_else(|| suggested_point(cx, joint)))
        .flatten();
    let all = inside.points.keys().map(|p| format!("`{link}.{p}`")).collect::<Vec<_>>();
    let choices = match all.len() {
        0 => format!("give `{link}` the point: `{}`", with_point(cx, &link, name)),
        1 => format!("write {}, or give `{link}` a point `{name} (0, 0)`", all[0]),
        n => format!("name the point: {}", all[..n.min(8)].join(" or ")),
    };
    let help = match &lookalike {
        Some(point) => {
            let how =
                crate::names::lookalikes::difference(name, point, "here", &format!("in `{link}.{point}`"));
            format!("name the pair `{point}`: {how}")
        }
        None => elsewhere
            .or_else(|| guided(cx, joint))
            .or_else(|| write_one(&cx.lines_meant(joint, joint.kind.node)))
            .unwrap_or(choices),
    };
    let name = name.clone();
    cx.problems.reported.insert(("point", format!("{link}.{name}")));
    // what is not found because of this is no second mistake
    cx.names.bad.extend(lookalike);
    let diagnosis =
        Diagnosis::error("mech::geometry::nothing_to_join", format!("`{link}` has no {what} `{name}`"))
            .primary(end.span, format!("the {what} `{name}` of `{link}` is joined here"))
            .label(joint.name.span, format!("the name of the pair is also the name of the {what}s it joins"))
            .help(help);
    let missing = || Undeclared { kind: "point", name, owner: Some(link), at: joint.name.span.to(end.span) };
    cx.error(if what == "point" { diagnosis.undeclared(missing()) } else { diagnosis });
}

/// The prismatic pair that may be meant where a hinge names a link with a line that no pair uses.
fn guided(cx: &Context<'_>, joint: &Joint) -> Option<String> {
    let unused = |line: &str| {
        !cx.doc.statements.iter().any(|s| match &s.node {
            Statement::Joint(other) => other.ends.iter().any(|end| match end {
                End::At(path) => path.tail.as_ref().is_some_and(|tail| tail.node == line),
                End::Over(_) | End::Under(_) => false,
            }),
            _ => false,
        })
    };
    let [End::At(a), End::At(b)] = joint.ends.as_slice() else { return None };
    let lines = [a, b].into_iter().filter_map(|path| cx.find_link(&path.head.node));
    let mut lines = lines.flat_map(|link| cx.names.inside[link.index()].lines.keys());
    if joint.kind.node != JointKind::Revolute || !lines.any(|line| unused(line)) {
        return None;
    }
    write_one(&cx.lines_meant(joint, JointKind::Prismatic))
}

/// The point that the ground lacks, where the other link has it.
fn missing_on_ground(cx: &Context<'_>, joint: &Joint, end: &Joined) -> Option<String> {
    let name = &joint.name.node;
    let other = |end: &End| match end {
        End::At(path) => cx.find_link(&path.head.node),
        End::Over(_) | End::Under(_) => None,
    };
    let has = |link: LinkId| cx.names.inside[link.index()].points.contains_key(name);
    let others = joint.ends.iter().filter_map(other).any(|link| link != LinkId::GROUND && has(link));
    (end.link == LinkId::GROUND && others)
        .then(|| format!("add `{name} (100 mm, 0)`, with its own place, to `ground {{ … }}`"))
}

/// A point at the origin of a link: the whole line where nothing else is in it.
fn with_point(cx: &Context<'_>, link: &str, point: &str) -> String {
    let empty = cx.doc.statements.iter().find_map(|s| match &s.node {
        Statement::Link(l) if l.name.node == link && l.bar.is_none() && l.body.is_empty() => Some(l),
        _ => None,
    });
    let Some(empty) = empty else { return format!("{point} (0, 0)") };
    let number = empty.number.as_ref().map_or_else(String::new, |n| format!("{} ", n.node));
    format!("link {number}{link} {{ {point} (0, 0) }}")
}

/// The statement that may be meant where a hinge joins links that lack the point of its name.
fn suggested_point(cx: &Context<'_>, joint: &Joint) -> Option<String> {
    let name = &joint.name.node;
    let has = |inside: &Inside| inside.points.contains_key(name);
    let links = cx.names.inside.iter().zip(&cx.builder.mech.links).filter(|(inside, _)| has(inside));
    let links = links.map(|(_, link)| link.name.as_str()).collect::<Vec<_>>();
    if let [_, _, ..] = links[..] {
        let line = format!("{} {name}: {}", joint.kind.node.word(), links.join(" - "));
        let links = links.iter().map(|l| format!("`{l}`")).collect::<Vec<_>>().join(" and ");
        return Some(format!("the point `{name}` is on {links}: write `{line}`"));
    }
    // another pair of the same links may be meant
    let own = ends_named(joint)?;
    let other = cx.doc.statements.iter().find_map(|s| match &s.node {
        Statement::Joint(other)
            if other.name.span != joint.name.span && other.kind.node == joint.kind.node =>
        {
            (ends_named(other)? == own).then_some(other)
        }
        _ => None,
    })?;
    let (other, kind) = (&other.name.node, other.kind.node.word());
    let braces = if joint.properties.is_empty() { "" } else { " { … }" };
    let ends = own.join(" - ");
    Some(format!(
        "`{other}` joins these links already: leave this line out, and write there what is in its braces, as in \
         `{kind} {other}: {ends}{braces}`"
    ))
}

/// The links of a joint whose ends name links alone.
fn ends_named(joint: &Joint) -> Option<Vec<&str>> {
    let ends = joint.ends.iter().map(|end| match end {
        End::At(Path { head, tail: None }) => Some(head.node.as_str()),
        _ => None,
    });
    ends.collect()
}

/// The points of all ends.
pub(crate) fn pins(cx: &mut Context<'_>, joint: &Joint, ends: &[Joined]) -> Option<Vec<Pin>> {
    let pins = ends.iter().map(|end| point(cx, joint, end)).collect::<Vec<_>>();
    pins.into_iter().collect()
}

fn revolute(cx: &mut Context<'_>, joint: &Joint, ends: &[Joined]) -> Option<PairKind> {
    let pins = pins(cx, joint, ends)?;
    joined_before(cx, joint, &pins)?;
    Some(PairKind::Revolute(pins))
}

/// Two hinges between the same points of the same links are one too many.
fn joined_before(cx: &mut Context<'_>, joint: &Joint, pins: &[Pin]) -> Option<()> {
    let same = |a: &Pin, b: &Pin| a.link == b.link && a.at == b.at;
    for id in cx.builder.hinges.near(pins) {
        let pair = cx.builder.mech.pair(id);
        let PairKind::Revolute(others) = &pair.kind else { continue };
        let again = pins.iter().filter(|p| others.iter().any(|o| same(o, p))).collect::<Vec<_>>();
        if let [a, b, ..] = again[..] {
            let spelled = |pin: &Pin| format!("{}.{}", cx.builder.mech.link(pin.link).name, pin.name);
            // the pin of more links joins others too
            let lesser = if pins.len() > others.len() { &pair.name } else { &joint.name.node };
            let error = Diagnosis::error(
                "mech::geometry::joined_twice",
                format!("`{}` and `{}` are joined twice", spelled(a), spelled(b)),
            )
            .primary(joint.name.span, "joined again here")
            .label(pair.span, "already joined here")
            .help(format!(
                "remove `{}`, or name other points: the two hinges coincide, so their reactions cannot \
                 be separated",
                lesser
            ));
            cx.error(error);
            return None;
        }
    }
    Some(())
}

/// A cylinder adds two links of its own, `NAME.barrel` and `NAME.rod`.
fn cylinder(cx: &mut Context<'_>, joint: &Joint, ends: &[Joined]) -> Option<PairKind> {
    let [from, to] = ends else { return None };
    let (from, to) = (point(cx, joint, from), point(cx, joint, to));
    let (from, to) = (from?, to?);
    let mut link = |part: &str| {
        let name = format!("{}.{part}", joint.name.node);
        cx.names.add_link(&mut cx.builder.mech, name, None, joint.name.span)
    };
    let (barrel, rod) = (link("barrel"), link("rod"));
    Some(PairKind::Cylinder { barrel, rod, from, to })
}

/// Enters the asserted groups.
pub(crate) fn groups(cx: &mut Context<'_>) {
    let doc = cx.doc;
    for statement in &doc.statements {
        if let Statement::Group(group) = &statement.node
            && cx.is_own(&group.name)
            && let Some(links) = group_links(cx, group)
        {
            let name = group.name.node.clone();
            cx.builder.mech.groups.push(GroupAssertion { name, span: statement.span, links });
        }
    }
}

fn group_links(cx: &mut Context<'_>, group: &Group) -> Option<Vec<LinkId>> {
    let mut links = Some(Vec::new());
    for name in &group.links {
        let link = cx.link(name);
        let message = match link {
            Some(LinkId::GROUND) => Some("the ground cannot be part of a structural group".to_owned()),
            Some(link) if links.iter().flatten().any(|l| *l == link) => {
                Some(format!("`{}` is named twice in group `{}`", name.node, group.name.node))
            }
            _ => None,
        };
        let fine = message.is_none();
        if let Some(message) = message {
            cx.error(
                Diagnosis::error("mech::geometry::no_group", message)
                    .label(name.span, "not a link of a group")
                    .help("name different moving links"),
            );
        }
        links = links.zip(link).filter(|_| fine).map(|(mut links, link)| {
            links.push(link);
            links
        });
    }
    links
}

/// `LINK.POINT` where a spring or a drive is fastened.
pub(crate) fn link_point(cx: &mut Context<'_>, path: &Path, what: &str) -> Option<(LinkId, Vec2)> {
    let link = cx.link(&path.head)?;
    if let Some(point) = &path.tail {
        return cx.point(link, point).map(|at| (link, at));
    }
    let points = cx.names.inside[link.index()].points.keys();
    let choices = points.take(8).map(|p| format!("`{}.{p}`", path.head.node)).collect::<Vec<_>>();
    let help = (!choices.is_empty()).then(|| format!("write {}", choices.join(" or ")));
    cx.error(wrong_kind(&path.head.node, "a link", &format!("a point for {what}"), path.span(), None, help));
    None
}

/// One of the ends is twice the same link.
pub fn joined_with_itself(
    help: impl Into<Help>,
    what: &str,
    name: &str,
    link: &str,
    first: Span,
    second: Span,
) -> Diagnosis {
    Diagnosis::error(
        "mech::geometry::joined_with_itself",
        format!("{what} `{name}` joins `{link}` with itself"),
    )
    .label(first, format!("`{link}` here"))
    .primary(second, "and here")
    .help(help)
}
