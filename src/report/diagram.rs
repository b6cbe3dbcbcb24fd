//! Error against time, both logarithmic, one line per kind of setting: a drawing in SVG.

use assur_solve::measure::accuracy::{AccuracyStudy, Kind, Setting};
use assur_text::units::significant;
use std::fmt::Write;

const WIDTH: f64 = 760.0;
const HEIGHT: f64 = 470.0;
/// The frame of the axes: left, top, right, bottom.
const FRAME: [f64; 4] = [86.0, 58.0, 560.0, 404.0];
const INK: &str = "#222222";
const PALE: &str = "#e3e3e3";

/// A logarithmic axis and where it lies.
struct Axis {
    /// Powers of ten.
    from: f64,
    to: f64,
    start: f64,
    end: f64,
}

impl Axis {
    /// Over positive numbers, with something to spare.
    fn over(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Option<Self> {
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for x in values.filter(|x| *x > 0.0).map(libm::log10) {
            (least, greatest) = (least.min(x), greatest.max(x));
        }
        let spare = 0.3_f64.max(0.05 * (greatest - least));
        (least <= greatest).then_some(Self { from: least - spare, to: greatest + spare, start, end })
    }

    fn place(&self, x: f64) -> f64 {
        self.start + (libm::log10(x) - self.from) / (self.to - self.from) * (self.end - self.start)
    }

    /// Powers of ten on the axis, at most about so many.
    fn powers(&self, most: f64) -> Vec<f64> {
        let step = ((self.to - self.from) / most).ceil().max(1.0);
        let mut at = (self.from / step).ceil() * step;
        let mut all = Vec::new();
        while at <= self.to {
            all.push(at);
            at += step;
        }
        all
    }

    /// 1, 2, 5, 10, … on the axis; powers of ten alone where it is long.
    fn ticks(&self) -> Vec<f64> {
        let times: &[f64] = if self.to - self.from > 3.0 { &[1.0] } else { &[1.0, 2.0, 5.0] };
        let mut all = Vec::new();
        let mut power = self.from.floor();
        while power <= self.to {
            let ten = libm::pow(10.0, power);
            all.extend(times.iter().map(|t| t * ten).filter(|x| {
                let at = libm::log10(*x);
                at >= self.from && at <= self.to
            }));
            power += 1.0;
        }
        all
    }
}

const fn colour(kind: Kind) -> &'static str {
    match kind {
        Kind::Scalar => "#1b6ca8",
        Kind::Friction => "#c8553d",
        Kind::Newton => "#3c8d53",
        Kind::Triad => "#8f5fa8",
        Kind::Samples => "#d19000",
        Kind::Root => "#5a6672",
    }
}

/// A sign of its own for each kind, about a place.
fn sign(out: &mut String, kind: Kind, x: f64, y: f64) {
    let fill = colour(kind);
    let r = 4.2;
    let text = match kind {
        Kind::Scalar => format!(r#"<circle cx="{x:.1}" cy="{y:.1}" r="{r}" fill="{fill}"/>"#),
        Kind::Friction => polygon(fill, &[(x, y - r - 1.0), (x + r, y + r - 0.5), (x - r, y + r - 0.5)]),
        Kind::Newton => polygon(fill, &[(x - r, y - r), (x + r, y - r), (x + r, y + r), (x - r, y + r)]),
        Kind::Triad => {
            polygon(fill, &[(x, y - r - 1.2), (x + r + 1.2, y), (x, y + r + 1.2), (x - r - 1.2, y)])
        }
        Kind::Samples => polygon(fill, &[(x, y + r + 1.0), (x + r, y - r + 0.5), (x - r, y - r + 0.5)]),
        Kind::Root => {
            format!(
                r#"<circle cx="{x:.1}" cy="{y:.1}" r="{r}" fill="white" stroke="{fill}" stroke-width="2"/>"#
            )
        }
    };
    out.push_str(&text);
    out.push('\n');
}

fn polygon(fill: &str, points: &[(f64, f64)]) -> String {
    let points: Vec<String> = points.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    format!(r#"<polygon points="{}" fill="{fill}"/>"#, points.join(" "))
}

fn text(out: &mut String, x: f64, y: f64, anchor: &str, size: f64, words: &str) {
    let _ = writeln!(
        out,
        r#"<text x="{x:.1}" y="{y:.1}" text-anchor="{anchor}" font-size="{size}" fill="{INK}">{}</text>"#,
        escaped(words)
    );
}

fn escaped(words: &str) -> String {
    words.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;")
}

fn line(out: &mut String, from: (f64, f64), to: (f64, f64), colour: &str) {
    let ((x, y), (u, v)) = (from, to);
    let _ = writeln!(out, r#"<line x1="{x:.1}" y1="{y:.1}" x2="{u:.1}" y2="{v:.1}" stroke="{colour}"/>"#);
}

/// Places of a kind's settings: time and error.
fn points(knob: &Setting) -> impl Iterator<Item = (f64, f64)> {
    knob.rows.iter().filter_map(|r| Some((r.micros, r.error?.max(1e-34))))
}

/// The diagram of a study; `None` where nothing can be set.
#[must_use]
pub fn svg(title: &str, study: &AccuracyStudy) -> Option<String> {
    let [left, top, right, bottom] = FRAME;
    let all = || study.knobs.iter().flat_map(points);
    let x = Axis::over(all().map(|p| p.0), left, right)?;
    let y = Axis::over(all().map(|p| p.1), bottom, top)?;
    let mut out = format!(
        r#"<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" height="{HEIGHT}" font-family="Helvetica, Arial, sans-serif">
<rect width="{WIDTH}" height="{HEIGHT}" fill="white"/>
"#
    );
    text(&mut out, left, 30.0, "start", 16.0, title);
    axes(&mut out, &x, &y);
    for knob in &study.knobs {
        series(&mut out, knob, &x, &y);
    }
    legend(&mut out, study);
    out.push_str("</svg>\n");
    Some(out)
}

fn axes(out: &mut String, x: &Axis, y: &Axis) {
    let [left, top, right, bottom] = FRAME;
    for tick in x.ticks() {
        let at = x.place(tick);
        line(out, (at, top), (at, bottom), PALE);
        line(out, (at, bottom), (at, bottom + 5.0), INK);
        text(out, at, bottom + 20.0, "middle", 12.0, &significant(tick, 1));
    }
    for power in y.powers(9.0) {
        let at = y.place(libm::pow(10.0, power));
        line(out, (left, at), (right, at), PALE);
        line(out, (left - 5.0, at), (left, at), INK);
        text(out, left - 28.0, at + 5.0, "end", 12.0, "10");
        text(out, left - 27.0, at - 1.0, "start", 9.0, &significant(power, 2).replace('-', "−"));
    }
    let _ = writeln!(
        out,
        r#"<rect x="{left}" y="{top}" width="{}" height="{}" fill="none" stroke="{INK}"/>"#,
        right - left,
        bottom - top
    );
    text(out, 0.5 * (left + right), bottom + 46.0, "middle", 13.0, "time, µs");
    let (u, v) = (24.0, 0.5 * (top + bottom));
    let _ = writeln!(
        out,
        r#"<text x="{u}" y="{v}" transform="rotate(-90 {u} {v})" text-anchor="middle" font-size="13" fill="{INK}">greatest error, relative</text>"#
    );
}

fn series(out: &mut String, knob: &Setting, x: &Axis, y: &Axis) {
    let places: Vec<(f64, f64)> = points(knob).map(|p| (x.place(p.0), y.place(p.1))).collect();
    let path: Vec<String> = places.iter().map(|(x, y)| format!("{x:.1},{y:.1}")).collect();
    let fill = colour(knob.kind);
    // scalars are no tolerances: between them there is nothing
    if knob.kind != Kind::Scalar {
        let _ = writeln!(
            out,
            r#"<polyline points="{}" fill="none" stroke="{fill}" stroke-width="1.6"/>"#,
            path.join(" ")
        );
    }
    for (u, v) in &places {
        sign(out, knob.kind, *u, *v);
    }
    let known = knob.rows.iter().filter(|r| r.error.is_some());
    if knob.kind == Kind::Scalar {
        for (row, (u, v)) in known.zip(&places) {
            let (anchor, at) = if *u > 0.7 * FRAME[2] { ("end", u - 9.0) } else { ("start", u + 9.0) };
            text(out, at, v + 4.0, anchor, 11.0, &row.setting);
        }
    }
}

fn legend(out: &mut String, study: &AccuracyStudy) {
    let x = FRAME[2] + 22.0;
    let mut y = FRAME[1] + 10.0;
    for knob in &study.knobs {
        sign(out, knob.kind, x, y);
        text(out, x + 13.0, y + 4.0, "start", 12.0, knob.kind.name());
        let settings: Vec<&str> = knob.rows.iter().map(|r| r.setting.as_str()).collect();
        let range = match settings.as_slice() {
            [first, .., last] if knob.kind != Kind::Scalar => format!("{first} … {last}"),
            _ => String::new(),
        };
        let per = if knob.kind.per_cycle() { "per cycle" } else { "per position" };
        let below = if range.is_empty() { per.to_owned() } else { format!("{range}, {per}") };
        text(out, x + 13.0, y + 19.0, "start", 10.0, &below);
        y += 44.0;
    }
}
