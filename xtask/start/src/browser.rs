//! `cargo xtask browser`: opens `report/index.html` in an installed browser, without a window, and tries it out.
//!
//! The page tries itself when it is opened as `index.html#selftest`. Here it is put into frames of several widths, in both
//! themes, touched, and printed.

use std::fs::{self, File};
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, ExitCode, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::devtools::Page;
use crate::{doctor, touch};

/// Widths of a screen \[px\]: a desk and a telephone.
const WIDTHS: [u32; 2] = [1280, 390];
/// Height of the screens \[px\].
const HEIGHT: u32 = 900;
/// The longest that the browser may take for one page.
const PATIENCE: Duration = Duration::from_secs(120);
/// The most pages of the report without its annexes.
const REPORT: usize = 18;
/// Lets timers of the page run without waiting for them; clocks stand still then.
const WITHOUT_WAITING: &str = "--virtual-time-budget=60000";
/// What the browser writes of the page's console, among much else of its own.
const CONSOLE: &str = ":CONSOLE";

/// Tries the page; success also if there is no browser, which is said.
pub(crate) fn run() -> ExitCode {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let Some(browser) = doctor::browser() else {
        println!("skipped: no browser is installed; `cargo xtask doctor` says how to get one");
        return ExitCode::SUCCESS;
    };
    match tried(&browser, &root) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: report/index.html in {browser}: {error}");
            ExitCode::FAILURE
        }
    }
}

fn tried(browser: &str, root: &Path) -> Result<(), String> {
    let root = fs::canonicalize(root).map_err(said)?;
    let page = root.join("report/index.html");
    let documents = fs::read_to_string(&page).map_err(|error| format!("{error}; run `cargo xtask report`"))?;
    let documents = documents.matches("<article ").count();
    let browser = Browser { program: browser, place: root.join("target/browser") };
    // What an earlier run left there; if there is none, there is nothing to do.
    let _ = fs::remove_dir_all(&browser.place);
    fs::create_dir_all(&browser.place).map_err(said)?;
    for width in WIDTHS {
        for (theme, preferred) in [("light", 1), ("dark", 0)] {
            let page = page.display();
            let frame = format!(
                "<!doctype html><meta charset=\"utf-8\"><p>nothing</p>\
                 <script>onmessage = (e) => {{ document.querySelector('p').textContent = e.data }}</script>\
                 <iframe src=\"file://{page}#selftest\" width=\"{width}\" height=\"{HEIGHT}\"></iframe>"
            );
            let address = browser.place.join("frame.html");
            fs::write(&address, frame).map_err(said)?;
            let arguments =
                ["--dump-dom", &format!("--blink-settings=preferredColorScheme={preferred}"), WITHOUT_WAITING];
            let (shown, logged) = browser.open(&arguments, &address)?;
            let heard = shown.split_once("<p>").and_then(|(_, rest)| rest.split_once("</p>")).map_or("", |(p, _)| p);
            println!("{theme:<5} {heard}");
            if !(heard.starts_with(&format!("{width} px")) && heard.ends_with(": passed")) {
                return Err(format!("at {width} px, {theme}: {heard}"));
            }
            if let Some(line) = logged.lines().find(|line| line.contains(CONSOLE)) {
                return Err(format!("at {width} px, {theme}, on the console: {line}"));
            }
        }
    }
    // With the clock of the machine, and therefore no check: the page itself checks how much work a frame is.
    let (shown, _) = browser.open(&["--dump-dom"], &page.with_file_name("index.html#frames"))?;
    let frames =
        shown.split_once("data-frames=\"").and_then(|(_, rest)| rest.split_once('"')).map_or("", |(said, _)| said);
    if frames.is_empty() {
        return Err(String::from("frames were not measured"));
    }
    println!("frame {frames}, with a grid of 300 intervals");
    println!("touch {}", touch::tried(&mut browser.told()?, &format!("file://{}", page.display()))?);
    let print = |page: &Path| {
        let printed = browser.place.join("index.pdf");
        let to = format!("--print-to-pdf={}", printed.display());
        browser.open(&["--no-pdf-header-footer", &to, WITHOUT_WAITING], page)?;
        Ok::<_, String>(pages(&fs::read(printed).map_err(said)?))
    };
    let (all, report) = (print(&page)?, print(&page.with_file_name("index.html#print"))?);
    println!("print {all} pages, the report alone {report}");
    // Each document begins a new one.
    if all < documents || REPORT < report {
        return Err(format!(
            "{documents} documents are {all} printed pages, the report {report}; at most {REPORT} were promised"
        ));
    }
    Ok(())
}

fn said(error: io::Error) -> String {
    error.to_string()
}

/// The pages of a PDF.
fn pages(pdf: &[u8]) -> usize {
    let page = b"/Type /Page\n";
    pdf.windows(page.len()).filter(|window| window == page).count()
}

/// A browser, and where it may write.
#[derive(Debug)]
struct Browser<'a> {
    program: &'a str,
    place: PathBuf,
}

/// Where the browser writes.
const CHANNELS: [&str; 2] = ["shown", "logged"];

impl Browser<'_> {
    /// Starts the browser with a profile of this name; what it writes goes to files.
    fn started(&self, profile: &str, arguments: &[&str]) -> Result<Child, String> {
        let [shown, logged] = CHANNELS.map(|name| self.place.join(name));
        Command::new(self.program)
            // The page is our own, and root, who runs many a check, has no sandbox.
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"])
            .args(["--disable-background-networking", "--disable-component-update", "--enable-logging=stderr"])
            .arg("--window-size=1400,1000")
            .arg(format!("--user-data-dir={}", self.place.join(profile).display()))
            .args(arguments)
            .stdin(Stdio::null())
            .stdout(File::create(shown).map_err(said)?)
            .stderr(File::create(logged).map_err(said)?)
            .spawn()
            .map_err(said)
    }

    /// The page in a browser that is told what to do.
    fn told(&self) -> Result<Page, String> {
        const PROFILE: &str = "told";
        Page::of(self.started(PROFILE, &["--remote-debugging-port=0", "about:blank"])?, &self.place.join(PROFILE))
    }

    /// Opens a file and returns what the browser writes on its two channels.
    fn open(&self, arguments: &[&str], file: &Path) -> Result<(String, String), String> {
        let address = format!("file://{}", file.display());
        let mut child = self.started("profile", &[arguments, &[&address]].concat())?;
        let [shown, logged] = CHANNELS.map(|name| self.place.join(name));
        let begun = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().map_err(said)? {
                break status;
            }
            if PATIENCE < begun.elapsed() {
                // It is being given up; what it says to that does not matter.
                let _ = child.kill().and_then(|()| child.wait());
                return Err(format!("it did not end in {} s", PATIENCE.as_secs()));
            }
            sleep(Duration::from_millis(50));
        };
        let texts =
            [&shown, &logged].map(|path| fs::read(path).map(|text| String::from_utf8_lossy(&text).into_owned()));
        let [shown, logged] = texts;
        let (shown, logged) = (shown.map_err(said)?, logged.map_err(said)?);
        if status.success() { Ok((shown, logged)) } else { Err(format!("it ended with {status}:\n{logged}")) }
    }
}

#[cfg(test)]
mod tests {
    use super::pages;

    #[test]
    fn pages_are_counted_and_their_list_is_not() {
        assert_eq!(pages(b"<</Type /Page\n/A 1>><</Type /Pages\n>><</Type /Page\n>>"), 2);
    }
}
