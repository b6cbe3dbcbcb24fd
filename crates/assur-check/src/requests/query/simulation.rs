//! Functions of a motion under loads: `time(top, 2)`, `count(top)`, `energy()`.

use crate::expr::context::Context;
use crate::expr::results::{Call, wrong_argument};
use crate::motion::simulation::{meaningless, no_simulate, without_meaning};
use crate::names::declared::QuantityKind;
use crate::names::suggestion::suggestion;
use crate::statements::written::text;
use crate::values::fold;
use crate::values::typed::{Dim, Type, Typed};
use assur_model::model::{BinaryOp, Expr, LoadId, PairId, PairKind, Query, Situation};
use assur_syntax::document::{Drive, DrivePosition, ExprKind, Name, Spring, SpringSite, Statement};
use assur_text::diagnostic::Diagnosis;
use assur_text::language::Function;
use assur_text::source::{Span, Spanned};
use assur_text::units::Dimension;

impl Context<'_> {
    /// Reports functions of a motion under loads in another file, and those of a turn of the drive in such a file.
    pub(crate) fn is_of_a_motion(&mut self, call: Call<'_>, function: Function) -> Option<()> {
        use Function as F;
        let of_states = matches!(function, F::Period | F::Sticks | F::Rests | F::FrictionWork);
        if of_states && !self.names.simulates {
            no_simulate(self, function.name(), call.span);
            return None;
        }
        let of_drive = matches!(function, F::Travel | F::Stroke | F::TimeRatio | F::Dead | F::Critical);
        if of_drive && self.names.simulates {
            let what = format!("`{}`, which is found over the positions of a drive,", call.name.node);
            let help = "take `max` or `min` of a coordinate over the motion, as in \
                        `max(displacement(G))`"
                .to_owned();
            self.error(without_meaning(&what, &help, call.span));
            return None;
        }
        Some(())
    }

    /// Reports what is beyond accelerations where these are found from the loads.
    pub(super) fn follows_from_loads(&mut self, call: Call<'_>) -> bool {
        let found = self.builder.mech.drives.iter().any(|drive| drive.free);
        if found {
            let help = "ask for `acceleration` and `alpha`, which follow from the loads, or give the drive a motion of its own \
                        in a file without `simulate`, as in `drive crank = 0 deg .. 360 deg at 60 rpm`";
            self.error(without_meaning(&format!("`{}`", call.name.node), help, call.span));
        }
        found
    }

    /// The functions of a motion under loads.
    pub(crate) fn of_motion(&mut self, call: Call<'_>, function: Function) -> Option<Typed> {
        match function {
            Function::Time => self.event_time(call),
            Function::Drive => self.event_drive(call),
            Function::Count => self.event_count(call),
            Function::Rests => self.rests(call),
            Function::Impulse => self.impulse(call),
            Function::FrictionWork => self.friction_work(call),
            Function::Period => self.period(call),
            Function::Sticks => self.sticks(call),
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
        let is_timed = |drive: &Drive| drive.rate.is_some() && drive.acceleration.is_none();
        if let Some(drive) = self.swept_drive().filter(|drive| !is_timed(drive)) {
            let name = text(&drive.target);
            let place = format!("where `{name}` has no constant speed");
            let help = format!(
                "give `{name}` one, as in `at 10 rad/s`, or ask for `drive(…)` in place of `time(…)`"
            );
            self.error(meaningless("`time` of an event", &place, &help, call.span));
            return None;
        }
        let query = Expr::Query(Query::EventTime(event, which));
        Some(Typed::new(query, Type::number(Dimension::TIME)))
    }

    /// `drive(top)`, `drive(top, 2)`
    fn event_drive(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 2)?;
        let event = self.event_argument(call, args[0])?;
        let which = args.get(1).map_or(Some(1), |which| self.count_argument(call, which))?;
        let query = Expr::Query(Query::EventDrive(event, which));
        match self.swept_drive().map(|drive| self.drive_dimension(drive)) {
            Some(dimension) => Some(Typed::new(query, Type::number(dimension))),
            None if self.names.simulates => {
                let help =
                    "ask for `time(…)`, or for a value there: `expect angle(crank) = 90 deg at event …`";
                self.error(without_meaning("`drive` of an event", help, call.span));
                None
            }
            // the event itself is reported
            None => Some(Typed::pending(Type::Number(Dim::Any))),
        }
    }

    /// `count(top)`
    fn event_count(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let event = self.event_argument(call, args[0])?;
        Some(Typed::new(Expr::Query(Query::EventCount(event)), Type::number(Dimension::NUMBER)))
    }

    /// `rests(G)`
    fn rests(&mut self, call: Call<'_>) -> Option<Typed> {
        let pair = self.stopped(call)?;
        Some(Typed::new(Expr::Query(Query::In(Situation::Rests(pair))), Type::Bool))
    }

    /// `impulse(G)`
    fn impulse(&mut self, call: Call<'_>) -> Option<Typed> {
        let pair = self.stopped(call)?;
        let turns = matches!(self.builder.mech.pair(pair).kind, PairKind::Revolute(_));
        let effort = if turns { Dimension::TORQUE } else { Dimension::FORCE };
        let dimension = effort.times(Dimension::TIME);
        Some(Typed::new(Expr::Query(Query::Impulse(pair)), Type::number(dimension)))
    }

    /// Whether a name is that of a free coordinate that a stop bounds.
    pub(crate) fn is_bounded(&self, name: &str) -> bool {
        let bounds = |s: &Statement| matches!(s, Statement::Stop(stop) if stop.pair.node == name);
        let driven = self.drive_names().iter().any(|drive| drive == name);
        !driven && self.doc.statements.iter().any(|s| bounds(&s.node))
    }

    /// `effort(G)` of a free coordinate: what its stops bear.
    pub(crate) fn effort_of_stops(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.pair_argument(call, args[0])?;
        let turns = matches!(self.builder.mech.pair(pair).kind, PairKind::Revolute(_));
        let dimension = if turns { Dimension::TORQUE } else { Dimension::FORCE };
        Some(Typed::new(Expr::Query(Query::StopsEffort(pair)), Type::number(dimension)))
    }

    /// A pair that has a stop, or a contact that parts.
    fn stopped(&mut self, call: Call<'_>) -> Option<PairId> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.pair_argument(call, args[0])?;
        let name = self.builder.mech.pair(pair).name.clone();
        // a stop of what is no pair is reported, and may be meant
        let known = |name: &str| self.find_pair(name).is_some();
        let is_stop = |s: &Statement| matches!(s, Statement::Stop(stop) if stop.pair.node == name || !known(&stop.pair.node));
        let parts = matches!(self.builder.mech.pair(pair).kind, PairKind::Contact { parts: true, .. });
        if !parts && !self.doc.statements.iter().any(|s| is_stop(&s.node)) {
            let what = format!("`{name}` has no stop to rest on");
            let help = format!("add one, as in `stop {name} > 0 mm {{ restitution 0.7 }}`");
            self.error(
                Diagnosis::error("mech::simulate::stop", what).primary(call.span, "this question").help(help),
            );
            return None;
        }
        Some(pair)
    }

    /// `period()`
    fn period(&mut self, call: Call<'_>) -> Option<Typed> {
        self.arguments(call, 0, 0)?;
        if !self.is_steady() {
            let what = "`period()` without a steady motion".to_owned();
            let help = "ask for the motion that repeats, as in `simulate steady turn of crank`".to_owned();
            self.error(without_meaning(&what, &help, call.span));
            return None;
        }
        Some(Typed::new(Expr::Query(Query::Period), Type::number(Dimension::TIME)))
    }

    /// `sticks(P)`
    fn sticks(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let pair = self.pair_argument(call, args[0])?;
        let declared = self.builder.mech.pair(pair);
        if !declared.rubs() {
            let what = format!("`sticks` of `{}`, which has no friction,", declared.name);
            let help = self.rubbing_between(pair);
            self.error(without_meaning(&what, &help, call.span));
            return None;
        }
        Some(Typed::new(Expr::Query(Query::In(Situation::Sticks(pair))), Type::Bool))
    }

    /// What may be asked in place of a pair without friction, of the problem as it is.
    fn rubbing_between(&self, pair: PairId) -> String {
        let mechanism = &self.builder.mech;
        let links = mechanism.pair(pair).kind.links();
        let clutch = mechanism.pairs.iter().find(|other| match &other.kind {
            PairKind::Transmission(t) => {
                t.slipping().is_some_and(|own| own.iter().all(|id| links.contains(id)))
            }
            _ => false,
        });
        match clutch {
            Some(clutch) => format!("write `sticks({})`", clutch.name),
            None => "ask it of a pair with `friction`, or of a clutch with `slipping`".to_owned(),
        }
    }

    /// `work(M)`, `work(k)`
    pub(super) fn work(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 1, 1)?;
        let ExprKind::Name(name) = &args[0].kind else {
            self.wrong_argument(call, "the name of a load or a spring", args[0].span);
            return None;
        };
        let whole = Spanned::new(name.clone(), args[0].span);
        self.names.note_quantity(&whole);
        self.names.note_thing(&whole);
        let power = match self.names.quantities.get(name).map(|d| d.what) {
            Some(QuantityKind::Load(id, _) | QuantityKind::Brake(id)) => Some(Query::LoadPower(id)),
            Some(QuantityKind::Balance(..)) => {
                self.work_of_balance(&whole);
                return None;
            }
            _ => self.spring_power(name),
        };
        let Some(power) = power else {
            self.wrong_argument(call, "the name of a load or a spring", args[0].span);
            return None;
        };
        Some(self.work_of(Expr::Query(power)))
    }

    /// The work of an unknown effort is not followed in a motion: it is an integral.
    pub(super) fn work_of_balance(&mut self, balance: &Name) {
        let name = &balance.node;
        let (wanted, help) = if self.names.simulates {
            ("the name of a load or a spring", format!("write `integral(power({name}))`"))
        } else {
            let what = "the work of a balance is";
            let speed = "divided by the speed of the drive";
            ("a flywheel", format!("{what} `integral(power({name}))` {speed}"))
        };
        self.error(wrong_argument("work", wanted, balance.span, "").help(help));
    }

    /// The power of a spring: between two points, or in a pair, where it is a load after all others.
    fn spring_power(&self, name: &str) -> Option<Query> {
        let springs = self.doc.statements.iter().filter_map(|s| match &s.node {
            Statement::Spring(spring) => Some(spring),
            _ => None,
        });
        let wanted = springs.clone().find(|spring| spring.name.node == name)?;
        let in_pair = matches!(wanted.site, SpringSite::Pair(_));
        let alike = springs.filter(|s| matches!(s.site, SpringSite::Pair(_)) == in_pair);
        let before = alike.take_while(|spring| spring.name.node != name).count();
        if !in_pair {
            return Some(Query::SpringPower(before));
        }
        let is_load = |s: &Statement| matches!(s, Statement::Load(_) | Statement::Brake(_));
        let loads = self.doc.statements.iter().filter(|s| is_load(&s.node)).count();
        Some(Query::LoadPower(LoadId::at(loads + before)))
    }

    /// `friction_work()`, `friction_work(P)`
    fn friction_work(&mut self, call: Call<'_>) -> Option<Typed> {
        let args = self.arguments(call, 0, 1)?;
        let pairs: Vec<PairId> = match args.first() {
            Some(arg) => vec![self.pair_argument(call, arg)?],
            None => {
                let all = self.builder.mech.pairs.iter().enumerate().filter(|(_, pair)| pair.rubs());
                all.map(|(i, _)| PairId::at(i)).collect()
            }
        };
        let of = |pair: PairId| Expr::Negate(Box::new(Expr::Query(Query::FrictionPower(pair))));
        let powers = pairs.into_iter().filter(|pair| self.builder.mech.pair(*pair).rubs()).map(of);
        let sum = powers.reduce(|sum, power| fold::binary(BinaryOp::Add, sum, power));
        Some(self.work_of(sum.unwrap_or(Expr::number(0.0))))
    }

    /// The work of a power; the same one is kept once.
    fn work_of(&mut self, power: Expr) -> Typed {
        let works = &mut self.builder.mech.works;
        let known = works.iter().position(|work| *work == power);
        let id = known.unwrap_or_else(|| {
            works.push(power);
            works.len() - 1
        });
        Typed::new(Expr::Query(Query::Work(id)), Type::number(Dimension::TORQUE))
    }

    /// `kinetic_energy()`, `potential_energy()`, and their sum.
    fn energy(&mut self, call: Call<'_>, parts: &[Query]) -> Option<Typed> {
        self.arguments(call, 0, 0)?;
        let pair = |s: &Statement| match s {
            Statement::Spring(Spring { site: SpringSite::Pair(pair), .. }) => self.find_pair(&pair.node),
            _ => None,
        };
        let hinges = self.doc.statements.iter().filter_map(|s| pair(&s.node)).enumerate();
        let hinges = hinges.map(|(spring, pair)| Query::TorsionEnergy(spring, pair));
        let stored = parts.contains(&Query::PotentialEnergy);
        let all = parts.iter().copied().chain(hinges.filter(|_| stored)).collect::<Vec<_>>();
        let mut parts = all.into_iter().map(Expr::Query);
        let first = parts.next()?;
        let sum = parts.fold(first, |sum, part| fold::binary(BinaryOp::Add, sum, part));
        Some(Typed::new(sum, Type::number(Dimension::TORQUE)))
    }

    /// The first drive that goes through a range.
    pub(crate) fn swept_drive(&self) -> Option<&Drive> {
        let mut all = self.drive_statements().into_iter();
        all.find(|drive| matches!(drive.position, Some(DrivePosition::Range(_))))
    }

    /// An event by its name. Reports what is none.
    pub(crate) fn event(&mut self, name: &Name) -> Option<usize> {
        self.names.note_event(name);
        if let Some(index) = self.names.events.get_index_of(&name.node) {
            return Some(index);
        }
        if self.names.bad.contains(&name.node) || !self.problems.reported.insert(("event", name.node.clone()))
        {
            return None;
        }
        let events = self.names.events.keys().map(String::as_str).collect::<Vec<_>>();
        let of_link = self.find_link(&name.node).map(|_| {
            format!("write `simulate steady turn of {0}` for turns of `{0}`, or name an event", name.node)
                .into()
        });
        let listed = || suggestion(&name.node, name.span, &events, "events");
        let help = of_link.or_else(listed).unwrap_or_else(|| {
            format!("declare it, as in `event {}: omega(crank) = 0 rad/s`", name.node).into()
        });
        self.error(
            Diagnosis::error("mech::simulate::unknown_event", format!("there is no event `{}`", name.node))
                .label(name.span, "not declared")
                .help(help),
        );
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
