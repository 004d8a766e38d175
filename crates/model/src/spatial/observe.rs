//! Lists all registers as numbers, in the order of [`photoncube_spec::Pins::observed`].

use photoncube_spec::{ENGINE_REGISTERS, EngineRegister, HeadRegister, Machine, Spatial, Sums};

use super::axis::{Axis, Square};
use super::engine::Engine;
use super::head::Head;
use super::lane::Lane;
use super::link::Flags;
use super::rules::ones;

impl Head {
    /// Appends the head's registers.
    pub(super) fn observe(&self, machine: &Machine, row: &mut Vec<u64>) {
        let channels = machine.channels().names().len();
        let lanes = self.entry.lanes.iter();
        for register in HeadRegister::ALL {
            match register {
                HeadRegister::HasBatch
                | HeadRegister::Spacing
                | HeadRegister::Waits
                | HeadRegister::BatchRead
                | HeadRegister::Promised
                    if self.paced => {}
                HeadRegister::Loaded => row.push(self.loaded.into()),
                HeadRegister::Open => row.push(self.open.into()),
                HeadRegister::Spacing => row.push(self.spacing.into()),
                HeadRegister::Waits if !self.sizes.has_waits() => {}
                HeadRegister::Waits => row.push((self.spacing != 0).into()),
                HeadRegister::HasBatch => row.push(self.has_batch().into()),
                HeadRegister::BatchRead if !self.sizes.has_waits() => {}
                HeadRegister::BatchRead => row.push(self.batch_read.into()),
                HeadRegister::Promised => row.push((1 << self.promised) - 1),
                HeadRegister::WritePlace => row.push(self.write_place as u64),
                HeadRegister::NewestPlace => row.push(self.newest_place as u64),
                HeadRegister::ReadPlace => row.push(self.read_place as u64),
                HeadRegister::HasWaiting => row.push((self.waiting > 0).into()),
                HeadRegister::HasResult => row.push(self.has_result.into()),
                HeadRegister::EntryTokenValid => row.push(self.entry.token_valid.into()),
                HeadRegister::EntryToken => {
                    row.extend(self.entry.token.position.map(u64::from));
                }
                HeadRegister::EntryRadius if machine.fixed_radius_sq().is_some() => {}
                HeadRegister::EntryRadius => row.push(self.entry.token.radius_sq.into()),
                HeadRegister::EntryPhoton => {
                    row.extend(lanes.clone().flat_map(|lane| lane.photon.map(u64::from)));
                }
                HeadRegister::EntryPower => {
                    let words = lanes.clone().flat_map(|lane| &lane.mantissa[..channels]);
                    row.extend(words.map(|&mantissa| u64::from(mantissa)));
                }
                HeadRegister::EntryExponent if !machine.has_exponent() => {}
                HeadRegister::EntryExponent => {
                    row.extend(lanes.clone().map(|lane| u64::from(lane.exponent)));
                }
                HeadRegister::EntryPresent => {
                    row.extend(lanes.clone().map(|lane| u64::from(lane.present)));
                }
                HeadRegister::EntryTaken => row.push(self.entry.taken.into()),
                HeadRegister::EntryFirst => row.push(self.entry.flags.first.into()),
                HeadRegister::EntryLast => row.push(self.entry.flags.last.into()),
                HeadRegister::DelayPower => {
                    let lanes = self.delay.iter().flat_map(|stage| &stage.power);
                    row.extend(lanes.flat_map(|power| &power[..channels]));
                }
                HeadRegister::DelayPresent => {
                    let lanes = self.delay.iter().flat_map(|stage| stage.present);
                    row.extend(lanes.map(u64::from));
                }
                HeadRegister::DelayAbsent => row.extend(self.absent.map(u64::from)),
                HeadRegister::DelayFirst => {
                    row.extend(self.delay.iter().map(|stage| u64::from(stage.flags.first)));
                }
                HeadRegister::DelayLast => {
                    row.extend(self.delay.iter().map(|stage| u64::from(stage.flags.last)));
                }
            }
        }
    }
}

/// A writer of one engine's registers into a row.
struct Writer<'a> {
    engine: &'a Engine,
    channels: usize,
    row: &'a mut Vec<u64>,
}

impl Engine {
    /// Appends the registers that the engine has.
    pub(super) fn observe(&self, spatial: &Spatial, channels: usize, row: &mut Vec<u64>) {
        let mut writer = Writer {
            engine: self,
            channels,
            row,
        };
        for table_row in ENGINE_REGISTERS {
            if table_row.is_in(spatial, self.rules.kind) {
                writer.register(table_row.register);
            }
        }
    }
}

impl Writer<'_> {
    fn register(&mut self, register: EngineRegister) {
        use EngineRegister as R;
        let engine = self.engine;
        let (hop, sums) = (&engine.hop, &engine.sums);
        let widths = &engine.rules.widths;
        let signed = |d: i32| d as u64 & ones(widths.signed_difference());
        let lookup = |square: Square| u64::from(square.far) << widths.square | square.word;
        match register {
            R::Reset => self.one(hop.reset),
            R::TokenValid => self.one(hop.token_valid),
            R::Token => self.axes(hop.token.position),
            R::TokenRadius => self.one(hop.token.radius_sq),
            R::NextValid => self.one(engine.next_valid),
            R::Keep => self.one(engine.keep),
            R::Next => self.axes(engine.next.position),
            R::NextRadius => self.one(engine.next.radius_sq),
            R::Query => self.axes(engine.query.position),
            R::QueryRadius => self.one(engine.query.radius_sq),
            R::RadiusDelay => {
                let delays = &engine.radius_delay[..engine.rules.radius_delays];
                self.row.extend(delays.iter().map(|&r| u64::from(r)));
            }
            R::Swap => self.one(hop.swap),
            R::Photon => hop.photon.into_iter().for_each(|lane| self.axes(lane)),
            R::Difference => self.coordinates(|axis| signed(axis.difference)),
            R::Magnitude => self.coordinates(|axis| axis.magnitude),
            R::MagnitudeDelay => self.coordinates(|axis| signed(axis.magnitude_delay)),
            R::ProductsMagnitude => self.coordinates(|axis| axis.products.magnitude.word),
            R::LowProduct => self.coordinates(|axis| axis.products.low),
            R::HighProduct => self.coordinates(|axis| axis.products.high),
            R::ProductsFar => self.coordinates(|axis| axis.products.magnitude.far),
            R::ProductsDelay => self.coordinates(|axis| signed(axis.products_delay)),
            R::Lookup => self.coordinates(|axis| lookup(axis.lookup)),
            R::Product => self.coordinates(|axis| axis.product),
            R::CrossMagnitude => self.coordinates(|axis| axis.crossed.magnitude.word),
            R::Cross => self.coordinates(|axis| axis.crossed.cross),
            R::CrossFar => self.coordinates(|axis| axis.crossed.magnitude.far),
            R::Square => self.coordinates(|axis| axis.square.word),
            R::SquareFar => self.coordinates(|axis| axis.square.far),
            R::SquareDelay => self.coordinates(|axis| axis.square_delay.word),
            R::SquareFarDelay => self.coordinates(|axis| axis.square_delay.far),
            R::PairSquare => self.lanes(|lane| lane.pair.square),
            R::PairZ => self.lanes(|lane| lane.pair.z),
            R::PairFar => self.lanes(|lane| lane.pair.far),
            R::Distance => self.lanes(|lane| lane.distance.word),
            R::DistanceFar => self.lanes(|lane| lane.distance.far),
            R::InRange => self.lanes(|lane| lane.in_range),
            R::RangeWait => {
                for wait in 0..engine.rules.range_waits {
                    self.lanes(|lane| lane.range_wait[wait]);
                }
            }
            R::RangeDelay => self.lanes(|lane| lane.range_delay),
            R::Decision => self.channels(&engine.lanes.map(|lane| [lane.decision.into(); 3])),
            R::PresenceDecision => self.lanes(|lane| lane.decision),
            R::Power => self.channels(&hop.powers.power),
            R::Present => self.row.extend(hop.powers.present.map(u64::from)),
            R::First | R::Last => self.flag(hop.powers.flags, register == R::First),
            R::GatedPower => self.channels(&sums.gated.power),
            R::GatedPresent => self.row.extend(sums.gated.present.map(u64::from)),
            R::GateFirst | R::GateLast => self.flag(sums.gated.flags, register == R::GateFirst),
            R::PairPower => self.powers(&sums.pairs.sums),
            R::PairCount => self.row.extend(sums.pairs.sums.map(|pair| pair.count)),
            R::PairFirst | R::PairLast => self.flag(sums.pairs.flags, register == R::PairFirst),
            R::PairFirstDelay => self.channels(&[[sums.pairs.flags.first.into(); 3]]),
            R::GroupPower => self.powers(&[sums.group.sums]),
            R::GroupCount => self.one(sums.group.sums.count),
            R::GroupFirst | R::GroupLast => self.flag(sums.group.flags, register == R::GroupFirst),
            R::GroupLastDelay => self.channels(&[[sums.group.flags.last.into(); 3]]),
            R::SumFirst => self.channels(&[[sums.group.flags.first.into(); 3]]),
            R::Sum => self.powers(&[sums.sum]),
            R::Count => self.one(sums.sum.count),
            R::Done => self.one(sums.done),
            R::SumDone => self.channels(&[[sums.done.into(); 3]]),
            R::ResultValid => self.one(sums.result.valid),
            R::Result => self.powers(&[sums.result.sums]),
            R::ResultCount => self.one(sums.result.sums.count),
        }
    }

    fn one(&mut self, value: impl Into<u64>) {
        self.row.push(value.into());
    }

    fn flag(&mut self, flags: Flags, first: bool) {
        self.one(if first { flags.first } else { flags.last });
    }

    fn axes(&mut self, values: [u32; 3]) {
        self.row.extend(values.map(u64::from));
    }

    /// Appends a value for each coordinate: axis a of lane g is at 3 g + a.
    fn coordinates<T: Into<u64>>(&mut self, value: impl Fn(&Axis) -> T) {
        let axes = self.engine.lanes.iter().flat_map(|lane| &lane.axes);
        self.row.extend(axes.map(|axis| value(axis).into()));
    }

    fn lanes<T: Into<u64>>(&mut self, value: impl Fn(&Lane) -> T) {
        let lanes = self.engine.lanes.iter();
        self.row.extend(lanes.map(|lane| value(lane).into()));
    }

    /// Appends the summed powers of the machine's channels, at most 64 bits each.
    fn powers(&mut self, sums: &[Sums]) {
        for sums in sums {
            self.channels(&[sums.power.map(|power| power as u64)]);
        }
    }

    /// Appends the powers of the machine's channels, for each lane.
    fn channels(&mut self, powers: &[[u64; 3]]) {
        let channels = self.channels;
        self.row
            .extend(powers.iter().flat_map(|power| &power[..channels]));
    }
}
