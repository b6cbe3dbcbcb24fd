//! Mutated programs: whatever a file says, it is read, checked, split, planned, solved and reported
//! without a panic, and in bounded time.

use assur::internals::check::Overrides;
use assur::internals::diagnostic::{Style, render};
use assur::internals::source::Source;
use proptest::prelude::*;
use std::path::Path;
use std::sync::{LazyLock, mpsc};
use std::time::Duration;

/// A run of a motion ends after a million steps: some ten seconds, and several times that on a busy machine.
const PATIENCE: Duration = Duration::from_secs(120);
/// What may stand in the place of a number.
const NUMBERS: [&str; 12] =
    ["0", "-1", "1e308", "1e-308", "1e999", "-1e308", "NaN", "inf", "1e15", "0.0000001", "3..", "−0"];

/// Texts to be mutated: the examples and the programs of the language's page, and among the wrong files those of the late
/// stages, which are one step from right.
static TEXTS: LazyLock<Vec<String>> = LazyLock::new(|| {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut texts = Vec::new();
    for folder in ["examples", "tests/language", "tests/errors/determinacy", "tests/errors/assembly"] {
        collect(&root.join(folder), &mut texts);
    }
    // a general group is searched from hundreds of starts
    texts.retain(|t| t.len() < 4_000);
    assert!(texts.len() > 60);
    texts
});

fn collect(folder: &Path, texts: &mut Vec<String>) {
    let mut entries: Vec<_> =
        std::fs::read_dir(folder).expect("a folder").flatten().map(|e| e.path()).collect();
    entries.sort();
    for path in entries {
        if path.is_dir() {
            collect(&path, texts);
        } else if path.extension().is_some_and(|e| e == "mech") {
            texts.push(std::fs::read_to_string(&path).expect("a text"));
        }
    }
}

/// The whole way, with what a reader sees at its end.
fn through(text: &str) {
    let (done, wait) = mpsc::channel();
    let owned = text.to_owned();
    let run = std::thread::spawn(move || {
        let source = Source::new("text.mech", owned);
        let (solved, problems) = assur::internals::solve_source(&source, &Overrides::none());
        let _ = render(&problems, &source, Style::PLAIN);
        let _ = render(&problems, &source, Style::Narrated);
        let _ = problems.views(&source);
        if let Some(solved) = solved {
            for (pose, at) in solved.solution.poses.iter().filter_map(|p| Some((p, p.outcome.as_ref().ok()?)))
            {
                assert!(at.condition >= 0.0, "condition {} at {}", at.condition, pose.name);
            }
        }
        let _ = done.send(());
    });
    match wait.recv_timeout(PATIENCE) {
        Ok(()) => {}
        Err(mpsc::RecvTimeoutError::Timeout) => panic!("takes more than {PATIENCE:?}:\n{text}"),
        Err(mpsc::RecvTimeoutError::Disconnected) => {
            let _ = run.join();
            panic!("a panic on:\n{text}");
        }
    }
}

/// A mutation of a text; places are given as parts of its length.
#[derive(Clone, Debug)]
enum Slip {
    Cut { at: f64, length: usize },
    SwapWords { a: f64, b: f64 },
    Number { at: f64, with: usize },
    RepeatLine { at: f64 },
    RemoveLine { at: f64 },
    SwapLines { a: f64, b: f64 },
    Truncate { at: f64 },
}

fn slip() -> impl Strategy<Value = Slip> {
    let part = || 0.0..1.0_f64;
    prop_oneof![
        2 => (part(), 1..12_usize).prop_map(|(at, length)| Slip::Cut { at, length }),
        2 => (part(), part()).prop_map(|(a, b)| Slip::SwapWords { a, b }),
        6 => (part(), 0..NUMBERS.len()).prop_map(|(at, with)| Slip::Number { at, with }),
        1 => part().prop_map(|at| Slip::RepeatLine { at }),
        3 => part().prop_map(|at| Slip::RemoveLine { at }),
        1 => (part(), part()).prop_map(|(a, b)| Slip::SwapLines { a, b }),
        1 => part().prop_map(|at| Slip::Truncate { at }),
    ]
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss)]
fn index(part: f64, length: usize) -> usize {
    ((part * length as f64) as usize).min(length.saturating_sub(1))
}

fn mutate(text: &str, slip: &Slip) -> String {
    let place = |part: f64| text.floor_char_boundary(index(part, text.len() + 1));
    match *slip {
        Slip::Cut { at, length } => {
            let start = place(at);
            let end = text.floor_char_boundary((start + length).min(text.len()));
            format!("{}{}", &text[..start], &text[end.max(start)..])
        }
        Slip::Truncate { at } => text[..place(at)].to_owned(),
        Slip::Number { at, with } => {
            let numbers = numbers(text);
            let Some(&(start, end)) = numbers.get(index(at, numbers.len())) else { return text.to_owned() };
            format!("{}{}{}", &text[..start], NUMBERS[with], &text[end..])
        }
        Slip::SwapWords { a, b } => swap(&text.split(' ').collect::<Vec<_>>(), a, b).join(" "),
        Slip::SwapLines { a, b } => swap(&text.lines().collect::<Vec<_>>(), a, b).join("\n"),
        Slip::RepeatLine { at } | Slip::RemoveLine { at } => {
            let mut lines: Vec<&str> = text.lines().collect();
            let at = index(at, lines.len());
            match slip {
                Slip::RepeatLine { .. } => lines.insert(at, lines[at]),
                _ => drop(lines.remove(at)),
            }
            lines.join("\n")
        }
    }
}

fn swap<'a>(parts: &[&'a str], a: f64, b: f64) -> Vec<&'a str> {
    let mut parts = parts.to_vec();
    let (a, b) = (index(a, parts.len()), index(b, parts.len()));
    parts.swap(a, b);
    parts
}

/// Where the numbers of a text stand.
fn numbers(text: &str) -> Vec<(usize, usize)> {
    let bytes = text.as_bytes();
    let mut out = Vec::new();
    let mut at = 0;
    while at < bytes.len() {
        let starts = bytes[at].is_ascii_digit() && (at == 0 || !is_name(bytes[at - 1]));
        let start = at;
        at += 1;
        if starts {
            while at < bytes.len() && (bytes[at].is_ascii_digit() || bytes[at] == b'.' || bytes[at] == b'e') {
                at += 1;
            }
            out.push((start, at));
        }
    }
    out
}

const fn is_name(byte: u8) -> bool {
    byte.is_ascii_alphanumeric() || byte == b'_' || byte == b'\'' || byte >= 0x80
}

/// `PROPTEST_CASES=100000` looks harder.
fn cases() -> u32 {
    std::env::var("PROPTEST_CASES")
        .ok()
        .and_then(|n| n.parse().ok())
        .unwrap_or_else(|| crate::share::part(2_000))
}

proptest! {
    #![proptest_config(ProptestConfig { max_shrink_iters: 0, ..ProptestConfig::with_cases(cases()) })]

    #[test]
    fn mutated_programs(which in 0.0..1.0_f64, slips in prop::collection::vec(slip(), 1..4)) {
        let mut text = TEXTS[index(which, TEXTS.len())].clone();
        for slip in &slips {
            if !text.is_empty() {
                text = mutate(&text, slip);
            }
        }
        through(&text);
    }
}

/// Every number of the simple examples in turn.
#[test]
fn numbers_out_of_range() {
    let text = include_str!("../../examples/crank-slider.mech");
    for (start, end) in numbers(text) {
        for number in ["0", "-1", "1e308", "1e-308"] {
            through(&format!("{}{number}{}", &text[..start], &text[end..]));
        }
    }
}

/// Every line left out, and every line said twice.
#[test]
fn lines_left_out_and_repeated() {
    for text in [
        include_str!("../../examples/crank-slider.mech"),
        include_str!("../../examples/kinetostatics/six-bar.mech"),
    ] {
        let lines: Vec<&str> = text.lines().collect();
        for at in 0..lines.len() {
            let mut less = lines.clone();
            less.remove(at);
            through(&less.join("\n"));
            let mut more = lines.clone();
            more.insert(at, lines[at]);
            through(&more.join("\n"));
        }
    }
}
