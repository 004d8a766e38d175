//! The direction in which a surface faces where a photon hit it, in one byte.

use glam::DVec3;

/// Cells along an edge of the cube's sides.
const CELLS: usize = 4;

/// The direction in which the front faces where a photon hit. A flat surface has one facing, [`Self::FLAT`],
/// whose normal is exactly the surface's own. A curved surface has [`Self::COUNT`] facings, the cells of a
/// cube of directions: six sides of 4 x 4 cells, each 22.5 degrees along the middle of its side. Photons are
/// grouped by facing, so there must be few.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Facing(u8);

impl Facing {
    /// The one facing of a flat surface.
    pub const FLAT: Self = Self(0);

    /// The number of facings of a curved surface.
    pub const COUNT: usize = 6 * CELLS * CELLS;

    /// The largest angle between a cell's normal and a normal in the cell, in degrees. A cell is a spherical
    /// quadrilateral, since its edges lie in planes through the origin, so the largest angle is at one of its
    /// vertices: 16.403 degrees, in the cells at the vertices of the cube.
    pub const MAX_OFF_DEG: f64 = 16.41;

    /// The cell of a unit normal.
    #[must_use]
    pub fn of(normal: DVec3) -> Self {
        let axis = normal.abs().max_position();
        let major = normal[axis];
        let cell = |minor: f64| {
            // From -1 to 1 across the side, in equal angles.
            let place = (minor / major.abs()).atan() / std::f64::consts::FRAC_PI_4;
            (((place + 1.0) * 0.5 * CELLS as f64) as usize).min(CELLS - 1)
        };
        let side = 2 * axis + usize::from(major < 0.0);
        let [u, v] = [(axis + 1) % 3, (axis + 2) % 3].map(|minor| cell(normal[minor]));
        Self(((side * CELLS + u) * CELLS + v) as u8)
    }

    /// The unit normal at the middle of the cell, for a curved surface.
    #[must_use]
    pub fn normal(self) -> DVec3 {
        let cell = self.index();
        let [side, u, v] = [cell / (CELLS * CELLS), cell / CELLS % CELLS, cell % CELLS];
        let place = |cell: usize| {
            let place = (2.0 * cell as f64 + 1.0) / CELLS as f64 - 1.0;
            (place * std::f64::consts::FRAC_PI_4).tan()
        };
        let axis = side / 2;
        let mut normal = DVec3::ZERO;
        normal[axis] = if side.is_multiple_of(2) { 1.0 } else { -1.0 };
        normal[(axis + 1) % 3] = place(u);
        normal[(axis + 2) % 3] = place(v);
        normal.normalize()
    }

    /// The index of the facing among the surface's facings.
    pub(crate) fn index(self) -> usize {
        self.0.into()
    }

    /// The facing of that index among the surface's facings.
    pub(crate) fn at(index: u32) -> Self {
        Self(index as u8)
    }

    /// All facings of a curved surface.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        (0..Self::COUNT as u32).map(Self::at)
    }
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    fn off_deg(normal: DVec3) -> f64 {
        Facing::of(normal)
            .normal()
            .angle_between(normal)
            .to_degrees()
    }

    #[test]
    fn cells_hold_their_own_normals() {
        for facing in Facing::all() {
            assert_eq!(Facing::of(facing.normal()), facing);
        }
    }

    /// The four vertices of each cell of the side in direction +x; the other sides are rotations of it.
    #[test]
    fn vertices_of_cells_are_furthest_off() {
        let cells = CELLS * CELLS;
        let edge = |line: usize| {
            let place = 2.0 * line as f64 / CELLS as f64 - 1.0;
            (place * std::f64::consts::FRAC_PI_4).tan()
        };
        let worst = (0..cells)
            .flat_map(|cell| [(0, 0), (0, 1), (1, 0), (1, 1)].map(|corner| (cell, corner)))
            .map(|(cell, (du, dv))| {
                let vertex = DVec3::new(1.0, edge(cell / CELLS + du), edge(cell % CELLS + dv));
                let off = Facing(cell as u8).normal().angle_between(vertex);
                off.to_degrees()
            })
            .fold(0.0, f64::max);
        // The constant is the angle, rounded up to a hundredth of a degree.
        assert!(
            (Facing::MAX_OFF_DEG - 0.01..=Facing::MAX_OFF_DEG).contains(&worst),
            "{worst}"
        );
    }

    proptest! {
        #[test]
        fn no_normal_is_further_from_its_cells(n in prop::array::uniform3(-1.0..1.0f64)) {
            let normal = DVec3::from(n);
            prop_assume!(normal.length() > 1e-3);
            let off = off_deg(normal.normalize());
            prop_assert!(off <= Facing::MAX_OFF_DEG, "{off}");
        }

        /// Every vector has a cell, whatever its numbers.
        #[test]
        fn any_numbers_have_a_cell(n in prop::array::uniform3(prop::num::f64::ANY)) {
            prop_assert!(Facing::of(DVec3::from(n)).index() < Facing::COUNT);
        }
    }
}
