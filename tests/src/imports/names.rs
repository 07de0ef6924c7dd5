//! From names to the files that define them.

use std::collections::BTreeMap;

use super::read::{Module, Place};

/// The most re-exports that a name passes on its way.
const DEPTH: usize = 16;

/// The names of all modules.
pub(super) struct Names {
    pub(super) modules: BTreeMap<Place, Module>,
}

impl Names {
    /// The module, and its file, that defines what `path` names in the module at `place`; `None` for a module, and for what is not of
    /// this crate.
    pub(super) fn definer(
        &self,
        place: &Place,
        path: &[String],
        depth: usize,
    ) -> Option<(&Place, &str)> {
        let (start, rest) = self.start(place, path)?;
        self.within(&start, rest, depth)
    }

    /// The module that `path` leads into, and its file, unless the module at `place` is a part of it.
    pub(super) fn subject(&self, place: &Place, path: &[String]) -> Option<(&Place, &str)> {
        let (mut subject, rest) = self.start(place, path)?;
        for next in rest.iter().take(rest.len().saturating_sub(1)) {
            if !self.modules.get(&subject)?.children.contains(next) {
                break;
            }
            subject.push(next.clone());
        }
        let (subject, module) = self.modules.get_key_value(&subject)?;
        (!place.starts_with(subject)).then_some((subject, module.file.as_str()))
    }

    /// The module where `path` starts, and the rest of it; `None` if it starts in another crate.
    fn start<'a>(&self, place: &Place, path: &'a [String]) -> Option<(Place, &'a [String])> {
        let (first, mut rest) = path.split_first()?;
        Some(match first.as_str() {
            "crate" => (Place::new(), rest),
            "self" => (place.clone(), rest),
            "super" => {
                let mut above = place.split_last()?.1;
                while rest.first().is_some_and(|next| next == "super") {
                    (above, rest) = (above.split_last()?.1, &rest[1..]);
                }
                (above.to_vec(), rest)
            }
            _ => {
                let module = self.modules.get(place)?;
                let known = module.children.contains(first) || module.bound.contains_key(first);
                known.then(|| (place.clone(), path))?
            }
        })
    }

    /// What defines the name that `path` leads to from the module at `place` downwards.
    fn within(&self, place: &Place, path: &[String], depth: usize) -> Option<(&Place, &str)> {
        let (place, module) = self.modules.get_key_value(place)?;
        let (first, rest) = path.split_first()?;
        if depth > DEPTH {
            return None;
        }
        if !rest.is_empty() && module.children.contains(first) {
            return self.within(&[place.as_slice(), &path[..1]].concat(), rest, depth);
        }
        if module.defined.contains(first) {
            return Some((place, &module.file));
        }
        for bound in module.bound.get(first).into_iter().flatten() {
            let target = [bound.as_slice(), rest].concat();
            if let Some(found) = self.definer(place, &target, depth + 1) {
                return Some(found);
            }
        }
        if module.children.contains(first) || module.bound.contains_key(first) {
            return None;
        }
        module.globs.iter().find_map(|glob| {
            let target = [glob.as_slice(), path].concat();
            self.definer(place, &target, depth + 1)
        })
    }
}
