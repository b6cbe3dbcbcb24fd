//! Where pictures go: standard output, one file, one page with all, or files in a folder.

use super::pages::Page;
use super::{fitting, one_only};
use crate::cli::args::{Draw, DrawFormat, Picture};
use crate::cli::error::CliError;
use crate::cli::files::made_folder;
use crate::cli::sink::Sink;
use crate::cli::stop::count_written;
use assur_drawing::{Sheet, Theme, escaped, page_rules};
use assur_picture::Kind;
use assur_worked::{Language, phrase};
use std::borrow::Cow;
use std::cell::RefCell;
use std::path::PathBuf;

pub enum Output {
    /// Standard output: one picture.
    Stdout(Option<DrawFormat>),
    /// One file: one picture.
    File(PathBuf),
    /// One page with all pictures, until it is written: a file, or standard output.
    Page(Option<PathBuf>, RefCell<Gallery>),
    /// Files in a folder.
    Folder(PathBuf, Option<DrawFormat>),
}

impl Output {
    /// What `-o` names, in a format; a name that ends as a format does is a file, any other a folder.
    pub fn of(args: &Draw, pictures: &[Picture], one: bool) -> Result<Self, CliError> {
        let wanted = args.format;
        let animation = matches!(pictures, [picture] if picture.kind == Kind::Animation);
        let named = args.out.as_deref().filter(|name| *name != "-");
        let ending = named.and_then(DrawFormat::of_ending);
        let format = wanted.or(ending);
        let page = || RefCell::new(Gallery::default());
        let place = named.unwrap_or("standard output");
        if let (Some(name), Some(wanted)) = (named, wanted)
            && ending.map_or(wanted == DrawFormat::Html, |ending| ending != wanted)
        {
            return Err(CliError::OtherFormat { name: name.to_owned(), ending: wanted.ending() });
        }
        if let Some(feature) = format.and_then(DrawFormat::missing_feature) {
            return Err(CliError::NotInBuild { name: place.to_owned(), feature });
        }
        if let Some(error) = format.and_then(|format| fitting::no_film(format, place, args, pictures)) {
            return Err(error);
        }
        match (named.map(PathBuf::from), format) {
            (path, Some(DrawFormat::Html)) if !(one && animation) => Ok(Self::Page(path, page())),
            (None, format) if one => Ok(Self::Stdout(format)),
            (Some(path), format) if ending.is_none() => Ok(Self::Folder(path, format)),
            (Some(path), _) if one => Ok(Self::File(path)),
            (_, format) => Err(one_only(place, format)),
        }
    }

    /// Its format, where it is known.
    pub fn format(&self) -> Option<DrawFormat> {
        match self {
            Self::Stdout(format) | Self::Folder(_, format) => *format,
            Self::File(path) => DrawFormat::of_ending(&path.to_string_lossy()),
            Self::Page(..) => Some(DrawFormat::Html),
        }
    }

    /// Whether it is one picture, in which an animation needs no script.
    pub fn is_picture(&self) -> bool {
        self.format() == Some(DrawFormat::Svg)
    }

    /// Whether nothing moves in it: a page of all pictures, pixels, a drawing for another program.
    pub fn is_still(&self) -> bool {
        matches!(self, Self::Page(..))
            || !matches!(self.format(), None | Some(DrawFormat::Svg | DrawFormat::Html))
    }

    /// A sheet in its format, and the ending of its file; pixels are made of SVG.
    pub fn text(&self, sheet: &Sheet, theme: Theme) -> (String, &'static str) {
        match self.format() {
            None | Some(DrawFormat::Svg) => (sheet.svg(theme), "svg"),
            Some(DrawFormat::Png) => (sheet.svg(theme), "png"),
            Some(DrawFormat::Pdf) => (sheet.svg(theme), "pdf"),
            Some(DrawFormat::Gif) => (sheet.svg(theme), "gif"),
            Some(DrawFormat::Apng) => (sheet.svg(theme), "apng"),
            Some(DrawFormat::Html) => (figure(sheet), "html"),
            Some(DrawFormat::Dxf) => (sheet.dxf(), "dxf"),
            Some(DrawFormat::Tikz) => (sheet.tikz(theme), "tikz"),
            Some(DrawFormat::Tex) => (sheet.tex(theme), "tex"),
        }
    }

    /// The first option that changes nothing in this format.
    pub fn without_effect(&self, args: &Draw) -> Option<CliError> {
        fitting::without_effect(self.format(), args)
    }

    /// Whether it holds one picture.
    pub const fn is_single(&self) -> bool {
        matches!(self, Self::Stdout(_) | Self::File(..))
    }

    /// Writes pictures; what goes to standard output as text is given back.
    pub fn write(&self, pages: &[Page], args: &Draw) -> Result<String, CliError> {
        match self {
            _ if pages.is_empty() => Ok(String::new()),
            Self::Stdout(_) => match pages {
                [page] if self.format().is_some_and(DrawFormat::is_binary) => {
                    let mut sink = Sink::stdout();
                    sink.write(&self.bytes(page, args, "standard output")?)?;
                    sink.finish().map(|_| String::new())
                }
                [page] => Ok(page.text.clone()),
                _ => Err(one_only("standard output", self.format())),
            },
            Self::File(path) => match pages {
                [page] => {
                    let bytes = self.bytes(page, args, &path.display().to_string())?;
                    written(Sink::page(path)?, &bytes).map(|()| String::new())
                }
                _ => Err(one_only(&path.display().to_string(), self.format())),
            },
            Self::Page(_, body) => {
                body.borrow_mut().add(pages);
                Ok(String::new())
            }
            Self::Folder(folder, _) => {
                made_folder(folder)?;
                for page in pages {
                    let path = folder.join(format!("{}.{}", page.name, page.ending));
                    let bytes = self.bytes(page, args, &path.display().to_string())?;
                    written(Sink::made_up(&path)?, &bytes)?;
                }
                Ok(String::new())
            }
        }
    }

    /// A picture as it is written.
    #[cfg_attr(
        not(feature = "gif"),
        allow(
            clippy::unnecessary_wraps,
            unused_variables,
            reason = "builds with features draw pixels, which may fail"
        )
    )]
    fn bytes<'p>(&self, page: &'p Page, args: &Draw, name: &str) -> Result<Cow<'p, [u8]>, CliError> {
        #[cfg(feature = "gif")]
        if let Some(show) = super::film::Show::of(page, args, name) {
            let is_gif = self.format() == Some(DrawFormat::Gif);
            return if is_gif { super::gif::gif(&show) } else { super::apng::apng(&show) }.map(Cow::Owned);
        }
        match self.format() {
            #[cfg(feature = "png")]
            Some(DrawFormat::Png) => super::png::png(&page.text, name).map(Cow::Owned),
            #[cfg(feature = "pdf")]
            Some(DrawFormat::Pdf) => super::pdf::pdf(&page.text, name).map(Cow::Owned),
            _ => Ok(Cow::Borrowed(page.text.as_bytes())),
        }
    }

    /// Writes the page in a language, where there is one with pictures.
    pub fn finish(&self, language: Language, theme: Theme, all: bool) -> Result<(), CliError> {
        let Self::Page(path, body) = self else { return Ok(()) };
        let body = body.borrow();
        if body.chapters.is_empty() {
            return Ok(());
        }
        let (code, title) = (language.code(), phrase(language, "Pictures"));
        let body = body.html(&title);
        let page = format!(
            "<!doctype html>\n<html lang=\"{code}\">\n{HEAD}<title>{title}</title>\n<style>\n{}{STYLE}{}</style>\n</head>\n<body>\n{body}{FOOT}",
            paper(theme),
            page_rules(theme)
        );
        let mut sink = path.as_deref().map_or_else(|| Ok(Sink::stdout()), Sink::page)?;
        sink.write(page)?;
        sink.finish_of(all).map(|_| ())
    }
}

/// The pictures of a page, by the folders of their files.
#[derive(Default)]
pub struct Gallery {
    chapters: Vec<Chapter>,
}

struct Chapter {
    /// The folder; empty where the files are in none.
    name: String,
    figures: String,
    count: usize,
}

impl Gallery {
    fn add(&mut self, pages: &[Page]) {
        for page in pages {
            let known = self.chapters.iter_mut().find(|chapter| chapter.name == page.chapter);
            let chapter = if let Some(known) = known {
                known
            } else {
                let name = page.chapter.clone();
                self.chapters.push(Chapter { name, figures: String::new(), count: 0 });
                let last = self.chapters.len() - 1;
                &mut self.chapters[last]
            };
            chapter.figures += &page.text;
            chapter.count += 1;
        }
    }

    /// With contents where there are several chapters.
    fn html(&self, title: &str) -> String {
        let mut html = String::new();
        let several = self.chapters.len() > 1;
        if several {
            html += &format!("<h1>{title}</h1>\n<nav><ul>\n");
            for (i, Chapter { name, count, .. }) in self.chapters.iter().enumerate() {
                let name = escaped(if name.is_empty() { "." } else { name });
                html += &format!("<li><a href=\"#chapter-{}\">{name}</a> ({count})</li>\n", i + 1);
            }
            html += "</ul></nav>\n";
        }
        for (i, Chapter { name, figures, .. }) in self.chapters.iter().enumerate() {
            if several {
                let name = escaped(if name.is_empty() { "." } else { name });
                html += &format!("<h2 id=\"chapter-{}\">{name}</h2>\n", i + 1);
            }
            html += &format!("<div class=\"pictures\">\n{figures}</div>\n");
        }
        html
    }
}

/// A picture of a page, which has the rules for all: a browser lays out only those that are seen, and leaves room for the others.
fn figure(sheet: &Sheet) -> String {
    let title = escaped(&sheet.drawing.title);
    let room = (sheet.bounds.size().y + CAPTION).ceil();
    format!(
        "<figure style=\"contain-intrinsic-height:auto {room}mm\">\n<figcaption>{title}</figcaption>\n{}</figure>\n",
        sheet.svg_in_page()
    )
}

/// Height of the line with the title of a picture, mm.
const CAPTION: f64 = 7.0;

/// Begin and end of a page: figures that shrink to the screen.
const HEAD: &str = "<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width\">
";
const STYLE: &str = "body{margin:1rem;font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",serif}
figure{margin:0;break-inside:avoid}figcaption{margin-bottom:.5rem}
figure svg{max-width:100%;height:auto}
.pictures{display:grid;grid-template-columns:repeat(auto-fit,minmax(min(100%,23rem),1fr));gap:2rem 1.5rem;align-items:start}
nav ul{columns:14rem;padding:0;list-style:none}h2{break-after:avoid}
@media screen{figure{content-visibility:auto}}
@media print{.pictures{grid-template-columns:1fr 1fr}}
";
const FOOT: &str = "</body>\n</html>\n";

/// The colours of the page around the pictures.
const fn paper(theme: Theme) -> &'static str {
    match theme {
        Theme::Auto => {
            "body{background:#fff;color:#111}\n@media (prefers-color-scheme:dark){body{background:#16181c;color:#ececec}}\n\
             @media print{body{background:#fff;color:#000}}\n"
        }
        Theme::Dark => "body{background:#16181c;color:#ececec}\n",
        Theme::Light | Theme::Mono => "body{background:#fff;color:#111}\n",
    }
}

/// Writes a file, which appears only when complete.
fn written(mut sink: Sink, text: &[u8]) -> Result<(), CliError> {
    sink.write(text)?;
    sink.finish_page().map(|_| count_written())
}

/// A name without signs that file systems refuse.
pub fn file_name(name: &str) -> String {
    name.chars().map(|c| if c.is_control() || "/\\:*?\"<>| ".contains(c) { '-' } else { c }).collect()
}
