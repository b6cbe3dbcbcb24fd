//! All names a document declares, found before anything is resolved, so that order is free.

use crate::names::declared::{Declared, Inside, QuantityKind, ThingKind};
use crate::names::lookalikes::Scope;
use crate::statements::written::written;
use assur_model::model::{BalanceId, LinkId, LoadId};
use assur_syntax::document::{Bad, Body, CamMember, End, ExprKind, Joint, Member, Name, Statement};
use assur_text::diagnostic::{Diagnosis, did_you_mean};
use assur_text::source::{Span, Spanned};
use indexmap::IndexMap;

/// Collects all names of the document; reports those declared twice.
pub fn declare(cx: &mut Scope<'_, '_>) {
    cx.names.add_link(&mut cx.builder.mech, "ground".into(), None, Span::default());
    cx.names.inside.push(Inside::default());
    let (mut loads, mut balances, mut flywheels) = (0, 0, 0);
    cx.names.simulates = cx.doc.statements.iter().any(|s| matches!(s.node, Statement::Simulate(_)));
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
            Statement::Brake(b) => {
                quantity(cx, &b.name, QuantityKind::Brake(LoadId::at(loads)));
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
            Statement::Curve(curve) => quantity(cx, &curve.name, QuantityKind::Curve(curve)),
            Statement::Find(find) => {
                for item in &find.items {
                    if let Some(name) = &item.name {
                        quantity(cx, name, QuantityKind::Find(item));
                    }
                }
            }
            Statement::Expect(expect) => {
                cx.names.expected.entry(&expect.text).or_default().push(expect);
            }
            Statement::Pose(pose) => {
                if let Some(&first) = cx.names.poses.get(&pose.name.node) {
                    cx.pose_taken(pose, first);
                } else {
                    cx.names.poses.insert(pose.name.node.clone(), pose.name.span);
                }
            }
            Statement::Event(event) => {
                if let Some(&first) = cx.names.events.get(&event.name.node) {
                    cx.twice("event", &event.name, first, None);
                } else {
                    cx.names.events.insert(event.name.node.clone(), event.name.span);
                }
            }
            // Declared below: a `given` of that name may follow.
            Statement::Variants(table) => cx.names.bad.extend(table.bad.iter().cloned()),
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

/// Links, pairs, groups and elements.
fn things(cx: &mut Scope<'_, '_>, statement: &Statement, span: Span) {
    match statement {
        Statement::Ground(ground) => {
            let link = &mut cx.builder.mech.links[0];
            if link.span == Span::default() {
                link.span = span;
                cx.names.ground = Some(Span::new(span.start, span.start + "ground".len()));
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
            let id = cx.names.add_link(&mut cx.builder.mech, link.name.node.clone(), written, link.name.span);
            cx.names.inside.push(Inside::default());
            for end in link.bar.iter().flat_map(|bar| [&bar.from, &bar.to]) {
                point(cx, end, id);
            }
            members(cx, id, &link.body);
        }
        Statement::Shaft(shaft) => {
            element(cx, &shaft.name, ThingKind::Shaft, &shaft.body);
            misspelt_wheels(cx, &shaft.body);
        }
        Statement::Slider(slider) => {
            element(cx, &slider.name, ThingKind::Slider, &slider.body);
        }
        Statement::Joint(joint) => joint_names(cx, joint),
        Statement::Spring(spring) => {
            thing(cx, &spring.name, ThingKind::Spring);
        }
        Statement::Counterweight(weight) => {
            thing(cx, &weight.name, ThingKind::Counterweight);
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
fn element(cx: &mut Scope<'_, '_>, name: &Name, kind: ThingKind, body: &Body) {
    if thing(cx, name, kind) {
        let id = cx.names.add_link(&mut cx.builder.mech, name.node.clone(), None, name.span);
        cx.names.inside.push(Inside::default());
        members(cx, id, body);
    }
}

fn joint_names(cx: &mut Scope<'_, '_>, joint: &Joint) {
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
fn members(cx: &mut Scope<'_, '_>, link: LinkId, body: &Body) {
    for member in body {
        match &member.node {
            Member::Point(p) => point(cx, &p.name, link),
            Member::PointFrom(p) => point(cx, &p.name, link),
            Member::Line(l) => inside(cx, &l.name, |i| &mut i.lines, link),
            Member::Circle(c) => inside(cx, &c.name, |i| &mut i.circles, link),
            Member::Profile(p) => inside(cx, &p.name, |i| &mut i.circles, link),
            Member::Bad(Bad { names }) => {
                cx.names.inside[link.index()].bad.extend(names.iter().cloned());
                cx.names.bad.extend(names.iter().cloned());
            }
            Member::Wheel(_)
            | Member::Mass(_)
            | Member::Weight(_)
            | Member::Inertia(_)
            | Member::Plane(_) => {}
        }
    }
    wheels(cx, body);
}

fn wheels(cx: &mut Scope<'_, '_>, body: &Body) {
    for member in body {
        if let Member::Wheel(wheel) = &member.node {
            thing(cx, &wheel.name, ThingKind::Wheel);
        }
    }
}

/// `whel w1` in a shaft: its word is reported, and the name is not missed.
fn misspelt_wheels(cx: &mut Scope<'_, '_>, body: &Body) {
    for member in body {
        if let Member::Point(point) = &member.node
            && let ExprKind::Name(name) = &point.at.kind
            && !did_you_mean(&point.name.node, ["wheel"]).is_empty()
        {
            cx.names.bad.insert(name.clone());
        }
    }
}

fn point(cx: &mut Scope<'_, '_>, name: &Name, link: LinkId) {
    inside(cx, name, |i| &mut i.points, link);
    cx.names.add_bearer(&name.node, link);
}

fn inside<F>(cx: &mut Scope<'_, '_>, name: &Name, list: F, link: LinkId)
where
    F: Fn(&mut Inside) -> &mut IndexMap<String, Span>,
{
    let names = &mut cx.names.inside[link.index()];
    let here = [&names.points, &names.lines, &names.circles];
    if let Some(&first) = here.iter().find_map(|list| list.get(&name.node)) {
        cx.twice("point", name, first, None);
    } else {
        list(names).insert(name.node.clone(), name.span);
    }
}

fn quantity<'a>(cx: &mut Scope<'_, 'a>, name: &Name, what: QuantityKind<'a>) {
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
                true => format!("write `find {name}`; its `expect` gives the expected value"),
                false => format!("write `find {name}`, and on a separate line `expect {name} = {value}`"),
            };
            cx.error(
                Diagnosis::error(
                    "mech::name::duplicate",
                    format!("`{name}` is already declared, and a `find` takes no value"),
                )
                .primary(span, "a question with a value")
                .label(first, "declared here")
                .help(help),
            );
            return;
        }
        cx.quantity_taken(name, what, first);
    } else {
        cx.names.quantities.insert(name.node.clone(), Declared { what, span: name.span });
    }
}

/// Two links have different numbers: the symbols of the report tell them apart by these.
fn number(cx: &mut Scope<'_, '_>, number: Option<&Spanned<String>>) {
    let Some(number) = number else { return };
    match cx.names.numbers.get(&number.node) {
        Some(&first) => cx.error(
            Diagnosis::error("mech::name::number", format!("two links have the number {}", number.node))
                .primary(number.span, "again here")
                .label(first, "first here")
                .help(
                    "give one of them another number, or none: the symbols of the report, such as R12 and \
                     ω2, use it",
                ),
        ),
        None => {
            cx.names.numbers.insert(number.node.clone(), number.span);
        }
    }
}

/// Where the name is declared before.
fn taken(cx: &Scope<'_, '_>, name: &Name) -> Option<Span> {
    let ground = (name.node == "ground").then(|| cx.builder.mech.links[0].span);
    cx.names.things.get(&name.node).map(|d| d.span).or(ground)
}

/// Whether the name was free.
fn thing(cx: &mut Scope<'_, '_>, name: &Name, what: ThingKind) -> bool {
    if let Some(first) = taken(cx, name) {
        cx.twice("thing", name, first, None);
        return false;
    }
    cx.names.things.insert(name.node.clone(), Declared { what, span: name.span });
    true
}
