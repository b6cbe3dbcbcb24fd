//! From event to event.

use super::states::{Ends, RESTS, Stage};
use super::{Point, Row, Rub, State, System};

const STEP: f64 = 1e-3;

/// An instant that was asked for: its point, its stage, whether an event is near.
pub struct Seen {
    pub point: Point,
    pub stage: Stage,
    pub settled: bool,
}

/// Why there is no motion.
#[derive(Debug)]
pub enum Failure {
    /// a bond would pull, or a point rests that a load brakes in the plane: the case is not one of these
    Ends,
    Unknown(String),
}

impl From<&str> for Failure {
    fn from(why: &str) -> Self {
        Self::Unknown(why.to_owned())
    }
}

impl System {
    fn rates(&self, point: &Point, state: &State) -> Option<Vec<f64>> {
        Some(self.stage(point, &self.rows(point), state)?.accelerations)
    }

    /// A step of Runge and Kutta's method of order 4 with fixed states.
    pub fn step(&self, from: &Point, state: &State, h: f64) -> Option<Point> {
        let moved = |by: f64, v: &[f64], a: &[f64]| {
            let add = |x: &[f64], dx: &[f64]| x.iter().zip(dx).map(|(x, dx)| x + by * dx).collect();
            Point { time: from.time + by, within: from.within, q: add(&from.q, v), v: add(&from.v, a) }
        };
        let a = self.rates(from, state)?;
        let second = moved(h / 2.0, &from.v, &a);
        let b = self.rates(&second, state)?;
        let third = moved(h / 2.0, &second.v, &b);
        let c = self.rates(&third, state)?;
        let last = moved(h, &third.v, &c);
        let d = self.rates(&last, state)?;
        let mean = |a: &[f64], b: &[f64], c: &[f64], d: &[f64]| {
            (0..a.len()).map(|i| (a[i] + 2.0 * (b[i] + c[i]) + d[i]) / 6.0).collect::<Vec<f64>>()
        };
        Some(moved(h, &mean(&from.v, &second.v, &third.v, &last.v), &mean(&a, &b, &c, &d)))
    }

    /// Nothing rubs, is held or closed.
    fn loose(&self) -> State {
        State {
            rubs: vec![Rub::Stands; self.elements.len()],
            sides: self.elements.iter().map(|e| vec![1.0; e.parts.len()]).collect(),
            closed: vec![false; self.stops.len()],
        }
    }

    /// Where drives alone carry what they move: as a step without any friction.
    pub fn carried(&self, from: &Point, h: f64) -> Point {
        self.step(from, &self.loose(), h).unwrap_or_else(|| from.clone())
    }

    /// Positions and rates that satisfy all constraints, with started scalars at their values and rates.
    fn start(&self, guess: &[f64], starts: &[(super::Scalar, f64, f64)]) -> Option<Point> {
        let within = self.breaks.first().map_or(1e-3, |first| first / 2.0);
        let mut point = Point { time: 0.0, within, q: guess.to_vec(), v: vec![0.0; guess.len()] };
        let rows_of = |point: &Point| {
            let law = |c: &super::Constraint| c.law.as_ref().map_or([0.0; 3], |law| law(0.0, within));
            let given = self.constraints.iter().map(|c| (c.of.at(point), law(c)));
            let started = starts.iter().map(|(of, at, rate)| (of.at(point), [*at, *rate, 0.0]));
            given.chain(started).collect::<Vec<(Row, [f64; 3])>>()
        };
        for _ in 0..30 {
            let rows = rows_of(&point);
            let wanted: Vec<(&[f64], f64)> =
                rows.iter().map(|(row, law)| (&row.gradient[..], law[0] - row.value)).collect();
            let moved = self.impulses(&vec![0.0; guess.len()], &wanted)?.0;
            point.q.iter_mut().zip(&moved).for_each(|(q, dq)| *q += dq);
        }
        let rows = rows_of(&point);
        let wanted: Vec<(&[f64], f64)> = rows.iter().map(|(row, law)| (&row.gradient[..], law[1])).collect();
        point.v = self.impulses(&point.v, &wanted)?.0;
        Some(point)
    }

    /// Takes what rounding left of the rates of what is held and closed.
    fn settle(&self, point: &mut Point, state: &State) {
        let rows = self.rows(point);
        let given = rows.constraints.iter().zip(&rows.laws).map(|(row, law)| (&row.gradient[..], law[1]));
        let held = rows.elements.iter().zip(&state.rubs).filter(|(_, rub)| **rub == Rub::Held);
        let shut = rows.stops.iter().zip(&state.closed).filter(|(_, closed)| **closed);
        let still =
            held.map(|(row, _)| row).chain(shut.map(|(row, _)| row)).map(|row| (&row.gradient[..], 0.0));
        let all: Vec<_> = given.chain(still).collect();
        if let Some((v, _)) = self.impulses(&point.v, &all) {
            point.v = v;
        }
    }

    /// Moreau's impact of all stops that touch: each rate is at least −e times what it was, or its impulse is zero.
    fn strike(&self, point: &mut Point, touching: &[usize]) -> Option<()> {
        let rows = self.rows(point);
        let given: Vec<_> =
            rows.constraints.iter().zip(&rows.laws).map(|(row, law)| (&row.gradient[..], law[1])).collect();
        let mut parts: Vec<u32> = (1..1 << touching.len()).collect();
        parts.sort_by_key(|part| u32::MAX - part.count_ones());
        for part in parts {
            let hit = |at: usize| part & 1 << at != 0;
            let wanted = |u: usize| {
                let rate = rows.stops[u].rate;
                // slow rebounds end: what is left of them is below the tolerance
                let e = if rate.abs() < 1e-6 { 0.0 } else { self.stops[u].restitution };
                -e * (self.stops[u].sense * rate).min(0.0) * self.stops[u].sense
            };
            let all: Vec<_> = (given.iter().copied())
                .chain(
                    (0..touching.len())
                        .filter(|&at| hit(at))
                        .map(|at| (&rows.stops[touching[at]].gradient[..], wanted(touching[at]))),
                )
                .collect();
            let (v, impulses) = self.impulses(&point.v, &all)?;
            let struck = (0..touching.len()).filter(|&at| hit(at)).map(|at| self.stops[touching[at]].sense);
            let push =
                impulses[given.len()..].iter().zip(struck).all(|(impulse, sense)| impulse * sense >= -1e-12);
            let after =
                |u: usize| rows.stops[u].gradient.iter().zip(&v).map(|(slope, v)| slope * v).sum::<f64>();
            let pass = touching.iter().all(|&u| self.stops[u].sense * (after(u) - wanted(u)) >= -1e-9);
            if push && pass {
                point.v = v;
                return Some(());
            }
        }
        None
    }

    /// The motion at the asked instants, or why there is none.
    pub fn run(
        &self,
        guess: &[f64],
        starts: &[(super::Scalar, f64, f64)],
        asked: &[f64],
    ) -> Result<Vec<Seen>, Failure> {
        let end = asked.last().copied().unwrap_or(0.0);
        let mut point = self.start(guess, starts).ok_or("start")?;
        let mut fastest = self.fastest(&point);
        let mut state = self.loose();
        let (mut seen, mut events, mut rested) = (Vec::new(), 0, Vec::new());
        loop {
            events += 1;
            if events > 600 {
                return Err(Failure::Unknown(format!("too many events at {}", point.time)));
            }
            let next = self.breaks.iter().copied().find(|at| *at > point.time + 1e-12).unwrap_or(end + 1.0);
            point.within = f64::midpoint(point.time, next);
            fastest = self.fastest(&point).max(fastest);
            state = self
                .choose(&point, &state, &rested, fastest)
                .ok_or_else(|| Failure::Unknown(format!("jams at {} from {state:?}", point.time)))?;
            self.settle(&mut point, &state);
            let began = point.time;
            let ended = loop {
                let until = asked.get(seen.len()).map_or(end, |at| *at);
                if point.time >= until - 1e-12 {
                    let stage = self.stage(&point, &self.rows(&point), &state).ok_or("stage")?;
                    seen.push(Seen {
                        point: point.clone(),
                        stage,
                        settled: point.time > began + 1e-4 && !state.rubs.contains(&Rub::Stands),
                    });
                    if seen.len() == asked.len() {
                        return Ok(seen);
                    }
                    continue;
                }
                if point.time >= next - 1e-12 {
                    break Vec::new();
                }
                let fast = point.v.iter().fold(20.0_f64, |most, v| most.max(v.abs()));
                let h = (STEP * 20.0 / fast).min(until - point.time).min(next - point.time);
                let (after, ended) = self.past(&point, &state, h, fastest)?;
                if ended.is_empty() {
                    point = after;
                    continue;
                }
                let (mut low, mut high) = (0.0, h);
                while high - low > 1e-12 {
                    let middle = f64::midpoint(low, high);
                    if self.past(&point, &state, middle, fastest)?.1.is_empty() {
                        low = middle
                    } else {
                        high = middle
                    }
                }
                let (after, ended) = self.past(&point, &state, high, fastest)?;
                point = after;
                break ended;
            };
            if let Some(last) = seen.last_mut().filter(|last| last.point.time > point.time - 1e-4) {
                last.settled = false;
            }
            rested = self.change(&mut point, &mut state, &ended, fastest)?;
        }
    }

    fn fastest(&self, point: &Point) -> f64 {
        let rows = self.rows(point);
        rows.elements
            .iter()
            .chain(&rows.stops)
            .fold(0.0, |most, row| most.max(row.rate.abs()).max(row.terms * 1e-3))
    }

    /// The point a step later, and what has ended by then.
    fn past(&self, from: &Point, state: &State, h: f64, fastest: f64) -> Result<(Point, Vec<Ends>), Failure> {
        let mut after = self.step(from, state, h).ok_or("no stage on the way")?;
        self.settle(&mut after, &self.loose());
        let rows = self.rows(&after);
        let stage = self.stage(&after, &rows, state).ok_or("no stage after a step")?;
        let rooms = self.rooms(&after, &rows, state, &stage, fastest);
        let ended = rooms.into_iter().filter(|(_, room)| *room < 0.0).map(|(ends, _)| ends).collect();
        Ok((after, ended))
    }

    /// What an event does to rates and states. The rest is chosen. Gives what is at rest.
    fn change(
        &self,
        point: &mut Point,
        state: &mut State,
        ended: &[Ends],
        fastest: f64,
    ) -> Result<Vec<usize>, Failure> {
        let (mut hit, mut turned) = (Vec::new(), Vec::new());
        for ends in ended {
            match *ends {
                Ends::Slides(i) if !self.elements[i].driven => turned.push(i),
                Ends::Side(i, p) => state.sides[i][p] *= -1.0,
                Ends::Presses(u) => state.closed[u] = false,
                Ends::Open(u) => hit.push(u),
                Ends::Bond => return Err(Failure::Ends),
                _ => {}
            }
        }
        let rests = |(i, rub): (usize, &Rub)| (*rub == Rub::Held || turned.contains(&i)).then_some(i);
        let resting: Vec<usize> = state.rubs.iter().enumerate().filter_map(rests).collect();
        if hit.is_empty() {
            return Ok(resting);
        }
        let touching: Vec<usize> =
            (0..self.stops.len()).filter(|u| hit.contains(u) || state.closed[*u]).collect();
        self.strike(point, &touching).ok_or("impact")?;
        let rows = self.rows(point);
        for u in touching {
            state.closed[u] = rows.stops[u].rate.abs() <= RESTS * fastest;
        }
        // friction does not act in an impact: what was held may slide after it
        Ok(resting.into_iter().filter(|&i| rows.elements[i].rate.abs() <= RESTS * fastest).collect())
    }
}
