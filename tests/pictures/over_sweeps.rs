//! Pictures of whole sweeps: what they say is what the solution says.

use crate::drawn::{animated, sheets, solved};
use crate::every_example::examples;
use assur::internals::drawing::{Shape, Style};
use assur::internals::math::Vec2;
use assur::internals::picture::Kind;

#[test]
fn animations_ask_for_nothing_and_repeat() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for (name, text) in examples() {
        let Some((source, solved)) = solved(&name, &text) else { continue };
        let Some(page) = animated(&source, &solved) else { continue };
        count += 1;
        if animated(&source, &solved).as_deref() != Some(&page) {
            wrong.push(format!("{name}: two runs give different bytes"));
        }
        if page.replace("http://www.w3.org/2000/svg", "").contains("http") || page.contains(" src=") {
            wrong.push(format!("{name}: the page names an address"));
        }
        if page.contains("NaN") || page.len() > 1_200_000 {
            wrong.push(format!("{name}: {} bytes", page.len()));
        }
        let markup = page.split_once("<body>").and_then(|(_, body)| body.split_once("<script>"));
        let markup = markup.map(|(body, _)| format!("<body>{body}</body>"));
        if let Err(fault) = crate::xml::check(
            &markup.unwrap_or_default().replace(">\n", ">").replace("\"></div>", "\"/></div>"),
        ) {
            wrong.push(format!("{name}: {fault}"));
        }
    }
    assert!(count > 80, "animations are drawn: {count}");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn plots_mark_the_extremes_that_the_file_asks_for() {
    let text = include_str!("../../examples/flywheel/engine.mech");
    let Some((source, solved)) = solved("engine.mech", text) else { panic!("the engine is solved") };
    let work = sheets(&source, &solved, Kind::Work);
    assert_eq!(work.len(), 3, "a picture per flywheel, and a second of that which counts the links");
    // `expect fluctuation(J) = 324.118… J`, `argmax(-work(J)) = 255.77… deg` of the example
    let said = &work[0].drawing.description;
    assert!(said.contains("324.1 J") && said.contains("least at 255.8°"), "{said}");
    let plot = sheets(&source, &solved, Kind::Plot);
    let said = &plot[0].drawing.description;
    assert!(said.contains("c: least 11.25 mm at 90°, greatest 101.2 mm at 270°"), "{said}");
}

#[test]
fn the_tangents_of_wittenbauer_are_those_of_the_answer() {
    let text = include_str!("../../examples/flywheel/engine.mech");
    let Some((source, solved)) = solved("engine.mech", text) else { panic!("the engine is solved") };
    let drawing = &sheets(&source, &solved, Kind::Work)[2].drawing;
    let tangents: Vec<_> = drawing
        .marks
        .iter()
        .filter_map(|mark| match mark.shape {
            Shape::Line(from, to) if mark.style == Style::Velocity => Some((from, to)),
            _ => None,
        })
        .collect();
    let [high, low] = tangents[..] else { panic!("two tangents, not {}", tangents.len()) };
    // μ_J = 2.5e-5 kg·m²/mm, μ_T = 10 J/mm; 2400 rpm; y is down
    let (inertia, energy, speed) = (2.5e-5, 10.0, 80.0 * std::f64::consts::PI);
    for (from, to) in [high, low] {
        let slope = -energy * (to.y - from.y) / (inertia * (to.x - from.x));
        assert!((slope / (0.5 * speed * speed) - 1.0).abs() < 1e-9, "{slope}");
    }
    let apart = energy * (low.0.y - high.0.y);
    assert!((apart / 324.118_356_369_868_4 - 1.0).abs() < 1e-9, "{apart}");
    let below = |(from, to): (Vec2, Vec2), p: Vec2| (to - from).cross(p - from) / (to - from).norm();
    let curve = drawing.marks.iter().filter(|mark| mark.style == Style::Curve1);
    let points = curve.flat_map(|mark| match &mark.shape {
        Shape::Lines { points, .. } => points.clone(),
        _ => Vec::new(),
    });
    let points: Vec<_> = points.collect();
    assert!(points.len() > 100);
    assert!(points.iter().all(|p| below(high, *p) > -1e-6 && below(low, *p) < 1e-6), "it is between them");
    let least = points.iter().map(|p| below(high, *p)).fold(f64::INFINITY, f64::min);
    assert!(least < 0.005, "it is touched: {least}");
    // with the reduced moments of inertia where they touch, (J_r(90.98 deg) + J_r(255.8 deg))/2, instead of their mean
    assert!(
        drawing.description.contains("0.30678 kg·m² instead of 0.30591 kg·m²"),
        "{}",
        drawing.description
    );
}

#[test]
fn polar_diagrams_have_a_light_vector_every_ten_degrees() {
    let text = "mech 1\ngravity 9.81 m/s^2\nground { A (0, 0); line guide through A along 0 deg }\n\
                link crank A-B 100 mm\nlink rod B-C 300 mm { S (100 mm, 0); mass 2 kg at S; inertia 0.02 kg*m^2 }\n\
                link piston { C (0, 0) }\nrevolute A: ground - crank\nrevolute B: crank - rod\nrevolute C: rod - piston\n\
                prismatic D: piston.C - ground.guide\nassemble C ahead of B\n\
                drive crank = 0 deg .. 360 deg in 12 steps at 30 rad/s\nbalance torque M on crank\nfind reaction(B, rod)\n";
    let (source, solved) = solved("slider.mech", text).expect("a solution");
    let sheet = sheets(&source, &solved, Kind::Polar).remove(0);
    let curve: Vec<Vec<Vec2>> = sheet
        .drawing
        .marks
        .iter()
        .filter(|m| m.style == Style::Unknown)
        .filter_map(|m| if let Shape::Lines { points, .. } = &m.shape { Some(points.clone()) } else { None })
        .collect();
    let ends: Vec<Vec2> = sheet
        .drawing
        .marks
        .iter()
        .filter(|m| m.style == Style::Ghost)
        .filter_map(|m| if let Shape::Line(_, end) = m.shape { Some(end) } else { None })
        .collect();
    assert_eq!(ends.len(), 36);
    for end in ends {
        let near = curve.iter().flat_map(|line| line.windows(2)).map(|pair| {
            let (a, b) = (pair[0], pair[1]);
            let share = ((end - a).dot(b - a) / (b - a).dot(b - a)).clamp(0.0, 1.0);
            (a + (b - a) * share - end).norm()
        });
        assert!(near.fold(f64::INFINITY, f64::min) < 0.05, "{end:?} is off the curve");
    }
    let labels: Vec<String> = sheet.placed.iter().map(|p| p.label.text.plain()).collect();
    assert!(labels.contains(&"90°".to_owned()) && !labels.contains(&"100°".to_owned()), "{labels:?}");
}

#[test]
fn an_animation_shows_the_paths_of_points_that_are_asked_for() {
    let linkage = "mech 1\nground { A (0, 0); D (100 mm, 0) }\nlink crank A-B 30 mm\nlink coupler B-C 100 mm { P (50 mm, 30 mm) }\n\
         link rocker D-C 60 mm\nrevolute A: ground - crank\nrevolute B: crank - coupler\nrevolute C: coupler - rocker\n\
         revolute D: ground - rocker\nassemble C left of B-D\ndrive crank = 0 deg .. 360 deg in 12 steps at 60 rpm\n";
    for (find, has_path) in
        [("find velocity(P)", true), ("find angle(rocker), position(P)", true), ("find angle(rocker)", false)]
    {
        let (source, solved) = solved("paths.mech", &format!("{linkage}{find}\n")).expect("a solution");
        let page = animated(&source, &solved).expect("it moves");
        assert_eq!(page.contains("<g class=\"path\" data-name=\"coupler.P\">"), has_path, "{find}");
    }
}
