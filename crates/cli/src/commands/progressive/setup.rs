//! What a picture is made of.

use anyhow::{Result, ensure};
use photoncube_render::{
    Area, Balance, Caustics, DirectLight, Engine, Estimator, Given, Lighting, Progressive,
    ProgressiveOptions, RadiusRule, Scene, ViewOptions,
};

use super::kept;
use super::work::snapshot;
use crate::args::ProgressiveArgs;
use crate::outputs::{self, Output};
use crate::shards::Settings;
use crate::{scenes, sight};

/// What a picture is made of.
pub struct Setup<'a> {
    pub scene: Scene,
    pub engine: Engine<'a>,
    pub lighting: Lighting,
    pub view: ViewOptions,
    pub options: ProgressiveOptions,
    pub balance: Balance,
}

impl<'a> Setup<'a> {
    /// Reads the scene, checks the files that will be written, and lets the pilot choose what is not given.
    pub fn new(args: &ProgressiveArgs, engine: Engine<'a>) -> Result<Self> {
        let scene = scenes::load(&args.scene)?;
        let lighting = args.light.lighting(&LIGHTING);
        lighting.check(&scene, &Estimator::FixedRadius)?;
        check_outputs(args, &scene)?;
        let rule = args.radius_rule;
        let rule = rule.unwrap_or_else(|| RadiusRule::of(&lighting));
        ensure!(
            args.shard.is_none() || rule == RadiusRule::Schedule,
            "--shard: by the radius rule chi-square passes depend on those before them, so they cannot be shared out; give \
             --radius-rule schedule"
        );
        let base = ViewOptions {
            width: args.size.width,
            height: args.size.height,
            seed: args.seed,
            ..ViewOptions::default()
        };
        sight::check(&scene, &base)?;
        let balance = balance(args, &scene, &lighting, &base)?;
        Ok(Self {
            view: ViewOptions {
                samples_per_axis: balance.samples_per_axis,
                ..base
            },
            options: ProgressiveOptions {
                photons: balance.photons,
                rule,
                ..options(args)
            },
            lighting: Lighting {
                direct: match lighting.direct {
                    DirectLight::Map => DirectLight::Map,
                    DirectLight::Rays(_) => DirectLight::Rays(balance.rays),
                },
                ..lighting
            },
            scene,
            engine,
            balance,
        })
    }

    /// The picture without passes.
    pub fn picture(&self) -> Result<Progressive<'_>> {
        let (lighting, view, options) = (self.lighting, self.view, self.options);
        Ok(Progressive::new(
            &self.scene,
            self.engine,
            lighting,
            view,
            options,
        )?)
    }

    /// What another run must have in common to go on with the passes.
    pub fn settings(&self, args: &ProgressiveArgs) -> Settings {
        let rule = self.options.rule;
        kept::settings(
            args,
            &self.scene,
            self.engine,
            &self.lighting,
            &self.balance,
            rule,
        )
    }
}

/// Checks all files that may be written against all that are read.
fn check_outputs(args: &ProgressiveArgs, scene: &Scene) -> Result<()> {
    let picture = args.output().into_iter();
    let mut outputs: Vec<_> = picture
        .clone()
        .map(|path| Output::picture("-o", path))
        .collect();
    outputs.extend(args.plot.iter().map(|path| Output::plot("--plot", path)));
    let state = args.state.iter();
    outputs.extend(state.map(|path| Output::within("--state", path.clone())));
    let map = args.error_map.iter();
    outputs.extend(map.map(|path| Output::plot("--error-map", path)));
    for picture in picture.filter(|_| args.snapshots) {
        let powers = (0..u64::BITS).map(|power| 1 << power);
        let passes = powers.take_while(|passes| *passes <= args.passes);
        let snapshots = passes.map(|passes| snapshot(picture, passes));
        outputs.extend(snapshots.map(|path| Output::within("--snapshots", path)));
    }
    let mut inputs = scene.files().to_vec();
    inputs.extend(args.reference.clone());
    outputs::check(&outputs, &inputs)
}

/// The lighting that is not given: what needs the least time for an error. The pilot chooses the number of shadow rays.
const LIGHTING: Lighting = Lighting {
    direct: DirectLight::Rays(1),
    caustics: Caustics::OWN,
    final_gather: 0,
    area: Area::Covered,
};

fn options(args: &ProgressiveArgs) -> ProgressiveOptions {
    ProgressiveOptions {
        in_range: args.in_range,
        alpha: args.alpha,
        seed: args.seed,
        ..ProgressiveOptions::default()
    }
}

/// What a pass is made of: what is given, and what a pilot chooses.
fn balance(
    args: &ProgressiveArgs,
    scene: &Scene,
    lighting: &Lighting,
    view: &ViewOptions,
) -> Result<Balance> {
    let given = Given {
        photons: args.photons,
        samples_per_axis: args.samples,
        rays: match args.light.direct {
            Some(DirectLight::Rays(rays)) => Some(rays),
            _ => None,
        },
    };
    let options = options(args);
    Ok(Balance::choose(scene, lighting, view, &options, given)?)
}
