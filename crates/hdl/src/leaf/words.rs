//! The two memories of a leaf machine in block RAM: the words of groups, and the entries of leaves with the boxes of their groups.
//!
//! Their words are wider than rust-hdl's kernels handle well, and their depth follows from the machine, so their Verilog is
//! written by hand.

use photoncube_spec::{Leaf, Spatial};
use rust_hdl::prelude::*;

use super::FACING;
use super::boxes::OF_LEAF;
use crate::defaults::{defaulted, signals};
use crate::parts::{Field, GroupPins, group_fields};

const LANES: usize = Spatial::LANES;

/// The name of a memory's array.
pub(super) const GROUPS: &str = "groups";
/// The names of the arrays of entries: the boxes of the first and of the second leaf of each pair, and the notes of both.
pub(super) const BOXES: [&str; Leaf::PAIR + 1] = ["boxes_0", "boxes_1", NOTES];
const NOTES: &str = "notes";
/// The names of the words that are written to them.
const BORDERS_WORD: &str = "box";
const NOTES_WORD: &str = "note";

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

/// The entries of a pair: the borders of each leaf's groups, low ones first; and the facings of the leaves, then whether each has one
/// group.
#[derive(Clone, Debug)]
pub(super) struct BoxPair {
    pub borders: [Vec<u64>; Leaf::PAIR],
    pub notes: Vec<u64>,
}

/// The entries of the leaves of both banks: the boxes of a leaf's groups, its facing, and whether it has one group. `LB` bits of a leaf's
/// number, `KB = LB - 1` of a pair's. The boxes of each leaf of a pair are an array. The notes beside them are an array of both leaves, since
/// a block RAM of its own for each leaf would be mostly empty.
#[derive(LogicBlock)]
pub(crate) struct BoxWords<const H: usize, const LB: usize, const KB: usize> {
    pub clock: Signal<In, Clock>,
    /// Axis a of group g of the leaf is at 3 g + a.
    pub low: [Signal<In, Bits<H>>; OF_LEAF],
    pub high: [Signal<In, Bits<H>>; OF_LEAF],
    pub facing: [Signal<In, Bits<FACING>>; Leaf::PAIR],
    pub short: [Signal<In, Bit>; Leaf::PAIR],
    pub write: Signal<In, Bit>,
    pub write_bank: Signal<In, Bit>,
    pub write_leaf: Signal<In, Bits<LB>>,
    pub read: Signal<In, Bit>,
    pub read_bank: Signal<In, Bit>,
    pub read_pair: Signal<In, Bits<KB>>,
    /// The words in `Found`: axis a of group i of the pair is at 3 i + a.
    pub found_low: [Signal<Out, Bits<H>>; OF_LEAF * Leaf::PAIR],
    pub found_high: [Signal<Out, Bits<H>>; OF_LEAF * Leaf::PAIR],
    pub found_facing: [Signal<Out, Bits<FACING>>; Leaf::PAIR],
    pub found_short: [Signal<Out, Bit>; Leaf::PAIR],
    _pairs: Vec<BoxPair>,
    pub(super) _look: BoxPair,
    pub(super) _found: BoxPair,
}

impl<const H: usize, const LB: usize, const KB: usize> Default for BoxWords<H, LB, KB> {
    fn default() -> Self {
        assert!(LB == KB + 1, "a pair is two leaves");
        let nothing = BoxPair {
            borders: [(); Leaf::PAIR].map(|()| vec![0; 2 * OF_LEAF]),
            notes: vec![0; 2 * Leaf::PAIR],
        };
        defaulted!(Self {
            _pairs: vec![nothing.clone(); 2 << KB],
            _look: nothing.clone(),
            _found: nothing,
        };
            clock low high facing short write write_bank write_leaf read read_bank read_pair found_low found_high
            found_facing found_short
        )
    }
}

/// The places of numbered ports of these names, in the order of their bits.
fn numbered(names: [&str; 2], count: usize, widths: [usize; 2]) -> Vec<Field> {
    let of = |(name, width): (&str, usize)| {
        let fields = (0..count).map(move |place| Field {
            name: format!("{name}${place}"),
            width,
        });
        fields.collect::<Vec<_>>()
    };
    names.into_iter().zip(widths).flat_map(of).collect()
}

impl<const H: usize, const LB: usize, const KB: usize> BoxWords<H, LB, KB> {
    /// The number of pairs in both banks.
    pub fn depth(&self) -> usize {
        2 << KB
    }

    /// The fields of a leaf's borders, from bit 0 up.
    fn borders() -> Vec<Field> {
        numbered(["low", "high"], OF_LEAF, [H; 2])
    }

    /// The fields of a pair's notes, from bit 0 up.
    fn notes() -> Vec<Field> {
        numbered(["facing", "short"], Leaf::PAIR, [FACING, 1])
    }

    fn step(&mut self) {
        self._found = self._look.clone();
        if self.read.val() {
            let pair = self.read_pair.val().to_u64() as usize;
            self._look = self._pairs[usize::from(self.read_bank.val()) << KB | pair].clone();
        }
        if !self.write.val() {
            return;
        }
        let mut borders: Vec<_> = self.low.iter().map(|low| low.val().to_u64()).collect();
        borders.extend(self.high.iter().map(|high| high.val().to_u64()));
        let leaf = self.write_leaf.val().to_u64() as usize;
        let pair = &mut self._pairs[(usize::from(self.write_bank.val()) << KB) | (leaf / 2)];
        pair.borders[leaf % Leaf::PAIR..].fill(borders);
        let facings = self.facing.iter().map(|facing| facing.val().to_u64());
        let shorts = self.short.iter().map(|short| short.val().into());
        pair.notes = facings.chain(shorts).collect();
    }
}

impl<const H: usize, const LB: usize, const KB: usize> Logic for BoxWords<H, LB, KB> {
    fn update(&mut self) {
        if self.clock.pos_edge() {
            self.step();
        }
        for leaf in 0..Leaf::PAIR {
            let borders = &self._found.borders[leaf];
            for place in 0..OF_LEAF {
                self.found_low[OF_LEAF * leaf + place].next = borders[place].to_bits();
                self.found_high[OF_LEAF * leaf + place].next = borders[OF_LEAF + place].to_bits();
            }
            self.found_facing[leaf].next = self._found.notes[leaf].to_bits();
            self.found_short[leaf].next = self._found.notes[Leaf::PAIR + leaf] != 0;
        }
    }

    fn connect(&mut self) {
        self.found_low.iter_mut().for_each(Signal::connect);
        self.found_high.iter_mut().for_each(Signal::connect);
        self.found_facing.iter_mut().for_each(Signal::connect);
        self.found_short.iter_mut().for_each(Signal::connect);
    }

    fn hdl(&self) -> Verilog {
        let (borders, notes) = (Self::borders(), Self::notes());
        let last = self.depth() - 1;
        let [mut arrays, mut steps, mut views] = [(); 3].map(|()| String::new());
        // Each array with its fields, the number of the first of each field, the word that is written, and where it is.
        for (number, array) in BOXES.iter().enumerate() {
            let is_note = *array == NOTES;
            let fields = if is_note { &notes } else { &borders };
            let (width, high) = (width_of(fields), width_of(fields) - 1);
            let word = if is_note { NOTES_WORD } else { BORDERS_WORD };
            let writes = if number == 0 {
                "write & ~write_leaf[0]"
            } else {
                "write"
            };
            arrays += &format!(
                "(* no_rw_check *) reg [{high}:0] {array} [0:{last}];\n\
                 reg [{high}:0] look_{number} = {width}'d0;\n\
                 reg [{high}:0] found_{number} = {width}'d0;\n"
            );
            steps += &format!(
                "\x20 if (read) look_{number} <= {array}[read_address];\n\
                 \x20 found_{number} <= look_{number};\n\
                 \x20 if ({writes}) {array}[write_address] <= {word};\n"
            );
            let first = if is_note { 0 } else { OF_LEAF * number };
            views += &lines(fields, |name, range, top| {
                let (stem, place) = name.split_once('$').expect("the ports are numbered");
                let index = first + place.parse::<usize>().expect("by their place");
                format!(
                    "wire [{top}:0] of_look_{stem}_{index} = look_{number}[{range}];\n\
                     wire [{top}:0] of_found_{stem}_{index} = found_{number}[{range}];\n\
                     always @(*) found_{stem}${index} = of_found_{stem}_{index};\n"
                )
            });
        }
        let [borders_high, notes_high] = [&borders, &notes].map(|fields| width_of(fields) - 1);
        Verilog::Custom(format!(
            "{arrays}\
             wire [{borders_high}:0] {BORDERS_WORD} = {{{of_leaf}}};\n\
             wire [{notes_high}:0] {NOTES_WORD} = {{{of_pair}}};\n\
             wire [{KB}:0] write_address = {{write_bank, write_leaf[{KB}:1]}};\n\
             wire [{KB}:0] read_address = {{read_bank, read_pair}};\n\
             always @(posedge clock) begin\n{steps}end\n{views}",
            of_leaf = concatenation(&borders),
            of_pair = concatenation(&notes),
        ))
    }
}
