//! A reply where the program itself fails.

use assur::internals::cli::args::Args;
use assur::internals::cli::reply::{Status, guarded};
use assur::internals::cli::screen::Screen;
use assur::internals::source::Source;
use clap::Parser;

#[test]
fn an_error_of_our_own_is_reported() {
    let source = Source::new("a.mech", "");
    let args = Args::try_parse_from(["assur", "check", "a.mech", "--color=never"]).unwrap();
    let reply = guarded(&source, &Screen::new(&args), |_| panic!("out of luck"));
    assert_eq!(reply.status, Status::Unusable);
    let (said, version) = (reply.diagnostics, env!("CARGO_PKG_VERSION"));
    for part in ["internal error", "a.mech", "out of luck", version] {
        assert!(said.contains(part), "{part}: {said}");
    }
}
