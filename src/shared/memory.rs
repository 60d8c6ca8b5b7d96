//! Checks for available memory. They run before memory is filled, because the program would otherwise be aborted without a
//! message.

/// True if `pieces` pieces of `bytes` bytes can be allocated now. The memory is freed at once.
///
/// On a system that overcommits memory the result is true for every amount below the limits of the system.
pub(crate) fn can_be_had(pieces: usize, bytes: usize) -> bool {
    /// Amount of memory that is assumed to be available without a test.
    const LITTLE: usize = 1 << 20;
    let Some(sum) = pieces.checked_mul(bytes) else { return false };
    sum <= LITTLE || Vec::<u8>::new().try_reserve_exact(sum).is_ok()
}

/// A vector of zeros. Small ones reuse memory that was freed recently and is in the cache; large ones come from the system
/// already zeroed.
pub(crate) fn zeros(count: usize) -> Vec<f64> {
    /// 32 kB, the fastest cache of most processors.
    const FEW: usize = 4096;
    if FEW < count {
        return vec![0.0; count];
    }
    let mut zeros = Vec::with_capacity(count);
    zeros.resize(count, 0.0);
    zeros
}

#[cfg(test)]
mod tests {
    use super::can_be_had;

    #[test]
    fn what_no_machine_has_cannot_be_had() {
        assert!(can_be_had(1000, 100));
        assert!(!can_be_had(usize::MAX, 2) && !can_be_had(usize::MAX / 4, 1));
    }
}
