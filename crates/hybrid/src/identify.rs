//! Friction from edge tractions and from displacements, with intervals.
