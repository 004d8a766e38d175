//! Correct blocks: the lint must report nothing.

use crate::blocks::*;
use rust_hdl::prelude::ast::{VerilogCase, VerilogExpression, VerilogMatch, VerilogStatement};
use rust_hdl::prelude::*;
use rust_hdl_lint::Rule;
use std::time::Duration;

/// The unsigned operators. Each was compared with Icarus at this width and found equal.
#[derive(LogicBlock)]
struct Operators<const N: usize> {
    a: I<N>,
    b: I<N>,
    count: I<8>,
    flag: BitI,
    k: Constant<Bits<N>>,
    sums: [O<N>; 4],
    shifts: [O<N>; 4],
    bitwise: [O<N>; 6],
    compares: [BitO; 9],
    flags: [BitO; 8],
}

impl<const N: usize> Default for Operators<N> {
    fn default() -> Self {
        Self {
            a: Default::default(),
            b: Default::default(),
            count: Default::default(),
            flag: Default::default(),
            k: Constant::new(0x555.into()),
            sums: Default::default(),
            shifts: Default::default(),
            bitwise: Default::default(),
            compares: Default::default(),
            flags: Default::default(),
        }
    }
}

impl<const N: usize> Logic for Operators<N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.sums[0].next = self.a.val() + self.b.val();
        self.sums[1].next = self.a.val() - self.b.val();
        self.sums[2].next = self.a.val() + 0x7FF;
        self.sums[3].next = self.a.val() + self.flag.val();
        self.shifts[0].next = self.a.val() << 3;
        self.shifts[1].next = self.a.val() >> 200;
        self.shifts[2].next = self.a.val() << self.count.val();
        self.shifts[3].next = self.a.val() >> self.count.val();
        self.bitwise[0].next = self.a.val() & self.b.val();
        self.bitwise[1].next = self.a.val() | self.k.val();
        self.bitwise[2].next = self.a.val() ^ 0x55;
        self.bitwise[3].next = !self.a.val();
        self.bitwise[4].next = self.a.val().replace_bit(5, self.flag.val());
        self.bitwise[5].next = self.a.val().replace_bit(self.count.val().index(), true);
        self.compares[0].next = self.a.val() == self.b.val();
        self.compares[1].next = self.a.val() != self.k.val();
        self.compares[2].next = self.a.val() < self.b.val();
        self.compares[3].next = self.a.val() <= 0xFFF;
        self.compares[4].next = self.a.val() > bits::<N>(5);
        self.compares[5].next = 5 >= self.a.val();
        self.compares[6].next = self.flag.val() & (self.a.val() == self.b.val());
        self.compares[7].next = !(self.a.val() > self.b.val());
        self.compares[8].next = (self.a.val() < 3) && !self.flag.val();
        self.flags[0].next = self.a.val().any();
        self.flags[1].next = self.a.val().all();
        self.flags[2].next = self.a.val().xor();
        self.flags[3].next = self.a.val().get_bit(11);
        self.flags[4].next = self.a.val().get_bit(self.count.val().index());
        self.flags[5].next = !self.a.val().any() | (self.flag.val() & !self.b.val().all());
        self.flags[6].next = self.flag.val();
        self.flags[7].next = true;
    }
}

/// The signed operators. Each was compared with Icarus at this width and found equal.
#[derive(LogicBlock, Default)]
struct SignedOperators<const N: usize> {
    a: SignedI<N>,
    b: SignedI<N>,
    raw: I<N>,
    sums: [SignedO<N>; 6],
    compares: [BitO; 6],
    bits: O<N>,
}

impl<const N: usize> Logic for SignedOperators<N> {
    #[hdl_gen]
    fn update(&mut self) {
        self.sums[0].next = self.a.val() + self.b.val();
        self.sums[1].next = self.a.val() - self.b.val();
        self.sums[2].next = -self.a.val();
        self.sums[3].next = signed_cast(self.raw.val());
        self.sums[4].next = self.a.val() + 5.into();
        self.sums[5].next = (-5).into();
        self.compares[0].next = self.a.val() < self.b.val();
        self.compares[1].next = self.a.val() >= self.b.val();
        self.compares[2].next = self.a.val() == self.b.val();
        self.compares[3].next = self.a.val() < signed_cast(self.raw.val());
        self.compares[4].next = self.a.val() == 5.into();
        self.compares[5].next = self.a.val().get_bit(3);
        self.bits.next = unsigned_cast(self.a.val());
    }
}

block!(Casts {
    zero: O<24>, pair: O<24>, narrow: O<8>, extended: SignedO<34>, product: O<32>,
    cast_product: O<32>, signed_product: SignedO<32>, slice: O<4>, moving: O<4>, rows: [O<4>; 3],
    sign: O<24>, k: Constant<Bits<24>> = Constant::new(0x8000.into()), wide: L<24>, offset: L<24>,
    big: O<130>, huge: Constant<Bits<130>> = Constant::new(u128::MAX.to_bits()), long: O<64>,
    narrowed: SignedO<8>, little: SignedO<8>, less: BitO, named: O<4>,
    place: Constant<Bits<4>> = Constant::new(8.into()),
}
    #[hdl_gen]
    fn update(&mut self) {
        self.zero.next = bit_cast::<24, 12>(self.a.val());
        self.pair.next = (bit_cast::<24, 12>(self.a.val()) << 12) | bit_cast::<24, 12>(self.b.val());
        self.narrow.next = bit_cast::<8, 12>(self.a.val());
        self.extended.next = signed_bit_cast::<34, 16>(self.s.val());
        self.narrowed.next = signed_bit_cast::<8, 16>(self.s.val());
        self.little.next = signed_cast(bit_cast::<8, 12>(self.a.val()));
        self.less.next = signed_bit_cast::<34, 16>(self.s.val()) < self.u.val();
        self.product.next = self.m.val() * self.m.val();
        self.cast_product.next = bit_cast::<16, 12>(self.a.val()) * bit_cast::<16, 12>(self.b.val());
        self.signed_product.next = self.s.val() * self.t.val();
        self.slice.next = self.a.val().get_bits::<4>(8);
        self.named.next = self.a.val().get_bits::<4>(self.place.val().index());
        self.moving.next = self.a.val().get_bits::<4>(self.three.val().index());
        for i in 0..3 {
            self.rows[i].next = self.a.val().get_bits::<4>(4 * i);
        }
        self.wide.next = bit_cast::<24, 16>(self.m.val());
        self.offset.next = self.wide.val() ^ self.k.val();
        self.sign.next = self.offset.val() - self.k.val();
        self.big.next = bit_cast::<130, 12>(self.a.val()) + self.huge.val();
        self.long.next = 0xFFFF_FFFF_FFFF_u64.into();
    }
);

#[derive(Copy, Clone, PartialEq, Debug, LogicState)]
enum Op {
    Nop,
    Load,
    Square,
}

/// The minimal block of the field guide.
#[derive(LogicBlock)]
struct Cell<const CW: usize, const W: usize> {
    clock: Signal<In, Clock>,
    data_in: I<CW>,
    op: Signal<In, Op>,
    enable: BitI,
    data_out: O<W>,
    c: DFF<Bits<CW>>,
    s: DFF<Bits<W>>,
    d: L<16>,
    sq: L<32>,
    k: Constant<Bits<W>>,
    initial_op: Constant<Op>,
    later_op: Constant<Op>,
    seen: DFFWithInit<Bits<CW>>,
}

impl<const CW: usize, const W: usize> Default for Cell<CW, W> {
    fn default() -> Self {
        Self {
            clock: Default::default(),
            data_in: Default::default(),
            op: Default::default(),
            enable: Default::default(),
            data_out: Default::default(),
            c: Default::default(),
            s: Default::default(),
            d: Default::default(),
            sq: Default::default(),
            k: Constant::new(3.into()),
            initial_op: Constant::new(Op::Square),
            later_op: Constant::new(Op::Load),
            seen: DFFWithInit::new(7.into()),
        }
    }
}

impl<const CW: usize, const W: usize> Logic for Cell<CW, W> {
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, c, s, seen);
        self.d.next = bit_cast::<16, CW>(self.c.q.val());
        self.sq.next = self.d.val() * self.d.val();
        match self.op.val() {
            Op::Nop => {}
            Op::Load => {
                if self.enable.val() {
                    self.c.d.next = self.data_in.val();
                }
            }
            Op::Square => {
                self.s.d.next = bit_cast::<W, 32>(self.sq.val());
            }
            _ => {}
        }
        if (self.op.val() == Op::Nop) | (self.op.val() == self.initial_op.val()) {
            self.s.d.next = self.k.val();
        } else if self.op.val() == self.later_op.val() {
            self.s.d.next = self.s.q.val();
        }
        self.data_out.next = self.s.q.val();
    }
}

/// Sixteen cells, each connected to its neighbours on two axes.
#[derive(LogicBlock, Default)]
struct Array {
    clock: Signal<In, Clock>,
    axis: I<2>,
    op: Signal<In, Op>,
    data_in: I<12>,
    data_out: O<26>,
    cell: [Cell<12, 26>; 16],
}

impl Logic for Array {
    #[hdl_gen]
    fn update(&mut self) {
        self.data_out.next = self.cell[0].data_out.val();
        for i in 0..16 {
            self.cell[i].clock.next = self.clock.val();
            self.cell[i].op.next = self.op.val();
            self.cell[i].enable.next = true;
            self.cell[i].data_in.next = self.data_in.val();
            if self.axis.val().index() == 1 {
                self.cell[i].data_in.next = self.cell[i + 4 - 2 * 4 * ((i / 4) % 2)]
                    .data_out
                    .val()
                    .get_bits::<12>(0);
            }
            if self.axis.val().index() == i + 2 {
                self.data_out.next = self.cell[i + 1 - 2 * (i % 2)].data_out.val();
            }
        }
    }
}

#[derive(Copy, Clone, PartialEq, Debug, Default, LogicStruct)]
struct Word {
    power: Bits<8>,
    shift: Bits<6>,
    op: Op,
    last: Bit,
}

#[derive(LogicInterface, Default)]
#[join = "Sink"]
struct Source {
    data: Signal<Out, Bits<12>>,
    valid: Signal<Out, Bit>,
    ready: Signal<In, Bit>,
}

#[derive(LogicInterface, Default)]
#[join = "Source"]
struct Sink {
    data: Signal<In, Bits<12>>,
    valid: Signal<In, Bit>,
    ready: Signal<Out, Bit>,
}

#[derive(LogicBlock, Default)]
struct Producer {
    count: I<12>,
    stream: Source,
}

impl Logic for Producer {
    #[hdl_gen]
    fn update(&mut self) {
        self.stream.data.next = self.count.val();
        self.stream.valid.next = self.stream.ready.val();
    }
}

#[derive(LogicBlock, Default)]
struct Consumer {
    stream: Sink,
    word: Signal<In, Word>,
    copy: Signal<Out, Word>,
    op: Signal<Out, Op>,
    shift: O<6>,
    little: BitO,
}

impl Logic for Consumer {
    #[hdl_gen]
    fn update(&mut self) {
        self.stream.ready.next = self.stream.valid.val() & self.word.val().last;
        self.copy.next = self.word.val();
        self.copy.next.power = self.stream.data.val().get_bits::<8>(2);
        self.op.next = self.word.val().op;
        self.shift.next = self.word.val().shift;
        self.little.next = self.word.val().power < 3;
    }
}

/// A block with one stream joined inside and one stream that passes through.
#[derive(LogicBlock, Default)]
struct Streams {
    count: I<12>,
    word: Signal<In, Word>,
    out: Source,
    op: Signal<Out, Op>,
    left: Producer,
    right: Consumer,
    through: Producer,
}

impl Logic for Streams {
    #[hdl_gen]
    fn update(&mut self) {
        self.left.count.next = self.count.val();
        self.through.count.next = self.count.val();
        self.right.word.next = self.word.val();
        self.op.next = self.right.op.val();
        Source::join(&mut self.left.stream, &mut self.right.stream);
        Source::link(&mut self.out, &mut self.through.stream);
    }
}

block!(HandWrittenTable { y: O<12> }
    fn update(&mut self) {}
    fn connect(&mut self) {
        self.y.connect();
    }
    fn hdl(&self) -> Verilog {
        let name = |name: &str| VerilogExpression::Signal(name.into());
        let row = |condition: &str, value: u32| VerilogCase {
            condition: condition.into(),
            block: vec![VerilogStatement::Assignment(
                name("y"),
                VerilogExpression::Literal(value.into()),
            )],
        };
        let cases = vec![row("3'd0", 5), row("3'h7", 6), row("3'b011", 7), row("default", 0)];
        Verilog::Combinatorial(vec![VerilogStatement::Match(VerilogMatch {
            test: name("three"),
            cases,
        })])
    }
);

fn bytes(count: u64) -> impl Iterator<Item = Bits<8>> {
    (0..count).map(|word| word.into())
}

fn assert_clean<B: Block>(name: &str, block: B) {
    let found: Vec<String> = findings(block).iter().map(ToString::to_string).collect();
    assert!(found.is_empty(), "{name}:\n{}", found.join("\n"));
}

#[test]
fn what_matched_as_written_is_clean() {
    assert_clean("12 bits", Operators::<12>::default());
    assert_clean("32 bits", Operators::<32>::default());
    assert_clean("34 bits", Operators::<34>::default());
    assert_clean("72 bits", Operators::<72>::default());
    assert_clean("130 bits", Operators::<130>::default());
    assert_clean("signed 16", SignedOperators::<16>::default());
    assert_clean("signed 34", SignedOperators::<34>::default());
    assert_clean("casts", Casts::default());
}

#[test]
fn statements_and_hierarchies_are_clean() {
    assert_clean("cell", Cell::<12, 26>::default());
    assert_clean("array", Array::default());
    assert_clean("table", HandWrittenTable::default());
    assert_clean("streams", Streams::default());
    assert_clean("under TopWrap", TopWrap::new(Array::default()));
}

#[test]
fn widgets_of_the_library_are_clean() {
    assert_clean("register", DFF::<Signed<9>>::default());
    assert_clean(
        "register with a value",
        DFFWithInit::<Bits<9>>::new(3.into()),
    );
    assert_clean("edge detector", EdgeDetector::new(true));
    assert_clean("reset", AutoReset::default());
    assert_clean("pulse width", PulseWidthModulator::<8>::default());
    assert_clean("shot", Shot::<32>::new(1_000_000, Duration::from_millis(1)));
    assert_clean(
        "pulser",
        Pulser::new(1_000_000, 1.0, Duration::from_millis(1)),
    );
    assert_clean("synchronizer", VectorSynchronizer::<Bits<8>>::default());
    assert_clean("delay line", DelayLine::<Bits<8>, 8, 3>::default());
    assert_clean("memory", RAM::<Bits<8>, 4>::from(bytes(16)));
    assert_clean("table", SyncROM::<Bits<8>, 4>::from(bytes(16)));
    assert_clean("cases", ROM::<Bits<8>, 4>::from(bytes(5)));
}

#[test]
fn a_library_fifo_agrees_though_it_is_not_three_address_code() {
    let rules: Vec<Rule> = findings(SynchronousFIFO::<Bits<8>, 4, 5, 1>::default())
        .iter()
        .map(|finding| finding.rule)
        .filter(|rule| *rule != Rule::UninitialisedMemory)
        .collect();
    assert!(!rules.is_empty());
    assert!(
        rules.iter().all(|rule| *rule == Rule::SeveralOperators),
        "{rules:?}"
    );
}
