//! Digests of Verilog texts. A recorded result names the text that it is about by its digest.

use std::fmt::Write;

use sha2::{Digest, Sha256};

/// SHA-256 of the concatenated texts, without lines that contain only a `//` comment, in hexadecimal digits.
/// A comment changes nothing that is measured or verified.
pub(crate) fn sha256<'a>(texts: impl IntoIterator<Item = &'a str>) -> String {
    let lines = texts.into_iter().flat_map(str::lines);
    let mut digest = Sha256::new();
    for line in lines.filter(|line| !line.trim_start_matches(' ').starts_with("//")) {
        digest.update(line);
        digest.update("\n");
    }
    digest
        .finalize()
        .iter()
        .fold(String::new(), |mut text, byte| {
            write!(text, "{byte:02x}").expect("a string takes all that is written to it");
            text
        })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_digest_is_that_of_sha256sum() {
        let empty = "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855";
        assert_eq!(sha256([]), empty);
        // printf 'module m;\nendmodule\n' | sha256sum
        let module = "bdd0e365f10b743d5ed41e927b135ffcd369723ffc717983faa285bc84ef14b5";
        assert_eq!(sha256(["module m;\nendmodule\n"]), module);
    }

    #[test]
    fn only_comment_lines_do_not_count() {
        let bare = sha256(["assign a = b;\n"]);
        assert_eq!(
            sha256(["// a comment\n  // another\nassign a = b;\n"]),
            bare
        );
        assert_ne!(sha256(["assign a = b; // behind\n"]), bare);
        assert_ne!(sha256(["assign a = c;\n"]), bare);
    }
}
