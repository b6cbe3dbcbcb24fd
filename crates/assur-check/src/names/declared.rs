//! Declared names: what they are and where.

use crate::names::uses::Uses;
use assur_model::model::{BalanceId, Link, LinkId, LoadId, Mechanism, PairId};
use assur_syntax::document::{
    Arg, Balance, Column, Curve, Expect, Expr, ExprKind, FindItem, JointKind, Load,
};
use assur_text::language::Function;
use assur_text::source::Span;
use indexmap::{IndexMap, IndexSet};

/// A declared name: what it is and where.
#[derive(Clone, Debug)]
pub struct Declared<T> {
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
    /// The torque of a brake, and its place among the loads of the file.
    Brake(LoadId),
    /// An unknown effort, and its place among the balances of the file.
    Balance(BalanceId, &'a Balance),
    /// A flywheel, the moment of inertia found: its place among the flywheels of the file.
    Flywheel(usize),
    /// A column of variants that no `given` declares: for an `expect`.
    Column(&'a Column),
    Curve(&'a Curve),
}

impl QuantityKind<'_> {
    /// What it is called, with its article.
    pub const fn phrase(self) -> &'static str {
        match self {
            Self::Given(_) => "a `given`",
            Self::Let(_) => "a `let`",
            Self::Find(_) => "an item of `find`",
            Self::Load(..) => "a load",
            Self::Brake(_) => "a brake",
            Self::Balance(..) => "an unknown effort",
            Self::Flywheel(_) => "a flywheel",
            Self::Column(_) => "a column of variants",
            Self::Curve(_) => "a curve",
        }
    }
}

/// What a thing's name stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ThingKind {
    Link,
    /// A pair or a transmission.
    Joint(JointKind),
    Group,
    Spring,
    Cam,
    Shaft,
    /// A slider on a rope.
    Slider,
    Wheel,
    Counterweight,
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
            Self::Counterweight => "a counterweight".into(),
            Self::Idler => "an idler".into(),
        }
    }
}

/// Names inside one link.
#[derive(Clone, Debug, Default)]
pub struct Inside {
    /// Points, in the order written.
    pub points: IndexMap<String, Span>,
    pub lines: IndexMap<String, Span>,
    /// Circles and cam profiles.
    pub circles: IndexMap<String, Span>,
    /// Names that stand in members that could not be read.
    pub bad: IndexSet<String>,
}

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
    pub numbers: IndexMap<String, Span>,
    /// What belongs to each link, by its id.
    pub inside: Vec<Inside>,
    /// The links that declare a point of a name.
    pub bearers: IndexMap<String, Vec<LinkId>>,
    pub poses: IndexMap<String, Span>,
    /// Events, in the order of the file.
    pub events: IndexMap<String, Span>,
    /// The answer key by what it speaks of, as written.
    pub expected: IndexMap<&'a str, Vec<&'a Expect>>,
    /// Names that stand in statements that could not be read.
    pub bad: IndexSet<String>,
    /// The file follows a motion under loads: `time` is its instant.
    pub simulates: bool,
    /// The word `ground`, where the ground is described.
    pub ground: Option<Span>,
    /// Where names are used.
    pub uses: Uses,
}

impl Names<'_> {
    /// Enters a point of a link by its name alone.
    pub fn add_bearer(&mut self, point: &str, link: LinkId) {
        match self.bearers.get_mut(point) {
            Some(links) if links.last() == Some(&link) => {}
            Some(links) => links.push(link),
            None => _ = self.bearers.insert(point.to_owned(), vec![link]),
        }
    }

    /// Enters a link, without its parts, into the mechanism.
    pub fn add_link(
        &mut self,
        mech: &mut Mechanism,
        name: String,
        number: Option<String>,
        span: Span,
    ) -> LinkId {
        let id = LinkId::at(mech.links.len());
        self.links.entry(name.clone()).or_insert(id);
        mech.links.push(Link { name, number, span, ..Link::default() });
        id
    }
}

// Which calls ask for results.

impl Names<'_> {
    /// Whether a call asks for something that is known only once the mechanism is solved.
    pub fn is_result(&self, function: &str, args: &[Arg]) -> bool {
        match Function::named(function) {
            Some(Function::Dir) => match args {
                [Arg { value: Expr { kind: ExprKind::Name(name), .. }, .. }] => {
                    !self.quantities.contains_key(name)
                }
                _ => false,
            },
            Some(Function::Max | Function::Min) => args.len() == 1,
            // the file's own curve of that name
            Some(f) if f.yields_to_curve() && self.quantities.contains_key(function) && !args.is_empty() => {
                !self.quantities.get(function).is_some_and(|d| matches!(d.what, QuantityKind::Curve(_)))
            }
            function => function.is_some_and(|f| f.row().is_result()),
        }
    }
}

// What the table of functions says of a name.

/// Whether a function's arguments are values; those of an unknown one are taken for values.
pub fn takes_values(function: &str) -> bool {
    Function::named(function).is_none_or(|f| f.row().takes_values())
}

/// The function of that name, if what it asks of things is known only once the mechanism is solved.
pub fn of_things(name: &str) -> Option<Function> {
    Function::named(name).filter(|f| f.row().is_result() && !f.row().takes_values())
}

/// How a function is written.
pub fn usage(function: &str) -> String {
    Function::named(function).map_or_else(String::new, |f| f.row().usage.to_owned())
}

/// What may be asked of a thing whose name stands where a value is due.
pub fn ask_of(kind: ThingKind, name: &str) -> Option<String> {
    let asked = match kind {
        ThingKind::Link => [format!("angle({name})"), format!("omega({name})")],
        ThingKind::Joint(JointKind::Revolute | JointKind::Weld) => {
            [format!("position({name})"), format!("mag(reaction({name}))")]
        }
        ThingKind::Joint(JointKind::Prismatic | JointKind::Slot | JointKind::Cylinder) => {
            [format!("displacement({name})"), format!("relative_velocity({name})")]
        }
        ThingKind::Shaft | ThingKind::Wheel => [format!("omega({name})"), format!("alpha({name})")],
        ThingKind::Slider => [format!("speed({name})"), format!("velocity({name})")],
        _ => return None,
    };
    Some(format!("ask for one of its quantities: `{}` or `{}`", asked[0], asked[1]))
}
