#pragma once

// The names of other modules that refinement uses.

#include "certify/ball_pencil.h"
#include "certify/delaunay_filter.h"
#include "certify/sizing.h"
#include "certify/triangle_geometry.h"
#include "certify/tube.h"
#include "geometry/subdomain.h"
#include "surface/mesh.h"
#include "surface/surface.h"

namespace morskin::refine {

using certify::Circumcircle;
using certify::circumcircle;
using certify::DelaunayFilter;
using certify::Depth;
using certify::exact_surface_ball;
using certify::expects_tube;
using certify::is_certainly_delaunay;
using certify::is_upright;
using certify::LazySurfaceBall;
using certify::Sizing;
using certify::smallest_squared_sine;
using certify::SurfaceBall;
using certify::triangle_under;
using certify::TriangleSides;
using geometry::HalfEdgeId;
using geometry::Subdomain;
using geometry::SurfaceMesh;
using geometry::TriangleId;
using geometry::VertexId;
using surface::Mesh;
using surface::Point;
using surface::SurfacePoint;
using surface::Vector;

}  // namespace morskin::refine
