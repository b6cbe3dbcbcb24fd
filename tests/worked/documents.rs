//! Pages as documents: well-formed, without scripts and requests, headings without gaps; the same in every language.

use crate::examples::{Example, examples};
use crate::made::solved;
use crate::xml;
use assur::internals::Solved;
use assur::internals::picture::Scene;
use assur::internals::source::Source;
use assur::internals::worked::{Language, html, markdown, text, typst, worked};

/// The page of an example.
fn page((source, solved): &(Source, Solved), language: Language) -> Option<String> {
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).ok()?;
    Some(html(&worked(scene, language, &[]).document))
}

#[test]
fn pages_are_well_formed_and_ask_for_nothing() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for Example { name, solved, .. } in examples() {
        let Some(page) = solved.as_ref().and_then(|solved| page(solved, Language::English)) else { continue };
        count += 1;
        let body = page.trim_start_matches("<!doctype html>\n");
        if let Err(fault) = xml::check(body) {
            wrong.push(format!("{name}: {fault}"));
        }
        for forbidden in ["<script", "src=", "url(", "@import"] {
            if page.contains(forbidden) {
                wrong.push(format!("{name}: {forbidden}"));
            }
        }
        let rest = page.replace("http://www.w3.org/2000/svg", "");
        if rest.contains("http://") || rest.contains("https://") {
            wrong.push(format!("{name}: an address"));
        }
        let mut level = 1;
        for (at, _) in page.match_indices("<h") {
            let next = page[at + 2..].bytes().next().unwrap_or(0);
            if !next.is_ascii_digit() {
                continue;
            }
            let own = usize::from(next - b'0');
            if own > level + 1 {
                wrong.push(format!("{name}: a heading of level {own} after one of {level}"));
            }
            level = own;
        }
        if page.matches("<h1").count() != 1 {
            wrong.push(format!("{name}: headings of the first level"));
        }
    }
    assert!(count > 190, "{count}");
    assert!(wrong.is_empty(), "{} of {count}: {:#?}", wrong.len(), &wrong[..wrong.len().min(30)]);
}

/// The numbers of a diagram, and the least letters that are read in print, mm.
const NUMBERS: f64 = 3.0;
const LEAST: f64 = 7.0 * 25.4 / 72.0;
/// What paper has between its margins, and what the page gives to the height of a diagram, mm.
const PAPER: [f64; 2] = [182.0, 150.0];

#[test]
fn numbers_of_plots_are_read_in_print() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    for Example { name, solved, .. } in examples() {
        let Some(page) = solved.as_ref().and_then(|solved| page(solved, Language::English)) else { continue };
        assert!(page.contains(&format!(".free svg{{max-height:{}mm}}", PAPER[1])), "the rule of the page");
        for figure in page.split(" class=\"free\">").skip(1) {
            let side = |name: &str| {
                let (_, rest) = figure.split_once(&format!(" {name}=\""))?;
                rest.split_once("mm\"")?.0.parse::<f64>().ok()
            };
            let (wide, tall) = (side("width").expect("a width"), side("height").expect("a height"));
            count += 1;
            if NUMBERS * (PAPER[0] / wide).min(PAPER[1] / tall) < LEAST {
                wrong.push(format!("{name}: {wide} × {tall} mm"));
            }
        }
    }
    assert!(count > 50, "{count} diagrams");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn a_solution_has_the_letters_and_signs_of_its_language() {
    let words = std::fs::read_to_string("examples/kinetostatics/six-bar.mech").expect("the example");
    let six_bar = solved("six-bar", &words).expect("solved");
    let russian = page(&six_bar, Language::Russian).expect("a page");
    assert!(russian.contains("lang=\"ru\"") && russian.contains("<mn>0,28489</mn>"), "{russian}");
    assert!(!russian.contains("<mn>0.28489</mn>"));
    let chinese = page(&six_bar, Language::Chinese).expect("a page");
    assert!(chinese.contains("速度分析") && chinese.contains("<mn>0.28489</mn>"));
}

#[test]
fn all_formats_have_the_same_equations() {
    let words = std::fs::read_to_string("examples/crank-slider.mech").expect("the example");
    let (source, solved) = solved("crank-slider", &words).expect("solved");
    let file = (source.name.as_str(), source.text.as_str());
    let scene = Scene::of(solved.compiled.model(), &solved.solution, file, None).expect("a position");
    let document = worked(scene, Language::English, &[]).document;
    let (marked, pictures) = markdown(&document, "x");
    let (typeset, same) = typst(&document, "x");
    assert_eq!(pictures.len(), same.len());
    assert!(pictures.len() >= 7, "{}", pictures.len());
    for text in [&text(&document), &marked, &typeset, &html(&document)] {
        for number in ["32.403", "4873.3", "3079.5", "472.06"] {
            assert!(text.contains(number), "{number} is missing");
        }
    }
    let page = html(&document);
    assert!(page.len() < 250_000, "{}", page.len());
    assert_eq!(page, html(&worked(scene, Language::English, &[]).document));
}
