//! The file survives whatever happens to the program that writes it.

use std::io::{BufRead, BufReader};
use std::process::{Command, Stdio};

use super::*;

/// A root of its own.
struct Scratch(PathBuf);

impl Scratch {
    fn new(name: &str) -> Self {
        let place = std::env::temp_dir().join(format!("palkki-store-{}-{name}", std::process::id()));
        fs::create_dir_all(place.join("report/data")).expect("a scratch directory can be made");
        Self(place)
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        // What stays is in the directory for temporary files.
        let _ = fs::remove_dir_all(&self.0);
    }
}

fn open(root: &Path, fresh: bool, only: &str) -> Result<Store, String> {
    Store::open(root, &["machine: a".to_owned()], fresh, |key| key.contains(only))
}

fn line(number: usize) -> Line {
    Line::without_result(format!("scene,route,{number},1e-4"), format!("why {number}"))
}

#[test]
fn results_are_found_again() {
    let scratch = Scratch::new("again");
    let mut store = open(&scratch.0, false, "").expect("a new file");
    (0..3).for_each(|k| store.append(&line(k)).expect("it can be written"));
    let again = open(&scratch.0, false, "").expect("the same machine");
    assert_eq!(again.lines, store.lines);
    assert_eq!(again.find("scene,route,1,1e-4").and_then(|line| line.field("status")), Some("why 1"));
    let without = open(&scratch.0, true, "route,1,").expect("the same machine");
    assert_eq!(without.lines, [line(0), line(2)], "what is wanted is measured again");
    let elsewhere = Store::open(&scratch.0, &["machine: b".to_owned()], false, |_| true);
    assert!(elsewhere.is_err_and(|message| message.contains("machine: a")), "machines are not mixed");
}

#[test]
fn a_file_that_ends_anywhere_is_read_as_far_as_it_goes() {
    let whole = format!(
        "# machine: a\n{HEADER}\ns,r,10,1e-4,certified,success,1.00e-16,,,3,9,5,1e-3,1e-3,1e-3\ns,r,30,1e-4,left-out\n"
    );
    for end in 0..whole.len() {
        let store = Store::parse(PathBuf::new(), &whole[..end]);
        assert!(store.lines.len() <= 2, "{store:?}");
        for line in &store.lines {
            assert!(line.key().starts_with("s,r,"), "{line:?} of {end} bytes");
        }
    }
}

#[test]
fn a_file_with_fewer_columns_is_read_and_not_continued() {
    let scratch = Scratch::new("columns");
    fs::write(
        scratch.0.join(PATH),
        "# machine: a\nscene,route,intervals,tolerance,status,median_s\ns,r,10,0e0,certified,2e-3\n",
    )
    .expect("the scratch directory can be written to");
    let store = Store::read(&scratch.0).expect("it can be read");
    assert_eq!(store.lines[0].seconds(), Some(2e-3));
    assert_eq!(store.lines[0].number("peak_kb"), None);
    assert!(open(&scratch.0, false, "").is_err_and(|message| message.contains("other columns")), "not mixed");
    assert!(open(&scratch.0, true, "s,r").is_ok_and(|store| store.lines.is_empty()), "but begun again");
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
            store.append(&line(number)).expect("it can be written");
        }
    }
    let scratch = Scratch::new("killed");
    let mut before = 0;
    for milliseconds in [1, 2, 5, 10, 20] {
        let mut victim = Command::new(std::env::current_exe().expect("this program"))
            .args(["--exact", "measure::store::tests::a_killed_run_goes_on", "--nocapture"])
            .env(VICTIM, &scratch.0)
            .stdout(Stdio::piped())
            .spawn()
            .expect("it starts");
        let told = BufReader::new(victim.stdout.take().expect("a pipe")).lines();
        assert!(told.map_while(Result::ok).any(|line| line.contains("begun")), "it began");
        std::thread::sleep(std::time::Duration::from_millis(milliseconds));
        victim.kill().expect("it runs for ever");
        victim.wait().expect("it is dead");

        let store = open(&scratch.0, false, "").expect("the file is whole");
        assert!(before <= store.lines.len(), "no result is lost");
        before = store.lines.len();
        for (number, found) in store.lines.iter().enumerate() {
            assert_eq!(*found, line(number), "every line is whole, in its place");
        }
    }
    assert!(0 < before, "something was written");
}
