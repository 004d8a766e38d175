//! The presence of a photon in a lane, and its effect on the lane's powers.

use rust_hdl::prelude::*;

/// Whether a lane has a photon of a group that is taken, and the inverse, each in its own register. The
/// inverse clears 24 registers of powers, which have only a clear input; an inverter before that input would
/// be on their slowest path.
#[derive(LogicBlock, Default)]
pub(crate) struct Presence {
    pub clock: Signal<In, Clock>,
    pub taken: Signal<In, Bit>,
    pub photon_present: Signal<In, Bits<1>>,
    pub present: Signal<Out, Bits<1>>,
    pub absent: Signal<Out, Bit>,
    pub is_present: DFF<Bits<1>>,
    pub is_absent: DFF<Bit>,
    is_photon: Signal<Local, Bit>,
}

impl Logic for Presence {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, is_present, is_absent);
        self.is_photon.next = self.taken.val() & self.photon_present.val().any();
        self.is_absent.d.next = !self.is_photon.val();
        self.is_present.d.next = 0.into();
        if self.is_photon.val() {
            self.is_present.d.next = 1.into();
        }
        self.present.next = self.is_present.q.val();
        self.absent.next = self.is_absent.q.val();
    }
}

/// A power of `P` bits, or 0 where the photon is absent.
#[derive(LogicBlock, Default)]
pub(crate) struct PowerOfPresent<const P: usize> {
    pub absent: Signal<In, Bit>,
    pub word: Signal<In, Bits<P>>,
    pub power: Signal<Out, Bits<P>>,
}

impl<const P: usize> Logic for PowerOfPresent<P> {
    #[hdl_gen]
    fn update(&mut self) {
        self.power.next = self.word.val();
        if self.absent.val() {
            self.power.next = 0.into();
        }
    }
}
