//! Tests that the conversation in this crate's README is one that the reference would have.

use serde_json::Value as Json;
use stickler_engines::Reference;
use stickler_engines::protocol::serve;

#[test]
fn the_conversation_in_the_readme_is_what_the_reference_says() {
    let readme = include_str!("../../README.md");
    let said = |mark: &str| {
        readme
            .lines()
            .filter_map(|line| line.strip_prefix(mark))
            .collect::<Vec<_>>()
    };
    let (requests, replies) = (said("→ "), said("← "));
    assert_eq!((requests.len(), replies.len()), (7, 6));
    let mut output = Vec::new();
    serve(&Reference::new(), requests.join("\n").as_bytes(), &mut output).unwrap();
    let output = String::from_utf8(output).unwrap();
    let json = |line: &str| serde_json::from_str::<Json>(line).unwrap();
    let answered: Vec<Json> = output.lines().map(json).collect();
    let expected: Vec<Json> = replies.into_iter().map(json).collect();
    assert_eq!(answered, expected);
}
