//! The server of the desk without a browser: its address, what it answers, what it refuses, how it ends.
//!
//! Goal:     nothing of the folder leaves it or is lost, whoever asks
//! Expected: contract of docs/desk.md; RFC 9112 for what is no request

use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::{Value, json};

/// A desk that is open, with its address.
pub(crate) struct Desk {
    program: Child,
    pub(crate) folder: tempfile::TempDir,
    port: u16,
    token: String,
}

/// Status, heads and body.
struct Answer {
    status: u16,
    heads: String,
    body: Vec<u8>,
}

impl Answer {
    fn json(&self) -> Value {
        serde_json::from_slice(&self.body).unwrap_or_else(|e| panic!("{e}: {}", String::from_utf8_lossy(&self.body)))
    }
}

impl Desk {
    fn open() -> Desk {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let root = Path::new(env!("CARGO_MANIFEST_DIR"));
        for (from, to) in
            [("examples/01_broad_tank/tank.json", "tank.json"), ("examples/records/elcentro.csv", "elcentro.csv")]
        {
            std::fs::copy(root.join(from), folder.path().join(to)).expect("copied");
        }
        std::fs::create_dir(folder.path().join("inner")).expect("writable");
        let mut program = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
            .args(["desk", "inner/../", "--no-browser"])
            .current_dir(folder.path())
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn()
            .expect("tankcheck runs");
        let mut line = String::new();
        let mut output = BufReader::new(program.stdout.take().expect("piped"));
        output.read_line(&mut line).expect("an address");
        let address = line.trim().strip_prefix("desk: http://127.0.0.1:").expect("an address on loopback").to_owned();
        let (port, token) = address.split_once('/').expect("a token");
        let (port, token) = (port.parse().expect("a port"), token.trim_end_matches('/').to_owned());
        assert!(token.len() >= 32 && token.bytes().all(|b| b.is_ascii_hexdigit()), "{token}");
        Desk { program, folder, port, token }
    }

    /// Sends bytes as they are; none where the server closes without an answer.
    fn raw(&self, request: &[u8]) -> Option<Answer> {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).expect("it listens");
        stream.set_read_timeout(Some(Duration::from_secs(60))).expect("a socket");
        // A server that has refused may close before all is sent.
        let _ = stream.write_all(request);
        let mut bytes = Vec::new();
        let _ = stream.read_to_end(&mut bytes);
        let split = bytes.windows(4).position(|four| four == b"\r\n\r\n")?;
        let heads = String::from_utf8_lossy(&bytes[..split]).to_lowercase();
        let status = heads.split(' ').nth(1)?.parse().ok()?;
        Some(Answer { status, heads, body: bytes[split + 4..].to_vec() })
    }

    fn send(&self, method: &str, path: &str, heads: &str, body: &[u8]) -> Answer {
        let own = if heads.to_lowercase().contains("host:") {
            String::new()
        } else {
            format!("Host: 127.0.0.1:{}\r\n", self.port)
        };
        let length = if body.is_empty() { String::new() } else { format!("Content-Length: {}\r\n", body.len()) };
        let mut request = format!("{method} {path} HTTP/1.0\r\n{own}{heads}{length}\r\n").into_bytes();
        request.extend_from_slice(body);
        self.raw(&request).unwrap_or_else(|| panic!("{method} {path}: no answer"))
    }

    fn get(&self, path: &str) -> Answer {
        self.send("GET", &format!("/{}/{path}", self.token), "", b"")
    }

    fn ask(&self, method: &str, path: &str, body: &Value) -> Answer {
        let path = format!("/{}/{path}", self.token);
        self.send(method, &path, "Content-Type: application/json\r\n", body.to_string().as_bytes())
    }

    fn text(&self) -> String {
        std::fs::read_to_string(self.folder.path().join("tank.json")).expect("the tank")
    }

    /// Ctrl-C; returns the exit code.
    #[cfg(unix)]
    fn close(mut self) -> Option<i32> {
        let sent = Command::new("kill").args(["-INT", &self.program.id().to_string()]).status();
        assert!(sent.expect("kill exists").success());
        let started = Instant::now();
        while started.elapsed() < Duration::from_secs(60) {
            if let Some(status) = self.program.try_wait().expect("a child") {
                return status.code();
            }
            std::thread::sleep(Duration::from_millis(10));
        }
        None
    }
}

impl Drop for Desk {
    fn drop(&mut self) {
        let _ = self.program.kill();
        let _ = self.program.wait();
    }
}

#[test]
fn it_answers_with_the_verdict_of_check_and_ends_by_ctrl_c() {
    let desk = Desk::open();
    let text = desk.text();
    let page = desk.get("");
    assert!(page.status == 200 && page.heads.contains("content-security-policy: default-src 'none'"), "{}", page.heads);
    let page = String::from_utf8_lossy(&page.body).into_owned();
    assert!(
        !page.contains("http://")
            && !page.contains("https://")
            && !page.contains(" style=")
            && !page.contains("onclick")
    );
    // The same numbers as on the command line.
    let checked = desk.ask("POST", "api/check", &json!({ "text": text, "name": "tank.json" })).json();
    let command = Command::new(env!("CARGO_BIN_EXE_tankcheck"))
        .args(["check", "tank.json", "--format", "json", "--select", "all"])
        .current_dir(desk.folder.path())
        .output()
        .expect("tankcheck runs");
    let command: Value = serde_json::from_slice(&command.stdout).expect("JSON");
    let governing = &command["verdict"]["governing"];
    let ours = &checked["results"]["verdict"]["governing"];
    assert_eq!((&ours["method"], &ours["check"]["id"]), (&governing["method"], &governing["check"]["id"]));
    let ratio = |value: &Value| value["check"]["utilisation"].as_f64().expect("a number");
    // The command prints ten digits.
    assert!((ratio(ours) / ratio(governing) - 1.0).abs() < 1e-9);
    // A run is the command that it shows.
    let arguments = json!(["tank.json", "--quake", "elcentro.csv", "--out", "out"]);
    let run = json!({ "command": "compare", "arguments": arguments, "out": "out" });
    assert_eq!(desk.ask("POST", "api/runs", &run).json(), json!({ "id": 1 }));
    let started = Instant::now();
    let ended = loop {
        let list = desk.get("api/runs").json();
        if !matches!(list[0]["state"].as_str(), Some("waiting" | "running")) {
            break list[0].clone();
        }
        assert!(started.elapsed() < Duration::from_secs(600), "{list}");
        std::thread::sleep(Duration::from_millis(50));
    };
    assert_eq!(ended["command"], "tankcheck compare tank.json --quake elcentro.csv --out out", "{ended}");
    assert!(matches!(ended["code"].as_i64(), Some(0 | 1 | 4)), "{ended}");
    let folder = desk.get("api/folder").json();
    assert_eq!(folder["results"][0]["path"], "out", "{folder}");
    let series = desk.get("api/series?path=out").json();
    assert_eq!(series["columns"].as_array().map(Vec::len), series["values"].as_array().map(Vec::len));
    let report = desk.get("api/result/out/report.html");
    assert!(report.status == 200 && report.heads.contains("sandbox"), "{}", report.heads);
    #[cfg(unix)]
    assert_eq!(desk.close(), Some(0));
}

#[test]
fn an_edit_of_another_window_is_not_lost() {
    let desk = Desk::open();
    let first = desk.get("api/file?path=tank.json").json();
    let save = |text: &str, was: &Value| {
        desk.ask("PUT", "api/file", &json!({ "path": "tank.json", "text": text, "was": was }))
    };
    let mine = save("{ \"name\": \"mine\" }\n", &first["sha256"]);
    assert_eq!(mine.status, 200);
    let theirs = save("{ \"name\": \"theirs\" }\n", &first["sha256"]);
    assert_eq!((theirs.status, &theirs.json()["text"]), (409, &json!("{ \"name\": \"mine\" }\n")));
    assert_eq!(theirs.json()["sha256"], mine.json()["sha256"]);
    assert_eq!(desk.text(), "{ \"name\": \"mine\" }\n");
    // A new file does not take the place of another; a file that a record has the name of is kept.
    assert_eq!(save("{}", &Value::Null).status, 409);
    // A German page is refused in German, with all else that the answer has.
    let old = json!({ "path": "tank.json", "text": "{}", "was": first["sha256"] }).to_string();
    let heads = "Content-Type: application/json\r\nAccept-Language: de\r\n";
    let german = desk.send("PUT", &format!("/{}/api/file", desk.token), heads, old.as_bytes()).json();
    assert_eq!(german["error"]["message"], "`tank.json` wurde geändert, seit es geöffnet wurde");
    assert_eq!(german["sha256"], mine.json()["sha256"]);
    let put = |name: &str, body: &[u8]| {
        desk.send("POST", &format!("/{}/api/upload?name={name}", desk.token), "", body).status
    };
    assert_eq!(
        (put("a.csv", b"1"), put("a.csv", b"1"), put("a.csv", b"2"), put("elcentro.csv", b"x")),
        (200, 200, 409, 409)
    );
}

/// A record is renamed and removed from the page; what names it is asked about, and follows.
#[test]
fn a_record_is_renamed_and_removed_but_not_silently() {
    let desk = Desk::open();
    let write = |name: &str, text: &str| std::fs::write(desk.folder.path().join(name), text).expect("writable");
    let read = |name: &str| std::fs::read_to_string(desk.folder.path().join(name)).ok();
    let set = |name: &str| format!("{{\n  // Three of them.\n  \"records\": [{{ \"along\": \"{name}#1\" }}]\n}}\n");
    write("inner/set.json", &set("../elcentro.csv"));
    write("study.json", "{ \"tanks\": { \"files\": \"tank.json\" }, \"records\": [{ \"files\": \"other*.csv\" }] }");
    write("other1.csv", "0,1\n0.01,2\n");
    let stamp = |path: &str| {
        let folder = desk.get("api/folder").json();
        let files = folder["files"].as_array().expect("files").clone();
        files.into_iter().find(|file| file["path"] == path).map_or(Value::Null, |file| file["stamp"].clone())
    };
    let rename = |path: &str, to: &str, was: &Value, named: bool| {
        desk.ask("POST", "api/rename", &json!({ "path": path, "to": to, "was": was, "named": named }))
    };
    let remove = |path: &str, was: &Value, rest: &str| {
        let was = was.as_str().unwrap_or("x");
        desk.send("DELETE", &format!("/{}/api/file?path={path}&was={was}{rest}", desk.token), "", b"")
    };
    let before = read("elcentro.csv").expect("a record");
    let was = stamp("elcentro.csv");
    // Outside, hidden, another ending, the place of another file, a record that is another one by now, or none.
    for to in ["../elcentro.csv", "/elcentro.csv", ".elcentro.csv", "inner/../../x.csv"] {
        assert_eq!(rename("elcentro.csv", to, &was, true).status, 403, "{to}");
    }
    assert_eq!(rename("elcentro.csv", "elcentro.json", &was, true).status, 422);
    assert_eq!(rename("elcentro.csv", "other1.csv", &was, true).status, 409);
    assert_eq!(rename("elcentro.csv", "new.csv", &json!("1-1"), true).status, 409);
    assert_eq!(rename("none.csv", "new.csv", &was, true).status, 404);
    // It is in use; then the set follows, its comment kept.
    let asked = rename("elcentro.csv", "far/el centro.csv", &was, false);
    assert_eq!((asked.status, &asked.json()["named"]), (409, &json!(["inner/set.json"])));
    assert_eq!(remove("elcentro.csv", &was, "").json()["named"], json!(["inner/set.json"]));
    assert!(read("elcentro.csv").is_some() && read("inner/set.json") == Some(set("../elcentro.csv")));
    let done = rename("elcentro.csv", "far/el centro.csv", &was, true);
    assert_eq!((done.status, &done.json()["changed"]), (200, &json!(["inner/set.json"])));
    assert_eq!((read("elcentro.csv"), read("far/el centro.csv")), (None, Some(before)));
    assert_eq!(read("inner/set.json"), Some(set("../far/el centro.csv")));
    // A pattern finds it no longer, which nobody asked for.
    assert_eq!(rename("other1.csv", "new.csv", &stamp("other1.csv"), true).status, 422);
    assert_eq!(remove("other1.csv", &stamp("other1.csv"), "").json()["named"], json!(["study.json"]));
    assert_eq!(remove("other1.csv", &json!("1-1"), "&named=true").status, 409);
    assert_eq!(remove("other1.csv", &stamp("other1.csv"), "&named=true").status, 200);
    assert_eq!(read("other1.csv"), None);
    // Results are not taken apart.
    std::fs::create_dir(desk.folder.path().join("out")).expect("writable");
    write("out/manifest.json", "{ \"kind\": \"compare\", \"files\": {} }");
    write("out/series.csv", "t,a\n");
    assert_eq!(remove("out/series.csv", &json!("4-0"), "&named=true").status, 422);
    assert!(read("out/series.csv").is_some());
}

/// Sets, studies and tanks that name files outside of the folder are refused as such a path itself is.
#[test]
fn what_a_file_names_lies_in_the_folder() {
    let desk = Desk::open();
    let write = |name: &str, text: String| std::fs::write(desk.folder.path().join(name), text).expect("writable");
    let outside =
        desk.folder.path().parent().expect("a parent").join(format!("desk-outside-{}.csv", std::process::id()));
    std::fs::write(&outside, "0,0.1\n0.01,0.2\n").expect("writable");
    let name = outside.file_name().expect("a name").to_string_lossy().into_owned();
    let mut ways = vec![format!("../{name}"), outside.to_string_lossy().into_owned(), format!("inner/../../{name}#1")];
    #[cfg(unix)]
    {
        std::os::unix::fs::symlink(&outside, desk.folder.path().join("link.csv")).expect("linked");
        ways.push("link.csv".into());
    }
    for way in ways {
        let sentence = format!("`{way}` is not below the opened folder");
        let refused = |what: &str, answer: Answer| {
            assert_eq!((answer.status, &answer.json()["error"]["message"]), (403, &json!(sentence)), "{what}");
        };
        let records = format!("[{{ \"along\": {} }}]", json!(way));
        write("set.json", format!("{{ \"records\": {records} }}"));
        let run = |command: &str, arguments: Value| {
            desk.ask("POST", "api/runs", &json!({ "command": command, "arguments": arguments, "out": "o" }))
        };
        refused("set", run("compare", json!(["tank.json", "--set", "set.json", "--out", "o"])));
        // Through a study and its tank.
        let tank = desk.text().replacen("\"site\"", "\"no_site\"", 1);
        let tank = tank.replacen('{', &format!("{{ \"site\": {{ \"spectrum\": {{ \"file\": {} }} }},", json!(way)), 1);
        write("farm.json", tank.clone());
        write("study.json", "{ \"tanks\": { \"files\": \"far*.json\" } }".into());
        refused("study", run("study plan", json!(["study.json", "--out", "o"])));
        refused("tank", run("check", json!(["farm.json"])));
        // In the form it is a fault of its field.
        let found = desk.ask("POST", "api/check", &json!({ "text": tank })).json();
        assert_eq!(
            (&found["faults"][0]["message"], &found["faults"][0]["path"]),
            (&json!(sentence), &json!("site.spectrum.file"))
        );
        refused("solve", desk.ask("POST", "api/solve", &json!({ "text": tank, "variable": "fill_height" })));
    }
    // From a folder further down, files above it that are inside are named as ever.
    write("inner/set.json", "{ \"records\": [{ \"along\": \"../elcentro.csv\" }] }".into());
    let run = json!({ "command": "compare", "arguments": ["tank.json", "--set", "inner/set.json", "--out", "o"], "out": "o" });
    assert_eq!(desk.ask("POST", "api/runs", &run).status, 200);
    std::fs::remove_file(&outside).expect("removed");
}

/// The battery of hostile requests: none is answered with a file from outside or a change, and the desk lives on.
#[test]
fn two_hundred_hostile_requests_reach_nothing() {
    let desk = Desk::open();
    std::fs::write(desk.folder.path().join(".secret"), "hidden").expect("writable");
    let outside = desk.folder.path().parent().expect("a parent").join(format!("desk-secret-{}", std::process::id()));
    std::fs::write(&outside, "hidden").expect("writable");
    let secret = outside.file_name().expect("a name").to_string_lossy().into_owned();
    #[cfg(unix)]
    std::os::unix::fs::symlink(&outside, desk.folder.path().join("link.json")).expect("linked");
    let before = desk.text();
    let mut count = 0;
    let mut refused = |what: &str, answer: &Answer| {
        count += 1;
        assert!((400..500).contains(&answer.status), "{what}: {}", answer.status);
        assert!(!String::from_utf8_lossy(&answer.body).contains("hidden"), "{what}");
    };
    // Without the token, with another, with a part of it.
    let tokens = [
        "",
        "/",
        "/0",
        "/..",
        "/%2e%2e",
        &format!("/{}", &desk.token[1..]),
        &format!("/{}x", desk.token),
        &format!("/{}", desk.token.to_uppercase()),
    ];
    for token in tokens {
        for path in ["/api/desk", "/api/folder", "/api/runs", "/api/file?path=tank.json", "/app.js", "/api/events"] {
            refused(&format!("{token}{path}"), &desk.send("GET", &format!("{token}{path}"), "", b""));
        }
    }
    // Other names of the host, other origins.
    let own = format!("/{}/", desk.token);
    for host in
        ["evil.example", "127.0.0.1", "127.0.0.1:1", "localhost.evil.example", "0.0.0.0", "[::1]", "127.0.0.1:80@evil"]
    {
        refused(host, &desk.send("GET", &format!("{own}api/desk"), &format!("Host: {host}\r\n"), b""));
        let twice = format!("Host: 127.0.0.1:{}\r\nHost: {host}\r\n", desk.port);
        refused(host, &desk.send("GET", &format!("{own}api/desk"), &twice, b""));
    }
    let change = json!({ "path": "tank.json", "text": "{}", "was": null }).to_string();
    for origin in ["http://evil.example", "null", "https://127.0.0.1", "http://127.0.0.1:1", "file://", ""] {
        for (method, path) in
            [("PUT", "api/file"), ("POST", "api/runs"), ("POST", "api/check"), ("DELETE", "api/runs/1")]
        {
            let heads = format!("Origin: {origin}\r\nContent-Type: application/json\r\n");
            refused(origin, &desk.send(method, &format!("{own}{path}"), &heads, change.as_bytes()));
        }
    }
    refused("cross-site", &desk.send("POST", &format!("{own}api/check"), "Sec-Fetch-Site: cross-site\r\n", b"{}"));
    // Paths that leave the folder.
    let climbing = [
        format!("../{secret}"),
        format!("..%2f{secret}"),
        format!("inner/../../{secret}"),
        format!("./../{secret}"),
        format!("..\\{secret}"),
        outside.to_string_lossy().into_owned(),
        "/etc/passwd".into(),
        "//etc/passwd".into(),
        "..".into(),
        ".".into(),
        "".into(),
        ".secret".into(),
        "%2esecret".into(),
        "inner/../.secret".into(),
        "tank.json%00".into(),
        "%00".into(),
        "C:%5cboot.ini".into(),
        "link.json".into(),
        "inner/%2e%2e/%2e%2e/x".into(),
    ];
    for path in &climbing {
        for address in ["api/file", "api/results", "api/series", "api/scene"] {
            refused(path, &desk.get(&format!("{address}?path={path}")));
        }
        refused(path, &desk.get(&format!("api/result/{path}/results.json")));
        let plain = path.replace("%2e", ".").replace("%2f", "/").replace("%00", "\0").replace("%5c", "\\");
        let saved = json!({ "path": plain, "text": "{}", "was": null });
        refused(path, &desk.ask("PUT", "api/file", &saved));
        let run = json!({ "command": "compare", "arguments": ["tank.json", "--out", plain], "out": "o" });
        refused(path, &desk.ask("POST", "api/runs", &run));
    }
    // Commands and options that the desk does not run.
    for (command, arguments) in [
        ("desk", json!(["."])),
        ("templates", json!(["x"])),
        ("completions", json!(["bash"])),
        ("sh", json!(["-c", "id"])),
        ("", json!([])),
        ("compare", json!(["--help"])),
        ("compare", json!(["-"])),
        ("compare", json!(["tank.json", "--nonsense"])),
        ("quake convert", json!([])),
        ("compare tank.json; id", json!([])),
        ("compare", json!(["tank.json", "--vtu", "/x"])),
        ("compare", json!("tank.json")),
        ("study run", json!(["../x"])),
        ("report", json!(["/"])),
    ] {
        refused(command, &desk.ask("POST", "api/runs", &json!({ "command": command, "arguments": arguments })));
    }
    // Bodies that are too long, no JSON, of another type; methods that there are not.
    let long = vec![b' '; (8 << 20) + 1];
    refused("long", &desk.send("POST", &format!("{own}api/check"), "Content-Type: application/json\r\n", &long));
    for body in ["", "{", "[]", "null", "\"x\"", "{\"text\": 1}", "{\"text\": \"{}\", \"record\": 7}", "\u{0}"] {
        refused(
            body,
            &desk.send("POST", &format!("{own}api/check"), "Content-Type: application/json\r\n", body.as_bytes()),
        );
    }
    for (method, path) in [
        ("DELETE", "api/file"),
        ("PATCH", "api/file"),
        ("TRACE", ""),
        ("PUT", "app.js"),
        ("POST", ""),
        ("DELETE", "api/runs/99"),
        ("POST", "api/rename"),
        ("DELETE", "api/file?path=tank.json"),
        ("DELETE", "api/file?path=tank.json&was=1-1"),
        ("DELETE", "api/file?path=../tank.json&was=1-1&named=true"),
        ("DELETE", "api/runs/x"),
    ] {
        refused(method, &desk.send(method, &format!("{own}{path}"), "", b""));
    }
    assert!(count >= 200, "{count}");
    // The server refuses bytes that are not a request, or closes the connection.
    for bytes in [
        &b"\0\0\0\0"[..],
        b"GET",
        b"GET / HTTP/9.9\r\n\r\n",
        b"\x16\x03\x01\x02\x00",
        b"GET /\r\n\r\n",
        &[b'A'; 100_000],
    ] {
        if let Some(answer) = desk.raw(&[bytes, b"\r\n\r\n"].concat()) {
            assert!((400..=505).contains(&answer.status), "{}", answer.status);
        }
    }
    // Deep and long texts are faults, not failures.
    for text in ["[".repeat(200_000), format!("{{\"name\": \"{}\"}}", "x".repeat(1 << 20)), "{\"a\":".repeat(5_000)] {
        let answer = desk.ask("POST", "api/check", &json!({ "text": text }));
        assert!(answer.status == 200 && answer.json()["faults"][0]["message"].is_string(), "{}", answer.status);
    }
    assert_eq!(desk.get("api/desk").status, 200);
    assert_eq!(desk.text(), before);
    assert_eq!(std::fs::read_to_string(&outside).expect("still there"), "hidden");
    std::fs::remove_file(&outside).expect("removed");
}

#[test]
fn a_port_that_is_taken_and_a_path_to_nothing_are_one_message() {
    let taken = std::net::TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = taken.local_addr().expect("an address").port().to_string();
    for (arguments, words) in
        [(vec!["desk", "--no-browser", "--port", &port], "--port"), (vec!["desk", "nothing.json"], "nothing.json")]
    {
        let run = Command::new(env!("CARGO_BIN_EXE_tankcheck")).args(&arguments).output().expect("tankcheck runs");
        let said = String::from_utf8_lossy(&run.stderr).into_owned();
        assert!(run.status.code() == Some(2) && said.contains(words) && said.contains("help:"), "{said}");
        assert!(run.stdout.is_empty());
    }
}
