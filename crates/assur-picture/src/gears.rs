//! Two wheels in mesh from the front: their circles, involute teeth where they meet, the line of action with its active part.

use crate::figures::plain;
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Subject;
use crate::scheme::length_scale;
use crate::symbol::{gear::TEETH, hinge};
use assur_drawing::{Drawing, Label, Level, Rect, Shape, Style, Text};
use assur_math::element::gear::{Gear, GearPair, involute};
use assur_math::math::Vec2;
use assur_model::model::Gears;
use assur_text::diagnostic::Diagnosis;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// What names take beside the wheels, mm.
const AROUND: Vec2 = Vec2::new(26.0, 20.0);
const NAMES: f64 = 4.0;
const RADII: f64 = 3.4;
/// Points of a flank.
const PARTS: u32 = 16;
/// How far circles go beyond their teeth, in pitches, and at most to each side.
const BEYOND: f64 = 0.75;
const WIDEST: f64 = 0.9 * PI;
/// Radius of a point, of the arc of the working pressure angle, half the common tangent, mm.
const POINT: f64 = 0.6;
const ARC: f64 = 15.0;
const TANGENT: f64 = 21.0;

/// A picture per mesh of wheels whose teeth and module are known.
///
/// # Errors
/// There is none; a scale is wanted that does not fit.
pub fn gears(subject: &Subject<'_, '_>, paper: &Paper) -> Result<Vec<Drawing>, Diagnosis> {
    let all = &subject.mechanism.gears;
    if all.is_empty() {
        let why = "there are no teeth to draw: no mesh has wheels with teeth and a module";
        return Err(Diagnosis::error("mech::picture::no_gears", why).help(
            "write both: `shaft I { wheel a teeth 18 module 2 mm }`, `shaft II { wheel b teeth 42 }`, `mesh k: a - b`",
        ));
    }
    all.iter().map(|gears| picture(subject, gears, paper)).collect()
}

fn picture(subject: &Subject<'_, '_>, gears: &Gears, paper: &Paper) -> Result<Drawing, Diagnosis> {
    let pair = &gears.pair;
    let wheels = [Placed::of(pair, 0), Placed::of(pair, 1)];
    let mut bounds = Rect::NOTHING;
    for wheel in &wheels {
        bounds.add(wheel.centre);
        wheel.teeth().into_iter().for_each(|at| bounds.add(at));
    }
    let frame = paper.frame(Scaled::Length, &bounds, AROUND)?;
    let [one, two] = &gears.wheels;
    let title = format!("{}: wheels {one} and {two}", subject.title());
    let id = subject.id(&format!("gears-{}", gears.mesh));
    let mut drawing = Drawing::new(&id, title, said(gears));
    for (i, wheel) in wheels.iter().enumerate() {
        drawing.begin("wheel", &gears.wheels[i]);
        wheel.draw(&mut drawing, &frame, i + 1);
        drawing.end();
    }
    action(&mut drawing, pair, &frame);
    for (i, wheel) in wheels.iter().enumerate() {
        let at = frame.point(wheel.centre);
        hinge::moving(&mut drawing, at);
        point(&mut drawing, at, ("O", i + 1), Vec2::new(-wheel.side, 0.6));
    }
    drawing.caption(measures(pair));
    drawing.captions.extend(frame.scale.map(|scale| length_scale(&scale)));
    Ok(drawing)
}

fn said(gears: &Gears) -> String {
    let pair = &gears.pair;
    let wheel = |i: usize| {
        let (gear, name, z) = (&pair.gears[i], &gears.wheels[i], pair.teeth.z[i]);
        let radii = [gear.da, gear.d, gear.dw, gear.db, gear.df].map(|d| plain(500.0 * d));
        format!(
            "Wheel {name} with {z} teeth, radii in mm: tip {}, reference {}, working {}, base {}, root {}.",
            radii[0], radii[1], radii[2], radii[3], radii[4]
        )
    };
    let (length, pitch) = (plain(1e3 * pair.g), plain(1e3 * pair.pb));
    format!("{} {} Active part of the line of action {length} mm, base pitch {pitch} mm.", wheel(0), wheel(1))
}

/// `m = 2 mm, z₁ = 17, z₂ = 40, a = 58.468 mm, …`
fn measures(pair: &GearPair) -> Text {
    let [z_1, z_2] = pair.teeth.z;
    let numbers = [
        ("m", "", format!("{} mm", plain(1e3 * pair.teeth.module))),
        ("z", "1", plain(z_1)),
        ("z", "2", plain(z_2)),
        ("a", "", format!("{} mm", plain(1e3 * pair.a))),
        ("α", "w", format!("{}°", plain(pair.alpha_w.to_degrees()))),
        ("ε", "", plain(pair.ratio)),
    ];
    let mut text = Text::default();
    for (i, (letter, index, value)) in numbers.into_iter().enumerate() {
        text = text.and(if i > 0 { ",  " } else { "" }, false, Level::Base).and(letter, true, Level::Base);
        if !index.is_empty() {
            text = text.and(index, index == "w", Level::Sub);
        }
        text = text.and(&format!(" = {value}"), false, Level::Base);
    }
    text
}

/// A wheel in its place: the axis of the pinion is the origin, the pitch point lies on x, m.
struct Placed<'g> {
    gear: &'g Gear,
    z: f64,
    pressure_angle: f64,
    centre: Vec2,
    /// 1 towards the pitch point along x, or −1.
    side: f64,
    /// −1 of a ring, the teeth of which point inwards.
    out: f64,
    /// The middle of the tooth that has a flank at the pitch point.
    middle: f64,
}

impl<'g> Placed<'g> {
    fn of(pair: &'g GearPair, index: usize) -> Self {
        let is_ring = pair.teeth.internal && index == 1;
        let (x, side) = match (index, is_ring) {
            (0, _) => (0.0, 1.0),
            (_, false) => (pair.a, -1.0),
            (_, true) => (-pair.a, 1.0),
        };
        let (gear, z) = (&pair.gears[index], pair.teeth.z[index]);
        let (centre, out) = (Vec2::new(x, 0.0), if is_ring { -1.0 } else { 1.0 });
        let mut placed =
            Self { gear, z, pressure_angle: pair.teeth.pressure_angle, centre, side, out, middle: 0.0 };
        // the tooth of the pinion is below its flank at the pitch point, that of the other above
        let half = placed.half(0.5 * gear.dw);
        placed.middle = if index == 0 { -half } else { placed.towards() - side.signum() * -half };
        placed
    }

    /// The angle of the pitch point.
    fn towards(&self) -> f64 {
        if self.side > 0.0 { 0.0 } else { PI }
    }

    /// Half the angle of a tooth at a radius; below the base circle that at it.
    fn half(&self, radius: f64) -> f64 {
        let angle = libm::acos((0.5 * self.gear.db / radius).min(1.0));
        self.gear.s / self.gear.d + self.out * (involute(self.pressure_angle) - involute(angle))
    }

    fn on(&self, radius: f64, angle: f64) -> Vec2 {
        self.centre + Vec2::direction(angle) * radius
    }

    /// Radii of a flank, from the root to the tip: a short radial part, then the involute in equal steps of its angle.
    fn radii(&self) -> Vec<f64> {
        let [base, root, tip] = [self.gear.db, self.gear.df, self.gear.da].map(|d| 0.5 * d);
        let angle = |radius: f64| libm::acos((base / radius).min(1.0));
        let (from, to) = (angle(root.max(base)), angle(tip));
        let radius = |i: u32| base / libm::cos(from + (to - from) * f64::from(i) / f64::from(PARTS));
        let below = (root < base).then_some(root);
        below.into_iter().chain((0..=PARTS).map(radius)).collect()
    }

    /// The outline of the teeth about the pitch point.
    fn teeth(&self) -> Vec<Vec2> {
        let (radii, pitch) = (self.radii(), TAU / self.z);
        let (root, tip) = (0.5 * self.gear.df, 0.5 * self.gear.da);
        let mut points = Vec::new();
        for tooth in -TEETH..=TEETH {
            let middle = self.middle + pitch * f64::from(tooth);
            points.extend(radii.iter().map(|r| self.on(*r, middle - self.half(*r))));
            points.push(self.on(tip, middle));
            points.extend(radii.iter().rev().map(|r| self.on(*r, middle + self.half(*r))));
            if tooth < TEETH {
                points.push(self.on(root, middle + 0.5 * pitch));
            }
        }
        points
    }

    fn draw(&self, drawing: &mut Drawing, frame: &Frame, number: usize) {
        let is_one = (self.gear.d - self.gear.dw).abs() < 1e-9 * self.gear.d;
        let circles = [
            (Style::Thin, self.gear.da, Some("a")),
            (Style::Axis, self.gear.d, Some("")),
            (Style::Axis, self.gear.dw, Some("w").filter(|_| !is_one)),
            (Style::Dashed, self.gear.db, Some("b")),
            (Style::Thin, self.gear.df, Some("f")),
        ];
        let half = ((f64::from(TEETH) + BEYOND) * TAU / self.z).min(WIDEST);
        for (style, diameter, index) in circles {
            let Some(index) = index else { continue };
            let (centre, radius) = (frame.point(self.centre), frame.length(0.5 * diameter));
            // y of paper goes down
            let from = -self.towards() - half;
            drawing.mark(style, Shape::Arc { centre, radius, from, sweep: 2.0 * half });
            let end = frame.point(self.on(0.5 * diameter, self.towards() + self.side * half));
            let mut text = Text::italic("r").lowered(&format!("{index}{number}"));
            if is_one && index.is_empty() {
                text = text.and(" = r", true, Level::Base).lowered(&format!("w{number}"));
            }
            let along = Vec2::direction(self.towards() + self.side * (half + FRAC_PI_2));
            drawing.label(Label::at(text, RADII, end, 0.6).towards(Vec2::new(along.x, -along.y)).ranked(3));
        }
        let points = self.teeth().into_iter().map(|at| frame.point(at)).collect();
        drawing.mark(Style::Medium, Shape::Lines { points, closed: false });
    }
}

/// The line of centres, the line of action with the points that bound it, the working pressure angle.
fn action(drawing: &mut Drawing, pair: &GearPair, frame: &Frame) {
    let pitch = Vec2::new(0.5 * pair.gears[0].dw, 0.0);
    let (sin, cos) = libm::sincos(pair.alpha_w);
    let line = Vec2::new(sin, cos);
    let out = if pair.teeth.internal { -1.0 } else { 1.0 };
    let on = |along: f64| frame.point(pitch + line * along);
    let to_base = |i: usize| 0.5 * pair.gears[i].db * libm::tan(pair.alpha_w);
    let ends = [on(-to_base(0)), on(out * to_base(1))];
    let active = [on(pair.gears[0].approach), on(-pair.gears[1].approach)];
    let (at, axis) = (frame.point(pitch), if pair.teeth.internal { -pair.a } else { pair.a });
    drawing.begin("axis", "");
    let far = if pair.teeth.internal { pitch.x } else { pair.a };
    drawing.line(Style::Axis, frame.point(Vec2::new(axis.min(0.0), 0.0)), frame.point(Vec2::new(far, 0.0)));
    drawing.line(Style::Axis, at + Vec2::new(0.0, TANGENT), at - Vec2::new(0.0, TANGENT));
    drawing.begin("action", "");
    let reach = |ends: [Vec2; 2]| ends.map(|end| (end - at).dot(Vec2::new(sin, -cos)));
    let all = [reach(ends), reach(active)].concat();
    let [from, to] = [all.iter().copied().fold(0.0, f64::min), all.iter().copied().fold(0.0, f64::max)];
    let along = Vec2::new(sin, -cos);
    drawing.line(Style::Thin, at + along * from, at + along * to.max(ARC));
    drawing.line(Style::Drive, active[1], active[0]);
    let arc = Shape::Arc { centre: at, radius: ARC, from: -FRAC_PI_2, sweep: pair.alpha_w };
    drawing.mark(Style::Thin, arc);
    let middle = Vec2::direction(0.5 * pair.alpha_w - FRAC_PI_2);
    let angle = Text::italic("α").and("w", true, Level::Sub);
    drawing.label(Label::at(angle, NAMES, at + middle * ARC, 0.5).towards(middle).ranked(2));
    let across = Vec2::new(cos, sin);
    for i in [0, 1] {
        let side = if i == 0 { across } else { -across };
        point(drawing, ends[i], ("N", i + 1), side);
        point(drawing, active[i], ("B", i + 1), -side);
    }
    drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: POINT });
    drawing.label(Label::at(Text::italic("C"), NAMES, at, POINT).towards(Vec2::new(1.0, 1.0)).ranked(1));
    drawing.end();
}

/// A point with its name.
fn point(drawing: &mut Drawing, at: Vec2, (letter, number): (&str, usize), towards: Vec2) {
    drawing.mark(Style::Solid, Shape::Circle { centre: at, radius: POINT });
    let text = Text::italic(letter).lowered(&number.to_string());
    drawing.label(Label::at(text, NAMES, at, POINT).towards(towards).ranked(1));
}
