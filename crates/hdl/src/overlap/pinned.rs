//! Drives and observes an overlapped machine by rows of numbers.

use photoncube_spec::overlap::Register;
use rust_hdl::prelude::*;

use super::cell::Cell;
use super::processor::Processor;
use crate::pinned::{Driver, Pinned, Word};

impl<const R: usize, const P: usize, const V: usize, const S: usize, const W: usize>
    Cell<R, P, V, S, W>
{
    fn sample_registers(&self, row: &mut Vec<u64>) {
        row.extend(Register::all().map(|register| match register {
            Register::Query => self.query.q.val().number(),
            Register::RadiusSq => self.radius_sq.q.val().number(),
            Register::Photon => self.photon.q.val().number(),
            Register::Magnitude => self.magnitude.q.val().number(),
            Register::DigitSquares => self.digit_squares.q.val().number(),
            Register::LowProduct => self.low_product.q.val().number(),
            Register::HighProduct => self.high_product.q.val().number(),
            Register::Square => self.square.q.val().number(),
            Register::Addend => self.addend.q.val().number(),
            Register::Operand => self.operand.q.val().number(),
            Register::Work => self.work.q.val().number(),
            Register::Distance => self.distance.q.val().number(),
            Register::InRange => self.in_range.q.val().number(),
            Register::Sum => self.sum.q.val().number(),
            Register::Power(place) => self.power[usize::from(place)].q.val().number(),
            Register::Present(place) => self.present[usize::from(place)].q.val().number(),
        }));
    }
}

impl<const R: usize, const P: usize, const V: usize, const S: usize, const W: usize> Pinned
    for Cell<R, P, V, S, W>
{
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        let mut driver = Driver::new(row);
        driver.put(&mut self.word);
        driver.put(&mut self.write_query);
        driver.put(&mut self.query_in);
        driver.put(&mut self.radius_sq_in);
        driver.put(&mut self.photon_in);
        driver.put(&mut self.present_in);
        driver.put(&mut self.power_in);
        driver.put(&mut self.link_x);
        driver.put(&mut self.link_y);
        driver.put(&mut self.link_z);
        driver.put(&mut self.link_w);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        row.push(self.sum_out.val().number());
        row.push(self.z_out.val().number());
        row.push(self.w_out.val().number());
        self.sample_registers(row);
    }

    fn settle(&mut self) -> bool {
        self.update_all();
        !self.has_changed()
    }
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
        row.push(self.query_ready.val().number());
        row.push(self.group_ready.val().number());
        row.push(self.result_valid.val().number());
        row.push(self.result_red.val().number());
        row.push(self.result_green.val().number());
        row.push(self.result_blue.val().number());
        row.push(self.result_count.val().number());
        let control = &self.control;
        row.push(control.address.q.val().number());
        row.push(control.occupied.q.val().number());
        row.push(control.last.q.val().number());
        row.push(control.drain.q.val().number());
        row.push(control.done.q.val().number());
        row.push(control.word_x.q.val().number());
        row.push(control.word_y.q.val().number());
        row.push(control.word_z.q.val().number());
        row.push(control.word_d.q.val().number());
        for cell in &self.cell {
            cell.sample_registers(row);
        }
    }

    fn settle(&mut self) -> bool {
        self.update_all();
        !self.has_changed()
    }
}
