//! Reads the boxes of all pairs of a set for a batch, and queues the pairs that have a wanted group.

use photoncube_spec::Leaf;
use rust_hdl::prelude::*;

use super::ram::AsyncRam;
use super::{FACINGS, MASK};
use crate::defaults::defaulted;

/// Issues the pairs of a set. `LB` bits of a leaf's number, `KB = LB - 1` of a pair's, `QN` of the number of places in the queue of pairs.
#[derive(LogicBlock)]
pub(crate) struct Scan<const LB: usize, const KB: usize, const QN: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    /// The batch that can start, if it is complete.
    pub complete: Signal<In, Bit>,
    pub releases: Signal<In, Bit>,
    pub facings: Signal<In, Bits<FACINGS>>,
    pub full_0: Signal<In, Bit>,
    pub full_1: Signal<In, Bit>,
    pub end_0: Signal<In, Bits<LB>>,
    pub end_1: Signal<In, Bits<LB>>,
    /// An issued pair is not queued; a pair leaves the queue.
    pub drops: Signal<In, Bit>,
    pub takes_pair: Signal<In, Bit>,
    pub starts: Signal<Out, Bit>,
    /// The batch started in the clock before: its box is taken now.
    pub takes_box: Signal<Out, Bit>,
    pub issues: Signal<Out, Bit>,
    pub issue_bank: Signal<Out, Bit>,
    pub issue_pair: Signal<Out, Bits<KB>>,
    pub facings_out: Signal<Out, Bits<FACINGS>>,
    pub found_valid_out: Signal<Out, Bit>,
    pub found_pair_out: Signal<Out, Bits<KB>>,
    pub found_bank_out: Signal<Out, Bit>,
    pub found_end_out: Signal<Out, Bit>,
    pub found_release_out: Signal<Out, Bit>,
    pub found_second_out: Signal<Out, Bit>,
    /// The leaves whose boxes are compared.
    pub compared: Signal<Out, Bits<2>>,
    pub starting: DFF<Bit>,
    pub started: DFF<Bit>,
    pub scanning: DFF<Bit>,
    pub scan_bank: DFF<Bit>,
    pub scan_pair: DFF<Bits<KB>>,
    pub scan_end: DFF<Bits<LB>>,
    pub scan_release: DFF<Bit>,
    pub scan_facings: DFF<Bits<FACINGS>>,
    pub used: DFF<Bits<QN>>,
    pub returned: DFF<Bits<2>>,
    pub look_valid: DFF<Bit>,
    pub look_pair: DFF<Bits<KB>>,
    pub look_bank: DFF<Bit>,
    pub look_end: DFF<Bit>,
    pub look_release: DFF<Bit>,
    pub look_second: DFF<Bit>,
    pub found_valid: DFF<Bit>,
    pub found_pair: DFF<Bits<KB>>,
    pub found_bank: DFF<Bit>,
    pub found_end: DFF<Bit>,
    pub found_release: DFF<Bit>,
    pub found_second: DFF<Bit>,
    most_used: Constant<Bits<QN>>,
    is_full: Signal<Local, Bit>,
    end_leaf: Signal<Local, Bits<LB>>,
    end_pair: Signal<Local, Bits<KB>>,
    next_bank: Signal<Local, Bit>,
    is_free: Signal<Local, Bit>,
    may_start: Signal<Local, Bit>,
    start: Signal<Local, Bit>,
    has_place: Signal<Local, Bit>,
    issue: Signal<Local, Bit>,
    is_last: Signal<Local, Bit>,
    issued: Signal<Local, Bits<QN>>,
    used_more: Signal<Local, Bits<QN>>,
    used_less: Signal<Local, Bits<QN>>,
}

impl<const LB: usize, const KB: usize, const QN: usize> Default for Scan<LB, KB, QN> {
    fn default() -> Self {
        defaulted!(Self {
            most_used: Constant::new((1u64 << (QN - 1)).to_bits()),
        };
            clock reset complete releases facings full_0 full_1 end_0 end_1 drops takes_pair starts takes_box issues issue_bank
            issue_pair facings_out found_valid_out found_pair_out found_bank_out found_end_out found_release_out
            found_second_out compared starting started scanning scan_bank scan_pair scan_end scan_release scan_facings used returned look_valid look_pair
            look_bank look_end look_release look_second found_valid found_pair found_bank found_end found_release
            found_second is_full end_leaf end_pair next_bank is_free may_start start has_place issue is_last issued used_more used_less
        )
    }
}

impl<const LB: usize, const KB: usize, const QN: usize> Logic for Scan<LB, KB, QN> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self,
            clock,
            starting,
            started,
            scanning,
            scan_bank,
            scan_pair,
            scan_end,
            scan_release,
            scan_facings,
            used,
            returned,
            look_valid,
            look_pair,
            look_bank,
            look_end,
            look_release,
            look_second,
            found_valid,
            found_pair,
            found_bank,
            found_end,
            found_release,
            found_second
        );
        self.has_place.next = self.used.q.val() != self.most_used.val();
        self.issue.next = self.scanning.q.val() & self.has_place.val();
        self.end_pair.next = self.scan_end.q.val().get_bits::<KB>(1);
        self.is_last.next = self.scan_pair.q.val() == self.end_pair.val();
        self.end_leaf.next = self.end_0.val();
        if self.scan_bank.q.val() {
            self.end_leaf.next = self.end_1.val();
        }
        self.next_bank.next =
            self.scan_bank.q.val() ^ (self.scanning.q.val() & self.scan_release.q.val());
        self.is_full.next = self.full_0.val();
        if self.next_bank.val() {
            self.is_full.next = self.full_1.val();
        }
        self.is_free.next = !self.scanning.q.val() | (self.has_place.val() & self.is_last.val());
        self.may_start.next = self.complete.val() & self.is_full.val() & !self.starting.q.val();
        self.starting.d.next = self.may_start.val() & self.is_free.val();
        self.started.d.next = self.starting.q.val();
        self.start.next = self.starting.q.val();
        self.look_valid.d.next = self.issue.val();
        self.look_pair.d.next = self.scan_pair.q.val();
        self.look_bank.d.next = self.scan_bank.q.val();
        self.look_end.d.next = self.is_last.val();
        self.look_release.d.next = self.scan_release.q.val();
        self.look_second.d.next = !self.is_last.val() | self.scan_end.q.val().get_bit(0);
        if self.issue.val() {
            self.scan_pair.d.next = self.scan_pair.q.val() + 1;
            if self.is_last.val() {
                self.scanning.d.next = false;
                if self.scan_release.q.val() {
                    self.scan_bank.d.next = !self.scan_bank.q.val();
                }
            }
        }
        if self.start.val() {
            self.scanning.d.next = true;
            self.scan_pair.d.next = 0.into();
            self.scan_end.d.next = self.end_leaf.val();
            self.scan_release.d.next = self.releases.val();
        }
        if self.started.q.val() {
            self.scan_facings.d.next = self.facings.val();
        }
        self.issued.next = 0.into();
        if self.issue.val() {
            self.issued.next = 1.into();
        }
        self.used_more.next = self.used.q.val() + self.issued.val();
        self.used_less.next = bit_cast::<QN, 2>(self.returned.q.val());
        self.used.d.next = self.used_more.val() - self.used_less.val();
        self.returned.d.next = 0.into();
        if self.drops.val() | self.takes_pair.val() {
            self.returned.d.next = 1.into();
        }
        if self.drops.val() & self.takes_pair.val() {
            self.returned.d.next = 2.into();
        }
        self.found_valid.d.next = self.look_valid.q.val();
        self.found_pair.d.next = self.look_pair.q.val();
        self.found_bank.d.next = self.look_bank.q.val();
        self.found_end.d.next = self.look_end.q.val();
        self.found_release.d.next = self.look_release.q.val();
        self.found_second.d.next = self.look_second.q.val();
        if self.reset.val() {
            self.starting.d.next = false;
            self.started.d.next = false;
            self.scanning.d.next = false;
            self.scan_bank.d.next = false;
            self.used.d.next = 0.into();
            self.returned.d.next = 0.into();
            self.look_valid.d.next = false;
            self.found_valid.d.next = false;
        }
        self.starts.next = self.start.val();
        self.takes_box.next = self.started.q.val();
        self.issues.next = self.issue.val();
        self.issue_bank.next = self.scan_bank.q.val();
        self.issue_pair.next = self.scan_pair.q.val();
        self.facings_out.next = self.scan_facings.q.val();
        self.found_valid_out.next = self.found_valid.q.val();
        self.found_pair_out.next = self.found_pair.q.val();
        self.found_bank_out.next = self.found_bank.q.val();
        self.found_end_out.next = self.found_end.q.val();
        self.found_release_out.next = self.found_release.q.val();
        self.found_second_out.next = self.found_second.q.val();
        self.compared.next = 0.into();
        if self.found_valid.q.val() {
            self.compared.next = 1.into();
            if self.found_second.q.val() {
                self.compared.next = 2.into();
            }
        }
    }
}

/// A stage beside the comparison of boxes. `KB` bits of a pair's number.
#[derive(LogicBlock, Default)]
pub(crate) struct CullStage<const KB: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub valid_in: Signal<In, Bit>,
    pub pair_in: Signal<In, Bits<KB>>,
    pub bank_in: Signal<In, Bit>,
    pub end_in: Signal<In, Bit>,
    pub release_in: Signal<In, Bit>,
    pub short_in: [Signal<In, Bit>; Leaf::PAIR],
    pub valid_out: Signal<Out, Bit>,
    pub pair_out: Signal<Out, Bits<KB>>,
    pub bank_out: Signal<Out, Bit>,
    pub end_out: Signal<Out, Bit>,
    pub release_out: Signal<Out, Bit>,
    pub short_out: [Signal<Out, Bit>; Leaf::PAIR],
    pub valid: DFF<Bit>,
    pub pair: DFF<Bits<KB>>,
    pub bank: DFF<Bit>,
    pub end_of_set: DFF<Bit>,
    pub releases: DFF<Bit>,
    pub short: [DFF<Bit>; Leaf::PAIR],
}

impl<const KB: usize> Logic for CullStage<KB> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, valid, pair, bank, end_of_set, releases);
        self.valid.d.next = self.valid_in.val() & !self.reset.val();
        self.pair.d.next = self.pair_in.val();
        self.bank.d.next = self.bank_in.val();
        self.end_of_set.d.next = self.end_in.val();
        self.releases.d.next = self.release_in.val();
        self.valid_out.next = self.valid.q.val();
        self.pair_out.next = self.pair.q.val();
        self.bank_out.next = self.bank.q.val();
        self.end_out.next = self.end_of_set.q.val();
        self.release_out.next = self.releases.q.val();
        for i in 0..2 {
            self.short[i].clock.next = self.clock.val();
            self.short[i].d.next = self.short_in[i].val();
            self.short_out[i].next = self.short[i].q.val();
        }
    }
}

/// The queue of pairs with a wanted group, and of the last pairs of batches. `KB` bits of a pair's number, `QB` of a place,
/// `QN = QB + 1` of the number of pairs.
#[derive(LogicBlock, Default)]
pub(crate) struct PairQueue<const KB: usize, const QB: usize, const QN: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    /// The pair that was compared.
    pub valid: Signal<In, Bit>,
    pub pair: Signal<In, Bits<KB>>,
    pub bank: Signal<In, Bit>,
    pub ends: Signal<In, Bit>,
    pub releases: Signal<In, Bit>,
    pub in_range: [Signal<In, Bit>; MASK],
    pub gathered: [Signal<In, Bit>; Leaf::PAIR],
    pub short: [Signal<In, Bit>; Leaf::PAIR],
    pub takes_pair: Signal<In, Bit>,
    /// The pair that was compared is not queued.
    pub drops: Signal<Out, Bit>,
    /// The oldest pair: its groups that are wanted, and its flags as the player reads them.
    pub has_pair: Signal<Out, Bit>,
    pub oldest_pair: Signal<Out, Bits<KB>>,
    pub oldest_mask: Signal<Out, Bits<MASK>>,
    pub oldest_flags: Signal<Out, Bits<3>>,
    /// The leaves of the pair of which a group is wanted.
    pub wanted: Signal<Out, Bits<2>>,
    pub queue_write: DFF<Bits<QB>>,
    pub queue_read: DFF<Bits<QB>>,
    pub queue_count: DFF<Bits<QN>>,
    pair_ram: AsyncRam<QB, KB>,
    mask_ram: AsyncRam<QB, MASK>,
    flag_ram: AsyncRam<QB, 3>,
    /// The second group of each leaf is one of the set and in range.
    second_0: Signal<Local, Bit>,
    second_1: Signal<Local, Bit>,
    /// Some group of each leaf is.
    near_0: Signal<Local, Bit>,
    near_1: Signal<Local, Bit>,
    wanted_0: Signal<Local, Bit>,
    wanted_1: Signal<Local, Bit>,
    some: Signal<Local, Bit>,
    queues: Signal<Local, Bit>,
    mask: Signal<Local, Bits<MASK>>,
    flags: Signal<Local, Bits<3>>,
}

impl<const KB: usize, const QB: usize, const QN: usize> Logic for PairQueue<KB, QB, QN> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, queue_write, queue_read, queue_count);
        self.pair_ram.clock.next = self.clock.val();
        self.mask_ram.clock.next = self.clock.val();
        self.flag_ram.clock.next = self.clock.val();
        self.second_0.next = self.in_range[1].val() & !self.short[0].val();
        self.second_1.next = self.in_range[3].val() & !self.short[1].val();
        self.near_0.next = self.in_range[0].val() | self.second_0.val();
        self.near_1.next = self.in_range[2].val() | self.second_1.val();
        self.wanted_0.next = self.near_0.val() & self.gathered[0].val();
        self.wanted_1.next = self.near_1.val() & self.gathered[1].val();
        self.some.next = self.wanted_0.val() | self.wanted_1.val() | self.ends.val();
        self.queues.next = self.valid.val() & self.some.val();
        self.drops.next = self.valid.val() & !self.some.val();
        self.mask.next = 0.into();
        if self.in_range[0].val() & self.gathered[0].val() {
            self.mask.next = self.mask.val() | 1;
        }
        if self.second_0.val() & self.gathered[0].val() {
            self.mask.next = self.mask.val() | 2;
        }
        if self.in_range[2].val() & self.gathered[1].val() {
            self.mask.next = self.mask.val() | 4;
        }
        if self.second_1.val() & self.gathered[1].val() {
            self.mask.next = self.mask.val() | 8;
        }
        self.wanted.next = 0.into();
        if self.valid.val() & (self.wanted_0.val() | self.wanted_1.val()) {
            self.wanted.next = 1.into();
            if self.wanted_0.val() & self.wanted_1.val() {
                self.wanted.next = 2.into();
            }
        }
        self.flags.next = 0.into();
        if self.bank.val() {
            self.flags.next = self.flags.val() | 1;
        }
        if self.ends.val() {
            self.flags.next = self.flags.val() | 2;
        }
        if self.releases.val() {
            self.flags.next = self.flags.val() | 4;
        }
        self.pair_ram.write.next = self.queues.val();
        self.pair_ram.write_place.next = self.queue_write.q.val();
        self.pair_ram.write_word.next = self.pair.val();
        self.pair_ram.read_place.next = self.queue_read.q.val();
        self.mask_ram.write.next = self.queues.val();
        self.mask_ram.write_place.next = self.queue_write.q.val();
        self.mask_ram.write_word.next = self.mask.val();
        self.mask_ram.read_place.next = self.queue_read.q.val();
        self.flag_ram.write.next = self.queues.val();
        self.flag_ram.write_place.next = self.queue_write.q.val();
        self.flag_ram.write_word.next = self.flags.val();
        self.flag_ram.read_place.next = self.queue_read.q.val();
        if self.queues.val() {
            self.queue_write.d.next = self.queue_write.q.val() + 1;
        }
        if self.takes_pair.val() {
            self.queue_read.d.next = self.queue_read.q.val() + 1;
        }
        if self.queues.val() & !self.takes_pair.val() {
            self.queue_count.d.next = self.queue_count.q.val() + 1;
        }
        if self.takes_pair.val() & !self.queues.val() {
            self.queue_count.d.next = self.queue_count.q.val() - 1;
        }
        if self.reset.val() {
            self.queue_write.d.next = 0.into();
            self.queue_read.d.next = 0.into();
            self.queue_count.d.next = 0.into();
        }
        self.has_pair.next = self.queue_count.q.val().any();
        self.oldest_pair.next = self.pair_ram.read_word.val();
        self.oldest_mask.next = self.mask_ram.read_word.val();
        self.oldest_flags.next = self.flag_ram.read_word.val();
    }
}
