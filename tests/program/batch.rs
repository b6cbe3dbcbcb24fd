//! `assur batch`, and rows of variants in `solve` and `test`, as run from a shell.

#![allow(clippy::unwrap_used)] // a test that cannot write its files has failed

use crate::run::{self, Folder, Said, assur, column, rows};
use std::path::Path;

const PRESS: &str = "mech 1
given r = 100 mm
given l = 350 mm
given phi = 60 deg
given P = 1000 N
ground { A (0, 0); line guide through A along 0 deg }
link 1 crank  A-B r
link 2 rod    B-C l
link 3 piston { C (0, 0) }
revolute  A: ground - crank
revolute  B: crank - rod
revolute  C: rod - piston
prismatic D: piston.C - ground.guide
drive crank = phi
assemble C ahead of B
force on piston at C = P @ 180 deg
balance torque M on crank
find x = position(C).x as mm, M as N*m, reactions
";

fn many(count: usize) -> String {
    let row = |i: usize| format!("{},{},{}\n", 80 + i % 40, 300 + i % 77, (7 * i) % 360);
    "r [mm],l [mm],phi [deg]\n".to_owned() + &(0..count).map(row).collect::<String>()
}

fn fine(said: &Said) {
    assert_eq!(said.status, 0, "{}", said.stderr);
}

#[test]
fn every_thread_count_gives_the_same_bytes() {
    let table = many(1500).replace("\n95,", "\n900,");
    let folder = Folder::new("threads").with("p.mech", PRESS).with("t.csv", &table);
    for format in ["csv", "table", "jsonl"] {
        let run = |threads: &str| {
            let key = format!("key{threads}.csv");
            let args = ["batch", "p.mech", "--variants", "t.csv", "--format", format, "--threads", threads];
            let said = assur(&folder, &[&args[..], &["--key", &key]].concat());
            assert_eq!(said.status, 1, "some rows do not close: {}", said.stderr);
            (said.stdout, said.stderr, folder.read(&key))
        };
        let one = run("1");
        assert!(one.1.contains("do not close: rows "), "{}", one.1);
        for threads in ["2", "3", "7"] {
            assert!(run(threads) == one, "{format} with {threads} threads");
        }
    }
}

#[test]
fn results_follow_the_order_of_the_input() {
    let folder = Folder::new("order").with("p.mech", PRESS).with("t.csv", &many(1000));
    let said = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--format", "csv"]);
    fine(&said);
    let numbers: Vec<String> = (1..=1000).map(|i| i.to_string()).collect();
    assert_eq!(column(&said.stdout, "row"), numbers);
    assert!(said.stderr.contains("p.mech: 1000 solved"), "{}", said.stderr);
}

#[test]
fn a_row_is_the_file_with_these_values() {
    let folder = Folder::new("set").with("p.mech", PRESS).with("t.csv", "r [cm],phi [deg]\n9.5,40\n11,250\n");
    let batch = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--format", "csv"]);
    fine(&batch);
    for (i, (r, phi)) in [("9.5cm", "40deg"), ("11cm", "250deg")].into_iter().enumerate() {
        let (r, phi) = (format!("r={r}"), format!("phi={phi}"));
        let alone = assur(&folder, &["solve", "p.mech", "--format", "csv", "--set", &r, "--set", &phi]);
        for name in ["x [mm]", "M [N*m]"] {
            assert_eq!(column(&batch.stdout, name)[i], column(&alone.stdout, name)[0]);
        }
    }
}

#[test]
fn what_is_set_replaces_the_row() {
    let folder = Folder::new("both").with("p.mech", PRESS).with("t.csv", "r [mm],P [N]\n90,10\n110,10\n");
    let args = ["batch", "p.mech", "--variants", "t.csv", "--format", "csv", "--set", "r=100mm"];
    let said = assur(&folder, &args);
    fine(&said);
    let x = column(&said.stdout, "x [mm]");
    assert_eq!(x[0], x[1]);
}

#[test]
fn broken_rows_stand_among_good_ones() {
    let table = "r [mm],l [mm]\n100,350\n900,350\n100,abc\n100\n100,350,1\n\"100,350\n-5,350\n100,350\n";
    let folder = Folder::new("broken").with("p.mech", PRESS);
    let mut bytes = table.as_bytes().to_vec();
    bytes.extend(b"100,\xff\n100,350\n");
    folder.write_bytes("t.csv", &bytes);
    let said = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--format", "csv"]);
    assert_eq!(said.status, 1);
    let x = column(&said.stdout, "x [mm]");
    let solved: Vec<usize> = (0..x.len()).filter(|i| !x[*i].is_empty()).map(|i| i + 1).collect();
    assert_eq!(solved, [1, 8, 10], "{}", said.stdout);
    for part in [
        "3 solved, 1 does not close: row 2",
        "5 cannot be read: rows 3, 4, 5, 6, 9",
        "failed (",
        "t.csv:4:5",
        "`abc` is not a number",
        "line 5, column 2: the value of `l` is missing",
        "line 6 has 3 cells",
        "row 2 (r = 900 mm, l = 350 mm)",
    ] {
        assert!(said.stderr.contains(part), "{part}: {}", said.stderr);
    }
    assert!(said.stdout.lines().nth(2).is_some_and(|l| l.contains("429.4 mm short")), "{}", said.stdout);
}

#[test]
fn spreadsheets_write_tables_in_many_ways() {
    let folder = Folder::new("dialects").with("p.mech", PRESS);
    let run = |table: &str| {
        folder.write_bytes("t.csv", table.as_bytes());
        let said = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--format", "csv"]);
        fine(&said);
        said.stdout
    };
    let plain = run("r [mm],l [mm]\n100.5,350\n99,340.25\n");
    for table in [
        "\u{feff}r [mm],l [mm]\r\n100.5,350\r\n99,340.25\r\n",
        "r [mm]; l [mm]\n100,5; 350\n\n99; 340,25\n;;\n",
        "\"r [mm]\",\"l [mm]\"\n\"100.5\", \"350\"\n99,340.25",
        "r [mm]\tl [mm]\n100,5\t350\n99\t340.25\n",
    ] {
        assert_eq!(column(&run(table), "x [mm]"), column(&plain, "x [mm]"), "{table}");
    }
}

#[test]
fn a_table_that_does_not_fit_is_told() {
    let folder = Folder::new("columns").with("p.mech", PRESS);
    for (table, status, says) in [
        ("q [mm]\n1\n", 1, "there is no given `q`"),
        ("r\n1\n", 1, "needs a unit"),
        ("r [kg]\n1\n", 1, "mass"),
        ("r [mm],r [mm]\n1,1\n", 1, "mech::name::duplicate"),
        ("r [mm\n1\n", 1, "mech::table::header"),
        ("r [mm]\n", 1, "mech::table::empty"),
        ("", 1, "mech::table::empty"),
    ] {
        folder.write_bytes("t.csv", table.as_bytes());
        let said = assur(&folder, &["batch", "p.mech", "--variants", "t.csv"]);
        assert_eq!(said.status, status, "{table}: {}", said.stderr);
        assert!(said.stderr.contains(says), "{table}: {}", said.stderr);
    }
    let said = assur(&folder, &["batch", "p.mech", "--variants", "no.csv"]);
    assert_eq!((said.status, said.stdout.as_str()), (2, ""));
    assert!(said.stderr.contains("there is no file or folder `no.csv`"), "{}", said.stderr);
}

#[test]
fn a_broken_file_spoils_no_other() {
    let folder = Folder::new("files").with("a.mech", PRESS).with("b.mech", "link\n").with("c.mech", PRESS);
    folder.write_bytes("d.mech", b"\xff");
    let said = assur(&folder, &["batch", "a.mech", "b.mech", "d.mech", "no", "c.mech", "--format", "csv"]);
    assert_eq!(said.status, 2);
    assert_eq!(column(&said.stdout, "file"), ["a.mech", "c.mech"]);
    for part in ["mech::syntax", "`d.mech` is not UTF-8 text", "no file or folder `no`", "2 files: 2 solved"]
    {
        assert!(said.stderr.contains(part), "{part}: {}", said.stderr);
    }
}

#[test]
fn files_of_different_columns_share_a_header() {
    let other = "given a = 2 mm\nfind b = 3*a\n";
    let folder = Folder::new("shared").with("a.mech", other).with("p.mech", PRESS);
    let said = assur(&folder, &["batch", "a.mech", "p.mech", "--format", "csv"]);
    fine(&said);
    assert_eq!(column(&said.stdout, "b [mm]"), ["6", ""]);
    let x = column(&said.stdout, "x [mm]");
    assert!(x[0].is_empty() && x[1].starts_with("389."), "{x:?}");
    assert!(rows(&said.stdout)[0].last().is_some_and(|h| h == "error"));
}

#[test]
fn a_file_is_whole_or_as_it_was() {
    let folder =
        Folder::new("out").with("p.mech", PRESS).with("old.csv", "what stood here").with("t.csv", &many(5));
    let said = assur(&folder, &["batch", "p.mech", "--out", "no/such/folder/a.csv"]);
    assert_eq!(said.status, 2);
    assert!(said.stderr.contains("there is no folder `no/such/folder`"), "{}", said.stderr);
    let said = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--out", "t.csv"]);
    assert_eq!(said.status, 2);
    assert!(said.stderr.contains("both an input and the output"), "{}", said.stderr);
    assert_eq!(folder.read("t.csv"), many(5));
    let said = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--out", "old.csv"]);
    fine(&said);
    assert_eq!((said.stdout.as_str(), rows(&folder.read("old.csv")).len()), ("", 6));
    assert_eq!(folder.names(), ["old.csv", "p.mech", "t.csv"], "nothing is left over");
}

#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_told() {
    let folder = Folder::new("full").with("p.mech", PRESS).with("t.csv", &many(2000));
    let said =
        assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--format", "csv", "--out", "/dev/full"]);
    assert_eq!(said.status, 2);
    assert!(said.stderr.contains("cannot be written: No space left"), "{}", said.stderr);
}

#[cfg(unix)]
#[test]
fn an_interrupt_leaves_whole_rows() {
    let folder =
        Folder::new("interrupt").with("p.mech", PRESS).with("old.csv", "old").with("t.csv", &many(400_000));
    let child = run::start(&folder, &["batch", "p.mech", "--variants", "t.csv", "--out", "old.csv"]);
    let begun = |name: &String| {
        let size = std::fs::metadata(folder.path(name)).map_or(0, |file| file.len());
        !["p.mech", "old.csv", "t.csv"].contains(&name.as_str()) && size > 10_000
    };
    let (start, most) = (std::time::Instant::now(), std::time::Duration::from_secs(10));
    while start.elapsed() < most && !folder.names().iter().any(begun) {
        std::thread::sleep(std::time::Duration::from_millis(5));
    }
    let id = child.id().to_string();
    assert!(std::process::Command::new("kill").args(["-INT", &id]).status().unwrap().success());
    let said = run::end(child);
    assert_eq!(said.status, 130, "{}", said.stderr);
    assert!(said.stderr.contains("interrupted after"), "{}", said.stderr);
    assert_eq!(folder.read("old.csv"), "old");
    let part = folder.read("old.csv.part");
    assert!(part.ends_with("\r\n"));
    let rows = rows(&part);
    assert!(rows.iter().all(|r| r.len() == rows[0].len()));
    assert_eq!(rows.last().unwrap()[0], (rows.len() - 1).to_string());
}

const TABLE: &str = "expect x = x_key within 1e-9
variants {
  r [mm], l [mm], phi [deg], x_key [mm]
  100, 400, 90, 387.29833462074168852
  300, 500, 90, 400
  100, 50, 90, 400
}
";

#[test]
fn rows_of_a_file_are_solved_and_tested() {
    let text = PRESS.to_owned() + TABLE;
    let folder = Folder::new("own").with("p.mech", &text);
    let said = assur(&folder, &["test", "p.mech"]);
    assert_eq!(said.status, 1);
    assert_eq!(said.stdout, "p.mech: 2 expectations met, 1 row not solved, 1 error in 3 rows\n");
    assert!(
        said.stderr.contains("row 3 (r = 100 mm, l = 50 mm, phi = 90 deg, x_key = 400 mm)"),
        "{}",
        said.stderr
    );
    let said = assur(&folder, &["solve", "p.mech", "--format", "csv"]);
    assert_eq!(column(&said.stdout, "x [mm]"), ["387.298334620742", "400", ""]);
    let said = assur(&folder, &["solve", "p.mech"]);
    assert!(
        said.stdout.contains("row 2 (r = 300 mm, l = 500 mm, phi = 90 deg, x_key = 400 mm)"),
        "{}",
        said.stdout
    );
    let said = assur(&folder, &["solve", "p.mech", "--format", "json"]);
    assert_eq!(said.stdout.lines().count(), 3);
    assert!(said.stdout.contains("\"variant\":{\"row\":2,\"values\":{\"r\":0.3,"), "{}", said.stdout);
    let wrong = text.replace("90, 400", "90, 401");
    folder.write_bytes("p.mech", wrong.as_bytes());
    let said = assur(&folder, &["test", "p.mech"]);
    assert_eq!(said.stdout, "p.mech: 1 expectation met, 1 failed, 1 row not solved, 1 error in 3 rows\n");
}

#[test]
fn a_key_column_gives_the_tolerance_by_its_digits() {
    let table =
        "expect x = x_key\nvariants {\n  phi [deg], x_key [mm]\n  90, 335.4\n  90, 335.41\n  90, 335.3\n}\n";
    let folder = Folder::new("digits").with("p.mech", &(PRESS.to_owned() + table));
    // x = sqrt(350² − 100²) = 335.410 mm
    let said = assur(&folder, &["test", "p.mech"]);
    assert!(said.stdout.contains("2 expectations met, 1 failed in 3 rows"), "{}{}", said.stdout, said.stderr);
}

fn exercise_set(args: &[&str]) -> Said {
    run::assur_in(Path::new(env!("CARGO_MANIFEST_DIR")), args)
}

#[test]
fn the_key_of_the_exercise_set_is_what_it_was() {
    let folder = Folder::new("set-key");
    let key = folder.path("key.csv");
    let said = exercise_set(&["batch", "examples/exercise-set", "--key", &key, "--format", "csv"]);
    fine(&said);
    assert!(said.stderr.ends_with("25 files: 75 solved\n"), "{}", said.stderr);
    let stated = "examples/exercise-set/key.csv";
    let written = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join(stated)).unwrap();
    // the last digits may change with the arithmetic
    let (now, then) = (rows(&folder.read("key.csv")), rows(&written));
    assert_eq!(now.len(), then.len());
    for (a, b) in now.iter().flatten().zip(then.iter().flatten()) {
        let same = match (a.parse::<f64>(), b.parse::<f64>()) {
            (Ok(a), Ok(b)) => (a - b).abs() <= 1e-9 * b.abs().max(1.0),
            _ => a == b,
        };
        assert!(same, "{a}, and {b} in {stated}");
    }
    let said = exercise_set(&["grade", stated, stated]);
    assert_eq!(said.status, 0, "{}{}", said.stdout, said.stderr);
    let said = exercise_set(&["test", "examples/exercise-set"]);
    assert_eq!(said.status, 0);
    let total = "total: 25 files, 75 rows, 213 expectations met, 0 failed";
    assert_eq!(said.stdout.lines().last(), Some(total));
}

#[test]
fn rows_have_names_of_their_own() {
    let folder =
        Folder::new("variant").with("p.mech", PRESS).with("t.csv", "variant,r [mm]\nA-7,100\n\"B, 2\",90\n");
    let args = ["batch", "p.mech", "--variants", "t.csv", "--format", "csv", "--key", "key.csv"];
    let said = assur(&folder, &args);
    fine(&said);
    assert!(said.stdout.contains("\r\n2,\"B, 2\",90,"), "{}", said.stdout);
    folder.write_bytes("a.csv", b"variant,x [mm]\nA-7,389.1\n");
    let said = assur(&folder, &["grade", "key.csv", "a.csv", "--only-answered"]);
    assert!(said.stdout.contains("1 of 1 right"), "{}{}", said.stdout, said.stderr);
}

#[test]
fn a_build_without_columns_says_so() {
    if cfg!(feature = "parquet") {
        return;
    }
    let folder = Folder::new("no_columns").with("p.mech", PRESS).with("t.parquet", "");
    for args in [["--variants", "t.parquet"], ["--out", "a.parquet"]] {
        let said = assur(&folder, &[&["batch", "p.mech"][..], &args].concat());
        assert_eq!((said.status, said.stdout.as_str()), (2, ""), "{args:?}");
        assert!(said.stderr.contains("`cargo install --path . --features parquet`"), "{}", said.stderr);
    }
    assert_eq!(folder.names(), ["p.mech", "t.parquet"]);
}

#[test]
fn a_key_is_comma_separated() {
    let folder = Folder::new("key").with("p.mech", PRESS).with("t.csv", &many(3));
    for name in ["key.arrow", "key.parquet"] {
        let said = assur(&folder, &["batch", "p.mech", "--variants", "t.csv", "--key", name]);
        assert_eq!((said.status, said.stdout.as_str()), (2, ""), "{name}");
        let why = format!("`{name}` cannot be written: an answer key is comma-separated values");
        assert!(said.stderr.contains(&why), "{}", said.stderr);
        assert!(!Path::new(&folder.path(name)).exists());
    }
}

/// Where no further thread can be had, one does the work. The limit does not hold for root, so that the program runs as another.
#[cfg(target_os = "linux")]
#[test]
fn without_threads_a_batch_goes_on_with_one() {
    let folder = Folder::new("batch-threads").with("press.mech", PRESS).with("rows.csv", &many(50));
    let args = ["batch", "press.mech", "--variants", "rows.csv", "--threads", "8"];
    let whole = assur(&folder, &args);
    // the program where everyone may run it
    std::fs::copy(env!("CARGO_BIN_EXE_assur"), folder.path("assur")).unwrap();
    let mut limited = std::process::Command::new("setpriv");
    limited.current_dir(folder.path("")).args(["--reuid", "65534", "--clear-groups", "prlimit", "--nproc=1"]);
    let Ok(out) = limited.arg(folder.path("assur")).args(args).output() else { return };
    let said = String::from_utf8_lossy(&out.stderr);
    // where nobody else may run it here nothing is tested
    if out.status.code() == Some(0) || said.contains("thread") {
        assert!(said == whole.stderr && out.stdout == whole.stdout.as_bytes(), "{said}");
    }
}

/// To be read each file has a table of its own columns below its name, which no line repeats.
#[test]
fn files_to_read_have_a_table_each() {
    let long = "a_long_name_of_a_folder/with_another_long_name_below_it_that_takes_a_line";
    let (a, b) = (format!("{long}/a.mech"), format!("{long}/b.mech"));
    let other = PRESS.replace("find ", "find twice = 2*r, ");
    let folder = Folder::new("batch-names").with(&a, PRESS).with(&b, &other);
    for format in ["table", "markdown", "latex", "typst"] {
        let said = assur(&folder, &["batch", "a_long_name_of_a_folder", "--format", format]);
        assert_eq!(said.status, 0, "{}", said.stderr);
        assert_eq!(said.stdout.matches("a.mech").count(), 1, "{format}: {}", said.stdout);
        assert_eq!(said.stdout.matches("b.mech").count(), 1, "{format}: {}", said.stdout);
        let (first, second) = said.stdout.split_once("b.mech").unwrap();
        assert!(!first.contains("twice") && second.contains("twice"), "{format}: {}", said.stdout);
    }
    let lines = assur(&folder, &["batch", "a_long_name_of_a_folder", "--format", "csv"]).stdout;
    assert!(lines.starts_with("file,row,") && lines.contains(&format!("{a},1,")), "{lines}");
}
