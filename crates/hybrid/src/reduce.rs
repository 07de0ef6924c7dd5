//! Displacements of nodes from measured ones, with their covariance.
