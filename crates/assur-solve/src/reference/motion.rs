//! Newton's method on all equations at once, then all its derivatives from the same matrix.

use super::{cam, geneva};
use crate::math::{Double, Factors, Scalar, V2, Vec2};
use crate::plan::Level;
use crate::plan::equation::{Equation, equations};
use crate::position::{At, BodyState, DriveInput, Jet, Model, PLACES, State};
use crate::structure::JointKind;

/// Steps of Newton's method: from the digits of `f64` three suffice.
const STEPS: usize = 12;
/// A step that is nothing.
const AT_REST: f64 = 1e-29;
/// What is left of a step where the last digits of twice as many do not come to rest; nearer to singular there is no
/// reference.
const RESTLESS: f64 = 1e-18;
/// What equations may be off, relative to the magnitudes in them.
const CLOSED: f64 = 1e-28;
/// A step farther than this leads elsewhere, in lengths of the mechanism and rad.
const FAR: f64 = 0.1;
/// Corrections of velocities and accelerations.
const CORRECTIONS: usize = 3;

pub(super) struct Motion<'a> {
    pub bodies: Vec<BodyState<Double>>,
    pub model: Model<'a>,
    state: &'a State,
    equations: Vec<Equation>,
    inputs: Vec<DriveInput<Double>>,
    /// Greatest coordinate in play, m.
    pub size: f64,
    /// What the equations of position are off, relative to the magnitudes in them.
    pub closure: f64,
    /// First column of each body; `None` where its motion is known.
    columns: Vec<Option<usize>>,
    count: usize,
}

/// Motion as far as the plan follows it; `None` where Newton's method does not settle on a position near that of the state.
pub(super) fn motion<'a>(model: &Model<'a>, state: &'a State) -> Option<Motion<'a>> {
    let mut motion = Motion {
        bodies: state.motion.bodies.iter().map(at_rest).collect(),
        model: *model,
        state,
        equations: equations(model.mechanism, model.structure, model.plan),
        inputs: state.motion.inputs.iter().map(DriveInput::in_scalar).collect(),
        size: size(model, state),
        closure: 0.0,
        columns: Vec::new(),
        count: 0,
    };
    for &(body, at, drive) in &model.plan.outer {
        let input = &state.motion.inputs[drive];
        let body = &mut motion.bodies[body];
        body.u = V2::new(Double::one(), Double::zero());
        body.p = V2::of(input.place) - V2::of(at);
    }
    for (slot, body) in model.structure.replaced.bodies.iter().enumerate() {
        let known = body.known || model.plan.is_block(slot);
        motion.columns.push((!known).then_some(motion.count));
        motion.count += if known { 0 } else { 3 };
    }
    if motion.equations.len() != motion.count {
        return None;
    }
    motion.position()?;
    motion.rates()?;
    for part in &model.plan.parts {
        motion.bodies[part.part] = motion.bodies[part.body].carried(part);
    }
    for step in &model.plan.cams {
        cam::place_block(step, &mut motion.bodies);
    }
    for step in &model.plan.genevas {
        geneva::place_block(step, state, &mut motion.bodies);
    }
    Some(motion)
}

fn at_rest(body: &BodyState) -> BodyState<Double> {
    let u: V2<Double> = V2::of(body.u);
    BodyState { p: V2::of(body.p), u: u / u.norm(), turned: Double::of(body.turned), ..BodyState::rest() }
}

/// The greatest coordinate in play, m; 1 where all are zero.
fn size(model: &Model<'_>, state: &State) -> f64 {
    let mut size = 0.0_f64;
    for joint in &model.structure.replaced.joints {
        let mut reach = |body: usize, at: Vec2| {
            let body = &state.motion.bodies[body];
            size = size.max(body.p.norm()).max(body.position(at).norm());
        };
        match &joint.kind {
            JointKind::Revolute(members) => members.iter().for_each(|(b, at)| reach(b.0, *at)),
            JointKind::Prismatic { slider, point, guide, through, .. } => {
                reach(slider.0, *point);
                reach(guide.0, *through);
            }
            JointKind::Weld { part, at, .. } => reach(part.0, *at),
            JointKind::Law(_) => {}
        }
    }
    // shafts of which no place is given stand in the origin
    if size > 0.0 { size } else { 1.0 }
}

impl Motion<'_> {
    fn jet(&self, bodies: &[BodyState<Double>], equation: &Equation) -> Jet<Double> {
        At { plan: self.model.plan, bodies, inputs: &self.inputs, chosen: &self.state.motion }.jet(equation)
    }

    /// One derivative of all equations, the equations themselves being the first.
    fn derivatives(&self, order: usize) -> Vec<Double> {
        self.equations.iter().map(|equation| self.jet(&self.bodies, equation).0[order]).collect()
    }

    /// The gradients of all equations, lengths counted in sizes. Bodies are at rest.
    fn matrix(&self) -> Vec<Vec<Double>> {
        let mut bodies = self.bodies.clone();
        let mut gradient = |equation: &Equation| {
            let mut row = vec![Double::zero(); self.count];
            let driven = self.jet(&bodies, equation).0[1];
            for slot in equation.bodies(self.model.plan) {
                let Some(column) = self.columns[slot] else { continue };
                for i in 0..3 {
                    bodies[slot] = unit_rate(&self.bodies[slot], i, self.size);
                    row[column + i] = self.jet(&bodies, equation).0[1] - driven;
                }
                bodies[slot] = self.bodies[slot];
            }
            row
        };
        self.equations.iter().map(&mut gradient).collect()
    }

    fn position(&mut self) -> Option<()> {
        let mut last = FAR;
        for _ in 0..STEPS {
            let matrix = self.matrix();
            let weights: Vec<f64> = matrix.iter().map(|row| row.iter().map(|x| x.high.abs()).sum()).collect();
            let values = self.derivatives(0);
            self.closure =
                values.iter().zip(&weights).fold(0.0, |most, (x, w)| f64::max(most, x.high.abs() / w));
            let step = Factors::new(matrix)?.solve(&values);
            let most = step.iter().fold(0.0, |most: f64, x| most.max(x.high.abs()));
            let resting = self.closure <= CLOSED && last.min(most) <= RESTLESS;
            if resting && (most <= AT_REST || most > 0.5 * last) {
                return Some(());
            }
            if most.is_nan() || most > 0.5 * last {
                return None;
            }
            last = most;
            self.move_by(&step);
        }
        None
    }

    fn move_by(&mut self, step: &[Double]) {
        let size = Double::of(self.size);
        for (body, column) in self.bodies.iter_mut().zip(&self.columns) {
            let Some(column) = *column else { continue };
            let [x, y, turn] = [0, 1, 2].map(|i| step[column + i]);
            body.p -= V2::new(x, y) * size;
            let u = body.u - body.u.perp() * turn;
            body.u = u / u.norm();
            body.turned = body.turned - turn;
        }
    }

    /// Velocities, accelerations and rates beyond, as far as the plan goes, each corrected by what the equations say of it.
    fn rates(&mut self) -> Option<()> {
        let (plan, effects) = (self.model.plan, self.model.plan.effects);
        if effects.level == Level::Positions {
            return Some(());
        }
        let factors = Factors::new(self.matrix())?;
        let last = match effects.level {
            _ if effects.beyond => PLACES - 1,
            Level::Accelerations => 2,
            Level::Positions | Level::Velocities => 1,
        };
        for order in 1..=last {
            for &(body, _, drive) in &plan.outer {
                *self.bodies[body].rate_mut(order).0 = self.inputs[drive].rate_of_point(order);
            }
            for _ in 0..CORRECTIONS {
                let less = factors.solve(&self.derivatives(order));
                self.add(&less, order);
            }
        }
        Some(())
    }

    fn add(&mut self, less: &[Double], order: usize) {
        let size = Double::of(self.size);
        for (body, column) in self.bodies.iter_mut().zip(&self.columns) {
            let Some(column) = *column else { continue };
            let (v, turn) = body.rate_mut(order);
            *v -= V2::new(less[column], less[column + 1]) * size;
            *turn = *turn - less[column + 2];
        }
    }
}

/// The body with a unit rate of one of its coordinates.
fn unit_rate(body: &BodyState<Double>, coordinate: usize, size: f64) -> BodyState<Double> {
    let mut moved = *body;
    match coordinate {
        0 => moved.v.x = Double::of(size),
        1 => moved.v.y = Double::of(size),
        _ => moved.omega = Double::one(),
    }
    moved
}
