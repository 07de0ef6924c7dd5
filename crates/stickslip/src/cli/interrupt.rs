//! Ctrl-C, SIGTERM and SIGHUP: of a run what was written so far goes and old results stay, a sweep ends with what is finished.

use std::process::exit;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};

use super::console::Console;
use super::failure::CommandError;
use crate::folder::{Abandoned, FolderError, FolderHandle, ResultFolder};

/// What shells report for a process that SIGINT ended, 128 + 2; also for the other signals, which the handler cannot distinguish.
pub(super) const INTERRUPTED: i32 = 130;

/// The folder that `create` makes, which an interrupt of the process deletes as long as it is not complete.
pub(super) fn guarded(
    console: Console,
    create: impl FnOnce() -> Result<ResultFolder, FolderError>,
) -> Result<ResultFolder, FolderError> {
    let slot: Arc<Mutex<Option<FolderHandle>>> = Arc::default();
    // An interrupt waits until it is known what there is to delete.
    let mut place = slot.lock().unwrap_or_else(PoisonError::into_inner);
    let seen = Arc::clone(&slot);
    // Without a handler an interrupt leaves the hidden folder, which does no harm.
    let _ = ctrlc::set_handler(move || {
        let slot = seen.lock().unwrap_or_else(PoisonError::into_inner);
        // While the lock is held, the run cannot fail on its deleted folder before this handler ends the process.
        let abandoned = slot.as_ref().map(FolderHandle::abandon);
        let reason = match &abandoned {
            Some(Abandoned::TooLate) => CommandError::InterruptedLate,
            Some(Abandoned::Deleted(_)) | None => CommandError::Interrupted,
        };
        console.fail(&reason.into());
        exit(INTERRUPTED);
    });
    let folder = create()?;
    *place = Some(folder.handle());
    drop(place);
    Ok(folder)
}

/// A flag that an interrupt of the process sets; a second one ends the process at once.
pub(super) fn flag() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    let set = Arc::clone(&flag);
    // Without a handler an interrupt ends the process, and rows that were written stay.
    let _ = ctrlc::set_handler(move || {
        if set.swap(true, Ordering::Relaxed) {
            exit(INTERRUPTED);
        }
    });
    flag
}
