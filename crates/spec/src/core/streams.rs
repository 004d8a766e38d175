//! The words of a core's streams.

use super::Core;
use crate::formats::Widths;
use crate::leaf::{Leaf, QueryWord};
use crate::stream::{Lane, Photon, Sums};

/// A field of a stream's word.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct StreamField {
    /// The name of the field.
    pub name: String,
    /// Its lowest bit.
    pub low: u32,
    /// Its bits.
    pub width: u32,
}

/// The fields of a word, and its length.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StreamWord {
    /// The fields, the lowest first.
    pub fields: Vec<StreamField>,
    /// The bits of `tdata`: a power of two of bytes that has room for all fields.
    pub bits: u32,
}

/// The words of the three streams of a core.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CoreStreams {
    /// `s_axis_photons`: the photons of a leaf one after the other, then `facing`.
    pub photons: StreamWord,
    /// `s_axis_queries`: `x`, `y`, `z`, `tag`, each from a multiple of 16 bits on, `facings`, `release`, and `radius_sq` where each
    /// query has a radius.
    pub queries: StreamWord,
    /// `m_axis_results`: the sums, the count, `tag`, and `radius_sq` where each query has a radius.
    pub results: StreamWord,
}

/// The fields of a result.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct QueryResult {
    /// The sums.
    pub sums: Sums,
    /// The tag.
    pub tag: u32,
    /// The radius, where each query has one.
    pub radius_sq: Option<u32>,
}

/// Bits between the first bits of a query's coordinates and tag.
const QUERY_STEP: u32 = 16;

impl StreamWord {
    /// A word of these fields side by side.
    fn side_by_side(fields: impl IntoIterator<Item = (String, u32)>) -> Self {
        let mut word = Self::default();
        for (name, width) in fields {
            word.push(name, width);
        }
        word.padded()
    }

    fn push(&mut self, name: impl Into<String>, width: u32) {
        let low = self.end();
        let name = name.into();
        self.fields.push(StreamField { name, low, width });
    }

    /// The bits up to the last field's end.
    pub fn end(&self) -> u32 {
        self.fields
            .last()
            .map_or(0, |field| field.low + field.width)
    }

    fn padded(mut self) -> Self {
        self.bits = 8 * self.end().div_ceil(8).next_power_of_two();
        self
    }

    /// The field of that name.
    ///
    /// # Panics
    /// Where there is none.
    pub fn field(&self, name: &str) -> &StreamField {
        let field = self.fields.iter().find(|field| field.name == name);
        field.unwrap_or_else(|| panic!("the word has no field `{name}`"))
    }

    /// The bytes of a word with these values, in the order of the fields; byte 0 has bits 0 to 7.
    ///
    /// # Panics
    /// Where a value has more bits than its field, or there are not as many values as fields.
    pub fn bytes(&self, values: &[u64]) -> Vec<u8> {
        assert_eq!(values.len(), self.fields.len(), "a value for each field");
        let mut bytes = vec![0; self.bits as usize / 8];
        for (field, &value) in self.fields.iter().zip(values) {
            assert!(
                field.width == u64::BITS || value >> field.width == 0,
                "{} does not fit field {} of {} bits",
                value,
                field.name,
                field.width
            );
            for bit in (0..field.width).filter(|bit| value >> bit & 1 == 1) {
                let place = field.low + bit;
                bytes[place as usize / 8] |= 1 << (place % 8);
            }
        }
        bytes
    }

    /// The values of the fields of a word.
    ///
    /// # Panics
    /// Where the word is shorter than its bits.
    pub fn values(&self, bytes: &[u8]) -> Vec<u64> {
        let value = |field: &StreamField| {
            let bits = (0..field.width).map(|bit| {
                let place = field.low + bit;
                u64::from(bytes[place as usize / 8] >> (place % 8) & 1) << bit
            });
            bits.sum()
        };
        self.fields.iter().map(value).collect()
    }
}

impl CoreStreams {
    /// The words of a core.
    pub fn of(core: &Core) -> Self {
        Self {
            photons: photons(core),
            queries: queries(core),
            results: results(core),
        }
    }

    /// The values of a leaf's fields. Absent photons have zeros.
    ///
    /// # Panics
    /// Where there are more photons than a leaf has.
    pub fn leaf_values(core: &Core, photons: &[Photon], facing: u32) -> Vec<u64> {
        assert!(
            photons.len() <= Core::LEAF_PHOTONS,
            "a leaf has at most 8 photons"
        );
        let lane = |place: usize| Lane {
            present: place < photons.len(),
            photon: photons.get(place).copied().unwrap_or_default(),
        };
        let lanes = (0..Core::LEAF_PHOTONS).map(lane);
        let mut values: Vec<_> = lanes.flat_map(|lane| lane_values(core, &lane)).collect();
        values.push(u64::from(facing));
        values
    }

    /// The lanes of a leaf and its facing, from the values of its fields.
    pub fn leaf_of(core: &Core, values: &[u64]) -> ([Lane; Core::LEAF_PHOTONS], u32) {
        let of_lane = (values.len() - 1) / Core::LEAF_PHOTONS;
        let lane = |place: usize| lane_of(core, &values[of_lane * place..][..of_lane]);
        let facing = values[values.len() - 1] as u32;
        (std::array::from_fn(lane), facing)
    }

    /// The values of a query's fields.
    pub fn query_values(core: &Core, query: &QueryWord) -> Vec<u64> {
        let [x, y, z] = query.query.position;
        let batch = query.batch;
        let values = [x, y, z, batch.tag, batch.facings, u32::from(query.release)];
        let radius_sq = core.has_radii().then_some(query.query.radius_sq);
        values.into_iter().chain(radius_sq).map(u64::from).collect()
    }

    /// A result, from the values of its fields.
    pub fn result_of(core: &Core, values: &[u64]) -> QueryResult {
        let channels = core.machine.channels().names().len();
        let power = |channel: usize| match channel < channels {
            true => u128::from(values[channel]),
            false => 0,
        };
        let sums = Sums {
            power: std::array::from_fn(power),
            count: values[channels],
        };
        QueryResult {
            sums,
            tag: values[channels + 1] as u32,
            radius_sq: values.get(channels + 2).map(|&radius_sq| radius_sq as u32),
        }
    }

    /// The values of a result's fields.
    pub fn result_values(core: &Core, result: &QueryResult) -> Vec<u64> {
        let channels = core.machine.channels().names().len();
        // A sum has at most 64 bits.
        let powers = result.sums.power[..channels].iter();
        let powers = powers.map(|&power| power as u64);
        let others = [result.sums.count, result.tag.into()];
        let radius_sq = result.radius_sq.map(u64::from);
        powers.chain(others).chain(radius_sq).collect()
    }
}

fn photons(core: &Core) -> StreamWord {
    let widths = Widths::of(core.machine);
    let channels = core.machine.channels().names();
    let lane = |place: usize| {
        let of = move |name: &str| format!("{name}_{place}");
        let coordinates = ["x", "y", "z"].map(|axis| (of(axis), widths.photon));
        let powers = channels
            .iter()
            .map(move |channel| (of(channel), widths.mantissa));
        let exponent = (widths.exponent > 0).then(|| (of("exponent"), widths.exponent));
        let present = (of("present"), 1);
        [present]
            .into_iter()
            .chain(coordinates)
            .chain(powers)
            .chain(exponent)
    };
    let lanes = (0..Core::LEAF_PHOTONS).flat_map(lane);
    StreamWord::side_by_side(lanes.chain([("facing".to_owned(), Leaf::FACING_BITS)]))
}

fn lane_values(core: &Core, lane: &Lane) -> Vec<u64> {
    let channels = core.machine.channels().names().len();
    let photon = &lane.photon;
    let mut values = vec![u64::from(lane.present)];
    values.extend(photon.position.map(u64::from));
    values.extend(
        photon.power[..channels]
            .iter()
            .map(|&power| u64::from(power)),
    );
    values.extend(
        core.machine
            .has_exponent()
            .then_some(u64::from(photon.exponent)),
    );
    values
}

fn lane_of(core: &Core, values: &[u64]) -> Lane {
    let channels = core.machine.channels().names().len();
    let at = |place: usize| values[place] as u32;
    let power = |channel: usize| {
        if channel < channels {
            at(4 + channel)
        } else {
            0
        }
    };
    Lane {
        present: values[0] != 0,
        photon: Photon {
            position: [at(1), at(2), at(3)],
            power: std::array::from_fn(power),
            exponent: match core.machine.has_exponent() {
                true => at(4 + channels),
                false => 0,
            },
        },
    }
}

fn queries(core: &Core) -> StreamWord {
    let widths = Widths::of(core.machine);
    let names = ["x", "y", "z"].map(|axis| (axis, widths.coordinate));
    let mut word = StreamWord::default();
    for (place, (name, width)) in (0..).zip(names.into_iter().chain([("tag", Core::TAG_BITS)])) {
        word.fields.push(StreamField {
            name: name.to_owned(),
            low: QUERY_STEP * place,
            width,
        });
    }
    word.push("facings", Leaf::FACINGS);
    word.push("release", 1);
    if core.has_radii() {
        word.push("radius_sq", widths.radius_sq);
    }
    word.padded()
}

fn results(core: &Core) -> StreamWord {
    let widths = Widths::of(core.machine);
    let channels = core.machine.channels().names();
    let sums = channels
        .iter()
        .map(|channel| ((*channel).to_owned(), widths.sum));
    let others = [("count", widths.count), ("tag", Core::TAG_BITS)];
    let radius = core.has_radii().then_some(("radius_sq", widths.radius_sq));
    let others = others.into_iter().chain(radius);
    StreamWord::side_by_side(sums.chain(others.map(|(name, width)| (name.to_owned(), width))))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::machines::find_machine;
    use crate::stream::{BatchPins, Query};

    fn core(name: &str) -> Core {
        Core::new(find_machine(name).unwrap(), 2).unwrap()
    }

    #[test]
    fn words_are_read_back_in_every_format() {
        for name in [
            "leaf-5-local7-rgb6d-n64",
            "leaf-4-local6x2-rgb4d-n64",
            "leaf-5-local8-rgb8e5-n4096",
            "leaf-4-radii-local6x2-rgb4d-n64",
        ] {
            let core = core(name);
            let streams = CoreStreams::of(&core);
            let photon = |seed: u32| Photon {
                position: [seed, seed + 1, seed + 2],
                power: [3, 4, 5],
                exponent: u32::from(core.machine.has_exponent()) * 7,
            };
            let photons: Vec<_> = (0..5).map(photon).collect();
            let values = CoreStreams::leaf_values(&core, &photons, 9);
            let bytes = streams.photons.bytes(&values);
            assert_eq!(bytes.len() as u32 * 8, streams.photons.bits);
            assert_eq!(streams.photons.values(&bytes), values);
            let (lanes, facing) = CoreStreams::leaf_of(&core, &values);
            assert_eq!(facing, 9);
            let present: Vec<_> = lanes
                .iter()
                .filter(|lane| lane.present)
                .map(|lane| lane.photon)
                .collect();
            assert_eq!(present, photons);
        }
    }

    #[test]
    fn the_fields_of_a_query_begin_at_multiples_of_16_bits() {
        let core = core("leaf-5-local7-rgb6d-n64");
        let word = CoreStreams::of(&core).queries;
        let query = QueryWord {
            query: Query {
                position: [1, 2, 3],
                radius_sq: 0,
            },
            release: true,
            batch: BatchPins {
                last: true,
                facings: 5,
                tag: 4,
            },
        };
        let bytes = word.bytes(&CoreStreams::query_values(&core, &query));
        assert_eq!(bytes, [1, 0, 2, 0, 3, 0, 4, 0, 5, 0, 0, 0, 1, 0, 0, 0]);
    }

    #[test]
    fn a_query_has_a_radius_only_where_the_machine_has_it() {
        let [fixed, radii] = ["leaf-5-local7-rgb6d-n64", "leaf-5-radii-local7-rgb6d-n64"].map(core);
        let query = QueryWord {
            query: Query {
                position: [1, 2, 3],
                radius_sq: 0x1234,
            },
            ..QueryWord::default()
        };
        let values = |core: &Core| CoreStreams::query_values(core, &query);
        assert_eq!(values(&fixed), [1, 2, 3, 0, 0, 0]);
        assert_eq!(values(&radii), [1, 2, 3, 0, 0, 0, 0x1234]);
        let word = CoreStreams::of(&radii).queries;
        assert_eq!(word.field("radius_sq").width, 14);
        assert_eq!(word.bits, CoreStreams::of(&fixed).queries.bits);
        assert_eq!(word.values(&word.bytes(&values(&radii))), values(&radii));
    }

    #[test]
    #[should_panic(expected = "512 does not fit field x of 9 bits")]
    fn a_value_that_does_not_fit_is_refused() {
        let word = CoreStreams::of(&core("leaf-5-local7-rgb6d-n64")).queries;
        word.bytes(&[512, 0, 0, 0, 0, 0]);
    }
}
