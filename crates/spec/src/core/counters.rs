//! The counters of a core.

/// A row of the table of counters.
#[derive(Copy, Clone, Debug)]
pub struct CounterRow {
    /// The counter.
    pub counter: CoreCounter,
    /// Its name in the map of registers.
    pub name: &'static str,
    /// A description of what it counts.
    pub about: &'static str,
}

macro_rules! counters {
    ($($counter:ident $name:literal $about:literal;)+) => {
        /// A counter, [`super::Core::COUNTER_BITS`] wide. It starts at 0 and wraps around.
        #[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum CoreCounter {
            $(#[doc = $about] $counter,)+
        }

        impl CounterRow {
            /// All counters, in the order of their addresses.
            pub const ALL: &[Self] = &[$(Self {
                counter: CoreCounter::$counter,
                name: $name,
                about: $about,
            },)+];
        }
    };
}

counters! {
    Clocks "clocks" "Clocks.";
    BusyClocks "busy_clocks" "Clocks in which a query is under way.";
    LeavesRead "leaves_read" "Leaves that were given to a chain.";
    QueriesRead "queries_read" "Queries that were given to a chain.";
    Results "results" "Results that left through m_axis_results.";
    LeavesCompared "leaves_compared" "Leaves whose boxes were compared with the box of a batch, in all chains.";
    LeavesWanted "leaves_wanted" "Leaves that a comparison found wanted, in all chains.";
    GroupsPlayed "groups_played" "Groups of four photons that the engines of a chain were given, in all chains. Each is four photon tests in every engine.";
    PhotonsInRange "photons_in_range" "The counts of all results that left.";
    PhotonStalls "photon_stalls" "Clocks in which a leaf waited on s_axis_photons.";
    QueryStalls "query_stalls" "Clocks in which a query waited on s_axis_queries.";
    ResultStalls "result_stalls" "Clocks in which a result waited on m_axis_results.";
    LeavesMalformed "leaves_malformed" "Leaves that were given with a photon behind an absent one.";
    LeavesRefused "leaves_refused" "Leaves that were dropped.";
    QueriesOutside "queries_outside" "Queries that were given outside of their frame.";
    QueriesRefused "queries_refused" "Queries that were dropped.";
    AccessesRefused "accesses_refused" "Accesses that were answered with SLVERR; two where a read and a write are refused in one clock.";
}
