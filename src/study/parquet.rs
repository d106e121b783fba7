//! `rows.parquet`: the rows of `rows.csv`, column by column, for tables that are too large for text.
//!
//! The columns are those of the CSV file, in its order; an empty cell is null. A utilisation that is a word (`fails`, `not_checked`, `accepted`)
//! is null in its column and stands in one of its own, whose name ends in `_ending`. The file is made of `rows.csv`, so that both cannot differ.

use std::fs::File;
use std::io::BufWriter;
use std::path::Path;
use std::sync::Arc;

use csv::StringRecord;
use parquet::basic::{LogicalType, Repetition, Type as Physical};
use parquet::data_type::{ByteArray, ByteArrayType, DataType, DoubleType, Int32Type};
use parquet::errors::ParquetError;
use parquet::file::properties::WriterProperties;
use parquet::file::writer::{SerializedColumnWriter, SerializedFileWriter};
use parquet::schema::types::Type;

use crate::error::Error;

/// Name of the file.
pub(super) const FILE: &str = "rows.parquet";

/// Columns of words, whatever stands in them: a tank may be called 101.
const WORDS: [&str; 4] = ["tank", "record", "status", "message"];
/// The column of whole numbers.
const SAMPLE: &str = "sample";
/// End of the names of columns that have words among their numbers, and of the columns that take these words.
const ENDS: [&str; 2] = ["_utilisation", "_ending"];
/// Rows that stand together in the file: some 20 MB while they are written.
const GROUP: usize = 40_000;

/// What a column holds.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Kind {
    Words,
    Count,
    Number,
    /// The words among the numbers of another column.
    Ending,
}

/// A column of the file.
#[derive(Clone, Debug, PartialEq)]
struct Column {
    name: String,
    /// Number of the column in `rows.csv`.
    from: usize,
    kind: Kind,
}

impl Column {
    fn field(&self) -> Result<Arc<Type>, ParquetError> {
        let physical = match self.kind {
            Kind::Words | Kind::Ending => Physical::BYTE_ARRAY,
            Kind::Count => Physical::INT32,
            Kind::Number => Physical::DOUBLE,
        };
        let text = physical == Physical::BYTE_ARRAY;
        let field = Type::primitive_type_builder(&self.name, physical)
            .with_repetition(Repetition::OPTIONAL)
            .with_logical_type(text.then_some(LogicalType::String));
        field.build().map(Arc::new)
    }

    /// Writes the cells of a group of rows.
    fn write(&self, rows: &[StringRecord], writer: &mut SerializedColumnWriter<'_>) -> Result<(), ParquetError> {
        let cells = rows.iter().map(|row| row.get(self.from).unwrap_or_default());
        let number = |cell: &str| cell.parse::<f64>().ok();
        match self.kind {
            Kind::Words => put::<ByteArrayType>(writer, cells.map(words)),
            Kind::Ending => put::<ByteArrayType>(writer, cells.map(|c| words(c).filter(|_| number(c).is_none()))),
            Kind::Count => put::<Int32Type>(writer, cells.map(|cell| cell.parse().ok())),
            Kind::Number => put::<DoubleType>(writer, cells.map(number)),
        }
    }
}

fn words(cell: &str) -> Option<ByteArray> {
    (!cell.is_empty()).then(|| ByteArray::from(cell))
}

/// Values of a column, none for null.
fn put<T: DataType>(
    writer: &mut SerializedColumnWriter<'_>,
    cells: impl Iterator<Item = Option<T::T>>,
) -> Result<(), ParquetError> {
    let (mut values, mut levels) = (Vec::new(), Vec::new());
    for cell in cells {
        levels.push(i16::from(cell.is_some()));
        values.extend(cell);
    }
    writer.typed::<T>().write_batch(&values, Some(&levels), None).map(drop)
}

/// A fault of reading or writing.
#[derive(Debug, thiserror::Error)]
enum Fault {
    #[error(transparent)]
    Table(#[from] csv::Error),
    #[error(transparent)]
    File(#[from] std::io::Error),
    #[error(transparent)]
    Parquet(#[from] ParquetError),
}

/// The columns of a table: numbers where every cell is one or empty, save for [`WORDS`].
fn columns(table: &Path) -> Result<Vec<Column>, Fault> {
    let mut reader = csv::Reader::from_path(table)?;
    let names = reader.headers()?.clone();
    // Whether a cell of each column is a word.
    let mut worded = vec![false; names.len()];
    let mut row = StringRecord::new();
    while reader.read_record(&mut row)? {
        for (worded, cell) in worded.iter_mut().zip(&row) {
            *worded |= !cell.is_empty() && cell.parse::<f64>().is_err();
        }
    }
    let mut columns = Vec::new();
    for (from, name) in names.iter().enumerate() {
        let mut add = |name: &str, kind| {
            let name = name.to_owned();
            columns.push(Column { name, from, kind });
        };
        match name.strip_suffix(ENDS[0]) {
            _ if WORDS.contains(&name) => add(name, Kind::Words),
            _ if name == SAMPLE => add(name, Kind::Count),
            Some(stem) if worded[from] => {
                add(name, Kind::Number);
                add(&format!("{stem}{}", ENDS[1]), Kind::Ending);
            }
            _ if worded[from] => add(name, Kind::Words),
            _ => add(name, Kind::Number),
        }
    }
    Ok(columns)
}

fn write_file(table: &Path, part: &Path) -> Result<(), Fault> {
    let columns = columns(table)?;
    let fields = columns.iter().map(Column::field).collect::<Result<Vec<_>, _>>()?;
    let schema = Type::group_type_builder("rows").with_fields(fields).build()?;
    // No version: the same rows give the same bytes.
    let properties = WriterProperties::builder().set_created_by("tankcheck".into()).build();
    let out = BufWriter::new(File::create(part)?);
    let mut writer = SerializedFileWriter::new(out, Arc::new(schema), Arc::new(properties))?;
    let mut reader = csv::Reader::from_path(table)?;
    let mut records = reader.records();
    loop {
        let rows: Vec<StringRecord> = records.by_ref().take(GROUP).collect::<Result<_, _>>()?;
        if rows.is_empty() {
            break;
        }
        let mut group = writer.next_row_group()?;
        for column in &columns {
            if let Some(mut at) = group.next_column()? {
                column.write(&rows, &mut at)?;
                at.close()?;
            }
        }
        group.close()?;
    }
    let out = writer.into_inner()?;
    let file = out.into_inner().map_err(std::io::IntoInnerError::into_error)?;
    Ok(file.sync_all()?)
}

/// Writes `rows.parquet` beside `rows.csv`, through a temporary name.
///
/// Errors: a table that cannot be read, a file that cannot be written.
pub(super) fn write(table: &Path, file: &Path) -> Result<(), Error> {
    let part = file.with_extension(format!("parquet{}", files::PART));
    let written = write_file(table, &part).and_then(|()| Ok(std::fs::rename(&part, file)?));
    written.map_err(|fault| {
        // The first error says more than one of removing what could not be written.
        let _ = std::fs::remove_file(&part);
        Error::Files(files::error::Error::Unwritten { path: file.into(), what: fault.to_string() })
    })
}

#[cfg(test)]
mod tests {
    use parquet::file::reader::{FileReader, SerializedFileReader};
    use parquet::record::Field;

    use super::*;

    const TABLE: &str = "tank,sample,record,level,status,fe.wave_m,fe.hoop_utilisation,fe.sliding_utilisation,message\n\
        101,0,r1,0.5,ok,1.25,0.1,0.3,\n\
        101,1,\"r,2\",1,refused,,,,\"no, it is \"\"odd\"\" – µ\"\n\
        102,0,r1,,ok,1e-7,fails,2.5e3,\n";

    /// Every cell of the table in the file, read by the reader of the crate: words, whole numbers, numbers to the last bit, nothing.
    #[test]
    fn every_cell_is_read_back() {
        let folder = tempfile::tempdir().unwrap();
        let (table, file) = (folder.path().join("rows.csv"), folder.path().join(FILE));
        std::fs::write(&table, TABLE).unwrap();
        write(&table, &file).unwrap();
        let reader = SerializedFileReader::new(File::open(&file).unwrap()).unwrap();
        assert_eq!(reader.metadata().file_metadata().num_rows(), 3);
        let word = |text: &str| Field::Str(text.into());
        let none = || Field::Null;
        let wanted = [
            vec![
                word("101"),
                Field::Int(0),
                word("r1"),
                Field::Double(0.5),
                word("ok"),
                Field::Double(1.25),
                Field::Double(0.1),
                none(),
                Field::Double(0.3),
                none(),
            ],
            vec![
                word("101"),
                Field::Int(1),
                word("r,2"),
                Field::Double(1.0),
                word("refused"),
                none(),
                none(),
                none(),
                none(),
                word("no, it is \"odd\" – µ"),
            ],
            vec![
                word("102"),
                Field::Int(0),
                word("r1"),
                none(),
                word("ok"),
                Field::Double(1e-7),
                none(),
                word("fails"),
                Field::Double(2.5e3),
                none(),
            ],
        ];
        for (row, wanted) in reader.get_row_iter(None).unwrap().zip(wanted) {
            let row = row.unwrap();
            let found: Vec<(String, Field)> = row.get_column_iter().map(|(n, f)| (n.clone(), f.clone())).collect();
            assert_eq!(found.iter().map(|(_, field)| field.clone()).collect::<Vec<_>>(), wanted);
            assert_eq!((found[6].0.as_str(), found[7].0.as_str()), ("fe.hoop_utilisation", "fe.hoop_ending"));
        }
        // The same rows, the same bytes; nothing is left beside.
        let bytes = std::fs::read(&file).unwrap();
        write(&table, &file).unwrap();
        assert_eq!(std::fs::read(&file).unwrap(), bytes);
        assert_eq!(std::fs::read_dir(folder.path()).unwrap().count(), 2);
    }

    #[test]
    fn a_table_that_cannot_be_read_is_an_error() {
        let folder = tempfile::tempdir().unwrap();
        assert!(write(&folder.path().join("none.csv"), &folder.path().join(FILE)).is_err());
    }
}
