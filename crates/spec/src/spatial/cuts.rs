//! The places in the pipeline of a spatial machine's engine where pipeline registers may stand.

/// A place in the pipeline of an engine where a pipeline register may stand. These places process a photon's
/// position and the query:
///
/// | place | value in the register, for each photon |
/// |---|---|
/// | `Difference` | on each axis d = query - photon, signed |
/// | `Magnitude` | on each axis the magnitude of d; or d, for a squarer that needs no magnitude |
/// | `Products` | on each axis m, the magnitude modulo 2^r; the far flag; and the products of m's digits; or d |
/// | `Cross` | on each axis m, the far flag, and the product of m's two digits; or the whole square |
/// | `Square` | on each axis d^2 in 2 r bits, and the far flag |
/// | `SquareDelay` | on each axis d^2 and the far flag one clock later, beside the sum of squares: a block RAM may be far from it |
/// | `Pair` | x^2 + y^2; z^2; whether any axis is far |
/// | `Distance` | the sum of the three squares; whether any axis is far |
/// | `Range` | the in-range flag |
/// | `RangeDelay` | the in-range flag one clock later, and the flags of the group one clock later |
/// | `Decision` | a copy of the in-range flag for each word that is summed, beside the sum of that word |
///
/// An axis is *far* where the magnitude exceeds r bits. For the products see
/// [`super::EngineRegister::LowProduct`]. The whole square comes from a table or from one product.
///
/// These places process the powers of a group:
///
/// | place | value in the register |
/// |---|---|
/// | `Gate` | powers and presence, 0 where the photon is out of range |
/// | `PairPower` | the sums of powers and counts over photons 0 and 1, and over photons 2 and 3 |
/// | `GroupPower` | the sums of powers and counts over the group |
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)] // the table says what they are
pub enum Cut {
    Difference,
    Magnitude,
    Products,
    Cross,
    Square,
    SquareDelay,
    Pair,
    Distance,
    Range,
    RangeDelay,
    Decision,
    Gate,
    PairPower,
    GroupPower,
}

impl Cut {
    /// All places, in the order in which values pass them.
    pub const ALL: [Self; 14] = [
        Self::Difference,
        Self::Magnitude,
        Self::Products,
        Self::Cross,
        Self::Square,
        Self::SquareDelay,
        Self::Pair,
        Self::Distance,
        Self::Range,
        Self::RangeDelay,
        Self::Decision,
        Self::Gate,
        Self::PairPower,
        Self::GroupPower,
    ];

    /// Whether the place processes positions. The powers of a group are delayed by the latency of these
    /// places.
    pub fn is_of_positions(self) -> bool {
        self <= Self::Decision
    }
}

/// A set of places: the pipeline registers of an engine.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct Cuts(u16);

impl Cuts {
    /// The set of these places.
    pub const fn of(cuts: &[Cut]) -> Self {
        let mut set = 0;
        let mut index = 0;
        while index < cuts.len() {
            set |= 1 << cuts[index] as u16;
            index += 1;
        }
        Self(set)
    }

    /// This set with one more place.
    pub const fn and(self, cut: Cut) -> Self {
        Self(self.0 | 1 << cut as u16)
    }

    /// Whether a pipeline register stands at the place.
    pub const fn has(self, cut: Cut) -> bool {
        self.0 >> cut as u16 & 1 == 1
    }

    /// Clocks from a position in an engine's hop register to the in-range flag of this engine, without waits
    /// for slower engines: the number of registers that process positions.
    pub fn latency(self) -> u32 {
        let registers = Cut::ALL.into_iter().filter(|cut| cut.is_of_positions());
        registers.filter(|&cut| self.has(cut)).count() as u32
    }

    /// Clocks from powers in an engine's hop register to the sums.
    pub fn power_latency(self) -> u32 {
        let registers = Cut::ALL.into_iter().filter(|cut| !cut.is_of_positions());
        1 + registers.filter(|&cut| self.has(cut)).count() as u32
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_has_its_cuts_and_no_other() {
        let cuts = Cuts::of(&[Cut::Magnitude, Cut::Range, Cut::GroupPower]);
        let had: Vec<_> = Cut::ALL.into_iter().filter(|&cut| cuts.has(cut)).collect();
        assert_eq!(had, [Cut::Magnitude, Cut::Range, Cut::GroupPower]);
        assert_eq!((cuts.latency(), cuts.power_latency()), (2, 2));
    }
}
