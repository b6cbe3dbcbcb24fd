//! Motion of points, links and pairs.

use crate::expr::context::Context;
use crate::expr::results::{Call, argument_count};
use crate::names::declared::ThingKind;
use crate::requests::query::args::{Mover, path};
use crate::requests::query::pair_kinds::ALONG_LINE;
use crate::trains::bevel;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_model::model::{
    CamPart, Expr as ModelExpr, Function as ModelFunction, LinkId, Pair, PairId, PairKind, PointRef, Query,
};
use assur_syntax::document::{Arg, Drive, Expr, ExprKind, JointKind, Statement};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::language::Function;
use assur_text::source::Spanned;
use assur_text::units::Dimension;

fn number(query: Query, dimension: Dimension) -> Typed {
    Typed::new(ModelExpr::Query(query), Type::number(dimension))
}

fn vector(query: Query, dimension: Dimension) -> Typed {
    Typed::new(ModelExpr::Query(query), Type::vector(dimension))
}

impl Context<'_> {
    /// `position`, `velocity`, `acceleration`: of a point, or of a slider on a rope
    pub(crate) fn point_motion(
        &mut self,
        call: Call<'_>,
        dimension: Dimension,
        of_point: fn(PointRef) -> Query,
        of_slider: fn(PairId) -> Query,
    ) -> Option<Typed> {
        if let Some(found) = self.moved_mass_centre(call.args, of_point, dimension) {
            return found;
        }
        let args = self.arguments(call, 1, 2)?;
        let point = match args[..] {
            [one] => {
                if let Some(pair) = self.slider(one) {
                    return Some(number(of_slider(pair), dimension));
                }
                let (link, at) = self.point_argument(call, one)?;
                PointRef::Fixed(link, at)
            }
            [_, point] if path(point).is_none() => {
                let (function, usage) = (call.name.node.clone(), self.own_usage(call));
                let takes = "a point, or a link and a point";
                self.error(argument_count(&function, takes, 2, call.span, &usage));
                return None;
            }
            [link, point] => {
                let link = self.link_argument(call, link);
                let point = self.point_argument(call, point);
                PointRef::Under(link?, point?)
            }
            _ => return None,
        };
        Some(vector(of_point(point), dimension))
    }

    /// The curvature of the path of a point, or of a designed cam.
    pub(super) fn curvature(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        let is_radius = function == Function::CurvatureRadius;
        if is_radius && !self.asks_path(call.args) {
            return self.of_cam(call, CamPart::CurvatureRadius);
        }
        let args = self.arguments(call, 1, 1)?;
        let (link, at) = self.point_argument(call, args[0])?;
        let point = PointRef::Fixed(link, at);
        Some(match is_radius {
            true => number(Query::CurvatureRadius(point), Dimension::LENGTH),
            false => vector(Query::CurvatureCentre(point), Dimension::LENGTH),
        })
    }

    /// Whether the one argument is a point, or what else cannot be a cam.
    fn asks_path(&mut self, args: &[Arg]) -> bool {
        let [Arg { value, name: None }] = args else { return false };
        let is_shared = |name: &String| self.bearers_as_declared(name).next().is_some();
        let may_be_cam = match &value.kind {
            ExprKind::Name(name) => !is_shared(name) && !self.builder.mech.cams.is_empty(),
            ExprKind::Member(..) => false,
            _ => true,
        };
        !may_be_cam && !self.asks_cam(args)
    }

    /// The pair of a slider on a rope.
    fn slider(&mut self, expr: &Expr) -> Option<PairId> {
        let ExprKind::Name(name) = &expr.kind else { return None };
        let is_slider = self.names.things.get(name).is_some_and(|d| d.what == ThingKind::Slider);
        let found = self.find_pair(name).filter(|_| is_slider)?;
        self.note_names(expr);
        Some(found)
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
        let speed = fold::call(ModelFunction::Abs, vec![velocity]);
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
    pub(crate) fn link_motion(
        &mut self,
        call: Call<'_>,
        query: fn(LinkId) -> Query,
        ty: Type,
    ) -> Option<Typed> {
        if self.link_by_points(call).is_some() {
            return None;
        }
        let args = self.arguments(call, 1, 1)?;
        if self.not_of_a_link(call, args[0]) {
            return None;
        }
        match self.mover(call, args[0])? {
            Mover::Link(link) => Some(Typed::new(ModelExpr::Query(query(link)), ty)),
            Mover::Slider => {
                self.wrong_argument(call, "a link that turns, not a slider,", args[0].span);
                None
            }
        }
    }

    /// A function of a pair's coordinate that is so many times its rate.
    pub(crate) fn of_coordinate(
        &mut self,
        call: Call<'_>,
        query: fn(PairId) -> Query,
        rates: i8,
    ) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.pair_argument(call, args[0])?;
        let coordinate = self.coordinate(call, pair)?;
        Some(number(query(pair), per_time(coordinate, rates)))
    }

    /// Whether the one argument is a pair in which a point slides along a line, and no point has its name.
    pub(super) fn asks_guide(&self, args: &[Arg]) -> bool {
        let [Arg { value: Expr { kind: ExprKind::Name(name), .. }, .. }] = args else { return false };
        let slides = |pair| (ALONG_LINE.0)(self.builder.mech.pair(pair));
        self.bearers_as_declared(name).next().is_none() && self.find_pair(name).is_some_and(slides)
    }

    /// `time_ratio(G)`
    pub(super) fn time_ratio(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.pair_argument(call, args[0])?;
        self.coordinate(call, pair)?;
        self.only_drive(call)?;
        Some(number(Query::TimeRatio(pair), Dimension::NUMBER))
    }

    /// `dead(G, 1)`
    pub(super) fn dead(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let pair = self.pair_argument(call, args[0])?;
        self.coordinate(call, pair)?;
        let drive = self.only_drive(call)?;
        Some(number(Query::Dead(pair, self.one_or_two(call, args[1])?), drive))
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

    /// What some kinds of pairs have: those of which `has` holds.
    pub(crate) fn of_pair(
        &mut self,
        call: Call<'_>,
        (has, help): (fn(&Pair) -> bool, Option<&str>),
        query: fn(PairId) -> Query,
        ty: Type,
    ) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.pair_argument(call, args[0])?;
        if has(self.builder.mech.pair(pair)) {
            return Some(Typed::new(ModelExpr::Query(query(pair)), ty));
        }
        self.not_of_this_pair(call, pair, help);
        None
    }

    /// The dimension of a pair's coordinate.
    fn coordinate(&mut self, call: Call<'_>, pair: PairId) -> Option<Dimension> {
        match &self.builder.mech.pair(pair).kind {
            PairKind::Revolute(pins) if pins.len() > 2 => {
                let links = pins.iter().map(|p| p.link).collect::<Vec<_>>();
                let names = self.spelled(&links);
                let help = format!("write it with links: `angle({}) - angle({})`", names[2], names[1]);
                let (pair, count) = (self.builder.mech.pair(pair).name.clone(), names.len());
                self.error(
                    Diagnosis::error(
                        "mech::request::which_two",
                        format!("`{pair}` joins {count} links and has no single relative motion"),
                    )
                    .primary(call.span, "this question")
                    .fixes(Fix::quoted(&help.replace(" with links:", ""), call.span))
                    .help(help),
                );
                None
            }
            PairKind::Revolute(_) if bevel::carries(self, pair) => {
                let name = self.builder.mech.pair(pair).name.clone();
                let help = format!("ask for `omega({name})`: it is relative to the carrier");
                self.not_of_this_pair(call, pair, Some(&help));
                None
            }
            PairKind::Revolute(_) => Some(Dimension::ANGLE),
            PairKind::Prismatic(_) | PairKind::Slot(_) | PairKind::Cylinder { .. } => Some(Dimension::LENGTH),
            PairKind::Contact { parts: true, .. } => Some(Dimension::LENGTH),
            PairKind::Contact { .. } | PairKind::Weld { .. } | PairKind::Transmission(_) => {
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
        self.error(
            Diagnosis::error(
                "mech::request::which_drive",
                format!("`{function}` needs exactly one drive, but there are {count}"),
            )
            .primary(span, "this question")
            .help("use it in a mechanism with one drive"),
        );
        None
    }

    /// All drives as written, in order.
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
}

/// The dimension of a rate.
const fn per_time(d: Dimension, n: i8) -> Dimension {
    Dimension { time: d.time - n, ..d }
}
