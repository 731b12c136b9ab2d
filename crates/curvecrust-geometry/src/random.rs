//! Random numbers that are the same on every machine.

/// The generator SplitMix64, with a seed and without global state.
///
/// Whatever is random in this workspace draws from it: its seed decides its results, to the bit.
/// It passes the usual statistical tests and is no generator for secrets.
///
/// Source: G. Steele, D. Lea, C. Flood, *Fast Splittable Pseudorandom Number Generators*,
/// OOPSLA 2014.
///
/// ```
/// use curvecrust_geometry::Random;
///
/// let mut random = Random::new(7);
/// let radius = random.between(0.5, 1.5);
/// assert!((0.5..1.5).contains(&radius));
/// assert_eq!(radius, Random::new(7).between(0.5, 1.5));
/// ```
#[derive(Clone, Debug)]
pub struct Random(u64);

impl Random {
    /// The sequence of a seed.
    #[must_use]
    pub fn new(seed: u64) -> Self {
        Self(seed)
    }

    /// The next 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in 0..1, uniform among the multiples of 2^-52.
    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 12) as f64 / (1u64 << 52) as f64
    }

    /// A number from `low` up to `high`: [`unit`](Self::unit) as a share of the way.
    ///
    /// Where `high - low` is rounded, the result may be `high` itself.
    pub fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// As [`between`](Self::between), from twice as many numbers: multiples of 2^-53 of the way.
    ///
    /// The same bits give the same number but for the last of them, so that the two methods are
    /// not interchangeable where results have to stay.
    pub fn fine_between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// A whole number below `count`; 0 if `count` is 0.
    ///
    /// Of 2^64 / `count` equally likely values, rounded up or down, each is the image: even enough
    /// for any `count` of things in memory.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the high word of the product is below the count"
    )]
    pub fn below(&mut self, count: usize) -> usize {
        ((u128::from(self.bits()) * count as u128) >> 64) as usize
    }

    /// A normal number of mean 0 and variance 1.
    ///
    /// Its last digits are those of the platform's logarithm and cosine.
    /// Source: G. Box, M. Muller, *A Note on the Generation of Random Normal Deviates*, 1958.
    pub fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.unit()).cos()
    }

    /// Brings the items into a random order.
    /// Source: R. Durstenfeld, *Algorithm 235: Random Permutation*, 1964.
    pub fn shuffle<T>(&mut self, items: &mut [T]) {
        for last in (1..items.len()).rev() {
            items.swap(last, self.below(last + 1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn bits_are_those_of_splitmix64() {
        let mut random = Random::new(0);
        let known = [
            0xe220_a839_7b1d_cdaf,
            0x6e78_9e6a_a1b9_65f4,
            0x06c4_5d18_8009_454f,
        ];
        assert_eq!([0; 3].map(|_| random.bits()), known);
    }

    #[test]
    fn numbers_are_in_their_ranges_and_evenly_spread() {
        let mut random = Random::new(3);
        let mut counts = [[0_u32; 10]; 3];
        for _ in 0..10_000 {
            let [unit, between] = [random.unit(), random.fine_between(-3.0, 7.0)];
            assert!((0.0..1.0).contains(&unit) && (-3.0..7.0).contains(&between));
            let tenths = [10.0 * unit, between + 3.0]
                .map(|x| (1..10).filter(|&i| x >= f64::from(i)).count());
            for (counts, tenth) in counts
                .iter_mut()
                .zip([tenths[0], tenths[1], random.below(10)])
            {
                counts[tenth] += 1;
            }
        }
        assert!(
            counts
                .as_flattened()
                .iter()
                .all(|&n| (900..1_100).contains(&n))
        );
        assert_eq!([random.below(0), random.below(1)], [0, 0]);
    }

    #[test]
    fn fine_numbers_differ_by_one_bit_at_most() {
        let (mut coarse, mut fine) = (Random::new(5), Random::new(5));
        let bit = 2f64.powi(-53);
        let mut larger = 0;
        for _ in 0..1_000 {
            let difference = fine.fine_between(0.0, 1.0) - coarse.unit();
            assert!((0.0..=bit).contains(&difference));
            larger += usize::from(difference > 0.0);
        }
        assert!((400..600).contains(&larger));
    }

    #[test]
    fn normal_numbers_have_mean_0_and_variance_1() {
        let mut random = Random::new(11);
        let numbers: Vec<f64> = (0..40_000).map(|_| random.normal()).collect();
        let mean =
            |power: i32| numbers.iter().map(|x| x.powi(power)).sum::<f64>() / numbers.len() as f64;
        assert!(mean(1).abs() < 0.02 && (mean(2) - 1.0).abs() < 0.02);
        assert!(mean(3).abs() < 0.08 && (mean(4) - 3.0).abs() < 0.15);
    }

    #[test]
    fn every_order_of_three_is_as_likely() {
        let mut random = Random::new(1);
        let mut counts = [0_u32; 27];
        for _ in 0..6_000 {
            let mut items = [0_usize, 1, 2];
            random.shuffle(&mut items);
            counts[items[0] * 9 + items[1] * 3 + items[2]] += 1;
        }
        let orders: Vec<u32> = counts.into_iter().filter(|&n| n > 0).collect();
        assert_eq!(orders.len(), 6);
        assert!(orders.iter().all(|n| (900..1_100).contains(n)));
    }
}
