//! Bevel trains against the velocities of their teeth in space, and forces with losses against the balance of every shaft.

#![allow(clippy::disallowed_methods, reason = "an independent computation")]

use super::masses::{values, within};
use super::quick_rows::random;

type V = [f64; 3];

fn cross(a: V, b: V) -> V {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Two central wheels, each on a wheel of one planet of a carrier: teeth of the central and of the planet's wheel, its side, what
/// its mesh passes on.
struct Train {
    teeth: [[f64; 2]; 2],
    far: [bool; 2],
    efficiency: [f64; 2],
    swapped: [bool; 2],
}

impl Train {
    fn random(state: &mut u64, lossy: bool) -> Self {
        let mut whole = |least: f64, most: f64| within(state, least, most).floor();
        let mut teeth = [[whole(12.0, 60.0), whole(12.0, 40.0)], [whole(12.0, 60.0), whole(12.0, 40.0)]];
        if random(state) < 0.2 {
            teeth[0][1] = teeth[0][0];
        }
        let mut coin = || random(state) < 0.5;
        let (far, swapped) = ([coin(), coin()], [coin(), coin()]);
        let mut part = || if lossy { within(state, 0.9, 1.0) } else { 1.0 };
        Self { teeth, far, efficiency: [part(), part()], swapped }
    }

    fn text(&self) -> String {
        let [[a, p], [b, q]] = self.teeth;
        let mut text = format!(
            "shaft left {{ wheel a teeth {a}; inertia 0.02 kg*m^2 }}\nshaft right {{ wheel b teeth {b}; inertia 0.03 kg*m^2 }}\n\
             shaft cage {{ inertia 0.5 kg*m^2 }}\nshaft planet on cage {{ wheel p teeth {p}; wheel q teeth {q}; inertia 0.01 kg*m^2 }}\n"
        );
        for (i, [own, other]) in [["a", "p"], ["b", "q"]].into_iter().enumerate() {
            let [first, second] = if self.swapped[i] { [other, own] } else { [own, other] };
            let far = if self.far[i] { " far" } else { "" };
            let loss = if self.efficiency[i] < 1.0 {
                format!("; efficiency {}", self.efficiency[i])
            } else {
                String::new()
            };
            text += &format!("mesh k{own}: {first} - {second} {{ bevel{far}{loss} }}\n");
        }
        text
    }

    /// How fast the planet turns about its axis for one of a central wheel seen from the carrier: their teeth have one velocity. The
    /// planet's axis is x, from outside inwards; the wheel on this side lies below it.
    fn ratio(&self, i: usize) -> f64 {
        let [own, planet] = self.teeth[i];
        let at = [-own, 0.0, if self.far[i] { planet } else { -planet }];
        let (of_own, of_planet) = (cross([0.0, 0.0, 1.0], at), cross([1.0, 0.0, 0.0], at));
        of_own[1] / of_planet[1]
    }

    /// The rates of carrier and planet for those of the central wheels.
    fn rates(&self, [a, b]: [f64; 2]) -> [f64; 2] {
        let [i, j] = [self.ratio(0), self.ratio(1)];
        let cage = (i * a - j * b) / (i - j);
        [cage, i * (a - cage)]
    }
}

#[test]
fn teeth_have_one_velocity_and_every_shaft_is_in_balance() {
    let mut state = 77;
    let mut lost = 0;
    for case in 0..200 {
        let train = Train::random(&mut state, case % 2 == 1);
        if (train.ratio(0) - train.ratio(1)).abs() < 0.1 {
            continue;
        }
        let speeds = [within(&mut state, 10.0, 90.0), within(&mut state, -90.0, 90.0)];
        let accelerations = [within(&mut state, -20.0, 20.0), within(&mut state, -20.0, 20.0)];
        let load = within(&mut state, -300.0, 300.0);
        let text = format!(
            "{}drive left at {} rad/s accelerating {} rad/s^2\ndrive right at {} rad/s accelerating {} rad/s^2\n\
             torque M on cage = {load} N*m\nbalance torque A on left\nbalance torque B on right\n",
            train.text(),
            speeds[0],
            accelerations[0],
            speeds[1],
            accelerations[1]
        );
        let names = ["omega(cage)", "omega(planet)", "alpha(planet)", "A", "B"];
        let found = values(&text, &names.map(str::to_owned));
        let [cage, planet] = train.rates(speeds);
        let [cage_2, planet_2] = train.rates(accelerations);
        let near =
            |x: f64, y: f64| assert!((x - y).abs() < 1e-8 * (1.0 + load.abs()), "{x} {y}\n{text}\n{found:?}");
        near(found[0], cage);
        near(found[1], planet);
        near(found[2], planet_2);
        // couples of the meshes on the central wheels, from the efforts; what they pass on to the planet
        let on = [0.02 * accelerations[0] - found[3], 0.03 * accelerations[1] - found[4]];
        let passed = [0, 1].map(|i| {
            let taken = -on[i] * (speeds[i] - cage);
            let given = if taken > 0.0 { train.efficiency[i] * taken } else { taken / train.efficiency[i] };
            lost += usize::from(given != taken);
            given / planet
        });
        near(passed[0] + passed[1], 0.01 * planet_2);
        near(load - on[0] - on[1], 0.5 * cage_2);
    }
    assert!(lost > 50, "{lost}");
}

#[test]
fn side_wheels_turn_as_with_two_planets_that_mesh() {
    let mut state = 5;
    for _ in 0..40 {
        let [a, p, b] = [12.0, 12.0, 12.0].map(|least: f64| within(&mut state, least, 50.0).floor());
        let drives = format!(
            "drive cage at {} rpm\ndrive left at {} rpm\n",
            within(&mut state, -500.0, 500.0),
            within(&mut state, -500.0, 500.0)
        );
        let sides = format!(
            "shaft cage\nshaft left {{ wheel a teeth {a} }}\nshaft right {{ wheel b teeth {b} }}\nshaft p on cage {{ wheel c teeth {p} }}\n"
        );
        let bevel = format!("{sides}mesh m: a - c {{ bevel }}\nmesh n: c - b {{ bevel far }}\n{drives}");
        let spur = format!(
            "{sides}shaft q on cage {{ wheel d teeth {p} }}\nmesh m: a - c\nmesh k: c - d\nmesh n: d - b\n{drives}"
        );
        let asked = ["omega(right)".to_owned()];
        let (one, two) = (values(&bevel, &asked)[0], values(&spur, &asked)[0]);
        assert!((one - two).abs() < 1e-10 * (1.0 + two.abs()), "{one} {two}\n{bevel}");
    }
}

/// A right-angle drive on the ground; wheels of one planet shaft that belts and spur wheels join to another.
#[test]
fn shafts_across_each_other_turn_as_outer_meshes() {
    let text = "shaft I { wheel a teeth 20 }\nshaft II { wheel b teeth 50 }\nmesh k: a - b { bevel }\ndrive I at 100 rad/s\n\
                torque M on II = 30 N*m\nbalance torque T on I\n";
    let found = values(text, &["omega(II)", "T", "moment(k, II)"].map(str::to_owned));
    assert!((found[0] + 40.0).abs() < 1e-12 && (found[1] - 12.0).abs() < 1e-12, "{found:?}");
    let text = "shaft cage\nshaft left { wheel a teeth 30 }\nshaft p on cage { wheel c teeth 15; wheel e teeth 20 }\n\
                shaft q on cage { wheel f teeth 40; wheel d teeth 10 }\nshaft right { wheel b teeth 25 }\n\
                mesh m: a - c { bevel }\nmesh k: e - f\nmesh n: d - b { bevel far }\ndrive cage at 7 rad/s\ndrive left at 10 rad/s\n";
    let found = values(text, &["omega(p)", "omega(q)", "omega(right)"].map(str::to_owned));
    let wanted = [-6.0, 3.0, 7.0 + 3.0 * 10.0 / 25.0];
    assert!(found.iter().zip(wanted).all(|(x, y)| (x - y).abs() < 1e-12), "{found:?}");
}

#[test]
fn the_words_stay_names() {
    let text = "given far = 20\ngiven bevel = 30\nshaft cage\nshaft left { wheel a teeth far }\nshaft right { wheel b teeth bevel }\n\
                shaft p on cage { wheel c teeth 14 }\nmesh bevel_mesh: a - c { bevel }\nmesh n: c - b { bevel far }\ndrive cage at 300 rpm\n\
                drive left at 0 rpm\n";
    let found = values(text, &["far", "bevel", "omega(right)/omega(cage)"].map(str::to_owned));
    assert!(
        found[0] == 20.0 && found[1] == 30.0 && (found[2] - (1.0 + 20.0 / 30.0)).abs() < 1e-12,
        "{found:?}"
    );
    let text = "shaft far { wheel bevel teeth 20 }\nshaft bevels { wheel other teeth 40 }\nmesh k: bevel - other\ndrive far at 10 rad/s\n";
    assert!((values(text, &["omega(bevels)".to_owned()])[0] + 5.0).abs() < 1e-12);
}
