//! Tests the hard cases: every row holds and is hard, and the runner fails a case that shows nothing.

use photoncube_hard_cases::{
    Bound, Grid, HARD_CASES, HardCase, HardCaseError, HardCaseReport, Outcome, hard_case_formats,
    run_hard_case,
};
use photoncube_render::{
    Engine, PhotonMap, RenderError, Scene, TraceOptions, ViewOptions, render, trace,
};
use photoncube_spec::{Channels, MACHINES, PHOTON_FORMATS, PhotonFormat, Rounding};

const DEFAULT: &PhotonFormat = &PHOTON_FORMATS[0];

#[test]
fn every_hard_case_holds_and_is_hard() {
    let formats = hard_case_formats();
    let mut failed = Vec::new();
    for case in HARD_CASES {
        let report = run_hard_case(case, &formats).expect("every case is about some format");
        println!(
            "{}: {} {} in {}, contrast {}, {} looked at in {} formats",
            report.case,
            report.result,
            report.bound,
            report.worst_format,
            report.contrast,
            report.looked_at,
            report.formats_run
        );
        if !(report.holds && report.is_hard) {
            failed.push(report);
        }
    }
    assert!(failed.is_empty(), "{failed:#?}");
}

#[test]
fn the_formats_are_all_that_are_named_and_one_each_of_mono_and_dithered() {
    let formats = hard_case_formats();
    let machines = MACHINES.iter().filter_map(|machine| machine.format());
    for format in PHOTON_FORMATS.iter().chain(machines) {
        assert!(formats.contains(format), "{format}");
    }
    let mono = |f: &PhotonFormat| f.power.channels == Channels::Mono;
    let dithered = |f: &PhotonFormat| f.power.rounding == Rounding::Dithered;
    assert!(formats.iter().any(mono) && formats.iter().any(dithered));
}

#[test]
fn every_row_says_what_and_why_under_a_name_of_its_own() {
    for (index, case) in HARD_CASES.iter().enumerate() {
        let names = HARD_CASES[..index].iter().map(|other| other.name);
        assert!(
            !names.clone().any(|name| name == case.name),
            "{}",
            case.name
        );
        let texts = [case.breaks, case.result, case.why, case.contrast.what];
        assert!(texts.iter().all(|text| !text.is_empty()), "{}", case.name);
        assert!(case.contrast.at_least > 0.0, "{}", case.name);
    }
}

/// The runner's row for an outcome.
fn row(measure: fn(&PhotonFormat) -> Result<Outcome, HardCaseError>) -> HardCaseReport {
    let case = HardCase {
        bound: Bound::Zero,
        measure,
        ..HARD_CASES[0]
    };
    run_hard_case(&case, &[*DEFAULT]).unwrap()
}

#[test]
fn a_case_that_looks_at_nothing_fails() {
    let report = row(|_| {
        Ok(Outcome {
            looked_at: 0,
            result: 0.0,
            contrast: 100.0,
        })
    });
    assert!(!report.holds);
    assert!(report.refusal.unwrap().contains("looked at nothing"));
}

#[test]
fn a_case_past_its_bound_or_without_a_number_fails() {
    let past = row(|_| {
        Ok(Outcome {
            looked_at: 1,
            result: 1.0,
            contrast: 100.0,
        })
    });
    let no_number = row(|_| {
        Ok(Outcome {
            looked_at: 1,
            result: f64::NAN,
            contrast: f64::NAN,
        })
    });
    assert!(!past.holds && past.is_hard);
    assert!(!no_number.holds && !no_number.is_hard);
}

#[test]
fn a_case_that_the_naive_arithmetic_passes_is_not_hard() {
    let report = row(|_| {
        Ok(Outcome {
            looked_at: 1,
            result: 0.0,
            contrast: 0.0,
        })
    });
    assert!(report.holds && !report.is_hard);
}

/// Ties in the words of every machine are decided correctly; the counts follow from the placement of the
/// photons.
#[test]
fn the_boundary_is_decided_right_by_the_golden_model_of_every_machine() {
    let case = HARD_CASES
        .iter()
        .find(|c| c.name == "boundary-ties-f32")
        .unwrap();
    for machine in MACHINES {
        let mut in_range = 0;
        for setting in (case.settings)(&Grid::of_machine(machine)).unwrap() {
            let workload = setting.workload(machine).unwrap();
            for ((query, photons), count) in workload.iter().zip(&setting.counts) {
                let given = photons.iter().copied();
                let sums = photoncube_model::gather(machine, query, given).unwrap();
                assert_eq!(sums.count, *count, "{}", machine.name);
                in_range += count;
            }
        }
        assert!(in_range > 100, "{}: {in_range}", machine.name);
    }
}

#[test]
fn a_query_of_too_many_photons_is_refused_with_the_pixel() {
    let scene = Scene::built_in("cornell").unwrap();
    let options = TraceOptions {
        photons: 20_000,
        seed: 9,
    };
    let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
    let map = PhotonMap::new(&scene, photons, 0.15).unwrap();
    let view = ViewOptions {
        width: 8,
        height: 8,
        samples_per_axis: 1,
        seed: 9,
    };
    let small = PhotonFormat {
        max_photons: 3,
        ..*DEFAULT
    };
    let error = render(&scene, &map, Engine::from(&small), &view, &|_| ()).unwrap_err();
    let RenderError::Gather { source, .. } = &error else {
        panic!("{error:?}");
    };
    assert!(error.to_string().starts_with("pixel ("), "{error}");
    let cause = source.to_string();
    assert!(
        cause.contains("over the 3 that format `local8-rgb8e5-n3` declares"),
        "{cause}"
    );
    let illegal = PhotonFormat {
        position_bits: 13,
        ..*DEFAULT
    };
    let error = render(&scene, &map, Engine::from(&illegal), &view, &|_| ()).unwrap_err();
    assert!(
        error
            .to_string()
            .contains("position_bits is 13, expected 4 to 12")
    );
}
