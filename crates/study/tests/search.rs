//! The search for scenes that the robust formulas do not render as they must.
//!
//! `CATOPTRIC_SEARCHED_SCENES` asks for more scenes, `CATOPTRIC_SEARCHED_FROM` for other ones. Each
//! fault is printed as a scene that can be rendered.

use catoptric_study::stability::search::search;

fn number(name: &str, default: u64) -> u64 {
    std::env::var_os(name).map_or(default, |text| {
        let parsed = text.to_str().and_then(|text| text.parse().ok());
        parsed.unwrap_or_else(|| panic!("{name} is a number"))
    })
}

#[test]
fn every_picture_is_the_true_one_of_a_scene_nearly_as_stated() {
    let from = number("CATOPTRIC_SEARCHED_FROM", 0);
    let found = search(from..from + number("CATOPTRIC_SEARCHED_SCENES", 1_000));
    println!("{} scenes, {} seen", found.scenes, found.seen);
    let texts: Vec<_> = found.faults.iter().map(|fault| fault.to_toml()).collect();
    assert!(texts.is_empty(), "{} faults\n\n{}", texts.len(), texts.join("\n"));
}
