//! The two memories of a leaf machine in block RAM: the words of groups, and the boxes of leaves.
//!
//! Their words are wider than rust-hdl's kernels handle well, and their depth follows from the machine, so their Verilog is
//! written by hand.

use photoncube_spec::{Leaf, Spatial};
use rust_hdl::prelude::*;

use super::FACING;
use crate::defaults::{defaulted, signals};
use crate::parts::{Field, GroupPins, group_fields};

const LANES: usize = Spatial::LANES;
const AXES: usize = 3;

/// The name of a memory's array.
pub(super) const GROUPS: &str = "groups";
/// The names of the arrays of boxes: the first and the second leaf of each pair.
pub(super) const BOXES: [&str; Leaf::PAIR] = ["boxes_0", "boxes_1"];

/// Bits of a word.
fn width_of(fields: &[Field]) -> usize {
    fields.iter().map(|field| field.width).sum()
}

/// The Verilog concatenation of the ports of these names.
fn concatenation(fields: &[Field]) -> String {
    let names = fields.iter().rev();
    let names: Vec<_> = names.map(|field| field.name.as_str()).collect();
    names.join(", ")
}

/// For each field a line of text, given its name and the range of its bits.
fn lines(fields: &[Field], line: impl Fn(&str, String, usize) -> String) -> String {
    let mut low = 0;
    let text = fields.iter().map(|Field { name, width }| {
        let first = low;
        low += width;
        line(name, format!("{}:{first}", low - 1), width - 1)
    });
    text.collect()
}

/// The words of the groups of both banks. `H` coordinate, `B` mantissa, `E` exponent, `PB` place bits.
#[derive(LogicBlock)]
pub(crate) struct GroupWords<const H: usize, const B: usize, const E: usize, const PB: usize> {
    pub clock: Signal<In, Clock>,
    pub present: [Signal<In, Bits<1>>; LANES],
    pub x: [Signal<In, Bits<H>>; LANES],
    pub y: [Signal<In, Bits<H>>; LANES],
    pub z: [Signal<In, Bits<H>>; LANES],
    /// The mantissas: channel c of lane g is at 4 c + g.
    pub channel: Vec<Signal<In, Bits<B>>>,
    pub exponent: Vec<Signal<In, Bits<E>>>,
    /// The words of the clock before are written to a place.
    pub write: Signal<In, Bit>,
    pub write_bank: Signal<In, Bit>,
    pub write_place: Signal<In, Bits<PB>>,
    pub read: Signal<In, Bit>,
    pub read_bank: Signal<In, Bit>,
    pub read_place: Signal<In, Bits<PB>>,
    /// The words in `Write`.
    pub write_present: [Signal<Out, Bits<1>>; LANES],
    pub write_x: [Signal<Out, Bits<H>>; LANES],
    pub write_y: [Signal<Out, Bits<H>>; LANES],
    pub write_z: [Signal<Out, Bits<H>>; LANES],
    /// The words in `Word`.
    pub word_present: [Signal<Out, Bits<1>>; LANES],
    pub word_x: [Signal<Out, Bits<H>>; LANES],
    pub word_y: [Signal<Out, Bits<H>>; LANES],
    pub word_z: [Signal<Out, Bits<H>>; LANES],
    pub word_channel: Vec<Signal<Out, Bits<B>>>,
    pub word_exponent: Vec<Signal<Out, Bits<E>>>,
    /// The words of both banks; a word has a number for each of its fields.
    _groups: Vec<Vec<u64>>,
    pub(super) _write: Vec<u64>,
    pub(super) _read: Vec<u64>,
    pub(super) _word: Vec<u64>,
    /// The names of the channels in the emitted text.
    pub(super) _channels: &'static [&'static str],
}

impl<const H: usize, const B: usize, const E: usize, const PB: usize> GroupWords<H, B, E, PB> {
    pub fn new(channels: &'static [&'static str]) -> Self {
        let words = channels.len() * LANES;
        let exponents = if E > 0 { LANES } else { 0 };
        let mut memory = defaulted!(Self {
            channel: signals(words),
            exponent: signals(exponents),
            word_channel: signals(words),
            word_exponent: signals(exponents),
            _groups: Vec::new(),
            _write: Vec::new(),
            _read: Vec::new(),
            _word: Vec::new(),
            _channels: channels,
        };
            clock present x y z write write_bank write_place read read_bank read_place write_present write_x
            write_y write_z word_present word_x word_y word_z
        );
        let nothing = vec![0; memory.fields().len()];
        memory._groups = vec![nothing.clone(); memory.depth()];
        memory._write.clone_from(&nothing);
        memory._read.clone_from(&nothing);
        memory._word = nothing;
        memory
    }

    /// The number of words in both banks.
    pub fn depth(&self) -> usize {
        2 << PB
    }

    /// The fields of a word, from bit 0 up: for each lane presence, coordinates, mantissas and exponent.
    fn fields(&self) -> Vec<Field> {
        group_fields([H, B, E], self.channel.len())
    }

    /// The index in a word of a lane's field, in the order of `fields`.
    pub(super) fn place(&self, lane: usize, field: usize) -> usize {
        lane * self._word.len() / LANES + field
    }

    fn group(&self) -> Vec<u64> {
        GroupPins {
            present: &self.present,
            position: [&self.x, &self.y, &self.z],
            channel: &self.channel,
            exponent: &self.exponent,
        }
        .word()
    }

    fn step(&mut self) {
        let address =
            |bank: bool, place: Bits<PB>| usize::from(bank) << PB | place.to_u64() as usize;
        self._word.clone_from(&self._read);
        if self.read.val() {
            let place = address(self.read_bank.val(), self.read_place.val());
            self._read.clone_from(&self._groups[place]);
        }
        if self.write.val() {
            let place = address(self.write_bank.val(), self.write_place.val());
            self._groups[place].clone_from(&self._write);
        }
        self._write = self.group();
    }
}

impl<const H: usize, const B: usize, const E: usize, const PB: usize> Logic
    for GroupWords<H, B, E, PB>
{
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.step();
        }
        let channels = self._channels.len();
        for lane in 0..LANES {
            let start = self.place(lane, 0);
            let (write, word) = (&self._write[start..], &self._word[start..]);
            self.write_present[lane].next = write[0].to_bits();
            self.write_x[lane].next = write[1].to_bits();
            self.write_y[lane].next = write[2].to_bits();
            self.write_z[lane].next = write[3].to_bits();
            self.word_present[lane].next = word[0].to_bits();
            self.word_x[lane].next = word[1].to_bits();
            self.word_y[lane].next = word[2].to_bits();
            self.word_z[lane].next = word[3].to_bits();
            for channel in 0..channels {
                self.word_channel[LANES * channel + lane].next = word[4 + channel].to_bits();
            }
            if let Some(exponent) = self.word_exponent.get_mut(lane) {
                exponent.next = word[4 + channels].to_bits();
            }
        }
    }

    fn connect(&mut self) {
        for lane in 0..LANES {
            self.write_present[lane].connect();
            self.write_x[lane].connect();
            self.write_y[lane].connect();
            self.write_z[lane].connect();
            self.word_present[lane].connect();
            self.word_x[lane].connect();
            self.word_y[lane].connect();
            self.word_z[lane].connect();
        }
        self.word_channel.iter_mut().for_each(Signal::connect);
        self.word_exponent.iter_mut().for_each(Signal::connect);
    }

    fn hdl(&self) -> Verilog {
        let fields = self.fields();
        let width = width_of(&fields);
        let is_position =
            |name: &str| !name.starts_with("channel") && !name.starts_with("exponent");
        let views = lines(&fields, |name, range, top| {
            let written = match is_position(name) {
                true => format!("always @(*) write_{name} = of_write_{name};\n"),
                false => String::new(),
            };
            format!(
                "wire [{top}:0] of_write_{name} = write_word[{range}];\n\
                 wire [{top}:0] of_read_{name} = read_word[{range}];\n\
                 wire [{top}:0] of_word_{name} = word[{range}];\n\
                 always @(*) word_{name} = of_word_{name};\n{written}"
            )
        });
        Verilog::Custom(format!(
            "(* no_rw_check *) reg [{high}:0] {GROUPS} [0:{last}];\n\
             reg [{high}:0] write_word = {width}'d0;\n\
             reg [{high}:0] read_word = {width}'d0;\n\
             reg [{high}:0] word = {width}'d0;\n\
             wire [{high}:0] group = {{{group}}};\n\
             wire [{PB}:0] write_address = {{write_bank, write_place}};\n\
             wire [{PB}:0] read_address = {{read_bank, read_place}};\n\
             always @(posedge clock) begin\n\
             \x20 if (read) read_word <= {GROUPS}[read_address];\n\
             \x20 word <= read_word;\n\
             \x20 write_word <= group;\n\
             \x20 if (write) {GROUPS}[write_address] <= write_word;\n\
             end\n\
             {views}",
            high = width - 1,
            last = self.depth() - 1,
            group = concatenation(&fields),
        ))
    }
}

/// The boxes of the leaves of both banks, each with its facing and whether its leaf has one group; `LB` bits of a leaf's number,
/// `KB = LB - 1` of a pair's.
#[derive(LogicBlock)]
pub(crate) struct BoxWords<const H: usize, const LB: usize, const KB: usize> {
    pub clock: Signal<In, Clock>,
    pub low: [Signal<In, Bits<H>>; AXES],
    pub high: [Signal<In, Bits<H>>; AXES],
    pub facing: Signal<In, Bits<FACING>>,
    pub short: Signal<In, Bit>,
    pub write: Signal<In, Bit>,
    pub write_bank: Signal<In, Bit>,
    pub write_leaf: Signal<In, Bits<LB>>,
    pub read: Signal<In, Bit>,
    pub read_bank: Signal<In, Bit>,
    pub read_pair: Signal<In, Bits<KB>>,
    /// The words in `Found`: axis a of leaf i is at 3 i + a.
    pub found_low: [Signal<Out, Bits<H>>; AXES * Leaf::PAIR],
    pub found_high: [Signal<Out, Bits<H>>; AXES * Leaf::PAIR],
    pub found_facing: [Signal<Out, Bits<FACING>>; Leaf::PAIR],
    pub found_short: [Signal<Out, Bit>; Leaf::PAIR],
    _boxes: [Vec<Vec<u64>>; Leaf::PAIR],
    pub(super) _look: [Vec<u64>; Leaf::PAIR],
    pub(super) _found: [Vec<u64>; Leaf::PAIR],
}

impl<const H: usize, const LB: usize, const KB: usize> Default for BoxWords<H, LB, KB> {
    fn default() -> Self {
        assert!(LB == KB + 1, "a pair is two leaves");
        let nothing = vec![0; Self::fields().len()];
        let two = || [nothing.clone(), nothing.clone()];
        defaulted!(Self {
            _boxes: two().map(|word| vec![word; 2 << KB]),
            _look: two(),
            _found: two(),
        };
            clock low high facing short write write_bank write_leaf read read_bank read_pair found_low found_high
            found_facing found_short
        )
    }
}

impl<const H: usize, const LB: usize, const KB: usize> BoxWords<H, LB, KB> {
    /// The places of a word's fields.
    pub(super) const LOW: usize = 0;
    pub(super) const HIGH: usize = AXES;
    pub(super) const FACING: usize = 2 * AXES;
    pub(super) const SHORT: usize = 2 * AXES + 1;

    /// The number of words in both banks, for each leaf of a pair.
    pub fn depth(&self) -> usize {
        2 << KB
    }

    /// The fields of a word, from bit 0 up.
    fn fields() -> Vec<Field> {
        let border = |name: &str, axis| Field {
            name: format!("{name}${axis}"),
            width: H,
        };
        let one = |name: &str, width| Field {
            name: name.to_owned(),
            width,
        };
        let low = (0..AXES).map(|axis| border("low", axis));
        let high = (0..AXES).map(|axis| border("high", axis));
        low.chain(high)
            .chain([one("facing", Leaf::FACING_BITS as usize), one("short", 1)])
            .collect()
    }

    fn step(&mut self) {
        self._found = self._look.clone();
        if self.read.val() {
            let pair = self.read_pair.val().to_u64() as usize;
            let place = usize::from(self.read_bank.val()) << KB | pair;
            self._look = [0, 1].map(|leaf| self._boxes[leaf][place].clone());
        }
        if !self.write.val() {
            return;
        }
        let mut word: Vec<_> = self.low.iter().map(|low| low.val().to_u64()).collect();
        word.extend(self.high.iter().map(|high| high.val().to_u64()));
        word.extend([self.facing.val().to_u64(), self.short.val().into()]);
        let leaf = self.write_leaf.val().to_u64() as usize;
        let place = (usize::from(self.write_bank.val()) << KB) | (leaf / 2);
        if leaf.is_multiple_of(Leaf::PAIR) {
            self._boxes[0][place].clone_from(&word);
        }
        self._boxes[1][place] = word;
    }
}

impl<const H: usize, const LB: usize, const KB: usize> Logic for BoxWords<H, LB, KB> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.step();
        }
        for leaf in 0..Leaf::PAIR {
            let word = &self._found[leaf];
            for axis in 0..AXES {
                self.found_low[AXES * leaf + axis].next = word[Self::LOW + axis].to_bits();
                self.found_high[AXES * leaf + axis].next = word[Self::HIGH + axis].to_bits();
            }
            self.found_facing[leaf].next = word[Self::FACING].to_bits();
            self.found_short[leaf].next = word[Self::SHORT] != 0;
        }
    }

    fn connect(&mut self) {
        self.found_low.iter_mut().for_each(Signal::connect);
        self.found_high.iter_mut().for_each(Signal::connect);
        self.found_facing.iter_mut().for_each(Signal::connect);
        self.found_short.iter_mut().for_each(Signal::connect);
    }

    fn hdl(&self) -> Verilog {
        let fields = Self::fields();
        let width = width_of(&fields);
        let (high, last) = (width - 1, self.depth() - 1);
        let [mut arrays, mut reads, mut views] = [(); 3].map(|()| String::new());
        for (leaf, array) in BOXES.iter().enumerate() {
            arrays += &format!(
                "(* no_rw_check *) reg [{high}:0] {array} [0:{last}];\n\
                 reg [{high}:0] look_{leaf} = {width}'d0;\n\
                 reg [{high}:0] found_{leaf} = {width}'d0;\n"
            );
            let writes = if leaf == 0 {
                "write & ~write_leaf[0]"
            } else {
                "write"
            };
            reads += &format!(
                "\x20 if (read) look_{leaf} <= {array}[read_address];\n\
                 \x20 found_{leaf} <= look_{leaf};\n\
                 \x20 if ({writes}) {array}[write_address] <= box;\n"
            );
            views += &lines(&fields, |name, range, top| {
                let (stem, index) = match name.split_once('$') {
                    Some((stem, axis)) => {
                        let axis: usize = axis.parse().expect("borders are numbered by axis");
                        (stem, AXES * leaf + axis)
                    }
                    None => (name, leaf),
                };
                format!(
                    "wire [{top}:0] of_look_{stem}_{index} = look_{leaf}[{range}];\n\
                     wire [{top}:0] of_found_{stem}_{index} = found_{leaf}[{range}];\n\
                     always @(*) found_{stem}${index} = of_found_{stem}_{index};\n"
                )
            });
        }
        Verilog::Custom(format!(
            "{arrays}\
             wire [{high}:0] box = {{{word}}};\n\
             wire [{KB}:0] write_address = {{write_bank, write_leaf[{KB}:1]}};\n\
             wire [{KB}:0] read_address = {{read_bank, read_pair}};\n\
             always @(posedge clock) begin\n{reads}end\n{views}",
            word = concatenation(&fields),
        ))
    }
}
