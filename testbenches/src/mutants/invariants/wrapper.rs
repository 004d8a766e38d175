//! The wrapper module: it has the design's registers as inputs and assumes the invariants.

use super::{Invariants, Never, Relation, UNKNOWN, Values};

/// The conjunction of conditions, as a list. Yosys reads a list quickly, and takes minutes for a chain of ten
/// thousand `&&`, at each read.
fn all_of(conditions: &[String]) -> String {
    match conditions.is_empty() {
        // Without any condition, the conjunction is true.
        true => "1'd1".to_owned(),
        false => format!("(&{{\n    {}\n  }})", conditions.join(",\n    ")),
    }
}

impl Invariants {
    /// The number of a port in the wrapper.
    fn port_number(&self, name: &str) -> usize {
        self.ports.keys().position(|port| port == name).unwrap_or(0)
    }

    /// The module `wrapper` without its last lines, around the design: it has all ports and assumes the
    /// invariants.
    fn around_gold(&self) -> String {
        self.around("gold", |name, _| Some(name.to_owned()))
    }

    /// The module `wrapper` around the comparison of two designs, which Yosys calls `miter`. `more` are further
    /// conditions that it assumes.
    pub fn around_miter(&self, more: &[String]) -> String {
        let name = |name: &str, direction: &str| match direction {
            "input" => Some(format!("in_{name}")),
            _ => self
                .declared
                .contains_key(name)
                .then(|| format!("gold_{name}")),
        };
        let more: Vec<_> = more
            .iter()
            .map(|condition| format!("  always @* assume({condition});\n"))
            .collect();
        self.around("miter", name) + &more.concat() + "endmodule\n"
    }

    /// The conditions that a group stays valid until it is taken, as the machine's protocol has it: it is valid in
    /// each step that reads a group which an earlier step has read.
    pub fn group_stays(&self) -> Vec<String> {
        let Some(address) = self
            .place
            .first()
            .and_then(|&index| self.register(index, "q"))
        else {
            return Vec::new();
        };
        let (address, valid) = (address.0, self.port_number("group_valid"));
        let at = |step: &usize| format!("{address} != {step} || p{valid}");
        self.reads_again.iter().map(at).collect()
    }

    /// A wrapper around a module in which some of the design's ports have other names.
    fn around(&self, module: &str, renamed: impl Fn(&str, &str) -> Option<String>) -> String {
        let (mut declared, mut connected) = (Vec::new(), Vec::new());
        for (number, (name, port)) in self.ports.iter().enumerate() {
            let (direction, high) = (&port.direction, port.width() - 1);
            if let Some(name) = renamed(name, direction) {
                declared.push(format!("  {direction} [{high}:0] p{number}"));
                connected.push(format!("    .\\{name} (p{number})"));
            }
        }
        format!(
            "module wrapper(\n{}\n);\n  {module} inside(\n{}\n  );\n  wire known = {};\n  always @* assume(known);\n",
            declared.join(",\n"),
            connected.join(",\n"),
            all_of(&[self.holds(), self.declared_count()].concat()),
        )
    }

    /// The conditions that a query's sums have no bit above those that the most photons need.
    fn declared_count(&self) -> Vec<String> {
        let condition = |(name, needed): (&String, &u32)| {
            let bits = self.ports.get(name)?.width();
            let number = self.port_number(name);
            ((*needed as usize) < bits).then(|| format!("p{number}[{}:{needed}] == 0", bits - 1))
        };
        self.declared.iter().filter_map(condition).collect()
    }

    /// The invariants as conditions on the current registers.
    fn holds(&self) -> Vec<String> {
        let at = |(place, known): (&u64, &Vec<Values>)| {
            let mut terms: Vec<_> = self.is_at(*place, "q").into_iter().collect();
            let registers = known.iter().enumerate();
            terms.extend(registers.filter_map(|(i, values)| self.has(i, *values, "q")));
            all_of(&terms)
        };
        let cases: Vec<_> = self.known.iter().map(at).collect();
        let mut all = vec![format!("({})", cases.join(" || "))];
        all.extend(self.never.iter().filter_map(|never| {
            let never = self.is(never, "q")?;
            Some(format!("!({never})"))
        }));
        let relations = self.relations.iter();
        all.extend(relations.filter_map(|relation| Some(format!("({})", self.of(relation, "q")?))));
        all
    }

    /// A wrapper with the outputs `refuted`, a bit for each register, each [`Never`] and each [`Relation`]
    /// that does not hold after a clock, and `broken`, the OR of these bits.
    pub(super) fn refutation(&self) -> String {
        let all = 0..self.registers.len();
        let bits = all
            .clone()
            .map(|index| self.breaks(index, |values| self.has_bits(index, values, "d")));
        let largest =
            all.map(|index| self.breaks(index, |values| self.is_within(index, values, "d")));
        let never = self.never.iter().map(|never| self.is(never, "d"));
        let never = never.map(|never| never.unwrap_or_else(|| "1'd0".to_owned()));
        let relations = self.relations.iter().map(|relation| {
            let holds = self.of(relation, "d");
            holds.map_or("1'd0".to_owned(), |holds| format!("!({holds})"))
        });
        let bits = bits.chain(largest).chain(never).chain(relations);
        let mut bits: Vec<_> = bits.collect();
        let width = bits.len();
        bits.reverse();
        let places: Vec<_> = self
            .known
            .keys()
            .filter_map(|place| self.is_at(*place, "d"))
            .collect();
        let nowhere = match places.is_empty() {
            true => "1'd0".to_owned(),
            false => format!("!({})", places.join(" || ")),
        };
        let (place, place_bits) = match self.place("d") {
            (_, 0) => ("1'd0".to_owned(), 1),
            place => place,
        };
        format!(
            "{}  (* keep *) wire [{place_bits}-1:0] place = {place};\n  (* keep *) wire [{width}-1:0] refuted = {{\n    {}\n  }};\n  (* keep *) wire broken = (|refuted) | {nowhere};\nendmodule\n",
            self.around_gold(),
            bits.join(",\n    ")
        )
    }

    /// The condition that an invariant of a register does not hold after a clock, at the place of the program
    /// then.
    fn breaks(&self, index: usize, holds: impl Fn(Values) -> Option<String>) -> String {
        let at = |(place, known): (&u64, &Vec<Values>)| {
            let holds = holds(known[index])?;
            Some(match self.is_at(*place, "d") {
                Some(is_at) => format!("({is_at} && !({holds}))"),
                None => format!("!({holds})"),
            })
        };
        let cases: Vec<_> = self.known.iter().filter_map(at).collect();
        match cases.is_empty() {
            true => "1'd0".to_owned(),
            false => format!("({})", cases.join(" || ")),
        }
    }

    /// The condition that the program is at a place; `None` for a machine without a program.
    fn is_at(&self, place: u64, when: &str) -> Option<String> {
        let (name, bits) = self.place(when);
        (bits > 0).then(|| format!("{name} == {bits}'d{place}"))
    }

    /// The place of the program as an expression, with its width.
    fn place(&self, when: &str) -> (String, u32) {
        let registers = self.place.iter();
        let registers = registers.filter_map(|&index| self.register(index, when));
        let (names, bits): (Vec<_>, Vec<_>) = registers.unzip();
        (format!("{{{}}}", names.join(", ")), bits.iter().sum())
    }

    /// The condition that a register has one of its values; `None` if all values are possible.
    fn has(&self, index: usize, values: Values, when: &str) -> Option<String> {
        let bits = self.has_bits(index, values, when);
        let largest = self.is_within(index, values, when);
        let terms: Vec<_> = bits.into_iter().chain(largest).collect();
        (!terms.is_empty()).then(|| terms.join(" && "))
    }

    /// The condition that the constant bits of a register have their values.
    fn has_bits(&self, index: usize, values: Values, when: &str) -> Option<String> {
        let (port, bits) = self.register(index, when)?;
        let never = !values.any & (u64::MAX >> (u64::BITS - bits));
        let mut terms = Vec::new();
        if never != 0 {
            terms.push(format!("({port} & {bits}'d{never}) == 0"));
        }
        if values.all != 0 {
            terms.push(format!("(~{port} & {bits}'d{}) == 0", values.all));
        }
        (!terms.is_empty()).then(|| terms.join(" && "))
    }

    /// The condition that a register is at most its largest value; `None` where its bits imply that.
    fn is_within(&self, index: usize, values: Values, when: &str) -> Option<String> {
        let (port, bits) = self.register(index, when)?;
        let as_bits = values.largest.wrapping_add(1).is_power_of_two();
        (values.largest < UNKNOWN.largest && !as_bits)
            .then(|| format!("{port} <= {bits}'d{}", values.largest))
    }

    /// The condition that flags have the combination of values that never occurs.
    fn is(&self, never: &Never, when: &str) -> Option<String> {
        let literal = |&(register, value): &(usize, u64)| {
            let (port, bits) = self.register(register, when)?;
            Some(format!("{port} == {bits}'d{value}"))
        };
        let literals: Option<Vec<_>> = never.0.iter().map(literal).collect();
        Some(literals?.join(" && "))
    }

    /// A relation between registers, as a condition.
    pub(super) fn of(&self, relation: &Relation, when: &str) -> Option<String> {
        relation.with(|name| {
            let observed = self.names.iter().position(|register| register == name);
            let port = match observed {
                Some(index) => self.register(index, when),
                None => self.port(&Relation::unobserved(name)?, when),
            };
            Some(port?.0)
        })
    }

    /// The wrapper's name of a register, with its width.
    pub(super) fn register(&self, index: usize, when: &str) -> Option<(String, u32)> {
        self.port(&self.registers[index], when)
    }

    /// The wrapper's name of the register with a path, with its width.
    fn port(&self, path: &str, when: &str) -> Option<(String, u32)> {
        let name = format!("{path}.{when}");
        let port = self.ports.get(&name)?;
        let bits = u32::try_from(port.width()).ok()?;
        Some((format!("p{}", self.port_number(&name)), bits))
    }
}
