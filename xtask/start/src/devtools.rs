//! A browser that is told what to do, over its debugging protocol: messages in JSON on a WebSocket of this machine.
//!
//! Only so much of either as the checks of the page take. No text that is sent has quotes in it, and no answer is nested.

use std::fs;
use std::io::{Read as _, Write as _};
use std::net::TcpStream;
use std::path::Path;
use std::process::Child;
use std::thread::sleep;
use std::time::{Duration, Instant};

/// The longest that the browser may take to begin, or for one answer.
const PATIENCE: Duration = Duration::from_secs(60);
/// Between two looks at whether something is there.
const PAUSE: Duration = Duration::from_millis(50);
/// The file in which the browser says on which port it listens.
const PORT: &str = "DevToolsActivePort";

/// A page of a browser that listens; the browser ends with it.
#[derive(Debug)]
pub(crate) struct Page {
    browser: Child,
    stream: TcpStream,
    /// How many messages were sent.
    sent: u32,
}

impl Page {
    /// The first page of a browser that was started with `--remote-debugging-port=0` and this folder for its profile.
    pub(crate) fn of(browser: Child, profile: &Path) -> Result<Self, String> {
        let mut browser = browser;
        match connected(profile) {
            Ok(stream) => Ok(Self { browser, stream, sent: 0 }),
            Err(error) => {
                // It is being given up; what it says to that does not matter.
                let _ = browser.kill().and_then(|()| browser.wait());
                Err(error)
            }
        }
    }

    /// Asks for something and returns the answer.
    pub(crate) fn ask(&mut self, method: &str, parameters: &str) -> Result<String, String> {
        self.sent += 1;
        let id = self.sent;
        let message = format!("{{\"id\":{id},\"method\":\"{method}\",\"params\":{{{parameters}}}}}");
        self.stream.write_all(&frame(message.as_bytes())).map_err(said)?;
        loop {
            let answer = message_from(&mut self.stream)?;
            if answer.starts_with(&format!("{{\"id\":{id},")) {
                let failed = answer.contains("\"error\":{") || answer.contains("\"exceptionDetails\"");
                return if failed { Err(format!("{method}: {answer}")) } else { Ok(answer) };
            }
        }
    }

    /// The numbers of an array that an expression comes to.
    pub(crate) fn numbers(&mut self, expression: &str) -> Result<Vec<f64>, String> {
        let joined = format!("({expression}).map(Number).join(' ')");
        let answer = self.ask("Runtime.evaluate", &format!("\"expression\":\"{joined}\""))?;
        let text = answer.split_once("\"value\":\"").and_then(|(_, rest)| rest.split_once('"')).map(|(text, _)| text);
        let numbers: Result<_, _> = text.unwrap_or_default().split_whitespace().map(str::parse::<f64>).collect();
        numbers.map_err(|_| format!("{expression} is not numbers: {answer}"))
    }

    /// Waits until an expression is true.
    pub(crate) fn until(&mut self, expression: &str) -> Result<(), String> {
        let begun = Instant::now();
        while self.numbers(&format!("[{expression}]"))? != [1.0] {
            if PATIENCE < begun.elapsed() {
                return Err(format!("{expression} did not become true"));
            }
            sleep(PAUSE);
        }
        Ok(())
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        // It has done its work.
        let _ = self.browser.kill().and_then(|()| self.browser.wait());
    }
}

fn said(error: std::io::Error) -> String {
    format!("the debugging protocol: {error}")
}

/// A connection to the first page of the browser with this profile.
fn connected(profile: &Path) -> Result<TcpStream, String> {
    let begun = Instant::now();
    let port = loop {
        let told = fs::read_to_string(profile.join(PORT)).unwrap_or_default();
        if let Some(port) = told.lines().next().and_then(|port| port.parse::<u16>().ok()) {
            break port;
        }
        if PATIENCE < begun.elapsed() {
            return Err(String::from("the browser does not say on which port it listens"));
        }
        sleep(PAUSE);
    };
    let host = format!("127.0.0.1:{port}");
    let socket = format!("ws://{host}");
    let path = loop {
        let list = http(&host, "GET /json/list HTTP/1.1\r\n")?.1;
        let pages = list.split("webSocketDebuggerUrl").skip(1);
        let path =
            pages.filter_map(|page| page.split_once(&socket)?.1.split_once('"')).map(|(path, _)| path.to_owned());
        if let Some(path) = path.into_iter().find(|path| path.contains("/page/")) {
            break path;
        }
        if PATIENCE < begun.elapsed() {
            return Err(format!("the browser has no page: {list}"));
        }
        sleep(PAUSE);
    };
    // A key that is always the same: the connection is not secret.
    let upgrade = "Upgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\n\
                   Sec-WebSocket-Key: AAAAAAAAAAAAAAAAAAAAAA==\r\n";
    let (stream, head) = http(&host, &format!("GET {path} HTTP/1.1\r\n{upgrade}"))?;
    if head.starts_with("HTTP/1.1 101") { Ok(stream) } else { Err(format!("no WebSocket: {head}")) }
}

/// Sends a request; the answer is its head, and a body of the length that the head gives.
fn http(host: &str, request: &str) -> Result<(TcpStream, String), String> {
    let mut stream = TcpStream::connect(host).map_err(said)?;
    stream.set_read_timeout(Some(PATIENCE)).map_err(said)?;
    stream.write_all(format!("{request}Host: {host}\r\n\r\n").as_bytes()).map_err(said)?;
    let (mut answer, mut byte) = (Vec::new(), [0]);
    while !answer.ends_with(b"\r\n\r\n") {
        stream.read_exact(&mut byte).map_err(said)?;
        answer.push(byte[0]);
    }
    let head = String::from_utf8_lossy(&answer).to_lowercase();
    let length = head.split_once("content-length:").and_then(|(_, rest)| rest.lines().next()?.trim().parse().ok());
    (&stream).take(length.unwrap_or(0)).read_to_end(&mut answer).map_err(said)?;
    Ok((stream, String::from_utf8_lossy(&answer).into_owned()))
}

/// A text as the client of a WebSocket sends it (RFC 6455), with a mask that changes nothing.
fn frame(text: &[u8]) -> Vec<u8> {
    const WHOLE_TEXT: u8 = 0x81;
    const MASKED: u8 = 0x80;
    let mut bytes = vec![WHOLE_TEXT];
    match (u8::try_from(text.len()), u16::try_from(text.len())) {
        (Ok(length @ ..=125), _) => bytes.push(MASKED | length),
        (_, Ok(length)) => {
            bytes.push(MASKED | 126);
            bytes.extend(length.to_be_bytes());
        }
        _ => {
            bytes.push(MASKED | 127);
            bytes.extend((text.len() as u64).to_be_bytes());
        }
    }
    bytes.extend([0; 4]);
    bytes.extend(text);
    bytes
}

/// The next text that the server sends.
fn message_from(stream: &mut TcpStream) -> Result<String, String> {
    let mut text = Vec::new();
    loop {
        let mut head = [0; 2];
        stream.read_exact(&mut head).map_err(said)?;
        let length = match head[1] & 0x7f {
            126 => {
                let mut long = [0; 2];
                stream.read_exact(&mut long).map_err(said)?;
                u64::from(u16::from_be_bytes(long))
            }
            127 => {
                let mut long = [0; 8];
                stream.read_exact(&mut long).map_err(said)?;
                u64::from_be_bytes(long)
            }
            short => u64::from(short),
        };
        let mut part = Vec::new();
        stream.take(length).read_to_end(&mut part).map_err(said)?;
        // Kinds above 7 are pings and the like.
        if head[0] & 0xf < 8 {
            text.extend(part);
            if head[0] & 0x80 != 0 {
                return Ok(String::from_utf8_lossy(&text).into_owned());
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::frame;

    #[test]
    fn frames_of_all_sizes_say_how_long_they_are() {
        for (length, head) in [
            (2, vec![0x81, 0x82]),
            (125, vec![0x81, 0xfd]),
            (126, vec![0x81, 0xfe, 0, 126]),
            (70_000, vec![0x81, 0xff, 0, 0, 0, 0, 0, 1, 0x11, 0x70]),
        ] {
            let bytes = frame(&vec![b'x'; length]);
            assert!(bytes.starts_with(&head) && bytes.len() == head.len() + 4 + length, "{length}");
        }
    }
}
