//! The decoder of a sequential machine. `W` control-word bits, `X` axis bits.

use photoncube_spec::{ControlWord, Field, SEQUENTIAL};
use rust_hdl::prelude::*;

use crate::parts::decoder;
use crate::pinned::Word;

decoder! {
    SEQUENTIAL, <W, X>,
    WriteQuery write_query [Bit],
    WritePhoton write_photon [Bit],
    WritePower write_power [Bit],
    WriteWork write_work [Bit],
    WriteSum write_sum [Bit],
    WorkSource work_source [Bits<2>],
    AddSum add_sum [Bit],
    TakesQuery takes_query [Bit],
    ReadsGroup reads_group [Bit],
    TakesGroup takes_group [Bit],
    Axis axis [Bits<X>],
}
