//! Condensed bodies that several cases share, kept as long as a case needs them.

use std::collections::HashMap;
use std::sync::{Arc, Mutex, MutexGuard, OnceLock, PoisonError};

use stickslip_fem_core::CondensedBody;

type Slot = OnceLock<Result<Arc<CondensedBody>, String>>;

#[derive(Debug, Default)]
struct Entry {
    /// Cases that still need it.
    uses: usize,
    slots: HashMap<Form, Arc<Slot>>,
}

/// What bodies of one key differ in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Form {
    pub(super) half: bool,
    /// Whether the compliance has a block for each edge.
    pub(super) in_blocks: bool,
}

/// Condensed bodies by key.
#[derive(Debug, Default)]
pub(super) struct Store {
    entries: Mutex<HashMap<String, Entry>>,
}

impl Store {
    /// A store for cases that use bodies with these keys, one key for each use.
    pub(super) fn for_uses<'a>(keys: impl Iterator<Item = &'a String>) -> Self {
        let mut entries: HashMap<String, Entry> = HashMap::new();
        for key in keys {
            entries.entry(key.clone()).or_default().uses += 1;
        }
        Self {
            entries: Mutex::new(entries),
        }
    }

    fn locked(&self) -> MutexGuard<'_, HashMap<String, Entry>> {
        // Counters and slots are changed in one step each, so a panic elsewhere leaves none half changed.
        self.entries.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// The condensed body, which the first caller makes with `condense` while others wait; and whether it was made now.
    ///
    /// # Errors
    /// What `condense` said, to all callers.
    pub(super) fn get(
        &self,
        key: &str,
        form: Form,
        condense: impl FnOnce() -> Result<CondensedBody, String>,
    ) -> (Result<Arc<CondensedBody>, String>, bool) {
        let slot = {
            let mut entries = self.locked();
            let entry = entries.entry(key.to_owned()).or_default();
            Arc::clone(entry.slots.entry(form).or_default())
        };
        let mut made = false;
        let body = slot.get_or_init(|| {
            made = true;
            condense().map(Arc::new)
        });
        (body.clone(), made)
    }

    /// A case is done with a body; the last one lets it go.
    pub(super) fn release(&self, key: &str) {
        let mut entries = self.locked();
        if let Some(entry) = entries.get_mut(key) {
            entry.uses = entry.uses.saturating_sub(1);
            if entry.uses == 0 {
                entries.remove(key);
            }
        }
    }

    #[cfg(test)]
    pub(super) fn is_empty(&self) -> bool {
        self.locked().is_empty()
    }
}
