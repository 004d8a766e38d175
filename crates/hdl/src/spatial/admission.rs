//! Decides which queries and groups the head takes, and when.
//!
//! The widths and limits of the counters follow from the number of engines; the other widths do not. So this
//! block's Verilog is written by hand, with its registers inside, and one set of compiled widths serves
//! machines of any number of engines.

use photoncube_spec::{HeadSizes, Spatial};
use rust_hdl::prelude::*;

use super::hidden::Hidden;
use crate::defaults::defaulted;

/// Takes queries and groups by the rules in the module of `photoncube_spec::HeadSizes`.
#[derive(LogicBlock)]
pub(crate) struct Admission {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub query_valid: Signal<In, Bit>,
    pub group_valid: Signal<In, Bit>,
    pub group_last: Signal<In, Bit>,
    /// The last result of a batch is read from the queue's memory.
    pub batch_read: Signal<In, Bit>,
    pub query_ready: Signal<Out, Bit>,
    pub group_ready: Signal<Out, Bit>,
    /// The group of this clock is taken.
    pub taken: Signal<Out, Bit>,
    /// The group that is taken is the first of its batch.
    pub first_taken: Signal<Out, Bit>,
    /// The group that is taken is the last of its batch.
    pub last_taken: Signal<Out, Bit>,
    /// A query is taken. In the clock of a reset none is.
    pub token_valid: Signal<Out, Bit>,
    /// The conditions of a photon memory: all queries of a batch are taken; the queue has room for its
    /// results; the clocks until a last group may be taken.
    pub is_full: Signal<Out, Bit>,
    pub has_room: Signal<Out, Bit>,
    pub clocks_to_last: Signal<Out, Bits<16>>,
    pub _loaded: Hidden,
    pub _open: Hidden,
    pub _has_batch: Hidden,
    pub _spacing: Hidden,
    pub _waits: Hidden,
    /// `BatchRead`: the places of a batch's results are free again.
    pub _gives_back: Hidden,
    pub _promised: Hidden,
    _engines: u64,
    _sizes: HeadSizes,
    /// Whether few LUTs stand before the flags of the entry, which are far away beside engine 0.
    _short_paths: bool,
    /// Whether every group is taken, see [`Spatial::paced`].
    _paced: bool,
}

/// The handshakes of one clock.
struct Taken {
    query: bool,
    query_ready: bool,
    group: bool,
    group_ready: bool,
    first: bool,
    last: bool,
}

impl Admission {
    pub fn new(spatial: &Spatial) -> Self {
        defaulted!(Self {
            _engines: spatial.engines() as u64,
            _sizes: HeadSizes::of(spatial),
            _short_paths: spatial.is_fine(),
            _paced: spatial.paced,
        };
            clock reset query_valid group_valid group_last batch_read query_ready group_ready taken first_taken
            last_taken token_valid is_full has_room clocks_to_last _loaded _open _has_batch _spacing _waits
            _gives_back _promised
        )
    }

    /// Whether there is room for the results of a batch: the highest of the unary bits is 0.
    fn has_room(&self) -> bool {
        self._promised.0 >> (self._sizes.promised_bits - 1) == 0
    }

    fn taken(&self) -> Taken {
        let open = self._open.0 != 0;
        let full = self._loaded.0 == self._engines;
        let fits = self._waits.0 == 0 && self.has_room();
        let decided = self._has_batch.0 != 0 && (!self.group_last.val() || fits);
        let group_ready = self._paced || decided;
        let group = self.group_valid.val() && group_ready;
        let first = group && !open;
        let query_ready = !full || first;
        Taken {
            query: self.query_valid.val() && query_ready,
            query_ready,
            group,
            group_ready,
            first,
            last: group && self.group_last.val(),
        }
    }

    fn step(&mut self) {
        let taken = self.taken();
        let kept = if taken.first { 0 } else { self._loaded.0 };
        self._loaded.0 = kept + u64::from(taken.query);
        if taken.group {
            self._open.0 = u64::from(!taken.last);
        }
        if !self._paced {
            self.count(&taken);
        }
        if self.reset.val() {
            (self._loaded, self._open, self._has_batch) = Default::default();
            (self._spacing, self._waits) = Default::default();
            (self._gives_back, self._promised) = Default::default();
        }
    }

    /// Counts what decides whether a group is taken.
    fn count(&mut self, taken: &Taken) {
        self._spacing.0 = match taken.last {
            true => u64::from(self._sizes.spacing) - 1,
            false => self._spacing.0.saturating_sub(1),
        };
        self._waits.0 = u64::from(self._spacing.0 != 0);
        let gives_back = match self._sizes.has_waits() {
            true => self._gives_back.0 != 0,
            false => self.batch_read.val(),
        };
        self._gives_back.0 = self.batch_read.val().into();
        self._promised.0 = match (taken.last, gives_back) {
            (true, false) => self._promised.0 << 1 | 1,
            (false, true) => self._promised.0 >> 1,
            _ => self._promised.0,
        };
        self._has_batch.0 = u64::from(self._open.0 != 0 || self._loaded.0 == self._engines);
    }
}

impl Logic for Admission {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.step();
        }
        let taken = self.taken();
        self.query_ready.next = taken.query_ready;
        self.group_ready.next = taken.group_ready;
        self.taken.next = taken.group;
        self.first_taken.next = taken.first && !(self._short_paths && self.reset.val());
        self.last_taken.next = taken.last;
        self.token_valid.next = taken.query && !self.reset.val();
        self.is_full.next = self._loaded.0 == self._engines;
        self.has_room.next = self.has_room();
        self.clocks_to_last.next = self._spacing.0.to_bits();
    }

    fn connect(&mut self) {
        self.query_ready.connect();
        self.group_ready.connect();
        self.taken.connect();
        self.first_taken.connect();
        self.last_taken.connect();
        self.token_valid.connect();
        self.is_full.connect();
        self.has_room.connect();
        self.clocks_to_last.connect();
    }

    fn hdl(&self) -> Verilog {
        Verilog::Custom(match self._paced {
            true => self.paced_text(),
            false => self.text(),
        })
    }
}

impl Admission {
    /// The Verilog where every group is taken. A block of `always @(*)` that reads no signal never runs in a simulator, so the outputs that are
    /// constant come from the register `one`, which synthesis removes.
    fn paced_text(&self) -> String {
        let bits = self._sizes.loaded_bits;
        format!(
            "reg [{l}:0] loaded = {bits}'d0;\n\
             reg open = 1'd0;\n\
             reg one = 1'd1;\n\
             wire full = loaded[{l}];\n\
             wire takes_first = group_valid & ~open;\n\
             wire takes_last = group_valid & group_last;\n\
             wire admits_query = ~full | takes_first;\n\
             always @(*) query_ready = admits_query;\n\
             always @(*) group_ready = one;\n\
             always @(*) taken = group_valid;\n\
             always @(*) first_taken = takes_first;\n\
             always @(*) last_taken = takes_last;\n\
             always @(*) token_valid = query_valid & admits_query & ~reset;\n\
             always @(*) is_full = full;\n\
             always @(*) has_room = one;\n\
             always @(*) clocks_to_last = {{16{{~one}}}};\n\
             always @(posedge clock) begin\n\
             \x20 one <= 1'd1;\n\
             \x20 loaded <= {loaded};\n\
             \x20 if (group_valid) open <= ~group_last;\n\
             \x20 if (reset) begin\n\
             \x20   loaded <= {bits}'d0;\n\
             \x20   open <= 1'd0;\n\
             \x20 end\n\
             end\n",
            l = bits - 1,
            loaded = next_loaded(bits),
        )
    }

    /// The Verilog where the head decides whether a group is taken. The next `open`, `has_batch` and `loaded` are written so
    /// that no more than two LUTs stand before a register, because the groups that are taken decide them in the same clock.
    /// Where all queries of the next batch are loaded, the end of an open batch leaves a batch that can be opened, so
    /// `has_batch` stays set.
    fn text(&self) -> String {
        let HeadSizes {
            spacing,
            loaded_bits,
            spacing_bits,
            promised_bits,
            ..
        } = self._sizes;
        // The number of engines is a power of two and the largest value of `loaded`, so `loaded` is full
        // where its highest bit is set.
        let engines = self._engines;
        assert_eq!(engines, 1 << (loaded_bits - 1));
        let start = spacing - 1;
        // The results of one engine never collide, so there is no counter.
        let [waits, fits, spacing_step, waits_reset, gives_back] = match self._sizes.has_waits() {
            false => [
                "",
                "room",
                &format!("spacing <= {spacing_bits}'d0;"),
                "",
                "batch_read",
            ],
            true => [
                "reg waits = 1'd0;\nreg gives_back = 1'd0;\n",
                "~waits & room",
                &format!(
                    "if (takes_last) spacing <= {spacing_bits}'d{start};\n  \
                     else if (waits) spacing <= spacing - {spacing_bits}'d1;\n  \
                     waits <= takes_last | (|spacing[{}:1]);\n  \
                     gives_back <= batch_read;",
                    spacing_bits - 1
                ),
                "    waits <= 1'd0;\n    gives_back <= 1'd0;\n",
                "gives_back",
            ],
        };
        // Each flag of the entry has a sum of products of its own, whose parts `keep` preserves: where Yosys shares the terms of several
        // outputs, four LUTs stand behind each other. Two are left before the flag of a first group, three before that of a query.
        // `first_taken` is 0 in the clock of a reset, which clears all that it would change.
        let [parts, takes_first, admits_query, takes_query, token_valid] = match self._short_paths {
            false => [
                "",
                "group_valid & full & ~open & (~group_last | fits)",
                "takes_first",
                "wire takes_query = query_valid & admits_query;\n",
                "takes_query & ~reset",
            ],
            true => [
                "(* keep *) wire blocked;\n\
                 assign blocked = group_last & ~(fits);\n\
                 (* keep *) wire opens;\n\
                 assign opens = group_valid & full & ~open & ~reset;\n\
                 (* keep *) wire fills_up;\n\
                 assign fills_up = query_valid & ~full & ~reset;\n\
                 (* keep *) wire follows;\n\
                 assign follows = query_valid & group_valid & ~open & ~reset;\n",
                "opens & ~blocked",
                "(group_valid & ~open & ~blocked)",
                "",
                "fills_up | (follows & ~blocked)",
            ],
        };
        format!(
            "reg [{l}:0] loaded = {loaded_bits}'d0;\n\
             reg open = 1'd0;\n\
             reg has_batch = 1'd0;\n\
             reg [{s}:0] spacing = {spacing_bits}'d0;\n\
             {waits}\
             reg [{p}:0] promised = {promised_bits}'d0;\n\
             wire full = loaded[{l}];\n\
             wire fills = {fills};\n\
             wire room = ~promised[{p}];\n\
             wire fits = {fits};\n\
             wire admits_group = has_batch & (~group_last | fits);\n\
             wire takes_group = group_valid & admits_group;\n\
             {parts}\
             wire takes_first = {takes_first};\n\
             wire takes_last = group_valid & has_batch & group_last & fits;\n\
             wire admits_query = ~full | {admits_query};\n\
             {takes_query}\
             always @(*) query_ready = admits_query;\n\
             always @(*) group_ready = admits_group;\n\
             always @(*) taken = takes_group;\n\
             always @(*) first_taken = takes_first;\n\
             always @(*) last_taken = takes_last;\n\
             always @(*) token_valid = {token_valid};\n\
             always @(*) is_full = full;\n\
             always @(*) has_room = room;\n\
             always @(*) clocks_to_last = {{{pad}'d0, spacing}};\n\
             always @(posedge clock) begin\n\
             \x20 loaded <= {loaded};\n\
             \x20 open <= (takes_group & ~group_last) | (open & ~takes_last);\n\
             \x20 has_batch <= (open & full) | (has_batch & ~takes_last) | fills;\n\
             \x20 {spacing_step}\n\
             \x20 if (takes_last != {gives_back})\n\
             \x20   promised <= takes_last ? {{promised[{p_1}:0], 1'd1}} : {{1'd0, promised[{p}:1]}};\n\
             \x20 if (reset) begin\n\
             \x20   loaded <= {loaded_bits}'d0;\n\
             \x20   open <= 1'd0;\n\
             \x20   has_batch <= 1'd0;\n\
             \x20   spacing <= {spacing_bits}'d0;\n\
             {waits_reset}\
             \x20   promised <= {promised_bits}'d0;\n\
             \x20 end\n\
             end\n",
            l = loaded_bits - 1,
            s = spacing_bits - 1,
            p = promised_bits - 1,
            p_1 = promised_bits - 2,
            // The query that completes a batch; with one engine every query that is taken.
            fills = match engines {
                1 => "query_valid".to_owned(),
                _ => format!("query_valid & (&loaded[{}:0])", loaded_bits - 2),
            },
            pad = 16 - spacing_bits,
            loaded = next_loaded(loaded_bits),
        )
    }
}

/// The number of queries taken for the next batch, a clock later. It has that many bits.
fn next_loaded(bits: u32) -> String {
    match bits {
        1 => "query_valid | (loaded & ~takes_first)".to_owned(),
        more => format!(
            "takes_first ? {{{rest}'d0, query_valid}} : loaded + {{{rest}'d0, query_valid & ~full}}",
            rest = more - 1
        ),
    }
}
