//! Where names are used, each with the declaration that it leads to.

use crate::names::declared::Names;
use assur_model::model::LinkId;
use assur_syntax::document::{Name, Path};
use assur_text::source::Span;
use indexmap::IndexSet;

/// A use of a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Use {
    /// Where the name is used; brackets around it may be part of it.
    pub at: Span,
    /// Where it is declared. A use may lead to several declarations: `B` in `revolute B: crank - rod` to both points.
    pub of: Span,
}

/// The uses that were seen, if somebody asks for them.
#[derive(Debug, Default)]
pub struct Uses {
    seen: Option<IndexSet<Use>>,
}

impl Uses {
    /// From now on all uses are kept.
    pub fn keep(&mut self) {
        self.seen = Some(IndexSet::new());
    }

    /// The number of uses kept.
    pub fn len(&self) -> usize {
        self.seen.as_ref().map_or(0, IndexSet::len)
    }

    /// Forgets those after the first ones: they were only tried.
    pub fn truncate(&mut self, len: usize) {
        if let Some(seen) = &mut self.seen {
            seen.truncate(len);
        }
    }

    /// All uses, in the order of the text.
    pub fn into_sorted(self) -> Vec<Use> {
        let mut all = self.seen.into_iter().flatten().collect::<Vec<_>>();
        all.sort_unstable();
        all
    }
}

impl Names<'_> {
    fn note(&mut self, name: &Name, of: impl FnOnce(&Self) -> Option<Span>) {
        // rows of variants are checked without
        if self.uses.seen.is_none() {
            return;
        }
        let of = of(self);
        if let (Some(seen), Some(of)) = (&mut self.uses.seen, of) {
            seen.insert(Use { at: name.span, of });
        }
    }

    /// Notes the use of a link, a pair or an element; of nothing else.
    pub fn note_thing(&mut self, name: &Name) {
        self.note(name, |names| {
            let ground = if name.node == "ground" { names.ground } else { None };
            names.things.get(&name.node).map(|d| d.span).or(ground)
        });
    }

    /// Notes the use of a quantity.
    pub fn note_quantity(&mut self, name: &Name) {
        self.note(name, |names| names.quantities.get(&name.node).map(|d| d.span));
    }

    /// Notes the use of a pose.
    pub fn note_pose(&mut self, name: &Name) {
        self.note(name, |names| names.poses.get(&name.node).copied());
    }

    /// Notes the use of an event.
    pub fn note_event(&mut self, name: &Name) {
        self.note(name, |names| names.events.get(&name.node).copied());
    }

    /// Notes the use of a part of a link: a point, a line or a circle.
    pub fn note_inside(&mut self, link: LinkId, name: &Name) {
        self.note(name, |names| {
            let inside = names.inside.get(link.index())?;
            let lists = [&inside.points, &inside.lines, &inside.circles];
            lists.iter().find_map(|list| list.get(&name.node)).copied()
        });
    }

    /// Notes the use of a thing, or of a part of a link.
    pub fn note_path(&mut self, path: &Path) {
        self.note_thing(&path.head);
        if let (Some(tail), Some(&link)) = (&path.tail, self.links.get(&path.head.node)) {
            self.note_inside(link, tail);
        }
    }

    /// Notes the use of all points of a name.
    pub fn note_points(&mut self, name: &Name) {
        if self.uses.seen.is_none() {
            return;
        }
        for link in self.bearers.get(&name.node).cloned().unwrap_or_default() {
            self.note_inside(link, name);
        }
    }
}
