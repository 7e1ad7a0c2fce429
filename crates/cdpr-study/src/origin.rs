//! Which program ran trials, and on what machine, as run and summary files record it: without that, times say nothing.

use std::fs;

use serde::{Deserialize, Serialize};

/// A program at work on a machine; [`origin_here`] gives this one.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Origin {
    /// cdpr.
    pub program: String,
    /// Its version.
    pub version: String,
    /// The processor, as the system names it; none where it does not.
    pub cpu: Option<String>,
    /// The instruction set, such as x86_64.
    pub architecture: String,
    /// The operating system and, on Linux, the release of its kernel.
    pub os: String,
    /// Logical cores that the program may use.
    pub cores: usize,
    /// Threads that ran trials; none where rows were run elsewhere and handed over.
    pub threads: Option<usize>,
}

/// This program on this machine.
///
/// # Example
/// ```
/// let here = cdpr_study::origin_here(Some(2));
/// assert_eq!((here.program.as_str(), here.threads), ("cdpr", Some(2)));
/// assert!(here.cores >= 1 && here.os.starts_with(std::env::consts::OS));
/// ```
pub fn origin_here(threads: Option<usize>) -> Origin {
    Origin {
        program: "cdpr".into(),
        version: env!("CARGO_PKG_VERSION").into(),
        cpu: cpu(),
        architecture: std::env::consts::ARCH.into(),
        os: os(),
        cores: std::thread::available_parallelism().map_or(1, usize::from),
        threads,
    }
}

fn cpu() -> Option<String> {
    let name = match std::env::consts::OS {
        "windows" => std::env::var("PROCESSOR_IDENTIFIER").ok(),
        "macos" => {
            let asked = std::process::Command::new("sysctl").args(["-n", "machdep.cpu.brand_string"]).output();
            asked.ok().and_then(|answer| String::from_utf8(answer.stdout).ok())
        }
        _ => fs::read_to_string("/proc/cpuinfo").ok().and_then(|text| model_name(&text).map(str::to_string)),
    };
    name.map(|name| name.trim().to_string()).filter(|name| !name.is_empty())
}

/// The first `model name` of `/proc/cpuinfo`.
fn model_name(cpuinfo: &str) -> Option<&str> {
    let mut pairs = cpuinfo.lines().filter_map(|line| line.split_once(':'));
    pairs.find(|(key, _)| key.trim() == "model name").map(|(_, name)| name.trim())
}

fn os() -> String {
    let name = std::env::consts::OS;
    match fs::read_to_string("/proc/sys/kernel/osrelease") {
        Ok(release) => format!("{name} {}", release.trim()),
        Err(_) => name.into(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_processor_is_named_as_linux_names_it() {
        assert_eq!(model_name("processor\t: 0\nmodel\t: 1\nmodel name\t: A 3000 @ 2 GHz\n"), Some("A 3000 @ 2 GHz"));
        assert_eq!(model_name("processor : 0\nBogoMIPS : 50.00\n"), None); // most ARM machines
    }
}
