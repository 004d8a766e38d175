//! Random words for pins whose valid pin is low.

use photoncube_spec::{BatchPins, Group, Leaf, Photon, Query};
use rand::{Rng, RngExt};

use super::cases::Cases;

impl<R: Rng> Cases<'_, R> {
    /// A query of random words, for the query pins while they are not valid.
    pub fn garbage_query(&mut self) -> Query {
        Query {
            position: [(); 3].map(|()| self.uniform(self.widths.coordinate)),
            radius_sq: match self.fixed_radius_sq {
                Some(fixed) => fixed,
                None => self.uniform(self.widths.radius_sq),
            },
        }
    }

    /// Random words for the query pins of a leaf machine.
    pub fn garbage_batch(&mut self) -> BatchPins {
        match self.has_leaves {
            false => BatchPins::default(),
            true => BatchPins {
                last: self.rng.random(),
                facings: self.rng.random(),
                tag: self.uniform(Leaf::TAG_BITS),
            },
        }
    }

    /// Fills `group` with random words, for its pins while they are not valid.
    pub fn garbage_group(&mut self, group: &mut Group) {
        group.last = self.rng.random();
        group.facing = self.facing();
        for lane in &mut group.lanes {
            lane.present = self.rng.random();
            lane.photon = Photon {
                position: [(); 3].map(|()| self.uniform(self.widths.photon)),
                // Words without pins are 0.
                power: self.full.power.map(|full| self.rng.random::<u32>() & full),
                exponent: match self.widths.exponent {
                    0 => 0,
                    bits => self.uniform(bits),
                },
            };
        }
    }
}
