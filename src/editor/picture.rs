//! The mechanism at one position.

use super::{Analysis, Declared, Results};
use assur_drawing::Theme;
use assur_picture::{Kind, Options, Scene, draw};

/// The mechanism at a position.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Picture {
    /// The drawing; empty where nothing has a position.
    pub svg: String,
    /// The names of all positions that are solved.
    pub poses: Vec<String>,
    /// Where what is drawn is declared: groups of the drawing have its class and, in `data-name`, its name.
    pub places: Vec<Declared>,
}

impl Analysis {
    /// The scheme at the position of a name, else at the first.
    ///
    /// # Errors
    /// There is no such position, in words.
    pub fn picture(&self, results: &Results, pose: Option<&str>) -> Result<Picture, String> {
        let solved = results.solved.as_ref().ok_or("the text has no solution")?;
        let file = (self.source.name.as_str(), self.source.text.as_str());
        let scene = Scene::of(solved.compiled.model(), &solved.solution, file, pose);
        let drawings = scene.and_then(|scene| draw(Kind::Scheme, &scene, &Options::default()));
        let drawings = drawings.map_err(|missing| missing.to_string())?;
        let poses = solved.solution.poses.iter().filter(|pose| pose.outcome.is_ok());
        Ok(Picture {
            svg: drawings.into_iter().map(|drawing| drawing.placed().svg(Theme::Auto)).collect(),
            poses: poses.map(|pose| pose.name.clone()).collect(),
            places: self.declared(),
        })
    }
}
