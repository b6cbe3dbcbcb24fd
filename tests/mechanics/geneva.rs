//! Geneva wheels of random size and place, over many turns: velocities and accelerations against differences, the turn per
//! slot, the force of the pin by the wheel's own equilibrium, the torque by the balance of powers, and an independent
//! position with twice the digits.
#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use assur::internals::check::Overrides;
use assur::internals::source::Source;
use std::f64::consts::{PI, TAU};
use std::fmt::Write;

struct Mix(u64);

impl Mix {
    fn between(&mut self, a: f64, b: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        a + (b - a) * (((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64)
    }
}

/// Angle of the pin, its speed and acceleration.
struct Drive {
    from: f64,
    step: f64,
    omega: f64,
    alpha: f64,
}

struct Wheel {
    slots: u32,
    distance: f64,
    radius: f64,
    across: f64,
    inertia: f64,
    torque: f64,
}

impl Wheel {
    /// With `excess` 1 the pin enters along the slot.
    fn random(mix: &mut Mix, excess: f64) -> Self {
        let slots = 3 + mix.between(0.0, 6.0) as u32;
        let distance = mix.between(0.05, 0.3);
        Self {
            slots,
            distance,
            radius: distance * (PI / f64::from(slots)).sin() * excess,
            across: mix.between(-PI, PI),
            inertia: mix.between(1e-4, 1e-2),
            torque: mix.between(-2.0, 2.0),
        }
    }

    /// Direction of the named slot from the centre, with all turns: by the place of the pin, over and over.
    fn angle(&self, phi: f64) -> f64 {
        let turns = ((phi + PI) / TAU).floor();
        let (sin, cos) = (phi - TAU * turns).sin_cos();
        let half = PI / f64::from(self.slots);
        let seen = -(self.radius * sin).atan2(self.distance - self.radius * cos);
        let entering = (half.sin() * self.distance / self.radius).min(1.0).asin() - half;
        let phi = phi - TAU * turns;
        let delta = if phi.abs() < entering { seen } else { -half * phi.signum() };
        delta - 2.0 * half * turns
    }

    fn text(&self, drive: &Drive, count: usize) -> String {
        let mut text = String::from("ground { A (10 mm, -20 mm); ");
        let (x, y) = (self.distance * self.across.cos(), self.distance * self.across.sin());
        let _ = writeln!(text, "C ({:?} m, {:?} m) }}", 0.01 + x, -0.02 + y);
        let _ = writeln!(text, "link crank A-B {:?} m", self.radius);
        let _ = writeln!(
            text,
            "link wheel {{ C (7 mm, 3 mm); line slot through C along 40 deg; mass 1 kg at C; inertia {:?} kg*m^2 }}",
            self.inertia
        );
        text += "revolute A: ground - crank\nrevolute C: ground - wheel\n";
        let _ = writeln!(text, "slot K: crank.B - wheel.slot {{ slots {} }}", self.slots);
        let poses: Vec<String> = (0..count)
            .map(|i| format!("{:?} rad", self.across + drive.from + drive.step * i as f64))
            .collect();
        let _ = writeln!(
            text,
            "drive crank = {} at {:?} rad/s accelerating {:?} rad/s^2",
            poses.join(", "),
            drive.omega,
            drive.alpha
        );
        let _ = writeln!(text, "torque on wheel = {:?} N*m\nbalance torque M on crank", self.torque);
        text + "find angle(wheel), omega(wheel), alpha(wheel), reaction(C, wheel), M\n"
    }
}

#[test]
fn wheels_turn_slot_by_slot_and_carry_what_their_equilibrium_says() {
    let mut mix = Mix(5);
    for case in 0..60 {
        let excess = if case % 3 == 0 { mix.between(1.0, 1.1) } else { 1.0 };
        let wheel = Wheel::random(&mut mix, excess);
        if wheel.radius > 0.97 * wheel.distance {
            continue;
        }
        let sense = if mix.between(0.0, 1.0) < 0.5 { -1.0 } else { 1.0 };
        let drive = Drive {
            from: mix.between(-PI + 0.01, PI - 0.01),
            step: sense * mix.between(0.2, 0.9),
            omega: sense * mix.between(1.0, 20.0),
            alpha: mix.between(-30.0, 30.0),
        };
        let text = wheel.text(&drive, 40);
        let source = Source::new("geneva.mech", &text);
        let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
        let all = solved.unwrap_or_else(|| panic!("{text}\n{problems:?}"));
        let (solution, model) = (&all.solution, all.compiled.model());
        for (i, pose) in solution.poses.iter().enumerate() {
            let solved = pose.outcome.as_ref().unwrap_or_else(|e| panic!("{text}\n{e:?}"));
            let phi = drive.from + drive.step * i as f64;
            let h = 1e-5;
            let at = |x: f64| wheel.angle(phi + x);
            let first = (at(h) - at(-h)) / (2.0 * h);
            let second = (at(h) - 2.0 * at(0.0) + at(-h)) / (h * h);
            let half = PI / f64::from(wheel.slots);
            let entering = (half.sin() * wheel.distance / wheel.radius).min(1.0).asin() - half;
            let near = (phi - TAU * ((phi + PI) / TAU).floor()).abs() - entering;
            let told = || format!("case {case}, pose {i}\n{text}");
            let body = &solved.state.motion.bodies[2];
            let named = 40.0_f64.to_radians();
            let wanted = wheel.across + PI + at(0.0) - named;
            assert!((body.u.angle() - wanted).sin().abs() < 1e-12, "{}", told());
            assert!((body.u.angle() - wanted).cos() > 0.0, "{}", told());
            if i > 0 {
                let turned = solved.angles[2] - solution.poses[0].outcome.as_ref().expect("solved").angles[2];
                assert!((turned - (at(0.0) - wheel.angle(drive.from))).abs() < 1e-9, "{}", told());
            }
            if near.abs() < 1e-3 {
                continue;
            }
            if i % 8 == 0 {
                crate::jerks::hold(&model, &solved.state, told);
            }
            let omega = first * drive.omega;
            let alpha = second * drive.omega * drive.omega + first * drive.alpha;
            assert!(
                (body.omega - omega).abs() < 1e-7 * drive.omega.abs(),
                "{} {omega}\n{}",
                body.omega,
                told()
            );
            let scale = drive.omega * drive.omega + drive.alpha.abs();
            assert!((body.alpha - alpha).abs() < 2e-4 * scale, "{} {alpha}\n{}", body.alpha, told());
            // power: M ω + L Ω = J Ω Ω̇
            let effort = solved.state.forces.efforts[0];
            let balance =
                wheel.inertia * body.alpha * body.omega - wheel.torque * body.omega - effort * drive.omega;
            let most = (wheel.torque.abs() + wheel.inertia * body.alpha.abs()) * drive.omega.abs();
            assert!(balance.abs() < 1e-12 * most.max(1e-3), "{balance:e}\n{}", told());
            let residuals = solved.residuals;
            assert!(residuals.closure < 1e-13, "{residuals:?}\n{}", told());
            assert!(residuals.equilibrium.is_some_and(|r| r < 1e-13), "{residuals:?}\n{}", told());
            assert!(residuals.power.is_some_and(|r| r < 1e-13), "{residuals:?}\n{}", told());
            let exact = solution.reference(&model, solved);
            let exact = exact.unwrap_or_else(|| panic!("a reference\n{}", told()));
            let other = &exact.bodies[2];
            // the rounding of the drive's angle counts several hundredfold where the pin passes near the wheel's centre
            let near = 1e-10 * (scale + body.alpha.abs());
            assert!((other.alpha.rounded() - body.alpha).abs() < near, "{}", told());
            assert!((exact.efforts[0].rounded() - effort).abs() < 1e-10 * most.max(1e-3), "{}", told());
        }
    }
}
