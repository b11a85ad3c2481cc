//! Tests `stickler reduce` where a printed page is not enough: an engine with a wrong value, and Ctrl-C.

use crate::common::{STICKLER, interrupt, under_way};
use std::fs;
use std::process::{Command, Output, Stdio};
use std::time::Duration;

/// A program that divides, among other things.
const PROGRAM: &str = "PROGRAM main
VAR
    a : INT := 17;
    b : INT := 5;
    rest : INT;
    total : DINT;
    list : ARRAY[1..3] OF DINT := [7, 8, 9];
END_VAR
    FOR a := 1 TO 3 DO
        total := total + list[a];
    END_FOR;
    a := 17;
    IF total > 20 THEN
        rest := a MOD b;
    ELSE
        rest := 1;
    END_IF;
    list[2] := total * 2;
END_PROGRAM
";

fn reduce(folder: &std::path::Path, engine: &str) -> Command {
    fs::write(folder.join("start.st"), PROGRAM).expect("a file in a folder of its own");
    let mut command = Command::new(STICKLER);
    command
        .args(["reduce", "start.st", "--dialect", "matiec", "--engine", engine])
        .current_dir(folder)
        .env("NO_COLOR", "1")
        .stdin(Stdio::null());
    command
}

fn shown(output: &Output) -> String {
    let both = [output.stdout.as_slice(), output.stderr.as_slice()].concat();
    String::from_utf8_lossy(&both).into_owned()
}

#[test]
fn a_wrong_value_is_kept_and_all_else_goes() {
    let folder = tempfile::tempdir().expect("a folder");
    // The engine is the reference, with each MOD of a request replaced by a division.
    let script = format!(
        "while IFS= read -r line; do\n\
         while case $line in *' MOD '*) ;; *) false ;; esac; do line=\"${{line%% MOD *}} / ${{line#* MOD }}\"; done\n\
         printf '%s\\n' \"$line\"\ndone | '{STICKLER}' engine\n"
    );
    fs::write(folder.path().join("divides.sh"), script).expect("a file");
    let output = reduce(folder.path(), "cmd:sh divides.sh")
        .output()
        .expect("the command runs");
    let text = shown(&output);
    assert_eq!(output.status.code(), Some(0), "{text}");
    assert!(text.contains("MOD") && text.contains("value:INT on"), "{text}");
    assert!(text.lines().count() <= 8, "{text}");
}

#[test]
fn ctrl_c_ends_it_with_the_smallest_program_so_far() {
    let folder = tempfile::tempdir().expect("a folder");
    let script = r#"
count=0
while IFS= read -r line; do
    rest=${line#*\"id\":}
    case $line in
    *'"type":"hello"'*)
        echo '{"type":"hello","protocol":1,"name":"slow","version":"7","dialects":["matiec"],"abilities":["check"]}'
        continue
        ;;
    *'"type":"bye"'*) exit 0 ;;
    esac
    count=$((count + 1))
    if [ $count -gt 4 ]; then
        : >under-way
        sleep 0.3
    fi
    case $line in
    *MOD*) echo "{\"type\":\"rejected\",\"id\":${rest%%,*},\"diagnostics\":[{\"code\":\"C7\",\"message\":\"no\"}]}" ;;
    *) echo "{\"type\":\"accepted\",\"id\":${rest%%,*}}" ;;
    esac
done
"#;
    fs::write(folder.path().join("slow.sh"), script).expect("a file");
    let run = under_way(&mut reduce(folder.path(), "cmd:sh slow.sh"));
    while !folder.path().join("under-way").exists() {
        std::thread::sleep(Duration::from_millis(20));
    }
    interrupt(&run);
    let output = run.wait_with_output().expect("an end");
    let text = shown(&output);
    assert_eq!(output.status.code(), Some(130), "{text}");
    assert!(text.starts_with("PROGRAM main") && text.contains("MOD"), "{text}");
    assert!(text.contains("the smallest program so far"), "{text}");
}
