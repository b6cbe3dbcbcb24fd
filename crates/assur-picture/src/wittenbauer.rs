//! Wittenbauer's diagram of a flywheel: the energy ΔT over the reduced moment of inertia of the links, J_r.
//!
//! Constant effort of the mean instead of that at constant speed makes the whole energy T = ½ (J + J_r) ω² grow by
//! ΔT = ½ ω_m² (J_r − J_r0) − W, where W is the work of the effort less its mean. Points of one speed lie on a line of
//! slope ½ ω². The solver takes both tangents at the mean speed: they touch where W is extreme and are \[W\] apart. At the
//! greatest and the least speed they are (ω_max² − ω_min²) J/2 = J ω_m² δ apart on the axis where J_r is zero.

use crate::diagram::{Axis, LETTERS, Line, Panel, with_unit};
use crate::figures::plain;
use crate::scene::Scene;
use crate::words;
use assur_drawing::{Drawing, Label, Level, Role, Scale, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{Display, Expr, Flywheel, FlywheelPart, FlywheelTorque, Query};
use assur_solve::answer::FlywheelAnswer;
use assur_solve::solve::Course;

/// The most that the panel takes, mm.
const SPACE: Vec2 = Vec2::new(124.0, 92.0);
/// Where [W] stands, left of the axis, mm.
const BESIDE: f64 = 15.0;
/// Radius of the arc of an angle, mm, and of its horizontal leg.
const ARC: f64 = 13.0;
/// A shorter arc is not drawn, mm.
const SMALL: f64 = 0.6;
/// How far a tangent goes beyond the point where it touches, mm.
const BEYOND: f64 = 14.0;
/// Points of the curve over the sweep.
const PARTS: f64 = 720.0;
/// Positions with their values.
const MARKED: u8 = 12;
/// A reduced moment of inertia that changes by less than this part of it is constant.
const CONSTANT: f64 = 1e-6;
/// Said of the tangents.
const AT_MEAN_SPEED: &str =
    "The answer takes both tangents at the mean speed; at the greatest and the least speed they would give:";
/// Size of the numbers at positions.
const NUMBERS: f64 = 3.0;
/// Halvings in the search for where a tangent touches.
const HALVINGS: u8 = 60;

/// A point of the curve: value of the drive, J_r, ΔT.
#[derive(Clone, Copy)]
struct Point {
    at: f64,
    inertia: f64,
    energy: f64,
}

/// The diagram of a flywheel.
pub struct Wittenbauer<'a> {
    wheel: &'a Flywheel,
    found: &'a FlywheelAnswer,
    along: Display,
    /// J_r where the cycle begins.
    first: f64,
    points: Vec<Point>,
}

/// The reduced moment of inertia of a flywheel whose answer counts the links; none where they are not in its torque.
pub fn links(scene: &Scene<'_>, which: usize, wheel: &Flywheel, found: &FlywheelAnswer) -> Option<Expr> {
    let counts = wheel.with_links && scene.model.plan.effects.inertia && wheel.speed.is_none();
    let of_load = matches!(wheel.torque, Some(FlywheelTorque::Load(_)));
    let [_, least, greatest] = found.links;
    let drawn = counts && !of_load && greatest - least > CONSTANT * greatest && found.fluctuation > 0.0;
    drawn.then_some(Expr::Query(Query::Flywheel(which, FlywheelPart::LinksInertia)))
}

impl<'a> Wittenbauer<'a> {
    /// With the course of the reduced moment of inertia.
    pub fn of(wheel: &'a Flywheel, found: &'a FlywheelAnswer, links: &Course, along: Display) -> Self {
        let line = links.lines(PARTS).concat();
        let first = line.first().map_or(0.0, |p| p.1);
        let mut diagram = Self { wheel, found, along, first, points: Vec::new() };
        diagram.points = line.into_iter().map(|(at, inertia)| diagram.point(at, inertia)).collect();
        diagram
    }

    /// The picture; none where nothing has an extent.
    pub fn draw(&self, scene: &Scene<'_>) -> Option<Drawing> {
        let name = &self.wheel.name;
        let title = format!("{}: energy over reduced inertia for the flywheel {name}", words::title(scene));
        let id = format!("{}-{name}", words::id(scene, "energy"));
        let slope = self.slope(1.0);
        let (upper, lower) = (self.touching(slope, 1.0), self.touching(slope, -1.0));
        let (panel, scales) = self.panel([upper, lower], slope)?;
        let mut drawing = Drawing::new(&id, title, self.said(scene));
        let below = with_unit(Text::italic("J").lowered("r"), &panel.x.power_text(), "kg*m^2");
        let energy = Text::upright("Δ").and("T", true, Level::Base);
        panel.draw(&mut drawing, with_unit(energy, &panel.y.power_text(), "J"), Some(below));
        drawing.begin("curve", name);
        let line: Line = self.points.iter().map(|p| (p.inertia, p.energy)).collect();
        panel.curve(&mut drawing, Style::Curve1, &[line]);
        self.positions(scene, &mut drawing, &panel);
        let high = self.tangent(scene, &mut drawing, &panel, (upper, slope), ("max", -1.0));
        let low = self.tangent(scene, &mut drawing, &panel, (lower, slope), ("min", 1.0));
        self.fluctuation(scene, &mut drawing, high, low);
        let on_paper = libm::atan(slope * scales[0].factor() / scales[1].factor());
        angle(&mut drawing, low, on_paper);
        self.captions(&mut drawing, scales);
        Some(drawing)
    }

    fn point(&self, at: f64, inertia: f64) -> Point {
        let (begin, length) = self.found.interval;
        // a cycle ends where it began
        let work = if (at - begin) / length >= 1.0 { 0.0 } else { self.found.work(at) };
        Point { at, inertia, energy: self.slope(1.0) * (inertia - self.first) - work }
    }

    /// Half the square of a multiple of the mean speed.
    fn slope(&self, times: f64) -> f64 {
        let speed = self.found.speed * times;
        0.5 * speed * speed
    }

    /// Where a line of a slope touches the curve, from above (`side` 1) or from below.
    fn touching(&self, slope: f64, side: f64) -> Point {
        let height = |p: &Point| side * (p.energy - slope * p.inertia);
        let better = |best: Point, here: Point| if height(&here) > height(&best) { here } else { best };
        let higher = |best: usize, i: usize| {
            if height(&self.points[i]) > height(&self.points[best]) { i } else { best }
        };
        let best = (0..self.points.len()).fold(0, higher);
        let mut found = self.points[best];
        let ends = [best.saturating_sub(1), (best + 1).min(self.points.len() - 1)].map(|i| self.points[i]);
        for end in ends {
            // from the best point towards its neighbour
            let (mut from, mut to) = (self.points[best], end);
            for _ in 0..HALVINGS {
                let [p, q] = [1.0 / 3.0, 2.0 / 3.0].map(|part| self.between(&from, &to, part));
                if height(&p) < height(&q) {
                    from = p
                } else {
                    to = q
                }
                found = [p, q].into_iter().fold(found, better);
            }
        }
        found
    }

    /// The point at a value of the drive.
    fn at(&self, value: f64) -> Point {
        let around = self.points.windows(2).find(|pair| (value - pair[0].at) * (value - pair[1].at) <= 0.0);
        let Some([p, q]) = around else { return self.points[0] };
        self.between(p, q, if p.at == q.at { 0.0 } else { (value - p.at) / (q.at - p.at) })
    }

    /// A point between two that are near: there the work is known, and J_r runs almost straight.
    fn between(&self, p: &Point, q: &Point, part: f64) -> Point {
        let mix = |x: f64, y: f64| x + (y - x) * part;
        self.point(mix(p.at, q.at), mix(p.inertia, q.inertia))
    }

    /// The moment of inertia between tangents at the greatest and the least speed, kg m².
    fn at_extreme_speeds(&self) -> f64 {
        let delta = self.wheel.fluctuation;
        let reach = |times: f64, side: f64| {
            let slope = self.slope(times);
            let touches = self.touching(slope, side);
            touches.energy - slope * touches.inertia
        };
        let apart = reach(1.0 + 0.5 * delta, 1.0) - reach(1.0 - 0.5 * delta, -1.0);
        (apart / (self.found.speed * self.found.speed * delta)).max(0.0)
    }

    /// A panel whose scale factors are of the series.
    fn panel(&self, touched: [Point; 2], slope: f64) -> Option<(Panel, [Scale; 2])> {
        let all = |of: fn(&Point) -> f64| {
            let values = self.points.iter().map(of);
            values.fold((f64::INFINITY, f64::NEG_INFINITY), |(least, most), x| (least.min(x), most.max(x)))
        };
        let (least, greatest) = all(|p| p.inertia);
        let x = Axis::around(least, greatest, 7.0);
        let (mut low, mut high) = all(|p| p.energy);
        for point in touched {
            let at_axis = point.energy - slope * (point.inertia - x.from);
            (low, high) = (low.min(at_axis), high.max(at_axis));
        }
        let y = Axis::around(low, high, 7.0);
        let scales = [Scale::fitting(x.to - x.from, SPACE.x)?, Scale::fitting(y.to - y.from, SPACE.y)?];
        let size = Vec2::new((x.to - x.from) / scales[0].factor(), (y.to - y.from) / scales[1].factor());
        Some((Panel { top: 0.0, size, x, y }, scales))
    }

    /// Some positions of the sweep with the values of the drive.
    fn positions(&self, scene: &Scene<'_>, drawing: &mut Drawing, panel: &Panel) {
        drawing.begin("positions", "");
        let (first, length) = self.found.interval;
        for i in 0..MARKED {
            let point = self.at(first + length * f64::from(i) / f64::from(MARKED));
            let at = panel.dot(drawing, point.inertia, point.energy);
            let text = Text::upright(&scene.place_text(&self.along, point.at));
            drawing.label(Label::at(text, NUMBERS, at, 0.9).ranked(5));
        }
        drawing.end();
    }

    /// A tangent from the axis to beyond where it touches; where it begins.
    fn tangent(
        &self,
        scene: &Scene<'_>,
        drawing: &mut Drawing,
        panel: &Panel,
        (touches, slope): (Point, f64),
        (index, side): (&str, f64),
    ) -> Vec2 {
        drawing.begin("tangent", index);
        let from = panel.at(panel.x.from, touches.energy - slope * (touches.inertia - panel.x.from));
        let at = panel.dot(drawing, touches.inertia, touches.energy);
        let along = (at - from).unit().unwrap_or(Vec2::new(1.0, 0.0));
        drawing.line(Style::Velocity, from, at + along * BEYOND);
        let text =
            Text::italic("ω").lowered(index).and(",  ", false, Level::Base).and("φ", true, Level::Base);
        let text = text.and(&format!(" = {}", scene.place_text(&self.along, touches.at)), false, Level::Base);
        drawing.label(Label::at(text, LETTERS, at, 0.9).towards(Vec2::new(0.5, side)).ranked(2));
        drawing.end();
        from
    }

    /// [W] between the tangents, beside the axis.
    fn fluctuation(&self, scene: &Scene<'_>, drawing: &mut Drawing, high: Vec2, low: Vec2) {
        drawing.begin("fluctuation", &self.wheel.name);
        let beside = |at: Vec2| at - Vec2::new(BESIDE, 0.0);
        for at in [high, low] {
            drawing.line(Style::Thin, at, beside(at) - Vec2::new(2.0, 0.0));
        }
        let middle = (beside(high) + beside(low)) * 0.5;
        drawing.mark(Style::Acceleration, Shape::Arrow(middle, beside(low)));
        drawing.mark(Style::Acceleration, Shape::Arrow(middle, beside(high)));
        let text = self.swing(scene);
        let label = Label::at(text, LETTERS, middle, 0.8).towards(Vec2::new(-1.0, 0.0)).ranked(0);
        drawing.label(label.coloured(Role::Vermilion));
        drawing.end();
    }

    /// `[W] = 324.1 J`
    fn swing(&self, scene: &Scene<'_>) -> Text {
        let joule = Display { unit: "J".to_owned(), factor: 1.0, ..Display::default() };
        let value = scene.value_text(&joule, self.found.fluctuation);
        Text::upright("[").and("W", true, Level::Base).and(&format!("] = {value}"), false, Level::Base)
    }

    /// Scale factors, and what the answer takes.
    fn captions(&self, drawing: &mut Drawing, [inertia, energy]: [Scale; 2]) {
        let on_paper = |times: f64| {
            let angle = libm::atan(self.slope(times) * inertia.factor() / energy.factor());
            format!(" = {}°", plain(angle.to_degrees()))
        };
        let quantity = |text: Text, letter: &str, index: &str, value: &str| {
            text.and(letter, true, Level::Base).lowered(index).and(value, false, Level::Base)
        };
        let named = |text: Text, value: f64| {
            let mut text = text;
            text.runs.extend(Text::name(&self.wheel.name).runs);
            text.and(&format!(" = {} kg·m²", plain(value)), false, Level::Base)
        };
        let scales = quantity(Text::default(), "μ", "J", &format!(" = {} kg·m²/mm,  ", inertia.text()));
        drawing.caption(quantity(scales, "μ", "T", &format!(" = {} J/mm", energy.text())));
        let mean = quantity(Text::default(), "ψ", "m", &format!("{},  ", on_paper(1.0)));
        let mean = quantity(mean, "ω", "m", &format!(" = {} rad/s,  ", plain(self.found.speed)));
        drawing.caption(quantity(mean, "J", "r,m", &format!(" = {} kg·m²", plain(self.found.links[0]))));
        if self.found.inertia > 0.0 {
            let formula = Text::name(&self.wheel.name).and(" = [", false, Level::Base);
            let formula = formula.and("W", true, Level::Base).and("]/(", false, Level::Base);
            let formula =
                quantity(formula, "ω", "m", "²").and("δ", true, Level::Base).and(") − ", false, Level::Base);
            let value = format!(" = {} kg·m²", plain(self.found.inertia));
            drawing.caption(quantity(formula, "J", "r,m", &value));
        }
        drawing.caption(Text::upright(AT_MEAN_SPEED));
        let delta = 0.5 * self.wheel.fluctuation;
        let extreme = quantity(Text::default(), "ψ", "max", &format!("{},  ", on_paper(1.0 + delta)));
        let extreme = quantity(extreme, "ψ", "min", &format!("{},  ", on_paper(1.0 - delta)));
        drawing.caption(named(extreme, self.at_extreme_speeds()));
    }

    fn said(&self, scene: &Scene<'_>) -> String {
        let [least, greatest] = self.found.extremes.map(|at| scene.place_text(&self.along, at));
        format!(
            "The energy of the links and the flywheel over the reduced moment of inertia of the links. Tangents at the \
             mean speed of {} rad/s touch at {least} and {greatest}; between them {}. {AT_MEAN_SPEED} {} kg·m² instead \
             of {} kg·m².",
            plain(self.found.speed),
            self.swing(scene).plain(),
            plain(self.at_extreme_speeds()),
            plain(self.found.inertia),
        )
    }
}

/// The angle of a tangent at its begin, where it can be seen.
fn angle(drawing: &mut Drawing, from: Vec2, angle: f64) {
    if ARC * angle < SMALL {
        return;
    }
    drawing.begin("angle", "");
    drawing.line(Style::Thin, from, from + Vec2::new(ARC + 4.0, 0.0));
    drawing.mark(Style::Thin, Shape::Arc { centre: from, radius: ARC, from: 0.0, sweep: -angle });
    let middle = from + Vec2::direction(-0.5 * angle) * ARC;
    let text = Text::italic("ψ").lowered("m");
    drawing.label(Label::at(text, LETTERS, middle, 0.6).towards(Vec2::direction(-0.5 * angle)).ranked(1));
    drawing.end();
}
