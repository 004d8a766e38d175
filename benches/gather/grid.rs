//! The main competitor: a uniform grid of f32 photons in structure-of-arrays form, eight at a time in AVX2.

use core::arch::x86_64::{__m256, _CMP_LE_OQ};

use glam::{DVec3, I64Vec3};
use photoncube_render::StoredPhoton;
use pulp::cast;
use pulp::x86::V3;
use rayon::prelude::*;

use crate::found::Found;

const LANES: usize = 8;

/// Photons sorted by cells whose edge is the search radius, with a dense array of cells.
pub struct F32Grid {
    /// The planes x, y, z, red, green, blue, each padded for the last load.
    planes: [Vec<f32>; 6],
    low: DVec3,
    radius: f64,
    cells: I64Vec3,
    /// The index of each cell's first photon, and the number of photons.
    starts: Vec<u32>,
}

impl F32Grid {
    pub fn new(photons: &[StoredPhoton], radius: f64) -> Self {
        let places = || photons.iter().map(|photon| photon.position);
        let low = places().reduce(DVec3::min).expect("photons");
        let high = places().reduce(DVec3::max).expect("photons");
        // One more cell on either side, so that a query's neighbours exist.
        let low = low - radius;
        let cells = ((high - low) / radius).floor().as_i64vec3() + 2;
        let mut grid = Self {
            planes: Default::default(),
            low,
            radius,
            cells,
            starts: vec![0; (cells.x * cells.y * cells.z) as usize + 1],
        };
        let mut order: Vec<_> = photons
            .par_iter()
            .map(|p| (grid.index(grid.cell(p.position)), p))
            .collect();
        order.par_sort_by_key(|(cell, _)| *cell);
        for (cell, photon) in order {
            grid.starts[cell + 1] += 1;
            let values = photon
                .position
                .to_array()
                .into_iter()
                .chain(photon.power.to_array());
            for (plane, value) in grid.planes.iter_mut().zip(values) {
                plane.push(value as f32);
            }
        }
        for cell in 1..grid.starts.len() {
            grid.starts[cell] += grid.starts[cell - 1];
        }
        grid.planes
            .iter_mut()
            .for_each(|plane| plane.extend([0.0; LANES]));
        grid
    }

    /// The number of bytes of photons and cells.
    pub fn bytes(&self) -> usize {
        let photons: usize = self
            .planes
            .iter()
            .map(|plane| size_of_val(plane.as_slice()))
            .sum();
        photons + size_of_val(self.starts.as_slice())
    }

    /// The cell of a position. Positions are above the low corner, so the conversion rounds down.
    fn cell(&self, position: DVec3) -> I64Vec3 {
        ((position - self.low) / self.radius).as_i64vec3()
    }

    fn index(&self, cell: I64Vec3) -> usize {
        ((cell.z * self.cells.y + cell.y) * self.cells.x + cell.x) as usize
    }

    /// The photons of three cells in a row along x; empty outside the grid.
    #[inline(always)]
    fn row(&self, row: I64Vec3) -> [usize; 2] {
        if row.y < 0 || row.y >= self.cells.y || row.z < 0 || row.z >= self.cells.z {
            return [0, 0];
        }
        let first = self.index(row.with_x((row.x - 1).max(0)));
        let last = self.index(row.with_x((row.x + 1).min(self.cells.x - 1)));
        [self.starts[first] as usize, self.starts[last + 1] as usize]
    }

    /// The sums of all queries, one after another.
    pub fn gather_all(&self, simd: V3, queries: &[DVec3]) -> Found {
        simd.vectorize(
            #[inline(always)]
            || {
                let mut all = Found::default();
                for query in queries {
                    all += self.gather(simd, *query);
                }
                all
            },
        )
    }

    #[inline(always)]
    fn gather(&self, simd: V3, query: DVec3) -> Found {
        let centre = [
            simd.avx._mm256_set1_ps(query.x as f32),
            simd.avx._mm256_set1_ps(query.y as f32),
            simd.avx._mm256_set1_ps(query.z as f32),
        ];
        let radius_sq = simd.avx._mm256_set1_ps((self.radius * self.radius) as f32);
        let zero = simd.avx._mm256_setzero_ps();
        let (mut red, mut green, mut blue) = (zero, zero, zero);
        let (mut count, mut tests) = (0, 0);
        let cell = self.cell(query);
        for z in -1..=1 {
            for y in -1..=1 {
                let [start, end] = self.row(cell + I64Vec3::new(0, y, z));
                tests += (end - start) as u64;
                // Slices of one length, so that bounds are checked once a row.
                let length = (end - start).next_multiple_of(LANES);
                let [xs, ys, zs, reds, greens, blues] = &self.planes;
                let (xs, ys, zs) = (
                    &xs[start..][..length],
                    &ys[start..][..length],
                    &zs[start..][..length],
                );
                let (reds, greens, blues) = (
                    &reds[start..][..length],
                    &greens[start..][..length],
                    &blues[start..][..length],
                );
                let mut first = 0;
                while first < length {
                    let dx = simd.avx._mm256_sub_ps(load(xs, first), centre[0]);
                    let dy = simd.avx._mm256_sub_ps(load(ys, first), centre[1]);
                    let dz = simd.avx._mm256_sub_ps(load(zs, first), centre[2]);
                    let xx = simd.avx._mm256_mul_ps(dx, dx);
                    let xy = simd.fma._mm256_fmadd_ps(dy, dy, xx);
                    let distance = simd.fma._mm256_fmadd_ps(dz, dz, xy);
                    let within = simd
                        .avx
                        ._mm256_cmp_ps::<{ _CMP_LE_OQ }>(distance, radius_sq);
                    let within = simd
                        .avx
                        ._mm256_and_ps(within, first_lanes(end - start - first));
                    count += u64::from(simd.avx._mm256_movemask_ps(within).count_ones());
                    let masked = simd.avx._mm256_and_ps(within, load(reds, first));
                    red = simd.avx._mm256_add_ps(red, masked);
                    let masked = simd.avx._mm256_and_ps(within, load(greens, first));
                    green = simd.avx._mm256_add_ps(green, masked);
                    let masked = simd.avx._mm256_and_ps(within, load(blues, first));
                    blue = simd.avx._mm256_add_ps(blue, masked);
                    first += LANES;
                }
            }
        }
        Found {
            queries: 1,
            power: DVec3::new(total(red), total(green), total(blue)),
            count,
            candidates: tests,
            tests,
        }
    }
}

#[inline(always)]
fn load(plane: &[f32], first: usize) -> __m256 {
    let lanes: &[f32; LANES] = plane[first..].first_chunk().expect("eight");
    cast(*lanes)
}

fn total(sum: __m256) -> f64 {
    let lanes: [f32; LANES] = cast(sum);
    f64::from(lanes.iter().sum::<f32>())
}

/// A mask of all ones in the first `photons` lanes, at most all lanes.
#[inline(always)]
fn first_lanes(photons: usize) -> __m256 {
    const ONES: [u32; 2 * LANES] = {
        let mut ones = [0; 2 * LANES];
        let mut lane = 0;
        while lane < LANES {
            ones[lane] = u32::MAX;
            lane += 1;
        }
        ones
    };
    let lanes: &[u32; LANES] = ONES[LANES - photons.min(LANES)..]
        .first_chunk()
        .expect("eight");
    cast(*lanes)
}
