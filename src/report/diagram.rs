//! Error against time, both logarithmic, one line per kind of setting: a drawing in SVG.

use assur_drawing::{Drawing, Label, Level, Shape, Style, Text, Theme};
use assur_math::math::Vec2;
use assur_solve::measure::accuracy::{AccuracyStudy, Kind, Setting};
use assur_text::units::significant;

/// The frame of the axes, mm; y of paper points down.
const WIDTH: f64 = 120.0;
const HEIGHT: f64 = 88.0;
/// From the frame to the legend, and from line to line of it.
const LEGEND: f64 = 7.0;
const LINE: f64 = 11.0;
/// Sizes of letters.
const TITLE: f64 = 4.8;
const WORDS: f64 = 3.8;
const NUMBERS: f64 = 3.4;
/// Length of a tick, and half the size of a sign.
const TICK: f64 = 1.3;
const SIGN: f64 = 1.15;

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

/// The line of a kind; scalars have none: they are no tolerances, and between them there is nothing.
const fn line_of(kind: Kind) -> Option<Style> {
    match kind {
        Kind::Scalar => None,
        Kind::Friction => Some(Style::AccelerationPart),
        Kind::Newton => Some(Style::UnknownPart),
        Kind::Triad => Some(Style::Medium),
        Kind::Samples => Some(Style::VelocityPart),
        Kind::Root => Some(Style::Way),
    }
}

/// A sign of its own for each kind, about a place.
fn sign(drawing: &mut Drawing, kind: Kind, at: Vec2) {
    let corners =
        |all: &[(f64, f64)]| Shape::polygon(all.iter().map(|(x, y)| at + Vec2::new(*x, *y) * SIGN).collect());
    let circle = Shape::Circle { centre: at, radius: SIGN };
    let (style, shape) = match kind {
        Kind::Scalar => (Style::BlueDot, circle),
        Kind::Friction => (Style::VermilionDot, corners(&[(0.0, -1.2), (1.1, 0.9), (-1.1, 0.9)])),
        Kind::Newton => (Style::GreenDot, corners(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)])),
        Kind::Triad => (Style::Solid, corners(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)])),
        Kind::Samples => (Style::BlueDot, corners(&[(0.0, 1.2), (1.1, -0.9), (-1.1, -0.9)])),
        Kind::Root => (Style::Hinge, circle),
    };
    drawing.mark(style, shape);
}

/// Places of a kind's settings: time and error.
fn points(knob: &Setting) -> impl Iterator<Item = (f64, f64)> {
    knob.rows.iter().filter_map(|r| Some((r.micros, r.error?.max(1e-34))))
}

/// The diagram of a study; `None` where nothing can be set.
#[must_use]
pub fn svg(title: &str, study: &AccuracyStudy) -> Option<String> {
    let all = || study.knobs.iter().flat_map(points);
    let x = Axis::over(all().map(|p| p.0), 0.0, WIDTH)?;
    let y = Axis::over(all().map(|p| p.1), 0.0, -HEIGHT)?;
    let kinds: Vec<&str> = study.knobs.iter().map(|k| k.kind.name()).collect();
    let description =
        format!("Greatest relative error against time in µs, both logarithmic, for {}.", kinds.join(", "));
    let mut drawing = Drawing::new("accuracy", format!("{title}: error against time"), description);
    written(&mut drawing, title, TITLE, Vec2::new(0.0, -HEIGHT - 11.0), Vec2::new(1.0, 0.0));
    axes(&mut drawing, &x, &y);
    for knob in &study.knobs {
        series(&mut drawing, knob, &x, &y);
    }
    legend(&mut drawing, study);
    Some(drawing.placed().svg(Theme::Auto))
}

/// A text beside a point in a direction.
fn written(drawing: &mut Drawing, words: &str, size: f64, at: Vec2, towards: Vec2) {
    drawing.label(Label::at(Text::upright(words), size, at, 0.3).towards(towards).ranked(0));
}

fn axes(drawing: &mut Drawing, x: &Axis, y: &Axis) {
    let (down, left) = (Vec2::new(0.0, 1.0), Vec2::new(-1.0, 0.0));
    for tick in x.ticks() {
        let at = Vec2::new(x.place(tick), 0.0);
        drawing.line(Style::Grid, at, Vec2::new(at.x, -HEIGHT));
        drawing.line(Style::Medium, at, at + down * TICK);
        written(drawing, &significant(tick, 1), NUMBERS, at + down * (TICK + 0.4), down);
    }
    for power in y.powers(9.0) {
        let at = Vec2::new(0.0, y.place(libm::pow(10.0, power)));
        drawing.line(Style::Grid, at, Vec2::new(WIDTH, at.y));
        drawing.line(Style::Medium, at, at + left * TICK);
        let number = Text::upright("10").and(&significant(power, 2).replace('-', "−"), false, Level::Sup);
        let label = Label::at(number, NUMBERS, at + left * (TICK + 0.4), 0.3).towards(left).ranked(0);
        drawing.label(label);
    }
    let corner = |x: f64, y: f64| Vec2::new(x, y);
    let frame = vec![corner(0.0, 0.0), corner(WIDTH, 0.0), corner(WIDTH, -HEIGHT), corner(0.0, -HEIGHT)];
    drawing.mark(Style::Medium, Shape::polygon(frame));
    written(drawing, "time, µs", WORDS, Vec2::new(WIDTH / 2.0, 7.0), down);
    written(drawing, "greatest error, relative", WORDS, Vec2::new(0.0, -HEIGHT - 3.0), Vec2::new(1.0, 0.0));
}

fn series(drawing: &mut Drawing, knob: &Setting, x: &Axis, y: &Axis) {
    drawing.begin("series", knob.kind.name());
    let places: Vec<Vec2> = points(knob).map(|p| Vec2::new(x.place(p.0), y.place(p.1))).collect();
    if let (Some(style), true) = (line_of(knob.kind), places.len() > 1) {
        drawing.mark(style, Shape::Lines { points: places.clone(), closed: false });
    }
    for at in &places {
        sign(drawing, knob.kind, *at);
    }
    if knob.kind == Kind::Scalar {
        let known = knob.rows.iter().filter(|r| r.error.is_some());
        for (row, at) in known.zip(&places) {
            let side = Vec2::new(if at.x > 0.8 * WIDTH { -1.0 } else { 1.0 }, 0.0);
            let text = Text::upright(&row.setting);
            drawing.label(Label::at(text, NUMBERS, *at, SIGN).towards(side).ranked(1));
        }
    }
    drawing.end();
}

fn legend(drawing: &mut Drawing, study: &AccuracyStudy) {
    let right = Vec2::new(1.0, 0.0);
    for (i, knob) in study.knobs.iter().enumerate() {
        let at = Vec2::new(WIDTH + LEGEND, -HEIGHT + 3.0 + LINE * i as f64);
        sign(drawing, knob.kind, at);
        written(drawing, knob.kind.name(), WORDS, at + right * 2.0, right);
        let settings: Vec<&str> = knob.rows.iter().map(|r| r.setting.as_str()).collect();
        let range = match settings.as_slice() {
            [first, .., last] if knob.kind != Kind::Scalar => format!("{first} … {last}"),
            _ => String::new(),
        };
        let per = if knob.kind.per_cycle() { "per cycle" } else { "per position" };
        let below = if range.is_empty() { per.to_owned() } else { format!("{range}, {per}") };
        written(drawing, &below, NUMBERS, at + Vec2::new(2.0, 4.6), right);
    }
}
