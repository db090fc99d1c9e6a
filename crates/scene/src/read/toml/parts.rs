//! A TOML text cut into parts that can be parsed one by one.
//!
//! The first part holds what must be seen together: the keys before the first header, the settings,
//! and the first table of each kind that may occur many times (`[[lights]]`, `[materials.x]`,
//! `[[spheres]]`, `[[planes]]`). There the parser refuses whatever may not stand beside a table of
//! that kind. Further tables, in their order, make the other parts. A list written inline
//! (`spheres = [{...}, ...]`) is cut between its entries; the first part then holds the empty list.
//! Two materials of one name in different parts are left for the reader to find.
//!
//! Cuts are made at tokens that end a statement or an entry in every text that is valid so far.
//! Thus a fault of the text is a fault of one of its parts, at the same place.

use std::borrow::Cow;
use std::iter::Peekable;
use std::ops::Range;

use toml_parser::Source;
use toml_parser::lexer::{Lexer, Token, TokenKind};

use super::super::Problem;
use super::super::draft::{List, MATERIALS};
use super::super::memory::Memory;

/// Bytes after which a part is full; it may be longer by one table or entry. A shorter text is not
/// cut.
const PART: usize = 1 << 14;

/// Most bytes that the parser takes for a token: the token and the parser's event for it, both in
/// lists that double as they grow, and a value.
const TOKEN_BYTES: u64 = 320;

/// Most bytes that the parser takes for a table: a tree node with room for eleven entries, once in
/// the parser's table and once in the values made from it.
const TABLE_BYTES: u64 = 3200;

/// A part of a text: pieces of it, one after another.
#[derive(Default)]
pub(super) struct Part {
    pieces: Vec<Range<usize>>,
    /// The list whose entries the pieces are; `None` if they are statements.
    inline: Option<List>,
    tokens: u64,
    tables: u64,
}

impl Part {
    /// Most bytes that parsing the part takes.
    pub(super) fn cost(&self) -> u64 {
        2 * self.len() as u64 + self.tokens * TOKEN_BYTES + self.tables * TABLE_BYTES
    }

    fn len(&self) -> usize {
        self.pieces.iter().map(Range::len).sum()
    }

    /// Text in front of the pieces: the key and bracket of a list that was cut.
    fn before(&self) -> String {
        self.inline.map_or_else(String::new, |list| format!("{} = [", list.key()))
    }

    /// The part as a TOML text.
    pub(super) fn text<'t>(&self, text: &'t str) -> Cow<'t, str> {
        match (self.pieces.as_slice(), self.inline) {
            ([], _) => "".into(),
            ([piece], None) => text[piece.clone()].into(),
            (pieces, _) => {
                let mut own = self.before();
                own.extend(pieces.iter().map(|piece| &text[piece.clone()]));
                if self.inline.is_some() {
                    own.push(']');
                }
                own.into()
            }
        }
    }

    /// Turns a span of this part's text into the span of the whole text.
    pub(super) fn place(&self, span: Range<usize>) -> Range<usize> {
        let before = self.before().len();
        let (start, end) = (span.start.saturating_sub(before), span.end.saturating_sub(before));
        let start = self.byte(start);
        // The end of one piece is not the start of the next.
        let end = end.checked_sub(1).map_or(start, |last| self.byte(last) + 1);
        start..end.max(start)
    }

    fn byte(&self, mut byte: usize) -> usize {
        for piece in &self.pieces {
            if byte < piece.len() {
                return piece.start + byte;
            }
            byte -= piece.len();
        }
        self.pieces.last().map_or(0, |last| last.end)
    }

    fn add(&mut self, piece: Range<usize>, cost: Cost) {
        self.tokens += cost.tokens;
        self.tables += cost.tables;
        match self.pieces.last_mut() {
            Some(last) if last.end == piece.start => last.end = piece.end,
            _ => self.pieces.push(piece),
        }
    }
}

/// What the parser makes from some tokens, for counting its memory.
#[derive(Clone, Copy, Default)]
struct Cost {
    tokens: u64,
    tables: u64,
}

/// Cuts a text. The first part comes first.
///
/// # Errors
/// There is no memory for the parts.
pub(super) fn parts(text: &str, memory: &Memory) -> Result<Vec<Part>, Problem> {
    let mut cutter = Cutter {
        source: Source::new(text),
        tokens: Source::new(text).lex().peekable(),
        whole: text.len() <= PART,
        at: 0,
        cost: Cost::default(),
        parts: vec![Part::default()],
        to_first: true,
        seen: Vec::new(),
    };
    // This is the most that the list of parts takes.
    memory.for_a_moment((text.len() / PART * 4 * size_of::<Part>()) as u64)?;
    cutter.statements();
    Ok(cutter.parts)
}

struct Cutter<'t> {
    source: Source<'t>,
    tokens: Peekable<Lexer<'t>>,
    /// Whether nothing is cut.
    whole: bool,
    /// End of the text that was put in a part.
    at: usize,
    /// Cost of the tokens read since then.
    cost: Cost,
    parts: Vec<Part>,
    /// Whether statements go to the first part rather than the last.
    to_first: bool,
    /// Kinds of tables that the first part has one of.
    seen: Vec<&'static str>,
}

impl Cutter<'_> {
    fn statements(&mut self) {
        let mut root = true;
        while let Some(kind) = self.peek() {
            match kind {
                TokenKind::Whitespace | TokenKind::Newline | TokenKind::Comment => {
                    self.next();
                }
                TokenKind::LeftSquareBracket => {
                    root = false;
                    self.header();
                }
                _ if root && !self.whole => self.key_value_of_root(),
                _ => self.rest_of_statement(),
            }
        }
        self.put(self.source.input().len());
    }

    /// The next token's kind, if there is one.
    fn peek(&mut self) -> Option<TokenKind> {
        self.tokens.peek().map(Token::kind).filter(|kind| *kind != TokenKind::Eof)
    }

    /// Takes the next token.
    fn next(&mut self) -> Option<Token> {
        let token = self.tokens.next().filter(|token| token.kind() != TokenKind::Eof)?;
        self.cost.tokens += 1;
        // A dotted key makes a table for each of its dots; a dot in a number is taken for one.
        let table = matches!(token.kind(), TokenKind::LeftCurlyBracket | TokenKind::Dot);
        self.cost.tables += u64::from(table);
        Some(token)
    }

    /// Puts the text up to a byte in the part whose turn it is.
    fn put(&mut self, end: usize) {
        let piece = self.at..end;
        self.at = end;
        let cost = std::mem::take(&mut self.cost);
        if !piece.is_empty() {
            let part = if self.to_first { 0 } else { self.parts.len() - 1 };
            self.parts[part].add(piece, cost);
        }
    }

    /// Reads a header's line, which decides where the statements below it go.
    fn header(&mut self) {
        let before = std::mem::take(&mut self.cost);
        let start = self.tokens.peek().map_or(0, |token| token.span().start());
        self.next();
        let double = self.peek() == Some(TokenKind::LeftSquareBracket);
        let mut keys: Vec<String> = Vec::new();
        while let Some(token) = self.next() {
            match token.kind() {
                TokenKind::Newline => break,
                TokenKind::Atom | TokenKind::BasicString | TokenKind::LiteralString
                    if keys.len() < 3 =>
                {
                    keys.push(self.key(token));
                }
                _ => {}
            }
        }
        self.cost.tables += 1;
        let own = std::mem::replace(&mut self.cost, before);
        self.put(start);
        self.cost = own;
        self.choose_part(&keys, double);
    }

    fn choose_part(&mut self, keys: &[String], double: bool) {
        let first = keys.first().map_or("", String::as_str);
        let kind = match List::of_key(first) {
            Some(list) => Some(list.key()),
            None => (first == MATERIALS && keys.len() > 1).then_some(MATERIALS),
        };
        let Some(kind) = kind.filter(|_| !self.whole) else {
            self.to_first = true;
            return;
        };
        let exact = match kind {
            MATERIALS => !double && keys.len() == 2,
            _ => double && keys.len() == 1,
        };
        // A subtable, `[spheres.x]` say, stays with the table before it.
        if exact && !self.seen.contains(&kind) {
            self.seen.push(kind);
            self.to_first = true;
        } else if exact {
            self.to_first = false;
            let full = |part: &Part| part.inline.is_some() || part.len() >= PART;
            if self.parts.len() == 1 || self.parts.last().is_some_and(full) {
                self.parts.push(Part::default());
            }
        }
    }

    /// Decodes a key.
    fn key(&self, token: Token) -> String {
        let mut key = String::new();
        if let Some(raw) = self.source.get(token) {
            raw.decode_key(&mut key, &mut ());
        }
        key
    }

    /// Reads a key and its value before the first header; a list is cut.
    fn key_value_of_root(&mut self) {
        let list = match self.next() {
            Some(token) if token.kind() == TokenKind::Atom => List::of_key(&self.key(token)),
            _ => None,
        };
        let mut next = self.next_but_blank();
        if list.is_some() && next == Some(TokenKind::Equals) {
            self.next();
            next = self.next_but_blank();
        }
        match list {
            Some(list) if next == Some(TokenKind::LeftSquareBracket) => {
                self.next();
                self.entries(list);
            }
            _ => {}
        }
        self.rest_of_statement();
    }

    fn next_but_blank(&mut self) -> Option<TokenKind> {
        while self.peek() == Some(TokenKind::Whitespace) {
            self.next();
        }
        self.peek()
    }

    /// Cuts the entries of a list written inline, up to the bracket that ends it.
    fn entries(&mut self, list: List) {
        // The list may turn out to have no end. Everything then goes to the first part after all,
        // whose parser reports it, so the present state is kept.
        let (first, cost_of_first) = (self.at, self.cost);
        let opened = self.tokens.peek().map_or(0, |token| token.span().start());
        let (cut_from, mut start) = (self.parts.len(), opened);
        self.cost = Cost::default();
        let mut whole = Cost::default();
        let mut depth = 0_u32;
        while let Some(kind) = self.peek() {
            // The end: the first part gets the key and the two brackets, without the entries.
            if kind == TokenKind::RightSquareBracket && depth == 0 {
                let end = self.tokens.peek().map_or(0, |token| token.span().start());
                self.cut(list, start..end);
                self.cost = cost_of_first;
                self.at = first;
                self.put(opened);
                self.at = end;
                return;
            }
            // Only a comma between entries may be cut at, not one inside an entry.
            let Some(token) = self.next() else { break };
            match kind {
                TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => depth += 1,
                TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => {
                    depth = depth.saturating_sub(1);
                }
                TokenKind::Comma if depth == 0 && token.span().end() - start >= PART => {
                    whole.tokens += self.cost.tokens;
                    whole.tables += self.cost.tables;
                    self.cut(list, start..token.span().end());
                    start = token.span().end();
                }
                _ => {}
            }
        }
        // No end was found: take the cuts back.
        self.parts.truncate(cut_from);
        self.cost.tokens += whole.tokens + cost_of_first.tokens;
        self.cost.tables += whole.tables + cost_of_first.tables;
    }

    fn cut(&mut self, list: List, piece: Range<usize>) {
        let mut part = Part { inline: Some(list), ..Part::default() };
        part.add(piece, std::mem::take(&mut self.cost));
        self.parts.push(part);
    }

    /// Skips the tokens up to the line break that ends a statement.
    fn rest_of_statement(&mut self) {
        let mut depth = 0_u32;
        while let Some(token) = self.next() {
            match token.kind() {
                TokenKind::LeftSquareBracket | TokenKind::LeftCurlyBracket => depth += 1,
                TokenKind::RightSquareBracket | TokenKind::RightCurlyBracket => {
                    depth = depth.saturating_sub(1);
                }
                TokenKind::Newline if depth == 0 => break,
                _ => {}
            }
        }
    }
}
