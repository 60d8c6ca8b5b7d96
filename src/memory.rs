//! Whether there is memory for a grid, asked before it is filled: without it the program would be aborted, with no word of why.

/// True if so many pieces of so many bytes can be had at once now. They are given back at once.
///
/// A system that promises more memory than it has says yes to anything below its limits.
pub(crate) fn can_be_had(pieces: usize, bytes: usize) -> bool {
    let Some(sum) = pieces.checked_mul(bytes) else { return false };
    Vec::<u8>::new().try_reserve_exact(sum).is_ok()
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
