//! The nearest of a list of known names, for errors about unknown names.

/// Letters of the longer name for each slip that is allowed: one slip in `red`, two in `stream`. The Rust
/// compiler uses this rule for unknown names. At least one letter must be right.
const LETTERS_A_SLIP: usize = 3;

/// Returns ` (did you mean `NAME`?)` with the [`nearest`] name of `known`, or an empty string where none is near.
#[must_use]
pub fn did_you_mean<'a>(found: &str, known: impl IntoIterator<Item = &'a str>) -> String {
    nearest(found, known).map_or_else(String::new, |name| format!(" (did you mean `{name}`?)"))
}

/// Returns the name of `known` that is the fewest slips away from `found`; `None` where no name is near. A slip is a letter too
/// many, too few, wrong, or two letters in the wrong order. Case is ignored.
#[must_use]
pub fn nearest<'a>(found: &str, known: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let found = found.to_lowercase();
    let length = found.chars().count();
    let slips = |name: &str| strsim::damerau_levenshtein(&found, &name.to_lowercase());
    let is_near = |&(name, slips): &(&str, usize)| {
        let longer = length.max(name.chars().count()).max(LETTERS_A_SLIP);
        slips <= longer / LETTERS_A_SLIP && slips < length
    };
    let names = known.into_iter().map(|name| (name, slips(name)));
    // `min_by_key` takes the first of several equally near names.
    let nearest = names.filter(is_near).min_by_key(|(_, slips)| *slips);
    nearest.map(|(name, _)| name)
}

#[cfg(test)]
mod tests {
    use super::did_you_mean;

    #[test]
    fn a_slip_is_told_with_the_name_that_was_meant_and_anything_else_is_not() {
        let machines = ["paper", "paper-12", "stream", "tile-6"];
        for (found, meant) in [
            ("papper", "paper"),
            ("Paper", "paper"),
            ("paper12", "paper-12"),
            ("steam", "stream"),
            ("tile6", "tile-6"),
        ] {
            let expected = format!(" (did you mean `{meant}`?)");
            assert_eq!(did_you_mean(found, machines), expected, "{found}");
        }
        for found in ["pentium4", "", "x", "pa"] {
            assert_eq!(did_you_mean(found, machines), "", "{found}");
        }
        assert_eq!(
            did_you_mean("rd", ["green", "red"]),
            " (did you mean `red`?)"
        );
        assert_eq!(did_you_mean("z", ["x", "y"]), "");
        assert_eq!(did_you_mean("corners", ["center"]), "");
        assert_eq!(did_you_mean("paper", []), "");
    }
}
