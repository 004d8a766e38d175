//! Two-state numbers of any width, for constant folding and for values of more than 64 bits at run time. The
//! operations are plain loops over words; the fast path is that of [`super::program`].

/// An unsigned number of `width` bits; the bits above the width are 0.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct Bits {
    width: u32,
    /// The words, the lowest first.
    words: Vec<u64>,
}

/// The number of words that hold `width` bits; at least one.
pub fn words_of(width: u32) -> usize {
    width.div_ceil(u64::BITS).max(1) as usize
}

/// A mask of the bits in the highest word of a number.
pub fn top_mask(width: u32) -> u64 {
    match width % u64::BITS {
        0 => u64::MAX,
        bits => u64::MAX >> (u64::BITS - bits),
    }
}

impl Bits {
    pub fn zero(width: u32) -> Self {
        let words = vec![0; words_of(width)];
        Self { width, words }
    }

    pub fn ones(width: u32) -> Self {
        let words = vec![u64::MAX; words_of(width)];
        Self::cut(width, words)
    }

    pub fn of(width: u32, value: u64) -> Self {
        let mut words = vec![0; words_of(width)];
        words[0] = value;
        Self::cut(width, words)
    }

    /// The number of the lowest `width` bits of the words. Missing words are 0.
    pub fn cut(width: u32, mut words: Vec<u64>) -> Self {
        words.resize(words_of(width), 0);
        if let Some(top) = words.last_mut() {
            *top &= top_mask(width);
        }
        Self { width, words }
    }

    pub fn width(&self) -> u32 {
        self.width
    }

    pub fn words(&self) -> &[u64] {
        &self.words
    }

    pub fn is_zero(&self) -> bool {
        self.words.iter().all(|&word| word == 0)
    }

    pub fn is_ones(&self) -> bool {
        *self == Self::ones(self.width)
    }

    pub fn bit(&self, index: u32) -> bool {
        index < self.width && self.words[(index / 64) as usize] >> (index % 64) & 1 == 1
    }

    /// The value; `None` where it does not fit 64 bits.
    pub fn to_u64(&self) -> Option<u64> {
        let above = self.words[1..].iter().all(|&word| word == 0);
        above.then_some(self.words[0])
    }

    fn word(&self, index: usize) -> u64 {
        self.words.get(index).copied().unwrap_or(0)
    }

    fn zip(&self, other: &Self, operation: impl Fn(u64, u64) -> u64) -> Self {
        let words = self.words.iter().zip(&other.words);
        let words = words.map(|(&a, &b)| operation(a, b)).collect();
        Self::cut(self.width, words)
    }

    pub fn not(&self) -> Self {
        let words = self.words.iter().map(|&word| !word).collect();
        Self::cut(self.width, words)
    }

    pub fn and(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a & b)
    }

    pub fn or(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a | b)
    }

    pub fn xor(&self, other: &Self) -> Self {
        self.zip(other, |a, b| a ^ b)
    }

    fn add_with(&self, other: &Self, carry: bool) -> Self {
        let mut carry = carry;
        let mut words = Vec::with_capacity(self.words.len());
        for (&a, &b) in self.words.iter().zip(&other.words) {
            let (sum, over) = a.overflowing_add(b);
            let (sum, over_again) = sum.overflowing_add(u64::from(carry));
            carry = over | over_again;
            words.push(sum);
        }
        Self::cut(self.width, words)
    }

    pub fn add(&self, other: &Self) -> Self {
        self.add_with(other, false)
    }

    pub fn subtract(&self, other: &Self) -> Self {
        self.add_with(&other.not(), true)
    }

    pub fn negate(&self) -> Self {
        Self::zero(self.width).subtract(self)
    }

    pub fn multiply(&self, other: &Self) -> Self {
        let mut words = vec![0u64; self.words.len()];
        for (low, &a) in self.words.iter().enumerate() {
            let mut carry = 0;
            for (&b, word) in other.words.iter().zip(&mut words[low..]) {
                let product = u128::from(a) * u128::from(b) + u128::from(*word) + carry;
                *word = product as u64;
                carry = product >> 64;
            }
        }
        Self::cut(self.width, words)
    }

    pub fn less(&self, other: &Self) -> bool {
        self.words.iter().rev().lt(other.words.iter().rev())
    }

    pub fn less_signed(&self, other: &Self) -> bool {
        let sign = self.width.saturating_sub(1);
        match (self.bit(sign), other.bit(sign)) {
            (true, false) => true,
            (false, true) => false,
            _ => self.less(other),
        }
    }

    pub fn parity(&self) -> bool {
        let ones: u32 = self.words.iter().map(|word| word.count_ones()).sum();
        ones % 2 == 1
    }

    pub fn shift_left(&self, amount: &Self) -> Self {
        match self.amount(amount) {
            None => Self::zero(self.width),
            Some(by) => self.up(by, self.width),
        }
    }

    pub fn shift_right(&self, amount: &Self) -> Self {
        match self.amount(amount) {
            None => Self::zero(self.width),
            Some(by) => self.slice(by, self.width),
        }
    }

    pub fn arithmetic_shift_right(&self, amount: &Self) -> Self {
        let filled = self.sign_extend(2 * self.width);
        let by = self.amount(amount).unwrap_or(self.width);
        filled.slice(by, self.width)
    }

    /// A shift's amount; `None` where it shifts out all bits.
    fn amount(&self, amount: &Self) -> Option<u32> {
        let by = amount.to_u64()?;
        (by < u64::from(self.width)).then_some(by as u32)
    }

    /// The number shifted up by `by` bits.
    fn up(&self, by: u32, width: u32) -> Self {
        let (whole, part) = ((by / 64) as usize, by % 64);
        let word = |index: usize| {
            let Some(from) = index.checked_sub(whole) else {
                return 0;
            };
            let low = self.word(from) << part;
            match (part, from.checked_sub(1)) {
                (1.., Some(below)) => low | self.word(below) >> (64 - part),
                _ => low,
            }
        };
        Self::cut(width, (0..words_of(width)).map(word).collect())
    }

    /// `width` bits from bit `low` on. Bits above the number are 0.
    pub fn slice(&self, low: u32, width: u32) -> Self {
        let (whole, part) = ((low / 64) as usize, low % 64);
        let word = |index: usize| {
            let low = self.word(index + whole) >> part;
            match part {
                0 => low,
                _ => low | self.word(index + whole + 1) << (64 - part),
            }
        };
        Self::cut(width, (0..words_of(width)).map(word).collect())
    }

    pub fn zero_extend(&self, width: u32) -> Self {
        Self::cut(width, self.words.clone())
    }

    pub fn sign_extend(&self, width: u32) -> Self {
        let extended = self.zero_extend(width);
        if !self.bit(self.width.saturating_sub(1)) {
            return extended;
        }
        let above = Self::ones(width.saturating_sub(self.width));
        extended.or(&above.up(self.width, width))
    }

    /// The concatenation with this number above `low`.
    pub fn concat(&self, low: &Self) -> Self {
        let width = self.width + low.width;
        self.up(low.width, width).or(&low.zero_extend(width))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use rand::{RngExt, SeedableRng};
    use rand_pcg::Pcg64;

    /// Compares the operations with the machine's own 128-bit integers, at every width up to these.
    #[test]
    fn operations_are_those_of_wide_integers() {
        let rng = &mut Pcg64::seed_from_u64(1);
        for width in (1..=128).cycle().take(5_000) {
            let mask = u128::MAX >> (128 - width);
            let mut any = || rng.random::<u128>() >> rng.random_range(0..128) & mask;
            let (a, b) = (any(), any());
            let by = u64::from(rng.random_range(0..width + 2));
            let bits = |value: u128| Bits::cut(width, vec![value as u64, (value >> 64) as u64]);
            let signed = |value: u128| ((value << (128 - width)) as i128) >> (128 - width);
            let shifted = |value: Option<u128>| bits(value.unwrap_or(0) & mask);
            let (x, y, amount) = (bits(a), bits(b), Bits::of(32, by));
            let by = by as u32;
            assert_eq!(x.add(&y), bits(a.wrapping_add(b) & mask));
            assert_eq!(x.subtract(&y), bits(a.wrapping_sub(b) & mask));
            assert_eq!(x.multiply(&y), bits(a.wrapping_mul(b) & mask));
            assert_eq!(x.negate(), bits(a.wrapping_neg() & mask));
            assert_eq!(x.less(&y), a < b);
            assert_eq!(x.less_signed(&y), signed(a) < signed(b));
            assert_eq!(x.shift_left(&amount), shifted(a.checked_shl(by)));
            assert_eq!(x.shift_right(&amount), shifted(a.checked_shr(by)));
            let filled = signed(a) >> by.min(127);
            assert_eq!(
                x.arithmetic_shift_right(&amount),
                bits(filled as u128 & mask)
            );
            assert_eq!(x.parity(), a.count_ones() % 2 == 1);
            let low = rng.random_range(0..width);
            assert_eq!(
                x.slice(low, width - low),
                Bits::cut(width - low, bits(a >> low).words)
            );
            assert_eq!(x.sign_extend(200).slice(0, width), x);
            assert_eq!(x.sign_extend(200).bit(199), signed(a) < 0);
            let joined = x.concat(&y);
            assert_eq!((joined.slice(width, width), joined.slice(0, width)), (x, y));
        }
    }
}
