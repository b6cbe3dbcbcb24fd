//! Symbols from the numbers of links.

use assur::internals::model::{Link, LinkId, Mechanism};
use assur::internals::report::symbols::Symbols;

fn symbols(numbers: &[Option<&str>]) -> Vec<Option<String>> {
    let link = |n: &Option<&str>| Link { number: n.map(str::to_owned), ..Link::default() };
    let mechanism = Mechanism { links: numbers.iter().map(link).collect(), ..Mechanism::default() };
    let symbols = Symbols::of(&mechanism);
    (1..numbers.len()).map(|on| symbols.reaction(LinkId::GROUND, LinkId::at(on))).collect()
}

#[test]
fn the_ground_is_0_unless_another_link_is() {
    let some = |text: &str| Some(text.to_owned());
    assert_eq!(symbols(&[None, Some("1"), Some("12"), None]), [some("R01"), some("R0,12"), None]);
    assert_eq!(symbols(&[Some("4"), Some("1")]), [some("R41")]);
    assert_eq!(symbols(&[None, Some("0")]), [None]);
}
