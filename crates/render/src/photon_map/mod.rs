//! Stage 3, the photon map: photons sorted by block, and within a block by surface and by facing.
//!
//! A block is a cell of a uniform grid whose edge is the search radius or somewhat more, so that all photons
//! in range of a query lie in the 27 blocks around it. Photons are sorted by (block z, y, x, surface,
//! facing). A flat surface has one facing, and a *run* is the slice of one facing of one surface in one
//! block. Only blocks with photons take memory. The three blocks of a row are adjacent in the order, so a
//! query looks up three slices of the grid and a few rows in each.

use std::ops::Range;

use glam::{DVec3, I64Vec3};
use photoncube_model::{INDEX_BITS, INDEX_MASK, Rows};
use rayon::prelude::*;

use self::error::{check_edge, check_radius, outside};
use self::groups::Groups;
use self::sort::Unsorted;
use crate::scene::Scene;
use crate::trace::Photon;
use crate::view::Front;

mod error;
mod groups;
mod sort;
mod stored;

pub use self::error::MapError;
pub use self::stored::StoredPhoton;

/// The photons of one facing of one surface in one block, a slice of the map's order.
#[derive(Debug, Clone, PartialEq, Eq)]
struct Run {
    block: u64,
    group: u32,
    photons: Range<u32>,
}

impl Run {
    /// The index of the block on each axis.
    fn block(&self) -> [u64; 3] {
        [0, 1, 2].map(|axis| self.block >> (axis * INDEX_BITS) & INDEX_MASK)
    }

    fn photons(&self) -> Range<usize> {
        self.photons.start as usize..self.photons.end as usize
    }
}

/// One run that a query gathers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Candidates {
    /// The offset of the run's block in the 27 blocks around the query, 0 to 2 on every axis; the query's own
    /// block is `[1, 1, 1]`.
    pub offset: [u32; 3],
    /// The index of the run in [`PhotonMap::runs`].
    pub run: usize,
    /// The photons of the run, as indices into [`PhotonMap::photons`].
    pub photons: Range<usize>,
}

/// Photons sorted into blocks, for one search radius.
///
/// # Which photons a query gathers
/// The estimate treats the photons near a query as photons *at* it. That is wrong for photons on another
/// sheet: the far side of a thin wall, or the next wall across a corner. So a photon is a candidate only
/// where the cosine between its surface's normal and the query's exceeds [`Self::MIN_FACING_COSINE`]. Photons
/// are sorted by surface within their block, so the selection precedes the stream to the processor: an
/// excluded photon never counts as a photon test.
///
/// A photon of another surface is a candidate only where the two surfaces are joined: where they touch along an edge, or are joined
/// by surfaces smaller than the search sphere. So no light leaks between two floors in one plane behind a wall, or onto a shelf
/// from the wall behind it.
///
/// On a curved surface (a sphere, a mesh) the photon's normal is rounded to one of 96, its [`Facing`], by
/// 16.4 degrees at most. So the rule's 60 degrees are 43.6 to 76.4 there: a photon whose normal is within 43.6
/// degrees of the query's is always a candidate, one beyond 76.4 never.
///
/// [`Facing`]: crate::Facing
///
/// On the Cornell box (a million photons, radius 0.045) gathering every photon in range gives
/// a relMSE of 0.15 against the path-traced reference, this rule 0.011; a
/// cosine of 0.999 gives the same as 0.5 there.
///
/// Not modelled: on one surface light leaks under a wall that stands on it, since both sides are one surface; and at the border of a surface the disc of
/// area pi r^2 reaches over it, which darkens a strip of width r.
///
/// On a curved surface the photons in range lie on a patch that is not that disc. With the principal
/// curvatures k1, k2 its area is pi r^2 (1 + (k1 - k2)^2 r^2 / 32), up to higher powers of r (Pottmann et al.,
/// "Integral invariants for robust geometry processing", 2009), and the estimate is brighter by as much: on a
/// sphere not at all, exactly, until the rule above cuts its cap (from r = 0.75 R up); on a cylinder by
/// (r / R)^2 / 32. Across an edge of a mesh the patch is bent, or cut where its sides part by more than the
/// rule's angle, which darkens as a border does.
#[derive(Debug, Clone, PartialEq)]
pub struct PhotonMap {
    radius: f64,
    /// The edge of the blocks, in scene units.
    edge: f64,
    /// The scene's lowest corner, which is the middle of block (0, 0, 0). So the outermost walls do not run
    /// along the border of blocks, where rounding would spread them over two.
    low: DVec3,
    photons: Vec<StoredPhoton>,
    runs: Vec<Run>,
    rows: Rows,
    groups: Groups,
}

impl PhotonMap {
    /// The cosine between the normals of photon and query that a candidate must exceed: 60 degrees keep the
    /// facets of a curved surface together and separate the walls of a corner.
    pub const MIN_FACING_COSINE: f64 = 0.5;

    /// The search radius at which a query gathers about `in_range` of the `photons` stored on the scene's
    /// surfaces: sqrt(in_range A / (pi photons)) in scene units, with A the area of all diffuse fronts. 200
    /// in range give a noise of about 7 %. For any count over 0.
    #[must_use]
    pub fn radius_for(scene: &Scene, photons: u64, in_range: f64) -> f64 {
        let diffuse = scene.surfaces().iter().filter(|s| !s.is_specular());
        let area: f64 = diffuse.map(|s| s.geometry.area()).sum();
        (in_range * area / (std::f64::consts::PI * photons as f64)).sqrt()
    }

    /// The map of `photons`, all on surfaces of `scene`, for the search radius `radius` in scene units, which
    /// is also the edge of the blocks.
    ///
    /// # Errors
    /// [`MapError::Radius`] for a radius that is not between 2^-20 and 2^20 of the scene's size;
    /// [`MapError::Photon`] for a photon outside the scene, or of a power that is negative or
    /// not finite.
    pub fn new(scene: &Scene, photons: Vec<Photon>, radius: f64) -> Result<Self, MapError> {
        Self::with_edge(scene, photons, radius, radius)
    }

    /// The map of `photons` with blocks of the edge `edge`, which may exceed the radius. Photon formats
    /// choose an edge at which the radius is a whole number of their steps.
    ///
    /// # Errors
    /// As for [`Self::new`]; [`MapError::Edge`] for an edge that is not between once and 2^20 times
    /// the radius.
    pub fn with_edge(
        scene: &Scene,
        photons: Vec<Photon>,
        radius: f64,
        edge: f64,
    ) -> Result<Self, MapError> {
        Self::sorted(scene, photons, radius, [edge; 2])
    }

    /// The map that [`Self::new`] and then [`Self::reblocked`] give, sorted once. Its photons never take memory twice.
    ///
    /// # Errors
    /// As for [`Self::with_edge`].
    pub fn new_reblocked(
        scene: &Scene,
        photons: Vec<Photon>,
        radius: f64,
        edge: f64,
    ) -> Result<Self, MapError> {
        Self::sorted(scene, photons, radius, [edge, radius])
    }

    /// The map of `photons` in blocks of the first edge. The photons of a run are in the order of blocks of the second edge.
    fn sorted(
        scene: &Scene,
        photons: Vec<Photon>,
        radius: f64,
        [edge, before]: [f64; 2],
    ) -> Result<Self, MapError> {
        let [low, high] = scene.bounds();
        check_radius((high - low).max_element(), radius)?;
        check_edge(radius, edge)?;
        let mut map = Self::empty(Groups::of(scene, radius, Self::MIN_FACING_COSINE), radius);
        (map.low, map.edge) = (low, edge);
        map.check(&photons, high)?;
        let groups = photons.par_iter().map(|photon| map.groups.group(photon));
        let groups = groups.collect();
        // The photons stay where they are, and then leave what they no longer need.
        let mut photons: Vec<_> = photons.into_iter().map(StoredPhoton::from).collect();
        photons.shrink_to_fit();
        map.sort(Unsorted { photons, groups }, before);
        Ok(map)
    }

    /// A map without photons.
    fn empty(groups: Groups, radius: f64) -> Self {
        Self {
            radius,
            edge: radius,
            low: DVec3::ZERO,
            photons: Vec::new(),
            runs: Vec::new(),
            rows: Rows::default(),
            groups,
        }
    }

    /// This map's photons in blocks of another edge.
    ///
    /// # Errors
    /// [`MapError::Edge`] as for [`Self::with_edge`].
    pub fn reblocked(&self, edge: f64) -> Result<Self, MapError> {
        self.reblocked_at(edge, DVec3::ZERO)
    }

    /// This map's photons in blocks of another edge, with the grid moved down by `shift`, from 0 to 1 block
    /// edges on each axis.
    pub(crate) fn reblocked_at(&self, edge: f64, shift: DVec3) -> Result<Self, MapError> {
        check_edge(self.radius, edge)?;
        let mut map = Self::empty(self.groups.clone(), self.radius);
        (map.low, map.edge) = (self.low - shift * edge, edge);
        let groups = self.runs.iter();
        let groups = groups.flat_map(|run| run.photons().map(|_| run.group));
        let unsorted = Unsorted {
            photons: self.photons.clone(),
            groups: groups.collect(),
        };
        map.sort(unsorted, edge);
        Ok(map)
    }

    /// Checks all photons and finds the first that is wrong.
    fn check(&self, photons: &[Photon], high: DVec3) -> Result<(), MapError> {
        let found = photons
            .par_iter()
            .enumerate()
            .find_map_first(|(index, photon)| {
                let (found, expected) = self.wrong(photon, high)?;
                Some(MapError::Photon {
                    index,
                    found,
                    expected,
                })
            });
        found.map_or(Ok(()), Err)
    }

    /// What is wrong with a photon, and the legal values.
    fn wrong(&self, photon: &Photon, high: DVec3) -> Option<(String, String)> {
        // A tenth of the radius covers any rounding of positions, and keeps indices positive.
        let slack = 0.1 * self.radius;
        let power = photon.power;
        if let Some(found) = outside(photon.position, self.low, high, slack) {
            return Some((found, "one inside the scene".to_owned()));
        }
        if !(power.is_finite() && power.cmpge(DVec3::ZERO).all()) {
            return Some((format!("power {power}"), "numbers from 0 up".to_owned()));
        }
        let surfaces = self.groups.surfaces();
        if photon.surface as usize >= surfaces {
            let found = format!("surface {}", photon.surface);
            return Some((found, format!("one of the scene's {surfaces}")));
        }
        let facings = self.groups.facings(photon.surface);
        (photon.facing.index() >= facings).then(|| {
            let found = format!("facing {}", photon.facing.index());
            (found, format!("one of its surface's {facings}"))
        })
    }

    /// Sorts photons into this map, which has none. The photons of a run are in the order of blocks of the edge `before`.
    fn sort(&mut self, unsorted: Unsorted, before: f64) {
        let by = |position, edge| block_key(self.in_blocks_of(position, edge));
        let (photons, runs) = match before == self.edge {
            true => unsorted.sorted(|at| [by(at, self.edge), 0]),
            false => unsorted.sorted(|at| [by(at, self.edge), by(at, before)]),
        };
        (self.photons, self.runs) = (photons, runs);
        self.runs.iter().for_each(|run| self.rows.push(run.block()));
    }

    /// The search radius, in scene units.
    #[must_use]
    pub fn radius(&self) -> f64 {
        self.radius
    }

    /// The blocks' edge, in scene units; at least the search radius.
    #[must_use]
    pub fn edge(&self) -> f64 {
        self.edge
    }

    /// All photons, sorted by block, surface and facing.
    #[must_use]
    pub fn photons(&self) -> &[StoredPhoton] {
        &self.photons
    }

    /// All photons as they were traced, in the map's order.
    pub fn traced_photons(&self) -> impl Iterator<Item = Photon> {
        let of_run = |run: &Run| {
            let (surface, facing) = (
                self.groups.surface(run.group),
                self.groups.facing(run.group),
            );
            let photons = self.photons[run.photons()].iter();
            photons.map(move |stored| Photon {
                position: stored.position,
                power: stored.power,
                surface,
                facing,
            })
        };
        self.runs.iter().flat_map(of_run)
    }

    /// The number of blocks that hold at least one photon.
    #[must_use]
    pub fn blocks(&self) -> usize {
        self.runs.chunk_by(|a, b| a.block == b.block).count()
    }

    /// The largest number of photons in one block.
    #[must_use]
    pub fn fullest_block(&self) -> usize {
        self.block_slices().map(|b| b.len()).max().unwrap_or(0)
    }

    /// The photons of every block that holds any, as indices into [`Self::photons`], in its order.
    pub fn block_slices(&self) -> impl Iterator<Item = Range<usize>> {
        let blocks = self.runs.chunk_by(|a, b| a.block == b.block);
        blocks.map(|runs| {
            let end = runs.last().map_or(0, |run| run.photons.end);
            runs[0].photons.start as usize..end as usize
        })
    }

    /// The photons of every run, as indices into [`Self::photons`], in its order.
    pub fn runs(&self) -> impl ExactSizeIterator<Item = Range<usize>> {
        self.runs.iter().map(Run::photons)
    }

    /// The block that contains `position`, by its index on each axis of the grid, and the position in the
    /// block, 0 to 1 of its edge.
    #[inline]
    #[must_use]
    pub fn place(&self, position: DVec3) -> (I64Vec3, DVec3) {
        let place = self.in_blocks(position);
        let (block, corner) = floors(place);
        (block, place - corner)
    }

    /// The position in steps of 2^-`bits` of a block's edge from the grid's origin, rounded down. The block's index
    /// is above the low `bits` bits.
    #[inline]
    pub(crate) fn steps(&self, position: DVec3, bits: u32) -> [i64; 3] {
        // A power of two, which rounds nothing.
        let steps = self.in_blocks(position) * f64::from(1_u32 << bits);
        floors(steps).0.to_array()
    }

    /// `position` in block edges from the grid's origin. The difference from the scene's corner is computed
    /// first. It is exact for a scene far from the origin: where a move rounds no coordinate, all later
    /// results are bit-identical.
    #[inline]
    fn in_blocks(&self, position: DVec3) -> DVec3 {
        self.in_blocks_of(position, self.edge)
    }

    #[inline]
    fn in_blocks_of(&self, position: DVec3, edge: f64) -> DVec3 {
        (position - self.low + 0.5 * edge) / edge
    }

    /// The runs that a query at `position` on `front` gathers, by the rule stated at [`PhotonMap`]: those of the 27 blocks around it
    /// whose photons count there, in the map's order.
    pub fn candidates(&self, position: DVec3, front: Front) -> impl Iterator<Item = Candidates> {
        let centre = self.place(position).0.to_array();
        let [low, high] = [-1, 1].map(|step| centre.map(|at| at.saturating_add(step)));
        let mut candidates = Vec::new();
        self.rows.within(low, high, |offset, run| {
            if self.gathers(self.runs[run].group, &front) {
                candidates.push(Candidates {
                    offset,
                    run,
                    photons: self.runs[run].photons(),
                });
            }
        });
        candidates.into_iter()
    }

    /// The block of a run, by the index on each axis of the grid, and the run's group.
    pub(crate) fn block_of_run(&self, run: usize) -> ([u64; 3], u32) {
        (self.runs[run].block(), self.runs[run].group)
    }

    /// The photons of a run, as indices into [`Self::photons`].
    pub(crate) fn photons_of_run(&self, run: usize) -> Range<usize> {
        self.runs[run].photons()
    }

    /// For each group of photons of one facing, whether a query on that front gathers it.
    pub(crate) fn facings(&self, front: &Front) -> Vec<bool> {
        let groups = 0..self.groups.count() as u32;
        groups.map(|group| self.gathers(group, front)).collect()
    }

    /// The surfaces whose photons may count for a query on `surface`, in order.
    pub(crate) fn joined_surfaces(&self, surface: u32) -> &[u32] {
        self.groups.joined_surfaces(surface)
    }

    /// The group of a run's photons of one facing, as an index into a set of [`crate::Batches::facing_sets`].
    ///
    /// # Panics
    /// Where there is no such run.
    pub fn group_of_run(&self, run: usize) -> u32 {
        self.runs[run].group
    }

    /// Whether photons of a group count for a query on `front`.
    pub(crate) fn gathers(&self, group: u32, front: &Front) -> bool {
        self.groups.normal(group).dot(front.normal) > Self::MIN_FACING_COSINE
            && front
                .surface
                .is_none_or(|surface| self.groups.are_joined(surface, group))
    }
}

/// The sort key of the block at a place, in block edges.
fn block_key(place: DVec3) -> u64 {
    key(floors(place).0).expect("checked: inside the scene")
}

/// The sort key of a block, by z, then y, then x; `None` outside the grid.
fn key(block: I64Vec3) -> Option<u64> {
    let inside = |index: i64| (0..1 << INDEX_BITS).contains(&index);
    let all = inside(block.x) && inside(block.y) && inside(block.z);
    all.then(|| {
        let [x, y, z] = block.to_array().map(|index| index as u64);
        (z << (2 * INDEX_BITS)) | (y << INDEX_BITS) | x
    })
}

/// The largest integers not above `x`, as integers and as floats. They saturate, and a NaN becomes 0.
///
/// On processors without a floor instruction the standard function is a call, and saturating conversions take
/// several steps. For the position of any block of the grid, this code needs neither.
#[inline]
fn floors(x: DVec3) -> (I64Vec3, DVec3) {
    /// Near this number floats are whole numbers, so adding it rounds, and the integer is in the low bits.
    const SHIFT: f64 = (3_u64 << 51) as f64;
    const NEAR: DVec3 = DVec3::splat((1_u64 << 50) as f64);
    if !x.abs().cmplt(NEAR).all() {
        let floors = I64Vec3::from_array(x.to_array().map(floor));
        return (floors, floors.as_dvec3());
    }
    let nearest = (x + SHIFT) - SHIFT;
    let above = DVec3::select(nearest.cmpgt(x), DVec3::ONE, DVec3::ZERO);
    let floors = nearest - above;
    let bits = (floors + SHIFT).to_array().map(f64::to_bits);
    let count = |bits: u64| bits as i64 - SHIFT.to_bits() as i64;
    (I64Vec3::from_array(bits.map(count)), floors)
}

/// The floor of one number, as in [`floors`].
fn floor(x: f64) -> i64 {
    let truncated = x as i64;
    truncated.saturating_sub((truncated as f64 > x).into())
}

#[cfg(test)]
mod tests;
