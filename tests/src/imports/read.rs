//! The names that the modules of a crate define, bring in and use.

use std::collections::{BTreeMap, BTreeSet};

use proc_macro2::{Delimiter, TokenStream, TokenTree};

use crate::source::is_punct;

/// Segments of a path from the crate's root.
pub(super) type Place = Vec<String>;

/// What a module holds as far as names are concerned.
#[derive(Debug, Default)]
pub(super) struct Module {
    pub(super) file: String,
    pub(super) defined: BTreeSet<String>,
    pub(super) children: BTreeSet<String>,
    /// Names that `use` brings in, and what they stand for, as written.
    pub(super) bound: BTreeMap<String, Vec<Place>>,
    pub(super) globs: Vec<Place>,
    /// Paths in the code, as written.
    pub(super) named: BTreeSet<Place>,
}

/// Reads the modules of a file whose own module is at `place`.
pub(super) fn read(
    file: &str,
    tokens: TokenStream,
    place: &Place,
    modules: &mut BTreeMap<Place, Module>,
) {
    Reader { file, modules }.module(tokens, place);
}

/// Reads modules from tokens.
struct Reader<'a> {
    file: &'a str,
    modules: &'a mut BTreeMap<Place, Module>,
}

impl Reader<'_> {
    fn module(&mut self, tokens: TokenStream, place: &Place) {
        let module = self.modules.entry(place.clone()).or_default();
        self.file.clone_into(&mut module.file);
        self.read(tokens, place, true);
    }

    /// Reads the code of the module at `place`; only at its `top` it declares names.
    fn read(&mut self, tokens: TokenStream, place: &Place, top: bool) {
        let trees: Vec<TokenTree> = tokens.into_iter().collect();
        let word = |index: usize| match trees.get(index) {
            Some(TokenTree::Ident(word)) => Some(word.to_string()),
            _ => None,
        };
        let mut next = 0;
        while next < trees.len() {
            let here = next;
            next += 1;
            match word(here).as_deref() {
                Some("use") => {
                    next = (here..trees.len())
                        .find(|&i| is_punct(&trees[i], ';'))
                        .unwrap_or(trees.len());
                    let shared = here > 0
                        && (word(here - 1).as_deref() == Some("pub")
                            || is_visibility(&trees[here - 1]));
                    self.used(&trees[here + 1..next], place, shared, top);
                }
                Some("mod") if word(here + 1).is_some() => {
                    let name = word(here + 1).unwrap_or_default();
                    self.at(place).children.insert(name.clone());
                    if let Some(TokenTree::Group(group)) = trees.get(here + 2) {
                        self.module(group.stream(), &[place.clone(), vec![name]].concat());
                        next = here + 3;
                    }
                }
                Some(
                    "struct" | "enum" | "union" | "trait" | "type" | "fn" | "const" | "static",
                ) if top => {
                    let name = word(here + 1).filter(|name| name != "fn" && name != "unsafe");
                    self.at(place).defined.extend(name);
                }
                Some("macro_rules") if top => {
                    self.at(place).defined.extend(word(here + 2));
                }
                // A name by itself is known by the `use` that brought it in.
                Some(_) => {
                    let begins =
                        here < 2 || !trees[here - 2..here].iter().all(|tree| is_punct(tree, ':'));
                    let path = path_at(&trees, here);
                    if begins && path.len() > 1 {
                        next = here + 3 * path.len() - 2;
                        self.at(place).named.insert(path);
                    }
                }
                None => {
                    if let TokenTree::Group(group) = &trees[here] {
                        self.read(group.stream(), place, false);
                    }
                }
            }
        }
    }

    fn at(&mut self, place: &Place) -> &mut Module {
        self.modules.entry(place.clone()).or_default()
    }

    /// Records the names of a `use` declaration.
    fn used(&mut self, tree: &[TokenTree], place: &Place, shared: bool, top: bool) {
        let mut leaves = Vec::new();
        leaves_of(tree, &[], &mut leaves);
        let module = self.at(place);
        for (path, name) in leaves {
            if name == "*" {
                module.globs.push(path.clone());
            } else if top {
                module.bound.entry(name).or_default().push(path.clone());
            }
            if !shared {
                module.named.insert(path);
            }
        }
    }
}

/// The paths that a tree of `use` names, each with the name that it gets here.
fn leaves_of(tree: &[TokenTree], before: &[String], leaves: &mut Vec<(Place, String)>) {
    let mut path = before.to_vec();
    let mut name = None;
    let mut renamed = false;
    for tree in tree {
        match tree {
            TokenTree::Ident(word) if word == "as" => renamed = true,
            TokenTree::Ident(word) if renamed => name = Some(word.to_string()),
            TokenTree::Ident(word) if word == "self" && !path.is_empty() => {}
            TokenTree::Ident(word) => path.push(word.to_string()),
            TokenTree::Punct(punct) if punct.as_char() == '*' => name = Some("*".to_owned()),
            TokenTree::Group(group) if group.delimiter() == Delimiter::Brace => {
                let inner: Vec<TokenTree> = group.stream().into_iter().collect();
                for part in inner
                    .split(|tree| is_punct(tree, ','))
                    .filter(|part| !part.is_empty())
                {
                    leaves_of(part, &path, leaves);
                }
                return;
            }
            _ => {}
        }
    }
    let last = path.last().cloned().unwrap_or_default();
    leaves.push((path, name.unwrap_or(last)));
}

/// The words joined by `::` from a token on.
fn path_at(trees: &[TokenTree], first: usize) -> Place {
    let mut path = Vec::new();
    let mut index = first;
    while let Some(TokenTree::Ident(word)) = trees.get(index) {
        path.push(word.to_string());
        let joined = [index + 1, index + 2]
            .iter()
            .all(|&i| trees.get(i).is_some_and(|tree| is_punct(tree, ':')));
        if !joined {
            break;
        }
        index += 3;
    }
    path
}

/// Whether a token is what follows `pub` in `pub(crate)`.
fn is_visibility(tree: &TokenTree) -> bool {
    matches!(tree, TokenTree::Group(group) if group.delimiter() == Delimiter::Parenthesis)
}
