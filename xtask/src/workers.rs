//! The same work on many things, as many at once as the machine has cores.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;

/// What `work` makes of each item, in their order. The last ones are begun first.
pub(crate) fn each<Item: Sync, Made: Send + Sync>(items: &[Item], work: impl Fn(&Item) -> Made + Sync) -> Vec<Made> {
    let cores = thread::available_parallelism().map_or(1, std::num::NonZero::get);
    let begun = AtomicUsize::new(0);
    let made: Vec<OnceLock<Made>> = items.iter().map(|_| OnceLock::new()).collect();
    thread::scope(|scope| {
        for _ in 0..cores.min(items.len()) {
            scope.spawn(|| {
                while let Some(k) = items.len().checked_sub(1 + begun.fetch_add(1, Ordering::Relaxed)) {
                    made[k].get_or_init(|| work(&items[k]));
                }
            });
        }
    });
    made.into_iter().filter_map(OnceLock::into_inner).collect()
}

#[cfg(test)]
mod tests {
    use super::each;

    #[test]
    fn the_order_is_that_of_the_items() {
        assert_eq!(each(&[1, 2, 3, 4, 5], |n| n * n), [1, 4, 9, 16, 25]);
        assert!(each(&[0; 0], |n| *n).is_empty());
    }
}
