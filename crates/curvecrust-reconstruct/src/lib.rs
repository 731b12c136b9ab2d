//! Curve reconstruction from bare points: HNN-Crust, NN-Crust, Crust and their relatives

pub mod neighbours;
