//! Each of some items once.

/// Returns the items in their order without those that came before. For lists that are short, or whose items have neither order
/// nor hash.
#[must_use]
pub fn distinct<T: PartialEq>(items: impl IntoIterator<Item = T>) -> Vec<T> {
    let mut found = Vec::new();
    for item in items {
        if !found.contains(&item) {
            found.push(item);
        }
    }
    found
}
