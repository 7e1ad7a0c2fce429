//! `cdpr batch`

use std::path::Path;

use cdpr_core::{Error, ErrorClass};
use cdpr_study::{BatchFolder, Described, MethodSummary, PairSummary, Progress, RunOptions, SummaryFile, TestSummary};

use crate::Answer;
use crate::args::{BatchArgs, Format, Trials};
use crate::input;
use crate::interruption::{answered_while, interrupted, writing};
use crate::output::{Console, count};
use crate::progress::bar;

pub fn run(args: &BatchArgs, out: &Console) -> Result<Answer, Error> {
    let experiment = input::experiment(&args.experiment)?;
    let trials = args.trials.clone().map_or(0..experiment.trials, |Trials(range)| range);
    let mut folder = BatchFolder::open(&args.output, &experiment, trials, args.resume)?;
    if folder.done() > 0 {
        out.say(&format!("{} already done", count(folder.done(), "trial")));
    }
    let bar = bar(out);
    let mut progress = |progress: Progress| {
        bar.set_length(progress.total as u64);
        bar.set_position(progress.done as u64);
        progress.failure.iter().for_each(|failure| bar.suspend(|| out.say(&format!("failed: {failure}"))));
    };
    let options = RunOptions { threads: args.threads, interrupted: &interrupted, progress: &mut progress };
    // Trials check the clock themselves, and after an interruption the tables of the finished trials must still be
    // written.
    let writing = writing();
    let ended = folder.run(&experiment, options);
    answered_while(&writing);
    drop(writing);
    bar.finish_and_clear();
    match ended {
        Ok(()) => {
            print_summary(&args.output, args.format, out)?;
            Ok(Answer::Yes)
        }
        Err(error) if error.class() == ErrorClass::Interrupted => {
            let done = count(folder.done(), "trial");
            out.say(&format!("{done} in {}; continue with --resume", args.output.display()));
            Err(error)
        }
        Err(error) => Err(error.in_file(&args.experiment)),
    }
}

/// Prints the contents of `summary.json`.
pub fn print_summary(folder: &Path, format: Format, out: &Console) -> Result<(), Error> {
    let text = cdpr_files::text::read(folder.join("summary.json"))?;
    if format == Format::Json {
        out.result(text.trim_end());
        return Ok(());
    }
    let summary: SummaryFile = cdpr_files::text::parse(&text, cdpr_files::text::Notation::Json)?;
    for line in lines(&summary) {
        out.result(&line);
    }
    let history = if folder.join("history.csv").is_file() { " history.csv," } else { "" };
    out.say(&format!("wrote trials.csv, timings.csv,{history} summary.json to {}", folder.display()));
    Ok(())
}

fn lines(summary: &SummaryFile) -> Vec<String> {
    let name = |m: &MethodSummary| format!("{}, {}", m.scenario, m.method);
    let width = summary.methods.iter().map(|m| name(m).chars().count()).max().unwrap_or(0);
    let head = "solved   planning, ms    median  shortening, ms        raw, m           cost, m";
    let mut lines = vec![format!("{:width$}  {head}", "mean ± standard deviation")];
    let number = |number: Option<f64>| number.unwrap_or(f64::NAN);
    let pair = |of: &Described, scale: f64| format!("{:.3} ± {:.3}", scale * number(of.mean), scale * number(of.sd));
    for method in &summary.methods {
        lines.push(format!(
            "{:width$}  {:>6} {:>15} {:>9.3} {:>15} {:>15} {:>15}",
            name(method),
            format!("{}/{}", method.solved, method.n),
            pair(&method.planning_seconds, 1e3),
            1e3 * number(method.planning_seconds.median),
            pair(&method.post_seconds, 1e3),
            pair(&method.raw_cost, 1.0),
            pair(&method.cost, 1.0),
        ));
    }
    let p = |p: f64| if p < 1e-3 { "<0.001".to_string() } else { format!("{p:.4}") };
    let told = |test: &TestSummary| format!("{} {}", test.group, test.p.map_or("-".to_string(), p));
    let letters: Vec<String> = summary.t_tests.iter().map(told).collect();
    if !letters.is_empty() {
        lines.push(format!("p of the t-tests: {}", letters.join(", ")));
    }
    lines.extend(compared_in_pairs(summary).iter().map(paired_line));
    lines
}

/// Pairs of methods that have not solved the same trials, so that their means are over different scenes.
fn compared_in_pairs(summary: &SummaryFile) -> Vec<&PairSummary> {
    let solved = |scenario: &str, name: &str| {
        let of = |m: &&MethodSummary| m.scenario == scenario && m.method == name;
        summary.methods.iter().find(of).map_or(0, |m| m.solved)
    };
    let differ = |pair: &&PairSummary| {
        pair.cost.n > 0 && [&pair.a, &pair.b].iter().any(|name| solved(&pair.scenario, name) != pair.cost.n)
    };
    summary.pairs.iter().filter(differ).collect()
}

/// "hard1: 9 trials solved by both; anytime shorter in 9, two trees in 0; two trees 0.0310 m longer than anytime on average"
fn paired_line(PairSummary { scenario, a, b, cost }: &&PairSummary) -> String {
    let mean = cost.mean_difference.unwrap_or(f64::NAN);
    let (longer, shorter) = if mean >= 0.0 { (a, b) } else { (b, a) };
    let by = format!("{longer} {:.4} m longer than {shorter} on average", mean.abs());
    let both = count(cost.n, "trial");
    format!("{scenario}: {both} solved by both; {a} shorter in {}, {b} in {}; {by}", cost.a_less, cost.b_less)
}
