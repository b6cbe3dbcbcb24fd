//! Which hinges stand at a point of a link, and which pairs guide a link.

use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairId, PairKind, Pin, Unsupported};
use assur_text::source::Span;
use indexmap::{IndexMap, IndexSet};

/// A point of a link as a key: equal for equal places.
pub(crate) type PlaceKey = (LinkId, [u64; 2]);

/// The hinges at each point of a link, and the prismatic pairs of each slider.
#[derive(Default)]
pub(crate) struct Hinges {
    at: IndexMap<PlaceKey, Vec<PairId>>,
    guided: IndexMap<LinkId, Vec<PairId>>,
}

impl Hinges {
    /// Enters the pins of a pair.
    pub(crate) fn enter(&mut self, kind: &PairKind, pair: PairId) {
        let (PairKind::Revolute(pins) | PairKind::Weld { pins, .. }) = kind else { return };
        for pin in pins {
            self.at.entry(place_key((pin.link, pin.at))).or_default().push(pair);
        }
    }

    /// Enters the slider of a pair.
    pub(crate) fn enter_guide(&mut self, kind: &PairKind, pair: PairId) {
        let PairKind::Prismatic(guide) = kind else { return };
        self.guided.entry(guide.slider).or_default().push(pair);
    }

    /// The prismatic pairs in which a link slides, in the order written.
    pub(crate) fn guided(&self, link: LinkId) -> &[PairId] {
        self.guided.get(&link).map_or(&[], Vec::as_slice)
    }

    /// The hinges that share a point with these pins, in the order written.
    pub(crate) fn near(&self, pins: &[Pin]) -> Vec<PairId> {
        let found = pins.iter().filter_map(|pin| self.at.get(&place_key((pin.link, pin.at))));
        let mut found = found.flatten().copied().collect::<Vec<_>>();
        found.sort_unstable();
        found.dedup();
        found
    }

    /// This point and all that pins join with it.
    pub fn joined_with(&self, mech: &Mechanism, point: (LinkId, Vec2)) -> Vec<(LinkId, Vec2)> {
        let mut joined = vec![point];
        let mut seen = IndexSet::from([place_key(point)]);
        let mut next = 0;
        while let Some(&at) = joined.get(next) {
            next += 1;
            for pair in self.at.get(&place_key(at)).into_iter().flatten() {
                let (PairKind::Revolute(pins) | PairKind::Weld { pins, .. }) = &mech.pair(*pair).kind else {
                    continue;
                };
                let new = pins.iter().map(|p| (p.link, p.at)).filter(|p| seen.insert(place_key(*p)));
                joined.extend(new);
            }
        }
        joined
    }
}

/// Adding zero makes one of both zeros.
pub(crate) fn place_key((link, at): (LinkId, Vec2)) -> PlaceKey {
    (link, [at.x, at.y].map(|x| (x + 0.0).to_bits()))
}

// The mechanism that is being made.

/// The mechanism that is being made, with what is looked up in it.
#[derive(Default)]
pub struct Builder {
    /// The mechanism so far. Every link is in it (name, number, span; ground first) as soon as the names are declared, so
    /// that link ids are known from the start. All other tables are filled in the order of the file; what has an error is
    /// left out.
    pub mech: Mechanism,
    /// The hinges at each point.
    pub hinges: Hinges,
    /// Links whose axial force is asked for, and where.
    pub axial: Vec<(LinkId, Span)>,
    /// Links inside which forces are asked for.
    pub inside: Vec<Inside>,
}

/// A link inside which forces are asked for, and the place of the cut where one is written.
pub struct Inside {
    pub link: LinkId,
    pub span: Span,
    pub cut: Option<(f64, Span)>,
}

impl Builder {
    /// Notes a construct that is understood but cannot be solved yet.
    pub fn unsupported(&mut self, what: impl Into<String>, span: Span) {
        let noted = Unsupported { what: what.into(), span };
        let again = self.mech.unsupported.iter().any(|u| u.span == span && u.what == noted.what);
        if !again {
            self.mech.unsupported.push(noted);
        }
    }

    /// This point and all that pins join with it.
    pub fn joined_with(&self, point: (LinkId, Vec2)) -> Vec<(LinkId, Vec2)> {
        self.hinges.joined_with(&self.mech, point)
    }
}
