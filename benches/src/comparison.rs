//! Medians of interleaved runs, and the table made of them.

use std::fmt::Write;
use std::time::Instant;

use serde::Serialize;

/// A task to time.
pub struct Task<'a> {
    /// What it does.
    pub name: String,
    /// Does it; what it returns must not be optimised away, and is not timed being dropped.
    run: Box<dyn FnMut() -> f64 + 'a>,
}

impl<'a> Task<'a> {
    /// A task, timed from start to end; its result is dropped after.
    pub fn new<R>(name: impl Into<String>, mut run: impl FnMut() -> R + 'a) -> Self {
        let timed = move || {
            let start = Instant::now();
            let result = run();
            let seconds = start.elapsed().as_secs_f64();
            std::hint::black_box(result);
            seconds
        };
        Self {
            name: name.into(),
            run: Box::new(timed),
        }
    }
}

/// The median times of tasks in seconds, each run once per round, in turn: what slows the machine
/// down for a while slows all of them.
#[must_use]
pub fn medians(mut tasks: Vec<Task<'_>>, rounds: usize) -> Vec<f64> {
    let mut times = vec![Vec::with_capacity(rounds); tasks.len()];
    for _ in 0..rounds.max(1) {
        for (task, times) in tasks.iter_mut().zip(&mut times) {
            times.push((task.run)());
        }
    }
    times.into_iter().map(median).collect()
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times.get(times.len() / 2).copied().unwrap_or(f64::NAN)
}

/// A figure beside its goal.
#[derive(Clone, Debug, Serialize)]
pub struct Row {
    /// What is measured, and on which input.
    pub what: String,
    /// What was measured, in words: times and what they are divided by.
    pub measured: String,
    /// The figure.
    pub figure: f64,
    /// Its bound.
    pub goal: Goal,
}

/// The bound of a figure.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Goal {
    /// It should be this at most.
    AtMost(f64),
    /// It should be this at least.
    AtLeast(f64),
    /// For information.
    None,
}

impl Row {
    /// Whether the goal is reached; true without one.
    #[must_use]
    pub fn is_reached(&self) -> bool {
        match self.goal {
            Goal::AtMost(bound) => self.figure <= bound,
            Goal::AtLeast(bound) => self.figure >= bound,
            Goal::None => true,
        }
    }
}

/// The rows as a Markdown table.
#[must_use]
pub fn markdown(rows: &[Row]) -> String {
    let mut table = String::from("| what | figure | goal | | measured |\n|---|---|---|---|---|\n");
    for row in rows {
        let (goal, mark) = match (row.goal, row.is_reached()) {
            (Goal::AtMost(bound), reached) => (format!("≤ {bound}"), reached),
            (Goal::AtLeast(bound), reached) => (format!("≥ {bound}"), reached),
            (Goal::None, _) => (String::new(), true),
        };
        let mark = if mark { "" } else { "missed" };
        let Row {
            what,
            measured,
            figure,
            ..
        } = row;
        // Writing to a string does not fail.
        let _ = writeln!(
            table,
            "| {what} | {figure:.2} | {goal} | {mark} | {measured} |"
        );
    }
    table
}

/// A time per element, in nanoseconds.
#[must_use]
pub fn per_element(seconds: f64, count: usize) -> String {
    format!("{:.1} ns", seconds * 1e9 / count as f64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_mark_what_is_missed() {
        let row = |goal| Row {
            what: "a against b".into(),
            measured: "3 s, 2 s".into(),
            figure: 1.5,
            goal,
        };
        let table = markdown(&[row(Goal::AtMost(1.6)), row(Goal::AtLeast(1.6))]);
        let lines: Vec<&str> = table.lines().collect();
        assert_eq!(lines[2], "| a against b | 1.50 | ≤ 1.6 |  | 3 s, 2 s |");
        assert_eq!(
            lines[3],
            "| a against b | 1.50 | ≥ 1.6 | missed | 3 s, 2 s |"
        );
    }

    #[test]
    fn medians_keep_the_order_of_tasks() {
        let tasks = vec![
            Task::new("long", || {
                std::thread::sleep(std::time::Duration::from_millis(3));
            }),
            Task::new("short", || ()),
        ];
        let times = medians(tasks, 3);
        assert!(times[0] > times[1]);
    }
}
