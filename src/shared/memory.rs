//! Memory for a grid. Whether there is enough is checked before it is filled: without it the program would be aborted, without a
//! message.

/// True if so many pieces of so many bytes can be allocated now. They are freed at once.
///
/// On a system that overcommits memory this is true of anything below its limits.
pub(crate) fn can_be_had(pieces: usize, bytes: usize) -> bool {
    /// Bytes that are assumed to be free without a test.
    const LITTLE: usize = 1 << 20;
    let Some(sum) = pieces.checked_mul(bytes) else { return false };
    sum <= LITTLE || Vec::<u8>::new().try_reserve_exact(sum).is_ok()
}

/// So many zeros. Few come from memory that was freed a moment ago and is in the cache, many from the system, which zeroes them.
pub(crate) fn zeros(count: usize) -> Vec<f64> {
    /// 32 kB, the nearest cache of most processors.
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
