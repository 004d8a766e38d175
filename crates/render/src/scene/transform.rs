//! The transform of a shape of a scene file: scaled, then turned, then moved.

use glam::{DMat3, DVec3};

/// A scale along the axes, a rotation and a translation, in this order.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Transform {
    /// The scale factor of each axis; all over 0, so that fronts stay fronts.
    pub scale: DVec3,
    /// The rotations about x, then y, then z, in degrees: counter-clockwise where the axis points at the
    /// viewer.
    pub rotate_deg: DVec3,
    /// The translation in scene units.
    pub translate: DVec3,
}

impl Default for Transform {
    fn default() -> Self {
        Self {
            scale: DVec3::ONE,
            rotate_deg: DVec3::ZERO,
            translate: DVec3::ZERO,
        }
    }
}

impl Transform {
    /// The function that transforms a point.
    pub fn of_point(&self) -> impl Fn(DVec3) -> DVec3 + use<> {
        let [x, y, z] = self.rotate_deg.to_array().map(f64::to_radians);
        let turn =
            DMat3::from_rotation_z(z) * DMat3::from_rotation_y(y) * DMat3::from_rotation_x(x);
        let Self {
            scale, translate, ..
        } = *self;
        // Points without a rotation keep their bits.
        let turned = self.rotate_deg != DVec3::ZERO;
        move |p| {
            let scaled = scale * p;
            let placed = if turned { turn * scaled } else { scaled };
            placed + translate
        }
    }

    /// The factor of all lengths; `None` where the axes have different factors.
    pub fn uniform_scale(&self) -> Option<f64> {
        let DVec3 { x, y, z } = self.scale;
        (x == y && y == z).then_some(x)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scaled_then_turned_then_moved() {
        let transform = Transform {
            scale: DVec3::new(2.0, 1.0, 1.0),
            rotate_deg: DVec3::new(0.0, 0.0, 90.0),
            translate: DVec3::new(0.0, 0.0, 3.0),
        };
        let place = transform.of_point();
        assert!(place(DVec3::X).distance(DVec3::new(0.0, 2.0, 3.0)) < 1e-15);
        let tumbled = Transform {
            rotate_deg: DVec3::new(90.0, 90.0, 0.0),
            ..Transform::default()
        };
        // The first rotation takes y to z, the second z to x.
        assert!(tumbled.of_point()(DVec3::Y).distance(DVec3::X) < 1e-15);
        assert_eq!(transform.uniform_scale(), None);
        assert_eq!(tumbled.uniform_scale(), Some(1.0));
    }
}
