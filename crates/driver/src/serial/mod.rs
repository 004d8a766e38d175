//! The way to a core at the end of a serial line.

mod error;
mod frame;
mod order;
mod session;

use std::io::{Read, Write};
use std::time::Duration;

use photoncube_spec::{
    Beat, Core, CoreAnswer, CoreRegister, CoreStreams, CoreWords, CounterRow, ResultWord, Serial,
    SerialKind, SerialSizes,
};

pub use error::SerialError;
use session::{Ends, Request, Session, Wanted};

use crate::transport::{Transport, TransportError};

/// How often the same work is begun.
const ATTEMPTS: u32 = 6;

/// A core at the end of a serial line, whose rules are those of [`photoncube_spec::Serial`].
///
/// The line is a byte port. A read returns what has come, or an error of the kind `TimedOut` after some milliseconds in which nothing has.
///
/// Where the line lost a frame of the board, the core was reset, and the counters of an answer are those of the work behind that.
pub struct SerialTransport<P> {
    core: Core,
    digest: u64,
    results_bits: u32,
    session: Session<P>,
    /// A frame of the board was lost.
    lost: bool,
}

impl<P: Read + Write> SerialTransport<P> {
    /// The time without a byte after which the board is asked whether it is there.
    pub const SILENCE: Duration = Duration::from_secs(2);

    /// Begins a session, and checks that the core at the other end is this one. `digest` is that of the core's configuration, `silence`
    /// the time without a byte after which the board is asked whether it is there.
    ///
    /// # Errors
    /// The port fails, nothing answers, or another core does.
    pub fn open(port: P, core: &Core, digest: u64, silence: Duration) -> Result<Self, SerialError> {
        let mut transport = Self {
            core: *core,
            digest,
            results_bits: CoreStreams::of(core).results.bits,
            session: Session::new(port, SerialSizes::of(core), silence),
            lost: true,
        };
        transport.attempt(Self::check)?;
        Ok(transport)
    }

    /// Tries some work, again in a new session where a frame of the board is lost.
    fn attempt<T>(
        &mut self,
        work: impl Fn(&mut Self) -> Result<T, Ends>,
    ) -> Result<T, SerialError> {
        for _ in 0..ATTEMPTS {
            if std::mem::take(&mut self.lost) {
                self.session.begin()?;
            }
            match work(self) {
                Ok(done) => return Ok(done),
                Err(Ends::Lost) => self.lost = true,
                Err(Ends::Error(error)) => {
                    self.lost = true;
                    return Err(error);
                }
            }
        }
        Err(SerialError::FromBoard { times: ATTEMPTS })
    }

    /// The words of registers.
    fn read(&mut self, addresses: &[u32]) -> Result<Vec<u32>, Ends> {
        let requests = addresses.iter().map(|&address| Request {
            kind: SerialKind::Read,
            payload: address_bytes(address).into(),
        });
        let wanted = Wanted {
            reads: addresses.len(),
            ..Wanted::default()
        };
        self.session.run(requests, &wanted)?;
        let reads = self.session.collected().reads;
        let word = |payload: Vec<u8>| {
            let bytes = payload[1..].try_into();
            u32::from_le_bytes(bytes.expect("an answer has a word of 4 bytes"))
        };
        Ok(reads.into_iter().map(word).collect())
    }

    /// Checks that the other end is the core.
    fn check(&mut self) -> Result<(), Ends> {
        use CoreRegister as R;
        let rows = R::all(&self.core, self.digest);
        let asked = [
            R::Identity,
            R::Version,
            R::Shape,
            R::DigestLow,
            R::DigestHigh,
        ];
        let asked = asked.map(|register| {
            let row = rows.iter().find(|row| row.register == register);
            row.expect("the map has all registers")
        });
        let found = self.read(&asked.map(|row| row.address))?;
        for (row, &word) in asked[..2].iter().zip(&found) {
            if word != row.reset {
                return Err(SerialError::NoCore {
                    register: if row.register == R::Identity {
                        "identity"
                    } else {
                        "version"
                    },
                    found: word,
                    expected: row.reset,
                }
                .into());
            }
        }
        let digest = u64::from(found[3]) | u64::from(found[4]) << 32;
        match digest == self.digest {
            true => Ok(()),
            false => Err(SerialError::OtherCore {
                chains: found[2] & 0xff,
                engines: found[2] >> 8 & 0xff,
                found: digest,
                core: self.core.name(),
                expected: self.digest,
            }
            .into()),
        }
    }

    /// Gives the words, and waits for their results. Where a frame of the board is lost, it gives those again that are not answered.
    fn words(&mut self, words: &CoreWords) -> Result<Vec<ResultWord>, SerialError> {
        let chains = self.core.chains as usize;
        let (mut left, mut known) = (words.clone(), vec![0; chains]);
        let mut answered = vec![0; chains];
        let mut results = Vec::with_capacity(words.queries.len());
        let mut attempts = 0;
        loop {
            if std::mem::take(&mut self.lost) {
                self.session.begin()?;
            }
            let ended = self.give(&left);
            let (found, before) = (self.session.collected().results, results.len());
            for payload in found {
                let result = self.result(&payload);
                match known.get_mut(result.id as usize) {
                    Some(known) if *known > 0 => *known -= 1,
                    of_chain => {
                        if of_chain.is_some() {
                            answered[result.id as usize] += 1;
                        }
                        results.push(result);
                    }
                }
            }
            match ended {
                Ok(()) => return Ok(results),
                Err(Ends::Error(error)) => {
                    self.lost = true;
                    return Err(error);
                }
                Err(Ends::Lost) => self.lost = true,
            }
            attempts = if results.len() > before {
                1
            } else {
                attempts + 1
            };
            if attempts == ATTEMPTS {
                return Err(SerialError::FromBoard { times: ATTEMPTS });
            }
            (left, known) = order::left(&self.core, words, &answered);
        }
    }

    /// Clears the counters, and gives words. The session collects the results.
    fn give(&mut self, words: &CoreWords) -> Result<(), Ends> {
        let mut clear = address_bytes(self.address(CoreRegister::Control)).to_vec();
        clear.extend(CoreRegister::CLEAR_COUNTERS.to_le_bytes());
        let clear = Request {
            kind: SerialKind::Write,
            payload: clear,
        };
        let sizes = SerialSizes::of(&self.core);
        let in_order = order::on_line(&self.core, words);
        let of_words = in_order.into_iter().map(|(kind, beat)| Request {
            kind,
            payload: word_payload(sizes.payload(kind), beat),
        });
        let wanted = Wanted {
            results: words.queries.len(),
            writes: 1,
            ..Wanted::default()
        };
        let requests = std::iter::once(clear).chain(of_words);
        self.session.run(requests, &wanted)
    }

    /// The values of the counters.
    fn counters(&mut self) -> Result<Vec<u64>, Ends> {
        let addresses: Vec<_> = CounterRow::ALL
            .iter()
            .flat_map(|row| {
                [
                    CoreRegister::CounterLow(row.counter),
                    CoreRegister::CounterHigh(row.counter),
                ]
            })
            .map(|register| self.address(register))
            .collect();
        let halves = self.read(&addresses)?;
        let counters = halves
            .chunks_exact(2)
            .map(|half| u64::from(half[0]) | u64::from(half[1]) << 32);
        Ok(counters.collect())
    }

    /// The address of a register.
    fn address(&self, register: CoreRegister) -> u32 {
        let rows = CoreRegister::all(&self.core, self.digest);
        let row = rows.iter().find(|row| row.register == register);
        row.expect("the map has all registers").address
    }

    fn result(&self, payload: &[u8]) -> ResultWord {
        let mark = payload[0];
        let mut data = payload[1..].to_vec();
        data.resize(self.results_bits as usize / 8, 0);
        ResultWord {
            data,
            last: mark >> Serial::MARK_LAST & 1 == 1,
            id: u32::from(mark) & ((1 << Serial::MARK_LAST) - 1),
            outside: mark >> Serial::MARK_OUTSIDE & 1 == 1,
        }
    }
}

/// The bytes of an address.
fn address_bytes(address: u32) -> [u8; 2] {
    let address = u16::try_from(address);
    address
        .expect("addresses are short: see Core::ADDRESS_BITS")
        .to_le_bytes()
}

/// The payload of a word: its mark and its first bytes.
fn word_payload(bytes: usize, beat: &Beat) -> Vec<u8> {
    let mark = beat.dest | u32::from(beat.last) << Serial::MARK_LAST;
    // A core has at most 16 chains.
    let mut payload = vec![mark as u8];
    payload.extend(&beat.data);
    payload.resize(bytes, 0);
    payload
}

impl<P: Read + Write + Send> Transport for SerialTransport<P> {
    fn exchange(&mut self, words: &CoreWords) -> Result<CoreAnswer, TransportError> {
        let results = self.words(words)?;
        let counters = self.attempt(Self::counters)?;
        Ok(CoreAnswer { results, counters })
    }
}
