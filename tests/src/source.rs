//! Rust sources as tokens, for checks that read the code of this workspace.

use std::fs;
use std::io;
use std::iter::Peekable;
use std::path::{Path, PathBuf};
use std::vec::IntoIter;

use proc_macro2::{Delimiter, Group, LexError, TokenStream, TokenTree};

/// Lists the Rust files below `folder` in the order of their paths, without tests: folders named `tests` and files named `tests.rs`.
///
/// # Errors
/// If a folder cannot be read.
pub fn files(folder: &Path) -> io::Result<Vec<PathBuf>> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.file_stem().is_some_and(|stem| stem == "tests") {
            continue;
        }
        if path.is_dir() {
            found.extend(files(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    found.sort();
    Ok(found)
}

/// Reads the tokens of a source text without its tests (items under `#[cfg(test)]` or `#[test]`) and without documentation.
///
/// The tokens keep their lines; comments are no tokens.
///
/// # Errors
/// If the text is not made of Rust tokens.
pub fn code(text: &str) -> Result<TokenStream, LexError> {
    Ok(without_tests(text.parse()?))
}

fn without_tests(tokens: TokenStream) -> TokenStream {
    let trees: Vec<TokenTree> = tokens.into_iter().collect();
    let mut trees = trees.into_iter().peekable();
    let mut kept = Vec::new();
    while let Some(tree) = trees.next() {
        if is_punct(&tree, '#') {
            let inner = trees.next_if(|next| is_punct(next, '!'));
            if let Some(attribute) = trees.next_if(|next| attribute(next).is_some()) {
                match self::attribute(&attribute) {
                    Some(Attribute::Documentation) => {}
                    Some(Attribute::Test) if inner.is_some() => return TokenStream::new(),
                    Some(Attribute::Test) => skip_item(&mut trees),
                    _ => {
                        kept.push(tree);
                        kept.extend(inner);
                        kept.push(inside(attribute));
                    }
                }
                continue;
            }
            kept.push(tree);
            kept.extend(inner);
        } else {
            kept.push(inside(tree));
        }
    }
    kept.into_iter().collect()
}

/// A group without the tests in it; any other token as it is.
fn inside(tree: TokenTree) -> TokenTree {
    let TokenTree::Group(group) = tree else {
        return tree;
    };
    let mut kept = Group::new(group.delimiter(), without_tests(group.stream()));
    kept.set_span(group.span());
    kept.into()
}

enum Attribute {
    Documentation,
    Test,
    Other,
}

/// What stands in the brackets of an attribute; `None` if the token is no bracket.
fn attribute(tree: &TokenTree) -> Option<Attribute> {
    let TokenTree::Group(group) = tree else {
        return None;
    };
    if group.delimiter() != Delimiter::Bracket {
        return None;
    }
    let mut content = group.stream().into_iter();
    let name = content.next().map(|tree| tree.to_string());
    let argument = content.next().map(|tree| tree.to_string());
    Some(match (name.as_deref(), argument.as_deref()) {
        (Some("doc"), _) => Attribute::Documentation,
        (Some("test"), None) | (Some("cfg"), Some("(test)")) => Attribute::Test,
        _ => Attribute::Other,
    })
}

/// Skips to the end of an item (its semicolon or its braces), statement, field or variant.
fn skip_item(trees: &mut Peekable<IntoIter<TokenTree>>) {
    let mut ends_in_semicolon = None;
    while let Some(tree) = trees.next() {
        if let (TokenTree::Ident(word), None) = (&tree, ends_in_semicolon) {
            let next = trees.peek().map(ToString::to_string).unwrap_or_default();
            ends_in_semicolon = match word.to_string().as_str() {
                "use" | "static" | "type" | "let" => Some(true),
                "const" => Some(!["fn", "unsafe", "async", "extern"].contains(&next.as_str())),
                "fn" | "mod" | "impl" | "struct" | "enum" | "trait" | "macro_rules" => Some(false),
                _ => None,
            };
        }
        let ended = match ends_in_semicolon {
            Some(true) => is_punct(&tree, ';'),
            Some(false) => is_punct(&tree, ';') || is_braced(&tree),
            None => is_punct(&tree, ','),
        };
        if ended {
            return;
        }
    }
}

fn is_braced(tree: &TokenTree) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Brace)
}

/// Whether a token is the sign `sign`.
pub fn is_punct(tree: &TokenTree, sign: char) -> bool {
    matches!(tree, TokenTree::Punct(punct) if punct.as_char() == sign)
}

#[cfg(test)]
mod tests {
    use super::code;

    fn words(text: &str) -> String {
        code(text).expect("tokens").to_string()
    }

    #[test]
    fn comments_and_documentation_are_left_out() {
        let text = "//! Module.\n/* a /* nested */ one */\n/// Item.\n#[doc = \"x\"]\nfn f() { /* b */ g(\"// c\") }";
        assert_eq!(words(text), words("fn f() { g(\"// c\") }"));
    }

    #[test]
    fn tests_are_left_out_and_what_follows_is_kept() {
        for test in [
            "#[cfg(test)] mod tests { fn f() {} }",
            "#[cfg(test)] mod tests;",
            "#[cfg(test)] use a::{b, c};",
            "#[cfg(test)] #[inline] pub(super) fn f<const N: usize>() -> [u8; N] { [0; N] }",
            "#[cfg(test)] const A: B = B { c: 1 };",
            "#[cfg(test)] pub const fn f() {}",
            "#[test] fn f() {}",
        ] {
            let kept = "fn g() {} ";
            assert_eq!(words(&format!("{test} {kept}")), words(kept), "{test}");
        }
        assert_eq!(
            words("fn g() { #[cfg(test)] let a = B { c: 1 }; d() }"),
            words("fn g() { d() }")
        );
        assert_eq!(
            words("struct S { #[cfg(test)] a: B<C>, d: E }"),
            words("struct S { d: E }")
        );
        assert_eq!(words("#![cfg(test)] fn f() {}"), "");
        assert_eq!(
            words("#[cfg(unix)] fn f() {}"),
            words("#[cfg(unix)]fn f(){}")
        );
    }
}
