//! Prints Criterion's measurements as rates and ratios.

use std::fs;
use std::path::Path;
use std::time::SystemTime;

use crate::found::Found;

/// A row of the table.
pub struct Row {
    /// The name of the photons and queries.
    pub data: String,
    pub contestant: &'static str,
    pub threads: usize,
    /// Criterion's name of the measurement, inside the data's name.
    pub id: String,
    pub found: Found,
    pub bytes_per_photon: f64,
}

/// Prints the rows that were measured since `started`, each with its ratios to the best competitor and to
/// kiddo on the same data and threads.
pub fn print(home: &Path, started: SystemTime, rows: &[Row]) {
    println!(
        "\n| photons, in range | gather | threads | M queries/s | ns a query | candidates a query | tests a query \
         | G candidates/s | G tests/s | G in range/s | bytes a photon | queries/s to best peer \
         | tests/s to best peer | queries/s to kiddo | to 1 thread |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    );
    let timed: Vec<_> = rows
        .iter()
        .filter_map(|row| {
            let seconds = seconds(home, started, row)?;
            Some(Timed { row, seconds })
        })
        .collect();
    for row in &timed {
        println!("{}", row.line(&timed));
    }
    assert!(
        !timed.is_empty(),
        "nothing was measured: does a filter leave anything?"
    );
}

/// A row, with the seconds of a gather.
struct Timed<'a> {
    row: &'a Row,
    seconds: f64,
}

impl Timed<'_> {
    fn rate(&self, count: u64) -> f64 {
        count as f64 / self.seconds
    }

    fn queries(&self) -> f64 {
        self.rate(self.row.found.queries)
    }

    fn tests(&self) -> f64 {
        self.rate(self.row.found.tests)
    }

    /// The row's line in the table, compared with the other rows.
    fn line(&self, all: &[Self]) -> String {
        let Row {
            data,
            contestant,
            threads,
            found,
            bytes_per_photon,
            ..
        } = self.row;
        let alike = || all.iter().filter(|other| other.row.is_beside(self.row));
        let peers = || alike().filter(|other| !other.row.contestant.starts_with("fixed point"));
        let best = |rate: fn(&Self) -> f64| peers().map(rate).reduce(f64::max);
        let kiddo = peers().find(|other| other.row.contestant == "kiddo");
        let one = all.iter().find(|other| {
            (&other.row.data, other.row.contestant, other.row.threads) == (data, *contestant, 1)
        });
        let a_query = |count: u64| count as f64 / found.queries as f64;
        format!(
            "| {data} | {contestant} | {threads} | {:.2} | {:.0} | {:.0} | {:.0} | {:.2} | {:.2} | {:.3} \
             | {bytes_per_photon:.2} | {} | {} | {} | {} |",
            self.queries() / 1e6,
            1e9 / self.queries(),
            a_query(found.candidates),
            a_query(found.tests),
            self.rate(found.candidates) / 1e9,
            self.tests() / 1e9,
            self.rate(found.count) / 1e9,
            ratio(best(Self::queries).map(|best| self.queries() / best)),
            ratio(best(Self::tests).map(|best| self.tests() / best)),
            ratio(kiddo.map(|other| self.queries() / other.queries())),
            ratio(one.map(|one| self.queries() / one.queries())),
        )
    }
}

impl Row {
    /// Whether both rows have equal photons, queries and threads.
    fn is_beside(&self, other: &Self) -> bool {
        (&self.data, self.threads) == (&other.data, other.threads)
    }
}

fn ratio(ratio: Option<f64>) -> String {
    ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.2}"))
}

/// The median time of a gather of all queries; `None` where this run did not measure it.
fn seconds(home: &Path, started: SystemTime, row: &Row) -> Option<f64> {
    // Criterion's form of names in paths.
    let folder =
        |name: &str| name.replace(['?', '"', '/', '\\', '*', '<', '>', ':', '|', '^'], "_");
    let path = home
        .join(folder(&row.data))
        .join(folder(&row.id))
        .join("new/estimates.json");
    let written = fs::metadata(&path).ok()?.modified().ok()?;
    let text = fs::read_to_string(path)
        .ok()
        .filter(|_| written >= started)?;
    let estimates: serde_json::Value = serde_json::from_str(&text).ok()?;
    Some(estimates["median"]["point_estimate"].as_f64()? * 1e-9)
}
