//! Arguments that name machine elements.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::names::declared::ThingKind;
use assur_syntax::document::ExprKind;
use assur_text::source::Spanned;

impl Context<'_> {
    /// An argument that names a machine element.
    pub(crate) fn element(
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
        self.names.note_thing(&name);
        if self.names.things.get(&name.node).is_some_and(|d| fits(d.what)) {
            return Some(());
        }
        let kind = if wanted == "a slider" { "slider" } else { "wheel" };
        self.no_thing(&name, kind, wanted, fits);
        None
    }
}
