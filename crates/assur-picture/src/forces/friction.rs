//! Friction: circles at the scale of lengths with the action lines that touch them, the angle between a reaction and the
//! normal at guides and contacts, and the frictionless line beside each.

use super::partly_determined;
use crate::error;
use crate::figures::{FORCE, MOMENT, plain};
use crate::inset::{Inset, flipped, freest, wrapped};
use crate::paper::{Frame, Paper, Scaled};
use crate::scene::Scene;
use crate::scheme::{Freed, efforts, length_scale};
use crate::shape::{Outline, shapes};
use crate::symbol::{arrow, hinge, mass};
use assur_drawing::{Drawing, Label, Level, Rect, Role, Segment, Shape, Style, Text, on_circle};
use assur_math::math::Vec2;
use assur_model::model::{LinkId, PairId, PairKind, Pin};
use assur_solve::solve::PairFriction;
use assur_text::diagnostic::Diagnosis;
use std::f64::consts::TAU;

/// Length of a reaction's arrow, and of its line on the other side, mm.
const ARROW: f64 = 19.0;
const LINE: f64 = 14.0;
/// Radius of a hinge within its friction circle.
const SMALL: f64 = 0.7;
/// Friction circles smaller than this on paper are shown magnified, and their least radius there.
const HIDDEN: f64 = 1.5;
const MAGNIFIED: f64 = 3.0;
/// Radius and angle of the arrow of a relative turn.
const TURN: (f64, f64) = (6.0, 1.0);
/// What arrows and names take, mm.
const AROUND: Vec2 = Vec2::new(40.0, 36.0);
const LETTERS: f64 = 4.0;
const POINT: f64 = 4.4;

/// The pairs with friction.
///
/// # Errors
/// No pair has friction; the forces are not known.
pub fn frictions(scene: &Scene<'_>) -> Result<Vec<PairFriction>, Diagnosis> {
    if !scene.mechanism().pairs.iter().any(|p| p.friction.is_some_and(|f| f.is_some())) {
        return Err(Diagnosis::error(
            "mech::picture::no_friction",
            "there is no friction to draw: no pair has a friction circle or a coefficient",
        )
        .help(
            "give a pair friction: `revolute A: ground - crank { friction_circle 5 mm }`, \
             or `prismatic D: … { friction 0.1 }`",
        ));
    }
    if !scene.model.plan.effects.moving {
        return Err(error::no_speed(scene, "velocities"));
    }
    partly_determined(scene)?;
    let frictions: Vec<PairFriction> = scene
        .view()
        .pair_frictions()
        .into_iter()
        .filter(|f| scene.is_placed(f.on) && scene.is_placed(f.from))
        .filter(|f| f.effort.is_finite() && f.normal.is_finite() && !scene.view().shares_friction(f.pair))
        .collect();
    if frictions.is_empty() {
        return Err(error::nothing_placed(scene, "friction is drawn at its pairs"));
    }
    Ok(frictions)
}

/// The picture of friction at a position.
///
/// # Errors
/// There is none.
pub fn friction(scene: &Scene<'_>, paper: &Paper) -> Result<Drawing, Diagnosis> {
    let frictions = frictions(scene)?;
    let all = shapes(scene);
    let links: Vec<LinkId> = (1..all.len())
        .map(LinkId::at)
        .filter(|link| scene.is_placed(*link) && !scene.is_in_cylinder(*link))
        .collect();
    let freed = Freed(&links);
    let mut bounds = Rect::NOTHING;
    freed.extent(scene, &all, &mut bounds);
    let frame = paper.frame(Scaled::Length, &bounds, AROUND)?;
    let drawing = empty(scene, &frictions);
    let mut picture = Picture { scene, frame, drawing, outlines: Vec::new(), taken: Vec::new() };
    for &link in &links {
        let body = scene.body(link);
        let outline = all[link.index()].outline(&picture.frame, &|at| body.position(at));
        picture.outlines.push((link, outline));
    }
    freed.on_guides(scene, &all, &picture.frame, &mut picture.drawing);
    picture.hinges();
    for friction in &frictions {
        if friction.turns { picture.journal(friction) } else { picture.guide(friction) }
    }
    let taken = std::mem::take(&mut picture.taken);
    efforts(scene, &picture.frame, taken, &mut picture.drawing);
    picture.inset(&frictions);
    if let Some(scale) = picture.frame.scale {
        picture.drawing.captions.push(length_scale(&scale));
    }
    Ok(picture.drawing)
}

fn empty(scene: &Scene<'_>, frictions: &[PairFriction]) -> Drawing {
    let title = format!("{}: friction{}", crate::words::title(scene), crate::words::at_position(scene));
    let said = frictions.iter().map(|f| {
        let name = &scene.mechanism().pair(f.pair).name;
        let (what, unit) = if f.turns { ("torque", "N·m") } else { ("force", "N") };
        let pressed = scene.figure(f.normal, FORCE);
        format!(
            "{name}: {what} {} {unit} on {}, pressed by {pressed} N",
            scene.figure(f.effort, if f.turns { MOMENT } else { FORCE }),
            scene.link_label(f.on)
        )
    });
    let description = format!("Friction in the pairs. {}. ", said.collect::<Vec<_>>().join("; "));
    Drawing::new(&crate::words::id(scene, "friction"), title, description)
}

/// A picture that is being drawn.
struct Picture<'a, 's> {
    scene: &'s Scene<'a>,
    frame: Frame,
    drawing: Drawing,
    outlines: Vec<(LinkId, Outline)>,
    /// Where arrows begin, and arcs with their radii.
    taken: Vec<(Vec2, Vec2)>,
}

impl Picture<'_, '_> {
    /// Names of hinges, whose circles are those of friction.
    fn hinges(&mut self) {
        for pair in &self.scene.mechanism().pairs {
            let PairKind::Revolute(pins) = &pair.kind else { continue };
            let own = |p: &&Pin| p.link != LinkId::GROUND && self.scene.is_placed(p.link);
            let Some(pin) = pins.iter().find(own) else { continue };
            let at = self.frame.point(self.scene.at(pin.link, pin.at));
            if pins.iter().any(|p| p.link == LinkId::GROUND) {
                hinge::support(&mut self.drawing, at);
            }
            let lines: Vec<Vec2> = self.lines_at(at);
            let label = Label::at(Text::name(&pair.name), POINT, at, hinge::RADIUS + 0.6).ranked(1);
            self.drawing.label(freest(&lines).map_or(label.clone(), |d| label.towards(d)));
        }
    }

    fn lines_at(&self, at: Vec2) -> Vec<Vec2> {
        let bars = self.outlines.iter().flat_map(|(_, o)| o.bars.iter());
        let near = bars.filter(|(a, b)| Segment { a: *a, b: *b }.distance(at) < 0.3);
        near.flat_map(|(a, b)| [*a - at, *b - at]).filter(|d| d.norm() > 1.0).collect()
    }

    /// The reaction on the second link, its distance to the left of the hinge, m, and the hinge, m.
    fn action(&self, f: &PairFriction) -> Option<(Vec2, f64, Vec2)> {
        let PairKind::Revolute(pins) = &self.scene.mechanism().pair(f.pair).kind else { return None };
        let at = pins.iter().find(|p| p.link == f.on)?;
        let force = self.scene.view().reaction(f.pair, f.on);
        let size = force.norm();
        (size > 0.0).then(|| (force, -f.effort / size, self.scene.at(f.on, at.at)))
    }

    /// A friction circle with its action line, the frictionless line and the relative turn.
    fn journal(&mut self, f: &PairFriction) {
        let Some((force, left, centre)) = self.action(f) else { return };
        let name = self.scene.mechanism().pair(f.pair).name.clone();
        self.drawing.begin("pair", &name);
        let at = self.frame.point(centre);
        let radius = self.frame.length(f.factor);
        if radius > 0.05 {
            self.drawing.mark(Style::FrictionCircle, Shape::Circle { centre: at, radius });
        }
        self.drawing.mark(Style::Hinge, Shape::Circle { centre: at, radius: SMALL.min(hinge::RADIUS) });
        let along = flipped(force) / force.norm();
        // to the left of the force on the ground
        let touch = at + flipped(force.perp()) / force.norm() * self.frame.length(left);
        self.drawing.line(Style::Dashed, touch - along * LINE, touch + along * LINE);
        self.drawing.mark(Style::Unknown, Shape::Arrow(touch, touch + along * ARROW));
        self.taken.push((touch, along));
        let label = Label::along(
            self.scene.reaction_name(f.pair, f.from, f.on),
            LETTERS,
            touch + along * 9.0,
            touch + along * (ARROW + 2.0),
        );
        self.drawing.label(label.coloured(Role::Green).ranked(2));
        self.without(f, at);
        if f.speed != 0.0 {
            let fixed = f.from == LinkId::GROUND || f.on == LinkId::GROUND;
            let middle = -self.free_angle(at, along, fixed);
            arrow::turn(&mut self.drawing, Style::Drive, at, TURN.0, (middle, TURN.1), f.speed > 0.0);
            self.taken.push((at, Vec2::direction(-middle) * TURN.0));
            let tip = arrow::middle(at, TURN.0, middle);
            let on = self.scene.link_label(f.on);
            let from = if f.from == LinkId::GROUND { "" } else { self.scene.link_label(f.from) };
            let label = Label::at(Text::italic("ω").lowered(&format!("{on}{from}")), 3.6, tip, 0.4);
            self.drawing.label(label.towards(tip - at).coloured(Role::Blue).ranked(3));
        }
        self.drawing.end();
    }

    /// A direction on paper away from bars, from the action line and from the support of a fixed hinge.
    fn free_angle(&self, at: Vec2, along: Vec2, fixed: bool) -> f64 {
        let mut busy = self.lines_at(at);
        busy.extend([along, -along]);
        if fixed {
            busy.extend([Vec2::new(-0.7, 0.7), Vec2::new(0.0, 1.0), Vec2::new(0.7, 0.7)]);
        }
        freest(&busy).map_or(0.0, Vec2::angle)
    }

    /// The line of the reaction without friction, thin.
    fn without(&mut self, f: &PairFriction, at: Vec2) {
        let free = self.scene.view().without_friction().reaction(f.pair, f.on);
        if let Some(along) = flipped(free).unit() {
            self.drawing.line(Style::Thin, at - along * LINE, at + along * LINE);
        }
    }

    /// Normal, reaction and the angle of friction between them.
    fn guide(&mut self, f: &PairFriction) {
        let Some((at, normal)) = self.guide_of(f.pair) else { return };
        let force = flipped(self.scene.view().reaction(f.pair, f.on));
        let (Some(along), Some(normal)) = (force.unit(), flipped(normal).unit()) else { return };
        let normal = if normal.dot(along) < 0.0 { -normal } else { normal };
        let name = self.scene.mechanism().pair(f.pair).name.clone();
        self.drawing.begin("pair", &name);
        let at = self.frame.point(at);
        self.drawing.line(Style::Axis, at - normal * LINE, at + normal * (ARROW + 3.0));
        self.drawing.line(Style::Dashed, at - along * LINE, at);
        self.drawing.mark(Style::Unknown, Shape::Arrow(at, at + along * ARROW));
        let label = Label::along(
            self.scene.reaction_name(f.pair, f.from, f.on),
            LETTERS,
            at + along * 9.0,
            at + along * (ARROW + 2.0),
        );
        self.drawing.label(label.coloured(Role::Green).ranked(2));
        let (from, sweep) = (normal.angle(), wrapped(along.angle() - normal.angle()));
        if sweep.abs() > 0.01 {
            let radius = ARROW * 0.8;
            self.drawing.mark(Style::Thin, Shape::Arc { centre: at, radius, from, sweep });
            let angle = libm::atan(f.factor) * 360.0 / TAU;
            let name = Text::italic("φ").and(&format!(" = {}°", plain(angle)), false, Level::Base);
            let middle = on_circle(at, radius, from + sweep / 2.0);
            self.drawing.label(Label::at(name, 3.6, middle, 0.4).towards(middle - at).ranked(4));
        }
        self.drawing.end();
    }

    /// Where a guide or a contact presses, and its normal, in ground axes.
    fn guide_of(&self, pair: PairId) -> Option<(Vec2, Vec2)> {
        match &self.scene.mechanism().pair(pair).kind {
            PairKind::Prismatic(g) => {
                let along = g.along.turned(self.scene.body(g.guide).u);
                let at = self.scene.at(g.slider, g.point);
                let middle = crate::wedge::middle(self.scene, [g.slider, g.guide], (at, along));
                Some((middle.unwrap_or(at), along.perp()))
            }
            _ => self.scene.view().contact_normal(pair),
        }
    }

    /// The largest friction circle that the scale hides, magnified.
    fn inset(&mut self, frictions: &[PairFriction]) {
        let hidden = frictions.iter().filter(|f| f.turns && self.frame.length(f.factor) < HIDDEN);
        let right = |f: &PairFriction| self.action(f).map_or(f64::MIN, |(_, _, at)| at.x);
        let largest = hidden.max_by(|a, b| a.factor.total_cmp(&b.factor).then(right(a).total_cmp(&right(b))));
        let Some(f) = largest else { return };
        let Some((force, left, place)) = self.action(f) else { return };
        let (at, radius) = (self.frame.point(place), self.frame.length(f.factor));
        let along = flipped(force) / force.norm();
        let touch = at + flipped(force.perp()) / force.norm() * self.frame.length(left);
        let lines = self.lines_at(at);
        let drawing = &mut self.drawing;
        drawing.begin("inset", &self.scene.mechanism().pair(f.pair).name);
        let Some(inset) = Inset::of(drawing, at, (radius, MAGNIFIED)) else { return drawing.end() };
        let centre = inset.point(at);
        drawing.mark(Style::FrictionCircle, Shape::Circle { centre, radius: inset.length(radius) });
        for line in lines {
            if let Some((from, to)) = inset.within(at, at + line) {
                let clear = (to - from) / (to - from).norm() * 1.2;
                drawing.line(Style::Link, from + clear, to);
            }
        }
        drawing.mark(Style::Hinge, Shape::Circle { centre, radius: 1.2 });
        drawing.line(Style::Thin, centre, inset.point(touch));
        inset.line(drawing, Style::Dashed, touch - along * LINE, touch);
        if let Some((from, to)) = inset.within(touch, touch + along * ARROW) {
            drawing.mark(Style::Unknown, Shape::Arrow(from, to));
        }
        mass::point(drawing, inset.point(touch));
        let words = format!(" = {} mm", plain(f.factor * 1000.0));
        inset.caption(drawing, Text::italic("ρ").and(&words, false, Level::Base), Role::Vermilion);
        drawing.end();
    }
}
