//! Runs many executions, each identified by its number, in threads as small as the compiler's own,
//! under a watchdog.

use std::fmt;
use std::io::Write;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::thread;
use std::time::Duration;

use fastrand::Rng;

use crate::corpus::{descriptions, is_system};
use crate::flat::{Token, unflatten};
use crate::generate::stream;
use crate::mutate::mutant;
use crate::times::Times;
use crate::verdict::{Answer, Failure, ask, keep_panics, minimized};
use crate::words::Words;

/// Executions of one thread, whose name says which: a stack that overflows prints it.
const BATCH: u64 = 100_000;
/// What is longer is a hang.
const HANG: Duration = Duration::from_secs(60);
/// How long an expansion may take, in an optimized build.
pub const BOUND: Duration = Duration::from_millis(2);
/// What stands for the number of an execution when all are done.
const ENDED: u64 = u64::MAX;
/// So many of the slowest are kept.
const SLOWEST: usize = 12;

/// What to run.
#[derive(Clone, Copy)]
pub struct Plan {
    pub first: u64,
    pub executions: u64,
    pub seed: u64,
    /// One of so many is a mutated description, the others are arbitrary streams.
    pub mutants: u64,
    /// Only descriptions of systems are mutated.
    pub of_systems: bool,
    /// Of each thread \[bytes\].
    pub stack: usize,
    /// Print the number of each execution before it.
    pub is_traced: bool,
    /// Print how far it is.
    pub is_shown: bool,
}

/// What the streams are made from.
struct Material {
    words: Words,
    corpus: Vec<Vec<Token>>,
}

impl Material {
    fn of(plan: &Plan) -> Self {
        let mut corpus = descriptions();
        if plan.of_systems {
            corpus.retain(|description| is_system(description));
        }
        Self {
            words: Words::default(),
            corpus,
        }
    }
}

/// Where a stream came from.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
enum Origin {
    Arbitrary,
    Mutated,
}

/// What came out.
#[derive(Default)]
pub struct Report {
    pub arbitrary_rejected: Times,
    pub arbitrary_accepted: Times,
    pub mutants_rejected: Times,
    pub mutants_accepted: Times,
    /// Executions beyond [`BOUND`], measured again and the best of three.
    pub slow: u64,
    pub slowest: Vec<(Duration, u64, usize, Answer)>,
    pub failures: Vec<(u64, Failure, String)>,
}

fn input(plan: &Plan, material: &Material, number: u64) -> (Origin, Vec<Token>) {
    let mut rng = Rng::with_seed(plan.seed.rotate_left(32) ^ number);
    // neighboring seeds begin alike
    for _ in 0..4 {
        rng.u64(..);
    }
    if number.is_multiple_of(plan.mutants) {
        (
            Origin::Mutated,
            mutant(&material.corpus, &material.words, &mut rng),
        )
    } else {
        (Origin::Arbitrary, stream(&material.words, &mut rng))
    }
}

/// The text of one execution.
#[must_use]
pub fn shown(plan: &Plan) -> String {
    let material = Material::of(plan);
    unflatten(&input(plan, &material, plan.first).1).to_string()
}

/// Runs the plan.
///
/// # Panics
///
/// Where no thread can be started.
#[must_use]
pub fn run(plan: Plan) -> Report {
    keep_panics();
    let current = Arc::new(AtomicU64::new(plan.first));
    watch(Arc::clone(&current), plan);
    let mut report = Report::default();
    let end = plan.first + plan.executions;
    let mut first = plan.first;
    while first < end {
        // tokens stay in their thread, and so does what they are made from
        let until = (first + BATCH).min(end);
        report = batches(plan, first..until, report, &current);
        if plan.is_shown {
            println!(
                "{until} executions, {} beyond {BOUND:?}, {} failures",
                report.slow,
                report.failures.len()
            );
        }
        first = until;
    }
    current.store(ENDED, Ordering::Relaxed);
    report
}

fn batches(
    plan: Plan,
    numbers: core::ops::Range<u64>,
    mut report: Report,
    current: &Arc<AtomicU64>,
) -> Report {
    let current = Arc::clone(current);
    let name = format!("executions {numbers:?} of seed {}", plan.seed);
    let thread = thread::Builder::new().name(name).stack_size(plan.stack);
    let run = move || {
        let material = Material::of(&plan);
        for number in numbers {
            current.store(number, Ordering::Relaxed);
            if plan.is_traced {
                println!("{number}");
                let _ = std::io::stdout().flush();
            }
            execute(&plan, &material, number, &mut report);
        }
        report
    };
    let thread = thread.spawn(run).expect("a thread");
    thread.join().expect("panics are caught")
}

fn execute(plan: &Plan, material: &Material, number: u64, report: &mut Report) {
    let (origin, tokens) = input(plan, material, number);
    match ask(&tokens) {
        Ok((answer, mut time)) => {
            if time > BOUND && !cfg!(debug_assertions) {
                let again = (0..2)
                    .filter_map(|_| ask(&tokens).ok())
                    .map(|(_, time)| time);
                time = again.fold(time, Duration::min);
                report.keep_slow(time, number, tokens.len(), answer);
            }
            report.times(origin, answer).add(time);
        }
        Err(failure) => {
            let alike =
                |shorter: &[Token]| ask(shorter).is_err_and(|other| other.is_like(&failure));
            let least = minimized(&tokens, alike);
            let failure = ask(&least).err().unwrap_or(failure);
            let text = unflatten(&least).to_string();
            println!("execution {number}: {failure:?}\n{text}\n");
            report.failures.push((number, failure, text));
        }
    }
}

/// Ends the process, with the input, if an execution does not end.
fn watch(current: Arc<AtomicU64>, plan: Plan) {
    thread::spawn(move || {
        let mut before = ENDED;
        loop {
            let first = current.load(Ordering::Relaxed);
            if first == ENDED {
                return;
            }
            if first == before {
                let text = shown(&Plan { first, ..plan });
                println!("execution {first} did not end within {HANG:?}:\n{text}");
                std::process::exit(1);
            }
            before = first;
            thread::sleep(HANG);
        }
    });
}

impl Report {
    fn times(&mut self, origin: Origin, answer: Answer) -> &mut Times {
        match (origin, answer) {
            (Origin::Arbitrary, Answer::Rejected) => &mut self.arbitrary_rejected,
            (Origin::Arbitrary, Answer::Accepted) => &mut self.arbitrary_accepted,
            (Origin::Mutated, Answer::Rejected) => &mut self.mutants_rejected,
            (Origin::Mutated, Answer::Accepted) => &mut self.mutants_accepted,
        }
    }

    fn keep_slow(&mut self, time: Duration, number: u64, tokens: usize, answer: Answer) {
        self.slow += u64::from(time > BOUND);
        self.slowest.push((time, number, tokens, answer));
        self.slowest.sort_by_key(|slow| core::cmp::Reverse(slow.0));
        self.slowest.truncate(SLOWEST);
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let rows = [
            ("arbitrary, rejected", &self.arbitrary_rejected),
            ("arbitrary, accepted", &self.arbitrary_accepted),
            ("mutated, rejected", &self.mutants_rejected),
            ("mutated, accepted", &self.mutants_accepted),
        ];
        writeln!(
            f,
            "{:<20} {:>10} {:>11} {:>11} {:>11} {:>11}",
            "", "executions", "median", "99 %", "99.9 %", "longest"
        )?;
        for (name, times) in rows {
            let [median, most, nearly_all] = [0.5, 0.99, 0.999].map(|part| times.quantile(part));
            let (count, longest) = (times.count(), times.longest());
            writeln!(
                f,
                "{name:<20} {count:>10} {median:>11.1?} {most:>11.1?} {nearly_all:>11.1?} {longest:>11.1?}"
            )?;
        }
        writeln!(
            f,
            "{} beyond {BOUND:?}; {} failures; the slowest:",
            self.slow,
            self.failures.len()
        )?;
        for (time, number, tokens, answer) in &self.slowest {
            writeln!(
                f,
                "  {time:>9.1?}  execution {number}, {tokens} tokens, {answer:?}"
            )?;
        }
        Ok(())
    }
}
