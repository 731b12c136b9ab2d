//! Random numbers that are the same on every machine, and seeds that depend on nothing but names.

/// SplitMix64: Steele, Lea, Flood, "Fast Splittable Pseudorandom Number Generators", OOPSLA 2014.
pub(super) struct Random(u64);

/// The seed of a trial: of the experiment's seed, the names of what is run, and the trial's number.
/// Adding inputs, values or trials leaves the seeds of the others as they are.
pub(super) fn seed_of(seed: u64, experiment: &str, series: &str, x: f64, trial: u32) -> u64 {
    let names = format!("{experiment}\n{series}\n{x}\n{trial}");
    // FNV-1a, then mixed.
    let hash = names
        .bytes()
        .fold(0xcbf2_9ce4_8422_2325, |hash: u64, byte| {
            (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3)
        });
    Random(seed ^ hash).bits()
}

impl Random {
    pub(super) fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number in 0..1.
    pub(super) fn unit(&mut self) -> f64 {
        f64::from_bits(self.bits() >> 12 | 1023 << 52) - 1.0
    }

    pub(super) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// A number below `count`, which must not be 0.
    #[expect(
        clippy::cast_possible_truncation,
        reason = "the high word of the product is below the count"
    )]
    pub(super) fn below(&mut self, count: usize) -> usize {
        ((u128::from(self.bits()) * count as u128) >> 64) as usize
    }

    /// A normal number of mean 0 and variance 1: Box and Muller, 1958.
    pub(super) fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.unit()).cos()
    }
}
