//! Examples with other numbers give pictures or diagnostics.

use crate::drawn::{animated, faults, moving, moving_picture, sheets, solved};
use crate::every_example::examples;
use crate::share::{all, least};
use assur::internals::picture::KINDS;

/// Changes per example.
const CHANGES: u64 = 2;

/// Numbers that follow from a seed.
struct Random(u64);

impl Random {
    fn below(&mut self, most: usize) -> usize {
        // xorshift
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        usize::try_from(self.0 % most.max(1) as u64).unwrap_or(0)
    }
}

/// A text with one of its numbers replaced, or one of its lines left out.
fn changed(text: &str, random: &mut Random) -> String {
    if random.below(4) == 0 {
        let left_out = random.below(text.lines().count());
        let kept = text.lines().enumerate().filter(|(i, _)| *i != left_out).map(|(_, line)| line);
        return kept.collect::<Vec<_>>().join("\n");
    }
    let is_digit = |at: usize| text.as_bytes().get(at).is_some_and(u8::is_ascii_digit);
    let in_word = |at: usize| text[..at].ends_with(|c: char| c.is_alphanumeric() || "._'".contains(c));
    let starts: Vec<usize> = (0..text.len()).filter(|at| is_digit(*at) && !in_word(*at)).collect();
    let Some(&start) = starts.get(random.below(starts.len())) else { return text.to_owned() };
    let end = text[start..].find(|c: char| !c.is_ascii_digit() && c != '.').map_or(text.len(), |n| start + n);
    let factors = ["0*", "-", "1e-6*", "1e6*", "0.5*", "2*", "1e-12*", "7*"];
    format!("{}{}{}{}", &text[..start], factors[random.below(factors.len())], &text[start..end], &text[end..])
}

#[test]
fn other_numbers_give_pictures_or_diagnostics() {
    let (mut wrong, mut count) = (Vec::new(), 0);
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    let texts = examples().into_iter().filter(|(_, text)| text.len() < 6000);
    for (index, (name, text)) in texts.enumerate() {
        for _ in 0..CHANGES {
            let other = changed(&text, &mut random);
            // one example of five, changed as where all are drawn
            if !all() && index % 5 > 0 {
                continue;
            }
            let drawn = std::panic::catch_unwind(|| {
                let (source, solved) = solved(&name, &other)?;
                let sheets = KINDS.into_iter().flat_map(|kind| sheets(&source, &solved, kind));
                let found: Vec<String> =
                    sheets.chain(moving(&source, &solved)).flat_map(|s| faults(&s)).collect();
                let pages = [animated(&source, &solved), moving_picture(&source, &solved)];
                let nan = pages.into_iter().flatten().any(|page| page.contains("NaN"));
                Some((found, nan))
            });
            match drawn {
                Ok(Some((found, nan))) => {
                    count += 1;
                    wrong.extend(found.into_iter().take(2).map(|fault| format!("{name}: {fault}\n{other}")));
                    wrong.extend(nan.then(|| format!("{name}: a number is none\n{other}")));
                }
                Ok(None) => {}
                Err(_) => wrong.push(format!("{name} panics:\n{other}")),
            }
        }
    }
    assert!(count as u64 > least(40) * CHANGES, "changed examples are solved: {count}");
    assert!(wrong.is_empty(), "{} faults\n{}", wrong.len(), wrong.join("\n"));
}
