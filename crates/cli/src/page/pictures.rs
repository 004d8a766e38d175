//! A picture with a slider against its reference, and its error map.

use std::path::Path;

use anyhow::Result;
use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use maud::{Markup, html};
use photoncube_render::{Image, LIGHT_RADIANCE, light_mask, relative_errors};

use crate::stages::{EXPOSURE, map_of};

/// A picture and its reference.
pub struct Pictures<'a> {
    /// What made the picture.
    pub made_by: &'a str,
    /// The picture.
    pub picture: &'a Image,
    /// The reference in f64.
    pub reference: &'a Image,
    /// The title of the error map.
    pub title: &'a str,
}

/// The largest and the median relative error of the pixels that are compared.
struct Errors {
    median: f64,
    largest: f64,
    pixels: usize,
}

impl Errors {
    fn of(pictures: &Pictures<'_>) -> Option<Self> {
        let mask = light_mask(pictures.reference, LIGHT_RADIANCE);
        let errors = relative_errors(
            pictures.picture.pixels(),
            pictures.reference.pixels(),
            &mask,
        );
        let mut errors: Vec<f64> = errors.into_iter().flatten().collect();
        errors.sort_by(f64::total_cmp);
        Some(Self {
            median: *errors.get(errors.len() / 2)?,
            largest: *errors.last()?,
            pixels: errors.len(),
        })
    }
}

/// The slider and the error map.
///
/// # Errors
/// A picture cannot be encoded.
pub fn pictures(pictures: &Pictures<'_>) -> Result<Markup> {
    let (width, height) = (pictures.picture.width(), pictures.picture.height());
    let picture = data_uri(pictures.picture)?;
    let reference = data_uri(pictures.reference)?;
    let map = map_of(pictures.picture, pictures.reference, pictures.title);
    let [map_width, map_height] = ["width", "height"].map(|name| attribute(&map, name).to_owned());
    let map = format!("data:image/svg+xml;base64,{}", STANDARD.encode(&map));
    let errors = Errors::of(pictures);
    let by = pictures.made_by;
    Ok(html! {
        div.pictures {
            figure.compare {
                div.pair style={ "aspect-ratio:" (width) "/" (height) } {
                    img src=(reference) width=(width) height=(height) alt="The scene by the reference in f64";
                    img.above src=(picture) width=(width) height=(height) alt={ "The scene by " (by) };
                }
                label {
                    span { (by) " at the left of the line, f64 at the right" }
                    input.slider type="range" min="0" max="100" value="50"
                        aria-label={ "How much of the picture is by " (by) ", in percent" };
                }
                figcaption {
                    "Both pictures have the same photons and the same queries. They differ by the arithmetic alone."
                }
            }
            figure.map {
                img.whole src=(map) width=(map_width) height=(map_height) alt={ "Map of the relative error of each pixel: " (by) " against f64" };
                figcaption {
                    @match errors {
                        Some(errors) => {
                            "Relative error of each pixel: median " (percent(errors.median)) ", largest "
                            (percent(errors.largest)) ", over " (errors.pixels) " pixels. Grey pixels are left out: they are \
                            black, or see a lamp."
                        }
                        None => "No pixel can be compared: each is black or sees a lamp."
                    }
                }
            }
        }
    })
}

/// The first value of an attribute in an SVG picture; empty where there is none.
fn attribute<'a>(svg: &'a str, name: &str) -> &'a str {
    let begin = format!(" {name}=\"");
    let value = svg.split_once(&begin).map(|(_, rest)| rest);
    value
        .and_then(|rest| rest.split_once('"'))
        .map_or("", |(value, _)| value)
}

/// A figure in percent with two significant digits.
fn percent(value: f64) -> String {
    format!("{} %", crate::table::significant(100.0 * value, 2))
}

fn data_uri(image: &Image) -> Result<String> {
    let png = image.encode(Path::new("picture.png"), EXPOSURE)?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(png)))
}
