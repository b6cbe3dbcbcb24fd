//! `find`: what is asked.

use crate::expr::context::Context;
use crate::expr::fit::unit_mismatch;
use crate::expr::positive::Want;
use crate::requests::{all_motion, all_powers, bars};
use crate::statements::walk;
use crate::values::definition::Settled;
use crate::values::typed::{Type, Typed, phrase};
use crate::values::unit_use::display_in;
use assur_model::model::{Display, Expr as ModelExpr, Find, FindKind};
use assur_syntax::document::{ExprKind, FindItem, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Collection;
use assur_text::source::Span;
use assur_text::units::{Dimension, Unit, lookup};
use indexmap::IndexMap;

/// Enters all that is asked into the mechanism.
pub(crate) fn finds(cx: &mut Context<'_>) {
    let mut asked: IndexMap<String, Span> = IndexMap::new();
    for statement in &cx.doc.statements {
        let Statement::Find(find) = &statement.node else { continue };
        for item in &find.items {
            let name = item.name.as_ref().map_or(&item.text, |n| &n.node);
            if let Some(&first) = asked.get(name) {
                if item.name.is_none() {
                    cx.error(
                        Diagnosis::warning(
                            "mech::request::asked_twice",
                            format!("`{name}` is asked for twice"),
                        )
                        .primary(item.span, "again here")
                        .label(first, "first asked here")
                        .help(format!("leave one of them out, or give it another name: `NAME = {name}`")),
                    );
                }
                continue;
            }
            asked.insert(name.clone(), item.span);
            if let Some(all) = all_motion::asked(cx, item) {
                for found in all {
                    if !asked.contains_key(&found.name) {
                        asked.insert(found.name.clone(), found.span);
                        cx.builder.mech.finds.push(found);
                    }
                }
                continue;
            }
            if let Some(all) = bars::asked(cx, item) {
                for found in all {
                    if !asked.contains_key(&found.name) {
                        asked.insert(found.name.clone(), found.span);
                        cx.builder.mech.finds.push(found);
                    }
                }
                continue;
            }
            if let Some(all) = all_powers::asked(cx, item) {
                let first = cx.builder.mech.finds.len();
                cx.builder.mech.finds.extend(all);
                cx.builder.mech.powers = Some((first, cx.builder.mech.finds.len()));
                continue;
            }
            if let Some(kind) = asked_for(cx, item) {
                cx.builder.mech.finds.push(Find { name: name.clone(), span: item.span, kind });
            }
        }
    }
}

fn asked_for(cx: &mut Context<'_>, item: &FindItem) -> Option<FindKind> {
    if collection(cx, item) == Some(Collection::REACTIONS) {
        return Some(FindKind::Reactions);
    }
    if let Some(table) = cx.gear_table(item) {
        return table;
    }
    if let Some(table) = cx.cam_table(item) {
        return table;
    }
    if let Some(table) = cx.fourier_table(item) {
        return table;
    }
    if let Some(table) = cx.internal_table(item) {
        return table;
    }
    let (expr, display) = match &item.name {
        // Read among the definitions already.
        Some(name) => match cx.values.definitions.settled(&name.node)? {
            Settled::Result(id, _) => {
                let quantity = &cx.builder.mech.quantities[id.index()];
                if quantity.span != name.span {
                    return None;
                }
                (ModelExpr::Quantity(*id), quantity.display.clone())
            }
            _ => return None,
        },
        None => {
            let (t, display) = cx.read_item(item)?;
            if t.pending {
                return None;
            }
            (t.expr, display)
        }
    };
    let poseless = cx.values.definitions.is_poseless(&expr);
    Some(FindKind::Value { expr, display, poseless })
}

/// The word of `find reactions`, `find positions` and the like; none for a name of the file.
pub(crate) fn collection(cx: &Context<'_>, item: &FindItem) -> Option<Collection> {
    let ExprKind::Name(name) = &item.value.kind else { return None };
    let own = item.name.is_some() || cx.names.quantities.contains_key(name);
    Collection::named(name).filter(|_| !own)
}

impl Context<'_> {
    /// An item of `find`, and how it is printed.
    pub(crate) fn read_item(&mut self, item: &FindItem) -> Option<(Typed, Display)> {
        let read = self.read(&item.value);
        if let Some(steps) = &item.steps {
            self.scalar_constant(steps, &Want::NUMBER, "the number of steps");
            self.builder.unsupported("a table with this number of steps", item.span);
        }
        let unit = match &item.unit {
            Some(word) => Some(self.unit(word)?),
            None => None,
        };
        let t = read?;
        let display = match unit {
            Some(unit) => {
                self.unit_fits(&unit, &t, item)?;
                display_in(&unit)
            }
            None => self.item_display(item, t.ty),
        };
        Some((t, display))
    }

    pub(crate) fn unit_fits(&mut self, unit: &Unit, t: &Typed, item: &FindItem) -> Option<()> {
        let fits = match t.ty {
            Type::Number(dim) | Type::Vector(dim) => {
                dim.unify(crate::values::typed::Dim::Of(unit.dimension)).is_some()
            }
            Type::Bool => false,
        };
        if fits {
            return Some(());
        }
        let span = item.unit.as_ref().map_or(item.span, |u| u.span);
        let (found, help) = match t.ty {
            Type::Bool => ("a condition".to_owned(), Some("leave out `as …`".to_owned())),
            ty if unit.dimension.fits(Dimension::FREQUENCY)
                && ty.dimension().fits(Dimension::ANGULAR_VELOCITY) =>
            {
                let help = format!("divide by a turn: `{} / 360 deg as {}`", item.text, unit.text);
                (phrase(ty.dimension()), Some(help))
            }
            ty => {
                let usual = self.values.usual_unit(ty.dimension());
                (phrase(ty.dimension()), (!usual.is_empty()).then(|| format!("write `{usual}`")))
            }
        };
        let (want, what) = (phrase(unit.dimension), format!("a quantity printed in {}", unit.text));
        self.error(unit_mismatch(&what, &want, &found, span, help));
        None
    }

    /// How an item without `as` is printed: in the unit of its `expect`, else in the one the file uses most.
    fn item_display(&self, item: &FindItem, ty: Type) -> Display {
        let name = item.name.as_ref().map_or(&item.text, |n| &n.node);
        self.expected_unit(name, ty).map_or_else(|| self.values.display(ty.dimension()), |u| display_in(&u))
    }

    /// The unit of the first number that the answer key gives for what is called so.
    fn expected_unit(&self, name: &str, ty: Type) -> Option<Unit> {
        let mut found = None;
        for expect in self.names.expected.get(name).into_iter().flatten() {
            for value in &expect.values {
                walk::parts(value, &mut |part| {
                    if let ExprKind::Number(number) = &part.kind
                        && let Some(word) = &number.unit
                        && let Ok(unit) = lookup(&word.node)
                        && unit.dimension.fits(ty.dimension())
                    {
                        found.get_or_insert(unit);
                    }
                });
            }
        }
        found
    }

    /// How an expected value is printed.
    pub(crate) fn expect_display(&self, text: &str, ty: Type) -> Display {
        let found = self.builder.mech.finds.iter().find(|f| f.name == text).and_then(|f| match &f.kind {
            FindKind::Value { display, .. } => Some(display.clone()),
            FindKind::Reactions | FindKind::Table(_) => None,
        });
        let expected = || self.expected_unit(text, ty).map(|u| display_in(&u));
        found.or_else(expected).unwrap_or_else(|| self.values.display(ty.dimension()))
    }
}
