//! What is asked of a flywheel: `fluctuation(J)`, `rim(J).width`.

use crate::expr::context::Context;
use crate::expr::read::no_part;
use crate::expr::results::Call;
use crate::motion::simulation::may_be_missing;
use crate::names::declared::QuantityKind;
use crate::names::suggestion::{not_declared, suggestion};
use crate::requests::query::not_a_quantity;
use crate::values::typed::{Type, Typed};
use assur_model::model::{Expr, FlywheelPart, Query};
use assur_syntax::document::{ExprKind, Name, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::source::Spanned;
use assur_text::units::Dimension;

impl Context<'_> {
    /// `fluctuation`, `work`, `reduced_torque`, `reduced_inertia`
    pub(crate) fn of_flywheel(
        &mut self,
        call: Call<'_>,
        part: FlywheelPart,
        dimension: Dimension,
    ) -> Option<Typed> {
        let index = self.flywheel(call)?;
        Some(Typed::new(Expr::Query(Query::Flywheel(index, part)), Type::number(dimension)))
    }

    /// `rim(J)` without one of its parts.
    pub(super) fn rim_alone(&mut self, call: Call<'_>) -> Option<Typed> {
        self.flywheel(call)?;
        let help = Some("ask for `rim(J).width`, `rim(J).height` or `rim(J).mass`".to_owned());
        self.error(not_a_quantity("rim(…)", call.span, help));
        None
    }

    /// `rim(J).width`
    pub(crate) fn rim(&mut self, call: Call<'_>, part: &Name) -> Option<Typed> {
        let index = self.flywheel(call)?;
        let (what, dimension) = match part.node.as_str() {
            "width" => (FlywheelPart::RimWidth, Dimension::LENGTH),
            "height" => (FlywheelPart::RimHeight, Dimension::LENGTH),
            "mass" => (FlywheelPart::RimMass, Dimension::MASS),
            _ => {
                let help = Some("its parts are `.width`, `.height`, `.mass`".to_owned());
                self.error(no_part(&part.node, part.span, help));
                return None;
            }
        };
        let described = self.doc.statements.iter().filter_map(|s| match &s.node {
            Statement::Flywheel(f) => Some(f.properties.iter().any(|p| p.name.node == "rim")),
            _ => None,
        });
        if described.into_iter().nth(index) == Some(false) {
            self.error(
                Diagnosis::error("mech::geometry::incomplete", "the flywheel has no rim")
                    .label(call.span, "its rim is not described")
                    .help(
                        "add `rim { diameter 0.5 m; weight_density 7.0e4 N/m^3; \
                         height_to_width 1.5 }` to its braces",
                    ),
            );
            return None;
        }
        Some(Typed::new(Expr::Query(Query::Flywheel(index, what)), Type::number(dimension)))
    }

    /// The one argument, that names a flywheel.
    fn flywheel(&mut self, call: Call<'_>) -> Option<usize> {
        let args = self.arguments(call, 1, 1)?;
        let ExprKind::Name(name) = &args[0].kind else {
            self.wrong_argument(call, "a flywheel", args[0].span);
            return None;
        };
        let name = Spanned::new(name.clone(), args[0].span);
        self.names.note_quantity(&name);
        match self.names.quantities.get(&name.node).map(|d| d.what) {
            Some(QuantityKind::Flywheel(index)) => Some(index),
            Some(QuantityKind::Balance(..)) if call.name.node == "work" => {
                self.work_of_balance(&name);
                None
            }
            // of the motion that could not be read
            Some(_) if call.name.node == "work" && !may_be_missing(self) => None,
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
        if self.names.bad.contains(&name.node)
            || !self.problems.reported.insert(("flywheel", name.node.clone()))
        {
            return;
        }
        let all = self.names.quantities.iter().filter(|(_, d)| matches!(d.what, QuantityKind::Flywheel(_)));
        let all = all.map(|(n, _)| n.as_str()).collect::<Vec<_>>();
        let help = suggestion(&name.node, name.span, &all, "flywheels");
        let (name, span) = (name.node.clone(), name.span);
        self.error(not_declared("flywheel", &name, None, span, help));
    }
}
