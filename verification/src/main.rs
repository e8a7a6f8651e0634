//! The `crossfibre` command.
fn main() {}
