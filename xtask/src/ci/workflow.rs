//! The workflows of GitHub against the steps: what runs here runs there.

use super::step::Step;
use clap::ValueEnum;
use curvecrust_lab::root;
use std::fs;

/// The workflows, each with its name.
fn workflows() -> Vec<(String, String)> {
    let folder = fs::read_dir(root().join(".github/workflows")).unwrap();
    folder
        .map(|entry| {
            let path = entry.unwrap().path();
            let name = path.file_name().unwrap().to_string_lossy().into_owned();
            (name, fs::read_to_string(path).unwrap())
        })
        .collect()
}

fn checks() -> String {
    fs::read_to_string(root().join(".github/workflows/ci.yml")).unwrap()
}

/// The names of the jobs: keys that are indented by two spaces.
fn jobs(workflow: &str) -> Vec<&str> {
    let jobs = workflow.lines().skip_while(|line| *line != "jobs:");
    jobs.filter_map(|line| line.strip_prefix("  ")?.strip_suffix(':'))
        .filter(|name| !name.starts_with([' ', '#']))
        .collect()
}

#[test]
fn the_workflow_runs_every_step() {
    let workflow = checks();
    let run: Vec<&str> = workflow
        .lines()
        .filter_map(|line| line.split_once("run: cargo xtask ci "))
        .flat_map(|(_, arguments)| arguments.split(' '))
        .filter(|argument| *argument != "--no-skip")
        .collect();
    for step in Step::value_variants() {
        assert!(run.contains(&step.name().as_str()), "{}", step.name());
    }
    for name in run {
        assert!(Step::from_str(name, false).is_ok(), "{name} is no step");
    }
}

#[test]
fn the_closing_job_needs_all_others() {
    let workflow = checks();
    let jobs = jobs(&workflow);
    let (closing, others) = jobs.split_last().unwrap();
    assert_eq!(*closing, "all");
    assert!(others.len() > 3, "{others:?}");
    let (_, after) = workflow.split_once("\n  all:\n").unwrap();
    let needs = after
        .lines()
        .find_map(|line| line.strip_prefix("    needs: "));
    assert_eq!(needs, Some(format!("[{}]", others.join(", ")).as_str()));
}

#[test]
fn actions_are_pinned_by_hash_and_know_no_secret() {
    for (name, text) in workflows() {
        assert!(
            text.contains("\npermissions:\n  contents: read\n"),
            "{name}"
        );
        let mut checkouts = 0;
        for line in text.lines().filter(|line| line.contains("uses: ")) {
            let (_, action) = line.split_once('@').unwrap();
            let (hash, version) = action.split_once(" # v").unwrap();
            let is_hash = hash.len() == 40 && hash.chars().all(|c| c.is_ascii_hexdigit());
            assert!(is_hash && !version.is_empty(), "{name}: {line}");
            checkouts += usize::from(line.contains("actions/checkout@"));
        }
        let kept = text.matches("persist-credentials: false").count();
        assert_eq!(
            kept, checkouts,
            "{name}: a checkout leaves its token behind"
        );
    }
}
