//! Plots of motions under loads: curves over time, events, extremes between the printed instants.

use crate::drawn::{animated, sheets, solved};
use crate::frames::motion;
use assur::internals::drawing::Theme;
use assur::internals::picture::Kind;

#[test]
fn plots_over_time_show_events_and_extremes() {
    let text = include_str!("../../examples/simulation/pendulum.mech");
    let Some((source, solved)) = solved("pendulum.mech", text) else { panic!("the pendulum swings") };
    let plot = sheets(&source, &solved, Kind::Plot);
    let said = &plot[0].drawing.description;
    // √(2g/l) = 4.4294 rad/s at the lowest place, a quarter and three quarters of the period 2.36784 s
    for part in [
        "omega(bar): least −4.429 rad/s at 0.592 s, greatest 4.429 rad/s at 1.776 s",
        "rest at 1.184 s, 2.368 s, 3.552 s, 4.736 s",
        "lowest at 0.592 s, 2.96 s",
        "energy(): 0 J everywhere",
        "position(P).x: least −1 m at 1.184 s, greatest 1 m at 0 s",
    ] {
        assert!(said.contains(part), "{part}: {said}");
    }
    let svg = plot[0].svg(Theme::Auto);
    assert!(svg.contains("rest, back") && svg.contains("over time"), "{svg}");
}

/// t = 4 s ln(1 + 50/12): the steps before, at which the angle is the same to five digits, are not taken for it.
#[test]
fn an_extreme_stands_where_the_curve_turns_not_where_a_step_ends() {
    let text = include_str!("../../examples/simulation/brake.mech");
    let Some((source, solved)) = solved("brake.mech", text) else { panic!("the rotor stops") };
    let plot = sheets(&source, &solved, Kind::Plot);
    let said = &plot[0].drawing.description;
    assert!(said.contains("greatest 38.57 rev at 6.569 s"), "{said}");
}

/// An answer between the file's two instants.
#[test]
fn a_motion_with_two_instants_has_smooth_curves() {
    let text = "mech 1\ngravity 9.81 m/s^2\nground { A (0, 0) }\nlink bar A-P 1 m { mass 1 kg at P; inertia 0 kg*m^2 }\n\
                revolute A: ground - bar\nstart bar = 0 deg\nsimulate 1 s\nfind omega(bar)\n";
    let Some((source, solved)) = solved("bar.mech", text) else { panic!("it falls") };
    let plot = sheets(&source, &solved, Kind::Plot);
    let said = &plot[0].drawing.description;
    assert!(said.contains("least −4.429 rad/s at 0.592 s, greatest 0 rad/s at 0 s"), "{said}");
    let page = animated(&source, &solved).unwrap_or_default();
    // the cursor of the page goes along the plot
    assert!(
        page.contains("class=\"motion-cursor\"") && motion(&page)["along"].is_string(),
        "the page has a plot"
    );
}

/// A ball hits the ground 36 times: four times with the name, once with the number of the other hits.
#[test]
fn events_that_come_many_times_are_named_together() {
    let text = include_str!("../../examples/simulation/bouncing.mech");
    let Some((source, solved)) = solved("bouncing.mech", text) else { panic!("the ball bounces") };
    let plot = sheets(&source, &solved, Kind::Plot);
    let labels: Vec<String> = plot[0].placed.iter().map(|placed| placed.label.text.plain()).collect();
    let hits = |label: &&String| label.split(", ").any(|name| name.starts_with("hit"));
    let named: Vec<&String> = labels.iter().filter(hits).collect();
    assert!(named.len() <= 5 && named.iter().all(|label| label.len() < 24), "{named:?}");
    assert!(named.iter().any(|label| label.contains("hit ×32")), "{named:?}");
}
