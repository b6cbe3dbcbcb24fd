//! Shafts without places: the half section of the schoolbook, laid out in order of the meshes. Sizes are relative.

mod bevel;
mod front;
mod layout;
mod rack;
mod turning;
mod wheels;
mod worm;

pub use layout::{Layout, is_internal};

use crate::figures::TURNING;
use crate::scene::Scene;
use crate::symbol::{arrow, hinge};
use assur_drawing::{Drawing, Label, Shape, Style, Text};
use assur_math::math::Vec2;
use assur_model::model::{
    BalanceKind, DriveTarget, LinkId, LoadId, LoadKind, PairId, PairKind, Query, Value,
};
use assur_text::diagnostic::Diagnosis;
use layout::Shaft;
use std::f64::consts::FRAC_PI_2;

const NAME: f64 = 3.8;
/// Size of what is said of a rope, a belt, a worm.
const SMALL: f64 = 3.3;
const LETTERS: f64 = 4.2;
/// Half the length of a bearing, and its distance from the shaft.
const BEARING: Vec2 = Vec2::new(3.0, 1.6);
/// Half the width of a hollow shaft.
const HOLLOW: f64 = 1.7;
/// From the end of a shaft to its bearing.
const TO_BEARING: f64 = 6.0;
/// Radius and angle of the arrow of a turning shaft.
const TURN: (f64, f64) = (3.4, 2.4);
/// Half the height of a block, and its half length.
const BLOCK: Vec2 = Vec2::new(5.0, 3.4);

/// Whether a file has shafts or sliders without a place.
pub fn has_train(scene: &Scene<'_>) -> bool {
    (1..scene.mechanism().links.len()).any(|i| !scene.is_placed(LinkId::at(i)))
}

/// Whether a machine in motion is seen from the side: shafts and sliders alone, and axes that meet.
pub fn is_in_section(scene: &Scene<'_>) -> bool {
    let is_bevel = |kind: &PairKind| matches!(kind, PairKind::Transmission(t) if t.bevel.is_some());
    let mechanism = scene.mechanism();
    mechanism.pairs.iter().any(|pair| is_bevel(&pair.kind)) && crate::machine::has_shafts_alone(mechanism)
}

/// A frame of a train in section, whose wheels have marks where their teeth go by.
pub fn section(scene: &Scene<'_>, rest: &Scene<'_>) -> Drawing {
    let layout = Layout::of(scene);
    let mut drawing = Drawing::new(&crate::words::id(scene, "train"), String::new(), String::new());
    shafts(scene, &layout, 0, &mut drawing);
    wheels::draw(scene, &layout, &mut drawing);
    sliders(scene, &layout, 0, &mut drawing);
    wheels::transmissions(scene, &layout, &mut drawing);
    turning::marks(scene, &layout, &|link| scene.turned_since(rest, link), &mut drawing);
    drawing
}

/// The section of all shafts without a place, and their front view.
///
/// # Errors
/// Where all links have places.
pub fn train(scene: &Scene<'_>) -> Result<Drawing, Diagnosis> {
    if !has_train(scene) {
        return Err(Diagnosis::error(
            "mech::picture::no_train",
            "there is no train to draw: no shaft or slider is declared without a position",
        )
        .help("draw the `scheme`, or declare shafts: `shaft I { wheel a teeth 20 }`"));
    }
    let mut layout = Layout::of(scene);
    let mechanism = scene.mechanism();
    let title =
        format!("{}: train in section{}", crate::words::title(scene), crate::words::at_position(scene));
    let mut drawing = Drawing::new(&crate::words::id(scene, "train"), title, said(scene));
    let in_section = layout.shafts.len();
    shafts(scene, &layout, 0, &mut drawing);
    wheels::draw(scene, &layout, &mut drawing);
    sliders(scene, &layout, 0, &mut drawing);
    wheels::transmissions(scene, &layout, &mut drawing);
    let beside = layout.sliders.len();
    let (across, hung) = front::draw(scene, &layout, &mut drawing);
    layout.shafts.extend(across);
    layout.sliders.extend(hung);
    shafts(scene, &layout, in_section, &mut drawing);
    sliders(scene, &layout, beside, &mut drawing);
    efforts(scene, &layout, &mut drawing);
    match layout.scale(mechanism) {
        Some(scale) => {
            drawing.captions.push(crate::scheme::length_scale(&scale));
            drawing
                .caption(Text::upright("Pitch circles to scale; axial places are chosen for the drawing."));
        }
        None if mechanism.open_sizes.is_empty() => drawing.caption(Text::upright(
            "Section, not to scale: axial places and small wheels are chosen for the drawing.",
        )),
        None => drawing
            .caption(Text::upright("Section, not to scale: sizes that the file leaves open are assumed.")),
    }
    Ok(drawing)
}

fn said(scene: &Scene<'_>) -> String {
    let mechanism = scene.mechanism();
    let wheels = mechanism.wheels.iter().map(|w| {
        let teeth = w.teeth.map(|z| format!(", {z} teeth")).unwrap_or_default();
        format!("{} on {}{teeth}", w.name, mechanism.link(w.link).name)
    });
    let wheels: Vec<String> = wheels.collect();
    let mut said = crate::words::mechanism(scene);
    if !wheels.is_empty() {
        said += &format!("Wheels: {}. ", wheels.join("; "));
    }
    let speeds = (1..mechanism.links.len()).filter_map(|i| {
        let omega = scene.body(LinkId::at(i)).omega;
        let turns = omega != 0.0 && omega.is_finite();
        turns.then(|| format!("ω of {} {} rad/s", mechanism.links[i].name, scene.figure(omega, TURNING)))
    });
    let speeds: Vec<String> = speeds.collect();
    if !speeds.is_empty() {
        said += &format!("{}.", speeds.join(", "));
    }
    said
}

/// The shafts from one on.
fn shafts(scene: &Scene<'_>, layout: &Layout, from: usize, drawing: &mut Drawing) {
    for shaft in &layout.shafts[from..] {
        drawing.begin("link", &scene.mechanism().link(shaft.link).name);
        draw_shaft(scene, layout, shaft, drawing);
        drawing.end();
    }
}

/// A shaft with its bearing and its name; of one on a carrier the arm of the carrier ends at it.
fn draw_shaft(scene: &Scene<'_>, layout: &Layout, shaft: &Shaft, drawing: &mut Drawing) {
    let at = |x: f64| Vec2::new(x, -shaft.level);
    let (from, to) = shaft.ends;
    if let Some(upright) = shaft.upright {
        let carrier = layout.shafts.iter().find(|s| s.link == shaft.on);
        bevel::axis(drawing, upright, shaft.level, carrier);
        let text = Text::upright(scene.link_label(shaft.link));
        let towards = Vec2::new(0.3, -1.0);
        drawing.label(Label::at(text, NAME, at(to), 0.6).towards(towards).ranked(2));
        return;
    }
    let gap = Vec2::new(0.0, if shaft.hollow { HOLLOW } else { 0.0 });
    // a bell and a frame end at their own side of it
    let from = if shaft.hollow { shaft.frame.map_or(from, |x| x.min(from)) } else { from };
    drawing.line(Style::Link, at(from) - gap, at(to) - gap);
    if shaft.hollow {
        drawing.line(Style::Link, at(from) + gap, at(to) + gap);
    }
    let end = if shaft.right { to } else { from };
    if shaft.on == LinkId::GROUND {
        let middle = if shaft.right { to - TO_BEARING } else { from + TO_BEARING };
        bearing(drawing, at(middle), if shaft.hollow { HOLLOW } else { 0.0 });
    } else if let Some(carrier) = layout.shafts.iter().find(|s| s.link == shaft.on) {
        // the arm, from the axis of the carrier
        drawing.line(Style::Link, at(to), Vec2::new(to, -carrier.level));
        let small = at((from + to) / 2.0 + 6.0);
        for side in [-1.6, 1.6] {
            let line = Vec2::new(2.2, 0.0);
            let middle = Vec2::new(small.x, small.y + side);
            drawing.line(Style::Medium, middle - line, middle + line);
        }
    }
    let out = if shaft.right { Vec2::new(1.0, -0.4) } else { Vec2::new(-1.0, -0.4) };
    let text = Text::upright(scene.link_label(shaft.link));
    drawing.label(Label::at(text, NAME, at(end), 0.6).towards(out).ranked(2));
}

/// A bearing of a shaft that is so thick.
fn bearing(drawing: &mut Drawing, at: Vec2, thick: f64) {
    for side in [-1.0, 1.0] {
        let middle = at + Vec2::new(0.0, side * (BEARING.y + thick));
        let line = Vec2::new(BEARING.x, 0.0);
        drawing.line(Style::Medium, middle - line, middle + line);
        hinge::hatch(drawing, middle - line, middle + line, Vec2::new(0.0, side));
    }
}

/// A bearing of an upright shaft.
fn bearing_across(drawing: &mut Drawing, at: Vec2) {
    for side in [-1.0, 1.0] {
        let middle = at + Vec2::new(side * BEARING.y, 0.0);
        let line = Vec2::new(0.0, BEARING.x);
        drawing.line(Style::Medium, middle - line, middle + line);
        hinge::hatch(drawing, middle - line, middle + line, Vec2::new(side, 0.0));
    }
}

/// The blocks of sliders from one on; that of a nut on a guide, which keeps it from turning.
fn sliders(scene: &Scene<'_>, layout: &Layout, from: usize, drawing: &mut Drawing) {
    for (link, at) in &layout.sliders[from..] {
        drawing.begin("link", &scene.mechanism().link(*link).name);
        let corner = |x: f64, y: f64| *at + Vec2::new(x * BLOCK.x, y * BLOCK.y);
        let corners = vec![corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)];
        drawing.mark(Style::Block, Shape::polygon(corners));
        let text = Text::upright(scene.link_label(*link));
        let is_nut = layout.nuts.contains(link);
        if is_nut {
            let (middle, half) = (*at + Vec2::new(0.0, BLOCK.y + 0.8), Vec2::new(2.0 * BLOCK.x, 0.0));
            drawing.line(Style::Medium, middle - half, middle + half);
            hinge::hatch(drawing, middle - half, middle + half, Vec2::new(0.0, 1.0));
        }
        let towards = if is_nut { Vec2::new(0.0, -1.0) } else { Vec2::new(1.0, 0.0) };
        drawing.label(Label::at(text, NAME, *at, BLOCK.x).towards(towards).ranked(2));
        drawing.end();
    }
}

/// Arrows at the ends of shafts and at sliders, none on another.
struct Arrows<'l> {
    layout: &'l Layout,
    taken: Vec<LinkId>,
}

impl Arrows<'_> {
    fn draw(&mut self, drawing: &mut Drawing, link: LinkId, style: Style, positive: bool, name: Text) {
        let count = self.taken.iter().filter(|t| **t == link).count();
        self.taken.push(link);
        let label = if let Some(shaft) = self.layout.shafts.iter().find(|s| s.link == link) {
            let (end, inward) =
                if shaft.right { (shaft.ends.1 - 1.5, -1.0) } else { (shaft.ends.0 + 1.5, 1.0) };
            let inside = if count == 0 { 0.0 } else { 5.0 + 7.5 * count as f64 };
            let at = Vec2::new(end + inward * inside, -shaft.level);
            arrow::turn(drawing, style, at, TURN.0, (FRAC_PI_2, TURN.1), positive);
            let top = at - Vec2::new(0.0, TURN.0);
            Label::at(name, LETTERS, top, 0.5).towards(Vec2::new(0.0, -1.0))
        } else if let Some((_, at)) = self.layout.sliders.iter().find(|s| s.0 == link) {
            // along its spindle, else along the rope: what a wheel that turns counter-clockwise pays out goes down
            let is_nut = self.layout.nuts.contains(&link);
            let way = if is_nut { Vec2::new(1.0, 0.0) } else { Vec2::new(0.0, 1.0) };
            let way = if positive { way } else { -way };
            let beside = 2.2 * (count + 1) as f64;
            let from = if is_nut {
                *at + Vec2::new(way.x * (BLOCK.x + 0.4), -BLOCK.y - beside)
            } else {
                *at + Vec2::new(beside, way.y * (BLOCK.y + 0.4))
            };
            drawing.mark(style, Shape::Arrow(from, from + way * 11.0));
            Label::along(name, LETTERS, from + way * 5.0, from + way * 12.0)
        } else {
            return;
        };
        drawing.label(label.coloured(style.text_role()).ranked(1));
    }
}

/// The moving link of a pair.
fn moving(scene: &Scene<'_>, pair: PairId) -> LinkId {
    let links = scene.mechanism().pair(pair).kind.links();
    links.into_iter().find(|l| *l != LinkId::GROUND).unwrap_or(LinkId::GROUND)
}

/// Drives, loads and unknown efforts.
fn efforts(scene: &Scene<'_>, layout: &Layout, drawing: &mut Drawing) {
    let mechanism = scene.mechanism();
    let mut arrows = Arrows { layout, taken: Vec::new() };
    for drive in &mechanism.drives {
        let link = match drive.target {
            DriveTarget::Link(link) => link,
            DriveTarget::Pair(pair) => moving(scene, pair),
            DriveTarget::Point(..) | DriveTarget::Place(..) => continue,
        };
        let speed = drive.speed.as_ref().map(|e| scene.view().scalar(e)).or(drive.sense).unwrap_or(1.0);
        let slides = layout.sliders.iter().any(|s| s.0 == link);
        drawing.begin("drive", &drive.name);
        let name = scene.indexed(if slides { "v" } else { "ω" }, link);
        arrows.draw(drawing, link, Style::Drive, speed > 0.0, name);
        drawing.end();
    }
    for (i, load) in mechanism.loads.iter().enumerate() {
        let Some(link) = load.link().filter(|l| !scene.is_placed(*l)) else { continue };
        let fallback = if matches!(load.kind, LoadKind::Torque { .. }) { "M" } else { "F" };
        let name = scene.load_name(load).unwrap_or_else(|| Text::italic(fallback));
        let positive = match scene.view().query(&Query::Load(LoadId::at(i))) {
            Value::Scalar(x) if x != 0.0 => x > 0.0,
            Value::Vector(v) if v.norm() > 0.0 => v.x + v.y > 0.0,
            _ => continue,
        };
        drawing.begin("load", &name.plain());
        arrows.draw(drawing, link, Style::Force, positive, name);
        drawing.end();
    }
    for balance in &mechanism.balances {
        for place in balance.kind.places() {
            let link = match place {
                BalanceKind::Torque(link) => *link,
                BalanceKind::Force { on, .. } => *on,
                BalanceKind::InPair(pair) => moving(scene, *pair),
                BalanceKind::Several(_) => continue,
            };
            if !scene.is_placed(link) {
                drawing.begin("balance", &balance.name);
                arrows.draw(drawing, link, Style::Unknown, true, Text::name(&balance.name));
                drawing.end();
            }
        }
    }
}
