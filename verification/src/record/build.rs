//! What the program is that has made a record.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// How the program was built; `unknown` where the build did not say.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Build {
    /// The compiler and its version.
    pub compiler: String,
    /// The machine that it was compiled for.
    pub target: String,
    /// `release` or `debug`.
    pub profile: String,
    /// FNV-1a, 64 bits, of the source of the library and of this command, in hexadecimal.
    pub source: String,
    /// The commit at which the source was built; none outside of a repository.
    pub commit: Option<String>,
    /// Whether the source was another than that of the commit.
    pub modified: Option<bool>,
}

impl Build {
    /// That of this program.
    pub fn here() -> Self {
        let text = |value: Option<&str>| value.unwrap_or("unknown").to_owned();
        Self {
            compiler: text(option_env!("CROSSFIBRE_COMPILER")),
            target: text(option_env!("CROSSFIBRE_TARGET")),
            profile: text(option_env!("CROSSFIBRE_PROFILE")),
            source: text(option_env!("CROSSFIBRE_SOURCE")),
            commit: option_env!("CROSSFIBRE_COMMIT").map(str::to_owned),
            modified: option_env!("CROSSFIBRE_MODIFIED").map(|modified| modified == "yes"),
        }
    }

    /// The commit in words.
    pub fn commit_in_words(&self) -> String {
        match (&self.commit, self.modified) {
            (None, _) => "of no known commit".into(),
            (Some(commit), Some(true)) => format!("of commit {commit}, modified"),
            (Some(commit), _) => format!("of commit {commit}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_build_says_what_made_it() {
        let build = Build::here();
        assert!(build.compiler.starts_with("rustc "), "{build:?}");
        assert!(["debug", "release", "unknown"].contains(&build.profile.as_str()), "{build:?}");
        assert!(build.source.len() == 16 && build.target.contains('-'), "{build:?}");
    }
}
