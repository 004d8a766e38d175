//! A first gather: the golden model of the paper's machine adds the photons around a query point.
//! `cargo run -p photoncube-model --example first_gather`

use std::error::Error;
use std::f64::consts::PI;

use photoncube_model::gather;
use photoncube_spec::{Photon, Query, find_machine};

fn main() -> Result<(), Box<dyn Error>> {
    let machine = find_machine("paper")?;
    // Coordinates are whole steps of the machine's grid; the radius is 5 steps.
    let query = Query {
        position: [100, 100, 100],
        radius_sq: 25,
    };
    let photon = |position, power| Photon {
        position,
        power,
        exponent: 0,
    };
    let photons = [
        photon([100, 100, 100], [300, 200, 100]),
        // 3^2 + 4^2 is 25: a photon on the boundary is in range.
        photon([103, 104, 100], [30, 20, 10]),
        photon([106, 100, 100], [3, 2, 1]),
    ];
    let sums = gather(machine, &query, photons)?;
    println!("{} of {} photons are in range", sums.count, photons.len());
    println!("sum of their power, by channel: {:?}", sums.power);
    // Eq. 2 of Ryu, Kim, Lee: the sum over the area of the disc. The host divides.
    let area = PI * f64::from(query.radius_sq);
    let radiance = sums.power.map(|power| power as f64 / area);
    println!("radiance, in units of power a square step: {radiance:.3?}");
    Ok(())
}
