//! Stops against the laws of momentum and of motion of all bodies with multipliers for hinges and stops, which the solver does not
//! use: random chains of three links that hit stops in their hinges, one and several at once, with rebound and without.

#![allow(clippy::unwrap_used)] // a test that cannot read its text has failed

use crate::support::random::Random;
use assur::internals::check::Overrides;
use assur::internals::math::Vec2;
use assur::internals::model::{MassProperties, Mechanism};
use assur::internals::position::State;
use assur::internals::solve_source;
use assur::internals::source::Source;
use nalgebra::{DMatrix, DVector};

/// A stop in the hinge between a link and the next: the sign of its gap against the angle, its limit, deg, its restitution.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stop {
    pub hinge: usize,
    pub sign: f64,
    limit: f64,
    restitution: f64,
}

/// A random chain on the ground, hinges `H0`, `H1`, `H2`, links `L1`, `L2`, `L3`, with stops on its two inner hinges.
pub(super) fn chain(seed: u64) -> (String, Vec<Stop>) {
    let mut random = Random::new(seed);
    let mut between = |low: f64, high: f64| random.within(low, high);
    let mut text = "mech 1\ngravity 9.81 m/s^2\nground { P0 (0, 0) }\n".to_owned();
    let (mut starts, mut hinges) = (String::new(), String::new());
    let mut angle = 0.0;
    for i in 0..3 {
        let (length, along) = (between(0.3, 0.8), between(0.3, 0.7));
        let (mass, inertia, rate) = (between(0.5, 3.0), between(0.01, 0.1), between(-4.0, 4.0));
        text += &format!(
            "link L{} P{i}-P{} {length} m {{ S ({} m, 0); mass {mass} kg at S; inertia {inertia} kg*m^2 }}\n",
            i + 1,
            i + 1,
            length * along
        );
        let base = if i == 0 { "ground".to_owned() } else { format!("L{i}") };
        hinges += &format!("revolute H{i}: {base}.P{i} - L{}.P{i}\n", i + 1);
        angle += between(-8.0, 8.0);
        starts += &format!("start L{} = {angle} deg at {rate} rad/s\n", i + 1);
    }
    let mut stops = Vec::new();
    for hinge in [1, 2] {
        for sign in [1.0, -1.0] {
            let restitution = if hinge == 1 { between(0.2, 0.6) } else { 0.0 };
            let stop = Stop { hinge, sign, limit: -sign * between(12.0, 30.0), restitution };
            let side = if sign > 0.0 { ">" } else { "<" };
            hinges +=
                &format!("stop H{hinge} {side} {} deg {{ restitution {} }}\n", stop.limit, stop.restitution);
            starts += &format!("event hits{}: displacement(H{hinge}) = {} deg\n", stops.len(), stop.limit);
            stops.push(stop);
        }
        // the state after an impact is printed at an event that it makes
        starts += &match hinge {
            1 => "event turns: relative_velocity(H1) = 0 rad/s\n".to_owned(),
            _ => format!("event rests: rests(H{hinge})\n"),
        };
    }
    text += &hinges;
    text += &starts;
    (text + "simulate 0.8 s within 1e-9\nfind energy()\n", stops)
}

/// The masses of all bodies, and the directions in which hinges and the stops that are reached can press.
pub(super) struct Bodies<'a> {
    pub mechanism: &'a Mechanism,
    pub state: &'a State,
}

impl Bodies<'_> {
    pub fn masses(&self) -> Vec<MassProperties> {
        self.mechanism.links.iter().skip(1).map(|link| link.mass.unwrap()).collect()
    }

    /// Velocities of the mass centres and of rotation, three numbers for each body.
    fn rates(&self, of: impl Fn(usize, Vec2) -> (Vec2, f64)) -> DVector<f64> {
        let each = self.masses().into_iter().enumerate().flat_map(|(i, mass)| {
            let (v, omega) = of(i + 1, mass.centre);
            [v.x, v.y, omega]
        });
        DVector::from_iterator(3 * self.masses().len(), each)
    }

    pub fn velocities(&self) -> DVector<f64> {
        let bodies = &self.state.motion.bodies;
        self.rates(|i, at| (bodies[i].velocity(at), bodies[i].omega))
    }

    pub fn accelerations(&self) -> DVector<f64> {
        let bodies = &self.state.motion.bodies;
        self.rates(|i, at| (bodies[i].acceleration(at), bodies[i].alpha))
    }

    /// Mass times rates.
    pub fn momentum(&self, rates: &DVector<f64>) -> DVector<f64> {
        let masses = self.masses();
        DVector::from_fn(rates.len(), |i, _| {
            let mass = &masses[i / 3];
            rates[i] * if i % 3 == 2 { mass.inertia } else { mass.mass }
        })
    }

    /// Generalised forces of all hinges, a column each for x and y, then of stops.
    pub fn directions(&self, stops: &[Stop]) -> DMatrix<f64> {
        let (bodies, masses) = (&self.state.motion.bodies, self.masses());
        let count = masses.len();
        let mut columns = DMatrix::zeros(3 * count, 2 * count + stops.len());
        for hinge in 0..count {
            let place = bodies[hinge + 1].position(Vec2::zero());
            let mut put = |body: usize, sign: f64| {
                let arm = place - bodies[body].position(masses[body - 1].centre);
                let row = 3 * (body - 1);
                (columns[(row, 2 * hinge)], columns[(row + 1, 2 * hinge + 1)]) = (sign, sign);
                (columns[(row + 2, 2 * hinge)], columns[(row + 2, 2 * hinge + 1)]) =
                    (-sign * arm.y, sign * arm.x);
            };
            put(hinge + 1, 1.0);
            if hinge > 0 {
                put(hinge, -1.0);
            }
        }
        for (k, stop) in stops.iter().enumerate() {
            columns[(3 * stop.hinge + 2, 2 * count + k)] = stop.sign;
            columns[(3 * (stop.hinge - 1) + 2, 2 * count + k)] = -stop.sign;
        }
        columns
    }

    /// How far a stop is from being reached, rad.
    pub fn gap(&self, stop: &Stop) -> f64 {
        let bodies = &self.state.motion.bodies;
        let angle = bodies[stop.hinge + 1].u.turned_back(bodies[stop.hinge].u).angle();
        stop.sign * (angle - stop.limit.to_radians())
    }
}

/// What hinges and stops give, and what they leave of what is wanted, over it.
fn given(directions: &DMatrix<f64>, wanted: &DVector<f64>) -> (DVector<f64>, f64) {
    let found = directions.clone().svd(true, true).solve(wanted, 1e-12).unwrap();
    let left = (directions * &found - wanted).norm() / wanted.norm().max(1e-3);
    (found, left)
}

/// How fast a stop opens.
fn opening(rates: &DVector<f64>, stop: &Stop) -> f64 {
    stop.sign * (rates[3 * stop.hinge + 2] - rates[3 * (stop.hinge - 1) + 2])
}

const TOLERANCE: f64 = 1e-7;
/// A stop is reached where the gap is rounding.
const REACHED: f64 = 5e-13;
/// A gap from there to here is neither: rebounds that are about to end pass through it.
const NEAR: f64 = 1e-9;

/// The laws of an impact, from just before it to just after it. How many stops take part.
pub(super) fn judge_impact(
    name: &str,
    mechanism: &Mechanism,
    stops: &[Stop],
    [before, after]: [&State; 2],
) -> usize {
    let (one, two) = (Bodies { mechanism, state: before }, Bodies { mechanism, state: after });
    let reached: Vec<Stop> = stops.iter().filter(|stop| two.gap(stop).abs() < REACHED).copied().collect();
    if stops.iter().any(|stop| (REACHED..NEAR).contains(&two.gap(stop).abs())) {
        return 0;
    }
    let (v, w) = (one.velocities(), two.velocities());
    let (impulses, left) = given(&two.directions(&reached), &two.momentum(&(&w - &v)));
    assert!(left < TOLERANCE, "{name}: {left}");
    let greatest = impulses.amax().max(1e-3);
    for (k, stop) in reached.iter().enumerate() {
        let impulse = impulses[6 + k];
        let (was, is) = (opening(&v, stop), opening(&w, stop));
        assert!(impulse > -TOLERANCE * greatest, "{name}: {stop:?} pulls {impulse}");
        if was < -TOLERANCE {
            assert!(
                (is + stop.restitution * was).abs() < TOLERANCE * was.abs().max(1.0),
                "{name}: {stop:?} {was} {is}"
            );
        } else {
            assert!(
                is > -TOLERANCE && impulse * is < TOLERANCE * greatest,
                "{name}: {stop:?} {is} {impulse}"
            );
        }
    }
    reached.len()
}

/// The laws of motion of all bodies at an instant, closed stops among what presses. How many are closed.
fn judge_instant(name: &str, mechanism: &Mechanism, stops: &[Stop], state: &State) -> usize {
    let bodies = Bodies { mechanism, state };
    for stop in stops {
        assert!(bodies.gap(stop) > -1e-9, "{name}: {stop:?} is passed by {}", -bodies.gap(stop));
    }
    let rates = bodies.velocities();
    let pressed = stops.iter().zip(&state.motion.stops).filter(|(_, force)| **force != 0.0);
    let closed: Vec<Stop> = pressed.map(|(stop, _)| *stop).collect();
    for stop in &closed {
        let (gap, rate) = (bodies.gap(stop), opening(&rates, stop));
        assert!(gap.abs() < NEAR && rate.abs() < TOLERANCE, "{name}: {stop:?} presses at {gap}, {rate}");
    }
    let a = bodies.accelerations();
    let mut wanted = bodies.momentum(&a);
    for (i, mass) in bodies.masses().iter().enumerate() {
        wanted[3 * i + 1] += 9.81 * mass.mass;
    }
    let (forces, left) = given(&bodies.directions(&closed), &wanted);
    assert!(left < TOLERANCE, "{name}: {left} of the forces");
    for (k, stop) in closed.iter().enumerate() {
        let opens = opening(&a, stop);
        let force = forces[6 + k];
        let scale = forces.amax();
        assert!(force > -TOLERANCE * scale, "{name}: {stop:?} pulls {force} N*m");
        assert!(
            opens > -1e-5 && (force * opens).abs() < 1e-5 * scale,
            "{name}: {stop:?} opens {opens} with {force}"
        );
    }
    closed.len()
}

#[test]
fn stops_of_random_chains_keep_the_laws_of_all_bodies() {
    let (mut impacts, mut together, mut closed, mut runs) = (0, 0, 0, 0);
    for seed in 0..super::many(40) {
        let (text, stops) = chain(seed);
        let (solved, problems) = solve_source(&Source::new("chain", &text), &Overrides::none());
        let Some(solved) = solved else { panic!("{text}\n{problems:?}") };
        let mechanism = &solved.compiled.mechanism;
        let states: Vec<&State> =
            solved.solution.poses.iter().filter_map(|p| Some(&p.outcome.as_ref().ok()?.state)).collect();
        runs += 1;
        let mut begin = 0;
        while begin < states.len() {
            let time = states[begin].motion.time;
            let end = begin + states[begin..].iter().take_while(|s| s.motion.time == time).count();
            let name = format!("chain {seed} at {time} s");
            let ends = [states[begin], states[end - 1]];
            let velocities = ends.map(|state| Bodies { mechanism, state }.velocities());
            if (&velocities[1] - &velocities[0]).norm() > 1e-6 {
                let reached = judge_impact(&name, mechanism, &stops, ends);
                impacts += usize::from(reached > 0);
                together += usize::from(reached > 1);
            } else {
                // what an impact pulls off opens just after it
                closed += judge_instant(&name, mechanism, &stops, ends[1]);
            }
            begin = end;
        }
    }
    println!("{runs} runs, {impacts} impacts, {together} with several stops, {closed} closed stops");
    assert!(impacts > 2 * runs && together > crate::share::least(3) && closed > crate::share::least(20));
}
