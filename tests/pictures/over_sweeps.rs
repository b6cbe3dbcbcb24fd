//! Pictures of whole sweeps: what they say is what the solution says.

use crate::drawn::{animated, sheets, solved};
use crate::every_example::examples;
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
    assert_eq!(work.len(), 2, "a picture per flywheel");
    // `expect fluctuation(J) = 324.118… J`, `argmax(-work(J)) = 255.77… deg` of the example
    let said = &work[0].drawing.description;
    assert!(said.contains("324.1 J") && said.contains("least at 255.8°"), "{said}");
    let plot = sheets(&source, &solved, Kind::Plot);
    let said = &plot[0].drawing.description;
    assert!(said.contains("c: least 11.25 mm at 90°, greatest 101.2 mm at 270°"), "{said}");
}
