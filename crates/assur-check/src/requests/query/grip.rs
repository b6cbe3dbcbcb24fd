//! What friction alone transmits: pulls of belts, capacities of belts and clutches.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::loads::slipping;
use crate::names::declared::QuantityKind;
use crate::requests::query::args::path;
use crate::values::typed::{Type, Typed};
use assur_model::model::{Expr, FrictionLimit, PairId, PairKind, Query, TransmissionKind};
use assur_text::language::Function;
use assur_text::units::Dimension;

impl Context<'_> {
    /// A function of a belt or a clutch.
    pub(super) fn by_grip(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        match function {
            Function::TightSide => self.belt_pull(call, Query::TightSide),
            Function::SlackSide => self.belt_pull(call, Query::SlackSide),
            Function::Wrap => self.wrap(call),
            Function::Capacity => self.capacity(call),
            _ => self.slips(call),
        }
    }

    /// `tight_side(b)`, `slack_side(b)`
    fn belt_pull(&mut self, call: Call<'_>, query: fn(PairId) -> Query) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let (pair, kind) = self.transmission(call, args[0])?;
        match self.grip(pair) {
            Some(FrictionLimit::Belt { .. }) => {
                Some(Typed::new(Expr::Query(query(pair)), Type::number(Dimension::FORCE)))
            }
            Some(FrictionLimit::Clutch(_)) | None => {
                self.no_grip(call, pair, kind);
                None
            }
        }
    }

    /// `wrap(b)`
    fn wrap(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let (pair, kind) = self.transmission(call, args[0])?;
        let Some(FrictionLimit::Belt { wrap, .. }) = self.grip(pair) else {
            self.no_grip(call, pair, kind);
            return None;
        };
        Some(Typed::new(Expr::number(wrap), Type::number(Dimension::ANGLE)))
    }

    /// `capacity(k)`
    fn capacity(&mut self, call: Call<'_>) -> Option<Typed> {
        let (pair, dimension) = self.gripping(call)?;
        let varying = slipping::capacity(self, pair);
        Some(Typed::new(varying.unwrap_or(Expr::Query(Query::Capacity(pair))), Type::number(dimension)))
    }

    /// `slips(k)`
    fn slips(&mut self, call: Call<'_>) -> Option<Typed> {
        let (pair, _) = self.gripping(call)?;
        Some(Typed::new(Expr::Query(Query::Slips(pair)), Type::Bool))
    }

    /// A clutch or a belt of which the capacity is known, with the dimension of it.
    fn gripping(&mut self, call: Call<'_>) -> Option<(PairId, Dimension)> {
        let args = self.arguments(call, 1, 1)?;
        if let Some([name]) = path(args[0]).as_deref()
            && let Some(QuantityKind::Brake(_)) = self.names.quantities.get(&name.node).map(|d| d.what)
        {
            let wanted = format!("a clutch or a belt (the torque of the brake is `{}`)", name.node);
            self.wrong_argument(call, &wanted, name.span);
            return None;
        }
        let (pair, kind) = self.transmission(call, args[0])?;
        match self.grip(pair) {
            Some(FrictionLimit::Clutch(_)) => Some((pair, Dimension::TORQUE)),
            Some(FrictionLimit::Belt { pretension: Some(_), .. }) => Some((pair, Dimension::FORCE)),
            Some(FrictionLimit::Belt { pretension: None, .. }) => {
                let help = "it depends on the pull at rest: add `pretension 400 N` to the belt";
                self.not_of_this_pair(call, pair, Some(help));
                None
            }
            None => {
                self.no_grip(call, pair, kind);
                None
            }
        }
    }

    fn no_grip(&mut self, call: Call<'_>, pair: PairId, kind: TransmissionKind) {
        let help = match kind {
            TransmissionKind::Belt => "add `friction 0.3; wrap 165 deg` to the belt",
            _ => "it is defined for belts and clutches",
        };
        self.not_of_this_pair(call, pair, Some(help));
    }

    fn grip(&self, pair: PairId) -> Option<FrictionLimit> {
        match &self.builder.mech.pair(pair).kind {
            PairKind::Transmission(t) => t.grip,
            _ => None,
        }
    }
}
