//! What `catoptric_tests::source` finds in made-up files.

use catoptric_tests::source::{Change, Source};

/// A text as the only file.
fn source(text: &str) -> Source {
    Source::of(vec![("folder/file.rs".into(), text.to_owned())])
}

/// A function after a change.
fn changed(text: &str, function: &str, change: &Change) -> Result<String, String> {
    let place = source(text).place(function, change)?;
    let mut text = text.to_owned();
    assert_eq!(&text[place.range.clone()], place.sound);
    text.replace_range(place.range, &place.instead);
    Ok(text)
}

#[test]
fn names_lead_to_functions_and_types() {
    let text = "
        pub(crate) enum E {
            A,
        }
        fn f() {}
        impl<T> S<T> {
            #[inline]
            pub fn f(&self) -> u32 {
                1
            }
        }
        impl Add for V<u8> { fn add(self) {} }
        impl Add for V<[u8; 2]> { fn add(self) {} }
        trait T { fn given() { 1 } fn asked(); }
        #[cfg(test)] mod tests { fn f() {} }
    ";
    let source = source(text);
    assert_eq!(source.text("f").as_deref(), Ok("fn f() {}\n"));
    assert_eq!(source.text("file::f").as_deref(), Ok("fn f() {}\n"));
    assert!(source.text("other::f").is_err() && source.text("e::f").is_err());
    assert_eq!(source.text("folder::file::f").as_deref(), Ok("fn f() {}\n"));
    let method = "pub fn f(&self) -> u32 {\n    1\n}\n";
    assert_eq!(source.text("S::f").as_deref(), Ok(method));
    assert_eq!(source.text("E").as_deref(), Ok("pub(crate) enum E {\n    A,\n}\n"));
    assert!(source.text("V<u8>::add").is_ok() && source.text("V<[u8;2]>::add").is_ok());
    assert!(source.text("V::add").is_err(), "there are two");
    assert!(source.text("T::given").is_ok() && source.text("T::asked").is_err());
}

#[test]
fn expressions_are_found_whatever_locals_are_called() {
    let less = Change { find: "$t.lt($best)", nth: 0, instead: "$t.le($best)" };
    for name in ["best", "so_far"] {
        let text = format!("fn take(x: X) {{ x.y.lt({name}) & x.z.gt({name}) }}");
        let expected = format!("fn take(x: X) {{ (x.y).le(({name})) & x.z.gt({name}) }}");
        assert_eq!(changed(&text, "take", &less), Ok(expected));
    }
    // The same hole is the same text, and macros are looked into.
    let square = Change { find: "$v.dot($v)", nth: 0, instead: "$v.dot($1)" };
    assert_eq!(
        changed("fn f(w: V) { assert!(a.dot(b) < w.dot(w)) }", "f", &square).as_deref(),
        Ok("fn f(w: V) { assert!(a.dot(b) < (w).dot(w)) }")
    );
    let body = Change { find: "$body", nth: 0, instead: "self.other($1)" };
    assert_eq!(
        changed("impl S { fn f(self, by: u8) { 1 } }", "S::f", &body).as_deref(),
        Ok("impl S { fn f(self, by: u8) self.other(by) }")
    );
}

#[test]
fn one_of_several_must_be_asked_for() {
    let text = "fn f() { if a { return x; } return y }";
    let change = |nth| Change { find: "return $x", nth, instead: "return -$x" };
    assert!(changed(text, "f", &change(0)).is_err());
    assert!(changed(text, "f", &change(3)).is_err());
    let second = changed(text, "f", &change(2));
    assert_eq!(second.as_deref(), Ok("fn f() { if a { return x; } return -(y) }"));
}
