//! What texts are read as.

use assur_syntax::document::{Cell, Document, Expr, ExprKind, Statement};
use assur_syntax::{parse, skeleton};
use assur_text::source::Source;

fn read(text: &str) -> Document {
    let source = Source::new("text.mech", text);
    let (document, problems) = parse(&source);
    assert!(problems.is_empty(), "{problems:?}");
    document
}

/// An expression with every bracket written.
fn shape(text: &str) -> String {
    let document = read(&format!("let x = {text}"));
    match &document.statements[0].node {
        Statement::Let(definition) => show(&definition.value),
        other => panic!("{other:?}"),
    }
}

fn show(expr: &Expr) -> String {
    match &expr.kind {
        ExprKind::Number(n) => match &n.unit {
            Some(unit) => format!("{}[{}]", n.text, unit.node),
            None => n.text.clone(),
        },
        ExprKind::Name(name) => name.clone(),
        ExprKind::Member(of, part) => format!("{}.{}", show(of), part.node),
        ExprKind::Call { function, args } => {
            let args = args.iter().map(|a| match &a.name {
                Some(name) => format!("{}={}", name.node, show(&a.value)),
                None => show(&a.value),
            });
            format!("{}({})", function.node, args.collect::<Vec<_>>().join(", "))
        }
        ExprKind::Vector(x, y) => format!("<{}, {}>", show(x), show(y)),
        ExprKind::Polar(r, phi) => format!("({} @ {})", show(r), show(phi)),
        ExprKind::Unary(op, x) => format!("{:?}({})", op.node, show(x)),
        ExprKind::Power(a, b) => format!("({} ^ {})", show(a), show(b)),
        ExprKind::Chain(first, rest) => {
            let rest = rest.iter().map(|(op, x)| format!(" {:?} {}", op.node, show(x)));
            format!("[{}{}]", show(first), rest.collect::<String>())
        }
        ExprKind::Compare(first, rest) => {
            let rest = rest.iter().map(|(op, x)| format!(" {:?} {}", op.node, show(x)));
            format!("[{}{}]", show(first), rest.collect::<String>())
        }
    }
}

#[test]
fn precedence() {
    assert_eq!(shape("a + b*c - d"), "[a Add [b Multiply c] Subtract d]");
    assert_eq!(shape("-x^2"), "Minus((x ^ 2))");
    assert_eq!(shape("2^-3^2"), "(2 ^ Minus((3 ^ 2)))");
    assert_eq!(shape("2*r @ phi + e @ 90 deg"), "[([2 Multiply r] @ phi) Add (e @ 90[deg])]");
    assert_eq!(shape("not a < b and c or d"), "[[Not([a Less b]) And c] Or d]");
    assert_eq!(shape("0.05 < t/s <= 0.95"), "[0.05 Less [t Divide s] LessOrEqual 0.95]");
    assert_eq!(shape("(a + b).x"), "[a Add b].x");
    assert_eq!(shape("f(load = 5 N, (1, 2))"), "f(load=5[N], <1, 2>)");
    assert_eq!(shape("−3"), "Minus(3)");
}

#[test]
fn a_unit_is_one_word() {
    assert_eq!(shape("60 N*m"), "60[N*m]");
    assert_eq!(shape("60 N * m"), "[60[N] Multiply m]");
    assert_eq!(shape("21 N / g"), "[21[N] Divide g]");
    assert_eq!(shape("6 mm*cos(a)"), "[6[mm] Multiply cos(a)]");
    assert_eq!(shape("6 mm*r"), "[6[mm] Multiply r]");
    assert_eq!(shape("6 mm*l1/2"), "[6[mm] Multiply l1 Divide 2]");
    assert_eq!(shape("-6 mm/r^2*k"), "[Minus(6[mm]) Divide (r ^ 2) Multiply k]");
    assert_eq!(shape("6 mm*r^n"), "[6[mm] Multiply (r ^ n)]");
    assert_eq!(shape("6 mm*p.x"), "[6[mm] Multiply p.x]");
    assert_eq!(shape("20 1/s"), "20[1/s]");
    assert_eq!(shape("20 s^-1 + 45°"), "[20[s^-1] Add 45[°]]");
    assert_eq!(shape("2 kg·m²"), "2[kg·m²]");
    assert_eq!(shape("5mm"), "5[mm]");
    assert_eq!(shape("5 wobbles"), "5[wobbles]");
    assert_eq!(shape("5 m2"), "5[m2]");
    assert_eq!(shape("1e-3 m"), "1e-3[m]");
}

#[test]
fn where_a_newline_ends_nothing() {
    let texts = [
        "let x = a +\n  b",
        "let x =\n  a + b",
        "let x = (\n  a + b\n)",
        "let x = a + // why\n\n  b",
        "let x = f(a,\n b\n )",
        "let x = a and\n b or\n c < \n d",
        "find a,\n  b as mm",
        "revolute A: ground -\n crank",
        "group g:\n a,\n b",
    ];
    for text in texts {
        assert_eq!(read(text).statements.len(), 1, "{text}");
    }
    assert_eq!(read("given a = 1; given b = 2\n\n;\ngiven c = 3").statements.len(), 3);
}

#[test]
fn names() {
    let document =
        read("given φ₁' = 1 rad\ngiven 曲柄 = 2\ngiven e\u{301} = 3\nlink cam { mass (0, 0); cam (1 m, 0) }");
    let Statement::Given(third) = &document.statements[2].node else { panic!() };
    assert_eq!(third.name.node, "é");
    assert_eq!(skeleton("А"), "A");
    assert_eq!(skeleton("Ѕ1"), "S1");
    assert_eq!(skeleton("α"), "α");
}

#[test]
fn notes_and_trivia() {
    let text = "mech 1\nmechanism \"M // N\" // aside\n// The crank\n//   turns.\n\n// not the problem\nslider A // s\n";
    let document = read(text);
    let notes = document.notes.iter().map(|n| n.node.as_str()).collect::<Vec<_>>();
    assert_eq!(notes, ["The crank", "  turns."]);
    let comments = document.trivia.comments.iter().map(|c| &text[c.start..c.end]).collect::<Vec<_>>();
    assert_eq!(comments, ["// aside", "// The crank", "//   turns.", "// not the problem", "// s"]);
    assert_eq!(document.trivia.blank_lines.len(), 1);
    assert_eq!(document.title().map(|t| t.node.as_str()), Some("M // N"));
}

#[test]
fn spans_end_with_what_they_hold() {
    let text = "link a A-B 5 mm   // c\nfind  a  +  b  as mm  // d\ndrive crank = 5 deg  \n";
    let document = read(text);
    let written = document.statements.iter().map(|s| &text[s.span.start..s.span.end]).collect::<Vec<_>>();
    assert_eq!(written, ["link a A-B 5 mm", "find  a  +  b  as mm", "drive crank = 5 deg"]);
    let Statement::Find(find) = &document.statements[1].node else { panic!() };
    assert_eq!(find.items[0].text, "a + b");
}

#[test]
fn a_bad_statement_keeps_its_names() {
    let (document, problems) = parse(&Source::new("t", "link rod B-C oops 5 { S2 (0, 0) }\nslider A\n"));
    assert_eq!((problems.len(), document.statements.len()), (1, 2));
    let Statement::Bad(bad) = &document.statements[0].node else { panic!() };
    assert!(["rod", "B", "C", "S2"].iter().all(|n| bad.names.iter().any(|b| b == n)));
}

#[test]
fn a_table_of_variants() {
    let document = read("mech 1\nvariants {\n  vA [m/s], i\n  4, 5\n  -2e-3, 2.5\n}\n");
    let Statement::Variants(table) = &document.statements[1].node else { panic!("a table") };
    assert_eq!((table.columns.len(), table.rows.len()), (2, 2));
    let Cell::Number(number) = &table.rows[1].cells[0].node else { panic!("a number") };
    assert_eq!(number.value.to_bits(), (-2e-3_f64).to_bits());
}

/// What questions are called.
fn labels(text: &str) -> Vec<String> {
    let document = read(text);
    let statements = document.statements.into_iter().flat_map(|s| match s.node {
        Statement::Find(find) => find.items.into_iter().map(|item| item.text).collect(),
        Statement::Expect(expect) => vec![expect.text],
        other => panic!("{other:?}"),
    });
    statements.collect()
}

#[test]
fn blanks_cannot_rename_a_question() {
    for (texts, wanted) in [
        (["angle(c)+angle(c)", "angle( c )  +\n angle (c) // twice"], "angle(c) + angle(c)"),
        (["- x^2 - -y", "-x ^ 2--y"], "-x^2 - -y"),
        (["(a+b) *2 / (c)", "( a + b )*2/( c )"], "(a + b)*2/(c)"),
        (["6 mm*r^2", "6mm * r ^ 2"], "6 mm * r^2"),
        (["60 N*m", "60N*m"], "60 N*m"),
        (["200/pi*(1 N*m)", "200 / pi * ( 1N*m )"], "200/pi*(1 N*m)"),
        (["5 m ^2", "5m  ^ 2"], "5 m ^ 2"),
        (["30° + 5%", "30 °+5 %"], "30° + 5 %"),
        (["f(a=5 N,b).x", "f ( a = 5N , b ) . x"], "f(a = 5 N, b).x"),
        (["(1 m,2 m)@x", "( 1m , 2m ) @ x"], "(1 m, 2 m) @ x"),
        (["not a<b and c>=d or e", "not  a < b  and c >= d or  e"], "not a < b and c >= d or e"),
    ] {
        for text in texts {
            assert_eq!(labels(&format!("find {text}")), [wanted], "{text}");
            assert_eq!(labels(&format!("expect {text}")), [wanted], "{text}");
        }
    }
}
