//! Guesses which known word was meant, and lists known words.

/// Letters of the longest word that is compared with the known ones.
const LONGEST: usize = 64;

/// The known word that was probably meant: the nearest one, if at most a third of the letters
/// differ; else one that has `word` as a part, as `max_depth` has `depth`.
///
/// Words of more than [`LONGEST`] letters get no answer: nobody reads them letter by letter, and
/// comparing them would take the square of their length. The time is linear in the known words.
pub(super) fn nearest<'a>(
    word: &str,
    known: impl Iterator<Item = &'a str> + Clone,
) -> Option<&'a str> {
    if word.chars().nth(LONGEST).is_some() {
        return None;
    }
    let longer = known.clone().find(|candidate| candidate.split('_').any(|part| part == word));
    let limit = word.chars().count().div_ceil(3);
    let near = known.map(|candidate| (distance(word, candidate, limit), candidate));
    near.filter(|(distance, _)| *distance <= limit)
        .min_by_key(|(distance, _)| *distance)
        .map(|(_, word)| word)
        .or(longer)
}

/// The Levenshtein distance of two words: letters to insert, delete or exchange.
///
/// Words whose lengths alone differ by more than the limit are not compared.
fn distance(a: &str, b: &str, limit: usize) -> usize {
    if a.chars().count().abs_diff(b.chars().count()) > limit {
        return usize::MAX;
    }
    strsim::levenshtein(a, b)
}

/// Lists the first twenty known words, and the one that was probably meant.
pub(super) fn list<'a>(
    word: &str,
    known: impl ExactSizeIterator<Item = &'a str> + Clone,
) -> String {
    const SHOWN: usize = 20;
    // Names are the user's own and may hold control characters.
    let shown: Vec<String> =
        known.clone().take(SHOWN).map(|word| word.escape_debug().to_string()).collect();
    let mut text = shown.join(", ");
    if known.len() > SHOWN {
        text += &format!(" and {} more", known.len() - SHOWN);
    }
    if let Some(meant) = nearest(word, known) {
        text += &format!(" (did you mean {}?)", meant.escape_debug());
    }
    text
}
