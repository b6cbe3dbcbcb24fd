//! Animations read back from their pages.

use assur::internals::Solved;
use assur::internals::drawing::Theme;
use assur::internals::picture::{Options, Scene, animation};
use assur::internals::solve::Pose;
use assur::internals::source::Source;
use assur::internals::worked::Language;

pub fn page(source: &Source, solved: &Solved, turn: &[Pose]) -> Option<String> {
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    let options = Options { frames: Some(turn.len()), ..Options::default() };
    animation(&Scene { turn, ..scene }, &options, Theme::Auto, &Language::English).ok()
}

/// The numbers of a series: steps in digits of base 64, five bits each, the least first, the first of all the sign.
pub fn series(text: &str) -> Vec<f64> {
    const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let (mut all, mut sum, mut step, mut place) = (Vec::new(), 0_i64, 0_i64, 0);
    for digit in text.chars().filter_map(|c| DIGITS.find(c)) {
        step |= (digit as i64 & 31) << place;
        place += 5;
        if digit < 32 {
            sum += if step & 1 == 1 { -(step >> 1) } else { step >> 1 };
            all.push(sum as f64);
            (step, place) = (0, 0);
        }
    }
    all
}

pub fn between<'t>(text: &'t str, before: &str, after: &str) -> &'t str {
    let rest = text.split_once(before).map_or("", |(_, rest)| rest);
    rest.split_once(after).map_or("", |(inner, _)| inner)
}

/// The data of the player.
pub fn motion(page: &str) -> serde_json::Value {
    serde_json::from_str(between(page, "\nconst motion = ", ";\n")).expect("data")
}

/// The series of a list.
pub fn all_series(list: &serde_json::Value) -> Vec<Vec<f64>> {
    list.as_array().expect("a list").iter().map(|text| series(text.as_str().expect("a series"))).collect()
}

/// The numbers of a list of lists.
pub fn lists(list: &serde_json::Value) -> Vec<Vec<f64>> {
    serde_json::from_value(list.clone()).expect("numbers")
}

/// The first number below the picture, of every frame: where the drive is.
pub fn values(page: &str) -> Vec<f64> {
    series(motion(page)["values"][0][3].as_str().unwrap_or_default())
}
