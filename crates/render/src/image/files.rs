//! Images in files: PNG to look at, OpenEXR to compute with.

use std::io::{BufWriter, Write};
use std::path::Path;

use glam::DVec3;
use image::codecs::openexr::{OpenExrDecoder, OpenExrEncoder};
use image::codecs::png::PngEncoder;
use image::{DynamicImage, ExtendedColorType, ImageDecoder, ImageEncoder};
use tempfile::NamedTempFile;

use super::{Image, ImageError, MAX_PIXELS};

/// What the name of a picture's file may end in.
pub const IMAGE_ENDINGS: [&str; 2] = [".png", ".exr"];

#[derive(Clone, Copy)]
enum Format {
    Png,
    Exr,
}

/// Whether a picture can be written there, as far as the name says.
///
/// # Errors
/// [`ImageError::Ending`].
pub fn check_image_path(path: &Path) -> Result<(), ImageError> {
    format_of(path).map(|_| ())
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

pub(super) fn write(image: &Image, path: &Path, exposure: f64) -> Result<(), ImageError> {
    let format = format_of(path)?;
    write_beside(path, |writer| match format {
        Format::Png => PngEncoder::new(writer).write_image(
            &image.to_srgb8(exposure),
            image.width,
            image.height(),
            ExtendedColorType::Rgb8,
        ),
        Format::Exr => OpenExrEncoder::new(writer).write_image(
            &f32_bytes(image),
            image.width,
            image.height(),
            ExtendedColorType::Rgb32F,
        ),
    })
    .map_err(|source| ImageError::Write {
        path: path.to_owned(),
        source,
    })
}

/// Three numbers a pixel, in this machine's order of bytes.
fn f32_bytes(image: &Image) -> Vec<u8> {
    let channels = image.pixels.iter().flat_map(|pixel| pixel.to_array());
    channels.flat_map(|c| (c as f32).to_ne_bytes()).collect()
}

fn write_beside(
    path: &Path,
    encode: impl FnOnce(&mut BufWriter<NamedTempFile>) -> image::ImageResult<()>,
) -> std::io::Result<()> {
    let folder = path.parent().filter(|p| !p.as_os_str().is_empty());
    let file = NamedTempFile::new_in(folder.unwrap_or(Path::new(".")))?;
    let mut writer = BufWriter::new(file);
    encode(&mut writer).map_err(cause)?;
    writer.flush()?;
    let file = writer.into_inner().map_err(|error| error.into_error())?;
    make_readable(file.path())?;
    file.persist(path).map_err(|error| error.error)?;
    Ok(())
}

/// What an encoder failed of: OpenEXR's calls an error of the system one of its decoder.
fn cause(error: image::ImageError) -> std::io::Error {
    let mut cause: &dyn std::error::Error = &error;
    while let Some(source) = cause.source() {
        cause = source;
    }
    std::io::Error::other(cause.to_string())
}

/// Temporary files are the owner's alone; a picture is not a secret.
#[cfg(unix)]
fn make_readable(path: &Path) -> std::io::Result<()> {
    use std::os::unix::fs::PermissionsExt;
    std::fs::set_permissions(path, std::fs::Permissions::from_mode(0o644))
}

#[cfg(not(unix))]
fn make_readable(_path: &Path) -> std::io::Result<()> {
    Ok(())
}

/// No file has more pixels: of OpenEXR's compressions deflate shrinks most, at most 1032 times, and a pixel is
/// three numbers of two bytes at least.
const PIXELS_A_BYTE: u64 = 1032 / 6;

pub(super) fn read_exr(path: &Path) -> Result<Image, ImageError> {
    let error = |message: String| ImageError::Read {
        path: path.to_owned(),
        message,
    };
    let bytes = std::fs::read(path).map_err(|e| error(e.to_string()))?;
    let length = bytes.len() as u64;
    let decoder = OpenExrDecoder::new(std::io::Cursor::new(bytes));
    let decoder = decoder.map_err(|e| error(e.to_string()))?;
    // The decoder takes memory for as many pixels as the file says that it has.
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

    #[test]
    fn a_written_png_reads_back_and_nothing_else_is_left() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("two.png");
        let image = two_pixels(f64::NAN);
        image.write(&path, 1.0).unwrap();
        let read = image::open(&path).unwrap().into_rgb8();
        assert_eq!(read.dimensions(), (2, 1));
        assert_eq!(read.into_raw(), image.to_srgb8(1.0));
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 1);
    }

    #[test]
    fn a_written_exr_reads_back_to_single_precision() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("two.EXR");
        let image = two_pixels(1e-9);
        image.write(&path, 3.0).unwrap();
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
        let error = two_pixels(0.0).write(&at("none/two.png"), 1.0).unwrap_err();
        assert!(error.to_string().contains("two.png"), "{error}");
        let error = two_pixels(0.0).write(&at("two.jpg"), 1.0).unwrap_err();
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
        two_pixels(f64::NAN).write(&at("nan.exr"), 1.0).unwrap();
        let error = Image::read_exr(&at("nan.exr")).unwrap_err();
        assert!(error.to_string().contains("not finite"), "{error}");
        // A header may say anything: here that there are 2^20 pixels, in tiles of 64.
        two_pixels(0.0).write(&at("huge.exr"), 1.0).unwrap();
        let mut bytes = std::fs::read(at("huge.exr")).unwrap();
        for (name, offset, value) in [
            (&b"chunkCount\0int\0"[..], 0, 1_i32 << 14),
            (b"dataWindow\0box2i\0", 8, (1 << 20) - 1),
            (b"displayWindow\0box2i\0", 8, (1 << 20) - 1),
        ] {
            let start = bytes.windows(name.len()).position(|bytes| bytes == name);
            // The attribute's size stands before its value.
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

    #[test]
    fn an_encoder_that_fails_is_told_by_what_the_system_said() {
        use image::error::{DecodingError, ImageFormatHint};

        let full = std::io::Error::from(std::io::ErrorKind::StorageFull);
        let said = full.to_string();
        let hint = ImageFormatHint::Exact(image::ImageFormat::OpenExr);
        let error = image::ImageError::Decoding(DecodingError::new(hint, full));
        assert!(error.to_string().contains("decoding"), "{error}");
        assert_eq!(cause(error).to_string(), said);
    }
}
