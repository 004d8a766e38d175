//! Tests `fit` on the built-in scenes: its predictions agree with the measurements, and its result is
//! minimal. For speed it uses fewer photons, maps and queries than the command.

use photoncube_render::{
    BenchOptions, Fit, FitOptions, Scene, SceneFacts, Trial, ViewOptions, fit,
};
use photoncube_spec::{Channels, Exponent};

fn options() -> FitOptions {
    let options = FitOptions::default();
    FitOptions {
        bench: BenchOptions {
            photons: 50_000,
            maps: 8,
            view: ViewOptions {
                width: 40,
                height: 40,
                ..options.bench.view
            },
            ..options.bench
        },
        ..options
    }
}

fn fitted(scene: &str) -> (Fit, Trial) {
    let scene = Scene::built_in(scene).unwrap();
    let fit = fit(&scene, &options(), &|_| ()).unwrap();
    let chosen = fit
        .chosen
        .clone()
        .expect("a tenth of the noise is possible");
    println!("{chosen:#?}");
    (fit, chosen)
}

/// The chosen format is below the bound, every format with a bit less above it, and all predictions
/// of formats that could hold the scene's colours within 30 % of what was measured.
fn assert_smallest(fit: &Fit, chosen: &Trial) {
    let bound = options().noise_ratio;
    assert!(chosen.holds && chosen.measured.error_over_noise <= bound);
    assert!(!fit.removals.is_empty());
    for removal in &fit.removals {
        let measured = removal.trial.measured.error_over_noise;
        println!("{}: {} {measured:.4}", removal.less, removal.trial.format);
        assert!(measured > bound && !removal.trial.holds);
    }
    let trials = fit.removals.iter().map(|removal| &removal.trial);
    for trial in trials.chain(&fit.broken).chain([chosen]) {
        let ratio = trial.predicted.error_over_noise / trial.measured.error_over_noise;
        println!("{}: predicted by measured {ratio:.3}", trial.format);
        assert!((ratio - 1.0).abs() < 0.3, "{}: {ratio}", trial.format);
    }
}

/// Coloured walls need three channels. All photons have equal power, so none needs an exponent.
#[test]
fn the_cornell_box_gets_three_channels_and_no_exponent() {
    let (fit, chosen) = fitted("cornell");
    assert_smallest(&fit, &chosen);
    assert!(!fit.facts.one_colour && fit.facts.power_spread < 1.001);
    assert_eq!(chosen.format.power.channels, Channels::Rgb);
    assert_eq!(chosen.format.power.exponent, Exponent::None);
}

/// Light of one colour and one power needs only the presence of a photon, exactly one bit.
#[test]
fn the_ring_gets_one_channel_of_one_bit() {
    let (fit, chosen) = fitted("ring");
    assert_smallest(&fit, &chosen);
    assert!(fit.facts.one_colour);
    assert_eq!(chosen.format.power.channels, Channels::Mono);
    assert_eq!(chosen.format.power.mantissa_bits, 1);
    // The error is exactly zero, except for the rounding of the colour, which is a sum.
    assert!(chosen.predicted.power_error_over_noise < SceneFacts::COLOUR_TOLERANCE);
    // On a caustic the law for even light is too small.
    assert!(
        chosen.predicted.position_error_over_noise > 1.2 * chosen.predicted.law_error_over_noise
    );
}

/// Powers of 2,000,000 to 1 occur in one block, so every photon has its own exponent.
#[test]
fn the_two_rooms_get_an_exponent_for_each_photon() {
    let (fit, chosen) = fitted("range");
    assert_smallest(&fit, &chosen);
    assert!(fit.facts.power_spread > 1e6);
    let exponent = chosen.format.power.exponent;
    assert!(matches!(exponent, Exponent::Photon { .. }), "{exponent:?}");
}

/// A small fit, which runs twice.
fn small(noise_ratio: f64) -> Fit {
    let options = options();
    let options = FitOptions {
        noise_ratio,
        bench: BenchOptions {
            photons: 10_000,
            maps: 3,
            view: ViewOptions {
                width: 12,
                height: 12,
                ..options.bench.view
            },
            ..options.bench
        },
        largest_query: 100_000,
    };
    fit(&Scene::built_in("cornell").unwrap(), &options, &|_| ()).unwrap()
}

#[test]
fn threads_do_not_matter() {
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        let fit = pool.build().unwrap().install(|| small(0.2));
        (fit.chosen, fit.broken, fit.removals, fit.noise_relative)
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn a_loose_bound_takes_the_least_there_is_and_a_tight_one_nothing() {
    let loose = small(1e6);
    let format = loose.chosen.unwrap().format;
    // It has three channels nevertheless, because one channel would give other colours.
    assert_eq!(format.name(), "local4-rgb1-n131072");
    let less: Vec<_> = loose.removals.iter().map(|removal| removal.less).collect();
    assert_eq!(less, ["two channels"]);
    let tight = small(1e-6);
    assert!(tight.chosen.is_none() && tight.removals.is_empty());
    let widest = tight.widest.unwrap();
    assert_eq!(widest.format.position_bits, 12);
    let least = widest.measured.error_over_noise;
    assert!(!widest.holds && least < 0.1);
    // The bound that the widest format names is one that a format holds.
    let chosen = small(least).chosen.unwrap();
    assert!(chosen.measured.error_over_noise <= least);
}

#[test]
fn a_ratio_of_nothing_is_refused() {
    let scene = Scene::built_in("cornell").unwrap();
    for noise_ratio in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        let options = FitOptions {
            noise_ratio,
            ..options()
        };
        let error = fit(&scene, &options, &|_| ()).unwrap_err().to_string();
        assert!(error.contains("above 0"), "{error}");
    }
}
