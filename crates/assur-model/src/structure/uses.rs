//! How many pairs use the points, lines and circles of links.

use crate::model::{LinkId, Mechanism, PairId, PairKind, Point};
use std::collections::HashMap;

/// How many pairs use a point, line or circle of a link.
pub(super) struct Uses<'a> {
    mechanism: &'a Mechanism,
    counts: HashMap<(LinkId, &'a str), usize>,
}

impl<'a> Uses<'a> {
    /// Of all pairs, without the one that `but` names.
    pub(super) fn of(mechanism: &'a Mechanism, but: Option<PairId>) -> Self {
        let mut this = Self { mechanism, counts: HashMap::new() };
        for (i, pair) in mechanism.pairs.iter().enumerate() {
            match &pair.kind {
                _ if but == Some(PairId::at(i)) => {}
                PairKind::Revolute(pins) | PairKind::Weld { pins, .. } => {
                    pins.iter().for_each(|p| this.add(p.link, &p.name))
                }
                PairKind::Prismatic(g) | PairKind::Slot(g) => {
                    this.add(g.guide, &g.line_name);
                    this.add(g.slider, &g.point_name);
                    let lines = mechanism.link(g.slider).lines.iter();
                    let own = lines.filter(|l| l.through == g.point && l.along == g.direction);
                    own.for_each(|l| this.add(g.slider, &l.name));
                }
                PairKind::Contact { first, second, .. } => {
                    [first, second].iter().for_each(|f| this.add(f.link, &f.name));
                }
                PairKind::Cylinder { from, to, .. } => {
                    [from, to].iter().for_each(|p| this.add(p.link, &p.name));
                }
                PairKind::Transmission(_) => {}
            }
        }
        this
    }

    fn add(&mut self, link: LinkId, name: &'a str) {
        *self.counts.entry((link, name)).or_default() += 1;
    }

    pub(super) fn points(&self, link: LinkId) -> &'a [Point] {
        &self.mechanism.link(link).points
    }

    pub(super) fn count(&self, link: LinkId, name: &str) -> usize {
        self.counts.get(&(link, name)).copied().unwrap_or(0)
    }

    /// How many use the lines that begin at a point.
    pub(super) fn of_lines(&self, link: LinkId, point: &Point) -> usize {
        let lines = self.mechanism.link(link).lines.iter().filter(|l| l.through == point.at);
        lines.map(|l| self.count(link, &l.name)).sum()
    }
}
