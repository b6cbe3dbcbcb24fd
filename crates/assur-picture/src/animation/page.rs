//! The mechanism in motion as a page: the first frame, how its parts move as small whole numbers, a slider, and a script of a
//! few lines. Without the script the first frame stands there.

use super::Animated;
use super::moved::{Body, Follower, Redrawn};
use super::values::{Column, columns, said};
use crate::kind::Options;
use crate::plot::{Curves, plot};
use crate::scene::Scene;
use crate::wording::Wording;
use assur_drawing::{Theme, escaped, number};
use assur_math::math::Vec2;
use assur_text::diagnostic::Diagnosis;
use std::fmt::Write;

/// Steps of a millimetre and of a radian.
const STEPS: (f64, f64) = (100.0, 18_000.0 / std::f64::consts::PI);

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
    let ways = scene.all_ways();
    let scene = &Scene { ways: &ways, ..*scene };
    let animated = Animated::of(scene, options, wording)?;
    let diagram = plot(scene, &[]).ok();
    let columns = columns(&animated.frames, diagram.as_ref().map(|(_, curves)| curves));
    let mut out = String::new();
    let heading = escaped(&animated.title);
    let code = wording.code();
    let _ = write!(
        out,
        "<!doctype html>\n<html lang=\"{code}\">\n{HEAD}<title>{heading}</title>\n{STYLE}</head>\n<body>\n<h1>{heading}</h1>\n"
    );
    out.push_str(&animated.sheet.svg(theme));
    let last = animated.frames.len() - 1;
    let _ = write!(
        out,
        "<div class=\"bar\"><button id=\"p\" type=\"button\" aria-label=\"{}\">▶</button><input id=\"s\" \
         type=\"range\" min=\"0\" max=\"{last}\" value=\"0\" aria-label=\"{}\"></div>\n<output id=\"o\" for=\"s\">{}</output>\n",
        wording.phrase("play or pause"),
        wording.phrase("pose"),
        escaped(&said(&columns, 0, wording.decimal()))
    );
    let mut places = String::from("null");
    if let Some((drawing, curves)) = diagram {
        let sheet = wording.drawing(scene.mechanism(), drawing).placed();
        let top = number(sheet.bounds.min.y);
        let cursor = format!(
            "<path id=\"c\" fill=\"none\" stroke=\"#b84a00\" stroke-width=\".35\" visibility=\"hidden\" d=\"M0 {top}V{}\"/>\n</svg>",
            number(sheet.bounds.max.y)
        );
        out.push_str(&sheet.svg(theme).replacen("</svg>", &cursor, 1));
        places = along(&animated.frames, &curves);
    }
    let moved = &animated.moved;
    let mut all = Distinct::default();
    let bodies = list(moved.bodies.iter().map(|b| body(b, &mut all)));
    let follower = |f: &Follower| format!("[{},{},{}]", number(f.at.x), number(f.at.y), f.body);
    let _ = write!(
        out,
        "<script>\nconst N={},Z=\"{DIGITS}\",S={},B={bodies},F={},R={},H={},V={},X={places},P='{}';\n{SCRIPT}</script>\n</body>\n</html>\n",
        animated.frames.len(),
        list(all.texts.into_iter()),
        list(moved.followers.iter().map(follower)),
        list(moved.redrawn.iter().map(redrawn)),
        list(
            animated
                .faded
                .iter()
                .map(|label| series(label.frames.iter().map(|hidden| Some(i64::from(*hidden)))))
        ),
        list(columns.iter().map(column)),
        wording.decimal(),
    );
    Ok(out)
}

/// Where the drive, or the instant, is in the plot, in steps of a hundredth of a millimetre.
fn along(frames: &[Scene<'_>], curves: &Curves) -> String {
    series(frames.iter().map(|frame| whole(curves.place(frame.along()?) * STEPS.0)))
}

/// The nearest whole number.
#[allow(clippy::cast_possible_truncation)] // millimetres of paper
fn whole(x: f64) -> Option<i64> {
    (x.abs() < 1e15).then(|| x.round() as i64)
}

fn list(parts: impl Iterator<Item = String>) -> String {
    format!("[{}]", parts.collect::<Vec<_>>().join(",\n"))
}

/// A number of all frames: name, unit, decimals, series.
fn column(column: &Column) -> String {
    let Column { name, unit, decimals, numbers } = column;
    format!("[{},{},{decimals},{}]", quoted(name), quoted(unit), series(numbers.iter().copied()))
}

/// The texts of a mark, each once, and which one each frame shows.
fn redrawn(texts: &Redrawn) -> String {
    let (known, which) = texts.distinct(1);
    let which = which.into_iter().map(|i| i64::try_from(i).ok());
    format!("[{},{}]", list(known.into_iter().map(quoted)), series(which))
}

/// A text in a script.
fn quoted(text: &str) -> String {
    let inner = text.replace('\\', "\\\\").replace('"', "\\\"").replace('\n', " ").replace("</", "<\\/");
    format!("\"{inner}\"")
}

/// Centre, and the places of the series by which it moves: right, down, turn.
fn body(body: &Body, all: &mut Distinct) -> String {
    let Body { centre, turns, poses, .. } = body;
    let mut column = |part: &dyn Fn(&(Vec2, f64)) -> f64| {
        all.place(series(poses.iter().map(|pose| Some(whole(part(pose)).unwrap_or(0)))))
    };
    let right = column(&|(at, _)| (at.x - centre.x) * STEPS.0);
    let down = column(&|(at, _)| (at.y - centre.y) * STEPS.0);
    let turn = turns.then(|| column(&|(_, angle)| angle * STEPS.1));
    let turn = turn.map_or(String::new(), |turn| format!(",{turn}"));
    format!("[{},{},{right},{down}{turn}]", number(centre.x), number(centre.y))
}

const HEAD: &str = "<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width,initial-scale=1\">
";

const STYLE: &str = "<style>
:root{color-scheme:light dark}
body{margin:0 auto;max-width:200mm;padding:1rem;font-family:\"Times New Roman\",Tinos,\"Liberation Serif\",serif;background:#fff;color:#111}
h1{font-size:1.4rem}g[class^=v]{transition:opacity .2s}svg{width:100%;height:auto;max-height:80vh;display:block}
.bar{display:flex;gap:.8rem;align-items:center;margin:.6rem 0}input{flex:1;min-width:0;accent-color:#0072b2}
button{font:inherit;min-width:3em;padding:.35em}
output{display:block;min-height:2.6em;font-variant-numeric:tabular-nums;white-space:pre-wrap;overflow-wrap:anywhere;margin-bottom:.6rem}
@media (prefers-color-scheme:dark){body{background:#16181c;color:#ececec}}
@media print{body{background:#fff;color:#000}.bar{display:none}}
</style>
";

/// Reads the series, shows a frame, plays: whole seconds between twelfths of the way where less motion is wanted.
const SCRIPT: &str = "const $=i=>document.getElementById(i),all=c=>[...document.querySelectorAll('.'+c)],few=matchMedia('(prefers-reduced-motion: reduce)');
const read=t=>{const o=[];let v=0,h=1,q=0;for(const c of t){const d=Z.indexOf(c);if(d<0){o.push(null);continue}v+=d%32*h;h*=32;if(d<32){q+=v%2?(1-v)/2:v/2;o.push(q);v=0;h=1}}return o};
const T=S.map(read),M=B.map((b,j)=>[all('m'+j),...b]),E=F.map((f,j)=>[all('f'+j),...f]);
const D=R.map((r,j)=>[all('r'+j),r[0],read(r[1])]),W=H.map((h,j)=>[all('v'+j),read(h)]),Q=V.map(v=>[v[0],v[1],v[2],read(v[3])]),C=X&&read(X);let k=0,on=false,t0=0;
const move=(g,t)=>{for(const e of g)e.setAttribute('transform',t)};
function show(i){k=i;for(const[g,x,y,a,b,c]of M)move(g,`translate(${T[a][i]/100+x} ${T[b][i]/100+y})`+(c>=0?` rotate(${T[c][i]/100})`:'')+` translate(${-x} ${-y})`);
for(const[g,x,y,j]of E){const[,X,Y,a,b,c]=M[j],w=c>=0?T[c][i]*Math.PI/18000:0,u=x-X,v=y-Y;
move(g,`translate(${T[a][i]/100+u*Math.cos(w)-v*Math.sin(w)-u} ${T[b][i]/100+u*Math.sin(w)+v*Math.cos(w)-v})`)}
for(const[g,r,q]of D)for(const e of g)e.innerHTML=r[q[i]];
for(const[g,h]of W)for(const e of g)e.style.opacity=1-h[i];
$('o').textContent=Q.map(([n,u,d,s])=>n+' = '+(s[i]===null?'—':(s[i]/10**d).toFixed(d).replace('-','−').replace('.',P)+u)).join('   ');
$('s').value=i;const c=$('c');if(c){const x=C[i];c.setAttribute('visibility',x!==null&&x>=-1&&x<=15001?'visible':'hidden');c.setAttribute('transform',`translate(${x/100} 0)`)}}
function step(t){if(!on)return;const w=few.matches?1000:6000/N;if(t-t0>=w){const d=few.matches?Math.ceil(N/12):Math.max(1,Math.min(Math.ceil(N/45),Math.floor((t-t0)/w)));t0=t;show((k+d)%N)}requestAnimationFrame(step)}
function play(y){on=y;$('p').textContent=on?'❚❚':'▶';if(on)requestAnimationFrame(step)}
$('s').oninput=e=>{play(false);show(+e.target.value)};$('p').onclick=()=>play(!on);
document.addEventListener('keydown',e=>{if(e.target.tagName=='BUTTON'||e.altKey||e.ctrlKey||e.metaKey)return;if(e.key==' '){e.preventDefault();play(!on)}
else if(e.target.id!='s'&&(e.key=='ArrowRight'||e.key=='ArrowLeft')){play(false);show((k+(e.key=='ArrowRight'?1:N-1))%N)}});
show(0);
";

// Whole numbers of all frames as text: the steps from one to the next, in digits of base 64 as in source maps. Five bits a digit, the
// least first; a digit from 32 on is followed by more, and the first bit is the sign.

/// Digits in their order; none of them ends a text or an element.
pub const DIGITS: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
/// Where there is no number.
const NONE: char = '~';

/// The text of numbers, in quotes.
pub fn series(numbers: impl Iterator<Item = Option<i64>>) -> String {
    let mut out = String::from("\"");
    let mut before = 0_i64;
    for number in numbers {
        match number {
            Some(number) => {
                digits(&mut out, number.wrapping_sub(before));
                before = number;
            }
            None => out.push(NONE),
        }
    }
    out.push('"');
    out
}

fn digits(out: &mut String, step: i64) {
    let mut rest = (step.unsigned_abs() << 1) | u64::from(step < 0);
    loop {
        #[allow(clippy::cast_possible_truncation)] // five bits
        let digit = (rest & 31) as usize;
        rest >>= 5;
        let digit = if rest > 0 { digit + 32 } else { digit };
        out.push(char::from(DIGITS.as_bytes()[digit]));
        if rest == 0 {
            return;
        }
    }
}

/// Series of many things, each text once.
#[derive(Default)]
pub struct Distinct {
    pub texts: Vec<String>,
    known: std::collections::HashMap<String, usize>,
}

impl Distinct {
    /// The place of a text.
    pub fn place(&mut self, text: String) -> usize {
        *self.known.entry(text).or_insert_with_key(|text| {
            self.texts.push(text.clone());
            self.texts.len() - 1
        })
    }
}
