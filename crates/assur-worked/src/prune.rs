//! What nothing needs is left out: coordinates and components that no other equation uses and nobody asked for.

use crate::course::Derivation;
use crate::document::{Block, text};
use crate::motion::Stage;
use crate::words::Message;
use assur_formula::{Equation, Expr, Name, Unit};
use assur_math::math::Vec2;
use assur_model::model::{FindKind, PointRef, Query};
use std::collections::BTreeSet;

impl Derivation<'_> {
    /// Leaves out equations that are not used; returns the places of their blocks.
    pub fn prune(&mut self) -> BTreeSet<usize> {
        let mut used: BTreeSet<Name> = self.asked.clone();
        let mut unused = BTreeSet::new();
        for (place, equation) in self.equations.iter().rev() {
            let optional = is_part(equation) || self.optional.contains(place);
            if optional && !used.contains(&equation.left.name) {
                unused.insert(*place);
                continue;
            }
            equation.right.visit(&mut |q| {
                used.insert(q.name.clone());
            });
        }
        let needless = |(place, name): &&(usize, Name)| self.optional.contains(place) && !used.contains(name);
        unused.extend(self.lines.iter().filter(needless).map(|(place, _)| *place));
        self.equations.retain(|(place, _)| !unused.contains(place));
        unused
    }

    /// The values that are written without an equation which gives or confirms them.
    pub fn stated_alone(&self, unused: &BTreeSet<usize>) -> Vec<Name> {
        let derived: BTreeSet<&Name> = self.equations.iter().map(|(_, e)| &e.left.name).collect();
        let alone = self.lines.iter().filter(|(place, name)| {
            let has_equation = self.solutions.contains(name) || derived.contains(name);
            !unused.contains(place) && !has_equation && !self.is_given(name) && !self.taken.contains(name)
        });
        alone.map(|(_, name)| name.clone()).collect()
    }

    /// Sentences that end before an equation which is nothing, or is left out, say so.
    pub fn say_nothing_follows(&mut self, unused: &BTreeSet<usize>) {
        for place in std::mem::take(&mut self.awaiting) {
            let mut later = (place + 1..self.blocks.len()).filter(|i| !unused.contains(i));
            let next = later.next().and_then(|i| self.blocks.get(i));
            if matches!(next, Some(Block::Equation(_) | Block::Vectors(_) | Block::Table(_))) {
                continue;
            }
            if let Some(Block::Paragraph(line)) = self.blocks.get_mut(place) {
                line.push(text(" 0."));
            }
        }
    }

    /// Motion of points that the file asks for and that no step needed.
    pub fn requests(&mut self, stage: Stage) {
        let mechanism = self.scene.mechanism();
        let mut points = Vec::new();
        for find in &mechanism.finds {
            let FindKind::Value { expr, .. } = &find.kind else { continue };
            mechanism.each_query(expr, &mut |query| {
                let wanted = match (stage, query) {
                    (Stage::Positions, Query::Position(p))
                    | (Stage::Velocities, Query::Velocity(p))
                    | (Stage::Accelerations, Query::Acceleration(p)) => Some(p),
                    _ => None,
                };
                if let (Stage::Positions, Query::Angle(link)) = (stage, query) {
                    self.asked.insert(Name::new("φ", &self.label(link.index())));
                }
                if let Some(PointRef::Fixed(link, at)) = wanted {
                    points.push((link.index(), *at));
                }
            });
        }
        let before = self.blocks.len();
        let order = match stage {
            Stage::Positions => 0,
            Stage::Velocities => 1,
            Stage::Accelerations => 2,
        };
        for (body, at) in points {
            let found = match order {
                0 => self.position(body, at),
                1 => self.velocity(body, at),
                _ => self.acceleration(body, at),
            };
            for part in &found {
                part.visit(&mut |q| {
                    self.asked.insert(q.name.clone());
                });
            }
            self.size_of_asked(order, (body, at), &found);
        }
        if self.blocks.len() > before {
            let words = crate::words::say(self.language, Message::AskedFor, &[]);
            self.insert(before, vec![Block::Paragraph(words)]);
        }
        self.asked_of_guides(stage);
    }
}

impl Derivation<'_> {
    /// The magnitude of a velocity (1) or acceleration (2) that the file asks for, where it has two components and none was found yet.
    fn size_of_asked(&mut self, order: usize, (body, at): (usize, Vec2), parts: &[Expr; 2]) {
        let (letter, unit) = match order {
            1 => ("v", Unit::Velocity),
            2 => ("a", Unit::Acceleration),
            _ => return,
        };
        let name = Name::new(letter, &self.point_name(body, at));
        if parts.iter().any(Expr::is_zero) || self.found.contains_key(&name) {
            return;
        }
        self.length_of(name, unit, parts);
    }
}

/// Whether an equation is of a coordinate or of a component of motion.
fn is_part(equation: &Equation) -> bool {
    let name = &equation.left.name;
    let letter = name.letter.trim_end_matches('′');
    match letter {
        "x" | "y" => true,
        "v" | "a" => name.sub.ends_with(['x', 'y']),
        _ => false,
    }
}
