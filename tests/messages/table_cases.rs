//! Mistakes in tables of variants and in values from outside.

use crate::case::{errors, folder};
use crate::paste::words;
use assur::internals::check::Overrides;
use assur::internals::exercise::table::{Lines, Table, TableError};
use assur::internals::source::Source;

/// The message and help of a table beside the crank-slider.
fn table_says(name: &str, text: &[u8]) -> (String, Option<String>) {
    let said = |error: &TableError| {
        use miette::Diagnostic;
        (error.to_string(), error.help().map(|h| h.to_string()))
    };
    let mut table = match Table::open(name, text).expect("it is read") {
        Ok(table) => table,
        Err((_, error)) => return said(&error),
    };
    let document = assur::internals::syntax::parse(&Source::new("text.mech", SLIDER)).0;
    let (columns, problems) = assur::internals::check::columns(&document, &Overrides::none(), &table.columns);
    let Some(columns) = columns else {
        let found = errors(&problems, &table.header);
        assert_eq!(found.len(), 1, "{name}: {found:#?}");
        return (found[0].message.clone(), found[0].help.clone());
    };
    let (columns, mut lines) = (columns.into(), Lines::default());
    table.lines(10, &mut lines).expect("it is read");
    let row = lines.get(0).map(|line| line.read(name, &columns, table.separator).map(|_| ()));
    match (row, table.without_rows()) {
        (Some(Err((_, error))), _) | (_, Some((_, error))) => said(&error),
        _ => ("it is right".to_owned(), None),
    }
}

const SLIDER: &str = "given r = 80 mm\ngiven l = 300 mm\ngiven n = 500 rpm\ngiven phi = 10 deg\ngiven P = 100 N\nfind r, l, n, phi, P\n";

#[test]
fn tables() {
    for (name, wanted) in [
        ("badunit", &["`milli` is not a unit", "write `mm`"][..]),
        ("deccomma", &["6 cells", "a decimal point, as in `80.5`"]),
        ("cell_too_many", &["6 cells", "leave `7` out, or name a column for it"]),
        ("other_separator", &["semicolons, but those of the rows by commas", "write: r [mm],l [mm],n [rpm]"]),
        ("noheader", &["the first line must name the columns"]),
        ("paren", &["in parentheses", "write: r [mm],l [mm],n [rpm],phi [deg],P [N]"]),
        ("thousands", &["`1,500`", "write `1.500` or `1500`"]),
    ] {
        let text = std::fs::read(folder().join(format!("messages/{name}.csv"))).expect("a table");
        let (message, help) = table_says(name, &text);
        let help = help.unwrap_or_default();
        for word in wanted {
            assert!(message.contains(word) || help.contains(word), "{name}: {message}; {help}");
        }
        if let Some(header) = help.strip_prefix("write: ") {
            let rows = String::from_utf8(text).expect("a text");
            let pasted = format!("{header}\n{}", rows.split_once('\n').expect("rows").1);
            assert_eq!(table_says(name, pasted.as_bytes()).0, "it is right");
        }
    }
    let (message, _) = table_says("header only", b"r [mm],l [mm]\n");
    assert_eq!(message, "the table has no rows");
}

#[test]
fn values_from_outside() {
    for (name, value, wanted) in [
        ("r", "0,12m", "write `--set r=0.12m`"),
        ("r", "1,200mm", "write `--set r=1.200mm` or `--set r=1200mm`"),
        ("r", "120", "write `--set r=120mm`"),
        ("n", "1500", "write `--set n=1500rpm`"),
        ("n", "1500 1/min", "write `--set n=1500rpm` or `--set n=25rad/s`"),
        ("P", "5 kNN", "write `--set P=5kN`"),
    ] {
        let source = Source::new("text.mech", SLIDER);
        let set = |value: &str| {
            let overrides = Overrides::set(vec![(name.to_owned(), value.to_owned())]);
            errors(&assur::internals::check_source(&source, &overrides).1, &source)
        };
        let found = set(value);
        assert_eq!(found.len(), 1, "{name}={value}: {found:#?}");
        let help = found[0].help.as_deref().unwrap_or_default();
        assert_eq!(help, wanted, "{name}={value}");
        for line in words(help).expect("lines") {
            let value = line.split_once('=').expect("a value").1;
            assert!(set(value).is_empty(), "{line}");
        }
    }
}
