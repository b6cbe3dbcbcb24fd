//! Work and precision of a motion under loads: what each accuracy takes by each method, and what it gives.

use super::{DOWN, LEFT, NUMBERS, RIGHT, WORDS, head, paragraph, written};
use crate::report::cost::{change, size, time, unit};
use assur_drawing::{Drawing, Label, Level, Role, Shape, Style, Text, Theme};
use assur_math::math::Vec2;
use assur_solve::measure::{Choice, MethodStudy, RunStudy};
use assur_solve::solve::Method;
use assur_text::units::significant;

/// The frame of the axes, mm; y of paper points down.
const WIDTH: f64 = 94.0;
const HEIGHT: f64 = 66.0;
/// What is left of it, for the numbers.
const SIDE: f64 = 11.0;
/// Length of a tick, half the size of a sign, and the rings around it.
const TICK: f64 = 1.1;
const SIGN: f64 = 1.15;
const RING: f64 = 2.3;
/// Points that are nearer to each other have one label.
const CLOSE: f64 = 4.5;

/// How a method is drawn: its line, its signs, its colour.
struct Look {
    line: Style,
    dot: Style,
    role: Role,
    corners: &'static [(f64, f64)],
}

const CIRCLE: Look = Look { line: Style::Velocity, dot: Style::BlueDot, role: Role::Blue, corners: &[] };
const SQUARE: Look = Look {
    line: Style::Curve4,
    dot: Style::GreenDot,
    role: Role::Green,
    corners: &[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)],
};
const TRIANGLE: Look = Look {
    line: Style::Curve3,
    dot: Style::VermilionDot,
    role: Role::Vermilion,
    corners: &[(0.0, -1.3), (1.25, 0.9), (-1.25, 0.9)],
};

const fn look_of(study: &MethodStudy) -> &'static Look {
    match study.asked {
        None => &CIRCLE,
        Some(Method::Radau) => &TRIANGLE,
        Some(_) => &SQUARE,
    }
}

const fn name_of(study: &MethodStudy) -> &'static str {
    match (study.asked, study.method) {
        (None, Method::Energy) => "energy",
        (None, Method::Radau) => "DOP853, then Radau",
        (Some(Method::Radau), _) => "Radau IIA",
        (_, _) => "DOP853",
    }
}

/// A sign about a place; hollow where the accuracy was not kept.
fn mark(drawing: &mut Drawing, look: &Look, at: Vec2, hollow: bool) {
    let shape = if look.corners.is_empty() {
        Shape::Circle { centre: at, radius: SIGN }
    } else {
        Shape::polygon(look.corners.iter().map(|(x, y)| at + Vec2::new(*x, *y) * SIGN).collect())
    };
    drawing.mark(if hollow { Style::Hinge } else { look.dot }, shape);
}

/// What is drawn, and where.
struct Frame<'s> {
    study: &'s RunStudy,
    /// The front of each method, with the file's own and the recommended accuracy.
    shown: Vec<Vec<Choice>>,
    x: Axis,
    y: Axis,
    /// The unit of times, µs.
    unit: (&'static str, f64),
}

impl Frame<'_> {
    fn at(&self, choice: Choice) -> Vec2 {
        let row = self.study.row(choice);
        Vec2::new(self.x.place(row.micros / self.unit.1), self.y.place(row.error))
    }
}

/// The accuracies of a method that none of its others beats: its line goes only forward.
fn front(study: &RunStudy, method: usize) -> Vec<Choice> {
    study.front(|of, row| of == method && row.error.is_finite())
}

/// The work–precision diagram of a motion under loads; `None` where it has no point.
#[must_use]
pub fn of_runs(title: &str, study: &RunStudy) -> Option<String> {
    let mut shown: Vec<Vec<Choice>> = (0..study.methods.len()).map(|method| front(study, method)).collect();
    for choice in [study.own(), study.recommendation].into_iter().flatten() {
        if study.row(choice).error.is_finite() && !shown[choice.method].contains(&choice) {
            shown[choice.method].push(choice);
        }
    }
    let rows = || shown.iter().flatten().map(|choice| study.row(*choice));
    let longest = rows().map(|row| row.micros).fold(0.0, f64::max);
    let unit = unit(longest);
    let x = Axis::over(rows().map(|row| row.micros / unit.1), 0.0, WIDTH)?;
    let y = Axis::over(rows().map(|row| row.error), 0.0, -HEIGHT)?;
    let finding = sentence(study);
    let mut drawing = Drawing::new("accuracy", format!("What accuracy costs: {title}"), finding.clone());
    head(&mut drawing, &format!("What accuracy costs: {title}"), &finding, -SIDE, -HEIGHT - 6.0);
    let frame = Frame { study, shown, x, y, unit };
    axes(&mut drawing, &frame);
    (0..study.methods.len()).for_each(|method| line(&mut drawing, &frame, method));
    rings(&mut drawing, &frame);
    let mut below = 15.5;
    let note = "At each point: the value of --within. Hollow: that was not kept. Circles: the method that solve chooses.";
    paragraph(&mut drawing, note, (NUMBERS, Role::Grey), -SIDE, &mut below);
    if let Some(note) = left_out(&frame) {
        paragraph(&mut drawing, &note, (NUMBERS, Role::Grey), -SIDE, &mut below);
    }
    Some(drawing.placed().svg(Theme::Auto))
}

/// The settings without a point: those that another beats in error and time, and those without an error.
fn left_out(frame: &Frame<'_>) -> Option<String> {
    let of_method = |(method, study): (usize, &MethodStudy)| {
        let shown = |row: usize| frame.shown[method].contains(&Choice { method, row });
        let rows = study.rows.iter().enumerate().filter(|(row, _)| !shown(*row));
        let rows: Vec<String> = rows.map(|(_, row)| size(row.within)).collect();
        (!rows.is_empty()).then(|| format!("{}: {}", name_of(study), rows.join(", ")))
    };
    let all: Vec<String> = frame.study.methods.iter().enumerate().filter_map(of_method).collect();
    (!all.is_empty())
        .then(|| format!("Not drawn, since another is better or no error is known: {}.", all.join("; ")))
}

/// What the picture shows.
fn sentence(study: &RunStudy) -> String {
    match study.own().map(|own| study.row(own)) {
        Some(own) if own.missed => {
            format!("This file does not keep its `within {}`. {}", size(study.asked), finding(study))
        }
        _ => finding(study),
    }
}

fn finding(study: &RunStudy) -> String {
    let most = study.front(|_, row| !row.missed).last().copied();
    let end = most.map_or_else(String::new, |most| {
        format!("no setting goes beyond {:.1} digits", study.row(most).digits())
    });
    let Some((found, most)) = study.recommendation.zip(most) else {
        return format!("No setting keeps an error of {}: {end}.", size(study.wanted));
    };
    let (from, to) = (study.row(found), study.row(most));
    let more = to.digits() - from.digits();
    let each = if more < 0.5 {
        String::new()
    } else {
        format!(
            ", each further digit {} more time",
            change(libm::pow(to.micros / from.micros, 1.0 / more)).trim_start_matches('+')
        )
    };
    format!("An error below {} takes {}{each}; {end}.", size(study.wanted), time(from.micros))
}

fn axes(drawing: &mut Drawing, frame: &Frame<'_>) {
    for tick in frame.x.ticks() {
        let at = Vec2::new(frame.x.place(tick), 0.0);
        drawing.line(Style::Grid, at, Vec2::new(at.x, -HEIGHT));
        drawing.line(Style::Medium, at, at + DOWN * TICK);
        written(drawing, &significant(tick, 1), (NUMBERS, Role::Ink), at + DOWN * (TICK + 0.3), DOWN);
    }
    for power in frame.y.powers(8.0) {
        let at = Vec2::new(0.0, frame.y.place(libm::pow(10.0, power)));
        let end = Vec2::new(WIDTH, at.y);
        drawing.line(Style::Grid, at, end);
        drawing.line(Style::Medium, at, at + LEFT * TICK);
        drawing.line(Style::Medium, end, end + RIGHT * TICK);
        let number = Text::upright("10").and(&significant(power, 2).replace('-', "−"), false, Level::Sup);
        drawing.label(Label::at(number, NUMBERS, at + LEFT * (TICK + 0.3), 0.3).towards(LEFT).ranked(0));
        written(drawing, &significant(-power, 2), (NUMBERS, Role::Ink), end + RIGHT * (TICK + 0.3), RIGHT);
    }
    let corners = [(0.0, 0.0), (WIDTH, 0.0), (WIDTH, -HEIGHT), (0.0, -HEIGHT)];
    drawing.mark(Style::Medium, Shape::polygon(corners.map(|(x, y)| Vec2::new(x, y)).to_vec()));
    let words = format!("time of the whole run, {}", frame.unit.0);
    written(drawing, &words, (WORDS, Role::Ink), Vec2::new(WIDTH / 2.0, 7.0), DOWN);
    written(drawing, "error", (WORDS, Role::Ink), Vec2::new(-SIDE, -HEIGHT - 3.0), RIGHT);
    written(drawing, "digits", (WORDS, Role::Ink), Vec2::new(WIDTH + 9.0, -HEIGHT - 3.0), LEFT);
    // the good corner
    drawing.mark(Style::Ghost, Shape::Arrow(Vec2::new(9.0, -7.0), Vec2::new(2.0, -1.8)));
    written(drawing, "better", (NUMBERS, Role::Grey), Vec2::new(9.5, -7.5), RIGHT);
}

fn line(drawing: &mut Drawing, frame: &Frame<'_>, method: usize) {
    let (study, look) = (&frame.study.methods[method], look_of(&frame.study.methods[method]));
    let shown = &frame.shown[method];
    let Some(first) = shown.first() else { return };
    drawing.begin("series", name_of(study));
    let points: Vec<Vec2> = front(frame.study, method).into_iter().map(|choice| frame.at(choice)).collect();
    if points.len() > 1 {
        drawing.mark(look.line, Shape::Lines { points, closed: false });
    }
    let name = Label::at(Text::upright(name_of(study)), WORDS, frame.at(*first), SIGN);
    drawing.label(name.coloured(look.role).towards(Vec2::new(0.3, -1.0)).ranked(2));
    let mut last: Option<Vec2> = None;
    for choice in shown {
        let (row, at) = (frame.study.row(*choice), frame.at(*choice));
        mark(drawing, look, at, row.missed);
        let own = frame.study.own() == Some(*choice);
        let ringed = own || frame.study.recommendation == Some(*choice);
        if ringed || last.is_none_or(|last| (at - last).norm() > CLOSE) {
            let within = size(if own { frame.study.asked } else { row.within });
            let radius = if ringed { RING } else { SIGN };
            let label = Label::at(Text::upright(&within), NUMBERS, at, radius);
            drawing.label(label.coloured(look.role).towards(RIGHT).ranked(3));
            last = Some(at);
        }
    }
    drawing.end();
}

/// The file's own accuracy and the one that is recommended.
fn rings(drawing: &mut Drawing, frame: &Frame<'_>) {
    let (own, found) = (frame.study.own(), frame.study.recommendation);
    let wide = if own == found { RING + 0.7 } else { RING };
    for (choice, style, radius, words) in
        [(own, Style::Medium, RING, "this file"), (found, Style::Dashed, wide, "recommended")]
    {
        let shown = choice.filter(|choice| frame.shown[choice.method].contains(choice));
        if let Some(at) = shown.map(|choice| frame.at(choice)) {
            drawing.mark(style, Shape::Circle { centre: at, radius });
            drawing.label(Label::at(Text::upright(words), NUMBERS, at, radius).towards(LEFT).ranked(1));
        }
    }
}

// A logarithmic axis.

/// A logarithmic axis and where it lies.
pub(super) struct Axis {
    from: f64,
    to: f64,
    start: f64,
    end: f64,
}

impl Axis {
    /// Over positive numbers, with something to spare, more of it at the small ones.
    pub(super) fn over(values: impl Iterator<Item = f64>, start: f64, end: f64) -> Option<Self> {
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for x in values.filter(|x| *x > 0.0).map(libm::log10) {
            (least, greatest) = (least.min(x), greatest.max(x));
        }
        let spare = 0.15_f64.max(0.08 * (greatest - least));
        (least <= greatest).then_some(Self { from: least - 2.5 * spare, to: greatest + spare, start, end })
    }

    pub(super) fn place(&self, x: f64) -> f64 {
        self.start + (libm::log10(x) - self.from) / (self.to - self.from) * (self.end - self.start)
    }

    /// Powers of ten on the axis, and about how many at most.
    pub(super) fn powers(&self, most: f64) -> Vec<f64> {
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
    pub(super) fn ticks(&self) -> Vec<f64> {
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
