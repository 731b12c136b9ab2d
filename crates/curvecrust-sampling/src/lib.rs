//! Epsilon- and reach-based rho-sampling of smooth plane curves
