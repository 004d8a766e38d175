//! The events of a core, each a bit of the registers `Events` and `InterruptEnable`.

/// A row of the table of events.
#[derive(Copy, Clone, Debug)]
pub struct EventRow {
    /// The event.
    pub event: CoreEvent,
    /// The name of its bit.
    pub name: &'static str,
    /// A description of it.
    pub about: &'static str,
}

macro_rules! events {
    ($($event:ident $name:literal $about:literal;)+) => {
        /// An event, in the order of its bit, the lowest first.
        #[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum CoreEvent {
            $(#[doc = $about] $event,)+
        }

        impl EventRow {
            /// All events, in the order of their bits.
            pub const ALL: &[Self] = &[$(Self {
                event: CoreEvent::$event,
                name: $name,
                about: $about,
            },)+];
        }
    };
}

events! {
    Done "done" "The last result under way has left: no query is under way.";
    LeafMalformed "leaf_malformed" "A leaf was given that has a photon behind an absent one.";
    SetTooLong "set_too_long" "A set has more leaves than a bank holds; the leaves behind them are dropped.";
    QueryOutside "query_outside" "A query was given that is outside of its frame.";
    ChainUnknown "chain_unknown" "A leaf or a query is for a chain that there is not; it is dropped.";
    AccessRefused "access_refused" "An access was answered with SLVERR.";
    Stalled "stalled" "The core was silent for as many clocks as stall_limit says.";
}

impl CoreEvent {
    /// The event's bit in the registers.
    pub const fn bit(self) -> u32 {
        1 << self as u32
    }
}
