//! Where the registers of an engine and of the head are: each place is stated once, and read either
//! as the value that stands there or as its path in the emitted text.

use photoncube_spec::{EngineRegister, HeadRegister, Spatial};

use super::engine::Engine;
use super::head::Head;
use crate::pinned::Word;

/// What is asked of a register.
#[derive(Copy, Clone)]
pub(super) enum Ask {
    /// Its value.
    Value,
    /// Its path.
    Path,
}

/// The answer.
pub(super) enum Answer {
    /// Its value.
    Value(u64),
    /// Its path below the block.
    Path(String),
}

/// A field's name in the text: registers inside hand-written text have a field with `_` before it.
fn visible(field: &str) -> &str {
    field.trim_start_matches('_')
}

macro_rules! path {
    ($name:ident; $a:ident [$i:expr] . $($rest:tt)+) => {
        $name += &format!("{}_{}.", visible(stringify!($a)), $i);
        path!($name; $($rest)+);
    };
    ($name:ident; $a:ident . $($rest:tt)+) => {
        $name += &format!("{}.", visible(stringify!($a)));
        path!($name; $($rest)+);
    };
    ($name:ident; $a:ident) => { $name += visible(stringify!($a)); };
}

macro_rules! register {
    ($ask:ident, $block:ident, $($path:tt)+) => {
        match $ask {
            Ask::Value => Answer::Value($block.$($path)+.val().number()),
            Ask::Path => {
                let mut name = String::new();
                path!(name; $($path)+);
                Answer::Path(name)
            }
        }
    };
}

const AXES: usize = 3;
const LANES: usize = Spatial::LANES;

/// A register of an engine, counted as the spec's table does.
pub(super) fn engine<
    const C: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
>(
    e: &Engine<C, D, R, Q, L, LP, HP, PR, T, U, P, PP, GP, S, N>,
    register: EngineRegister,
    i: usize,
    ask: Ask,
) -> Answer {
    use EngineRegister as E;
    let channels = e._channels;
    // Of a coordinate, of a lane's channel.
    let (pair, photon) = (i / AXES / 2 * AXES + i % AXES, i / AXES % 2);
    let (channel, of_lane) = (i % channels, i / channels);
    match register {
        E::Reset => register!(ask, e, query_flags.reset.q),
        E::TokenValid => register!(ask, e, query_flags.token_valid.q),
        E::NextValid => register!(ask, e, query_flags.next_valid.q),
        E::Swap => register!(ask, e, query_flags.swap.q),
        E::Token => register!(ask, e, query[i].token.q),
        E::Next => register!(ask, e, query[i].waiting.q),
        E::Query => register!(ask, e, query[i].query.q),
        E::TokenRadius => register!(ask, e, radius_word[i].token.q),
        E::NextRadius => register!(ask, e, radius_word[i].waiting.q),
        E::QueryRadius => register!(ask, e, radius_word[i].query.q),
        E::RadiusDelay => register!(ask, e, radius_sq_delay[i].q),
        E::Photon => register!(ask, e, photon[i].q),
        E::Difference => register!(ask, e, square_pair[pair].difference[photon].q),
        E::Magnitude => register!(ask, e, square_pair[pair].digits[photon].magnitude.q),
        E::MagnitudeFar => register!(ask, e, square_pair[pair].digits[photon].magnitude_far.q),
        E::ProductsMagnitude => {
            register!(
                ask,
                e,
                square_pair[pair].digits[photon].products_magnitude.q
            )
        }
        E::LowProduct => register!(ask, e, square_pair[pair].digits[photon].low_product.q),
        E::HighProduct => register!(ask, e, square_pair[pair].digits[photon].high_product.q),
        E::ProductsFar => register!(ask, e, square_pair[pair].digits[photon].products_far.q),
        E::CrossMagnitude => {
            register!(ask, e, square_pair[pair].digits[photon].cross_magnitude.q)
        }
        E::Cross => register!(ask, e, square_pair[pair].digits[photon].cross_product.q),
        E::CrossFar => register!(ask, e, square_pair[pair].digits[photon].cross_far.q),
        E::MagnitudeDelay if e.square_pair[pair].lookup.is_empty() => {
            register!(ask, e, square_pair[pair].product[photon].magnitude_delay.q)
        }
        E::MagnitudeDelay => {
            register!(
                ask,
                e,
                square_pair[pair].lookup[0].magnitude_delay[photon].q
            )
        }
        E::Lookup if photon == 0 => {
            register!(ask, e, square_pair[pair].lookup[0].square_table.lookup_a)
        }
        E::Lookup => register!(ask, e, square_pair[pair].lookup[0].square_table.lookup_b),
        E::ProductsDelay if e.square_pair[pair].lookup.is_empty() => {
            register!(ask, e, square_pair[pair].product[photon].products_delay.q)
        }
        E::ProductsDelay => {
            register!(ask, e, square_pair[pair].lookup[0].products_delay[photon].q)
        }
        E::Product => register!(ask, e, square_pair[pair].product[photon].product.q),
        E::Square => register!(ask, e, square_pair[pair].square_stage[photon].q),
        E::SquareFar => register!(ask, e, square_pair[pair].far_stage[photon].q),
        E::PairSquare => register!(ask, e, lane[i].pair_square.q),
        E::PairZ => register!(ask, e, lane[i].pair_z.q),
        E::PairFar => register!(ask, e, lane[i].pair_far.q),
        E::Distance => register!(ask, e, lane[i].distance.q),
        E::DistanceFar => register!(ask, e, lane[i].distance_far.q),
        E::InRange => register!(ask, e, lane[i].in_range.q),
        E::Power => register!(ask, e, channel_sum[channel].hop[of_lane].q),
        E::Present => register!(ask, e, count_sum.hop[i].q),
        E::First => register!(ask, e, group_flags.first.flag[0].q),
        E::Last => register!(ask, e, group_flags.last.flag[0].q),
        E::GatedPower => register!(ask, e, channel_sum[channel].gate[of_lane].register.q),
        E::GatedPresent => register!(ask, e, count_sum.gate[i].register.q),
        E::GateFirst => register!(ask, e, group_flags.gate_first.flag[0].q),
        E::GateLast => register!(ask, e, group_flags.gate_last.flag[0].q),
        E::PairPower => register!(ask, e, channel_sum[channel].pair[of_lane].q),
        E::PairCount => register!(ask, e, count_sum.pair[i].q),
        E::PairFirst => register!(ask, e, group_flags.pair_first.flag[0].q),
        E::PairLast => register!(ask, e, group_flags.pair_last.flag[0].q),
        E::GroupPower => register!(ask, e, channel_sum[channel].group.q),
        E::GroupCount => register!(ask, e, count_sum.group.q),
        E::GroupFirst => register!(ask, e, group_flags.group_first.flag[0].q),
        E::GroupLast => register!(ask, e, group_flags.group_last.flag[0].q),
        E::Sum => register!(ask, e, channel_sum[i].sum.q),
        E::Count => register!(ask, e, count_sum.sum.q),
        E::Done => register!(ask, e, group_flags.done.q),
        E::ResultValid => register!(ask, e, group_flags.result_valid.q),
        E::Result => register!(ask, e, channel_sum[i].result.q),
        E::ResultCount => register!(ask, e, count_sum.result.q),
    }
}

/// A register of the head, counted as the spec says.
pub(super) fn head<
    const B: usize,
    const E: usize,
    const P: usize,
    const S: usize,
    const N: usize,
>(
    h: &Head<B, E, P, S, N>,
    register: HeadRegister,
    i: usize,
    ask: Ask,
) -> Answer {
    let words = h._channels * LANES;
    match register {
        HeadRegister::Loaded => register!(ask, h, admission._loaded),
        HeadRegister::Open => register!(ask, h, admission._open),
        HeadRegister::Spacing => register!(ask, h, admission._spacing),
        HeadRegister::Promised => register!(ask, h, admission._promised),
        HeadRegister::WritePlace => register!(ask, h, queue._write_place),
        HeadRegister::ReadPlace => register!(ask, h, queue._read_place),
        HeadRegister::DelayPower => register!(ask, h, power_delay[i % words].stage[i / words].q),
        HeadRegister::DelayPresent => {
            register!(ask, h, present_delay[i % LANES].stage[i / LANES].q)
        }
        HeadRegister::DelayFirst => register!(ask, h, first_delay.stage[i].flag[0].q),
        HeadRegister::DelayLast => register!(ask, h, last_delay.stage[i].flag[0].q),
    }
}
