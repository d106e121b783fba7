//! Charts of a part.

use serde::{Deserialize, Serialize};
use tank::units::Dimension;

use super::fact::{Fact, Message, is_default};
use crate::channel::Channel;
use crate::value::unit_symbol;

/// Values against each other. Charts of one line that several engines have under one id are drawn into one figure.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Chart {
    /// Id; with the subject in front that of the file of the figure.
    pub id: String,
    /// Title; by default that of the id.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub title: Option<Message>,
    /// The rest of the caption.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub caption: Option<Message>,
    /// Room.
    #[serde(default, skip_serializing_if = "is_default")]
    pub room: Room,
    /// Horizontal axis.
    pub x: Axis,
    /// Vertical axis.
    pub y: Axis,
    /// Filled areas, drawn first.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub areas: Vec<Line>,
    /// Curves.
    pub lines: Vec<Line>,
    /// Values of x with their symbols.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub marks: Vec<(f64, String)>,
}

/// Room of a chart.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Room {
    /// Half the width of the text.
    #[default]
    Half,
    /// The same, higher.
    Tall,
    /// The width of the text.
    Wide,
}

/// An axis.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Axis {
    /// Id.
    pub id: String,
    /// Dimension, written as the symbol of its unit in SI.
    #[serde(with = "unit_symbol")]
    pub unit: Dimension,
    /// What it holds.
    #[serde(default, skip_serializing_if = "is_default")]
    pub scale: Scale,
}

/// What an axis holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Scale {
    /// The values.
    #[default]
    Free,
    /// The values and zero.
    Zero,
    /// From one value to another.
    Range([f64; 2]),
    /// The logarithms of the values.
    Log,
    /// The same with labels at powers of ten, at most this many below the largest value.
    Decades(u8),
}

/// A curve, or the corners of an area.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Line {
    /// Text of the legend.
    #[serde(default, skip_serializing_if = "Fact::is_none")]
    pub label: Fact,
    /// Its look.
    #[serde(default, skip_serializing_if = "is_default")]
    pub look: Look,
    /// Points in SI.
    pub points: Vec<[f64; 2]>,
}

/// What a curve stands for, which gives it its look.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Look {
    /// The result.
    #[default]
    Main,
    /// A result of many points.
    Thin,
    /// Another one beside it.
    Other,
    /// The result on soft ground.
    Soft,
    /// The result on hard ground.
    Hard,
    /// The result on rock.
    Rock,
    /// The ground.
    Ground,
    /// The ground without load.
    Level,
    /// What has yielded.
    Yielded,
    /// A method, by the class of its colour.
    Method(String),
}

/// Histories of one dimension over time.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct History {
    /// Id, also of the file of the figure.
    pub id: String,
    /// Id of the axis upwards.
    pub axis: String,
    /// At most two columns of `series.csv`; the legend calls them x and y.
    pub channels: Vec<String>,
}

impl Chart {
    /// A chart of half the width.
    pub fn new(id: &str, x: Axis, y: Axis, lines: Vec<Line>) -> Chart {
        Chart {
            id: id.into(),
            title: None,
            caption: None,
            room: Room::Half,
            x,
            y,
            areas: Vec::new(),
            lines,
            marks: Vec::new(),
        }
    }
}

impl Axis {
    /// An axis.
    pub fn new(id: &str, unit: Dimension, scale: Scale) -> Axis {
        Axis { id: id.into(), unit, scale }
    }
}

impl Line {
    /// A line.
    pub fn new(label: impl Into<Fact>, look: Look, points: Vec<[f64; 2]>) -> Line {
        Line { label: label.into(), look, points }
    }
}

impl History {
    /// Channels of one dimension.
    pub fn new(id: &str, axis: &str, channels: &[Channel]) -> History {
        History { id: id.into(), axis: axis.into(), channels: channels.iter().map(|channel| channel.id()).collect() }
    }
}
