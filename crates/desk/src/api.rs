//! Addresses of the desk, below its token; `docs/desk.md` lists them.

use std::convert::Infallible;
use std::path::Path as FilePath;
use std::sync::Arc;
use std::time::Duration;

use axum::body::Bytes;
use axum::extract::{DefaultBodyLimit, Path, Query, Request, State};
use axum::http::{HeaderValue, StatusCode, header};
use axum::middleware::Next;
use axum::response::sse::{Event, Sse};
use axum::response::{IntoResponse, Response};
use axum::routing::{delete, get, post};
use axum::{Json, Router, middleware};
use futures_util::Stream;
use serde::Deserialize;
use serde_json::{Value, json};

use crate::Opening;
use crate::folder::{Folder, sha256};
use crate::guard;
use crate::keeping::{remove, rename};
use crate::office::{Office, Question, RecordChoice, Refused, Tank};
use crate::page;
use crate::runs::Runs;
use crate::series;

/// Longest body of a question, and of a record that is put into the folder [bytes].
const BODY: usize = 8 << 20;
const UPLOAD: usize = 64 << 20;
/// Shortest time between two events.
const PAUSE: Duration = Duration::from_millis(250);
/// Time between two looks at the folder.
const LOOK: Duration = Duration::from_millis(1500);

/// The desk.
pub(crate) struct Desk {
    pub(crate) opening: Opening,
    pub(crate) folder: Folder,
    pub(crate) office: Arc<dyn Office>,
    pub(crate) runs: Runs,
}

pub(crate) type Own = State<Arc<Desk>>;

/// A refusal as an answer.
#[derive(Clone)]
pub(crate) struct Fault(pub(crate) StatusCode, pub(crate) Value);

impl Fault {
    pub(crate) fn of(status: StatusCode, refused: Refused) -> Fault {
        Fault(status, json!({ "error": { "message": refused.message, "help": refused.help } }))
    }
}

impl IntoResponse for Fault {
    fn into_response(self) -> Response {
        let mut response = (self.0, Json(self.1.clone())).into_response();
        response.extensions_mut().insert(self);
        response
    }
}

/// Says a fault in German to a page that asks for it.
async fn in_its_language(State(desk): Own, request: Request, next: Next) -> Response {
    let german = request.headers().get(header::ACCEPT_LANGUAGE).is_some_and(|language| language == "de");
    let mut response = next.run(request).await;
    let Some(mut fault) = response.extensions_mut().remove::<Fault>().filter(|_| german) else {
        return response;
    };
    for part in ["message", "help"] {
        let text = &mut fault.1["error"][part];
        if let Some(said) = text.as_str().and_then(|text| desk.office.german(text)) {
            *text = said.into();
        }
    }
    fault.into_response()
}

/// A place that is not in the folder.
impl From<Refused> for Fault {
    fn from(refused: Refused) -> Fault {
        Fault::of(StatusCode::FORBIDDEN, refused)
    }
}

pub(crate) fn absent(what: &str) -> Fault {
    Fault::of(StatusCode::NOT_FOUND, Refused::new(format!("there is no `{what}`")))
}

/// All addresses.
pub(crate) fn router(desk: Arc<Desk>, token: &str, port: u16) -> Router {
    let api = Router::new()
        .route("/desk", get(about))
        .route("/folder", get(contents))
        .route("/file", get(file).put(save).delete(remove))
        .route("/rename", post(rename))
        .route("/upload", post(upload).layer(DefaultBodyLimit::max(UPLOAD)))
        .route("/schema", get(schema))
        .route("/templates", get(|desk: Own| ask(desk.0, Question::Templates)))
        .route("/check", post(check))
        .route("/sheet", post(sheet))
        .route("/edit", post(edit))
        .route("/solve", post(solve))
        .route("/record", post(record))
        .route("/runs", get(runs).post(run))
        .route("/runs/{id}", delete(cancel))
        .route("/events", get(events))
        .route("/results", get(results))
        .route("/series", get(histories))
        .route("/scene", get(scene))
        .route("/result/{*path}", get(result))
        .fallback(|| async { absent("address") })
        .layer(middleware::from_fn_with_state(Arc::clone(&desk), in_its_language));
    let inner = Router::new().nest("/api", api).route("/{*path}", get(page)).route("/", get(start));
    Router::new()
        .route("/", get(closed))
        .nest(&format!("/{token}"), inner.clone())
        .route(&format!("/{token}/"), get(start))
        .fallback(|| async { StatusCode::NOT_FOUND })
        .layer(DefaultBodyLimit::max(BODY))
        .layer(middleware::from_fn_with_state(port, guard::guard))
        .with_state(desk)
}

/// The only page without a token.
async fn closed() -> Response {
    let text = "<!doctype html><meta charset=\"utf-8\"><title>tankcheck desk</title><p>The desk is open at the address that \
                <code>tankcheck desk</code> printed, with its token.</p>\n";
    ([(header::CONTENT_TYPE, "text/html; charset=utf-8")], text).into_response()
}

async fn start() -> Response {
    page::file("index.html").unwrap_or_else(|| StatusCode::NOT_FOUND.into_response())
}

async fn page(Path(path): Path<String>) -> Response {
    page::file(&path).unwrap_or_else(|| absent("file").into_response())
}

/// Work that reads or computes, beside the thread of the server.
pub(crate) async fn beside<T: Send + 'static>(work: impl FnOnce() -> T + Send + 'static) -> Result<T, Fault> {
    // Work that panics has said so on standard error.
    tokio::task::spawn_blocking(work)
        .await
        .map_err(|_| Fault::of(StatusCode::INTERNAL_SERVER_ERROR, Refused::new("the program failed at this question")))
}

async fn ask(desk: Arc<Desk>, question: Question) -> Result<Json<Value>, Fault> {
    let answer = beside(move || desk.office.answer(question)).await?;
    answer.map(Json).map_err(|refused| Fault::of(StatusCode::UNPROCESSABLE_ENTITY, refused))
}

async fn about(State(desk): Own) -> Json<Value> {
    Json(json!({
        "version": desk.opening.version,
        "folder": desk.folder.root().to_string_lossy(),
        "tank": desk.opening.tank,
    }))
}

async fn contents(State(desk): Own) -> Result<Response, Fault> {
    let found = beside(move || desk.folder.contents()).await?;
    Ok(Json(found).into_response())
}

#[derive(Deserialize)]
struct In {
    language: Option<String>,
}

async fn schema(State(desk): Own, Query(asked): Query<In>) -> Result<Json<Value>, Fault> {
    ask(desk, Question::Schema(asked.language)).await
}

#[derive(Deserialize)]
struct At {
    path: String,
}

async fn file(State(desk): Own, Query(at): Query<At>) -> Result<Json<Value>, Fault> {
    let place = desk.folder.inside(&at.path)?;
    let text = beside(move || files::read_text(&place)).await?.map_err(|_| absent(&at.path))?;
    Ok(Json(json!({ "path": at.path, "sha256": sha256(text.as_bytes()), "text": text })))
}

#[derive(Deserialize)]
struct Saved {
    path: String,
    text: String,
    /// Hash of the text that it replaces; none for a new file.
    was: Option<String>,
}

async fn save(State(desk): Own, Json(new): Json<Saved>) -> Result<Json<Value>, Fault> {
    let place = desk.folder.inside(&new.path)?;
    if !new.path.ends_with(".json") && !new.path.ends_with(".jsonc") {
        return Err(Refused::new(format!("`{}`: found another ending, expected `.json`", new.path)).into());
    }
    beside(move || replaced(&place, &new)).await?
}

/// Writes a file where it still is what the page has read.
fn replaced(place: &FilePath, new: &Saved) -> Result<Json<Value>, Fault> {
    let there = match files::read_text(place) {
        Ok(text) => Some(text),
        Err(error) if error.kind() == std::io::ErrorKind::NotFound => None,
        Err(error) => return Err(unwritten(&new.path, &error.to_string())),
    };
    let hash = there.as_ref().map(|text| sha256(text.as_bytes()));
    let own = sha256(new.text.as_bytes());
    if hash != new.was && hash.as_deref() != Some(own.as_str()) {
        let message = match there {
            Some(_) => format!("`{}` was changed since it was opened", new.path),
            None => format!("`{}` was removed since it was opened", new.path),
        };
        let error = json!({ "message": message, "help": Value::Null });
        return Err(Fault(StatusCode::CONFLICT, json!({ "error": error, "text": there, "sha256": hash })));
    }
    if let Some(folder) = place.parent() {
        std::fs::create_dir_all(folder).map_err(|e| unwritten(&new.path, &e.to_string()))?;
    }
    files::write_whole(place, new.text.as_bytes()).map_err(|e| unwritten(&new.path, &e.to_string()))?;
    Ok(Json(json!({ "sha256": own })))
}

pub(crate) fn unwritten(path: &str, what: &str) -> Fault {
    Fault::of(StatusCode::INTERNAL_SERVER_ERROR, Refused::new(format!("{path}: cannot be written: {what}")))
}

#[derive(Deserialize)]
struct Named {
    name: String,
}

async fn upload(State(desk): Own, Query(Named { name }): Query<Named>, body: Bytes) -> Result<Json<Value>, Fault> {
    if name.contains('/') {
        return Err(Refused::new(format!("`{name}`: expected a name without a folder")).into());
    }
    let place = desk.folder.inside(&name)?;
    let hash = sha256(&body);
    let answer = json!({ "path": name, "sha256": hash });
    beside(move || match files::read(&place) {
        Ok(there) if sha256(&there) == hash => Ok(Json(answer)),
        Ok(_) => {
            let refused = Refused::new(format!("there is another `{name}` in the folder\n  help: rename one of them"));
            Err(Fault::of(StatusCode::CONFLICT, refused))
        }
        Err(_) if place.exists() => Err(unwritten(&name, "something else has this name")),
        Err(_) => match files::write_whole(&place, &body) {
            Ok(()) => Ok(Json(answer)),
            Err(error) => Err(unwritten(&name, &error.to_string())),
        },
    })
    .await?
}

impl Desk {
    /// The tank of a question, its record found; or which of its values names a file outside.
    fn tank(&self, mut tank: Tank) -> Result<Result<Tank, (String, Refused)>, Fault> {
        let name = tank.name.as_deref().unwrap_or("tank.json");
        let place = self.folder.inside(name)?;
        if let Err(outside) = self.admits_named(&place, &tank.text) {
            return Ok(Err(outside));
        }
        tank.folder = self.folder.root().to_owned();
        tank.record = tank.record.map(|record| self.record(record)).transpose()?;
        Ok(Ok(tank))
    }

    fn admitted(&self, tank: Tank) -> Result<Tank, Fault> {
        self.tank(tank)?.map_err(|(_, refused)| refused.into())
    }

    fn record(&self, record: RecordChoice) -> Result<RecordChoice, Fault> {
        let path = self.folder.inside(&record.path)?;
        Ok(RecordChoice { path: path.to_string_lossy().into_owned(), ..record })
    }
}

async fn check(State(desk): Own, Json(tank): Json<Tank>) -> Result<Json<Value>, Fault> {
    let tank = match desk.tank(tank)? {
        Ok(tank) => tank,
        // Shown where it stands in the form.
        Err((path, Refused { message, help })) => {
            let fault = json!({ "code": Value::Null, "message": message, "path": path, "line": 1, "column": 1, "start": 0, "end": 0,
                "found": "", "allowed": "", "help": help });
            return Ok(Json(
                json!({ "faults": [fault], "text_faults": message, "warnings": [], "results": null, "sketch": null }),
            ));
        }
    };
    ask(desk, Question::Check(tank)).await
}

#[derive(Deserialize)]
struct OfSheet {
    #[serde(flatten)]
    tank: Tank,
    method: usize,
    check: Option<String>,
}

async fn sheet(State(desk): Own, Json(asked): Json<OfSheet>) -> Result<Json<Value>, Fault> {
    let tank = desk.admitted(asked.tank)?;
    ask(desk, Question::Sheet { tank, method: asked.method, check: asked.check }).await
}

#[derive(Deserialize)]
struct Edited {
    text: String,
    path: String,
    value: Option<Value>,
}

async fn edit(State(desk): Own, Json(asked): Json<Edited>) -> Result<Json<Value>, Fault> {
    ask(desk, Question::Edit { text: asked.text, path: asked.path, value: asked.value }).await
}

#[derive(Deserialize)]
struct Solved {
    #[serde(flatten)]
    tank: Tank,
    variable: String,
}

async fn solve(State(desk): Own, Json(asked): Json<Solved>) -> Result<Json<Value>, Fault> {
    let tank = desk.admitted(asked.tank)?;
    ask(desk, Question::Solve { tank, variable: asked.variable }).await
}

async fn record(State(desk): Own, Json(asked): Json<RecordChoice>) -> Result<Json<Value>, Fault> {
    let record = desk.record(asked)?;
    ask(desk, Question::Record(record)).await
}

async fn runs(State(desk): Own) -> Response {
    Json(desk.runs.list()).into_response()
}

#[derive(Deserialize)]
struct Asked {
    command: String,
    arguments: Vec<String>,
    /// Folder of the results.
    out: Option<String>,
}

async fn run(State(desk): Own, Json(asked): Json<Asked>) -> Result<Json<Value>, Fault> {
    let unfit = |refused| Fault::of(StatusCode::UNPROCESSABLE_ENTITY, refused);
    let places = desk.office.admit(&asked.command, &asked.arguments).map_err(unfit)?;
    for place in &places {
        desk.folder.admits(place)?;
    }
    let own = Arc::clone(&desk);
    beside(move || places.iter().try_for_each(|place| own.admits_below(place))).await??;
    if let Some(out) = asked.out.as_deref().filter(|out| desk.runs.writes(out)) {
        return Err(Fault::of(StatusCode::CONFLICT, Refused::new(format!("another run writes into `{out}`"))));
    }
    let command = asked.command.split(' ').map(str::to_owned);
    let id = desk.runs.add(command.chain(asked.arguments).collect(), asked.out);
    Ok(Json(json!({ "id": id })))
}

async fn cancel(State(desk): Own, Path(id): Path<u64>) -> Result<Json<Value>, Fault> {
    if desk.runs.cancel(id) { Ok(Json(json!({}))) } else { Err(absent("run")) }
}

/// Events: `runs` with the list when it changes, `folder` when files come, go or change.
async fn events(State(desk): Own) -> Sse<impl Stream<Item = Result<Event, Infallible>>> {
    let state = (desk.runs.changes(), None::<u64>, true, desk);
    let next = |(mut changes, mut seen, first, desk): (tokio::sync::watch::Receiver<u64>, _, bool, Arc<Desk>)| async move {
        if first {
            let event = Event::default().event("runs").data(text(&desk.runs.list()));
            seen = held(&desk).await;
            return Some((Ok(event), (changes, seen, false, desk)));
        }
        loop {
            tokio::time::sleep(PAUSE).await;
            match tokio::time::timeout(LOOK, changes.changed()).await {
                Ok(Err(_)) => return None,
                Ok(Ok(())) => {
                    let event = Event::default().event("runs").data(text(&desk.runs.list()));
                    return Some((Ok(event), (changes, seen, false, desk)));
                }
                Err(_) => {
                    let now = held(&desk).await;
                    if now != seen {
                        let event = Event::default().event("folder").data("{}");
                        return Some((Ok(event), (changes, now, false, desk)));
                    }
                }
            }
        }
    };
    Sse::new(futures_util::stream::unfold(state, next)).keep_alive(axum::response::sse::KeepAlive::default())
}

fn text(value: &impl serde::Serialize) -> String {
    serde_json::to_string(value).unwrap_or_default()
}

/// A number for what the folder holds.
async fn held(desk: &Arc<Desk>) -> Option<u64> {
    let folder = desk.folder.clone();
    beside(move || folder.state()).await.ok()
}

async fn results(State(desk): Own, Query(at): Query<At>) -> Result<Response, Fault> {
    let place = desk.folder.data(&at.path)?;
    sent(place, None).await
}

async fn histories(State(desk): Own, Query(at): Query<At>) -> Result<Json<Value>, Fault> {
    let place = desk.folder.owned(&at.path, "series.csv").map_err(|_| absent("series.csv"))?;
    let columns = beside(move || files::read_text(&place).map(|text| series::columns(&text))).await?;
    columns.map(Json).map_err(|_| absent("series.csv"))
}

async fn scene(State(desk): Own, Query(at): Query<At>) -> Result<Response, Fault> {
    let place = desk.folder.owned(&at.path, "scene.json").map_err(|_| absent("scene.json"))?;
    sent(place, None).await
}

/// A file of a folder of results: its name is what its manifest lists.
async fn result(State(desk): Own, Path(path): Path<String>, Query(how): Query<Download>) -> Result<Response, Fault> {
    let parts: Vec<&str> = path.split('/').collect();
    let found = (1..parts.len()).find_map(|i| desk.folder.owned(&parts[..i].join("/"), &parts[i..].join("/")).ok());
    let place = found.ok_or_else(|| absent(&path))?;
    sent(place, how.download.as_deref()).await
}

#[derive(Deserialize)]
struct Download {
    download: Option<String>,
}

/// A file as it is; what it may do where a browser shows it stands in its head.
async fn sent(place: std::path::PathBuf, download: Option<&str>) -> Result<Response, Fault> {
    let name = place.file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    let kind = match name.rsplit_once('.').map_or("", |(_, end)| end) {
        "html" => "text/html; charset=utf-8",
        "json" => "application/json",
        "csv" => "text/csv; charset=utf-8",
        "svg" => "image/svg+xml",
        "pdf" => "application/pdf",
        _ => "application/octet-stream",
    };
    let bytes = beside(move || files::read(&place)).await?.map_err(|_| absent(&name))?;
    let policy = HeaderValue::from_static(guard::policy(&name));
    let mut response = ([(header::CONTENT_TYPE, kind)], bytes).into_response();
    response.headers_mut().insert(header::CONTENT_SECURITY_POLICY, policy);
    if download.is_some()
        && let Ok(value) = HeaderValue::from_str(&format!("attachment; filename=\"{}\"", name.replace('"', "")))
    {
        response.headers_mut().insert(header::CONTENT_DISPOSITION, value);
    }
    Ok(response)
}
