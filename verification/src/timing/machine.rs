//! What machine times are of, and a loop by which two machines can be set in relation.

use std::fmt;
use std::fs;
use std::hint::black_box;
use std::process::Command;
use std::thread::available_parallelism;

use serde::{Deserialize, Serialize};

use super::{Contestant, Turn, clocked};

/// A machine, as far as it says of itself; `unknown` where it does not.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Machine {
    /// The processor's name.
    pub processor: String,
    /// How many threads run at once.
    pub cores: Option<usize>,
    /// Extensions for vectors that the processor has and the project's programs use.
    pub vectors: Vec<String>,
    /// The operating system.
    pub system: String,
    /// What has compiled this program.
    pub compiler: String,
}

impl Machine {
    /// This one.
    pub fn here() -> Self {
        let unknown = || "unknown".to_owned();
        let release = |text: String| field(&text, "PRETTY_NAME", '=');
        let system = fs::read_to_string("/etc/os-release").ok().and_then(release);
        Self {
            processor: processor().unwrap_or_else(unknown),
            cores: available_parallelism().ok().map(usize::from),
            vectors: vectors().into_iter().map(str::to_owned).collect(),
            system: system.unwrap_or_else(|| std::env::consts::OS.into()),
            compiler: option_env!("CROSSFIBRE_COMPILER").map_or_else(unknown, str::to_owned),
        }
    }
}

impl fmt::Display for Machine {
    fn fmt(&self, to: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { processor, cores, vectors, system, compiler } = self;
        let cores = cores.map_or("unknown".into(), |cores| cores.to_string());
        let vectors = if vectors.is_empty() { "none known".into() } else { vectors.join(", ") };
        write!(to, "processor {processor}; cores {cores}; vectors {vectors}; {system}; {compiler}")
    }
}

fn processor() -> Option<String> {
    if let Ok(text) = fs::read_to_string("/proc/cpuinfo") {
        return field(&text, "model name", ':');
    }
    version(Command::new("sysctl").args(["-n", "machdep.cpu.brand_string"]))
}

/// The value of the first line `name = value`, without quotation marks.
fn field(text: &str, name: &str, sign: char) -> Option<String> {
    text.lines().find_map(|line| {
        let (found, value) = line.split_once(sign)?;
        (found.trim() == name).then(|| value.trim().trim_matches('"').to_owned())
    })
}

#[cfg(target_arch = "x86_64")]
fn vectors() -> Vec<&'static str> {
    let of = [
        (is_x86_feature_detected!("avx2"), "AVX2"),
        (is_x86_feature_detected!("fma"), "FMA"),
        (is_x86_feature_detected!("avx512f"), "AVX-512F"),
        (is_x86_feature_detected!("avx512dq"), "AVX-512DQ"),
        (is_x86_feature_detected!("avx512vl"), "AVX-512VL"),
    ];
    of.into_iter().filter_map(|(is_there, name)| is_there.then_some(name)).collect()
}

#[cfg(not(target_arch = "x86_64"))]
fn vectors() -> Vec<&'static str> {
    vec![]
}

/// The first line that a program prints, as compilers do for `--version`.
pub fn version(command: &mut Command) -> Option<String> {
    let output = command.output().ok().filter(|output| output.status.success())?;
    let text = String::from_utf8_lossy(&output.stdout);
    text.lines().next().map(str::to_owned)
}

/// Links of the calibration loop's chain.
pub const LINKS: u64 = 100_000;

/// x ← (√x + 0.83)/1.37, a square root, a sum and a quotient that wait for each other: the clock and
/// the latencies of the processor and nothing else. A link counts as an element-step.
pub fn calibration<'a>() -> Contestant<'a> {
    Contestant::new("calibration loop", || {
        let (seconds, _) = clocked(|| chain(black_box(3.1), LINKS));
        Ok(Turn { seconds, element_steps: LINKS, checksum: None })
    })
}

fn chain(start: f64, links: u64) -> f64 {
    (0..links).fold(start, |x, _| (x.sqrt() + 0.83) / 1.37)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_chain_ends_where_its_links_no_longer_change_it() {
        // 1.37 x = √x + 0.83: √x = (1 + √(1 + 4 × 1.37 × 0.83))/(2 × 1.37).
        let root = (1.0 + (1.0_f64 + 4.0 * 1.37 * 0.83).sqrt()) / (2.0 * 1.37);
        let away = (chain(3.1, 60) / (root * root) - 1.0).abs();
        // A link shrinks what is left to 1/(2 × 1.37 √x) = 0.31 of it, sixty to 1e-30; there remain three
        // roundings of half a unit a link, and three of the closed form.
        assert!(away < 6.0 * f64::EPSILON, "{away:e}");
        assert_ne!(chain(3.1, 3), chain(3.1, 4));
    }

    #[test]
    fn a_field_is_found_by_its_whole_name_and_without_quotation_marks() {
        let text = "NAME=\"Some\"\nmodel name extra\t: no\nmodel name\t: A Processor: 7\nmodel name\t: B\n";
        assert_eq!(field(text, "model name", ':').as_deref(), Some("A Processor: 7"));
        assert_eq!(field(text, "NAME", '=').as_deref(), Some("Some"));
        assert_eq!(field(text, "PRETTY_NAME", '='), None);
    }

    /// What Linux says of the first processor.
    #[cfg(target_os = "linux")]
    fn said(name: &str) -> Option<String> {
        let text = fs::read_to_string("/proc/cpuinfo").unwrap();
        let line = text.lines().find(|line| line.starts_with(name))?;
        line.split_once(": ").map(|(_, value)| value.trim().to_owned())
    }

    #[test]
    #[cfg(target_os = "linux")]
    fn a_processor_is_called_as_the_system_calls_it() {
        assert_eq!(processor(), said("model name"));
    }

    #[test]
    #[cfg(all(target_os = "linux", target_arch = "x86_64"))]
    fn vectors_are_those_that_the_system_knows_of() {
        let flags = said("flags").unwrap();
        let is_there = |name: &str| flags.split_whitespace().any(|flag| flag == name);
        // A name without its hyphen and in small letters is the flag.
        let all = ["AVX2", "FMA", "AVX-512F", "AVX-512DQ", "AVX-512VL"].into_iter();
        let expected = all.filter(|name| is_there(&name.replace('-', "").to_lowercase()));
        assert_eq!(vectors(), expected.collect::<Vec<_>>());
    }

    #[test]
    #[cfg(unix)]
    fn a_version_is_the_first_line_of_a_program_that_succeeds() {
        let printed = |script: &str| version(Command::new("sh").args(["-c", script]));
        assert_eq!(printed("echo cc 7.3; echo more").as_deref(), Some("cc 7.3"));
        assert_eq!(printed("echo cc 7.3; exit 1"), None);
    }

    #[test]
    fn what_a_machine_does_not_say_is_called_unknown() {
        let machine = Machine {
            processor: "unknown".into(),
            cores: None,
            vectors: vec![],
            system: "plan9".into(),
            compiler: "unknown".into(),
        };
        assert_eq!(
            machine.to_string(),
            "processor unknown; cores unknown; vectors none known; plan9; unknown"
        );
        assert_eq!(version(&mut Command::new("no-such-program-of-crossfibre")), None);
    }
}
