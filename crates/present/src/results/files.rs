//! Files on their way to who writes them.

/// A file's name and bytes.
pub(super) type File = (String, Vec<u8>);

/// What a file, or a pattern of files, holds.
#[derive(Clone, Debug)]
pub(super) struct FileNote {
    pub(super) files: String,
    pub(super) what: String,
}

impl FileNote {
    pub(super) fn new(files: impl Into<String>, what: impl Into<String>) -> Self {
        Self {
            files: files.into(),
            what: what.into(),
        }
    }
}
