//! The pictures of a position, as figures.

use crate::course::Course;
use crate::document::Figure;
use crate::localised::drawing_in;
use crate::words::{Language, Message};
use assur_drawing::{Drawing, Theme};
use assur_picture::{Kind, Options, draw};

impl Course<'_> {
    /// The pictures of a kind, none where there is nothing to show.
    pub fn pictures(&self, kind: Kind, caption: Message, part: &str) -> Vec<Figure> {
        let drawings = self.drawings(kind);
        drawings.into_iter().map(|d| self.figure(d, kind.name().to_owned(), caption, part)).collect()
    }

    /// The scheme without anything that is found: loads against the motion show its sense, so that none is drawn with these.
    pub fn blank_scheme(&self) -> Vec<Figure> {
        let against = self.scene.mechanism().loads.iter().any(assur_model::model::Load::is_against_motion);
        let mut options = Options::default();
        if against {
            options.scheme.loads = assur_picture::Loads::None;
        }
        let Ok(drawings) = draw(Kind::Scheme, &self.scene, &options) else { return Vec::new() };
        let name = || Kind::Scheme.name().to_owned();
        let plain = |mut drawing: Drawing| {
            // titles and descriptions tell of the position
            drawing.title = self.caption(Message::SchemeAt, "");
            drawing.description = drawing.title.clone();
            self.figure(drawing, name(), Message::SchemeAt, "")
        };
        drawings.into_iter().map(plain).collect()
    }

    /// Free bodies and polygons, each with the labels of its links as its name.
    pub fn force_pictures(&self) -> Vec<Figure> {
        let of_links = |drawing: &Drawing| {
            let words = drawing.title.split_once("links ").map_or("", |(_, rest)| rest);
            let end = words.find(" freed").or_else(|| words.find(" at ")).or_else(|| words.find(':'));
            words[..end.unwrap_or(words.len())].to_owned()
        };
        self.drawings(Kind::Forces)
            .into_iter()
            .map(|drawing| {
                let links = of_links(&drawing);
                let freed = drawing.title.contains(" freed");
                let caption = if freed { Message::Freed } else { Message::Polygon };
                let labels: Vec<&str> = links.split(", ").collect();
                self.figure(drawing, labels.join(" "), caption, &links)
            })
            .collect()
    }

    fn drawings(&self, kind: Kind) -> Vec<Drawing> {
        if self.shown { draw(kind, &self.scene, &Options::default()).unwrap_or_default() } else { Vec::new() }
    }

    fn figure(&self, drawing: Drawing, name: String, caption: Message, part: &str) -> Figure {
        let mut drawing = drawing_in(self.language, self.scene.mechanism(), drawing);
        if self.language != Language::English {
            drawing.title = self.caption(caption, part);
        }
        Figure { svg: drawing.placed().svg(Theme::Auto), name, caption: self.caption(caption, part) }
    }
}
