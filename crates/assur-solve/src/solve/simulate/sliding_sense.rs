//! How what rubs moves: every element in a sense of its own, or held.

use super::dissipative::DissipativeElement;
use super::secants::Secants;
use crate::math::{Lu, Vec2};
use crate::model::{LoadId, PairId};
use crate::plan::{FrictionElement, Plan};
use crate::position::{Model, extent};

/// How every pair that rubs moves.
#[derive(Clone, Debug)]
pub(super) struct Slipping {
    /// By element, of friction, of losses, then of loads against the motion: ±1, or 0 where it is held.
    pub senses: Vec<f64>,
    /// Elements that are held, independent of each other: others that are held follow from them.
    pub held: Vec<usize>,
    /// Elements at the limit of their friction that others keep from sliding.
    pub still: Vec<bool>,
    /// Elements that drives alone move: never held, but at rest as long as their drives are.
    pub driven: Vec<bool>,
    /// Elements that were held before.
    pub before: Vec<bool>,
    /// Of points in the plane, by element: the velocity up to which they keep the direction in which they begin to slide, m/s.
    pub along: Vec<Vec2>,
    /// Slow points in the plane slide on by their velocities.
    pub passes: bool,
    /// Efforts that hold, by element.
    pub efforts: Vec<f64>,
    /// Efforts that are given of some that hold beside those.
    pub given: Vec<(usize, f64)>,
    /// Friction at rest over that of sliding, by element.
    pub at_rest: Vec<f64>,
    /// What has stopped at once since friction admitted no acceleration, and when, s.
    pub jammed: Vec<(f64, usize)>,
    /// Elements whose speeds the last impact has changed.
    pub struck: Vec<bool>,
    /// Stops that are open, and at which friction holds the coordinate.
    pub kept: Vec<bool>,
    /// Stops that are as good as touched, but not looked at.
    pub off: Vec<usize>,
    /// What turns within the last step, s.
    pub turning: Vec<(f64, usize)>,
    /// The greatest sliding speed so far.
    pub fastest: f64,
    /// The senses are those of a motion.
    pub begun: bool,
    /// All free coordinates are held, and no drive moves.
    pub rests: bool,
    /// More is held than coordinates are free, and it is not known by what.
    pub undetermined: bool,
    /// How often it was chosen anew at one instant, s.
    pub again: (f64, u32),
    /// Elements whose friction what presses gives: those that slide, but for loads.
    pub sliding: Vec<usize>,
    /// The senses for which the secants are those.
    senses_of: Vec<f64>,
    pub secants: Secants,
    /// The size of the mechanism, m.
    pub extent: f64,
    /// Units of the efforts of friction, by element.
    pub scales: Vec<f64>,
    /// Accelerations of the bodies where no free coordinate accelerates.
    pub bias: Vec<(Vec2, f64)>,
    /// Accelerations of the free coordinates without friction and stops, and with them.
    pub loaded: Vec<f64>,
    pub accelerations: Vec<f64>,
    /// What closed stops bear.
    pub pressed: Vec<f64>,
    /// Speeds of the held elements, of closed stops, then of what slides, for a unit rate of each free coordinate; M⁻¹ of them.
    pub slopes: Vec<f64>,
    pub columns: Vec<f64>,
    /// Units of the free coordinates, then of the efforts of what is held and of closed stops.
    pub units: Vec<f64>,
    /// What the speeds of these change by where nothing holds.
    pub left: Vec<f64>,
    /// Their efforts, in their units.
    pub bears: Vec<f64>,
    /// What each of their efforts changes the others' speeds by.
    pub matrix: Lu,
    /// The greatest term of the equations, in these units.
    pub greatest: f64,
}

impl Slipping {
    /// For a model; `still` is it with the friction at rest, where that is another one.
    pub fn new(model: &Model<'_>, still: Option<&Model<'_>>) -> Self {
        let count = DissipativeElement::count(model.plan);
        let extent = extent(model);
        Self {
            senses: vec![0.0; count],
            held: Vec::new(),
            still: vec![false; count],
            driven: vec![false; count],
            before: vec![true; count],
            along: vec![Vec2::zero(); count],
            passes: false,
            efforts: vec![0.0; count],
            given: Vec::new(),
            at_rest: DissipativeElement::all(model.plan).map(|rubs| greater_at_rest(still, rubs)).collect(),
            jammed: Vec::new(),
            struck: vec![false; count],
            kept: vec![false; model.mechanism.stops.len()],
            off: Vec::new(),
            turning: Vec::new(),
            fastest: 0.0,
            begun: false,
            rests: false,
            undetermined: false,
            again: (f64::NAN, 0),
            sliding: Vec::new(),
            senses_of: Vec::new(),
            secants: Secants::default(),
            extent,
            scales: DissipativeElement::all(model.plan)
                .map(|rubs| if rubs.turns() { extent } else { 1.0 })
                .collect(),
            bias: Vec::new(),
            loaded: Vec::new(),
            accelerations: Vec::new(),
            pressed: Vec::new(),
            slopes: Vec::new(),
            columns: Vec::new(),
            units: Vec::new(),
            left: Vec::new(),
            bears: Vec::new(),
            matrix: Lu::default(),
            greatest: 0.0,
        }
    }

    /// What is held, whatever the coordinates.
    pub fn held_in(&self, plan: &Plan) -> Held {
        let held = DissipativeElement::all(plan).zip(&self.senses).filter(|(_, sense)| **sense == 0.0);
        Held { elements: held.map(|(rubs, _)| place(rubs)).collect(), fastest: self.fastest }
    }

    /// Takes over what was held in other coordinates.
    pub fn take(&mut self, held: &Held, plan: &Plan) {
        for (rubs, sense) in DissipativeElement::all(plan).zip(&mut self.senses) {
            *sense = if held.elements.contains(&place(rubs)) { 0.0 } else { 1.0 };
        }
        (self.begun, self.fastest) = (true, held.fastest);
    }

    /// Takes what slides, in these senses; another matrix goes with others.
    pub fn take_sliding(&mut self, plan: &Plan) {
        if self.senses_of == self.senses {
            return;
        }
        self.senses_of.clone_from(&self.senses);
        self.sliding.clear();
        let sliding = (0..DissipativeElement::inner(plan)).filter(|&element| self.senses[element] != 0.0);
        self.sliding.extend(sliding);
        self.secants.begin(self.sliding.len());
    }

    /// The effort of a held element over the greatest term of the equations.
    pub fn share(&self, element: usize) -> f64 {
        let place = self.held.iter().position(|held| *held == element);
        place.map_or(0.0, |place| self.bears[place].abs() / self.greatest)
    }

    /// The acceleration of a free coordinate in its unit.
    pub fn share_of(&self, coordinate: usize) -> f64 {
        (self.accelerations[coordinate] / self.units[coordinate]).abs()
    }

    /// Whether an element does not move: it is held, or others keep it from sliding.
    pub fn holds(&self, element: usize) -> bool {
        self.senses[element] == 0.0 || self.still[element]
    }

    /// The slopes of a held element or a closed stop, by its place among them.
    pub fn slopes_of(&self, place: usize, n: usize) -> &[f64] {
        &self.slopes[n * place..][..n]
    }
}

/// What friction holds, whatever the coordinates.
#[derive(Clone)]
pub(super) struct Held {
    elements: Vec<Place>,
    fastest: f64,
}

/// Where something rubs: a pair with its bodies, sliding or turning, a transmission with its law, or a load.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    Pair(PairId, [usize; 2], bool),
    Load(LoadId),
}

/// An element by its pair and its bodies.
fn bodies(element: &FrictionElement) -> Place {
    let (one, other) = (element.body, element.base);
    Place::Pair(element.pair, [one.min(other), one.max(other)], element.kind.turns())
}

fn place(rubs: DissipativeElement<'_>) -> Place {
    match rubs {
        DissipativeElement::Pair(element) => bodies(element),
        DissipativeElement::Law(law, _) => Place::Pair(law.pair, [law.index; 2], false),
        DissipativeElement::Load(load) => Place::Load(load.load),
    }
}

/// The friction of an element at rest over that of its sliding.
fn greater_at_rest(still: Option<&Model<'_>>, rubs: DissipativeElement<'_>) -> f64 {
    let DissipativeElement::Pair(element) = rubs else { return 1.0 };
    let same = |other: &&FrictionElement| bodies(other) == bodies(element);
    let found = still.and_then(|model| model.plan.friction.iter().find(same));
    found.map_or(1.0, |other| other.kind.factor() / element.kind.factor())
}
