//! Masses that stand for a link's mass, and parts of results in general.

use super::gear::GearRate;
use crate::expr::{
    context::Context,
    read::no_part,
    results::{Call, Sign},
};
use crate::requests::query::not_a_quantity;
use crate::values::typed::{Type, Typed};
use assur_model::model::{Expr as ModelExpr, Query, SubstitutionPart};
use assur_syntax::document::{Expr, ExprKind, Name};
use assur_text::language::Function;
use assur_text::source::Spanned;
use assur_text::units::Dimension;

const PARTS: [(&str, SubstitutionPart, Type); 8] = [
    ("m1", SubstitutionPart::M1, Type::number(Dimension::MASS)),
    ("m2", SubstitutionPart::M2, Type::number(Dimension::MASS)),
    ("P2", SubstitutionPart::P2, Type::vector(Dimension::LENGTH)),
    ("l2", SubstitutionPart::L2, Type::number(Dimension::LENGTH)),
    ("a2", SubstitutionPart::A2, Type::vector(Dimension::ACCELERATION)),
    ("F1", SubstitutionPart::F1, Type::vector(Dimension::FORCE)),
    ("F2", SubstitutionPart::F2, Type::vector(Dimension::FORCE)),
    ("dJ", SubstitutionPart::DJ, Type::number(Dimension::INERTIA)),
];

fn part_list() -> String {
    let all = PARTS.iter().map(|(name, ..)| format!("`.{name}`")).collect::<Vec<_>>();
    format!("its parts are {}", all.join(", "))
}

impl Context<'_> {
    /// A part of a result that has named parts; `None` where the base is something else.
    pub(crate) fn part_of_result(&mut self, whole: &Expr, base: &Expr, part: &Name) -> Option<Option<Typed>> {
        match &base.kind {
            ExprKind::Call { function, args } => {
                let call = Call { name: function, args, span: base.span, sign: Sign::Matters };
                match Function::named(&function.node)? {
                    Function::StaticSubstitution => Some(self.substitution(call, 2, part)),
                    Function::DynamicSubstitution => Some(self.substitution(call, 1, part)),
                    Function::Profile => Some(self.profile_part(call, part)),
                    Function::Table => Some(self.gear_part(call, part)),
                    Function::ToothForce => Some(self.gear_rate(call, GearRate::ToothForce, part)),
                    Function::SlidingVelocity => Some(self.gear_rate(call, GearRate::SlidingVelocity, part)),
                    Function::Internal if !self.is_curve(&function.node) => Some(self.internal(call, part)),
                    Function::Fourier if !self.is_curve(&function.node) => Some(self.fourier(call, part)),
                    Function::Rim => Some(self.rim(call, part)),
                    _ => None,
                }
            }
            // `crank.B` where a value is due.
            ExprKind::Name(name) if !self.names.quantities.contains_key(name) => {
                Some(self.path_as_value(whole, &Spanned::new(name.clone(), base.span), part))
            }
            _ => None,
        }
    }

    fn path_as_value(&mut self, whole: &Expr, head: &Name, tail: &Name) -> Option<Typed> {
        let path = format!("{}.{}", head.node, tail.node);
        self.names.note_thing(head);
        let Some(link) = self.find_link(&head.node) else {
            if self.find_link(&path).is_some() {
                let help = Some(format!("ask for one of its quantities: `angle({path})` or `omega({path})`"));
                self.error(not_a_quantity(&path, whole.span, help));
                return None;
            }
            return self.named(head);
        };
        self.names.note_inside(link, tail);
        if self.kind_inside(link, &tail.node) == Some("point") {
            let help =
                Some(format!("ask for one of its quantities: `position({path})` or `velocity({path})`"));
            self.error(not_a_quantity(&path, whole.span, help));
        } else if self.kind_inside(link, &tail.node).is_some() {
            self.error(not_a_quantity(&path, whole.span, None));
        } else {
            self.point(link, tail);
        }
        None
    }

    /// The masses at so many points that are named.
    fn substitution(&mut self, call: Call<'_>, count: usize, part: &Name) -> Option<Typed> {
        let args = self.arguments(call, count + 1, count + 1)?;
        let link = self.link_argument(call, args[0])?;
        let mut points = Vec::new();
        for arg in &args[1..] {
            let ExprKind::Name(name) = &arg.kind else {
                self.wrong_argument(call, "a point of that link", arg.span);
                return None;
            };
            points.push(self.point(link, &Spanned::new(name.clone(), arg.span)));
        }
        self.with_mass(call, link)?;
        let Some((_, which, ty)) = PARTS.iter().find(|(name, ..)| *name == part.node) else {
            self.error(no_part(&part.node, part.span, Some(part_list())));
            return None;
        };
        let query = match points[..] {
            [Some(a), Some(b)] => Query::StaticSubstitution(link, a, b, *which),
            [Some(a)] => Query::DynamicSubstitution(link, a, *which),
            _ => return None,
        };
        Some(Typed::new(ModelExpr::Query(query), *ty))
    }

    /// A substitution without one of its parts.
    pub(crate) fn substitution_alone(&mut self, call: Call<'_>) -> Option<Typed> {
        let path = format!("{}(…)", call.name.node);
        self.error(not_a_quantity(&path, call.span, Some(part_list())));
        None
    }
}
