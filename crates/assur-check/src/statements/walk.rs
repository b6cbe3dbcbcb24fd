//! Over all expressions of a document.

pub use assur_syntax::document::{children, parts};

use assur_syntax::document::{
    AssembleClause, CamMember, Definition, DrivePosition, Event, ExpectAt, Expr, ExprKind, LineDirection,
    Member, Number, Place, Property, Sensed, Setting, Site, Statement, TimeCourse, Until, WheelSize,
};

/// Whether two expressions are the same but for their places.
pub fn same(a: &Expr, b: &Expr) -> bool {
    let alike = match (&a.kind, &b.kind) {
        (ExprKind::Number(a), ExprKind::Number(b)) => {
            let unit = |n: &Number| n.unit.as_ref().map(|u| u.node.clone());
            a.text == b.text && unit(a) == unit(b)
        }
        (ExprKind::Name(a), ExprKind::Name(b)) => a == b,
        (ExprKind::Member(_, a), ExprKind::Member(_, b)) => a.node == b.node,
        (ExprKind::Call { function: a, .. }, ExprKind::Call { function: b, .. }) => a.node == b.node,
        (ExprKind::Unary(a, _), ExprKind::Unary(b, _)) => a.node == b.node,
        (ExprKind::Chain(_, a), ExprKind::Chain(_, b)) => {
            a.iter().map(|o| o.0.node).eq(b.iter().map(|o| o.0.node))
        }
        (ExprKind::Compare(_, a), ExprKind::Compare(_, b)) => {
            a.iter().map(|o| o.0.node).eq(b.iter().map(|o| o.0.node))
        }
        (a, b) => std::mem::discriminant(a) == std::mem::discriminant(b),
    };
    let parts = |e| {
        let mut all = Vec::new();
        children(e, &mut |child| all.push(child));
        all
    };
    let (a, b) = (parts(a), parts(b));
    alike && a.len() == b.len() && a.into_iter().zip(b).all(|(a, b)| same(a, b))
}

/// Calls `visit` on every expression of a statement, each as a whole.
pub fn expressions<'a>(statement: &'a Statement, visit: &mut dyn FnMut(&'a Expr)) {
    match statement {
        Statement::Given(Definition { value, .. }) | Statement::Let(Definition { value, .. }) => visit(value),
        Statement::Gravity(value) => visit(value),
        Statement::Ground(g) => body(&g.body, visit),
        Statement::Link(l) => {
            l.bar.iter().for_each(|bar| visit(&bar.length));
            body(&l.body, visit);
        }
        Statement::Shaft(s) => body(&s.body, visit),
        Statement::Slider(s) => body(&s.body, visit),
        Statement::Joint(j) => properties(&j.properties, visit),
        Statement::Spring(s) => properties(&s.properties, visit),
        Statement::All(a) => properties(&a.properties, visit),
        Statement::Flywheel(f) => properties(&f.properties, visit),
        Statement::Counterweight(c) => properties(&c.properties, visit),
        Statement::Stop(s) => {
            visit(&s.bound);
            properties(&s.properties, visit);
        }
        Statement::Brake(b) => properties(&b.properties, visit),
        Statement::Cam(cam) => cam.members.iter().for_each(|m| cam_member(&m.node, visit)),
        Statement::Drive(d) => {
            match &d.position {
                Some(DrivePosition::Values(values)) => values.iter().for_each(|v| visit(&v.value)),
                Some(DrivePosition::Range(c)) => {
                    [&c.from, &c.to, c.steps.expr()].into_iter().for_each(&mut *visit)
                }
                None => {}
            }
            sensed(d.rate.iter().chain(&d.acceleration), visit);
        }
        Statement::Pose(p) => settings(&p.settings, visit),
        Statement::Assemble(a) => {
            for clause in &a.clauses {
                match &clause.node {
                    AssembleClause::Near { at, .. } => visit(at),
                    AssembleClause::Phase { phase, .. } => visit(phase),
                    AssembleClause::Sign { bound, .. } => visit(bound),
                    AssembleClause::Side { .. } | AssembleClause::Order { .. } => {}
                }
            }
        }
        Statement::Balance(b) => {
            site(&b.site, visit);
            b.along.iter().for_each(visit);
        }
        Statement::Load(l) => {
            site(&l.site, visit);
            visit(&l.value.value);
            l.last.iter().for_each(&mut *visit);
            l.when.iter().for_each(visit);
        }
        Statement::Find(f) => f.items.iter().for_each(|item| visit(&item.value)),
        Statement::Expect(e) => {
            visit(&e.what);
            e.values.iter().chain(&e.within).for_each(&mut *visit);
            if let Some(ExpectAt::Settings(all)) = &e.at {
                settings(all, visit);
            }
        }
        Statement::Equilibrium(all) => all.iter().for_each(|one| {
            one.sought.values().for_each(&mut *visit);
            sensed(one.rate.iter(), visit);
        }),
        Statement::Start(s) => sensed(s.value.iter().chain(&s.rate), visit),
        Statement::Simulate(s) => {
            if let TimeCourse::Between { from, to } = &s.course {
                from.iter().chain([to]).for_each(&mut *visit);
            }
            s.steps.iter().chain(&s.within).for_each(visit);
        }
        Statement::Event(Event { passing, .. }) | Statement::Until(Until { passing }) => {
            std::iter::once(&passing.what).chain(&passing.value).for_each(visit);
        }
        Statement::Edition(_)
        | Statement::Title(_)
        | Statement::Group(_)
        | Statement::Variants(_)
        | Statement::Curve(_)
        | Statement::Ignore(_)
        | Statement::Bad(_) => {}
    }
}

fn body<'a>(members: &'a assur_syntax::document::Body, visit: &mut dyn FnMut(&'a Expr)) {
    for member in members {
        match &member.node {
            Member::Point(p) => visit(&p.at),
            Member::PointFrom(p) => [&p.first_distance, &p.second_distance].into_iter().for_each(&mut *visit),
            Member::Line(l) => {
                if let LineDirection::Along(angle) = &l.direction {
                    visit(angle);
                }
            }
            Member::Circle(c) => visit(&c.radius),
            Member::Mass(m) | Member::Weight(m) => {
                let of_shape = m.shape.iter().flat_map(|shape| shape.values());
                std::iter::once(&m.value)
                    .chain(of_shape)
                    .chain(&m.inertia)
                    .chain(&m.plane)
                    .for_each(&mut *visit);
            }
            Member::Plane(at) => visit(at),
            Member::Inertia(i) => visit(&i.value),
            Member::Wheel(w) => {
                if let Some(WheelSize::Radius(e) | WheelSize::Diameter(e) | WheelSize::Teeth(e)) = &w.size {
                    visit(e);
                }
                w.module.iter().for_each(&mut *visit);
            }
            Member::Profile(_) | Member::Bad(_) => {}
        }
    }
}

fn cam_member<'a>(member: &'a CamMember, visit: &mut dyn FnMut(&'a Expr)) {
    match member {
        CamMember::Follower(f) => properties(&f.properties, visit),
        CamMember::Phase(p) => std::iter::once(&p.angle).chain(&p.through).for_each(visit),
        CamMember::Property(p) => properties(std::slice::from_ref(p), visit),
        CamMember::Turning(_) | CamMember::Lift(_) | CamMember::Bad(_) => {}
    }
}

fn properties<'a>(all: &'a [Property], visit: &mut dyn FnMut(&'a Expr)) {
    for p in all {
        p.values.iter().for_each(&mut *visit);
        properties(&p.properties, visit);
    }
}

fn settings<'a>(all: &'a [Setting], visit: &mut dyn FnMut(&'a Expr)) {
    sensed(all.iter().map(|s| &s.value), visit);
}

fn sensed<'a>(all: impl Iterator<Item = &'a Sensed>, visit: &mut dyn FnMut(&'a Expr)) {
    all.for_each(|s| visit(&s.value));
}

fn site<'a>(site: &'a Site, visit: &mut dyn FnMut(&'a Expr)) {
    if let Site::Link { at: Some(Place::Ground(place)), .. } = site {
        visit(place);
    }
}
