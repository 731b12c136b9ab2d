//! Every row of the table of bad input in `docs/formats.md`.

use crate::harness::{Folder, Run};

/// The error about a file of that name and content.
#[track_caller]
fn error(name: &str, content: impl AsRef<[u8]>) -> String {
    let folder = Folder::with(name, content);
    let error = folder.run(&format!("reconstruct {name}")).error();
    error.strip_prefix("error: ").unwrap().to_owned()
}

#[test]
fn nothing_at_all() {
    for name in ["p.csv", "p.xy"] {
        assert_eq!(error(name, ""), format!("{name}: there are no points"));
        assert_eq!(
            error(name, "# nothing\n"),
            format!("{name}: there are no points")
        );
    }
    assert_eq!(error("p.csv", "x,y\n"), "p.csv: there are no points");
}

#[test]
fn lines_that_are_no_points() {
    assert_eq!(
        error("p.csv", "x,y\n1,2\n3\n"),
        "p.csv, line 3: a point is x and y, but here is only `3`"
    );
    assert_eq!(
        error("p.xy", "1 2\n3\n"),
        "p.xy, line 2: a point is x and y, but here is only `3`"
    );
    assert_eq!(
        error("p.xy", "1 2\n3 4 5\n"),
        "p.xy, line 2, column 5: a point is x and y, but `5` follows"
    );
    assert_eq!(
        error("p.csv", "x,y\n1,2\n3,4,5\n"),
        "p.csv, line 3: the line has 3 columns, the first has 2"
    );
    assert_eq!(
        error("p.csv", "1,2,3\n"),
        "p.csv, line 1: 3 columns without names: head those of the coordinates x and y"
    );
    assert_eq!(
        error("p.csv", "lon,lat\n1,2\n"),
        "p.csv, line 1: no column is named x: there are `lon`, `lat`"
    );
    assert_eq!(
        error("p.csv", "x,y,X\n1,2,3\n"),
        "p.csv, line 1: two columns are named x"
    );
}

#[test]
fn text_where_a_number_should_be() {
    assert_eq!(
        error("p.csv", "name,x,y\na,1,2\nb,3,four\n"),
        "p.csv, line 3, field 3: `four` is not a number"
    );
    assert_eq!(
        error("p.xy", "1 2\n\n  3   four\n"),
        "p.xy, line 3, column 7: `four` is not a number"
    );
    assert_eq!(
        error("p.xy", "1 2\n3 4\0\n"),
        "p.xy, line 2, column 3: `4\\0` is not a number"
    );
    assert_eq!(
        error("p.csv", "1,2\n3,\0\n"),
        "p.csv, line 2, field 2: `\\0` is not a number"
    );
}

#[test]
fn numbers_that_are_no_coordinates() {
    for bad in ["NaN", "inf", "-inf", "1e400"] {
        assert_eq!(
            error("p.csv", format!("x,y\n1,{bad}\n")),
            format!("p.csv, line 2, field 2: `{bad}` is not a finite number")
        );
        assert_eq!(
            error("p.xy", format!("{bad} 1\n")),
            format!("p.xy, line 1, column 1: `{bad}` is not a finite number")
        );
    }
    for bad in ["1e300", "1e-300"] {
        let found = error("p.xy", format!("1 {bad}\n"));
        let says = format!("p.xy, line 1, column 3: `{bad}` is out of range: scale the points");
        assert!(found.starts_with(&says), "{found}");
    }
}

#[test]
fn text_of_other_systems_is_read() {
    for content in ["\u{feff}x,y\r\n1,2\r\n3,4\r\n", "\u{feff}1,2\n3,4"] {
        let folder = Folder::with("p.csv", content);
        let found = folder.run("reconstruct p.csv -q").fine();
        assert!(found.ends_with("0,1,2\n0,open,,1,3,4\n"), "{found}");
    }
    Folder::with("p.xy", "\u{feff}1 2\r\n3\t4\r\n")
        .run("reconstruct p.xy")
        .fine();
    assert_eq!(
        error("p.csv", b"\xff\xfe1\0,\x002\0"),
        "p.csv: the text is UTF-16: save it as UTF-8"
    );
}

#[test]
fn no_file() {
    let folder = Folder::new();
    assert_eq!(
        folder.run("reconstruct gone.csv").error(),
        "error: gone.csv: No such file or directory (os error 2)"
    );
    assert_eq!(
        folder.run("reconstruct .").error(),
        "error: .: Is a directory (os error 21)"
    );
    assert_eq!(
        folder.run("reconstruct -").error(),
        "error: stdin: there are no points"
    );
}

#[cfg(unix)]
#[test]
fn stdin_closed() {
    use std::process::Command;
    let program = env!("CARGO_BIN_EXE_curvecrust");
    let line = format!("exec '{program}' reconstruct - <&-");
    let run: Run = Command::new("sh")
        .args(["-c", &line])
        .output()
        .unwrap()
        .into();
    assert_eq!(run.error(), "error: stdin: there are no points");
}
