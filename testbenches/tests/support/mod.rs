//! Trials that need a tool. Where the tool is missing, a trial is listed as ignored with the install command;
//! with `REQUIRE_EDA=1` it fails instead.

use libtest_mimic::{Failed, Trial};
use photoncube_testbench::DeviceKind;

/// A trial in a device.
pub fn trial(
    name: String,
    kind: DeviceKind,
    run: impl FnOnce() -> Result<(), Failed> + Send + 'static,
) -> Trial {
    let Some(missing) = kind.missing_tool() else {
        return Trial::test(name, run);
    };
    let required = std::env::var("REQUIRE_EDA").is_ok_and(|value| value == "1");
    let message = missing.to_string();
    let fail = move || Err(Failed::from(message));
    if required {
        return Trial::test(name, fail);
    }
    Trial::test(format!("{name} ({})", missing.install()), fail).with_ignored_flag(true)
}
