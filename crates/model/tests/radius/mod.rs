//! Tests of gathers at other radii than the format's.

use super::*;

/// 4 d^2 of all photons, in ascending order.
fn sorted_quarters(format: &PhotonFormat, query: &LocalQuery, blocks: &[Block]) -> Vec<u64> {
    let of = |block: &Block| {
        let photons = block.photons.iter();
        let quarters = photons.map(|p| quarters(format, query, block.offset, p) as u64);
        quarters.collect::<Vec<_>>()
    };
    let mut all: Vec<u64> = blocks.iter().flat_map(of).collect();
    all.sort_unstable();
    all
}

proptest! {
    /// At any radius, exactly the photons whose d^2 is within it are counted. The radius is that of a photon
    /// of the case, so ties occur.
    #[test]
    fn any_smaller_radius_decides_exactly((format, query, blocks) in case(), pick in any::<u32>()) {
        let gather = LocalGather::new(&format).unwrap();
        let max = gather.radius_sq();
        let quarters = sorted_quarters(&format, &query, &blocks);
        let tie = quarters.get(pick as usize % quarters.len().max(1)).map_or(0, |q| q.div_ceil(4));
        for radius_sq in [pick % (max + 1), tie.min(u64::from(max)) as u32, 0, max] {
            let within = quarters.iter().filter(|q| **q <= 4 * u64::from(radius_sq));
            let sums = gather.gather_within(&query, radius_sq, blocks.iter().map(Block::view));
            prop_assert_eq!(sums.unwrap().count, within.count() as u64);
        }
        let full = gather.gather_within(&query, max, blocks.iter().map(Block::view)).unwrap();
        prop_assert_eq!(full, self::gather(&format, &query, &blocks));
    }
}

#[test]
fn a_radius_over_the_formats_is_refused_with_the_limit_and_by_how_much() {
    let gather = LocalGather::new(DEFAULT).unwrap();
    let wider = gather.gather_within(&query_at([256; 3]), 254 * 254 + 3, []);
    let message = wider.unwrap_err().to_string();
    assert_eq!(
        message,
        "radius_sq is 64519, 3 over the largest that format `local8-rgb8e5` holds, 64516"
    );
}
