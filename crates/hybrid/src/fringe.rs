//! Fringe pictures: synthesis, phase, unwrapping, carrier.
