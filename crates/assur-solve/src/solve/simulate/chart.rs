//! A mechanism in other free coordinates: where those of the starts come to a dead position, another link says better where
//! everything is.

use crate::model::{DriveTarget, Mechanism};
use crate::plan::{FrictionElement, MotionStep, Plan, plan_with};
use crate::position::{BodyState, ContactMode, Forces, Model, Reaction, State, extent};
use crate::solve::assemble::every_way;
use crate::structure::{BodyId, GroupJoint, Structure, structure};

/// Bodies that stand where they are known to be do so to this part of the extent.
const THERE: f64 = 1e-6;

/// Round profiles of a general group of which both sides are tried.
const MOST_ROUND: usize = 8;

/// The mechanism with other links driven in place of its free coordinates.
#[derive(Debug)]
pub(super) struct Chart {
    mechanism: Mechanism,
    structure: Structure,
    plan: Plan,
    back: Back,
}

/// Where its forces stand in the mechanism as it is written.
#[derive(Debug)]
struct Back {
    /// By slot of a reaction: slots here with their signs.
    reactions: Vec<Vec<(usize, f64)>>,
    efforts: Vec<Option<usize>>,
    /// By element of friction: element here and sign.
    friction: Vec<Option<(usize, f64)>>,
    groups: usize,
}

/// A position that was found in other coordinates, as the mechanism as it is written has it.
#[derive(Clone, Debug, Default)]
pub(crate) struct Given {
    pub bodies: Vec<BodyState>,
    /// The forces, and those without friction, unless the plan as it is written finds them.
    pub forces: Option<Forces>,
    pub ideal: Option<Forces>,
    /// The least condition of the groups they were found with.
    pub condition: f64,
}

impl Chart {
    /// With these targets in place of those of all drives; `None` where they do not determine the motion.
    pub fn of(written: &Model<'_>, targets: &[DriveTarget]) -> Option<Self> {
        let mut mechanism = written.mechanism.clone();
        for (drive, target) in mechanism.drives.iter_mut().zip(targets) {
            drive.target = *target;
        }
        // groups that the file asserts are those of its own drives
        mechanism.groups.clear();
        let (structure, _) = structure(&mechanism).ok()?;
        if structure.replaced.bodies.len() != written.structure.replaced.bodies.len() {
            return None;
        }
        let mut plan = plan_with(&mechanism, &structure, written.plan.effects);
        plan.settings = written.plan.settings;
        let back = Back::of(written, &structure, &plan)?;
        Some(Self { mechanism, structure, plan, back })
    }

    pub const fn model(&self) -> Model<'_> {
        Model { mechanism: &self.mechanism, structure: &self.structure, plan: &self.plan }
    }

    /// How the elements of friction of this plan move, as the mechanism as it is written has them.
    pub fn grips(&self, here: &[ContactMode]) -> Vec<ContactMode> {
        let each = self.back.friction.iter().map(|at| {
            at.map_or_else(ContactMode::default, |(i, sign)| {
                let ContactMode { sense, effort, along } = here[i];
                ContactMode { sense: sign * sense, effort: sign * effort, along }
            })
        });
        // losses have the same order in both
        each.chain(here[self.plan.friction.len().min(here.len())..].iter().copied()).collect()
    }

    /// Forces of this plan, as the mechanism as it is written has them.
    pub fn forces(&self, here: &Forces) -> Forces {
        self.back.forces(here)
    }

    /// Whether every group has a closed form.
    pub fn is_closed(&self) -> bool {
        let iterated =
            |step: &MotionStep| matches!(step, MotionStep::General { .. } | MotionStep::Triad { .. });
        !self.plan.motion.iter().any(iterated)
    }

    /// The position of a state of this plan as the mechanism as it is written has it.
    pub fn given(&self, state: &mut State) -> Given {
        let motion = state.motion.conditions.iter();
        let mut condition = motion.fold(1.0_f64, |least, c| least.min(c.abs()));
        let (mut forces, mut ideal) = (None, None);
        if self.plan.effects.forces {
            condition = state.forces.conditions.iter().fold(condition, |least, c| least.min(c.abs()));
            forces = Some(self.forces(&state.forces));
            if self.plan.effects.loses() {
                state.run_again_without_friction(&self.plan);
                ideal = Some(self.forces(&state.forces));
            }
        }
        Given { bodies: state.motion.bodies.clone(), forces, ideal, condition }
    }
}

/// The state of a model whose bodies stand where they are known to be, for inputs that say so; `None` where it is not found.
pub(super) fn standing(model: &Model<'_>, inputs: &State, bodies: &[BodyState]) -> Option<State> {
    let extent = extent(model);
    let mut state = State::new(model.plan);
    state.motion.inputs.clone_from(&inputs.motion.inputs);
    state.motion.time = inputs.motion.time;
    state.motion.bodies.copy_from_slice(bodies);
    state.start(model.plan);
    for (index, step) in model.plan.motion.iter().enumerate() {
        let group = &model.structure.motion[index].bodies;
        let away = |state: &State| {
            let each = group.iter().map(|b| {
                let (here, there) = (&state.motion.bodies[b.0], &bodies[b.0]);
                (here.p - there.p).norm() / extent + (here.u - there.u).norm()
            });
            if state.motion.open.is_some() { f64::INFINITY } else { each.sum::<f64>() }
        };
        let stands = match step {
            MotionStep::General { problem, .. } => {
                // from where its bodies stand, with round profiles on either side
                let round = model.plan.general[*problem].round.len().min(MOST_ROUND);
                (0..1_u32 << round).any(|sides| {
                    group.iter().for_each(|b| state.motion.bodies[b.0] = bodies[b.0]);
                    state.branches[index].general_sides = sides;
                    state.motion.open = None;
                    state.step::<0>(model.plan, step);
                    away(&state) <= THERE
                })
            }
            MotionStep::Triad { .. } => {
                state.step::<0>(model.plan, step);
                away(&state) <= THERE
            }
            _ => every_way(model, &mut state, index, extent).into_iter().any(|way| {
                way.put(model, &mut state, index);
                away(&state) <= THERE
            }),
        };
        if !stands {
            return None;
        }
    }
    Some(state)
}

impl Given {
    /// Puts a state of the plan as it is written there. Returns whether its forces are known.
    pub fn put(&self, state: &mut State) -> bool {
        state.motion.open = None;
        state.motion.bodies.clone_from(&self.bodies);
        if let Some(forces) = &self.forces {
            state.forces.clone_from(forces);
        }
        self.forces.is_some()
    }
}

/// The bodies whose forces a joint of a group carries: its own, and in a hinge of several links those that hold on to it.
fn carried(joints: &[GroupJoint], joint: &GroupJoint) -> Vec<BodyId> {
    let mut bodies = vec![joint.body];
    let mut next = 0;
    while next < bodies.len() {
        let held = joints.iter().filter(|other| other.joint == joint.joint && other.base == bodies[next]);
        let fresh: Vec<BodyId> = held.map(|other| other.body).filter(|body| !bodies.contains(body)).collect();
        bodies.extend(fresh);
        next += 1;
    }
    bodies
}

impl Back {
    fn of(written: &Model<'_>, structure: &Structure, plan: &Plan) -> Option<Self> {
        let reactions = written.plan.reactions.iter().map(|joint| {
            let carried = carried(&written.plan.reactions, joint);
            let same = plan.reactions.iter().enumerate().filter(|(_, other)| other.joint == joint.joint);
            let signed = same.filter_map(|(slot, other)| {
                match (carried.contains(&other.body), carried.contains(&other.base)) {
                    (true, false) => Some((slot, 1.0)),
                    (false, true) => Some((slot, -1.0)),
                    _ => None,
                }
            });
            signed.collect()
        });
        let efforts = written.structure.efforts.iter();
        let efforts = efforts.map(|e| structure.efforts.iter().position(|other| other.source == e.source));
        let friction = written.plan.friction.iter().map(|element| {
            let alike = |other: &FrictionElement| {
                other.pair == element.pair && other.kind.turns() == element.kind.turns()
            };
            let same = |other: &FrictionElement| {
                alike(other) && (other.body, other.base) == (element.body, element.base)
            };
            let turned = |other: &FrictionElement| {
                alike(other) && (other.body, other.base) == (element.base, element.body)
            };
            let find = |how: &dyn Fn(&FrictionElement) -> bool| plan.friction.iter().position(how);
            find(&same).map(|i| (i, 1.0)).or_else(|| find(&turned).map(|i| (i, -1.0)))
        });
        let back = Self {
            reactions: reactions.collect(),
            efforts: efforts.collect(),
            friction: friction.collect(),
            groups: written.plan.forces.len(),
        };
        let whole =
            back.reactions.iter().all(|slots| !slots.is_empty()) && back.friction.iter().all(Option::is_some);
        (whole && written.plan.laws.len() == plan.laws.len()).then_some(back)
    }

    fn forces(&self, here: &Forces) -> Forces {
        let sum = |slots: &Vec<(usize, f64)>| {
            slots.iter().fold(Reaction::default(), |sum, &(slot, sign)| {
                let Reaction { force, couple } = here.reactions[slot];
                Reaction { force: sum.force + force * sign, couple: sum.couple + couple * sign }
            })
        };
        let signed = |list: &[f64]| {
            let each = self.friction.iter().map(|at| at.map_or(f64::NAN, |(i, sign)| sign * list[i]));
            each.collect()
        };
        let ahead = crate::math::Vec2::new(1.0, 0.0);
        Forces {
            applied: here.applied.clone(),
            wrenches: here.wrenches.clone(),
            reactions: self.reactions.iter().map(sum).collect(),
            // nothing holds a free coordinate
            efforts: self.efforts.iter().map(|at| at.map_or(0.0, |i| here.efforts[i])).collect(),
            lines: self.efforts.iter().map(|at| at.map_or((ahead * 0.0, ahead), |i| here.lines[i])).collect(),
            conditions: vec![1.0; self.groups],
            frictions: signed(&here.frictions),
            senses: signed(&here.senses),
            law_forces: here.law_forces.clone(),
            locked: here.locked,
            consistent: here.consistent,
        }
    }
}
