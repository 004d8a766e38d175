//! Renders with the golden model of cores, and compares with the direct gather.

use photoncube_driver::{
    Driver, DriverError, Forecast, ModelTransport, Transport, TransportError, Work,
};
use photoncube_render::{
    Engine, Estimator, Gatherer, Light, Lighting, PhotonMap, QuantisedMap, QueryPoint, RenderError,
    Rendering, Scene, TraceOptions, ViewOptions, render, render_lit, trace, view_queries,
};
use photoncube_spec::{
    Core, CoreAnswer, CoreCounter, CoreWords, Numbers, PhotonFormat, QueryRounds, find_machine,
};

const VIEW: ViewOptions = ViewOptions {
    width: 12,
    height: 12,
    samples_per_axis: 1,
    seed: 3,
};

fn traced(scene: &str, in_range: f64) -> (Scene, PhotonMap) {
    let scene = match scene.ends_with(".toml") {
        false => Scene::built_in(scene).unwrap(),
        true => {
            let path = format!("{}/../../docs/scenes/{scene}", env!("CARGO_MANIFEST_DIR"));
            Scene::from_file(path.as_ref()).unwrap()
        }
    };
    let options = TraceOptions {
        photons: 20_000,
        seed: 3,
    };
    let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
    let radius = PhotonMap::radius_for(&scene, 20_000, in_range);
    let map = PhotonMap::new(&scene, photons, radius).unwrap();
    (scene, map)
}

fn core(chains: u32, machine: &str) -> Core {
    Core::new(find_machine(machine).unwrap(), chains).unwrap()
}

/// The view as a square of that many pixels a side.
fn square(side: u32) -> ViewOptions {
    ViewOptions {
        width: side,
        height: side,
        ..VIEW
    }
}

/// The picture by that many models of a core.
fn by_models(
    scene: &Scene,
    map: &PhotonMap,
    core: &Core,
    view: &ViewOptions,
    count: usize,
) -> (Rendering, Work) {
    let models = (0..count).map(|_| ModelTransport::new(core)).collect();
    let driver = Driver::new(core, models).unwrap();
    let engine = Engine::Hardware(core.machine, &driver);
    let rendering = render(scene, map, engine, view, &|_| ()).unwrap();
    (rendering, driver.work())
}

/// Scenes of flat walls and of curved surfaces, whose queries gather more sets of facings than one set of photons serves; and a
/// machine whose banks are smaller than the photons of a frame.
#[test]
fn a_core_renders_what_the_direct_gather_renders() {
    for (scene, in_range, chains, name) in [
        ("cornell", 60.0, 1, "leaf-7-local7-rgb6d-n4096"),
        ("ring", 40.0, 3, "leaf-5-local6x2-rgb4d-n4096"),
        ("balls.toml", 60.0, 2, "leaf-6-local7-rgb6d-n4096"),
        ("cornell", 60.0, 4, "leaf-4-local7-rgb6d-n128"),
    ] {
        let (scene, map) = traced(scene, in_range);
        let core = core(chains, name);
        let (found, work) = by_models(&scene, &map, &core, &VIEW, 1);
        // A query of a small bank meets in several sets more photons than the machine's format lets it meet at once.
        let format = PhotonFormat {
            max_photons: 1 << 20,
            ..*core.machine.format().unwrap()
        };
        let expected = render(&scene, &map, Engine::from(&format), &VIEW, &|_| ()).unwrap();
        assert_eq!(found.image, expected.image, "{name}");
        let in_range = work.counter(CoreCounter::PhotonsInRange);
        assert_eq!(in_range, expected.stats.photons_in_range, "{name}");
        assert!(in_range > 0, "{name}");
        assert_eq!(
            work.counter(CoreCounter::Results),
            work.query_words,
            "{name}"
        );
        for wrong in [
            CoreCounter::LeavesMalformed,
            CoreCounter::LeavesRefused,
            CoreCounter::QueriesOutside,
        ] {
            assert_eq!(work.counter(wrong), 0, "{name}: {wrong:?}");
        }
        // So small a picture keeps several chains busy for a part of the time only, and its chains' first sets wait for each other.
        let (clocks, forecast) = (work.counter(CoreCounter::Clocks), work.clocks_forecast);
        match chains {
            1 => assert!(
                clocks.abs_diff(forecast) * 100 <= clocks,
                "{name}: {forecast} of {clocks}"
            ),
            _ => assert!(forecast <= clocks, "{name}: {forecast} of {clocks}"),
        }
        let in_several_sets = work.query_words > work.queries;
        assert_eq!(in_several_sets, name.ends_with("n128"), "{name}: {work:?}");
    }
}

/// `report` says the seconds of a picture by this forecast, which is made without a simulation.
#[test]
fn the_forecast_of_a_picture_is_near_its_simulated_clocks() {
    let view = square(128);
    let core = core(6, "leaf-7-local7-rgb6d-n4096");
    for scene in ["cornell", "ring"] {
        let (scene, map) = traced(scene, 200.0);
        let queries = view_queries(&scene, &view).unwrap();
        let numbers = Numbers::Local(*core.machine.format().unwrap());
        let quantised = QuantisedMap::new(&map, &numbers).unwrap();
        let forecast = Forecast::of(&core, &quantised, &queries);
        assert_eq!(forecast.queries, queries.len() as u64);

        let (_, work) = by_models(&scene, &map, &core, &view, 1);
        let clocks = work.counter(CoreCounter::Clocks);
        // In the forecast, a leaf is sent at its time, also where its stream is free before, and not later for leaves of other chains. On
        // these pictures that makes 1.1 % more and 1.5 % fewer clocks.
        let forecast = forecast.clocks;
        assert!(
            clocks.abs_diff(forecast) * 50 <= clocks,
            "{}: {clocks}, forecast {forecast}",
            scene.name()
        );
    }
}

/// With 20 photons in range most batches take the clocks of the chain's pipeline, with 200 those of their groups. The loads of sets, which the
/// forecast has less exactly, wait for nothing here. A clock too many or too few in each batch would be fifty times the error that it may have.
#[test]
fn the_forecast_of_one_chain_has_each_clock_of_its_batches() {
    let view = square(192);
    let core = core(1, "leaf-7-local7-rgb6d-n4096");
    let batches = u64::from(view.width * view.height) / core.engines() as u64;
    for in_range in [20.0, 60.0, 200.0] {
        let (scene, map) = traced("cornell", in_range);
        let (_, work) = by_models(&scene, &map, &core, &view, 1);
        let (clocks, forecast) = (work.counter(CoreCounter::Clocks), work.clocks_forecast);
        assert!(
            clocks.abs_diff(forecast) * 50 <= batches,
            "{in_range} in range: {forecast} of {clocks} clocks, {batches} batches"
        );
    }
}

/// The picture of an estimator by a model of a core, and its gathers.
fn estimated(
    (scene, map): &(Scene, PhotonMap),
    engine: Engine<'_>,
    estimator: &Estimator,
) -> Result<Rendering, RenderError> {
    let light = Light {
        lighting: &Lighting::default(),
        global: map,
        caustic: None,
        estimator,
    };
    render_lit(scene, light, engine, &VIEW, &|_| ())
}

/// A core that the host asks for one round at a time.
struct WithoutRounds(ModelTransport);

impl Transport for WithoutRounds {
    fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, TransportError> {
        assert_eq!(words.rounds, QueryRounds::Own);
        self.0.exchange(words)
    }
}

const ESTIMATORS: [&str; 5] = ["fixed", "ladder:4:cone", "ladder:11", "knn:20", "knn:300"];

/// On whole and on half steps. With 300 photons asked for, many queries have fewer in their search radius.
#[test]
fn queries_with_radii_make_every_estimate_of_the_integers() {
    for (scene, chains, name) in [
        ("cornell", 1, "leaf-7-radii-local7-rgb6d-n4096"),
        ("ring", 3, "leaf-5-radii-local6x2-rgb4d-n4096"),
    ] {
        let traced = traced(scene, 60.0);
        let core = core(chains, name);
        for estimator in ESTIMATORS {
            let model = WithoutRounds(ModelTransport::new(&core));
            let driver = Driver::new(&core, vec![model]).unwrap();
            let estimator = estimator.parse().unwrap();
            let hardware = Engine::Hardware(core.machine, &driver);
            let found = estimated(&traced, hardware, &estimator).unwrap();
            let expected = estimated(&traced, Engine::from(core.machine), &estimator).unwrap();
            assert_eq!(found.image, expected.image, "{name}: {estimator}");
            let gathers = |rendering: &Rendering| rendering.stats.gathers;
            assert_eq!(gathers(&found), gathers(&expected), "{name}: {estimator}");
            assert_eq!(
                driver.work().queries,
                gathers(&found),
                "{name}: {estimator}"
            );
        }
    }
}

/// The bank of the last machine holds fewer leaves than some batches want. For their queries the host asks one round at a time.
#[test]
fn the_rounds_of_a_core_make_every_estimate_of_the_integers() {
    for (scene, chains, name) in [
        ("cornell", 1, "leaf-7-radii-local7-rgb6d-n4096"),
        ("ring", 3, "leaf-5-radii-local6x2-rgb4d-n4096"),
        ("cornell", 2, "leaf-4-radii-local7-rgb6d-n256"),
    ] {
        let (scene, map) = traced(scene, 60.0);
        let core = core(chains, name);
        for estimator in ESTIMATORS {
            let driver = Driver::new(&core, vec![ModelTransport::new(&core)]).unwrap();
            let estimator: Estimator = estimator.parse().unwrap();
            let traced = (scene.clone(), map.clone());
            let hardware = Engine::Hardware(core.machine, &driver);
            let found = estimated(&traced, hardware, &estimator).unwrap();
            // A query of a small bank meets in several sets more photons than the machine's format lets it meet at once.
            let format = PhotonFormat {
                max_photons: 1 << 20,
                ..*core.machine.format().unwrap()
            };
            let expected = estimated(&traced, Engine::from(&format), &estimator).unwrap();
            assert_eq!(found.image, expected.image, "{name}: {estimator}");
            let work = driver.work();
            let asked = work.queries as f64 / found.stats.estimates as f64;
            assert!(asked <= 2.0, "{name}: {estimator}: {asked}");
            // A ladder of more than eight rungs is two.
            let in_part_by_host = asked.fract() > 0.0;
            let is_split =
                name.ends_with("n256") && matches!(estimator, Estimator::KNearest { .. });
            assert_eq!(in_part_by_host, is_split, "{name}: {estimator}: {asked}");
        }
    }
}

#[test]
fn an_estimate_that_a_core_has_no_radii_for_is_refused() {
    let core = core(1, "leaf-4-local7-rgb6d-n256");
    let driver = Driver::new(&core, vec![ModelTransport::new(&core)]).unwrap();
    let engine = Engine::Hardware(core.machine, &driver);
    let traced = traced("cornell", 60.0);
    let error = estimated(&traced, engine, &Estimator::KNearest { k: 20 }).unwrap_err();
    let error = error.to_string();
    assert!(error.contains("all have the format's radius"), "{error}");
    let (_, map) = &traced;
    let place = map.photons()[0].position;
    let map = QuantisedMap::new(map, &core.machine.numbers).unwrap();
    let query = QueryPoint {
        position: place,
        normal: place,
        surface: None,
        beta: place,
    };
    let error = driver.gather_all(&map, &[query], &[1]).unwrap_err();
    let error = error.to_string();
    assert!(
        error.contains("a query with a radius of its own"),
        "{error}"
    );
}

#[test]
fn several_cores_share_the_frames_of_a_picture() {
    let (scene, map) = traced("cornell", 60.0);
    let core = core(2, "leaf-6-local7-rgb6d-n4096");
    let (one, one_work) = by_models(&scene, &map, &core, &VIEW, 1);
    let (three, three_work) = by_models(&scene, &map, &core, &VIEW, 3);
    assert_eq!(one.image, three.image);
    let played = |work: &Work| work.counter(CoreCounter::GroupsPlayed);
    assert_eq!(played(&one_work), played(&three_work));
}

/// What is wrong with the answers of a core.
#[derive(Copy, Clone)]
enum Wrong {
    /// The first two results are mixed up.
    Swapped,
    /// The last result is missing.
    Missing,
    /// The first result is said to be of a query outside of its frame.
    Outside,
    /// The first result is said to come from another chain.
    OtherChain,
}

struct Answers(ModelTransport, Wrong);

impl Transport for Answers {
    fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, TransportError> {
        let mut answer = self.0.exchange(words)?;
        match self.1 {
            Wrong::Swapped => answer.results.swap(0, 1),
            Wrong::Missing => drop(answer.results.pop()),
            Wrong::Outside => answer.results[0].outside = true,
            Wrong::OtherChain => answer.results[0].id = 9,
        }
        Ok(answer)
    }
}

#[test]
fn wrong_answers_of_a_core_are_refused() {
    let (scene, map) = traced("cornell", 60.0);
    let core = core(1, "leaf-6-local7-rgb6d-n4096");
    for (wrong, expected) in [
        (
            Wrong::Swapped,
            "result 0, of chain 0, has the tag 1, expected 0",
        ),
        (Wrong::Missing, "results, expected"),
        (
            Wrong::Outside,
            "result 0 is of a query outside of its frame",
        ),
        (
            Wrong::OtherChain,
            "result 0, of chain 9, has the tag 0, expected none",
        ),
    ] {
        let driver = Driver::new(&core, vec![Answers(ModelTransport::new(&core), wrong)]).unwrap();
        let engine = Engine::Hardware(core.machine, &driver);
        let error = render(&scene, &map, engine, &VIEW, &|_| ()).unwrap_err();
        let error = error.to_string();
        assert!(error.contains(expected), "{error}");
    }
}

#[test]
fn a_driver_without_a_core_is_refused() {
    let core = core(1, "leaf-4-local7-rgb6d-n256");
    let error = Driver::<ModelTransport>::new(&core, Vec::new()).unwrap_err();
    assert!(matches!(error, DriverError::NoTransport));
}
