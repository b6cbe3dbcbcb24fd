//! Functions of a motion under loads: `time(top, 2)`, `count(top)`, `energy()`.

use crate::error::SimulateError;
use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::names::suggestion::suggestion;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_model::model::{BinaryOp, Expr, Query};
use assur_syntax::document::{ExprKind, Name, SpringSite, Statement};
use assur_text::language::Function;
use assur_text::source::{Span, Spanned};
use assur_text::units::Dimension;

impl Context<'_> {
    /// Reports functions of a motion under loads in another file, and those of a turn of the drive in such a file.
    pub(crate) fn is_of_a_motion(&mut self, call: Call<'_>, function: Function) -> Option<()> {
        use Function as F;
        let of_events = matches!(function, F::Time | F::Count);
        let of_drive = matches!(function, F::Travel | F::Stroke | F::TimeRatio | F::Dead | F::Critical);
        if of_events && !self.names.simulates {
            let help = "add `simulate 0 s .. 1 s` with a `start` for each free coordinate".to_owned();
            self.error(SimulateError::Missing { word: "event", help, span: call.span });
            return None;
        }
        if of_drive && self.names.simulates {
            let what = format!("`{}`, which is found over the positions of a drive,", call.name.node);
            let help = "take `max` or `min` of a coordinate over the motion, as in `max(displacement(G))`"
                .to_owned();
            self.error(SimulateError::NoMeaning { what, help, span: call.span });
            return None;
        }
        Some(())
    }

    /// The functions of a motion under loads.
    pub(crate) fn of_motion(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        match function {
            Function::Time => self.event_time(call),
            Function::Count => self.event_count(call),
            Function::KineticEnergy => self.energy(call, &[Query::KineticEnergy]),
            Function::PotentialEnergy => self.energy(call, &[Query::PotentialEnergy]),
            _ => self.energy(call, &[Query::KineticEnergy, Query::PotentialEnergy]),
        }
    }

    /// `time(top)`, `time(top, 2)`
    fn event_time(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let event = self.event_argument(call, args[0])?;
        let which = match args.get(1) {
            None => 1,
            Some(which) => self.count_argument(call, which)?,
        };
        let query = Expr::Query(Query::EventTime(event, which));
        Some(Typed::new(query, Type::number(Dimension::TIME)))
    }

    /// `count(top)`
    fn event_count(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let event = self.event_argument(call, args[0])?;
        Some(Typed::new(Expr::Query(Query::EventCount(event)), Type::number(Dimension::NUMBER)))
    }

    /// `kinetic_energy()`, `potential_energy()`, and their sum.
    fn energy(&mut self, call: Call<'_>, parts: &[Query]) -> Option<Typed> {
        self.arguments(call, 0, 0)?;
        let in_hinge =
            |s: &Statement| matches!(s, Statement::Spring(s) if matches!(s.site, SpringSite::Pair(_)));
        if parts.contains(&Query::PotentialEnergy) && self.doc.statements.iter().any(|s| in_hinge(&s.node)) {
            self.builder.unsupported("the potential energy of a spring in a hinge", call.span);
        }
        let mut parts = parts.iter().map(|query| Expr::Query(*query));
        let first = parts.next()?;
        let sum = parts.fold(first, |sum, part| fold::binary(BinaryOp::Add, sum, part));
        Some(Typed::new(sum, Type::number(Dimension::TORQUE)))
    }

    /// An event by its name. Reports what is none.
    pub(crate) fn event(&mut self, name: &Name) -> Option<usize> {
        if let Some(index) = self.names.events.get_index_of(&name.node) {
            return Some(index);
        }
        if self.names.bad.contains(&name.node) {
            return None;
        }
        let events = self.names.events.keys().map(String::as_str).collect::<Vec<_>>();
        let help = suggestion(&name.node, &events, "events")
            .unwrap_or_else(|| format!("declare it, as in `event {}: omega(crank) = 0 rad/s`", name.node));
        self.error(SimulateError::UnknownEvent { name: name.node.clone(), help, span: name.span });
        None
    }

    fn event_argument(&mut self, call: Call<'_>, arg: &assur_syntax::document::Expr) -> Option<usize> {
        match &arg.kind {
            ExprKind::Name(name) => self.event(&Spanned::new(name.clone(), arg.span)),
            _ => {
                self.no_event(call, arg.span);
                None
            }
        }
    }

    fn no_event(&mut self, call: Call<'_>, span: Span) {
        self.wrong_argument(call, "the name of an `event`, which says when it happens,", span);
    }

    /// A whole number from 1, as written.
    fn count_argument(&mut self, call: Call<'_>, arg: &assur_syntax::document::Expr) -> Option<usize> {
        if let ExprKind::Number(n) = &arg.kind
            && n.unit.is_none()
            && n.value.fract() == 0.0
            && (1.0..1e9).contains(&n.value)
        {
            #[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss)] // whole, below 1e9
            return Some(n.value as usize);
        }
        self.wrong_argument(call, "a whole number from 1: which time it happens,", arg.span);
        None
    }
}
