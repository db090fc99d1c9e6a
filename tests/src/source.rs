//! Rust source as data: functions and types by their name, wherever they stand, and expressions
//! in them by their shape.

use std::collections::BTreeMap;
use std::fs;
use std::ops::Range;
use std::path::{Path, PathBuf};

use syn::spanned::Spanned;
use syn::visit::{self, Visit};
use syn::{Block, Expr, FnArg, ImplItemFn, ItemFn, ItemImpl, ItemTrait, Pat, Stmt, Type};

/// The files below a folder, and what is defined there.
pub struct Source {
    files: Vec<(PathBuf, String)>,
    items: Vec<Item>,
}

/// A function, or a type.
struct Item {
    /// What it is called: `name`, `Type::name`, and `Type<Of>::name` where that alone is one.
    names: Vec<String>,
    /// Module that it stands in, by its file: `folder::file`.
    module: String,
    file: usize,
    /// From its visibility to its end.
    range: Range<usize>,
    /// Names of a function's parameters, `self` left out; empty where one is a pattern.
    parameters: Vec<String>,
    body: Option<Block>,
}

/// A change to one function.
///
/// `find` and `instead` are expressions. `$name` in `find` stands for any expression, the same one
/// wherever it occurs; in `instead` for what it was. `$1`, `$2` stand for the function's
/// parameters, and `$body` alone for its whole body.
#[derive(Clone, Copy, Debug)]
pub struct Change {
    /// What is sought.
    pub find: &'static str,
    /// Which of those found, from 1 on; 0 where there must be one only.
    pub nth: usize,
    /// What comes in its place.
    pub instead: &'static str,
}

/// Where a change is made.
#[derive(Clone, Debug)]
pub struct Place {
    /// File below the folder.
    pub file: PathBuf,
    /// Bytes of the expression.
    pub range: Range<usize>,
    /// Text of the expression.
    pub sound: String,
    /// Text that comes in its place.
    pub instead: String,
}

impl Source {
    /// Reads all Rust files below a folder.
    ///
    /// # Panics
    /// If one cannot be read or is no Rust.
    #[must_use]
    pub fn new(folder: &Path) -> Self {
        let mut paths = Vec::new();
        let mut folders = vec![folder.to_owned()];
        while let Some(folder) = folders.pop() {
            for entry in fs::read_dir(&folder).expect("a folder of source") {
                let path = entry.expect("an entry").path();
                if path.is_dir() {
                    folders.push(path);
                } else if path.extension().is_some_and(|ending| ending == "rs") {
                    paths.push(path);
                }
            }
        }
        paths.sort();
        let read = |path: PathBuf| {
            let text = fs::read_to_string(&path).expect("a source file");
            (path.strip_prefix(folder).expect("it is below the folder").to_owned(), text)
        };
        Self::of(paths.into_iter().map(read).collect())
    }

    /// Takes files as they are: paths and texts.
    ///
    /// # Panics
    /// If one is no Rust.
    #[must_use]
    pub fn of(files: Vec<(PathBuf, String)>) -> Self {
        let mut items = Vec::new();
        for (number, (path, text)) in files.iter().enumerate() {
            let parsed = syn::parse_file(text).expect("the file is Rust");
            let parts = path.with_extension("");
            let parts: Vec<_> = parts.iter().map(|part| part.to_string_lossy()).collect();
            let mut reader =
                Reader { module: parts.join("::"), file: number, within: Vec::new(), items };
            reader.visit_file(&parsed);
            items = reader.items;
        }
        Self { files, items }
    }

    /// The text of a function or type from its visibility on, without indentation.
    ///
    /// # Errors
    /// If it does not stand there once.
    pub fn text(&self, name: &str) -> Result<String, String> {
        let item = self.item(name)?;
        let text = &self.files[item.file].1;
        let line = text[..item.range.start].rfind('\n').map_or(0, |end| end + 1);
        let indented = item.range.start - line;
        let lines = text[item.range.clone()].lines();
        let without =
            |line: &str| line.get(..indented).is_some_and(|start| start.trim().is_empty());
        let lines = lines.map(|line| if without(line) { &line[indented..] } else { line });
        Ok(lines.collect::<Vec<_>>().join("\n") + "\n")
    }

    /// Finds where a change of a function is made.
    ///
    /// # Errors
    /// If there is no such function, or no such expression in it, or more of them than asked for.
    pub fn place(&self, function: &str, change: &Change) -> Result<Place, String> {
        let item = self.item(function)?;
        let (path, text) = &self.files[item.file];
        let Some(body) = &item.body else { return Err(format!("{function} has no body")) };
        let mut instead = with_parameters(change.instead, &item.parameters);
        let found = if change.find == "$body" {
            vec![(body.span().byte_range(), BTreeMap::new())]
        } else {
            let pattern = with_parameters(change.find, &item.parameters).replace('$', HOLE);
            let parsed = syn::parse_str(&pattern)
                .map_err(|error| format!("{function}, {}: {error}", change.find))?;
            let mut finder = Finder { pattern, parsed, text, found: Vec::new() };
            finder.visit_block(body);
            finder.found
        };
        let chosen = if change.nth == 0 && found.len() == 1 { 1 } else { change.nth };
        let Some((range, bound)) = chosen.checked_sub(1).and_then(|i| found.get(i)) else {
            let many = found.len();
            return Err(format!("{function} has {many} of {}, and {chosen} is meant", change.find));
        };
        // Longer names first: one may begin another.
        for (name, text) in bound.iter().rev() {
            instead = instead.replace(&format!("${name}"), &format!("({text})"));
        }
        let sound = text[range.clone()].to_owned();
        Ok(Place { file: path.clone(), range: range.clone(), sound, instead })
    }

    /// The item of a name, which may be led by its module.
    fn item(&self, name: &str) -> Result<&Item, String> {
        // Any part of the modules around may lead the name: `b::f` is `a::b::f` too.
        let is = |item: &&Item| {
            item.names.iter().any(|own| {
                let module = name.strip_suffix(own.as_str()).map(|rest| rest.strip_suffix("::"));
                let around = format!("::{}", item.module);
                match module {
                    Some(Some(module)) => around.ends_with(&format!("::{module}")),
                    _ => own == name,
                }
            })
        };
        let found: Vec<_> = self.items.iter().filter(is).collect();
        match found[..] {
            [item] => Ok(item),
            _ => Err(format!("{name} stands there {} times", found.len())),
        }
    }
}

/// What a hole of a pattern is called for the parser.
const HOLE: &str = "hole__";

/// `$1` and so on as the names of parameters.
fn with_parameters(text: &str, parameters: &[String]) -> String {
    let mut text = text.to_owned();
    for (name, number) in parameters.iter().zip(1..) {
        text = text.replace(&format!("${number}"), name);
    }
    text
}

/// Collects the items of one file. Tests are left out.
struct Reader {
    module: String,
    file: usize,
    /// Names of the type or trait around.
    within: Vec<String>,
    items: Vec<Item>,
}

impl Reader {
    fn add(&mut self, name: &syn::Ident, range: Range<usize>) -> &mut Item {
        let names = if self.within.is_empty() {
            vec![name.to_string()]
        } else {
            self.within.iter().map(|within| format!("{within}::{name}")).collect()
        };
        let (module, parameters) = (self.module.clone(), Vec::new());
        self.items.push(Item { names, module, file: self.file, range, parameters, body: None });
        self.items.last_mut().expect("it was pushed")
    }

    fn add_function(&mut self, signature: &syn::Signature, start: usize, body: &Block) {
        let parameter = |argument: &FnArg| match argument {
            FnArg::Receiver(_) => None,
            FnArg::Typed(typed) => Some(match &*typed.pat {
                Pat::Ident(pattern) => pattern.ident.to_string(),
                _ => String::new(),
            }),
        };
        let item = self.add(&signature.ident, start..body.span().byte_range().end);
        item.parameters = signature.inputs.iter().filter_map(parameter).collect();
        item.body = Some(body.clone());
    }
}

/// Where an item starts that may have a visibility.
fn start(visibility: &syn::Visibility, rest: &impl Spanned) -> usize {
    let rest = rest.span().byte_range().start;
    match visibility {
        syn::Visibility::Inherited => rest,
        shown => shown.span().byte_range().start,
    }
}

impl<'ast> Visit<'ast> for Reader {
    fn visit_item_mod(&mut self, module: &'ast syn::ItemMod) {
        let is_test = |attribute: &syn::Attribute| {
            attribute.path().is_ident("cfg")
                && attribute.parse_args::<syn::Path>().is_ok_and(|path| path.is_ident("test"))
        };
        if !module.attrs.iter().any(is_test) {
            visit::visit_item_mod(self, module);
        }
    }

    fn visit_item_impl(&mut self, item: &'ast ItemImpl) {
        let Type::Path(of) = &*item.self_ty else { return };
        let Some(last) = of.path.segments.last() else { return };
        self.within = vec![last.ident.to_string()];
        if let syn::PathArguments::AngleBracketed(arguments) = &last.arguments {
            let arguments: Vec<_> = arguments.args.iter().map(spelled).collect();
            self.within.push(format!("{}<{}>", last.ident, arguments.join(", ")));
        }
        visit::visit_item_impl(self, item);
        self.within.clear();
    }

    fn visit_item_trait(&mut self, item: &'ast ItemTrait) {
        self.within = vec![item.ident.to_string()];
        visit::visit_item_trait(self, item);
        self.within.clear();
    }

    fn visit_item_fn(&mut self, item: &'ast ItemFn) {
        // A function in a method's body is no method.
        let within = std::mem::take(&mut self.within);
        self.add_function(&item.sig, start(&item.vis, &item.sig), &item.block);
        self.within = within;
    }

    fn visit_impl_item_fn(&mut self, item: &'ast ImplItemFn) {
        self.add_function(&item.sig, start(&item.vis, &item.sig), &item.block);
    }

    fn visit_trait_item_fn(&mut self, item: &'ast syn::TraitItemFn) {
        if let Some(body) = &item.default {
            self.add_function(&item.sig, item.sig.span().byte_range().start, body);
        }
    }

    fn visit_item_enum(&mut self, item: &'ast syn::ItemEnum) {
        let end = item.brace_token.span.close().byte_range().end;
        self.add(&item.ident, start(&item.vis, &item.enum_token)..end);
    }

    fn visit_item_struct(&mut self, item: &'ast syn::ItemStruct) {
        let end = item.span().byte_range().end;
        self.add(&item.ident, start(&item.vis, &item.struct_token)..end);
    }
}

/// A generic argument as it is spelled, without blanks.
fn spelled(argument: &syn::GenericArgument) -> String {
    let text = argument.span().source_text().unwrap_or_default();
    text.split_whitespace().collect()
}

/// Finds the expressions of a pattern's shape, outer ones before inner ones.
struct Finder<'a> {
    pattern: String,
    parsed: Expr,
    text: &'a str,
    found: Vec<(Range<usize>, BTreeMap<String, String>)>,
}

impl<'ast> Visit<'ast> for Finder<'_> {
    fn visit_expr(&mut self, expr: &'ast Expr) {
        let mut shape = Shape { pattern: &self.pattern, text: self.text, bound: BTreeMap::new() };
        if shape.fits(&self.parsed, expr) {
            let bound = shape.bound;
            self.found.push((expr.span().byte_range(), bound));
        }
        visit::visit_expr(self, expr);
    }

    /// Looks into a macro's arguments, where they are expressions.
    fn visit_macro(&mut self, macro_: &'ast syn::Macro) {
        let parser = syn::punctuated::Punctuated::<Expr, syn::Token![,]>::parse_terminated;
        if let Ok(arguments) = macro_.parse_body_with(parser) {
            for argument in &arguments {
                <Self as Visit<'_>>::visit_expr(self, argument);
            }
        }
    }
}

/// A pattern beside a text, and what its holes stand for.
struct Shape<'a> {
    pattern: &'a str,
    text: &'a str,
    bound: BTreeMap<String, String>,
}

impl Shape<'_> {
    fn fits(&mut self, pattern: &Expr, expr: &Expr) -> bool {
        if let Expr::Path(path) = pattern
            && let Some(name) = path.path.get_ident().map(ToString::to_string)
            && let Some(name) = name.strip_prefix(HOLE)
        {
            let text = self.text[expr.span().byte_range()].to_owned();
            return *self.bound.entry(name.to_owned()).or_insert_with(|| text.clone()) == text;
        }
        match (pattern, expr) {
            (Expr::Binary(p), Expr::Binary(e)) => {
                self.same(&p.op, &e.op)
                    && self.fits(&p.left, &e.left)
                    && self.fits(&p.right, &e.right)
            }
            (Expr::Assign(p), Expr::Assign(e)) => {
                self.fits(&p.left, &e.left) && self.fits(&p.right, &e.right)
            }
            (Expr::Unary(p), Expr::Unary(e)) => {
                self.same(&p.op, &e.op) && self.fits(&p.expr, &e.expr)
            }
            (Expr::Paren(p), Expr::Paren(e)) => self.fits(&p.expr, &e.expr),
            (Expr::Reference(p), Expr::Reference(e)) => {
                p.mutability.is_some() == e.mutability.is_some() && self.fits(&p.expr, &e.expr)
            }
            (Expr::Field(p), Expr::Field(e)) => p.member == e.member && self.fits(&p.base, &e.base),
            (Expr::Index(p), Expr::Index(e)) => {
                self.fits(&p.expr, &e.expr) && self.fits(&p.index, &e.index)
            }
            (Expr::Return(p), Expr::Return(e)) => match (&p.expr, &e.expr) {
                (Some(p), Some(e)) => self.fits(p, e),
                (p, e) => p.is_none() && e.is_none(),
            },
            (Expr::Call(p), Expr::Call(e)) => {
                self.fits(&p.func, &e.func) && self.all_fit(&p.args, &e.args)
            }
            (Expr::MethodCall(p), Expr::MethodCall(e)) => {
                let same = p.method == e.method
                    && match (&p.turbofish, &e.turbofish) {
                        (Some(p), Some(e)) => self.same(p, e),
                        // A pattern need not say which.
                        (p, _) => p.is_none(),
                    };
                same && self.fits(&p.receiver, &e.receiver) && self.all_fit(&p.args, &e.args)
            }
            (Expr::If(p), Expr::If(e)) => {
                let otherwise = match (&p.else_branch, &e.else_branch) {
                    (Some((_, p)), Some((_, e))) => self.fits(p, e),
                    (p, e) => p.is_none() && e.is_none(),
                };
                otherwise
                    && self.fits(&p.cond, &e.cond)
                    && self.blocks_fit(&p.then_branch, &e.then_branch)
            }
            (Expr::Block(p), Expr::Block(e)) => self.blocks_fit(&p.block, &e.block),
            _ => self.same(pattern, expr),
        }
    }

    fn all_fit<T>(
        &mut self,
        patterns: &syn::punctuated::Punctuated<Expr, T>,
        exprs: &syn::punctuated::Punctuated<Expr, T>,
    ) -> bool {
        patterns.len() == exprs.len() && patterns.iter().zip(exprs).all(|(p, e)| self.fits(p, e))
    }

    /// Blocks of one expression.
    fn blocks_fit(&mut self, pattern: &Block, block: &Block) -> bool {
        match (&pattern.stmts[..], &block.stmts[..]) {
            ([Stmt::Expr(p, None)], [Stmt::Expr(e, None)]) => self.fits(p, e),
            _ => self.same(pattern, block),
        }
    }

    /// Whether two parts are spelled alike, but for blanks.
    fn same(&self, pattern: &impl Spanned, part: &impl Spanned) -> bool {
        let pattern = self.pattern[pattern.span().byte_range()].chars();
        let part = self.text[part.span().byte_range()].chars();
        pattern.filter(|c| !c.is_whitespace()).eq(part.filter(|c| !c.is_whitespace()))
    }
}
