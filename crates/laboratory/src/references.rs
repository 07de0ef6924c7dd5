//! Closed forms and tables that results are compared with.

pub mod aluminium;
pub mod line_contact;
pub mod loaded_hole;
pub mod persson;
pub mod rigid_pin;
