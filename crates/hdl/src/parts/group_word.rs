//! The word of a group of photons in a memory: a number for each of its fields.

use photoncube_spec::Spatial;
use rust_hdl::prelude::*;

const LANES: usize = Spatial::LANES;
const AXES: [&str; 3] = ["x", "y", "z"];

/// A field of a word: its port name and its width.
pub(crate) struct Field {
    pub name: String,
    pub width: usize,
}

/// The fields of a group's word, from bit 0 up: for each lane presence, coordinates of `position` bits, the mantissas
/// of its share of `mantissas` with `mantissa` bits, and an exponent, where that has bits.
pub(crate) fn group_fields(
    [position, mantissa, exponent]: [usize; 3],
    mantissas: usize,
) -> Vec<Field> {
    let mut fields = Vec::new();
    let mut field = |name: String, width| fields.push(Field { name, width });
    for lane in 0..LANES {
        field(format!("present${lane}"), 1);
        for axis in AXES {
            field(format!("{axis}${lane}"), position);
        }
        for place in (lane..mantissas).step_by(LANES) {
            field(format!("channel${place}"), mantissa);
        }
        if exponent > 0 {
            field(format!("exponent${lane}"), exponent);
        }
    }
    fields
}

/// The pins of a group.
pub(crate) struct GroupPins<'a, const H: usize, const B: usize, const E: usize> {
    pub present: &'a [Signal<In, Bits<1>>; LANES],
    /// The coordinates x, y and z.
    pub position: [&'a [Signal<In, Bits<H>>; LANES]; 3],
    /// The mantissas: channel c of lane g is at 4 c + g.
    pub channel: &'a [Signal<In, Bits<B>>],
    pub exponent: &'a [Signal<In, Bits<E>>],
}

impl<const H: usize, const B: usize, const E: usize> GroupPins<'_, H, B, E> {
    /// The values of the pins, in the order of [`group_fields`].
    pub fn word(&self) -> Vec<u64> {
        let mut word = Vec::new();
        for lane in 0..LANES {
            word.push(self.present[lane].val().to_u64());
            word.extend(self.position.map(|axis| axis[lane].val().to_u64()));
            let channels = self.channel.iter().skip(lane).step_by(LANES);
            word.extend(channels.map(|channel| channel.val().to_u64()));
            let exponent = self.exponent.get(lane);
            word.extend(exponent.map(|exponent| exponent.val().to_u64()));
        }
        word
    }
}
