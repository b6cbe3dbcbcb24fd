//! Solutions that are kept and read, one of every kind: a textbook's six-bar, friction, trains, cams, groups that are solved as a
//! whole, a cylinder, a motion under loads, a course project.

use crate::made::{of_solved, solved};
use assur::internals::worked::text;

#[test]
fn solutions_read_as_they_did() {
    let names = [
        "crank-slider",
        "kinetostatics/six-bar",
        "friction/four-bar",
        "trains/planetary-gearbox",
        "dyads/rpr",
        "determinacy/class-iii-group",
        "loads/torsion-spring",
        "trains/tooth-forces-with-losses",
        "cams/lever",
        "drives/cylinder-lift",
        "simulation/brake",
        "shaper/shaper-a",
    ];
    for name in names {
        let words = std::fs::read_to_string(format!("examples/{name}.mech")).expect("an example");
        let (source, solved) = solved(name, &words).expect("solved");
        let (made, _) = of_solved(&source, &solved).expect("a position");
        insta::with_settings!({ snapshot_path => "snapshots", prepend_module_to_snapshot => false }, {
            insta::assert_snapshot!(name.replace('/', "-"), text(&made.document));
        });
    }
}
