//! Places labels around points, without overlaps and inside the chart.

/// A rectangle from (left, top) to (right, bottom), in pixels.
pub type Rect = ((i32, i32), (i32, i32));

/// The places that are occupied.
pub struct Labels {
    taken: Vec<Rect>,
    within: Rect,
}

/// The height of a label in pixels.
const LINE: i32 = 15;
/// The mean width of a character in pixels, rounded up.
const CHARACTER: i32 = 7;
/// Half of a point's size in pixels, plus a margin.
const POINT: i32 = 7;
/// The pixels that a label keeps from a line.
const LINE_MARGIN: i32 = 2;
/// The number of distances that are tried, in steps of [`STEP`].
const STEPS: i32 = 90;
const STEP: i32 = 4;

impl Labels {
    /// Starts with only the points occupied.
    pub fn around(points: &[(i32, i32)], within: Rect) -> Self {
        let r = POINT - 1;
        let square = |&(x, y): &(i32, i32)| ((x - r, y - r), (x + r, y + r));
        let taken = points.iter().map(square).collect();
        Self { taken, within }
    }

    /// Keeps labels from a level or an upright line.
    pub fn avoid(&mut self, from: (i32, i32), to: (i32, i32)) {
        let low = (
            from.0.min(to.0) - LINE_MARGIN,
            from.1.min(to.1) - LINE_MARGIN,
        );
        let high = (
            from.0.max(to.0) + LINE_MARGIN,
            from.1.max(to.1) + LINE_MARGIN,
        );
        self.taken.push((low, high));
    }

    /// The nearest free place for the label of the point; `None` where there is none.
    pub fn place(&mut self, (x, y): (i32, i32), label: &str) -> Option<Rect> {
        let width = CHARACTER * label.chars().count() as i32;
        let corners = (0..STEPS).flat_map(|step| {
            // Just above the point's height, so that a line through the point does not cross the text.
            let (away, middle) = (step * STEP, y - LINE);
            let (right, left) = (x + POINT, x - POINT - width);
            [
                (right, middle - away),
                (right, middle + away),
                (left, middle - away),
                (left, middle + away),
                (x - width / 2, y - POINT - LINE - away),
                (x - width / 2, y + POINT + away),
            ]
        });
        let mut boxes = corners.map(|(left, top)| ((left, top), (left + width, top + LINE)));
        let place = boxes.find(|place| self.is_free(*place))?;
        self.taken.push(place);
        Some(place)
    }

    fn is_free(&self, place: Rect) -> bool {
        let ((left, top), (right, bottom)) = self.within;
        let inside =
            place.0.0 >= left && place.1.0 <= right && place.0.1 >= top && place.1.1 <= bottom;
        inside && !self.taken.iter().any(|taken| overlap(*taken, place))
    }
}

/// The end of a line from the point to its label; `None` if the label is near enough to need no line.
pub fn leader((x, y): (i32, i32), ((left, top), (right, bottom)): Rect) -> Option<(i32, i32)> {
    let (to_x, to_y) = (x.clamp(left, right), y.clamp(top, bottom));
    let far = (to_x - x).abs() > 2 * POINT || (to_y - y).abs() > 2 * POINT;
    far.then_some((to_x, to_y))
}

fn overlap(a: Rect, b: Rect) -> bool {
    a.0.0 < b.1.0 && b.0.0 < a.1.0 && a.0.1 < b.1.1 && b.0.1 < a.1.1
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn labels_of_one_place_stand_apart_and_inside() {
        let within = ((90, 80), (300, 300));
        let place = (95, 105);
        let mut labels = Labels::around(&[place], within);
        let boxes: Vec<_> = (0..8)
            .filter_map(|_| labels.place(place, "label"))
            .collect();
        assert_eq!(boxes.len(), 8);
        for (index, one) in boxes.iter().enumerate() {
            assert!(boxes[..index].iter().all(|other| !overlap(*one, *other)));
            assert!(one.0.0 >= 90 && one.0.1 >= 80 && one.1.0 <= 300 && one.1.1 <= 300);
        }
        assert!(leader(place, boxes[0]).is_none() && leader(place, boxes[7]).is_some());
    }

    #[test]
    fn a_label_keeps_from_a_line() {
        let mut labels = Labels::around(&[(50, 50)], ((0, 0), (200, 200)));
        let free = labels.place((50, 50), "label").unwrap();
        let mut labels = Labels::around(&[(50, 50)], ((0, 0), (200, 200)));
        labels.avoid((free.0.0, free.0.1 + 5), (free.1.0, free.0.1 + 5));
        let other = labels.place((50, 50), "label").unwrap();
        assert!(!overlap(free, other));
    }

    #[test]
    fn where_there_is_no_place_there_is_no_label() {
        let mut labels = Labels::around(&[(5, 5)], ((0, 0), (10, 10)));
        assert_eq!(labels.place((5, 5), "a long label"), None);
    }
}
