//! The places of the registers of an engine, of the head and of the entry.

use photoncube_spec::{EngineRegister, HeadRegister, Spatial};

use super::engine::Engine;
use super::machine::SpatialMachine;
use crate::pinned::Word;
use crate::registers::{Answer, Ask, register};

const AXES: usize = 3;
const LANES: usize = Spatial::LANES;

/// A register of an engine, by the index of the spec's table.
pub(super) fn engine<
    const C: usize,
    const H: usize,
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
    e: &Engine<C, H, D, R, Q, L, LP, HP, PR, T, U, P, PP, GP, S, N>,
    register: EngineRegister,
    i: usize,
    ask: Ask,
) -> Answer {
    use EngineRegister as E;
    let channels = e._channels;
    // The pair and photon of a coordinate, and those of a lane's channel.
    let (pair, photon) = (i / AXES / 2 * AXES + i % AXES, i / AXES % 2);
    let (channel, of_lane) = (i % channels, i / channels);
    match register {
        E::Reset => register!(ask, e, query_flags.reset.q),
        E::TokenValid => register!(ask, e, query_flags.token_valid.q),
        E::NextValid => register!(ask, e, query_flags.next_valid.q),
        E::Keep => register!(ask, e, query_flags.keep.q),
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
        E::Square if e.square_pair[pair].lookup.is_empty() => {
            register!(ask, e, square_pair[pair].square_stage[photon].q)
        }
        E::Square => register!(ask, e, square_pair[pair].lookup[0].square_stage[photon].q),
        E::SquareFar if e.square_pair[pair].lookup.is_empty() => {
            register!(ask, e, square_pair[pair].far_stage[photon].q)
        }
        E::SquareFar => register!(ask, e, square_pair[pair].lookup[0].far_stage[photon].q),
        E::SquareDelay => register!(ask, e, square_pair[pair].square_delay[photon].q),
        E::SquareFarDelay => register!(ask, e, square_pair[pair].far_delay[photon].q),
        E::PairSquare => register!(ask, e, lane[i].pair_square.q),
        E::PairZ => register!(ask, e, lane[i].pair_z.q),
        E::PairFar => register!(ask, e, lane[i].pair_far.q),
        E::Distance => register!(ask, e, lane[i].distance.q),
        E::DistanceFar => register!(ask, e, lane[i].distance_far.q),
        E::InRange => register!(ask, e, lane[i].in_range.q),
        E::RangeWait => register!(ask, e, lane[i % LANES].range_wait[i / LANES].q),
        E::RangeDelay => register!(ask, e, lane[i].range_delay[0].q),
        E::Decision => register!(ask, e, channel_sum[channel].decision[of_lane].q),
        E::PresenceDecision => register!(ask, e, count_sum.decision[i].q),
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
        E::PairFirstDelay => register!(ask, e, group_flags.pair_first_delay[i].q),
        E::GroupPower => register!(ask, e, channel_sum[channel].group.q),
        E::GroupCount => register!(ask, e, count_sum.group.q),
        E::GroupFirst => register!(ask, e, group_flags.group_first.flag[0].q),
        E::GroupLast => register!(ask, e, group_flags.group_last.flag[0].q),
        E::GroupLastDelay => register!(ask, e, group_flags.group_last_delay[i].q),
        E::SumFirst => register!(ask, e, group_flags.first_copy[i].q),
        E::Sum => register!(ask, e, channel_sum[i].sum.q),
        E::Count => register!(ask, e, count_sum.sum.q),
        E::Done => register!(ask, e, group_flags.done.q),
        E::SumDone => register!(ask, e, group_flags.done_copy[i].q),
        E::ResultValid => register!(ask, e, group_flags.result_valid.q),
        E::Result => register!(ask, e, channel_sum[i].result.q),
        E::ResultCount => register!(ask, e, count_sum.result.q),
    }
}

/// A register of the head or of the entry, by the spec's index.
pub(super) fn head<
    const C: usize,
    const H: usize,
    const D: usize,
    const R: usize,
    const Q: usize,
    const L: usize,
    const LP: usize,
    const HP: usize,
    const PR: usize,
    const T: usize,
    const U: usize,
    const B: usize,
    const E: usize,
    const P: usize,
    const PP: usize,
    const GP: usize,
    const S: usize,
    const N: usize,
>(
    m: &SpatialMachine<C, H, D, R, Q, L, LP, HP, PR, T, U, B, E, P, PP, GP, S, N>,
    register: HeadRegister,
    i: usize,
    ask: Ask,
) -> Answer {
    use HeadRegister as H;
    let channels = m.head._channels;
    let words = channels * LANES;
    let channel = i % channels * LANES + i / channels;
    match register {
        H::Loaded => register!(ask, m, head.admission._loaded),
        H::Open => register!(ask, m, head.admission._open),
        H::HasBatch => register!(ask, m, head.admission._has_batch),
        H::Spacing => register!(ask, m, head.admission._spacing),
        H::Waits => register!(ask, m, head.admission._waits),
        H::BatchRead => register!(ask, m, head.admission._gives_back),
        H::Promised => register!(ask, m, head.admission._promised),
        H::WritePlace => register!(ask, m, head.queue._write_place),
        H::NewestPlace => register!(ask, m, head.queue._newest_place),
        H::ReadPlace => register!(ask, m, head.queue._read_place),
        H::HasWaiting => register!(ask, m, head.queue._has_waiting),
        H::HasResult => register!(ask, m, head.queue._has_result),
        H::EntryTokenValid => register!(ask, m, entry_token_valid.flag[0].q),
        H::EntryToken => register!(ask, m, entry_token[i].q),
        H::EntryRadius => register!(ask, m, entry_radius[i].q),
        H::EntryPhoton => register!(ask, m, entry_photon[i].q),
        H::EntryPower => register!(ask, m, entry_mantissa[channel].q),
        H::EntryExponent => register!(ask, m, entry_exponent[i].q),
        H::EntryPresent => register!(ask, m, entry_present[i].q),
        H::EntryTaken => register!(ask, m, entry_taken.q),
        H::EntryFirst => register!(ask, m, entry_first.flag[0].q),
        H::EntryLast => register!(ask, m, entry_last.flag[0].q),
        H::DelayPower if i < words => register!(ask, m, head.decoded[i].q),
        H::DelayPower => {
            register!(ask, m, head.power_delay[i % words].stage[i / words - 1].q)
        }
        H::DelayPresent if i < LANES => register!(ask, m, head.presence[i].is_present.q),
        H::DelayPresent => {
            register!(ask, m, head.present_delay[i % LANES].stage[i / LANES - 1].q)
        }
        H::DelayAbsent => register!(ask, m, head.presence[i].is_absent.q),
        H::DelayFirst => register!(ask, m, head.first_delay.stage[i].flag[0].q),
        H::DelayLast => register!(ask, m, head.last_delay.stage[i].flag[0].q),
    }
}
