//! Forces per structural group, the last first: the group freed from the others, and its polygon.

mod actions;
mod free_body;
mod friction;
mod lever;
mod polygon;
mod powers;

pub use friction::{friction, frictions};
pub use lever::{lever, levered};

use crate::error;
use crate::error::no_forces_for;
use crate::paper::Paper;
use crate::scene::Scene;
use crate::shape::shapes;
use actions::FreeBody;
pub use actions::{letters, place};
use assur_drawing::Drawing;
use assur_model::model::{LinkId, LoadId, PairId, Query};
use assur_model::structure::BodyId;
use assur_solve::solve::Model;
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Span;
use miette::Diagnostic;

/// What is freed at once: a group, or one link of a group that is solved as a whole.
pub struct Part {
    pub links: Vec<LinkId>,
    /// The pair between the two links of a dyad.
    pub inner: Option<PairId>,
}

/// Free bodies and polygons at a position.
///
/// # Errors
/// There are no forces: nothing loads the mechanism, they are not determined, or friction locks it.
pub fn forces(scene: &Scene<'_>, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let (mut drawings, shapes) = (Vec::new(), shapes(scene));
    for (part, free) in freed(scene)? {
        drawings.push(free_body::draw((scene, &shapes), &part, &free, paper)?);
        drawings.extend(polygon::draw(scene, &part, &free, paper)?);
    }
    Ok(drawings)
}

/// What is freed, with the forces on it.
///
/// # Errors
/// As [`forces()`].
pub fn freed(scene: &Scene<'_>) -> Result<Vec<(Part, FreeBody)>, Diagnosis> {
    partly_determined(scene)?;
    if !is_loaded(&scene.model) {
        return Err(nothing_loads());
    }
    let all = parts(scene).into_iter().filter_map(|part| FreeBody::of(scene, &part).map(|free| (part, free)));
    let all: Vec<(Part, FreeBody)> = all.filter(|(_, free)| !free.forces.is_empty()).collect();
    if all.is_empty() { Err(error::nothing_placed(scene, "forces act at points")) } else { Ok(all) }
}

/// Refuses where there are no forces or they are not known.
pub fn loaded(scene: &Scene<'_>) -> Result<(), Diagnosis> {
    determined(scene)?;
    if is_loaded(&scene.model) { Ok(()) } else { Err(nothing_loads()) }
}

/// Refuses where the forces are not known, on any link.
fn determined(scene: &Scene<'_>) -> Result<(), Diagnosis> {
    if scene.solved.state.friction_shares() { Err(held(scene)) } else { partly_determined(scene) }
}

fn held(scene: &Scene<'_>) -> Diagnosis {
    let help = "draw another pose, or give friction to fewer pairs";
    let why = "pairs hold by friction, and how they share the loads is not determined";
    error::no_forces_by_drive(scene, why, "held", help)
}

/// Refuses where no force is known: chains of links that share by friction what they hold are left out of the pictures.
fn partly_determined(scene: &Scene<'_>) -> Result<(), Diagnosis> {
    if let Some(defect) = &scene.model.structure.force_defect {
        let help = "declare what holds it: `balance torque Mb on crank`";
        let label = defect.labels().and_then(|mut labels| labels.next());
        let at = label.map(|label| Span::new(label.offset(), label.offset() + label.len()));
        return Err(no_forces_for(&defect.to_string(), at, "not determined", help.to_owned()));
    }
    if scene.solved.state.forces.locked {
        let help = "draw another pose, or lower the friction";
        return Err(error::no_forces_by_drive(scene, "friction locks the mechanism", "locked", help));
    }
    let links = (1..scene.mechanism().links.len()).map(LinkId::at);
    if scene.solved.state.friction_shares() && links.into_iter().all(|link| is_held(scene, link)) {
        return Err(held(scene));
    }
    if scene.model.plan.effects.forces { Ok(()) } else { Err(nothing_loads()) }
}

fn nothing_loads() -> Diagnosis {
    let help = "declare a load: `force P on ram at Q = 100 N @ 180 deg`, or `gravity 9.81 m/s^2` and masses";
    error::no_forces("nothing loads the mechanism", help)
}

fn is_loaded(model: &Model<'_>) -> bool {
    let effects = &model.plan.effects;
    let mechanism = model.mechanism;
    !mechanism.loads.is_empty() || effects.inertia || effects.gravity || effects.springs
}

/// Whether the forces on a link depend on how pairs share what friction holds.
fn is_held(scene: &Scene<'_>, link: LinkId) -> bool {
    let (view, mechanism) = (scene.view(), scene.mechanism());
    let mut pairs = (0..mechanism.pairs.len()).map(PairId::at);
    let mut loads = (0..mechanism.loads.len()).map(LoadId::at);
    pairs.any(|id| mechanism.pair(id).kind.links().contains(&link) && view.shares_friction(id))
        || loads.any(|id| {
            let load = &mechanism.loads[id.index()];
            load.link() == Some(link) && !view.query(&Query::Load(id)).is_defined()
        })
}

/// The groups in the order in which forces are found; of those that are not dyads of links every link alone. What is welded to
/// the ground comes last.
fn parts(scene: &Scene<'_>) -> Vec<Part> {
    use assur_model::structure::GroupKind;
    let structure = scene.model.structure;
    let mut parts = Vec::new();
    let groups = structure.forces.iter().map(|group| (group.bodies.as_slice(), Some(group)));
    for (bodies, group) in groups.chain([(&[BodyId::GROUND][..], None)]) {
        let links: Vec<LinkId> = bodies
            .iter()
            .flat_map(|body| links_of(&scene.model, *body))
            .filter(|l| scene.is_placed(*l) && *l != LinkId::GROUND && !scene.is_in_cylinder(*l))
            .filter(|l| !is_held(scene, *l))
            .collect();
        let alone = bodies.iter().all(|body| structure.replaced.links_of(*body).len() < 2);
        match group {
            Some(group) if matches!(group.kind, GroupKind::Dyad(_)) && links.len() == 2 && alone => {
                let inner =
                    group.joints.iter().find(|j| j.inner).map(|j| structure.replaced.joint(j.joint).pair);
                parts.push(Part { links, inner });
            }
            _ => parts.extend(links.into_iter().map(|link| Part { links: vec![link], inner: None })),
        }
    }
    parts
}

/// The links of a body, those first that others carry.
fn links_of(model: &Model<'_>, body: BodyId) -> Vec<LinkId> {
    let mut own = model.structure.replaced.links_of(body);
    let depth = |link: &LinkId| model.plan.welds.iter().position(|weld| weld.part.body == link.index());
    own.sort_by_key(|link| std::cmp::Reverse(depth(link)));
    own
}

/// `2, 3`
fn names(scene: &Scene<'_>, part: &Part) -> String {
    part.links.iter().map(|l| scene.link_label(*l)).collect::<Vec<_>>().join(", ")
}
