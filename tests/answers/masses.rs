//! Several masses on a link: as one mass with their sums, and as bodies of their own.

use super::quick_rows::random;
use std::fmt::Write;

/// One mass: in kg, its place in m, its inertia in kg m².
struct Part {
    m: f64,
    at: [f64; 2],
    j: f64,
}

/// A number between two others, the same at every run.
pub fn within(state: &mut u64, least: f64, most: f64) -> f64 {
    least + (most - least) * random(state)
}

fn parts(state: &mut u64) -> Vec<Part> {
    let count = 2 + (random(state) * 4.0) as usize;
    let part = |state: &mut u64| Part {
        m: within(state, 0.2, 5.0),
        at: [within(state, -0.4, 0.8), within(state, -0.4, 0.4)],
        j: if random(state) < 0.5 { 0.0 } else { within(state, 0.001, 0.3) },
    };
    (0..count).map(|_| part(state)).collect()
}

/// The members of a link: points first, the masses as they are; some as weights.
fn several(parts: &[Part], link: &str) -> String {
    let mut text = String::new();
    for (i, p) in parts.iter().enumerate() {
        let _ = write!(text, "{link}{i} ({} m, {} m); ", p.at[0], p.at[1]);
        match i % 3 {
            1 => _ = write!(text, "weight {} N at {link}{i}", p.m * 9.81),
            _ => _ = write!(text, "mass {} kg at {link}{i}", p.m),
        }
        if p.j > 0.0 {
            let _ = write!(text, " inertia {} kg*m^2", p.j);
        }
        text += "; ";
    }
    text
}

/// Mass, mass centre, moment of inertia about it.
fn sums(parts: &[Part]) -> (f64, [f64; 2], f64) {
    let m: f64 = parts.iter().map(|p| p.m).sum();
    let [x, y] = [0, 1].map(|k| parts.iter().map(|p| p.m * p.at[k]).sum::<f64>() / m);
    let j = parts.iter().map(|p| p.j + p.m * ((p.at[0] - x).powi(2) + (p.at[1] - y).powi(2))).sum();
    (m, [x, y], j)
}

fn one(parts: &[Part], link: &str) -> String {
    let (m, [x, y], j) = sums(parts);
    let points: String = (parts.iter().enumerate())
        .map(|(i, p)| format!("{link}{i} ({} m, {} m); ", p.at[0], p.at[1]))
        .collect();
    format!("{points}{link}S ({x} m, {y} m); mass {m} kg at {link}S; inertia {j} kg*m^2; ")
}

const LINKS: [&str; 3] = ["crank", "rod", "rocker"];

/// A four-bar with masses on its links that can turn fully.
fn four_bar(state: &mut u64) -> (String, String, Vec<Vec<Part>>) {
    let crank = within(state, 0.1, 0.2);
    let lengths = [crank, within(state, 0.4, 0.6), within(state, 0.4, 0.6)];
    let all: Vec<Vec<Part>> = LINKS.iter().map(|_| parts(state)).collect();
    let mut texts = [String::new(), String::new()];
    for (k, text) in texts.iter_mut().enumerate() {
        let member = |i: usize| if k == 0 { several(&all[i], LINKS[i]) } else { one(&all[i], LINKS[i]) };
        let _ = write!(
            text,
            "gravity 9.81 m/s^2\nground {{ A (0, 0); D (0.5 m, 0) }}\nlink crank A-B {} m {{ {} }}\nlink rod B-C {} m \
             {{ {} }}\nlink rocker D-C {} m {{ {} }}\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: \
             rod - rocker\nrevolute D: ground - rocker\nassemble C left of B-D\n",
            lengths[0],
            member(0),
            lengths[1],
            member(1),
            lengths[2],
            member(2)
        );
    }
    let [text, summed] = texts;
    let angle = within(state, 0.0, 360.0);
    let drive =
        format!("drive crank = {angle} deg at 7 rad/s accelerating 3 rad/s^2\nbalance torque M on crank\n");
    (text + &drive, summed + &drive, all)
}

/// The values of questions at the first position.
pub fn values(text: &str, names: &[String]) -> Vec<f64> {
    let asked = format!("{text}find {}\n", names.join(", "));
    let solution = assur::solve(&asked).unwrap_or_else(|e| panic!("{e}\n{asked}"));
    let pose = &solution.poses()[0];
    names.iter().map(|name| pose[name.as_str()].number().expect("a number")).collect()
}

#[track_caller]
fn near(found: f64, wanted: f64, scale: f64, text: &str) {
    assert!((found - wanted).abs() <= 1e-10 * scale.max(1.0), "{found} is not {wanted}\n{text}");
}

#[test]
fn several_masses_are_one_with_their_sums_and_bodies_of_their_own() {
    let mut state = 20_261_127;
    for _ in 0..500 {
        let (text, summed, all) = four_bar(&mut state);
        let mut names: Vec<String> = Vec::new();
        for pair in ["A, crank", "B, rod", "C, rod", "D, rocker"] {
            names.extend(["x", "y"].map(|axis| format!("reaction({pair}).{axis}")));
        }
        names.push("M".into());
        for link in LINKS {
            names.extend([
                format!("mass({link})"),
                format!("inertia({link})"),
                format!("inertia_torque({link})"),
            ]);
            names.extend(["x", "y"].map(|axis| format!("acceleration(mass_centre({link})).{axis}")));
            names.push(format!("inertia({link}, {link}0)"));
        }
        names.extend(["x", "y"].map(|axis| format!("mass_centre().{axis}")));
        names.extend(["x", "y"].map(|axis| format!("velocity(mass_centre()).{axis}")));
        let (found, wanted) = (values(&text, &names), values(&summed, &names));
        let scale = wanted.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
        for ((name, x), y) in names.iter().zip(&found).zip(&wanted) {
            near(*x, *y, scale, &format!("{name}\n{text}"));
        }
        // virtual power with each part as a body: M ω + Σ (m_i (g − a_i)·v_i − J_i α ω) = 0
        let mut asked = vec!["M".to_owned()];
        for (link, parts) in LINKS.iter().zip(&all) {
            asked.extend([format!("omega({link})"), format!("alpha({link})")]);
            for i in 0..parts.len() {
                for function in ["velocity", "acceleration"] {
                    asked.extend(["x", "y"].map(|axis| format!("{function}({link}.{link}{i}).{axis}")));
                }
            }
        }
        let mut known = values(&text, &asked).into_iter();
        let mut next = || known.next().expect("as many as asked");
        let (moment, mut power, mut most) = (next(), 0.0, 0.0);
        for parts in &all {
            let (omega, alpha) = (next(), next());
            for p in parts {
                let [vx, vy, ax, ay] = [next(), next(), next(), next()];
                let own = p.m * (-ax * vx - (ay + 9.81) * vy) - p.j * alpha * omega;
                (power, most) = (power + own, f64::max(most, own.abs()));
            }
        }
        near(moment * 7.0, -power, most, &text);
    }
}

#[test]
fn the_inertia_of_the_whole_link_is_about_the_point_named() {
    let text = "ground { A (0, 0) }\nlink arm A-B 0.8 m { S (0.4 m, 0); mass 3 kg at S; mass 5 kg at B; inertia 4 kg*m^2 \
                about A }\nrevolute A: ground - arm\ndrive arm = 20 deg at 2 rad/s\n";
    let names = ["inertia(arm, A)", "inertia(arm)", "mass()"].map(str::to_owned);
    let found = values(text, &names);
    near(found[0], 4.0, 1.0, text);
    near(found[1], 4.0 - 5.2_f64.powi(2) / 8.0, 1.0, text);
    near(found[2], 8.0, 1.0, text);
}

#[test]
fn an_inertia_stands_with_one_mass_as_on_a_line_of_its_own() {
    let file = |members: &str| {
        format!(
            "ground {{ A (0, 0) }}\nlink arm A-B 0.8 m {{ S (0.4 m, 0); {members} }}\nrevolute A: ground - arm\ndrive arm \
             = 20 deg at 2 rad/s accelerating 1 rad/s^2\n"
        )
    };
    let names = ["inertia(arm)", "inertia_torque(arm)"].map(str::to_owned);
    let one = values(&file("mass 3 kg at S inertia 0.16 kg*m^2"), &names);
    assert_eq!(one, values(&file("mass 3 kg at S; inertia 0.16 kg*m^2"), &names));
}

#[test]
fn names_of_the_functions_stay_names() {
    for word in ["mass", "mass_centre", "inertia"] {
        let text = format!(
            "given {word} = 3 kg\nground {{ A (0, 0) }}\nlink arm A-B 0.8 m {{ P (0.4 m, 0); mass {word} at P }}\nrevolute A: ground - arm\ndrive arm = 0 deg at 2 rad/s\n"
        );
        let asked = ["mass(arm)".to_owned(), word.to_owned(), "mass_centre(arm).x".to_owned()];
        let found = values(&text, &asked);
        assert_eq!(found, [3.0, 3.0, 0.4], "{word}");
        let curve = format!(
            "curve {word} {{\n  t [m], p [N]\n  0, 0\n  1, 10\n}}\nground {{ A (0, 0) }}\nlink arm A-B 0.8 m\nrevolute A: ground \
             - arm\ndrive arm = 0 deg\nlet x = {word}(0.5 m)\nfind y = {word}(position(arm.B).x), x\n"
        );
        let solution = assur::solve(&curve).unwrap_or_else(|e| panic!("{e}"));
        let value = |name: &str| solution.poses()[0][name].number();
        assert!((value("y").expect("a value") - 8.0).abs() < 1e-9, "{word}");
    }
}

/// Masses, places and loads that go with a row: mass 1 at the end of an arm, mass 2 in its middle.
#[test]
fn rows_of_variants_have_their_own_masses() {
    let rows = (0..60).map(|i| {
        let x = f64::from(i);
        (0.2 + 0.1 * x, 3.0 - 0.04 * x, 0.5 + 0.02 * x)
    });
    let rows = rows.collect::<Vec<_>>();
    let table = rows.iter().fold(String::new(), |text, (a, b, l)| text + &format!("  {a}, {b}, {l}\n"));
    let text = format!(
        "given a = 1 kg\ngiven b = 1 kg\ngiven l = 1 m\nvariants {{\n  a [kg], b [kg], l [m]\n{table}}}\nground {{ A (0, 0) }}\n\
         link arm A-B l {{ S (l/2, 0); mass a at B; mass b at S inertia 0.1 kg*m^2 }}\nrevolute A: ground - arm\n\
         drive arm = 90 deg at 2 rad/s\nlet q = mass(arm)*3\nforce F on arm at B = mass(arm)*(2 m/s^2) @ 0 deg\n\
         balance torque M on arm\nfind q, inertia(arm, A), mass_centre(arm).y, M\n"
    );
    let problem = assur::Problem::new("rows.mech", text.as_str());
    let solved = problem.solve_variants().expect("rows");
    assert_eq!(solved.len(), rows.len());
    for (row, (a, b, l)) in solved.iter().zip(rows) {
        let pose = &row.as_ref().expect("a row").poses()[0];
        let value = |name: &str| pose[name].number().expect("a number");
        let mass = a + b;
        near(value("q"), 3.0 * mass, 1.0, &text);
        near(value("inertia(arm, A)"), a * l * l + b * l * l / 4.0 + 0.1, 1.0, &text);
        near(value("mass_centre(arm).y"), (a * l + b * l / 2.0) / mass, 1.0, &text);
        near(value("M"), 2.0 * mass * l, 1.0, &text);
    }
}

#[test]
fn plane_is_a_member_or_the_name_of_a_point() {
    let text = "let v = (0.1 m, 0.2 m)\nlet w = 2*v + (0, 0.1 m)\ngiven d = 0.1 m\nground { A (0, 0); plane v }\nlink bar A-B 0.5 m { plane w; \
                mass 2 kg at B }\nlink arm A-D 0.5 m { plane d; mass 2 kg at D }\nrevolute A: ground - bar - arm\ndrive bar = 0 \
                deg\ndrive arm = 0 deg\nfind position(bar.plane).y, position(ground.plane).x\n";
    let solution = assur::solve(text).expect("both read");
    let pose = &solution.poses()[0];
    assert_eq!(pose["position(bar.plane).y"].si(), assur::Quantity::Number(0.5));
    assert_eq!(pose["position(ground.plane).x"].si(), assur::Quantity::Number(0.1));
}

#[test]
fn words_behind_a_number_are_no_units() {
    let text = "given m0 = 6 kg\ngiven J = 0.5 kg*m^2\nground { A (0, 0) }\nlink bar A-B 1 m { P (0.2 m, 0); mass m0/2 rod A to B; mass 2*m0/3 ring \
                centre P radius 0.1 m; mass m0/2 at P inertia J/2 }\nrevolute A: ground - bar\nlink disk { A (0, 0); mass 5 kg at A; \
                inertia 5 kg*(200 mm)^2/2 about A }\nrevolute O: ground.A - disk.A\ndrive bar = 0 deg\ndrive disk = 0 deg\n";
    let found = values(text, &["mass(bar)", "inertia(bar, A)", "inertia(disk)"].map(str::to_owned));
    let wanted = [10.0, 1.0 + 4.0 * (0.01 + 0.04) + 3.0 * 0.04 + 0.25, 0.1];
    assert!(found.iter().zip(wanted).all(|(a, b)| (a - b).abs() < 1e-14), "{found:?}");
}
