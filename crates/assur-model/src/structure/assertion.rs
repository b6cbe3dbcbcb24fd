//! `group NAME: links` — asserted groups against those found.

use super::count::Structure;
use super::group::{Group, GroupKind};
use super::joint::{BodyId, BodyOrigin};
use super::roller::{groups, label, whole, with_lines};
use crate::model::{GroupAssertion, LinkId, Mechanism, PairId, PairKind};
use assur_text::diagnostic::Diagnosis;

/// Errors and warnings; groups that are asserted get their names.
pub(super) fn check(mechanism: &Mechanism, structure: &mut Structure) -> (Vec<Diagnosis>, Vec<Diagnosis>) {
    let (mut errors, mut warnings) = (Vec::new(), Vec::new());
    for assertion in &mechanism.groups {
        let assertion = &of_bodies(structure, assertion);
        let pairs = Pairs::of(mechanism, structure, assertion);
        let (name, span) = (assertion.name.clone(), assertion.span);
        if pairs.rest(assertion.links.len()) != 0 {
            errors.push(not_a_group(mechanism, structure, assertion, &pairs));
            continue;
        }
        let inside: Vec<usize> = found(mechanism, structure, assertion)
            .filter(|&i| {
                links(mechanism, structure, &structure.motion[i]).all(|l| assertion.links.contains(&l))
            })
            .collect();
        let covered = inside.iter().flat_map(|&i| links(mechanism, structure, &structure.motion[i])).count();
        match inside.as_slice() {
            [one] if covered == assertion.links.len() => {
                structure.motion[*one].name = Some(assertion.name.clone());
            }
            [_, ..] if covered == assertion.links.len() => {
                let sentence = "name each group by itself: a structural group cannot be split";
                let help = with_lines(sentence, &lines(mechanism, structure, assertion));
                warnings.push(
                    Diagnosis::warning(
                        "mech::determinacy::contains_smaller",
                        format!("`{name}` satisfies the count of a group, but consists of smaller groups"),
                    )
                    .label(span, "asserted here")
                    .fixes(groups(&help, span))
                    .help(help),
                );
            }
            _ => {
                let help = instead(mechanism, structure, assertion);
                errors.push(
                    Diagnosis::error(
                        "mech::determinacy::part_of_larger",
                        format!(
                            "`{name}` satisfies the count of a group, but its links cannot be solved \
                             by themselves"
                        ),
                    )
                    .label(span, "asserted here")
                    .fixes(groups(&help, span))
                    .help(help),
                );
            }
        }
    }
    (errors, warnings)
}

/// An assertion that names a body of welded links by any of them.
fn of_bodies(structure: &Structure, assertion: &GroupAssertion) -> GroupAssertion {
    let mut links: Vec<LinkId> = Vec::new();
    for link in assertion.links.iter().map(|link| own(structure, *link)) {
        if !links.contains(&link) {
            links.push(link);
        }
    }
    GroupAssertion { links, ..assertion.clone() }
}

/// The link whose frame the body of a link has.
fn own(structure: &Structure, link: LinkId) -> LinkId {
    LinkId::at(structure.replaced.body_of(link).0)
}

/// The links of a group that have a name of their own: barrel and rod of a cylinder have none.
fn links<'a>(
    mechanism: &'a Mechanism,
    structure: &'a Structure,
    group: &'a Group,
) -> impl Iterator<Item = LinkId> + 'a {
    let bodies = group.bodies.iter().filter_map(|b| match structure.replaced.bodies[b.0].origin {
        BodyOrigin::Link(id) => Some(id),
        BodyOrigin::Imaginary(_) => None,
    });
    bodies.filter(|&link| {
        !mechanism.pairs.iter().any(
            |p| matches!(&p.kind, PairKind::Cylinder { barrel, rod, .. } if *barrel == link || *rod == link),
        )
    })
}

/// Groups found that hold a link of the assertion.
fn found<'a>(
    mechanism: &'a Mechanism,
    structure: &'a Structure,
    assertion: &'a GroupAssertion,
) -> impl Iterator<Item = usize> + 'a {
    let groups = structure.motion.iter().enumerate();
    groups
        .filter(|(_, g)| links(mechanism, structure, g).any(|l| assertion.links.contains(&l)))
        .map(|(i, _)| i)
}

/// The groups found that hold links of the assertion, as lines to paste. A driven link is no group.
fn lines(mechanism: &Mechanism, structure: &Structure, assertion: &GroupAssertion) -> Vec<String> {
    let groups = found(mechanism, structure, assertion).map(|i| &structure.motion[i]);
    let groups: Vec<&Group> = groups.filter(|g| g.kind != GroupKind::Driven).collect();
    let line = |(i, group): (usize, &&Group)| {
        let names: Vec<&str> =
            links(mechanism, structure, group).map(|l| mechanism.link(l).name.as_str()).collect();
        let number = if groups.len() > 1 { format!("_{}", i + 1) } else { String::new() };
        format!("group {}{number}: {}", assertion.name, names.join(", "))
    };
    groups.iter().enumerate().map(line).collect()
}

fn not_a_group(
    mechanism: &Mechanism,
    structure: &Structure,
    assertion: &GroupAssertion,
    pairs: &Pairs,
) -> Diagnosis {
    let mut labels = vec![label("asserted here", assertion.span)];
    let mut listed = pairs.lower.clone();
    listed.dedup();
    labels.extend(listed.iter().map(|p| label("lower pair of these links", mechanism.pair(*p).span)));
    labels.extend(pairs.higher.iter().map(|p| label("higher pair of these links", mechanism.pair(*p).span)));
    {
        let help = instead(mechanism, structure, assertion);
        Diagnosis::error(
            "mech::determinacy::not_a_group",
            format!(
                "`{}` is not a structural group: {}, not 0",
                assertion.name,
                pairs.formula(assertion.links.len())
            ),
        )
        .labels(labels)
        .fixes(groups(&help, assertion.span))
        .help(help)
    }
}

/// The groups found with the links of the assertion.
fn instead(mechanism: &Mechanism, structure: &Structure, assertion: &GroupAssertion) -> String {
    let driven: Vec<String> = found(mechanism, structure, assertion)
        .filter(|&i| structure.motion[i].kind == GroupKind::Driven)
        .flat_map(|i| links(mechanism, structure, &structure.motion[i]))
        .map(|l| format!("`{}`", mechanism.link(l).name))
        .collect();
    let is = if driven.len() == 1 { "is driven and belongs" } else { "are driven and belong" };
    let lines = lines(mechanism, structure, assertion);
    let sentence = match (driven.is_empty(), lines.is_empty()) {
        (true, true) => "leave the statement out: groups are found without it".to_owned(),
        (true, false) => "write the groups that were found with these links".to_owned(),
        (false, true) => format!("leave the statement out: {} {is} to no group", driven.join(", ")),
        (false, false) => format!("write the groups that were found; {} {is} to no group", driven.join(", ")),
    };
    with_lines(&sentence, &lines)
}

/// Lower pairs (one entry per pair they count for) and higher pairs of the named links, without those that join them to
/// links solved later: such a pair belongs to the later group.
struct Pairs {
    lower: Vec<PairId>,
    higher: Vec<PairId>,
    /// Rollers among the links: each turns freely, and that counts for nothing.
    passive: usize,
    /// All of them are prismatic: no link turns, and 2n = P_L counts.
    prismatic: bool,
}

impl Pairs {
    fn of(mechanism: &Mechanism, structure: &Structure, assertion: &GroupAssertion) -> Self {
        let rank = |link: LinkId| {
            let body = BodyId(link.index());
            structure.motion.iter().position(|g| g.bodies.contains(&body))
        };
        let last = assertion.links.iter().map(|&l| rank(l)).max().flatten();
        let passive = assertion.links.iter().filter(|l| structure.passive.contains(l)).count();
        let mut this = Self { lower: Vec::new(), higher: Vec::new(), passive, prismatic: true };
        for (i, pair) in mechanism.pairs.iter().enumerate() {
            let mut links: Vec<LinkId> = pair.kind.links().iter().map(|link| own(structure, *link)).collect();
            if !links.iter().any(|l| assertion.links.contains(l)) {
                continue;
            }
            links.retain(|&l| rank(l) <= last);
            let inside = links.iter().filter(|l| assertion.links.contains(l)).count();
            if inside == 0 || links.len() < 2 {
                continue;
            }
            let outside = links.len() - inside;
            let id = PairId::at(i);
            match &pair.kind {
                // of a pin, the links of the group turn on one carrier: outside where there is one
                PairKind::Revolute(_) => {
                    let count = if outside > 0 { inside } else { inside - 1 };
                    this.lower.extend(std::iter::repeat_n(id, count));
                }
                // two links with three lower pairs: they count for nothing
                PairKind::Cylinder { .. } | PairKind::Weld { .. } => {}
                PairKind::Prismatic(_) => this.lower.push(id),
                PairKind::Slot(_) | PairKind::Contact { .. } => this.higher.push(id),
                PairKind::Transmission(t) => this.higher.extend(std::iter::repeat_n(id, t.laws.len())),
            }
            this.prismatic &= matches!(pair.kind, PairKind::Prismatic(_) | PairKind::Weld { .. });
        }
        this
    }

    /// What is left of the freedoms of n links.
    fn rest(&self, n: usize) -> i64 {
        let signed = |x: usize| i64::try_from(x).unwrap_or(i64::MAX);
        if self.prismatic {
            return 2 * signed(n) - signed(self.lower.len());
        }
        3 * signed(n) - 2 * signed(self.lower.len()) - signed(self.higher.len()) - signed(self.passive)
    }

    fn formula(&self, n: usize) -> String {
        let (lower, higher, rest) = (self.lower.len(), self.higher.len(), whole(self.rest(n)));
        if self.prismatic {
            return format!("with prismatic pairs alone 2n − P_L = 2·{n} − {lower} = {rest}");
        }
        let passive = if self.passive > 0 { format!(" − {} passive", self.passive) } else { String::new() };
        if higher == 0 {
            return format!("3n − 2P_L = 3·{n} − 2·{lower}{passive} = {rest}");
        }
        format!("3n − 2P_L − P_H = 3·{n} − 2·{lower} − {higher}{passive} = {rest}")
    }
}
