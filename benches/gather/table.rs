//! What Criterion measured, as rates and ratios.

use std::fs;
use std::path::Path;
use std::time::SystemTime;

use crate::found::Found;

/// One measurement.
pub struct Row {
    /// Photons and queries.
    pub data: String,
    pub contestant: &'static str,
    pub threads: usize,
    /// Criterion's name for it, within the data's.
    pub id: String,
    pub found: Found,
    pub bytes_per_photon: f64,
}

/// Prints the rows that were measured since `started`, each with its ratios to the best peer and to kiddo on
/// the same data and threads.
pub fn print(home: &Path, started: SystemTime, rows: &[Row]) {
    println!(
        "\n| photons, in range | gather | threads | M queries/s | G tests/s | G accepted/s | tests a query \
         | bytes a photon | tests/s to best peer | queries/s to kiddo | to 1 thread |\n\
         | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |"
    );
    let timed: Vec<_> = rows
        .iter()
        .filter_map(|row| Some((row, seconds(home, started, row)?)))
        .collect();
    for (row, time) in &timed {
        let like = |other: &Row| (&other.data, other.threads) == (&row.data, row.threads);
        let alike = || timed.iter().filter(|(other, _)| like(other));
        let tests = |(row, time): &(&Row, f64)| row.found.tests as f64 / time;
        let peers = alike().filter(|(other, _)| !other.contestant.starts_with("fixed point"));
        let best = peers.map(tests).reduce(f64::max);
        let queries = |(row, time): &(&Row, f64)| row.found.queries as f64 / time;
        let kiddo = alike().find(|(other, _)| other.contestant == "kiddo");
        let one = timed.iter().find(|(other, _)| {
            (&other.data, other.contestant, other.threads) == (&row.data, row.contestant, 1)
        });
        let rate = |count: f64| count / time;
        println!(
            "| {} | {} | {} | {:.2} | {:.2} | {:.3} | {:.0} | {:.2} | {} | {} | {} |",
            row.data,
            row.contestant,
            row.threads,
            rate(row.found.queries as f64) / 1e6,
            rate(row.found.tests as f64) / 1e9,
            rate(row.found.count as f64) / 1e9,
            row.found.tests as f64 / row.found.queries as f64,
            row.bytes_per_photon,
            ratio(best.map(|best| rate(row.found.tests as f64) / best)),
            ratio(kiddo.map(|other| queries(&(*row, *time)) / queries(other))),
            ratio(one.map(|(_, other)| other / time)),
        );
    }
    assert!(
        !timed.is_empty(),
        "nothing was measured: does a filter leave anything?"
    );
}

fn ratio(ratio: Option<f64>) -> String {
    ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.2}"))
}

/// The median of a gather of all queries; none where this run did not measure it.
fn seconds(home: &Path, started: SystemTime, row: &Row) -> Option<f64> {
    // As Criterion writes names in paths.
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
