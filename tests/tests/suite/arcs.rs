//! Stresses inside the plate carry the load through every circle around the hole.
