//! Progress bars on standard error, for work of more than a second.

use indicatif::{ProgressBar, ProgressStyle};

/// A bar of `length` units; it is silent where standard error is no terminal.
pub fn bar(what: &'static str, length: u64) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg:22} [{bar:32}] {percent:>3} %  {eta:>4} left")
        .expect("the template is a constant that a test has parsed")
        .progress_chars("=> ");
    ProgressBar::new(length)
        .with_style(style)
        .with_message(what)
}

/// A count that goes up to nobody knows where, with the time since; silent as a bar is.
pub fn spinner(what: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{spinner} {msg} {pos}  {elapsed}")
        .expect("the template is a constant that a test has parsed");
    ProgressBar::new_spinner()
        .with_style(style)
        .with_message(what)
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_templates_are_well_formed() {
        super::bar("test", 1).finish_and_clear();
        super::spinner("test").finish_and_clear();
    }
}
