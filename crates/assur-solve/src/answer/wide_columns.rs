//! Answers as numbers in the author's units, column by column, of positions side by side: as [`NumberColumns`], without a state of
//! each position.

use super::joint_reaction::JointReaction;
use super::number_columns::{ColumnSource, NumberColumns};
use super::pose_answers::PoseAnswers;
use super::wide_crossing::WideCrossing;
use super::wide_rows::{numbers, of_drive, vectors, write_drive};
use crate::math::{Scalar, V2, Vec2};
use crate::model::{Axis, BinaryOp, Expr, FindKind, LinkId, PairId, PointRef, Query, Value};
use crate::position::{BodyState, DriveValue, F64x8, Model, State, in_avx2};
use crate::structure::EffortSource;
use assur_text::units::Conversion;

#[derive(Clone, Debug)]
pub struct WideColumns(pub(super) Vec<Column>);

#[derive(Clone, Debug)]
pub(super) struct Column {
    pub shown: WideShown,
    pub unit: Conversion,
}

/// What a column shows, or two for a vector.
#[derive(Clone, Debug)]
pub(super) enum WideShown {
    /// The value of a drive.
    Drive(usize, bool),
    /// What an expression comes to.
    Found(WideExpr),
    /// What is known of a position in addition to its state.
    PoseExtras(WideBeside),
}

/// What is known of a position in addition to its state.
#[derive(Clone, Copy, Debug)]
pub(crate) enum WideBeside {
    /// The angle of a link with its whole turns, rad.
    Angle(LinkId),
    /// The residual of the equilibrium.
    Equilibrium,
    /// The residual of the powers.
    Power,
    Condition,
}

/// Expressions of answers that need no angle, in operations that all positions share.
#[derive(Clone, Debug)]
pub(super) enum WideExpr {
    Number(f64),
    Vector(Vec2),
    Position(LinkId, Vec2),
    Velocity(LinkId, Vec2),
    Acceleration(LinkId, Vec2),
    Omega(LinkId),
    Alpha(LinkId),
    Effort(usize),
    /// The force on a link in a pair.
    Force(JointReaction),
    Couple(JointReaction),
    Crossing(Box<WideCrossing>),
    Component(Box<Self>, Axis),
    Negate(Box<Self>),
    Binary(BinaryOp, Box<Self>, Box<Self>),
}

#[derive(Clone, Copy)]
enum WideValue {
    Number(F64x8),
    Vector(V2<F64x8>),
}

/// Longer expressions are evaluated position by position: quantities of the file are written out in them.
const LONGEST: usize = 64;

impl NumberColumns {
    /// The same for positions side by side; `None` where one shows more than a few operations on motion and forces.
    #[must_use]
    pub fn wide(&self, model: &Model<'_>) -> Option<WideColumns> {
        let columns = self.columns().map(|(shown, vector, unit)| {
            let shown = match shown {
                ColumnSource::Drive(drive) => WideShown::Drive(*drive, vector),
                ColumnSource::Effort(slot) => WideShown::Found(WideExpr::Effort(*slot)),
                ColumnSource::Force(joints) => WideShown::Found(WideExpr::Force(joints.clone())),
                ColumnSource::Couple(joints) => WideShown::Found(WideExpr::Couple(joints.clone())),
                ColumnSource::Find(index) => {
                    let FindKind::Value { expr, .. } = &model.mechanism.finds.get(*index)?.kind else {
                        return None;
                    };
                    let found = WideExpr::of_answer(model, expr)?;
                    (found.is_vector() == vector).then_some(WideShown::Found(found))?
                }
                ColumnSource::Known(Some(Value::Scalar(x))) if !vector => {
                    WideShown::Found(WideExpr::Number(*x))
                }
                ColumnSource::Known(Some(Value::Vector(v))) if vector => {
                    WideShown::Found(WideExpr::Vector(*v))
                }
                ColumnSource::Known(_) => return None,
            };
            Some(Column { shown, unit })
        });
        columns.collect::<Option<_>>().map(WideColumns)
    }
}

impl WideColumns {
    /// How many there are: a vector has two.
    #[must_use]
    pub fn count(&self) -> usize {
        self.0.iter().map(Column::count).sum()
    }

    /// Writes the numbers of the first positions, as many as there are places, column by column; NaN where there is none. `values` are
    /// those of the drives. What is known in addition to the states is left to `beside`.
    pub(crate) fn write(
        &self,
        rows: &[State<F64x8>],
        (values, drives): (&[DriveValue], usize),
        out: &mut dyn Iterator<Item = &mut [f64]>,
        beside: impl Fn(WideBeside, &mut [f64]),
    ) {
        for Column { shown, unit } in &self.0 {
            let Some(first) = out.next() else { return };
            match shown {
                WideShown::Found(expr) if expr.is_vector() => {
                    let Some(second) = out.next() else { return };
                    in_avx2(
                        #[inline(always)]
                        || expr.write_vectors(rows, first, second, *unit),
                    );
                }
                WideShown::Found(expr) => in_avx2(
                    #[inline(always)]
                    || expr.write_numbers(rows, first, *unit),
                ),
                WideShown::PoseExtras(what) => beside(*what, first),
                WideShown::Drive(drive, vector) => {
                    let second = if *vector { out.next() } else { None };
                    write_drive(of_drive(values, drives, *drive), *unit, first, second);
                }
            }
        }
    }
}

impl Column {
    fn count(&self) -> usize {
        1 + usize::from(match &self.shown {
            WideShown::Drive(_, vector) => *vector,
            WideShown::Found(expr) => expr.is_vector(),
            WideShown::PoseExtras(_) => false,
        })
    }
}

impl WideExpr {
    /// `None` for what is evaluated position by position.
    pub fn of_answer(model: &Model<'_>, expr: &Expr) -> Option<Self> {
        Self::of(model, expr, &mut LONGEST.clone())
    }

    fn of(model: &Model<'_>, expr: &Expr, left: &mut usize) -> Option<Self> {
        *left = left.checked_sub(1)?;
        Some(match expr {
            Expr::Constant(Value::Scalar(x)) => Self::Number(*x),
            Expr::Constant(Value::Vector(v)) => Self::Vector(*v),
            Expr::Component(v, axis) => {
                let v = Self::of(model, v, left).filter(Self::is_vector)?;
                Self::Component(Box::new(v), *axis)
            }
            Expr::Negate(a) => Self::Negate(Box::new(Self::of(model, a, left)?)),
            Expr::Binary(op, a, b) => {
                let (a, b) = (Self::of(model, a, left)?, Self::of(model, b, left)?);
                let fits = match (op, a.is_vector(), b.is_vector()) {
                    (BinaryOp::Add | BinaryOp::Sub, a, b) => a == b,
                    (BinaryOp::Mul, a, b) => !(a && b),
                    (BinaryOp::Div, _, b) => !b,
                };
                fits.then(|| Self::Binary(*op, Box::new(a), Box::new(b)))?
            }
            Expr::Quantity(id) => Self::of(model, &model.mechanism.quantities.get(id.index())?.expr, left)?,
            Expr::Query(query) => Self::of_query(model, query)?,
            _ => return None,
        })
    }

    fn of_query(model: &Model<'_>, query: &Query) -> Option<Self> {
        let mass = |link: &LinkId| model.mechanism.link(*link).mass;
        Some(match query {
            Query::Position(PointRef::Fixed(link, at)) => Self::Position(*link, *at),
            Query::Velocity(PointRef::Fixed(link, at)) => Self::Velocity(*link, *at),
            Query::Acceleration(PointRef::Fixed(link, at)) => Self::Acceleration(*link, *at),
            Query::Omega(link) => Self::Omega(*link),
            Query::Alpha(link) => Self::Alpha(*link),
            Query::Balance(id) => Self::effort(model, EffortSource::Balance(*id))?,
            Query::Effort(id) => Self::effort(model, EffortSource::Drive(*id))?,
            Query::Reaction(pair, link) => Self::Force(joints(model, *pair, *link)?),
            Query::Moment(pair, link) => Self::Couple(couple_joints(model, *pair, *link)?),
            Query::InertiaForce(link) => match mass(link) {
                Some(m) => Self::Acceleration(*link, m.centre).times(-m.mass),
                None => Self::Vector(Vec2::zero()),
            },
            Query::InertiaTorque(link) => match mass(link) {
                Some(m) => Self::Alpha(*link).times(-m.inertia),
                None => Self::Number(0.0),
            },
            _ => return None,
        })
    }

    /// A product with a number.
    pub fn times(self, factor: f64) -> Self {
        Self::Binary(BinaryOp::Mul, Box::new(self), Box::new(Self::Number(factor)))
    }

    fn effort(model: &Model<'_>, source: EffortSource) -> Option<Self> {
        model.structure.efforts.iter().position(|effort| effort.source == source).map(Self::Effort)
    }

    pub fn is_vector(&self) -> bool {
        match self {
            Self::Vector(_)
            | Self::Position(..)
            | Self::Velocity(..)
            | Self::Acceleration(..)
            | Self::Crossing(_)
            | Self::Force(_) => true,
            Self::Number(_)
            | Self::Omega(_)
            | Self::Alpha(_)
            | Self::Effort(_)
            | Self::Couple(_)
            | Self::Component(..) => false,
            Self::Negate(a) => a.is_vector(),
            Self::Binary(_, a, b) => a.is_vector() || b.is_vector(),
        }
    }

    // the usual ones without a look at the expression at every row
    #[inline(always)]
    fn write_vectors(&self, rows: &[State<F64x8>], x: &mut [f64], y: &mut [f64], unit: Conversion) {
        match self {
            Self::Position(link, at) => {
                vectors(rows, (x, y), unit, |state| state.motion.bodies[link.index()].position(*at));
            }
            Self::Velocity(link, at) => {
                vectors(rows, (x, y), unit, |state| state.motion.bodies[link.index()].velocity(*at));
            }
            Self::Acceleration(link, at) => {
                vectors(rows, (x, y), unit, |state| state.motion.bodies[link.index()].acceleration(*at));
            }
            Self::Force(joints) => vectors(rows, (x, y), unit, |state| joints.force(state)),
            other => vectors(rows, (x, y), unit, |state| match other.value(state) {
                WideValue::Vector(v) => v,
                WideValue::Number(x) => V2 { x, y: x },
            }),
        }
    }

    #[inline(always)]
    fn write_numbers(&self, rows: &[State<F64x8>], out: &mut [f64], unit: Conversion) {
        match self {
            Self::Omega(link) => numbers(rows, out, unit, |state| state.motion.bodies[link.index()].omega),
            Self::Effort(slot) => numbers(rows, out, unit, |state| state.forces.efforts[*slot]),
            Self::Couple(joints) => numbers(rows, out, unit, |state| joints.couple(state)),
            other => numbers(rows, out, unit, |state| match other.value(state) {
                WideValue::Vector(v) => v.x,
                WideValue::Number(x) => x,
            }),
        }
    }

    fn value(&self, state: &State<F64x8>) -> WideValue {
        use WideValue::{Number, Vector};
        let body = |link: &LinkId| -> &BodyState<F64x8> { &state.motion.bodies[link.index()] };
        match self {
            Self::Number(x) => Number(F64x8::of(*x)),
            Self::Vector(v) => Vector(V2::of(*v)),
            Self::Position(link, at) => Vector(body(link).position(*at)),
            Self::Velocity(link, at) => Vector(body(link).velocity(*at)),
            Self::Acceleration(link, at) => Vector(body(link).acceleration(*at)),
            Self::Omega(link) => Number(body(link).omega),
            Self::Alpha(link) => Number(body(link).alpha),
            Self::Effort(slot) => Number(state.forces.efforts[*slot]),
            Self::Force(joints) => Vector(joints.force(state)),
            Self::Couple(joints) => Number(joints.couple(state)),
            Self::Crossing(crossing) => Vector(crossing.at(state)),
            Self::Component(v, axis) => match (v.value(state), axis) {
                (Vector(v), Axis::X) => Number(v.x),
                (Vector(v), Axis::Y) => Number(v.y),
                (number, _) => number,
            },
            Self::Negate(a) => match a.value(state) {
                Number(x) => Number(-x),
                Vector(v) => Vector(-v),
            },
            Self::Binary(op, a, b) => binary(*op, a.value(state), b.value(state)),
        }
    }
}

/// The joints that a reaction is made up of, where they alone do, and forces are solved.
pub(super) fn joints(model: &Model<'_>, pair: PairId, link: LinkId) -> Option<JointReaction> {
    let state = State::closed(model.plan);
    JointReaction::of(&PoseAnswers::bare(model, &state), pair, link).filter(|_| model.plan.has_forces())
}

/// The same where its couple is determined.
pub(super) fn couple_joints(model: &Model<'_>, pair: PairId, link: LinkId) -> Option<JointReaction> {
    let determined = model.structure.undetermined_couples.binary_search(&pair).is_err();
    joints(model, pair, link).filter(|_| determined)
}

/// Two operands, as one position has them.
fn binary(op: BinaryOp, a: WideValue, b: WideValue) -> WideValue {
    use BinaryOp::{Add, Div, Mul, Sub};
    use WideValue::{Number, Vector};
    match (op, a, b) {
        (Add, Number(a), Number(b)) => Number(a + b),
        (Sub, Number(a), Number(b)) => Number(a - b),
        (Mul, Number(a), Number(b)) => Number(a * b),
        (Div, Number(a), Number(b)) => Number(a / b),
        (Add, Vector(a), Vector(b)) => Vector(a + b),
        (Sub, Vector(a), Vector(b)) => Vector(a - b),
        (Mul, Vector(a), Number(k)) | (Mul, Number(k), Vector(a)) => Vector(a * k),
        (Div, Vector(a), Number(k)) => Vector(a / k),
        // expressions are made of what fits
        _ => Number(F64x8::of(f64::NAN)),
    }
}
