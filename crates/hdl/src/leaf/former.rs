//! Puts queries into batches, and fills batches up.

use rust_hdl::prelude::*;

use super::FACINGS;
use crate::defaults::defaulted;

/// Gives the chain tokens. `NB` bits of the number of tokens.
#[derive(LogicBlock)]
pub(crate) struct Former<const NB: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub query_last: Signal<In, Bit>,
    pub query_release: Signal<In, Bit>,
    pub query_facings: Signal<In, Bits<FACINGS>>,
    /// The chain takes a token, if it is valid.
    pub chain_ready: Signal<In, Bit>,
    /// The batch starts.
    pub starts: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub token_valid: Signal<Out, Bit>,
    /// The chain takes a token; the token is a query; it is the first of its batch.
    pub takes_token: Signal<Out, Bit>,
    pub takes_query: Signal<Out, Bit>,
    pub first: Signal<Out, Bit>,
    /// A query is offered that is one of the batch if it is taken.
    pub offers_query: Signal<Out, Bit>,
    /// The token that is given, if one is, is a filler.
    pub fills: Signal<Out, Bit>,
    /// The chain has all tokens of the batch.
    pub complete: Signal<Out, Bit>,
    pub release_out: Signal<Out, Bit>,
    pub facings_out: Signal<Out, Bits<FACINGS>>,
    pub loaded: DFF<Bits<NB>>,
    pub closed: DFF<Bit>,
    pub releases: DFF<Bit>,
    pub facings: DFF<Bits<FACINGS>>,
    engines: Constant<Bits<NB>>,
    one_less: Constant<Bits<NB>>,
    is_full: Signal<Local, Bit>,
    is_first: Signal<Local, Bit>,
    is_last_place: Signal<Local, Bit>,
    valid: Signal<Local, Bit>,
    takes: Signal<Local, Bit>,
    is_query: Signal<Local, Bit>,
    is_offered: Signal<Local, Bit>,
}

impl<const NB: usize> Former<NB> {
    /// Builds a former of batches for that many engines.
    pub fn new(engines: u32) -> Self {
        let constant = |value: u32| Constant::new(u64::from(value).to_bits());
        defaulted!(Self {
            engines: constant(engines),
            one_less: constant(engines - 1),
        };
            clock reset query_valid query_last query_release query_facings chain_ready starts query_ready
            token_valid takes_token takes_query first offers_query fills complete release_out facings_out loaded closed releases
            facings is_full is_first is_last_place valid takes is_query is_offered
        )
    }
}

impl<const NB: usize> Logic for Former<NB> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, loaded, closed, releases, facings);
        self.is_full.next = self.loaded.q.val() == self.engines.val();
        self.is_last_place.next = self.loaded.q.val() == self.one_less.val();
        self.is_first.next = !self.loaded.q.val().any();
        self.valid.next = self.query_valid.val();
        if self.closed.q.val() {
            self.valid.next = !self.is_full.val();
        }
        self.takes.next = self.valid.val() & self.chain_ready.val();
        self.is_query.next = self.takes.val() & !self.closed.q.val();
        if self.takes.val() {
            self.loaded.d.next = self.loaded.q.val() + 1;
        }
        if self.is_query.val() {
            self.closed.d.next = self.query_last.val() | self.is_last_place.val();
            self.releases.d.next =
                self.query_release.val() | (self.releases.q.val() & !self.is_first.val());
        }
        self.is_offered.next = self.query_valid.val() & !self.closed.q.val();
        if self.is_offered.val() & self.is_first.val() {
            self.facings.d.next = self.query_facings.val();
        }
        if self.starts.val() {
            self.loaded.d.next = 0.into();
            self.closed.d.next = false;
        }
        if self.reset.val() {
            self.loaded.d.next = 0.into();
            self.closed.d.next = false;
        }
        self.query_ready.next = self.chain_ready.val() & !self.closed.q.val();
        self.token_valid.next = self.valid.val();
        self.takes_token.next = self.takes.val();
        self.takes_query.next = self.is_query.val();
        self.first.next = self.is_first.val();
        self.offers_query.next = self.is_offered.val();
        self.fills.next = self.closed.q.val();
        self.complete.next = self.closed.q.val() & self.is_full.val();
        self.release_out.next = self.releases.q.val();
        self.facings_out.next = self.facings.q.val();
    }
}

/// A coordinate of the token: that of the query on the pins, or of a filler. `C` bits.
#[derive(LogicBlock, Default)]
pub(crate) struct TokenPlace<const C: usize> {
    pub fills: Signal<In, Bit>,
    pub query: Signal<In, Bits<C>>,
    pub filler: Signal<In, Bits<C>>,
    pub token: Signal<Out, Bits<C>>,
}

impl<const C: usize> Logic for TokenPlace<C> {
    #[hdl_gen]
    fn update(&mut self) {
        self.token.next = self.query.val();
        if self.fills.val() {
            self.token.next = self.filler.val();
        }
    }
}
