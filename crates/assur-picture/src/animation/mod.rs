//! The mechanism in motion: one page with the scheme of the first frame, how its parts move as small whole numbers, a slider,
//! and a script of a few lines. Without the script the first frame stands there.

mod moved;

use crate::error::Missing;
use crate::kind::Options;
use crate::no_diagram::NoDiagram;
use crate::plot::{self, plot};
use crate::scene::Scene;
use crate::scheme::{Loads, Scheme, frame_of_all, scheme_in};
use crate::words;
use assur_drawing::{Drawing, Rect, Sheet, Theme, escaped, number};
use assur_solve::answer::NoSweep;
use assur_solve::solve::{Cause, DriveValue, Pose};
use moved::{Body, Moved, Redrawn};
use std::fmt::Write;

/// The most frames.
const MOST: usize = 400;
/// Room for labels around what moves, mm.
const LABELS: f64 = 6.0;
/// Steps of a millimetre and of a radian.
const STEPS: (f64, f64) = (100.0, 18_000.0 / std::f64::consts::PI);

/// The frames of a mechanism: positions over the way of its drive.
fn frames<'a>(scene: &Scene<'a>, options: &Options) -> Result<Vec<Scene<'a>>, Missing> {
    let all: &'a [Pose] = if scene.turn.is_empty() { &scene.solution.poses } else { scene.turn };
    let at = |pose: &'a Pose| Some(Scene { pose, solved: pose.outcome.as_ref().ok()?, ..*scene });
    let solved: Vec<Scene<'a>> = all.iter().filter_map(at).collect();
    let most = options.frames.map_or(MOST, |_| usize::MAX);
    let step = solved.len().div_ceil(most).max(1);
    let frames: Vec<Scene<'a>> = solved.into_iter().step_by(step).collect();
    if frames.len() < 2 {
        let cause = Cause::NoSweep(NoSweep::OnePosition);
        return Err(NoDiagram::no_sweep(scene, "animation", &cause).into());
    }
    Ok(frames)
}

/// The schemes of all frames, in one place.
fn schemes(scene: &Scene<'_>, options: &Options) -> Result<Vec<Drawing>, Missing> {
    let frames = frames(scene, options)?;
    let wanted = Scheme { loads: Loads::None, ..Scheme::default() };
    let frame = frame_of_all(&frames, &options.scheme.paper())?;
    if frame.scale.is_none() {
        return Err(Missing::nothing_placed(scene, "an animation shows links that move"));
    }
    Ok(frames.iter().map(|scene| scheme_in(scene, &wanted, &frame)).collect())
}

/// The first frame.
///
/// # Errors
/// There is no way to go.
pub fn still(scene: &Scene<'_>, options: &Options) -> Result<Drawing, Missing> {
    let mut first = schemes(scene, options)?.into_iter().next().unwrap_or_default();
    first.id = words::id(scene, "animation");
    Ok(first)
}

/// The page.
///
/// # Errors
/// There is no way to go.
pub fn animation(scene: &Scene<'_>, options: &Options, theme: Theme) -> Result<String, Missing> {
    let schemes = schemes(scene, options)?;
    let moved = Moved::of(&schemes);
    let frames = frames(scene, options)?;
    let title = format!("{}: animation", words::title(scene));
    let mut room = Rect::NOTHING;
    schemes.iter().for_each(|scheme| room.join(&scheme.extent()));
    let mut first = schemes.into_iter().next().unwrap_or_default();
    first.id = words::id(scene, "animation");
    // labels are beside what moves
    first.room = Some(room.grown(LABELS));
    first.title.clone_from(&title);
    let mut sheet = first.placed();
    let count = sheet.drawing.labels.len().max(sheet.placed.len());
    sheet.moved = moved.classes.clone();
    sheet.moved[1].resize(count, None);
    let diagram = plot(scene, &[]).ok().map(|(drawing, curves)| (drawing.placed(), curves));
    Ok(page(&title, &sheet, &moved, &frames, diagram, theme))
}

fn page(
    title: &str,
    sheet: &Sheet,
    moved: &Moved,
    frames: &[Scene<'_>],
    diagram: Option<(Sheet, plot::Curves)>,
    theme: Theme,
) -> String {
    let mut out = String::new();
    let heading = escaped(title);
    let _ = write!(out, "{HEAD}<title>{heading}</title>\n{STYLE}</head>\n<body>\n<h1>{heading}</h1>\n");
    out.push_str(&sheet.svg(theme));
    let last = frames.len() - 1;
    let _ = write!(
        out,
        "<div class=\"bar\"><button id=\"p\" type=\"button\" aria-label=\"play or pause\">▶</button><input id=\"s\" \
         type=\"range\" min=\"0\" max=\"{last}\" value=\"0\" aria-label=\"pose\"></div>\n<output id=\"o\" for=\"s\">{}</output>\n",
        escaped(&words::drives(&frames[0]))
    );
    let drives: Vec<f64> = frames.iter().map(drive).collect();
    let mut shares = String::from("null");
    if let Some((diagram, curves)) = &diagram {
        let top = number(diagram.bounds.min.y);
        let cursor = format!(
            "<path id=\"c\" fill=\"none\" stroke=\"#b84a00\" stroke-width=\".35\" visibility=\"hidden\" d=\"M0 {top}V{}\"/>\n</svg>",
            number(diagram.bounds.max.y)
        );
        out.push_str(&diagram.svg(theme).replacen("</svg>", &cursor, 1));
        shares = list(drives.iter().map(|x| number(curves.place(*x))));
    }
    let values = frames.iter().zip(&drives).map(|(frame, drive)| {
        let mut said = vec![words::drives(frame)];
        if let Some((_, curves)) = &diagram {
            said.extend(
                curves
                    .at(*drive)
                    .map(|(name, display, y)| format!("{name} = {}", frame.value_text(display, y))),
            );
        }
        quoted(&said.join("   "))
    });
    let _ = write!(
        out,
        "<script>\nconst N={},B=[{}],R=[{}],V=[{}],X={shares};\n{SCRIPT}</script>\n</body>\n</html>\n",
        frames.len(),
        moved.bodies.iter().map(body).collect::<Vec<_>>().join(",\n"),
        moved.redrawn.iter().map(redrawn).collect::<Vec<_>>().join(",\n"),
        values.collect::<Vec<_>>().join(","),
    );
    out
}

fn drive(scene: &Scene<'_>) -> f64 {
    match scene.pose.drives.first() {
        Some(DriveValue::Scalar(x)) => *x,
        _ => f64::NAN,
    }
}

fn list(parts: impl Iterator<Item = String>) -> String {
    format!("[{}]", parts.collect::<Vec<_>>().join(","))
}

/// The texts of a mark, each once, and which one each frame shows.
fn redrawn(texts: &Redrawn) -> String {
    let mut known: Vec<&String> = Vec::new();
    let mut which = Vec::with_capacity(texts.len());
    for text in texts {
        let at = known.iter().position(|other| *other == text).unwrap_or_else(|| {
            known.push(text);
            known.len() - 1
        });
        which.push(at.to_string());
    }
    format!("[{},{}]", list(known.into_iter().map(|text| quoted(text))), list(which.into_iter()))
}

/// A text in a script.
fn quoted(text: &str) -> String {
    let inner = text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', " ").replace("</", "<\\/");
    format!("\"{inner}\"")
}

/// Centre, whether it turns, and steps from frame to frame: right, down, turn.
#[allow(clippy::cast_possible_truncation)] // millimetres of paper
fn body(body: &Body) -> String {
    let mut done = [0_i64; 3];
    let mut steps = Vec::with_capacity(3 * body.poses.len());
    for (at, angle) in &body.poses {
        let here = [at.x * STEPS.0, at.y * STEPS.0, angle * STEPS.1].map(|x| x.round() as i64);
        let count = if body.turns { 3 } else { 2 };
        for i in 0..count {
            steps.push((here[i] - done[i]).to_string());
        }
        done = here;
    }
    let turns = u8::from(body.turns);
    format!("[{},{},{turns},{}]", number(body.centre.x), number(body.centre.y), list(steps.into_iter()))
}

const HEAD: &str = "<!doctype html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">
";

const STYLE: &str = "<style>
:root{color-scheme:light dark}
body{margin:0 auto;max-width:200mm;padding:1rem;font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",serif;background:#fff;color:#111}
h1{font-size:1.4rem}svg{width:100%;height:auto;max-height:80vh;display:block}
.bar{display:flex;gap:.8rem;align-items:center;margin:.6rem 0}input{flex:1;min-width:0;accent-color:#0072b2}
button{font:inherit;min-width:3em;padding:.35em}
output{display:block;min-height:2.6em;font-variant-numeric:tabular-nums;white-space:pre-wrap;overflow-wrap:anywhere;margin-bottom:.6rem}
@media (prefers-color-scheme:dark){body{background:#16181c;color:#ececec}}
@media print{body{background:#fff;color:#000}.bar{display:none}}
</style>
";

/// Sums up the steps, shows a frame, plays: whole seconds between twelfths of the way where less motion is wanted.
const SCRIPT: &str = "const $=i=>document.getElementById(i),all=c=>[...document.querySelectorAll('.'+c)],few=matchMedia('(prefers-reduced-motion: reduce)');
const M=B.map((b,j)=>{const w=b[2]?3:2,t=[];let q=[0,0,0];for(let k=0;k<N;k++){for(let i=0;i<w;i++)q[i]+=b[3][k*w+i];
t.push(`translate(${q[0]/100} ${q[1]/100})`+(b[2]?` rotate(${q[2]/100})`:'')+` translate(${-b[0]} ${-b[1]})`)}return[all('m'+j),t]});
const D=R.map((r,j)=>[all('r'+j),r[1].map(i=>r[0][i])]);let k=0,on=false,t0=0;
function show(i){k=i;for(const[g,t]of M)for(const e of g)e.setAttribute('transform',t[i]);for(const[g,r]of D)for(const e of g)e.innerHTML=r[i];
$('o').textContent=V[i];$('s').value=i;const c=$('c');if(c){const x=X[i];c.setAttribute('visibility',x>=-0.01&&x<=150.01?'visible':'hidden');c.setAttribute('transform',`translate(${x} 0)`)}}
function step(t){if(!on)return;const w=few.matches?1000:6000/N;if(t-t0>=w){const d=few.matches?Math.ceil(N/12):Math.max(1,Math.min(4,Math.floor((t-t0)/w)));t0=t;show((k+d)%N)}requestAnimationFrame(step)}
function play(y){on=y;$('p').textContent=on?'❚❚':'▶';if(on)requestAnimationFrame(step)}
$('s').oninput=e=>{play(false);show(+e.target.value)};$('p').onclick=()=>play(!on);
document.addEventListener('keydown',e=>{if(e.target.tagName=='BUTTON'||e.altKey||e.ctrlKey||e.metaKey)return;if(e.key==' '){e.preventDefault();play(!on)}
else if(e.target.id!='s'&&(e.key=='ArrowRight'||e.key=='ArrowLeft')){play(false);show((k+(e.key=='ArrowRight'?1:N-1))%N)}});
show(0);
";
