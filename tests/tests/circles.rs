//! Import circles: files of one crate that need each other to be understood.
//!
//! An arrow goes from a file to the file that defines what it names, in a `use` or in a path,
//! however many re-exports lie between. That a parent declares its children, or passes on what
//! they define, is no arrow; that it uses it itself is one. Code for tests alone is left out.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cargo_metadata::MetadataCommand;
use catoptric_tests::scenes::root;
use proc_macro2::{TokenStream, TokenTree};
use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Attribute, Item, ItemMod, ItemUse, Meta, UseTree, Visibility};

/// Packages that still have circles, with the number of files in the largest one. It may only
/// fall.
const CIRCLES: &[(&str, usize)] = &[];

#[test]
fn no_file_stands_in_a_circle() {
    let metadata = MetadataCommand::new()
        .manifest_path(root().join("Cargo.toml"))
        .no_deps()
        .exec()
        .expect("cargo metadata");
    let mut wrong = Vec::new();
    for package in metadata.workspace_packages() {
        let allowed = CIRCLES.iter().find(|(name, _)| package.name == *name);
        let allowed = allowed.map_or(0, |(_, files)| *files);
        let mut largest = 0;
        let mut told = String::new();
        for target in package.targets.iter().filter(|target| !target.is_custom_build()) {
            let files =
                Files::read(target.src_path.as_std_path(), &|path| fs::read_to_string(path).ok());
            for circle in files.circles() {
                largest = largest.max(circle.len());
                told += &files.told(&circle);
            }
        }
        if largest > allowed {
            wrong.push(format!(
                "{}: a circle of {largest} files, and {allowed} are allowed\n{told}",
                package.name
            ));
        } else if largest < allowed {
            wrong.push(format!(
                "{}: the largest circle has {largest} files; lower its entry in CIRCLES",
                package.name
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The modules of one crate, and the files that they stand in.
#[derive(Default)]
struct Files {
    files: Vec<(PathBuf, String)>,
    modules: Vec<Module>,
}

/// A module, in a file of its own or not.
#[derive(Default)]
struct Module {
    file: usize,
    parent: usize,
    children: BTreeMap<String, usize>,
    /// Items defined here.
    defined: BTreeSet<String>,
    imports: Vec<Import>,
    /// Paths that the code names, outside `use`.
    named: Vec<Named>,
}

/// One leaf of a `use`.
struct Import {
    path: Named,
    /// The name that it has here; of a glob, none.
    name: Option<String>,
    glob: bool,
    /// Whether it is passed on to others.
    exported: bool,
}

/// A path as it is written, and its line.
#[derive(Clone)]
struct Named {
    path: Vec<String>,
    line: usize,
}

/// What a path leads to.
#[derive(Clone, Copy)]
enum Found {
    Module(usize),
    /// Something that is defined in a file.
    Item(usize),
}

impl Files {
    /// Reads a crate from its root. `text` gives a file's text, if there is such a file.
    fn read(root: &Path, text: &dyn Fn(&Path) -> Option<String>) -> Self {
        let mut files = Self::default();
        let folder = root.parent().expect("a file stands in a folder");
        files.add_file(0, root, folder, text);
        files
    }

    /// Adds a file as a module; its number. Modules that it declares are looked for in `folder`.
    fn add_file(
        &mut self,
        parent: usize,
        path: &Path,
        folder: &Path,
        text: &dyn Fn(&Path) -> Option<String>,
    ) -> usize {
        let source = text(path).unwrap_or_else(|| panic!("{} can be read", path.display()));
        let parsed = syn::parse_file(&source).expect("the file is Rust");
        // A file may be mounted twice, by `#[path]`: two modules and one file.
        let known = self.files.iter().position(|(known, _)| known == path);
        let file = known.unwrap_or_else(|| {
            self.files.push((path.to_owned(), source));
            self.files.len() - 1
        });
        self.add_module(parent, file, &parsed.items, folder, text)
    }

    /// Adds a module and those below it; its number.
    fn add_module(
        &mut self,
        parent: usize,
        file: usize,
        items: &[Item],
        folder: &Path,
        text: &dyn Fn(&Path) -> Option<String>,
    ) -> usize {
        let number = self.modules.len();
        let mut reader = Reader { module: Module { file, parent, ..Module::default() } };
        let mut modules = Vec::new();
        for item in items {
            match item {
                Item::Mod(module) if !is_for_tests(&module.attrs) => modules.push(module),
                Item::Mod(_) => {}
                _ => reader.visit_item(item),
            }
        }
        self.modules.push(reader.module);
        for module in modules {
            let name = module.ident.to_string();
            let below = folder.join(&name);
            let child = if let Some((_, items)) = &module.content {
                self.add_module(number, file, items, &below, text)
            } else {
                let place = self.place(file, folder, module, text);
                let within = place.file_name().is_some_and(|name| name == "mod.rs");
                let below = if within { place.parent().expect("a folder") } else { &below };
                self.add_file(number, &place, below, text)
            };
            self.modules[number].children.insert(name, child);
        }
        number
    }

    /// Where the text of a declared module stands.
    fn place(
        &self,
        file: usize,
        folder: &Path,
        module: &ItemMod,
        text: &dyn Fn(&Path) -> Option<String>,
    ) -> PathBuf {
        for attribute in &module.attrs {
            if let Meta::NameValue(path) = &attribute.meta
                && path.path.is_ident("path")
                && let syn::Expr::Lit(literal) = &path.value
                && let syn::Lit::Str(name) = &literal.lit
            {
                return self.files[file].0.with_file_name(name.value());
            }
        }
        let flat = folder.join(format!("{}.rs", module.ident));
        if text(&flat).is_some() {
            flat
        } else {
            folder.join(module.ident.to_string()).join("mod.rs")
        }
    }

    /// What a path means where it is written; `None` for what other crates define, and for locals.
    fn find(&self, module: usize, path: &[String], steps: usize) -> Option<Found> {
        // Globs may lead in a circle.
        if steps > 32 {
            return None;
        }
        let (first, mut rest) = path.split_first()?;
        let mut at = match first.as_str() {
            "crate" => 0,
            "self" => module,
            "super" => self.modules[module].parent,
            name => match self.look_up(module, name, steps)? {
                Found::Module(at) => at,
                item @ Found::Item(_) => return Some(item),
            },
        };
        while let Some((name, after)) = rest.split_first() {
            let found = match name.as_str() {
                "super" => Some(Found::Module(self.modules[at].parent)),
                name => self.look_up(at, name, steps),
            };
            match found {
                Some(Found::Module(next)) => at = next,
                Some(item) => return Some(item),
                // A macro made it.
                None => return Some(Found::Item(self.modules[at].file)),
            }
            rest = after;
        }
        Some(Found::Module(at))
    }

    /// What a name means in a module.
    fn look_up(&self, module: usize, name: &str, steps: usize) -> Option<Found> {
        let here = &self.modules[module];
        if let Some(child) = here.children.get(name) {
            return Some(Found::Module(*child));
        }
        if here.defined.contains(name) {
            return Some(Found::Item(here.file));
        }
        let import = here.imports.iter().find(|import| import.name.as_deref() == Some(name));
        if let Some(import) = import {
            // `use name::..` asks for the crate of that name, not for itself.
            let own = import.path.path[0] == name;
            return if own { None } else { self.find(module, &import.path.path, steps + 1) };
        }
        here.imports.iter().filter(|import| import.glob).find_map(|glob| {
            match self.find(module, &glob.path.path, steps + 1)? {
                Found::Module(from) if from != module => self.look_up(from, name, steps + 1),
                _ => None,
            }
        })
    }

    /// Every arrow with the line in which it is first drawn.
    fn arrows(&self) -> BTreeMap<(usize, usize), usize> {
        let mut arrows = BTreeMap::new();
        for (number, module) in self.modules.iter().enumerate() {
            let imported = module.imports.iter().filter(|import| !import.exported && !import.glob);
            for named in imported.map(|import| &import.path).chain(&module.named) {
                if let Some(Found::Item(to)) = self.find(number, &named.path, 0)
                    && to != module.file
                {
                    let line = arrows.entry((module.file, to)).or_insert(named.line);
                    *line = (*line).min(named.line);
                }
            }
        }
        arrows
    }

    /// Sets of files each of which reaches all others of its set.
    fn circles(&self) -> Vec<BTreeSet<usize>> {
        let arrows = self.arrows();
        let reached = |from: usize| {
            let mut reached = BTreeSet::new();
            let mut rest = vec![from];
            while let Some(file) = rest.pop() {
                let next = arrows.keys().filter(|(start, _)| *start == file).map(|(_, to)| *to);
                rest.extend(next.filter(|to| reached.insert(*to)));
            }
            reached
        };
        let reached: Vec<_> = (0..self.files.len()).map(reached).collect();
        let mut circles = BTreeSet::new();
        for (file, from) in reached.iter().enumerate().filter(|(file, from)| from.contains(file)) {
            circles
                .insert(from.iter().copied().filter(|to| reached[*to].contains(&file)).collect());
        }
        circles.into_iter().collect()
    }

    /// A circle's arrows, each with the line that draws it.
    fn told(&self, circle: &BTreeSet<usize>) -> String {
        let mut told = format!("  {} files:\n", circle.len());
        for ((from, to), line) in self.arrows() {
            if circle.contains(&from) && circle.contains(&to) {
                let (path, text) = &self.files[from];
                let code = text.lines().nth(line - 1).unwrap_or_default().trim();
                let path = path.strip_prefix(root()).unwrap_or(path).display();
                let to = self.files[to].0.file_name().unwrap_or_default().display();
                told += &format!("    {path}:{line} -> {to}: {code}\n");
            }
        }
        told
    }
}

/// Collects what one module defines and names, without the modules in it.
struct Reader {
    module: Module,
}

impl Reader {
    /// Adds the leaves of a `use`.
    fn import(&mut self, tree: &UseTree, before: &[String], exported: bool) {
        let line = tree.span().start().line;
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        let (path, name, glob) = match tree {
            UseTree::Path(path) => return self.import(&path.tree, &with(&path.ident), exported),
            UseTree::Group(group) => {
                return group.items.iter().for_each(|tree| self.import(tree, before, exported));
            }
            UseTree::Name(name) if name.ident == "self" => {
                (before.to_vec(), before.last().cloned(), false)
            }
            UseTree::Name(name) => (with(&name.ident), Some(name.ident.to_string()), false),
            UseTree::Rename(rename) => {
                let own = rename.ident == "self";
                let path = if own { before.to_vec() } else { with(&rename.ident) };
                (path, Some(rename.rename.to_string()), false)
            }
            UseTree::Glob(_) => (before.to_vec(), None, true),
        };
        if !path.is_empty() {
            let path = Named { path, line };
            self.module.imports.push(Import { path, name, glob, exported });
        }
    }

    /// Adds the paths among a macro's tokens.
    fn tokens(&mut self, tokens: TokenStream) {
        let mut path: Vec<String> = Vec::new();
        let mut line = 0;
        // Colons since the last name; a name after a dot is a field or a method.
        let (mut colons, mut dot) = (0, false);
        for token in tokens {
            match token {
                TokenTree::Ident(ident) => {
                    if colons != 2 || path.is_empty() {
                        self.name(std::mem::take(&mut path), line);
                        line = ident.span().start().line;
                    }
                    if !dot {
                        path.push(ident.to_string());
                    }
                    (colons, dot) = (0, false);
                }
                TokenTree::Punct(punct) if punct.as_char() == ':' => colons += 1,
                other => {
                    self.name(std::mem::take(&mut path), line);
                    dot = matches!(&other, TokenTree::Punct(punct) if punct.as_char() == '.');
                    colons = 0;
                    if let TokenTree::Group(group) = other {
                        self.tokens(group.stream());
                    }
                }
            }
        }
        self.name(path, line);
    }

    fn name(&mut self, path: Vec<String>, line: usize) {
        if !path.is_empty() {
            self.module.named.push(Named { path, line });
        }
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item(&mut self, item: &'ast Item) {
        let (attributes, name) = match item {
            Item::Const(item) => (&item.attrs, Some(&item.ident)),
            Item::Enum(item) => (&item.attrs, Some(&item.ident)),
            Item::Fn(item) => (&item.attrs, Some(&item.sig.ident)),
            Item::Macro(item) => (&item.attrs, item.ident.as_ref()),
            Item::Static(item) => (&item.attrs, Some(&item.ident)),
            Item::Struct(item) => (&item.attrs, Some(&item.ident)),
            Item::Trait(item) => (&item.attrs, Some(&item.ident)),
            Item::Type(item) => (&item.attrs, Some(&item.ident)),
            Item::Union(item) => (&item.attrs, Some(&item.ident)),
            Item::Impl(item) => (&item.attrs, None),
            Item::Use(item) => (&item.attrs, None),
            _ => return visit::visit_item(self, item),
        };
        if !is_for_tests(attributes) {
            self.module.defined.extend(name.map(ToString::to_string));
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        if item.leading_colon.is_none() {
            self.import(&item.tree, &[], !matches!(item.vis, Visibility::Inherited));
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        if path.leading_colon.is_none() {
            let segments = path.segments.iter().map(|segment| segment.ident.to_string());
            self.name(segments.collect(), path.span().start().line);
        }
        visit::visit_path(self, path);
    }

    fn visit_macro(&mut self, macro_: &'ast syn::Macro) {
        self.visit_path(&macro_.path);
        self.tokens(macro_.tokens.clone());
    }

    fn visit_attribute(&mut self, _: &'ast Attribute) {}

    fn visit_visibility(&mut self, _: &'ast Visibility) {}
}

fn is_for_tests(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| match &attribute.meta {
        Meta::Path(path) => path.is_ident("test"),
        Meta::List(list) => list.path.is_ident("cfg") && list.tokens.to_string() == "test",
        Meta::NameValue(_) => false,
    })
}

/// The files of the circles of a made-up crate, each as text after its path.
fn circles_of(files: &[(&str, &str)]) -> Vec<Vec<String>> {
    let text = |path: &Path| {
        let found = files.iter().find(|(name, _)| Path::new(name) == path);
        found.map(|(_, text)| (*text).to_owned())
    };
    let read = Files::read(Path::new(files[0].0), &text);
    let name = |file: &usize| read.files[*file].0.display().to_string();
    let circles = read.circles();
    for circle in &circles {
        // Every arrow is told with its line.
        assert!(read.told(circle).lines().count() > circle.len());
    }
    circles.iter().map(|circle| circle.iter().map(name).collect()).collect()
}

#[test]
fn a_circle_of_two_is_found() {
    let by_use = [
        ("src/lib.rs", "mod a; mod b;"),
        ("src/a.rs", "use crate::b::B; pub(crate) struct A;"),
        ("src/b.rs", "use super::a::{self, A}; pub(crate) struct B;"),
    ];
    assert_eq!(circles_of(&by_use), [["src/a.rs", "src/b.rs"]]);
    let by_path = [
        ("src/lib.rs", "mod a; mod b;"),
        ("src/a.rs", "pub(crate) fn a() { crate::b::b() }"),
        ("src/b.rs", "use crate::a; pub(crate) fn b() { assert_eq!(1, 1 + 2 * a::a()) }"),
    ];
    assert_eq!(circles_of(&by_path), [["src/a.rs", "src/b.rs"]]);
    let with_the_parent = [
        ("src/lib.rs", "mod a;"),
        ("src/a.rs", "mod b; use b::B; pub(crate) struct A;"),
        ("src/a/b.rs", "use super::A; pub(super) struct B;"),
    ];
    assert_eq!(circles_of(&with_the_parent), [["src/a.rs", "src/a/b.rs"]]);
    let by_glob = [
        ("src/lib.rs", "mod a;"),
        ("src/a/mod.rs", "mod b; pub use b::B; pub(crate) struct A(B);"),
        ("src/a/b.rs", "use super::*; pub struct B(Box<A>);"),
    ];
    assert_eq!(circles_of(&by_glob), [["src/a/mod.rs", "src/a/b.rs"]]);
}

#[test]
fn a_circle_of_three_through_a_reexport_is_found() {
    let files = [
        ("src/lib.rs", "mod a; mod b; mod c; mod d; pub use c::C;"),
        ("src/a.rs", "use crate::b::B; pub(crate) struct A;"),
        ("src/b.rs", "use crate::C; pub(crate) struct B;"),
        ("src/c.rs", "pub struct C(crate::a::A);"),
        ("src/d.rs", "use crate::{C, a::A};"),
    ];
    assert_eq!(circles_of(&files), [["src/a.rs", "src/b.rs", "src/c.rs"]]);
}

#[test]
fn where_there_is_no_circle_none_is_found() {
    let files = [
        // The parent declares and passes on, and the children see what is not its own.
        ("src/lib.rs", "mod a; mod b; pub use a::A; pub(crate) const ONE: u32 = 1;"),
        (
            "src/a.rs",
            "mod c; pub use c::C; pub struct A; impl A { fn one() -> u32 { crate::ONE } }",
        ),
        ("src/a/c.rs", "use super::super::b::b; use std::fmt; pub struct C(super::A);"),
        (
            "src/b.rs",
            "pub(crate) fn b(a: u32) { let x = a.A(); }
             #[cfg(test)] mod tests { use crate::A; }
             #[test] fn test() { crate::a::C; }",
        ),
    ];
    assert_eq!(circles_of(&files), Vec::<Vec<String>>::new());
}
