//! The exact in-range decision, from the definition alone: no clamp, no half squares, no saturation.

use photoncube_model::{GatherError, Gathered, Instructions, PhotonPlanes, PlacedQuery};
use photoncube_spec::{PhotonBlock, PhotonFormat, PhotonRecord, Query};

use super::case::HardCaseError;
use super::room::FRONT;
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

/// Every pair of a query and a photon that it gathers, for a setting. The fast gather decides, whose arithmetic
/// has a clamp, half squares and saturation.
pub(super) fn all_met(setting: &Setting, format: &PhotonFormat) -> Result<Vec<Met>, HardCaseError> {
    let quantised = QuantisedMap::new(&setting.map, &format.into())?;
    let mut all = Vec::new();
    for &place in &setting.queries {
        let query = quantised.query(place);
        for block in quantised.blocks(place, FRONT) {
            for record in block.photons {
                let photons = std::slice::from_ref(record);
                all.push(Met {
                    halves: halves(format, &query, block.offset, record),
                    in_range: counts(format, &query, &PhotonBlock { photons, ..block })?,
                });
            }
        }
    }
    Ok(all)
}

/// Whether the fast gather counts the one photon of a block.
fn counts(
    format: &PhotonFormat,
    query: &Query,
    block: &PhotonBlock<'_>,
) -> Result<bool, HardCaseError> {
    let mut planes = PhotonPlanes::new(format)?;
    let edge = planes.cube_edge();
    let cube = block.offset.map(|at| u64::from(at / edge));
    let in_cube = PhotonBlock {
        offset: block.offset.map(|at| at % edge),
        ..*block
    };
    let stored = planes.push_run(cube, 0, &[in_cube]);
    stored.map_err(GatherError::from)?;
    let placed = PlacedQuery {
        block: [1; 3],
        fraction: query.position.map(|at| (at - format.edge_steps()) as u16),
        facing: 0,
    };
    let mut found = [Gathered::default()];
    let (instructions, radius_sq) = (Instructions::fastest(), query.radius_sq);
    planes.gather(instructions, radius_sq, &[placed], |_, _| true, &mut found)?;
    Ok(found[0].sums.count == 1)
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
