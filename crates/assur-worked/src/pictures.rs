//! The pictures of a position, as figures.

use crate::course::Derivation;
use crate::document::Figure;
use crate::localised::drawing_in;
use crate::words::{Language, Message};
use assur_drawing::{Drawing, Theme};
use assur_math::math::Vec2;
use assur_model::model::{Display, FindKind, Mechanism};
use assur_picture::{Kind, Options, Subject, draw};

/// What A4 has between the margins, mm.
const PAPER: f64 = 182.0;
/// What a mechanism takes on a sheet, mm: the rest of the page is for the problem.
const SHEET: Vec2 = Vec2 { x: 176.0, y: 66.0 };
/// How tall a plot may be, mm: a page takes it with letters of 7 points.
const TALLEST: f64 = 180.0;
/// How often a picture is drawn with less space, and how much less than what it seems to need.
const TRIES: u8 = 4;
const LESS: f64 = 0.96;

impl Derivation<'_> {
    /// The pictures of a kind, none where there is nothing to show.
    pub fn pictures(&self, kind: Kind, caption: Message, part: &str) -> Vec<Figure> {
        let drawings = self.drawings(kind, 1.0).into_iter().enumerate();
        let figure = |(i, drawing)| self.figure(drawing, (kind, i), kind.name().to_owned(), caption, part);
        drawings.map(figure).collect()
    }

    /// The scheme of a sheet, with unknown efforts in their positive sense; with loads against the motion where its sense is no question.
    pub fn blank_scheme(&self, with_senses: bool) -> Vec<Figure> {
        let mut options = Options::default();
        options.scheme.against_motion = with_senses;
        options.scheme.size = SHEET;
        let size = options.scheme.size;
        let mut made = |smaller: f64| {
            (options.scheme.size, options.scheme.grows) = (size * smaller, smaller >= 1.0);
            let mut drawing = draw(Kind::Scheme, &self.scene, &options).ok()?.into_iter().next()?;
            // titles and descriptions tell of the position
            drawing.title = self.caption(Message::SchemeAt, "");
            drawing.description = drawing.title.clone();
            Some(drawing)
        };
        let Some(drawing) = made(1.0) else { return Vec::new() };
        vec![self.placed(drawing, &mut made, Kind::Scheme.name().to_owned(), Message::SchemeAt, "")]
    }

    /// Free bodies and polygons, each with the labels of its links as its name.
    pub fn force_pictures(&self) -> Vec<Figure> {
        let of_links = |drawing: &Drawing| {
            let words = drawing.title.split_once("links ").map_or("", |(_, rest)| rest);
            let end = words.find(" freed").or_else(|| words.find(" at ")).or_else(|| words.find(':'));
            words[..end.unwrap_or(words.len())].to_owned()
        };
        self.drawings(Kind::Forces, 1.0)
            .into_iter()
            .enumerate()
            .map(|(i, drawing)| {
                let links = of_links(&drawing);
                let freed = drawing.title.contains(" freed");
                let caption = if freed { Message::Freed } else { Message::Polygon };
                let labels: Vec<&str> = links.split(", ").collect();
                self.figure(drawing, (Kind::Forces, i), labels.join(" "), caption, &links)
            })
            .collect()
    }

    /// Those of a kind, smaller by a factor than usual.
    fn drawings(&self, kind: Kind, smaller: f64) -> Vec<Drawing> {
        let mut options = Options::default();
        options.scheme.size = options.scheme.size * smaller;
        options.scheme.grows = smaller >= 1.0;
        drawn_for_paper(kind, Subject::from(&self.scene), &options)
    }

    fn figure(
        &self,
        drawing: Drawing,
        (kind, index): (Kind, usize),
        name: String,
        caption: Message,
        part: &str,
    ) -> Figure {
        let mut again = |smaller: f64| self.drawings(kind, smaller).into_iter().nth(index);
        self.placed(drawing, &mut again, name, caption, part)
    }

    /// With its labels in their places; what they make wider than paper is drawn again with less space.
    fn placed(
        &self,
        drawing: Drawing,
        again: &mut dyn FnMut(f64) -> Option<Drawing>,
        name: String,
        caption: Message,
        part: &str,
    ) -> Figure {
        let place = |drawing: Drawing| {
            let mut drawing = drawing_in(self.language, self.scene.mechanism(), drawing);
            if self.language != Language::English {
                drawing.title = self.caption(caption, part);
            }
            drawing.placed()
        };
        let mut sheet = place(drawing);
        let mut smaller = 1.0;
        for _ in 0..TRIES {
            let wide = sheet.bounds.size().x;
            if wide <= PAPER {
                break;
            }
            smaller *= LESS * PAPER / wide;
            let Some(next) = again(smaller) else { break };
            sheet = place(next);
        }
        Figure { svg: sheet.svg(Theme::Auto), name, caption: self.caption(caption, part) }
    }
}

/// The pictures of a kind, none where there is nothing to show; of plots as many as paper needs.
#[must_use]
pub fn drawn_for_paper(kind: Kind, subject: Subject<'_, '_>, options: &Options) -> Vec<Drawing> {
    match kind {
        Kind::Plot => {
            let mut drawings = plots(subject, &plotted(subject.mechanism), options);
            for (i, drawing) in drawings.iter_mut().enumerate().skip(1) {
                drawing.id += &format!("-{}", i + 1);
            }
            drawings
        }
        _ => draw(kind, subject, options).unwrap_or_default(),
    }
}

/// The items of `find` with numbers, those of a panel together.
fn plotted(mechanism: &Mechanism) -> Vec<usize> {
    let numbers = mechanism.finds.iter().enumerate().filter_map(|(i, find)| match &find.kind {
        FindKind::Value { display, poseless: false, .. } => Some((i, display)),
        _ => None,
    });
    let numbers: Vec<(usize, &Display)> = numbers.collect();
    let panel = |(_, of): &(usize, &Display)| {
        numbers.iter().position(|(_, d)| (&d.unit, d.dimension) == (&of.unit, of.dimension))
    };
    let mut ordered = numbers.clone();
    ordered.sort_by_key(panel);
    ordered.into_iter().map(|(i, _)| i).collect()
}

/// A plot, or several where it would be too tall for paper.
fn plots(subject: Subject<'_, '_>, items: &[usize], options: &Options) -> Vec<Drawing> {
    let options = Options { plotted: items.to_vec(), ..options.clone() };
    let drawn = draw(Kind::Plot, subject, &options).unwrap_or_default();
    let is_tall = |drawing: &Drawing| drawing.clone().placed().bounds.size().y > TALLEST;
    if items.len() < 2 || !drawn.iter().any(is_tall) {
        return drawn;
    }
    let (first, rest) = items.split_at(items.len().div_ceil(2));
    [plots(subject, first, &options), plots(subject, rest, &options)].concat()
}
