//! The language server: changes that it offers at a place.

use crate::lsp::{URI, applied, range};
use crate::lsp_answers::{ENGINE, ask, changed, solved};
use serde_json::json;

/// The titles of what is offered at a place.
fn titles(text: &str, line: u32, character: u32) -> Vec<String> {
    let (mut server, _) = solved(text);
    let here = range((line, character), (line, character));
    let actions = ask(&mut server, "codeAction", &json!({ "range": here, "context": { "diagnostics": [] } }));
    let all = actions.as_array().expect("actions").iter();
    all.map(|action| action["title"].as_str().expect("a title").to_owned()).collect()
}

#[test]
fn a_missing_point_is_declared_in_its_link() {
    let asked = |path: &str| ENGINE.replace("find Mb", &format!("find position({path}), Mb"));
    let in_braces = changed(&asked("rod.E"), 16, 19, "declare `E");
    assert!(in_braces.contains("kg*m^2; E (50 mm, 50 mm) }\n"), "{in_braces}");
    let of_bar = changed(&asked("crank.E"), 16, 21, "declare `E");
    assert!(of_bar.contains("link crank A-B r { E (50 mm, 50 mm) }\n"), "{of_bar}");
    let on_ground = changed(&asked("ground.E"), 16, 22, "declare `E (50 mm, 50 mm)` on the ground");
    assert!(on_ground.contains("along 0 deg; E (50 mm, 50 mm) }\n"), "{on_ground}");
    let lines = asked("piston.E")
        .replace("{ C (0, 0); mass 2.14 kg at C }", "{\n  C (0, 0); mass 2.14 kg at C  // all\n}");
    let in_lines = changed(&lines, 18, 22, "declare `E");
    assert!(in_lines.contains("  // all\n  E (50 mm, 50 mm)\n}\n"), "{in_lines}");
    for text in [in_braces, of_bar, on_ground, in_lines] {
        let (_, said) = solved(&text.replace("expect Mb = 400 N*m\n", ""));
        assert_eq!(said[0]["params"]["diagnostics"], json!([]), "{text}");
    }
    // a name alone may be of any link
    let all = titles(&asked("E"), 16, 14);
    let declared = all.iter().filter(|title| title.starts_with("declare `E")).collect::<Vec<_>>();
    assert_eq!(declared.len(), 3, "{all:?}");
    // the pair needs it
    let without = ENGINE.replace("link rod B-C l", "link rod A-C l");
    let joined = changed(&without, 10, 9, "declare `B");
    assert!(joined.contains("kg*m^2; B (50 mm, 50 mm) }\n"), "{joined}");
}

#[test]
fn the_same_is_written_in_other_words() {
    let written = changed(ENGINE, 10, 3, "write the points of `B`");
    assert!(written.contains("revolute B: crank.B - rod.B\n"), "{written}");
    assert!(titles(&written, 10, 3).iter().all(|title| !title.starts_with("write the points")));
    let lengths = titles(ENGINE, 2, 11);
    assert!(
        lengths.contains(&"write `0.1 m`".to_owned()) && lengths.contains(&"write `10 cm`".to_owned()),
        "{lengths:?}"
    );
    assert!(changed(ENGINE, 13, 15, "write `0.785").contains("drive crank = 0.7853981633974483 rad at n\n"));
    let speeds = titles(ENGINE, 3, 12);
    assert!(speeds.iter().any(|title| title.starts_with("write `157.0796326794897 rad/s")), "{speeds:?}");
}

#[test]
fn an_assembly_is_chosen_by_a_fix() {
    let open = ENGINE.replace("assemble C ahead of B\n", "");
    let chosen = changed(&open, 11, 9, "add `assemble C ahead of B`");
    let (_, said) = solved(&chosen.replace("expect Mb = 400 N*m\n", ""));
    assert_eq!(said[0]["params"]["diagnostics"], json!([]), "{chosen}");
    let wrong = ENGINE.replace("assemble C ahead of B", "assemble B > 400 deg");
    let all = titles(&wrong, 14, 12);
    assert!(all.iter().any(|title| title.starts_with("write `assemble ")), "{all:?}");
}

#[test]
fn every_change_is_of_the_open_text() {
    let (mut server, _) = solved(ENGINE);
    let all = ask(
        &mut server,
        "codeAction",
        &json!({ "range": range((0, 0), (18, 0)), "context": { "diagnostics": [] } }),
    );
    for action in all.as_array().expect("actions").iter().filter(|action| action["edit"].is_object()) {
        let after = applied(ENGINE, &action["edit"]["changes"][URI]);
        assert_ne!(after, ENGINE, "{action}");
    }
}
