//! Names for the channels and results in the emitted text.
//!
//! Their number depends on the machine, so the blocks number them. The emitted text has the names of
//! `photoncube_spec::Pins`.

use photoncube_spec::Machine;

/// Pairs of an element's name in rust-hdl and its name in the emitted text.
pub(crate) struct ChannelNames(Vec<(String, String)>);

impl ChannelNames {
    /// The names of a block that has no channels.
    pub(super) fn none() -> Self {
        Self(Vec::new())
    }

    pub(crate) fn of(machine: &Machine) -> Self {
        let channels = machine.channels().names();
        let lanes = machine.photons_per_iteration();
        let word = |index: usize| format!("{}${}", channels[index / lanes], index % lanes);
        let words =
            (0..channels.len() * lanes).map(|index| (format!("channel${index}"), word(index)));
        // The head of a spatial machine has signals `power` of its own, so the mantissas of a single channel have
        // another name inside the machine than on its pins.
        let is_single = machine.spatial().is_some() && channels.len() == 1;
        let inside = (0..if is_single { lanes } else { 0 }).flat_map(|index| {
            [
                (
                    format!("photon_channel${index}"),
                    format!("photon_{}", word(index)),
                ),
                (format!("channel${index}"), format!("mantissa${index}")),
            ]
        });
        let sums = channels.iter().chain(&["count"]).enumerate();
        let results =
            sums.map(|(index, name)| (format!("result${index}"), format!("result${name}")));
        // Each of these pins exists once or not at all.
        let single = ["radius_sq", "query_release"];
        let singles = single.map(|name| (format!("{name}$0"), name.to_owned()));
        Self(inside.chain(words).chain(results).chain(singles).collect())
    }

    /// The name in the emitted text of a pin whose rust-hdl name ends with `_` and a number.
    pub(crate) fn pin(&self, pin: &str) -> String {
        match pin.rsplit_once('_') {
            Some((array, index)) => self.name(&format!("{array}${index}")).replace('$', "_"),
            None => pin.to_owned(),
        }
    }

    /// Renames an identifier that ends with such an element; returns any other identifier unchanged.
    pub(super) fn name(&self, identifier: &str) -> String {
        let named = self.0.iter().find_map(|(numbered, named)| {
            let path = identifier.strip_suffix(numbered.as_str())?;
            let whole = path.is_empty() || path.ends_with(['_', '$']);
            whole.then(|| format!("{path}{named}"))
        });
        named.unwrap_or_else(|| identifier.to_owned())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::find_machine;

    #[test]
    fn numbered_elements_get_the_names_of_the_machines_channels() {
        let renamed = |machine: &str, identifier: &str| {
            ChannelNames::of(find_machine(machine).unwrap()).name(identifier)
        };
        #[rustfmt::skip]
        let rows = [
            ("paper", "photon_channel$0", "photon_red$0"),
            ("paper", "ports$channel$11", "ports$blue$3"),
            ("paper-5d", "channel$11", "green$3"),
            ("fit-ring", "photon_channel$3", "photon_power$3"),
            ("fit-ring", "ports$result$1", "ports$result$count"),
            ("paper", "result$3", "result$count"),
            ("paper", "otherchannel$3", "otherchannel$3"),
            ("paper", "channel$12", "channel$12"),
            ("paper", "cell$0", "cell$0"),
            ("stream-local7-mono1-n8", "photon_channel$3", "photon_power$3"),
            ("stream-local7-mono1-n8", "head$channel$3", "head$mantissa$3"),
        ];
        for (machine, identifier, expected) in rows {
            assert_eq!(renamed(machine, identifier), expected, "{machine}");
        }
    }
}
