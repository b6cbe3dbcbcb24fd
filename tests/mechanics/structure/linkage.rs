//! Random linkages as plain data, and their text.

use crate::support::random::Random;
use std::fmt::Write;

/// Links by number, 0 for the ground.
#[derive(Clone, Debug, Default)]
pub struct Linkage {
    pub links: Vec<bool>,
    pub pairs: Vec<Pair>,
    /// Links whose angle is driven.
    pub drives: Vec<usize>,
    /// Pairs there have been.
    numbers: usize,
}

#[derive(Clone, Debug)]
pub struct Pair {
    /// Its number: `P7` names the pair, its points and its line.
    pub number: usize,
    pub kind: Kind,
}

#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Two links or more.
    Revolute(Vec<usize>),
    Prismatic(usize, usize),
    /// A point of the first on a line of the second.
    Slot(usize, usize),
}

impl Pair {
    pub fn name(&self) -> String {
        format!("P{}", self.number)
    }

    pub fn word(&self) -> &'static str {
        match self.kind {
            Kind::Revolute(_) => "revolute",
            Kind::Prismatic(..) => "prismatic",
            Kind::Slot(..) => "slot",
        }
    }

    pub fn links(&self) -> Vec<usize> {
        match &self.kind {
            Kind::Revolute(links) => links.clone(),
            Kind::Prismatic(a, b) | Kind::Slot(a, b) => vec![*a, *b],
        }
    }
}

pub fn link_name(link: usize) -> String {
    if link == 0 { "ground".into() } else { format!("L{link}") }
}

impl Linkage {
    /// The ground, and a crank for every drive.
    pub fn with_cranks(drives: usize) -> Self {
        let mut this = Self { links: vec![true], ..Self::default() };
        for _ in 0..drives {
            let crank = this.add_link();
            this.add(Kind::Revolute(vec![0, crank]));
            this.drives.push(crank);
        }
        this
    }

    pub fn add_link(&mut self) -> usize {
        self.links.push(true);
        self.links.len() - 1
    }

    pub fn add(&mut self, kind: Kind) -> usize {
        let number = self.numbers;
        self.numbers += 1;
        self.pairs.push(Pair { number, kind });
        number
    }

    /// A structural group on links that there are: a dyad, a link between slots, or a triad.
    pub fn add_group(&mut self, random: &mut Random) {
        let count = self.links.len();
        let base = |random: &mut Random| random.below(count);
        match random.below(8) {
            0..3 => {
                let (a, b) = (base(random), base(random));
                let (i, k) = (self.add_link(), self.add_link());
                self.hinge(a, i, random);
                self.hinge(b, k, random);
                self.add(Kind::Revolute(vec![i, k]));
            }
            3 => {
                let (a, b) = (base(random), base(random));
                let (i, k) = (self.add_link(), self.add_link());
                self.hinge(a, i, random);
                self.add(Kind::Revolute(vec![i, k]));
                self.slide(k, b, random);
            }
            4 => {
                let (a, b) = (base(random), base(random));
                let (i, k) = (self.add_link(), self.add_link());
                self.hinge(a, i, random);
                self.slide(i, k, random);
                self.hinge(b, k, random);
            }
            5 => {
                let (a, b) = (base(random), base(random));
                let i = self.add_link();
                self.hinge(a, i, random);
                self.rest(i, b, random);
            }
            6 => {
                let bases = [base(random), base(random), base(random)];
                let i = self.add_link();
                for b in bases {
                    self.rest(i, b, random);
                }
            }
            _ => {
                let bases = [base(random), base(random), base(random)];
                let plate = self.add_link();
                for b in bases {
                    let leg = self.add_link();
                    self.hinge(b, leg, random);
                    self.add(Kind::Revolute(vec![leg, plate]));
                }
            }
        }
    }

    /// A hinge of a new link, now and then on a pin that there is.
    fn hinge(&mut self, base: usize, new: usize, random: &mut Random) {
        let on_base = |p: &&mut Pair| matches!(&p.kind, Kind::Revolute(links) if links.contains(&base));
        let pin = self.pairs.iter_mut().filter(on_base).find(|_| random.chance(0.3));
        if let Some(Pair { kind: Kind::Revolute(links), .. }) = pin {
            links.push(new);
            return;
        }
        self.add(Kind::Revolute(vec![base, new]));
    }

    fn slide(&mut self, a: usize, b: usize, random: &mut Random) {
        self.add(if random.chance(0.5) { Kind::Prismatic(a, b) } else { Kind::Prismatic(b, a) });
    }

    fn rest(&mut self, a: usize, b: usize, random: &mut Random) {
        self.add(if random.chance(0.5) { Kind::Slot(a, b) } else { Kind::Slot(b, a) });
    }

    /// A pair between any two links.
    pub fn add_any(&mut self, random: &mut Random) -> usize {
        let a = random.below(self.links.len());
        let b = (a + 1 + random.below(self.links.len() - 1)) % self.links.len();
        match random.below(4) {
            0 => self.add(Kind::Slot(a, b)),
            1 => self.add(Kind::Prismatic(a, b)),
            _ => self.add(Kind::Revolute(vec![a, b])),
        }
    }

    pub fn without_pair(&self, number: usize) -> Self {
        let mut out = self.clone();
        out.pairs.retain(|p| p.number != number);
        out
    }

    pub fn without_link(&self, link: usize) -> Self {
        let mut out = self.clone();
        out.links[link] = false;
        out.pairs.retain_mut(|p| match &mut p.kind {
            Kind::Revolute(links) => {
                links.retain(|l| *l != link);
                links.len() > 1
            }
            Kind::Prismatic(a, b) | Kind::Slot(a, b) => *a != link && *b != link,
        });
        out
    }

    /// Its text. Every pair has points and lines of its own, at random places; those of a pair that is left out stay.
    pub fn text(&self, places: &[Pair], random: &mut Random) -> String {
        let mut text = "mech 1\nmechanism \"random\"\n".to_owned();
        let mut place = || {
            let mut number = || random.within(-300.0, 300.0).round();
            format!("({} mm, {} mm)", number(), number())
        };
        for (link, _) in self.links.iter().enumerate().filter(|(_, there)| **there) {
            let mut members = Vec::new();
            for pair in places.iter().filter(|p| p.links().contains(&link)) {
                let name = pair.name();
                members.push(format!("{name} {}", place()));
                let direction = pair.number * 37 % 180;
                match pair.kind {
                    Kind::Prismatic(..) => {
                        members.push(format!("line l{name} through {name} along {direction} deg"));
                    }
                    Kind::Slot(_, guide) if guide == link => {
                        members.push(format!("line l{name} through {name} along {direction} deg"));
                    }
                    _ => {}
                }
            }
            let head = if link == 0 { "ground".to_owned() } else { format!("link {}", link_name(link)) };
            writeln!(text, "{head} {{ {} }}", members.join("; ")).expect("a text");
        }
        for pair in &self.pairs {
            let (word, name) = (pair.word(), pair.name());
            let ends = match &pair.kind {
                Kind::Revolute(links) => links.iter().map(|l| link_name(*l)).collect::<Vec<_>>().join(" - "),
                Kind::Prismatic(a, b) => format!("{}.l{name} - {}.l{name}", link_name(*a), link_name(*b)),
                Kind::Slot(a, b) => format!("{}.{name} - {}.l{name}", link_name(*a), link_name(*b)),
            };
            writeln!(text, "{word} {name}: {ends}").expect("a text");
        }
        for (i, drive) in self.drives.iter().enumerate() {
            writeln!(text, "drive {} = {} deg", link_name(*drive), 10 + 20 * i).expect("a text");
        }
        text
    }
}
