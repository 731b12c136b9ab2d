//! Medial axis, local feature size and reach of smooth plane curves
