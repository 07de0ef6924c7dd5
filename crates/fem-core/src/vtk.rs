//! vtk.
