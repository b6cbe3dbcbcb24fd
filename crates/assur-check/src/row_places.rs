//! Where in a document a row of variants may change a number without changing anything else, and what the number must be there.
//! A document that uses a column elsewhere is checked again for every row.

use crate::statements::walk::{children, expressions, parts};
use assur_syntax::document::{
    AssembleClause, Bar, Body, Document, DrivePosition, Expect, ExpectAt, Expr, ExprKind, JointKind,
    LineDirection, Member, Place, Property, Sensed, Setting, Site, Statement,
};
use assur_text::language::Function;
use indexmap::IndexSet;

/// What is asked of a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Asked {
    /// Nothing but that it is finite.
    Nothing,
    /// It is greater than zero.
    Positive,
    /// It is not less than zero.
    NotNegative,
    /// It is not zero.
    NotZero,
    /// It is less than half a turn.
    LessThanHalf,
    /// It is a weight, of which the mass is kept.
    Weight,
    /// It is an angle, of which the direction is kept.
    Direction,
}

/// Functions of numbers: what they give of a row is a number.
const PLAIN: [&str; 12] =
    ["sin", "cos", "tan", "asin", "acos", "atan", "atan2", "sqrt", "abs", "max", "min", "mag"];

/// Expressions that depend on columns, each with what is asked of it.
pub(crate) struct Places<'d> {
    /// Names whose values go with the row.
    names: &'d IndexSet<String>,
    pub(crate) found: Vec<(&'d Expr, Asked)>,
    /// Values of the answer key, with their tolerance where one is written.
    pub(crate) expected: Vec<(&'d Expr, Option<&'d Expr>)>,
}

/// All places of a document where these names are used; `None` where one of them may change more than numbers.
pub(crate) fn places<'d>(doc: &'d Document, names: &'d IndexSet<String>) -> Option<Places<'d>> {
    let filled = |text: &str| text.contains('{');
    if doc.notes.iter().any(|note| filled(&note.node)) || doc.title().is_some_and(|t| filled(&t.node)) {
        return None;
    }
    if asks_inside(doc) {
        return None;
    }
    let mut places = Places { names, found: Vec::new(), expected: Vec::new() };
    doc.statements.iter().try_for_each(|s| places.statement(&s.node))?;
    Some(places)
}

/// Whether a document asks for forces inside links: places of cuts are compared with the links.
fn asks_inside(doc: &Document) -> bool {
    let mut found = false;
    for statement in &doc.statements {
        expressions(&statement.node, &mut |expr| {
            parts(expr, &mut |part| {
                found |= matches!(&part.kind, ExprKind::Call { function, .. } if function.node == Function::Internal.name());
            });
        });
    }
    found
}

/// Whether an expression uses one of these names.
pub(crate) fn depends(names: &IndexSet<String>, expr: &Expr) -> bool {
    let mut found = false;
    parts(expr, &mut |part| {
        found |= matches!(&part.kind, ExprKind::Name(name) if names.contains(name));
    });
    found
}

/// Whether an expression uses these names in operations and functions of numbers alone.
pub(crate) fn is_plain(names: &IndexSet<String>, expr: &Expr) -> bool {
    if let ExprKind::Call { function, args } = &expr.kind {
        let over_sweep = args.len() == 1 && matches!(function.node.as_str(), "max" | "min");
        if over_sweep || !PLAIN.contains(&function.node.as_str()) {
            return !depends(names, expr);
        }
    }
    let mut plain = true;
    children(expr, &mut |part| plain &= is_plain(names, part));
    plain
}

impl<'d> Places<'d> {
    fn depends(&self, expr: &Expr) -> bool {
        depends(self.names, expr)
    }

    fn add(&mut self, expr: &'d Expr, asked: Asked) -> Option<()> {
        if self.depends(expr) {
            is_plain(self.names, expr).then(|| self.found.push((expr, asked)))?;
        }
        Some(())
    }

    fn all(&mut self, exprs: impl IntoIterator<Item = &'d Expr>, asked: Asked) -> Option<()> {
        exprs.into_iter().try_for_each(|e| self.add(e, asked))
    }

    /// What must not go with the row.
    fn none<'e>(&self, exprs: impl IntoIterator<Item = &'e Expr>) -> Option<()> {
        (!exprs.into_iter().any(|e| self.depends(e))).then_some(())
    }

    fn statement(&mut self, statement: &'d Statement) -> Option<()> {
        match statement {
            Statement::Edition(_)
            | Statement::Title(_)
            | Statement::Group(_)
            | Statement::Ignore(_)
            | Statement::Variants(_) => Some(()),
            Statement::Given(d) | Statement::Let(d) => self.add(&d.value, Asked::Nothing),
            Statement::Gravity(value) => self.add(value, Asked::Positive),
            Statement::Ground(ground) => self.body(None, &ground.body),
            Statement::Link(link) => self.body(link.bar.as_ref(), &link.body),
            Statement::Joint(joint) => {
                use JointKind::{Cylinder, Prismatic, Revolute, Slot};
                let known = matches!(joint.kind.node, Revolute | Prismatic | Slot | Cylinder);
                known.then(|| self.properties(&joint.properties))?
            }
            Statement::All(all) => self.properties(&all.properties),
            Statement::Spring(spring) => self.properties(&spring.properties),
            // a point may be two coordinates
            Statement::Drive(drive) if drive.target.tail.is_some() => None,
            Statement::Drive(drive) => {
                match &drive.position {
                    None => {}
                    Some(DrivePosition::Values(values)) => self.sensed(values)?,
                    Some(DrivePosition::Range(course)) => {
                        self.none([&course.from, &course.to, course.steps.expr()])?;
                    }
                }
                self.sensed(drive.rate.iter().chain(&drive.acceleration))
            }
            Statement::Pose(pose) => self.settings(&pose.settings),
            Statement::Assemble(assemble) => assemble.clauses.iter().try_for_each(|c| match &c.node {
                AssembleClause::Near { at, .. } => self.add(at, Asked::Nothing),
                AssembleClause::Sign { bound, .. } => self.add(bound, Asked::Nothing),
                AssembleClause::Side { .. } | AssembleClause::Order { .. } => Some(()),
                AssembleClause::Phase { .. } => None,
            }),
            Statement::Balance(balance) => {
                self.site(&balance.site)?;
                self.all(&balance.along, Asked::Direction)
            }
            Statement::Load(load) => {
                self.site(&load.site)?;
                self.none(&load.when)?;
                self.add(&load.value.value, Asked::Nothing)
            }
            Statement::Find(find) => find.items.iter().try_for_each(|item| {
                self.none(&item.steps)?;
                self.add(&item.value, Asked::Nothing)
            }),
            Statement::Expect(expect) => self.expect(expect),
            Statement::Shaft(_)
            | Statement::Slider(_)
            | Statement::Brake(_)
            | Statement::Cam(_)
            | Statement::Flywheel(_)
            | Statement::Counterweight(_)
            | Statement::Curve(_)
            | Statement::Start(_)
            | Statement::Equilibrium(_)
            | Statement::Simulate(_)
            | Statement::Event(_)
            | Statement::Until(_)
            | Statement::Stop(_)
            | Statement::Bad(_) => None,
        }
    }

    fn body(&mut self, bar: Option<&'d Bar>, body: &'d Body) -> Option<()> {
        let of_body = body.iter().filter_map(|m| match &m.node {
            Member::Point(point) => Some(&point.at),
            _ => None,
        });
        let moved = of_body.chain(bar.map(|bar| &bar.length)).any(|e| self.depends(e));
        let heavier = body.iter().any(|m| match &m.node {
            Member::Mass(at) | Member::Weight(at) => self.depends(&at.value),
            _ => false,
        });
        let masses = body.iter().filter(|m| matches!(m.node, Member::Mass(_) | Member::Weight(_))).count();
        let shapes = body.iter().filter_map(|m| match &m.node {
            Member::Mass(at) | Member::Weight(at) => at.shape.as_ref(),
            _ => None,
        });
        let summed = masses > 1 || shapes.clone().next().is_some();
        // the sums follow from all of them
        if summed && (moved || heavier) {
            return None;
        }
        self.none(shapes.flat_map(|shape| shape.values()))?;
        let planes = body.iter().filter_map(|m| match &m.node {
            Member::Mass(at) | Member::Weight(at) => at.plane.as_ref(),
            Member::Plane(at) => Some(at),
            _ => None,
        });
        // the couples of the masses follow from all of them
        if planes.clone().next().is_some() && (moved || heavier) {
            return None;
        }
        self.none(planes)?;
        let has_mass = masses > 0;
        self.all(bar.map(|bar| &bar.length), Asked::Positive)?;
        for member in body {
            match &member.node {
                Member::Point(point) => self.add(&point.at, Asked::Nothing)?,
                // they follow from other points
                Member::PointFrom(_) if moved => return None,
                Member::PointFrom(point) => self.none([&point.first_distance, &point.second_distance])?,
                Member::Line(line) => match &line.direction {
                    LineDirection::Along(angle) => self.add(angle, Asked::Direction)?,
                    LineDirection::To(_) => (!moved).then_some(())?,
                },
                Member::Circle(circle) => self.add(&circle.radius, Asked::Positive)?,
                Member::Mass(at) | Member::Weight(at) => {
                    let is_mass = matches!(member.node, Member::Mass(_));
                    self.add(&at.value, if is_mass { Asked::Positive } else { Asked::Weight })?;
                    match &at.inertia {
                        Some(inertia) if summed => self.none([inertia])?,
                        inertia => self.all(inertia, Asked::NotNegative)?,
                    }
                }
                // less the part of the mass, by its distance
                Member::Inertia(inertia) if inertia.about.is_some() && has_mass => {
                    (!moved && !heavier).then_some(())?;
                    self.none([&inertia.value])?;
                }
                Member::Inertia(inertia) => self.add(&inertia.value, Asked::NotNegative)?,
                Member::Plane(_) => {}
                Member::Wheel(_) | Member::Profile(_) | Member::Bad(_) => return None,
            }
        }
        Some(())
    }

    fn expect(&mut self, expect: &'d Expect) -> Option<()> {
        self.none(expect.within.iter().chain([&expect.what]))?;
        if let Some(ExpectAt::Settings(all)) = &expect.at {
            self.none(all.iter().map(|s| &s.value.value))?;
        }
        for value in expect.values.iter().filter(|value| depends(self.names, value)) {
            is_plain(self.names, value).then_some(())?;
            self.expected.push((value, expect.within.as_ref()));
        }
        Some(())
    }

    /// What is zero, or is not, may call for other steps.
    fn properties(&mut self, properties: &'d [Property]) -> Option<()> {
        properties.iter().try_for_each(|property| {
            let asked = match property.name.node.as_str() {
                "friction"
                | "friction_circle"
                | "equivalent_friction"
                | "radius"
                | "stiffness"
                | "free_length"
                | "damping" => Asked::Positive,
                "free_angle" => Asked::Nothing,
                _ => {
                    self.none(&property.values)?;
                    return self.properties(&property.properties);
                }
            };
            self.all(&property.values, asked)?;
            self.properties(&property.properties)
        })
    }

    fn settings(&mut self, settings: &'d [Setting]) -> Option<()> {
        self.sensed(settings.iter().map(|s| &s.value))
    }

    fn sensed(&mut self, sensed: impl IntoIterator<Item = &'d Sensed>) -> Option<()> {
        self.all(sensed.into_iter().map(|s| &s.value), Asked::Nothing)
    }

    fn site(&mut self, site: &'d Site) -> Option<()> {
        match site {
            Site::Link { at: Some(Place::Ground(place)), .. } => self.add(place, Asked::Nothing),
            // its resultant follows from two points and two values
            Site::Segment { .. } => None,
            Site::Link { .. } | Site::Pair(_) | Site::Pin(_) => Some(()),
        }
    }
}
