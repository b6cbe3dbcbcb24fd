//! Arguments that name machine elements.

use super::Call;
use crate::context::Context;
use crate::names::ThingKind;
use crate::source::Spanned;
use crate::syntax::document::ExprKind;

impl Context<'_> {
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
        let kind = if wanted == "a slider" { "slider" } else { "wheel" };
        self.no_thing(&name, kind, wanted, fits);
        None
    }
}
