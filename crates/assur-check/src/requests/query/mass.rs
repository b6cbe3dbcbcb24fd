//! Masses of links: they are numbers, and their centres are points of the links.

use crate::expr::context::Context;
use crate::expr::results::{Call, Sign};
use crate::names::declared::ThingKind;
use crate::values::fold;
use crate::values::typed::{Type, Typed};
use assur_math::math::Vec2;
use assur_model::model::{
    BinaryOp, Expr as ModelExpr, LinkId, MassProperties, Mechanism, PairKind, PointRef, Query,
};
use assur_syntax::document::{Arg, Expr, ExprKind};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Function;
use assur_text::source::Spanned;
use assur_text::units::Dimension;

impl Context<'_> {
    /// A function of the masses of links.
    pub(super) fn of_masses(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        match function {
            Function::Mass => self.mass_of(call),
            Function::MassCentre => self.mass_centre_of(call),
            _ => self.moment_of_inertia(call),
        }
    }

    /// `mass(L)`, `mass()`
    fn mass_of(&mut self, call: Call<'_>) -> Option<Typed> {
        let mass = self.heavy(call)?.iter().map(|(_, m)| m.mass).sum();
        Some(Typed::constant(mass, Dimension::MASS))
    }

    /// `mass_centre(L)`, `mass_centre()`
    fn mass_centre_of(&mut self, call: Call<'_>) -> Option<Typed> {
        self.of_mass_centre(call, Query::Position, Dimension::LENGTH)
    }

    /// A quantity of the mass centre of a link or of all: Σ m_i x_i / m.
    fn of_mass_centre(
        &mut self,
        call: Call<'_>,
        query: fn(PointRef) -> Query,
        dimension: Dimension,
    ) -> Option<Typed> {
        let mut heavy = self.heavy(call)?;
        heavy.retain(|(_, m)| m.mass > 0.0);
        self.in_the_plane(call, &heavy)?;
        let of =
            |(link, m): &(LinkId, MassProperties)| ModelExpr::Query(query(PointRef::Fixed(*link, m.centre)));
        let expr = match &heavy[..] {
            [] => {
                self.without_any_mass(call);
                return None;
            }
            [one] => of(one),
            [first, others @ ..] => {
                let part = |one: &(LinkId, MassProperties)| {
                    fold::binary(BinaryOp::Mul, ModelExpr::number(one.1.mass), of(one))
                };
                let add = |sum, one| fold::binary(BinaryOp::Add, sum, part(one));
                let sum = others.iter().fold(part(first), add);
                let mass = heavy.iter().map(|(_, m)| m.mass).sum();
                fold::binary(BinaryOp::Div, sum, ModelExpr::number(mass))
            }
        };
        Some(Typed::new(expr, Type::vector(dimension)))
    }

    /// `velocity(mass_centre(L))`: `None` where the argument is something else.
    pub(super) fn moved_mass_centre(
        &mut self,
        of: &[Arg],
        query: fn(PointRef) -> Query,
        dimension: Dimension,
    ) -> Option<Option<Typed>> {
        let [Arg { value: Expr { kind: ExprKind::Call { function, args }, span }, name: None }] = of else {
            return None;
        };
        let own =
            Function::named(&function.node) == Some(Function::MassCentre) && !self.is_curve(&function.node);
        let call = Call { name: function, args, span: *span, sign: Sign::Matters };
        own.then(|| self.of_mass_centre(call, query, dimension))
    }

    /// `inertia(L)` about the mass centre, `inertia(L, P)` about a point of the link
    fn moment_of_inertia(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let link = self.link_argument(call, args[0])?;
        let arm = match args.get(1) {
            None => None,
            Some(point) => Some(self.point_on(call, link, (point, "a point of that link"))?),
        };
        self.with_mass(call, link)?;
        let m = self.builder.mech.link(link).mass?;
        let arm = arm.map_or(Vec2::zero(), |at| at - m.centre);
        Some(Typed::constant(m.inertia + m.mass * arm.dot(arm), Dimension::INERTIA))
    }

    /// A point of this link, named alone or with it.
    pub(super) fn point_on(
        &mut self,
        call: Call<'_>,
        link: LinkId,
        (point, wanted): (&Expr, &str),
    ) -> Option<Vec2> {
        match &point.kind {
            ExprKind::Name(name) => return self.point(link, &Spanned::new(name.clone(), point.span)),
            ExprKind::Member(..) => {
                let (owner, at) = self.point_argument(call, point)?;
                if owner == link {
                    return Some(at);
                }
            }
            _ => {}
        }
        self.wrong_argument(call, wanted, point.span);
        None
    }

    /// The link that is named with its mass, or all moving links that have one.
    pub(super) fn heavy(&mut self, call: Call<'_>) -> Option<Vec<(LinkId, MassProperties)>> {
        let args = self.arguments(call, 0, 1)?;
        if let [link] = args[..] {
            let link = self.link_argument(call, link)?;
            self.with_mass(call, link)?;
            return Some(vec![(link, self.builder.mech.link(link).mass?)]);
        }
        let mech = &self.builder.mech;
        let fixed = fixed(mech);
        let links = mech.links.iter().enumerate().map(|(i, link)| (LinkId::at(i), link));
        let moving = links.filter(|(id, _)| !fixed.contains(id));
        Some(moving.filter_map(|(id, link)| Some((id, link.mass?))).collect())
    }

    /// Reports a mass centre of what has a mass, but no place.
    pub(super) fn in_the_plane(&mut self, call: Call<'_>, heavy: &[(LinkId, MassProperties)]) -> Option<()> {
        let Some((open, _)) = heavy.iter().find(|(link, _)| !self.builder.mech.is_placed(*link)) else {
            return Some(());
        };
        let link = self.builder.mech.link(*open);
        let (name, declared) = (link.name.clone(), link.span);
        let slides = self.names.things.get(&name).is_some_and(|d| d.what == ThingKind::Slider);
        let help = if slides {
            "a slider on a rope has no place: ask for the centres of the other links, as in `mass_centre(crank)`"
                .to_owned()
        } else {
            format!(
                "place one of its wheels, as in `wheel w … at O`, or write a link with `revolute O: ground - {name}`"
            )
        };
        self.error(
            Diagnosis::error("mech::request::no_place", format!("the position of `{name}` is not given"))
                .primary(call.span, "its mass centre is asked for")
                .label(declared, "declared here")
                .help(help),
        );
        None
    }

    /// Reports a mass centre where nothing has a mass.
    pub(super) fn without_any_mass(&mut self, call: Call<'_>) {
        self.error(
            Diagnosis::error("mech::request::no_mass", "nothing that moves has a mass".to_owned())
                .primary(call.span, "this question")
                .help("add a mass in the braces of a link: `mass 2 kg at S; inertia 0.1 kg*m^2`"),
        );
    }
}

/// The ground, and the links that are welded to it.
fn fixed(mechanism: &Mechanism) -> Vec<LinkId> {
    let mut fixed = vec![LinkId::GROUND];
    loop {
        let welds = mechanism.pairs.iter().filter(|pair| matches!(pair.kind, PairKind::Weld { .. }));
        let next = welds.map(|pair| pair.kind.links()).find(|links| {
            links.iter().any(|link| fixed.contains(link)) && !links.iter().all(|link| fixed.contains(link))
        });
        let Some(links) = next else { return fixed };
        fixed.extend(links);
    }
}
