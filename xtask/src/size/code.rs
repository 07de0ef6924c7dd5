//! Lines of code of one source text.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, LexError, Span, TokenStream, TokenTree};
use stickslip_tests::source::{self, is_punct};

/// What a source text holds.
#[derive(Debug, PartialEq)]
pub(super) struct Code {
    /// Lines on which a token of code stands.
    pub(super) lines: usize,
    /// Names of functions with their lines from `fn` to the closing brace, in the order in which they begin.
    pub(super) functions: Vec<(String, usize)>,
}

/// Counts the code of a source text.
///
/// # Errors
/// If the text is not made of Rust tokens.
pub(super) fn measure(text: &str) -> Result<Code, LexError> {
    let tokens = source::code(text)?;
    let mut occupied = BTreeSet::new();
    occupy(tokens.clone(), &mut occupied);
    let blank = |line: usize| {
        text.lines()
            .nth(line - 1)
            .is_none_or(|line| line.trim().is_empty())
    };
    // Only strings hold blank lines.
    occupied.retain(|&line| !blank(line));
    let mut functions = Vec::new();
    find_functions(tokens, &mut functions);
    Ok(Code {
        lines: occupied.len(),
        functions,
    })
}

/// Adds the lines of all tokens, from 1.
fn occupy(tokens: TokenStream, lines: &mut BTreeSet<usize>) {
    let mut add = |span: Span| lines.extend(span.start().line..=span.end().line);
    let mut groups = Vec::new();
    for tree in tokens {
        if let TokenTree::Group(group) = tree {
            add(group.span_open());
            add(group.span_close());
            groups.push(group.stream());
        } else {
            add(tree.span());
        }
    }
    for group in groups {
        occupy(group, lines);
    }
}

/// Adds the functions with a body: `fn`, a name, and the next braces before a semicolon.
fn find_functions(tokens: TokenStream, found: &mut Vec<(String, usize)>) {
    let mut begun: Option<(String, usize)> = None;
    let mut after_fn = None;
    for tree in tokens {
        match &tree {
            TokenTree::Ident(word) if word == "fn" => after_fn = Some(word.span().start().line),
            TokenTree::Ident(name) => {
                if let Some(line) = after_fn.take() {
                    begun = Some((name.to_string(), line));
                }
            }
            TokenTree::Group(group) => {
                after_fn = None;
                if group.delimiter() == Delimiter::Brace
                    && let Some((name, first)) = begun.take()
                {
                    found.push((name, group.span_close().end().line - first + 1));
                }
                find_functions(group.stream(), found);
            }
            other => {
                after_fn = None;
                if is_punct(other, ';') {
                    begun = None;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Code, measure};

    fn lines(text: &str) -> usize {
        measure(text).expect("tokens").lines
    }

    #[test]
    fn blank_lines_comments_and_documentation_do_not_count() {
        assert_eq!(
            lines("//! Module.\n\n/* a\n/* b */\n*/\nuse a::b;\n\n/// Doc.\nfn f() {\n  // c\n}\n"),
            3
        );
        assert_eq!(lines("fn f() {} // beside code\n"), 1);
        assert_eq!(lines("f(/* between */\n  1);"), 2);
    }

    #[test]
    fn strings_count_with_what_looks_like_comments_in_them() {
        assert_eq!(lines("const A: &str = \"\n// text\n\n/* text\n\";"), 4);
        assert_eq!(lines("const A: &str = r#\"\n\"//\"\n\"#;"), 3);
        assert_eq!(
            lines("const A: char = '\"'; // \"\nconst B: char = '\\'';"),
            2
        );
    }

    #[test]
    fn tests_do_not_count() {
        let text = "fn f() {}\n#[cfg(test)]\nmod tests {\n  fn g() {}\n}\nfn h() {}\n";
        let functions = vec![("f".to_owned(), 1), ("h".to_owned(), 1)];
        assert_eq!(
            measure(text).expect("tokens"),
            Code {
                lines: 2,
                functions
            }
        );
    }

    #[test]
    fn functions_are_measured_from_signature_to_brace() {
        let text = "trait T { fn declared(&self); fn given(&self) {\n\n} }\n\
                    impl T for fn(u8) -> u8 { fn declared(\n&self) where\nu8: Copy {\n let f: fn() = g; fn inner() {}\n } }";
        let functions = measure(text).expect("tokens").functions;
        let expected = [("given", 3), ("declared", 5), ("inner", 1)];
        assert_eq!(
            functions,
            expected.map(|(name, lines)| (name.to_owned(), lines))
        );
    }
}
