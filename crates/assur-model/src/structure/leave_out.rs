//! What to leave out of an overconstrained part: each change tried before a help speaks of it.

use super::defect::{Defect, Fit, Part};
use super::effort::{Effort, EffortKind, EffortSource};
use super::incidence::Incidence;
use super::joint::{BodyId, BodyOrigin, Replaced};
use super::roller::listed;
use super::trial::Trial;
use crate::model::{LinkId, Mechanism, PairId, PairKind};

/// Changes tried of each sort.
const MOST_TRIED: usize = 48;
const MOST_NAMED: usize = 12;

/// A change after which the part is sound.
pub(super) struct Change {
    /// As a help says it: `` `slot E` ``.
    pub text: String,
    /// Links that no drive moves any more.
    pub unmoved: usize,
}

/// The changes that make a part sound, each by itself, those that keep most links moving first.
pub(super) struct Changes {
    pub pairs: Vec<Change>,
    /// Prismatic pairs by name that may be slots, with the statement of the slot.
    pub slots: Vec<(String, String)>,
    /// Links with their pairs.
    pub links: Vec<String>,
    /// Drives or unknown efforts.
    pub efforts: Vec<String>,
}

/// The links of a list of bodies.
pub(super) fn links<'a>(replaced: &'a Replaced, bodies: &'a [BodyId]) -> impl Iterator<Item = LinkId> + 'a {
    bodies.iter().filter_map(|b| match replaced.bodies[b.0].origin {
        BodyOrigin::Link(id) => Some(id),
        BodyOrigin::Imaginary(_) => None,
    })
}

/// A pair as its statement begins: `slot E`.
pub(super) fn statement(mechanism: &Mechanism, pair: PairId) -> String {
    let pair = mechanism.pair(pair);
    format!("`{} {}`", pair.kind.word(), pair.name)
}

/// An effort as its statement begins: `drive crank`, `start crank`, `balance Mb`.
fn effort_statement(mechanism: &Mechanism, source: EffortSource) -> String {
    match source {
        EffortSource::Drive(id) => {
            let drive = &mechanism.drives[id.index()];
            format!("`{} {}`", if drive.free { "start" } else { "drive" }, drive.written_name())
        }
        EffortSource::Balance(id) => format!("`balance {}`", mechanism.balances[id.index()].name),
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
    pub(super) fn changes(&self) -> Changes {
        Changes { pairs: self.pairs(), slots: self.slots(), links: self.links(), efforts: self.efforts() }
    }

    /// The part has no condition too many any more, and nothing is made loose; or all is determined.
    fn is_sound(&self, now: Fit) -> bool {
        let of_part = now.surplus + self.part.surplus == self.defect.fit.surplus;
        now == Fit::default() || of_part && now.missing == self.defect.fit.missing
    }

    fn undriven_pairs(&self) -> impl Iterator<Item = PairId> + '_ {
        let pairs = self.part.pairs.iter().map(|p| p.0);
        pairs.filter(|&p| !is_driven(self.trial, p)).take(self.trial.most_tried(MOST_TRIED))
    }

    fn pairs(&self) -> Vec<Change> {
        let mut found = Vec::new();
        for pair in self.undriven_pairs() {
            let mut offer = |now: Incidence, text: String| {
                if self.is_sound(now.fit()) {
                    found.push(Change { text, unmoved: now.unmoved().len() });
                }
            };
            let text = statement(self.trial.mechanism, pair);
            offer(self.trial.without(&[pair], &[]), text.clone());
            if let PairKind::Revolute(pins) = &self.trial.mechanism.pair(pair).kind
                && pins.len() > 2
            {
                for pin in
                    pins.iter().filter(|p| self.part.bodies.contains(&self.trial.replaced.body_of(p.link)))
                {
                    let name = &self.trial.mechanism.link(pin.link).name;
                    offer(self.trial.without_member(pair, pin.link), format!("`{name}` in {text}"));
                }
            }
        }
        found.sort_by_key(|c| c.unmoved);
        found.truncate(MOST_NAMED);
        found
    }

    fn slots(&self) -> Vec<(String, String)> {
        let mechanism = self.trial.mechanism;
        let slot = |p: PairId| {
            let pair = mechanism.pair(p);
            let PairKind::Prismatic(g) = &pair.kind else { return None };
            let (slider, base) = (&mechanism.link(g.slider).name, &mechanism.link(g.guide).name);
            let line = format!("slot {}: {slider}.{} - {base}.{}", pair.name, g.point_name, g.line_name);
            let fits = || self.trial.as_slot(p).is_some_and(|now| self.is_sound(now.fit()));
            (!g.point_name.is_empty() && fits()).then(|| (pair.name.clone(), line))
        };
        self.undriven_pairs().filter_map(slot).collect()
    }

    /// Links without loads first: what acts on a link goes with it.
    fn links(&self) -> Vec<String> {
        let mechanism = self.trial.mechanism;
        let bodies = self.part.bodies.iter();
        let tried = bodies
            .flat_map(|body| self.trial.replaced.links_of(*body))
            .filter(|l| *l != LinkId::GROUND)
            .take(self.trial.most_tried(MOST_TRIED))
            .filter(|&l| !drives_link(self.trial, l))
            .filter(|&l| self.is_sound(self.trial.without_links(&[l]).fit()));
        let mut links: Vec<LinkId> = tried.collect();
        links.sort_by_key(|l| mechanism.loads.iter().filter(|load| load.link() == Some(*l)).count());
        links.iter().take(MOST_NAMED).map(|l| format!("`{}`", mechanism.link(*l).name)).collect()
    }

    pub(super) fn efforts(&self) -> Vec<String> {
        let tried = self.part.efforts.iter().take(self.trial.most_tried(MOST_TRIED));
        let needless = tried.filter(|&&e| self.is_sound(self.trial.without(&[], &[e]).fit()));
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
        let mechanism = self.trial.mechanism;
        let (mut pairs, mut efforts, mut texts) = (Vec::new(), Vec::new(), Vec::new());
        let mut now = self.defect.fit;
        while now.surplus + self.part.surplus > self.defect.fit.surplus {
            let of_pair = self.undriven_pairs().filter(|p| !pairs.contains(p)).map(|p| (Some(p), None));
            let of_effort =
                self.part.efforts.iter().filter(|e| !efforts.contains(*e)).map(|&e| (None, Some(e)));
            let fits = of_pair.chain(of_effort).map(|(pair, effort)| {
                let with_pair: Vec<PairId> = pairs.iter().copied().chain(pair).collect();
                let with_effort: Vec<usize> = efforts.iter().copied().chain(effort).collect();
                (self.trial.without(&with_pair, &with_effort).fit(), pair, effort)
            });
            let lesser = fits.filter(|f| f.0.surplus < now.surplus);
            let (fit, pair, effort) = lesser.min_by_key(|f| (f.0.missing, f.0.surplus))?;
            texts.extend(pair.map(|p| statement(mechanism, p)));
            texts.extend(effort.map(|e| effort_statement(mechanism, self.trial.efforts[e].source)));
            pairs.extend(pair);
            efforts.extend(effort);
            now = fit;
        }
        Some((texts, now.missing.saturating_sub(self.defect.fit.missing)))
    }

    /// Pairs without which the part has no condition too many, though something is made loose.
    pub(super) fn loosening(&self) -> Vec<(String, usize)> {
        let (part, defect) = (self.part, self.defect);
        let mut found = Vec::new();
        for pair in self.undriven_pairs() {
            let now = self.trial.without(&[pair], &[]).fit();
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
        let is_needless = |p: PairId| self.is_sound(self.trial.without(&[p], &[]).fit());
        (self.part.efforts.is_empty()
            && alike(*first, *second)
            && is_needless(*first)
            && is_needless(*second))
        .then_some([*first, *second])
    }
}

fn is_driven(trial: Trial<'_>, pair: PairId) -> bool {
    trial.efforts.iter().flat_map(Effort::places).any(|kind| match kind {
        EffortKind::RelativeAngle { joint, .. } | EffortKind::Coordinate(joint) => {
            trial.replaced.joint(joint).pair == pair
        }
        EffortKind::Angle(_) | EffortKind::Line(_) | EffortKind::Point(_) | EffortKind::Place(..) => false,
    })
}

fn drives_link(trial: Trial<'_>, link: LinkId) -> bool {
    let body = trial.replaced.body_of(link);
    trial.efforts.iter().any(|e| e.bodies(trial.replaced).contains(&body))
}

pub(super) fn pairs_of(mechanism: &Mechanism, link: LinkId) -> Vec<PairId> {
    let pairs = mechanism.pairs.iter().enumerate();
    pairs.filter(|(_, p)| p.kind.links().contains(&link)).map(|(i, _)| PairId::at(i)).collect()
}

/// `` `a`, `b` or `c` ``
pub(super) fn one_of(items: &[String]) -> String {
    listed(items, "or")
}
