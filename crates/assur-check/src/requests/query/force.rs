//! Forces: reactions, inertia, efforts, power.

use crate::expr::{
    context::Context,
    results::{Call, Sign, wrong_argument},
};
use crate::links::lookup::is_linkage_pair;
use crate::motion::place;
use crate::names::declared::ThingKind;
use crate::names::{
    declared::QuantityKind,
    suggestion::{suggestion, wrong_kind},
};
use crate::requests::query::args::path;
use crate::values::typed::{Type, Typed};
use assur_model::model::{
    BinaryOp, DriveId, Expr as ModelExpr, LinkId, Pair, PairId, PairKind, Query, TransmissionKind,
};
use assur_syntax::document::{Expr, ExprKind, Member, Name, Statement};
use assur_text::diagnostic::{Diagnosis, Fix};
use assur_text::language::Function;
use assur_text::source::Spanned;
use assur_text::units::Dimension;

fn number(query: Query, dimension: Dimension) -> Typed {
    Typed::new(ModelExpr::Query(query), Type::number(dimension))
}

const fn may_have_mass(member: &Member) -> bool {
    matches!(member, Member::Mass(_) | Member::Weight(_) | Member::Inertia(_) | Member::Bad(_))
}

/// The force that a transmission of another kind has.
const fn other_force(kind: TransmissionKind) -> &'static str {
    match kind {
        TransmissionKind::Rope => "ask for the pull in it: `tension(…)`",
        TransmissionKind::Screw | TransmissionKind::Clutch => "ask for its torque: `moment(…, …)`",
        TransmissionKind::Mesh
        | TransmissionKind::Belt
        | TransmissionKind::Chain
        | TransmissionKind::Rack
        | TransmissionKind::Worm => "ask for the force along its circles: `tangential_force(…)`",
    }
}

impl Context<'_> {
    /// `reaction`, `moment`, `normal`, `friction` of a pair that has it, on a link
    pub(crate) fn reaction(
        &mut self,
        call: Call<'_>,
        has: fn(&Pair) -> bool,
        query: fn(PairId, LinkId) -> Query,
        ty: Type,
    ) -> Option<Typed> {
        if self.link_before_pair(call) {
            return None;
        }
        let args = self.arguments(call, 1, 2)?;
        let pair = self.pair_argument(call, args[0]);
        let link = match args.get(1) {
            Some(link) => Some(self.link_argument(call, link)?),
            None => None,
        };
        let pair = pair?;
        if !has(self.builder.mech.pair(pair)) {
            self.not_of_this_pair(call, pair, Some("`reaction(…)` is defined for every pair"));
            return None;
        }
        let link = match (link, args.get(1)) {
            (Some(link), Some(place)) => self.link_of_pair(pair, link, place)?,
            _ => self.any_link(call, pair, ty)?,
        };
        Some(Typed::new(ModelExpr::Query(query(pair, link)), ty))
    }

    fn link_of_pair(&mut self, pair: PairId, link: LinkId, place: &Expr) -> Option<LinkId> {
        let links = self.builder.mech.pair(pair).kind.links();
        if links.contains(&link) {
            return Some(link);
        }
        let quoted = self.spelled(&links).iter().map(|n| format!("`{n}`")).collect::<Vec<_>>();
        let declared = self.pair_span(pair);
        let name = self.builder.mech.pair(pair).name.clone();
        let link = self.builder.mech.link(link).name.clone();
        let help = format!("`{name}` joins {}", quoted.join(", "));
        self.error(
            Diagnosis::error("mech::request::link_not_in_pair", format!("`{name}` does not join `{link}`"))
                .primary(place.span, format!("not a link of `{name}`"))
                .label(declared, format!("`{name}` is declared here"))
                .help(help),
        );
        None
    }

    /// The second link of a pair of two where the sign does not matter; otherwise it must be said.
    fn any_link(&mut self, call: Call<'_>, pair: PairId, ty: Type) -> Option<LinkId> {
        let links = self.builder.mech.pair(pair).kind.links();
        if let ([_, second], Sign::Free) = (&links[..], call.sign) {
            return Some(*second);
        }
        let (function, pair) = (call.name.node.clone(), self.builder.mech.pair(pair).name.clone());
        let choices =
            self.spelled(&links).iter().map(|l| format!("`{function}({pair}, {l})`")).collect::<Vec<_>>();
        let help = match links.len() {
            2 => {
                let size = if matches!(ty, Type::Vector(_)) { Function::Mag } else { Function::Abs };
                format!("write {}, or `{}({function}({pair}))`", choices.join(" or "), size.name())
            }
            _ => format!("write {}", choices.join(" or ")),
        };
        self.error(
            Diagnosis::error(
                "mech::request::which_link",
                format!(
                    "`{function}({pair})` acts on {} links with opposite signs, and no link is named",
                    links.len()
                ),
            )
            .primary(call.span, "the link is missing")
            .fixes(Fix::quoted(&help, call.span).into_iter().take(2))
            .help(help),
        );
        None
    }

    pub(crate) fn contact_force(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 2, 2)?;
        let pair = self.pair_argument(call, args[0]);
        let side = self.one_or_two(call, args[1]);
        let (pair, side) = (pair?, side?);
        let declared = self.builder.mech.pair(pair);
        let PairKind::Prismatic(guide) = &declared.kind else {
            self.not_of_this_pair(call, pair, Some("it is defined for prismatic pairs"));
            return None;
        };
        if guide.contacts.is_none() {
            let (pair, declared) = (declared.name.clone(), declared.span);
            self.error(
                Diagnosis::error("mech::request::no_contacts", format!("`{pair}` has no contact points"))
                    .primary(call.span, "this question")
                    .label(declared, "declared here, without `contacts`")
                    .help("add them in its braces: `contacts -20 mm, 25 mm`"),
            );
            return None;
        }
        Some(number(Query::ContactForce(pair, side), Dimension::FORCE))
    }

    /// `inertia_force`, `inertia_torque`, `inertia_arm`
    pub(crate) fn inertia(&mut self, call: Call<'_>, query: fn(LinkId) -> Query, ty: Type) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let link = self.link_argument(call, args[0])?;
        self.with_mass(call, link)?;
        Some(Typed::new(ModelExpr::Query(query(link)), ty))
    }

    /// Reports a link without mass.
    pub(crate) fn with_mass(&mut self, call: Call<'_>, link: LinkId) -> Option<()> {
        let declared = self.builder.mech.link(link);
        if declared.mass.is_some() {
            return Some(());
        }
        // A mass that is declared with an error is missing here as well, and that is reported.
        let written = self.doc.statements.iter().any(|s| match &s.node {
            Statement::Link(l) => {
                l.name.span == declared.span && l.body.iter().any(|m| may_have_mass(&m.node))
            }
            Statement::Bad(_) => true,
            _ => false,
        });
        if !written {
            let (link, declared) = (declared.name.clone(), declared.span);
            self.error(
                Diagnosis::error("mech::request::no_mass", format!("`{link}` has no mass"))
                    .primary(call.span, "this question")
                    .label(declared, "declared here")
                    .help("add a mass in its braces: `mass 2 kg at S; inertia 0.1 kg*m^2`"),
            );
        }
        None
    }

    /// `tangential_force(k)`
    pub(crate) fn tangential_force(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let (pair, kind) = self.transmission(call, args[0])?;
        if matches!(kind, TransmissionKind::Rope | TransmissionKind::Screw | TransmissionKind::Clutch) {
            self.not_of_this_pair(call, pair, Some(other_force(kind)));
            return None;
        }
        let on = self.side(call, pair, args.get(1).copied())?;
        Some(number(Query::TangentialForce(pair, on), Dimension::FORCE))
    }

    /// `normal_force(k)`
    pub(crate) fn normal_force(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let (pair, kind) = self.transmission(call, args[0])?;
        let PairKind::Transmission(t) = &self.builder.mech.pair(pair).kind else { return None };
        if !matches!(kind, TransmissionKind::Mesh | TransmissionKind::Rack) {
            self.not_of_this_pair(call, pair, Some(other_force(kind)));
            return None;
        }
        if t.pressure_angle.is_none() {
            let help = "the line of action is not known: add `{ pressure_angle 20 deg }` to it";
            self.not_of_this_pair(call, pair, Some(help));
            return None;
        }
        let on = self.side(call, pair, args.get(1).copied())?;
        Some(number(Query::ToothForce(pair, on), Dimension::FORCE))
    }

    /// The side of a transmission that is asked for, if one is. Of a worm the wheel: the radius of the worm is not known.
    fn side(&mut self, call: Call<'_>, pair: PairId, on: Option<&Expr>) -> Option<Option<LinkId>> {
        let Some(on) = on else { return Some(None) };
        let link = self.link_argument(call, on)?;
        let PairKind::Transmission(t) = &self.builder.mech.pair(pair).kind else { return None };
        let sides = if t.kind == TransmissionKind::Worm { &t.links[1..] } else { &t.links[..] };
        if sides.contains(&link) {
            return Some(Some(link));
        }
        let names: Vec<String> =
            sides.iter().map(|l| format!("`{}`", self.builder.mech.link(*l).name)).collect();
        let wanted = format!("a side of `{}`: {}", self.builder.mech.pair(pair).name, names.join(" or "));
        self.wrong_argument(call, &wanted, on.span);
        None
    }

    /// `tension(a)`; `tension(a, A)` of the part of a rope that ends at A
    pub(crate) fn tension(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let (pair, kind) = self.transmission(call, args[0])?;
        let PairKind::Transmission(t) = &self.builder.mech.pair(pair).kind else { return None };
        let parts = t.laws.len();
        if kind != TransmissionKind::Rope {
            self.not_of_this_pair(call, pair, Some(other_force(kind)));
            return None;
        }
        let (part, end) = self.part_of_rope(call, pair, args.get(1).copied(), parts)?;
        Some(number(Query::Tension(pair, part, end), Dimension::FORCE))
    }

    /// An argument that names a transmission, and its kind.
    pub(super) fn transmission(&mut self, call: Call<'_>, expr: &Expr) -> Option<(PairId, TransmissionKind)> {
        let pair = self.pair_argument(call, expr)?;
        let PairKind::Transmission(t) = &self.builder.mech.pair(pair).kind else {
            let meant = match &expr.kind {
                ExprKind::Name(name) => {
                    let name = Spanned::new(name.clone(), expr.span);
                    let fits =
                        |kind: ThingKind| matches!(kind, ThingKind::Joint(kind) if !is_linkage_pair(kind));
                    self.fitting(&name, "transmission", &fits)
                }
                _ => None,
            };
            let help = meant.unwrap_or_else(|| "it is defined for meshes, ropes and their like".to_owned());
            self.not_of_this_pair(call, pair, Some(&help));
            return None;
        };
        Some((pair, t.kind))
    }

    /// Which part of a rope is meant, and which of its ends: what is named.
    fn part_of_rope(
        &mut self,
        call: Call<'_>,
        pair: PairId,
        end: Option<&Expr>,
        parts: usize,
    ) -> Option<(usize, Option<usize>)> {
        let PairKind::Transmission(t) = &self.builder.mech.pair(pair).kind else { return None };
        let outer = [t.ends.first().cloned()?, t.ends.last().cloned()?];
        let rope = self.builder.mech.pair(pair).name.clone();
        let Some(end) = end else {
            if parts == 1 {
                return Some((0, None));
            }
            let usage = format!("tension({rope}, {})` or `tension({rope}, {})", outer[0], outer[1]);
            let function = call.name.node.clone();
            let wanted = "also an end of the rope, because wheels divide it,".to_owned();
            self.error(wrong_argument(&function, &wanted, call.span, &usage));
            return None;
        };
        self.note_names(end);
        let named = path(end).map(|p| p.iter().map(|n| n.node.as_str()).collect::<Vec<_>>().join("."));
        match named {
            Some(name) if name == outer[0] => Some((0, Some(0))),
            Some(name) if name == outer[1] => Some((parts - 1, Some(1))),
            _ => {
                let wanted = format!("one end of the rope: `{}` or `{}`", outer[0], outer[1]);
                self.wrong_argument(call, &wanted, end.span);
                None
            }
        }
    }

    /// `effort(crank)`
    pub(crate) fn effort(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let Some(names) = path(args[0]) else {
            self.wrong_argument(call, "a driven link or pair", args[0].span);
            return None;
        };
        self.note_names(args[0]);
        if let [name] = names.as_slice()
            && self.is_bounded(&name.node)
        {
            return self.effort_of_stops(call);
        }
        let (index, drive) = self.drive(&names)?;
        let target = &self.drive_statements()[index].target;
        // what it drives could not be read
        if self.names.bad.contains(&target.head.node) && !self.names.things.contains_key(&target.head.node) {
            return None;
        }
        let (is_point, is_place) = (target.tail.is_some(), place::is_place(self, target));
        if is_point && !is_place {
            self.wrong_argument(call, "a link or a pair that is driven", args[0].span);
            return None;
        }
        self.own_effort(args[0])?;
        if is_place {
            let [x, y] = [drive, DriveId::at(drive.index() + 1)]
                .map(|id| Box::new(ModelExpr::Query(Query::Effort(id))));
            return Some(Typed::new(ModelExpr::Vector(x, y), Type::vector(Dimension::FORCE)));
        }
        let statement = self.drive_statements()[index];
        let turns = self.drive_dimension(statement) == Dimension::ANGLE;
        Some(number(Query::Effort(drive), if turns { Dimension::TORQUE } else { Dimension::FORCE }))
    }

    /// Reports an effort of a drive where other efforts are unknown.
    fn own_effort(&mut self, driven: &Expr) -> Option<()> {
        let balance = self.names.quantities.iter().find(|(_, d)| matches!(d.what, QuantityKind::Balance(..)));
        let Some((balance, declared)) = balance.map(|(name, d)| (name.clone(), d.span)) else {
            return Some(());
        };
        let name = path(driven)?.iter().map(|n| n.node.as_str()).collect::<Vec<_>>().join(".");
        self.error(
            Diagnosis::error(
                "mech::request::no_own_effort",
                format!(
                    "`{name}` has no effort of its own, because the file declares the unknown \
                     effort `{balance}`"
                ),
            )
            .primary(driven.span, "this question")
            .label(declared, "the unknown effort")
            .help(format!("ask for `{balance}`, or leave out this `balance`")),
        );
        None
    }

    /// A drive by its name: its place among the statements, and its first coordinate.
    fn drive(&mut self, names: &[Name]) -> Option<(usize, DriveId)> {
        let written = names.iter().map(|n| n.node.as_str()).collect::<Vec<_>>().join(".");
        let drives = self.drive_names();
        if let Some(i) = drives.iter().position(|d| *d == written) {
            let before = &self.drive_statements()[..i];
            let places = before.iter().filter(|drive| place::is_place(self, &drive.target)).count();
            return Some((i, DriveId::at(i + places)));
        }
        let (first, last) = (names.first()?, names.last()?);
        // that it is not declared is one message
        let known = self.problems.reported.contains(&("thing", first.node.clone()));
        let bad = known || self.names.bad.contains(&first.node);
        if bad || !self.problems.reported.insert(("drive", written.clone())) {
            return None;
        }
        let all = drives.iter().map(String::as_str).collect::<Vec<_>>();
        let free = self.builder.mech.drives.iter().any(|d| d.free && d.name == written);
        let help = if free {
            Some(format!("`{written}` is free: it moves as the loads make it, and has no effort of its own"))
        } else {
            suggestion(&written, first.span, &all, "driven links and pairs").map(|help| help.to_string())
        };
        self.error(
            Diagnosis::error("mech::request::not_driven", format!("nothing drives `{written}`"))
                .primary(first.span.to(last.span), "no drive of that name")
                .help_if(help)
                .quoted(first.span.to(last.span)),
        );
        None
    }

    /// What the drives move, as written, in order.
    pub fn drive_names(&self) -> Vec<String> {
        let written = |path: &assur_syntax::document::Path| match &path.tail {
            Some(tail) => format!("{}.{}", path.head.node, tail.node),
            None => path.head.node.clone(),
        };
        self.drive_statements().iter().map(|d| written(&d.target)).collect()
    }

    /// `power(Mb)` of an unknown effort, a load or a drive
    pub(crate) fn power(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let names = path(args[0]);
        let Some(names) = names else {
            self.wrong_argument(call, "a load, an unknown effort or a drive", args[0].span);
            return None;
        };
        self.names.note_quantity(&names[0]);
        let declared = self.names.quantities.get(&names[0].node).map(|d| (d.what, d.span));
        let query = match declared {
            Some((QuantityKind::Load(id, _) | QuantityKind::Brake(id), _)) if names.len() == 1 => {
                Query::LoadPower(id)
            }
            Some((QuantityKind::Balance(id, _), _)) if names.len() == 1 => Query::BalancePower(id),
            Some((_, span)) if names.len() == 1 => {
                self.error(wrong_kind(
                    &names[0].node,
                    "a value",
                    "a load or an unknown effort",
                    names[0].span,
                    Some(span),
                    None,
                ));
                return None;
            }
            _ => {
                self.note_names(args[0]);
                let (index, drive) = self.drive(&names)?;
                self.own_effort(args[0])?;
                if place::is_place(self, &self.drive_statements()[index].target) {
                    let [x, y] = [drive, DriveId::at(drive.index() + 1)]
                        .map(|id| ModelExpr::Query(Query::EffortPower(id)));
                    let sum = crate::values::fold::binary(BinaryOp::Add, x, y);
                    return Some(Typed::new(sum, Type::number(Dimension::POWER)));
                }
                Query::EffortPower(drive)
            }
        };
        Some(number(query, Dimension::POWER))
    }
}
