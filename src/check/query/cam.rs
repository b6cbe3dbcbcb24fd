//! What is asked of a designed cam: a value at a cam angle, a greatest or least one over the turn, a table.

use super::Call;
use super::args::path;
use crate::check::context::Context;
use crate::check::error::{MotionError, RequestError, UnitsError};
use crate::check::expr::Want;
use crate::check::expr::typed::{Type, Typed};
use crate::check::names::ThingKind;
use crate::element::cam::{CamPoint, Quantity};
use crate::math::Vec2;
use crate::model::{Expr as ModelExpr, FindKind, PlateCam, Table, TableEntry, Value};
use crate::source::Spanned;
use crate::syntax::document::{Arg, Expr, ExprKind, FindItem, Name};
use crate::units::Dimension;
use std::f64::consts::TAU;

/// Steps of a table where none are written.
const STEPS: usize = 36;
/// The most steps of a table.
const MOST_STEPS: usize = 36_000;

/// A number or vector that belongs to a cam angle.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CamPart {
    /// Lift (0) and its derivatives by the cam angle.
    Lift(u8),
    /// Derivatives of the lift by time.
    Rate(u8),
    /// Knife edge or centre of the roller in the axes of the cam.
    Pitch,
    /// Place of contact in the axes of the cam.
    Point,
    /// Pressure angle.
    PressureAngle,
    /// Radius of curvature of the pitch curve.
    CurvatureRadius,
}

/// Parts by name.
const PARTS: [(&str, CamPart); 11] = [
    ("s", CamPart::Lift(0)),
    ("s'", CamPart::Lift(1)),
    ("s''", CamPart::Lift(2)),
    ("s'''", CamPart::Lift(3)),
    ("velocity", CamPart::Rate(1)),
    ("acceleration", CamPart::Rate(2)),
    ("jerk", CamPart::Rate(3)),
    ("pitch", CamPart::Pitch),
    ("point", CamPart::Point),
    ("pressure_angle", CamPart::PressureAngle),
    ("curvature_radius", CamPart::CurvatureRadius),
];

impl CamPart {
    fn ty(self, oscillates: bool) -> Type {
        let way = if oscillates { Dimension::ANGLE } else { Dimension::LENGTH };
        match self {
            Self::Lift(0) => Type::number(way),
            Self::Lift(_) if oscillates => Type::number(Dimension::NUMBER),
            Self::Lift(_) | Self::CurvatureRadius => Type::number(Dimension::LENGTH),
            #[allow(clippy::cast_possible_wrap)] // 1 to 3
            Self::Rate(n) => Type::number(Dimension { time: -(n as i8), ..way }),
            Self::Pitch | Self::Point => Type::vector(Dimension::LENGTH),
            Self::PressureAngle => Type::number(Dimension::ANGLE),
        }
    }

    fn value(self, plate: &PlateCam, phi: f64, at: &CamPoint) -> Value {
        Value::Scalar(match self {
            Self::Lift(n) => at.value(Quantity::Lift(n)),
            Self::Rate(n) => at.value(Quantity::Lift(n)) * rate(plate, n),
            Self::Pitch => return Value::Vector(plate.cam.in_cam(at.tip, phi)),
            Self::Point => return Value::Vector(plate.cam.in_cam(at.contact, phi)),
            Self::PressureAngle => at.value(Quantity::PressureAngle),
            Self::CurvatureRadius => at.value(Quantity::CurvatureRadius),
        })
    }
}

/// What a derivative by the cam angle is multiplied by to be one by time; not a number without a speed.
fn rate(plate: &PlateCam, n: u8) -> f64 {
    plate.speed.map_or(f64::NAN, |omega| (0..n).fold(1.0, |k, _| k * omega))
}

fn part_list() -> String {
    let all = PARTS.iter().map(|(name, _)| format!("`.{name}`")).collect::<Vec<_>>();
    format!("its parts are {}", all.join(", "))
}

impl Context<'_> {
    /// The designed cam an expression names; `None` where it names none, `Some(None)` where that one has an error.
    fn cam_of(&self, expr: &Expr) -> Option<Option<PlateCam>> {
        let names = path(expr)?;
        let [name] = names.as_slice() else { return None };
        let is_cam = self.names.things.get(&name.node).is_some_and(|d| d.what == ThingKind::Cam);
        is_cam.then(|| self.mech.cams.iter().find(|c| c.name == name.node).cloned())
    }

    /// The cam that the first argument must name.
    fn cam_argument(&mut self, call: Call<'_>, expr: &Expr) -> Option<PlateCam> {
        if let Some(cam) = self.cam_of(expr) {
            return cam;
        }
        match path(expr).as_deref() {
            Some([name]) => {
                let name = Spanned::new(name.node.clone(), name.span);
                self.no_thing(&name, "cam", "a cam", |k| k == ThingKind::Cam);
            }
            _ => self.wrong_argument(call, "a cam", expr.span),
        }
        None
    }

    /// Whether the first argument names a designed cam.
    pub(super) fn asks_cam(&self, args: &[Arg]) -> bool {
        args.first().is_some_and(|a| self.cam_of(&a.value).is_some())
    }

    /// `pressure_angle(plate, 30 deg)`, `curvature_radius(plate, 30 deg)`
    pub(super) fn of_cam(&mut self, call: Call<'_>, part: CamPart) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let plate = self.cam_argument(call, args[0])?;
        let Some(angle) = args.get(1) else {
            let written = format!("{}({})", call.name.node, plate.name);
            let help = match part {
                CamPart::Lift(_) => format!("write `{}.s` with a cam angle: `profile({}, 30 deg).s`", written, plate.name),
                _ => format!("write `{}({}, 30 deg)` or `max({written})`", call.name.node, plate.name),
            };
            let message = format!("{written} for every cam angle");
            self.error(RequestError::NoValue { path: message, span: call.span, help: Some(help) });
            return None;
        };
        let phi = self.scalar_constant(angle, &Want::ANGLE, "the cam angle")?;
        self.cam_value(&plate, part, phi, call)
    }

    fn cam_value(&mut self, plate: &PlateCam, part: CamPart, phi: f64, call: Call<'_>) -> Option<Typed> {
        self.with_speed(plate, part, call)?;
        let value = part.value(plate, phi, &plate.cam.at(phi));
        let ty = part.ty(plate.cam.follower.oscillates());
        let t = Typed::new(ModelExpr::Constant(value), ty);
        if value.is_defined() {
            return Some(t);
        }
        let why = "the pitch curve is straight there";
        self.error(UnitsError::NoValue { why, span: call.span });
        None
    }

    fn with_speed(&mut self, plate: &PlateCam, part: CamPart, call: Call<'_>) -> Option<()> {
        if !matches!(part, CamPart::Rate(_)) || plate.speed.is_some() {
            return Some(());
        }
        let help = format!("add `speed 80 rpm` to the braces of cam `{}`; `.s'`, `.s''` are per radian", plate.name);
        let path = "a rate by time of a cam without a speed".to_owned();
        self.error(RequestError::NoValue { path, span: call.span, help: Some(help) });
        None
    }

    /// `profile(plate, 30 deg).pitch`
    pub(super) fn profile_part(&mut self, call: Call<'_>, part: &Name) -> Option<Typed> {
        let which = self.part_named(part)?;
        self.of_cam(call, which)
    }

    fn part_named(&mut self, part: &Name) -> Option<CamPart> {
        if let Some((_, which)) = PARTS.iter().find(|(name, _)| *name == part.node) {
            return Some(*which);
        }
        let help = Some(part_list());
        self.error(RequestError::Part { part: part.node.clone(), span: part.span, help });
        None
    }

    /// `profile(plate, 30 deg)` without one of its parts.
    pub(super) fn profile_alone(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        self.cam_argument(call, args[0])?;
        let path = format!("{}(…)", call.name.node);
        let help = Some(format!("ask for a part, as `profile(plate, 30 deg).point`; {}", part_list()));
        self.error(RequestError::NoValue { path, span: call.span, help });
        None
    }

    /// `start(plate)`: where the follower stands at lift zero.
    pub(super) fn cam_start(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let plate = self.cam_argument(call, args[0])?;
        let ty = if plate.cam.follower.oscillates() { Dimension::ANGLE } else { Dimension::LENGTH };
        Some(Typed::constant(plate.cam.start(), ty))
    }

    /// `smallest_base_radius(plate, 30 deg)`
    pub(super) fn smallest_base_radius(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let plate = self.cam_argument(call, args[0])?;
        let allowed = self.scalar_constant(args[1], &Want::ANGLE, "the allowed pressure angle")?;
        if allowed <= 0.0 || allowed >= TAU / 4.0 {
            self.wrong_argument(call, "an angle between 0 and 90 deg", args[1].span);
            return None;
        }
        if let Some(radius) = plate.cam.smallest_base_radius(allowed) {
            return Some(Typed::constant(radius, Dimension::LENGTH));
        }
        let why = "on no base circle the pressure angle is that small, or it does not hang on the base circle";
        self.error(UnitsError::NoValue { why, span: call.span });
        None
    }

    /// `max(pressure_angle(plate))`, `min(profile(plate).s'')`, `argmax(…)`; `None` where the argument asks no cam.
    pub(super) fn over_cam(&mut self, call: Call<'_>) -> Option<Option<Typed>> {
        let [Arg { name: None, value }] = call.args else { return None };
        let (inner, part) = match &value.kind {
            ExprKind::Member(base, part) => (base.as_ref(), Some(part)),
            _ => (value, None),
        };
        let ExprKind::Call { function, args } = &inner.kind else { return None };
        let [argument] = args.as_slice() else { return None };
        let cam = self.cam_of(&argument.value)?;
        let which = match (function.node.as_str(), part) {
            ("pressure_angle", None) => CamPart::PressureAngle,
            ("curvature_radius", None) => CamPart::CurvatureRadius,
            ("profile", Some(part)) => match self.part_named(part) {
                Some(which) => which,
                None => return Some(None),
            },
            _ => return None,
        };
        Some(cam.and_then(|plate| self.cam_extreme(call, &plate, which)))
    }

    fn cam_extreme(&mut self, call: Call<'_>, plate: &PlateCam, part: CamPart) -> Option<Typed> {
        let (quantity, factor) = match part {
            CamPart::Lift(n) => (Quantity::Lift(n), 1.0),
            CamPart::Rate(n) => (Quantity::Lift(n), rate(plate, n)),
            CamPart::PressureAngle => (Quantity::PressureAngle, 1.0),
            CamPart::CurvatureRadius => (Quantity::CurvatureRadius, 1.0),
            CamPart::Pitch | CamPart::Point => {
                self.wrong_argument(call, "a number", call.span);
                return None;
            }
        };
        self.with_speed(plate, part, call)?;
        let (phi, value) = plate.cam.extreme(quantity, call.name.node != "min");
        let ty = part.ty(plate.cam.follower.oscillates());
        if call.name.node == "argmax" {
            return Some(Typed::constant(phi, Dimension::ANGLE));
        }
        let value = value * factor;
        if value.is_finite() {
            return Some(Typed::new(ModelExpr::number(value), ty));
        }
        let why = "the curve is straight or hollow somewhere: there is no greatest radius";
        self.error(UnitsError::NoValue { why, span: call.span });
        None
    }

    /// `profile(plate) in 72 steps`; `None` where the item asks no table of a cam.
    pub(in crate::check) fn cam_table(&mut self, item: &FindItem) -> Option<Option<FindKind>> {
        let ExprKind::Call { function, args } = &item.value.kind else { return None };
        let [argument] = args.as_slice() else { return None };
        let parts: &[(&str, CamPart)] = match function.node.as_str() {
            "profile" => &PARTS,
            "pressure_angle" => &PARTS[9..10],
            "curvature_radius" => &PARTS[10..],
            _ => return None,
        };
        let plate = self.cam_of(&argument.value)?;
        if item.name.is_some() {
            return None;
        }
        Some(plate.and_then(|plate| self.table_of(&plate, parts, item)))
    }

    fn table_of(&mut self, plate: &PlateCam, parts: &[(&str, CamPart)], item: &FindItem) -> Option<FindKind> {
        let steps = match &item.steps {
            None => STEPS,
            Some(expr) => {
                let steps = self.scalar_constant(expr, &Want::NUMBER, "the number of steps")?;
                if steps.fract() != 0.0 || !(1.0..=MOST_STEPS as f64).contains(&steps) {
                    let value = crate::check::amount::digits(steps);
                    self.error(MotionError::Steps { value, most: MOST_STEPS, span: expr.span });
                    return None;
                }
                steps as usize
            }
        };
        if let Some(unit) = &item.unit {
            let help = Some("leave out `as …`: each column has a unit of its own".to_owned());
            self.error(RequestError::NoValue { path: "a table".into(), span: unit.span, help });
            return None;
        }
        let angles: Vec<f64> = (0..steps).map(|i| TAU * i as f64 / steps as f64).collect();
        let points: Vec<CamPoint> = angles.iter().map(|phi| plate.cam.at(*phi)).collect();
        let mut table = Table::default();
        let mut entry = |cx: &Self, name: String, dimension: Dimension, values: Vec<f64>| {
            table.entries.push(TableEntry { name, display: cx.display(dimension), values });
        };
        entry(self, "cam angle".into(), Dimension::ANGLE, angles.clone());
        for &(name, part) in parts {
            if matches!(part, CamPart::Rate(_)) && plate.speed.is_none() {
                continue;
            }
            let values: Vec<Value> =
                angles.iter().zip(&points).map(|(phi, at)| part.value(plate, *phi, at)).collect();
            let ty = part.ty(plate.cam.follower.oscillates());
            let component = |pick: fn(Vec2) -> f64| {
                values.iter().map(|v| if let Value::Vector(v) = v { pick(*v) } else { f64::NAN }).collect()
            };
            match ty {
                Type::Vector(_) => {
                    entry(self, format!("{name}.x"), ty.dimension(), component(|v| v.x));
                    entry(self, format!("{name}.y"), ty.dimension(), component(|v| v.y));
                }
                _ => {
                    let numbers = values.iter().map(|v| if let Value::Scalar(x) = v { *x } else { f64::NAN });
                    entry(self, name.to_owned(), ty.dimension(), numbers.collect());
                }
            }
        }
        Some(FindKind::Table(table))
    }
}
