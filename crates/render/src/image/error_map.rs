//! Draws errors as colours, with a legend.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use glam::DVec3;

use super::files::encode_png;

/// The smallest and the largest error with a colour of their own.
const SCALE: [f64; 2] = [1e-3, 1.0];
/// The errors that the legend names, on a logarithmic scale.
const NAMED: [f64; 7] = [0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0];
/// The colour of pixels that are left out.
const LEFT_OUT: [u8; 3] = [128, 128, 128];
/// The least length of the picture's longer side in the map, in pixels of the page.
const SIDE: u32 = 512;
const MARGIN: u32 = 16;
const TITLE: u32 = 28;
const BAR: u32 = 20;
const LABELS: u32 = 110;

/// Draws a picture of relative errors, row by row, `width` in a row. The result is an SVG page with title and
/// legend, in colours of the inferno palette by the error's logarithm, from 0.1 % to 100 %. A pixel without
/// an error, which is left out, is grey.
///
/// Of a ragged picture only whole rows are drawn; an empty picture has none.
#[must_use]
pub fn error_map(title: &str, width: u32, errors: &[Option<f64>]) -> String {
    let height = errors.len() as u32 / width.max(1);
    let zoom = (SIDE / width.max(height).max(1)).max(1);
    let (w, h) = (zoom * width, zoom * height);
    let colours = errors
        .iter()
        .flat_map(|error| error.map_or(LEFT_OUT, colour));
    let pixels: Vec<u8> = colours.take(3 * (width * height) as usize).collect();
    let left = MARGIN + w + MARGIN;
    let (page_width, page_height) = (left + BAR + LABELS, TITLE + h.max(200) + MARGIN);
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{page_width}\" height=\"{page_height}\" \
         font-family=\"sans-serif\" font-size=\"12\" role=\"img\">\n\
         <title>{0}</title>\n\
         <desc>A picture of relative errors, {width} x {height} pixels, dark where they are small; the legend is from \
         0.1 % to 100 %.</desc>\n\
         <rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n\
         <text x=\"{MARGIN}\" y=\"19\" font-size=\"14\">{0}</text>\n\
         <image x=\"{MARGIN}\" y=\"{TITLE}\" width=\"{w}\" height=\"{h}\" \
         style=\"image-rendering:pixelated\" href=\"data:image/png;base64,{1}\"/>\n",
        escaped(title),
        BASE64_STANDARD.encode(png(width, height, &pixels)),
    );
    svg += &legend(left, h.max(200), errors.contains(&None));
    svg + "</svg>\n"
}

/// The relative errors of the luminance, |a - b| over sqrt(b^2 + 1e-4) as in relMSE; `None` where the mask
/// leaves a pixel out. The result is as long as the shortest of the three.
#[must_use]
pub fn relative_errors(image: &[DVec3], reference: &[DVec3], mask: &[bool]) -> Vec<Option<f64>> {
    let pairs = image.iter().zip(reference).zip(mask);
    let error = |((a, b), kept): ((&DVec3, &DVec3), &bool)| {
        let [a, b] = [a, b].map(|rgb| crate::metrics::luminance(*rgb));
        kept.then(|| (a - b).abs() / super::compare::relative_scale(b))
    };
    pairs.map(error).collect()
}

/// The position of an error on the scale, 0 to 1.
fn place(error: f64) -> f64 {
    let [low, high] = SCALE.map(f64::ln);
    // A NaN counts as the largest error.
    match error.is_nan() {
        true => 1.0,
        false => ((error.ln() - low) / (high - low)).clamp(0.0, 1.0),
    }
}

fn colour(error: f64) -> [u8; 3] {
    colorous::INFERNO.eval_continuous(place(error)).as_array()
}

fn legend(left: u32, height: u32, left_out: bool) -> String {
    /// The number of strips of the legend's bar, finer than an eye sees.
    const STRIPS: u32 = 64;
    let [low, high] = SCALE;
    let y_of = |place: f64| f64::from(TITLE) + (1.0 - place) * f64::from(height - 40);
    let mut svg = String::new();
    for strip in 0..STRIPS {
        let [below, above] = [strip, strip + 1].map(|s| f64::from(s) / f64::from(STRIPS));
        let error = low * (high / low).powf(0.5 * (below + above));
        let [r, g, b] = colour(error);
        let (y, tall) = (y_of(above), y_of(below) - y_of(above) + 0.5);
        svg += &format!(
            "<rect x=\"{left}\" y=\"{y:.2}\" width=\"{BAR}\" height=\"{tall:.2}\" fill=\"rgb({r},{g},{b})\"/>\n"
        );
    }
    let x = left + BAR + 6;
    for error in NAMED {
        let y = y_of(place(error)) + 4.0;
        svg += &format!("<text x=\"{x}\" y=\"{y:.2}\">{} %</text>\n", 100.0 * error);
    }
    if left_out {
        let (y, text) = (TITLE + height - 18, TITLE + height - 6);
        let [r, g, b] = LEFT_OUT;
        svg += &format!(
            "<rect x=\"{left}\" y=\"{y}\" width=\"{BAR}\" height=\"14\" fill=\"rgb({r},{g},{b})\"/>\n\
             <text x=\"{x}\" y=\"{text}\">left out</text>\n"
        );
    }
    svg
}

fn escaped(text: &str) -> String {
    let text = text.replace('&', "&amp;").replace('<', "&lt;");
    text.replace('>', "&gt;")
}

fn png(width: u32, height: u32, pixels: &[u8]) -> Vec<u8> {
    if pixels.is_empty() {
        return Vec::new();
    }
    encode_png(width, height, pixels).expect("memory takes all that is written")
}

#[cfg(test)]
mod tests {
    use super::super::files::decode_png;
    use super::*;

    #[test]
    fn colours_rise_from_dark_to_light_over_three_decades() {
        let sum = |error| colour(error).iter().map(|c| u32::from(*c)).sum::<u32>();
        assert_eq!(colour(0.0), colour(SCALE[0]));
        assert_eq!(colour(7.0), colour(SCALE[1]));
        assert_eq!(colour(f64::NAN), colour(SCALE[1]));
        let named = NAMED.map(sum);
        assert!(named.windows(2).all(|pair| pair[0] < pair[1]), "{named:?}");
    }

    #[test]
    fn errors_are_relative_to_the_reference_and_masked() {
        let [image, reference] = [1.1, 1.0].map(|l| [DVec3::splat(l); 2]);
        let found = relative_errors(&image, &reference, &[true, false]);
        // 1e-4 is added to the square of 1.
        assert!((found[0].unwrap() - 0.1).abs() < 1e-5);
        assert_eq!(found[1], None);
    }

    #[test]
    fn the_map_holds_its_picture_and_a_legend() {
        let errors = [Some(0.0), Some(0.05), None, Some(2.0)];
        let svg = error_map("a < b & c", 2, &errors);
        for text in [
            "<title>a &lt; b &amp; c</title>",
            "font-size=\"14\">a &lt; b &amp; c<",
            ">0.1 %<",
            ">100 %<",
            "left out",
            "</svg>",
        ] {
            assert!(svg.contains(text), "{text}: {svg}");
        }
        let start = svg.find("base64,").unwrap() + 7;
        let end = start + svg[start..].find('"').unwrap();
        let png = BASE64_STANDARD.decode(&svg[start..end]).unwrap();
        let (width, height, pixels) = decode_png(&png);
        assert_eq!((width, height), (2, 2));
        assert_eq!(pixels[6..9], LEFT_OUT);
        assert_eq!(pixels[9..12], colour(1.0));
        assert!(!error_map("", 2, &errors[..2]).contains("left out"));
    }

    #[test]
    fn a_map_of_nothing_is_an_empty_page() {
        assert!(error_map("none", 0, &[]).contains("</svg>"));
    }
}
