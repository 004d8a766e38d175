//! A session on a serial line: sends frames within the credit, goes back where the board refuses one, and collects what comes.

use std::collections::VecDeque;
use std::io::{ErrorKind, Read, Write};
use std::time::{Duration, Instant, SystemTime};

use photoncube_spec::{Serial, SerialFaultRow, SerialKind, SerialSizes};

use super::error::SerialError;
use super::frame::{self, Frame, Heard, Reader};

/// A frame for the board.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Request {
    pub(super) kind: SerialKind,
    pub(super) payload: Vec<u8>,
}

/// The frames of the board that are wanted, by their number.
#[derive(Copy, Clone, Debug, Default)]
pub(super) struct Wanted {
    pub(super) results: usize,
    pub(super) reads: usize,
    pub(super) writes: usize,
}

/// What has come: payloads.
#[derive(Clone, Debug, Default)]
pub(super) struct Collected {
    pub(super) results: Vec<Vec<u8>>,
    pub(super) reads: Vec<Vec<u8>>,
    pub(super) writes: usize,
}

impl Collected {
    fn has(&self, wanted: &Wanted) -> bool {
        self.results.len() >= wanted.results
            && self.reads.len() >= wanted.reads
            && self.writes >= wanted.writes
    }
}

/// The reason why a session ends early.
#[derive(Debug)]
pub(super) enum Ends {
    /// A frame of the board is lost: the work must be done again, in a new session.
    Lost,
    /// Nothing helps.
    Error(SerialError),
}

impl<E: Into<SerialError>> From<E> for Ends {
    fn from(error: E) -> Self {
        Self::Error(error.into())
    }
}

/// A frame that is not known to be taken by the core.
struct Sent {
    request: Request,
    /// The bytes of all frames of the session, up to and with this one, in the buffer of the bridge.
    end: u64,
}

/// Frames that may be on their way: with more, a number of 8 bits would not tell them apart.
const WINDOW: usize = u8::MAX as usize;
/// How often the board is asked for an answer.
const ASKED: u32 = 4;
/// How often the board may refuse a frame, or say that nothing happens, without any progress.
const WITHOUT_PROGRESS: u32 = 8;
/// A pause of a reader of a port that returns at once.
const PAUSE: Duration = Duration::from_millis(1);

/// A session. Frames are counted from its begin on.
pub(super) struct Session<P> {
    port: P,
    reader: Reader,
    sizes: SerialSizes,
    /// The time without a byte after which the board is asked.
    silence: Duration,
    token: u8,
    /// Whether a sync with the token is not answered yet.
    syncing: bool,
    window: VecDeque<Sent>,
    /// The number of the first frame of the window.
    first: u64,
    /// The number of the frame that goes onto the line next.
    next: u64,
    /// The bytes of the buffer that the board has taken.
    taken: u64,
    heard_at: Instant,
    asked: u32,
    refused: u32,
    idle: u32,
    collected: Collected,
}

impl<P: Read + Write> Session<P> {
    pub(super) fn new(port: P, sizes: SerialSizes, silence: Duration) -> Self {
        // A board may still answer the syncs of a program that ended.
        let now = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH);
        Self {
            port,
            reader: Reader::new(sizes),
            sizes,
            silence,
            token: now.map_or(0, |now| now.subsec_micros() as u8),
            syncing: false,
            window: VecDeque::new(),
            first: 0,
            next: 0,
            taken: 0,
            heard_at: Instant::now(),
            asked: 0,
            refused: 0,
            idle: 0,
            collected: Collected::default(),
        }
    }

    /// Begins: the core is reset, and what was on its way is forgotten.
    pub(super) fn begin(&mut self) -> Result<(), SerialError> {
        self.window.clear();
        (self.first, self.next, self.taken) = (0, 0, 0);
        (self.asked, self.refused, self.idle) = (0, 0, 0);
        self.collected = Collected::default();
        // Frames that were on their way may be lost, and are not missed.
        self.reader.count(false);
        self.ask(true)?;
        while self.syncing {
            let heard = self.listen()?;
            let mut frames = heard.iter().filter_map(|heard| match heard {
                Heard::Frame(frame) => Some(frame),
                Heard::Damage => None,
            });
            self.syncing = !frames.any(|frame| self.is_answer(frame));
            if self.syncing && self.is_silent() {
                self.ask(true)?;
            }
        }
        self.reader.count(true);
        self.asked = 0;
        Ok(())
    }

    /// What has come, also before a session was lost.
    pub(super) fn collected(&mut self) -> Collected {
        std::mem::take(&mut self.collected)
    }

    /// Sends requests, and collects what comes for them.
    pub(super) fn run(
        &mut self,
        requests: impl IntoIterator<Item = Request>,
        wanted: &Wanted,
    ) -> Result<(), Ends> {
        let mut requests = requests.into_iter().peekable();
        self.collected = Collected::default();
        self.heard_at = Instant::now();
        loop {
            if !self.syncing {
                self.send(&mut requests)?;
            }
            if requests.peek().is_none() && self.collected.has(wanted) {
                return Ok(());
            }
            for heard in self.listen()? {
                match heard {
                    Heard::Frame(frame) => self.heard(frame, wanted)?,
                    Heard::Damage => return Err(Ends::Lost),
                }
            }
            if self.is_silent() {
                self.ask(false)?;
            }
        }
    }

    /// Puts frames onto the line: those that the board refused, then new ones, as many as it has room for.
    fn send(
        &mut self,
        requests: &mut std::iter::Peekable<impl Iterator<Item = Request>>,
    ) -> Result<(), SerialError> {
        let mut line = Vec::new();
        loop {
            let place = (self.next - self.first) as usize;
            if place == self.window.len() {
                let Some(request) = requests.next_if(|_| place < WINDOW) else {
                    break;
                };
                let before = self.window.back().map_or(self.taken, |sent| sent.end);
                let end = before + self.sizes.in_buffer(request.kind) as u64;
                self.window.push_back(Sent { request, end });
            }
            let sent = &self.window[place];
            if sent.end - self.taken > Serial::BUFFER_BYTES as u64 {
                break;
            }
            let request = &sent.request;
            frame::write(request.kind, self.next as u8, &request.payload, &mut line);
            self.next += 1;
        }
        self.port.write_all(&line)?;
        Ok(())
    }

    /// What the bytes say that have come; nothing where none has.
    fn listen(&mut self) -> Result<Vec<Heard>, SerialError> {
        let mut bytes = [0; Serial::BUFFER_BYTES];
        let count = match self.port.read(&mut bytes) {
            Ok(0) => {
                std::thread::sleep(PAUSE);
                0
            }
            Ok(count) => count,
            Err(error) => match error.kind() {
                ErrorKind::TimedOut | ErrorKind::WouldBlock | ErrorKind::Interrupted => 0,
                _ => return Err(error.into()),
            },
        };
        if count > 0 {
            self.heard_at = Instant::now();
        }
        let reader = &mut self.reader;
        Ok(bytes[..count]
            .iter()
            .filter_map(|&byte| reader.take(byte))
            .collect())
    }

    fn is_silent(&self) -> bool {
        self.heard_at.elapsed() > self.silence
    }

    /// Sends a sync with a token of its own.
    fn ask(&mut self, begins: bool) -> Result<(), SerialError> {
        if self.asked == ASKED {
            return Err(SerialError::NoAnswer {
                asked: ASKED,
                waited: self.silence * ASKED,
            });
        }
        self.asked += 1;
        self.token = self.token.wrapping_add(1);
        self.syncing = true;
        self.heard_at = Instant::now();
        let begins = if begins { Serial::BEGINS } else { 0 };
        let mut line = Vec::new();
        frame::write(SerialKind::Sync, 0, &[self.token, begins], &mut line);
        self.port.write_all(&line)?;
        Ok(())
    }

    fn is_answer(&self, frame: &Frame) -> bool {
        frame.kind == SerialKind::Synced && frame.payload[0] == self.token
    }

    /// Takes a frame of the board.
    fn heard(&mut self, frame: Frame, wanted: &Wanted) -> Result<(), Ends> {
        let payload = frame.payload;
        match frame.kind {
            SerialKind::Result => self.collected.results.push(payload),
            SerialKind::ReadAnswer | SerialKind::WriteAnswer if payload[0] != 0 => {
                return Err(SerialError::Refused(payload[0]).into());
            }
            SerialKind::ReadAnswer => self.collected.reads.push(payload),
            SerialKind::WriteAnswer => self.collected.writes += 1,
            SerialKind::Credit => return self.credit([payload[0], payload[1]]),
            SerialKind::Error if self.syncing => return Ok(()),
            SerialKind::Error => return Ok(self.refusal(payload[0])?),
            SerialKind::Synced if self.syncing && payload[0] == self.token => {
                return self.synced(payload[1], [payload[2], payload[3]], wanted);
            }
            _ => return Ok(()),
        }
        self.progress();
        Ok(())
    }

    fn progress(&mut self) {
        (self.refused, self.idle) = (0, 0);
    }

    /// The board has taken so many bytes, modulo 2^16.
    fn credit(&mut self, taken: [u8; 2]) -> Result<(), Ends> {
        let more = u64::from(u16::from_le_bytes(taken).wrapping_sub(self.taken as u16));
        let place = (self.next - self.first) as usize;
        let on_the_way = match place {
            0 => 0,
            _ => self.window[place - 1].end - self.taken,
        };
        if more > on_the_way {
            // More than there was: the board was reset.
            return Err(Ends::Lost);
        }
        self.taken += more;
        while (self.window.front()).is_some_and(|sent| sent.end <= self.taken) {
            self.window.pop_front();
            self.first += 1;
        }
        if more > 0 {
            self.progress();
        }
        Ok(())
    }

    /// The board has refused a frame and is deaf.
    fn refusal(&mut self, cause: u8) -> Result<(), SerialError> {
        self.refused += 1;
        if self.refused == WITHOUT_PROGRESS {
            let row = SerialFaultRow::ALL.get(usize::from(cause));
            return Err(SerialError::ToBoard {
                times: self.refused,
                cause: row.map_or(cause.to_string(), |row| row.name.to_owned()),
            });
        }
        self.ask(false)
    }

    /// The board goes on with the frame of this number.
    fn synced(&mut self, expected: u8, taken: [u8; 2], wanted: &Wanted) -> Result<(), Ends> {
        self.credit(taken)?;
        let offset = expected.wrapping_sub(self.first as u8);
        let next = self.first + u64::from(offset);
        if next > self.next {
            return Err(Ends::Lost);
        }
        let nothing_lost = next == self.next;
        self.next = next;
        self.syncing = false;
        self.asked = 0;
        self.idle += u32::from(nothing_lost);
        match self.idle {
            WITHOUT_PROGRESS => Err(SerialError::Stalled {
                found: self.collected.results.len(),
                expected: wanted.results,
                waited: self.silence * WITHOUT_PROGRESS,
            }
            .into()),
            _ => Ok(()),
        }
    }
}
