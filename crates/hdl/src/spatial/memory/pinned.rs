//! Drives and observes a photon memory on its own by rows of numbers.

use photoncube_spec::{MemoryRegister, SignalPlace};
use rust_hdl::prelude::*;

use super::{GROUPS, LANES, PhotonMemory};
use crate::emit::BlockRam;
use crate::pinned::{Driver, Pinned, Word, sample, settle};
use crate::registers::{Answer, Ask};

impl<const H: usize, const B: usize, const E: usize> PhotonMemory<H, B, E> {
    /// The number of instances of a register, as the spec counts them.
    fn instances(&self, register: MemoryRegister) -> usize {
        use MemoryRegister as M;
        match register {
            M::Full | M::End => 2,
            M::WritePresent | M::ReadPresent | M::WordPresent => LANES,
            M::WritePosition | M::ReadPosition | M::WordPosition => 3 * LANES,
            M::WritePower | M::ReadPower | M::WordPower => self.channel.len(),
            M::WriteExponent | M::ReadExponent | M::WordExponent => self.exponent.len(),
            _ => 1,
        }
    }

    /// A register's value or path, by the spec's index.
    pub(crate) fn own_register(&self, register: MemoryRegister, index: usize, ask: Ask) -> Answer {
        match ask {
            Ask::Value => Answer::Value(self.value(register, index)),
            Ask::Path => Answer::Path(self.path(register, index)),
        }
    }
}

impl<const H: usize, const B: usize, const E: usize> Pinned for PhotonMemory<H, B, E> {
    fn set_clock(&mut self, level: bool) {
        self.clock.next = level.into();
    }

    fn drive(&mut self, row: &[u64]) {
        let mut driver = Driver::new(row);
        driver.put(&mut self.reset);
        driver.put(&mut self.group_valid);
        driver.put(&mut self.group_last);
        for present in &mut self.present {
            driver.put(present);
        }
        for axis in [&mut self.x, &mut self.y, &mut self.z] {
            for coordinate in axis {
                driver.put(coordinate);
            }
        }
        for channel in &mut self.channel {
            driver.put(channel);
        }
        for exponent in &mut self.exponent {
            driver.put(exponent);
        }
        driver.put(&mut self.release_in);
        driver.put(&mut self.query_taken);
        driver.put(&mut self.is_full);
        driver.put(&mut self.has_room);
        driver.put(&mut self.clocks_to_last);
    }

    fn sample(&self, row: &mut Vec<u64>) {
        sample!(self, row: group_ready, word_valid, word_last);
        row.extend(self.word_present.iter().map(|bit| bit.val().number()));
        for axis in [&self.word_x, &self.word_y, &self.word_z] {
            row.extend(axis.iter().map(|coordinate| coordinate.val().number()));
        }
        row.extend(self.word_channel.iter().map(|word| word.val().number()));
        row.extend(self.word_exponent.iter().map(|word| word.val().number()));
        for register in MemoryRegister::ALL {
            let instances = 0..self.instances(register);
            row.extend(instances.map(|index| self.value(register, index)));
        }
    }

    fn register(&self, place: SignalPlace, ask: Ask) -> Option<Answer> {
        match place {
            SignalPlace::Memory { register, index } => {
                Some(self.own_register(register, index, ask))
            }
            _ => None,
        }
    }

    fn block_rams(&self) -> Vec<BlockRam> {
        vec![BlockRam {
            path: GROUPS.to_owned(),
            words: self.words(),
        }]
    }

    settle!();
}
