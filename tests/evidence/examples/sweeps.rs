//! Compares the events of random sweeps, `sweeps FIRST LAST`: one line for each that depends on the number of rows or the direction.
#![expect(clippy::print_stdout, reason = "a command that talks to a person")]

use palkki_evidence::sweeps::faults;

fn main() {
    let ends: Vec<u64> = std::env::args().skip(1).filter_map(|end| end.parse().ok()).collect();
    let [first, last] = ends[..] else { return };
    let (mut events, mut bad) = (0, 0);
    for i in first..last {
        let (count, wrong) = faults(i, 1e-9);
        events += count;
        bad += u64::from(!wrong.is_empty());
        wrong.iter().for_each(|line| println!("{line}"));
    }
    println!("{events} events; {bad} of {} sweeps differ", last - first);
}
