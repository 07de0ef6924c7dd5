//! Gratings: frequency, fringe orders, displacements, strains.
