//! Running the command in tests.

#![allow(clippy::unwrap_used)] // a test may
#![allow(dead_code)] // each test file uses its part

use std::path::{Path, PathBuf};

use assert_cmd::cargo::cargo_bin_cmd;

/// How a command ended.
pub struct Ended {
    pub code: i32,
    pub stdout: String,
    pub stderr: String,
}

impl Ended {
    /// Everything that a user sees, for a snapshot.
    pub fn seen(&self) -> String {
        let Self { code, stdout, stderr } = self;
        format!("exit code {code}\n--- standard output\n{stdout}--- standard error\n{stderr}")
    }
}

/// The folder of the shipped scenes.
pub fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("scenes")
}

/// Runs the command in a folder, so that messages hold no paths of this machine.
pub fn crossfibre(folder: &Path, arguments: &[&str]) -> Ended {
    let output = cargo_bin_cmd!("crossfibre").current_dir(folder).args(arguments).output().unwrap();
    let text = |bytes| String::from_utf8(bytes).unwrap();
    Ended {
        code: output.status.code().unwrap(),
        stdout: text(output.stdout),
        stderr: text(output.stderr),
    }
}

/// Holds what is seen against `golden/cli/<name>.snap`.
pub fn assert_snapshot(name: &str, seen: &str) {
    assert_snapshot_in("cli", name, seen);
}

/// Holds a text against `golden/<folder>/<name>.snap`; `INSTA_UPDATE=always` writes it anew.
pub fn assert_snapshot_in(folder: &str, name: &str, text: &str) {
    let mut settings = insta::Settings::clone_current();
    let golden = Path::new(env!("CARGO_MANIFEST_DIR")).join("../golden");
    settings.set_snapshot_path(golden.join(folder));
    settings.set_prepend_module_to_snapshot(false);
    settings.set_omit_expression(true);
    settings.bind(|| insta::assert_snapshot!(name, text));
}
