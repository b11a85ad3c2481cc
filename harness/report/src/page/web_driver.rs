//! A client of ChromeDriver for tests that press keys: the few commands of the WebDriver protocol that they need.

use super::browser_tests::installed;
use serde_json::{Value, json};
use std::io::{self, BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};

/// The variable that names a ChromeDriver.
const VARIABLE: &str = "STICKLER_CHROMEDRIVER";

/// The key that moves the focus.
pub(super) const TAB: char = '\u{e004}';

/// A key that changes nothing.
const SHIFT: char = '\u{e008}';

/// The maximum number of keys that a page may miss while it is opened.
const MAX_PRESSES: usize = 100;

/// A browser under control; it is closed at the end.
pub(super) struct WebDriver {
    driver: Child,
    port: u16,
    session: String,
}

impl WebDriver {
    /// Starts a browser; prints why the test is skipped where no ChromeDriver is installed.
    pub(super) fn start(browser: &Path, options: &[&str]) -> Option<WebDriver> {
        let missing = "no ChromeDriver is installed to press keys in index.html with";
        let program = installed(VARIABLE, &["chromedriver"], missing)?;
        let mut driver = Command::new(program)
            .arg("--port=0")
            .stdout(Stdio::piped())
            .spawn()
            .expect("a ChromeDriver that starts");
        let output = BufReader::new(driver.stdout.take().expect("its output"));
        let port = output.lines().map_while(Result::ok).find_map(|line| {
            let (_, port) = line.split_once("successfully on port ")?;
            port.trim_end_matches('.').parse().ok()
        });
        let mut started = WebDriver {
            driver,
            port: port.expect("a line that tells the port"),
            session: String::new(),
        };
        let chrome = json!({ "binary": browser, "args": options });
        let capabilities = json!({ "capabilities": { "alwaysMatch": { "goog:chromeOptions": chrome } } });
        let session = started.request("POST", "/session", &capabilities);
        session["sessionId"]
            .as_str()
            .expect("a session")
            .clone_into(&mut started.session);
        Some(started)
    }

    /// Opens an address, and returns once the page receives keys: a browser drops those that come before the first painting.
    pub(super) fn open(&self, address: &str) {
        self.command("url", &json!({ "url": address }));
        self.value("addEventListener('keydown', () => { document.hears = true; }, { once: true })");
        let hears = (0..MAX_PRESSES).any(|_| {
            self.press([SHIFT]);
            self.value("document.hears === true") == true
        });
        assert!(hears, "{address} receives no key");
    }

    /// Goes to a place of the page, such as `#REAL_TO_INT`, at which it is not yet, and returns once the page shows it.
    pub(super) fn follow(&self, hash: &str) {
        // The page listens to the same event, and was first.
        let script = "const [hash, done] = arguments; \
            addEventListener('hashchange', () => done(), { once: true }); location.hash = hash;";
        self.command("execute/async", &json!({ "script": script, "args": [hash] }));
    }

    /// Gives the window these outer measures in pixels.
    pub(super) fn resize(&self, width: u32, height: u32) {
        self.command("window/rect", &json!({ "width": width, "height": height }));
    }

    /// Presses the keys of a text one after the other.
    pub(super) fn press(&self, keys: impl IntoIterator<Item = char>) {
        let presses = keys.into_iter().flat_map(|key| {
            ["keyDown", "keyUp"].map(|kind| json!({ "type": kind, "value": key.to_string() }))
        });
        let keyboard = json!({ "type": "key", "id": "keyboard", "actions": presses.collect::<Vec<_>>() });
        self.command("actions", &json!({ "actions": [keyboard] }));
    }

    /// Returns the value of an expression once the page has answered to all that was done before.
    pub(super) fn value(&self, expression: &str) -> Value {
        let script =
            format!("const done = arguments[0]; setTimeout(() => setTimeout(() => done({expression})))");
        self.command("execute/async", &json!({ "script": script, "args": [] }))
    }

    fn command(&self, name: &str, body: &Value) -> Value {
        self.request("POST", &format!("/session/{}/{name}", self.session), body)
    }

    fn request(&self, method: &str, path: &str, body: &Value) -> Value {
        let answer = self
            .exchange(method, path, body)
            .expect("an answer of the driver");
        assert!(answer["value"].get("error").is_none(), "{path}: {answer}");
        answer["value"].clone()
    }

    fn exchange(&self, method: &str, path: &str, body: &Value) -> io::Result<Value> {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port))?;
        let body = body.to_string();
        write!(
            stream,
            "{method} {path} HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\nContent-Type: application/json\r\n\
             Content-Length: {}\r\n\r\n{body}",
            body.len()
        )?;
        let mut response = BufReader::new(stream);
        let mut length = 0;
        let mut line = String::new();
        while response.read_line(&mut line)? > 0 && line != "\r\n" {
            if let Some(number) = line.to_ascii_lowercase().strip_prefix("content-length:") {
                length = number.trim().parse().map_err(io::Error::other)?;
            }
            line.clear();
        }
        Ok(serde_json::from_reader(response.take(length))?)
    }
}

impl Drop for WebDriver {
    fn drop(&mut self) {
        // Also where a test failed: a browser whose driver is gone lives on.
        let _ = self.exchange("DELETE", &format!("/session/{}", self.session), &json!({}));
        let _ = self.driver.kill();
        let _ = self.driver.wait();
    }
}
