//! Drives and observes spatial machines and their square units by rows of numbers.

use photoncube_spec::{SignalPlace, Spatial};
use rust_hdl::prelude::*;

use super::machine::SpatialMachine;
use super::memory::GROUPS;
use super::registers;
use super::square::SquarePair;
use crate::emit::BlockRam;
use crate::pinned::{Driver, Pinned, Word, drive, sample, sample_registers, settle};
use crate::registers::{Answer, Ask};

/// The path prefix of a machine's only photon memory.
const MEMORY: &str = "memory_0.";

impl<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
> Pinned for SquarePair<C, H, D, R, Q, L, LP, HP, PR>
{
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        drive!(self, row: query, photon_a, photon_b);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: square_a, square_b, far_a, far_b);
    }

    settle!();
}

impl<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
> Pinned for SpatialMachine<C, H, D, R, Q, L, LP, HP, PR, T, U, B, E, P, PP, GP, S, N>
{
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        let mut driver = Driver::new(row);
        driver.put(&mut self.reset);
        driver.put(&mut self.query_valid);
        driver.put(&mut self.query_x);
        driver.put(&mut self.query_y);
        driver.put(&mut self.query_z);
        for radius_sq in &mut self.query_radius_sq {
            driver.put(radius_sq);
        }
        for release in &mut self.query_release {
            driver.put(release);
        }
        driver.put(&mut self.group_valid);
        driver.put(&mut self.group_last);
        for lane in 0..Spatial::LANES {
            driver.put(&mut self.photon_present[lane]);
            driver.put(&mut self.photon_x[lane]);
            driver.put(&mut self.photon_y[lane]);
            driver.put(&mut self.photon_z[lane]);
            let channels = self.photon_channel.iter_mut();
            for channel in channels.skip(lane).step_by(Spatial::LANES) {
                driver.put(channel);
            }
            if let Some(exponent) = self.photon_exponent.get_mut(lane) {
                driver.put(exponent);
            }
        }
        driver.put(&mut self.result_ready);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: query_ready, group_ready, result_valid);
        row.extend(self.result.iter().map(|result| result.val().number()));
        sample!(self, row: result_count);
        sample_registers(self, &self._places, row);
    }

    fn register(&self, place: SignalPlace, ask: Ask) -> Option<Answer> {
        Some(match place {
            SignalPlace::Head { register, index } => registers::head(self, register, index, ask),
            SignalPlace::Memory { register, index } => self.memory[0]
                .own_register(register, index, ask)
                .below(MEMORY),
            SignalPlace::Engine {
                engine,
                register,
                index,
            } => {
                let answer = registers::engine(&self.engine[engine], register, index, ask);
                answer.below(format_args!("engine_{engine}."))
            }
            _ => return None,
        })
    }

    fn block_rams(&self) -> Vec<BlockRam> {
        let memories = self.memory.iter();
        memories
            .map(|memory| BlockRam {
                path: format!("{MEMORY}{GROUPS}"),
                words: memory.words(),
            })
            .collect()
    }

    settle!();
}
