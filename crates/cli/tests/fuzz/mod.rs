//! Tests the method `fuzz`: the readers of what people give, on inputs that are nearly right.

use super::{json, photoncube};

#[test]
fn readers_read_or_refuse_wrong_inputs() {
    const INPUTS: u64 = 1_000;
    let report = json(&["verify", "fuzz", "1000"]);
    assert_eq!(report["controls"][0]["control_found"], true);
    assert_eq!(report["findings"], serde_json::json!([]));
    let readers = report["readers"].as_array().unwrap();
    assert_eq!(readers.len(), 8);
    for reader in readers {
        let count = |key: &str| reader[key].as_u64().unwrap();
        assert_eq!(count("inputs"), INPUTS, "{reader}");
        assert_eq!(
            count("inputs_read") + count("inputs_refused"),
            INPUTS,
            "{reader}"
        );
        // If all inputs were correct, or all far from correct, the test would show little.
        assert!(count("inputs_read") > INPUTS / 100, "{reader}");
        assert!(count("inputs_refused") > INPUTS / 100, "{reader}");
        assert_eq!(reader["failures"], serde_json::json!([]));
    }
}

#[test]
fn an_input_is_had_again_by_its_number() {
    let one = ["verify", "fuzz", "1", "--reader", "listing", "--from", "7"];
    let said = |args: &[&str]| {
        let output = photoncube(args).assert().success();
        String::from_utf8(output.get_output().stderr.clone()).unwrap()
    };
    let first = said(&one);
    assert!(first.starts_with("listing: input 7: Text(\""), "{first}");
    assert_eq!(first, said(&one));
    assert_ne!(first, said(&[&one[..], &["--seed", "2"]].concat()));
}
