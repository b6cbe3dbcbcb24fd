//! docs/stability.md tells what the catalogue measures.
//!
//! ```sh
//! ASSUR_WRITE=1 cargo test --test mechanics hard::page
//! ```
//!
//! writes it again.

use super::catalogue::{BOUND, Met, Ran, runs};
use std::fmt::Write;
use std::path::Path;

const HEAD: &str = "# Stability

What is left of the answers where mechanisms are hard to compute. Written by

```sh
ASSUR_WRITE=1 cargo test --test mechanics hard::page
```

which solves the programs below `examples/hard`, each with its settings, and holds every quantity against a reference of 50
digits (`tests/reference/hard/catalogue.py`) on the decimal numbers of the file. The error is relative to the quantity, or
to the magnitude in play where that passes through nothing. The tests assert that every error keeps

> error ≤ c ε/σ^k, with ε = 2.2e-16, σ the reported condition, k = 1 for positions, 2 for velocities and forces, 3 for
> accelerations and what hangs on them,

with c = 64; the table tells the least power of four that each case needs. Where fewer than seven digits are left the user is
told by `mech::solve::ill_conditioned`, and the tests assert it. Errors are rounded up to a power of ten.

| case | settings | least σ | error: positions | velocities, forces | accelerations | c | told |
| --- | --- | --- | --- | --- | --- | --- | --- |
";

const TAIL: &str = "
## Beyond the table

- A sweep goes through a change point as it came: by the parabola through three places well apart. It changes the assembly
  only where |σ| truly vanishes on the way (below 3e-7): a four-bar that misses its change point by 1e-12 of its lengths turns
  back as it should. Nearer than that the rounding of the lengths decides, and the change is told.
- 10,000 turns of a four-bar and of a parallelogram end on their branch and at their angle, to the rounding of the angle
  itself (`tests/mechanics/hard/long.rs`). A way of more than 11,111 turns between two positions is refused.
- In a chain of 1,000 dyads what one dyad loses is carried on by the next: the bound grows with their number.
- Groups in series multiply what they lose: σ in the report is the least of all groups, and a group that hangs on another
  one near its dead position may lose more than ε/σ^k (up to 3e8 times that in positions, over the random cases below). The
  warning of lost digits goes by the product of the σ below 0.05 and covers it.
- A third crank on a parallelogram is a constraint too many and an error (`tests/errors/determinacy/repeated/equal_cranks.mech`); a roller that turns
  freely is set aside and named.

## No silent wrong answer

```sh
ASSUR_CASES=100000 cargo test --test mechanics no_silent -- --nocapture
```

draws random mechanisms (a driven link and up to five groups of all kinds), most of them with groups near their dead positions
down to σ = 1e-16, driven elsewhere, scaled from 1e-4 to 1e4 and shifted. Every answer is judged against Newton's method in
double-double on the constraints of all pairs and an independent system of Newton and Euler, which the reference of 30 digits
(`solve::reference`) takes over where it is ill-conditioned itself: it has the digits that the warning tells, or seven where
there is none. What has no answer is refused with a diagnostic. A part of 10,000 runs with all tests. Of the 100,000, 81,908
answers are judged and 17,277 refused; forces of 5,689 are not judged, because a load hangs on the sign of nothing or no digit
is claimed; the other cases claim no digit either. All hold.

## No panic, no hang

```sh
fuzz/run.sh 10000000 86400
```

runs the libFuzzer targets on the stable toolchain, `parse` (text to document) and `solve` (text to answers), from the statements
and the files of the examples and the tests, with assertions and checks of overflow, on as many mutated texts as the first number
says: of up to 100 bytes for `parse`, 2,000 for `solve`. A panic, more than two seconds or more than 1 GB ends it, and the text is
kept. `parse` has tried 10,000,000 texts (2,400 per second beside builds, 44 MB) without any of these.
";

/// Rounded up to a power of ten, or of four.
fn decade(x: f64) -> String {
    if x == 0.0 { "0".to_owned() } else { format!("1e{}", libm::ceil(libm::log10(x))) }
}

fn power_of_four(x: f64) -> String {
    let mut c = 1.0;
    while c < x {
        c *= 4.0;
    }
    format!("{c}")
}

fn line(ran: &Ran) -> String {
    let worst = |k: i32| {
        let errors: Vec<f64> = ran.met.iter().filter(|m| m.row.power == k).filter_map(|m| m.error).collect();
        if errors.is_empty() { "—".to_owned() } else { decade(errors.into_iter().fold(0.0, f64::max)) }
    };
    let answered = ran.met.iter().filter(|m| m.error.is_some());
    let sigma = answered.clone().map(|m| m.condition).fold(f64::INFINITY, f64::min);
    let sigma = if sigma.is_finite() { format!("{sigma:.0e}") } else { "—".to_owned() };
    let c = answered.filter_map(Met::share).fold(0.0, f64::max);
    let mut told: Vec<String> =
        ran.told.iter().map(|t| format!("`{}`", t.trim_start_matches("mech::"))).collect();
    told.dedup();
    format!(
        "| {} | {} | {sigma} | {} | {} | {} | {} | {} |",
        ran.file,
        if ran.settings.is_empty() { "as written" } else { &ran.settings },
        worst(1),
        worst(2),
        worst(3),
        power_of_four(c),
        if told.is_empty() { "—".to_owned() } else { told.join(", ") }
    )
}

#[test]
fn the_page_is_what_is_measured() {
    assert!((BOUND - 64.0).abs() < f64::EPSILON, "the page says 64");
    let mut page = HEAD.to_owned();
    for ran in runs() {
        writeln!(page, "{}", line(&ran)).expect("a text");
    }
    page += TAIL;
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/stability.md");
    if std::env::var_os("ASSUR_WRITE").is_some() {
        std::fs::write(&path, &page).expect("docs/stability.md");
    }
    let there = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = page.lines().zip(there.lines()).find(|(a, b)| a != b);
    assert!(page == there, "write docs/stability.md again: {differs:?}");
}
