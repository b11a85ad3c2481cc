//! Caches that are as they should be, and caches that are not.

use super::*;
use std::fs;
use std::time::{Duration, SystemTime};
use stickler_mdtest::assert_fits;
use tempfile::TempDir;

fn cache(folder: &TempDir) -> Cache {
    Cache::open(folder.path(), "ironplc", "0123")
}

fn file(folder: &TempDir) -> PathBuf {
    folder.path().join("ironplc-0123.cache")
}

/// Returns the note of a cache that has one and no more.
fn only_note(cache: &Cache) -> String {
    let notes = cache.notes();
    assert_eq!(notes.len(), 1, "{notes:?}");
    notes.concat()
}

fn recalled(cache: &Cache, questions: &[&str]) -> Vec<Option<String>> {
    let answer = |question: &&str| cache.get(question).map(str::to_owned);
    questions.iter().map(answer).collect()
}

#[test]
fn what_is_kept_is_recalled_by_the_next_run_and_by_nobody_else() {
    let folder = TempDir::new().unwrap();
    let first = cache(&folder);
    first.put("one", "1");
    assert_eq!(first.get("one"), None, "it is this run's own");
    first.put("two", "2");
    assert!(first.notes().is_empty());
    let second = cache(&folder);
    assert_eq!(
        recalled(&second, &["one", "two", "three"]),
        [Some("1".to_owned()), Some("2".to_owned()), None]
    );
    assert!(second.notes().is_empty());
    assert_eq!(Cache::open(folder.path(), "ironplc", "4567").get("one"), None);
    assert_eq!(Cache::open(folder.path(), "matiec", "0123").get("one"), None);
}

#[test]
fn two_runs_at_once_keep_what_both_found() {
    let folder = TempDir::new().unwrap();
    let runs = [cache(&folder), cache(&folder)];
    std::thread::scope(|scope| {
        for (number, run) in runs.iter().enumerate() {
            scope.spawn(move || {
                for question in 0..500 {
                    run.put(&format!("{number}-{question}"), &"x".repeat(question));
                }
            });
        }
    });
    let after = cache(&folder);
    assert_eq!(after.answers.len(), 1000);
    assert!(after.notes().is_empty());
}

#[test]
fn what_is_torn_or_broken_is_said_once_and_the_rest_is_used() {
    let folder = TempDir::new().unwrap();
    let first = cache(&folder);
    for question in ["one", "two", "three"] {
        first.put(question, "answer");
    }
    let whole = fs::read_to_string(file(&folder)).unwrap();
    let broken = whole.replace("two", "tow");
    fs::write(file(&folder), &broken[..broken.len() - 4]).unwrap();
    let second = cache(&folder);
    assert_eq!(
        recalled(&second, &["one", "two", "tow", "three"]),
        [Some("answer".to_owned()), None, None, None]
    );
    assert_fits(
        &only_note(&second),
        "…2 lines are broken; what they kept is asked again",
    );
    second.put("four", "answer");
    let third = cache(&folder);
    assert_eq!(third.notes(), [""; 0], "it was mended");
    assert_eq!(third.answers.len(), 2);
}

#[test]
fn a_file_of_another_kind_or_version_is_said_and_begins_anew() {
    let folder = TempDir::new().unwrap();
    let line = file::written("one", "1");
    for foreign in [
        String::new(),
        "nonsense".to_owned(),
        format!("stickler-cache 2 0123\n{line}"),
        format!("stickler-cache 1 4567\n{line}"),
        format!("\u{0}{line}"),
    ] {
        fs::write(file(&folder), &foreign).unwrap();
        let first = cache(&folder);
        assert_eq!(first.get("one"), None);
        assert_fits(&only_note(&first), "…is no cache of this version…");
        first.put("two", "2");
        let second = cache(&folder);
        assert_eq!(recalled(&second, &["one", "two"]), [None, Some("2".to_owned())]);
        assert!(second.notes().is_empty());
    }
}

#[test]
fn a_folder_that_cannot_be_made_is_said_once_and_nothing_is_kept() {
    let folder = TempDir::new().unwrap();
    let in_the_way = folder.path().join("file");
    fs::write(&in_the_way, "").unwrap();
    let cache = Cache::open(&in_the_way, "ironplc", "0123");
    cache.put("one", "1");
    assert_fits(&only_note(&cache), "…keeps no results…");
    assert!(cache.notes().is_empty());
}

/// Everywhere but there a disk would have to be filled.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_said_once_and_nothing_more_is_kept() {
    let folder = TempDir::new().unwrap();
    let cache = cache(&folder);
    cache.lock().file = Some(fs::OpenOptions::new().append(true).open("/dev/full").unwrap());
    cache.put("one", "1");
    cache.put("two", "2");
    let full = "…cannot be written, and keeps no more results: No space left…";
    assert_fits(&only_note(&cache), full);
}

#[test]
fn a_file_that_has_grown_too_large_keeps_its_newer_half() {
    let folder = TempDir::new().unwrap();
    let first = cache(&folder);
    for question in ["one", "two", "three", "four"] {
        first.put(question, "answer");
    }
    let size = fs::metadata(file(&folder)).unwrap().len();
    let largest = usize::try_from(size).unwrap() - 1;
    let mut notes = Vec::new();
    drop(file::open(&file(&folder), "0123", largest, &mut notes));
    assert!(notes.is_empty());
    let answer = || Some("answer".to_owned());
    assert_eq!(
        recalled(&cache(&folder), &["one", "two", "three", "four"]),
        [None, None, answer(), answer()]
    );
    assert!(fs::metadata(file(&folder)).unwrap().len() < size);
}

#[test]
fn the_files_that_were_not_used_for_longest_are_removed() {
    let folder = TempDir::new().unwrap();
    for age in 0..12_u64 {
        let name = format!("{age:04}");
        drop(Cache::open(folder.path(), "ironplc", &name));
        let file = fs::File::options()
            .append(true)
            .open(folder.path().join(format!("ironplc-{name}.cache")))
            .unwrap();
        let day = Duration::from_secs(24 * 60 * 60);
        file.set_modified(SystemTime::now() - day * u32::try_from(age + 1).unwrap())
            .unwrap();
    }
    fs::write(folder.path().join("another.txt"), "").unwrap();
    drop(cache(&folder));
    let mut names: Vec<String> = fs::read_dir(folder.path())
        .unwrap()
        .map(|file| file.unwrap().file_name().into_string().unwrap())
        .collect();
    names.sort();
    let numbers = ["0000", "0001", "0002", "0003", "0004", "0005", "0006", "0123"];
    let mut expected = vec!["another.txt".to_owned()];
    expected.extend(numbers.map(|number| format!("ironplc-{number}.cache")));
    assert_eq!(names, expected);
}
