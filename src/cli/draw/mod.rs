//! `assur draw`

mod output;

use super::args::Draw;
use super::error::CliError;
use super::files;
use super::reply::Printer;
use super::reply::{Reply, Status, complaint, for_each_input};
use super::screen::Screen;
use crate::pipeline::{self, Solved};
use assur_check::Overrides;
use assur_drawing::Theme;
use assur_math::math::Vec2;
use assur_picture::{Kind, Options, Scene, Scheme};
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use output::Output;

/// Draws pictures of solved problems.
pub fn run(args: &Draw, screen: &Screen) -> Status {
    let (kinds, names) = args.kinds();
    let inputs = files::expand(&names);
    let one = inputs.len() == 1 && kinds.len() == 1;
    let output = match Output::of(args.out.as_deref(), one) {
        Ok(output) => output,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            return Status::Unusable;
        }
    };
    let overrides = args.overrides();
    let drawing = Drawing { args, screen, kinds, overrides, output, several: inputs.len() > 1 };
    let status = for_each_input(inputs, &mut Printer::new(screen, ""), |source, _| drawing.of_file(source));
    match drawing.output.finish(&names) {
        Ok(()) => status,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            Status::Unusable
        }
    }
}

/// Pictures that are wanted.
struct Drawing<'a> {
    args: &'a Draw,
    screen: &'a Screen,
    kinds: Vec<Kind>,
    overrides: Overrides,
    output: Output,
    /// The command line names several files.
    several: bool,
}

/// A picture as text, with its title and the name of its file.
struct Page {
    name: String,
    title: String,
    text: String,
}

impl Drawing<'_> {
    fn of_file(&self, source: &Source) -> Reply {
        let (solved, mut problems) = pipeline::solve_drawn(source, &self.overrides, &self.kinds);
        let pages = match solved {
            Some(solved) => self.pages(source, &solved, &mut problems),
            None => Vec::new(),
        };
        match self.output.write(&pages, &self.args_inputs()) {
            Ok(results) => Reply::new(results, &problems, source, self.screen),
            Err(error) => {
                let reply = Reply::new(String::new(), &problems, source, self.screen);
                let diagnostics = reply.diagnostics + &complaint(error, self.screen);
                Reply { diagnostics, status: Status::Unusable, ..reply }
            }
        }
    }

    fn args_inputs(&self) -> Vec<String> {
        self.args.kinds().1
    }

    fn options(&self) -> Options {
        let mut scheme = Scheme {
            loads: self.args.loads.into(),
            ghosts: self.args.ghosts,
            paths: self.args.path.clone(),
            ..Scheme::default()
        };
        if let Some((width, height)) = self.args.size {
            scheme.size = Vec2::new(width, height);
        }
        Options { scheme }
    }

    /// All pictures of a file.
    fn pages(&self, source: &Source, solved: &Solved, problems: &mut Problems) -> Vec<Page> {
        let moves = self.args.ghosts > 0 || !self.args.path.is_empty();
        let turn = if moves { pipeline::turn(&solved.compiled, &solved.solution) } else { Vec::new() };
        let scenes = self.scenes(source, solved, problems);
        let scenes: Vec<Scene<'_>> = scenes.into_iter().map(|scene| Scene { turn: &turn, ..scene }).collect();
        let options = self.options();
        let stem = if self.several { path_in_one(&source.name) } else { stem(&source.name) };
        let several = scenes.len() > 1;
        let mut pages = Vec::new();
        for kind in &self.kinds {
            for scene in &scenes {
                match assur_picture::draw(*kind, scene, &options) {
                    Ok(drawings) => {
                        let pose = if several { format!("-{}", scene.pose.name) } else { String::new() };
                        let name = output::file_name(&format!("{stem}-{}{pose}", kind.name()));
                        pages.extend(self.numbered(&name, drawings));
                    }
                    // of all kinds those are left out that the file has no effects for
                    Err(_) if self.args.all => break,
                    Err(missing) => {
                        problems.push(missing);
                        break;
                    }
                }
            }
        }
        pages
    }

    /// Pictures of one kind and one position as text, numbered where there are several.
    fn numbered(&self, name: &str, drawings: Vec<assur_drawing::Drawing>) -> Vec<Page> {
        let theme: Theme = self.args.theme.into();
        let many = drawings.len() > 1;
        let pages = drawings.into_iter().enumerate().map(|(i, mut drawing)| {
            let name = if many { format!("{name}-{}", i + 1) } else { name.to_owned() };
            if self.several {
                // two files of one name may be in one page
                drawing.id = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
            }
            Page { name, title: drawing.title.clone(), text: drawing.placed().svg(theme) }
        });
        pages.collect()
    }

    /// The positions that are shown: those named, else on standard output and in one file the first, else the first of a
    /// sweep and all of a list.
    fn scenes<'s>(&self, source: &'s Source, solved: &'s Solved, problems: &mut Problems) -> Vec<Scene<'s>> {
        let model = solved.compiled.model();
        let file = (source.name.as_str(), source.text.as_str());
        let of = |name: Option<&str>| Scene::of(model, &solved.solution, file, name);
        let named = self.args.pose.iter().map(|name| of(Some(name)));
        let first = self.args.pose.is_empty().then(|| of(None));
        let mut scenes = Vec::new();
        for scene in named.chain(first) {
            match scene {
                Ok(scene) => scenes.push(scene),
                Err(missing) => problems.push(missing),
            }
        }
        scenes
    }
}

/// The file's name without folders and ending.
fn stem(name: &str) -> String {
    let last = name.rsplit(['/', '\\']).next().unwrap_or(name);
    let stem = last.strip_suffix(".mech").unwrap_or(last);
    if stem == "-" { "picture".to_owned() } else { stem.to_owned() }
}

/// The file's name with its folders, so that two of one name in two folders are apart: `cams-lever` of `cams/lever.mech`.
fn path_in_one(name: &str) -> String {
    let parts = name.split(['/', '\\']).filter(|part| !part.is_empty() && *part != "." && *part != "..");
    stem(&parts.collect::<Vec<_>>().join("-"))
}

/// An output that cannot hold several pictures.
fn one_only(name: &str) -> CliError {
    CliError::OnePicture { name: name.to_owned() }
}
