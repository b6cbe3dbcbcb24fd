//! docs/measured/stability.md shows the measurements of the catalogue.
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

Accuracy of the answers for mechanisms that are hard to compute. Written by

```sh
ASSUR_WRITE=1 cargo test --test mechanics hard::page
```

which solves the programs below `examples/hard`, each with its settings, and compares every quantity with a reference of 50
digits (`tests/reference/hard/catalogue.py`) on the decimal numbers of the file. The error is relative to the quantity, or
to its typical magnitude if the quantity passes through zero. The tests assert for every error

> error ≤ c ε/σ^k, with ε = 2.2e-16, σ the reported condition, k = 1 for positions, 2 for velocities and forces, 3 for
> accelerations and quantities that depend on them,

with c = 64; the table gives the least power of four that each case needs. If fewer than seven digits are left,
`mech::solve::ill_conditioned` is reported, and the tests assert it. Errors are rounded up to a power of ten.

| case | settings | least σ | error: positions | velocities, forces | accelerations | c | reported |
| --- | --- | --- | --- | --- | --- | --- | --- |
";

const TAIL: &str = "
## Beyond the table

- A sweep continues through a change point along the parabola through three earlier positions well apart. It changes the assembly
  only if |σ| really vanishes (below 3e-7): a four-bar that misses its change point by 1e-12 of its lengths turns
  back as it should. Nearer than that the rounding of the lengths decides, and the change is reported.
- After 10,000 turns a four-bar and a parallelogram are on their branch and at their angle, to the rounding of the angle
  itself (`tests/mechanics/hard/long.rs`). More than 11,111 turns between two positions are an error.
- In a chain of 1,000 dyads each dyad passes its error on to the next: the bound grows with their number.
- The errors of groups in series multiply: σ in the report is the least of all groups, and a group that depends on another
  one near its dead position may lose more than ε/σ^k (up to 3e8 times that in positions, over the random cases below). The
  warning of lost digits uses the product of all σ below 0.05, which includes this.
- A third crank on a parallelogram is a redundant constraint and an error (`tests/errors/determinacy/repeated/equal_cranks.mech`); the free
  rotation of a roller is not solved, and the report names it.

## No silent wrong answer

```sh
ASSUR_CASES=100000 cargo test --test mechanics no_silent -- --nocapture
```

draws random mechanisms (a driven link and up to five groups of all kinds), most of them with groups near their dead positions
down to σ = 1e-16, driven elsewhere, scaled from 1e-4 to 1e4 and shifted. Every answer is compared with Newton's method in
double-double on the constraints of all pairs and an independent system of Newton and Euler; if this is ill-conditioned itself, with the
reference of 30 digits (`solve::reference`). The answer must have as many correct digits as the warning states, or seven if
there is no warning. A case without an answer must end with a diagnostic. 10,000 of these cases run with all tests. Of the 100,000, 81,908
answers are compared and 17,277 end with a diagnostic; forces of 5,689 are not compared, because a load depends on the sign of zero or the
warning claims no digit; the other cases claim no digit either. All answers pass.

## No panic, no hang

```sh
fuzz/run.sh 10000000 86400
```

runs the libFuzzer targets on the stable toolchain, `parse` (text to document) and `solve` (text to answers), with assertions and checks of
overflow. They start from the statements and files of the examples and the tests. The first number is the number of mutated texts,
of up to 100 bytes for `parse`, 2,000 for `solve`. A panic, more than two seconds or more than 1 GB ends the run, and the text is
kept. `parse` has tried 10,000,000 texts (2,400 per second while builds ran, 44 MB) and `solve` 371,410 (690 per second, 63 MB)
without any of these.
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
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/measured/stability.md");
    if std::env::var_os("ASSUR_WRITE").is_some() {
        std::fs::write(&path, &page).expect("docs/measured/stability.md");
    }
    let there = std::fs::read_to_string(&path).unwrap_or_default();
    let differs = page.lines().zip(there.lines()).find(|(a, b)| a != b);
    assert!(page == there, "write docs/measured/stability.md again: {differs:?}");
}
