//! A worked solution as a whole.

use crate::course::{Counts, Derivation};
use crate::document::{Block, Document, Figure, cited};
use crate::formulas::Formula;
use crate::given::Data;
use crate::motion::Stage;
use crate::words::{Language, Message};
use assur_formula::{Equation, Expr, Name, Unit};
use assur_model::model::{Level, Value};
use assur_picture::{Kind, Scene};
use assur_solve::solve::DriveValue;
use assur_text::units::Dimension;

/// A part of a solution, by its number.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// Text, scheme, given values.
    Problem,
    Structure,
    Positions,
    Velocities,
    Accelerations,
    /// Loads and inertia forces.
    Inertia,
    Forces,
    Check,
    Results,
}

const PARTS: [Part; 9] = [
    Part::Problem,
    Part::Structure,
    Part::Positions,
    Part::Velocities,
    Part::Accelerations,
    Part::Inertia,
    Part::Forces,
    Part::Check,
    Part::Results,
];

impl Part {
    /// The part of a number, 0 to 8.
    #[must_use]
    pub fn numbered(number: usize) -> Option<Self> {
        PARTS.get(number).copied()
    }
}

/// A size that the file works out from its given values.
#[derive(Clone, Debug)]
pub struct Size {
    pub name: Name,
    /// Its value, SI; an angle in degrees.
    pub value: f64,
    pub unit: Unit,
    pub right: Expr,
}

#[derive(Clone, Debug, Default)]
pub struct Worked {
    pub document: Document,
    /// The equations in it.
    pub equations: Vec<Equation>,
    /// Formulas that do not agree with the solver: they are not written, and a test fails.
    pub disagreements: Vec<String>,
    /// What is derived, and what is stated alone.
    pub counts: Counts,
    /// Values that are on the page without an equation.
    pub stated: Vec<Name>,
}

/// The worked solution of a position; all parts where none are named.
#[must_use]
pub fn worked(scene: Scene<'_>, language: Language, parts: &[Part]) -> Worked {
    worked_from(scene, language, parts, (&[], &[]), None)
}

/// The same after the sizes that the file works out from its given values, with its formulas of results and the data of the file.
#[must_use]
pub fn worked_from(
    scene: Scene<'_>,
    language: Language,
    parts: &[Part],
    (sizes, formulas): (&[Size], &[Formula]),
    data: Option<Data<'_>>,
) -> Worked {
    let mut course = Derivation::new(scene, language);
    let mut sections: Vec<(Part, usize)> = Vec::new();
    let begin = |course: &Derivation<'_>, part: Part, sections: &mut Vec<(Part, usize)>| {
        sections.push((part, course.blocks.len()));
    };
    let mut given_at = 0;
    for part in PARTS {
        begin(&course, part, &mut sections);
        if part == Part::Structure {
            course.sizes(sizes);
        }
        if part == Part::Results {
            course.designs();
            course.head(Message::Results);
            course.asked_of_strokes();
            course.formulas(formulas);
            course.asked_besides();
        }
        course.part(part);
        if part == Part::Problem {
            given_at = course.blocks.len();
            course.overview();
        }
    }
    let unused = course.prune();
    course.say_nothing_follows(&unused);
    let given = course.given_values(data);
    let stated = course.stated_alone(&unused);
    let mut blocks = Vec::new();
    let ends = sections.iter().skip(1).map(|s| s.1).chain([course.blocks.len()]);
    for ((part, start), end) in sections.iter().zip(ends) {
        if !parts.is_empty() && !parts.contains(part) {
            continue;
        }
        let kept = |from: usize, to: usize| {
            let kept = (from..to).filter(|i| !unused.contains(i));
            kept.map(|i| course.blocks[i].clone()).collect::<Vec<_>>()
        };
        if *part == Part::Problem {
            blocks.extend(kept(*start, given_at));
            blocks.extend(given.iter().cloned());
            blocks.extend(kept(given_at, end));
        } else {
            blocks.extend(kept(*start, end));
        }
    }
    if language.letters().comma {
        blocks = blocks.into_iter().map(Block::with_commas).collect();
    }
    let title = if scene.mechanism().title.is_empty() { scene.file } else { &scene.mechanism().title };
    let document = Document {
        fields: Vec::new(),
        title: title.to_owned(),
        language: language.code(),
        labels: language.labels(),
        blocks: numbered(without_empty(cited(blocks, language.labels().cited))),
    };
    let Derivation { equations, disagreements, counts, .. } = course;
    let equations = equations.into_iter().map(|(_, equation)| equation).collect();
    Worked { document, equations, disagreements, counts, stated }
}

/// Without headings that nothing follows.
pub fn without_empty(blocks: Vec<Block>) -> Vec<Block> {
    let mut kept: Vec<Block> = Vec::new();
    for block in blocks.into_iter().rev() {
        if let Block::Heading(level, _) = &block {
            // going backwards: what follows is there already
            let empty = match kept.last() {
                None => true,
                Some(Block::Heading(next, _)) => next <= level,
                // the pictures of the section
                Some(Block::Figures(_)) => *level > 2,
                Some(_) => false,
            };
            if empty {
                continue;
            }
        }
        kept.push(block);
    }
    kept.reverse();
    kept
}

/// Headings of the second level with their numbers.
fn numbered(mut blocks: Vec<Block>) -> Vec<Block> {
    let mut count = 0;
    for block in &mut blocks {
        if let Block::Heading(2, words) = block {
            count += 1;
            *words = format!("{count} {words}");
        }
    }
    blocks
}

impl Derivation<'_> {
    fn part(&mut self, part: Part) {
        let level = self.scene.model.plan.effects.level;
        let has_forces = self.scene.model.plan.has_forces() && !self.state().forces.locked;
        let shares = has_forces && self.state().friction_shares();
        let forces = has_forces && !(shares && self.all_shares());
        match part {
            Part::Problem => {
                let scheme = self.pictures(Kind::Scheme, Message::SchemeAt, &self.position_words());
                self.problem(scheme);
            }
            Part::Structure => self.structure_section(),
            Part::Positions => {
                let scheme = self.caption(Message::SchemeAt, &self.position_words());
                self.head(Message::Positions);
                self.cite_as(Message::SeeScheme, scheme);
                self.stage(Stage::Positions, &[]);
            }
            Part::Velocities if level >= Level::Velocities => {
                let plan = self.pictures(Kind::Velocities, Message::VelocityPlan, "");
                self.head(Message::Velocities);
                self.stage(Stage::Velocities, &plan);
                self.figures(plan);
            }
            Part::Velocities => self.remark(Message::Rates, &[]),
            Part::Accelerations if level >= Level::Accelerations => {
                let plan = self.pictures(Kind::Accelerations, Message::AccelerationPlan, "");
                self.head(Message::Accelerations);
                self.stage(Stage::Accelerations, &plan);
                self.asked_of_jerks();
                self.figures(plan);
            }
            Part::Accelerations => {}
            Part::Inertia if has_forces => {
                self.head(Message::Inertia);
                self.masses();
                self.loads();
                self.substitutions();
            }
            Part::Forces if forces && self.nothing_acts() => {
                self.counts.forces[0] += self.scene.model.plan.forces.len();
            }
            Part::Forces if forces => {
                self.head(Message::Reactions);
                let figures = self.force_pictures();
                self.forces(&figures);
                if !shares {
                    self.friction_balance();
                    self.asked_of_forces();
                }
            }
            Part::Inertia => {}
            Part::Forces if self.state().forces.locked => self.locked(),
            Part::Forces if has_forces => self.held_by_many(),
            Part::Forces => self.remark(Message::NoForces, &[]),
            Part::Check => {
                self.head(Message::Check);
                let checked = self.check();
                if checked && forces && !shares && level >= Level::Velocities {
                    let lever = self.pictures(Kind::Lever, Message::Lever, "");
                    self.cite(Message::SeeLever, &lever);
                    self.figures(lever);
                }
                self.run();
            }
            Part::Results => self.results(),
        }
    }

    /// Sizes of the file by its own formulas.
    fn sizes(&mut self, sizes: &[Size]) {
        if sizes.is_empty() {
            return;
        }
        let heading = self.words(Message::Sizes);
        self.heading(2, heading);
        self.say(Message::SizesOf, &[]);
        for size in sizes {
            self.asked.insert(size.name.clone());
            self.equate(size.name.clone(), size.value, size.unit, size.right.clone());
        }
    }

    /// What needs no position: cycle, flywheels, cams, gears.
    fn designs(&mut self) {
        let page = crate::design::design(self.scene.model, self.scene.solution, self.language);
        let mut equations = page.equations.into_iter().peekable();
        let mut wheels = page.reduced.into_iter().peekable();
        for (i, block) in page.blocks.into_iter().enumerate() {
            if let Some((_, wheel)) = wheels.next_if(|(place, _)| *place == i) {
                self.reduced_torque(wheel);
            }
            if let Some((_, equation)) = equations.next_if(|(place, _)| *place == i) {
                self.equations.push((self.blocks.len(), equation));
            }
            self.blocks.push(block);
        }
        self.disagreements.extend(page.disagreements);
        self.design_values = page.values;
    }

    fn head(&mut self, heading: Message) {
        let heading = self.words(heading);
        self.heading(2, heading);
    }

    fn stage(&mut self, stage: Stage, plan: &[Figure]) {
        self.cite(Message::SeePlan, plan);
        self.motion(stage);
        self.requests(stage);
    }

    /// `φ₁ = 45°` of every drive.
    pub fn drive_words(&self, values: &[DriveValue]) -> Vec<String> {
        assur_picture::drive_words(self.scene.mechanism(), values, &self.scene.greatest)
    }

    /// `, φ₁ = 45°`, where the drives are; of a motion under loads the instant before.
    fn position_words(&self) -> String {
        let mechanism = self.scene.mechanism();
        let said = self.drive_words(&self.scene.pose.drives);
        let instant = mechanism.simulation.as_ref().map(|_| {
            let display = mechanism.display_of(Dimension::TIME);
            let time = Value::Scalar(self.state().motion.time);
            format!("t = {}", display.text(time, 5))
        });
        let said: Vec<String> = instant.into_iter().chain(said).collect();
        if said.is_empty() { String::new() } else { format!(", {}", said.join(", ")) }
    }
}
