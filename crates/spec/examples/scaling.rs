//! Prints the photon bandwidth, the resident queries and the memory that a tile machine needs for photon maps
//! of up to 1e8 photons. `docs/scaling.md` derives the formulas.
//!
//! ```text
//! cargo run -p photoncube-spec --example scaling -- MACHINE CLOCK_MHZ
//! ```

use std::f64::consts::PI;
use std::process::ExitCode;

use photoncube_spec::{Machine, find_machine};

/// Photons that the search radius is chosen to have in range.
const IN_RANGE: f64 = 200.0;
/// Queries of a picture: 1920 x 1080 pixels, 16 each.
const QUERIES: f64 = 1920.0 * 1080.0 * 16.0;
/// Block edges, squared, of a flat surface across the four-block frame.
const FRAME_FACES: f64 = 16.0;
/// Block edges, squared, of a flat surface in the two-block cube that holds the queries of a frame.
const QUERY_FACES: f64 = 4.0;
/// Block edges, squared, of a flat surface in the 27 blocks around a query's own block. Only photons of these
/// blocks can be in range of the query.
const OWN_FACES: f64 = 9.0;

fn main() -> ExitCode {
    let arguments: Vec<_> = std::env::args().skip(1).collect();
    let parsed = match arguments.as_slice() {
        [name, clock] => find_machine(name).ok().zip(clock.parse::<f64>().ok()),
        _ => None,
    };
    match parsed.filter(|(_, clock)| *clock > 0.0) {
        Some((machine, clock)) => {
            print!("{}", report(machine, clock * 1e6));
            ExitCode::SUCCESS
        }
        None => {
            eprintln!("usage: scaling MACHINE CLOCK_MHZ, as in: scaling tile-10 150");
            ExitCode::from(2)
        }
    }
}

fn report(machine: &Machine, clock: f64) -> String {
    let lanes = machine.photons_per_iteration() as f64;
    let engines = machine.queries_at_once() as f64;
    let bytes = f64::from(machine.bits_per_photon()) / 8.0;
    let bandwidth = lanes * clock * bytes;
    let mut text = format!(
        "{}: {engines} queries at once, {lanes} photons a clock, {bytes} bytes a photon, {:.0} MHz\n\
         photon tests per second   {lanes} x {engines} x {:.0} MHz = {:.1} G at the peak\n\
         of photons that can be in range: {OWN_FACES} of {FRAME_FACES} faces, at most {:.1} G\n\
         photon bandwidth          {lanes} x {:.0} MHz x {bytes} B = {:.2} GB/s, for any number of engines\n\
         without sharing           x {engines} = {:.0} GB/s\n\n\
         photons  memory   faces  photons a frame  queries a frame  batches a frame  engines busy  seconds a picture\n",
        machine.name,
        clock / 1e6,
        clock / 1e6,
        lanes * engines * clock / 1e9,
        lanes * engines * clock / 1e9 * OWN_FACES / FRAME_FACES,
        clock / 1e6,
        bandwidth / 1e9,
        bandwidth * engines / 1e9,
    );
    for exponent in 5..=8 {
        text += &row(10_f64.powi(exponent), machine, bytes, clock);
    }
    text
}

fn row(photons: f64, machine: &Machine, bytes: f64, clock: f64) -> String {
    let lanes = machine.photons_per_iteration() as f64;
    let engines = machine.queries_at_once() as f64;
    // A disc of the search radius, which is a block's edge, has IN_RANGE photons.
    let photons_a_face = IN_RANGE / PI;
    let faces = photons / photons_a_face;
    let photons_a_frame = FRAME_FACES * photons_a_face;
    let queries_a_frame = QUERIES / (faces / QUERY_FACES);
    let batches = (queries_a_frame / engines).ceil();
    let clocks_a_batch = match machine.spatial() {
        Some(spatial) => (photons_a_frame / lanes + f64::from(spatial.batch_gap_clocks()))
            .max(spatial.least_batch_clocks().into()),
        None => photons_a_frame / lanes * machine.rate().interval(),
    };
    let clocks = (faces / QUERY_FACES) * batches * clocks_a_batch;
    format!(
        "{photons:>7.0e} {:>7.3} GB {faces:>8.0} {photons_a_frame:>13.0} {queries_a_frame:>16.1} \
         {batches:>16.0} {:>12.0} % {:>12.2}\n",
        photons * bytes / 1e9,
        100.0 * queries_a_frame / (batches * engines),
        clocks / clock,
    )
}
