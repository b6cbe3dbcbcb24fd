//! The time of worked solutions, as `assur report` writes them: from the arguments to the files on disk. The least of several rounds, in
//! milliseconds, with the bytes of the pages.
//!
//! `cargo bench --bench report -- FILE…`; without files the six-bar, the shaper project and 1,000 exercise sheets, against what they may take.

use assur::internals::cli;
use std::ffi::OsString;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// How often each is written.
const ROUNDS: usize = 9;
/// Rows of the file of sheets.
const SHEETS: usize = 1000;

/// What is written, and what it may take.
struct Job {
    name: String,
    arguments: Vec<String>,
    milliseconds: f64,
    bytes: u64,
    rounds: usize,
}

fn main() -> std::io::Result<()> {
    let folder = std::env::temp_dir().join(format!("assur-report-{}", std::process::id()));
    std::fs::create_dir_all(&folder)?;
    // what cargo puts behind the files
    let files: Vec<String> = std::env::args().skip(1).filter(|arg| arg != "--bench").collect();
    let jobs = if files.is_empty() { usual(&folder)? } else { files.iter().map(|file| page(file)).collect() };
    println!("{:<52} {:>9} {:>7} {:>9} {:>9}", "example", "ms", "may", "bytes", "may");
    for job in &jobs {
        let (time, bytes) = measured(job, &folder);
        let most = |x: f64| if x.is_finite() { x.to_string() } else { String::new() };
        let limit = if job.bytes < u64::MAX { job.bytes.to_string() } else { String::new() };
        println!("{:<52} {time:>9.2} {:>7} {bytes:>9} {limit:>9}", job.name, most(job.milliseconds));
    }
    std::fs::remove_dir_all(&folder)
}

/// The solution of a file, however long it takes.
fn page(file: &str) -> Job {
    let arguments = vec![file.to_owned()];
    Job { name: file.to_owned(), arguments, milliseconds: f64::INFINITY, bytes: u64::MAX, rounds: ROUNDS }
}

fn usual(folder: &Path) -> std::io::Result<Vec<Job>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let at = |name: &str| root.join(name).display().to_string();
    let rows = folder.join("rows.mech");
    std::fs::write(&rows, with_rows(&std::fs::read_to_string(root.join("kinetostatics/six-bar.mech"))?))?;
    let sheets = vec![rows.display().to_string(), "--sheet".to_owned(), "--per-row".to_owned()];
    let key = vec![rows.display().to_string(), "--key".to_owned()];
    let job = |name: &str, arguments, milliseconds, bytes, rounds| Job {
        name: name.to_owned(),
        arguments,
        milliseconds,
        bytes,
        rounds,
    };
    Ok(vec![
        job("kinetostatics/six-bar", vec![at("kinetostatics/six-bar.mech")], 30.0, 250_000, ROUNDS),
        job("shaper/shaper-a", vec![at("shaper/shaper-a.mech")], 100.0, u64::MAX, ROUNDS),
        job("shaper/shaper-b", vec![at("shaper/shaper-b.mech")], 100.0, u64::MAX, ROUNDS),
        job("1,000 sheets of the six-bar", sheets, 1000.0, u64::MAX, 2),
        job("the key of 1,000 rows", key, 1000.0, u64::MAX, 2),
    ])
}

/// The six-bar with a table of variants.
fn with_rows(text: &str) -> String {
    let kept: Vec<&str> = text.lines().filter(|line| !line.starts_with("expect")).collect();
    let mut rows = kept.join("\n") + "\nvariants {\n  phi1 [deg], Fr [N]\n";
    for row in 0..SHEETS {
        let _ = writeln!(rows, "  {}.{}, {}", 30 + row / 10, row % 10, 200 + row);
    }
    rows + "}\n"
}

/// The least time of several rounds, ms, and the bytes of what is written.
fn measured(job: &Job, folder: &Path) -> (f64, u64) {
    let out = folder.join("page.html");
    let mut words: Vec<OsString> = vec!["assur".into(), "report".into()];
    words.extend(job.arguments.iter().map(OsString::from));
    words.extend(["-o".into(), out.into_os_string()]);
    let mut least = f64::INFINITY;
    for _ in 0..job.rounds {
        let start = Instant::now();
        let status = cli::run(words.clone());
        assert!(format!("{status:?}").contains("(0)"), "{} is not written: {status:?}", job.name);
        least = least.min(1e3 * start.elapsed().as_secs_f64());
    }
    let pages: Vec<PathBuf> =
        std::fs::read_dir(folder).into_iter().flatten().flatten().map(|entry| entry.path()).collect();
    let pages = pages.into_iter().filter(|path| path.extension().is_some_and(|ending| ending == "html"));
    let bytes = pages.map(|path| {
        let size = path.metadata().map_or(0, |about| about.len());
        let _ = std::fs::remove_file(path);
        size
    });
    (least, bytes.sum())
}
