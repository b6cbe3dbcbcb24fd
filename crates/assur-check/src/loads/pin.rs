//! Pins that loads act on.

use super::load::form;
use crate::expr::context::Context;
use crate::links::lookup::kind_phrase;
use assur_math::math::Vec2;
use assur_model::model::{self, LinkId, PairId, PairKind};
use assur_syntax::document::{LoadKind, Name};

/// The pin of a revolute pair: it is fixed to the first link, and the others turn on it.
#[derive(Clone, Copy)]
pub(crate) struct LoadedPin {
    pub(crate) pair: PairId,
    pub(crate) on: LinkId,
    /// Its place on that link, m.
    pub(crate) at: Vec2,
}

impl LoadedPin {
    /// The pin of that name under a load of this kind.
    pub(crate) fn of(cx: &mut Context<'_>, name: &Name, kind: LoadKind) -> Option<Self> {
        let bearer = cx.bearers_as_declared(&name.node).next();
        if cx.find_pair(&name.node).is_none()
            && let Some((link, _)) = bearer
        {
            let link = cx.builder.mech.link(link).name.clone();
            let message = format!("no pair is named `{}`: a load `at` a name acts on a pin", name.node);
            form(cx, message, &format!("a point of a link: write `on {link} at {}`", name.node), name.span);
            return None;
        }
        if cx.find_pair(&name.node).is_none() && cx.find_link(&name.node).is_some() {
            let message = format!("`{}` is a link: a load `at` a name acts on a pin", name.node);
            let example = if kind == LoadKind::Torque { String::new() } else { " at B".to_owned() };
            form(cx, message, &format!("write `on {}{example}`", name.node), name.span);
            return None;
        }
        let pair = cx.pair(name)?;
        let declared = cx.builder.mech.pair(pair);
        let PairKind::Revolute(pins) = &declared.kind else {
            let message = format!("`{}` is {}, and no pin", name.node, kind_phrase(&declared.kind));
            form(cx, message, "name a revolute pair, or a link and its point: `on rod at C`", name.span);
            return None;
        };
        let (on, at) = pins.first().map(|pin| (pin.link, pin.at))?;
        let loaded = Self { pair, on, at };
        if kind == LoadKind::Torque {
            let moving = loaded.moving(cx).map(|pin| cx.builder.mech.link(pin.link).name.as_str());
            let help = format!("write the link: `on {}`", moving.unwrap_or("crank"));
            form(cx, "a pin takes no torque".to_owned(), &help, name.span);
            return None;
        }
        Some(loaded)
    }

    /// The first link on the pin that moves.
    fn moving<'c>(&self, cx: &'c Context<'_>) -> Option<&'c model::Pin> {
        let PairKind::Revolute(pins) = &cx.builder.mech.pair(self.pair).kind else { return None };
        pins.iter().find(|pin| pin.link != LinkId::GROUND)
    }

    /// Reports what has no meaning at a pin of the ground, which does not move.
    pub(crate) fn moves(self, cx: &mut Context<'_>, name: &Name, what: &str) -> Option<Self> {
        if self.on != LinkId::GROUND {
            return Some(self);
        }
        let example = self.moving(cx).map_or_else(
            || "on crank at B".to_owned(),
            |pin| format!("on {} at {}", cx.builder.mech.link(pin.link).name, pin.name),
        );
        let message = format!("the pin `{}` is fixed to the ground, so {what}", name.node);
        form(cx, message, &format!("write the link on which it acts: `{example}`"), name.span);
        None
    }
}
