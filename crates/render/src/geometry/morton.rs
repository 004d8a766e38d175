//! The Morton curve, an order in which places that are close are mostly close in the order too.

/// The place on a Morton curve: the bits of the three coordinates, interleaved. Coordinates have at most 21 bits.
pub(crate) fn morton(place: [u64; 3]) -> u64 {
    let [x, y, z] = place.map(spread);
    x | y << 1 | z << 2
}

/// The low 21 bits, each followed by two zeros.
fn spread(index: u64) -> u64 {
    (0..21).fold(0, |code, bit| code | (index >> bit & 1) << (3 * bit))
}
