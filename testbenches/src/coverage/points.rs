//! Parses Verilator's coverage file. Each point is a line `C '...' hits`, in which each field is a letter
//! between the characters 1 and 2, followed by its value.

use serde::Serialize;

/// A kind of coverage point.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum CoverageKind {
    /// A block of statements was executed.
    Line,
    /// A branch of an `if` or an arm of a `case` was taken.
    Branch,
    /// A bit of a signal changed its value.
    Toggle,
    /// A cover point of the testbench held.
    User,
}

impl CoverageKind {
    /// All kinds.
    pub const ALL: [Self; 4] = [Self::Line, Self::Branch, Self::Toggle, Self::User];

    /// The kind's name in reports.
    pub fn name(self) -> &'static str {
        match self {
            Self::Line => "line",
            Self::Branch => "branch",
            Self::Toggle => "toggle",
            Self::User => "user",
        }
    }

    fn of_page(page: &str) -> Option<Self> {
        let name = page.strip_prefix("v_")?;
        Self::ALL.into_iter().find(|kind| kind.name() == name)
    }
}

/// One point of one instance.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Point {
    pub kind: CoverageKind,
    pub module: String,
    /// The path of the instance in the top instance; empty for the top itself.
    pub instance: String,
    /// The line in the simulated text, from 1.
    pub line: usize,
    /// A bit such as `sum[3]`, or the kind of a block or branch.
    pub what: String,
    pub hits: u64,
}

/// Parses all points of a file.
///
/// # Errors
/// The first line that is not a point.
pub(super) fn parse(file: &str) -> Result<Vec<Point>, String> {
    let points = file.lines().filter(|line| !line.starts_with('#'));
    let point = |line| parse_line(line).ok_or_else(|| format!("no point of coverage: {line:?}"));
    points.map(point).collect()
}

fn parse_line(line: &str) -> Option<Point> {
    let (fields, hits) = line.strip_prefix("C '")?.rsplit_once("' ")?;
    let field = |name: &str| {
        let mut fields = fields.split('\u{1}').filter_map(|f| f.split_once('\u{2}'));
        fields.find(|(key, _)| *key == name).map(|(_, value)| value)
    };
    let (page, module) = field("page")?.split_once('/')?;
    Some(Point {
        kind: CoverageKind::of_page(page)?,
        module: module.to_owned(),
        instance: path_in_top(field("h")?).to_owned(),
        line: field("l")?.parse().ok()?,
        what: field("o")?.to_owned(),
        hits: hits.trim().parse().ok()?,
    })
}

/// The path without the testbench's modules around the design.
fn path_in_top(path: &str) -> &str {
    const TOP: &str = ".dut";
    let rest = path.split_once(TOP).map_or("", |(_, rest)| rest);
    rest.trim_start_matches('.')
}

#[cfg(test)]
mod tests {
    use super::*;

    const BIT: &str = "C '\u{1}f\u{2}design.v\u{1}l\u{2}100\u{1}n\u{2}16\u{1}page\u{2}v_toggle/photoncube_paper\u{1}o\u{2}green_0[10]\u{1}h\u{2}TOP.trace.dut.cell_3' 7";

    #[test]
    fn a_point_is_read() {
        let point = Point {
            kind: CoverageKind::Toggle,
            module: "photoncube_paper".into(),
            instance: "cell_3".into(),
            line: 100,
            what: "green_0[10]".into(),
            hits: 7,
        };
        assert_eq!(
            parse(&format!("# SystemC::Coverage-3\n{BIT}\n")),
            Ok(vec![point])
        );
    }

    #[test]
    fn a_line_of_another_form_is_refused_with_its_text() {
        for line in ["C 'x' 1", "nonsense", &BIT.replace("v_toggle", "v_other")] {
            assert!(parse(line).unwrap_err().contains("no point"), "{line}");
        }
    }
}
