//! The results as a workbook: values are numbers with all their digits, in the unit of their row or column.
//!
//! | sheet | rows |
//! |---|---|
//! | Overview | project, verdict, files with hashes |
//! | Quantities | a quantity; a column a method |
//! | Checks | a check |
//! | one a method | a line of its calculation, as a formula over the lines above where they have all its values |
//! | Profiles | a height of a profile |
//! | Histories | an instant; a column a history |
//!
//! The same results give the same bytes.

mod formula;

use rust_xlsxwriter::{
    DocProperties, ExcelDateTime, Format, FormatAlign, FormatBorder, Formula, Workbook, Worksheet, XlsxError,
};
use tank::assessment::Check;
use tank::units::Dimension;

use crate::methods::{excitation, look};
use crate::number::{Scale, utilisation};
use crate::words::workbook as words;
use crate::words::{self as all_words, capital};
use files::error::Error;
use files::text::visible;
use results::{Method, Results, Series, SeriesInfo};

/// Longest text of a cell that spreadsheets take, and one sign for what was cut [characters].
const LONGEST_TEXT: usize = 32_766;

/// A text as a cell has it, which is never a formula.
fn shown(text: &str) -> String {
    let text = visible(text);
    match text.char_indices().nth(LONGEST_TEXT) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.into_owned(),
    }
}

/// Largest relative difference of a utilisation from the quotient of demand and capacity that it is then written as.
const SAME: f64 = 1e-9;

/// Longest name of a sheet that spreadsheets take.
const LONGEST: usize = 31;

/// A sheet that is filled row by row.
struct Page<'a> {
    sheet: &'a mut Worksheet,
    row: u32,
}

/// A cell.
enum Cell<'a> {
    Text(&'a str),
    Number(f64),
    /// A formula and its value.
    Formula(&'a str, f64),
    /// A share, shown in percent.
    Share(f64),
    /// A formula and its value, a share.
    SharedBy(&'a str, f64),
    Whole(usize),
}

impl Page<'_> {
    fn head(&mut self, heads: &[&str], frozen: u16) -> Result<(), XlsxError> {
        let format =
            Format::new().set_bold().set_text_wrap().set_align(FormatAlign::Top).set_border_bottom(FormatBorder::Thin);
        for (column, head) in (0..).zip(heads) {
            self.sheet.write_string_with_format(self.row, column, shown(head), &format)?;
        }
        self.row += 1;
        self.sheet.set_freeze_panes(self.row, frozen)?;
        self.sheet.set_repeat_rows(0, self.row - 1)?;
        Ok(())
    }

    fn cells<'c>(&mut self, cells: impl IntoIterator<Item = Option<Cell<'c>>>) -> Result<(), XlsxError> {
        for (column, cell) in (0..).zip(cells) {
            match cell {
                None => {}
                Some(Cell::Text(text)) => drop(self.sheet.write_string(self.row, column, shown(text))?),
                Some(Cell::Number(value)) if value.is_finite() => {
                    let format = Format::new().set_num_format(digits(value));
                    self.sheet.write_number_with_format(self.row, column, value, &format)?;
                }
                Some(Cell::Formula(text, value)) if value.is_finite() => {
                    let format = Format::new().set_num_format(digits(value));
                    let formula = Formula::new(text).set_result(value.to_string());
                    self.sheet.write_formula_with_format(self.row, column, formula, &format)?;
                }
                Some(Cell::Share(value)) if value.is_finite() => {
                    let format = Format::new().set_num_format("0.0%");
                    self.sheet.write_number_with_format(self.row, column, value, &format)?;
                }
                Some(Cell::SharedBy(text, value)) => {
                    let format = Format::new().set_num_format("0.0%");
                    let formula = Formula::new(text).set_result(value.to_string());
                    self.sheet.write_formula_with_format(self.row, column, formula, &format)?;
                }
                Some(Cell::Share(value)) => drop(self.sheet.write_string(self.row, column, utilisation(value))?),
                Some(Cell::Number(_) | Cell::Formula(..)) => {}
                Some(Cell::Whole(value)) => drop(self.sheet.write_number(self.row, column, value as f64)?),
            }
        }
        self.row += 1;
        Ok(())
    }

    fn widths(&mut self, widths: &[f64]) -> Result<(), XlsxError> {
        for (column, width) in (0..).zip(widths) {
            self.sheet.set_column_width(column, *width)?;
        }
        Ok(())
    }
}

/// Format that shows about four significant digits; the cell keeps them all.
fn digits(value: f64) -> &'static str {
    match value.abs() {
        0.0 => "0",
        v if !(1e-4..1e7).contains(&v) => "0.000E+00",
        v if v >= 1000.0 => "#,##0",
        v if v >= 100.0 => "0.0",
        v if v >= 10.0 => "0.00",
        v if v >= 1.0 => "0.000",
        v if v >= 0.1 => "0.0000",
        v if v >= 0.01 => "0.00000",
        v if v >= 0.001 => "0.000000",
        _ => "0.0000000",
    }
}

/// The results as the bytes of an `.xlsx` file.
///
/// Errors: more rows, columns or characters than a sheet holds.
pub fn workbook(results: &Results, series: &Series) -> Result<Vec<u8>, Error> {
    // Where a report has both systems, a cell has the first: it holds one number.
    let _style = crate::style::of(results.project.as_ref());
    write(results, series).map_err(|e| Error::Report(format!("workbook: {e}")))
}

fn write(results: &Results, series: &Series) -> Result<Vec<u8>, XlsxError> {
    let mut book = Workbook::new();
    // A fixed date: the time of a run is in the overview.
    let created = ExcelDateTime::from_ymd(2000, 1, 1)?;
    book.set_properties(&DocProperties::new().set_title(shown(&results.name)).set_creation_datetime(&created));
    let mut names = Vec::new();
    overview(&mut page(&mut book, "Overview", &mut names)?, results)?;
    quantities(&mut page(&mut book, words::sheets::QUANTITIES, &mut names)?, results)?;
    checks(&mut page(&mut book, words::sheets::CHECKS, &mut names)?, results)?;
    for method in results.methods.iter().filter(|m| !m.steps.is_empty()) {
        let name = format!("{} {}", method.id, excitation(method));
        steps(&mut page(&mut book, &name, &mut names)?, method)?;
    }
    if results.methods.iter().any(|m| !m.profiles.is_empty()) {
        profiles(&mut page(&mut book, words::sheets::PROFILES, &mut names)?, results)?;
    }
    if !series.columns.is_empty() {
        histories(&mut page(&mut book, "Histories", &mut names)?, results, series)?;
    }
    book.save_to_buffer()
}

/// A new sheet, its name without the signs that spreadsheets refuse and different from all others.
fn page<'b>(book: &'b mut Workbook, name: &str, names: &mut Vec<String>) -> Result<Page<'b>, XlsxError> {
    let plain: String = name.chars().map(|c| if "[]:*?/\\'".contains(c) || c.is_control() { '_' } else { c }).collect();
    let cut = |extra: &str| -> String {
        let room = LONGEST - extra.len();
        plain.chars().take(room).chain(extra.chars()).collect()
    };
    let mut free = cut("");
    let mut count = 2;
    while names.iter().any(|known| known.eq_ignore_ascii_case(&free)) {
        free = cut(&format!(" {count}"));
        count += 1;
    }
    let sheet = book.add_worksheet();
    sheet.set_name(&free)?;
    names.push(free);
    // A4, landscape, as wide as one page.
    sheet.set_paper_size(9).set_landscape().set_print_fit_to_pages(1, 0);
    Ok(Page { sheet, row: 0 })
}

fn overview(page: &mut Page, results: &Results) -> Result<(), XlsxError> {
    page.widths(&[18.0, 60.0, 70.0])?;
    let bold = Format::new().set_bold().set_font_size(14);
    page.sheet.write_string_with_format(0, 0, shown(&results.name), &bold)?;
    page.row = 2;
    let project = results.project.clone().unwrap_or_default();
    let given = [project.name, project.client, project.document, project.revision, project.date];
    for (label, value) in all_words::summary::COVER.into_iter().zip(&given) {
        if let Some(value) = value {
            page.cells([Some(Cell::Text(label)), Some(Cell::Text(value))])?;
        }
    }
    let verdict = [all_words::verdict::headline(&results.verdict), all_words::verdict::deciding(results)];
    for (label, text) in words::VERDICT.into_iter().zip(&verdict) {
        page.cells([Some(Cell::Text(label)), Some(Cell::Text(text))])?;
    }
    for gap in &results.verdict.accepted {
        let approval = all_words::verdict::approval(&gap.check, &results.volatile.created);
        let text = format!("{} ({}), {approval}: {}", gap.check.name, gap.method, gap.check.reason);
        page.cells([Some(Cell::Text(all_words::verdict::GAPS)), Some(Cell::Text(&text))])?;
    }
    let v = &results.volatile;
    for (label, text) in words::PROVENANCE.into_iter().zip([&v.version, &v.created, &v.command]) {
        page.cells([Some(Cell::Text(label)), Some(Cell::Text(text))])?;
    }
    page.row += 1;
    page.cells(words::FILES.map(|head| Some(Cell::Text(head))))?;
    for file in &results.files {
        page.cells([&file.role, &file.name, &file.sha256].map(|text| Some(Cell::Text(text))))?;
    }
    Ok(())
}

fn quantities(page: &mut Page, results: &Results) -> Result<(), XlsxError> {
    let titles: Vec<String> = results.methods.iter().map(|m| format!("{}, {}", look(m).label, excitation(m))).collect();
    page.widths(&[38.0, 9.0])?;
    for column in 0..titles.len() {
        page.sheet.set_column_width((column + 2) as u16, 13.0)?;
    }
    let heads: Vec<&str> = words::QUANTITIES.into_iter().chain(titles.iter().map(String::as_str)).collect();
    page.head(&heads, 2)?;
    for row in &results.comparison.rows {
        let scale = Scale::single(row.dimension, row.cells.iter().flatten().map(|c| c.value));
        let values = row.cells.iter().map(|cell| cell.map(|c| Cell::Number(scale.convert(c.value))));
        let lead = [Some(Cell::Text(&row.title)), Some(Cell::Text(scale.symbol()))];
        page.cells(lead.into_iter().chain(values))?;
    }
    Ok(())
}

fn checks(page: &mut Page, results: &Results) -> Result<(), XlsxError> {
    page.widths(&[34.0, 10.0, 8.0, 40.0, 28.0, 11.0, 11.0, 8.0, 11.0, 14.0])?;
    page.head(&words::CHECKS, 0)?;
    let rows: Vec<(&Method, &Check)> =
        results.methods.iter().flat_map(|m| m.checks.iter().map(move |c| (m, c))).collect();
    for (method, check) in rows {
        let scale = Scale::single(check.dimension, [check.demand, check.capacity].into_iter().flatten());
        let number = |value: Option<f64>| value.map(|v| Cell::Number(scale.convert(v)));
        let quotient = format!("=F{0}/G{0}", page.row + 1);
        page.cells([
            Some(Cell::Text(&method.title)),
            Some(Cell::Text(excitation(method))),
            Some(Cell::Text(words::decides(results.verdict.decides(method)))),
            Some(Cell::Text(&capital(&check.name))),
            Some(Cell::Text(&check.clause)),
            number(check.demand),
            number(check.capacity),
            check.demand.or(check.capacity).map(|_| Cell::Text(scale.symbol())),
            check.ratio().map(|ratio| match check.demand.zip(check.capacity) {
                Some((demand, capacity)) if (demand / capacity - ratio).abs() <= SAME * ratio => {
                    Cell::SharedBy(&quotient, ratio)
                }
                _ => Cell::Share(ratio),
            }),
            Some(Cell::Text(all_words::verdict::result(check))),
        ])?;
    }
    let last = page.row.saturating_sub(1).max(1);
    page.sheet.autofilter(0, 0, last, (words::CHECKS.len() - 1) as u16)?;
    Ok(())
}

fn steps(page: &mut Page, method: &Method) -> Result<(), XlsxError> {
    page.widths(&[5.0, 30.0, 44.0, 12.0, 44.0, 30.0, 12.0, 9.0, 30.0, 12.0])?;
    page.head(&words::STEPS, 0)?;
    for (number, step) in (1..).zip(&method.steps) {
        let (value, unit) = in_unit(step.value, step.dimension);
        let text = |text| Some(Cell::Text(text));
        // A value that is given stands in its unit, to be changed there; a computed one comes from the column in SI.
        let row = page.row + 1;
        let factor = Scale::single(step.dimension, [step.value]).convert(1.0);
        let computed = formula::of_line(&method.steps, number - 1, &|line| format!("J{}", line + 2));
        let (shown, si) = match &computed {
            Some(formula) => (format!("=J{row}*{factor}"), format!("={formula}")),
            None => (String::new(), format!("=G{row}/{factor}")),
        };
        let shown = if shown.is_empty() { Cell::Number(value) } else { Cell::Formula(&shown, value) };
        page.cells([
            Some(Cell::Whole(number)),
            text(&step.section),
            text(&step.name),
            text(&step.symbol),
            text(&step.formula),
            text(&step.look_up),
            Some(shown),
            text(unit),
            text(&step.clause),
            Some(Cell::Formula(&si, step.value)),
        ])?;
    }
    Ok(())
}

/// A value in SI as number in an engineer's unit, with its symbol.
fn in_unit(value: f64, dimension: Dimension) -> (f64, &'static str) {
    let scale = Scale::single(dimension, [value]);
    (scale.convert(value), scale.symbol())
}

fn profiles(page: &mut Page, results: &Results) -> Result<(), XlsxError> {
    page.widths(&[34.0, 10.0, 44.0, 10.0, 6.0, 12.0, 9.0])?;
    page.head(&words::PROFILES, 0)?;
    for method in &results.methods {
        for profile in &method.profiles {
            let height = Scale::single(Dimension::Length, profile.z.iter().copied());
            let scale = Scale::single(profile.dimension, profile.values.iter().copied());
            for (z, value) in profile.z.iter().zip(&profile.values) {
                page.cells([
                    Some(Cell::Text(&method.title)),
                    Some(Cell::Text(excitation(method))),
                    Some(Cell::Text(&profile.title)),
                    Some(Cell::Number(height.convert(*z))),
                    Some(Cell::Text(height.symbol())),
                    Some(Cell::Number(scale.convert(*value))),
                    Some(Cell::Text(scale.symbol())),
                ])?;
            }
        }
    }
    let last = page.row.saturating_sub(1).max(1);
    page.sheet.autofilter(0, 0, last, (words::PROFILES.len() - 1) as u16)?;
    Ok(())
}

/// Title and scale of a column of the series.
fn history(results: &Results, id: &str, values: &[f64]) -> (String, Scale) {
    let with_prefix = results.runs.iter().enumerate().flat_map(|(i, run)| {
        let prefix = if i == 0 { "" } else { run.engine.prefix() };
        run.histories.iter().map(move |info: &SeriesInfo| (prefix, info))
    });
    let known = with_prefix.into_iter().find(|(prefix, info)| id.strip_prefix(prefix) == Some(info.id.as_str()));
    match known {
        Some((prefix, info)) => {
            let engine = prefix.trim_end_matches('_');
            let title = match engine {
                "" => info.title.clone(),
                engine => format!("{}, {engine}", info.title),
            };
            (title, Scale::single(info.dimension, values.iter().copied()))
        }
        None => (id.to_owned(), Scale::single(Dimension::Dimensionless, values.iter().copied())),
    }
}

fn histories(page: &mut Page, results: &Results, series: &Series) -> Result<(), XlsxError> {
    let columns: Vec<(String, Scale)> =
        series.ids.iter().zip(&series.columns).map(|(id, values)| history(results, id, values)).collect();
    let heads: Vec<String> = columns
        .iter()
        .map(|(title, scale)| match scale.symbol() {
            "" => title.clone(),
            unit => format!("{title} [{unit}]"),
        })
        .collect();
    let time = "Time [s]".to_owned();
    let heads: Vec<&str> = [time.as_str()].into_iter().chain(heads.iter().map(String::as_str)).collect();
    page.head(&heads, 1)?;
    for column in 0..columns.len() {
        page.sheet.set_column_width((column + 1) as u16, 15.0)?;
    }
    for (i, t) in series.time.iter().enumerate() {
        let values = columns.iter().zip(&series.columns).map(|((_, scale), column)| {
            let value = column.get(i).copied().filter(|v| v.is_finite())?;
            Some(Cell::Number(scale.convert(value)))
        });
        page.cells([Some(Cell::Number(*t))].into_iter().chain(values))?;
    }
    Ok(())
}
