//! The flags that chose a method before each method was a subcommand. They work for one release, with a hint.

use std::ffi::OsString;

/// Each flag, and whether it had a value, which is the first argument of its subcommand.
const FLAGS: [(&str, bool); 11] = [
    ("lint", false),
    ("fuzz", true),
    ("coverage", false),
    ("programs", true),
    ("mutants", true),
    ("campaign", false),
    ("exhaustive", false),
    ("faults", false),
    ("formal", false),
    ("placed", false),
    ("table", false),
];

/// The words of a command line with the method of `verify` as a subcommand, and a hint where it was a flag.
///
/// `verify` without a method is `verify equivalence`. Other command lines are returned as they are.
pub fn with_method(mut words: Vec<OsString>) -> (Vec<OsString>, Option<String>) {
    let is_plain = |word: &OsString| word != "--json";
    let Some(verify) = (1..words.len()).find(|&at| is_plain(&words[at])) else {
        return (words, None);
    };
    if words[verify] != "verify" {
        return (words, None);
    }
    let flag = (verify + 1..words.len()).find_map(|at| Some((at, flag(&words[at])?)));
    if let Some((at, (name, mut value))) = flag {
        let takes_value = FLAGS.contains(&(name, true));
        words.remove(at);
        if takes_value && value.is_none() && at < words.len() {
            value = Some(words.remove(at));
        }
        let hint = hint(name, value.as_ref());
        let method = [OsString::from(name)].into_iter().chain(value);
        words.splice(verify + 1..verify + 1, method);
        return (words, Some(hint));
    }
    let first = words[verify + 1..].iter().find(|word| is_plain(word));
    let first = first.map(|word| word.to_string_lossy());
    if first.is_none_or(|first| first.starts_with('-') && first != "-h" && first != "--help") {
        words.insert(verify + 1, "equivalence".into());
    }
    (words, None)
}

/// The method that a word chose, and the value in the word.
fn flag(word: &OsString) -> Option<(&'static str, Option<OsString>)> {
    let word = word.to_str()?.strip_prefix("--")?;
    let (name, value) = match word.split_once('=') {
        Some((name, value)) => (name, Some(value.into())),
        None => (word, None),
    };
    let mut names = FLAGS.iter().map(|flag| flag.0);
    Some((names.find(|known| *known == name)?, value))
}

fn hint(name: &str, value: Option<&OsString>) -> String {
    let value = value.map_or(String::new(), |value| {
        format!(" {}", value.to_string_lossy())
    });
    format!(
        "hint: `verify --{name}{value}` is now `verify {name}{value}`; the flag goes with the next release"
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(line: &str) -> (String, Option<String>) {
        let words = line.split(' ').map(OsString::from).collect();
        let (words, hint) = with_method(words);
        let words: Vec<_> = words.iter().map(|word| word.to_string_lossy()).collect();
        (words.join(" "), hint)
    }

    #[test]
    fn a_flag_becomes_a_subcommand_with_a_hint() {
        for (old, new) in [
            ("p verify --lint", "p verify lint"),
            (
                "p verify --machine x --formal --json",
                "p verify formal --machine x --json",
            ),
            (
                "p --json verify --mutants 7 --seed 2",
                "p --json verify mutants 7 --seed 2",
            ),
            ("p verify --seed 2 --fuzz=9", "p verify fuzz 9 --seed 2"),
            ("p verify --programs", "p verify programs"),
        ] {
            let (words, hint) = read(old);
            assert_eq!(words, new);
            assert!(hint.unwrap().contains("is now `verify "), "{old}");
            assert_eq!(read(new), (new.to_owned(), None));
        }
        let hint = read("p verify --mutants 7").1.unwrap();
        assert!(
            hint.contains("`verify --mutants 7` is now `verify mutants 7`"),
            "{hint}"
        );
    }

    #[test]
    fn without_a_method_verify_is_equivalence() {
        for (given, read_as) in [
            ("p verify", "p verify equivalence"),
            ("p verify --json", "p verify equivalence --json"),
            ("p verify --seed 2", "p verify equivalence --seed 2"),
            (
                "p verify --machine x lint",
                "p verify equivalence --machine x lint",
            ),
            ("p verify --help", "p verify --help"),
            ("p verify --json lint", "p verify --json lint"),
            ("p verify lnit", "p verify lnit"),
            ("p list --lint", "p list --lint"),
            ("p --json", "p --json"),
        ] {
            assert_eq!(read(given), (read_as.to_owned(), None));
        }
    }
}
