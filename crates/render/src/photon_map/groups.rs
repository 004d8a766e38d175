//! The groups of a block's photons: by surface, and on a curved surface by facing.

use glam::DVec3;

use crate::scene::{Scene, Surface};
use crate::trace::{Facing, Photon};

/// The facings of all surfaces, numbered in the order of the surfaces. In a scene of flat surfaces a group's
/// number is that of its surface.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Groups {
    /// The first group of each surface, and the number of all groups.
    first: Vec<u32>,
    /// The normal of each group's facing.
    normals: Vec<DVec3>,
}

impl Groups {
    pub fn of(scene: &Scene) -> Self {
        let mut groups = Self {
            first: vec![0],
            normals: Vec::new(),
        };
        for surface in scene.surfaces() {
            groups.normals.extend(normals(surface));
            groups.first.push(groups.normals.len() as u32);
        }
        groups
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
