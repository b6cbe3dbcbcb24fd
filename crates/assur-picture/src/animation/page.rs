//! The mechanism in motion as a page: the picture with its bar, and the player with its data. Without the script the first frame
//! stands there.

use super::motion::motion;
use crate::kind::Options;
use crate::scene::Scene;
use crate::wording::Wording;
use assur_drawing::{Theme, escaped};
use assur_text::diagnostic::Diagnosis;

/// What moves the picture, on all pages.
pub const PLAYER: &str = include_str!("player.js");
/// How its bar and its arrows look.
pub const PLAYER_STYLE: &str = include_str!("player.css");

const STYLE: &str = ":root{color-scheme:light dark}
body{margin:0 auto;max-width:200mm;padding:1rem;font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",serif;background:#fff;color:#111}
body:has(.motion-plot){max-width:340mm}h1{font-size:1.4rem}svg{width:100%;height:auto;max-height:80vh;display:block}
[data-missing]{display:none}
@media (prefers-color-scheme:dark){body{background:#16181c;color:#ececec}}
@media print{body{background:#fff;color:#000}}
";

/// The page.
///
/// # Errors
/// There is no way to go.
pub fn animation(
    scene: &Scene<'_>,
    options: &Options,
    theme: Theme,
    wording: &dyn Wording,
) -> Result<String, Diagnosis> {
    let moving = motion(scene, options, theme, wording)?;
    let (title, code) = (escaped(&moving.title), wording.code());
    // no text in it ends the script
    let data = serde_json::to_string(&moving.motion).unwrap_or_default().replace('<', "\\u003c");
    Ok(format!(
        "<!doctype html>\n<html lang=\"{code}\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">\n<title>{title}</title>\n\
         <style>{STYLE}{PLAYER_STYLE}</style>\n</head>\n<body>\n<h1>{title}</h1>\n{}\
         <script type=\"module\">\n{PLAYER}\nconst motion = {data};\nwindow.played = player(document.body, motion, {{}}, document);\n\
         </script>\n</body>\n</html>\n",
        moving.markup
    ))
}
