//! Functions over the sweep: `mean(Mb)`, `max(mag(reaction(B)))`.

use crate::expr::context::Context;
use crate::expr::results::Call;
use crate::values::fold;
use crate::values::typed::{Dim, Type, Typed};
use assur_model::model::{Cycle, CycleFunction, Expr, Part, Query};
use assur_text::units::Dimension;

impl Context<'_> {
    /// `max`, `min`, `mean`, `integral`, `argmax` of one number, or of its opposite: where a number is least its opposite is greatest.
    pub(crate) fn over_sweep(&mut self, call: Call<'_>, how: CycleFunction, opposite: bool) -> Option<Typed> {
        let (value, part) = self.value_and_part(call)?;
        let t = self.read(value)?;
        let Type::Number(dim) = t.ty else {
            let help = matches!(t.ty, Type::Vector(_)).then(|| "write `mag(…)`, `.x` or `.y`".to_owned());
            let what = format!("the argument of `{}`", call.name.node);
            self.shape(&what, "a number", t.ty, value.span, help);
            return None;
        };
        let dimension = match dim {
            Dim::Of(Dimension { length, mass, time, .. }) => [length, mass, time],
            Dim::Any => [0; 3],
        };
        let dim = match how {
            CycleFunction::Max | CycleFunction::Min | CycleFunction::Mean => dim,
            CycleFunction::Integral => dim.times(Dim::Of(self.over(call)?)),
            CycleFunction::Argmax => Dim::Of(self.over(call)?),
            CycleFunction::Harmonic(_) => {
                self.over(call)?;
                dim
            }
        };
        let ty = Type::Number(dim);
        if t.pending {
            return Some(Typed::pending(ty));
        }
        let expr = if opposite { fold::negate(t.expr) } else { t.expr };
        Some(Typed::new(self.cycle((how, dimension), expr, (call, part)), ty))
    }

    /// The dimension of what it is taken over: the drive, or the time of a motion under loads.
    fn over(&mut self, call: Call<'_>) -> Option<Dimension> {
        if self.names.simulates { Some(Dimension::TIME) } else { self.only_drive(call) }
    }

    /// A function over the sweep; the same one is kept once.
    pub(super) fn cycle(
        &mut self,
        (how, dimension): (CycleFunction, [i8; 3]),
        expr: Expr,
        (call, part): (Call<'_>, Part),
    ) -> Expr {
        let known =
            self.builder.mech.cycles.iter().position(|c| c.how == how && c.expr == expr && c.part == part);
        Expr::Query(Query::Cycle(known.unwrap_or_else(|| {
            self.builder.mech.cycles.push(Cycle { span: call.span, how, expr, dimension, part });
            self.builder.mech.cycles.len() - 1
        })))
    }

    /// `frictionless(mean(Mb))` is `mean(frictionless(Mb))`: what is found over the sweep is not found anew at a pose.
    pub(crate) fn frictionless_over_sweep(&mut self, expr: &Expr, call: Call<'_>) -> Expr {
        let mut found = Vec::new();
        expr.queries(&mut |q| {
            if let Query::Cycle(index) = q {
                found.push(*index);
            }
        });
        let mut inside = Vec::new();
        for index in found {
            let Some(cycle) = self.builder.mech.cycles.get(index).cloned() else { continue };
            let ideal = Expr::Frictionless(Box::new(cycle.expr));
            inside.push((index, self.cycle((cycle.how, cycle.dimension), ideal, (call, cycle.part))));
        }
        expr.map_leaves(&mut |leaf| match leaf {
            Expr::Query(Query::Cycle(index)) => {
                inside.iter().find(|(i, _)| i == index).map_or_else(|| leaf.clone(), |(_, e)| e.clone())
            }
            _ => leaf.clone(),
        })
    }
}
