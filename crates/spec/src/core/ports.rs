//! The ports of a core.

use super::{Core, CoreStreams};
use crate::interface::{Direction, Port};
use crate::pins::{Pin, SignalPlace};

/// Bits of a column of a row: a port that is wider has several.
const COLUMN_BITS: u32 = u64::BITS;

/// The name of the clock.
const CLOCK: &str = "aclk";

/// The columns of the rows in which a core's ports are driven and compared: all ports but the clock. A port with more than 64 bits has a column
/// for each 64 of them, the lowest first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct CorePins {
    /// Columns of the inputs.
    pub inputs: Vec<Pin>,
    /// Columns of the outputs.
    pub outputs: Vec<Pin>,
}

impl Core {
    /// The ports of the top module, the clock first.
    pub fn ports(&self) -> Vec<Port> {
        let streams = CoreStreams::of(self);
        let chain = self.chain_bits();
        let (address, word) = (Self::ADDRESS_BITS, Self::REGISTER_BITS);
        let mut ports = Vec::new();
        let mut add = |direction: Direction, name: &str, width: u32, meaning: &str| {
            ports.push(Port {
                direction,
                name: name.to_owned(),
                width,
                meaning: meaning.to_owned(),
            });
        };
        use Direction::{Input, Output};
        add(Input, CLOCK, 1, "every register changes at its rising edge");
        add(
            Input,
            "aresetn",
            1,
            "synchronous, active low; one clock is enough",
        );
        add(
            Input,
            "s_axis_photons_tdata",
            streams.photons.bits,
            "a leaf of up to 8 photons",
        );
        add(Input, "s_axis_photons_tvalid", 1, "");
        add(Output, "s_axis_photons_tready", 1, "");
        add(
            Input,
            "s_axis_photons_tlast",
            1,
            "the leaf is the last of its set",
        );
        add(
            Input,
            "s_axis_photons_tdest",
            chain,
            "the chain that the leaf is for",
        );
        add(
            Input,
            "s_axis_queries_tdata",
            streams.queries.bits,
            "a query",
        );
        add(Input, "s_axis_queries_tvalid", 1, "");
        add(Output, "s_axis_queries_tready", 1, "");
        add(
            Input,
            "s_axis_queries_tlast",
            1,
            "the query is the last of its batch",
        );
        add(
            Input,
            "s_axis_queries_tdest",
            chain,
            "the chain that the query is for",
        );
        add(
            Output,
            "m_axis_results_tdata",
            streams.results.bits,
            "the result of a query",
        );
        add(Output, "m_axis_results_tvalid", 1, "");
        add(Input, "m_axis_results_tready", 1, "");
        add(Output, "m_axis_results_tlast", 1, "the tlast of the query");
        add(
            Output,
            "m_axis_results_tid",
            chain,
            "the chain that the result is from",
        );
        add(
            Output,
            "m_axis_results_tuser",
            1,
            "a coordinate of the query is too large for the frame; the sums are 0",
        );
        add(
            Input,
            "s_axi_awaddr",
            address,
            "in bytes; the two low bits are not looked at",
        );
        add(Input, "s_axi_awprot", 3, "not looked at");
        add(Input, "s_axi_awvalid", 1, "");
        add(Output, "s_axi_awready", 1, "");
        add(Input, "s_axi_wdata", word, "");
        add(Input, "s_axi_wstrb", word / 8, "");
        add(Input, "s_axi_wvalid", 1, "");
        add(Output, "s_axi_wready", 1, "");
        add(Output, "s_axi_bresp", 2, "0 OKAY, 2 SLVERR");
        add(Output, "s_axi_bvalid", 1, "");
        add(Input, "s_axi_bready", 1, "");
        add(
            Input,
            "s_axi_araddr",
            address,
            "in bytes; the two low bits are not looked at",
        );
        add(Input, "s_axi_arprot", 3, "not looked at");
        add(Input, "s_axi_arvalid", 1, "");
        add(Output, "s_axi_arready", 1, "");
        add(Output, "s_axi_rdata", word, "");
        add(Output, "s_axi_rresp", 2, "0 OKAY, 2 SLVERR");
        add(Output, "s_axi_rvalid", 1, "");
        add(Input, "s_axi_rready", 1, "");
        add(Output, "irq", 1, "1 while an event that is enabled is set");
        ports
    }

    /// The columns of all ports but the clock.
    pub fn pins(&self) -> CorePins {
        let of = |direction: Direction| {
            let ports = self.ports().into_iter();
            let ports = ports.filter(|port| port.direction == direction && port.name != CLOCK);
            let columns = ports.flat_map(|port| port_columns(&port));
            let pin = |(name, width)| Pin {
                name,
                width,
                place: SignalPlace::Top,
            };
            columns.map(pin).collect()
        };
        CorePins {
            inputs: of(Direction::Input),
            outputs: of(Direction::Output),
        }
    }
}

/// Name and bits of each column of a port, the lowest first.
pub fn port_columns(port: &Port) -> Vec<(String, u32)> {
    if port.width <= COLUMN_BITS {
        return vec![(port.name.clone(), port.width)];
    }
    let columns = 0..port.width.div_ceil(COLUMN_BITS);
    let column = |word: u32| {
        let width = (port.width - word * COLUMN_BITS).min(COLUMN_BITS);
        (format!("{}_{word}", port.name), width)
    };
    columns.map(column).collect()
}
