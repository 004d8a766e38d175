//! What photons of a block are parted by: their surface, and on a curved surface where its front faces.

use glam::DVec3;

use crate::facing::Facing;
use crate::scene::{Scene, Surface};
use crate::trace::Photon;

/// The facings of all surfaces, numbered in the surfaces' order. In a scene of flat surfaces a group's number is
/// its surface's.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Groups {
    /// The first group of each surface, and the number of all.
    first: Vec<u32>,
    /// Where the photons of each group face.
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

    /// How many surfaces there are.
    pub fn surfaces(&self) -> usize {
        self.first.len() - 1
    }

    /// How many facings a surface has.
    pub fn facings(&self, surface: u32) -> usize {
        let surface = surface as usize;
        (self.first[surface + 1] - self.first[surface]) as usize
    }

    /// The group of a photon of this scene.
    pub fn group(&self, photon: &Photon) -> u32 {
        self.first[photon.surface as usize] + photon.facing.index() as u32
    }

    /// Where the photons of a group face.
    pub fn normal(&self, group: u32) -> DVec3 {
        self.normals[group as usize]
    }
}

/// What stores no photons and is not flat needs no facings; its one faces no query.
fn normals(surface: &Surface) -> Vec<DVec3> {
    match surface.geometry.flat_normal() {
        Some(normal) => vec![normal],
        None if surface.is_specular() => vec![DVec3::ZERO],
        None => Facing::all().map(Facing::normal).collect(),
    }
}
