//! How what rubs moves: every element in a sense of its own, or held.

use super::dissipative::DissipativeElement;
use super::secants::Secants;
use crate::math::Lu;
use crate::model::{LoadId, PairId};
use crate::plan::{FrictionElement, Plan};
use crate::position::Model;
use crate::structure::EffortSource;

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
    /// Efforts that hold, by element.
    pub efforts: Vec<f64>,
    /// Friction at rest over that of sliding, by element.
    pub at_rest: Vec<f64>,
    /// Elements whose speeds the last impact has changed.
    pub struck: Vec<bool>,
    /// Stops that are open, and at which friction holds the coordinate.
    pub kept: Vec<bool>,
    /// A stop that is as good as touched, but not looked at.
    pub off: Option<usize>,
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
    /// Where the efforts of the free coordinates stand.
    pub efforts_of: Vec<usize>,
    /// Speeds of the held elements, then of closed stops, for a unit rate of each free coordinate.
    pub slopes: Vec<f64>,
    /// Units of the unknowns.
    pub units: Vec<f64>,
    /// The greatest term of the equations, in these units.
    pub greatest: f64,
    pub matrix: Lu,
    pub secants: Secants,
}

impl Slipping {
    /// For the free drives of a model; `still` is it with the friction at rest, where that is another one.
    pub fn new(model: &Model<'_>, still: Option<&Model<'_>>, free: &[usize]) -> Self {
        let count = DissipativeElement::count(model.plan);
        let own = |&drive: &usize| {
            let is_own = |source| matches!(source, EffortSource::Drive(id) if id.index() == drive);
            model.structure.efforts.iter().position(|effort| is_own(effort.source))
        };
        Self {
            senses: vec![0.0; count],
            held: Vec::new(),
            still: vec![false; count],
            driven: vec![false; count],
            before: vec![true; count],
            efforts: vec![0.0; count],
            at_rest: DissipativeElement::all(model.plan).map(|rubs| greater_at_rest(still, rubs)).collect(),
            struck: vec![false; count],
            kept: vec![false; model.mechanism.stops.len()],
            off: None,
            turning: Vec::new(),
            fastest: 0.0,
            begun: false,
            rests: false,
            undetermined: false,
            again: (f64::NAN, 0),
            efforts_of: free.iter().filter_map(own).collect(),
            slopes: Vec::new(),
            units: Vec::new(),
            greatest: 0.0,
            matrix: Lu::default(),
            secants: Secants::default(),
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

    /// The effort of a held element, of so many free coordinates, over the greatest term of the equations.
    pub fn share(&self, element: usize, n: usize) -> f64 {
        let place = self.held.iter().position(|held| *held == element);
        place.map_or(0.0, |place| self.secants.x[n + place].abs() / self.greatest)
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

/// Where something rubs: a pair with its bodies, a transmission with its law, or a load.
#[derive(Clone, Copy, PartialEq)]
enum Place {
    Pair(PairId, [usize; 2]),
    Load(LoadId),
}

/// An element by its pair and its bodies.
fn bodies(element: &FrictionElement) -> Place {
    let (one, other) = (element.body, element.base);
    Place::Pair(element.pair, [one.min(other), one.max(other)])
}

fn place(rubs: DissipativeElement<'_>) -> Place {
    match rubs {
        DissipativeElement::Pair(element) => bodies(element),
        DissipativeElement::Law(law, _) => Place::Pair(law.pair, [law.index; 2]),
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
