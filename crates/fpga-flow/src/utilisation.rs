//! The resources of a device that a design uses, or would need.

use serde::{Deserialize, Serialize};

/// A kind of resource of a device, such as logic cells.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Resource {
    /// nextpnr's name of the resource.
    pub resource: String,
    /// How many the design needs.
    pub needed: u64,
    /// How many the device has.
    pub available: u64,
    /// How many more the design needs than the device has; 0 where it has enough.
    pub lacking: u64,
}

impl Resource {
    /// Whether the design needs more than the device has.
    pub fn is_lacking(&self) -> bool {
        self.lacking > 0
    }
}

/// The line of nextpnr's log before the resources.
const HEADING: &str = "Device utilisation:";

/// The resources in nextpnr's log that the design needs; none where the log has no such table.
pub(crate) fn resources(log: &str) -> Vec<Resource> {
    let Some((_, table)) = log.split_once(HEADING) else {
        return Vec::new();
    };
    let rows = table.lines().skip(1).map_while(resource);
    rows.filter(|row| row.needed > 0).collect()
}

/// A row such as `Info: ICESTORM_LC: 4646/ 5280 87%`.
fn resource(line: &str) -> Option<Resource> {
    let (name, numbers) = line.strip_prefix("Info:")?.split_once(':')?;
    let (needed, rest) = numbers.split_once('/')?;
    let needed: u64 = needed.trim().parse().ok()?;
    let available = rest.split_whitespace().next()?.parse().ok()?;
    Some(Resource {
        resource: name.trim().to_owned(),
        needed,
        available,
        lacking: needed.saturating_sub(available),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The end of the log of nextpnr-ice40 0.11 for a design that a HX1K cannot hold.
    const LOG: &str = "Info: Packing special functions..

Info: Device utilisation:
Info: \t         ICESTORM_LC:    4646/   1280   362%
Info: \t        ICESTORM_RAM:       0/     16     0%
Info: \t               SB_IO:       3/     72     4%

Info: Placed 0 cells based on constraints.
ERROR: Unable to place cell 'x', no BELs remaining to implement cell type 'ICESTORM_LC'
";

    #[test]
    fn what_is_lacking_is_counted() {
        let found = resources(LOG);
        let of = |resource: &Resource| (resource.resource.clone(), resource.lacking);
        let found: Vec<_> = found.iter().map(of).collect();
        assert_eq!(
            found,
            [("ICESTORM_LC".to_owned(), 3366), ("SB_IO".to_owned(), 0)]
        );
        assert_eq!(resources("ERROR: no such package\n"), []);
    }
}
