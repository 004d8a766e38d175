//! Planted cases for the reports of findings and opaque blocks.

use crate::blocks::*;
use rust_hdl::prelude::*;
use rust_hdl_lint::{Design, OpaqueKind, Rule, lint};

block!(Inner { y: O<13>, z13: [O<13>; 3], clock: Signal<In, Clock>, hold: DFF<Bits<12>> }
    #[hdl_gen]
    fn update(&mut self) {
        dff_setup!(self, clock, hold);
        self.y.next = bit_cast::<13, 12>(self.hold.q.val() + 1);
        for i in 0..3 {
            self.z13[i].next = bit_cast::<13, 12>(self.a.val() + self.b.val());
        }
    }
);

block!(Hand { y: O<32> }
    fn update(&mut self) {
        self.y.next = self.m.val() * self.n.val();
    }
    fn connect(&mut self) {
        self.y.connect();
    }
    fn hdl(&self) -> Verilog {
        Verilog::Custom("always @(*)\n  y = m * n;".into())
    }
);

block!(Outer { y: O<13>, inner: [Inner; 2], hand: Hand }
    #[hdl_gen]
    fn update(&mut self) {
        for i in 0..2 {
            self.inner[i].a.next = self.a.val();
        }
        self.hand.m.next = self.m.val();
        self.y.next = self.inner[1].y.val();
    }
);

fn outer() -> Outer {
    let mut outer = Outer::default();
    outer.connect_all();
    outer
}

#[test]
fn a_finding_names_block_rule_statement_and_cure() {
    let found = lint(&outer());
    assert_eq!(
        found[0].to_string(),
        "top$inner$0: CastOfExpression: y = bit_cast<13>(hold$q + 32'h1): expected a cast of a \
         signal, or of bits that the operator gets right; assign the operator's result to a Local \
         of its own width and cast that"
    );
}

#[test]
fn a_loop_reports_its_statement_once() {
    let found = lint(&outer());
    let statements: Vec<(&str, &str)> = found
        .iter()
        .map(|f| (f.path.as_str(), f.statement.as_str()))
        .collect();
    let sum = "y = bit_cast<13>(hold$q + 32'h1)";
    let looped = "z13[i] = bit_cast<13>(a + b)";
    let expected = [
        ("top$inner$0", sum),
        ("top$inner$0", looped),
        ("top$inner$1", sum),
        ("top$inner$1", looped),
    ];
    assert_eq!(statements, expected);
}

#[test]
fn opaque_text_is_listed_with_registers_told_apart() {
    let listed: Vec<(String, OpaqueKind)> = Design::of(&outer())
        .opaque()
        .into_iter()
        .map(|opaque| (opaque.path, opaque.kind))
        .collect();
    let expected = [
        ("top$inner$0$hold", OpaqueKind::Register),
        ("top$inner$1$hold", OpaqueKind::Register),
        ("top$hand", OpaqueKind::Custom),
    ];
    assert_eq!(listed, expected.map(|(path, kind)| (path.to_owned(), kind)));
}

#[test]
fn opaque_text_is_kept_for_an_allow_list() {
    let hand = Design::of(&outer()).opaque().pop().expect("hand is opaque");
    assert_eq!(hand.text, "always @(*) y = m * n;");
}

#[test]
fn a_missing_name_is_told() {
    let found = findings(Unknown::<3>::default());
    assert_eq!(found.len(), 1);
    assert_eq!(found[0].rule, Rule::UndeclaredConstant);
    assert_eq!(found[0].detail.as_deref(), Some("`K`"));
}

/// A const generic inside an expression.
#[derive(LogicBlock, Default)]
struct Unknown<const K: u64> {
    a: I<12>,
    y: O<12>,
}

impl<const K: u64> Logic for Unknown<K> {
    #[hdl_gen]
    fn update(&mut self) {
        self.y.next = self.a.val() + K;
    }
}
