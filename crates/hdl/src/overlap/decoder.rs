//! The decoder of an overlapped machine. `W` control-word bits.

use photoncube_spec::{ControlWord, Field, OVERLAPPED};
use rust_hdl::prelude::*;

use crate::parts::decoder;
use crate::pinned::Word;

decoder! {
    OVERLAPPED, <W>,
    WritePhoton write_photon [Bit],
    WritePower write_power [Bit],
    MovePower move_power [Bits<7>],
    WriteSquare write_square [Bit],
    WriteWork write_work [Bit],
    WriteSum write_sum [Bit],
    WriteDistance write_distance [Bit],
    DistanceSource distance_source [Bits<2>],
    Axis axis [Bits<4>],
    Gate gate [Bit],
    AddSum add_sum [Bit],
    SendWork send_work [Bit],
    SendDistance send_distance [Bit],
}
