//! laminate.
