//! Tests of operators as contact uses them.

mod contacts;
mod contract;
mod persson;
mod strip;
