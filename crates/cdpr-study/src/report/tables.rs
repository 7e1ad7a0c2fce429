//! Tables of a report as HTML. All text from files goes through `escaped`.

use super::paper::{Claim, Printed};
use super::study::{APART, Study};
use crate::experiment_spec::Measure;
use crate::{Described, MethodSummary, Origin, PairSummary, Paired, Rules, TestSummary};
use cdpr_core::words::count;
use cdpr_view::escaped;

/// Whether a cell holds a number, or several, with which its column is aligned to the right.
fn is_number(cell: &str) -> bool {
    let allowed = |c: char| c.is_ascii_digit() || " .-–…±()%e".contains(c);
    cell.contains(|c: char| c.is_ascii_digit() || c == '–') && cell.chars().all(allowed)
}

/// A table from its header and rows; cells are HTML. Columns of numbers are aligned to the right.
pub(super) fn table(head: &[&str], rows: &[Vec<String>]) -> String {
    let numbers: Vec<bool> = (0..head.len())
        .map(|column| !rows.is_empty() && rows.iter().all(|row| row.get(column).is_some_and(|cell| is_number(cell))))
        .collect();
    let line = |tag: &str, cells: &mut dyn Iterator<Item = &str>| {
        let class = |column: usize| if numbers.get(column) == Some(&true) { " class=\"n\"" } else { "" };
        let cells: String =
            cells.enumerate().map(|(column, cell)| format!("<{tag}{}>{cell}</{tag}>", class(column))).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let body: String = rows.iter().map(|row| line("td", &mut row.iter().map(String::as_str))).collect();
    format!(
        "<div class=\"wide\"><table>\n<thead>{}</thead>\n<tbody>{body}</tbody></table></div>\n",
        line("th", &mut head.iter().copied())
    )
}

/// A number with four significant digits.
pub(super) fn four(number: f64) -> String {
    if number == 0.0 || !number.is_finite() {
        return if number == 0.0 { "0".into() } else { "–".into() };
    }
    let before = number.abs().log10().floor() as i32 + 1;
    if before < -3 {
        return format!("{number:.3e}");
    }
    format!("{number:.*}", (4 - before).clamp(0, 7) as usize)
}

fn cell(number: Option<f64>, scale: f64) -> String {
    number.map_or("–".to_string(), |number| four(scale * number))
}

/// Name, units with their scales (the largest unit first), and location of a measure.
type Column = (&'static str, &'static [(&'static str, f64)], fn(&MethodSummary) -> &Described);

const TIMES: &[(&str, f64)] = &[(", s", 1.0), (", ms", 1e3), (", µs", 1e6)];
const LENGTHS: &[(&str, f64)] = &[(", m", 1.0), (", mm", 1e3)];

const MEASURES: [Column; 8] = [
    ("Planning time", TIMES, |m| &m.planning_seconds),
    ("Time of post-processing", TIMES, |m| &m.post_seconds),
    ("Cost of the planner's path", LENGTHS, |m| &m.raw_cost),
    ("Cost of the final path", LENGTHS, |m| &m.cost),
    ("Reduction by post-processing", &[(", %", 100.0)], |m| &m.reduction),
    ("Waypoints of the final path", &[("", 1.0)], |m| &m.waypoints),
    ("Motions checked by the planner", &[("", 1.0)], |m| &m.motion_checks),
    ("Time to compile the scene, not part of the planning time", TIMES, |m| &m.compile_seconds),
];

/// The largest mean or median of a measure.
fn largest(study: &Study, of: fn(&MethodSummary) -> &Described) -> f64 {
    let found = study.summary.methods.iter().flat_map(|m| [of(m).mean, of(m).median]).flatten();
    found.map(f64::abs).filter(|value| value.is_finite()).fold(0.0, f64::max)
}

/// The first unit in which a number is at least 1, or else the last one.
fn fitting(units: &[(&'static str, f64)], largest: f64) -> (&'static str, f64) {
    let found = units.iter().find(|(_, scale)| largest * scale >= 1.0);
    *found.unwrap_or(if largest > 0.0 { &units[units.len() - 1] } else { &units[0] })
}

/// Decimals with which a number has four digits.
fn decimals(number: f64) -> usize {
    if number > 0.0 { (3 - number.log10().floor() as i32).clamp(0, 4) as usize } else { 0 }
}

/// One table per measure, with all scenarios and methods.
pub(super) fn statistics(study: &Study) -> String {
    let interval = format!("{} % interval of the mean", 100.0 * study.summary.confidence);
    let head = [
        "scenario",
        "method",
        "solved",
        "mean",
        "sd",
        &interval,
        "median",
        "quartiles",
        "5 % and 95 %",
        "least and largest",
    ];
    let row = |m: &MethodSummary, of: fn(&MethodSummary) -> &Described, (scale, decimals): (f64, usize)| {
        // All numbers of a table have the same decimals.
        let cell = |number: Option<f64>| match number.filter(|number| number.is_finite()) {
            Some(number) => format!("{:.*}", decimals, scale * number),
            None => "–".to_string(),
        };
        let pair = |low, high| format!("{} … {}", cell(low), cell(high));
        let d = of(m);
        let [low, high] = d.confidence_interval;
        vec![
            escaped(&m.scenario),
            escaped(&m.method),
            format!("{} of {}", m.solved, m.n),
            cell(d.mean),
            cell(d.sd),
            pair(low, high),
            cell(d.median),
            pair(d.q25, d.q75),
            pair(d.q05, d.q95),
            pair(d.min, d.max),
        ]
    };
    let one = |(name, units, of): &Column| {
        let most = largest(study, *of);
        let (unit, scale) = fitting(units, most);
        let form = (scale, decimals(scale * most));
        let rows: Vec<Vec<String>> = study.summary.methods.iter().map(|m| row(m, *of, form)).collect();
        let open = if rows.len() > 24 { "" } else { " open" };
        format!("<details{open}><summary>{name}{unit}</summary>\n{}</details>\n", table(&head, &rows))
    };
    MEASURES.iter().map(one).collect()
}

/// The programs and machines that ran the trials, one paragraph each.
pub(super) fn origins(study: &Study) -> String {
    let line = |origin: &Origin| {
        let Origin { program, version, cpu, architecture, os, cores, threads } = origin;
        let threads = threads.map_or(String::new(), |threads| format!(", {}", count(threads, "thread")));
        let cpu = cpu.as_deref().unwrap_or("unknown processor");
        escaped(&format!("{program} {version} on {cpu} ({architecture}, {}), {os}{threads}", count(*cores, "core")))
    };
    study.summary.origins.iter().map(|origin| format!("<p>Run by {}.</p>\n", line(origin))).collect()
}

/// How each method plans.
pub(super) fn rules(study: &Study) -> String {
    let row = |rules: &Rules| {
        let Rules { method, planner, engine, interference, step, post, repeats, sweep, .. } = rules;
        let swept = |key: &str, is: bool| if is { format!("{key}, swept") } else { key.to_string() };
        let sweep = sweep.as_ref();
        vec![
            escaped(method),
            escaped(planner),
            escaped(engine),
            escaped(interference),
            swept(&four(*step), sweep.is_some_and(|sweep| !sweep.step.is_empty())),
            escaped(&swept(post, sweep.is_some_and(|sweep| !sweep.post.is_empty()))),
            swept(&repeats.to_string(), sweep.is_some_and(|sweep| !sweep.repeats.is_empty())),
        ]
    };
    let rows: Vec<Vec<String>> = study.summary.rules.iter().map(row).collect();
    if rows.is_empty() {
        return String::new();
    }
    table(&["method", "planner", "engine", "interference", "step, m", "post-processing", "repeats"], &rows)
}

/// The t-tests, with the paper's p-values if it prints any.
pub(super) fn t_tests(study: &Study, printed: Option<&Printed>) -> String {
    let name = |pair: &[String; 2]| escaped(&pair.join(", "));
    let row = |test: &TestSummary| {
        let p = probability(test.p);
        let theirs = printed.and_then(|printed| printed.p_values.get(&test.group));
        let theirs = theirs.map_or("–".to_string(), |p| escaped(p));
        let measure = measure_name(test.measure).to_string();
        let mut cells = vec![escaped(&test.group), measure, name(&test.a), name(&test.b)];
        cells.extend([cell(test.t, 1.0), cell(test.df, 1.0), p]);
        cells.extend(printed.is_some().then_some(theirs));
        cells.extend(in_pairs(test.paired.as_ref()));
        cells
    };
    let rows: Vec<Vec<String>> = study.summary.t_tests.iter().map(row).collect();
    let mut head = vec!["group", "measure", "a", "b", "t", "degrees of freedom", "p"];
    head.extend(printed.is_some().then_some("p in the paper"));
    head.extend(["pairs", "a less", "b less", "p of the pairs"]);
    table(&head, &rows)
}

/// Cells with the number of pairs, in how many each is less, and the probability of the paired test.
fn in_pairs(paired: Option<&Paired>) -> [String; 4] {
    let Some(Paired { n, a_less, b_less, p, .. }) = paired else { return ["–"; 4].map(str::to_string) };
    [n.to_string(), a_less.to_string(), b_less.to_string(), probability(*p)]
}

fn probability(p: Option<f64>) -> String {
    p.map_or("–".to_string(), |p| if p < 1e-3 { "&lt; 0.001".into() } else { format!("{p:.4}") })
}

/// The lengths of each method beside those of the first one of its scenario, in the trials that both have solved.
pub(super) fn pairs(study: &Study) -> String {
    let row = |PairSummary { scenario, a, b, cost }: &PairSummary| {
        // In mm, without the sign of a zero.
        let longer = |mean: f64| (1e6 * mean).round() / 1e3 + 0.0;
        let mean = cost.mean_difference.map_or("–".to_string(), |mean| format!("{:.3}", longer(mean)));
        let [n, a_less, b_less, p] = in_pairs(Some(cost));
        vec![escaped(scenario), escaped(a), escaped(b), n, a_less, b_less, mean, p]
    };
    let rows: Vec<Vec<String>> = study.summary.pairs.iter().map(row).collect();
    let head =
        ["scenario", "a", "b", "trials of both", "a shorter", "b shorter", "a longer by, mm (mean)", "p of the pairs"];
    table(&head, &rows)
}

fn measure_name(measure: Measure) -> &'static str {
    match measure {
        Measure::PlanningSeconds => "planning time",
        Measure::PostSeconds => "time of post-processing",
        Measure::RawCost => "cost of the planner's path",
        Measure::Cost => "cost",
    }
}

/// Means and standard deviations beside the paper's.
pub(super) fn beside(study: &Study, printed: &Printed) -> String {
    let mut rows = Vec::new();
    for cell in &printed.means {
        let measures = [
            ("planning time, s", Measure::PlanningSeconds, cell.planning_seconds),
            ("time of post-processing, s", Measure::PostSeconds, cell.post_seconds),
            ("cost, m", Measure::Cost, cell.cost),
        ];
        for (name, measure, theirs) in measures {
            let Some([mean, sd]) = theirs else { continue };
            let ours = study.method(&cell.of).map(|m| m.of(measure));
            let ours = ours.and_then(|d| Some((d.mean?, d.sd?)));
            rows.push(vec![
                escaped(&cell.of[0]),
                escaped(&cell.of[1]),
                name.to_string(),
                format!("{mean} ± {sd}"),
                ours.map_or("–".into(), |(mean, sd)| format!("{} ± {}", four(mean), four(sd))),
                ours.map_or("–".into(), |(ours, _)| four(ours / mean)),
            ]);
        }
    }
    table(&["scenario", "method", "measure", "paper, mean ± sd", "here, mean ± sd", "here / paper"], &rows)
}

/// The percentages that the paper draws from its table, beside ours.
pub(super) fn claims(study: &Study, printed: &Printed) -> String {
    let row = |claim: &Claim| {
        let found = percentage(study, claim);
        let here = found.map_or("–".into(), |[p, low, high]| format!("{p:.2} ({low:.2} … {high:.2})"));
        let neutral = if claim.less { 0.0 } else { 100.0 };
        let verdict =
            found.map_or("–", |[_, low, high]| match (claim.percent > neutral, low > neutral, high < neutral) {
                (true, true, _) | (false, _, true) => "yes",
                (true, _, true) | (false, true, _) => "no, the other way round",
                _ => "not distinguishable",
            });
        vec![escaped(&claim.a[0]), escaped(&claim.says), format!("{:.2}", claim.percent), here, verdict.to_string()]
    };
    let rows: Vec<Vec<String>> = printed.claims.iter().map(row).collect();
    table(&["scenario", "what", "paper, %", "here, % (interval)", "same direction"], &rows)
}

/// 100 a/b or 100 (1 − a/b) of two means, with a 95 % interval by the delta method for independent samples.
fn percentage(study: &Study, claim: &Claim) -> Option<[f64; 3]> {
    let of = |pair| {
        let m = study.method(pair)?;
        let d = m.of(claim.measure);
        Some((d.mean?, d.sd? / d.mean? / (m.solved as f64).sqrt()))
    };
    let ((a, ea), (b, eb)) = (of(&claim.a)?, of(&claim.b)?);
    let ratio = a / b;
    let half = 1.96 * ratio * ea.hypot(eb);
    let percents = [ratio, ratio - half, ratio + half].map(|r| 100.0 * if claim.less { 1.0 - r } else { r });
    let [p, x, y] = percents;
    Some([p, x.min(y), x.max(y)])
}

/// Differences between the orders of rewinding; empty without a sweep over both.
pub(super) fn orders(study: &Study, printed: Option<&Printed>) -> String {
    let gaps = study.order_gaps();
    if gaps.is_empty() {
        return String::new();
    }
    let row = |gap: &super::study::OrderGap| {
        let beyond = gap.beyond.map(|share| format!("{share:.1}"));
        let numbers = [gap.difference, gap.gap, gap.largest, gap.gains[0], gap.gains[1]].map(|g| format!("{g:.3}"));
        let names = [escaped(&gap.backward.scenario), escaped(&gap.backward.method), gap.trials.to_string()];
        [&names[..], &numbers[..3], &beyond[..], &numbers[3..]].concat()
    };
    let rows: Vec<Vec<String>> = gaps.iter().map(row).collect();
    let [different, one, five] = APART.map(|apart| format!("trials beyond {apart}, %"));
    let head = [
        "scenario",
        "backward first, against its twin",
        "trials",
        "mean difference",
        "mean gap",
        "largest gap",
        &different,
        &one,
        &five,
        "both gain over backward",
        "both gain over forward",
    ];
    let paper =
        printed.and_then(|p| p.order_gap).map_or(String::new(), |gap| format!(" The paper prints a gap of {gap}."));
    format!(
        "<h2>Order of rewinding</h2>\n<p>Reductions on the same raw paths, in percentage points of the raw cost; the \
         gap is the absolute difference.{paper}</p>\n{}",
        table(&head, &rows)
    )
}
