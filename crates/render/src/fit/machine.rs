//! Finds the machines that are wide enough for a format.

use photoncube_spec::{Channels, Machine, PhotonFormat, PowerFormat};
use serde::Serialize;

/// A field of a machine's format, with the value that another format needs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize)]
pub struct FieldNeed {
    /// The name of the field.
    pub field: &'static str,
    /// The value that the format needs.
    pub needed: u64,
    /// The value that the machine has.
    pub found: u64,
}

/// Every field of the machine's photon format that decides its widths, beside the needed one. The owner of
/// the exponent does not matter, because a machine gets a block's exponent with every photon, by the same
/// pins. Nor does the rounding, which is done before photons are stored.
#[must_use]
pub fn field_needs(machine: &PhotonFormat, needed: &PhotonFormat) -> Vec<FieldNeed> {
    let fields = |format: &PhotonFormat| {
        [
            ("position_bits", u64::from(format.position_bits)),
            ("radius_bits", format.radius_bits().into()),
            ("channels", channels(format)),
            ("mantissa_bits", format.power.mantissa_bits.into()),
            ("exponent_range", format.power.exponent_range().into()),
            ("max_photons", format.max_photons),
        ]
    };
    let pairs = fields(machine).into_iter().zip(fields(needed));
    pairs
        .map(|((field, found), (_, needed))| FieldNeed {
            field,
            needed,
            found,
        })
        .collect()
}

/// Whether a machine of the one format is enough for the other: no field is smaller.
///
/// Positions with as many bits, and radii with as many steps, are as fine or finer. Where both have equal
/// `radius_bits`, more position bits and fewer extra query bits round the photon less and the query as much.
#[must_use]
pub fn covers(machine: &PhotonFormat, needed: &PhotonFormat) -> bool {
    let needs = field_needs(machine, needed);
    needs.iter().all(|need| need.found >= need.needed)
}

/// The format of the photons that a machine is fed: the machine's widths, rounded as the needed format says. Photons are
/// rounded before they are stored, so the emitted Verilog of both is one text.
#[must_use]
pub fn fed(machine: &PhotonFormat, needed: &PhotonFormat) -> PhotonFormat {
    PhotonFormat {
        power: PowerFormat {
            rounding: needed.power.rounding,
            ..machine.power
        },
        ..*machine
    }
}

/// The machines that are wide enough for the format.
pub fn covering<'a>(
    machines: &'a [Machine],
    needed: &PhotonFormat,
) -> impl Iterator<Item = (&'a Machine, &'a PhotonFormat)> {
    let needed = *needed;
    let local = machines
        .iter()
        .filter_map(|machine| Some((machine, machine.format()?)));
    local.filter(move |(_, format)| covers(format, &needed))
}

fn channels(format: &PhotonFormat) -> u64 {
    Channels::count(format.power.channels).into()
}

#[cfg(test)]
mod tests {
    use photoncube_spec::{MACHINES, find_photon_format};

    use super::*;

    #[test]
    fn a_machine_covers_what_is_nowhere_wider() {
        let covers = |machine, needed| {
            let format = |name| find_photon_format(name).unwrap();
            covers(&format(machine), &format(needed))
        };
        let needed = "local7x1-rgb6e3d-n16384";
        for machine in [
            needed,
            "local7x1-rgb6b3-n16384",
            "local8-rgb6e3-n16384",
            "local8x2-rgb16b8",
        ] {
            assert!(covers(machine, needed), "{machine}");
        }
        for machine in [
            "local7-rgb6e3-n16384",
            "local6x2-rgb6e3-n16384",
            "local7x1-mono6e3-n16384",
            "local7x1-rgb5e3-n16384",
            "local7x1-rgb6e2-n16384",
            "local7x1-rgb6e3-n8192",
        ] {
            assert!(!covers(machine, needed), "{machine}");
        }
    }

    #[test]
    fn a_machine_is_fed_its_own_widths_by_the_rounding_of_the_fit() {
        let fed = |machine, needed| {
            let format = |name| find_photon_format(name).unwrap();
            fed(&format(machine), &format(needed)).name()
        };
        assert_eq!(
            fed("local8-rgb8e5", "local7-rgb7e1d-n4096"),
            "local8-rgb8e5d"
        );
        assert_eq!(
            fed("local6x2-rgb6d-n4096", "local6-rgb5"),
            "local6x2-rgb6-n4096"
        );
        assert_eq!(fed("local8-rgb8e5", "local6-rgb5"), "local8-rgb8e5");
    }

    #[test]
    fn only_machines_of_a_photon_format_cover() {
        let needed = find_photon_format("local4-mono1-n1").unwrap();
        let found: Vec<_> = covering(MACHINES, &needed).collect();
        assert!(found.len() >= 2 && found.iter().all(|(machine, _)| machine.plain().is_none()));
        let needed = find_photon_format("local12x2-rgb16e8").unwrap();
        assert_eq!(covering(MACHINES, &needed).count(), 0);
    }
}
