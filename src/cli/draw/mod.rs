//! `assur draw`

mod output;
mod plotted;
mod poses;

use super::args::{Draw, Picture};
use super::error::CliError;
use super::files;
use super::reply::Printer;
use super::reply::{Reply, Status, complaint, for_each_input};
use super::screen::Screen;
use crate::pipeline::{self, Solved};
use assur_check::Overrides;
use assur_drawing::Theme;
use assur_math::math::Vec2;
use assur_model::model::Mechanism;
use assur_picture::{Kind, Missing, Options, Scene, Scheme};
use assur_text::diagnostic::Problems;
use assur_text::source::Source;
use output::Output;

/// Draws pictures of solved problems.
pub fn run(args: &Draw, screen: &Screen) -> Status {
    let (pictures, names) = args.pictures();
    let inputs = files::expand(&names);
    let one = inputs.len() == 1 && pictures.len() == 1;
    let animation = matches!(pictures.as_slice(), [picture] if picture.kind == Kind::Animation);
    let output = match Output::of(args.out.as_deref(), one, animation) {
        Ok(output) => output,
        Err(error) => {
            screen.complain(&complaint(error, screen));
            return Status::Unusable;
        }
    };
    let overrides = args.overrides();
    let drawing = Drawing { args, screen, pictures, overrides, output, several: inputs.len() > 1 };
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
    pictures: Vec<Picture>,
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
    /// Of its file.
    ending: &'static str,
}

impl Drawing<'_> {
    fn of_file(&self, source: &Source) -> Reply {
        let extended = plotted::extended(source, &self.overrides, &self.pictures);
        let source = extended.as_ref().unwrap_or(source);
        let kinds: Vec<Kind> = self.pictures.iter().map(|picture| picture.kind).collect();
        let (solved, mut problems) = pipeline::solve_drawn(source, &self.overrides, &kinds);
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
        self.args.pictures().1
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
        Options { scheme, ..Options::default() }
    }

    /// All pictures of a file.
    fn pages(&self, source: &Source, solved: &Solved, problems: &mut Problems) -> Vec<Page> {
        let animated = self.pictures.iter().any(|picture| picture.kind == Kind::Animation);
        let moves = animated || self.args.ghosts > 0 || !self.args.path.is_empty();
        let turn = if moves { pipeline::turn(&solved.compiled, &solved.solution) } else { Vec::new() };
        let mechanism = &solved.compiled.mechanism;
        let of_cams = |picture: &Picture| picture.kind == Kind::Cam;
        if solved.solution.poses.is_empty() && self.pictures.iter().all(of_cams) {
            return self.cams(source, mechanism, problems);
        }
        let scenes = self.scenes(source, solved, problems);
        let scenes: Vec<Scene<'_>> = scenes.into_iter().map(|scene| Scene { turn: &turn, ..scene }).collect();
        let stem = self.stem(source);
        let several = scenes.len() > 1;
        let (mut pages, mut lacking) = (Vec::new(), Vec::new());
        for picture in &self.pictures {
            let plotted = plotted::items(source, mechanism, &picture.of);
            let options = Options { plotted, of: picture.of.clone(), ..self.options() };
            let shown = if picture.kind.is_of_sweep() { 1 } else { scenes.len() };
            for scene in &scenes[..shown.min(scenes.len())] {
                let mut name = format!("{stem}-{}", picture.kind.name());
                if !picture.of.is_empty() {
                    name += &format!("-{}", picture.of);
                }
                if several && !picture.kind.is_of_sweep() {
                    name += &format!("-{}", scene.pose.name);
                }
                match self.drawn(picture.kind, scene, &options, output::file_name(&name)) {
                    Ok(drawn) => pages.extend(drawn),
                    // of all kinds those are left out that the file has no effects for
                    Err(_) if self.args.all => {}
                    Err(missing) => {
                        // what lacks at every pose is said once
                        let words = missing.to_string();
                        if !lacking.contains(&words) {
                            lacking.push(words);
                            problems.push(missing);
                        }
                    }
                }
            }
        }
        pages
    }

    /// The pictures of a kind at a position; an animation is a page of its own where the output is not one.
    fn drawn(
        &self,
        kind: Kind,
        scene: &Scene<'_>,
        options: &Options,
        name: String,
    ) -> Result<Vec<Page>, Missing> {
        if kind == Kind::Animation && !self.output.is_page() {
            let text = assur_picture::animation(scene, options.scheme.size, self.args.theme.into())?;
            return Ok(vec![Page { name, title: String::new(), text, ending: "html" }]);
        }
        Ok(self.numbered(&name, assur_picture::draw(kind, scene, options)?))
    }

    /// The cams of a file that has no position.
    fn cams(&self, source: &Source, mechanism: &Mechanism, problems: &mut Problems) -> Vec<Page> {
        match assur_picture::cams_alone(mechanism, &source.name, self.options().scheme.size) {
            Ok(drawings) => {
                self.numbered(&output::file_name(&format!("{}-cam", self.stem(source))), drawings)
            }
            Err(missing) => {
                problems.push(missing);
                Vec::new()
            }
        }
    }

    /// The begin of the names of pictures.
    fn stem(&self, source: &Source) -> String {
        if self.several { path_in_one(&source.name) } else { stem(&source.name) }
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
            Page { name, title: drawing.title.clone(), text: drawing.placed().svg(theme), ending: "svg" }
        });
        pages.collect()
    }

    /// The positions that are shown: those named, else all of a list, the first of a sweep.
    fn scenes<'s>(&self, source: &'s Source, solved: &'s Solved, problems: &mut Problems) -> Vec<Scene<'s>> {
        let model = solved.compiled.model();
        let file = (source.name.as_str(), source.text.as_str());
        let of = |name: Option<&str>| Scene::of(model, &solved.solution, file, name);
        let listed = if self.args.pose.is_empty() { poses::listed(solved) } else { Vec::new() };
        let drawn = if self.output.is_single() { listed.len().min(1) } else { listed.len() };
        if drawn < listed.len() && !self.pictures.iter().all(|picture| picture.kind.is_of_sweep()) {
            let (first, count) = (listed[0].to_owned(), listed.len());
            problems.push(CliError::FirstPose { first, count });
        }
        let named = self.args.pose.iter().map(String::as_str).chain(listed[..drawn].iter().copied());
        let mut names: Vec<Option<&str>> = Vec::new();
        for name in named.map(Some) {
            if !names.contains(&name) {
                names.push(name);
            }
        }
        if names.is_empty() {
            names.push(None);
        }
        let mut scenes = Vec::new();
        for scene in names.into_iter().map(of) {
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
