//! What to leave out of an overconstrained part, and what to write in place of a statement: each change tried before a help speaks of
//! it.

use super::defect::{Defect, Fit, Part};
use super::diagnose::slipping;
use super::effort::{self, Effort, EffortKind, EffortSource};
use super::generic::Split;
use super::incidence::Incidence;
use super::order::{Named, Order, Rank};
use super::replace;
use super::trial::{Change, Outcome, Statement, Trial, leave_out, leave_out_link};
use super::weld_defects;
use super::words::{drive_statement, is_structure, line, pairs_of, statement};
use crate::math::Vec2;
use crate::model::{DriveId, Guide, LinkId, Mechanism, PairId, PairKind, Pin, Rate};

/// Changes tried of each sort.
const MOST_TRIED: usize = 48;
const MOST_NAMED: usize = 8;

/// A change after which the part is sound.
pub(super) struct Mend {
    pub what: Sort,
    /// As a help says it: `` `slot E` ``.
    pub text: String,
    /// Links that no drive moves any more.
    pub unmoved: usize,
    /// Everything is determined with it.
    heals: bool,
    /// Another statement names what it leaves out.
    is_needed: bool,
    rank: Rank,
    /// What it leaves out alone.
    left_out: Option<Statement>,
}

/// What a change does, in the words of a help.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sort {
    /// Leaves out a pair or a drive.
    Statement,
    /// Leaves out the only drive.
    OnlyDrive,
    /// Leaves out a link with its pairs.
    Link,
    /// Writes another line in place of a pair.
    Written,
}

/// An effort as its statement begins: `drive crank`, `start crank`, `balance Mb`.
fn effort_statement(mechanism: &Mechanism, source: EffortSource) -> String {
    match source {
        EffortSource::Drive(id) => drive_statement(&mechanism.drives[id.index()]),
        EffortSource::Balance(id) => format!("`balance {}`", mechanism.balances[id.index()].name),
    }
}

/// What a help says first to leave out of a mechanism that is held once too often, if that makes all determined.
#[must_use]
pub fn spare(mechanism: &Mechanism) -> Option<Spare> {
    let replaced = replace::replace(mechanism);
    let efforts = effort::of_drives(mechanism, &replaced);
    let trial = Trial { mechanism, replaced: &replaced, efforts: &efforts };
    let defect = Incidence::new(&replaced, &efforts).defect(&replaced)?;
    let [part] = defect.over.as_slice() else { return None };
    let repair = Repair { trial, defect: &defect, part };
    // two points of one link at one pin, a clutch that has to slip, and links that are welded: that says it
    if repair.split().is_some()
        || slipping(trial, part).is_some()
        || !weld_defects::defects(mechanism, &replaced).is_empty()
    {
        return None;
    }
    let mends = repair.mends();
    match mends.into_iter().find(|mend| mend.heals)?.left_out? {
        Statement::Pair(pair) => Some(Spare::Pair(pair)),
        Statement::Link(link) => Some(Spare::Link(link)),
        Statement::Effort(effort) => match efforts[effort].source {
            EffortSource::Drive(drive) if efforts.len() > 1 => Some(Spare::Drive(drive)),
            _ => None,
        },
    }
}

/// A pair, a link with its pairs, or one of several drives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spare {
    Pair(PairId),
    Link(LinkId),
    Drive(DriveId),
}

impl Spare {
    /// The mechanism without it. Links and pairs keep their numbers: the pairs join nothing, and the link rests on the ground.
    #[must_use]
    pub fn taken_out(self, mechanism: &Mechanism) -> Option<Mechanism> {
        let mut left = mechanism.clone();
        match self {
            Self::Pair(pair) => {
                leave_out(&mut left.pairs[pair.index()].kind);
            }
            Self::Drive(drive) => {
                left.drives.remove(drive.index());
            }
            Self::Link(link) => {
                let own = pairs_of(mechanism, link);
                leave_out_link(&mut left, link);
                let free = own.into_iter().find(|pair| left.pair(*pair).kind.links().is_empty())?;
                let at = Vec2::zero();
                let pins = [LinkId::GROUND, link].map(|link| Pin { link, name: String::new(), at });
                left.pairs[free.index()].kind = PairKind::Weld { pins: pins.to_vec(), angle: 0.0 };
            }
        }
        Some(left)
    }
}

/// A part that is to be made sound.
#[derive(Clone, Copy)]
pub(super) struct Repair<'a> {
    pub trial: Trial<'a>,
    pub defect: &'a Defect,
    pub part: &'a Part,
}

impl Repair<'_> {
    /// Two points of one link that pins of the part would bring together.
    pub(super) fn split(&self) -> Option<Split> {
        let split = Incidence::new(self.trial.replaced, self.trial.efforts).split()?;
        let pair = self.trial.replaced.joint(split.joint).pair;
        self.part.pairs.iter().any(|own| own.0 == pair).then_some(split)
    }

    /// The changes that make the part sound, each by itself, the likeliest first; where some make the whole sound, those alone.
    pub(super) fn mends(&self) -> Vec<Mend> {
        let mut mends: Vec<Mend> = Vec::new();
        let moves = !is_structure(self.trial.mechanism);
        for (mut mend, change) in self.tried() {
            let now = self.trial.after(&change);
            if self.is_sound(&now) {
                mend.heals = now.is_sound();
                mend.unmoved = if mend.heals && moves { now.incidence.unmoved().len() } else { 0 };
                mends.push(mend);
            }
        }
        let heals = mends.iter().any(|mend| mend.heals);
        mends.retain(|mend| mend.heals == heals);
        // questions and loads that name a statement would have errors without it
        let is_free = mends.iter().any(|mend| !mend.is_needed);
        mends.retain(|mend| mend.is_needed != is_free);
        // another pin in place of one is more than leaving out a pair
        let is_pin = |mend: &Mend| mend.what == Sort::Written && mend.text.starts_with("`revolute");
        if mends.iter().any(|mend| mend.what == Sort::Statement) {
            mends.retain(|mend| !is_pin(mend));
        }
        mends.sort_by_key(|mend| mend.rank);
        mends.dedup_by(|a, b| a.text == b.text);
        mends
    }

    /// What may make the part sound, with the change that it is.
    fn tried(&self) -> Vec<(Mend, Change)> {
        let order = Order::of(self.trial);
        let named = Named::of(self.trial.mechanism);
        let most = self.trial.most_tried(MOST_TRIED);
        let mend = |what, text, rank, is_needed, left_out| Mend {
            what,
            text,
            unmoved: 0,
            heals: false,
            is_needed,
            rank,
            left_out,
        };
        let mut statements = self.statements();
        statements.sort_by_cached_key(|statement| (named.has(*statement), order.rank(*statement)));
        let left_out = statements.into_iter().take(2 * most).map(|one| {
            let (sort, text) = self.words(one);
            (mend(sort, text, order.rank(one), named.has(one), Some(one)), Change::without(one))
        });
        let written = self.rewritten().into_iter().take(most).map(|(pair, kind, line)| {
            let text = format!("`{line}` in place of {}", statement(self.trial.mechanism, pair));
            let rank = order.rank(Statement::Pair(pair));
            (mend(Sort::Written, text, rank, false, None), Change::writing(pair, kind))
        });
        left_out.chain(written).collect()
    }

    /// Whether one of them, without a pair or drive that is left out or with any, makes the whole sound.
    pub(super) fn heals(&self, by_statement: bool) -> bool {
        let is_one = |mend: &Mend| mend.heals && (!by_statement || mend.what == Sort::Statement);
        self.mends().iter().any(is_one)
    }

    /// Some mends of each sort, the sorts in the order of their likeliest.
    pub(super) fn sorted(&self) -> Vec<(Sort, Vec<Mend>)> {
        let mut sorts: Vec<(Sort, Vec<Mend>)> = Vec::new();
        for mend in self.mends() {
            match sorts.iter_mut().find(|sort| sort.0 == mend.what) {
                Some((_, mends)) if mends.len() == MOST_NAMED => {}
                Some((_, mends)) => mends.push(mend),
                None => sorts.push((mend.what, vec![mend])),
            }
        }
        // a line written anew is the lesser change of two, and the less likely one
        sorts.sort_by_key(|sort| sort.0 == Sort::Written);
        sorts
    }

    /// The part has no condition too many any more, and nothing is made loose; or all is determined.
    fn is_sound(&self, now: &Outcome) -> bool {
        let of_part = now.fit.surplus + self.part.surplus == self.defect.fit.surplus;
        now.is_sound() || now.is_whole && of_part && now.fit.missing == self.defect.fit.missing
    }

    /// Pairs, links and drives that are statements of their own.
    fn statements(&self) -> Vec<Statement> {
        let trial = self.trial;
        let pairs = self.undriven_pairs().map(Statement::Pair);
        let links = self.part.bodies.iter().flat_map(|body| trial.replaced.links_of(*body));
        let links = links.filter(|&link| {
            let is_shaft = |pair: &PairId| trial.mechanism.pair(*pair).bearing.is_some();
            let pairs = pairs_of(trial.mechanism, link);
            let is_free = !drives_link(trial, link) && !pairs.iter().any(|p| is_driven(trial, *p));
            link != LinkId::GROUND && is_free && !pairs.iter().any(is_shaft)
        });
        let efforts = self.part.efforts.iter().copied().map(Statement::Effort);
        pairs.chain(links.map(Statement::Link)).chain(efforts).collect()
    }

    fn words(&self, statement_of: Statement) -> (Sort, String) {
        let Trial { mechanism, efforts, .. } = self.trial;
        match statement_of {
            Statement::Pair(pair) => (Sort::Statement, statement(mechanism, pair)),
            Statement::Link(link) => (Sort::Link, format!("`{}`", mechanism.link(link).name)),
            Statement::Effort(effort) => {
                let is_machine = efforts.len() == 1 && !is_structure(mechanism);
                let sort = if is_machine { Sort::OnlyDrive } else { Sort::Statement };
                (sort, effort_statement(mechanism, efforts[effort].source))
            }
        }
    }

    pub(super) fn undriven_pairs(&self) -> impl Iterator<Item = PairId> + '_ {
        let pairs = self.part.pairs.iter().map(|p| p.0);
        pairs.filter(|&p| !is_driven(self.trial, p) && is_spare(self.trial.mechanism, p))
    }

    /// Prismatic pairs as slots, and pins of several links without one of them.
    fn rewritten(&self) -> Vec<(PairId, PairKind, String)> {
        let mechanism = self.trial.mechanism;
        let kinds = self.undriven_pairs().flat_map(|p| {
            let kinds = match &mechanism.pair(p).kind {
                PairKind::Prismatic(guide) => {
                    vec![PairKind::Slot(Guide { own_line: None, ..guide.clone() })]
                }
                PairKind::Revolute(pins) if pins.len() > 2 => {
                    let but = |i: usize| {
                        pins.iter().enumerate().filter(|(k, _)| *k != i).map(|(_, pin)| pin.clone()).collect()
                    };
                    let of_part =
                        |pin: &Pin| self.part.bodies.contains(&self.trial.replaced.body_of(pin.link));
                    (0..pins.len())
                        .filter(|i| of_part(&pins[*i]))
                        .map(|i| PairKind::Revolute(but(i)))
                        .collect()
                }
                _ => Vec::new(),
            };
            kinds.into_iter().map(move |kind| (p, kind))
        });
        let with_line = |(p, kind): (PairId, PairKind)| {
            let line = line(mechanism, &mechanism.pair(p).name, &kind)?;
            Some((p, kind, line))
        };
        kinds.filter_map(with_line).collect()
    }

    pub(super) fn efforts(&self) -> Vec<String> {
        let tried = self.part.efforts.iter().take(self.trial.most_tried(MOST_TRIED));
        let of_part = |now: Fit| {
            now.surplus + self.part.surplus == self.defect.fit.surplus
                && now.missing == self.defect.fit.missing
        };
        let needless = tried.filter(|&&e| of_part(self.trial.without_effort(e).fit()));
        let mechanism = self.trial.mechanism;
        let mut lines: Vec<String> =
            needless.map(|&e| effort_statement(mechanism, self.trial.efforts[e].source)).collect();
        // one statement may give two coordinates
        lines.dedup();
        lines
    }

    /// Pairs and efforts that together leave no condition too many in the part, where no single one does, and the number of
    /// freedoms that they make loose: as few as can be found one after another.
    pub(super) fn together(&self) -> Option<(Vec<String>, usize)> {
        let most = self.trial.most_tried(MOST_TRIED);
        let pairs = self.undriven_pairs().take(most).map(Statement::Pair);
        let mut left: Vec<Statement> =
            pairs.chain(self.part.efforts.iter().copied().map(Statement::Effort)).collect();
        let mut out = Vec::new();
        let mut now = self.defect.fit;
        while now.surplus + self.part.surplus > self.defect.fit.surplus {
            let without = |statement: Statement| {
                let all = out.iter().copied().chain([statement]).collect();
                self.trial.after(&Change::without_all(all)).fit
            };
            let fits = left.iter().map(|&statement| (without(statement), statement));
            let lesser = fits.filter(|f| f.0.surplus < now.surplus);
            let (fit, statement) = lesser.min_by_key(|f| (f.0.missing, f.0.surplus))?;
            out.push(statement);
            left.retain(|other| *other != statement);
            now = fit;
        }
        let texts = out.iter().map(|one| self.words(*one).1).collect();
        Some((texts, now.missing.saturating_sub(self.defect.fit.missing)))
    }

    /// Pairs without which the part has no condition too many, though something is made loose.
    pub(super) fn loosening(&self) -> Vec<(String, usize)> {
        let (part, defect) = (self.part, self.defect);
        let mut found = Vec::new();
        for pair in self.undriven_pairs().take(self.trial.most_tried(MOST_TRIED)) {
            let now = self.trial.after(&Change::without(Statement::Pair(pair))).fit;
            if now.surplus + part.surplus == defect.fit.surplus {
                found.push((
                    statement(self.trial.mechanism, pair),
                    now.missing.saturating_sub(defect.fit.missing),
                ));
            }
        }
        found.sort_by_key(|f| f.1);
        let least = found.first().map_or(0, |f| f.1);
        found.retain(|f| f.1 == least);
        found.truncate(MOST_NAMED);
        found
    }

    /// Two pairs of one kind of which each says what the other says.
    pub(super) fn repeated(&self) -> Option<[PairId; 2]> {
        let [(first, _), (second, _)] = self.part.pairs.as_slice() else { return None };
        let alike = |a: PairId, b: PairId| {
            let (a, b) = (&self.trial.mechanism.pair(a).kind, &self.trial.mechanism.pair(b).kind);
            a.statement() == b.statement()
        };
        let is_needless = |p: PairId| self.is_sound(&self.trial.after(&Change::without(Statement::Pair(p))));
        (self.part.efforts.is_empty()
            && alike(*first, *second)
            && is_needless(*first)
            && is_needless(*second))
        .then_some([*first, *second])
    }
}

pub(super) fn is_driven(trial: Trial<'_>, pair: PairId) -> bool {
    trial.efforts.iter().flat_map(Effort::places).any(|kind| match kind {
        EffortKind::RelativeAngle { joint, .. } | EffortKind::Coordinate(joint) => {
            trial.replaced.joint(joint).pair == pair
        }
        EffortKind::Angle(_) | EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => false,
    })
}

/// Whether a pair is a statement of its own that no transmission needs: none of a shaft or slider, no slide of a rack, and no pin
/// on which a wheel turns that runs.
pub(super) fn is_spare(mechanism: &Mechanism, pair: PairId) -> bool {
    let laws = mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Transmission(t) => Some(t),
        _ => None,
    });
    let terms = || laws.clone().flat_map(|t| &t.laws).map(|law| law.terms.as_slice());
    let is_slide = terms().flatten().any(|(rate, _)| *rate == Rate::Slide(pair));
    let turns = |term: Option<&(Rate, f64)>, link| term.is_some_and(|(rate, _)| *rate == Rate::Turn(link));
    let links = mechanism.pair(pair).kind.links();
    // the link on which both wheels of a law turn is its third term, or the ground
    let carries = |wheel: LinkId, law: &[(Rate, f64)]| {
        let is_wheel = law.iter().take(2).any(|term| turns(Some(term), wheel));
        let on = links.iter().any(|&link| match law.get(2) {
            None => link == LinkId::GROUND,
            carrier => turns(carrier, link),
        });
        is_wheel && on
    };
    let bears = |pin: &Pin| {
        let wheels = mechanism.wheels.iter().filter(|wheel| wheel.link == pin.link);
        wheels.into_iter().any(|wheel| wheel.centre == Some(pin.at))
            && terms().any(|law| carries(pin.link, law))
    };
    let borne = matches!(&mechanism.pair(pair).kind, PairKind::Revolute(pins) if pins.iter().any(bears));
    mechanism.pair(pair).bearing.is_none() && !is_slide && !borne
}

fn drives_link(trial: Trial<'_>, link: LinkId) -> bool {
    let body = trial.replaced.body_of(link);
    trial.efforts.iter().any(|e| e.bodies(trial.replaced).contains(&body))
}
