//! The train from the front, beside its section and at the same heights: pitch circles to scale, teeth where they meet.

use super::layout::{Drawn, Layout, Run, Shaft};
use super::rack::{Rack, racks};
use super::rope::{self, Rope};
use super::worm;
use crate::scene::Scene;
use crate::symbol::gear::{MODULE, held, row};
use crate::symbol::{arrow, gear, hinge};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, Mechanism, PairKind, Transmission, TransmissionKind};
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// From the section to the front view.
const BESIDE: f64 = 24.0;
/// The most wheels that are told apart in it.
const MOST: usize = 10;
/// How far axes go beyond the wheels.
const BEYOND: f64 = 4.0;
/// How far wheels that mesh may be from touching.
const TOUCH: f64 = 0.05;
const NAME: f64 = 3.6;
const LETTERS: f64 = 4.0;

/// The front view, where wheels mesh, have their sizes and fit together, and of all that ropes and worms run on. Puts what has
/// no place in section into it: shafts of worms, sliders on ropes. These are what it returns.
pub fn draw(scene: &Scene<'_>, layout: &Layout, drawing: &mut Drawing) -> (Vec<Shaft>, Vec<(LinkId, Vec2)>) {
    let shown = shown(scene.mechanism(), layout);
    let has_ropes = kinds(scene.mechanism()).any(|t| t.kind == TransmissionKind::Rope);
    let mut weights = Vec::new();
    if shown.is_empty() && !has_ropes {
        return (Vec::new(), weights);
    }
    let left = drawing.extent().max.x.max(0.0) + BESIDE;
    let front = if has_ropes { hoist(scene, layout, shown, left) } else { stack(scene, layout, shown, left) };
    let (front, ropes) = front;
    front.axes(drawing);
    front.shown.iter().for_each(|i| front.wheel(drawing, &layout.wheels[*i]));
    layout.runs.iter().filter(|run| front.shows(run)).for_each(|run| front.run(drawing, run));
    racks(scene.mechanism(), layout).iter().for_each(|rack| front.rack(drawing, rack));
    front.shafts().for_each(|shaft| front.shaft(drawing, shaft));
    front.shafts().for_each(|shaft| front.turn(drawing, shaft));
    drawing.end();
    let bounds = front.bounds();
    for rope in ropes {
        let discs = |i: usize| front.disc(i);
        rope.draw(drawing, (front.origin.y, bounds.0, bounds.1), (&discs, &mut weights));
    }
    let worms = worm::placed(scene.mechanism(), layout, |wheel| front.centre(wheel));
    worms.iter().for_each(|(_, thread)| worm::thread(drawing, *thread));
    (worms.into_iter().map(|w| w.0).collect(), weights)
}

/// The front view of a train of wheels alone, for all its frames.
pub struct FrontView {
    layout: Layout,
    shown: Vec<usize>,
}

impl FrontView {
    /// None where the view does not show all of the train, or where ropes, racks or worms move beside the wheels.
    pub fn of(scene: &Scene<'_>) -> Option<Self> {
        let layout = Layout::of(scene);
        let shown = shown(scene.mechanism(), &layout);
        let wheels = |t: &Transmission| {
            matches!(t.kind, TransmissionKind::Mesh | TransmissionKind::Belt | TransmissionKind::Chain)
        };
        let all = shown.len() == layout.wheels.len() && kinds(scene.mechanism()).all(wheels);
        (all && !shown.is_empty()).then_some(Self { layout, shown })
    }

    /// The view where each link has turned by an angle, rad.
    pub fn turned(&self, scene: &Scene<'_>, angles: Vec<f64>) -> Drawing {
        let mut drawing = Drawing::new(&crate::words::id(scene, "train"), String::new(), String::new());
        let (mut front, _) = stack(scene, &self.layout, self.shown.clone(), 0.0);
        front.angles = angles;
        front.axes(&mut drawing);
        front.shown.iter().for_each(|i| front.wheel(&mut drawing, &self.layout.wheels[*i]));
        self.layout.runs.iter().for_each(|run| front.run(&mut drawing, run));
        front.shafts().for_each(|shaft| front.shaft(&mut drawing, shaft));
        drawing.end();
        drawing
    }
}

fn kinds(mechanism: &Mechanism) -> impl Iterator<Item = &Transmission> {
    mechanism.pairs.iter().filter_map(|pair| match &pair.kind {
        PairKind::Transmission(t) => Some(t),
        _ => None,
    })
}

/// The wheels of the view.
fn shown(mechanism: &Mechanism, layout: &Layout) -> Vec<usize> {
    use TransmissionKind as Kind;
    let touches = |run: &Run| {
        let [a, b] = run.wheels.map(|i| &layout.wheels[i]);
        let apart = (centre_level(mechanism, a) - centre_level(mechanism, b)).abs();
        let wanted = if run.internal { (a.radius - b.radius).abs() } else { a.radius + b.radius };
        run.apart || (apart - wanted).abs() < TOUCH
    };
    let racks = racks(mechanism, layout);
    let is_rack = |link: &LinkId| racks.iter().any(|rack| rack.link == *link);
    let runs = layout.runs.iter().all(|run| run.cones.is_none() && touches(run));
    let all = runs && layout.wheels.len() <= MOST && layout.sliders.iter().all(|s| is_rack(&s.0));
    let hangs = kinds(mechanism).any(|t| matches!(t.kind, Kind::Rope | Kind::Worm));
    let plain =
        kinds(mechanism).all(|t| matches!(t.kind, Kind::Mesh | Kind::Rack | Kind::Belt | Kind::Chain));
    let some = !(layout.runs.is_empty() && racks.is_empty());
    let has_planets = layout.shafts.iter().any(|s| s.on != LinkId::GROUND);
    if all && (hangs && !has_planets || !hangs && plain && some && layout.scale(mechanism).is_some()) {
        return (0..layout.wheels.len()).collect();
    }
    // what ropes carry and what worms turn is seen from the front alone
    let mut wheels: Vec<usize> = Vec::new();
    for t in kinds(mechanism) {
        match t.kind {
            Kind::Rope => wheels.extend(rope::wheels(mechanism, layout, t)),
            Kind::Worm => wheels.extend(worm::wheel(mechanism, layout, t)),
            _ => {}
        }
    }
    wheels.sort_unstable();
    wheels.dedup();
    wheels
}

/// The height of the axis of a wheel: of a ring of the ground that of the wheel in it tells it.
fn centre_level(mechanism: &Mechanism, wheel: &Drawn) -> f64 {
    match wheel.ring_at {
        Some(touch) if mechanism.wheels[wheel.wheel].link == LinkId::GROUND => touch - wheel.radius,
        _ => wheel.level,
    }
}

/// Axes above each other, at the heights that they have in section.
fn stack<'a, 's>(
    scene: &'s Scene<'a>,
    layout: &'s Layout,
    shown: Vec<usize>,
    left: f64,
) -> (Front<'a, 's>, Vec<Rope<'s>>) {
    let widest = shown.iter().map(|i| layout.wheels[*i].radius).fold(0.0, f64::max);
    let origin = Vec2::new(left + widest, 0.0);
    (Front { scene, layout, shown, origin, row: Vec2::new(0.0, -1.0), angles: Vec::new() }, Vec::new())
}

/// Axes beside each other, so that ropes hang freely: in that order of two in which fewer parts pass before other wheels.
fn hoist<'a, 's>(
    scene: &'s Scene<'a>,
    layout: &'s Layout,
    shown: Vec<usize>,
    left: f64,
) -> (Front<'a, 's>, Vec<Rope<'s>>) {
    let mechanism = scene.mechanism();
    let one = |way: f64| {
        let mut front = Front {
            scene,
            layout,
            shown: shown.clone(),
            origin: Vec2::zero(),
            row: Vec2::new(way, 0.0),
            angles: Vec::new(),
        };
        let ropes = |front: &Front<'_, '_>| rope::ropes(mechanism, layout, &|i| front.disc(i));
        let discs = |front: &Front<'_, '_>| -> Vec<(f64, f64)> {
            front.shown.iter().map(|i| front.disc(*i)).collect()
        };
        let shift = discs(&front)
            .into_iter()
            .map(|(x, radius)| x - radius)
            .chain(ropes(&front).iter().map(Rope::left))
            .fold(f64::INFINITY, f64::min);
        front.origin = Vec2::new(left - shift, 0.0);
        let (ropes, discs) = (ropes(&front), discs(&front));
        let crossed: usize = ropes.iter().map(|rope| rope.crossed(&discs, &|i| front.disc(i))).sum();
        // the farther apart weights hang, the better
        let spread = ropes.iter().map(Rope::right).fold(0.0, f64::max)
            - ropes.iter().map(Rope::left).fold(f64::MAX, f64::min);
        (crossed, -spread, front, ropes)
    };
    let (there, back) = (one(1.0), one(-1.0));
    let best = if (back.0, back.1) < (there.0, there.1) { back } else { there };
    (best.2, best.3)
}

struct Front<'a, 's> {
    scene: &'s Scene<'a>,
    layout: &'s Layout,
    /// Indices of drawn wheels.
    shown: Vec<usize>,
    /// Where an axis of level 0 is, and the direction in which levels grow.
    origin: Vec2,
    row: Vec2,
    /// By how much each link has turned, rad; none where the train stands still.
    angles: Vec<f64>,
}

impl Front<'_, '_> {
    fn at(&self, level: f64) -> Vec2 {
        self.origin + self.row * level
    }

    fn centre(&self, wheel: &Drawn) -> Vec2 {
        let mechanism = self.scene.mechanism();
        self.carried(mechanism.wheels[wheel.wheel].link, self.at(centre_level(mechanism, wheel)))
    }

    fn angle(&self, link: LinkId) -> f64 {
        self.angles.get(link.index()).copied().unwrap_or(0.0)
    }

    /// A place on the axis of a link where the carrier of the link has turned; y of paper is down.
    fn carried(&self, link: LinkId, place: Vec2) -> Vec2 {
        let shaft = self.layout.shafts.iter().find(|shaft| shaft.link == link);
        let Some(carrier) = shaft.and_then(|shaft| self.carrier(shaft)) else { return place };
        let axis = self.at(carrier.level);
        axis + (place - axis).turned(Vec2::direction(-self.angle(carrier.link)))
    }

    /// The abscissa of the middle of a drawn wheel, and its radius.
    fn disc(&self, i: usize) -> (f64, f64) {
        let wheel = &self.layout.wheels[i];
        (self.centre(wheel).x, wheel.radius)
    }

    fn shows(&self, run: &Run) -> bool {
        run.wheels.iter().all(|wheel| self.shown.contains(wheel))
    }

    /// Shafts with a wheel in the view, and those that carry or turn on them.
    fn shafts(&self) -> impl Iterator<Item = &Shaft> {
        let wheels = &self.scene.mechanism().wheels;
        let has =
            move |link: LinkId| self.shown.iter().any(|i| wheels[self.layout.wheels[*i].wheel].link == link);
        let carries = move |link: LinkId| self.layout.shafts.iter().any(|s| s.on == link && has(s.link));
        self.layout.shafts.iter().filter(move |shaft| has(shaft.link) || carries(shaft.link))
    }

    fn circles(&self) -> impl Iterator<Item = (Vec2, f64)> {
        self.shown.iter().map(|i| (self.centre(&self.layout.wheels[*i]), self.layout.wheels[*i].radius))
    }

    /// The greatest and the least height of all wheels, without one that of the axes.
    fn bounds(&self) -> (f64, f64) {
        if self.shown.is_empty() {
            return (self.origin.y, self.origin.y);
        }
        let top = self.circles().map(|(c, r)| c.y - r).fold(f64::MAX, f64::min);
        (top, self.circles().map(|(c, r)| c.y + r).fold(f64::MIN, f64::max))
    }

    /// The line of all axes, and one across for each that does not move.
    fn axes(&self, drawing: &mut Drawing) {
        let mechanism = self.scene.mechanism();
        let wheels = self.shown.iter().map(|i| &self.layout.wheels[*i]);
        let ends: Vec<(f64, f64)> = wheels.map(|w| (centre_level(mechanism, w), w.radius)).collect();
        if ends.is_empty() {
            return;
        }
        let from = ends.iter().map(|(s, r)| s - r).fold(f64::MAX, f64::min);
        let to = ends.iter().map(|(s, r)| s + r).fold(f64::MIN, f64::max);
        drawing.line(Style::Axis, self.at(to + BEYOND), self.at(from - BEYOND));
        let mut done: Vec<f64> = Vec::new();
        for shaft in self.shafts().filter(|s| s.on == LinkId::GROUND) {
            if done.iter().any(|level| (level - shaft.level).abs() < TOUCH) {
                continue;
            }
            done.push(shaft.level);
            let own = ends.iter().filter(|(s, _)| (s - shaft.level).abs() < TOUCH);
            let reach = self.row.perp() * (own.map(|(_, r)| *r).fold(0.0, f64::max) + BEYOND);
            let at = self.at(shaft.level);
            drawing.line(Style::Axis, at - reach, at + reach);
        }
    }

    fn wheel(&self, drawing: &mut Drawing, wheel: &Drawn) {
        let (centre, radius) = (self.centre(wheel), wheel.radius);
        let own = &self.scene.mechanism().wheels[wheel.wheel];
        drawing.begin("wheel", &own.name);
        drawing.mark(Style::Medium, Shape::Circle { centre, radius });
        if own.link == LinkId::GROUND {
            (0..3).for_each(|third| held(drawing, centre, radius, FRAC_PI_2 + TAU * f64::from(third) / 3.0));
        } else if !self.angles.is_empty() {
            for quarter in 0..4 {
                let spoke = Vec2::direction(FRAC_PI_2 * f64::from(quarter) - self.angle(own.link));
                drawing.line(Style::Thin, centre, centre + spoke * radius);
            }
        }
        // beside the teeth, which are above and below
        let side = Vec2::new(0.8, if wheel.ring_at.is_some() { -0.6 } else { 0.6 });
        let label = Label::at(Text::name(&own.name), NAME, centre + side * radius, 0.3);
        drawing.label(label.towards(-side).ranked(3));
    }

    fn run(&self, drawing: &mut Drawing, run: &Run) {
        let [a, b] = run.wheels.map(|i| &self.layout.wheels[i]);
        let (c_a, c_b) = (self.centre(a), self.centre(b));
        if run.apart {
            gear::belt(drawing, (c_a, a.radius), (c_b, b.radius), run.crossed);
            return;
        }
        let own = &self.scene.mechanism().wheels;
        let Some(z) = own[a.wheel].teeth.filter(|_| own[b.wheel].teeth.is_some()) else { return };
        let module = (2.0 * a.radius / z).max(MODULE);
        drawing.begin("mesh", &own[a.wheel].name);
        for (wheel, other, shift) in [(a, b, 0.0), (b, a, 0.5)] {
            let centre = self.centre(wheel);
            let is_ring = run.internal && wheel.radius > other.radius;
            let towards = self.centre(other) - centre;
            let towards = if run.internal && !is_ring { -towards } else { towards };
            let turned = self.before_centres(own[wheel.wheel].link, own[other.wheel].link);
            let shift = shift + turned * wheel.radius / (PI * module);
            row(
                drawing,
                centre,
                wheel.radius,
                towards.angle(),
                module,
                shift - (shift - 0.25).round(),
                if is_ring { -1.0 } else { 1.0 },
            );
        }
    }

    /// By how much a wheel has turned less than the line from its centre to that of another.
    fn before_centres(&self, link: LinkId, other: LinkId) -> f64 {
        let carrier = |link: LinkId| {
            let shaft = self.layout.shafts.iter().find(|shaft| shaft.link == link)?;
            self.carrier(shaft).map(|carrier| carrier.link)
        };
        let line = carrier(link).or_else(|| carrier(other)).map_or(0.0, |carrier| self.angle(carrier));
        line - self.angle(link)
    }

    fn rack(&self, drawing: &mut Drawing, rack: &Rack<'_>) {
        let (centre, radius) = (self.centre(rack.wheel), rack.wheel.radius);
        let side = rack.side(self.scene);
        let mechanism = self.scene.mechanism();
        drawing.begin("rack", &mechanism.link(rack.link).name);
        let teeth = mechanism.wheels[rack.wheel.wheel].teeth;
        gear::rack(drawing, (centre, radius), side, teeth, rack.link == LinkId::GROUND);
        if let Some(z) = teeth {
            let module = (2.0 * radius / z).max(MODULE);
            row(drawing, centre, radius, side.angle(), module, 0.0, 1.0);
        }
        let text = Text::upright(self.scene.link_label(rack.link));
        let end = centre + side * radius + side.perp() * gear::reach(radius);
        drawing.label(Label::at(text, NAME, end, 1.0).towards(side.perp()).ranked(3));
    }

    /// The end of a shaft; of one on a carrier with the arm that carries it.
    fn shaft(&self, drawing: &mut Drawing, shaft: &Shaft) {
        let at = self.carried(shaft.link, self.at(shaft.level));
        drawing.begin("link", &self.scene.mechanism().link(shaft.link).name);
        if let Some(carrier) = self.carrier(shaft) {
            drawing.line(Style::Link, self.at(carrier.level), at);
            hinge::moving(drawing, self.at(carrier.level));
            let name = Text::upright(self.scene.link_label(carrier.link));
            drawing.label(Label::along(name, NAME, self.at(carrier.level), at).ranked(4));
        }
        hinge::moving(drawing, at);
    }

    fn carrier(&self, shaft: &Shaft) -> Option<&Shaft> {
        self.layout.shafts.iter().find(|s| s.link == shaft.on)
    }

    /// The sense in which a shaft turns.
    fn turn(&self, drawing: &mut Drawing, shaft: &Shaft) {
        let omega = self.scene.body(shaft.link).omega;
        if omega == 0.0 || !omega.is_finite() {
            return;
        }
        let own = |w: &&Drawn| self.scene.mechanism().wheels[w.wheel].link == shaft.link;
        let wheels = self.layout.wheels.iter().filter(own).map(|w| w.radius);
        let least = wheels.fold(f64::INFINITY, f64::min);
        let arm =
            self.layout.shafts.iter().find(|s| s.on == shaft.link).map(|s| (s.level - shaft.level).abs());
        // a carrier's arrow is on the way of its planet
        let (radius, middle, sweep) = match arm {
            Some(arm) if arm > 4.0 => (arm, PI * 0.78, 9.0 / arm),
            _ if self.carrier(shaft).is_some() => (0.55 * least, 0.0, 1.4),
            _ => (0.5 * least.min(40.0), -FRAC_PI_2, 1.4),
        };
        if !radius.is_finite() || radius < 1.5 {
            return;
        }
        let at = self.at(shaft.level);
        drawing.begin("turn", &self.scene.mechanism().link(shaft.link).name);
        arrow::turn(drawing, Style::Drive, at, radius, (middle, sweep), omega > 0.0);
        let tip = arrow::middle(at, radius, middle);
        let label = Label::at(self.scene.indexed("ω", shaft.link), LETTERS, tip, 0.5);
        drawing.label(label.towards(tip - at).coloured(assur_drawing::Role::Blue).ranked(2));
    }
}
