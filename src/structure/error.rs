//! What can be wrong with a structure, said with the count and the pairs it concerns.

use miette::{Diagnostic, LabeledSpan};
use thiserror::Error;

use super::count::Count;
use super::decompose::{Defect, Part};
use super::effort::{Effort, EffortSource};
use super::joint::{BodyOrigin, JointId, JointKind, Replaced};
use super::{BodyId, Structure};
use crate::model::{Drive, GroupAssertion, Mechanism, PairId};
use crate::source::Span;

/// A defect of the structure.
#[derive(Clone, Debug, Error, Diagnostic)]
pub enum StructureError {
    /// A link is joined to nothing.
    #[error("link `{name}` is joined to nothing")]
    #[diagnostic(
        code(mech::determinacy::floating_link),
        help("join it with a pair, as in `revolute A: ground - {name}`, or remove it")
    )]
    FloatingLink {
        /// Its name.
        name: String,
        /// Its place.
        #[label("no pair names this link")]
        span: miette::SourceSpan,
    },
    /// A link driven at a point is joined elsewhere too.
    #[error(
        "`{drive}` moves only one point of its link, but pair `{pair}` joins the link elsewhere: its rotation is not known"
    )]
    #[diagnostic(
        code(mech::determinacy::outer_link),
        help("join an outer link at its driven point only, or drive it as an ordinary link")
    )]
    OuterLink {
        /// The drive.
        drive: String,
        /// The pair.
        pair: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// More mobility than drives.
    #[error("the mechanism is underconstrained: mobility F = {formula}, and {drives} {drives_are} declared")]
    #[diagnostic(code(mech::determinacy::underconstrained))]
    Underconstrained {
        /// The count in figures.
        formula: String,
        /// Number of drives.
        drives: usize,
        /// `drive is` or `drives are`.
        drives_are: &'static str,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// Fewer freedoms than conditions.
    #[error("the mechanism is overconstrained: mobility F = {formula}, and {drives} {drives_are} declared")]
    #[diagnostic(code(mech::determinacy::overconstrained))]
    Overconstrained {
        /// The count in figures.
        formula: String,
        /// Number of drives.
        drives: usize,
        /// `drive is` or `drives are`.
        drives_are: &'static str,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The total is right, but one part has too many conditions and another too few.
    #[error(
        "one part is overconstrained and another is loose, although the total F = {formula} fits {drives} {drives_are} declared"
    )]
    #[diagnostic(code(mech::determinacy::unbalanced))]
    Unbalanced {
        /// The count in figures.
        formula: String,
        /// Number of drives.
        drives: usize,
        /// `drive` or `drives` with the verb.
        drives_are: &'static str,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The number or the place of unknown efforts does not fit.
    #[error("forces are not determined: {unknown} unknown {efforts} for mobility F = {formula}{where_}")]
    #[diagnostic(code(mech::determinacy::efforts))]
    Efforts {
        /// Number of unknown efforts.
        unknown: usize,
        /// `effort` or `efforts`.
        efforts: &'static str,
        /// The count in figures.
        formula: String,
        /// Which part is concerned, where the number fits.
        where_: String,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The asserted group does not count.
    #[error(
        "`{name}` is not a structural group: 3n − 2P_L − P_H = 3·{n} − 2·{lower} − {higher} = {rest}, not 0"
    )]
    #[diagnostic(code(mech::determinacy::not_a_group))]
    NotAGroup {
        /// Its name.
        name: String,
        /// Links.
        n: usize,
        /// Lower pairs.
        lower: usize,
        /// Higher pairs.
        higher: usize,
        /// What is left.
        rest: i64,
        /// What to write.
        #[help]
        help: String,
        /// Places.
        #[label(collection)]
        labels: Vec<LabeledSpan>,
    },
    /// The asserted links are part of a larger group.
    #[error("`{name}` counts as a group, but its links are solved only together with others: {groups}")]
    #[diagnostic(
        code(mech::determinacy::part_of_larger),
        help("name the whole group, or leave the `group` statement out: groups are found without it")
    )]
    PartOfLarger {
        /// Its name.
        name: String,
        /// The groups found that hold its links.
        groups: String,
        /// Place.
        #[label("asserted here")]
        span: miette::SourceSpan,
    },
    /// The asserted group is made of smaller ones.
    #[error("`{name}` counts as a group, but is made of smaller groups: {groups}")]
    #[diagnostic(
        code(mech::determinacy::contains_smaller),
        severity(warning),
        help(
            "a structural group is one that cannot be split; name each of them by a `group` statement of its own"
        )
    )]
    ContainsSmaller {
        /// Its name.
        name: String,
        /// The groups found.
        groups: String,
        /// Place.
        #[label("asserted here")]
        span: miette::SourceSpan,
    },
}

fn label(text: impl Into<String>, span: Span) -> LabeledSpan {
    LabeledSpan::new_with_span(Some(text.into()), span)
}

fn drives_are(n: usize) -> &'static str {
    if n == 1 { "drive is" } else { "drives are" }
}

impl StructureError {
    pub(super) fn outer_link(mechanism: &Mechanism, drive: &Drive, pair: PairId) -> Self {
        let pair = mechanism.pair(pair);
        Self::OuterLink {
            drive: format!("drive {}", drive.name),
            pair: pair.name.clone(),
            labels: vec![
                label("moves one point only", drive.span),
                label("joins the link elsewhere", pair.span),
            ],
        }
    }

    pub(super) fn not_a_group(
        mechanism: &Mechanism,
        assertion: &GroupAssertion,
        lower: &[usize],
        higher: &[usize],
    ) -> Self {
        let n = assertion.links.len();
        let rest = signed(3 * n) - signed(2 * lower.len() + higher.len());
        let mut labels = vec![label("asserted here", assertion.span)];
        let mut listed = lower.to_vec();
        listed.dedup();
        for i in listed {
            labels.push(label("lower pair of the group", mechanism.pairs[i].span));
        }
        for &i in higher {
            labels.push(label("higher pair of the group", mechanism.pairs[i].span));
        }
        let help = if rest > 0 {
            format!(
                "{rest} freedom{} left: a link or pair that belongs to the group is missing",
                if rest == 1 { " is" } else { "s are" }
            )
        } else {
            format!(
                "{} condition{} too many: leave a link out of the pairs, or add the link that shares them",
                -rest,
                if rest == -1 { "" } else { "s" }
            )
        };
        Self::NotAGroup {
            name: assertion.name.clone(),
            n,
            lower: lower.len(),
            higher: higher.len(),
            rest,
            help,
            labels,
        }
    }

    pub(super) fn part_of_larger(
        mechanism: &Mechanism,
        assertion: &GroupAssertion,
        structure: &Structure,
    ) -> Self {
        let holds = |g: &super::Group| {
            g.bodies.iter().any(|b| {
                matches!(structure.replaced.bodies[b.0].origin, BodyOrigin::Link(l) if assertion.links.contains(&l))
            })
        };
        let groups: Vec<String> = structure
            .motion
            .iter()
            .filter(|g| holds(g))
            .map(|g| group_text(mechanism, structure, g))
            .collect();
        Self::PartOfLarger {
            name: assertion.name.clone(),
            groups: groups.join("; "),
            span: assertion.span.into(),
        }
    }

    pub(super) fn contains_smaller(
        mechanism: &Mechanism,
        assertion: &GroupAssertion,
        structure: &Structure,
        groups: &[usize],
    ) -> Self {
        let groups: Vec<String> =
            groups.iter().map(|&i| group_text(mechanism, structure, &structure.motion[i])).collect();
        Self::ContainsSmaller {
            name: assertion.name.clone(),
            groups: groups.join("; "),
            span: assertion.span.into(),
        }
    }
}

fn signed(x: usize) -> i64 {
    i64::try_from(x).unwrap_or(i64::MAX)
}

fn group_text(mechanism: &Mechanism, structure: &Structure, group: &super::Group) -> String {
    let names: Vec<String> =
        group.bodies.iter().map(|&b| structure.replaced.body_name(mechanism, b)).collect();
    format!("{} ({})", names.join(", "), group.kind_name())
}

pub(super) fn floating_links(mechanism: &Mechanism) -> Vec<StructureError> {
    let mut joined = vec![false; mechanism.links.len()];
    for pair in &mechanism.pairs {
        for link in pair.kind.links() {
            joined[link.index()] = true;
        }
        if let crate::model::PairKind::Cylinder { barrel, rod, .. } = &pair.kind {
            joined[barrel.index()] = true;
            joined[rod.index()] = true;
        }
    }
    let floating = mechanism.links.iter().zip(&joined).skip(1).filter(|(_, joined)| !**joined);
    floating
        .map(|(link, _)| StructureError::FloatingLink { name: link.name.clone(), span: link.span.into() })
        .collect()
}

fn part_labels(
    mechanism: &Mechanism,
    replaced: &Replaced,
    efforts: &[Effort],
    part: &Part,
    text: &str,
) -> Vec<LabeledSpan> {
    let mut labels = Vec::new();
    let mut seen: Vec<PairId> = Vec::new();
    for &joint in &part.joints {
        let pair = replaced.joint(joint).pair;
        if !seen.contains(&pair) {
            seen.push(pair);
            labels.push(label(text, mechanism.pair(pair).span));
        }
    }
    for &effort in &part.efforts {
        let span = match efforts[effort].source {
            EffortSource::Drive(id) => mechanism.drives[id.index()].span,
            EffortSource::Balance(id) => mechanism.balances[id.index()].span,
        };
        labels.push(label(text, span));
    }
    labels
}

fn body_labels(
    mechanism: &Mechanism,
    replaced: &Replaced,
    bodies: &[BodyId],
    text: &str,
) -> Vec<LabeledSpan> {
    let links = bodies.iter().filter_map(|b| match replaced.bodies[b.0].origin {
        BodyOrigin::Link(id) => Some(mechanism.link(id)),
        BodyOrigin::Imaginary(_) => None,
    });
    links.filter(|l| l.span != Span::default()).map(|l| label(text, l.span)).collect()
}

fn names(mechanism: &Mechanism, replaced: &Replaced, bodies: &[BodyId]) -> String {
    let names: Vec<String> =
        bodies.iter().map(|&b| format!("`{}`", replaced.body_name(mechanism, b))).collect();
    names.join(", ")
}

fn all_prismatic(replaced: &Replaced, joints: &[JointId]) -> bool {
    !joints.is_empty()
        && joints.iter().all(|&j| matches!(replaced.joint(j).kind, JointKind::Prismatic { .. }))
}

pub(super) fn of_motion(
    mechanism: &Mechanism,
    replaced: &Replaced,
    count: &Count,
    drives: &[Effort],
    defect: &Defect,
) -> StructureError {
    let over = part_labels(mechanism, replaced, drives, &defect.over, "one condition too many in this part");
    let mut under = body_labels(mechanism, replaced, &defect.under.bodies, "can still move");
    let (formula, n) = (count.formula(), count.drives);
    let loose = names(mechanism, replaced, &defect.under.bodies);
    let fixed = names(mechanism, replaced, &defect.over.bodies);
    let missing = count.mobility - signed(n);
    if defect.over.joints.is_empty() && defect.over.efforts.is_empty() {
        let help = if all_prismatic(replaced, &defect.under.joints) {
            format!(
                "{loose}: links joined by prismatic pairs alone do not turn, so that three of them hold two links at their angles twice and leave one free to slide; make one of the pairs a revolute, or drive it"
            )
        } else {
            format!(
                "{loose} can still move: add {missing} drive{} such as `drive LINK = 0 deg`, or a pair that holds them",
                if missing == 1 { "" } else { "s" }
            )
        };
        return StructureError::Underconstrained {
            formula,
            drives: n,
            drives_are: drives_are(n),
            help,
            labels: under,
        };
    }
    if defect.under.bodies.is_empty() {
        let help = if n > 0 && missing < 0 && count.mobility >= 0 {
            format!(
                "remove {} drive{}, or free {fixed} by one pair less",
                -missing,
                if missing == -1 { "" } else { "s" }
            )
        } else {
            format!("{fixed}: remove a pair, or make a lower pair a higher one (`slot` or `contact`)")
        };
        return StructureError::Overconstrained {
            formula,
            drives: n,
            drives_are: drives_are(n),
            help,
            labels: over,
        };
    }
    under.extend(over);
    StructureError::Unbalanced {
        formula,
        drives: n,
        drives_are: drives_are(n),
        help: format!(
            "{loose} can still move, while {fixed} are held more than once: move a pair or a drive from the second to the first"
        ),
        labels: under,
    }
}

pub(super) fn of_forces(
    mechanism: &Mechanism,
    replaced: &Replaced,
    count: &Count,
    efforts: &[Effort],
    defect: &Defect,
) -> StructureError {
    let unknown = efforts.len();
    let missing = count.mobility - signed(unknown);
    let mut labels = body_labels(mechanism, replaced, &defect.under.bodies, "nothing holds this link");
    labels.extend(part_labels(mechanism, replaced, efforts, &defect.over, "one unknown too many here"));
    let help = match missing {
        0 => "put the balance where it can hold the links that can move".to_owned(),
        m if m > 0 => {
            format!("add {m} balance{} such as `balance torque Mb on LINK`", if m == 1 { "" } else { "s" })
        }
        m => format!("remove {} balance{}", -m, if m == -1 { "" } else { "s" }),
    };
    let where_ = if missing == 0 {
        format!(": {} not held", names(mechanism, replaced, &defect.under.bodies))
    } else {
        String::new()
    };
    StructureError::Efforts {
        unknown,
        efforts: if unknown == 1 { "effort" } else { "efforts" },
        formula: count.formula(),
        where_,
        help,
        labels,
    }
}
