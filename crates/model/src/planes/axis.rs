//! The distance on one axis without a sign: by additions and subtractions that saturate.

/// A query e fine steps into the middle block, on one axis, in words that hold a block's edge less one.
///
/// With c the centre of a photon, the spec's m is
/// - in the middle block (at - c) | (c - above), of which one is 0: above is e, or on half steps e + 1,
///   since a photon above the query is at m = c - e - 1 there;
/// - in the block below it (edge - 1 - c) + from_below, with from_below = e + 1: the photon's way up to the
///   middle block, less one, and the query's;
/// - in the block above it c + from_above, with from_above = edge - e, on half steps one less.
///
/// m saturates at the words' largest value, which is at least the format's clamp, R + 1: so m decides as
/// the clamped difference of the spec does. A way that is too long for a word saturates there too, which
/// takes m with it.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Axis<T> {
    pub at: T,
    pub above: T,
    pub from_below: T,
    pub from_above: T,
}

/// How a block lies to the middle one, on one axis.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) enum Side {
    Middle,
    Below,
    Above,
}

impl Side {
    /// Of a block at this offset in the frame, 0 to 2.
    pub fn of(offset: u32) -> Self {
        [Self::Below, Self::Middle, Self::Above][offset as usize]
    }
}

macro_rules! axis_of_words {
    ($word:ty) => {
        impl Axis<$word> {
            /// The axis of a query `at` fine steps, less than `edge`, into the middle block.
            #[inline(always)]
            pub fn new(at: u32, edge: u32, half_steps: bool) -> Self {
                let half = u32::from(half_steps);
                let word = |steps: u32| steps.min(<$word>::MAX.into()) as $word;
                Self {
                    at: word(at),
                    above: word(at + half),
                    from_below: word(at + 1),
                    from_above: word(edge - at - half),
                }
            }

            /// m for a centre in the middle block.
            #[inline(always)]
            pub fn inside(self, centre: $word) -> $word {
                self.at.saturating_sub(centre) | centre.saturating_sub(self.above)
            }

            /// m for a centre in another block; one below is given as edge - 1 - c.
            #[inline(always)]
            pub fn outside(self, side: Side, centre: $word) -> $word {
                centre.saturating_add(match side {
                    Side::Below => self.from_below,
                    _ => self.from_above,
                })
            }
        }
    };
}

axis_of_words!(u8);
axis_of_words!(u16);

#[cfg(test)]
mod tests {
    use super::*;

    /// The spec's m, clamped to the words.
    fn expected(query: u32, centre: u32, half_steps: bool, largest: u32) -> u32 {
        let d = query as i32 - centre as i32;
        let m = if half_steps && d < 0 { !d } else { d.abs() };
        (m as u32).min(largest)
    }

    macro_rules! every_place {
        ($word:ty, $bits:expr, $step:expr) => {
            for bits in $bits {
                for half_steps in [false, true] {
                    let edge = 1_u32 << bits;
                    let places = || (0..edge).step_by($step).chain([edge - 1]);
                    for at in places() {
                        let axis = Axis::<$word>::new(at, edge, half_steps);
                        // On half steps a centre is a grid line above the block's corner.
                        for centre in places().filter(|c| *c > 0 || !half_steps) {
                            let m = |block: u32| {
                                let centre = block * edge + centre;
                                expected(edge + at, centre, half_steps, <$word>::MAX.into())
                            };
                            let mirrored = (edge - 1 - centre) as $word;
                            let found = [
                                axis.outside(Side::Below, mirrored),
                                axis.inside(centre as $word),
                                axis.outside(Side::Above, centre as $word),
                            ];
                            assert_eq!(
                                found.map(u32::from),
                                [0, 1, 2].map(m),
                                "{bits} {at} {centre}"
                            );
                        }
                    }
                }
            }
        };
    }

    #[test]
    fn bytes_are_right_for_every_query_and_centre() {
        every_place!(u8, 4..=8, 1);
    }

    #[test]
    fn words_are_right_over_the_whole_frame() {
        every_place!(u16, 9..=14, 37);
    }
}
