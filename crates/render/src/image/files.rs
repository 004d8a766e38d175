//! Image files: PNG for viewing, OpenEXR for computing.

use std::io::Cursor;
use std::path::Path;

use glam::DVec3;
use image::codecs::openexr::{OpenExrDecoder, OpenExrEncoder};
use image::codecs::png::PngEncoder;
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder};

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
    let (width, height) = (image.width, image.height());
    let mut bytes = Cursor::new(Vec::new());
    match format_of(path)? {
        Format::Png => {
            let pixels = image.to_srgb8(exposure);
            PngEncoder::new(&mut bytes).write_image(&pixels, width, height, ExtendedColorType::Rgb8)
        }
        Format::Exr => OpenExrEncoder::new(&mut bytes).write_image(
            &f32_bytes(image),
            width,
            height,
            ExtendedColorType::Rgb32F,
        ),
    }
    .map_err(|error| ImageError::Encode {
        path: path.to_owned(),
        message: error.to_string(),
    })?;
    Ok(bytes.into_inner())
}

/// Three numbers for each pixel, in native byte order.
fn f32_bytes(image: &Image) -> Vec<u8> {
    let channels = image.pixels.iter().flat_map(|pixel| pixel.to_array());
    channels.flat_map(|c| (c as f32).to_ne_bytes()).collect()
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
    let decoder = OpenExrDecoder::new(Cursor::new(bytes));
    let decoder = decoder.map_err(|e| error(e.to_string()))?;
    // The decoder allocates memory for as many pixels as the header states.
    let (width, height) = decoder.dimensions();
    let most = MAX_PIXELS.min(length * PIXELS_A_BYTE);
    if u64::from(width) * u64::from(height) > most {
        return Err(error(format!(
            "found {width}x{height} pixels, expected at most {most} in a file of {length} bytes"
        )));
    }
    let read = DynamicImage::from_decoder(decoder);
    let read = read.map_err(|e| error(e.to_string()))?.into_rgb32f();
    let (width, height) = read.dimensions();
    let pixels = read.pixels().map(|p| DVec3::from(p.0.map(f64::from)));
    let pixels: Vec<_> = pixels.collect();
    if pixels.iter().any(|pixel| !pixel.is_finite()) {
        return Err(error("a pixel is not finite".to_owned()));
    }
    Image::new(width, pixels.len() as u32 / width.max(1), pixels).map_err(|_| {
        let found = format!("{width}x{height} pixels");
        error(found)
    })
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
        let read = image::load_from_memory(&png).unwrap().into_rgb8();
        assert_eq!(read.dimensions(), (2, 1));
        assert_eq!(read.into_raw(), image.to_srgb8(1.0));
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
