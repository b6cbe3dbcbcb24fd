//! Mobility and structural groups.

use super::document::{Align, Block, Column, Report, Section, Table};
use super::train::kind_name;
use assur_model::model::{BalanceKind, PairId, PairKind, Value};
use assur_model::structure::{BodyId, BodyOrigin, Effort, EffortSource, Group, GroupKind, Structure};
use assur_solve::solve::Model;
use assur_text::units::Dimension;

/// The numbers of a group: links, lower pairs, higher pairs of the mechanism as declared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct GroupCount {
    pub n: usize,
    pub lower: usize,
    pub higher: usize,
    /// Rollers that turn freely.
    pub passive: usize,
}

impl GroupCount {
    /// Counts a group: an imaginary body with its two joints is a higher pair.
    pub fn of(structure: &Structure, group: &Group) -> Self {
        let imaginary =
            |body: &BodyId| matches!(structure.replaced.bodies[body.0].origin, BodyOrigin::Imaginary(_));
        let replaced = group.bodies.iter().filter(|b| imaginary(b)).count();
        let higher = replaced + group.laws.len();
        let lower = group.joints.iter().filter(|j| !imaginary(&j.body) && !imaginary(&j.base)).count();
        let link = |body: &BodyId| match structure.replaced.bodies[body.0].origin {
            BodyOrigin::Link(id) => structure.passive.contains(&id),
            BodyOrigin::Imaginary(_) => false,
        };
        let passive = group.bodies.iter().filter(|b| link(b)).count();
        Self { n: group.bodies.len() - replaced, lower, higher, passive }
    }

    /// The count in figures, as `3·2 − 2·3 = 0`; a body between two guides does not turn, so that 2n = P_L counts.
    pub fn formula(self, kind: GroupKind) -> String {
        let [n, lower, higher, passive] =
            [self.n, self.lower, self.higher, self.passive].map(|x| i64::try_from(x).unwrap_or(i64::MAX));
        if kind == GroupKind::Translation {
            return format!("2·{n} − {lower} = {}", 2 * n - lower);
        }
        let rest = 3 * n - 2 * lower - higher - passive;
        let less =
            |count: i64, what: &str| if count > 0 { format!(" − {count}{what}") } else { String::new() };
        format!("3·{n} − 2·{lower}{}{} = {rest}", less(higher, ""), less(passive, " passive"))
    }
}

/// Names of a group's links. Imaginary ones are left out; a group of such alone has the names of their pairs.
pub(super) fn link_names(model: &Model<'_>, group: &Group) -> Vec<String> {
    let (mut links, mut pairs) = (Vec::new(), Vec::new());
    for body in &group.bodies {
        match model.structure.replaced.bodies[body.0].origin {
            BodyOrigin::Link(_) => links.push(model.structure.replaced.body_name(model.mechanism, *body)),
            BodyOrigin::Imaginary(pair) => pairs.push(model.mechanism.pair(pair).name.clone()),
        }
    }
    if links.is_empty() { pairs } else { links }
}

/// The groups in the order in which they move: the links of each, and its class and kind.
#[must_use]
pub fn groups_in_order(model: &Model<'_>) -> Vec<(Vec<String>, String)> {
    let kind = |group| format!("{}, {}", Group::class_name(group), kind_name(model, group));
    model.structure.motion.iter().map(|group| (link_names(model, group), kind(group))).collect()
}

/// The facts in short, as shown above the answers.
pub(super) fn summary(model: &Model<'_>, report: &mut Report) {
    let mut section = Section::new("Structure");
    let groups =
        groups_in_order(model).into_iter().map(|(links, kind)| format!("{} ({kind})", links.join(", ")));
    let groups = groups.collect::<Vec<_>>();
    let mut facts = vec![("mobility".to_owned(), format!("F = {}", model.structure.count.formula()))];
    if !groups.is_empty() {
        facts.push(("groups".to_owned(), groups.join("; ")));
    }
    facts.push(("effects".to_owned(), effects(model)));
    section.blocks.push(Block::Facts(facts));
    report.section(section);
}

fn effects(model: &Model<'_>) -> String {
    let names = model.plan.effects.computed();
    if names.is_empty() { "positions only".to_owned() } else { names.join(", ") }
}

/// Everything known before anything is solved.
pub(super) fn sections(model: &Model<'_>, report: &mut Report) {
    let count = &model.structure.count;
    let mut section = Section::new("Structure");
    let mut facts = vec![
        ("mobility".to_owned(), format!("F = {}", count.formula())),
        ("moving links".to_owned(), count.n.to_string()),
        ("lower pairs".to_owned(), count.lower.to_string()),
        ("higher pairs".to_owned(), count.higher.to_string()),
        ("drives".to_owned(), drive_names(model)),
        ("equilibrium of".to_owned(), sought_names(model)),
        ("free coordinates".to_owned(), free_names(model)),
        ("unknown efforts".to_owned(), effort_names(model)),
        ("effects".to_owned(), effects(model)),
    ];
    facts.retain(|f| !f.1.is_empty());
    section.blocks.push(Block::Facts(facts));
    section.list(notes(model));
    report.section(section);
    masses(model, report);
    let mut motion = Section::new("Groups in the order in which motion is solved");
    motion.table(groups(model, &model.structure.motion, &model.structure.drives));
    report.section(motion);
    if model.plan.effects.forces {
        let mut forces = Section::new("Groups in the order in which forces are solved");
        forces.table(groups(model, &model.structure.forces, &model.structure.efforts));
        if let Some(defect) = &model.structure.force_defect {
            forces.text(defect.to_string());
        }
        report.section(forces);
    }
}

/// Mass, mass centre in its own axes and moment of inertia about it of each link, where one has several masses.
fn masses(model: &Model<'_>, report: &mut Report) {
    let mechanism = model.mechanism;
    if mechanism.links.iter().all(|link| link.mass_parts.is_empty()) {
        return;
    }
    let units = [Dimension::MASS, Dimension::LENGTH, Dimension::LENGTH, Dimension::INERTIA];
    let displays = units.map(|dimension| mechanism.display_of(dimension));
    let mut columns = vec![Column::words("link")];
    for letter in &["m", "x_S", "y_S", "J_S"] {
        columns.push(Column { header: (*letter).to_owned(), align: Align::Right });
    }
    let mut table = Table::new(columns, 1);
    for link in mechanism.links.iter().skip(1) {
        let Some(m) = link.mass else { continue };
        let numbers = [m.mass, m.centre.x, m.centre.y, m.inertia];
        let texts = numbers.iter().zip(&displays).map(|(x, display)| display.text(Value::Scalar(*x), 6));
        table.row(std::iter::once(link.name.clone()).chain(texts).collect());
    }
    let mut section = Section::new("Masses");
    section.table(table);
    report.section(section);
}

fn groups(model: &Model<'_>, groups: &[Group], efforts: &[Effort]) -> Table {
    let mut columns = vec![Column::right("#")];
    columns.extend(["links", "class", "kind", "order", "count", "pairs", "name"].map(Column::words));
    columns[4] = Column::right("order");
    let keys = columns.len();
    let mut table = Table::new(columns, keys);
    for (i, group) in groups.iter().enumerate() {
        let count = GroupCount::of(model.structure, group);
        let with: Vec<String> = group.efforts.iter().map(|&e| source_name(model, &efforts[e])).collect();
        let kind = match (group.kind, with.as_slice()) {
            (_, []) => kind_name(model, group).to_owned(),
            (GroupKind::Driven, _) => format!("with {}", with.join(", ")),
            _ => format!("{} ({})", kind_name(model, group), with.join(", ")),
        };
        table.row(vec![
            (i + 1).to_string(),
            link_names(model, group).join(", "),
            group.class_name().to_owned(),
            kind,
            group.order.to_string(),
            count.formula(group.kind),
            pair_names(model, group).join(", "),
            group.name.clone().unwrap_or_default(),
        ]);
    }
    if table.rows.iter().all(|r| r[7].is_empty()) {
        table.columns.pop();
        table.rows.iter_mut().for_each(|r| drop(r.pop()));
    }
    table
}

fn pair_names(model: &Model<'_>, group: &Group) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for joint in group.joints.iter().map(|j| j.joint).chain(group.laws.iter().copied()) {
        let pair = model.structure.replaced.joint(joint).pair;
        let name = &model.mechanism.pair(pair).name;
        if !names.contains(name) {
            names.push(name.clone());
        }
    }
    names
}

/// Name of a drive, or of a balance.
pub(super) fn source_name(model: &Model<'_>, effort: &Effort) -> String {
    match effort.source {
        EffortSource::Drive(id) => {
            let drive = &model.mechanism.drives[id.index()];
            let word = match (drive.sought.is_some(), drive.free) {
                (true, _) => "equilibrium",
                (false, true) => "start",
                (false, false) => "drive",
            };
            format!("{word} {}", drive.name)
        }
        EffortSource::Balance(id) => format!("balance {}", model.mechanism.balances[id.index()].name),
    }
}

fn drive_names(model: &Model<'_>) -> String {
    let drives = model.mechanism.drives.iter().filter(|d| !d.is_unaided()).map(|d| d.name.as_str());
    drives.collect::<Vec<_>>().join(", ")
}

/// The coordinates whose positions need no effort.
fn sought_names(model: &Model<'_>) -> String {
    let sought = model.mechanism.drives.iter().filter(|d| d.sought.is_some()).map(|d| d.name.as_str());
    sought.collect::<Vec<_>>().join(", ")
}

/// The coordinates whose motion follows from the loads.
fn free_names(model: &Model<'_>) -> String {
    let free = model.mechanism.drives.iter().filter(|d| d.free).map(|d| d.name.as_str());
    free.collect::<Vec<_>>().join(", ")
}

fn effort_names(model: &Model<'_>) -> String {
    if !model.plan.effects.forces {
        return String::new();
    }
    if model.mechanism.balances.is_empty() {
        let own = model.structure.efforts.iter().filter_map(|e| match e.source {
            EffortSource::Drive(id) => {
                let drive = &model.mechanism.drives[id.index()];
                (!drive.is_unaided()).then(|| format!("effort({})", drive.name))
            }
            EffortSource::Balance(_) => None,
        });
        return own.collect::<Vec<_>>().join(", ");
    }
    let balances = model.mechanism.balances.iter().map(|b| {
        let kind = match b.kind {
            BalanceKind::Torque(_) => "torque",
            BalanceKind::Force { .. } => "force",
            BalanceKind::InPair(_) => "in a pair",
            BalanceKind::Several(_) => "at several places",
        };
        format!("{} ({kind})", b.name)
    });
    balances.collect::<Vec<_>>().join(", ")
}

/// The bodies of welded links, with their welds.
pub(super) fn welded<'a>(model: &Model<'a>) -> impl Iterator<Item = (BodyId, Vec<PairId>)> + use<'a> {
    let (mechanism, replaced) = (model.mechanism, &model.structure.replaced);
    let bodies = (0..mechanism.links.len()).map(BodyId);
    bodies.filter(|body| replaced.links_of(*body).len() > 1).map(|body| {
        let is_weld = |pair: &PairId| matches!(&mechanism.pair(*pair).kind, PairKind::Weld { pins, .. } if replaced.body_of(pins[0].link) == body);
        (body, (0..mechanism.pairs.len()).map(PairId::at).filter(is_weld).collect())
    })
}

/// Unusual properties of the structure.
fn notes(model: &Model<'_>) -> Vec<String> {
    let (mechanism, structure) = (model.mechanism, model.structure);
    let mut notes = Vec::new();
    for link in &structure.passive {
        notes.push(format!(
            "`{}` can turn without moving anything else: a passive freedom, which is not solved",
            mechanism.link(*link).name
        ));
    }
    notes.extend(welded(model).map(|(body, welds)| {
        let name = structure.replaced.body_name(mechanism, body);
        let names: Vec<&str> = welds.iter().map(|weld| mechanism.pair(*weld).name.as_str()).collect();
        format!("{name}: one body ({} {})", if names.len() == 1 { "weld" } else { "welds" }, names.join(", "))
    }));
    let chained: Vec<String> =
        structure.undetermined_couples.iter().map(|p| format!("`{}`", mechanism.pair(*p).name)).collect();
    if !chained.is_empty() {
        notes.push(format!(
            "the couples in {} are not determined: the pairs close a chain of prismatic pairs, where 2n = P_L counts",
            chained.join(", ")
        ));
    }
    notes
}
