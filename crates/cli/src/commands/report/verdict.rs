//! The verdict of the report: the bits that the scene needs, the smallest machine and the fastest. Only this
//! module decides it.

use serde::Serialize;

use crate::hardware::digits;
use crate::table::grouped;

/// The best listed formats and machines within the bound. `fit` searches all formats; the report does not.
#[derive(Debug, Default, PartialEq, Serialize)]
pub struct Verdict {
    /// The format with the fewest bits, alone or in a machine; `None` where none is within the bound.
    pub format: Option<String>,
    /// The bits of a stored photon in that format.
    pub bits_per_photon: Option<u32>,
    /// The machine with the fewest LUT4 equivalents.
    pub smallest_machine: Option<String>,
    /// The machine with the most pictures per second at its measured clock.
    pub fastest_machine: Option<String>,
    /// The pictures per second of the fastest machine.
    pub pictures_per_second: Option<f64>,
}

/// A row among which the verdict is found.
#[derive(Clone, Copy)]
pub struct Candidate<'a> {
    /// The name of a format, a machine or a core.
    pub name: &'a str,
    /// Its photon format; `None` for plain numbers.
    pub format: Option<&'a str>,
    /// Bits of a stored photon.
    pub bits_per_photon: u32,
    /// Whether it is a format alone.
    pub is_format: bool,
    /// Whether its error is within the bound.
    pub within_bound: bool,
    /// Its LUT4 equivalents without DSP blocks.
    pub lut4_equivalents: Option<u64>,
    /// The pictures per second at its measured clock.
    pub pictures_per_second: Option<f64>,
}

impl Verdict {
    /// Finds the verdict of the rows.
    pub fn of<'a>(rows: impl Iterator<Item = Candidate<'a>>) -> Self {
        let within: Vec<_> = rows.filter(|row| row.within_bound).collect();
        let formats = within
            .iter()
            .filter_map(|row| Some((row.format?, row.bits_per_photon)));
        let format = formats.min_by_key(|(_, bits)| *bits);
        let machines = || within.iter().filter(|row| !row.is_format);
        let sized = machines().filter_map(|row| Some((row, row.lut4_equivalents?)));
        let smallest = sized.min_by_key(|(_, area)| *area);
        let timed = machines().filter_map(|row| Some((row, row.pictures_per_second?)));
        let fastest = timed.max_by(|(_, a), (_, b)| a.total_cmp(b));
        Self {
            format: format.map(|(format, _)| format.to_owned()),
            bits_per_photon: format.map(|(_, bits)| bits),
            smallest_machine: smallest.map(|(row, _)| row.name.to_owned()),
            fastest_machine: fastest.map(|(row, _)| row.name.to_owned()),
            pictures_per_second: fastest.map(|(_, speed)| speed),
        }
    }

    /// The verdict as text.
    pub fn text(&self, bound: f64, query_points: u64) -> String {
        let needs = match (self.bits_per_photon, &self.format) {
            (Some(bits), Some(format)) => {
                format!("the format of fewest bits is {format}, {bits} bits per photon")
            }
            _ => "no format is precise enough".to_owned(),
        };
        let machine = |name: &Option<String>| name.clone().unwrap_or_else(|| "none".to_owned());
        let speed = self.pictures_per_second.map_or_else(String::new, |speed| {
            format!(
                ", {} pictures/s of {} queries each",
                digits(speed),
                grouped(query_points)
            )
        });
        format!(
            "of the formats and machines listed below, with an error within {bound} of the noise (luminance, red, green \
             and blue):\n{needs}; the smallest machine is {}; the fastest is {}{speed}.\n\
             `photoncube fit` searches all formats, so it may find fewer bits.",
            machine(&self.smallest_machine),
            machine(&self.fastest_machine),
        )
    }
}
