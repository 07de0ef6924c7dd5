//! Files, figures, page and tables from made-up results of a pin-loaded plate and of a line contact.

mod files;
mod findings;
mod fixture;
mod page;
mod summary;
mod terminal;
