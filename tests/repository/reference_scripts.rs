//! The independent computations in `tests/reference`: each runs, with nothing but Python's standard library, and what it
//! prints is what the examples expect. A key that is changed on one side alone fails here.
//!
//! A script runs where it or what it is compared with has changed since it passed, by the hashes of `tests/reference/passed.txt`.
//! `UPDATE=1` runs all of them, and writes the hashes of a run that passed.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::process::Command;
use std::sync::Mutex;

/// Modules that other scripts import, and those that need the program (`answers.py`) or a folder.
const NO_SCRIPTS: [&str; 15] = [
    "answers.py",
    "dynamics.py",
    "exercise_set.py",
    "expressions.py",
    "friction.py",
    "mechfile.py",
    "mpmath.py",
    "planar.py",
    "printing.py",
    "reader.py",
    "sliding.py",
    "solution.py",
    "taylor.py",
    "trusses.py",
    "two_bars.py",
];

/// The hash of the catalogue of hard cases and of its script, as it passed.
const CATALOGUE: u64 = 0xb457_9f49_c0f8_7fb0;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

fn files(folder: &Path, extension: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(files(&path, extension));
        } else if path.extension().is_some_and(|e| e == extension) {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// What a script prints.
fn run(script: &Path) -> Result<String, String> {
    let folder = script.parent().expect("a folder");
    let name = script.file_name().expect("a name").to_string_lossy().into_owned();
    let output = Command::new("python3")
        .arg(&name)
        .current_dir(folder)
        .env("PYTHONPATH", root().join("tests/reference/decimals"))
        .env("PYTHONDONTWRITEBYTECODE", "1")
        .output()
        .map_err(|e| format!("python3 is needed to run the reference scripts: {e}"))?;
    if !output.status.success() {
        return Err(format!("{name}: {}", String::from_utf8_lossy(&output.stderr)));
    }
    Ok(String::from_utf8_lossy(&output.stdout).into_owned())
}

fn words(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}

/// `expect` lines with those that continue them.
fn expectations(text: &str) -> Vec<String> {
    let mut found: Vec<String> = Vec::new();
    for line in text.lines() {
        match found.last_mut() {
            _ if line.starts_with("expect ") => found.push(words(line)),
            Some(last) if last.ends_with(',') => *last = format!("{last} {}", words(line)),
            _ => {}
        }
    }
    found
}

/// Numbers of at least seven figures.
fn numbers(text: &str) -> Vec<f64> {
    let is_part = |c: char| c.is_ascii_digit() || ".eE+-".contains(c);
    let long = |s: &&str| s.chars().filter(char::is_ascii_digit).count() >= 7;
    let parts = text.split(|c| !is_part(c)).filter(long);
    parts.filter_map(|s| s.parse::<f64>().ok()).map(f64::abs).collect()
}

/// Whether the number is among those of the examples, but for the last digit.
fn known(all: &[f64], x: f64, within: f64) -> bool {
    let from = all.partition_point(|y| *y < x * (1.0 - within));
    all.get(from).is_some_and(|y| *y <= x * (1.0 + within))
}

fn sorted(texts: impl Iterator<Item = String>) -> Vec<f64> {
    let mut all: Vec<f64> = texts.flat_map(|t| numbers(&t)).collect();
    all.sort_by(f64::total_cmp);
    all
}

/// The outputs of all scripts, two at a time.
fn outputs(scripts: &[PathBuf]) -> BTreeMap<PathBuf, Result<String, String>> {
    let (next, done) = (Mutex::new(0), Mutex::new(BTreeMap::new()));
    let work = || {
        loop {
            let i = {
                let mut next = next.lock().expect("no panic");
                *next += 1;
                *next - 1
            };
            let Some(script) = scripts.get(i) else { return };
            let output = run(script);
            done.lock().expect("no panic").insert(script.clone(), output);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(work);
        }
    });
    done.into_inner().expect("no panic")
}

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).expect("a text")
}

/// FNV-1a, which is the same on every machine and with every compiler.
fn hash(texts: &[String]) -> u64 {
    let bytes = texts.iter().flat_map(|text| text.bytes().chain([0xff]));
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

/// The hashes of the scripts as they passed.
#[derive(Default, PartialEq)]
struct Passed(BTreeMap<String, u64>);

impl Passed {
    fn path() -> PathBuf {
        root().join("tests/reference/passed.txt")
    }

    fn kept() -> Self {
        let text = std::fs::read_to_string(Self::path()).unwrap_or_default();
        let line = |line: &str| {
            let (hash, name) = line.split_once(' ')?;
            Some((name.to_owned(), u64::from_str_radix(hash, 16).ok()?))
        };
        Self(text.lines().filter_map(line).collect())
    }

    /// Each script with the modules it may import and the example of its name: `cams/lever.mech` of `cams_lever.py`. One without such an
    /// example is compared with all of them, and with the numbers of the tests.
    fn now(scripts: &[PathBuf]) -> Self {
        let modules: Vec<PathBuf> = files(&root().join("tests/reference"), "py");
        let modules = modules.into_iter().filter(|p| NO_SCRIPTS.contains(&file_name(p).as_str()));
        let modules = hash(&modules.map(|p| read(&p)).collect::<Vec<_>>());
        let named = |path: &PathBuf| {
            let inner = path.strip_prefix(root().join("examples")).expect("an example").with_extension("py");
            (inner.to_string_lossy().replace(['/', '-'], "_"), read(path))
        };
        let examples: BTreeMap<String, String> =
            files(&root().join("examples"), "mech").iter().map(named).collect();
        let all = hash(&examples.values().cloned().collect::<Vec<_>>());
        let of = |script: &PathBuf| {
            let example = examples.get(&file_name(script)).cloned().unwrap_or_else(|| all.to_string());
            let hash = hash(&[read(script), example, modules.to_string()]);
            (file_name(script), hash)
        };
        Self(scripts.iter().map(of).collect())
    }

    fn has(&self, kept: &Self, script: &Path) -> bool {
        let name = file_name(script);
        self.0.get(&name).is_some_and(|hash| kept.0.get(&name) == Some(hash))
    }

    fn write(&self) {
        let line = |(name, hash): (&String, &u64)| format!("{hash:016x} {name}\n");
        std::fs::write(Self::path(), self.0.iter().map(line).collect::<String>()).expect("written");
    }
}

fn file_name(path: &Path) -> String {
    path.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
}

#[test]
fn the_scripts_print_what_the_examples_expect() {
    let is_script = |p: &PathBuf| {
        let name = file_name(p);
        !NO_SCRIPTS.contains(&name.as_str()) && name != "catalogue.py" && name != "pairs.py"
    };
    let mut scripts: Vec<PathBuf> =
        files(&root().join("tests/reference"), "py").into_iter().filter(is_script).collect();
    scripts.push(root().join("tests/reference/gears/pairs.py"));
    let (kept, now) = (Passed::kept(), Passed::now(&scripts));
    let update = std::env::var_os("UPDATE").is_some();
    if !update {
        scripts.retain(|script| !now.has(&kept, script));
        if scripts.is_empty() {
            return;
        }
    }
    let is_whole = scripts.len() == now.0.len();
    let examples: Vec<String> =
        files(&root().join("examples"), "mech").iter().map(|p| words(&read(p))).collect();
    let keys = sorted(examples.iter().cloned());
    let rust = ["tests", "src", "crates"].into_iter().flat_map(|folder| files(&root().join(folder), "rs"));
    let texts = rust.map(|p| read(&p).replace('_', ""));
    let everywhere = sorted(texts.chain(examples.iter().cloned()));
    let (mut lines, mut verbatim, mut wrong) = (0, 0, Vec::new());
    for (script, output) in outputs(&scripts) {
        let name = script.display();
        let output = match output {
            Ok(output) => output,
            Err(e) => {
                wrong.push(e);
                continue;
            }
        };
        let expected = expectations(&output);
        if expected.is_empty() && !numbers(&output).iter().any(|x| known(&everywhere, *x, 1e-6)) {
            wrong.push(format!("{name}: none of its numbers is in the examples or tests"));
        }
        for line in expected {
            lines += 1;
            if examples.iter().any(|e| e.contains(&line)) {
                verbatim += 1;
                continue;
            }
            // printed under another name, or with another last digit
            let value =
                line.split_once(" = ").map_or("", |l| l.1).split(" within ").next().unwrap_or_default();
            let missing: Vec<f64> = numbers(value).into_iter().filter(|x| !known(&keys, *x, 1e-13)).collect();
            if !missing.is_empty() {
                wrong.push(format!("{name}: no example expects {missing:?} of `{line}`"));
            }
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    assert!(!is_whole || lines > 500 && verbatim * 20 > lines * 19, "{verbatim} of {lines} lines");
    if update {
        now.write();
    }
}

#[test]
fn the_catalogue_of_hard_cases_is_what_its_script_prints() {
    let folder = root().join("tests/reference/hard");
    // a table of its own, which changes with its script alone
    let texts = ["hard/catalogue.py", "hard/catalogue.csv", "decimals/mpmath.py"];
    let now = hash(&texts.map(|path| read(&root().join("tests/reference").join(path))));
    if !crate::share::all() && now == CATALOGUE {
        return;
    }
    let printed = run(&folder.join("catalogue.py")).unwrap_or_else(|e| panic!("{e}"));
    let kept = read(&folder.join("catalogue.csv"));
    assert_eq!(printed.lines().count(), kept.lines().count());
    for (new, old) in printed.lines().zip(kept.lines()).skip(1) {
        let (new, old): (Vec<&str>, Vec<&str>) = (new.split(',').collect(), old.split(',').collect());
        assert_eq!(new[..4], old[..4]);
        assert_eq!(new[7], old[7]);
        let number = |text: &str| text.parse::<f64>().expect("a number");
        let (size, high) = (number(old[6]).abs().max(number(old[4]).abs()), number(new[4]) - number(old[4]));
        let off = high + (number(new[5]) - number(old[5]));
        assert!(off.abs() <= 1e-28 * size, "{new:?} {old:?}");
    }
    assert_eq!(now, CATALOGUE, "it passed: put {now:#x} in the place of CATALOGUE");
}
