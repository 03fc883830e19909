/// The method that meshes where nobody names one.

#include "morskin/method.h"

#include "morskin/pipeline.h"
#include "tests/support/meshes.h"
#include "tests/support/rna_balls.h"

using namespace morskin;
using namespace morskin::support;

namespace {

certify::Sizing limited(double C, double largest_length_scale) {
  certify::Sizing sizing = sizing_for(C);
  sizing.largest_length_scale = largest_length_scale;
  return sizing;
}

}  // namespace

TEST_CASE("coarse meshes are static unless a limit is far below the radii or balls are many") {
  const WeightedPoints balls(50'000, ball(0, 0, 0, 2));
  CHECK(usual_method(balls, sizing_for(0.25)) == Method::Sweep);
  CHECK(usual_method(balls, sizing_for(0.26)) == Method::Static);
  CHECK(usual_method(balls, limited(0.4, 0.45)) == Method::Sweep);
  CHECK(usual_method(balls, limited(0.4, 0.55)) == Method::Static);
  const WeightedPoints more(50'001, ball(0, 0, 0, 2));
  CHECK(usual_method(more, sizing_for(0.4)) == Method::Sweep);
}

TEST_CASE("what asks for a part of the sweep is swept, and a method asked for is taken") {
  const PreparedSkin skin = prepare_skin({ball(0, 0, 0, 2)});
  const certify::Sizing coarse = sizing_for(0.4);
  CHECK(method_of(skin, {.sizing = coarse}) == Method::Static);
  CHECK(method_of(skin, {.sizing = coarse, .method = Method::Sweep}) == Method::Sweep);
  CHECK(method_of(skin, {.sizing = {}, .method = Method::Static}) == Method::Static);
  CHECK(method_of(skin, {.sizing = coarse, .fronts = 1}) == Method::Sweep);
  CHECK(method_of(skin, {.sizing = coarse, .fronts = 8}) == Method::Sweep);
  CHECK(method_of(skin, {.sizing = coarse, .guard = front::Guard::Spheres}) == Method::Sweep);
}

TEST_CASE("a result names the method that made it") {
  const PreparedSkin skin = prepare_skin(molecule("benzene.pdb", skin::Model::Vdw));
  CHECK(make_mesh(skin, {.sizing = {}}).method == Method::Sweep);
  const MeshResult coarse = make_mesh(skin, {.sizing = sizing_for(0.4)});
  CHECK(coarse.method == Method::Static);
  CHECK_MESSAGE(coarse.certificate.certified, coarse.certificate.reason);
}

namespace {

/// Meshes with C = 0.4 and the limit that a length stands for, which the static method gets as it
/// is.
/// @return the seconds that thinned meshes took to be made finer in places
double thickening_seconds(const PreparedSkin& skin, double edge_length, Method method) {
  MeshingOptions options{.sizing = sizing_for(0.4), .method = method};
  options.sizing.set_edge_length(edge_length);
  double& limit = options.sizing.largest_length_scale;
  if (method == Method::Static) limit *= limit / options.sizing.sampled().largest_length_scale;
  const geometry::Run run;
  const MeshResult made = make_mesh(skin, options, run);
  CHECK_MESSAGE(made.certificate.certified, made.certificate.reason);
  CHECK(made.certificate.min_angle_deg >= 30);
  CHECK(run.seconds("refine angles in space") == 0);
  return run.seconds("thicken");
}

}  // namespace

TEST_CASE("what thinning left too coarse for 30 degrees is made finer there, not all over") {
  struct Case {
    unsigned seed;
    double edge_length;
    Method method;
  };
  double seconds = 0;
  for (const Case& each :
       {Case{24, 0.4, Method::Static}, {151, 0.5, Method::Sweep}, {384, 0.8, Method::Sweep}}) {
    CAPTURE(each.seed);
    const auto skin = prepared(ball_set(each.seed));
    REQUIRE(skin);
    seconds += thickening_seconds(*skin, each.edge_length, each.method);
  }
  CHECK(seconds > 0);  // else this tries nothing: other seeds are needed
}

TEST_CASE("a thinned mesh is made finer from where it was, not from where raising angles failed") {
  const PreparedSkin skin = prepare_skin(rna_balls());
  double seconds = 0;
  for (const double edge_length : rna_edge_lengths) {
    seconds += thickening_seconds(skin, edge_length, Method::Static);
  }
  CHECK(seconds > 0);  // else this tries nothing
}
