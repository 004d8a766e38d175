//! The values of a core's pins in one clock.

use super::{CorePins, CoreStreams, QueryRounds};

/// A word of an AXI4-Stream to the core.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Beat {
    /// `tdata`, byte 0 first; no bytes stand for zeros.
    pub data: Vec<u8>,
    /// `tlast`.
    pub last: bool,
    /// `tdest`.
    pub dest: u32,
}

/// The inputs of an AXI4-Stream to the core.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StreamIn {
    /// `tvalid`.
    pub valid: bool,
    /// The word, valid or not.
    pub beat: Beat,
}

/// The inputs of AXI4-Lite.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct LiteIn {
    /// `awaddr`, and `araddr` in [`Self::read_address`].
    pub write_address: u32,
    /// `awvalid`.
    pub write_address_valid: bool,
    /// `wdata`.
    pub write_data: u32,
    /// `wstrb`.
    pub write_strobe: u32,
    /// `wvalid`.
    pub write_data_valid: bool,
    /// `bready`.
    pub write_answer_ready: bool,
    /// `araddr`.
    pub read_address: u32,
    /// `arvalid`.
    pub read_address_valid: bool,
    /// `rready`.
    pub read_answer_ready: bool,
}

/// The values of a core's input pins in one clock.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CoreInputs {
    /// `aresetn` is 0.
    pub reset: bool,
    /// `s_axis_photons`.
    pub photons: StreamIn,
    /// `s_axis_queries`.
    pub queries: StreamIn,
    /// `m_axis_results_tready`.
    pub result_ready: bool,
    /// `s_axi`.
    pub lite: LiteIn,
}

/// An answer on AXI4-Lite: the code, and the word of a read.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct LiteAnswer {
    /// SLVERR in the place of OKAY.
    pub refused: bool,
    /// The word that was read; 0 of a write.
    pub word: u32,
}

/// A result on `m_axis_results`.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ResultWord {
    /// `tdata`, byte 0 first.
    pub data: Vec<u8>,
    /// `tlast`.
    pub last: bool,
    /// `tid`.
    pub id: u32,
    /// `tuser`.
    pub outside: bool,
}

/// The values of a core's output pins in one clock.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CoreOutputs {
    /// `s_axis_photons_tready`.
    pub photon_ready: bool,
    /// `s_axis_queries_tready`.
    pub query_ready: bool,
    /// `m_axis_results`, while `tvalid`.
    pub result: Option<ResultWord>,
    /// `awready` and `wready`, which are equal.
    pub write_ready: bool,
    /// `bresp`, while `bvalid`.
    pub write_answer: Option<LiteAnswer>,
    /// `arready`.
    pub read_ready: bool,
    /// `rresp` and `rdata`, while `rvalid`.
    pub read_answer: Option<LiteAnswer>,
    /// `irq`.
    pub interrupt: bool,
}

/// Words for both input streams of a core, each in its order. The batches release all sets.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CoreWords {
    /// The leaves.
    pub photons: Vec<Beat>,
    /// The queries.
    pub queries: Vec<Beat>,
    /// The rounds of their batches.
    pub rounds: QueryRounds,
}

impl CoreWords {
    /// The number of results for the queries.
    pub fn results(&self) -> usize {
        self.queries.len() * self.rounds.results()
    }
}

/// What a core answers to such words.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct CoreAnswer {
    /// The results, in the order in which they left the core.
    pub results: Vec<ResultWord>,
    /// What the core's counters counted, in the order of [`super::CounterRow::ALL`].
    pub counters: Vec<u64>,
}

/// The response OKAY or SLVERR.
fn response(answer: LiteAnswer) -> u64 {
    if answer.refused { 2 } else { 0 }
}

/// The columns of a word of so many bits.
fn columns(data: &[u8], bits: u32) -> impl Iterator<Item = u64> + '_ {
    let column_bytes = 8;
    (0..bits as usize / 8)
        .step_by(column_bytes)
        .map(move |first| {
            let bytes =
                (0..column_bytes).filter_map(|place| Some((place, *data.get(first + place)?)));
            bytes
                .map(|(place, byte)| u64::from(byte) << (8 * place))
                .sum()
        })
}

impl CorePins {
    /// Packs one clock's inputs into a row in the order of [`Self::inputs`].
    pub fn input_row(streams: &CoreStreams, inputs: &CoreInputs) -> Vec<u64> {
        let mut row = vec![u64::from(!inputs.reset)];
        for (stream, word) in [
            (&inputs.photons, &streams.photons),
            (&inputs.queries, &streams.queries),
        ] {
            row.extend(columns(&stream.beat.data, word.bits));
            row.extend([
                stream.valid.into(),
                stream.beat.last.into(),
                u64::from(stream.beat.dest),
            ]);
        }
        row.push(inputs.result_ready.into());
        let lite = &inputs.lite;
        let unprivileged = 0;
        row.extend([
            u64::from(lite.write_address),
            unprivileged,
            lite.write_address_valid.into(),
        ]);
        row.extend([lite.write_data, lite.write_strobe].map(u64::from));
        row.extend([lite.write_data_valid, lite.write_answer_ready].map(u64::from));
        row.extend([u64::from(lite.read_address), unprivileged]);
        row.extend([lite.read_address_valid, lite.read_answer_ready].map(u64::from));
        row
    }

    /// Packs one clock's outputs into a row in the order of [`Self::outputs`]. Words that are not valid count as 0.
    pub fn output_row(streams: &CoreStreams, outputs: &CoreOutputs) -> Vec<u64> {
        let mut row = vec![outputs.photon_ready.into(), outputs.query_ready.into()];
        let (result, valid) = (
            outputs.result.clone().unwrap_or_default(),
            outputs.result.is_some(),
        );
        row.extend(columns(&result.data, streams.results.bits));
        row.extend([
            u64::from(valid),
            result.last.into(),
            result.id.into(),
            result.outside.into(),
        ]);
        let (write, read) = (outputs.write_answer, outputs.read_answer);
        row.extend([outputs.write_ready, outputs.write_ready].map(u64::from));
        row.extend([response(write.unwrap_or_default()), write.is_some().into()]);
        let answer = read.unwrap_or_default();
        row.extend([
            outputs.read_ready.into(),
            answer.word.into(),
            response(answer),
            read.is_some().into(),
        ]);
        row.push(outputs.interrupt.into());
        row
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::core::Core;
    use crate::machines::find_machine;

    #[test]
    fn rows_have_a_value_for_each_column_in_its_place() {
        let machine = find_machine("leaf-5-local7-rgb6d-n64").unwrap();
        let core = Core::new(machine, 3).unwrap();
        let (streams, pins) = (CoreStreams::of(&core), core.pins());
        let inputs = CoreInputs {
            queries: StreamIn {
                valid: true,
                beat: Beat {
                    data: vec![1, 2],
                    last: false,
                    dest: 2,
                },
            },
            lite: LiteIn {
                read_address: 8,
                ..LiteIn::default()
            },
            ..CoreInputs::default()
        };
        let row = CorePins::input_row(&streams, &inputs);
        assert_eq!(row.len(), pins.inputs.len());
        let value = |name: &str| {
            let column = pins.inputs.iter().position(|pin| pin.name == name);
            row[column.unwrap()]
        };
        assert_eq!(value("aresetn"), 1);
        assert_eq!(value("s_axis_queries_tdata_0"), 0x201);
        assert_eq!(value("s_axis_queries_tdest"), 2);
        assert_eq!(value("s_axi_araddr"), 8);
        let outputs = CoreOutputs {
            read_answer: Some(LiteAnswer {
                refused: true,
                word: 7,
            }),
            interrupt: true,
            ..CoreOutputs::default()
        };
        let row = CorePins::output_row(&streams, &outputs);
        assert_eq!(row.len(), pins.outputs.len());
        let value = |name: &str| {
            let column = pins.outputs.iter().position(|pin| pin.name == name);
            row[column.unwrap()]
        };
        let of_read = ["s_axi_rdata", "s_axi_rresp", "s_axi_rvalid", "irq"];
        assert_eq!(of_read.map(value), [7, 2, 1, 1]);
    }
}
