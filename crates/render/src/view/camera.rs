//! The pinhole camera of the reference renderer, by its formula.

use glam::{DMat4, DVec3, DVec4};

/// A ray: a half-line with origin and direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ray {
    /// The origin in scene units.
    pub origin: DVec3,
    /// The direction; of unit length in all rays that this crate makes.
    pub direction: DVec3,
}

/// The side of the image that the angle of view spans.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum FovAxis {
    /// The smaller side of the image.
    #[default]
    Smaller,
    /// The larger side of the image.
    Larger,
    /// The width of the image.
    X,
    /// The height of the image.
    Y,
}

impl FovAxis {
    /// The length of that side in a `w` x `h` image.
    fn side(self, w: f64, h: f64) -> f64 {
        match self {
            Self::Smaller => w.min(h),
            Self::Larger => w.max(h),
            Self::X => w,
            Self::Y => h,
        }
    }
}

/// A pinhole camera that looks along its local +z, with +x to the left and +y up in the image.
#[derive(Debug, Clone, PartialEq)]
pub struct Camera {
    to_world: DMat4,
    /// tan of half the angle of view.
    tan_half_fov: f64,
    fov_axis: FovAxis,
}

impl Camera {
    /// A camera whose smaller image side spans `fov_deg` degrees (over 0, below 180), placed by
    /// the rows of `to_world`, an affine matrix; `None` for other numbers.
    #[must_use]
    pub fn new(fov_deg: f64, to_world: [[f64; 4]; 4]) -> Option<Self> {
        let to_world = DMat4::from_cols_array_2d(&to_world).transpose();
        let affine = to_world.row(3) == DVec4::W;
        let invertible = to_world.determinant().abs() > 1e-12 && to_world.is_finite();
        let open = fov_deg > 0.0 && fov_deg < 180.0;
        (affine && invertible && open).then(|| Self {
            to_world,
            tan_half_fov: (fov_deg.to_radians() / 2.0).tan(),
            fov_axis: FovAxis::Smaller,
        })
    }

    /// A camera at `position` with `target` in the middle of its image and `up` upwards. Its angle of view is
    /// `fov_deg` degrees (over 0, below 180) on the side `fov_axis`. `None` where position and target are
    /// equal or in a line along `up`, or for other numbers.
    #[must_use]
    pub fn look_at(
        position: DVec3,
        target: DVec3,
        up: DVec3,
        fov_deg: f64,
        fov_axis: FovAxis,
    ) -> Option<Self> {
        let ahead = (target - position).try_normalize()?;
        let across = up.try_normalize()?.cross(ahead);
        // Below this limit the camera's rotation would depend on rounding.
        let left = (across.length() > 1e-6).then(|| across.normalize())?;
        let columns = [left, ahead.cross(left), ahead, position];
        let row = |axis: usize| columns.map(|column| column[axis]);
        let camera = Self::new(fov_deg, [row(0), row(1), row(2), [0.0, 0.0, 0.0, 1.0]])?;
        Some(Self { fov_axis, ..camera })
    }

    /// The position in scene units.
    pub(crate) fn position(&self) -> DVec3 {
        self.to_world.transform_point3(DVec3::ZERO)
    }

    /// The view ray through the point `(x, y)` of a `width` x `height` image, in pixels from
    /// the top left corner; the centre of the first pixel is (0.5, 0.5).
    ///
    /// Local direction = normalise((1 - 2x/W) t, (1 - 2y/H) t, 1) with t = tan(fov/2); where the
    /// image is not square, the coordinate of the side without the angle is scaled by the aspect ratio.
    #[must_use]
    pub fn ray(&self, x: f64, y: f64, width: u32, height: u32) -> Ray {
        let (w, h) = (f64::from(width), f64::from(height));
        let t = self.tan_half_fov / self.fov_axis.side(w, h);
        let local = DVec3::new((w - 2.0 * x) * t, (h - 2.0 * y) * t, 1.0);
        Ray {
            origin: self.position(),
            direction: self.to_world.transform_vector3(local).normalize(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::Scene;

    /// The reference's five check rays: image point, origin on the near plane, direction.
    const CHECK_RAYS: [([f64; 2], [f64; 3], [f64; 3]); 5] = [
        (
            [0.5, 0.5],
            [
                -0.000354353163857013,
                0.00035435313475318253,
                3.8990001678466797,
            ],
            [
                -0.31679967045783997,
                0.3167996406555176,
                -0.8940223455429077,
            ],
        ),
        (
            [127.5, 0.5],
            [
                0.0003543531056493521,
                0.00035435313475318253,
                3.8990001678466797,
            ],
            [0.3167996108531952, 0.3167996406555176, -0.8940223455429077],
        ),
        (
            [64.0, 64.0],
            [
                -2.980232380322967e-11,
                2.980232033378272e-11,
                3.8990001678466797,
            ],
            [
                -2.9802322387695312e-08,
                2.9802320611338473e-08,
                -0.9999999403953552,
            ],
        ),
        (
            [0.5, 127.5],
            [
                -0.000354353163857013,
                -0.00035435304744169116,
                3.8990001678466797,
            ],
            [
                -0.31679967045783997,
                -0.3167995810508728,
                -0.8940223455429077,
            ],
        ),
        (
            [100.5, 30.5],
            [
                0.00020368333207443357,
                0.0001869422703748569,
                3.8990001678466797,
            ],
            [
                0.19631868600845337,
                0.18018293380737305,
                -0.9638427495956421,
            ],
        ),
    ];

    #[test]
    fn agrees_with_the_reference_renderer() {
        let camera = Scene::built_in("cornell").unwrap().camera().clone();
        for ([x, y], origin, direction) in CHECK_RAYS {
            let ray = camera.ray(x, y, 128, 128);
            let error = (ray.direction - DVec3::from(direction)).abs();
            // The reference works in single precision, whose last place below 1 is 6e-8, and is
            // off by up to two of those.
            assert!(error.max_element() < 1.2e-7, "{x}, {y}: {error}");
            // Its rays start on the near plane, 0.001 ahead; ours at the pinhole.
            let near = ray.origin + ray.direction * (0.001 / -ray.direction.z);
            // 2.4e-7 is the last place of its 3.899.
            assert!(near.distance(origin.into()) < 2.4e-7, "{x}, {y}: {near}");
        }
    }

    #[test]
    fn a_wide_image_shows_more_at_the_sides() {
        let camera = Scene::built_in("cornell").unwrap().camera().clone();
        let square = camera.ray(0.0, 0.0, 64, 64).direction;
        let wide = camera.ray(32.0, 0.0, 128, 64).direction;
        // 1e-15: the same numbers up to the last bit.
        assert!(square.distance(wide) < 1e-15);
    }

    #[test]
    fn a_look_at_camera_sees_its_target_and_up() {
        let position = DVec3::new(1.0, 2.0, 3.0);
        let target = DVec3::new(4.0, 2.5, 1.0);
        let look = |axis| Camera::look_at(position, target, DVec3::Z, 60.0, axis).unwrap();
        let camera = look(FovAxis::Smaller);
        let ahead = camera.ray(32.0, 32.0, 64, 64);
        assert_eq!(ahead.origin, position);
        // 1e-15: a few roundings of numbers below 1.
        let towards = (target - position).normalize();
        assert!(ahead.direction.distance(towards) < 1e-15);
        let edge =
            |camera: &Camera, x, y| camera.ray(x, y, 128, 64).direction.angle_between(towards);
        let above = camera.ray(32.0, 0.0, 64, 64).direction;
        assert!(above.z > towards.z && above.angle_between(towards).to_degrees() - 30.0 < 1e-12);
        for (axis, x, y) in [
            (FovAxis::Smaller, 64.0, 0.0),
            (FovAxis::Y, 64.0, 0.0),
            (FovAxis::Larger, 0.0, 32.0),
            (FovAxis::X, 0.0, 32.0),
        ] {
            let angle = edge(&look(axis), x, y).to_degrees();
            assert!((angle - 30.0).abs() < 1e-12, "{axis:?}: {angle}");
        }
        let none = |target, up| Camera::look_at(position, target, up, 60.0, FovAxis::X).is_none();
        assert!(none(position, DVec3::Z) && none(position + DVec3::Z, DVec3::Z));
        assert!(none(target, DVec3::ZERO) && none(DVec3::NAN, DVec3::Z));
    }

    /// The reference's camera, of a matrix that mirrors nothing, is the one that looks along -z.
    #[test]
    fn a_look_at_camera_is_not_mirrored() {
        let position = DVec3::new(0.0, 0.0, 3.9);
        let camera = Camera::look_at(position, DVec3::ZERO, DVec3::Y, 39.3077, FovAxis::Smaller);
        let reference = Scene::built_in("cornell").unwrap().camera().clone();
        for ([x, y], ..) in CHECK_RAYS {
            let [ours, theirs] =
                [camera.as_ref().unwrap(), &reference].map(|c| c.ray(x, y, 128, 128));
            assert!(ours.direction.distance(theirs.direction) < 1.2e-7);
        }
    }

    #[test]
    fn impossible_cameras_are_refused() {
        let identity = DMat4::IDENTITY.to_cols_array_2d();
        assert!(Camera::new(39.0, identity).is_some());
        assert!(Camera::new(180.0, identity).is_none());
        assert!(Camera::new(f64::NAN, identity).is_none());
        assert!(Camera::new(39.0, [[0.0; 4]; 4]).is_none());
    }
}
