//! No text makes it panic or hang: examples with lines cut, doubled and swapped, numbers made extreme, bytes changed.

use assur::source::Source;
use std::path::{Path, PathBuf};

/// A deterministic generator (xorshift), so that a failure can be had again.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % (n.max(1) as u64)).unwrap_or(0)
    }
}

fn examples(folder: &Path, out: &mut Vec<PathBuf>) {
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            examples(&path, out);
        } else if path.extension().is_some_and(|e| e == "mech") {
            out.push(path);
        }
    }
}

fn mutated(text: &str, random: &mut Random) -> String {
    const NUMBERS: [&str; 7] = ["0", "-1", "1e308", "1e-308", "1e999", "0.0000001", "123456789"];
    let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
    for _ in 0..=random.below(3) {
        let (i, j) = (random.below(lines.len()), random.below(lines.len()));
        match random.below(5) {
            0 => {
                lines.remove(i);
            }
            1 => lines.insert(j, lines[i].clone()),
            2 => lines.swap(i, j),
            3 => {
                let words: Vec<&str> = lines[i].split(' ').collect();
                let numbers: Vec<usize> = (0..words.len())
                    .filter(|&w| words[w].starts_with(|c: char| c.is_ascii_digit()))
                    .collect();
                if !numbers.is_empty() {
                    let at = numbers[random.below(numbers.len())];
                    let mut words: Vec<String> = words.into_iter().map(str::to_owned).collect();
                    words[at] = NUMBERS[random.below(NUMBERS.len())].to_owned();
                    lines[i] = words.join(" ");
                }
            }
            _ => {
                let mut chars: Vec<char> = lines[i].chars().collect();
                if !chars.is_empty() {
                    let at = random.below(chars.len());
                    chars[at] = ['(', '}', '"', '.', '-', 'µ', '\u{0}', '@'][random.below(8)];
                    lines[i] = chars.into_iter().collect();
                }
            }
        }
        if lines.is_empty() {
            lines.push(String::new());
        }
    }
    lines.join("\n")
}

#[test]
fn mutated_examples_never_panic() {
    let mut files = Vec::new();
    examples(&Path::new(env!("CARGO_MANIFEST_DIR")).join("examples"), &mut files);
    files.sort();
    assert!(!files.is_empty());
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    let texts: Vec<String> = files.iter().map(|f| std::fs::read_to_string(f).expect("an example")).collect();
    for round in 0..600 {
        let text = mutated(&texts[round % texts.len()], &mut random);
        let source = Source::new("mutant.mech", text.clone());
        if std::panic::catch_unwind(|| assur::diagnose(&source)).is_err() {
            panic!("a panic at:\n{text}");
        }
    }
}
