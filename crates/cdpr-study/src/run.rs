//! Runs the trials of an experiment on several threads and delivers their rows in order.
//!
//! Trial 0 of every method in every scenario comes first, then trial 1 of all, so that the rate of progress stays the
//! same to the end. Each trial has its own stream of random numbers, so neither threads nor interruptions change a row.
//!
//! Threads wait when they are 4096 trials ahead of the oldest unfinished one, which limits memory. They share no
//! engine, since they would contend for its hint.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{RecvTimeoutError, SyncSender, sync_channel};
use std::sync::{Arc, Condvar, Mutex, PoisonError};
use std::time::{Duration, Instant};

use serde::{Deserialize, Deserializer, Serialize, Serializer, de};

use super::derived_seed;
use super::experiment::{Experiment, Method, Scenario};
use super::random_scene::RandomScenes;
use cdpr_core::Choice;
use cdpr_core::collision::{Checker, Engine, Interference};
use cdpr_core::compiled::CompiledScene;
use cdpr_core::error::{Error, ErrorClass, caught};
use cdpr_core::geometry::Pose;
use cdpr_core::limits::PROOF_EFFORT;
use cdpr_core::model::Scene;
use cdpr_core::plan::{PlanOptions, PlanResult, Post, Query, Route, post_process, search_route};
use cdpr_core::planning::{Milestone, Status};
use cdpr_core::proof::{Answer, decide};
use cdpr_core::watch::{Interrupt, Watch, in_time, thread_count};

/// Maximum number of trials finished ahead of the oldest unfinished one; limits memory.
const AHEAD: usize = 4096;
/// Time between two polls of the interrupt.
const PATIENCE: Duration = Duration::from_millis(20);

/// How a trial ended; serialized by name.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub enum TrialStatus {
    /// Planning ended with this status.
    Ended(Status),
    /// The program failed; the progress gives the reason.
    #[default]
    Failed,
    /// A planner of the caller has returned no path.
    Unsolved,
    /// A planner of the caller has returned a path that is not valid, or that does not lead from start to goal.
    InvalidPath,
}

impl TrialStatus {
    /// Name of the status in files.
    pub fn name(self) -> &'static str {
        match self {
            TrialStatus::Ended(status) => status.name(),
            TrialStatus::Failed => "failed",
            TrialStatus::Unsolved => "unsolved",
            TrialStatus::InvalidPath => "invalid_path",
        }
    }

    /// The status of a name.
    ///
    /// # Errors
    /// An unknown name.
    pub fn named(name: &str) -> Result<Self, Error> {
        let ours = [TrialStatus::Failed, TrialStatus::Unsolved, TrialStatus::InvalidPath];
        match ours.into_iter().find(|status| status.name() == name) {
            Some(status) => Ok(status),
            None => Status::named(name).map(TrialStatus::Ended),
        }
    }
}

impl Serialize for TrialStatus {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.serialize_str(self.name())
    }
}

impl<'de> Deserialize<'de> for TrialStatus {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        TrialStatus::named(&String::deserialize(deserializer)?).map_err(de::Error::custom)
    }
}

/// A row of `trials.csv`: a trial of a method in a scenario. Its keys are the columns, in this order; numbers of a trial
/// that was not solved are empty.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct TrialRow {
    /// Name of the scenario.
    pub scenario: String,
    /// Name of the method.
    pub method: String,
    /// Number of the trial.
    pub trial: usize,
    /// Seed of the trial: planning the scene with it reproduces the path.
    pub seed: u64,
    /// Outcome of the trial.
    pub status: TrialStatus,
    /// Length of the planner's path, m.
    pub raw_cost: Option<f64>,
    /// Length of the final path, m.
    pub cost: Option<f64>,
    /// Waypoints of the planner's path.
    pub raw_waypoints: Option<usize>,
    /// Waypoints of the final path.
    pub waypoints: Option<usize>,
    /// Nodes of the tree.
    pub nodes: Option<usize>,
    /// Motions checked by the planner.
    pub motion_checks: Option<usize>,
}

/// All data of a trial, in the order of the files of rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// The part that follows from the seed.
    pub result: TrialRow,
    /// Time of the planner, s.
    pub planning_seconds: Option<f64>,
    /// Time of rewinding, s.
    pub post_seconds: Option<f64>,
    /// When the planner's path improved, if the experiment requests it; only in the first variant of a sweep.
    #[serde(with = "milestones")]
    pub history: Vec<Milestone>,
    /// Time to compile the scene for the engine, s, in the first trial of a method for which a thread has compiled it; the
    /// trials that share it have none.
    #[serde(default)]
    pub compile_seconds: Option<f64>,
}

/// Milestones as one field of CSV: `seconds samples cost`, separated by semicolons.
mod milestones {
    use serde::{Deserialize, Deserializer, Serializer, de::Error};

    use super::Milestone;

    pub fn serialize<S: Serializer>(history: &[Milestone], serializer: S) -> Result<S::Ok, S::Error> {
        let texts: Vec<_> = history.iter().map(|m| format!("{} {} {}", m.seconds, m.samples, m.cost)).collect();
        serializer.serialize_str(&texts.join(";"))
    }

    pub fn deserialize<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Vec<Milestone>, D::Error> {
        let text = String::deserialize(deserializer)?;
        let problem = |part| D::Error::custom(format!("found \"{part}\", expected seconds, samples and cost"));
        text.split_terminator(';').map(|part| milestone(part).ok_or_else(|| problem(part))).collect()
    }

    fn milestone(text: &str) -> Option<Milestone> {
        let mut numbers = text.split(' ');
        let seconds = numbers.next()?.parse().ok()?;
        let samples = numbers.next()?.parse().ok()?;
        let cost = numbers.next()?.parse().ok()?;
        numbers.next().is_none().then_some(Milestone { seconds, samples, cost })
    }
}

/// Options of a run.
pub struct RunOptions<'a> {
    /// Number of threads; `None` means the number of cores.
    pub threads: Option<usize>,
    /// Polled often; true ends the run with [`Error::interrupted`] after all rows so far have been delivered.
    pub interrupted: &'a Interrupt<'a>,
    /// Called after each trial.
    pub progress: &'a mut dyn FnMut(Progress),
}

/// Progress of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Progress {
    /// Number of finished trials, over all methods and scenarios.
    pub done: usize,
    /// Total number of trials.
    pub total: usize,
    /// The reason, if the program failed in the trial just finished.
    pub failure: Option<String>,
}

/// Receives the rows of a trial: its group, and one row per variant.
pub type Sink<'a> = dyn FnMut(usize, &[Row]) -> Result<(), Error> + 'a;

/// A trial of a method in a scenario.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Unit {
    group: usize,
    trial: usize,
}

/// The number of threads that these options request.
///
/// # Errors
/// Zero threads, or too many.
pub fn threads_of(options: &RunOptions) -> Result<usize, Error> {
    let threads = options.threads.map(thread_count).transpose()?;
    Ok(threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, usize::from)))
}

/// Runs all unfinished trials below `end`; `next[group]` is the first unfinished trial of a group.
///
/// # Errors
/// Errors of the sink, a scenario for which no free scene is found, zero threads, [`Error::interrupted`].
pub fn run(
    experiment: &Experiment,
    next: &[usize],
    end: usize,
    options: RunOptions,
    sink: &mut Sink,
) -> Result<(), Error> {
    let threads = threads_of(&options)?;
    let total = next.iter().map(|first| end.saturating_sub(*first)).sum();
    let first = next.iter().copied().min().unwrap_or(end);
    let queue = Queue::new(Units { trial: first, group: 0, end, next });
    let (sender, results) = sync_channel(2 * threads);
    std::thread::scope(|scope| {
        for _ in 0..threads.min(total) {
            let (sender, queue) = (sender.clone(), &queue);
            let started = std::thread::Builder::new().spawn_scoped(scope, move || work(experiment, queue, &sender));
            if let Err(problem) = started {
                queue.stop();
                return Err(Error::invalid("threads", format!("{threads} threads cannot be started: {problem}")));
            }
        }
        drop(sender);
        let written = (|| {
            let mut early = BTreeMap::new();
            let mut done = 0;
            while done < total {
                if (options.interrupted)() {
                    return Err(Error::interrupted());
                }
                match results.recv_timeout(PATIENCE) {
                    Ok((index, result)) => early.insert(index, result),
                    Err(RecvTimeoutError::Timeout) => continue,
                    Err(RecvTimeoutError::Disconnected) => return Err(Error::invalid("", "all threads have ended")),
                };
                while let Some(result) = early.remove(&done) {
                    let Trial { group, rows, failure } = result?;
                    sink(group, &rows)?;
                    done += 1;
                    queue.written(done);
                    (options.progress)(Progress { done, total, failure });
                    if done < total && (options.interrupted)() {
                        return Err(Error::interrupted());
                    }
                }
            }
            Ok(())
        })();
        queue.stop();
        drop(results); // threads waiting to deliver a result find the receiver gone and end
        written
    })
}

/// The result of a trial.
struct Trial {
    group: usize,
    rows: Vec<Row>,
    failure: Option<String>,
}

/// The units in order of work.
struct Units<'a> {
    trial: usize,
    group: usize,
    end: usize,
    next: &'a [usize],
}

impl Iterator for Units<'_> {
    type Item = Unit;

    fn next(&mut self) -> Option<Unit> {
        while self.trial < self.end {
            let unit = Unit { group: self.group, trial: self.trial };
            self.group += 1;
            if self.group >= self.next.len() {
                (self.trial, self.group) = (self.trial + 1, 0);
            }
            if self.next.get(unit.group).is_some_and(|next| unit.trial >= *next) {
                return Some(unit);
            }
        }
        None
    }
}

/// Distributes units and holds back threads that are too far ahead of what has been written.
struct Queue<'a> {
    state: Mutex<QueueState<'a>>,
    moved: Condvar,
    stop: AtomicBool,
}

struct QueueState<'a> {
    units: std::iter::Enumerate<Units<'a>>,
    given: usize,
    written: usize,
}

impl<'a> Queue<'a> {
    fn new(units: Units<'a>) -> Self {
        let state = QueueState { units: units.enumerate(), given: 0, written: 0 };
        Queue { state: Mutex::new(state), moved: Condvar::new(), stop: AtomicBool::new(false) }
    }

    fn take(&self) -> Option<(usize, Unit)> {
        let mut state = self.state.lock().unwrap_or_else(PoisonError::into_inner);
        while state.given >= state.written + AHEAD && !self.stopped() {
            state = self.moved.wait(state).unwrap_or_else(PoisonError::into_inner);
        }
        state.given += 1;
        if self.stopped() { None } else { state.units.next() }
    }

    fn written(&self, done: usize) {
        self.state.lock().unwrap_or_else(PoisonError::into_inner).written = done;
        self.moved.notify_all();
    }

    fn stop(&self) {
        let _state = self.state.lock().unwrap_or_else(PoisonError::into_inner); // no thread is between its check and its wait
        self.stop.store(true, Ordering::Relaxed);
        self.moved.notify_all();
    }

    fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

type Handover = SyncSender<(usize, Result<Trial, Error>)>;

/// The work of one thread.
fn work(experiment: &Experiment, queue: &Queue, sender: &Handover) {
    let mut engines = Engines::default();
    while let Some((index, unit)) = queue.take() {
        let result = match caught(|| trial(experiment, unit, &mut engines, &|| queue.stopped())) {
            Err(bug) if bug.class() == ErrorClass::Internal => {
                engines = Engines::default();
                Ok(failed(experiment, unit, &bug.to_string()))
            }
            result => result,
        };
        if sender.send((index, result)).is_err() {
            return;
        }
    }
}

/// Engines compiled by this thread. Threads share none, so that they do not contend for an engine's hint.
#[derive(Default)]
struct Engines {
    fixed: BTreeMap<usize, Vec<Compiled>>,
    drawn: Option<(usize, usize, Scene, Vec<Compiled>)>,
}

/// A scene compiled for an engine and an interference rule.
struct Compiled {
    key: (Engine, Interference),
    compiled: Arc<CompiledScene>,
    /// Time to compile the scene, s.
    seconds: f64,
    /// The groups of trials that have recorded that time.
    recorded: Vec<usize>,
    /// For each time limit of a method, the answer of the decision within it, so that no row depends on other methods.
    answers: Vec<(Option<Duration>, Option<Answer>)>,
}

impl Compiled {
    /// Whether the scene has a path: `None` if the method does not ask, or if it is not known in time.
    fn decided(
        &mut self,
        scene: &Scene,
        route: &Route,
        options: &PlanOptions,
        watch: &Watch,
    ) -> Result<Option<&Answer>, Error> {
        let by_turning = !route.is_plain() && scene.turning().is_some();
        if !options.proof || by_turning {
            return Ok(None);
        }
        let at = match self.answers.iter().position(|(budget, _)| *budget == options.budget) {
            Some(at) => at,
            None => {
                let answer = decided_within(scene, route, self.compiled.level(), &watch.with_budget(options.budget))?;
                self.answers.push((options.budget, answer));
                self.answers.len() - 1
            }
        };
        Ok(self.answers[at].1.as_ref())
    }
}

fn drawn(
    experiment: &Experiment,
    number: usize,
    random: &RandomScenes,
    trial: usize,
    watch: &Watch,
) -> Result<Scene, Error> {
    let seed = derived_seed(experiment.seed, &["scene", &experiment.scenarios[number].name], trial);
    random.draw_within(seed, watch).map_err(|e| e.under(&format!("scenarios[{number}]")))
}

/// The scene in which every method plans in a trial of the scenario with this number.
///
/// # Errors
/// A scenario for which no free scene is found; the errors of the watch.
pub fn trial_scene(experiment: &Experiment, number: usize, trial: usize, watch: &Watch) -> Result<Scene, Error> {
    let scenario = &experiment.scenarios[number];
    scenario
        .random
        .as_ref()
        .map_or_else(|| Ok(scenario.scene.clone()), |random| drawn(experiment, number, random, trial, watch))
}

/// Whether a scene has a path without turning. With via points or several goals, the answer that there is none if a leg on the way to each
/// goal has none. `None` if start, a via point or a goal is invalid or turned, or if time runs out.
pub(super) fn decided_within(
    scene: &Scene,
    route: &Route,
    engine: &dyn Checker,
    watch: &Watch,
) -> Result<Option<Answer>, Error> {
    let blocked = |answer: &Option<Answer>| matches!(answer, Some(Answer::NoPath(_)));
    let mut answer = None;
    for stops in route.stops(&Query::of(scene))? {
        let valid = |stop: &Pose| scene.has_orientation(&stop.orientation) && engine.state_valid(&stop.position);
        if !stops.iter().all(valid) {
            return Ok(None);
        }
        answer = None;
        for ends in stops.windows(2) {
            answer = in_time(decide(engine, [&ends[0].position, &ends[1].position], PROOF_EFFORT, watch))?;
            if blocked(&answer) {
                break;
            }
        }
        if !blocked(&answer) {
            break;
        }
    }
    Ok(answer)
}

/// The input of the trials of a method.
struct Prepared<'a> {
    scene: &'a Scene,
    compiled: Arc<CompiledScene>,
    /// Time to compile the scene for the engine, s, if the method has not recorded it yet.
    compile_seconds: Option<f64>,
    /// Whether there is a path, if that was decided.
    answer: Option<&'a Answer>,
}

impl Engines {
    /// The scene of a trial, compiled and decided.
    fn of<'a>(
        &'a mut self,
        experiment: &'a Experiment,
        Unit { group, trial, .. }: Unit,
        watch: &Watch,
    ) -> Result<Prepared<'a>, Error> {
        let (number, scenario, Method { options, .. }) = parts(experiment, group);
        let (scene, known) = match &scenario.random {
            None => (&scenario.scene, self.fixed.entry(number).or_default()),
            Some(random) => {
                if !matches!(&self.drawn, Some((n, t, ..)) if (*n, *t) == (number, trial)) {
                    let scene = drawn(experiment, number, random, trial, watch)?;
                    self.drawn = Some((number, trial, scene, Vec::new()));
                }
                let (.., scene, known) = self.drawn.as_mut().expect("just drawn");
                (&*scene, known)
            }
        };
        let wanted = (options.engine, options.interference);
        let at = match known.iter().position(|compiled| compiled.key == wanted) {
            Some(at) => at,
            None => {
                let began = Instant::now();
                let compiled = Arc::new(CompiledScene::new(scene, wanted.0, wanted.1, watch)?);
                let seconds = began.elapsed().as_secs_f64();
                known.push(Compiled { key: wanted, compiled, seconds, recorded: Vec::new(), answers: Vec::new() });
                known.len() - 1
            }
        };
        let Compiled { compiled, seconds, recorded, .. } = &mut known[at];
        let compile_seconds = (!recorded.contains(&group)).then_some(*seconds);
        recorded.extend(compile_seconds.map(|_| group));
        let compiled = compiled.clone();
        let answer = known[at].decided(scene, &scenario.route, options, watch)?;
        Ok(Prepared { scene, compiled, compile_seconds, answer })
    }
}

pub(super) fn parts(experiment: &Experiment, group: usize) -> (usize, &Scenario, &Method) {
    let (scenario, method) = (group / experiment.methods.len(), group % experiment.methods.len());
    (scenario, &experiment.scenarios[scenario], &experiment.methods[method])
}

fn trial(experiment: &Experiment, unit: Unit, engines: &mut Engines, interrupted: &Interrupt) -> Result<Trial, Error> {
    let (_, scenario, method) = parts(experiment, unit.group);
    let prepared = engines.of(experiment, unit, &Watch::on(interrupted))?;
    let seed = trial_seed(experiment, unit.group, unit.trial);
    match results(scenario, method, seed, &prepared, interrupted) {
        Ok(results) => {
            let row = |((name, _), found): (&(String, _), _)| Row {
                compile_seconds: prepared.compile_seconds,
                ..row(&scenario.name, name, unit.trial, seed, found)
            };
            let mut rows: Vec<Row> = method.variants.iter().zip(&results).map(row).collect();
            if experiment.layout.history {
                rows[0].history = results[0].history.clone();
            }
            Ok(Trial { group: unit.group, rows, failure: None })
        }
        Err(error) if error.class() == ErrorClass::Interrupted => Err(error),
        Err(error) => Ok(failed(experiment, unit, &error.to_string())),
    }
}

/// The results of a trial, one for each variant.
fn results(
    scenario: &Scenario,
    Method { options, variants, .. }: &Method,
    seed: u64,
    Prepared { scene, compiled, answer, .. }: &Prepared,
    interrupted: &Interrupt,
) -> Result<Vec<PlanResult>, Error> {
    // A trial measures its planner: only scenes without a path are decided for it.
    let proof = matches!(answer, Some(Answer::NoPath(_)));
    if proof && !scenario.route.is_plain() {
        return Ok(vec![PlanResult { status: Status::NoPath, ..PlanResult::out_of_time() }]);
    }
    let options = PlanOptions { seed, proof, ..options.clone() };
    let answer = answer.filter(|_| scenario.route.is_plain());
    let query = Query { answer, ..Query::of(scene).by(compiled) };
    let whole = scenario.plans_whole_paths();
    let post = if whole { options.post } else { Some(Post::None) };
    let raw = search_route(query, &scenario.route, &PlanOptions { post, ..options }, &|| interrupted())?.result;
    if interrupted() {
        return Err(Error::interrupted()); // a search that was cut short is no trial
    }
    if whole {
        return Ok(vec![raw]); // it has no variants
    }
    variants.iter().map(|(_, how)| post_process(compiled, &raw, how, &Watch::on(interrupted))).collect()
}

/// The seed of a trial of a method in a scenario.
pub fn trial_seed(experiment: &Experiment, group: usize, trial: usize) -> u64 {
    let (_, scenario, method) = parts(experiment, group);
    derived_seed(experiment.seed, &["trial", &scenario.name, &method.name], trial)
}

pub(super) fn row(scenario: &str, method: &str, trial: usize, seed: u64, found: &PlanResult) -> Row {
    let solved = found.status == Status::Solved;
    let result = TrialRow {
        scenario: scenario.to_string(),
        method: method.to_string(),
        trial,
        seed,
        status: TrialStatus::Ended(found.status),
        raw_cost: solved.then_some(found.raw_cost),
        cost: solved.then_some(found.cost),
        raw_waypoints: solved.then_some(found.raw_path.len()),
        waypoints: solved.then_some(found.path.len()),
        nodes: solved.then_some(found.stats.nodes),
        motion_checks: solved.then_some(found.stats.motion_checks),
    };
    Row {
        result,
        planning_seconds: Some(found.stats.planning_seconds),
        post_seconds: solved.then_some(found.stats.post_seconds),
        history: Vec::new(),
        compile_seconds: None,
    }
}

/// The rows of a trial in which the program failed.
fn failed(experiment: &Experiment, unit: Unit, problem: &str) -> Trial {
    let (_, scenario, method) = parts(experiment, unit.group);
    let seed = trial_seed(experiment, unit.group, unit.trial);
    let failed = |(name, _): &(String, _)| {
        let nothing = row(&scenario.name, name, unit.trial, seed, &PlanResult::out_of_time());
        let result = TrialRow { status: TrialStatus::Failed, ..nothing.result };
        Row { result, planning_seconds: None, ..nothing }
    };
    let failure = format!("{}, {}, trial {} (seed {seed}): {problem}", scenario.name, method.name, unit.trial);
    Trial { group: unit.group, rows: method.variants.iter().map(failed).collect(), failure: Some(failure) }
}
