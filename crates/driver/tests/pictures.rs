//! Renders with the golden model of leaf machines, and compares with the direct gather.

use photoncube_driver::{Driver, DriverError, ModelTransport, Transport, TransportError, Work};
use photoncube_render::{
    Engine, PhotonMap, Rendering, Scene, TraceOptions, ViewOptions, render, trace,
};
use photoncube_spec::{LeafAnswer, LeafWords, Machine, PhotonFormat, find_machine};

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

fn machine(name: &str) -> &'static Machine {
    find_machine(name).unwrap()
}

/// The picture by that many models of a machine.
fn by_models(
    scene: &Scene,
    map: &PhotonMap,
    machine: &'static Machine,
    count: usize,
) -> (Rendering, Work) {
    let models = (0..count).map(|_| ModelTransport::new(machine)).collect();
    let driver = Driver::new(machine, models).unwrap();
    let engine = Engine::Hardware(machine, &driver);
    let rendering = render(scene, map, engine, &VIEW, &|_| ()).unwrap();
    let work = driver.work();
    (rendering, work)
}

/// Scenes of flat walls and of curved surfaces, whose queries gather more sets of facings than one set of photons serves; and a
/// machine whose banks are smaller than the photons of a frame.
#[test]
fn a_leaf_machine_renders_what_the_direct_gather_renders() {
    for (scene, in_range, name) in [
        ("cornell", 60.0, "leaf-7-local7-rgb6d-n4096"),
        ("ring", 40.0, "leaf-5-local6x2-rgb4d-n4096"),
        ("balls.toml", 60.0, "leaf-6-local7-rgb6d-n4096"),
        ("cornell", 60.0, "leaf-4-local7-rgb6d-n128"),
    ] {
        let (scene, map) = traced(scene, in_range);
        let machine = machine(name);
        let (found, work) = by_models(&scene, &map, machine, 1);
        // A query of a small bank meets in several sets more photons than the machine's format lets it meet at once.
        let format = PhotonFormat {
            max_photons: 1 << 20,
            ..*machine.format().unwrap()
        };
        let expected = render(&scene, &map, Engine::from(&format), &VIEW, &|_| ()).unwrap();
        assert_eq!(found.image, expected.image, "{name}");
        assert_eq!(work.in_range, expected.stats.photons_in_range, "{name}");
        assert!(work.in_range > 0, "{name}");
        let in_several_sets = work.query_words > work.queries;
        assert_eq!(in_several_sets, name.ends_with("n128"), "{name}: {work:?}");
    }
}

#[test]
fn several_machines_share_the_frames_of_a_picture() {
    let (scene, map) = traced("cornell", 60.0);
    let machine = machine("leaf-6-local7-rgb6d-n4096");
    let (one, one_work) = by_models(&scene, &map, machine, 1);
    let (three, three_work) = by_models(&scene, &map, machine, 3);
    assert_eq!(one.image, three.image);
    assert_eq!(one_work.groups_played, three_work.groups_played);
}

/// A machine that mixes up two results.
struct Swaps(ModelTransport);

impl Transport for Swaps {
    fn exchange(&mut self, words: &LeafWords) -> Result<LeafAnswer, TransportError> {
        let mut answer = self.0.exchange(words)?;
        answer.results.swap(0, 1);
        Ok(answer)
    }
}

#[test]
fn results_out_of_order_are_refused() {
    let (scene, map) = traced("cornell", 60.0);
    let machine = machine("leaf-6-local7-rgb6d-n4096");
    let driver = Driver::new(machine, vec![Swaps(ModelTransport::new(machine))]).unwrap();
    let engine = Engine::Hardware(machine, &driver);
    let error = render(&scene, &map, engine, &VIEW, &|_| ()).unwrap_err();
    let error = error.to_string();
    assert!(
        error.contains("result 0 has the tag 1, expected 0"),
        "{error}"
    );
}

#[test]
fn what_is_no_leaf_machine_is_refused() {
    let made = |name| Driver::<ModelTransport>::new(machine(name), Vec::new());
    let error = made("tile-4").unwrap_err();
    assert!(matches!(error, DriverError::NoLeaves("tile-4")));
    let error = made("leaf-4-local7-rgb6d-n256").unwrap_err();
    assert!(matches!(error, DriverError::NoTransport));
}
