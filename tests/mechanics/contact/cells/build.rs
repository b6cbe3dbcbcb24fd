//! A file and the system of the oracle, written from the same numbers.

use super::super::oracle::{Constraint, Element, Law, Load, Part, Scalar, Stop, System};
use crate::support::random::Random;
use std::fmt::Write;
use std::rc::Rc;

pub const GRAVITY: f64 = 9.81;

/// A place on a body, from its mass centre, or in the plane.
#[derive(Clone, Copy)]
pub struct Place {
    pub body: Option<usize>,
    pub at: [f64; 2],
}

/// A link: its first coordinate, its mass centre in its frame.
#[derive(Clone, Copy)]
pub struct Body {
    pub base: usize,
    pub centre: [f64; 2],
}

impl Body {
    /// A point by its coordinates in the frame of the link.
    pub fn point(self, at: [f64; 2]) -> Place {
        Place { body: Some(self.base), at: [at[0] - self.centre[0], at[1] - self.centre[1]] }
    }
}

pub const fn fixed(at: [f64; 2]) -> Place {
    Place { body: None, at }
}

impl Place {
    pub fn angle(self, q: &[f64]) -> f64 {
        self.body.map_or(0.0, |base| q[base + 2])
    }

    pub fn of(self, q: &[f64]) -> [f64; 2] {
        let Some(base) = self.body else { return self.at };
        let (sin, cos) = q[base + 2].sin_cos();
        [q[base] + cos * self.at[0] - sin * self.at[1], q[base + 1] + sin * self.at[0] + cos * self.at[1]]
    }
}

/// A function of the coordinates of some bodies.
pub fn scalar(of: &[Place], value: impl Fn(&[f64]) -> f64 + 'static) -> Scalar {
    let on = of.iter().filter_map(|place| place.body).flat_map(|base| base..base + 3).collect();
    Scalar { on, value: Rc::new(value), linear: false }
}

/// How far the first place is from the second along a line on the second's body.
pub fn along(a: Place, b: Place, line: f64) -> Scalar {
    scalar(&[a, b], move |q| {
        let ([x, y], [u, v], angle) = (a.of(q), b.of(q), b.angle(q) + line);
        (x - u) * angle.cos() + (y - v) * angle.sin()
    })
}

pub fn turned(a: Place, b: Place) -> Scalar {
    Scalar { linear: true, ..scalar(&[a, b], move |q| a.angle(q) - b.angle(q)) }
}

pub fn linear(on: &[usize], value: impl Fn(&[f64]) -> f64 + 'static) -> Scalar {
    Scalar { on: on.to_vec(), value: Rc::new(value), linear: true }
}

/// A single coordinate, as of shafts and sliders.
pub fn single(i: usize) -> Scalar {
    linear(&[i], move |q| q[i])
}

pub fn part(even: f64, of: &[usize]) -> Part {
    Part { even, odd: 0.0, of: of.to_vec() }
}

/// What is asked: the words, and what the oracle has for them.
pub enum Asked {
    Value(Scalar),
    Rate(Scalar),
    /// the multiplier of a drive
    Effort(usize),
}

#[derive(Default)]
pub struct Scene {
    pub system: System,
    pub guess: Vec<f64>,
    pub ground: String,
    pub text: String,
    pub starts: Vec<(Scalar, f64, f64)>,
    pub asked: Vec<(String, Asked)>,
    /// the program says that it does not solve this
    pub refused: bool,
}

/// Writes a line of the file.
macro_rules! line {
    ($scene:expr, $($words:tt)*) => { { writeln!($scene.text, $($words)*).unwrap(); } };
}
pub(super) use line;

impl Scene {
    /// The coordinates of a link of this mass, inertia, mass centre in its frame, and place of its frame.
    pub fn body(&mut self, mass: f64, inertia: f64, centre: [f64; 2], [x, y, angle]: [f64; 3]) -> Body {
        let base = self.guess.len();
        let (sin, cos) = angle.sin_cos();
        let at = [x + cos * centre[0] - sin * centre[1], y + sin * centre[0] + cos * centre[1], angle];
        self.guess.extend(at);
        self.system.mass.extend([mass, mass, inertia]);
        self.system.weight.extend([0.0, -mass * GRAVITY, 0.0]);
        Body { base, centre }
    }

    /// A coordinate of its own.
    pub fn coordinate(&mut self, mass: f64, weight: f64) -> usize {
        self.guess.push(0.0);
        self.system.mass.push(mass);
        self.system.weight.push(weight);
        self.guess.len() - 1
    }

    pub fn constrain(&mut self, of: Scalar) -> usize {
        self.system.constraints.push(Constraint { of, law: None, bond: false });
        self.system.constraints.len() - 1
    }

    /// The multipliers are the force on the first place.
    pub fn hinge(&mut self, a: Place, b: Place) -> [usize; 2] {
        [0, 1].map(|i| self.constrain(scalar(&[a, b], move |q| a.of(q)[i] - b.of(q)[i])))
    }

    /// The multiplier is the normal force on the first place.
    pub fn guide(&mut self, a: Place, b: Place, line: f64) -> usize {
        self.constrain(scalar(&[a, b], move |q| a.angle(q) - b.angle(q) - line));
        self.constrain(along(a, b, line + std::f64::consts::FRAC_PI_2))
    }

    pub fn drive(&mut self, name: &str, of: Scalar, (words, law): (String, Law)) {
        line!(self, "drive {name} = {words}");
        self.system.constraints.push(Constraint { of, law: Some(law), bond: false });
        self.asked.push((format!("effort({name})"), Asked::Effort(self.system.constraints.len() - 1)));
    }

    /// A start of a coordinate whose value and rate are asked in these words.
    pub fn start(&mut self, name: &str, unit: &str, of: Scalar, [at, rate]: [f64; 2], words: [&str; 2]) {
        line!(self, "start {name} = {at} {unit} at {rate} {unit}/s");
        self.asked.push((words[0].to_owned(), Asked::Value(of.clone())));
        self.asked.push((words[1].to_owned(), Asked::Rate(of.clone())));
        self.starts.push((of, at, rate));
    }

    /// A start of a guide.
    pub fn start_guide(&mut self, name: &str, of: Scalar, start: [f64; 2]) {
        let words = [format!("displacement({name})"), format!("relative_velocity({name})")];
        self.start(name, "m", of, start, [&words[0], &words[1]]);
    }

    /// A start of a link that turns.
    pub fn start_link(&mut self, name: &str, of: Scalar, start: [f64; 2]) {
        let words = [format!("angle({name}) as rad"), format!("omega({name})")];
        self.start(name, "rad", of, start, [&words[0], &words[1]]);
    }

    pub fn rub(&mut self, of: Scalar, parts: Vec<Part>, capacity: f64, at_rest: f64) {
        let capacity = Rc::new(move |_| capacity);
        self.system.elements.push(Element { of, parts, capacity, at_rest, driven: false });
    }

    pub fn stop(&mut self, name: &str, unit: &str, of: Scalar, [sense, at, restitution]: [f64; 3]) {
        let sign = if sense > 0.0 { '>' } else { '<' };
        line!(self, "stop {name} {sign} {at} {unit} {{ restitution {restitution} }}");
        self.system.stops.push(Stop { of, sense, at, restitution });
    }

    /// A load of a random kind and about this size, in either direction; `write` makes a statement of a name, a value and its ending.
    pub fn load(
        &mut self,
        random: &mut Random,
        of: &Scalar,
        size: f64,
        how: &Loaded,
        write: impl Fn(&str, &str, &str) -> String,
    ) {
        let Loaded { unit, coordinate, length } = how;
        let size = rounded(size * random.sign());
        let rate = rounded(random.within(3.0, 12.0));
        let law: Load = match random.below(7) {
            0 => return,
            1 => {
                self.text += &write("P1", &format!("{size} {unit}"), "");
                Rc::new(move |_, _, _| size)
            }
            2 => {
                self.text += &write("P1", &format!("{size} {unit}/s*time"), "");
                Rc::new(move |t, _, _| size * t)
            }
            3 => {
                self.text += &write("P1", &format!("{size} {unit}*sin({rate} rad/s*time)"), "");
                Rc::new(move |t, _, _| size * (rate * t).sin())
            }
            4 => {
                self.text += &write("P1", &format!("{size} {unit}*cos({rate} rad/s*time)"), "");
                Rc::new(move |t, _, _| size * (rate * t).cos())
            }
            5 => {
                let [first, second] = [rounded(random.within(0.1, 0.3)), rounded(random.within(0.35, 0.6))];
                let back = rounded(size * random.within(-1.2, 0.5));
                self.text += &write("P1", &format!("{size} {unit}"), &format!(" when time < {first} s"));
                self.text += &write("P2", &format!("{back} {unit}"), &format!(" when time > {second} s"));
                self.system.breaks.extend([first, second]);
                Rc::new(move |_, within, _| {
                    if within < first {
                        size
                    } else if within > second {
                        back
                    } else {
                        0.0
                    }
                })
            }
            _ => {
                let (stiffness, middle) = (rounded(size.abs() * 5.0), rounded(random.within(-0.3, 0.3)));
                self.text += &write(
                    "P1",
                    &format!("{stiffness} {unit}/{length}*({middle} {length} - {coordinate})"),
                    "",
                );
                Rc::new(move |_, _, at| stiffness * (middle - at))
            }
        };
        self.system.loads.push((of.clone(), law));
    }
}

/// The unit of a load, and the coordinate along which it acts with its unit.
pub struct Loaded<'a> {
    pub unit: &'a str,
    pub coordinate: &'a str,
    pub length: &'a str,
}

/// Four digits, so that files are short.
pub fn rounded(x: f64) -> f64 {
    (x * 1e4).round() / 1e4
}

/// How a drive moves, or a free coordinate begins.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum Begins {
    Rest,
    With,
    Against,
    Reversal,
    Dwell,
    Stop,
}

pub const BEGINS: [Begins; 6] =
    [Begins::Rest, Begins::With, Begins::Against, Begins::Reversal, Begins::Dwell, Begins::Stop];

/// A drive's law of this size, in its words, with the instants where it is not smooth.
pub fn drive_law(
    scene: &mut Scene,
    random: &mut Random,
    begins: Begins,
    size: f64,
    unit: &str,
) -> (String, Law) {
    let (size, rate) = (rounded(size), rounded(random.within(5.0, 10.0)));
    match begins {
        Begins::Reversal => (
            format!("{size} {unit}*(1 - cos({rate} rad/s*time))"),
            Rc::new(move |t, _| {
                let (sin, cos) = (rate * t).sin_cos();
                [size * (1.0 - cos), size * rate * sin, size * rate * rate * cos]
            }),
        ),
        Begins::Dwell => {
            let phase = rounded(random.within(0.5, 1.5));
            let pi = std::f64::consts::PI;
            scene.system.breaks.extend((0..8).map(|i| (phase + f64::from(i) * pi) / rate));
            (
                format!("{size} {unit}*max(0, sin({rate} rad/s*time - {phase} rad))^2"),
                Rc::new(move |t, within| {
                    let (sin, cos) = (rate * t - phase).sin_cos();
                    if (rate * within - phase).sin() < 0.0 {
                        return [0.0; 3];
                    }
                    [
                        size * sin * sin,
                        2.0 * size * rate * sin * cos,
                        2.0 * size * rate * rate * (cos * cos - sin * sin),
                    ]
                }),
            )
        }
        Begins::Rest if random.chance(0.5) => {
            let speed = rounded(size * rate);
            (format!("0 {unit} at {speed} {unit}/s"), Rc::new(move |t, _| [speed * t, speed, 0.0]))
        }
        _ => (
            format!("{size} {unit}*sin({rate} rad/s*time)"),
            Rc::new(move |t, _| {
                let (sin, cos) = (rate * t).sin_cos();
                [size * sin, size * rate * cos, -size * rate * rate * sin]
            }),
        ),
    }
}

/// Rate of a free coordinate at the start.
pub fn first_rate(random: &mut Random, begins: Begins, size: f64) -> f64 {
    match begins {
        Begins::With => rounded(random.within(0.2, 1.0) * size),
        Begins::Against => -rounded(random.within(0.2, 1.0) * size),
        _ => 0.0,
    }
}
