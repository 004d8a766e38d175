//! Image files: PNG for viewing, OpenEXR for computing.

use std::io::Cursor;
use std::path::Path;

use exr::meta::header::Header;
use exr::prelude::{
    Image as ExrImage, IntegerBounds, ReadChannels as _, ReadLayers as _, SpecificChannels, Vec2,
    WritableImage as _,
};
use glam::DVec3;

use super::{Image, ImageError, MAX_PIXELS};

/// The legal endings of the name of a picture's file.
pub const IMAGE_ENDINGS: [&str; 2] = [".png", ".exr"];

#[derive(Clone, Copy)]
enum Format {
    Png,
    Exr,
}

fn format_of(path: &Path) -> Result<Format, ImageError> {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    match ending.to_ascii_lowercase().as_str() {
        "png" => Ok(Format::Png),
        "exr" => Ok(Format::Exr),
        _ => Err(ImageError::Ending {
            path: path.to_owned(),
            found: ending.into_owned(),
        }),
    }
}

pub(super) fn encode(image: &Image, path: &Path, exposure: f64) -> Result<Vec<u8>, ImageError> {
    match format_of(path)? {
        Format::Png => {
            let pixels = image.to_srgb8(exposure);
            encode_png(image.width, image.height(), &pixels).map_err(|e| e.to_string())
        }
        Format::Exr => encode_exr(image).map_err(|e| e.to_string()),
    }
    .map_err(|message| ImageError::Encode {
        path: path.to_owned(),
        message,
    })
}

/// A PNG of 8-bit sRGB pixels, three bytes each, row by row from the top.
pub(super) fn encode_png(
    width: u32,
    height: u32,
    pixels: &[u8],
) -> Result<Vec<u8>, png::EncodingError> {
    let mut bytes = Vec::new();
    let mut encoder = png::Encoder::new(&mut bytes, width, height);
    encoder.set_color(png::ColorType::Rgb);
    encoder.set_compression(png::Compression::Fast);
    encoder.write_header()?.write_image_data(pixels)?;
    Ok(bytes)
}

/// An OpenEXR of one layer with channels R, G and B of 32-bit floats, run-length coded.
fn encode_exr(image: &Image) -> exr::error::Result<Vec<u8>> {
    let size = Vec2(image.width as usize, image.height() as usize);
    let channels = SpecificChannels::rgb(|pixel: Vec2<usize>| {
        let [r, g, b] = image.pixels[pixel.flat_index_for_size(size)].to_array();
        (r as f32, g as f32, b as f32)
    });
    let mut bytes = Cursor::new(Vec::new());
    ExrImage::from_channels(size, channels)
        .write()
        .to_buffered(&mut bytes)?;
    Ok(bytes.into_inner())
}

/// The most pixels for each byte of a file. Of OpenEXR's compressions deflate shrinks most, at most 1032
/// times, and a pixel has at least three numbers of two bytes.
const PIXELS_A_BYTE: u64 = 1032 / 6;

pub(super) fn read_exr(path: &Path) -> Result<Image, ImageError> {
    let error = |message: String| ImageError::Read {
        path: path.to_owned(),
        message,
    };
    let bytes = std::fs::read(path).map_err(|e| error(e.to_string()))?;
    let length = bytes.len() as u64;
    let reader = exr::block::read(Cursor::new(bytes), false).map_err(|e| error(e.to_string()))?;
    let header = reader.headers().iter().find(|header| has_colours(header));
    let header = header.ok_or_else(|| {
        error("found no flat layer with the channels R, G and B, expected one".to_owned())
    })?;
    let shown = header.shared_attributes.display_window;
    let offset = header.own_attributes.layer_position - shown.position;
    let Vec2(width, height) = shown.size;
    // The reader allocates memory for as many pixels as the header states.
    let most = MAX_PIXELS.min(length * PIXELS_A_BYTE);
    if (width as u64).saturating_mul(height as u64) > most {
        return Err(error(format!(
            "found {width}x{height} pixels, expected at most {most} in a file of {length} bytes"
        )));
    }
    let read = exr::prelude::read()
        .no_deep_data()
        .largest_resolution_level()
        .rgb_channels(
            move |_, _| vec![DVec3::ZERO; width * height],
            move |pixels, place, (r, g, b): (f32, f32, f32)| {
                if let Some(place) = place_shown(place.to_i32() + offset, shown) {
                    pixels[place] = DVec3::new(r.into(), g.into(), b.into());
                }
            },
        )
        .first_valid_layer()
        .all_attributes()
        .from_chunks(reader)
        .map_err(|e| error(e.to_string()))?;
    let pixels = read.layer_data.channel_data.pixels;
    if pixels.iter().any(|pixel| !pixel.is_finite()) {
        return Err(error("a pixel is not finite".to_owned()));
    }
    Image::new(width as u32, height as u32, pixels)
        .map_err(|_| error(format!("{width}x{height} pixels")))
}

/// Whether a layer is flat and has the three channels of a picture.
fn has_colours(header: &Header) -> bool {
    let has = |name: &str| {
        header
            .channels
            .find_index_of_channel(&name.into())
            .is_some()
    };
    !header.deep && ["R", "G", "B"].into_iter().all(has)
}

/// The index of a pixel in the window that is shown; a file may hold pixels beside it, which have none.
fn place_shown(place: Vec2<i32>, shown: IntegerBounds) -> Option<usize> {
    let Vec2(x, y) = place;
    let Vec2(width, height) = shown.size;
    let (x, y) = (usize::try_from(x).ok()?, usize::try_from(y).ok()?);
    (x < width && y < height).then(|| y * width + x)
}

/// The width, the height and the pixels of an 8-bit RGB PNG.
#[cfg(test)]
pub(super) fn decode_png(bytes: &[u8]) -> (u32, u32, Vec<u8>) {
    let mut reader = png::Decoder::new(Cursor::new(bytes)).read_info().unwrap();
    let mut pixels = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut pixels).unwrap();
    assert_eq!(frame.color_type, png::ColorType::Rgb);
    (frame.width, frame.height, pixels)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_pixels(last: f64) -> Image {
        let pixels = vec![DVec3::new(0.0, 0.5, 1.0), DVec3::new(-1.0, 18.1, last)];
        Image::new(2, 1, pixels).unwrap()
    }

    fn write(image: &Image, path: &Path) {
        std::fs::write(path, image.encode(path, 3.0).unwrap()).unwrap();
    }

    #[test]
    fn a_png_reads_back() {
        let image = two_pixels(f64::NAN);
        let png = image.encode(Path::new("two.png"), 1.0).unwrap();
        assert_eq!(decode_png(&png), (2, 1, image.to_srgb8(1.0)));
    }

    #[test]
    fn a_written_exr_reads_back_to_single_precision() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("two.EXR");
        let image = two_pixels(1e-9);
        write(&image, &path);
        let read = Image::read_exr(&path).unwrap();
        let rounded =
            |image: &Image| -> Vec<_> { image.pixels().iter().map(|p| p.as_vec3()).collect() };
        assert_eq!(rounded(&read), rounded(&image));
        assert_eq!((read.width(), read.height()), (2, 1));
    }

    #[test]
    fn what_is_no_picture_is_an_error_with_the_path() {
        let folder = tempfile::tempdir().unwrap();
        let at = |name: &str| folder.path().join(name);
        let error = two_pixels(0.0).encode(&at("two.jpg"), 1.0).unwrap_err();
        assert!(
            error
                .to_string()
                .contains("`jpg`, expected one of .png, .exr"),
            "{error}"
        );
        assert!(Image::read_exr(&at("none.exr")).is_err());
        std::fs::write(at("text.exr"), "no picture").unwrap();
        let error = Image::read_exr(&at("text.exr")).unwrap_err();
        assert!(error.to_string().contains("text.exr"), "{error}");
        write(&two_pixels(f64::NAN), &at("nan.exr"));
        let error = Image::read_exr(&at("nan.exr")).unwrap_err();
        assert!(error.to_string().contains("not finite"), "{error}");
        // A header may state anything: here 2^20 pixels, in tiles of 64.
        write(&two_pixels(0.0), &at("huge.exr"));
        let mut bytes = std::fs::read(at("huge.exr")).unwrap();
        for (name, offset, value) in [
            (&b"chunkCount\0int\0"[..], 0, 1_i32 << 14),
            (b"dataWindow\0box2i\0", 8, (1 << 20) - 1),
            (b"displayWindow\0box2i\0", 8, (1 << 20) - 1),
        ] {
            let start = bytes.windows(name.len()).position(|bytes| bytes == name);
            // The size of the attribute comes before its value.
            let place = start.unwrap() + name.len() + 4 + offset;
            bytes[place..place + 4].copy_from_slice(&value.to_le_bytes());
        }
        std::fs::write(at("huge.exr"), bytes).unwrap();
        let error = Image::read_exr(&at("huge.exr")).unwrap_err().to_string();
        assert!(
            error.contains("1048576x1 pixels, expected at most"),
            "{error}"
        );
    }
}
