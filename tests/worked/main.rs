//! Worked solutions: every printed equation is read back from the page and from Markdown, and evaluated from its digits.

#[path = "../folder/mod.rs"]
mod folder;
#[allow(dead_code, reason = "solutions need no reference solution")]
#[path = "../mechanics/support/mod.rs"]
mod support;

#[path = "../pictures/xml.rs"]
mod xml;

#[allow(dead_code, reason = "the pictures of solutions are a few kinds")]
#[path = "../pictures/drawn.rs"]
mod drawn;

mod documents;
mod examples;
mod formulas;
mod frames;
mod friction;
mod given;
mod held;
mod kept;
mod languages;
mod made;
mod random;
mod reader;
#[path = "../share/mod.rs"]
mod share;
mod sheets;
