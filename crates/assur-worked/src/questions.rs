//! What a file asks for, in words and letters.

use crate::asked_formula::letters;
use crate::document::{Inline, Line, text};
use crate::forces::quantity_name;
use crate::words::{FunctionWords, Language, QuestionMessage, say};
use assur_formula::{Node, name_node};
use assur_math::math::{SAME, Vec2};
use assur_model::model::{
    Axis, BalanceKind, CycleFunction, Expr, Find, FindKind, FlywheelPart, Function, LinkId, Mechanism,
    PairId, PairKind, PointRef, Query, SubstitutionPart, Wheel,
};

/// The questions of a file, one after another.
pub fn questions(mechanism: &Mechanism, source: &str, language: Language) -> Vec<Line> {
    let asking = Asking { mechanism, language };
    let letters = letters_of_all(mechanism, source, language);
    mechanism.finds.iter().zip(letters).map(|(find, letters)| asking.item(find, source, letters)).collect()
}

/// The letters of all questions: no two have the same ones.
pub fn letters_of_all(mechanism: &Mechanism, source: &str, language: Language) -> Vec<Option<Node>> {
    let mut all: Vec<Option<Node>> = Vec::new();
    for find in &mechanism.finds {
        let own = letters_of(mechanism, find, source, language);
        let is_free = !all.iter().any(|others| others.is_some() && *others == own);
        all.push(own.filter(|_| is_free));
    }
    all
}

/// The letters of a question: those of its name, else of what it is; none where it has only words.
fn letters_of(mechanism: &Mechanism, find: &Find, source: &str, language: Language) -> Option<Node> {
    let written = written(find, source);
    let named = named(find, written);
    let own = named.and_then(|name| letters(mechanism, name, language));
    own.or_else(|| letters(mechanism, &formula(written, named), language))
}

fn written<'a>(find: &'a Find, source: &'a str) -> &'a str {
    source.get(find.span.start..find.span.end).unwrap_or(&find.name)
}

/// The name that the author gave it.
fn named<'a>(find: &Find, written: &'a str) -> Option<&'a str> {
    written.split_once('=').map(|(name, _)| name.trim()).filter(|name| *name == find.name)
}

/// What one question is, without its letters and its unit.
pub fn question(mechanism: &Mechanism, source: &str, find: &Find, language: Language) -> Line {
    Asking { mechanism, language }.named(find, source, None)
}

/// Whether a question has neither a name of its own nor words: only a formula says what it is.
pub fn is_formula(mechanism: &Mechanism, source: &str, find: &Find, language: Language) -> bool {
    let FindKind::Value { expr, .. } = &find.kind else { return false };
    if mechanism.is_condition(expr) {
        return false;
    }
    let written = written(find, source);
    let words = Asking { mechanism, language }.expr(expr).is_some();
    named(find, written).is_none() && !words && !crate::asked_formula::has_words(&formula(written, None))
}

/// A reaction among all of them.
pub fn question_of_reaction(mechanism: &Mechanism, pair: PairId, on: LinkId, language: Language) -> Line {
    let asking = Asking { mechanism, language };
    asking.say(QuestionMessage::Reaction, &[asking.pair(pair), asking.link(on)])
}

/// Which couple of a pair acts on a link.
#[must_use]
pub fn question_of_couple(mechanism: &Mechanism, pair: PairId, on: LinkId, language: Language) -> Line {
    let asking = Asking { mechanism, language };
    asking.say(QuestionMessage::Moment, &[asking.pair(pair), asking.link(on)])
}

struct Asking<'a> {
    mechanism: &'a Mechanism,
    language: Language,
}

impl Asking<'_> {
    /// The letters of a question, what it is, and its unit.
    fn item(&self, find: &Find, source: &str, letters: Option<Node>) -> Line {
        let mut line = self.named(find, source, letters);
        if let FindKind::Value { display, .. } = &find.kind
            && !display.unit.is_empty()
        {
            line.push(text(format!(", {}", crate::sheet::printed_unit(&display.unit).trim_start())));
        }
        line
    }

    /// What a question is, after the letters that it has.
    fn named(&self, find: &Find, source: &str, letters: Option<Node>) -> Line {
        let written = written(find, source);
        let expr = match &find.kind {
            FindKind::Reactions => return self.say(QuestionMessage::Reactions, &[]),
            FindKind::Table(_) => return self.table(written),
            FindKind::Value { expr, .. } => expr,
        };
        let named = named(find, written);
        let words = self.expr(expr).unwrap_or_else(|| {
            let formula = formula(written, named);
            let words = crate::asked_formula::asked(self.mechanism, &formula, self.language);
            words.unwrap_or_else(|| vec![text(formula.replace('*', "·"))])
        });
        // what is only its letters needs them once
        match letters.map(Inline::Math).filter(|letters| !words.contains(letters)) {
            Some(letters) => [vec![letters, text(" – ")], words].concat(),
            None => words,
        }
    }

    /// A table: of which part of the mechanism.
    fn table(&self, written: &str) -> Line {
        let parts = written.split_once('(').and_then(|(function, rest)| {
            Some((FunctionWords::of(function.trim(), 1)?, rest.split_once(')')?.0.trim()))
        });
        match parts {
            Some((words, of)) => say(self.language, words, &[vec![text(of)]]),
            None => vec![text(one_line(written))],
        }
    }

    fn say(&self, message: QuestionMessage, parts: &[Line]) -> Line {
        say(self.language, message, parts)
    }

    /// What an expression is; none where it is a formula.
    fn expr(&self, expr: &Expr) -> Option<Line> {
        match expr {
            Expr::Query(query) => self.query(query),
            Expr::Quantity(id) => self.expr(&self.mechanism.quantities.get(id.index())?.expr),
            Expr::Component(of, axis) => {
                let part = match axis {
                    Axis::X => QuestionMessage::AlongX,
                    Axis::Y => QuestionMessage::AlongY,
                };
                Some(self.say(part, &[self.expr(of)?]))
            }
            Expr::Call(Function::Mag | Function::Abs, of) => {
                let [of] = of.as_slice() else { return None };
                Some(self.say(QuestionMessage::Magnitude, &[self.expr(of)?]))
            }
            Expr::Call(Function::Direction, of) => {
                let [of] = of.as_slice() else { return None };
                Some(self.say(QuestionMessage::Direction, &[self.expr(of)?]))
            }
            Expr::Frictionless(of) => Some(self.say(QuestionMessage::Frictionless, &[self.expr(of)?])),
            _ => None,
        }
    }

    fn query(&self, query: &Query) -> Option<Line> {
        use QuestionMessage as M;
        let m = self.mechanism;
        let (link, pair) = (|id: &LinkId| self.link(*id), |id: &PairId| self.pair(*id));
        let (message, parts) = match query {
            Query::Angle(id) => (M::Angle, vec![link(id)]),
            Query::Omega(id) => (M::AngularVelocity, vec![link(id)]),
            Query::Alpha(id) => (M::AngularAcceleration, vec![link(id)]),
            Query::AngularJerk(id) => (M::AngularJerk, vec![link(id)]),
            Query::Displacement(id) => {
                let parts = matches!(m.pair(*id).kind, PairKind::Contact { .. });
                (if parts { M::Gap } else { M::Displacement }, vec![pair(id)])
            }
            Query::RelativeVelocity(id) => (M::RelativeVelocity, vec![pair(id)]),
            Query::Sliding(id) => (M::Sliding, vec![pair(id)]),
            Query::RelativeAcceleration(id) => (M::RelativeAcceleration, vec![pair(id)]),
            Query::RelativeJerk(id) => (M::RelativeJerk, vec![pair(id)]),
            Query::Coriolis(id) => (M::Coriolis, vec![pair(id)]),
            Query::Reaction(id, on) => (M::Reaction, vec![pair(id), link(on)]),
            Query::Axial(id) => (M::Axial, vec![link(id)]),
            Query::Moment(id, on) => (M::Moment, vec![pair(id), link(on)]),
            Query::Normal(id, on) => (M::Normal, vec![pair(id), link(on)]),
            Query::Friction(id, on) => (M::Friction, vec![pair(id), link(on)]),
            Query::FrictionPower(id) => (M::FrictionPower, vec![pair(id)]),
            Query::Efficiency => (M::Efficiency, Vec::new()),
            Query::Locked => (M::Locked, Vec::new()),
            Query::InertiaForce(id) => (M::InertiaForce, vec![link(id)]),
            Query::InertiaTorque(id) => (M::InertiaTorque, vec![link(id)]),
            Query::PressureAngle(id) => (M::PressureAngle, vec![pair(id)]),
            Query::Balance(id) => {
                let balance = m.balances.get(id.index())?;
                let message = match balance.kind {
                    BalanceKind::Torque(_) => M::BalancingTorque,
                    _ => M::BalancingEffort,
                };
                (message, vec![self.letters(&balance.name)])
            }
            Query::StopsEffort(id) => (M::StopsEffort, vec![pair(id)]),
            Query::Impulse(id) => (M::Impulse, vec![pair(id)]),
            Query::Effort(id) => (M::DriveEffort, vec![vec![text(&*m.drives.get(id.index())?.name)]]),
            Query::Load(id) => (M::Load, vec![self.letters(m.loads.get(id.index())?.name.as_deref()?)]),
            Query::BalancePower(id) => (M::Power, vec![self.letters(&m.balances.get(id.index())?.name)]),
            Query::LoadPower(id) => (M::Power, vec![self.letters(m.loads.get(id.index())?.name.as_deref()?)]),
            Query::EffortPower(id) => (M::Power, vec![vec![text(&*m.drives.get(id.index())?.name)]]),
            Query::KineticEnergy => (M::KineticEnergy, Vec::new()),
            Query::PotentialEnergy => (M::PotentialEnergy, Vec::new()),
            Query::Travel(id) => (M::Travel, vec![pair(id)]),
            Query::Stroke(id) => (M::Stroke, vec![pair(id)]),
            Query::TimeRatio(id) => (M::TimeRatio, vec![pair(id)]),
            Query::TangentialForce(id, on) => self.of_wheels(
                *id,
                *on,
                [M::TangentialForce, M::TangentialForceOn, M::TangentialForceBetween],
            ),
            Query::ToothForce(id, on) => {
                self.of_wheels(*id, *on, [M::ToothForce, M::ToothForceOn, M::ToothForceBetween])
            }
            Query::Tension(id, ..) => (M::Tension, vec![pair(id)]),
            Query::TightSide(id) => (M::TightSide, vec![pair(id)]),
            Query::SlackSide(id) => (M::SlackSide, vec![pair(id)]),
            Query::Dead(id, _) => (M::DeadPosition, vec![pair(id)]),
            Query::Period => (M::Period, Vec::new()),
            Query::EventDrive(id, _) => (M::EventDrive, self.event(*id)?),
            Query::EventTime(id, _) => (M::EventTime, self.event(*id)?),
            Query::Cycle(id) => {
                let cycle = m.cycles.get(*id)?;
                let message = match cycle.how {
                    CycleFunction::Max => M::Greatest,
                    CycleFunction::Min => M::Least,
                    CycleFunction::Mean => M::Mean,
                    CycleFunction::Integral => M::Integral,
                    CycleFunction::Argmax => M::WhereGreatest,
                    CycleFunction::Harmonic(_) => return None,
                };
                (message, vec![self.expr(&cycle.expr)?])
            }
            Query::Work(id) => (M::Work, vec![self.expr(m.works.get(*id)?)?]),
            Query::Flywheel(id, part) => {
                (of_flywheel(*part), vec![self.letters(&m.flywheels.get(*id)?.name)])
            }
            Query::StaticSubstitution(id, first, second, part) => {
                let mass = |at: Vec2| Some((M::StaticMass, vec![link(id), self.at(*id, at)?]));
                match part {
                    SubstitutionPart::M1 => mass(*first)?,
                    SubstitutionPart::M2 => mass(*second)?,
                    SubstitutionPart::DJ => (M::InertiaLeft, vec![link(id)]),
                    _ => return None,
                }
            }
            Query::DynamicSubstitution(id, first, part) => match part {
                SubstitutionPart::M1 => (M::DynamicMass, vec![link(id), self.at(*id, *first)?]),
                SubstitutionPart::M2 => (M::SecondMass, vec![link(id)]),
                SubstitutionPart::L2 => (M::SecondDistance, vec![link(id)]),
                _ => return None,
            },
            _ => {
                let (message, at) = of_point(query)?;
                (message, vec![self.point(at)?])
            }
        };
        Some(self.say(message, &parts))
    }

    fn event(&self, id: usize) -> Option<Vec<Line>> {
        let name = self.mechanism.events.get(id)?.name.as_deref()?;
        Some(vec![vec![text(name)]])
    }

    /// A force between two wheels: in their transmission, on one from the other, between both.
    fn of_wheels(
        &self,
        id: PairId,
        on: Option<LinkId>,
        [within, one, between]: [QuestionMessage; 3],
    ) -> (QuestionMessage, Vec<Line>) {
        let pair = self.mechanism.pair(id);
        let wheels: Vec<&Wheel> = match &pair.kind {
            // with losses the two wheels have not the same force
            PairKind::Transmission(t) if on.is_some() || t.laws.iter().all(|l| l.efficiency.is_none()) => t
                .ends
                .iter()
                .filter_map(|end| self.mechanism.wheels.iter().find(|w| w.name == *end))
                .collect(),
            _ => Vec::new(),
        };
        let named = |wheel: &Wheel| vec![text(&*wheel.name)];
        match (wheels.as_slice(), on) {
            ([a, b], None) => (between, vec![named(a), named(b)]),
            ([a, b], Some(link)) if a.link == link => (one, vec![named(a), named(b)]),
            ([a, b], Some(link)) if b.link == link => (one, vec![named(b), named(a)]),
            _ => (within, vec![self.pair(id)]),
        }
    }

    fn letters(&self, name: &str) -> Line {
        vec![Inline::Math(name_node(&quantity_name(name)))]
    }

    fn link(&self, id: LinkId) -> Line {
        let link = self.mechanism.link(id);
        vec![text(link.number.clone().unwrap_or_else(|| link.name.clone()))]
    }

    fn pair(&self, id: PairId) -> Line {
        vec![text(&*self.mechanism.pair(id).name)]
    }

    /// The name of a point.
    fn point(&self, at: &PointRef) -> Option<Line> {
        let PointRef::Fixed(id, at) = at else { return None };
        self.at(*id, *at)
    }

    fn at(&self, id: LinkId, at: Vec2) -> Option<Line> {
        let link = self.mechanism.link(id);
        let point = link.points.iter().find(|p| (p.at - at).norm() <= SAME)?;
        Some(vec![text(&*point.name)])
    }
}

/// A question without its name and its unit.
fn formula(written: &str, named: Option<&str>) -> String {
    let words = one_line(written);
    let right = match (named, words.split_once('=')) {
        (Some(_), Some((_, right))) => right.trim().to_owned(),
        _ => words,
    };
    match right.rsplit_once(" as ") {
        Some((formula, _)) => formula.trim().to_owned(),
        None => right,
    }
}

fn one_line(words: &str) -> String {
    words.split_whitespace().collect::<Vec<_>>().join(" ")
}

fn of_flywheel(part: FlywheelPart) -> QuestionMessage {
    use QuestionMessage as M;
    match part {
        FlywheelPart::Inertia => M::FlywheelInertia,
        FlywheelPart::Fluctuation => M::Fluctuation,
        FlywheelPart::RimWidth => M::RimWidth,
        FlywheelPart::RimHeight => M::RimHeight,
        FlywheelPart::RimMass => M::RimMass,
        FlywheelPart::Torque => M::ReducedTorque,
        FlywheelPart::LinksInertia => M::ReducedInertia,
        FlywheelPart::Work => M::ExcessWork,
    }
}

/// What is asked of a point.
const fn of_point(query: &Query) -> Option<(QuestionMessage, &PointRef)> {
    use QuestionMessage as M;
    Some(match query {
        Query::Position(at) => (M::Position, at),
        Query::Velocity(at) => (M::Velocity, at),
        Query::Acceleration(at) => (M::Acceleration, at),
        Query::Jerk(at) => (M::Jerk, at),
        Query::CurvatureRadius(at) => (M::CurvatureRadius, at),
        Query::CurvatureCentre(at) => (M::CurvatureCentre, at),
        _ => return None,
    })
}
