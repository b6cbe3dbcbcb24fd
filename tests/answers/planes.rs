//! Counterweights and rocking couples against the sums over all masses, each by its own acceleration.

use super::masses::{values, within};
use super::quick_rows::random;
use std::fmt::Write;

/// A mass: kg, its place in m, its plane in m.
struct Heavy {
    m: f64,
    at: [f64; 2],
    z: f64,
}

fn heavies(state: &mut u64) -> Vec<Heavy> {
    let count = 1 + (random(state) * 4.0) as usize;
    let one = |state: &mut u64| Heavy {
        m: within(state, 0.2, 5.0),
        at: [within(state, -0.4, 0.4), within(state, -0.4, 0.4)],
        z: if random(state) < 0.3 { 0.0 } else { within(state, -1.0, 1.0) },
    };
    (0..count).map(|_| one(state)).collect()
}

fn members(all: &[Heavy]) -> String {
    let mut text = String::new();
    for (i, h) in all.iter().enumerate() {
        let plane = if h.z == 0.0 { String::new() } else { format!(" plane {} m", h.z) };
        let _ = write!(text, "P{i} ({} m, {} m); mass {} kg at P{i}{plane}; ", h.at[0], h.at[1], h.m);
    }
    text
}

/// The equations Σ m r = 0, with two counterweights also Σ m r z = 0, with what was found; and no other answer but that of the masses.
#[test]
fn counterweights_leave_no_force_and_no_couple() {
    let mut state = 20_261_129;
    for _ in 0..200 {
        let all = heavies(&mut state);
        let hinge = [within(&mut state, -0.1, 0.1), within(&mut state, -0.1, 0.1)];
        let two = random(&mut state) < 0.7;
        let names = if two { vec!["X", "Y"] } else { vec!["X"] };
        let (mut text, mut planes) = (String::new(), Vec::new());
        for (i, name) in names.iter().enumerate() {
            let z = i as f64 * 0.5 + within(&mut state, -0.4, 0.0);
            let given = match random(&mut state) < 0.5 {
                true => format!("radius {} m", within(&mut state, 0.05, 0.5)),
                false => format!("mass {} kg", within(&mut state, 1.0, 9.0)),
            };
            let _ = writeln!(text, "counterweight {name} on rotor {{ {given}; plane {z} m }}");
            planes.push(z);
        }
        let file = format!(
            "ground {{ O (0, 0) }}\nlink rotor {{ O ({} m, {} m); {} }}\n{text}revolute O: ground - rotor\n\
             drive rotor = 0 deg at 7 rad/s accelerating 2 rad/s^2\n",
            hinge[0],
            hinge[1],
            members(&all)
        );
        let mut asked = Vec::new();
        for name in &names {
            asked.extend([
                format!("mass({name})"),
                format!("radius({name})"),
                format!("angle({name})/(1 rad)"),
            ]);
        }
        asked.extend(["shaking_force().x", "shaking_force().y"].map(str::to_owned));
        asked.extend(["x", "y"].map(|axis| format!("rocking_couple(0.2 m).{axis}")));
        asked.extend(["mass(rotor)", "inertia(rotor, O)"].map(str::to_owned));
        let found = values(&file, &asked);
        let mut sums = [0.0; 4];
        let (mut whole, mut about, mut most) = (0.0, 0.0, 1.0);
        let mut add = |m: f64, [x, y]: [f64; 2], z: f64| {
            let of = [m * x, m * y, m * x * z, m * y * z];
            sums.iter_mut().zip(of).for_each(|(sum, x)| *sum += x);
            (whole, about) = (whole + m, about + m * (x * x + y * y));
            most = of.iter().fold(most, |most: f64, x| most.max(x.abs()));
        };
        all.iter().for_each(|h| add(h.m, [h.at[0] - hinge[0], h.at[1] - hinge[1]], h.z));
        for (found, z) in found.chunks(3).zip(&planes) {
            let [m, r, angle] = [found[0], found[1], found[2]];
            add(m, [r * libm::cos(angle), r * libm::sin(angle)], *z);
        }
        let held = if two { 4 } else { 2 };
        for sum in &sums[..held] {
            assert!(sum.abs() < 1e-12 * most, "{sum}\n{file}");
        }
        let rest = &found[3 * names.len()..];
        // about z = 0.2 m, where Σ m r = 0 leaves Σ m r z; a = α k × r − ω² r
        let [x, y] = [sums[2], sums[3]];
        let couple = [2.0 * x - 49.0 * y, 2.0 * y + 49.0 * x];
        let wanted = [0.0, 0.0, couple[0], couple[1], whole, about];
        for (a, b) in rest.iter().zip(wanted) {
            assert!((a - b).abs() < 1e-10 * most.max(b.abs()), "{a} is not {b}\n{file}");
        }
    }
}

/// A slider-crank whose links have masses in planes, against the acceleration of each mass.
#[test]
fn rocking_couples_are_sums_over_the_masses() {
    let mut state = 20_261_130;
    for _ in 0..100 {
        let links = ["crank", "rod", "piston"];
        let all = [heavies(&mut state), heavies(&mut state), heavies(&mut state)];
        let angle = within(&mut state, 0.0, 360.0);
        let text = format!(
            "ground {{ A (0, 0); line guide through A along 0 deg }}\nlink crank A-B 0.1 m {{ {} }}\nlink rod B-C 0.35 m {{ {} }}\n\
             link piston {{ C (0, 0); {} }}\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston\n\
             prismatic D: piston.C - ground.guide\nassemble C ahead of B\ndrive crank = {angle} deg at 9 rad/s accelerating 4 rad/s^2\n",
            members(&all[0]),
            members(&all[1]),
            members(&all[2])
        );
        let from = within(&mut state, -0.5, 0.5);
        let mut asked = vec![format!("rocking_couple({from} m).x"), format!("rocking_couple({from} m).y")];
        for (link, all) in links.iter().zip(&all) {
            for i in 0..all.len() {
                asked.extend(["x", "y"].map(|axis| format!("acceleration({link}.P{i}).{axis}")));
            }
        }
        let found = values(&text, &asked);
        let (mut couple, mut most) = ([0.0, 0.0], 1.0);
        for (h, a) in all.iter().flatten().zip(found[2..].chunks(2)) {
            let moment = h.m * (h.z - from);
            couple = [couple[0] + moment * a[1], couple[1] - moment * a[0]];
            most = f64::max(most, (moment * a[0]).abs().max((moment * a[1]).abs()));
        }
        for (a, b) in found.iter().zip(couple) {
            assert!((a - b).abs() < 1e-11 * most, "{a} is not {b}\n{text}");
        }
    }
}

#[test]
fn words_of_balancing_stay_names() {
    for word in ["plane", "counterweight", "rocking_couple"] {
        let text = format!(
            "given {word} = 0.4 m\nground {{ A (0, 0) }}\nlink {word}1 A-B {word} {{ {word} ({word}/2, 0); mass 2 kg at {word} }}\n\
             link polar A-B 0.4 m {{ {word} 0.3 m at 40 deg; mass 1 kg at {word} }}\n\
             link {word} A-B 0.4 m {{ {word} 0.3 m @ 40 deg; S 0.2 m from A 0.3 m from B left; mass 1 kg at {word} plane 20 mm }}\n\
             revolute A: ground - {word}1 - polar - {word}\ndrive {word}1 = 0 deg\ndrive polar = 0 deg\ndrive {word} = 0 deg\n\
             let x = mass({word})*2\n"
        );
        assert_eq!(values(&text, &["x".to_owned(), "mass()".to_owned()]), [2.0, 4.0], "{word}");
    }
}

/// Rows that change a mass, a radius or a plane.
#[test]
fn rows_of_variants_have_their_own_counterweights() {
    let rows: Vec<(f64, f64)> = (0..30).map(|i| (2.0 + f64::from(i), 0.1 + 0.01 * f64::from(i))).collect();
    let table = rows.iter().fold(String::new(), |text, (m, z)| text + &format!("  {m}, {z}\n"));
    let text = format!(
        "given m_a = 1 kg\ngiven z = 1 m\nvariants {{\n  m_a [kg], z [m]\n{table}}}\nground {{ A (0, 0) }}\n\
         link rotor A-B 0.4 m {{ mass m_a at B plane z }}\ncounterweight X on rotor {{ radius 0.2 m }}\n\
         counterweight Y on rotor {{ radius 0.2 m; plane 1 m }}\nrevolute A: ground - rotor\n\
         drive rotor = 90 deg at 2 rad/s\nfind mass(X), mass(Y)\n"
    );
    let solved = assur::Problem::new("rows.mech", text.as_str()).solve_variants().expect("rows");
    for (row, (m, z)) in solved.iter().zip(rows) {
        let pose = &row.as_ref().expect("a row").poses()[0];
        for (name, wanted) in [("mass(X)", 2.0 * m * (1.0 - z)), ("mass(Y)", 2.0 * m * z)] {
            let found = pose[name].number().expect("a number");
            assert!((found - wanted).abs() < 1e-12 * wanted, "{name} = {found} is not {wanted}");
        }
    }
}
