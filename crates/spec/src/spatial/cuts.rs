//! Where the pipeline of a spatial machine has registers.

/// A place in the pipeline of an engine where a register may stand. From a photon's position and
/// the query on:
///
/// | cut | what is there, for each photon |
/// |---|---|
/// | `Difference` | on each axis d = query - photon, signed |
/// | `Magnitude` | on each axis |d|; d once more for a squarer that needs no magnitude |
/// | `Products` | on each axis |d| modulo 2^r, whether it exceeds r bits, and the products of its digits, see [`super::EngineRegister::LowProduct`]; or d |
/// | `Cross` | on each axis |d| modulo 2^r, whether it exceeds r bits, and the product of its two digits; or the square from a table or as one product |
/// | `Square` | on each axis d^2 in 2 r bits, and whether |d| exceeds r bits |
/// | `Pair` | x^2 + y^2; z^2; whether any axis is far |
/// | `Distance` | the sum of the three squares; whether any axis is far |
/// | `Range` | whether the photon is in range |
/// | `RangeDelay` | the same once more, on its way to the sums, as the flags of a group have on theirs |
/// | `Decision` | the same once more, for each word that is summed: one beside each of its sums |
///
/// and from the powers of a group on:
///
/// | cut | what is there |
/// |---|---|
/// | `Gate` | powers and presence, cleared where out of range |
/// | `PairPower` | their sums over photons 0 and 1, and over 2 and 3 |
/// | `GroupPower` | their sums over the group |
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[allow(missing_docs)] // the table says what they are
pub enum Cut {
    Difference,
    Magnitude,
    Products,
    Cross,
    Square,
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
    /// All cuts, in the order of the flow.
    pub const ALL: [Self; 13] = [
        Self::Difference,
        Self::Magnitude,
        Self::Products,
        Self::Cross,
        Self::Square,
        Self::Pair,
        Self::Distance,
        Self::Range,
        Self::RangeDelay,
        Self::Decision,
        Self::Gate,
        Self::PairPower,
        Self::GroupPower,
    ];

    /// Whether the cut is in the flow of positions, whose latency the powers wait for.
    pub fn is_of_positions(self) -> bool {
        self <= Self::Decision
    }
}

/// A set of cuts: a register stands at each of them.
#[derive(Copy, Clone, Debug, PartialEq, Eq, Hash)]
pub struct Cuts(u16);

impl Cuts {
    /// These cuts.
    pub const fn of(cuts: &[Cut]) -> Self {
        let mut set = 0;
        let mut index = 0;
        while index < cuts.len() {
            set |= 1 << cuts[index] as u16;
            index += 1;
        }
        Self(set)
    }

    /// These and that one.
    pub const fn and(self, cut: Cut) -> Self {
        Self(self.0 | 1 << cut as u16)
    }

    /// Whether a register stands at the cut.
    pub const fn has(self, cut: Cut) -> bool {
        self.0 >> cut as u16 & 1 == 1
    }

    /// Clocks from a position in an engine's hop register to the decision whether it is in range, if
    /// it waits for no other engine's: the registers of the flow of positions.
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
