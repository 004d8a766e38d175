//! Drives and observes a sequential machine and its parts by rows of numbers.

use rust_hdl::prelude::*;

use super::cell::Cell;
use super::network::Network;
use super::processor::Processor;
use crate::pinned::{Driver, Pinned, Word, drive, sample, settle};

impl<const N: usize, const V: usize, const X: usize> Pinned for Network<N, V, X> {
    fn drive(&mut self, row: &[u64]) {
        let mut driver = Driver::new(row);
        driver.put(&mut self.axis);
        for work in &mut self.work {
            driver.put(work);
        }
    }

    fn sample(&self, row: &mut Vec<u64>) {
        row.extend(self.link.iter().map(|link| link.val().number()));
    }

    settle!();
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
> Pinned for Cell<C, H, M, Q, R, P, V, S>
{
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        drive!(
            self, row: write_query, write_photon, write_power, write_work, write_sum, work_source,
            add_sum, query_in, radius_sq_in, photon_in, present_in, power_in, link_in,
        );
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: work_out, sum_out);
        self.sample_registers(row);
    }

    settle!();
}

impl<
    const C: usize,
    const H: usize,
    const M: usize,
    const Q: usize,
    const R: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const W: usize,
    const X: usize,
    const N: usize,
    const G: usize,
> Pinned for Processor<C, H, M, Q, R, B, E, P, V, S, A, W, X, N, G>
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
        driver.put(&mut self.query_radius_sq);
        driver.put(&mut self.group_valid);
        driver.put(&mut self.group_last);
        for lane in 0..G {
            driver.put(&mut self.photon_present[lane]);
            driver.put(&mut self.photon_x[lane]);
            driver.put(&mut self.photon_y[lane]);
            driver.put(&mut self.photon_z[lane]);
            for channel in self.photon_channel.iter_mut().skip(lane).step_by(G) {
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
        sample!(self, row: control.address.q, control.last.q, control.done.q);
        for cell in &self.cell {
            cell.sample_registers(row);
        }
    }

    settle!();
}
