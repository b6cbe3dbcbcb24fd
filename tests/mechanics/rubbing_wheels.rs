//! Friction in pairs beside wheels: closed forms of a gear pair on rubbing bearings, a damped fixed point on the equilibrium of
//! all links of a crank-slider driven through gears, and the equations of all bodies with 30 digits.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use crate::geared_chains::{answers, close, eliminate};
use crate::share::{least, part};
use crate::support::random::Random;

/// F_t = T/(r_2 − ρ_2/cos α), M = F_t (r_1/η + ρ_1/cos α) where II is driven against T.
#[test]
fn bearings_of_a_gear_pair_rub_with_the_tooth_force() {
    let mut random = Random::new(91);
    for i in 0..60 {
        let (r_1, r_2) = (random.within(0.03, 0.2), random.within(0.03, 0.2));
        let [rho_1, rho_2] = [0, 1].map(|_| random.within(0.001, 0.01));
        let (angle, eta) =
            (random.within(10.0, 25.0), if i % 2 == 0 { 1.0 } else { random.within(0.9, 0.99) });
        let (load, back) = (random.within(10.0, 100.0), random.sign() < 0.0);
        let text = format!(
            "ground {{ O1 (0, 0); O2 ({} m, 0) }}\nlink I {{ O (0, 0); wheel z1 radius {r_1} m at O }}\nlink II {{ O (0, 0); wheel z2 radius {r_2} m at O }}\n\
             revolute A: ground.O1 - I.O {{ friction_circle {rho_1} m }}\nrevolute B: ground.O2 - II.O {{ friction_circle {rho_2} m }}\n\
             mesh k: z1 - z2 {{ pressure_angle {angle} deg; efficiency {eta} }}\n\
             drive I at 10 rad/s\ntorque T on II = {} N*m\nbalance torque M on I\nfind M, tangential_force(k), efficiency()\n",
            r_1 + r_2,
            if back { -load } else { load }
        );
        let found = answers(&text);
        let Some(found) = &found[0] else { panic!("{text}") };
        let cos = angle.to_radians().cos();
        // I turns ccw, II cw: a torque ccw on II works against it. What is lost in the mesh the driver loses before its teeth
        let (tooth, m) = if back {
            let tooth = load / (r_2 / eta + rho_2 / cos);
            (tooth, tooth * (rho_1 / cos - r_1))
        } else {
            let tooth = load / (r_2 - rho_2 / cos);
            (tooth, tooth * (r_1 / eta + rho_1 / cos))
        };
        close(found["tangential_force(k)"][0], tooth, 1e-9, &text);
        close(found["M"][0], m, 1e-9, &text);
    }
}

/// A crank-slider whose crank is driven by a pinion.
struct Press {
    radii: [f64; 2],
    crank: f64,
    rod: f64,
    rho: [f64; 4],
    mu: f64,
    eta: f64,
    phi: f64,
    load: f64,
    /// The load is a torque on the motor, and the piston's force is sought.
    back: bool,
}

impl Press {
    /// `rough` multiplies radii of friction circles and coefficients.
    fn new(random: &mut Random, rough: f64) -> Self {
        let crank = random.within(0.05, 0.15);
        Self {
            radii: [random.within(0.05, 0.1), random.within(0.1, 0.3)],
            crank,
            rod: crank * random.within(2.5, 5.0),
            rho: std::array::from_fn(|_| rough * random.within(0.0005, 0.004)),
            mu: rough * random.within(0.02, 0.15),
            eta: random.within(0.9, 1.0),
            phi: random.within(-3.0, 3.0),
            load: random.sign() * random.within(100.0, 2000.0),
            back: false,
        }
    }

    fn text(&self) -> String {
        let loads = if self.back {
            format!("torque P on motor = {} N*m\nbalance force M on piston at B along 90 deg", self.load)
        } else {
            format!("force P on piston at B = {} N @ 90 deg\nbalance torque M on motor", self.load)
        };
        format!(
            "ground {{ O1 ({} m, 0); O2 (0, 0); line guide through O2 along 90 deg }}\n\
             link motor {{ O (0, 0); wheel z1 radius {} m at O }}\nlink crank O2-A {} m {{ wheel z2 radius {} m at O2 }}\n\
             link rod A-B {} m\nlink piston {{ B (0, 0) }}\n\
             revolute O1: ground.O1 - motor.O {{ friction_circle {} m }}\nrevolute O2: ground - crank {{ friction_circle {} m }}\n\
             revolute A: crank - rod {{ friction_circle {} m }}\nrevolute B: rod - piston {{ friction_circle {} m }}\n\
             prismatic D: piston.B - ground.guide {{ friction {} }}\nmesh k: z2 - z1 {{ pressure_angle 20 deg; efficiency {} }}\n\
             drive motor = {} rad at 3 rad/s cw\nassemble B ahead of O2\n\
             {loads}\n\
             find M, omega(motor), omega(crank), omega(rod), angle(rod), velocity(B).y, tangential_force(k), efficiency()\n",
            self.radii[0] + self.radii[1],
            self.radii[0],
            self.crank,
            self.radii[1],
            self.rod,
            self.rho[0],
            self.rho[1],
            self.rho[2],
            self.rho[3],
            self.mu,
            self.eta,
            -self.phi * self.radii[1] / self.radii[0],
        )
    }

    /// M and the tooth force by a damped fixed point; `None` where it does not settle.
    fn solve(&self) -> Option<[f64; 2]> {
        let (c, s) = (self.phi.cos(), self.phi.sin());
        let a = [self.crank * c, self.crank * s];
        let y = a[1] + (self.rod * self.rod - a[0] * a[0]).sqrt();
        let b = [0.0, y];
        let i = self.radii[1] / self.radii[0];
        let crank = 3.0 / i;
        // the rod: velocity of B has no x
        let v_a = [-a[1] * crank, a[0] * crank];
        let rod = v_a[0] / (b[1] - a[1]);
        let v = v_a[1] + rod * (b[0] - a[0]);
        let turns = [-3.0, crank, rod - crank, -rod];
        let (o_1, pitch) = ([self.radii[0] + self.radii[1], 0.0], [self.radii[1], 0.0]);
        let tangent = 20.0_f64.to_radians().tan();
        let mut rub = [0.0; 5];
        let (mut side, mut driven) = (1.0, true);
        let mut last = [f64::NAN; 2];
        for step in 0..4000 {
            // unknowns: O1 on motor, O2 on crank, A on rod, B on piston, N and couple on piston, tooth on motor, M
            let mut matrix = vec![vec![0.0; 12]; 12];
            let mut right = vec![0.0; 12];
            let pins = [(0, None, o_1), (1, None, [0.0; 2]), (2, Some(1), a), (3, Some(2), b)];
            for (k, (on, from, p)) in pins.into_iter().enumerate() {
                for (body, sign) in [(Some(on), 1.0), (from, -1.0)] {
                    let Some(body) = body else { continue };
                    matrix[3 * body][2 * k] += sign;
                    matrix[3 * body + 1][2 * k + 1] += sign;
                    matrix[3 * body + 2][2 * k] -= sign * p[1];
                    matrix[3 * body + 2][2 * k + 1] += sign * p[0];
                    right[3 * body + 2] -= sign * rub[k];
                }
            }
            matrix[9][8] = 1.0;
            matrix[11][8] = -b[1];
            matrix[11][9] = 1.0;
            // up on the motor's tooth where positive; the teeth part the axes
            let tooth = [side * tangent, 1.0];
            for (body, sign) in [(0, 1.0), (1, -1.0)] {
                matrix[3 * body][10] += sign * tooth[0];
                matrix[3 * body + 1][10] += sign * tooth[1];
                matrix[3 * body + 2][10] += sign * (pitch[0] * tooth[1] - pitch[1] * tooth[0]);
            }
            // what the driver loses before its teeth
            let lost = 1.0 / self.eta - 1.0;
            if driven {
                matrix[2][10] += lost * (pitch[0] - o_1[0]);
            } else {
                matrix[5][10] -= lost * pitch[0];
            }
            let (sought, loaded) = if self.back { (10, 2) } else { (2, 10) };
            matrix[sought][11] = 1.0;
            right[loaded] -= self.load;
            right[10] -= rub[4];
            let x = eliminate(matrix, right);
            // the motor turns cw: it drives where the crank's tooth gets power
            side = if x[10] < 0.0 { -1.0 } else { 1.0 };
            driven = -x[10] * pitch[0] * crank > 0.0;
            let weight = if step < 20 { 0.2 } else { 0.5 };
            for k in 0..4 {
                let force = x[2 * k].hypot(x[2 * k + 1]);
                rub[k] += weight * (-turns[k].signum() * self.rho[k] * force - rub[k]);
            }
            rub[4] += weight * (-v.signum() * self.mu * x[8].abs() - rub[4]);
            let now = [x[11], x[10].abs()];
            if now.iter().any(|x| !x.is_finite()) {
                return None;
            }
            if now.iter().zip(&last).all(|(a, b)| (a - b).abs() <= 1e-14 * a.abs()) {
                return Some(now);
            }
            last = now;
        }
        None
    }
}

#[test]
fn a_press_rubs_in_all_pairs_behind_its_gears() {
    let mut random = Random::new(92);
    let mut solved = 0;
    for _ in 0..part(120) {
        let press = Press::new(&mut random, 1.0);
        let Some([m, tooth]) = press.solve() else { continue };
        let text = press.text();
        let found = answers(&text);
        let found = found[0].as_ref().unwrap_or_else(|| panic!("{text}"));
        close(found["M"][0], m, 1e-8, &text);
        close(found["tangential_force(k)"][0], tooth, 1e-8, &text);
        solved += 1;
    }
    assert!(solved > least(100), "{solved}");
}

/// With much friction there may be no state of the forces, or several: what is reported satisfies all equations (see
/// `answers`), and where a state is found here it is not locked.
#[test]
fn a_rough_press_is_locked_only_where_no_state_is_found() {
    let mut random = Random::new(93);
    let (mut solved, mut locked, mut same) = (0, 0, 0);
    for _ in 0..part(150) {
        let press = Press { back: true, ..Press::new(&mut random, 10.0) };
        let own = press.solve();
        let text = press.text();
        let found = answers(&text);
        let Some(m) = found[0].as_ref().map(|found| found["M"][0]).filter(|m| m.is_finite()) else {
            locked += 1;
            assert!(own.is_none(), "{text}: {own:?}");
            continue;
        };
        solved += 1;
        same += usize::from(own.is_some_and(|own| (own[0] - m).abs() <= 1e-7 * (1.0 + m.abs())));
    }
    println!("{solved} solved, {locked} locked, {same} the same");
    assert!(
        solved > least(60) && locked > least(5) && same > least(50),
        "{solved} solved, {locked} locked, {same} the same"
    );
}
