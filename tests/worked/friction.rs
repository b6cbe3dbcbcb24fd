//! The iteration of friction as it is shown ends with the friction of the solver; friction at a place without a name; both pulls of a rope.

use crate::examples::{Example, examples};
use crate::made::{Tally, of_solved, solved};
use assur::internals::plan::ForceStep;

#[test]
fn the_last_step_has_the_friction_of_the_solver() {
    let (mut groups, mut searched, mut wrong) = (0, 0, Vec::new());
    for Example { name, solved, .. } in examples() {
        let Some((_, solved)) = solved else { continue };
        let plan = solved.compiled.model().plan;
        for pose in solved.solution.poses.iter().filter_map(|p| p.outcome.as_ref().ok()) {
            for (index, step) in plan.forces.iter().enumerate() {
                let ForceStep::Friction { group, .. } = step else { continue };
                let steps = pose.state.friction_steps(plan, index);
                let Some(last) = steps.last().filter(|_| !pose.state.forces.locked) else { continue };
                groups += 1;
                let same = group.elements.iter().zip(last).all(|(&element, presses)| {
                    let own = plan.friction[element].kind.factor() * presses;
                    let found = pose.state.forces.frictions[element].abs();
                    pose.state.forces.senses[element] == 0.0 || (own - found).abs() <= 1e-9 * own.max(found)
                });
                if !same && steps.len() < 20 {
                    wrong.push(format!("{name}: {steps:?}"));
                }
                searched += usize::from(!same);
            }
        }
    }
    println!("{groups} groups, {searched} searched");
    assert!(wrong.is_empty() && groups > 60, "{groups} groups, {wrong:#?}");
}

/// A rod that slides on a point of the ground at the origin of its own frame, which has no name: at rest and moving.
#[test]
fn friction_at_the_origin_of_a_link_is_derived() {
    for speeds in [None, Some((2.0, 0.3, -0.2)), Some((-1.0, -0.2, 0.1))] {
        let (turn, move_at) = speeds.map_or((String::new(), String::new()), |(omega, v, w)| {
            (format!(" at {omega} rad/s"), format!(" at ({v} m/s, {w} m/s)"))
        });
        let text = format!(
            "mech 1\ngravity 9.81 m/s^2\nground {{ E (0, 0) }}\n\
             link rod {{ A (0.1 m, 0); line axis through A along 0 deg; mass 1 kg at A; inertia 1 kg*m^2 }}\n\
             contact K: rod.axis - ground.E {{ friction 0.4 }}\nstart rod = 180 deg{turn}\n\
             start rod.A = (-0.1 m, 0){move_at}\nsimulate 0.05 s\nfind angle(rod) as deg\nfind reactions\n"
        );
        let (source, solved) = solved("origin", &text).unwrap_or_else(|| panic!("{text}"));
        let (made, condition) = of_solved(&source, &solved).unwrap_or_else(|| panic!("{text}"));
        let mut tally = Tally::default();
        tally.judge("origin", &made, condition);
        // what is left of the energy has fewer digits than are printed
        assert!(tally.approximate <= 1, "{}", tally.approximate);
        tally.approximate = 0;
        tally.finish();
        let law = assur::internals::worked::text(&made.document).contains("f_K |R_ground,K| = ");
        assert!(law == speeds.is_some() && tally.reactions[0] > 0, "{text}");
    }
}

/// The pulls at both ends of a rope with losses are derived, each with its own letters.
#[test]
fn a_rope_with_losses_shows_both_pulls() {
    for (speed, driven) in [(3.0, "w"), (-3.0, "P")] {
        let text = format!(
            "mech 1\nshaft drum {{ wheel w radius 0.2 m }}\nslider P\nrope r: P - w {{ efficiency 0.8 }}\n\
             force W on P = 100 N\ndrive drum at {speed} rad/s\nfind tension(r, P), tension(r, w), tension(r)\n"
        );
        let (source, solved) = solved("rope", &text).unwrap_or_else(|| panic!("{text}"));
        let (made, condition) = of_solved(&source, &solved).unwrap_or_else(|| panic!("{text}"));
        let mut tally = Tally::default();
        tally.judge("rope", &made, condition);
        tally.finish();
        let page = assur::internals::worked::text(&made.document);
        assert!(page.contains(&format!("F_r,{driven} = η_r F_r = ")), "{page}");
    }
}
