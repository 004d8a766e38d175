//! Packs rows into bytes, for the pipe to a compiled simulation.

use std::ops::RangeInclusive;

use photoncube_spec::Pin;

/// The layout of a packed row. Each value takes the 1, 2, 4 or 8 bytes of Verilator's own types. All values
/// of one byte come first, then those of two, and so on, so that each size is one tight loop.
pub(crate) struct Packing {
    /// The columns whose values take one byte, in order.
    bytes_1: Vec<usize>,
    bytes_2: Vec<usize>,
    bytes_4: Vec<usize>,
    bytes_8: Vec<usize>,
    /// The number of bytes of a row.
    pub bytes: usize,
}

impl Packing {
    pub fn of(pins: &[Pin]) -> Self {
        let of_width = |widths: RangeInclusive<u32>| {
            let columns = pins.iter().enumerate();
            let columns = columns.filter(|(_, pin)| widths.contains(&pin.width));
            columns.map(|(column, _)| column).collect::<Vec<_>>()
        };
        let [bytes_1, bytes_2] = [of_width(0..=8), of_width(9..=16)];
        let [bytes_4, bytes_8] = [of_width(17..=32), of_width(33..=64)];
        Self {
            bytes: bytes_1.len() + 2 * bytes_2.len() + 4 * bytes_4.len() + 8 * bytes_8.len(),
            bytes_1,
            bytes_2,
            bytes_4,
            bytes_8,
        }
    }

    /// The columns in the order of their bytes.
    pub fn order(&self) -> impl Iterator<Item = usize> {
        let sizes = [&self.bytes_1, &self.bytes_2, &self.bytes_4, &self.bytes_8];
        sizes.into_iter().flatten().copied()
    }

    pub fn columns(&self) -> usize {
        self.order().count()
    }

    pub fn pack(&self, rows: &[u64], bytes: &mut Vec<u8>) {
        for row in rows.chunks_exact(self.columns()) {
            bytes.extend(self.bytes_1.iter().map(|&column| row[column] as u8));
            for &column in &self.bytes_2 {
                bytes.extend((row[column] as u16).to_ne_bytes());
            }
            for &column in &self.bytes_4 {
                bytes.extend((row[column] as u32).to_ne_bytes());
            }
            for &column in &self.bytes_8 {
                bytes.extend(row[column].to_ne_bytes());
            }
        }
    }

    pub fn unpack(&self, bytes: &[u8], rows: &mut Vec<u64>) {
        let columns = self.columns();
        let first = rows.len();
        rows.resize(first + bytes.len() / self.bytes * columns, 0);
        let rows = rows[first..].chunks_exact_mut(columns);
        for (row, packed) in rows.zip(bytes.chunks_exact(self.bytes)) {
            let (ones, rest) = packed.split_at(self.bytes_1.len());
            let (twos, rest) = rest.split_at(2 * self.bytes_2.len());
            let (fours, eights) = rest.split_at(4 * self.bytes_4.len());
            for (&column, &value) in self.bytes_1.iter().zip(ones) {
                row[column] = u64::from(value);
            }
            for (&column, value) in self.bytes_2.iter().zip(twos.as_chunks().0) {
                row[column] = u64::from(u16::from_ne_bytes(*value));
            }
            for (&column, value) in self.bytes_4.iter().zip(fours.as_chunks().0) {
                row[column] = u64::from(u32::from_ne_bytes(*value));
            }
            for (&column, value) in self.bytes_8.iter().zip(eights.as_chunks().0) {
                row[column] = u64::from_ne_bytes(*value);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use photoncube_spec::{MACHINES, Pins};

    #[test]
    fn a_packed_row_is_read_back() {
        for machine in MACHINES {
            let pins = Pins::of(machine).observed;
            let packing = Packing::of(&pins);
            let row = |salt: u64| {
                let value = move |(index, pin): (usize, &Pin)| {
                    let mixed = (index as u64 + salt).wrapping_mul(0x9e37_79b9_7f4a_7c15);
                    mixed >> (u64::BITS - pin.width)
                };
                pins.iter().enumerate().map(value).collect::<Vec<_>>()
            };
            let rows = [row(1), row(2)].concat();
            let (mut bytes, mut back) = (Vec::new(), Vec::new());
            packing.pack(&rows, &mut bytes);
            assert_eq!(bytes.len(), 2 * packing.bytes);
            packing.unpack(&bytes, &mut back);
            assert_eq!(back, rows);
        }
    }
}
