//! The readers of user files and texts, each with good inputs to start from.

use std::path::Path;

use anyhow::{Context, Result, anyhow};
use photoncube_render::{
    Engine, Image, PhotonMap, Scene, TraceOptions, ViewOptions, render, trace,
};
use photoncube_spec::{Hypercube, Microprogram, parse_listing};
use rand::Rng;

use super::mutate;
use crate::args::Args;
use crate::shards::{Selection, jobs_in, merge_lines};
use crate::verified;

/// An input of a reader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Input {
    Text(String),
    Bytes(Vec<u8>),
}

/// A function that reads user input.
pub struct Reader {
    /// The reader's name on the command line.
    pub name: &'static str,
    /// A description of what it reads, for people.
    pub reads: &'static str,
    /// Makes good inputs; `folder` is a working folder.
    good: fn(folder: &Path) -> Result<Vec<Input>>,
    /// Reads an input. An error is a refusal, which is not a failure.
    read: fn(folder: &Path, input: &Input) -> Result<()>,
}

/// All readers of user input.
pub const READERS: [Reader; 8] = [
    Reader {
        name: "scene-toml",
        reads: "scenes in TOML",
        good: |folder| {
            std::fs::write(folder.join("knot.obj"), MESHES[0])?;
            Ok(texts(&TOML_SCENES))
        },
        read: |folder, input| use_scene(&Scene::from_toml("fuzz.toml", text(input), folder)?),
    },
    Reader {
        name: "scene-json",
        reads: "scenes in JSON",
        good: |_| Ok(texts(&JSON_SCENES)),
        read: |_, input| use_scene(&Scene::from_json("fuzz.json", text(input))?),
    },
    Reader {
        name: "mesh",
        reads: "meshes in OBJ",
        good: |_| Ok(texts(&MESHES)),
        read: read_mesh,
    },
    Reader {
        name: "listing",
        reads: "microprogram listings",
        good: |_| Ok(listings()),
        read: |_, input| Ok(parse_listing(text(input)).map(drop)?),
    },
    Reader {
        name: "picture",
        reads: "pictures in OpenEXR",
        good: |_| good_picture(),
        read: read_picture,
    },
    Reader {
        name: "results",
        reads: "tables of results in JSON",
        good: |_| Ok(texts(&RESULTS)),
        read: |_, input| verified::parse(text(input)).map(drop),
    },
    Reader {
        name: "state",
        reads: "state files of shards",
        good: |_| Ok(texts(&STATES)),
        read: merge_state,
    },
    Reader {
        name: "arguments",
        reads: "command lines",
        good: |_| Ok(texts(&COMMANDS)),
        read: |_, input| {
            let words = text(input).split_whitespace();
            Ok(Args::try_read(words).map(drop)?)
        },
    },
];

/// A reader with a planted mistake, which the method must find.
pub const PLANTED: Reader = Reader {
    name: "planted",
    reads: "texts that panics without a closing bracket",
    good: |_| Ok(texts(&["{ 1 }"])),
    read: |_, input| match text(input).contains('}') {
        true => Ok(()),
        false => panic!("no closing bracket"),
    },
};

const TOML_SCENES: [&str; 7] = [
    include_str!("../../../../../../docs/scenes/balls.toml"),
    include_str!("../../../../../../docs/scenes/boxes.toml"),
    include_str!("../../../../../../docs/scenes/knots.toml"),
    include_str!("../../../../../../docs/scenes/lights.toml"),
    include_str!("../../../../../../docs/scenes/mirrors.toml"),
    include_str!("../../../../../../docs/scenes/room.toml"),
    include_str!("../../../../../../docs/scenes/spheres.toml"),
];

const JSON_SCENES: [&str; 2] = [
    include_str!("../../../../../render/scenes/cornell.json"),
    include_str!("../../../../../../docs/scenes/spheres.json"),
];

const MESHES: [&str; 2] = [
    "# a tetrahedron\no t\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n",
    "v 0 0 0 0.5 0.5 0.5\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\ng a\nusemtl b\nf 1/1/1 2//1 -2 -1\n",
];

/// The scene for which a mesh is read.
const MESH_SCENE: &str = include_str!("mesh.toml");

const RESULTS: [&str; 1] = [
    r#"[{"machine": "paper", "method": "equivalence", "aspect": "", "by": "icarus: 11.0",
"volume": 12, "unit": "vectors", "outcome": "0 mismatches", "command": "photoncube verify"}]"#,
];

const STATES: [&str; 1] = [concat!(
    r#"{"photoncube":"synth","format":4,"settings":{"--seed":"1"},"jobs":5,"shards":{"of":2,"has":[1]}}"#,
    "\n{\"job\":0,\"result\":1}\n{\"job\":2,\"result\":[1.5]}\n{\"job\":4,\"result\":null}\n"
)];

/// Command lines with every kind of value.
const COMMANDS: [&str; 10] = [
    "photoncube run cornell --machine paper-12 --out out --photons 2000000 --size 64x48 --json",
    "photoncube render cornell -o box.png --engine f64 --photons 100 --samples 3 --in-range 0.5",
    "photoncube render ring -o x.exr --estimator ladder:8:cone --direct rays:4 --caustics own:50 --area covered",
    "photoncube progressive cornell -o b.png --error-target 0.1 --confidence 0.9 --passes 10 --alpha 0.7",
    "photoncube fit ring --noise-ratio 0.1 --maps 8 --seed 3",
    "photoncube verify --machine paper-5d --against icarus,verilator --iterations 20 --seed 7",
    "photoncube verify formal --machine stream --property units:: --json",
    "photoncube generate --machine paper --coordinate-bits 12 --dimension 5 --check",
    "photoncube synth --machine tile-4 --flow place --grade 8 --seed 2",
    "photoncube report --sweep cornell ring --in-range 50,200 --shard 2/7 --state 2.jobs",
];

fn texts(texts: &[&str]) -> Vec<Input> {
    texts
        .iter()
        .map(|&text| Input::Text(text.to_owned()))
        .collect()
}

fn listings() -> Vec<Input> {
    let program = |dimension| Microprogram::all_reduce(Hypercube::new(dimension)).to_string();
    [4, 5]
        .map(|dimension| Input::Text(program(dimension)))
        .into()
}

/// Pictures with each form of block that the project writes.
fn good_picture() -> Result<Vec<Input>> {
    let pixels = (0..12).map(|i| glam::DVec3::splat(f64::from(i))).collect();
    let picture = Image::new(4, 3, pixels)?.encode(Path::new("good.exr"), 1.0)?;
    Ok(vec![Input::Bytes(picture)])
}

fn read_picture(folder: &Path, input: &Input) -> Result<()> {
    let Input::Bytes(bytes) = input else {
        return Err(anyhow!("a picture is bytes"));
    };
    let path = folder.join("fuzz.exr");
    std::fs::write(&path, bytes).context("the fuzzer's own folder")?;
    Ok(Image::read_exr(&path).map(drop)?)
}

/// Merges a state file as `merge --partial` does.
fn merge_state(folder: &Path, input: &Input) -> Result<()> {
    let path = folder.join("fuzz.state");
    std::fs::write(&path, text(input)).context("the fuzzer's own folder")?;
    let selection = Selection::of(&[path], jobs_in)?;
    merge_lines(&selection.inputs, selection.jobs, &mut std::io::sink())
}

fn read_mesh(folder: &Path, input: &Input) -> Result<()> {
    std::fs::write(folder.join("fuzz.obj"), text(input)).context("the fuzzer's own folder")?;
    use_scene(&Scene::from_toml("fuzz.toml", MESH_SCENE, folder)?)
}

/// Uses an accepted scene: traces some photons and renders a small picture, which must not panic either.
fn use_scene(scene: &Scene) -> Result<()> {
    let options = TraceOptions {
        photons: 20,
        seed: 1,
    };
    let photons = trace(scene, &options, &|_| ())?.photons;
    let radius = PhotonMap::radius_for(scene, photons.len() as u64, 10.0);
    let map = PhotonMap::new(scene, photons, radius)?;
    let view = ViewOptions {
        width: 3,
        height: 2,
        samples_per_axis: 1,
        seed: 1,
    };
    render(scene, &map, Engine::F64, &view, &|_| ())?;
    Ok(())
}

fn text(input: &Input) -> &str {
    match input {
        Input::Text(text) => text,
        Input::Bytes(_) => unreachable!("this reader's good inputs are texts"),
    }
}

impl Reader {
    /// Opens the reader with its good inputs.
    pub fn open<'a>(&'a self, folder: &'a Path) -> Result<Open<'a>> {
        let (mut texts, mut files) = (Vec::new(), Vec::new());
        for input in (self.good)(folder)? {
            (self.read)(folder, &input)
                .with_context(|| format!("{}: a good input is refused: {input:?}", self.name))?;
            match input {
                Input::Text(text) => texts.push(text),
                Input::Bytes(bytes) => files.push(bytes),
            }
        }
        Ok(Open {
            reader: self,
            folder,
            texts,
            files,
        })
    }
}

/// A reader with its good inputs.
pub struct Open<'a> {
    reader: &'a Reader,
    folder: &'a Path,
    texts: Vec<String>,
    files: Vec<Vec<u8>>,
}

impl Open<'_> {
    /// The reader's name.
    pub fn name(&self) -> &'static str {
        self.reader.name
    }

    /// A randomly changed input.
    pub fn input(&self, rng: &mut impl Rng) -> Input {
        if self.files.is_empty() {
            Input::Text(mutate::text(rng, &self.texts))
        } else {
            Input::Bytes(mutate::bytes(rng, &self.files))
        }
    }

    /// Reads an input. An error is a refusal, which is not a failure.
    pub fn read(&self, input: &Input) -> Result<()> {
        (self.reader.read)(self.folder, input)
    }
}
