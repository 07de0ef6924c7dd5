//! Joints whose answers are known: linear ones, uniform ones, and small plates around a pin.

mod crack_band;
mod discount;
mod errors;
mod linear;
mod mode;
mod models;
mod patch;
mod pins;
mod plasticity;
mod plate;
mod severed;
