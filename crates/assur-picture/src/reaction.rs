//! Letters of reactions: the same for a force in every picture and in the steps of a solution.

use crate::scene::Scene;
use assur_drawing::Text;
use assur_model::model::{LinkId, PairId};
use assur_model::structure::{BodyId, BodyOrigin};

/// The index of the force of one body on another, from their numbers or names: `12`, `ground,crank`.
#[must_use]
pub fn reaction_index(from: &str, on: &str) -> String {
    let apart = if from.chars().count() > 1 || on.chars().count() > 1 { "," } else { "" };
    format!("{from}{apart}{on}")
}

impl<'a> Scene<'a> {
    /// The number of a body as written, or its name; of a body that stands for a pair the pair's.
    #[must_use]
    pub fn body_label(&self, body: usize) -> &'a str {
        match self.model.structure.replaced.bodies[body].origin {
            BodyOrigin::Link(link) => self.link_label(link),
            BodyOrigin::Imaginary(pair) => &self.mechanism().pair(pair).name,
        }
    }

    /// The letter of the force in a pair on one of its links: of what touches it there, which stands for another link in a cylinder
    /// and where a contact is replaced.
    #[must_use]
    pub fn reaction_name(&self, pair: PairId, from: LinkId, on: LinkId) -> Text {
        let replaced = &self.model.structure.replaced;
        let own = BodyId(on.index());
        let joints = replaced.joints_of(pair).map(|joint| replaced.joint(joint).bodies());
        let others = joints.filter(|bodies| bodies.contains(&own)).flatten().filter(|body| *body != own);
        let others: Vec<BodyId> = others.collect();
        let direct = others.is_empty() || (from != on && others.contains(&BodyId(from.index())));
        let from = if direct { self.link_label(from) } else { self.body_label(others[0].0) };
        Text::italic("R").lowered(&reaction_index(from, self.link_label(on)))
    }
}
