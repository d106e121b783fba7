//! Who a verification is for and who answers for it: the cover of the report.

use serde::{Deserialize, Serialize};

use crate::units::System;
use crate::words;

words! {
    /// Language of a report.
    pub Language: English {
        /// English.
        English = "en",
        /// German.
        German = "de",
    }
}

/// The block `project` of `tank.json`. Absent entries stay blank on the cover.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Project {
    /// Name of the project.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Client.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub client: Option<String>,
    /// Number of the document.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub document: Option<String>,
    /// Revision of the document.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub revision: Option<String>,
    /// Date of the document.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub date: Option<String>,
    /// Author.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub author: Option<String>,
    /// Checker.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub checker: Option<String>,
    /// Who approves it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub approver: Option<String>,
    /// Language of the report; English if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub language: Option<Language>,
    /// Units of the report; SI if absent.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub units: Option<System>,
}

impl Project {
    /// Whether nothing is given.
    pub fn is_empty(&self) -> bool {
        *self == Project::default()
    }

    /// Number and revision of the document for running heads: `TK-104 rev. B`; empty without a number.
    pub fn mark(&self) -> String {
        match (&self.document, &self.revision) {
            (Some(document), Some(revision)) => format!("{document} rev. {revision}"),
            (Some(document), None) => document.clone(),
            (None, _) => String::new(),
        }
    }
}
