//! What a text declares, in its order.

use assur_syntax::document::{Body, Document, End, Member, Name, Statement};
use assur_text::source::{Span, Spanned};

/// What a symbol is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SymbolKind {
    /// `given`
    Given,
    /// `let`, a curve
    Derived,
    /// A link, a shaft, a slider, the ground.
    Link,
    /// A point of a link.
    Point,
    /// A line, a circle or a profile of a link.
    Shape,
    /// A wheel of a link, an idler of a rope.
    Wheel,
    /// A pair, a transmission, a spring.
    Pair,
    /// A cam, a flywheel, a brake.
    Element,
    /// A force, a torque, an unknown effort.
    Load,
    Pose,
    Event,
    Group,
    Answer,
}

impl SymbolKind {
    /// What it is called, with its article.
    #[must_use]
    pub const fn phrase(self) -> &'static str {
        match self {
            Self::Given => "a given value",
            Self::Derived => "a computed value",
            Self::Link => "a link",
            Self::Point => "a point",
            Self::Shape => "a line, circle or profile",
            Self::Wheel => "a wheel",
            Self::Pair => "a pair or a transmission",
            Self::Element => "a machine element",
            Self::Load => "a load",
            Self::Pose => "a pose",
            Self::Event => "an event",
            Self::Group => "a structural group",
            Self::Answer => "an answer",
        }
    }
}

#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    pub name: String,
    pub kind: SymbolKind,
    /// All that declares it.
    pub whole: Span,
    pub at: Span,
    /// What belongs to it.
    pub parts: Vec<Symbol>,
}

impl Symbol {
    pub(super) fn new(name: &Name, kind: SymbolKind, whole: Span) -> Self {
        Self { name: name.node.clone(), kind, whole, at: name.span, parts: Vec::new() }
    }

    fn with(self, body: &Body) -> Self {
        Self { parts: parts(body), ..self }
    }
}

/// All that a document declares.
#[must_use]
pub fn symbols(document: &Document) -> Vec<Symbol> {
    document.statements.iter().flat_map(of_statement).collect()
}

fn of_statement(statement: &Spanned<Statement>) -> Vec<Symbol> {
    let whole = statement.span;
    let one = |name: &Name, kind| vec![Symbol::new(name, kind, whole)];
    match &statement.node {
        Statement::Given(definition) => one(&definition.name, SymbolKind::Given),
        Statement::Let(definition) => one(&definition.name, SymbolKind::Derived),
        Statement::Curve(curve) => one(&curve.name, SymbolKind::Derived),
        Statement::Ground(ground) => {
            let word = Span::new(whole.start, whole.start + "ground".len());
            let name = Spanned::new("ground".to_owned(), word);
            vec![Symbol::new(&name, SymbolKind::Link, whole).with(&ground.body)]
        }
        Statement::Link(link) => {
            let mut symbol = Symbol::new(&link.name, SymbolKind::Link, whole);
            let ends = link.bar.iter().flat_map(|bar| [&bar.from, &bar.to]);
            symbol.parts = ends.map(|end| Symbol::new(end, SymbolKind::Point, end.span)).collect();
            symbol.parts.extend(parts(&link.body));
            vec![symbol]
        }
        Statement::Shaft(shaft) => vec![Symbol::new(&shaft.name, SymbolKind::Link, whole).with(&shaft.body)],
        Statement::Slider(slider) => {
            vec![Symbol::new(&slider.name, SymbolKind::Link, whole).with(&slider.body)]
        }
        Statement::Joint(joint) => {
            let mut symbol = Symbol::new(&joint.name, SymbolKind::Pair, whole);
            let idlers = joint.ends.iter().filter_map(|end| match end {
                End::Over(name) => Some(name),
                _ => None,
            });
            symbol.parts = idlers.map(|name| Symbol::new(name, SymbolKind::Wheel, name.span)).collect();
            vec![symbol]
        }
        Statement::Spring(spring) => one(&spring.name, SymbolKind::Pair),
        Statement::Group(group) => one(&group.name, SymbolKind::Group),
        Statement::Pose(pose) => one(&pose.name, SymbolKind::Pose),
        Statement::Event(event) => one(&event.name, SymbolKind::Event),
        Statement::Balance(balance) => one(&balance.name, SymbolKind::Load),
        Statement::Load(load) => load.name.iter().flat_map(|name| one(name, SymbolKind::Load)).collect(),
        Statement::Brake(brake) => one(&brake.name, SymbolKind::Element),
        Statement::Cam(cam) => one(&cam.name, SymbolKind::Element),
        Statement::Counterweight(weight) => one(&weight.name, SymbolKind::Element),
        Statement::Flywheel(flywheel) => one(&flywheel.name, SymbolKind::Element),
        Statement::Find(find) => {
            let named = find.items.iter().filter_map(|item| Some((item.name.as_ref()?, item.span)));
            named.map(|(name, span)| Symbol::new(name, SymbolKind::Answer, span)).collect()
        }
        _ => Vec::new(),
    }
}

fn parts(body: &Body) -> Vec<Symbol> {
    let part = |member: &Spanned<Member>| {
        let (name, kind) = match &member.node {
            Member::Point(point) => (&point.name, SymbolKind::Point),
            Member::PointFrom(point) => (&point.name, SymbolKind::Point),
            Member::Line(line) => (&line.name, SymbolKind::Shape),
            Member::Circle(circle) => (&circle.name, SymbolKind::Shape),
            Member::Profile(profile) => (&profile.name, SymbolKind::Shape),
            Member::Wheel(wheel) => (&wheel.name, SymbolKind::Wheel),
            _ => return None,
        };
        Some(Symbol::new(name, kind, member.span))
    };
    body.iter().filter_map(part).collect()
}
