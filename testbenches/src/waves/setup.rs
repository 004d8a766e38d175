//! The files that make a viewer show a waveform: which signals, in which groups, and where.

use super::scopes::{Scope, Shown, Signal};
use super::{NS_PER_CLOCK, Waves};

/// The most signals that a viewer is told to show. Viewers become slow with many; all others are in their list.
const MOST_SHOWN: usize = 1_000;

/// GTKWave's trace flags, see `analyzer.h` of GTKWave: right-justified with 0x20.
const BINARY: &str = "@28";
const DECIMAL: &str = "@24";
/// For the words of a stream.
const HEXADECIMAL: &str = "@22";
const TEXT: &str = "@820";
/// GTKWave's zoom at which the values of a clock can be read: minus the binary logarithm of the ns in about 200 pixels.
const ZOOM: &str = "-5.0";
/// The clocks that are shown before the first difference.
const BEFORE: u64 = 8;
/// The most bits of a signal that is shown as a decimal number.
const WIDEST_NUMBER: u32 = 48;
/// A group that is open, one that is closed, and their ends.
const OPEN: [&str; 2] = ["@800200", "@1000200"];
const CLOSED: [&str; 2] = ["@c00200", "@1401200"];

impl Waves {
    /// The scopes to show: the run, those in which a signal differs first, the input pins, and as many others of the
    /// device as are not too many.
    fn shown<'a>(&self, scopes: &'a [Scope]) -> Vec<&'a Scope> {
        let mut rows = self.rows.iter();
        let differing = rows.find(|row| !row.differing.is_empty());
        let differing = differing.map_or(&[][..], |row| &row.differing);
        let differs = |signal: &Signal| match signal.shown {
            Shown::Device(column) | Shown::Model(column) => differing.contains(&column),
            _ => false,
        };
        let rank = |scope: &&Scope| match scope.signals[0].shown {
            Shown::Clock => Some(0),
            _ if scope.signals.iter().any(differs) => Some(1),
            Shown::Input(_) => Some(2),
            Shown::Model(_) => None,
            _ => Some(3),
        };
        let mut shown: Vec<_> = scopes
            .iter()
            .filter(|scope| rank(scope).is_some())
            .collect();
        shown.sort_by_key(rank);
        let mut signals = 0;
        let few = |scope: &&Scope| {
            signals += scope.signals.len();
            signals <= MOST_SHOWN
        };
        shown.into_iter().take_while(few).collect()
    }

    /// The times of the first and the last recorded clock, and of the first difference, in ns.
    fn times(&self) -> (u64, u64, Option<u64>) {
        let clocks = self.clocks();
        let difference = self.difference().map(Self::time);
        (Self::time(clocks.start), Self::time(clocks.end), difference)
    }
}

/// Commands for `surfer --command-file`.
pub(super) fn surfer(waves: &Waves, scopes: &[Scope]) -> String {
    let mut text = String::new();
    for scope in waves.shown(scopes) {
        text += &format!("scope_add_as_group {}\n", scope.path.join("."));
    }
    let (start, end, difference) = waves.times();
    if let Some(difference) = difference {
        text += &format!("cursor_set {difference}ns\n");
    }
    text + &format!("zoom_to {start}ns {end}ns\n")
}

/// A save file, the second argument of `gtkwave`.
pub(super) fn gtkwave(waves: &Waves, scopes: &[Scope]) -> String {
    let (start, _, difference) = waves.times();
    let shown_from = difference.map_or(start, |time| time.saturating_sub(BEFORE * NS_PER_CLOCK));
    let marker = difference.map_or("-1".to_owned(), |time| time.to_string());
    // The markers A to Z are not set.
    let others = " -1".repeat(26);
    let mut text = format!(
        "[size] 1600 1000\n*{ZOOM} {marker}{others}\n[timestart] {}\n[sst_expanded] 1\n",
        start.max(shown_from)
    );
    for (index, scope) in waves.shown(scopes).into_iter().enumerate() {
        let path = scope.path.join(".");
        let [begin, end] = if index < 4 { OPEN } else { CLOSED };
        text += &format!("{begin}\n-{path}\n");
        for signal in &scope.signals {
            let (flags, range) = match signal.bits {
                None => (TEXT, String::new()),
                Some(1) => (BINARY, String::new()),
                Some(bits) => {
                    let flags = if bits > WIDEST_NUMBER {
                        HEXADECIMAL
                    } else {
                        DECIMAL
                    };
                    (flags, format!("[{}:0]", bits - 1))
                }
            };
            text += &format!("{flags}\n{path}.{}{range}\n", signal.name);
        }
        text += &format!("{end}\n-{path}\n");
    }
    text
}
