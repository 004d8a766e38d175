//! The queue of results.
//!
//! Its depth follows from the number of engines, as the counters of `admission` do. So its Verilog is written
//! by hand, with the memory, the places and the word on the pins inside.

use photoncube_spec::{HeadSizes, Spatial};
use rust_hdl::prelude::*;

use super::hidden::Hidden;
use crate::defaults::{defaulted, signals};

/// Results are written where `result_valid_in`, are read from the memory into a register, and leave where
/// valid and ready. `S` bits of a sum, `N` of the count.
#[derive(LogicBlock)]
pub(crate) struct ResultQueue<const S: usize, const N: usize> {
    pub clock: Signal<In, Clock>,
    pub reset: Signal<In, Bit>,
    pub result_valid_in: Signal<In, Bit>,
    pub result_in: Vec<Signal<In, Bits<S>>>,
    pub result_count_in: Signal<In, Bits<N>>,
    pub result_ready: Signal<In, Bit>,
    pub result_valid: Signal<Out, Bit>,
    pub result: Vec<Signal<Out, Bits<S>>>,
    pub result_count: Signal<Out, Bits<N>>,
    /// The last result of a batch is read from the memory.
    pub batch_read: Signal<Out, Bit>,
    pub _write_place: Hidden,
    pub _newest_place: Hidden,
    pub _read_place: Hidden,
    pub _has_waiting: Hidden,
    pub _has_result: Hidden,
    /// The sums and the count of each place.
    _results: Vec<(Vec<u64>, u64)>,
    /// The sums and the count on the pins.
    _word: (Vec<u64>, u64),
    _place_bits: u32,
    _engines: usize,
    /// Whether one LUT stands between the comparison of places and `has_waiting`.
    _short_paths: bool,
}

impl<const S: usize, const N: usize> ResultQueue<S, N> {
    pub fn new(spatial: &Spatial, channels: usize) -> Self {
        let sizes = HeadSizes::of(spatial);
        assert_eq!(sizes.queue, 1 << sizes.place_bits);
        defaulted!(Self {
            result_in: signals(channels),
            result: signals(channels),
            _results: vec![(vec![0; channels], 0); sizes.queue],
            _word: (vec![0; channels], 0),
            _place_bits: sizes.place_bits,
            _engines: spatial.engines(),
            _short_paths: spatial.is_fine(),
        };
            clock reset result_valid_in result_count_in result_ready result_valid result_count batch_read
            _write_place _newest_place _read_place _has_waiting _has_result
        )
    }

    fn is_valid(&self) -> bool {
        self._has_result.0 != 0
    }

    /// Whether a result moves from the memory to the pins in this clock.
    fn reads(&self) -> bool {
        self._has_waiting.0 != 0 && (!self.is_valid() || self.result_ready.val())
    }

    fn step(&mut self) {
        let places = self._results.len() as u64;
        let (reads, written) = (self.reads(), self.result_valid_in.val());
        let reads_newest = reads && self._read_place.0 == self._newest_place.0;
        let stays = self._has_waiting.0 != 0 && !reads_newest;
        self._has_result.0 = u64::from(reads || (self.is_valid() && !self.result_ready.val()));
        self._has_waiting.0 = u64::from(written || stays);
        if reads {
            self._word = self._results[self._read_place.0 as usize].clone();
        }
        if written {
            let sums = self.result_in.iter().map(|sum| sum.val().to_u64());
            self._results[self._write_place.0 as usize] =
                (sums.collect(), self.result_count_in.val().to_u64());
            self._newest_place = self._write_place;
            self._write_place.0 = (self._write_place.0 + 1) % places;
        }
        self._read_place.0 = (self._read_place.0 + u64::from(reads)) % places;
        if self.reset.val() {
            (self._write_place, self._newest_place) = Default::default();
            (self._read_place, self._has_waiting, self._has_result) = Default::default();
        }
    }
}

impl<const S: usize, const N: usize> Logic for ResultQueue<S, N> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.step();
        }
        self.result_valid.next = self.is_valid();
        let of_batch = self._read_place.0 as usize % self._engines;
        self.batch_read.next = self.reads() && of_batch == self._engines - 1;
        let (sums, count) = &self._word;
        for (result, sum) in self.result.iter_mut().zip(sums) {
            result.next = sum.to_bits();
        }
        self.result_count.next = count.to_bits();
    }

    fn connect(&mut self) {
        for result in &mut self.result {
            result.connect();
        }
        self.result_valid.connect();
        self.result_count.connect();
        self.batch_read.connect();
    }

    fn hdl(&self) -> Verilog {
        let (bits, channels) = (self._place_bits, self.result.len());
        let (high, top, last) = (channels * S + N - 1, bits - 1, self._results.len() - 1);
        // A result is the last of its batch where all place bits that count within a batch are 1.
        let batch_end = match self._engines.ilog2() {
            0 => String::new(),
            bits => format!(" & (&read_place[{}:0])", bits - 1),
        };
        let sums: String = (0..channels)
            .rev()
            .map(|channel| format!(", result_in${channel}"))
            .collect();
        let outputs: String = (0..channels)
            .map(|channel| {
                let low = channel * S;
                let high = low + S - 1;
                format!("always @(*) result${channel} = word[{high}:{low}];\n")
            })
            .collect();
        // No word is read in the clock in which it is written, so no logic needs to distinguish old from new.
        // The comparison with the newest place depends only on registers. `keep` preserves it, so that Yosys
        // does not move late signals into it.
        // On short paths it preserves `reads` too, so that one LUT is behind the comparison.
        let reads = match self._short_paths {
            false => "wire reads =",
            true => "(* keep *) wire reads;\nassign reads =",
        };
        Verilog::Custom(format!(
            "(* no_rw_check *) reg [{high}:0] results [0:{last}];\n\
             reg [{high}:0] word = {width}'d0;\n\
             reg [{top}:0] write_place = {bits}'d0;\n\
             reg [{top}:0] newest_place = {bits}'d0;\n\
             reg [{top}:0] read_place = {bits}'d0;\n\
             reg has_waiting = 1'd0;\n\
             reg has_result = 1'd0;\n\
             integer place;\n\
             initial for (place = 0; place <= {last}; place = place + 1) \
             results[place] = {width}'d0;\n\
             {reads} has_waiting & (~has_result | result_ready);\n\
             (* keep *) wire is_newest;\n\
             assign is_newest = read_place == newest_place;\n\
             wire reads_newest = reads & is_newest;\n\
             always @(*) result_valid = has_result;\n\
             always @(*) batch_read = reads{batch_end};\n\
             {outputs}\
             always @(*) result_count = word[{high}:{count_low}];\n\
             always @(posedge clock) begin\n\
             \x20 if (result_valid_in) begin\n\
             \x20   results[write_place] <= {{result_count_in{sums}}};\n\
             \x20   newest_place <= write_place;\n\
             \x20   write_place <= write_place + {bits}'d1;\n\
             \x20 end\n\
             \x20 if (reads) begin\n\
             \x20   word <= results[read_place];\n\
             \x20   read_place <= read_place + {bits}'d1;\n\
             \x20 end\n\
             \x20 has_waiting <= result_valid_in | (has_waiting & ~reads_newest);\n\
             \x20 has_result <= reads | (has_result & ~result_ready);\n\
             \x20 if (reset) begin\n\
             \x20   write_place <= {bits}'d0;\n\
             \x20   newest_place <= {bits}'d0;\n\
             \x20   read_place <= {bits}'d0;\n\
             \x20   has_waiting <= 1'd0;\n\
             \x20   has_result <= 1'd0;\n\
             \x20 end\n\
             end\n",
            width = high + 1,
            count_low = channels * S,
        ))
    }
}
