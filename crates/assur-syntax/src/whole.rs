//! Rules for the whole file: it is not empty, the edition is first, there is one title.

use super::document::{Document, Statement};
use assur_text::diagnostic::{Diagnosis, Fix, Problems};
use assur_text::source::Span;

/// The edition that this compiler reads.
const EDITION: &str = "1";

pub(super) fn check(document: &Document, problems: &mut Problems) {
    if document.statements.is_empty() && !problems.has_errors() {
        problems.push(
            Diagnosis::error("mech::syntax::empty_file", "the file is empty")
                .help("begin with a title: mechanism \"My first crank-slider\""),
        );
    }
    let mut title: Option<Span> = None;
    let mut edition: Option<Span> = None;
    for (index, statement) in document.statements.iter().enumerate() {
        let at = statement.span;
        match &statement.node {
            Statement::Title(_) => match title {
                Some(first) => problems.push(
                    Diagnosis::error("mech::syntax::title_twice", "the file has two titles")
                        .primary(at, "a second title")
                        .label(first, "the first one")
                        .help("remove one of them: one file is one problem")
                        .left_out("the second title", at),
                ),
                None => title = Some(at),
            },
            Statement::Edition(number) => {
                if number.node != EDITION {
                    let found = number.node.clone();
                    problems.push(
                        Diagnosis::error(
                            "mech::syntax::unknown_edition",
                            format!("edition {found} of the language does not exist"),
                        )
                        .label(number.span, "only edition 1 exists")
                        .help("write `mech 1`; this is the only edition")
                        .fixes([Fix {
                            title: "write `mech 1`".to_owned(),
                            edits: vec![assur_text::source::Edit::new(number.span, "1")],
                            certain: false,
                        }]),
                    );
                }
                let first = document.statements.first().map_or(at, |s| s.span);
                if let Some(before) = edition {
                    let (other, help) = ("already given here", "remove one of them");
                    problems.push(edition_not_first(at, before, other, help));
                } else if index > 0 {
                    let help = "move it to the first line";
                    let other = "the first statement";
                    problems.push(edition_not_first(at, first, other, help));
                }
                edition = Some(edition.unwrap_or(at));
            }
            _ => {}
        }
    }
}

fn edition_not_first(at: Span, before: Span, other: &'static str, help: &'static str) -> Diagnosis {
    Diagnosis::error("mech::syntax::edition_not_first", "the edition must be the first statement, once")
        .primary(at, "the edition")
        .label(before, other)
        .help(help)
        .fixes(help.starts_with("remove ").then(|| Fix::left_out("this one", at)))
}
