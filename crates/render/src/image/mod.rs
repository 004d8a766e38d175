//! Stage 6: the image, which is linear until it is written.

mod compare;
mod error_map;
mod files;

use std::path::{Path, PathBuf};

use glam::DVec3;
use thiserror::Error;

pub(crate) use self::compare::relative_scale;
pub use self::compare::{
    CompareError, LIGHT_RADIANCE, light_mask, rel_mse, rms_relative_difference, rmse,
};
pub use self::error_map::{error_map, relative_errors};
pub use self::files::IMAGE_ENDINGS;

/// The most pixels of a picture that is read or rendered, which bounds memory. A pixel takes 273 bytes at the
/// peak of [`crate::Progressive`] and 60 elsewhere (measured with 4 million), so this many take 18 GB.
pub const MAX_PIXELS: u64 = 1 << 26;

/// The reason why an image could not be made, read or written.
#[derive(Debug, Error)]
pub enum ImageError {
    /// The number of pixels is not that of the image.
    #[error("image of {width}x{height}: found {found} pixels, expected {}", u64::from(*width) * u64::from(*height))]
    Pixels {
        /// The number of pixels in a row.
        width: u32,
        /// The number of rows.
        height: u32,
        /// The number of pixels given.
        found: usize,
    },
    /// The ending of the file name is that of no known format.
    #[error("{}: found a name that ends in `{found}`, expected one of {}", path.display(), IMAGE_ENDINGS.join(", "))]
    Ending {
        /// The path of the file.
        path: PathBuf,
        /// The ending, without its point.
        found: String,
    },
    /// The file could not be read.
    #[error("{}: {message}; expected an OpenEXR picture with red, green and blue, as commands write where -o ends in .exr", path.display())]
    Read {
        /// The path of the file.
        path: PathBuf,
        /// The message of the system or of the decoder.
        message: String,
    },
    /// The picture could not be encoded in that format.
    #[error("{}: {message}", path.display())]
    Encode {
        /// The path of the file.
        path: PathBuf,
        /// The message of the encoder.
        message: String,
    },
}

/// Radiance in linear RGB, row 0 at the top.
#[derive(Debug, Clone, PartialEq)]
pub struct Image {
    width: u32,
    pixels: Vec<DVec3>,
}

impl Image {
    /// An image of `width * height` pixels, row by row from the top.
    ///
    /// # Errors
    /// [`ImageError::Pixels`] where there are more or fewer, or none.
    pub fn new(width: u32, height: u32, pixels: Vec<DVec3>) -> Result<Self, ImageError> {
        let expected = u64::from(width) * u64::from(height);
        if expected == 0 || pixels.len() as u64 != expected {
            return Err(ImageError::Pixels {
                width,
                height,
                found: pixels.len(),
            });
        }
        Ok(Self::from_rows(width, pixels))
    }

    /// `pixels` must be whole rows.
    pub(crate) fn from_rows(width: u32, pixels: Vec<DVec3>) -> Self {
        debug_assert_eq!(pixels.len() % width as usize, 0);
        Self { width, pixels }
    }

    /// The number of pixels in a row.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// The number of rows of pixels.
    #[must_use]
    pub fn height(&self) -> u32 {
        (self.pixels.len() / self.width as usize) as u32
    }

    /// The pixels, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[DVec3] {
        &self.pixels
    }

    /// The image as 8-bit sRGB, three bytes a pixel: radiance times `exposure`, clamped at 1, by the transfer
    /// curve of IEC 61966-2-1, rounded to nearest. NaN becomes black.
    #[must_use]
    pub fn to_srgb8(&self, exposure: f64) -> Vec<u8> {
        let channels = self
            .pixels
            .iter()
            .flat_map(|pixel| (*pixel * exposure).to_array());
        // `as` saturates and converts NaN to 0.
        channels
            .map(|c| (255.0 * srgb(c.clamp(0.0, 1.0))).round() as u8)
            .collect()
    }

    /// The bytes of a file in the format that the name's ending selects: `.png`, 8 bits of sRGB with the tone
    /// mapping of [`Self::to_srgb8`], or `.exr`, OpenEXR with three linear channels of f32, without
    /// `exposure`.
    ///
    /// # Errors
    /// [`ImageError::Ending`] or [`ImageError::Encode`], with the path.
    pub fn encode(&self, path: &Path, exposure: f64) -> Result<Vec<u8>, ImageError> {
        files::encode(self, path, exposure)
    }

    /// Reads an OpenEXR file as [`Self::encode`] writes it: the red, green and blue of the first layer,
    /// unchanged.
    ///
    /// # Errors
    /// [`ImageError::Read`] with the path.
    pub fn read_exr(path: &Path) -> Result<Self, ImageError> {
        files::read_exr(path)
    }
}

/// The sRGB transfer curve for 0 to 1.
fn srgb(linear: f64) -> f64 {
    if linear <= 0.003_130_8 {
        12.92 * linear
    } else {
        1.055 * linear.powf(1.0 / 2.4) - 0.055
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn two_pixels() -> Image {
        let pixels = vec![DVec3::new(0.0, 0.5, 1.0), DVec3::new(-1.0, 18.0, f64::NAN)];
        Image::new(2, 1, pixels).unwrap()
    }

    #[test]
    fn tone_mapping_is_srgb() {
        // 0.5 is 188 in sRGB; 0.25 is 137.
        assert_eq!(two_pixels().to_srgb8(1.0), [0, 188, 255, 0, 255, 0]);
        assert_eq!(two_pixels().to_srgb8(0.5), [0, 137, 188, 0, 255, 0]);
    }

    #[test]
    fn pixels_must_fill_the_image() {
        let error = Image::new(3, 2, vec![DVec3::ZERO; 5]).unwrap_err();
        assert_eq!(
            error.to_string(),
            "image of 3x2: found 5 pixels, expected 6"
        );
        assert!(Image::new(0, 2, vec![]).is_err());
    }
}
