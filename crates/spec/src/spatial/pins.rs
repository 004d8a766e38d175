//! The registers of a spatial machine as signals, in the order head, photon memory, engines.

use super::{
    ENGINE_REGISTERS, HeadRegister, HeadSizes, Instances, MemoryRegister, Radius, Spatial,
};
use crate::formats::Widths;
use crate::machine::Machine;
use crate::pins::{Pin, SignalPlace};

/// Lists the registers of a spatial machine.
pub(crate) struct SpatialPins<'a> {
    machine: &'a Machine,
    spatial: &'a Spatial,
    widths: Widths,
    channels: &'static [&'static str],
}

impl<'a> SpatialPins<'a> {
    pub(crate) fn of(machine: &'a Machine, spatial: &'a Spatial) -> Self {
        Self {
            machine,
            spatial,
            widths: Widths::of(machine),
            channels: machine.channels().names(),
        }
    }

    pub(crate) fn registers(&self) -> Vec<Pin> {
        let mut pins = Vec::new();
        for register in HeadRegister::ALL {
            self.head_register(register, &mut pins);
        }
        if self.machine.has_memory() {
            for register in MemoryRegister::ALL {
                self.memory_register(register, &mut pins);
            }
        }
        for engine in 0..self.spatial.engines() {
            self.engine_registers(engine, &mut pins);
        }
        pins
    }

    fn head_register(&self, register: HeadRegister, pins: &mut Vec<Pin>) {
        let sizes = HeadSizes::of(self.spatial);
        let stages = self.spatial.latency() as usize;
        let lanes = stages * Spatial::LANES;
        let decides = usize::from(!self.spatial.paced);
        let (count, width) = match register {
            HeadRegister::Loaded => (1, sizes.loaded_bits),
            HeadRegister::Open
            | HeadRegister::HasWaiting
            | HeadRegister::HasResult
            | HeadRegister::EntryTokenValid
            | HeadRegister::EntryTaken
            | HeadRegister::EntryFirst
            | HeadRegister::EntryLast => (1, 1),
            HeadRegister::HasBatch => (decides, 1),
            HeadRegister::Spacing => (decides, sizes.spacing_bits),
            HeadRegister::Waits | HeadRegister::BatchRead if !sizes.has_waits() => (0, 1),
            HeadRegister::Waits | HeadRegister::BatchRead => (decides, 1),
            HeadRegister::Promised => (decides, sizes.promised_bits),
            HeadRegister::WritePlace | HeadRegister::NewestPlace | HeadRegister::ReadPlace => {
                (1, sizes.place_bits)
            }
            HeadRegister::EntryToken => (3, self.widths.coordinate),
            HeadRegister::EntryRadius if self.spatial.radius == Radius::Format => (0, 0),
            HeadRegister::EntryRadius => (1, self.widths.radius_sq),
            HeadRegister::EntryPhoton => (3 * Spatial::LANES, self.widths.photon),
            HeadRegister::EntryPower => {
                (Spatial::LANES * self.channels.len(), self.widths.mantissa)
            }
            HeadRegister::EntryExponent if self.widths.exponent == 0 => (0, 0),
            HeadRegister::EntryExponent => (Spatial::LANES, self.widths.exponent),
            HeadRegister::EntryPresent | HeadRegister::DelayAbsent => (Spatial::LANES, 1),
            HeadRegister::DelayPower => (lanes * self.channels.len(), self.widths.power),
            HeadRegister::DelayPresent => (lanes, 1),
            HeadRegister::DelayFirst | HeadRegister::DelayLast => (stages, 1),
        };
        pins.extend((0..count).map(|index| Pin {
            name: format!("head_{}_{index}", register.name()),
            width,
            place: SignalPlace::Head { register, index },
        }));
    }

    fn memory_register(&self, register: MemoryRegister, pins: &mut Vec<Pin>) {
        let place = self.spatial.memory_groups.ilog2();
        let lanes = Spatial::LANES;
        let (count, width) = match register {
            MemoryRegister::FillPlace
            | MemoryRegister::WritePlace
            | MemoryRegister::PlayPlace
            | MemoryRegister::PlayEnd
            | MemoryRegister::BeforeEnd => (1, place),
            MemoryRegister::Full => (2, 1),
            MemoryRegister::End => (2, place),
            MemoryRegister::WritePresent
            | MemoryRegister::ReadPresent
            | MemoryRegister::WordPresent => (lanes, 1),
            MemoryRegister::WritePosition
            | MemoryRegister::ReadPosition
            | MemoryRegister::WordPosition => (3 * lanes, self.widths.photon),
            MemoryRegister::WritePower | MemoryRegister::ReadPower | MemoryRegister::WordPower => {
                (lanes * self.channels.len(), self.widths.mantissa)
            }
            MemoryRegister::WriteExponent
            | MemoryRegister::ReadExponent
            | MemoryRegister::WordExponent => (
                if self.widths.exponent == 0 { 0 } else { lanes },
                self.widths.exponent,
            ),
            _ => (1, 1),
        };
        pins.extend((0..count).map(|index| Pin {
            name: format!("memory_{}_{index}", register.name()),
            width,
            place: SignalPlace::Memory { register, index },
        }));
    }

    fn engine_registers(&self, engine: usize, pins: &mut Vec<Pin>) {
        let kind = self.spatial.kind(self.machine.squarer, engine);
        for row in ENGINE_REGISTERS {
            if !row.is_in(self.spatial, kind) {
                continue;
            }
            let count = row.instances.count(self.spatial, kind, self.channels.len());
            pins.extend((0..count).map(|index| Pin {
                name: self.engine_pin(engine, row.name, row.instances, index),
                width: (row.width)(&self.widths),
                place: SignalPlace::Engine {
                    engine,
                    register: row.register,
                    index,
                },
            }));
        }
    }

    fn engine_pin(&self, engine: usize, name: &str, instances: Instances, index: usize) -> String {
        format!(
            "engine_{engine}_{name}{}",
            instances.suffix(index, self.channels)
        )
    }
}
