//! Animations: the corners of every mark are, in every frame, where they are when that frame is drawn; labels keep apart.

use crate::drawn::solved;
use crate::every_example::examples;
use crate::frames::{all_series, between, lists, motion, page, values};
use assur::internals::math::Vec2;
use assur::internals::pipeline::turn_in;

/// Frames of an animation.
const FRAMES: usize = 60;
/// Frames between those that are drawn for comparison.
const STEP: usize = 17;
/// What a corner may be off, mm: marks go with others within 0.02 mm, and their turns are rounded to a hundredth of a degree.
const OFF: f64 = 0.1;
/// Labels that share less are apart: widths of letters are rounded up, mm.
const TOUCH: f64 = 0.3;

/// What moves a mark or a label.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Mover {
    Nothing,
    Body(usize),
    Follower(usize),
    /// It is drawn anew in every frame.
    Redrawn,
}

/// A label with its box.
struct Label {
    text: String,
    mover: Mover,
    /// Its place among those that fade.
    fades: Option<usize>,
    area: [Vec2; 2],
}

/// An animation as its page has it.
pub struct Moving {
    columns: Vec<Vec<f64>>,
    bodies: Vec<Vec<f64>>,
    followers: Vec<Vec<f64>>,
    /// Class, mover and corners of every mark.
    marks: Vec<(String, Mover, Vec<Vec2>)>,
    labels: Vec<Label>,
    /// Of labels that fade, in which frames.
    hidden: Vec<Vec<f64>>,
    /// The first number below the picture, of every frame.
    values: Vec<f64>,
}

fn attribute(element: &str, name: &str) -> f64 {
    between(element, &format!(" {name}=\""), "\"").parse().unwrap_or(0.0)
}

/// The corners of a path of lines and arcs.
fn corners(path: &str) -> Vec<Vec2> {
    let mut found = Vec::new();
    for part in path.split_inclusive(|c: char| c.is_ascii_alphabetic()).collect::<Vec<_>>().windows(2) {
        let (kind, rest) =
            (part[0].chars().last(), part[1].trim_end_matches(|c: char| c.is_ascii_alphabetic()));
        let all: Vec<f64> = rest.split([' ', ',']).filter_map(|x| x.parse().ok()).collect();
        if kind.is_some_and(|kind| "MLA".contains(kind)) && all.len() >= 2 {
            found.push(Vec2::new(all[all.len() - 2], all[all.len() - 1]));
        }
    }
    found
}

impl Moving {
    pub fn of(page: &str) -> Self {
        let motion = motion(page);
        let (columns, hidden) = (all_series(&motion["series"]), all_series(&motion["faded"]));
        let (bodies, followers) = (lists(&motion["bodies"]), lists(&motion["followers"]));
        let values = values(page);
        let svg = between(page, "<svg", "</svg>");
        let (mut marks, mut labels) = (Vec::new(), Vec::new());
        let (mut mover, mut fades) = (Mover::Nothing, None);
        for line in svg.lines() {
            let mut line = line;
            while let Some((class, rest)) =
                line.strip_prefix("<g class=\"").and_then(|rest| rest.split_once("\">"))
            {
                let index = class.get(1..).and_then(|i| i.parse().ok());
                match (class.chars().next(), index) {
                    (Some('m'), Some(i)) => mover = Mover::Body(i),
                    (Some('f'), Some(i)) => mover = Mover::Follower(i),
                    (Some('r'), Some(_)) => mover = Mover::Redrawn,
                    (Some('v'), Some(i)) => fades = Some(i),
                    _ => break,
                }
                line = rest;
            }
            if line.starts_with("</g>") {
                (mover, fades) = (Mover::Nothing, None);
            }
            let class = between(line, "class=\"", "\"").to_owned();
            if line.starts_with("<line") {
                let at = |x: &str, y: &str| Vec2::new(attribute(line, x), attribute(line, y));
                marks.push((class, mover, vec![at("x1", "y1"), at("x2", "y2")]));
            } else if line.starts_with("<circle") && class != "n0" {
                marks.push((class, mover, vec![Vec2::new(attribute(line, "cx"), attribute(line, "cy"))]));
            } else if line.starts_with("<path") {
                marks.push((class, mover, corners(between(line, " d=\"", "\""))));
            } else if line.starts_with("<g class=\"lab") {
                labels.extend(label(line).map(|(text, area)| Label { text, mover, fades, area }));
            }
        }
        Self { columns, bodies, followers, hidden, values, marks, labels }
    }

    fn count(&self) -> usize {
        self.columns.iter().map(Vec::len).max().unwrap_or(0)
    }

    fn carried(&self, mover: Mover, frame: usize, at: Vec2) -> Vec2 {
        let (body, at, shift) = match mover {
            Mover::Nothing | Mover::Redrawn => return at,
            Mover::Body(body) => (body, at, Vec2::zero()),
            Mover::Follower(i) => {
                let place = Vec2::new(self.followers[i][0], self.followers[i][1]);
                (self.followers[i][2] as usize, place, at - place)
            }
        };
        let body = &self.bodies[body];
        let column = |i: usize| body.get(i).map_or(0.0, |k| self.columns[*k as usize][frame] / 100.0);
        let centre = Vec2::new(body[0], body[1]);
        let turned = (at - centre).turned(Vec2::direction(column(4).to_radians()));
        turned + Vec2::new(column(2), column(3)) + centre + shift
    }

    /// The labels that lie on each other in a frame.
    fn touching(&self, frame: usize) -> Vec<(&str, &str)> {
        let area = |i: usize| {
            let Label { mover, area, .. } = &self.labels[i];
            area.map(|corner| self.carried(*mover, frame, area[0]) + corner - area[0])
        };
        let is_hidden = |i: usize| self.labels[i].fades.is_some_and(|i| self.hidden[i][frame] > 0.5);
        let mut found = Vec::new();
        for i in 0..self.labels.len() {
            for j in (0..i).filter(|j| !is_hidden(i) && !is_hidden(*j)) {
                let (a, b) = (area(i), area(j));
                let shared = |a: [f64; 2], b: [f64; 2]| a[1].min(b[1]) - a[0].max(b[0]) > TOUCH;
                if shared([a[0].x, a[1].x], [b[0].x, b[1].x]) && shared([a[0].y, a[1].y], [b[0].y, b[1].y]) {
                    found.push((self.labels[i].text.as_str(), self.labels[j].text.as_str()));
                }
            }
        }
        found
    }
}

/// The text of a label and its box.
fn label(line: &str) -> Option<(String, [Vec2; 2])> {
    let mut area: Option<[Vec2; 2]> = None;
    let mut all = String::new();
    for text in line.split("<text").skip(1) {
        let at = Vec2::new(attribute(text, "x"), attribute(text, "y"));
        let (size, width) = (attribute(text, "font-size"), attribute(text, "textLength"));
        let (min, max) = (Vec2::new(at.x, at.y - 0.66 * size), Vec2::new(at.x + width, at.y + 0.02 * size));
        area = Some(area.map_or([min, max], |[a, b]| {
            [Vec2::new(a.x.min(min.x), a.y.min(min.y)), Vec2::new(b.x.max(max.x), b.y.max(max.y))]
        }));
        all += between(text, ">", "<");
    }
    area.map(|area| (all, area))
}

#[test]
fn corners_of_all_marks_are_where_they_are_when_a_frame_is_drawn() {
    let (mut wrong, mut compared, mut touching) = (Vec::new(), 0, Vec::new());
    let (mut touches, mut all) = (0, 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let mut turn = match &solved.compiled.mechanism.simulation {
            Some(_) => Vec::new(),
            None => turn_in(&solved.compiled, &solved.solution, FRAMES),
        };
        turn.retain(|pose| pose.outcome.is_ok());
        let Some(first) = page(&source, &solved, &turn) else { continue };
        let first = Moving::of(&first);
        let count = first.count();
        let mut touched = 0;
        for frame in 0..count {
            let found = first.touching(frame);
            touched += usize::from(!found.is_empty());
            if let Some((a, b)) = found.first()
                && touched == 1
            {
                touching.push(format!("{name}: {a} on {b} in frame {frame}"));
            }
        }
        all += count;
        touches += touched;
        if let Some(last) = touching.last_mut().filter(|_| touched > 0) {
            *last += &format!(", in {touched} of {count}");
        }
        for _ in (STEP..turn.len().saturating_sub(1)).step_by(STEP) {
            turn.rotate_left(STEP);
            let Some(drawn) = page(&source, &solved, &turn) else { continue };
            let drawn = Moving::of(&drawn);
            let same = |a: &[(String, Mover, Vec<Vec2>)], b: &[(String, Mover, Vec<Vec2>)]| {
                a.len() == b.len() && a.iter().zip(b).all(|(a, b)| a.0 == b.0 && a.2.len() == b.2.len())
            };
            if !same(&first.marks, &drawn.marks) {
                continue;
            }
            let Some(frame) = first.values.iter().position(|value| drawn.values.first() == Some(value))
            else {
                continue;
            };
            for (mark, there) in first.marks.iter().zip(&drawn.marks) {
                // the corners of a path begin with the first frame
                if ["dr", "pa"].iter().any(|class| mark.0.starts_with(class)) || mark.1 == Mover::Redrawn {
                    continue;
                }
                compared += 1;
                let off =
                    mark.2.iter().zip(&there.2).map(|(a, b)| (first.carried(mark.1, frame, *a) - *b).norm());
                let most = off.fold(0.0, f64::max);
                if most > OFF {
                    wrong.push(format!("{name}: a mark `{}` is {most:.2} mm off in frame {frame}", mark.0));
                }
            }
        }
    }
    eprintln!("{compared} marks compared; labels touch in {touches} of {all} frames");
    assert!(compared > 5000, "{compared} marks compared");
    assert!(
        touches * 100 < all,
        "labels lie on each other in {touches} of {all} frames:\n{}",
        touching.join("\n")
    );
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// A crank that turns all the way, over a range and in a sense.
fn crank(drive: &str) -> String {
    format!(
        "mech 1\nground {{ A (0, 0); D (100 mm, 0) }}\nlink crank A-B 30 mm\nlink coupler B-C 100 mm\n\
         link rocker D-C 60 mm\nrevolute A: ground - crank\nrevolute B: crank - coupler\nrevolute C: coupler - rocker\n\
         revolute D: ground - rocker\nassemble C left of B-D\ndrive crank = {drive}\nfind position(C)\n"
    )
}

#[test]
fn an_animation_plays_in_the_sense_of_its_drive() {
    let ranges =
        ["0 deg .. 360 deg", "360 deg .. 0 deg", "40 deg .. 400 deg", "10 deg .. 70 deg", "70 deg .. 10 deg"];
    for range in ranges {
        for (speed, sense) in
            [("at 60 rpm ccw", -1.0), ("at 60 rpm cw", 1.0), ("at -60 rpm", 1.0), ("turning cw", 1.0)]
        {
            let drive = format!("{range} in 12 steps {speed}");
            let (source, solved) = solved("crank", &crank(&drive)).expect("it is solved");
            let turn = turn_in(&solved.compiled, &solved.solution, FRAMES);
            let page = page(&source, &solved, &turn).expect("it moves");
            let moving = Moving::of(&page);
            // the y axis of paper points down; the first body is the crank
            let turned = &moving.columns[moving.bodies[0][4] as usize];
            assert!((turned[1] - turned[0]) * sense > 0.0, "{drive}: {:?}", &turned[..2]);
        }
    }
}

#[test]
fn a_train_turns_as_its_speeds_say() {
    // Willis with 24, 18 and 60 teeth, the ring at rest: ω_H = 24/84 ω_S, ω_P = (1 − 60/18) ω_H
    let text = "mech 1\nshaft S { wheel sun teeth 24 module 2 mm }\nshaft H\nshaft P on H { wheel p teeth 18 }\n\
         ground { wheel ring teeth 60 }\nmesh sp: sun - p\nmesh pr: p - ring { internal }\ndrive S at 7 rad/s\nfind omega(P)\n";
    let (source, solved) = solved("train", text).expect("it is solved");
    let moving = Moving::of(&crate::drawn::animated(&source, &solved).expect("it moves"));
    let last = moving.count() - 1;
    let turned = |body: &Vec<f64>| body.get(4).map(|k| moving.columns[*k as usize][last]);
    let mut turns: Vec<f64> = moving.bodies.iter().filter_map(turned).collect();
    turns.sort_by(f64::total_cmp);
    let sun = turns[0];
    // y of paper is down: counter-clockwise is negative
    let [carrier, planet] = [2.0 / 7.0, 2.0 / 7.0 * (1.0 - 60.0 / 18.0)].map(|ratio| sun * ratio);
    for wanted in [carrier, planet] {
        assert!(turns.iter().any(|turn| (turn - wanted).abs() < 2.0), "{wanted} of {turns:?}");
    }
    assert!(sun < 0.0 && planet > 0.0, "{turns:?}");
}
