//! The common alternative: a kd-tree that visits the photons in range.

use glam::{DVec3, Vec3};
use kiddo::{ImmutableKdTree, SquaredEuclidean};
use photoncube_render::StoredPhoton;

use crate::found::Found;

/// kiddo's tree of f32 positions, with the powers beside it.
pub struct Tree {
    tree: ImmutableKdTree<f32, 3>,
    powers: Vec<Vec3>,
    radius_sq: f32,
}

impl Tree {
    pub fn new(photons: &[StoredPhoton], radius: f64) -> Self {
        let positions = photons.iter().map(|p| p.position.as_vec3().to_array());
        let tree = ImmutableKdTree::new_from_slice(&positions.collect::<Vec<_>>());
        Self {
            tree: tree.expect("photons"),
            powers: photons.iter().map(|p| p.power.as_vec3()).collect(),
            radius_sq: (radius * radius) as f32,
        }
    }

    /// The number of bytes of the photons: position, index and power, without the tree's own nodes.
    pub fn bytes(&self) -> usize {
        self.powers.len() * (size_of::<[f32; 3]>() + size_of::<u32>() + size_of::<Vec3>())
    }

    /// The sums of all queries, one after another.
    pub fn gather_all(&self, queries: &[DVec3]) -> Found {
        let mut all = Found::default();
        for query in queries {
            let (mut power, mut count) = (Vec3::ZERO, 0);
            self.tree
                .query(&query.as_vec3().to_array())
                .within::<SquaredEuclidean<f32>>(self.radius_sq)
                .unsorted()
                .visit(|found| {
                    power += self.powers[found.item as usize];
                    count += 1;
                });
            all += Found {
                queries: 1,
                power: power.as_dvec3(),
                count,
                candidates: count,
                tests: count,
            };
        }
        all
    }
}
