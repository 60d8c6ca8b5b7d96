//! The libraries at the edge: no panic, no hang, nothing printed, no wrong answer certified.

use std::process::Command;

use palkki::route::{Method, Solver};

use palkki_evidence::libraries::ALL;

use crate::scenes::{example, run};

/// The libraries.
const LIBRARIES: [Solver; 2] = [Solver::Clarabel, Solver::Osqp];

/// The most iterations that either may make: the limit of osqp, by its budget of multiplications.
const MOST_ITERATIONS: usize = 200_000;

#[test]
fn every_situation_ends_with_a_verdict() {
    // Hopeless, loose and ordinary ones: there have to be some of each.
    let mut asked = [0; 3];
    for situation in ALL {
        for library in LIBRARIES {
            let raw = situation.run(library).expect("a scene");
            let who = format!("{library}, {}: {raw:?}", situation.name);
            assert!(raw.iterations <= MOST_ITERATIONS, "{who}");
            assert!(!raw.word.is_empty(), "{who}");
            // Without a minimum, or without numbers, nothing can be certified.
            let hopeless = ["NaN", "infinite", "no minimum", "no unknown"].iter().any(|w| situation.name.contains(w));
            assert!(!(hopeless && raw.solved), "{who}");
            // What anything satisfies is no answer, whatever the library calls it.
            let loose = situation.name == "a tolerance that anything reaches";
            assert!(!loose || !raw.solved, "{who}");
            let ordinary = situation.name.starts_with("an ordinary one") || situation.name == "one unknown";
            assert!(!ordinary || raw.solved, "{who}");
            for (count, is) in asked.iter_mut().zip([hopeless, loose, ordinary]) {
                *count += usize::from(is);
            }
        }
    }
    assert!(asked.iter().all(|count| 0 < *count), "{asked:?}");
}

/// Where time and memory would be gone before an answer is there, they are not asked.
#[test]
fn a_grid_that_is_too_fine_is_not_tried() {
    for library in LIBRARIES {
        let raw = run(&example(), Method::Force, library, 100_002);
        assert!(!raw.solved && !raw.run.reports_success, "{library}");
        assert_eq!(raw.run.message, "not tried: 100001 unknowns, 100000 is the limit of this solver", "{library}");
    }
}

#[test]
fn the_same_word_comes_twice() {
    // No clock decides where a run ends: the limits are counts.
    let endless: Vec<_> = ALL.iter().filter(|s| s.name.contains("nothing can reach")).collect();
    assert!(!endless.is_empty(), "a situation in which only a limit ends a run");
    for situation in endless {
        for library in LIBRARIES {
            assert_eq!(situation.run(library), situation.run(library), "{library}, {}", situation.name);
        }
    }
}

/// C prints past whatever captures the output of a test, so another process makes the runs.
#[test]
fn nothing_is_printed() {
    let own = std::env::current_exe().expect("this program");
    let name = "solvers::libraries::every_situation_ends_with_a_verdict";
    let output = Command::new(own).args([name, "--exact", "--nocapture"]).output().expect("it starts again");
    let (out, err) = (String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(output.status.success(), "{out}{err}");
    assert_eq!(err, "", "standard error");
    let known = |line: &str| {
        line.is_empty()
            || ["running 1 test", "test result: ok."].iter().any(|start| line.starts_with(start))
            || line == format!("test {name} ... ok")
    };
    let printed: Vec<&str> = out.lines().filter(|line| !known(line)).collect();
    assert!(printed.is_empty(), "standard output has {printed:#?}");
}
