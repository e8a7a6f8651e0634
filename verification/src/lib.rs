//! The `crossfibre` command: runs, traces, plans and verifies the reference.
