//! Motion of points, links and pairs.

use crate::error::RequestError;
use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::names::declared::ThingKind;
use crate::requests::query::args::{Mover, path};
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_model::model::{Expr as ModelExpr, Function, PairId, PairKind, PointRef, Query};
use assur_syntax::document::{Drive, Expr, ExprKind, JointKind, Statement};
use assur_text::source::Spanned;
use assur_text::units::Dimension;

fn number(query: Query, dimension: Dimension) -> Typed {
    Typed::new(ModelExpr::Query(query), Type::number(dimension))
}

fn vector(query: Query, dimension: Dimension) -> Typed {
    Typed::new(ModelExpr::Query(query), Type::vector(dimension))
}

impl Context<'_> {
    /// `position`, `velocity`, `acceleration`
    pub(crate) fn point_motion(&mut self, call: Call<'_>) -> Option<Typed> {
        let dimension = match call.name.node.as_str() {
            "position" => Dimension::LENGTH,
            "velocity" => Dimension::VELOCITY,
            _ => Dimension::ACCELERATION,
        };
        let args = self.arguments(call, 1, 2)?;
        let point = match args[..] {
            [one] => {
                if let Some(pair) = self.slider(one) {
                    let query = match call.name.node.as_str() {
                        "position" => Query::Displacement(pair),
                        "velocity" => Query::RelativeVelocity(pair),
                        _ => Query::RelativeAcceleration(pair),
                    };
                    return Some(number(query, dimension));
                }
                let (link, at) = self.point_argument(call, one)?;
                PointRef::Fixed(link, at)
            }
            [_, point] if path(point).is_none() => {
                let (function, usage) = (call.name.node.clone(), self.own_usage(call));
                let takes = "a point, or a link and a point";
                self.error(RequestError::Arguments { function, takes, found: 2, span: call.span, usage });
                return None;
            }
            [link, point] => {
                let link = self.link_argument(call, link);
                let point = self.point_argument(call, point);
                PointRef::Under(link?, point?)
            }
            _ => return None,
        };
        let query = match call.name.node.as_str() {
            "position" => Query::Position(point),
            "velocity" => Query::Velocity(point),
            _ => Query::Acceleration(point),
        };
        Some(vector(query, dimension))
    }

    /// The pair of a slider on a rope.
    fn slider(&self, expr: &Expr) -> Option<PairId> {
        let ExprKind::Name(name) = &expr.kind else { return None };
        let is_slider = self.names.things.get(name).is_some_and(|d| d.what == ThingKind::Slider);
        self.find_pair(name).filter(|_| is_slider)
    }

    /// `speed(A)`: the magnitude of a slider's velocity.
    pub(crate) fn speed(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let Some(pair) = self.slider(args[0]) else {
            if self.speed_of_point(call) {
                return None;
            }
            self.element(call, "a slider", |k| k == ThingKind::Slider)?;
            return None;
        };
        let velocity = ModelExpr::Query(Query::RelativeVelocity(pair));
        let speed = fold::call(Function::Abs, vec![velocity]);
        Some(Typed::new(speed, Type::number(Dimension::VELOCITY)))
    }

    /// `radius(w1)`: of a gear wheel that of its pitch circle.
    pub(crate) fn radius_of_wheel(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        self.element(call, "a wheel", |k| k == ThingKind::Wheel)?;
        let ExprKind::Name(name) = &args[0].kind else { return None };
        let radius = self.wheel_radius(&Spanned::new(name.clone(), args[0].span))?;
        Some(Typed::constant(radius, Dimension::LENGTH))
    }

    /// `angle`, `omega`, `alpha`, `dir` of a link
    pub(crate) fn link_motion(&mut self, call: Call<'_>) -> Option<Typed> {
        if self.link_by_points(call).is_some() {
            return None;
        }
        let args = self.arguments(call, 1, 1)?;
        if self.not_of_a_link(call, args[0]) {
            return None;
        }
        let mover = self.mover(call, args[0])?;
        let (dimension, query): (_, fn(_) -> Query) = match call.name.node.as_str() {
            "angle" => (Dimension::ANGLE, Query::Angle),
            "omega" => (Dimension::ANGULAR_VELOCITY, Query::Omega),
            "alpha" => (Dimension::ANGULAR_ACCELERATION, Query::Alpha),
            _ => (Dimension::NUMBER, Query::LinkDirection),
        };
        match mover {
            Mover::Link(link) if call.name.node == "dir" => Some(vector(query(link), dimension)),
            Mover::Link(link) => Some(number(query(link), dimension)),
            Mover::Slider => {
                self.wrong_argument(call, "what turns, and not a slider,", args[0].span);
                None
            }
        }
    }

    /// Functions of a pair's coordinate.
    pub(crate) fn pair_motion(&mut self, call: Call<'_>) -> Option<Typed> {
        let count = if call.name.node == "dead" { 2 } else { 1 };
        let args = self.arguments(call, count, count)?;
        let pair = self.pair_argument(call, args[0])?;
        if call.name.node == "coriolis" {
            return self.coriolis(call, pair);
        }
        let coordinate = self.coordinate(call, pair)?;
        Some(match call.name.node.as_str() {
            "displacement" => number(Query::Displacement(pair), coordinate),
            "relative_velocity" => number(Query::RelativeVelocity(pair), per_time(coordinate, 1)),
            "relative_acceleration" => number(Query::RelativeAcceleration(pair), per_time(coordinate, 2)),
            "travel" => number(Query::Travel(pair), coordinate),
            "stroke" => number(Query::Stroke(pair), coordinate),
            "time_ratio" => {
                self.only_drive(call)?;
                number(Query::TimeRatio(pair), Dimension::NUMBER)
            }
            _ => {
                let drive = self.only_drive(call)?;
                number(Query::Dead(pair, self.one_or_two(call, args[1])?), drive)
            }
        })
    }

    /// `1` or `2`, as written.
    pub(crate) fn one_or_two(&mut self, call: Call<'_>, expr: &Expr) -> Option<u8> {
        match &expr.kind {
            ExprKind::Number(n) if n.unit.is_none() && n.value == 1.0 => Some(1),
            ExprKind::Number(n) if n.unit.is_none() && n.value == 2.0 => Some(2),
            _ => {
                self.wrong_argument(call, "the number 1 or 2", expr.span);
                None
            }
        }
    }

    fn coriolis(&mut self, call: Call<'_>, pair: PairId) -> Option<Typed> {
        match self.builder.mech.pair(pair).kind {
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => {
                Some(vector(Query::Coriolis(pair), Dimension::ACCELERATION))
            }
            PairKind::Revolute(_) | PairKind::Contact { .. } | PairKind::Transmission(_) => {
                self.not_of_this_pair(call, pair, Some("it is defined where a point slides along a line"));
                None
            }
        }
    }

    /// The dimension of a pair's coordinate.
    fn coordinate(&mut self, call: Call<'_>, pair: PairId) -> Option<Dimension> {
        match &self.builder.mech.pair(pair).kind {
            PairKind::Revolute(pins) if pins.len() > 2 => {
                let links = pins.iter().map(|p| p.link).collect::<Vec<_>>();
                let names = self.spelled(&links);
                let help = format!("write it with links: `angle({}) - angle({})`", names[2], names[1]);
                let (pair, count) = (self.builder.mech.pair(pair).name.clone(), names.len());
                self.error(RequestError::WhichTwo { pair, count, span: call.span, help });
                None
            }
            PairKind::Revolute(_) => Some(Dimension::ANGLE),
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => Some(Dimension::LENGTH),
            PairKind::Contact { .. } | PairKind::Transmission(_) => {
                self.not_of_this_pair(call, pair, Some("it has no coordinate"));
                None
            }
        }
    }

    /// The dimension of the one drive's values.
    pub(crate) fn only_drive(&mut self, call: Call<'_>) -> Option<Dimension> {
        let drives = self.drive_statements();
        if let [drive] = drives[..] {
            return Some(self.drive_dimension(drive));
        }
        let (function, count, span) = (call.name.node.clone(), drives.len(), call.span);
        self.error(RequestError::WhichDrive { function, count, span });
        None
    }

    /// All drives as written, in order: their place is their id.
    pub fn drive_statements(&self) -> Vec<&Drive> {
        let all = self.doc.statements.iter();
        all.filter_map(|s| if let Statement::Drive(d) = &s.node { Some(d) } else { None }).collect()
    }

    /// An angle or a length.
    pub fn drive_dimension(&self, drive: &Drive) -> Dimension {
        let head = self.names.things.get(&drive.target.head.node).map(|d| d.what);
        match (head, &drive.target.tail) {
            (_, Some(_)) => Dimension::LENGTH,
            (
                Some(
                    ThingKind::Joint(JointKind::Revolute)
                    | ThingKind::Link
                    | ThingKind::Shaft
                    | ThingKind::Wheel,
                ),
                None,
            ) => Dimension::ANGLE,
            (Some(ThingKind::Joint(_) | ThingKind::Slider), None) => Dimension::LENGTH,
            _ => Dimension::ANGLE,
        }
    }

    pub(crate) fn transmission_angle(&mut self, call: Call<'_>) -> Option<Typed> {
        if !call.args.is_empty() && self.group_by_links(call).is_some() {
            return None;
        }
        let args = self.arguments(call, 1, 1)?;
        let ExprKind::Name(name) = &args[0].kind else {
            self.wrong_argument(call, "a group", args[0].span);
            return None;
        };
        let group = self.group(&Spanned::new(name.clone(), args[0].span))?;
        Some(number(Query::TransmissionAngle(group), Dimension::ANGLE))
    }

    pub(crate) fn pressure_angle(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.pair_argument(call, args[0])?;
        match self.builder.mech.pair(pair).kind {
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Contact { .. } => {
                Some(number(Query::PressureAngle(pair), Dimension::ANGLE))
            }
            PairKind::Revolute(_) | PairKind::Cylinder { .. } | PairKind::Transmission(_) => {
                self.not_of_this_pair(call, pair, None);
                None
            }
        }
    }
}

/// The dimension of a rate.
const fn per_time(d: Dimension, n: i8) -> Dimension {
    Dimension { time: d.time - n, ..d }
}
