//! The `crossfibre` command: runs, traces, plans and verifies the reference.

pub mod bits;
pub mod cases;
pub mod claims;
pub mod closed_form;
pub mod command;
pub mod cost;
pub mod diff;
pub mod exact_file;
pub mod exact_plot;
pub mod exact_summary;
pub mod exit;
pub mod extremes;
pub mod figures;
pub mod fronts;
pub mod golden;
pub mod ledger_effects;
pub mod output;
pub mod plot;
pub mod record;

pub mod report;
pub mod stability;
pub mod summary;
pub mod sweep;
pub mod tables;
pub mod trace_line;
pub mod wide;
pub mod worked;
