//! Everything that works in floats: the scene, photon tracing, the photon map, quantisation
//! for the machine, the f64 reference of the radiance estimate, and the image.
//!
//! The modules follow the six stages of a photon-mapping renderer, in their order:
//! 1. [`Scene`]: surfaces, one area light or more, a camera;
//! 2. [`trace`]: photons leave the lights, follow mirrors and refraction, and are stored at every diffuse hit;
//! 3. [`PhotonMap`]: photons in blocks of a grid whose edge is at least the search radius;
//! 4. [`ViewOptions`]: view rays, supersampled, end at [`QueryPoint`]s;
//! 5. [`render`] with an [`Engine`] and an [`Estimator`]: the radiance estimate, by the f64 reference or by the
//!    golden model on photons that [`QuantisedMap`] turned into the integers of a machine or a photon format;
//! 6. [`Image`]: linear RGB, tone mapping, PNG and OpenEXR, maps of the error.
//!
//! [`Lighting`] decides which light comes from the maps, which from shadow rays and which from gather rays:
//! see [`render_lit`]. [`Progressive`] is the mean of many such pictures, and estimates its own error.
//!
//! [`fit`] finds the smallest photon format that a scene needs.
//!
//! The processor does the fifth stage; [`workload`] gives real queries to its testbench.
//!
//! All results are a function of the scene, the options and the seed; the number of threads
//! never matters.
//!
//! ```
//! use photoncube_render::{Engine, PhotonMap, Scene, TraceOptions, ViewOptions, render, trace};
//!
//! let scene = Scene::built_in("cornell")?;
//! let traced = trace(&scene, &TraceOptions { photons: 5_000, seed: 1 }, &|_| ())?;
//! let radius = PhotonMap::radius_for(&scene, 5_000, 50.0);
//! let map = PhotonMap::new(&scene, traced.photons, radius)?;
//! let view = ViewOptions { width: 16, height: 16, samples_per_axis: 1, seed: 1 };
//! // The f64 reference; `Engine::Integers` gathers in a machine's integers.
//! let rendering = render(&scene, &map, Engine::F64, &view, &|_| ())?;
//! assert_eq!((rendering.image.width(), rendering.image.height()), (16, 16));
//! assert!(rendering.stats.photons_in_range > 0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What is modelled
//! Quads, boxes, spheres and meshes of triangles, each with diffuse (Lambertian) reflection on its front, as a
//! perfect mirror of one side or two, or as the smooth border of a clear medium (Fresnel and Snell); a black back,
//! diffuse area lights that are quads, global illumination of any depth with its caustics, a pinhole camera with a
//! box filter. Photons on the far side of a thin sheet, or across a corner, are kept out of an estimate by the rule
//! stated at [`PhotonMap`].
//! Not modelled: glossy surfaces, colours of media and dispersion, textures, lens effects, smooth normals of
//! meshes.

mod estimate;
mod fit;
mod geometry;
mod image;
mod lighting;
mod metrics;
mod performance;
mod photon_map;
mod progressive;
mod quantise;
mod render;
mod scene;
mod schedule;
mod trace;
mod view;

pub use estimate::{
    Bisection, Estimator, EstimatorError, Kernel, KernelEstimate, Ladder, LadderError, MAX_RUNGS,
    MIN_K, Near, Neighbourhood, Rung, UnfitEstimator, UnknownEstimator, smallest_radius_sq,
};
pub use fit::{
    FieldNeed, Fit, FitError, FitOptions, FitProgress, Measurement, Prediction, Removal,
    SceneFacts, Trial, covering, covers, fed, field_needs, fit, largest_query,
};
pub use geometry::{Geometry, Hit, Mesh, MeshError, Quad, Sphere};
pub use image::{
    CompareError, IMAGE_ENDINGS, Image, ImageError, LIGHT_RADIANCE, MAX_PIXELS, error_map,
    light_mask, rel_mse, relative_errors, rms_relative_difference, rmse,
};
pub use lighting::{
    Area, BallError, Caustics, DirectLight, Lighting, LightingError, PhotonMaps, Radii,
    UnknownLighting, ball_errors,
};
pub use metrics::{
    BenchError, BenchOptions, ErrorBench, ErrorReport, ErrorStudy, EstimatorReport, Interval,
    LightReport, LightStudy, MAX_QUERY_NOISE, MISCLASSIFIED_TIMES_STEPS, Measure, MetricsError,
    Misclassified, Moments, Noise, NoiseMeter, RelativeErrors, RelativeSummary, luminance,
    view_queries,
};
pub use performance::{Speed, f32_speed, forecast_clocks, gather_speed};
pub use photon_map::{Candidates, MapError, PhotonMap, StoredPhoton};
pub use progressive::{
    Balance, ErrorEstimate, Given, OtherPicture, PixelBound, Progressive, ProgressiveError,
    ProgressiveOptions, ProgressiveState, RadiusRule, UnknownRadiusRule,
};
pub use quantise::{QuantiseError, QuantisedMap};
pub use render::{
    Engine, Gatherer, GathererError, Light, NearestGathered, RenderError, RenderStats, Rendering,
    WorkloadError, gather_rungs, render, render_lit, workload,
};
pub use scene::{Bsdf, LightChoice, ObjError, Scene, SceneError, Surface};
pub use schedule::{
    Batch, BatchOptions, Batches, Bounds, Cost, Cull, Facings, Leaf, Leaves, close_together, cost,
};
pub use trace::{
    BATCH_PATHS, Facing, MAX_PHOTONS, PathKind, Photon, PhotonTrace, TraceError, TraceOptions,
    trace,
};
pub use view::{
    Camera, FovAxis, Front, QueryPoint, Ray, Sights, ViewError, ViewOptions, sees_a_front,
};
