//! Evaluates curve reconstructions: edges against the truth, Hausdorff distance
