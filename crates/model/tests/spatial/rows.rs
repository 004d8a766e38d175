//! Tests of the rows of registers. The driver of all tests checks their length and that each value fits.

use photoncube_model::golden_machine;
use photoncube_spec::{EngineRegister, HeadRegister, Inputs, Machine, Pins, SignalPlace};

use crate::driver::{Driver, Waits};
use crate::machines::{all_named, named};
use crate::words::Noise;

#[test]
fn power_up_is_all_zero_and_ready_for_a_query() {
    for machine in all_named() {
        let pins = Pins::of(machine);
        let mut row = Vec::new();
        golden_machine(machine).observe(&Inputs::default(), &mut row);
        assert_eq!(row.len(), pins.observed.len());
        for (value, pin) in row.iter().zip(&pins.observed) {
            let ready = pin.name == "query_ready";
            assert_eq!(*value, u64::from(ready), "{}", pin.name);
        }
    }
}

/// Whether the reset clears the register in an engine.
fn is_cleared(register: EngineRegister) -> bool {
    use EngineRegister as R;
    let of_tokens = [R::TokenValid, R::NextValid, R::Swap, R::ResultValid];
    let of_firsts = [R::First, R::GateFirst, R::PairFirst, R::PairFirstDelay];
    let of_lasts = [R::Last, R::GateLast, R::PairLast, R::GroupLast];
    let of_sums = [R::GroupFirst, R::GroupLastDelay, R::SumFirst, R::SumDone];
    register == R::Done
        || [of_tokens, of_firsts, of_lasts, of_sums]
            .as_flattened()
            .contains(&register)
}

/// Whether a register of the head stores its next value during a reset as in any clock.
fn is_word(register: HeadRegister) -> bool {
    use HeadRegister as H;
    [H::EntryToken, H::EntryRadius, H::EntryPhoton].contains(&register)
        || [H::EntryPower, H::EntryExponent, H::EntryPresent].contains(&register)
        || [
            H::EntryTaken,
            H::DelayPower,
            H::DelayPresent,
            H::DelayAbsent,
        ]
        .contains(&register)
}

/// The registers before the clock of a reset.
struct Before(Vec<(SignalPlace, u64)>);

impl Before {
    fn of(&self, place: SignalPlace) -> u64 {
        let register = self.0.iter().find(|(other, _)| *other == place);
        register.expect("the machine has the register").1
    }

    fn head(&self, register: HeadRegister, index: usize) -> u64 {
        self.of(SignalPlace::Head { register, index })
    }

    fn engine(&self, register: EngineRegister, index: usize) -> u64 {
        let engine = 0;
        self.of(SignalPlace::Engine {
            engine,
            register,
            index,
        })
    }

    fn is_swapped(&self) -> bool {
        self.head(HeadRegister::EntryFirst, 0) == 1
    }

    /// Whether engine 0 keeps the token in the entry; it does so if it has room.
    fn keeps(&self) -> bool {
        let has_room = self.is_swapped() || self.engine(EngineRegister::NextValid, 0) == 0;
        has_room && self.head(HeadRegister::EntryTokenValid, 0) == 1
    }

    /// The next value of the next query: the token that was kept in the clock before.
    fn next(&self, register: EngineRegister, index: usize) -> u64 {
        let token = match register {
            EngineRegister::Next => EngineRegister::Token,
            _ => EngineRegister::TokenRadius,
        };
        let keeps = self.engine(EngineRegister::Keep, 0) == 1;
        self.engine(if keeps { token } else { register }, index)
    }

    /// The next value of the current query: the next query, if a first group is in the entry.
    fn query(&self, register: EngineRegister, index: usize) -> u64 {
        let next = match register {
            EngineRegister::Query => EngineRegister::Next,
            _ => EngineRegister::NextRadius,
        };
        match self.is_swapped() {
            true => self.next(next, index),
            false => self.engine(register, index),
        }
    }
}

fn reset_in_flight(machine: &Machine, clocks: u64) {
    let mut driver = Driver::new(machine);
    driver.give(&Noise::seeded(machine, clocks).batches(20, 3));
    for _ in 0..clocks {
        driver.tick(Waits::default());
    }
    let before = Before(driver.registers());
    // A query, a group and a result are ready in this clock, and are lost.
    driver.reset();
    for (place, value) in driver.registers() {
        match place {
            SignalPlace::Head { register, .. } if is_word(register) => {}
            SignalPlace::Head { .. } => assert_eq!(value, 0, "{place:?}"),
            SignalPlace::Engine {
                engine: 0,
                register,
                index,
            } => match register {
                EngineRegister::Reset => assert_eq!(value, 1),
                EngineRegister::Keep => assert_eq!(value, before.keeps().into()),
                EngineRegister::Next | EngineRegister::NextRadius => {
                    assert_eq!(value, before.next(register, index), "{place:?}");
                }
                EngineRegister::Query | EngineRegister::QueryRadius => {
                    assert_eq!(value, before.query(register, index), "{place:?}");
                }
                register => assert!(value == 0 || !is_cleared(register), "{place:?}"),
            },
            _ => {}
        }
    }
    // The reset reaches one more engine with each clock and leaves all flags at 0.
    for reached in 0..machine.queries_at_once() {
        for (place, value) in driver.registers() {
            if let SignalPlace::Engine {
                engine, register, ..
            } = place
            {
                let arrived = engine <= reached;
                assert!(value == 0 || !arrived || !is_cleared(register), "{place:?}");
                if register == EngineRegister::Reset {
                    assert_eq!(value, u64::from(engine == reached));
                }
            }
        }
        driver.tick(Waits::default());
    }
}

#[test]
fn a_reset_clears_the_head_at_once_and_the_engines_flags_as_a_wave() {
    for name in ["stream", "tile-5", "tile-7", "tile-6-mixed"] {
        for clocks in 0..120 {
            reset_in_flight(&named(name), clocks);
        }
    }
}

/// In the clock of a reset, the powers of a group that is ready still enter the delay line.
#[test]
fn a_reset_does_not_touch_the_powers_in_the_delay_line() {
    let machine = named("stream");
    let delayed = |driver: &Driver| {
        let registers = driver.registers();
        let powers = registers.into_iter().filter(|(place, _)| {
            let register = HeadRegister::DelayPower;
            matches!(place, SignalPlace::Head { register: r, .. } if *r == register)
        });
        powers.map(|(_, value)| value).collect::<Vec<_>>()
    };
    let [mut with, mut without] = [0, 1].map(|_| {
        let mut driver = Driver::new(&machine);
        driver.give(&Noise::new(&machine).batches(5, 3));
        for _ in 0..8 {
            driver.tick(Waits::default());
        }
        driver
    });
    with.reset();
    without.tick(Waits::default());
    assert!(delayed(&with)[..12].iter().any(|&power| power > 0));
    assert_eq!(delayed(&with), delayed(&without));
}
