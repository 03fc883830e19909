#include "app/figures/figures.h"

#include <doctest/doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>

#include "app/figures/bundled.h"
#include "app/figures/free_form.h"
#include "app/figures/sweep_events.h"
#include "app/pictures/png.h"
#include "tests/support/png_reading.h"

using namespace morskin;

namespace {

// Made by `morskin figure N --scale 0.25`.
constexpr double golden_scale = 0.25;

std::string file_text(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

// Other compilers and libraries round otherwise, so a few pixels at rims may differ and the rest by
// a level or so; a line that is missing, a thing that stands elsewhere, a light that is out shows.
void check_against_golden(std::string_view name) {
  CAPTURE(name);
  constexpr double largest_mean = 1.0, largest_share = 0.004;
  constexpr int level = 24;  // of 255: a difference that the eye sees
  const std::string drawn = pictures::png(figures::find_figure(name)->draw(golden_scale));
  const auto picture = support::read_png(drawn);
  const auto golden =
      support::read_png(file_text("tests/golden/figure-" + std::string(name) + ".png"));
  REQUIRE(picture);
  REQUIRE(golden);
  REQUIRE(picture->width == golden->width);
  REQUIRE(picture->height == golden->height);
  double sum = 0, seen = 0;
  for (std::size_t i = 0; i < picture->bytes.size(); ++i) {
    const int difference = std::abs(picture->bytes[i] - golden->bytes[i]);
    sum += difference;
    seen += difference > level;
  }
  const auto count = static_cast<double>(picture->bytes.size());
  CHECK(sum / count < largest_mean);
  CHECK(seen / count < largest_share);
}

}  // namespace

TEST_CASE("the figures of critical points and operations are as they were approved") {
  for (const char* name : {"2", "4", "5", "6", "7", "8", "9", "10a"}) check_against_golden(name);
}

TEST_CASE("every figure has a name of its own, and is found by it") {
  for (const figures::Figure& figure : figures::all_figures()) {
    CHECK(figures::find_figure(figure.name) == &figure);
  }
  CHECK(figures::find_figure("3") == nullptr);
}

TEST_CASE("a figure drawn twice has the same bytes") {
  const figures::Figure& figure = *figures::find_figure("8");
  CHECK(pictures::png(figure.draw(0.2)) == pictures::png(figure.draw(0.2)));
}

TEST_CASE("a recorded sweep tells of every operation and leaves out no triangle") {
  const front::PreparedSkin skin = figures::bundled_skin("cube8.xyzr", skin::Model::Paper, 0);
  const figures::RecordedSweep sweep = figures::recorded_sweep(skin, 0.08);
  const front::SweepResult plain = front::sweep_once(skin.surface, sweep.guide);
  std::size_t triangles = 0;
  std::array<std::size_t, 5> counts{};
  for (const figures::Event& event : sweep.events) {
    CHECK(event.before == triangles);
    CHECK(event.after > event.before);
    if (event.operation == front::Operation::Creation) CHECK(event.after - event.before == 6);
    if (event.operation == front::Operation::Wing) CHECK(event.after - event.before == 1);
    triangles = event.after;
    ++counts[static_cast<std::size_t>(event.operation)];
  }
  CHECK(triangles == sweep.mesh.surface.triangle_count());
  CHECK(sweep.mesh.surface.triangle_list() == plain.mesh.surface.triangle_list());
  const front::Operations& o = plain.operations;
  CHECK(counts == std::array{o.creation, o.creep, o.wing, o.bridge, o.seal});
}

TEST_CASE("inner polar balls are empty of samples and lie inside the head") {
  const std::vector<figures::Point> samples =
      figures::samples_of(figures::head_function, figures::Point(-1.1, -2.2, -1.4),
                          figures::Point(1.1, 1.4, 1.4), 0.13);
  REQUIRE(samples.size() > 500);
  for (const figures::Point& p : samples) CHECK(std::abs(figures::head_function(p)) < 1e-6);
  const auto balls = figures::inner_polar_balls(samples, figures::head_function);
  REQUIRE(balls.size() > 300);
  for (const geometry::WeightedPoint& ball : balls) {
    CHECK(figures::head_function(ball.position) < 0);
    const double radius = std::sqrt(ball.weight / 2);
    double nearest = INFINITY;
    for (const figures::Point& p : samples) {
      nearest = std::min(nearest, (p - ball.position).norm());
    }
    CHECK(nearest == doctest::Approx(radius).epsilon(1e-6));
  }
}

TEST_SUITE("slow") {
  TEST_CASE("the figures of molecules and of the head are as they were approved") {
    for (const char* name : {"1", "10b", "11"}) check_against_golden(name);
  }
}
