//! The file survives whatever happens to the program that writes it.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::{Command, Stdio};

use palkki::methods::Method;
use palkki::solvers::Solver;

use super::line::{Line, PATH, Store};
use super::plan::{Job, Route, Subject};
use super::references::Errors;
use crate::Cause;
use crate::report::files;

fn open(root: &Path, fresh: bool, only: &str) -> Result<Store, Cause> {
    Store::open(root, &["machine: a".to_owned()], fresh, |key| key.contains(only))
}

/// Nothing is known of it yet.
fn begun(intervals: usize) -> Line {
    let route = Route::Solver(Method::Force, Solver::Clarabel);
    Line::of(Job { subject: Subject::Gallery("scene"), route, intervals, tolerance: 1e-4 })
}

fn line(number: usize) -> Line {
    begun(number).ended(&format!("why {number}"))
}

#[test]
fn results_are_found_again() {
    let scratch = tempfile::tempdir().expect("a directory for temporary files");
    let mut store = open(scratch.path(), false, "").expect("a new file");
    (0..3).for_each(|k| store.append(line(k)).expect("it can be written"));
    let again = open(scratch.path(), false, "").expect("the same machine");
    assert_eq!(again.lines, store.lines);
    assert_eq!(again.named(&begun(1).name()).map(|line| line.status.as_str()), Some("why 1"));
    let without = open(scratch.path(), true, "clarabel,1,").expect("the same machine");
    assert_eq!(without.lines, [line(0), line(2)], "what is wanted is measured again");
    let elsewhere = Store::open(scratch.path(), &["machine: b".to_owned()], false, |_| true);
    assert!(elsewhere.is_err_and(|error| error.to_string().contains("machine: a")), "machines are not mixed");
}

#[test]
fn numbers_are_read_as_they_were_written() {
    let scratch = tempfile::tempdir().expect("a directory for temporary files");
    let mut store = open(scratch.path(), false, "").expect("a new file");
    let errors = Errors { solver: [f64::NAN; 4], total: [1.234_5e-7, 0.0, 2e-3, 1e-9] };
    store.append(begun(30).with(vec![1.234_56e-3], &errors)).expect("it can be written");
    let read = Store::read(scratch.path()).expect("it can be read").1.lines.remove(0);
    assert_eq!((read.total(), read.of_solver()), (Some([1.23e-7, 0.0, 2e-3, 1e-9]), None), "three digits, and no NaN");
    assert_eq!((read.median_s, read.worst(), read.runs), (Some(1.235e-3), Some(2e-3), Some(1)), "{read:?}");
}

#[test]
fn a_file_with_other_columns_is_not_continued() {
    let scratch = tempfile::tempdir().expect("a directory for temporary files");
    files::replace(&scratch.path().join(PATH), "# machine: a\nscene,route\ns,r\n").expect("it can be written");
    assert!(open(scratch.path(), false, "").is_err_and(|error| error.to_string().contains("--fresh")), "not mixed");
    assert!(open(scratch.path(), true, "s,r").is_ok_and(|store| store.lines.is_empty()), "but begun again");
}

/// Where the process to be killed finds its file.
const VICTIM: &str = "PALKKI_STORE_OF_A_VICTIM";

/// This test starts itself once more, as a process that appends for ever, and kills it while it writes: time and again.
#[test]
fn a_killed_run_goes_on() {
    if let Some(root) = std::env::var_os(VICTIM) {
        let mut store = open(Path::new(&root), false, "").expect("the file of the last victim");
        println!("begun");
        for number in store.lines.len().. {
            store.append(line(number)).expect("it can be written");
        }
    }
    let scratch = tempfile::tempdir().expect("a directory for temporary files");
    let mut before = 0;
    for milliseconds in [1, 2, 5, 10, 20] {
        let mut victim = Command::new(std::env::current_exe().expect("this program"))
            .args(["--exact", "measure::tests::a_killed_run_goes_on", "--nocapture"])
            .env(VICTIM, scratch.path())
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let told = BufReader::new(victim.stdout.take().expect("a pipe")).lines();
        assert!(told.map_while(Result::ok).any(|line| line.contains("begun")), "it began");
        std::thread::sleep(std::time::Duration::from_millis(milliseconds));
        victim.kill().expect("it runs for ever");
        victim.wait().expect("it is dead");

        let store = open(scratch.path(), false, "").expect("the file is whole");
        assert!(before <= store.lines.len(), "no result is lost");
        before = store.lines.len();
        for (number, found) in store.lines.iter().enumerate() {
            assert_eq!(*found, line(number), "every line is whole, in its place");
        }
    }
    assert!(0 < before, "something was written");
}
