//! The network's topology: nodes, axes, and the photon and role that a node's index selects.
//!
//! Ryu, Kim, Lee place 16 cells on a 4-D hypercube whose axes they call x, y, z, w. In our reading (design,
//! section 2), index bits 2 and 3 (axes z, w) select a cell's role in its quad, and all other bits select the
//! photon.

use std::fmt;

/// One dimension of the hypercube; its number is the node-index bit that it flips.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Axis(u8);

impl Axis {
    /// The first photon axis.
    pub const X: Self = Self(0);
    /// The second photon axis.
    pub const Y: Self = Self(1);
    /// The first role axis: it joins X with Y, and Z with D.
    pub const Z: Self = Self(2);
    /// The second role axis: it joins X with Z, and Y with D.
    pub const W: Self = Self(3);

    /// The names of the axes by index bit. The first four are the paper's; the others go backwards through
    /// the alphabet.
    const NAMES: [&'static str; 10] = ["x", "y", "z", "w", "v", "u", "t", "s", "r", "q"];

    /// The axis that flips node-index bit `bit`, or `None` past the last named axis.
    pub fn new(bit: u8) -> Option<Self> {
        (usize::from(bit) < Self::NAMES.len()).then_some(Self(bit))
    }

    /// Finds the axis of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        let bit = Self::NAMES.iter().position(|&n| n == name)?;
        Self::new(u8::try_from(bit).ok()?)
    }

    /// The node-index bit that this axis flips.
    pub fn bit(self) -> u32 {
        u32::from(self.0)
    }

    /// The axis's name in listings.
    pub fn name(self) -> &'static str {
        Self::NAMES[usize::from(self.0)]
    }
}

impl fmt::Display for Role {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl fmt::Display for Axis {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The work of a cell in the quad of its photon. Three cells hold a coordinate each, the fourth holds none.
/// Where a photon's power has one channel, the X cell holds it, and the Y and Z cells hold no power.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Role {
    /// Coordinate x, then the red channel.
    X,
    /// Coordinate y, then the green channel.
    Y,
    /// Coordinate z, then the blue channel.
    Z,
    /// No coordinate (the paper's distance cell), then the photon count.
    D,
}

impl Role {
    /// All roles, in the order of node-index bits 3..2.
    pub const ALL: [Self; 4] = [Self::X, Self::Y, Self::Z, Self::D];

    /// The role of the neighbour on an axis. On a photon axis the neighbour has the same role.
    pub fn across(self, axis: Axis) -> Self {
        let node = (self as usize) << Hypercube::FIRST_ROLE_BIT;
        Self::ALL[((node ^ (1 << axis.bit())) >> Hypercube::FIRST_ROLE_BIT) % Self::ALL.len()]
    }

    /// The role's name in listings.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "X",
            Self::Y => "Y",
            Self::Z => "Z",
            Self::D => "D",
        }
    }

    /// The coordinate that the role holds: 0 for x, 1 for y, 2 for z, `None` for the distance cell.
    pub fn coordinate(self) -> Option<usize> {
        match self {
            Self::X => Some(0),
            Self::Y => Some(1),
            Self::Z => Some(2),
            Self::D => None,
        }
    }
}

/// A hypercube of `2^dimension` nodes; two nodes are neighbours where one index bit differs.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Hypercube {
    dimension: u32,
}

impl Hypercube {
    /// The index bit of the first of the two role axes.
    const FIRST_ROLE_BIT: u32 = 2;
    /// The number of role bits: two bits select one of four roles.
    const ROLE_BITS: u32 = 2;
    /// The smallest dimension: two photon axes and two role axes, as in the paper.
    pub const MIN_DIMENSION: u32 = 4;
    /// The largest dimension, in which every axis has a name.
    pub const MAX_DIMENSION: u32 = Axis::NAMES.len() as u32;

    /// Makes the hypercube of that dimension.
    ///
    /// # Panics
    /// Below dimension 4 or past the last named axis; the named machines are all inside.
    pub fn new(dimension: u32) -> Self {
        assert!((Self::MIN_DIMENSION..=Self::MAX_DIMENSION).contains(&dimension));
        Self { dimension }
    }

    /// The number of axes.
    pub fn dimension(self) -> u32 {
        self.dimension
    }

    /// The number of nodes, `2^dimension`.
    pub fn nodes(self) -> usize {
        1 << self.dimension
    }

    /// The axes, from index bit 0.
    pub fn axes(self) -> impl Iterator<Item = Axis> {
        (0..self.dimension).filter_map(|bit| Axis::new(bit as u8))
    }

    /// The two axes that join the four roles of a quad (z and w).
    pub fn role_axes(self) -> impl Iterator<Item = Axis> {
        self.axes().filter(|axis| Self::is_role_bit(axis.bit()))
    }

    /// The axes that join photons: x, y, and every axis above w.
    pub fn photon_axes(self) -> impl Iterator<Item = Axis> {
        self.axes().filter(|axis| !Self::is_role_bit(axis.bit()))
    }

    /// The number of photons that the cube tests at once: one for each quad.
    pub fn photons(self) -> usize {
        1 << self.photon_axes().count()
    }

    /// Whether the cube has that axis.
    pub fn has_axis(self, axis: Axis) -> bool {
        axis.bit() < self.dimension
    }

    /// The node at the other end of the link on `axis`.
    pub fn neighbour(self, node: usize, axis: Axis) -> usize {
        node ^ (1 << axis.bit())
    }

    /// The role of a node, from its index bits 3..2.
    pub fn role(self, node: usize) -> Role {
        Role::ALL[(node >> Self::FIRST_ROLE_BIT) & (Role::ALL.len() - 1)]
    }

    /// The photon of a node: its index bits without the role bits, as an index.
    pub fn photon(self, node: usize) -> usize {
        let low = node & ((1 << Self::FIRST_ROLE_BIT) - 1);
        let high = node >> (Self::FIRST_ROLE_BIT + Self::ROLE_BITS);
        low | (high << Self::FIRST_ROLE_BIT)
    }

    /// The node where the result of `role` is read: the one of photon 0. After the exchange-adds every quad
    /// holds equal sums, so any quad would do.
    pub fn result_node(self, role: Role) -> usize {
        (role as usize) << Self::FIRST_ROLE_BIT
    }

    fn is_role_bit(bit: u32) -> bool {
        (Self::FIRST_ROLE_BIT..Self::FIRST_ROLE_BIT + Self::ROLE_BITS).contains(&bit)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_paper_has_sixteen_nodes_with_four_links_each() {
        let cube = Hypercube::new(4);
        assert_eq!(cube.nodes(), 16);
        for node in 0..cube.nodes() {
            let mut neighbours: Vec<_> = cube.axes().map(|a| cube.neighbour(node, a)).collect();
            neighbours.sort_unstable();
            neighbours.dedup();
            assert_eq!(neighbours.len(), 4, "node {node}");
            assert!(!neighbours.contains(&node));
        }
    }

    #[test]
    fn links_are_bidirectional() {
        for dimension in 4..=10 {
            let cube = Hypercube::new(dimension);
            for node in 0..cube.nodes() {
                for axis in cube.axes() {
                    assert_eq!(cube.neighbour(cube.neighbour(node, axis), axis), node);
                }
            }
        }
    }

    #[test]
    fn role_axes_keep_the_photon_and_photon_axes_keep_the_role() {
        for dimension in 4..=10 {
            let cube = Hypercube::new(dimension);
            assert_eq!(cube.role_axes().count(), 2);
            assert_eq!(cube.photons() * 4, cube.nodes());
            for node in 0..cube.nodes() {
                for axis in cube.role_axes() {
                    assert_eq!(cube.photon(cube.neighbour(node, axis)), cube.photon(node));
                }
                for axis in cube.photon_axes() {
                    assert_eq!(cube.role(cube.neighbour(node, axis)), cube.role(node));
                }
            }
        }
    }

    #[test]
    fn every_photon_has_each_role_once() {
        let cube = Hypercube::new(5);
        let mut seen: Vec<_> = (0..cube.nodes())
            .map(|node| (cube.photon(node), cube.role(node)))
            .collect();
        seen.sort_unstable();
        seen.dedup();
        assert_eq!(seen.len(), cube.nodes());
        for role in Role::ALL {
            assert_eq!(cube.role(cube.result_node(role)), role);
            assert_eq!(cube.photon(cube.result_node(role)), 0);
        }
    }

    #[test]
    fn the_role_across_an_axis_is_that_of_the_neighbour() {
        let cube = Hypercube::new(10);
        for node in 0..cube.nodes() {
            for axis in cube.axes() {
                let neighbour = cube.role(cube.neighbour(node, axis));
                assert_eq!(cube.role(node).across(axis), neighbour);
            }
        }
    }

    #[test]
    fn axis_names_are_read_back() {
        for bit in 0..10 {
            let axis = Axis::new(bit).unwrap();
            assert_eq!(Axis::from_name(axis.name()), Some(axis));
        }
        assert_eq!(Axis::new(10), None);
        assert_eq!(Axis::from_name("W"), None);
    }
}
