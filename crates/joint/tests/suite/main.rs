//! Joints whose answers are known: linear ones, uniform ones, and small plates around a pin.

mod linear;
mod models;
mod patch;
mod plate;
