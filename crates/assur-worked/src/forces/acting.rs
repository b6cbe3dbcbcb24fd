//! Forces and couples that are known on a body.

use crate::course::Course;
use crate::document::{Line, text};
use crate::motion::heading_of;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use std::collections::BTreeMap;

/// A known force on a body.
#[derive(Clone, Debug)]
pub struct Force {
    pub name: Name,
    /// Its place in the frame of the body, m.
    pub at: Vec2,
    pub parts: [Expr; 2],
    /// Its magnitude and direction in a vector equation.
    pub known: [Line; 2],
    /// It comes from outside: a load, and no reaction.
    pub load: bool,
    /// It is friction, or what a wheel puts on its carrier: the solver's sum of loads does not have it.
    pub rubs: bool,
}

/// A known couple on a body.
#[derive(Clone, Debug)]
pub struct Couple {
    pub value: Expr,
    /// It is a load.
    pub load: bool,
    pub rubs: bool,
}

impl Couple {
    /// Whether it is the quantity with these letters, or its opposite.
    pub fn has_letters(&self, name: &Name) -> bool {
        match &self.value {
            Expr::Leaf(q) => q.name == *name,
            Expr::Neg(x) => matches!(&**x, Expr::Leaf(q) if q.name == *name),
            _ => false,
        }
    }
}

/// All that is known to act on the bodies.
#[derive(Clone, Debug, Default)]
pub struct Acting {
    /// Forces, by body.
    pub forces: Vec<Vec<Force>>,
    /// Couples, by body.
    pub couples: Vec<Vec<Couple>>,
    /// Reactions found: letters, components, couple; by slot.
    pub reactions: Vec<Option<Name>>,
    /// Lines along which reactions on links without loads act.
    pub lines: BTreeMap<Name, Line>,
    /// Reactions that are stated, by slot: components and couple.
    pub stated: Vec<Option<([Expr; 2], Expr)>>,
}

impl Acting {
    pub fn of(bodies: usize, reactions: usize) -> Self {
        Self {
            forces: vec![Vec::new(); bodies],
            couples: vec![Vec::new(); bodies],
            reactions: vec![None; reactions],
            lines: BTreeMap::new(),
            stated: vec![None; reactions],
        }
    }
}

impl Course<'_> {
    /// Keeps the reaction in a joint as a force of one body on another: the other gets the opposite.
    pub fn carry(
        &mut self,
        from: usize,
        on: usize,
        place: Vec2,
        parts: &[Expr; 2],
        couple: &Expr,
        slot: usize,
    ) {
        let name = self.reaction_name(from, on);
        if let Some(kept) = self.acting.reactions.get_mut(slot) {
            *kept = Some(name.clone());
        }
        if from == 0 {
            return;
        }
        let opposite = self.reaction_name(on, from);
        let body = self.moved(from);
        let at = (place - body.p).turned_back(body.u);
        let size = self.found.get(&name).cloned();
        let size = size.as_ref().map(crate::course::cell).unwrap_or_default();
        let [x, y] = parts.clone();
        if !(x.is_zero() && y.is_zero()) {
            let along = self.acting.lines.get(&name).cloned();
            let along =
                along.unwrap_or_else(|| vec![text(format!("{}°", heading_of(&-x.clone(), &-y.clone())))]);
            let known = [size, along];
            self.acting.forces[from].push(Force {
                name: opposite.clone(),
                at,
                parts: [-x, -y],
                known,
                load: false,
                rubs: false,
            });
        }
        if !couple.is_zero() {
            self.acting.couples[from].push(Couple { value: -couple.clone(), load: false, rubs: false });
        }
    }

    /// The components of a reaction from its parts, and its magnitude.
    pub fn reaction(&mut self, from: usize, on: usize, value: Vec2, right: [Expr; 2]) -> [Expr; 2] {
        let name = self.reaction_name(from, on);
        let [x, y] = right;
        let parts = [
            self.equate(name.and("x"), value.x, Unit::Force, x),
            self.equate(name.and("y"), value.y, Unit::Force, y),
        ];
        self.magnitude(name, &parts);
        parts
    }

    /// The magnitude of a force from its components.
    pub fn magnitude(&mut self, name: Name, parts: &[Expr; 2]) -> Expr {
        self.length_of(name, Unit::Force, parts)
    }
}
