//! Plants faults in emitted Verilog.

/// Replaces a text that occurs once in the module with that heading.
pub fn edit(text: &str, module: &str, from: &str, to: &str) -> String {
    assert_eq!(text.matches(module).count(), 1, "{module}");
    let (before, rest) = text.split_at(text.find(module).expect("counted"));
    let end = rest.find("endmodule").expect("a module ends");
    let (body, after) = rest.split_at(end);
    assert_eq!(body.matches(from).count(), 1, "`{from}` in {module}");
    format!("{before}{}{after}", body.replace(from, to))
}
