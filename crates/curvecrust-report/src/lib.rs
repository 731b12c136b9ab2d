//! Tables and figures of curve reconstruction experiments
