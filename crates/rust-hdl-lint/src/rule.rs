//! The rules of the lint, one row each.

/// Declares [`Rule`] and the functions that read its table.
macro_rules! rules {
    ($($(#[$doc:meta])+ $rule:ident: $expected:literal; $advice:literal;)+) => {
        /// A kind of difference between the Rust simulation and the emitted Verilog.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
        pub enum Rule {
            $($(#[$doc])+ $rule,)+
        }

        impl Rule {
            /// All rules, in the order of the table.
            pub const ALL: &'static [Rule] = &[$(Rule::$rule),+];

            /// The rule's name in reports.
            pub fn name(self) -> &'static str {
                match self { $(Rule::$rule => stringify!($rule),)+ }
            }

            /// The form that the lint expects.
            pub fn expected(self) -> &'static str {
                match self { $(Rule::$rule => $expected,)+ }
            }

            /// A suggestion of the code to write instead.
            pub fn advice(self) -> &'static str {
                match self { $(Rule::$rule => $advice,)+ }
            }
        }
    };
}

rules! {
    /// `bit_cast::<13, 12>(a + b)` prints `((a + b) & 13'h1fff)`: the operands widen to 13 bits
    /// first (1364-2001 5.4.1), so the carry, the borrow or the ones of `!` reach the new bits.
    CastOfExpression:
        "a cast of a signal, or of bits that the operator gets right";
        "assign the operator's result to a Local of its own width and cast that";

    /// `a + 1 == b` is printed unchanged. The literal is 32 bits wide, and so is the sum (5.4.1), which
    /// therefore does not wrap as `Bits` does.
    CompareOfExpression:
        "a comparison or a logical operator between signals, Constants and literals";
        "assign the expression to a Local of its own width and compare that";

    /// `a & b == c` is `(a & b) == c` in Rust and `a & (b == c)` in Verilog (5.1.2, table 5-4).
    BitwiseBesideCompare:
        "`& | ^` beside a comparison in parentheses";
        "write the parentheses, or assign the bitwise part to a Local first";

    /// `s < 5.into()` prints `s < 32'h5`, and one unsigned operand makes the whole expression
    /// unsigned (5.5.1). A part-select is always unsigned, also that of a signed signal, and
    /// `$unsigned` extends with zeros.
    SignedAgainstUnsigned:
        "operands that are signed in Verilog too";
        "use a Signed Constant or Local, or offset-binary unsigned values";

    /// `(a + b) * c` evaluates the sum at the width of the product, 32 bits (5.4.1), so it does
    /// not wrap.
    FactorExpression:
        "factors that are signals, casts of signals or slices of signals";
        "assign each factor to a Local of its own width first";

    /// `signed_bit_cast::<34, 32>(a * b)` prints `$signed(a * b)`, whose argument is
    /// self-determined: 16 bits (5.5, table 5-22). The high half is lost.
    CastOfProduct:
        "`*` alone on the right-hand side";
        "assign the product to a 32-bit Local and cast that";

    /// `a * b == c * d` or `bit_cast((a * b) >> 16)` evaluates the product at the width of its
    /// context, which may be 16 bits (5.4.1). The high half is lost.
    ProductInContext:
        "`*` alone on the right-hand side";
        "assign the product to a 32-bit Local and use that";

    /// `signed_bit_cast::<8, 16>(a) < b` prints `$signed(a) < b`: the narrowing is not printed,
    /// nor does the tree hold the new width.
    NarrowingSignedCast:
        "a signed cast that is not narrower than its signal, beside a signal of known width";
        "assign the cast to a Signed Local of the new width first";

    /// `(a + 1) >> 1` shifts the sum at the width of its context, so the carry comes back; a
    /// count that is an expression is evaluated at a width of its own (table 5-22).
    ShiftOfExpression:
        "a shift of a signal by a signal or a literal";
        "assign the shifted value and the count to Locals first";

    /// `bit_cast::<8, 12>(a).all()` prints `&((a) & 8'hff)`: the operand keeps its 12 bits, so
    /// the answer is always 0. `(a + 1).any()` sees the carry.
    ReductionOfExpression:
        "a reduction of a signal or of a slice of a signal";
        "assign the value to a Local of its own width and reduce that";

    /// `get_bits::<5>(9)` of 12 bits reads X beyond the word, where Rust reads 0 (4.2.1). A
    /// one-bit signal is a scalar, which has no bits to select.
    SliceOutOfRange:
        "a slice that lies within the word for every value of its index";
        "widen the word or narrow the index; read a one-bit signal whole";

    /// `(a + b).get_bits::<4>(2)` prints `(a + b)[2+:4]`, which is not Verilog: only a name can
    /// be selected from (4.2.1).
    SliceOfExpression:
        "a slice of a signal";
        "assign the expression to a Local and slice that";

    /// `x.get_bits::<6>(3).get_bit(2)` prints `x[3+:6][2]`, which is not Verilog-2001.
    SliceOfSlice:
        "one slice";
        "add the two offsets up, or assign the outer slice to a Local";

    /// An index of a bit or a slice that is an expression. Verilog evaluates it at its own width.
    IndexExpression:
        "an index that is a literal, loop-variable arithmetic or a signal";
        "assign the index to a Local first";

    /// A literal that does not fit. It is truncated in an assignment and never equal in a comparison; the
    /// Rust conversion panics.
    LiteralTooWide:
        "a literal that fits the width beside it";
        "correct the literal or the width";

    /// Two sides of an assignment or of an operator with different widths. Rust forces one width; in a
    /// hand-written tree Verilog silently truncates or extends (9.2).
    WidthMismatch:
        "a target and operands of one width";
        "cast with bit_cast, or correct the hand-written hdl()";

    /// More than one operator in a statement. The widths show that this statement agrees, but its next change
    /// may not; the project writes three-address code.
    SeveralOperators:
        "one operator for each assignment";
        "assign the inner operators to Locals of their own width";

    /// A block that reads no input and no child: `always @(*) y = 7;` waits for an event that
    /// never comes (9.7.5), and Icarus leaves the outputs at X.
    ConstantOnlyBlock:
        "a block that reads at least one input or one output of a child";
        "read the Constant where it is needed instead of passing it through a port";

    /// A memory word that is never written is 0 in Rust and X in Verilog.
    UninitialisedMemory:
        "an initial value for every word of the memory";
        "initialise each word (a loop in an initial block, or $readmemh)";

    /// `self.a[i ^ 1]`: the printer's own evaluator reads `^` as a power and handles only numbers and loop
    /// variables; it panics on other operators.
    IndexOperator:
        "an array index of loop variables, numbers and `+ - * / % ( )`";
        "write the index with arithmetic: `i + 1 - 2 * (i % 2)` for `i ^ 1`";

    /// `self.a[i][j]` or `self.c[i].n[j]`: only the first index is resolved, and the second is
    /// printed as a bit select.
    NestedArrayPath:
        "one index in a path";
        "flatten the array, or write the network block's hdl() by hand";

    /// `x + K` with a `const` or a const generic prints the bare identifier, which no module
    /// declares.
    UndeclaredConstant:
        "every name declared by the block, by a child's port or by an enum";
        "hold the value in a Constant field";

    /// A hand-written `hdl()` that names a signal the block does not have (any more). Verilog may
    /// take it for a new one-bit wire (3.5).
    StaleName:
        "every name declared by the block, by a child's port or by an enum";
        "correct the name, or write hdl() from the same source as update()";

    /// A loop variable named like a field: the printer puts the loop's number in place of
    /// `self.i`.
    ShadowedName:
        "a loop variable that is not the name of a field";
        "rename the loop variable or the field";

    /// A field named `begin`, `cell`, `table` ... becomes an identifier that is a keyword of
    /// Verilog, or of SystemVerilog, which Verilator reads by default.
    KeywordName:
        "field names that are identifiers of Verilog and of SystemVerilog";
        "rename the field";

    /// A pattern is printed as Rust writes it: `0x1F`, `1_000`, `true` and a binding have other meanings in
    /// Verilog.
    CasePattern:
        "patterns that are decimal or sized numbers, variants of an enum or `_`";
        "write the number in decimal; use if for bool";

    /// A block that drives signals in `update()` but has no `hdl()`: an empty module.
    MissingHdl:
        "an hdl() for every block that drives a signal";
        "put #[hdl_gen] on update(), or write hdl() by hand";

    /// Two instances of one `Verilog::Wrapper` or `Blackbox` declare its module twice.
    RepeatedCore:
        "the core's text once in a design";
        "leave `cores` empty and append the text once, or use Verilog::Custom";
}
