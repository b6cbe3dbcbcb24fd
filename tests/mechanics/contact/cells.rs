//! Random machines of every kind that rubs, holds or stops, against the oracle.

#![allow(clippy::unwrap_used)] // a test that cannot write or read its text has failed
#![allow(clippy::disallowed_methods, reason = "an independent computation")]

mod build;
mod carts;
mod loops;
mod rolling;
mod trains;
mod turning;

use super::oracle::Failure;
use crate::share;
use crate::support::random::Random;
use assur::Problem;
use build::{Asked, GRAVITY, Scene};
use serde_json::Value;

/// Of the greatest value.
const TOLERANCE: f64 = 2e-5;

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Kind {
    Guide,
    Static,
    BothEnds,
    Against,
    Stop,
    Circle,
    Brake,
    Contact,
    Loss,
}

#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Column {
    Driven,
    One,
    /// one free coordinate on a driven body
    Plate,
    Two,
    Loop,
}

const COLUMNS: [Column; 5] = [Column::Driven, Column::One, Column::Plate, Column::Two, Column::Loop];

/// How a case comes out.
#[derive(Debug)]
enum Outcome {
    Right,
    Wrong(String),
    Ended(String),
    /// what the oracle cannot do
    Unknown(String),
}

const INSTANTS: u8 = 8;
const END: f64 = 0.8;

impl Scene {
    fn file(&self) -> String {
        let asked: Vec<&str> = self.asked.iter().map(|(words, _)| &words[..]).collect();
        format!(
            "mech 1\nmechanism \"cell\"\ngravity {GRAVITY} m/s^2\nground {{ O (0, 0); {}Q (0, 1 m) }}\n{}simulate 0 s .. {END} s in {INSTANTS} steps\nfind {}\n",
            self.ground,
            self.text,
            asked.join(", ")
        )
    }

    /// Nothing, if the motion ends as no case here is to.
    fn outcome(&mut self) -> Option<Outcome> {
        let solve =
            |file: String| serde_json::from_str::<Value>(&Problem::new("cell", file).solve_json()).unwrap();
        if self.refused {
            let solution = solve(self.file());
            let code = &solution["diagnostics"][0]["code"];
            let right = *code == "mech::request::not_supported_yet"
                && solution["poses"].as_array().is_none_or(Vec::is_empty);
            let ended = || Outcome::Ended(format!("it is not refused: {}", solution["diagnostics"]));
            return Some(if right { Outcome::Right } else { ended() });
        }
        let asked: Vec<f64> = (1..=INSTANTS).map(|i| END * f64::from(i) / f64::from(INSTANTS)).collect();
        self.system.breaks.sort_by(f64::total_cmp);
        let seen = match self.system.run(&self.guess, &self.starts, &asked) {
            Ok(seen) => seen,
            Err(Failure::Ends) => return None,
            Err(Failure::Unknown(why)) => return Some(Outcome::Unknown(why)),
        };
        let solution = solve(self.file());
        let empty = Vec::new();
        let poses = solution["poses"].as_array().unwrap_or(&empty);
        let mut wrong = Vec::new();
        for (words, of) in &self.asked {
            let right: Vec<f64> = (seen.iter())
                .map(|seen| match of {
                    Asked::Value(of) => of.at(&seen.point).value,
                    Asked::Rate(of) => of.at(&seen.point).rate,
                    // beside an event an effort jumps
                    Asked::Effort(_) if !(seen.settled && seen.stage.determined) => f64::NAN,
                    Asked::Effort(j) => seen.stage.multipliers[*j],
                })
                .collect();
            let size = right.iter().filter(|x| x.is_finite()).fold(1e-2_f64, |most, x| most.max(x.abs()));
            for (time, right) in asked.iter().zip(right).filter(|(_, right)| right.is_finite()) {
                let near = |pose: &&Value| pose["time"].as_f64().is_some_and(|t| (t - time).abs() < 1e-9);
                let Some(pose) = poses.iter().find(near) else {
                    return Some(Outcome::Ended(format!(
                        "{words} is {right} at {time} s: {}",
                        solution["diagnostics"]
                    )));
                };
                let quantity = words.trim_end_matches(" as rad");
                let got = pose["quantities"][quantity].as_f64();
                if !got.is_some_and(|got| (got - right).abs() <= TOLERANCE * size) {
                    wrong.push(format!("{words} is {got:?}, not {right} at {time} s"));
                }
            }
        }
        Some(if wrong.is_empty() { Outcome::Right } else { Outcome::Wrong(wrong.join("\n")) })
    }
}

fn made(kind: Kind, column: Column, seed: u64, random: &mut Random) -> Scene {
    match (kind, column) {
        (Kind::Contact, _) => rolling::scene(random, column),
        (Kind::Loss, _) => trains::scene(random, column),
        (Kind::Against, Column::Two) if seed % 3 == 1 => rolling::puck(random),
        (_, Column::Loop) => loops::scene(random, kind, seed),
        (Kind::Circle | Kind::Brake, _) => turning::scene(random, kind, column),
        // every other one of what has stops turns
        (Kind::Stop, column) if column != Column::Driven && seed % 2 == 1 => {
            turning::scene(random, kind, column)
        }
        _ => carts::scene(random, kind, column),
    }
}

/// The case of a seed, and how it comes out.
fn tried(kind: Kind, column: Column, seed: u64) -> (Scene, Outcome) {
    let mut random = Random::new(seed * 1000 + (kind as u64) * 10 + column as u64);
    loop {
        let mut scene = made(kind, column, seed, &mut random);
        if let Some(outcome) = scene.outcome() {
            return (scene, outcome);
        }
    }
}

/// Three seeds of every column, or a hundred, or as many as are asked for.
fn check(kind: Kind) {
    let mut failures = Vec::new();
    let asked = std::env::var("ASSUR_CELLS").ok().and_then(|cells| cells.parse().ok());
    let seeds = asked.unwrap_or(if share::all() { 100 } else { 3 });
    for (column, seed) in COLUMNS.into_iter().flat_map(|column| (0..seeds).map(move |seed| (column, seed))) {
        let (scene, outcome) = tried(kind, column, seed);
        let why = match outcome {
            Outcome::Right => continue,
            Outcome::Wrong(why) | Outcome::Ended(why) => why,
            Outcome::Unknown(why) => format!("the oracle has no answer: {why}"),
        };
        failures.push(format!("{kind:?} {column:?} {seed}: {why}\n{}", scene.file()));
    }
    assert!(failures.is_empty(), "{} cells\n{}", failures.len(), failures.join("\n"));
}

#[test]
fn guides_rub() {
    check(Kind::Guide);
}

#[test]
fn guides_hold_more_than_they_rub() {
    check(Kind::Static);
}

#[test]
fn guides_rub_at_both_ends() {
    check(Kind::BothEnds);
}

#[test]
fn loads_act_against_motion() {
    check(Kind::Against);
}

#[test]
fn stops_hold_and_rebound() {
    check(Kind::Stop);
}

#[test]
fn hinges_rub_on_circles() {
    check(Kind::Circle);
}

#[test]
fn brakes_and_clutches_hold() {
    check(Kind::Brake);
}

#[test]
fn discs_and_cams_roll_and_slide() {
    check(Kind::Contact);
}

#[test]
fn transmissions_lose_power() {
    check(Kind::Loss);
}
