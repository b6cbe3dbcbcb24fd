//! Numbers with which nothing can be computed are an error where they are written, not `inf` and `NaN` in what is printed.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::drawing::{Drawing, Theme};
use assur::internals::exercise::grade::{Credit, Points, Rules, Sheet, Submissions, grade};
use assur::internals::picture::{KINDS, Options, Scene, draw};
use assur::internals::pipeline::solve_drawn;
use assur::internals::report::text::{self, Look};
use assur::internals::report::{self, AccuracyShown, PrintedDigits};
use assur::internals::source::Source;
use proptest::prelude::*;

fn said(text: &str, set: &[(&str, &str)]) -> String {
    let source = Source::new("great.mech", text);
    let set = set.iter().map(|(name, value)| ((*name).to_owned(), (*value).to_owned())).collect();
    let (_, problems) = assur::internals::solve_source(&source, &Overrides::set(set));
    render(&problems, &source, Style::PLAIN)
}

#[test]
fn great_numbers_are_refused_where_they_are_written() {
    let cases = [
        include_str!("../cases/use3/limits/great-lengths.mech"),
        include_str!("../cases/use3/limits/great-expectation.mech"),
        include_str!("../cases/use3/limits/great-point-drawn.mech"),
    ];
    for case in cases {
        let words = said(case, &[]);
        assert!(words.contains("mech::unit::no_value") && !words.contains("NaN"), "{words}");
    }
    let bar = "given r = 100 mm\nground { O (0, 0) }\nlink a O-A r\nrevolute O: ground - a\ndrive a = 30 deg\nfind position(A)\n";
    assert!(said(bar, &[("r", "1e120mm")]).contains("1e100"));
}

/// Thousands of columns that the key does not have are one warning.
#[test]
fn columns_that_the_key_does_not_have_are_reported_together() {
    let key = Sheet::read("key.csv", "row,x [mm]\n1,413\n".as_bytes(), None).expect("read");
    let key = key.unwrap_or_else(|(_, error)| panic!("{error}"));
    for (count, reported) in [(0, 0), (3, 3), (5, 5), (6, 1), (20_000, 1)] {
        let names: String = (0..count).map(|i| format!(",q{i} [mm]")).collect();
        let text = format!("row,x [mm]{names}\n1,413{}\n", ",1".repeat(count));
        let sheet = Sheet::read("answers.csv", text.as_bytes(), Some(&key)).expect("read");
        let sheet = sheet.unwrap_or_else(|(_, error)| panic!("{error}"));
        assert_eq!(sheet.left_out.len(), reported, "{count}");
        let kept: usize = sheet.left_out.iter().map(|(source, _)| source.text.len()).sum();
        assert!(kept < 1_000, "{count}: {kept} bytes");
    }
}

/// Lines that are no row of the key are kept to a number and counted beyond it.
#[test]
fn lines_that_the_key_does_not_have_are_counted() {
    let read = |name: &str, text: &str, key: Option<&Sheet>| {
        let sheet = Sheet::read(name, text.as_bytes(), key).expect("read");
        sheet.unwrap_or_else(|(_, error)| panic!("{error}"))
    };
    let key = read("key.csv", "row,x [mm]\n1,413\n", None);
    for count in [0, 1, 999, 1000, 1001, 3000] {
        let unknown: String = (0..count).map(|i| format!("z{i},1\n")).collect();
        let unreadable = "1,2,3\n".repeat(count);
        for (lines, what) in [(unknown, "unknown"), (unreadable, "unreadable")] {
            let answers = read("answers.csv", &format!("row,x [mm]\n1,413\n{lines}"), Some(&key));
            let rules = Rules {
                within: 1e-2,
                only_answered: false,
                submissions: Submissions::Last,
                points: Points::default(),
                credit: Credit::default(),
            };
            let graded = grade(&key, answers, &rules);
            let graded = graded.unwrap_or_else(|(_, error)| panic!("{error}"));
            let left_out = (graded.left_out.len(), graded.more_left_out);
            assert_eq!(left_out, (count.min(1000), count.saturating_sub(1000)), "{count} {what}");
            assert_eq!(graded.is_all_right(), count == 0, "{count} {what}");
        }
    }
}

/// Coordinates and angles at which numbers are farther apart than the digits that are printed.
#[test]
fn digits_that_numbers_do_not_have_are_a_warning() {
    let far = include_str!("../cases/use3/limits/far-origin.mech");
    let angle = include_str!("../cases/use3/limits/great-angle.mech");
    for (case, words) in [(far, "numbers near 1e12 m are"), (angle, "numbers near 1e17 deg are")] {
        assert!(said(case, &[]).contains(words), "{}", said(case, &[]));
        let source = Source::new("great.mech", case);
        let (compiled, _) = assur::internals::compile(&source, &Overrides::none());
        let (solved, problems) = assur::internals::solve_within(compiled.expect("compiled"), Some(1e-9));
        assert!(problems.has_errors(), "the accuracy is not reached");
        // 2e-3 of the shortest link, 0.4 rad
        let reached = solved.ok().and_then(|s| s.reached).expect("measured");
        assert!(!reached.is_kept() && reached.error > 1e-3, "{}", reached.error);
    }
    // at 1e3 m and 1e3 deg nothing is lost that shows
    let near = far.replace("1e12 m", "1e3 m");
    assert_eq!(said(&near, &[]), "");
    assert_eq!(said(&angle.replace("1e17", "1e5"), &[]), "");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::share::part(150)))]

    /// Wherever a number is huge or tiny, nothing printed is `inf` or `NaN`.
    #[test]
    fn nothing_printed_is_no_number(place in 0usize..64, power in -110i32..110, digit in 1u8..10, file in 0usize..5) {
        let text = [
            include_str!("../../examples/crank-slider.mech"),
            include_str!("../../examples/loads/spring.mech"),
            include_str!("../../examples/drives/slider-drive.mech"),
            include_str!("../../examples/friction/crank-slider.mech"),
            include_str!("../../examples/contacts/knife-lever.mech"),
        ][file];
        let text = text.split("\nexpect").next().unwrap_or_default();
        let numbers = numbers(text);
        let (start, end) = numbers[place % numbers.len()];
        let text = format!("{}{digit}e{power}{}\n", &text[..start], &text[end..]);
        let source = Source::new("great.mech", &*text);
        let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
        let mut out = render(&problems, &source, Style::PLAIN);
        if let Some(solved) = &solved {
            let answers = solved.answers(PrintedDigits::READABLE);
            out += &text::render(&report::of_answers("great", &answers, AccuracyShown::EveryPose), Look::PLAIN);
            out += &report::json::render("great", Some(&answers.model), Some(&answers), &problems.views(&source));
        }
        out += &pictures(&source);
        let words = out.split(|c: char| !c.is_alphanumeric()).map(str::to_lowercase);
        let bad = words.filter(|w| w == "inf" || w == "nan" || w == "infinity").count();
        prop_assert!(bad == 0, "{}\n{}", text, out);
    }
}

/// A plan of velocities that are nothing beside those of a point that no joint has.
#[test]
fn a_lever_of_one_point_is_drawn() {
    let text = include_str!("../../examples/contacts/knife-lever.mech").replace("A-O 18 mm", "A-O 1e-308 mm");
    let tags = pictures(&Source::new("small.mech", &*text));
    assert!(!tags.is_empty() && !tags.contains(" NaN ") && !tags.contains(" inf "));
}

/// The tags of all pictures of a text, without what they say.
fn pictures(source: &Source) -> String {
    let mut out = String::new();
    let Some(solved) = solve_drawn(source, &Overrides::none(), &KINDS).0 else { return out };
    let file = (source.name.as_str(), source.text.as_str());
    let Ok(scene) = Scene::of(solved.compiled.model(), &solved.solution, file, None) else { return out };
    for kind in KINDS {
        for drawing in draw(kind, &scene, &Options::default()).unwrap_or_default() {
            let svg = Drawing::placed(drawing).svg(Theme::Mono);
            for tag in svg.split('<').filter_map(|tag| tag.split('>').next()) {
                // the letters of commands are at their numbers
                out += &tag.replace("NaN", " NaN ").replace("inf", " inf ");
            }
        }
    }
    out
}

/// Where numbers are in statements.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let mut found = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        let code = if line.starts_with("mech") || line.starts_with("//") { "" } else { line };
        let bytes = code.as_bytes();
        let mut i = 0;
        while i < bytes.len() {
            let begins = bytes[i].is_ascii_digit()
                && (i == 0 || !bytes[i - 1].is_ascii_alphanumeric() && bytes[i - 1] != b'_');
            let mut end = i;
            while end < bytes.len() && (bytes[end].is_ascii_digit() || bytes[end] == b'.') {
                end += 1;
            }
            if begins && end < bytes.len() && bytes[end] == b' ' && line.contains('=') | line.contains("link")
            {
                found.push((at + i, at + end));
            }
            i = end.max(i + 1);
        }
        at += line.len();
    }
    found
}
