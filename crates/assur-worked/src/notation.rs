//! The letters of the equations, and what they stand for.

use crate::course::Derivation;
use crate::document::{Block, Inline, Line, text};
use crate::words::{Language, SymbolMessage, say};
use assur_formula::{Name, Quantity, Unit, name_node};
use std::collections::BTreeSet;

/// A letter as the list has it, whether a quantity is one of those, and what it says.
struct Symbol {
    letters: &'static [&'static str],
    unit: Unit,
    /// The mark above.
    mark: &'static str,
    is: Is,
    said: SymbolMessage,
}

/// Which quantities of a letter and a unit are meant.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Is {
    /// All of them.
    All,
    /// Those that the solution finds.
    Found,
    /// Those that the file gives.
    Given,
    /// With the index of inertia forces.
    OfInertia,
    /// Reduced to one coordinate.
    Reduced,
    /// The force of one link on another, named by both.
    Reaction,
}

const fn symbol(letters: &'static [&'static str], unit: Unit, is: Is, said: SymbolMessage) -> Symbol {
    Symbol { letters, unit, mark: "", is, said }
}

const fn marked(letters: &'static [&'static str], unit: Unit, is: Is, said: SymbolMessage) -> Symbol {
    Symbol { letters, unit, mark: "n", is, said }
}

const SYMBOLS: &[Symbol] = &[
    symbol(&["x", "y"], Unit::Length, Is::All, SymbolMessage::Coordinates),
    symbol(&["l"], Unit::Length, Is::All, SymbolMessage::Distance),
    symbol(&["s"], Unit::Length, Is::Found, SymbolMessage::Slide),
    symbol(&["φ"], Unit::Angle, Is::All, SymbolMessage::LinkAngle),
    symbol(&["δ"], Unit::Angle, Is::Found, SymbolMessage::LineAngle),
    symbol(&["β"], Unit::Angle, Is::Found, SymbolMessage::TriangleAngle),
    symbol(&["γ"], Unit::Angle, Is::Given, SymbolMessage::OwnAngle),
    symbol(&["v"], Unit::Velocity, Is::All, SymbolMessage::Velocity),
    symbol(&["ω"], Unit::AngularVelocity, Is::All, SymbolMessage::AngularVelocity),
    symbol(&["a"], Unit::Acceleration, Is::All, SymbolMessage::Acceleration),
    marked(&["a"], Unit::Acceleration, Is::All, SymbolMessage::Parts),
    symbol(&["α"], Unit::AngularAcceleration, Is::All, SymbolMessage::AngularAcceleration),
    symbol(&["m"], Unit::Mass, Is::All, SymbolMessage::Mass),
    symbol(&["J"], Unit::Inertia, Is::Given, SymbolMessage::Inertia),
    symbol(&["G"], Unit::Force, Is::All, SymbolMessage::Weight),
    symbol(&["F"], Unit::Force, Is::OfInertia, SymbolMessage::InertiaForce),
    symbol(&["M"], Unit::Torque, Is::OfInertia, SymbolMessage::InertiaCouple),
    symbol(&["h"], Unit::Length, Is::OfInertia, SymbolMessage::InertiaArm),
    symbol(&["Q"], Unit::Force, Is::Found, SymbolMessage::KnownForces),
    symbol(&["R"], Unit::Force, Is::Reaction, SymbolMessage::Reaction),
    symbol(&["r"], Unit::Length, Is::Given, SymbolMessage::Radius),
    symbol(&["z"], Unit::One, Is::Given, SymbolMessage::Teeth),
    symbol(&["c"], Unit::Stiffness, Is::All, SymbolMessage::Stiffness),
    symbol(&["k"], Unit::Damping, Is::All, SymbolMessage::Damping),
    symbol(&["f"], Unit::One, Is::Given, SymbolMessage::FrictionCoefficient),
    symbol(&["P"], Unit::Power, Is::Found, SymbolMessage::Power),
    symbol(&["η"], Unit::One, Is::All, SymbolMessage::Efficiency),
    symbol(&["T"], Unit::Work, Is::All, SymbolMessage::KineticEnergy),
    symbol(&["J"], Unit::Inertia, Is::Reduced, SymbolMessage::ReducedInertia),
    symbol(&["M"], Unit::Torque, Is::Reduced, SymbolMessage::ReducedTorque),
];

impl Derivation<'_> {
    /// The letters that the equations use, with what they stand for, in one line.
    pub(crate) fn notation(&self) -> Option<Block> {
        let between = if self.language == Language::Chinese { "；" } else { "; " };
        let mut line: Line = Vec::new();
        for symbol in SYMBOLS {
            let names = self.names_of(symbol);
            if names.is_empty() {
                continue;
            }
            if !line.is_empty() {
                line.push(text(between));
            }
            for (i, name) in names.iter().enumerate() {
                line.extend((i > 0).then(|| text(", ")));
                line.push(Inline::Math(name_node(name)));
            }
            line.push(text(" – "));
            line.extend(say(self.language, symbol.said, &[]));
        }
        (!line.is_empty()).then(|| Block::Remark(say(self.language, SymbolMessage::Symbols, &[line])))
    }

    /// The letters of a symbol as the equations have them: without index, but of inertia forces and reactions.
    fn names_of(&self, symbol: &Symbol) -> Vec<Name> {
        let own = self.language.letters();
        let mut found: BTreeSet<Name> = BTreeSet::new();
        let mut look = |q: &Quantity| {
            let is_reaction = symbol.is == Is::Reaction;
            let letter = if is_reaction { own.reaction.0 } else { q.name.letter.as_str() };
            let meant = if is_reaction {
                q.name.letter == own.reaction.0
                    && self.is_between_links(q.name.sub.strip_prefix(own.reaction.1))
            } else {
                symbol.letters.contains(&letter) && self.is_meant(symbol.is, q, own.inertia)
            };
            if !meant || q.unit != symbol.unit || q.name.sup != symbol.mark || q.name.vector {
                return;
            }
            let name = match symbol.is {
                Is::OfInertia => Name::new(letter, own.inertia),
                Is::Reaction if found.is_empty() => {
                    Name::new(letter, q.name.sub.trim_end_matches(['x', 'y']).trim_end_matches(','))
                }
                Is::Reaction => return,
                Is::Reduced => Name::new(letter, "r"),
                _ => Name::new(letter, ""),
            };
            found.insert(name.marked(symbol.mark));
            if symbol.mark == "n" {
                found.insert(Name::new(letter, "").marked("t"));
            }
        };
        for (_, equation) in &self.equations {
            look(&equation.left);
            equation.right.visit(&mut |q| look(q));
        }
        found.into_iter().collect()
    }

    fn is_meant(&self, is: Is, q: &Quantity, inertia: &str) -> bool {
        let index = q.name.sub.as_str();
        match is {
            Is::All => !index.is_empty() || !q.given,
            Is::Found => !index.is_empty() && !q.given,
            Is::Given => !index.is_empty() && q.given,
            Is::OfInertia => index.strip_prefix(inertia).is_some_and(|link| !link.is_empty()),
            Is::Reduced => index == "r" && !q.given,
            Is::Reaction => false,
        }
    }

    /// Whether an index names two links: the force of the first on the second.
    fn is_between_links(&self, index: Option<&str>) -> bool {
        let Some(index) = index else { return false };
        let index = index.trim_end_matches(['x', 'y']).trim_end_matches(',');
        let labels = || (0..self.scene.mechanism().links.len()).map(|link| self.label(link));
        labels().any(|from| {
            let on = index.strip_prefix(&*from).map(|on| on.trim_start_matches(','));
            on.is_some_and(|on| labels().any(|label| label == on))
        })
    }
}
