//! Random arms whose tips are driven, against the inverse of the Jacobian and Lagrange's equations; and the force at the tip against
//! the torques that do the same.

use super::masses::within;
use libm::{acos, atan2, cos, sin};

const G: f64 = 9.81;

struct Arm {
    l: [f64; 2],
    m: [f64; 2],
    tip: [f64; 2],
    v: [f64; 2],
    a: [f64; 2],
    /// The elbow is on the left of the line to the tip.
    left: bool,
}

impl Arm {
    fn random(state: &mut u64) -> Self {
        let l = [0; 2].map(|_| within(state, 0.2, 1.0));
        let (least, most) = ((l[0] - l[1]).abs(), l[0] + l[1]);
        let reach = least + (most - least) * within(state, 0.1, 0.9);
        let towards = within(state, -3.1, 3.1);
        Self {
            l,
            m: [0; 2].map(|_| within(state, 0.5, 5.0)),
            tip: [reach * cos(towards), reach * sin(towards)],
            v: [0; 2].map(|_| within(state, -1.0, 1.0)),
            a: [0; 2].map(|_| within(state, -3.0, 3.0)),
            left: within(state, 0.0, 1.0) < 0.5,
        }
    }

    fn text(&self, efforts: &str) -> String {
        let Self { l, m, tip, v, a, left } = self;
        let link = |name: &str, ends: &str, i: usize| {
            let (half, j) = (l[i] / 2.0, m[i] * l[i] * l[i] / 12.0);
            format!(
                "link {name} {ends} {} m {{ S ({half} m, 0); mass {} kg at S; inertia {j} kg*m^2 }}\n",
                l[i], m[i]
            )
        };
        format!(
            "gravity 9.81 m/s^2\nground {{ A (0, 0) }}\n{}{}revolute A: ground - upper\nrevolute B: upper - fore\ndrive fore.C = \
             ({} m, {} m) at ({} m/s, {} m/s) accelerating ({} m/s^2, {} m/s^2)\nassemble B {} of A-C\n{efforts}",
            link("upper", "A-B", 0),
            link("fore", "B-C", 1),
            tip[0],
            tip[1],
            v[0],
            v[1],
            a[0],
            a[1],
            if *left { "left" } else { "right" },
        )
    }

    /// Rates, accelerations, torques on the arms from the ground.
    fn expected(&self) -> [f64; 6] {
        let Self { l: [l_1, l_2], m: [m_1, m_2], tip: [x, y], v, a, left } = *self;
        let elbow =
            acos((x * x + y * y - l_1 * l_1 - l_2 * l_2) / (2.0 * l_1 * l_2)) * if left { 1.0 } else { -1.0 };
        let q_1 = atan2(y, x) + atan2(l_2 * sin(elbow), l_1 + l_2 * cos(elbow));
        let q_2 = q_1 - elbow;
        let ((c_1, s_1), (c_2, s_2)) = ((cos(q_1), sin(q_1)), (cos(q_2), sin(q_2)));
        let det = l_1 * l_2 * sin(q_2 - q_1);
        let solve = |x: f64, y: f64| [l_2 * (c_2 * x + s_2 * y) / det, -l_1 * (c_1 * x + s_1 * y) / det];
        let [w_1, w_2] = solve(v[0], v[1]);
        let (n_1, n_2) = (l_1 * w_1 * w_1, l_2 * w_2 * w_2);
        let [a_1, a_2] = solve(a[0] + n_1 * c_1 + n_2 * c_2, a[1] + n_1 * s_1 + n_2 * s_2);
        let (first, both, second) =
            (m_1 * l_1 * l_1 / 3.0 + m_2 * l_1 * l_1, m_2 * l_1 * l_2 / 2.0, m_2 * l_2 * l_2 / 3.0);
        let (c, s) = (cos(q_1 - q_2), sin(q_1 - q_2));
        let upper = first * a_1 + both * (c * a_2 + s * w_2 * w_2) + (m_1 / 2.0 + m_2) * G * l_1 * c_1;
        let fore = second * a_2 + both * (c * a_1 - s * w_1 * w_1) + m_2 * G * l_2 / 2.0 * c_2;
        [w_1, w_2, a_1, a_2, upper, fore]
    }
}

fn numbers(text: &str, names: &[&str]) -> Vec<f64> {
    let solution = assur::solve(format!("{text}find {}\n", names.join(", ")));
    let solution = solution.unwrap_or_else(|e| panic!("{text}\n{e}"));
    let pose = &solution.poses()[0];
    let number = |name: &&str| match pose[*name].si() {
        assur::Quantity::Number(x) => x,
        other => panic!("{name} is {other:?} in\n{text}"),
    };
    names.iter().map(number).collect()
}

#[test]
fn tips_against_jacobians() {
    let mut state = 18;
    for _ in 0..200 {
        let arm = Arm::random(&mut state);
        let [w_1, w_2, a_1, a_2, upper, fore] = arm.expected();
        let text = arm.text("balance torque M1 on upper\nbalance torque M2 in B\n");
        let names = ["omega(upper)", "omega(fore)", "alpha(upper)", "alpha(fore)", "M1", "M2"];
        let expected = [w_1, w_2, a_1, a_2, upper + fore, fore];
        for (x, y) in numbers(&text, &names).iter().zip(expected) {
            assert!((x - y).abs() <= 1e-9 * (1.0 + y.abs()), "{x} for {y} in\n{text}");
        }
        // without motors the tip is pushed: its power is that of the motors, now and for any other motion
        let text = arm.text("");
        let found = numbers(&text, &["effort(fore.C).x", "effort(fore.C).y", "power(fore.C)"]);
        let power = upper * w_1 + fore * w_2;
        let pushed = found[0] * arm.v[0] + found[1] * arm.v[1];
        for x in [found[2], pushed] {
            assert!((x - power).abs() <= 1e-8 * (1.0 + power.abs()), "{x} for {power} in\n{text}");
        }
    }
}
