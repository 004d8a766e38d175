//! Colours that a computation shows to be distinguishable for the colour-blind.

use plotters::style::{RGBColor, WHITE};

/// The colour of the most important item of a picture: a front, a bound.
pub const FIRST: RGBColor = RGBColor(213, 94, 0);
/// The colour of the second item.
pub const SECOND: RGBColor = RGBColor(0, 90, 170);
/// The colour of the third item.
pub const THIRD: RGBColor = RGBColor(86, 180, 233);
/// The colour of lines and texts.
pub const INK: RGBColor = RGBColor(30, 30, 30);
/// The colour of unimportant items.
pub const FAINT: RGBColor = RGBColor(165, 165, 165);

/// The colours of a page.
pub struct Set {
    /// The background.
    pub paper: RGBColor,
    /// Lines and texts.
    pub ink: RGBColor,
    /// Unimportant items.
    pub faint: RGBColor,
    /// The most important item.
    pub first: RGBColor,
    /// The second item, and links.
    pub second: RGBColor,
    /// The third item.
    pub third: RGBColor,
}

/// The colours of a light page.
pub const LIGHT: Set = Set {
    paper: WHITE,
    ink: INK,
    faint: FAINT,
    first: FIRST,
    second: SECOND,
    third: THIRD,
};

/// The colours of a dark page.
pub const DARK: Set = Set {
    paper: RGBColor(18, 20, 24),
    ink: RGBColor(240, 240, 240),
    faint: RGBColor(92, 96, 102),
    first: RGBColor(255, 140, 40),
    second: RGBColor(70, 140, 255),
    third: RGBColor(130, 190, 245),
};

/// The colour as CSS and SVG write it.
pub fn css(RGBColor(red, green, blue): RGBColor) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

#[cfg(test)]
mod tests {

    use super::*;

    type Matrix = [[f64; 3]; 3];

    const IDENTITY: Matrix = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    /// The linear red, green and blue that an eye without the cones for long waves, or without those for
    /// middle ones, sees: Machado, Oliveira, Fernandes, "A Physiologically-based Model for Simulation of
    /// Color Vision Deficiency" (2009), severity 1.
    const PROTANOPIA: Matrix = [
        [0.152_286, 1.052_583, -0.204_868],
        [0.114_503, 0.786_281, 0.099_216],
        [-0.003_882, -0.048_116, 1.051_998],
    ];
    const DEUTERANOPIA: Matrix = [
        [0.367_322, 0.860_646, -0.227_968],
        [0.280_085, 0.672_501, 0.047_413],
        [-0.011_820, 0.042_940, 0.968_881],
    ];
    /// The matrix from linear sRGB to CIE XYZ; white is the sum of each row.
    const TO_XYZ: Matrix = [
        [0.412_456, 0.357_576, 0.180_438],
        [0.212_673, 0.715_152, 0.072_175],
        [0.019_334, 0.119_192, 0.950_304],
    ];

    /// The smallest distance of two colours. Ten times the just visible difference of adjacent areas is 23;
    /// lines of two pixels need more. Our former red and green were 18 and 28 apart, and were confused.
    const APART: f64 = 30.0;

    fn times(matrix: &Matrix, vector: [f64; 3]) -> [f64; 3] {
        matrix.map(|row| row.iter().zip(vector).map(|(a, b)| a * b).sum())
    }

    fn linear(channel: u8) -> f64 {
        let c = f64::from(channel) / 255.0;
        match c <= 0.040_45 {
            true => c / 12.92,
            false => ((c + 0.055) / 1.055).powf(2.4),
        }
    }

    /// The colour as such an eye sees it, in CIE L*a*b*.
    fn lab(eye: &Matrix, RGBColor(r, g, b): RGBColor) -> [f64; 3] {
        let seen = times(eye, [r, g, b].map(linear)).map(|c| c.clamp(0.0, 1.0));
        let (xyz, white) = (times(&TO_XYZ, seen), times(&TO_XYZ, [1.0; 3]));
        let root = |i: usize| {
            let t: f64 = xyz[i] / white[i];
            let corner = 6.0_f64 / 29.0;
            match t > corner.powi(3) {
                true => t.cbrt(),
                false => t / (3.0 * corner.powi(2)) + 4.0 / 29.0,
            }
        };
        let [x, y, z] = [0, 1, 2].map(root);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    /// The smallest distance of two colours over all eyes.
    fn distance(a: RGBColor, b: RGBColor) -> f64 {
        let eyes = [IDENTITY, PROTANOPIA, DEUTERANOPIA];
        let distances = eyes.iter().map(|eye| {
            let [a, b] = [a, b].map(|colour| lab(eye, colour));
            let squares = a.iter().zip(b).map(|(a, b)| (a - b).powi(2));
            squares.sum::<f64>().sqrt()
        });
        distances.fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn all_colours_are_apart_for_every_eye() {
        for set in [LIGHT, DARK] {
            let Set {
                paper,
                ink,
                faint,
                first,
                second,
                third,
            } = set;
            are_apart(&[first, second, third, ink, faint, paper]);
        }
    }

    fn are_apart(colours: &[RGBColor]) {
        for (index, a) in colours.iter().enumerate() {
            for b in &colours[..index] {
                assert!(
                    distance(*a, *b) > APART,
                    "{a:?} {b:?}: {}",
                    distance(*a, *b)
                );
            }
        }
    }

    /// The control: the former red and green, (190, 60, 40) and (60, 140, 90).
    #[test]
    fn red_and_green_alike_for_deuteranopes_are_too_near() {
        let (red, green) = (RGBColor(190, 60, 40), RGBColor(60, 140, 90));
        assert!(distance(red, green) < APART);
        // For other eyes the two are far apart.
        let [red, green] = [red, green].map(|colour| lab(&IDENTITY, colour));
        assert!((red[1] - green[1]).abs() > APART);
    }
}
