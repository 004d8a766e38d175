//! Divides points as a k-d tree does: photons into leaves, and queries into batches.

/// Orders points, given by their numbers, so that each chunk of `size` lies close together: splits them at the middle of their longest
/// axis, at a whole number of chunks, until one chunk is left. Equal arguments give one order.
pub fn close_together(points: &mut [u32], size: usize, position: &impl Fn(u32) -> [i64; 3]) {
    let chunks = points.len().div_ceil(size);
    if chunks < 2 {
        return;
    }
    let extent = |axis: usize| {
        let places = points.iter().map(|point| position(*point)[axis]);
        let [low, high] = [places.clone().min(), places.max()];
        high.unwrap_or(0) - low.unwrap_or(0)
    };
    let axis = (0..3).max_by_key(|axis| extent(*axis)).unwrap_or(0);
    let middle = chunks / 2 * size;
    // The point's own number makes the order total.
    points.select_nth_unstable_by_key(middle, |point| (position(*point)[axis], *point));
    let (low, high) = points.split_at_mut(middle);
    close_together(low, size, position);
    close_together(high, size, position);
}
