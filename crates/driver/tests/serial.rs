//! A core at the end of a serial line: pictures over lines that damage and lose bytes, and boards that do not answer.

use std::collections::VecDeque;
use std::io::{self, Read, Write};
use std::time::Duration;

use photoncube_driver::{Driver, SerialError, SerialTransport};
use photoncube_model::SerialModel;
use photoncube_render::{Engine, PhotonMap, Scene, TraceOptions, ViewOptions, render, trace};
use photoncube_spec::{Core, CoreCounter, PhotonFormat, find_machine};
use rand::{RngExt, SeedableRng};
use rand_pcg::Pcg32;

const VIEW: ViewOptions = ViewOptions {
    width: 5,
    height: 5,
    samples_per_axis: 1,
    seed: 3,
};

const DIGEST: u64 = 0x0123_4567_89ab_cdef;
const SILENCE: Duration = Duration::from_millis(20);

/// A line that does something wrong with one byte of so many, on average: at regular places a host that goes back by as many bytes would meet it
/// again and again.
#[derive(Copy, Clone, Debug, Default)]
struct Noise {
    /// To the board, and from it; 0 for never.
    one_in: [usize; 2],
    /// Whether the byte is lost, else a bit of it is wrong.
    loses: bool,
    /// Whether the places are regular.
    regular: bool,
}

/// The model of a core at the other end of a line.
struct ModelPort {
    model: SerialModel,
    noise: Noise,
    bytes: [usize; 2],
    rng: Pcg32,
    from_board: VecDeque<u8>,
}

impl ModelPort {
    fn new(core: &Core, noise: Noise) -> Self {
        Self {
            model: SerialModel::new(core, DIGEST),
            noise,
            bytes: [0; 2],
            rng: Pcg32::seed_from_u64(1),
            from_board: VecDeque::new(),
        }
    }

    /// The byte at the other end; none where it is lost.
    fn carried(&mut self, direction: usize, byte: u8) -> Option<u8> {
        self.bytes[direction] += 1;
        let count = self.bytes[direction];
        let one_in = self.noise.one_in[direction];
        let is_wrong = match (one_in, self.noise.regular) {
            (0, _) => false,
            (_, true) => count % one_in == one_in - 1,
            (_, false) => self.rng.random_range(0..one_in) == 0,
        };
        match (is_wrong, self.noise.loses) {
            (false, _) => Some(byte),
            (true, true) => None,
            (true, false) => Some(byte ^ 1 << (count / 7 % 8)),
        }
    }
}

impl Write for ModelPort {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        for &byte in bytes {
            if let Some(byte) = self.carried(0, byte) {
                self.model.hear(byte);
            }
        }
        for byte in self.model.said() {
            let byte = self.carried(1, byte);
            self.from_board.extend(byte);
        }
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Read for ModelPort {
    fn read(&mut self, to: &mut [u8]) -> io::Result<usize> {
        match self.from_board.read(to)? {
            0 => Err(io::ErrorKind::TimedOut.into()),
            count => Ok(count),
        }
    }
}

fn core() -> Core {
    Core::new(find_machine("leaf-5-local7-rgb6d-n64").unwrap(), 3).unwrap()
}

fn traced() -> (Scene, PhotonMap) {
    let scene = Scene::built_in("cornell").unwrap();
    let options = TraceOptions {
        photons: 300,
        seed: 3,
    };
    let photons = trace(&scene, &options, &|_| ()).unwrap().photons;
    let radius = PhotonMap::radius_for(&scene, 300, 8.0);
    let map = PhotonMap::new(&scene, photons, radius).unwrap();
    (scene, map)
}

#[test]
fn a_picture_over_any_line_is_that_of_the_direct_gather() {
    let (scene, map) = traced();
    let core = core();
    // A query of a small bank meets in several sets more photons than the machine's format lets it meet at once.
    let format = PhotonFormat {
        max_photons: 1 << 20,
        ..*core.machine.format().unwrap()
    };
    let expected = render(&scene, &map, Engine::from(&format), &VIEW, &|_| ()).unwrap();
    for (one_in, loses) in [
        ([0, 0], false),
        ([997, 0], false),
        ([997, 0], true),
        ([0, 997], false),
        ([0, 997], true),
        ([1499, 1103], false),
    ] {
        let noise = Noise {
            one_in,
            loses,
            regular: false,
        };
        let port = ModelPort::new(&core, noise);
        let transport = SerialTransport::open(port, &core, DIGEST, SILENCE).unwrap();
        let driver = Driver::new(&core, vec![transport]).unwrap();
        let engine = Engine::Hardware(core.machine, &driver);
        let found = render(&scene, &map, engine, &VIEW, &|_| ());
        if let Err(error) = &found {
            panic!("{noise:?}: {error:?} {:?}", driver.work());
        }
        let found = found.unwrap();
        assert_eq!(found.image, expected.image, "{noise:?}");
        let work = driver.work();
        assert!(work.query_words > 100, "{noise:?}");
        if one_in[1] == 0 {
            assert_eq!(work.counter(CoreCounter::Results), work.query_words);
        }
    }
}

/// A board that says nothing.
struct Silent;

impl Write for Silent {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        Ok(())
    }
}

impl Read for Silent {
    fn read(&mut self, _: &mut [u8]) -> io::Result<usize> {
        Err(io::ErrorKind::TimedOut.into())
    }
}

fn refusal<P: Read + Write>(port: P, core: &Core, digest: u64) -> SerialError {
    match SerialTransport::open(port, core, digest, SILENCE) {
        Ok(_) => panic!("it was opened"),
        Err(error) => error,
    }
}

#[test]
fn a_board_that_is_not_there_or_another_is_named() {
    let core = core();
    let error = refusal(Silent, &core, DIGEST).to_string();
    assert!(
        error.contains("has not answered 4 times in 0.08 s"),
        "{error}"
    );
    let port = ModelPort::new(&core, Noise::default());
    let error = refusal(port, &core, DIGEST + 1).to_string();
    assert!(
        error.contains("3 chains of 2 engines with the digest 0123456789abcdef"),
        "{error}"
    );
    // A core whose words have other lengths.
    let other = Core::new(find_machine("leaf-4-local8-rgb8e5-n4096").unwrap(), 1).unwrap();
    let port = ModelPort::new(&other, Noise::default());
    let error = refusal(port, &core, DIGEST + 1).to_string();
    assert!(error.contains("expected `core-3-leaf-5"), "{error}");
}

#[test]
fn a_line_that_carries_nothing_right_is_named() {
    let core = core();
    let to_board = Noise {
        one_in: [14, 0],
        loses: false,
        regular: true,
    };
    let error = refusal(ModelPort::new(&core, to_board), &core, DIGEST);
    assert!(
        matches!(
            error,
            SerialError::ToBoard { .. } | SerialError::NoAnswer { .. }
        ),
        "{error}"
    );
    let from_board = Noise {
        one_in: [0, 17],
        loses: false,
        regular: true,
    };
    let error = refusal(ModelPort::new(&core, from_board), &core, DIGEST);
    assert!(matches!(error, SerialError::FromBoard { .. }), "{error}");
}
