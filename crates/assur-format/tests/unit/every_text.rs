//! What holds for every text of the repository.

use crate::texts::{all, check, formatted};

#[test]
fn only_blanks_change() {
    let texts = all();
    assert!(texts.len() > 500, "{} texts", texts.len());
    for (name, text) in texts {
        check(&name, &text);
    }
}

#[test]
fn line_ends_stay() {
    for (name, text) in all() {
        let text = text.replace("\r\n", "\n");
        if text.contains('\n') {
            let with_returns = text.replace('\n', "\r\n");
            assert_eq!(formatted(&with_returns), formatted(&text).replace('\n', "\r\n"), "{name}");
        }
    }
}
