//! Eight numbers side by side, and the arithmetic on them in the vector registers of the processor.

use pulp::Simd;

/// Oscillators side by side.
pub(crate) const LANES: usize = 8;
/// One value for each of them.
pub(crate) type Lanes = [f64; LANES];

/// Lanes from their index.
pub(crate) fn lanes(f: impl FnMut(usize) -> f64) -> Lanes {
    std::array::from_fn(f)
}

/// `N` vector registers: as many lanes as are processed together.
pub(crate) type Pack<S, const N: usize> = [<S as Simd>::f64s; N];

/// Arithmetic on [`Pack`]s. Two or more registers at a time hide the latency of each.
#[derive(Clone, Copy)]
pub(crate) struct Unit<S: Simd, const N: usize> {
    pub simd: S,
    /// First lane worked on.
    pub first: usize,
}

impl<S: Simd, const N: usize> Unit<S, N> {
    /// Lanes in a pack.
    pub(crate) const WIDTH: usize = N * S::F64_LANES;

    /// Units that together work on all lanes.
    #[inline(always)]
    pub(crate) fn all(simd: S) -> impl Iterator<Item = Unit<S, N>> {
        (0..LANES / Self::WIDTH).map(move |unit| Unit { simd, first: unit * Self::WIDTH })
    }

    #[inline(always)]
    pub(crate) fn load(self, lanes: &Lanes) -> Pack<S, N> {
        let (registers, _) = S::as_simd_f64s(&lanes[self.first..self.first + Self::WIDTH]);
        std::array::from_fn(|k| registers[k])
    }

    #[inline(always)]
    pub(crate) fn store(self, lanes: &mut Lanes, values: Pack<S, N>) {
        let (registers, _) = S::as_mut_simd_f64s(&mut lanes[self.first..self.first + Self::WIDTH]);
        registers.copy_from_slice(&values);
    }

    #[inline(always)]
    pub(crate) fn splat(self, x: f64) -> Pack<S, N> {
        [self.simd.splat_f64s(x); N]
    }

    #[inline(always)]
    pub(crate) fn mul(self, a: Pack<S, N>, b: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.mul_f64s(a[k], b[k]))
    }

    #[inline(always)]
    pub(crate) fn add(self, a: Pack<S, N>, b: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.add_f64s(a[k], b[k]))
    }

    #[inline(always)]
    pub(crate) fn sub(self, a: Pack<S, N>, b: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.sub_f64s(a[k], b[k]))
    }

    /// a b + c, in one instruction where the processor has it.
    #[inline(always)]
    pub(crate) fn fma(self, a: Pack<S, N>, b: Pack<S, N>, c: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.mul_add_e_f64s(a[k], b[k], c[k]))
    }

    #[inline(always)]
    pub(crate) fn sqrt(self, a: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.sqrt_f64s(a[k]))
    }

    /// The larger of m and a.
    #[inline(always)]
    pub(crate) fn max(self, m: Pack<S, N>, a: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.max_f64s(m[k], a[k]))
    }

    /// The larger of m and |a|.
    #[inline(always)]
    pub(crate) fn max_abs(self, m: Pack<S, N>, a: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.max_f64s(m[k], self.simd.abs_f64s(a[k])))
    }

    /// `a` where x > y, `b` elsewhere.
    #[inline(always)]
    pub(crate) fn choose(self, x: Pack<S, N>, y: Pack<S, N>, a: Pack<S, N>, b: Pack<S, N>) -> Pack<S, N> {
        std::array::from_fn(|k| self.simd.select_f64s(self.simd.greater_than_f64s(x[k], y[k]), a[k], b[k]))
    }
}
