//! Tests of gathers at other radii than the format's.

use super::*;

/// 4 d^2 of all photons, in ascending order.
fn sorted_quarters(format: &PhotonFormat, query: &Query, blocks: &[Block]) -> Vec<u64> {
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
        let numbers = Numbers::from(format);
        let gather = Gather::new(&numbers).unwrap();
        let max = format.radius_steps().pow(2);
        let quarters = sorted_quarters(&format, &query, &blocks);
        let tie = quarters.get(pick as usize % quarters.len().max(1)).map_or(0, |q| q.div_ceil(4));
        for radius_sq in [pick % (max + 1), tie.min(u64::from(max)) as u32, 0, max] {
            let within = quarters.iter().filter(|q| **q <= 4 * u64::from(radius_sq)).count();
            let count = numbers.radius_word(radius_sq).map_or(0, |radius_sq| {
                let query = Query { radius_sq, ..query };
                gather.sums(&query, blocks.iter().map(Block::view)).unwrap().count
            });
            prop_assert_eq!(count, within as u64);
        }
        prop_assert_eq!(numbers.radius_word(max), Some(format.largest_in_range()));
    }
}

#[test]
fn a_radius_over_the_formats_is_refused_with_the_limit_and_by_how_much() {
    let gather = Gather::new(&DEFAULT.into()).unwrap();
    let query = Query {
        radius_sq: 254 * 254 + 3,
        ..query_at(DEFAULT, [256; 3])
    };
    let message = gather.sums(&query, []).unwrap_err().to_string();
    assert_eq!(
        message,
        "radius_sq is 64519, 3 over the largest that format `local8-rgb8e5` holds, 64516"
    );
}
