//! Error against time, both logarithmic, one line per kind of setting or method: a drawing in SVG.

use assur_drawing::{Drawing, Label, Level, Shape, Style, Text, Theme};
use assur_math::math::Vec2;
use assur_solve::measure::accuracy::{AccuracyStudy, Kind, Setting};
use assur_solve::measure::{MethodStudy, RunRow, RunStudy};
use assur_solve::solve::Method;
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

/// The shape of a sign.
#[derive(Clone, Copy)]
enum Sign {
    Circle,
    Up,
    Down,
    Square,
    Diamond,
}

/// What a kind of setting is drawn with.
const fn sign_of(kind: Kind) -> (Style, Sign) {
    match kind {
        Kind::Scalar => (Style::BlueDot, Sign::Circle),
        Kind::Friction => (Style::VermilionDot, Sign::Up),
        Kind::Newton => (Style::GreenDot, Sign::Square),
        Kind::Triad => (Style::Solid, Sign::Diamond),
        Kind::Samples => (Style::BlueDot, Sign::Down),
        Kind::Root => (Style::Hinge, Sign::Circle),
    }
}

/// A sign about a place.
fn mark(drawing: &mut Drawing, (style, sign): (Style, Sign), at: Vec2) {
    let corners =
        |all: &[(f64, f64)]| Shape::polygon(all.iter().map(|(x, y)| at + Vec2::new(*x, *y) * SIGN).collect());
    let shape = match sign {
        Sign::Circle => Shape::Circle { centre: at, radius: SIGN },
        Sign::Up => corners(&[(0.0, -1.2), (1.1, 0.9), (-1.1, 0.9)]),
        Sign::Square => corners(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]),
        Sign::Diamond => corners(&[(0.0, -1.3), (1.3, 0.0), (0.0, 1.3), (-1.3, 0.0)]),
        Sign::Down => corners(&[(0.0, 1.2), (1.1, -0.9), (-1.1, -0.9)]),
    };
    drawing.mark(style, shape);
}

/// One line of the diagram.
struct Series<'s> {
    name: String,
    /// What stands below its name.
    below: String,
    /// Between its points, where there is something.
    line: Option<Style>,
    sign: (Style, Sign),
    /// Time, µs, and error.
    points: Vec<(f64, f64)>,
    /// Names of the points, where they are named.
    names: Vec<&'s str>,
}

/// Errors below are drawn there.
const LEAST: f64 = 1e-34;

fn of_knob(knob: &Setting) -> Series<'_> {
    let per = if knob.kind.per_cycle() { "per cycle" } else { "per position" };
    let known: Vec<_> = knob.rows.iter().filter_map(|r| Some((r, r.error?.max(LEAST)))).collect();
    let below = match knob.rows.as_slice() {
        [first, .., last] if knob.kind != Kind::Scalar => {
            format!("{} … {}, {per}", first.setting, last.setting)
        }
        _ => per.to_owned(),
    };
    let names = known.iter().map(|(row, _)| row.setting.as_str()).filter(|_| knob.kind == Kind::Scalar);
    Series {
        name: knob.kind.name().to_owned(),
        below,
        line: line_of(knob.kind),
        sign: sign_of(knob.kind),
        points: known.iter().map(|(row, error)| (row.micros, *error)).collect(),
        names: names.collect(),
    }
}

/// The error that is left, and the one that is reported, by one method.
fn of_method(study: &MethodStudy) -> [Series<'static>; 2] {
    let (name, line, sign, dots) = match study.asked {
        None => ("as solve does it", Style::VelocityPart, (Style::BlueDot, Sign::Circle), Style::Way),
        Some(Method::Radau) => {
            ("Radau IIA", Style::AccelerationPart, (Style::VermilionDot, Sign::Up), Style::UnknownPart)
        }
        Some(_) => ("DOP853", Style::Curve3, (Style::GreenDot, Sign::Square), Style::Ghost),
    };
    let range = match study.rows.as_slice() {
        [first, .., last] => format!("within {:.0e} … {:.0e}", first.within, last.within),
        [only] => format!("within {:.0e}", only.within),
        [] => String::new(),
    };
    let points = |error: fn(&RunRow) -> f64| {
        let finite = study.rows.iter().map(|row| (row.micros, error(row).max(LEAST)));
        finite.filter(|point| point.1.is_finite()).collect()
    };
    [
        Series {
            name: name.to_owned(),
            below: range,
            line: Some(line),
            sign,
            points: points(|row| row.error),
            names: Vec::new(),
        },
        Series {
            name: "the error it reports".to_owned(),
            below: String::new(),
            line: Some(dots),
            sign: (Style::Hinge, sign.1),
            points: points(|row| row.reported),
            names: Vec::new(),
        },
    ]
}

/// The diagram of a study; `None` where nothing can be set.
#[must_use]
pub fn svg(title: &str, study: &AccuracyStudy) -> Option<String> {
    let kinds: Vec<&str> = study.knobs.iter().map(|k| k.kind.name()).collect();
    let all: Vec<Series<'_>> = study.knobs.iter().map(of_knob).collect();
    drawn(title, &format!("for {}", kinds.join(", ")), &all)
}

/// The work–precision diagram of a motion under loads; `None` where it has no point.
#[must_use]
pub fn of_runs(title: &str, study: &RunStudy) -> Option<String> {
    let all: Vec<Series<'_>> = study.methods.iter().flat_map(of_method).collect();
    drawn(title, "of the whole motion, true and reported", &all)
}

fn drawn(title: &str, of: &str, all: &[Series<'_>]) -> Option<String> {
    let points = || all.iter().flat_map(|series| series.points.iter().copied());
    let x = Axis::over(points().map(|p| p.0), 0.0, WIDTH)?;
    let y = Axis::over(points().map(|p| p.1), 0.0, -HEIGHT)?;
    let description = format!("Greatest relative error against time in µs, both logarithmic, {of}.");
    let mut drawing = Drawing::new("accuracy", format!("{title}: error against time"), description);
    written(&mut drawing, title, TITLE, Vec2::new(0.0, -HEIGHT - 11.0), Vec2::new(1.0, 0.0));
    axes(&mut drawing, &x, &y);
    for line in all {
        series(&mut drawing, line, &x, &y);
    }
    legend(&mut drawing, all);
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

fn series(drawing: &mut Drawing, line: &Series<'_>, x: &Axis, y: &Axis) {
    drawing.begin("series", &line.name);
    let places: Vec<Vec2> = line.points.iter().map(|p| Vec2::new(x.place(p.0), y.place(p.1))).collect();
    if let (Some(style), true) = (line.line, places.len() > 1) {
        drawing.mark(style, Shape::Lines { points: places.clone(), closed: false });
    }
    for at in &places {
        mark(drawing, line.sign, *at);
    }
    for (name, at) in line.names.iter().zip(&places) {
        let side = Vec2::new(if at.x > 0.8 * WIDTH { -1.0 } else { 1.0 }, 0.0);
        drawing.label(Label::at(Text::upright(name), NUMBERS, *at, SIGN).towards(side).ranked(1));
    }
    drawing.end();
}

fn legend(drawing: &mut Drawing, all: &[Series<'_>]) {
    let right = Vec2::new(1.0, 0.0);
    for (i, line) in all.iter().enumerate() {
        let at = Vec2::new(WIDTH + LEGEND, -HEIGHT + 3.0 + LINE * i as f64);
        mark(drawing, line.sign, at);
        written(drawing, &line.name, WORDS, at + right * 2.0, right);
        if !line.below.is_empty() {
            written(drawing, &line.below, NUMBERS, at + Vec2::new(2.0, 4.6), right);
        }
    }
}
