//! A drawing while it is made, and the sheet that comes of it.

use crate::geometry::Rect;
use crate::label::Label;
use crate::mark::{Mark, Shape};
use crate::outside;
use crate::placement::{self, Later};
use crate::style::Style;
use crate::text::Text;
use crate::wrap::wrapped;
use assur_math::math::Vec2;

/// White around the drawing, mm.
const MARGIN: f64 = 3.0;
/// From the drawing to the first line below it, and from line to line.
const ABOVE: f64 = 7.5;
const LINE: f64 = 6.0;
/// Lines below a narrower drawing are so long, mm.
const NARROWEST: f64 = 70.0;
/// From a text to the bar behind it.
const GAP: f64 = 4.0;
/// Size of letters below the drawing.
pub(crate) const CAPTION: f64 = 4.0;

/// Marks that belong together: those of a link, of a pair, of a vector.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Group {
    pub class: &'static str,
    pub name: String,
}

/// A line below the drawing.
#[derive(Clone, Debug, PartialEq)]
pub struct Caption {
    pub text: Text,
    /// A bar of a length, mm, and what it stands for.
    pub bar: Option<(f64, Text)>,
}

/// A drawing that is being made.
#[derive(Clone, Debug, Default)]
pub struct Drawing {
    /// The begin of the ids in the document.
    pub id: String,
    /// What it shows, in a few words.
    pub title: String,
    /// What it shows, in sentences with the main numbers.
    pub description: String,
    /// Groups of marks; the first is of those that belong to none.
    pub groups: Vec<Group>,
    /// The marks, the first at the back.
    pub marks: Vec<Mark>,
    /// Labels that look for a place.
    pub labels: Vec<Label>,
    pub captions: Vec<Caption>,
    /// What the sheet has room for beside the marks, where they move.
    pub room: Option<Rect>,
    /// The group of the next marks.
    current: usize,
}

/// A label in its place.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    pub label: Label,
    pub bounds: Rect,
    /// The line to what it is about, where that is far.
    pub leader: Option<(Vec2, Vec2)>,
}

/// A drawing whose labels have their places.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// All but the places of labels.
    pub drawing: Drawing,
    pub placed: Vec<Placed>,
    /// All of it, with white around.
    pub bounds: Rect,
    /// Where the lines below begin.
    pub lines: Vec<Vec2>,
    /// Classes of marks and of labels that a script moves, by their places in the lists; none where nothing moves.
    pub moved: [Vec<Option<String>>; 2],
}

impl Drawing {
    #[must_use]
    pub fn new(id: &str, title: String, description: String) -> Self {
        let none = Group { class: "", name: String::new() };
        let id = id.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        Self { id, title, description, groups: vec![none], ..Self::default() }
    }

    /// The next marks and labels belong to this.
    pub fn begin(&mut self, class: &'static str, name: &str) {
        self.current = self.groups.len();
        self.groups.push(Group { class, name: name.to_owned() });
    }

    /// The next marks and labels belong to nothing.
    pub const fn end(&mut self) {
        self.current = 0;
    }

    pub fn mark(&mut self, style: Style, shape: Shape) {
        self.marks.push(Mark { shape, style, group: self.current });
    }

    pub fn line(&mut self, style: Style, from: Vec2, to: Vec2) {
        self.mark(style, Shape::Line(from, to));
    }

    pub fn label(&mut self, label: Label) {
        self.labels.push(Label { group: self.current, ..label });
    }

    /// Adds a line below.
    pub fn caption(&mut self, text: Text) {
        self.captions.push(Caption { text, bar: None });
    }

    /// The box of all marks.
    #[must_use]
    pub fn extent(&self) -> Rect {
        self.extent_of(self.marks.iter().map(|mark| mark.shape.bounds()))
    }

    /// The same from the boxes of all marks without the widths of their strokes.
    fn extent_of(&self, boxes: impl Iterator<Item = Rect>) -> Rect {
        let mut all = self.room.unwrap_or(Rect::NOTHING);
        self.marks.iter().zip(boxes).for_each(|(mark, own)| all.join(&own.grown(mark.style.half_width())));
        all
    }

    /// Finds a place for every label; none is left out.
    #[must_use]
    pub fn placed(self) -> Sheet {
        self.placed_through(&[])
    }

    /// The same where marks move: labels keep their distance to what they are about, and are where they are best in all
    /// frames.
    #[must_use]
    pub fn placed_through(mut self, later: &[Later]) -> Sheet {
        let boxes: Vec<Rect> = self.marks.iter().map(|mark| mark.shape.bounds()).collect();
        let found = placement::place((&self.marks, &boxes), &self.labels, later);
        let mut bounds = self.extent_of(boxes.into_iter());
        for frame in later {
            let boxes = found.iter().zip(&frame.shifts).filter_map(|(b, by)| Some(b.as_ref()?.shifted(*by)));
            boxes.for_each(|b| bounds.join(&b));
        }
        found.iter().flatten().for_each(|b| bounds.join(b));
        if bounds.is_nothing() {
            bounds = Rect { min: Vec2::zero(), max: Vec2::zero() };
        }
        let left: Vec<usize> = (0..found.len()).filter(|i| found[*i].is_none()).collect();
        let mut places: Vec<_> = found.into_iter().map(|b| (b, None)).collect();
        for out in outside::place(&bounds.grown(placement::APART), &self.labels, &left) {
            places[out.label] = (Some(out.bounds), Some(out.leader));
        }
        let labels = std::mem::take(&mut self.labels);
        let placed: Vec<Placed> = labels
            .into_iter()
            .zip(places)
            .filter_map(|(label, (bounds, leader))| Some(Placed { label, bounds: bounds?, leader }))
            .collect();
        placed.iter().for_each(|p| bounds.join(&p.bounds));
        let left = bounds.min.x;
        let width = bounds.size().x.max(NARROWEST);
        self.captions =
            std::mem::take(&mut self.captions).into_iter().flat_map(|c| c.wrapped(width)).collect();
        let mut lines = Vec::with_capacity(self.captions.len());
        let mut y = bounds.max.y + ABOVE;
        for caption in &self.captions {
            lines.push(Vec2::new(left, y));
            bounds.add(Vec2::new(left + caption.width(), y + 0.3 * CAPTION));
            y += LINE;
        }
        Sheet { drawing: self, placed, bounds: bounds.grown(MARGIN), lines, moved: Default::default() }
    }
}

impl Caption {
    /// Its lines; one with a bar is one.
    fn wrapped(self, width: f64) -> Vec<Self> {
        if self.bar.is_some() {
            return vec![self];
        }
        wrapped(&self.text, CAPTION, width).into_iter().map(|text| Self { text, bar: None }).collect()
    }

    /// Where its bar begins, after the begin of the line.
    pub(crate) fn bar_at(&self) -> f64 {
        self.text.bounds(CAPTION).max.x + GAP
    }

    /// Where the text behind the bar begins.
    pub(crate) fn behind(&self) -> f64 {
        self.bar_at() + self.bar.as_ref().map_or(0.0, |(length, _)| length + 2.0)
    }

    fn width(&self) -> f64 {
        match &self.bar {
            Some((_, text)) => self.behind() + text.bounds(CAPTION).max.x,
            None => self.text.bounds(CAPTION).max.x,
        }
    }
}
