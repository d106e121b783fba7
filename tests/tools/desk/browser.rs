//! A headless Chromium, driven through its own protocol (Chrome DevTools) over a pipe: JSON messages that end with a zero byte.

use std::collections::VecDeque;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, ChildStdout, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// Longest wait for what should be there at once, on a busy machine.
const PATIENCE: Duration = Duration::from_secs(60);

/// A browser with one page.
pub(crate) struct Browser {
    program: Child,
    input: ChildStdin,
    output: BufReader<ChildStdout>,
    count: u64,
    session: Option<String>,
    /// Errors that the page has thrown or logged.
    pub(crate) faults: Vec<String>,
    events: VecDeque<Value>,
    _profile: tempfile::TempDir,
}

impl Browser {
    /// Starts it with an empty page.
    pub(crate) fn start(chromium: &Path) -> Browser {
        let profile = tempfile::tempdir().expect("a temporary folder");
        // The shell gives the pipe the numbers that the browser expects.
        let script = "exec \"$0\" \"$@\" 3<&0 4>&1 0</dev/null 1>/dev/null 2>/dev/null";
        let mut program = Command::new("sh")
            .args(["-c", script])
            .arg(chromium)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--disable-quic", "--no-first-run", "--disable-sync"])
            .args(["--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-background-networking"])
            .args(["--disable-component-update", "--disable-dev-shm-usage", "--remote-debugging-pipe"])
            .arg(format!("--user-data-dir={}", profile.path().display()))
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("sh runs");
        let (input, output) = (program.stdin.take().expect("piped"), program.stdout.take().expect("piped"));
        let output = BufReader::new(output);
        let (faults, events) = (Vec::new(), VecDeque::new());
        let mut browser =
            Browser { program, input, output, count: 0, session: None, faults, events, _profile: profile };
        let target = browser.call("Target.createTarget", &json!({ "url": "about:blank" }))["targetId"].clone();
        let attached = browser.call("Target.attachToTarget", &json!({ "targetId": target, "flatten": true }));
        browser.session = attached["sessionId"].as_str().map(str::to_owned);
        for domain in ["Page", "Runtime", "Log", "DOM"] {
            browser.call(&format!("{domain}.enable"), &json!({}));
        }
        browser
    }

    /// Calls a method; returns its result.
    pub(crate) fn call(&mut self, method: &str, params: &Value) -> Value {
        self.count += 1;
        let mut message = json!({ "id": self.count, "method": method, "params": params });
        if let Some(session) = &self.session {
            message["sessionId"] = json!(session);
        }
        self.input.write_all(format!("{message}\0").as_bytes()).expect("the browser listens");
        self.input.flush().expect("the browser listens");
        loop {
            let mut bytes = Vec::new();
            let read = self.output.read_until(0, &mut bytes).expect("the browser answers");
            assert!(read > 0, "the browser has ended during {method}");
            let answer: Value = serde_json::from_slice(&bytes[..bytes.len() - 1]).expect("JSON");
            if answer["id"] == json!(self.count) {
                assert!(answer["error"].is_null(), "{method}: {}", answer["error"]);
                return answer["result"].clone();
            }
            self.note(answer);
        }
    }

    fn note(&mut self, event: Value) {
        let params = &event["params"];
        match event["method"].as_str() {
            Some("Runtime.exceptionThrown") => self.faults.push(params["exceptionDetails"].to_string()),
            Some("Log.entryAdded") if params["entry"]["level"] == "error" => {
                self.faults.push(params["entry"].to_string());
            }
            Some("Page.javascriptDialogOpening") => self.events.push_back(event),
            _ => {}
        }
    }

    /// The value of an expression; a promise is awaited.
    pub(crate) fn value(&mut self, expression: &str) -> Value {
        let params = json!({ "expression": expression, "returnByValue": true, "awaitPromise": true });
        let found = self.call("Runtime.evaluate", &params);
        assert!(found["exceptionDetails"].is_null(), "{expression}: {}", found["exceptionDetails"]);
        found["result"]["value"].clone()
    }

    /// Waits until an expression is true; returns how long it took.
    pub(crate) fn wait(&mut self, expression: &str) -> Duration {
        let started = Instant::now();
        let asked = format!("(() => {{ try {{ return !!({expression}) }} catch {{ return false }} }})()");
        while self.value(&asked) != json!(true) {
            if started.elapsed() > PATIENCE {
                let text = self.value("document.body.innerText.slice(0, 4000)");
                panic!("never true: {expression}\n{}\nfaults: {:?}", text.as_str().unwrap_or_default(), self.faults);
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        started.elapsed()
    }

    /// Opens an address.
    pub(crate) fn open(&mut self, address: &str) {
        self.call("Page.navigate", &json!({ "url": address }));
        self.wait("document.readyState === 'complete'");
    }

    /// Size of the window [CSS pixels], and whether the system is dark.
    pub(crate) fn look(&mut self, width: u32, height: u32, dark: bool) {
        let size = json!({ "width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 600 });
        self.call("Emulation.setDeviceMetricsOverride", &size);
        let scheme = if dark { "dark" } else { "light" };
        let features = json!({ "features": [{ "name": "prefers-color-scheme", "value": scheme }] });
        self.call("Emulation.setEmulatedMedia", &features);
    }

    /// A key, as `Tab`, `Enter`, `ArrowRight` or a character; `modifiers`: 1 Alt, 2 Ctrl, 8 Shift.
    pub(crate) fn key(&mut self, key: &str, modifiers: u8) {
        let code = match key {
            "Backspace" => 8,
            "Tab" => 9,
            "Enter" => 13,
            "Escape" => 27,
            " " => 32,
            "ArrowLeft" => 37,
            "ArrowUp" => 38,
            "ArrowRight" => 39,
            "ArrowDown" => 40,
            other => other.bytes().next().map_or(0, |byte| i32::from(byte.to_ascii_uppercase())),
        };
        let text = match key {
            "Enter" => "\r",
            key if key.chars().count() == 1 && modifiers & 3 == 0 => key,
            _ => "",
        };
        for kind in ["keyDown", "keyUp"] {
            let place = match key {
                digit if digit.len() == 1 && digit.bytes().all(|b| b.is_ascii_digit()) => format!("Digit{digit}"),
                letter if letter.len() == 1 && letter.bytes().all(|b| b.is_ascii_alphabetic()) => {
                    format!("Key{}", letter.to_uppercase())
                }
                " " => "Space".into(),
                other => other.into(),
            };
            let mut params = json!({ "type": kind, "key": key, "code": place, "modifiers": modifiers, "windowsVirtualKeyCode": code });
            if kind == "keyDown" && !text.is_empty() {
                params["text"] = json!(text);
            }
            self.call("Input.dispatchKeyEvent", &params);
        }
    }

    /// Types a text where the focus is.
    pub(crate) fn types(&mut self, text: &str) {
        self.call("Input.insertText", &json!({ "text": text }));
    }

    /// Clicks the middle of the element of an expression.
    pub(crate) fn click(&mut self, element: &str) {
        self.wait(element);
        let place = self.value(&format!(
            "(() => {{ const e = {element}; e.scrollIntoView({{ block: 'center' }}); const r = e.getBoundingClientRect(); \
             return [r.x + r.width / 2, r.y + r.height / 2] }})()"
        ));
        for kind in ["mouseMoved", "mousePressed", "mouseReleased"] {
            let params = json!({ "type": kind, "x": place[0], "y": place[1], "button": "left", "clickCount": 1 });
            self.call("Input.dispatchMouseEvent", &params);
        }
    }

    /// Drops a file of the disk on the element of an expression.
    pub(crate) fn drop_file(&mut self, element: &str, file: &Path) {
        let place = self.value(&format!(
            "(() => {{ const r = {element}.getBoundingClientRect(); return [r.x + r.width / 2, r.y + r.height / 2] }})()"
        ));
        let data = json!({ "items": [], "files": [file.to_string_lossy()], "dragOperationsMask": 1 });
        for kind in ["dragEnter", "dragOver", "drop"] {
            let params = json!({ "type": kind, "x": place[0], "y": place[1], "data": data });
            self.call("Input.dispatchDragEvent", &params);
        }
    }

    /// The window as PNG in base64; in the folder of `TANKCHECK_LOOK` too.
    pub(crate) fn picture(&mut self, name: &str) -> String {
        let picture = self.call("Page.captureScreenshot", &json!({ "format": "png" }));
        let picture = picture["data"].as_str().unwrap_or_default().to_owned();
        if let Some(folder) = std::env::var_os("TANKCHECK_LOOK") {
            let script = "import base64,sys; open(sys.argv[1],'wb').write(base64.b64decode(sys.stdin.read()))";
            let file = Path::new(&folder).join(format!("{name}.png"));
            let mut python = Command::new("python3").args(["-c", script]).arg(file).stdin(Stdio::piped()).spawn();
            if let Ok(python) = &mut python {
                let written = python.stdin.take().map(|mut input| input.write_all(picture.as_bytes()));
                drop(written);
                let _ = python.wait();
            }
        }
        picture
    }
}

impl Drop for Browser {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}
