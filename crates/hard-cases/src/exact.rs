//! The exact in-range decision, from the definition alone: no clamp, no half squares, no saturation.

use photoncube_spec::{PhotonFormat, PhotonRecord, Query};

use super::case::HardCaseError;
use super::room::NORMAL;
use super::setting::Setting;
use photoncube_render::QuantisedMap;

/// A photon in the frame of a query of a format.
#[derive(Debug, Clone, Copy)]
pub(super) struct Met {
    /// The distances between both middles on each axis, in halves of a fine step.
    pub halves: [i64; 3],
    /// The format's decision.
    pub in_range: bool,
}

impl Met {
    /// The exact decision.
    pub fn truly(&self, format: &PhotonFormat) -> bool {
        let distance_sq: i64 = self.halves.iter().map(|h| h * h).sum();
        distance_sq <= (2 * i64::from(format.radius_steps())).pow(2)
    }

    /// The whole steps on each axis; on half steps, half a step less than the distance.
    pub fn steps(&self) -> [u64; 3] {
        self.halves.map(|halves| halves.unsigned_abs() / 2)
    }
}

/// Every pair of a query and a photon that it gathers, for a setting.
pub(super) fn all_met(setting: &Setting, format: &PhotonFormat) -> Result<Vec<Met>, HardCaseError> {
    let quantised = QuantisedMap::new(&setting.map, &format.into())?;
    let mut all = Vec::new();
    for &place in &setting.queries {
        let query = quantised.query(place);
        let verdicts = quantised
            .verdicts(place, NORMAL)
            .map(|(_, verdict)| verdict);
        let blocks = quantised.blocks(place, NORMAL);
        let photons = blocks.flat_map(|block| block.photons.iter().map(move |p| (block.offset, p)));
        all.extend(
            photons
                .zip(verdicts)
                .map(|((offset, record), in_range)| Met {
                    halves: halves(format, &query, offset, record),
                    in_range,
                }),
        );
    }
    Ok(all)
}

fn halves(
    format: &PhotonFormat,
    query: &Query,
    offset: [u32; 3],
    record: &PhotonRecord,
) -> [i64; 3] {
    std::array::from_fn(|axis| {
        let block = i64::from(offset[axis]) << format.position_bits;
        let cell = block + i64::from(record.position[axis]);
        let photon = (2 * cell + 1) << format.query_extra_bits;
        2 * i64::from(query.position[axis]) + 1 - photon
    })
}
