//! Progress bars on standard error, for work of more than a second.

use std::time::Duration;

use indicatif::{ProgressBar, ProgressStyle};

/// The format of a bar. The bar takes the width that the words leave, so that a line of 40 columns is enough.
const BAR: &str = "{msg} {percent:>3} % {eta:>4} left {wide_bar}";

/// The time between two pictures of a spinner.
pub const TICK: Duration = Duration::from_millis(200);

/// A bar of `length` units. It is silent where standard error is not a terminal.
pub fn bar(what: &'static str, length: u64) -> ProgressBar {
    ProgressBar::new(length)
        .with_style(bar_style())
        .with_message(what)
}

fn bar_style() -> ProgressStyle {
    ProgressStyle::with_template(BAR)
        .expect("the template is a constant that a test has parsed")
        .progress_chars("=> ")
}

/// A counter without a known end, with the elapsed time. It is silent where standard error is not a terminal.
pub fn spinner(what: &'static str) -> ProgressBar {
    let style = ProgressStyle::with_template("{spinner} {msg} {pos}  {elapsed}")
        .expect("the template is a constant that a test has parsed");
    ProgressBar::new_spinner()
        .with_style(style)
        .with_message(what)
}

#[cfg(test)]
mod tests {
    use std::io;
    use std::sync::{Arc, Mutex};

    use indicatif::{ProgressDrawTarget, TermLike};

    use super::*;

    /// A terminal of that many columns that records its output.
    #[derive(Clone, Debug)]
    struct Terminal(u16, Arc<Mutex<String>>);

    impl TermLike for Terminal {
        fn width(&self) -> u16 {
            self.0
        }
        fn move_cursor_up(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_down(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_right(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn move_cursor_left(&self, _: usize) -> io::Result<()> {
            Ok(())
        }
        fn write_line(&self, text: &str) -> io::Result<()> {
            self.write_str(text)
        }
        fn write_str(&self, text: &str) -> io::Result<()> {
            self.1.lock().unwrap().push_str(text);
            Ok(())
        }
        fn clear_line(&self) -> io::Result<()> {
            Ok(())
        }
        fn flush(&self) -> io::Result<()> {
            Ok(())
        }
    }

    #[test]
    fn a_bar_fits_a_line_of_40_columns_and_fills_a_wide_one() {
        for (columns, has_bar) in [(40, false), (80, true)] {
            let terminal = Terminal(columns, Arc::default());
            let target = ProgressDrawTarget::term_like(Box::new(terminal.clone()));
            // The longest message of all bars.
            let bar = bar("measuring estimators", 10);
            bar.set_draw_target(target);
            bar.set_position(5);
            bar.tick();
            let written = terminal.1.lock().unwrap().clone();
            // The line as it was drawn last.
            let line = written.rsplit("measuring").next().unwrap();
            let line = format!("measuring{line}");
            assert!(line.starts_with("measuring estimators  50 %"), "{line:?}");
            assert!(
                line.trim_end().chars().count() <= usize::from(columns),
                "{line:?}"
            );
            assert_eq!(line.contains("==="), has_bar, "{line:?}");
        }
        spinner("test").finish_and_clear();
    }
}
