//! Drives and observes an overlapped machine by rows of numbers.

use rust_hdl::prelude::*;

use super::cell::Cell;
use super::processor::Processor;
use crate::pinned::{Driver, Pinned, Word, drive, sample, settle};

impl<const R: usize, const P: usize, const V: usize, const S: usize, const W: usize>
    Cell<R, P, V, S, W>
{
    fn sample_registers(&self, row: &mut Vec<u64>) {
        sample!(
            self, row: query.q, radius_sq.q, photon.q, magnitude.q, digit_squares.q, low_product.q,
            high_product.q, square.q, addend.q, operand.q, work.q, distance.q, in_range.q, sum.q,
        );
        for (power, present) in self.power.iter().zip(&self.present) {
            sample!(row: power.q, present.q);
        }
    }
}

impl<const R: usize, const P: usize, const V: usize, const S: usize, const W: usize> Pinned
    for Cell<R, P, V, S, W>
{
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        drive!(
            self, row: word, write_query, query_in, radius_sq_in, photon_in, present_in, power_in,
            link_x, link_y, link_z, link_w,
        );
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: sum_out, z_out, w_out);
        self.sample_registers(row);
    }

    settle!();
}

impl<
    const R: usize,
    const P: usize,
    const V: usize,
    const S: usize,
    const A: usize,
    const D: usize,
    const W: usize,
> Pinned for Processor<R, P, V, S, A, D, W>
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
        for lane in 0..4 {
            driver.put(&mut self.photon_present[lane]);
            driver.put(&mut self.photon_x[lane]);
            driver.put(&mut self.photon_y[lane]);
            driver.put(&mut self.photon_z[lane]);
            driver.put(&mut self.photon_red[lane]);
            driver.put(&mut self.photon_green[lane]);
            driver.put(&mut self.photon_blue[lane]);
        }
        driver.put(&mut self.result_ready);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(
            self, row: query_ready, group_ready, result_valid, result_red, result_green, result_blue,
            result_count, control.address.q, control.occupied.q, control.last.q, control.drain.q,
            control.done.q, control.word_x.q, control.word_y.q, control.word_z.q, control.word_d.q,
        );
        for cell in &self.cell {
            cell.sample_registers(row);
        }
    }

    settle!();
}
