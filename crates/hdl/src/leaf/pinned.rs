//! Drives and observes leaf machines by rows of numbers.

use photoncube_spec::{SignalPlace, Spatial};
use rust_hdl::prelude::*;

use super::machine::LeafMachine;
use super::registers::own_register;
use super::words::{BOXES, GROUPS};
use crate::emit::BlockRam;
use crate::pinned::{Driver, Pinned, Word, sample, sample_registers, settle};
use crate::registers::{Answer, Ask};

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
    const PB: usize,
    const LB: usize,
    const KB: usize,
    const QB: usize,
    const QN: usize,
    const NB: usize,
    const SB: usize,
    const OB: usize,
    const TB: usize,
    const RB: usize,
> Pinned
    for LeafMachine<
        C,
        H,
        D,
        R,
        Q,
        L,
        LP,
        HP,
        PR,
        T,
        U,
        B,
        E,
        P,
        PP,
        GP,
        S,
        N,
        PB,
        LB,
        KB,
        QB,
        QN,
        NB,
        SB,
        OB,
        TB,
        RB,
    >
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
        driver.put(&mut self.query_release);
        driver.put(&mut self.query_last);
        driver.put(&mut self.query_facings);
        driver.put(&mut self.query_tag);
        driver.put(&mut self.group_valid);
        driver.put(&mut self.group_last);
        driver.put(&mut self.group_facing);
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
        sample!(self, row: result_count, result_tag, compared, wanted, played);
        sample_registers(self, &self._places, row);
    }

    fn register(&self, place: SignalPlace, ask: Ask) -> Option<Answer> {
        match place {
            SignalPlace::Leaf { register, index } => Some(own_register(self, register, index, ask)),
            of_chain => Some(self.chain.register(of_chain, ask)?.below("chain.")),
        }
    }

    fn block_rams(&self) -> Vec<BlockRam> {
        let ram = |path: String, words| BlockRam { path, words };
        let boxes = BOXES.iter();
        let boxes = boxes.map(|array| ram(format!("box_words.{array}"), self.box_words.depth()));
        let groups = ram(format!("group_words.{GROUPS}"), self.group_words.depth());
        boxes.chain([groups]).collect()
    }

    settle!();
}
