//! Functions that are understood but cannot be solved yet: their arguments are checked and the call is noted.

use super::Call;
use crate::check::context::Context;
use crate::check::expr::typed::{Type, Typed};
use crate::check::names::ThingKind;
use crate::source::Spanned;
use crate::syntax::document::ExprKind;
use crate::units::Dimension;

impl Context<'_> {
    /// A function that cannot be solved yet.
    pub(super) fn not_yet(&mut self, call: Call<'_>) -> Option<Typed> {
        let (what, ty) = match call.name.node.as_str() {
            "speed" => {
                self.element(call, "a slider", |k| matches!(k, ThingKind::Slider))?;
                ("sliders on ropes", Type::number(Dimension::VELOCITY))
            }
            _ => {
                self.element(call, "a wheel", |k| k == ThingKind::Wheel)?;
                ("wheels", Type::number(Dimension::LENGTH))
            }
        };
        self.unsupported(what, call.span);
        Some(Typed::pending(ty))
    }

    /// An argument that names a machine element.
    fn element(&mut self, call: Call<'_>, wanted: &str, fits: impl Fn(ThingKind) -> bool) -> Option<()> {
        let args = self.arguments(call, 1, 1)?;
        let ExprKind::Name(name) = &args[0].kind else {
            self.wrong_argument(call, wanted, args[0].span);
            return None;
        };
        let name = Spanned::new(name.clone(), args[0].span);
        if self.names.things.get(&name.node).is_some_and(|d| fits(d.what)) {
            return Some(());
        }
        let kind = if wanted == "a slider" { "slider" } else { "wheel" };
        self.no_thing(&name, kind, wanted, fits);
        None
    }
}
