//! A draft that was changed after reading: blame falls on the file only for what it says.

use catoptric_scene::{Document, Scene, SceneError, SceneFormat};

fn changed(text: &str, change: impl Fn(&mut Document)) -> Result<Scene, SceneError> {
    let format = SceneFormat::of_text(text.as_bytes());
    let mut document = Document::parse("a.scene", text.as_bytes(), format)?;
    change(&mut document);
    document.into_scene()
}

const NOT_IN_FILE: &str = "(not in the file: a default, or set after the file was read)";

#[test]
fn what_is_set_after_reading_counts() {
    let scene = changed("[image]\nwidth = 0", |document| document.draft_mut().image.width = 7);
    assert_eq!(scene.expect("the wrong width was replaced").image.width, 7);
}

#[test]
fn a_wrong_value_set_after_reading_is_not_blamed_on_the_file() {
    for text in ["[image]\nwidth = 640", "[image]", r#"{"image": {"width": 640}}"#] {
        let error = changed(text, |document| document.draft_mut().image.width = 0).unwrap_err();
        assert_eq!(error.key().as_deref(), Some("image.width"));
        assert_eq!(error.position(), None);
        let message = error.to_string();
        assert!(message.starts_with("a.scene: image.width: found 0; allowed: "), "{message}");
        assert!(message.ends_with(NOT_IN_FILE), "{message}");
    }
}

#[test]
fn other_wrong_values_of_the_file_still_have_their_place() {
    let text = "[image]\nwidth = 0\nheight = 0";
    let error = changed(text, |document| document.draft_mut().image.width = 7).unwrap_err();
    assert_eq!(error.key().as_deref(), Some("image.height"));
    assert_eq!(error.position(), Some((3, 10)));
}

#[test]
fn a_default_that_does_not_fit_is_said_to_be_one() {
    let error = changed("[camera]\nlook_at = [0, 5, 0]", |_| {}).unwrap_err();
    assert_eq!(error.key().as_deref(), Some("camera.up"));
    assert_eq!(error.position(), None);
    assert!(error.to_string().ends_with(NOT_IN_FILE), "{error}");
}

#[test]
fn materials_that_nothing_uses_are_judged_in_the_changed_scene() {
    let text = "[materials.m]\ncolor = [1e15, 1, 1]";
    assert!(changed(text, |_| {}).is_ok());
    let error = changed(text, |document| document.draft_mut().render.ambient = [1e15; 3]);
    assert_eq!(error.unwrap_err().position(), Some((2, 9)));
}

#[test]
fn a_scene_without_a_file_names_the_key_alone() {
    let mut draft =
        Document::parse("a.toml", b"[image]", SceneFormat::Toml).expect("legal").draft().clone();
    draft.render.background[1] = f64::NAN;
    let error = Scene::new(draft).unwrap_err();
    let message = error.to_string();
    assert!(message.starts_with("render.background[1]: found nan; allowed: "), "{message}");
    assert!(!message.contains("file"), "{message}");
}
