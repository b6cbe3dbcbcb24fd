//! Forces and couples that are known on a body.

use crate::course::Derivation;
use crate::document::{Line, text};
use crate::motion::heading_of;
use assur_formula::{Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_position::position::{Action, Origin};
use std::collections::BTreeMap;

/// A known force on a body.
#[derive(Clone, Debug)]
pub struct Force {
    /// Its letters.
    pub name: Name,
    /// Its place in the frame of the body, m.
    pub at: Vec2,
    /// Its components.
    pub parts: [Expr; 2],
    /// Its magnitude and direction in a vector equation.
    pub known: [Line; 2],
    /// What it comes from; none of a rest of loads.
    pub from: Option<Origin>,
}

/// A known couple on a body.
#[derive(Clone, Debug)]
pub struct Couple {
    /// Its value.
    pub value: Expr,
    /// What it comes from; none of a rest of loads.
    pub from: Option<Origin>,
}

/// Whether something is a load, with friction or without: neither a reaction nor an effort.
pub const fn is_load(from: Option<Origin>, with_friction: bool) -> bool {
    match from {
        Some(Origin::Friction(_)) => with_friction,
        Some(Origin::Reaction(_) | Origin::Law(_) | Origin::Effort(_)) => false,
        None | Some(Origin::Load(_) | Origin::Weight | Origin::Inertia | Origin::Spring(_)) => true,
    }
}

/// All that is known to act on the bodies.
#[derive(Clone, Debug, Default)]
pub struct FreeBodies {
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

impl FreeBodies {
    /// Nothing yet.
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

impl Derivation<'_> {
    /// Writes a force on the body on which it acts, and the opposite on the one that does it.
    pub(super) fn put_force(&mut self, action: &Action, name: &Name, parts: &[Expr; 2], known: &[Line; 2]) {
        for (side, parts) in
            [(Some(*action), parts.clone()), (action.opposite(), parts.clone().map(|part| -part))]
        {
            let Some(Action { on, at, from, .. }) = side.filter(|side| side.on != 0) else { continue };
            let moved = self.moved(on);
            let at = (at - moved.p).turned_back(moved.u);
            let (name, known, from) = (name.clone(), known.clone(), Some(from));
            self.free.forces[on].push(Force { name, at, parts, known, from });
        }
    }

    /// Writes a couple on the body on which it acts, and the opposite on the one that does it.
    pub(super) fn put_couple(&mut self, action: &Action, value: &Expr) {
        self.free.couples[action.on].push(Couple { value: value.clone(), from: Some(action.from) });
        if let Some(by) = action.by {
            self.free.couples[by].push(Couple { value: -value.clone(), from: Some(action.from) });
        }
    }

    /// Keeps the reaction in a joint as a force of one body on another: the other gets the opposite.
    pub fn carry(&mut self, slot: usize, parts: &[Expr; 2], couple: &Expr) {
        if let Some(action) = self.scene.view().actions_from(Origin::Reaction(slot)).pop() {
            self.carry_at(action.at, slot, parts, couple);
        }
    }

    /// The same with the couple about another place.
    pub(super) fn carry_at(&mut self, at: Vec2, slot: usize, parts: &[Expr; 2], couple: &Expr) {
        let Some(action) = self.scene.view().actions_from(Origin::Reaction(slot)).pop() else { return };
        let Some(back) = action.opposite().map(|back| Action { by: None, at, ..back }) else { return };
        let (from, on) = (back.on, action.on);
        // hinges are named by bodies, welds by their parts
        let weld = self.scene.model.plan.welds.iter().any(|weld| weld.slot == slot);
        let own = |slot: usize| if weld { slot } else { self.body_of(slot) };
        let (from, on) = (own(from), own(on));
        let name = self.reaction_name(from, on);
        self.free.reactions[slot] = Some(name.clone());
        if back.on == 0 {
            return;
        }
        let [x, y] = parts.clone().map(|part| -part);
        if !(x.is_zero() && y.is_zero()) {
            let size = self.found.get(&name).map(crate::course::cell).unwrap_or_default();
            let along = self.free.lines.get(&name).cloned();
            let along = along.unwrap_or_else(|| vec![text(format!("{}°", heading_of(&x, &y)))]);
            self.put_force(&back, &self.reaction_name(on, from), &[x, y], &[size, along]);
        }
        if !couple.is_zero() {
            self.put_couple(&back, &-couple.clone());
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

    /// The same from the sums of forces on one of the two bodies.
    pub(super) fn reaction_in_sums(
        &mut self,
        [from, on]: [usize; 2],
        value: Vec2,
        right: [Expr; 2],
        freed: usize,
    ) -> [Expr; 2] {
        let name = self.reaction_name(from, on);
        let [x, y] = right;
        let parts = [("x", value.x, x), ("y", value.y, y)].map(|(axis, value, right)| {
            let at = self.blocks.len();
            let found = self.equate(name.and(axis), value, Unit::Force, right.clone());
            let sum = if freed == on { found.clone() - right } else { right - found.clone() };
            self.balanced(at, &Name::new("ΣF", axis), &sum);
            found
        });
        self.magnitude(name, &parts);
        parts
    }

    /// The magnitude of a force from its components.
    pub fn magnitude(&mut self, name: Name, parts: &[Expr; 2]) -> Expr {
        self.length_of(name, Unit::Force, parts)
    }
}
