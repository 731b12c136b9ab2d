//! Curve reconstruction with many fewer samples: medial axis, lfs, sampling, HNN-Crust, evaluation
