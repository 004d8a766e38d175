//! Plays the wanted groups of leaves to the chain.

use rust_hdl::prelude::*;

use super::MASK;
use crate::defaults::defaulted;

/// Takes pairs from the queue and reads their groups. `PB` bits of a group's place, `KB` of a pair's, `SB` of the spacing,
/// `OB` of the number of batches under way.
#[derive(LogicBlock)]
pub(crate) struct Player<const PB: usize, const KB: usize, const SB: usize, const OB: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    /// The oldest pair in the queue, if there is one. Its flags are, from bit 0 on, its bank, whether it ends its batch, and
    /// whether the batch releases the set.
    pub has_pair: Signal<In, Bit>,
    pub pair: Signal<In, Bits<KB>>,
    pub mask: Signal<In, Bits<MASK>>,
    pub flags: Signal<In, Bits<3>>,
    /// The last result of a batch is taken from the chain.
    pub batch_leaves: Signal<In, Bit>,
    /// The pair leaves the queue.
    pub takes_pair: Signal<Out, Bit>,
    pub plays: Signal<Out, Bit>,
    pub play_bank: Signal<Out, Bit>,
    pub play_place: Signal<Out, Bits<PB>>,
    pub frees: Signal<Out, Bit>,
    pub word_valid_out: Signal<Out, Bit>,
    pub word_last_out: Signal<Out, Bit>,
    pub word_blank_out: Signal<Out, Bit>,
    pub entry_valid: DFF<Bit>,
    pub entry_mask: DFF<Bits<MASK>>,
    pub entry_last: DFF<Bit>,
    pub entry_pair: DFF<Bits<KB>>,
    pub entry_bank: DFF<Bit>,
    pub entry_end: DFF<Bit>,
    pub entry_release: DFF<Bit>,
    pub spacing: DFF<Bits<SB>>,
    pub may_end: DFF<Bit>,
    pub outstanding: DFF<Bits<OB>>,
    pub read_valid: DFF<Bit>,
    pub read_last: DFF<Bit>,
    pub read_blank: DFF<Bit>,
    pub word_valid: DFF<Bit>,
    pub word_last: DFF<Bit>,
    pub word_blank: DFF<Bit>,
    spaced: Constant<Bits<SB>>,
    most: Constant<Bits<OB>>,
    less: Signal<Local, Bits<MASK>>,
    rest: Signal<Local, Bits<MASK>>,
    rest_less: Signal<Local, Bits<MASK>>,
    rest_but_one: Signal<Local, Bits<MASK>>,
    mask_less: Signal<Local, Bits<MASK>>,
    mask_but_one: Signal<Local, Bits<MASK>>,
    is_end: Signal<Local, Bit>,
    is_spaced: Signal<Local, Bit>,
    has_room: Signal<Local, Bit>,
    is_played: Signal<Local, Bit>,
    ends: Signal<Local, Bit>,
    takes: Signal<Local, Bit>,
    group: Signal<Local, Bits<2>>,
    high: Signal<Local, Bits<PB>>,
    low: Signal<Local, Bits<PB>>,
}

impl<const PB: usize, const KB: usize, const SB: usize, const OB: usize> Player<PB, KB, SB, OB> {
    /// Builds a player that leaves `least_spacing` clocks from one last group to the next, and has at most
    /// `most_outstanding` batches under way.
    pub fn new(least_spacing: u32, most_outstanding: u32) -> Self {
        assert!(PB == KB + 2, "a pair has four groups");
        defaulted!(Self {
            // One of the clocks between is that in which `may_end` is set.
            spaced: Constant::new(u64::from(least_spacing.saturating_sub(2)).to_bits()),
            most: Constant::new(u64::from(most_outstanding).to_bits()),
        };
            clock reset has_pair pair mask flags batch_leaves takes_pair plays play_bank play_place frees
            word_valid_out word_last_out word_blank_out entry_valid entry_mask entry_last entry_pair entry_bank entry_end
            entry_release spacing outstanding read_valid read_last read_blank word_valid word_last word_blank
            less rest rest_less rest_but_one mask_less mask_but_one is_end is_spaced has_room may_end is_played ends takes group high low
        )
    }
}

impl<const PB: usize, const KB: usize, const SB: usize, const OB: usize> Logic
    for Player<PB, KB, SB, OB>
{
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(
            self,
            clock,
            entry_valid,
            entry_mask,
            entry_last,
            entry_pair,
            entry_bank,
            entry_end,
            entry_release,
            spacing,
            may_end,
            outstanding,
            read_valid,
            read_last,
            read_blank,
            word_valid,
            word_last,
            word_blank
        );
        self.less.next = self.entry_mask.q.val() - 1;
        self.rest.next = self.entry_mask.q.val() & self.less.val();
        self.rest_less.next = self.rest.val() - 1;
        self.rest_but_one.next = self.rest.val() & self.rest_less.val();
        self.mask_less.next = self.mask.val() - 1;
        self.mask_but_one.next = self.mask.val() & self.mask_less.val();
        self.is_end.next = self.entry_end.q.val() & self.entry_last.q.val();
        self.is_spaced.next = !self.spacing.q.val().any();
        self.has_room.next = self.outstanding.q.val() != self.most.val();
        self.is_played.next =
            self.entry_valid.q.val() & (self.may_end.q.val() | !self.is_end.val());
        self.ends.next = self.is_played.val() & self.is_end.val();
        self.may_end.d.next = self.is_spaced.val() & self.has_room.val() & !self.ends.val();
        self.takes.next = self.has_pair.val()
            & (!self.entry_valid.q.val() | (self.is_played.val() & self.entry_last.q.val()));
        if self.is_played.val() {
            self.entry_mask.d.next = self.rest.val();
            self.entry_last.d.next = !self.rest_but_one.val().any();
            self.entry_valid.d.next = !self.entry_last.q.val();
        }
        if self.takes.val() {
            self.entry_valid.d.next = true;
            self.entry_mask.d.next = self.mask.val();
            self.entry_last.d.next = !self.mask_but_one.val().any();
            self.entry_pair.d.next = self.pair.val();
            self.entry_bank.d.next = self.flags.val().get_bit(0);
            self.entry_end.d.next = self.flags.val().get_bit(1);
            self.entry_release.d.next = self.flags.val().get_bit(2);
        }
        if !self.is_spaced.val() {
            self.spacing.d.next = self.spacing.q.val() - 1;
        }
        if self.ends.val() {
            self.spacing.d.next = self.spaced.val();
        }
        if self.ends.val() & !self.batch_leaves.val() {
            self.outstanding.d.next = self.outstanding.q.val() + 1;
        }
        if self.batch_leaves.val() & !self.ends.val() {
            self.outstanding.d.next = self.outstanding.q.val() - 1;
        }
        self.group.next = 3.into();
        if self.entry_mask.q.val().get_bit(2) {
            self.group.next = 2.into();
        }
        if self.entry_mask.q.val().get_bit(1) {
            self.group.next = 1.into();
        }
        if self.entry_mask.q.val().get_bit(0) | !self.entry_mask.q.val().any() {
            self.group.next = 0.into();
        }
        self.high.next = bit_cast::<PB, KB>(self.entry_pair.q.val()) << 2;
        self.low.next = bit_cast::<PB, 2>(self.group.val());
        self.play_place.next = self.high.val() | self.low.val();
        self.play_bank.next = self.entry_bank.q.val();
        self.plays.next = self.is_played.val();
        self.takes_pair.next = self.takes.val();
        self.frees.next = self.ends.val() & self.entry_release.q.val();
        self.read_valid.d.next = self.is_played.val();
        self.read_last.d.next = self.ends.val();
        self.read_blank.d.next = !self.entry_mask.q.val().any();
        self.word_valid.d.next = self.read_valid.q.val();
        self.word_last.d.next = self.read_last.q.val();
        self.word_blank.d.next = self.read_blank.q.val();
        if self.reset.val() {
            self.entry_valid.d.next = false;
            self.spacing.d.next = 0.into();
            self.may_end.d.next = false;
            self.outstanding.d.next = 0.into();
            self.read_valid.d.next = false;
            self.word_valid.d.next = false;
        }
        self.word_valid_out.next = self.word_valid.q.val();
        self.word_last_out.next = self.word_last.q.val();
        self.word_blank_out.next = self.word_blank.q.val();
    }
}

/// The presence of a photon on its way to the chain: none is present in a group that stands for no photons.
#[derive(LogicBlock, Default)]
pub(crate) struct PresentUnlessBlank {
    pub blank: Signal<In, Bit>,
    pub word: Signal<In, Bits<1>>,
    pub present: Signal<Out, Bits<1>>,
}

impl Logic for PresentUnlessBlank {
    #[hdl_gen]
    fn update(&mut self) {
        self.present.next = self.word.val();
        if self.blank.val() {
            self.present.next = 0.into();
        }
    }
}
