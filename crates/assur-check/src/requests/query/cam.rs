//! What is asked of a designed cam: a value at a cam angle, a greatest or least one over the turn, a table.

use crate::expr::{
    context::{Context, undefined},
    positive::Want,
    read::no_part,
    results::Call,
};
use crate::motion::drive::wrong_steps;
use crate::names::declared::ThingKind;
use crate::requests::query::{args::path, not_a_quantity};
use crate::values::typed::{Type, Typed};
use assur_math::element::cam::Quantity;
use assur_model::model::{CAM_PARTS, CamPart, CycleFunction, Expr as ModelExpr, FindKind, PlateCam};
use assur_syntax::document::{Arg, Expr, ExprKind, FindItem, Name};
use assur_text::language::Function;
use assur_text::source::Spanned;
use assur_text::units::Dimension;
use std::f64::consts::TAU;

/// Steps of a table where none are written.
const STEPS: usize = 36;
/// The most steps of a table.
const MOST_STEPS: usize = 36_000;

fn of_type(part: CamPart, plate: &PlateCam) -> Type {
    let dimension = part.dimension(plate.cam.follower.oscillates());
    if part.is_vector() { Type::vector(dimension) } else { Type::number(dimension) }
}

fn part_list() -> String {
    let all = CAM_PARTS.iter().map(|(name, _)| format!("`.{name}`")).collect::<Vec<_>>();
    format!("its parts are {}", all.join(", "))
}

impl Context<'_> {
    /// The designed cam an expression names; `None` where it names none, `Some(None)` where that one has an error.
    fn cam_of(&mut self, expr: &Expr) -> Option<Option<PlateCam>> {
        let names = path(expr)?;
        let [name] = names.as_slice() else { return None };
        self.names.note_thing(name);
        let is_cam = self.names.things.get(&name.node).is_some_and(|d| d.what == ThingKind::Cam);
        is_cam.then(|| self.builder.mech.cams.iter().find(|c| c.name == name.node).cloned())
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
    pub(crate) fn asks_cam(&mut self, args: &[Arg]) -> bool {
        args.first().is_some_and(|a| self.cam_of(&a.value).is_some())
    }

    /// `pressure_angle(plate, 30 deg)`, `curvature_radius(plate, 30 deg)`
    pub(crate) fn of_cam(&mut self, call: Call<'_>, part: CamPart) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let plate = self.cam_argument(call, args[0])?;
        let Some(angle) = args.get(1) else {
            let written = format!("{}({})", call.name.node, plate.name);
            let help = match part {
                CamPart::Lift(_) => {
                    format!("write `{}.s` with a cam angle: `profile({}, 30 deg).s`", written, plate.name)
                }
                _ => format!("write `{}({}, 30 deg)` or `max({written})`", call.name.node, plate.name),
            };
            let message = format!("{written} for every cam angle");
            self.error(not_a_quantity(&message, call.span, Some(help)));
            return None;
        };
        let phi = self.scalar_constant(angle, &Want::ANGLE, "the cam angle")?;
        self.cam_value(&plate, part, phi, call)
    }

    fn cam_value(&mut self, plate: &PlateCam, part: CamPart, phi: f64, call: Call<'_>) -> Option<Typed> {
        self.with_speed(plate, part, call)?;
        let value = part.value(plate, phi, &plate.cam.at(phi));
        let ty = of_type(part, plate);
        let t = Typed::new(ModelExpr::Constant(value), ty);
        if value.is_defined() {
            return Some(t);
        }
        let why = "the pitch curve is straight there";
        self.error(undefined(why, call.span, None));
        None
    }

    fn with_speed(&mut self, plate: &PlateCam, part: CamPart, call: Call<'_>) -> Option<()> {
        if !matches!(part, CamPart::Rate(_)) || plate.speed.is_some() {
            return Some(());
        }
        let help =
            format!("add `speed 80 rpm` to the braces of cam `{}`; `.s'`, `.s''` are per radian", plate.name);
        let path = "a rate by time of a cam without a speed".to_owned();
        self.error(not_a_quantity(&path, call.span, Some(help)));
        None
    }

    /// `profile(plate, 30 deg).pitch`
    pub(crate) fn profile_part(&mut self, call: Call<'_>, part: &Name) -> Option<Typed> {
        let which = self.part_named(part)?;
        self.of_cam(call, which)
    }

    fn part_named(&mut self, part: &Name) -> Option<CamPart> {
        if let Some((_, which)) = CAM_PARTS.iter().find(|(name, _)| *name == part.node) {
            return Some(*which);
        }
        let help = Some(part_list());
        self.error(no_part(&part.node, part.span, help));
        None
    }

    /// `profile(plate, 30 deg)` without one of its parts.
    pub(crate) fn profile_alone(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        self.cam_argument(call, args[0])?;
        let path = format!("{}(…)", call.name.node);
        let help = Some(format!("ask for a part, as `profile(plate, 30 deg).point`; {}", part_list()));
        self.error(not_a_quantity(&path, call.span, help));
        None
    }

    /// `start(plate)`: where the follower stands at lift zero.
    pub(crate) fn cam_start(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let plate = self.cam_argument(call, args[0])?;
        let ty = if plate.cam.follower.oscillates() { Dimension::ANGLE } else { Dimension::LENGTH };
        Some(Typed::constant(plate.cam.start(), ty))
    }

    /// `smallest_base_radius(plate, 30 deg)`
    pub(crate) fn smallest_base_radius(&mut self, call: Call<'_>) -> Option<Typed> {
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
        let why = "no base circle gives such a small pressure angle, or the angle does not depend on the \
                   base circle";
        self.error(undefined(why, call.span, None));
        None
    }

    /// `max(pressure_angle(plate))`, `min(profile(plate).s'')`, `argmax(…)`, `argmin(…)`; `None` where the argument asks no cam.
    pub(crate) fn over_cam(
        &mut self,
        call: Call<'_>,
        how: CycleFunction,
        least: bool,
    ) -> Option<Option<Typed>> {
        let [Arg { name: None, value }] = call.args else { return None };
        let (inner, part) = match &value.kind {
            ExprKind::Member(base, part) => (base.as_ref(), Some(part)),
            _ => (value, None),
        };
        let ExprKind::Call { function, args } = &inner.kind else { return None };
        let [argument] = args.as_slice() else { return None };
        let cam = self.cam_of(&argument.value)?;
        let which = match (Function::named(&function.node), part) {
            (Some(Function::PressureAngle), None) => CamPart::PressureAngle,
            (Some(Function::CurvatureRadius), None) => CamPart::CurvatureRadius,
            (Some(Function::Profile), Some(part)) => match self.part_named(part) {
                Some(which) => which,
                None => return Some(None),
            },
            _ => return None,
        };
        Some(cam.and_then(|plate| self.cam_extreme(call, (how, least), &plate, which)))
    }

    fn cam_extreme(
        &mut self,
        call: Call<'_>,
        (how, least): (CycleFunction, bool),
        plate: &PlateCam,
        part: CamPart,
    ) -> Option<Typed> {
        let (quantity, factor) = match part {
            CamPart::Lift(n) => (Quantity::Lift(n), 1.0),
            CamPart::Rate(n) => (Quantity::Lift(n), plate.rate(n)),
            CamPart::PressureAngle => (Quantity::PressureAngle, 1.0),
            CamPart::CurvatureRadius => (Quantity::CurvatureRadius, 1.0),
            CamPart::Pitch | CamPart::Point => {
                self.wrong_argument(call, "a number", call.span);
                return None;
            }
        };
        self.with_speed(plate, part, call)?;
        let (phi, value) = plate.cam.extreme(quantity, !least);
        let ty = of_type(part, plate);
        if how == CycleFunction::Argmax {
            return Some(Typed::constant(phi, Dimension::ANGLE));
        }
        let value = value * factor;
        if value.is_finite() {
            return Some(Typed::new(ModelExpr::number(value), ty));
        }
        let why = "the curve is straight or hollow somewhere: there is no greatest radius";
        self.error(undefined(why, call.span, None));
        None
    }

    /// `profile(plate) in 72 steps`; `None` where the item asks no table of a cam.
    pub(crate) fn cam_table(&mut self, item: &FindItem) -> Option<Option<FindKind>> {
        let ExprKind::Call { function, args } = &item.value.kind else { return None };
        let [argument] = args.as_slice() else { return None };
        let parts: &[(&str, CamPart)] = match Function::named(&function.node)? {
            Function::Profile => &CAM_PARTS,
            Function::PressureAngle => &CAM_PARTS[9..10],
            Function::CurvatureRadius => &CAM_PARTS[10..],
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
                    let value = crate::values::format_value::digits(steps);
                    self.error(wrong_steps(&value, MOST_STEPS, expr.span));
                    return None;
                }
                steps as usize
            }
        };
        if let Some(unit) = &item.unit {
            let help = Some("leave out `as …`: each column has a unit of its own".to_owned());
            self.error(not_a_quantity("a table", unit.span, help));
            return None;
        }
        Some(FindKind::Table(plate.table(parts, steps, |d| self.values.display(d))))
    }
}
