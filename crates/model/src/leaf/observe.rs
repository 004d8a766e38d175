//! Lists all registers as numbers, in the order of [`photoncube_spec::Pins::observed`].

use photoncube_spec::{Group, LeafRegister, LeafRow};

use super::LeafMachine;
use super::boxes::{Bounds, Stage};
use super::scan::{Looked, Pair};

/// The low borders of boxes, axis by axis.
fn low<'a>(boxes: &'a [Bounds]) -> impl Iterator<Item = u64> + 'a {
    boxes.iter().flat_map(|bounds| bounds.low.map(u64::from))
}

fn high<'a>(boxes: &'a [Bounds]) -> impl Iterator<Item = u64> + 'a {
    boxes.iter().flat_map(|bounds| bounds.high.map(u64::from))
}

impl LeafMachine {
    /// Appends the registers, except those of the chain.
    pub(super) fn observe_leaf(&self, row: &mut Vec<u64>) {
        for table_row in LeafRow::ALL {
            self.register(table_row.register, row);
        }
    }

    fn register(&self, register: LeafRegister, row: &mut Vec<u64>) {
        use LeafRegister as R;
        let (fill, boxes, former, scan) = (&self.fill, &self.boxes, &self.former, &self.scan);
        let (player, tags) = (&self.player, &self.tags);
        let mut one = |value: u64| row.push(value);
        match register {
            R::FillBank => one(fill.bank as u64),
            R::FillPlace => one(fill.place as u64),
            R::FillReady => one(fill.ready.into()),
            R::Filled => fill.filled.into_iter().for_each(|bit| one(bit.into())),
            R::WriteValid => one(fill.write.valid.into()),
            R::WriteBank => one(fill.write.bank as u64),
            R::WritePlace => one(fill.write.place as u64),
            R::WriteLast => one(fill.write.last.into()),
            R::WriteFacing => one(self.memory.write.facing.into()),
            R::HalfValid | R::GroupValid | R::BoxValid => one(self.stage(register).valid.into()),
            R::HalfBank | R::GroupBank | R::BoxBank => one(self.stage(register).bank as u64),
            R::HalfPlace | R::GroupPlace | R::BoxLeaf => one(self.stage(register).place as u64),
            R::HalfLast | R::GroupLast | R::BoxLast => one(self.stage(register).last.into()),
            R::HalfFacing | R::GroupFacing => one(self.stage(register).facing.into()),
            R::HalfLow => row.extend(low(&boxes.halves)),
            R::HalfHigh => row.extend(high(&boxes.halves)),
            R::GroupLow => row.extend(low(&[boxes.of_group])),
            R::GroupHigh => row.extend(high(&[boxes.of_group])),
            R::BoxShort => boxes.notes.iter().for_each(|note| one(note.short.into())),
            R::BoxFacing => boxes.notes.iter().for_each(|note| one(note.facing.into())),
            R::BoxLow => row.extend(low(&boxes.of_leaf)),
            R::BoxHigh => row.extend(high(&boxes.of_leaf)),
            R::Full => boxes.sets.iter().for_each(|set| one(set.full.into())),
            R::End => boxes.sets.iter().for_each(|set| one(set.end as u64)),
            R::Loaded => one(former.loaded.into()),
            R::Closed => one(former.closed.into()),
            R::Release => one(former.release.into()),
            R::Facings => one(former.facings.into()),
            R::QueryLow => row.extend(low(&[former.bounds])),
            R::QueryHigh => row.extend(high(&[former.bounds])),
            R::Starting => one(scan.starting.into()),
            R::Started => one(scan.started.into()),
            R::Scanning => one(scan.scanning.into()),
            R::ScanBank => one(scan.bank as u64),
            R::ScanPair => one(scan.pair as u64),
            R::ScanEnd => one(scan.end as u64),
            R::ScanRelease => one(scan.release.into()),
            R::ScanFacings => one(scan.facings.into()),
            R::ScanLow => row.extend(low(&[scan.bounds])),
            R::ScanHigh => row.extend(high(&[scan.bounds])),
            R::Returned => one(scan.returned.into()),
            R::Used => one(scan.used.into()),
            R::QueueWrite => one(scan.queue_write.into()),
            R::QueueRead => one(scan.queue_read.into()),
            R::QueueCount => one(scan.queued() as u64),
            R::EntryValid => one(player.entry.valid.into()),
            R::EntryMask => one(player.entry.mask.into()),
            R::EntryLast => one(player.entry.last.into()),
            R::EntryPair => one(player.entry.pair.pair as u64),
            R::EntryBank => one(player.entry.pair.bank as u64),
            R::EntryEnd => one(player.entry.pair.end.into()),
            R::EntryRelease => one(player.entry.pair.release.into()),
            R::MayEnd => one(player.may_end.into()),
            R::Spacing => one(player.spacing.into()),
            R::Outstanding => one(player.outstanding.into()),
            R::ReadValid => one(player.read.valid.into()),
            R::ReadLast => one(player.read.last.into()),
            R::ReadBlank => one(player.read.blank.into()),
            R::WordValid => one(player.word.valid.into()),
            R::WordLast => one(player.word.last.into()),
            R::WordBlank => one(player.word.blank.into()),
            R::TagWrite => one(tags.write as u64),
            R::TagRead => one(tags.read as u64),
            R::HasOldest => one(tags.has_oldest.into()),
            R::Oldest => one(tags.oldest_word()),
            R::TagResult => one(tags.result.into()),
            R::WritePresent | R::WritePosition | R::WritePower | R::WriteExponent => {
                self.words(register, &self.memory.write, row);
            }
            R::ReadPresent | R::ReadPosition | R::ReadPower | R::ReadExponent => {
                self.words(register, &self.memory.read, row);
            }
            R::WordPresent | R::WordPosition | R::WordPower | R::WordExponent => {
                self.words(register, &self.memory.word, row);
            }
            R::CullValid | R::CullPair | R::CullBank | R::CullEnd | R::CullRelease => {
                let stages = scan
                    .cull
                    .iter()
                    .map(|culled| of_pair(register, culled.pair));
                row.extend(stages);
            }
            R::CullSet => {
                let bit = |(place, &bit): (usize, &bool)| u64::from(bit) << place;
                let set = |near: [bool; 4]| near.iter().enumerate().map(bit).sum::<u64>();
                row.extend(scan.cull[0].near.map(set));
            }
            R::CullFacing => row.extend(scan.cull[0].facing.map(|facing| facing as u64)),
            R::CullGathered => {
                let stages = scan.cull.iter().skip(1).flat_map(|culled| culled.gathered);
                row.extend(stages.map(u64::from));
            }
            R::CullShort => {
                let stages = scan.cull.iter().flat_map(|culled| culled.short);
                row.extend(stages.map(u64::from));
            }
            R::LookValid
            | R::LookPair
            | R::LookBank
            | R::LookEnd
            | R::LookRelease
            | R::LookSecond
            | R::LookLow
            | R::LookHigh
            | R::LookFacing
            | R::LookShort => looked(register, &scan.look, row),
            _ => looked(register, &scan.found, row),
        }
    }

    /// The stage of the boxes that a register is in.
    fn stage(&self, register: LeafRegister) -> Stage {
        use LeafRegister as R;
        match register {
            R::HalfValid | R::HalfBank | R::HalfPlace | R::HalfLast | R::HalfFacing => {
                self.boxes.half
            }
            R::GroupValid | R::GroupBank | R::GroupPlace | R::GroupLast | R::GroupFacing => {
                self.boxes.group
            }
            _ => self.boxes.leaf,
        }
    }

    fn words(&self, register: LeafRegister, group: &Group, row: &mut Vec<u64>) {
        use LeafRegister as R;
        let channels = self.machine.channels().names().len();
        let lanes = group.lanes.iter();
        match register {
            R::WritePresent | R::ReadPresent | R::WordPresent => {
                row.extend(lanes.map(|lane| u64::from(lane.present)));
            }
            R::WritePosition | R::ReadPosition | R::WordPosition => {
                row.extend(lanes.flat_map(|lane| lane.photon.position.map(u64::from)));
            }
            R::WritePower | R::ReadPower | R::WordPower => {
                let powers = lanes.flat_map(|lane| &lane.photon.power[..channels]);
                row.extend(powers.map(|&power| u64::from(power)));
            }
            _ if self.machine.has_exponent() => {
                row.extend(lanes.map(|lane| u64::from(lane.photon.exponent)));
            }
            _ => {}
        }
    }
}

fn of_pair(register: LeafRegister, pair: Pair) -> u64 {
    use LeafRegister as R;
    match register {
        R::LookValid | R::FoundValid | R::CullValid => pair.valid.into(),
        R::LookPair | R::FoundPair | R::CullPair => pair.pair as u64,
        R::LookBank | R::FoundBank | R::CullBank => pair.bank as u64,
        R::LookEnd | R::FoundEnd | R::CullEnd => pair.end.into(),
        _ => pair.release.into(),
    }
}

fn looked(register: LeafRegister, looked: &Looked, row: &mut Vec<u64>) {
    use LeafRegister as R;
    let boxes = looked.leaves.map(|leaf| leaf.groups).concat();
    match register {
        R::LookSecond | R::FoundSecond => row.push(looked.second.into()),
        R::LookLow | R::FoundLow => row.extend(low(&boxes)),
        R::LookHigh | R::FoundHigh => row.extend(high(&boxes)),
        R::LookFacing | R::FoundFacing => {
            row.extend(looked.leaves.map(|leaf| u64::from(leaf.note.facing)));
        }
        R::LookShort | R::FoundShort => {
            row.extend(looked.leaves.map(|leaf| u64::from(leaf.note.short)));
        }
        _ => row.push(of_pair(register, looked.pair)),
    }
}
