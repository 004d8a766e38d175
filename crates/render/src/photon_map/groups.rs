//! The groups of a block's photons: by surface, and on a curved surface by facing.

use glam::DVec3;

use crate::scene::{Scene, Surface};
use crate::trace::{Facing, Photon};

/// The facings of all surfaces, numbered in the order of the surfaces. In a scene of flat surfaces a group's
/// number is that of its surface.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct Groups {
    /// The first group of each surface, and the number of all groups.
    first: Vec<u32>,
    /// The normal of each group's facing.
    normals: Vec<DVec3>,
    /// The surface of each group.
    surfaces: Vec<u32>,
    /// For each surface, the surfaces whose photons may count for a query on it, in order.
    joined: Vec<Vec<u32>>,
}

impl Groups {
    /// The facings of a scene, of which those face alike whose cosine exceeds `cosine`, for queries of a search radius (scene units).
    pub fn of(scene: &Scene, radius: f64, cosine: f64) -> Self {
        let mut groups = Self {
            first: vec![0],
            ..Self::default()
        };
        for (index, surface) in scene.surfaces().iter().enumerate() {
            groups.normals.extend(normals(surface));
            groups.surfaces.resize(groups.normals.len(), index as u32);
            groups.first.push(groups.normals.len() as u32);
        }
        let surfaces = 0..scene.surfaces().len() as u32;
        let joined = surfaces.map(|surface| scene.joined(surface, radius, cosine));
        groups.joined = joined.collect();
        groups
    }

    /// Whether photons of a group may count for a query on `surface`.
    pub fn are_joined(&self, surface: u32, group: u32) -> bool {
        let other = self.surfaces[group as usize];
        other == surface || self.joined_surfaces(surface).contains(&other)
    }

    /// The surfaces whose photons may count for a query on `surface`, in order.
    pub fn joined_surfaces(&self, surface: u32) -> &[u32] {
        &self.joined[surface as usize]
    }

    /// The number of surfaces.
    pub fn surfaces(&self) -> usize {
        self.first.len() - 1
    }

    /// The number of facings of a surface.
    pub fn facings(&self, surface: u32) -> usize {
        let surface = surface as usize;
        (self.first[surface + 1] - self.first[surface]) as usize
    }

    /// The group of a photon.
    pub fn group(&self, photon: &Photon) -> u32 {
        self.first[photon.surface as usize] + photon.facing.index() as u32
    }

    /// The surface of a group.
    pub fn surface(&self, group: u32) -> u32 {
        self.surfaces[group as usize]
    }

    /// The facing of a group on its surface.
    pub fn facing(&self, group: u32) -> Facing {
        Facing::at(group - self.first[self.surface(group) as usize])
    }

    /// The number of groups.
    pub fn count(&self) -> usize {
        self.normals.len()
    }

    /// The normal of a group's facing.
    pub fn normal(&self, group: u32) -> DVec3 {
        self.normals[group as usize]
    }
}

/// The normals of a surface's facings. A surface that is not flat and stores no photons needs none, and its
/// single facing is that of no query.
fn normals(surface: &Surface) -> Vec<DVec3> {
    match surface.geometry.flat_normal() {
        Some(normal) => vec![normal],
        None if surface.is_specular() => vec![DVec3::ZERO],
        None => Facing::all().map(Facing::normal).collect(),
    }
}
