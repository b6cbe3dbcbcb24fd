//! Functions that are understood but cannot be solved yet: their arguments are checked and the call is noted.

use super::Call;
use crate::check::context::Context;
use crate::check::error::NameError;
use crate::check::expr::typed::{Dim, Type, Typed};
use crate::check::lookup::suggestion;
use crate::check::names::{QuantityKind, ThingKind};
use crate::source::Spanned;
use crate::syntax::document::{ExprKind, JointKind, Name};
use crate::units::Dimension;

const ANY: Type = Type::Number(Dim::Any);

impl Context<'_> {
    /// A function that cannot be solved yet.
    pub(super) fn not_yet(&mut self, call: Call<'_>) -> Option<Typed> {
        let (what, ty) = match call.name.node.as_str() {
            "max" | "min" | "mean" => ("functions over a sweep", self.one_value(call)?.ty),
            "integral" | "argmax" => {
                self.one_value(call)?;
                ("functions over a sweep", ANY)
            }
            "profile" | "curvature_radius" => {
                self.element(call, "a cam", |k| k == ThingKind::Cam)?;
                let length = call.name.node == "curvature_radius";
                ("cams", if length { Type::number(Dimension::LENGTH) } else { ANY })
            }
            "table" | "contact_ratio" => {
                self.element(call, "a mesh", |k| k == ThingKind::Joint(JointKind::Mesh))?;
                let ratio = call.name.node == "contact_ratio";
                ("gears", if ratio { Type::number(Dimension::NUMBER) } else { ANY })
            }
            _ => {
                self.flywheel(call)?;
                let work = call.name.node == "fluctuation";
                ("flywheels", if work { Type::number(Dimension::TORQUE) } else { ANY })
            }
        };
        self.unsupported(what, call.span);
        Some(Typed::pending(ty))
    }

    fn one_value(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        self.read(args[0])
    }

    /// An argument that names a machine element.
    pub(super) fn element(
        &mut self,
        call: Call<'_>,
        wanted: &str,
        fits: impl Fn(ThingKind) -> bool,
    ) -> Option<()> {
        let args = self.arguments(call, 1, 1)?;
        let ExprKind::Name(name) = &args[0].kind else {
            self.wrong_argument(call, wanted, args[0].span);
            return None;
        };
        let name = Spanned::new(name.clone(), args[0].span);
        if self.names.things.get(&name.node).is_some_and(|d| fits(d.what)) {
            return Some(());
        }
        let kind = match wanted {
            "a slider" => "slider",
            "a wheel" => "wheel",
            "a cam" => "cam",
            _ => "mesh",
        };
        self.no_thing(&name, kind, wanted, fits);
        None
    }

    fn flywheel(&mut self, call: Call<'_>) -> Option<()> {
        let args = self.arguments(call, 1, 1)?;
        let ExprKind::Name(name) = &args[0].kind else {
            self.wrong_argument(call, "a flywheel", args[0].span);
            return None;
        };
        let name = Spanned::new(name.clone(), args[0].span);
        match self.names.quantities.get(&name.node).map(|d| d.what) {
            Some(QuantityKind::Flywheel) => Some(()),
            Some(_) => {
                self.wrong_argument(call, "a flywheel", name.span);
                None
            }
            None => {
                self.no_flywheel(&name);
                None
            }
        }
    }

    fn no_flywheel(&mut self, name: &Name) {
        if self.names.bad.contains(&name.node) || !self.reported.insert(("flywheel", name.node.clone())) {
            return;
        }
        let all = self.names.quantities.iter().filter(|(_, d)| d.what == QuantityKind::Flywheel);
        let all = all.map(|(n, _)| n.as_str()).collect::<Vec<_>>();
        let help = suggestion(&name.node, &all, "flywheels");
        let (name, span) = (name.node.clone(), name.span);
        self.error(NameError::Unknown { kind: "flywheel", name, place: String::new(), span, help });
    }
}
