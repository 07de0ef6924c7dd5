//! Result folders: whole or not at all, and nothing of others is deleted.

mod ownership;
mod whole;
