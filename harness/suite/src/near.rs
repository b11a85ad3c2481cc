//! Suggestions for names that nobody knows.

/// The number of names up to which all of them are told.
const FEW: usize = 12;

/// Returns what a message about an unknown name ends with: the nearest of the `known` names, or all of them where none is near
/// and they are few.
pub(crate) fn suggestion<'n>(name: &str, known: impl Iterator<Item = &'n str>) -> String {
    let known: Vec<&str> = known.collect();
    let distance = |other: &str| strsim::damerau_levenshtein(&name.to_lowercase(), &other.to_lowercase());
    let nearest = known.iter().map(|other| (distance(other), *other)).min();
    match nearest {
        Some((distance, other)) if distance <= (other.chars().count() / 3).max(1) => {
            format!("did you mean `{other}`?")
        }
        None => "there is none".to_owned(),
        Some(_) if known.len() <= FEW => format!("there are {}", known.join(" · ")),
        Some((_, other)) => format!("there are {}, the nearest is `{other}`", known.len()),
    }
}
