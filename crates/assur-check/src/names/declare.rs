//! All names a document declares, found before anything is resolved, so that order is free.

use crate::error::NameError;
use crate::expr::context::Context;
use crate::statements::written::written;
use assur_model::model::{BalanceId, Link, LinkId, LoadId, PairId};
use assur_syntax::document::{
    Bad, Balance, Body, CamMember, Column, End, Expr, ExprKind, FindItem, Joint, JointKind, Load, Member,
    Name, Statement,
};
use assur_text::source::{Span, Spanned};
use indexmap::{IndexMap, IndexSet};

/// A declared name: what it is and where.
#[derive(Clone, Debug)]
pub struct Declared<T> {
    /// What it is.
    pub what: T,
    /// Where the name stands.
    pub span: Span,
}

/// What a quantity's name stands for.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum QuantityKind<'a> {
    /// `given NAME = …`
    Given(&'a Expr),
    /// `let NAME = …`
    Let(&'a Expr),
    /// `find NAME = …`
    Find(&'a FindItem),
    /// A force or torque, and its place among the loads of the file.
    Load(LoadId, &'a Load),
    /// An unknown effort, and its place among the balances of the file.
    Balance(BalanceId, &'a Balance),
    /// A flywheel, the moment of inertia found: its place among the flywheels of the file.
    Flywheel(usize),
    /// A column of variants that no `given` declares: for an `expect`.
    Column(&'a Column),
}

impl QuantityKind<'_> {
    /// What it is called, with its article.
    pub const fn phrase(self) -> &'static str {
        match self {
            Self::Given(_) => "a `given`",
            Self::Let(_) => "a `let`",
            Self::Find(_) => "what is to be found",
            Self::Load(..) => "a load",
            Self::Balance(..) => "an unknown effort",
            Self::Flywheel(_) => "a flywheel",
            Self::Column(_) => "a column of variants",
        }
    }
}

/// What a thing's name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThingKind {
    /// A link.
    Link,
    /// A pair or a transmission.
    Joint(JointKind),
    /// An asserted group.
    Group,
    /// A spring.
    Spring,
    /// A cam.
    Cam,
    /// A shaft.
    Shaft,
    /// A slider on a rope.
    Slider,
    /// A wheel.
    Wheel,
    /// An idler of a rope, declared by `over(C)`.
    Idler,
}

impl ThingKind {
    /// What it is called, with its article.
    #[must_use]
    pub fn phrase(self) -> String {
        match self {
            Self::Link => "a link".into(),
            Self::Joint(JointKind::Revolute | JointKind::Prismatic) => "a pair".into(),
            Self::Joint(kind) => format!("a {}", kind.word()),
            Self::Group => "a group".into(),
            Self::Spring => "a spring".into(),
            Self::Cam => "a cam".into(),
            Self::Shaft => "a shaft".into(),
            Self::Slider => "a slider".into(),
            Self::Wheel => "a wheel".into(),
            Self::Idler => "an idler".into(),
        }
    }
}

/// Names inside one link.
#[derive(Clone, Debug, Default)]
pub struct Inside {
    /// Points, in the order written.
    pub points: IndexMap<String, Span>,
    /// Lines.
    pub lines: IndexMap<String, Span>,
    /// Circles and cam profiles.
    pub circles: IndexMap<String, Span>,
    /// Names that stand in members that could not be read.
    pub bad: IndexSet<String>,
}

/// All declared names.
#[derive(Debug, Default)]
pub struct Names<'a> {
    /// given, let, loads, balances, flywheels, `find NAME =`.
    pub quantities: IndexMap<String, Declared<QuantityKind<'a>>>,
    /// Links, pairs, groups, elements.
    pub things: IndexMap<String, Declared<ThingKind>>,
    /// The id of each link: of the ground, of those declared, and of those that pairs add.
    pub links: IndexMap<String, LinkId>,
    /// The id of each pair that is in the mechanism.
    pub pairs: IndexMap<String, PairId>,
    /// Numbers of links.
    pub numbers: IndexMap<String, Span>,
    /// What belongs to each link, by its id.
    pub inside: Vec<Inside>,
    /// Poses.
    pub poses: IndexMap<String, Span>,
    /// Names that stand in statements that could not be read.
    pub bad: IndexSet<String>,
}

/// Collects all names of the document; reports those declared twice.
pub fn declare(cx: &mut Context<'_>) {
    cx.add_link("ground".into(), None, Span::default());
    cx.names.inside.push(Inside::default());
    let (mut loads, mut balances, mut flywheels) = (0, 0, 0);
    for statement in &cx.doc.statements {
        match &statement.node {
            Statement::Given(d) => quantity(cx, &d.name, QuantityKind::Given(&d.value)),
            Statement::Let(d) => quantity(cx, &d.name, QuantityKind::Let(&d.value)),
            Statement::Load(load) => {
                if let Some(name) = &load.name {
                    quantity(cx, name, QuantityKind::Load(LoadId::at(loads), load));
                }
                loads += 1;
            }
            Statement::Balance(b) => {
                quantity(cx, &b.name, QuantityKind::Balance(BalanceId::at(balances), b));
                balances += 1;
            }
            Statement::Flywheel(f) => {
                quantity(cx, &f.name, QuantityKind::Flywheel(flywheels));
                flywheels += 1;
            }
            Statement::Find(find) => {
                for item in &find.items {
                    if let Some(name) = &item.name {
                        quantity(cx, name, QuantityKind::Find(item));
                    }
                }
            }
            Statement::Pose(pose) => {
                if let Some(&first) = cx.names.poses.get(&pose.name.node) {
                    cx.pose_taken(pose, first);
                } else {
                    cx.names.poses.insert(pose.name.node.clone(), pose.name.span);
                }
            }
            // Declared below: a `given` of that name may follow.
            Statement::Variants(_) => {}
            Statement::Bad(bad) => cx.names.bad.extend(bad.names.iter().cloned()),
            other => things(cx, other, statement.span),
        }
    }
    for statement in &cx.doc.statements {
        let Statement::Variants(table) = &statement.node else { continue };
        for column in &table.columns {
            let declared = Declared { what: QuantityKind::Column(column), span: column.name.span };
            cx.names.quantities.entry(column.name.node.clone()).or_insert(declared);
        }
    }
}

impl Context<'_> {
    /// Enters a link, without its parts, into the mechanism.
    pub(crate) fn add_link(&mut self, name: String, number: Option<String>, span: Span) -> LinkId {
        let id = LinkId::at(self.mech.links.len());
        self.names.links.entry(name.clone()).or_insert(id);
        self.mech.links.push(Link { name, number, span, ..Link::default() });
        id
    }
}

/// Links, pairs, groups and elements.
fn things(cx: &mut Context<'_>, statement: &Statement, span: Span) {
    match statement {
        Statement::Ground(ground) => {
            let link = &mut cx.mech.links[0];
            if link.span == Span::default() {
                link.span = span;
            }
            if link.number.is_none() {
                link.number = ground.number.as_ref().map(|n| n.node.clone());
                number(cx, ground.number.as_ref());
            }
            members(cx, LinkId::GROUND, &ground.body);
        }
        Statement::Link(link) => {
            if !thing(cx, &link.name, ThingKind::Link) {
                return;
            }
            number(cx, link.number.as_ref());
            let written = link.number.as_ref().map(|n| n.node.clone());
            let id = cx.add_link(link.name.node.clone(), written, link.name.span);
            cx.names.inside.push(Inside::default());
            for end in link.bar.iter().flat_map(|bar| [&bar.from, &bar.to]) {
                inside(cx, end, |i| &mut i.points, id);
            }
            members(cx, id, &link.body);
        }
        Statement::Shaft(shaft) => {
            element(cx, &shaft.name, ThingKind::Shaft, &shaft.body);
        }
        Statement::Slider(slider) => {
            element(cx, &slider.name, ThingKind::Slider, &slider.body);
        }
        Statement::Joint(joint) => joint_names(cx, joint),
        Statement::Spring(spring) => {
            thing(cx, &spring.name, ThingKind::Spring);
        }
        Statement::Group(group) => {
            thing(cx, &group.name, ThingKind::Group);
        }
        Statement::Cam(cam) => {
            thing(cx, &cam.name, ThingKind::Cam);
            for member in &cam.members {
                if let CamMember::Bad(bad) = &member.node {
                    cx.names.bad.extend(bad.names.iter().cloned());
                }
            }
        }
        _ => {}
    }
}

/// A shaft or a slider: a link too.
fn element(cx: &mut Context<'_>, name: &Name, kind: ThingKind, body: &Body) {
    if thing(cx, name, kind) {
        let id = cx.add_link(name.node.clone(), None, name.span);
        cx.names.inside.push(Inside::default());
        members(cx, id, body);
    }
}

fn joint_names(cx: &mut Context<'_>, joint: &Joint) {
    match taken(cx, &joint.name) {
        Some(first) => cx.joint_taken(joint, first),
        None => _ = thing(cx, &joint.name, ThingKind::Joint(joint.kind.node)),
    }
    for end in &joint.ends {
        if let End::Over(name) = end
            && !cx.over_slider(joint, name)
        {
            thing(cx, name, ThingKind::Idler);
        }
    }
}

/// The names in the braces of a link.
fn members(cx: &mut Context<'_>, link: LinkId, body: &Body) {
    for member in body {
        match &member.node {
            Member::Point(p) => inside(cx, &p.name, |i| &mut i.points, link),
            Member::PointFrom(p) => inside(cx, &p.name, |i| &mut i.points, link),
            Member::Line(l) => inside(cx, &l.name, |i| &mut i.lines, link),
            Member::Circle(c) => inside(cx, &c.name, |i| &mut i.circles, link),
            Member::Profile(p) => inside(cx, &p.name, |i| &mut i.circles, link),
            Member::Bad(Bad { names }) => {
                cx.names.inside[link.index()].bad.extend(names.iter().cloned());
                cx.names.bad.extend(names.iter().cloned());
            }
            Member::Wheel(_) | Member::Mass(_) | Member::Weight(_) | Member::Inertia(_) => {}
        }
    }
    wheels(cx, body);
}

fn wheels(cx: &mut Context<'_>, body: &Body) {
    for member in body {
        if let Member::Wheel(wheel) = &member.node {
            thing(cx, &wheel.name, ThingKind::Wheel);
        }
    }
}

fn inside<F>(cx: &mut Context<'_>, name: &Name, list: F, link: LinkId)
where
    F: Fn(&mut Inside) -> &mut IndexMap<String, Span>,
{
    let names = &mut cx.names.inside[link.index()];
    let here = [&names.points, &names.lines, &names.circles];
    if let Some(&first) = here.iter().find_map(|list| list.get(&name.node)) {
        cx.error(NameError::duplicate(name, first, None));
    } else {
        list(names).insert(name.node.clone(), name.span);
    }
}

fn quantity<'a>(cx: &mut Context<'a>, name: &Name, what: QuantityKind<'a>) {
    if let Some(first) = cx.names.quantities.get(&name.node) {
        let first = first.span;
        if let QuantityKind::Find(item) = what
            && let ExprKind::Number(_) = &item.value.kind
            && let Some(value) = written(&item.value)
        {
            let (name, span) = (name.node.clone(), item.span);
            let is_expected =
                |s: &Spanned<Statement>| matches!(&s.node, Statement::Expect(e) if e.text == name);
            let help = match cx.doc.statements.iter().any(is_expected) {
                true => format!("write `find {name}`; what is expected of it stands in its `expect`"),
                false => format!("write `find {name}`, and as a line of its own `expect {name} = {value}`"),
            };
            cx.error(NameError::ValueInFind { name, span, declared: first, help });
            return;
        }
        cx.quantity_taken(name, what, first);
    } else {
        cx.names.quantities.insert(name.node.clone(), Declared { what, span: name.span });
    }
}

/// Two links have different numbers: the symbols of the report tell them apart by these.
fn number(cx: &mut Context<'_>, number: Option<&Spanned<String>>) {
    let Some(number) = number else { return };
    match cx.names.numbers.get(&number.node) {
        Some(&first) => {
            cx.error(NameError::SameNumber { number: number.node.clone(), again: number.span, first })
        }
        None => {
            cx.names.numbers.insert(number.node.clone(), number.span);
        }
    }
}

/// Where the name is declared before.
fn taken(cx: &Context<'_>, name: &Name) -> Option<Span> {
    let ground = (name.node == "ground").then(|| cx.mech.links[0].span);
    cx.names.things.get(&name.node).map(|d| d.span).or(ground)
}

/// Whether the name was free.
fn thing(cx: &mut Context<'_>, name: &Name, what: ThingKind) -> bool {
    if let Some(first) = taken(cx, name) {
        cx.error(NameError::duplicate(name, first, None));
        return false;
    }
    cx.names.things.insert(name.node.clone(), Declared { what, span: name.span });
    true
}
