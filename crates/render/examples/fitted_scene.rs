//! The smallest photon format that a scene needs: its error is at most a tenth of the noise of the photons themselves.
//! `cargo run -p photoncube-render --example fitted_scene`

use std::error::Error;

use photoncube_render::{BenchOptions, FitOptions, Scene, fit};

fn main() -> Result<(), Box<dyn Error>> {
    let scene = Scene::built_in("cornell")?;
    // Four maps of few photons show how the search works; `photoncube fit` measures on 16 maps of ten times as many.
    let options = FitOptions {
        bench: BenchOptions {
            photons: 20_000,
            in_range: 50.0,
            maps: 4,
            ..BenchOptions::default()
        },
        ..FitOptions::default()
    };
    let found = fit(&scene, &options, &|_| ())?;
    println!("chosen from {} formats", found.candidates);
    println!(
        "noise of the photons: {:.4} of the radiance",
        found.noise_relative
    );
    let chosen = found.chosen.ok_or("no format is below the bound")?;
    println!(
        "{}, {} bits a photon: error {:.4} of the noise, at most {}",
        chosen.format.name(),
        chosen.bits_per_photon(),
        chosen.measured.error_over_noise,
        options.noise_ratio
    );
    Ok(())
}
