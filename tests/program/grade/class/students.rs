//! A class and its table of answers, and what each student was made to do.

use std::collections::BTreeSet;
use std::fmt::Write;

const STUDENTS: usize = 200;
const VARIANTS: usize = 10;
const HEADER: &str =
    "Student;E-mail;problem;variant;pose;Mb [N*m];Fx [N];phi [deg];z [mm];locks;Remarks, if any;";
/// The points of the quantities in eighths, per problem.
pub const POINTS: [[i64; 5]; 2] = [[16, 8, 8, 4, 0], [24, 0, 0, 0, 8]];

/// What a student does with a question.
#[derive(Clone, Copy, PartialEq)]
pub enum Deed {
    Right,
    Sign,
    Unit,
    Wrong,
    Nothing,
    Nonsense,
}

/// A line of answers.
pub struct Line {
    pub number: usize,
    pub student: String,
    pub problem: usize,
    pub pose: usize,
    pub deeds: [Deed; 5],
}

/// A generator of its own: the same class on every machine.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % n
    }

    fn one_in(&mut self, n: u64) -> bool {
        self.below(n) == 0
    }

    fn deed(&mut self, quantity: usize) -> Deed {
        match (self.below(10), quantity) {
            (0, 0..=2) => Deed::Sign,
            (1, 0..=2) => Deed::Unit,
            (2 | 3, _) => Deed::Wrong,
            (4, _) => Deed::Nothing,
            (5, _) => Deed::Nonsense,
            _ => Deed::Right,
        }
    }
}

/// The key: Mb, Fx, phi, z of the engine at two positions, Mb and a condition of the press.
fn key(problem: usize, variant: usize, pose: usize) -> [f64; 4] {
    let (v, p) = (f64::from(u32::try_from(variant).unwrap()), f64::from(u32::try_from(pose).unwrap()));
    match problem {
        0 => [20.0 + 3.0 * v + p, -(300.0 + 10.0 * v), 20.0 + 4.0 * v + p, 0.0],
        _ => [150.0 + 7.0 * v, 0.0, 0.0, 0.0],
    }
}

/// The key with its points.
pub fn key_file() -> String {
    let mut text = "file,row,variant,pose,Mb [N*m],Fx [N],phi [deg],z [mm],locks\r\n".to_owned();
    text += "set/engine.mech,points,,,2,1,1,0.5,\r\nset/press.mech,points,,,3,,,,1\r\n";
    for v in 0..VARIANTS {
        for pose in [1, 2] {
            let [m, f, phi, z] = key(0, v, pose);
            write!(text, "set/engine.mech,{},V-{v},{pose},{m},{f},{phi},{z},\r\n", v + 1).unwrap();
        }
        write!(text, "set/press.mech,{},V-{v},1,{},,,,true\r\n", v + 1, key(1, v, 1)[0]).unwrap();
    }
    text
}

/// A cell as a spreadsheet with decimal commas writes it.
fn cell(deed: Deed, quantity: usize, key: f64, chance: &mut Chance) -> String {
    let number = |x: f64| format!("{x:.5}").replace('.', ",");
    let rad = std::f64::consts::PI / 180.0;
    match (deed, quantity) {
        (Deed::Nothing, _) => ["", " ", "-", "\"\""][usize::try_from(chance.below(4)).unwrap()].to_owned(),
        (Deed::Nonsense, _) => {
            let long = format!("\"{}\"", "9; ".repeat(20_000));
            let all =
                ["=1+1", "@SUM(A1)", "about 3", "\u{1b}[2J", "1e999", "+cmd|' /C calc'!A0", "1,2,3", &long];
            all[usize::try_from(chance.below(8)).unwrap()].to_owned()
        }
        (Deed::Right, 4) => "true".to_owned(),
        (_, 4) => "false".to_owned(),
        (Deed::Right, 3) => "0".to_owned(),
        (_, 3) => "0,7".to_owned(),
        (Deed::Right, _) => number(key * [1.0, 1.02, 0.98][usize::try_from(chance.below(3)).unwrap()]),
        (Deed::Sign, _) => number(-key),
        (Deed::Unit, 2) => number(key * rad),
        (Deed::Unit, _) => number(key * 1000.0),
        _ => number(key * 1.37),
    }
}

fn name(i: usize) -> (String, String) {
    let long = "x".repeat(3000);
    // as written, and as it comes out in a spreadsheet
    match i {
        3 => ("=1+1".to_owned(), "'=1+1".to_owned()),
        4 => ("\u{1b}[2JEve".to_owned(), "\\u{1b}[2JEve".to_owned()),
        5 => ("@SUM(1)".to_owned(), "'@SUM(1)".to_owned()),
        6 => ("\"Berg; \"\"B\"\" Anna\"".to_owned(), "Berg; \"B\" Anna".to_owned()),
        7 => (long.clone(), long),
        8 => ("\u{202e}nhoJ".to_owned(), "\\u{202e}nhoJ".to_owned()),
        9 => ("Zo\u{65}\u{301}  Ås".to_owned(), "Zo\u{e9} Ås".to_owned()),
        _ => (format!("Student {i:03}"), format!("Student {i:03}")),
    }
}

/// The table of a class.
pub struct Class {
    /// The table.
    pub bytes: Vec<u8>,
    /// Lines that can be marked.
    pub lines: Vec<Line>,
    /// Lines that cannot be.
    pub bad: BTreeSet<usize>,
    /// All who are named in a line that can be divided into cells.
    pub students: Vec<String>,
    number: usize,
    chance: Chance,
}

impl Class {
    pub fn new() -> Self {
        let bytes = format!("\u{feff}{HEADER}\r\n").into_bytes();
        let chance = Chance(2026);
        let mut class =
            Self { bytes, lines: Vec::new(), bad: BTreeSet::new(), students: Vec::new(), number: 1, chance };
        for i in 0..STUDENTS {
            class.student(i);
            if i % 9 == 4 {
                class.hostile(i);
            }
        }
        class
    }

    fn write(&mut self, line: &[u8]) {
        self.bytes.extend_from_slice(line);
        self.bytes.extend_from_slice(if self.number.is_multiple_of(3) { b"\n" } else { b"\r\n" });
        self.number += 1;
    }

    fn named(&mut self, student: &str) {
        if !self.students.iter().any(|s| s == student) {
            self.students.push(student.to_owned());
        }
    }

    fn student(&mut self, i: usize) {
        let (written, student) = name(i);
        let variant = i % VARIANTS;
        if self.chance.one_in(25) {
            // a variant that does not exist, and nothing else
            self.write(format!("{written};;engine;X-{i};1;1;2;3;4;;;").as_bytes());
            self.bad.insert(self.number);
            self.named(&student);
            return;
        }
        let mut tasks = vec![(0, 1), (0, 2), (1, 1)];
        if self.chance.one_in(6) {
            // hands in a part
            tasks.remove(usize::try_from(self.chance.below(3)).unwrap());
        }
        if self.chance.one_in(4) {
            let again =
                tasks[usize::try_from(self.chance.below(u64::try_from(tasks.len()).unwrap())).unwrap()];
            tasks.push(again);
        }
        for (problem, pose) in tasks {
            self.task(&written, &student, problem, variant, pose);
        }
    }

    fn task(&mut self, written: &str, student: &str, problem: usize, variant: usize, pose: usize) {
        let mut deeds = [Deed::Nothing; 5];
        let keys = key(problem, variant, pose);
        let mut cells = Vec::new();
        for (quantity, deed) in deeds.iter_mut().enumerate() {
            if POINTS[problem][quantity] == 0 {
                // what is not asked may be written all the same
                cells.push(if self.chance.one_in(5) { "7".to_owned() } else { String::new() });
                continue;
            }
            *deed = self.chance.deed(quantity);
            cells.push(cell(*deed, quantity, keys[quantity.min(3)], &mut self.chance));
        }
        let problems = [["engine", "ENGINE.mech", "set/engine.mech"], ["press", "press.mech", "Press"]];
        let problem_name = problems[problem][usize::try_from(self.chance.below(3)).unwrap()];
        let letter = if self.chance.one_in(2) { 'V' } else { 'v' };
        let line = format!(
            "{written};a@b.example;{problem_name};{letter}-{variant};{pose};{};=remark;",
            cells.join(";")
        );
        self.write(line.as_bytes());
        let number = self.number;
        self.named(student);
        self.lines.push(Line { number, student: student.to_owned(), problem, pose, deeds });
    }

    /// A line that nothing can be made of.
    fn hostile(&mut self, i: usize) {
        let megabytes = format!("Mallory;;engine;V-1;1;{};1", "1".repeat(3 << 20));
        let line: Vec<u8> = match i / 9 % 9 {
            0 => b";;;;;;;;;".to_vec(),
            1 => Vec::new(),
            2 => b";;engine;V-1;1;1;2;3;4;;;".to_vec(),
            3 => b"Mallory;;engine;V-1;1;\"1;2;3;4;;;".to_vec(),
            4 => b"Mallory;;engine;V-1;1;1;2;3;4;5;6;7;8".to_vec(),
            5 => b"M\xfcller;;engine;V-1;1;1;2;3;4;;;".to_vec(),
            6 => megabytes.into_bytes(),
            7 => b"  ".to_vec(),
            _ => b"=cmd|' /C calc'!A0".to_vec(),
        };
        let blank = line.iter().all(|b| matches!(b, b' ' | b';'));
        self.write(&line);
        if !blank {
            self.bad.insert(self.number);
        }
        if line.starts_with(b"=cmd") {
            self.named("'=cmd|' /C calc'!A0");
        }
    }
}
