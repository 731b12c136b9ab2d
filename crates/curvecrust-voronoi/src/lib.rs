//! Delaunay triangulation and Voronoi diagram of point sets, on spade
