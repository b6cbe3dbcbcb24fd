//! The rules of the style, one snapshot each: a text, and what becomes of it.

use crate::texts::formatted;

/// A text and what becomes of it, with blanks at the ends of lines shown.
fn both(text: &str) -> String {
    let shown = |text: &str| text.lines().map(|l| format!("| {l}|\n")).collect::<String>();
    format!("{}\n{}", shown(text), shown(&formatted(text)))
}

macro_rules! rules {
    ($($name:ident: $text:expr,)*) => {
        $(
            #[test]
            fn $name() {
                insta::assert_snapshot!(stringify!($name), both($text));
            }
        )*
    };
}

rules! {
    indent: "link bar{\nA (0, 0)\n      mass 2 kg at A\n}\nspring k: a.A - b.B {\n rate {\n x 1\n}\n}",
    statement_that_goes_on: "find a,\nb,\n  // why\n   c\nlet x = (1 +\n2*\n3)\nfind\nd",
    empty_lines: "\n\nmech 1\n\n\n\nlink a {\n\n  A (0, 0)\n\n\n  B (1 m, 0)\n\n}\n\n\n",
    end_of_text: "mech 1   \ngiven r = 1 m",
    semicolons: "given r = 1 m;\nlink a { A (0, 0);B (1 m, 0) };  // two\n;\ngiven s = 2 m;given t = 3 m",
    commas_and_brackets: "find max( a ,b ),velocity( C ) .x , ( 1 m ,2 m )",
    signs: "let a=-b+c-d\nlet p = r@-30deg\nlet q = - ( a ) ^ 2 ^ - 1\nassemble x>0,y  <=  - 1 mm",
    products: "let a = b * c/d\nlet e = b *c\nlet f = b* c\nlet g = 2*r  *  (b+c)",
    units: "given a = 5mm\ngiven b = 5  N*m\ngiven c = 30°\ngiven d = 30 °\ngiven e = 5%\nlet f = 60 N * m\nlet g = 5 m ^ 2\nlet h = 6 mm*r",
    pairs_and_points: "link rod B - C 5 m\nrevolute B:crank-rod\nassemble C left  of A - B",
    braces: "link a{A (0,0)}\nrevolute A: a - b{friction 0.1;radius 5 mm}",
    ranges_and_settings: "drive a = 0 deg..360 deg in 12 steps at 80rpm\npose 4' at a=90deg,b = 1 m\nfind x=a  as   kN*m",
    tables: "variants {\n r[mm],n [rpm] ,  M\n 5,1000,-2.5\n15,   80, 1\n\n7,7,7\n}\nvariants {\nvariant, r [mm]\nB-2,5\n\"group 10\" , 15\n}",
    columns_of_pairs: "revolute A: a - b\nprismatic Bb: c.B - d.e { friction 0.1 }\n\nrevolute C: a - b\nslot D: a.C - b.s",
    columns_of_links: "link 1 a A-B 5 m\nlink 10 long { A (0, 0) }\nshaft S { wheel w teeth 5 }\nshaft Sb on a\nlink c {\n A (0, 0)\n}\nlink dd A-B 1 m",
    columns_of_values: "given r = 1 m\ngiven long = 2 m\nlet x = r\nlet yy = long\n// ends the run\nlet longer = r",
    columns_of_comments: "given r = 1 m // the crank\ngiven long = 2 m   //the rod\ngiven m = 1 kg\nfind x // else\nlink a { // body\n A (0, 0) // left\n mass 2 kg at A// heavy\n}",
    wide_letters: "given 曲柄 = 1 m // a\ngiven r = 2 m // b",
    comments: "//a\n//  b\n//----\n//1 m\n   // c\nmech 1//d",
    mark_of_the_encoding: "\u{FEFF}mech  1\n",
}

#[test]
fn line_ends_are_those_of_the_first_line() {
    assert_eq!(
        formatted("mech  1\r\ngiven r = 1 m\n\n\ngiven s = 2 m"),
        "mech 1\r\ngiven r = 1 m\r\n\r\ngiven s = 2 m\r\n"
    );
    assert_eq!(formatted("mech 1\ngiven r = 1 m\r\n"), "mech 1\ngiven r = 1 m\n");
}

#[test]
fn a_range_of_lines_leaves_others() {
    use assur_format::{edits, touching};
    use assur_text::source::{Source, edited};
    let text = "mech  1\ngiven  r = 1 m\ngiven  s = 1 m\nfind  r\n";
    let edits = edits(&Source::new("text.mech", text)).expect("a text that reads");
    let some = touching(text, edits, 2..=3);
    assert_eq!(edited(text, &some), "mech  1\ngiven r = 1 m\ngiven s = 1 m\nfind  r\n");
}

#[test]
fn a_text_that_does_not_read_is_refused() {
    let source = assur_text::source::Source::new("text.mech", "mech  1\nlink link link\n");
    assert!(assur_format::edits(&source).is_err_and(|problems| problems.has_errors()));
}
