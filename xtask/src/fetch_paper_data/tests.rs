//! On a clone and a folder made up here; the network is not needed.

use super::*;
use std::process::Command;
use tempfile::TempDir;

const POINT_FILE: &str = "0 1\n\n2\n3.5 -4e2\n";

const DRAWING: &str =
    "<svg xmlns=\"http://www.w3.org/2000/svg\"><circle r=\"2\" id=\"round\"/></svg>";
/// An open curve, and a circle.
const ARC: &str = "m 1,2 c 0,1 1,2 3,4";
const CIRCLE: &str = "M0 0A1 1 0 0 1 2 0A1 1 0 0 1 0 0Z";

/// A source with the four curves in as many notations.
fn source() -> String {
    let (a, b) = (ARC, CIRCLE);
    format!(
        "// string cat = \"m 9,9 l 9,9\";\n\
         void test() {{\n\
         \tstring parallel = \"{a}\";\n\
         \tconst char *teaser = \"m 1,2 \"\n\t\t\"l 3,4 \"\n\t\t\"3,4\";\n\
         \tstring bunny(\"{b}\"), title = \"bunny\";\n\
         \tstatic const char cat[] = \"{b}\";\n\
         \tif (name == \"cat\") load(cat, 'c');\n\
         }}\n"
    )
}

fn put(folder: &Path, name: &str, text: &str) {
    let path = folder.join(name);
    fs::create_dir_all(path.parent().unwrap()).unwrap();
    fs::write(path, text).unwrap();
}

fn clone() -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    put(dir.path(), SOURCE, &source());
    put(dir.path(), "data/crocodile-conf.p2d", POINT_FILE);
    put(dir.path(), "data/deep/down/ventilator.p2d", POINT_FILE);
    put(dir.path(), "mushroom.p2d", POINT_FILE);
    dir
}

fn laid_out() -> TempDir {
    let dir = tempfile::tempdir().unwrap();
    for name in CURVES {
        put(dir.path(), &curve_file(name), DRAWING);
    }
    for name in POINTS {
        put(dir.path(), &points_file(name), POINT_FILE);
    }
    dir
}

fn failure<T>(result: anyhow::Result<T>) -> String {
    match result {
        Ok(_) => panic!("an error was expected"),
        Err(error) => format!("{error:#}"),
    }
}

#[test]
fn a_clone_is_laid_out() {
    let files = read(clone().path()).unwrap();
    let names: Vec<&str> = files.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(
        names,
        [
            "curves/parallel.svg",
            "curves/teaser.svg",
            "curves/bunny.svg",
            "curves/cat.svg",
            "points/crocodile-conf.p2d",
            "points/ventilator.p2d",
            "points/mushroom.p2d",
            "NOTE.md"
        ]
    );
    assert!(files[1].1.contains(" d=\"m 1,2 l 3,4 3,4\"/>"));
    assert!(files[3].1.contains(&format!(" d=\"{CIRCLE}\"/>")));
    assert!(files[3].1.contains("viewBox=\"-0.040 -1.040 2.080 2.080\""));
    assert_eq!(files[5].1, POINT_FILE);
}

#[test]
fn what_is_laid_out_can_be_laid_out_again() {
    let there = tempfile::tempdir().unwrap();
    let target = there.path().join("fixtures/paper");
    let files = read(clone().path()).unwrap();
    assert!(!install(&files, &target, false).unwrap());
    let again = read(&target).unwrap();
    assert_eq!(again, files);
    assert!(install(&again, &target, false).unwrap());
    assert_eq!(read(&target).unwrap(), files);
    // Nothing is left beside it.
    assert_eq!(fs::read_dir(target.parent().unwrap()).unwrap().count(), 1);
}

#[test]
fn a_folder_is_taken_as_it_is() {
    let files = read(laid_out().path()).unwrap();
    assert_eq!(files.len(), CURVES.len() + POINTS.len() + 1);
    assert_eq!(files[0].1, DRAWING);
}

#[test]
fn a_folder_that_lacks_files_names_them_all() {
    let dir = laid_out();
    fs::remove_file(dir.path().join("curves/cat.svg")).unwrap();
    fs::remove_file(dir.path().join("points/mushroom.p2d")).unwrap();
    let message = failure(read(dir.path()));
    assert!(
        message.ends_with("lacks curves/cat.svg, points/mushroom.p2d"),
        "{message}"
    );
}

#[test]
fn bad_files_of_a_folder_are_named() {
    let bad = [
        ("curves/cat.svg", "<html>Not found", "holds no curve"),
        (
            "curves/cat.svg",
            "<svg xmlns=\"http://www.w3.org/2000/svg\"/>",
            "holds no curve",
        ),
        ("points/mushroom.p2d", "\n1\nx y\n1 inf\n", "no point"),
    ];
    for (name, text, reason) in bad {
        let dir = laid_out();
        put(dir.path(), name, text);
        let message = failure(read(dir.path()));
        assert!(
            message.contains(name) && message.contains(reason),
            "{message}"
        );
    }
}

#[test]
fn bad_clones_say_what_is_missing() {
    let without = |from: &str, to: &str| {
        let dir = clone();
        put(dir.path(), SOURCE, &source().replace(from, to));
        failure(read(dir.path()))
    };
    let message = without("*teaser", "*teapot");
    assert!(
        message.contains(SOURCE) && message.contains("no string literal named teaser"),
        "{message}"
    );
    let message = without("cat[] = \"M0", "cat[] = \"Miaow");
    assert!(message.contains("the string cat is no curve"), "{message}");
    let message = without("title = \"bunny\"", "bunny = \"m 0,0 l 1,1\"");
    assert!(
        message.contains("several path strings named bunny"),
        "{message}"
    );

    let dir = clone();
    fs::remove_file(dir.path().join("data/deep/down/ventilator.p2d")).unwrap();
    let message = failure(read(dir.path()));
    assert!(message.contains("no ventilator.p2d anywhere"), "{message}");
}

#[test]
fn a_folder_that_is_none_or_something_else() {
    let dir = tempfile::tempdir().unwrap();
    let message = failure(read(&dir.path().join("nowhere")));
    assert!(
        message.contains("cannot read the folder") && message.contains("nowhere"),
        "{message}"
    );
    put(dir.path(), "file", "");
    let message = failure(read(&dir.path().join("file")));
    assert!(message.contains("cannot read the folder"), "{message}");
    let message = failure(read(dir.path()));
    assert!(
        message.contains("neither a clone") && message.contains(SOURCE),
        "{message}"
    );
}

#[test]
fn files_of_another_origin_are_kept() {
    let there = tempfile::tempdir().unwrap();
    let target = there.path().join("paper");
    let files = read(clone().path()).unwrap();
    install(&files, &target, false).unwrap();
    put(&target, "curves/mine.svg", "mine");
    let message = failure(install(&files, &target, false));
    assert!(
        message.contains("mine.svg") && message.contains("--force"),
        "{message}"
    );
    assert!(target.join("curves/mine.svg").is_file());
    assert!(install(&files, &target, true).unwrap());
    assert!(!target.join("curves/mine.svg").exists());
}

#[test]
fn a_failed_write_leaves_the_old_folder_and_nothing_else() {
    let there = tempfile::tempdir().unwrap();
    let target = there.path().join("paper");
    let files = read(clone().path()).unwrap();
    install(&files, &target, false).unwrap();
    // A file cannot be a folder as well.
    let impossible = [
        (String::from("NOTE.md"), String::new()),
        (String::from("NOTE.md/x"), String::new()),
    ];
    let message = failure(install(&impossible, &target, true));
    assert!(message.contains("cannot write"), "{message}");
    assert_eq!(read(&target).unwrap(), files);
    assert_eq!(fs::read_dir(there.path()).unwrap().count(), 1);
}

/// Runs git in a folder; `None` if there is no git.
fn git(folder: &Path, arguments: &[&str]) -> Option<String> {
    let output = Command::new("git")
        .current_dir(folder)
        .args(["-c", "user.name=A", "-c", "user.email=a@example.org"])
        .args(["-c", "commit.gpgsign=false"])
        .args(arguments)
        .env_remove("GIT_DIR")
        .env_remove("GIT_WORK_TREE")
        .env_remove("GIT_INDEX_FILE")
        .output()
        .ok()?;
    assert!(output.status.success(), "{output:?}");
    Some(String::from_utf8(output.stdout).unwrap().trim().to_owned())
}

#[test]
fn the_commit_is_fetched_not_the_newest_state() {
    let dir = clone();
    let commits = || {
        git(dir.path(), &["init", "--quiet"])?;
        git(dir.path(), &["add", "."])?;
        git(dir.path(), &["commit", "--quiet", "-m", "first"])?;
        let first = git(dir.path(), &["rev-parse", "--short", "HEAD"])?;
        git(dir.path(), &["rm", "--quiet", "-r", "data"])?;
        git(dir.path(), &["commit", "--quiet", "-m", "second"])?;
        Some(first)
    };
    let Some(first) = commits() else {
        println!("skipped: no git");
        return;
    };
    let url = dir.path().to_str().unwrap();
    let repository = |commit| Repository {
        git: "git",
        url,
        commit,
    };
    assert_eq!(fetch(&repository(&first)).unwrap().len(), 8);
    let message = failure(fetch(&repository("0000000")));
    assert!(message.contains("checking out 0000000"), "{message}");
    assert!(failure(fetch(&repository("HEAD"))).contains("no crocodile-conf.p2d"));
}

#[test]
fn without_git_or_network_it_says_what_to_do_by_hand() {
    let dir = tempfile::tempdir().unwrap();
    let nowhere = dir.path().join("nowhere");
    for (git, reason) in [("git-that-is-not-there", "no git"), ("git", "cloning")] {
        let message = failure(fetch(&Repository {
            git,
            url: nowhere.to_str().unwrap(),
            commit: "ef67f83",
        }));
        assert!(message.contains(reason), "{message}");
        assert!(
            message.contains("\n  git clone") && message.contains("--from DIR"),
            "{message}"
        );
    }
}
