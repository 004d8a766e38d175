//! The properties of spatial machines: those of each unit that the machine has, of its sums, its streams and its photon
//! memory.

use photoncube_spec::{Machine, Widths};

use super::property::{Fault, Method, Property, at, covers, of_logic};
use super::{memory, streams};

/// All properties, the cheapest first. `has_module` returns whether the emitted text has a module.
pub(super) fn properties(machine: &Machine, has_module: &dyn Fn(&str) -> bool) -> Vec<Property> {
    let spatial = machine.spatial().expect("it is spatial");
    let widths = Widths::of(machine);
    let full_scale = machine.full_scale();
    let units = UNITS.iter().filter(|unit| has_module(unit.module));
    let mut properties: Vec<_> = units.map(|unit| unit.property(machine)).collect();
    properties.extend([
        sum(
            "sums::power",
            "accumulate",
            machine,
            [widths.group_power(), widths.sum],
            full_scale,
        ),
        sum(
            "sums::count",
            "accumulate_2",
            machine,
            [Widths::GROUP_COUNT, widths.count],
            1,
        ),
    ]);
    properties.extend(streams::properties(spatial, &widths));
    properties.extend(memory::properties(machine, spatial, &widths));
    properties
}

/// A unit without registers: its formula and its ports. The last ports are the outputs, named `result` and
/// `second`.
pub(super) struct Unit {
    pub name: &'static str,
    pub module: &'static str,
    pub claim: &'static str,
    pub inputs: &'static [(&'static str, Width)],
    pub output: (&'static str, Width),
    pub second: Option<&'static str>,
    pub claims: &'static str,
    pub covers: [&'static str; 2],
    pub fault: (&'static str, &'static str),
}

pub(super) type Width = fn(&Widths) -> u32;

pub(super) const BIT: Width = |_| 1;

/// The units with their formulas in Verilog for the output `result`. Wider words are written so that nothing
/// wraps. `LOW` is the number of bits of a magnitude's low digit; `LIMIT` is the largest sum of squares in
/// range where queries have no radius of their own; `LINE` is the grid line of a photon `b`.
const UNITS: &[Unit] = &[
    Unit {
        name: "units::subtract",
        module: "subtract",
        claim: "difference = a - b in two's complement",
        inputs: &[("a", |w| w.coordinate), ("b", |w| w.coordinate)],
        output: ("difference", |w| w.signed_difference()),
        second: None,
        claims: "assert (result[`OUT-1] == (a < b)); assert (result[`OUT-2:0] + b == {1'b0, a} + {result[`OUT-1], {`OUT-1{1'b0}}});",
        covers: ["a < b", "a > b"],
        fault: ("wide_a - wide_b", "wide_a + wide_b"),
    },
    Unit {
        name: "units::subtract_line",
        module: "subtract_line",
        claim: "difference = a - line in two's complement, with the line in the middle of the cell b",
        inputs: &[("a", |w| w.coordinate), ("b", |w| w.photon)],
        output: ("difference", |w| w.signed_difference()),
        second: None,
        claims: "assert (result[`OUT-1] == (a < `LINE)); assert (result[`OUT-2:0] + `LINE == {1'b0, a} + {result[`OUT-1], {`OUT-1{1'b0}}});",
        covers: ["a < `LINE", "a > `LINE"],
        fault: ("wide_a - line", "wide_a + line"),
    },
    Unit {
        name: "units::magnitude",
        module: "magnitude_of",
        claim: "magnitude = |difference|; assumed: not below the smallest difference of two coordinates",
        inputs: &[("difference", |w| w.signed_difference())],
        output: ("magnitude", |w| w.coordinate),
        second: None,
        claims: "assume (difference != {1'b1, {`OUT{1'b0}}}); \
                 assert (difference[`OUT] ? {1'b0, result} + difference == {1'b1, {`OUT+1{1'b0}}} : {1'b0, result} == difference);",
        covers: ["difference[`OUT]", "~difference[`OUT] & result != 0"],
        fault: ("inverted + ", "inverted - "),
    },
    Unit {
        name: "units::split",
        module: "split_magnitude",
        claim: "counted = magnitude modulo 2^radius; far = the rest is not 0",
        inputs: &[("magnitude", |w| w.coordinate)],
        output: ("counted", |w| w.difference),
        second: Some("far"),
        claims: "assert (second == (magnitude >= (1 << `OUT))); assert (second || result == magnitude);",
        covers: ["second", "~second & result != 0"],
        fault: ("far = |", "far = &"),
    },
    Unit {
        name: "units::digit_products",
        module: "digit_products",
        claim: "low_product + 4 high_product = the product of the two digits",
        inputs: &[("magnitude", |w| w.difference)],
        output: ("low_product", |w| w.low_product()),
        second: Some("high_product"),
        claims: "assert (result + 4 * second == magnitude[`LOW+:4] * magnitude[`LOW-1:0]);",
        covers: ["second != 0", "result != 0"],
        fault: ("{4{magnitude[1]}}", "{4{magnitude[0]}}"),
    },
    Unit {
        name: "units::cross_sum",
        module: "cross_sum",
        claim: "cross_product = low_product + 4 high_product, modulo its width",
        inputs: &[
            ("low_product", |w| w.low_product()),
            ("high_product", |w| w.high_product()),
        ],
        output: ("cross_product", |w| w.cross()),
        second: None,
        claims: "assert (result == (low_product + 4 * high_product) % (1 << `OUT));",
        covers: ["high_product != 0", "low_product != 0"],
        fault: (
            "low_product[5:2] + high_product",
            "low_product[5:2] | high_product",
        ),
    },
    Unit {
        name: "units::square_sum",
        module: "square_sum",
        claim: "square = magnitude * magnitude, for every magnitude; assumed: the product of its digits is given",
        inputs: &[
            ("magnitude", |w| w.difference),
            ("cross_product", |w| w.cross()),
        ],
        output: ("square", |w| w.square),
        second: None,
        claims: "assume (cross_product == magnitude[`LOW+:4] * magnitude[`LOW-1:0]); assert (result == 1 * magnitude * magnitude);",
        covers: ["magnitude == (1 << `OUT/2) - 1", "magnitude == 16"],
        fault: ("high_square = 8'd4;", "high_square = 8'd5;"),
    },
    Unit {
        name: "units::pair_sum",
        module: "pair_sum",
        claim: "sum = a + b, exactly",
        inputs: &[("a", |w| w.square), ("b", |w| w.square)],
        output: ("sum", |w| w.pair()),
        second: None,
        claims: "assert ({1'b0, result} - b == a);",
        covers: ["result[`OUT-1]", "result == 0"],
        fault: ("wide_a + wide_b", "wide_a | wide_b"),
    },
    Unit {
        name: "units::distance_sum",
        module: "distance_sum",
        claim: "sum = a + b, exactly",
        inputs: &[("a", |w| w.pair()), ("b", |w| w.square)],
        output: ("sum", |w| w.distance),
        second: None,
        claims: "assert ({1'b0, result} - b == a);",
        covers: ["result[`OUT-1]", "result == 0"],
        fault: ("wide_a + wide_b", "wide_a | wide_b"),
    },
    Unit {
        name: "units::range",
        module: "range_of_query",
        claim: "in_range = distance <= radius_sq and no axis is far",
        inputs: &[
            ("distance", |w| w.distance),
            ("far", BIT),
            ("largest", |w| w.radius_sq),
        ],
        output: ("in_range", BIT),
        second: None,
        claims: "if (far || distance > largest) assert (!result); else assert (result);",
        covers: ["distance == largest & result", "far & distance < largest"],
        fault: ("distance <= limit", "distance < limit"),
    },
    Unit {
        name: "units::range",
        module: "range_of_format",
        claim: "in_range = distance <= the format's radius_sq and no axis is far",
        inputs: &[("distance", |w| w.distance), ("far", BIT)],
        output: ("in_range", BIT),
        second: None,
        claims: "if (far || distance > `LIMIT) assert (!result); else assert (result);",
        covers: ["distance == `LIMIT & result", "far & distance < `LIMIT"],
        fault: ("distance <= limit", "distance < limit"),
    },
    Unit {
        name: "units::any_far",
        module: "any_far",
        claim: "any = x or y or z",
        inputs: &[("x", BIT), ("y", BIT), ("z", BIT)],
        output: ("any", BIT),
        second: None,
        claims: "assert (result == ({x, y, z} != 0));",
        covers: ["result", "~result"],
        fault: ("x | y | z", "x | y & z"),
    },
    Unit {
        name: "units::gated_sum",
        module: "gated_sum",
        claim: "sum = the powers of those in range, exactly",
        inputs: &[
            ("a", |w| w.power),
            ("b", |w| w.power),
            ("a_in_range", BIT),
            ("b_in_range", BIT),
        ],
        output: ("sum", |w| w.pair_power()),
        second: None,
        claims: "assert ({1'b0, result} - (a_in_range ? a : 0) == (b_in_range ? b : 0));",
        covers: ["result[`OUT-1]", "a != 0 & b != 0 & result == 0"],
        fault: ("gated_a + gated_b", "gated_a | gated_b"),
    },
    Unit {
        name: "units::gated_count",
        module: "gated_sum_2",
        claim: "sum = how many are there and in range",
        inputs: &[
            ("a", BIT),
            ("b", BIT),
            ("a_in_range", BIT),
            ("b_in_range", BIT),
        ],
        output: ("sum", |_| Widths::PAIR_COUNT),
        second: None,
        claims: "if (a & a_in_range & b & b_in_range) assert (result == 2); \
                 else if ((a & a_in_range) | (b & b_in_range)) assert (result == 1); else assert (result == 0);",
        covers: ["result == 2", "result == 0 & a & b"],
        fault: ("gated_a + gated_b", "gated_a | gated_b"),
    },
    Unit {
        name: "units::group_sum",
        module: "group_sum",
        claim: "sum = a + b, exactly",
        inputs: &[("a", |w| w.pair_power()), ("b", |w| w.pair_power())],
        output: ("sum", |w| w.group_power()),
        second: None,
        claims: "assert ({1'b0, result} - b == a);",
        covers: ["result[`OUT-1]", "result == 0"],
        fault: ("wide_a + wide_b", "wide_a | wide_b"),
    },
    Unit {
        name: "units::group_count",
        module: "group_sum_2",
        claim: "sum = a + b, exactly",
        inputs: &[("a", |_| Widths::PAIR_COUNT), ("b", |_| Widths::PAIR_COUNT)],
        output: ("sum", |_| Widths::GROUP_COUNT),
        second: None,
        claims: "assert ({1'b0, result} - b == a);",
        covers: ["result[`OUT-1]", "result == 0"],
        fault: ("wide_a + wide_b", "wide_a | wide_b"),
    },
    Unit {
        name: "units::power_of_present",
        module: "power_of_present",
        claim: "power = absent ? 0 : word",
        inputs: &[("absent", BIT), ("word", |w| w.power)],
        output: ("power", |w| w.power),
        second: None,
        claims: "if (absent) assert (result == 0); else assert (result == word);",
        covers: ["absent & word != 0", "result != 0"],
        fault: ("if (absent)", "if (~absent)"),
    },
];

/// The modules that the table of units has.
#[cfg(test)]
pub(super) fn unit_modules() -> impl Iterator<Item = &'static str> {
    UNITS.iter().map(|unit| unit.module)
}

/// The grid line in the middle of a photon's cell; without extra bits, the cell.
pub(super) fn line(extra_bits: u32) -> String {
    match extra_bits {
        0 => "b".to_owned(),
        bits => format!("{{b, {bits}'d{}}}", 1 << (bits - 1)),
    }
}

impl Unit {
    pub fn property(&self, machine: &Machine) -> Property {
        let widths = &Widths::of(machine);
        let format = machine.format();
        let format = format.expect("a spatial machine has a photon format");
        let (output, width) = self.output;
        let input =
            |(name, width): &(&str, Width)| format!("input wire [{}-1:0] {name}, ", width(widths));
        let port = |(name, _): &(&str, Width)| format!(".{name}({name}), ");
        let second = self
            .second
            .map_or(String::new(), |name| format!(", .{name}(second)"));
        let second_width = match self.second {
            Some("high_product") => widths.high_product(),
            _ => 1,
        };
        let declared = self.second.map_or(String::new(), |_| {
            format!("wire [{second_width}-1:0] second;")
        });
        let ports: String = self.inputs.iter().map(port).collect();
        Property {
            macros: vec![
                ("OUT", width(widths).to_string()),
                ("LOW", widths.low_digit().to_string()),
                ("LINE", line(format.query_extra_bits)),
                ("LIMIT", format.largest_in_range().to_string()),
                ("INPUTS", self.inputs.iter().map(input).collect()),
                ("SECOND", declared),
                ("PORTS", format!("{ports}.{output}(result){second}")),
                ("CLAIMS", self.claims.to_owned()),
                ("COVER_ONE", self.covers[0].to_owned()),
                ("COVER_TWO", self.covers[1].to_owned()),
            ],
            faults: vec![Fault::new(self.module, self.fault.0, self.fault.1)],
            covers: covers(["cover_one", "cover_two"]),
            ..of_logic(
                self.name,
                self.module,
                self.claim,
                include_str!("harness/unit_stream.sv"),
                &[],
            )
        }
    }
}

/// The property of a query's sum, to which each photon adds at most `each`.
fn sum(
    name: &'static str,
    module: &'static str,
    machine: &Machine,
    [group, sum]: [u32; 2],
    each: u128,
) -> Property {
    let photons = machine.photons_per_iteration() as u128;
    let count = |photons: u128| format!("photons_full_scale == {}", photons * each);
    let counts: Vec<_> = (0..=photons).map(count).collect();
    let largest = u128::from(machine.max_photons()) * each;
    Property {
        macros: vec![
            ("GROUP", group.to_string()),
            ("SUM", sum.to_string()),
            ("LARGEST", format!("{}'d{largest}", sum + 1)),
            ("ONE_OF_THE_COUNTS", counts.join(" || ")),
            ("COVERED", (3 * photons * each).to_string()),
        ],
        method: Method::Induction(1),
        faults: vec![Fault::new(module, "kept + wide_group", "kept ^ wide_group")],
        fault_clocks: 5,
        covers: at([("cover_sums", 4)]),
        ..of_logic(
            name,
            module,
            "the sum is exact for the declared photons of a query at full scale; assumed: no more are given, and a \
             group's sum is no more than its photons'",
            include_str!("harness/accumulate.sv"),
            &[],
        )
    }
}
