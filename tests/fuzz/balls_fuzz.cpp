// Up to 12 balls, eight bytes each, meshed and certified, or refused as singular.
//
// Three bytes place a ball on a grid of sixteenths or, in one of three nasty ways, beside a ball
// before it; two its radius; the others choose the way, that ball, and the step off the exact
// place, down to 1e-12. A last byte by itself chooses a larger C than the usual one here: coarse
// meshes go other ways.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>

#include "skin/model.h"
#include "tests/fuzz/require.h"
#include "tests/support/nasty_sets.h"
#include "tests/support/outcome.h"

using namespace morskin;

namespace {

using Bytes = std::array<std::uint8_t, 8>;

double signed_sixteenths(std::uint8_t byte) { return (static_cast<double>(byte) - 128) / 16; }

support::Ball ball_from(const Bytes& b, const support::Balls& balls) {
  support::Ball ball{{signed_sixteenths(b[0]), signed_sixteenths(b[1]), signed_sixteenths(b[2])},
                     0.1 + static_cast<double>(b[3]) / 64};
  const double step = std::pow(10.0, -(b[4] % 13)) * (b[4] >= 128 ? 1 : -1);
  if ((b[5] & 8) != 0) ball.radius *= std::pow(2.0, static_cast<double>(b[6] % 16) - 8);
  if (balls.empty()) return ball;
  const support::Ball& other = balls[b[7] % balls.size()];
  const geometry::Vector direction =
      ball.centre.isZero(0) ? geometry::Vector(1, 0, 0) : ball.centre.normalized();
  switch (b[5] % 5) {
    case 1:  // nearly at the other's place, or right there
      ball.centre = other.centre + (b[6] < 128 ? 0 : step) * direction;
      break;
    case 2:  // nearly touching it
      ball.centre =
          other.centre + std::sqrt(2.0) * (other.radius + ball.radius) * (1 + step) * direction;
      break;
    case 3:  // nearly touching it from inside
      ball.centre = other.centre +
                    std::sqrt(2.0) * std::abs(other.radius - ball.radius) * (1 + step) * direction;
      break;
    case 4:  // nearly on the grid
      ball.centre += step * geometry::Vector(1, 0.5, -0.25);
      break;
    default:
      break;
  }
  return ball;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::size_t max_balls = 12;
  support::Balls balls;
  for (std::size_t i = 0; i + 8 <= size && balls.size() < max_balls; i += 8) {
    Bytes bytes;
    std::copy_n(data + i, 8, bytes.begin());
    balls.push_back(ball_from(bytes, balls));
  }
  if (balls.empty()) return 0;
  // A coarse mesh takes less time; with Q = 1.65 the theory ends at C = 0.109.
  constexpr std::array coarse{0.15, 0.2, 0.25, 0.3};
  morskin::MeshingOptions options;
  options.sizing.C = size % 8 == 1 ? coarse[data[size - 1] % coarse.size()] : 0.1;
  options.sizing.Q = certify::Sizing::quality_for(options.sizing.C);
  const auto points = support::weighted(balls);
  const support::Outcome outcome = support::outcome_of(points, options);
  if (outcome.kind == support::Outcome::Kind::Failed) {
    std::fprintf(stderr, "%s, with C = %g for these balls (x y z r, --model vdw):\n%s",
                 outcome.why.c_str(), options.sizing.C, skin::xyzr_text(points).c_str());
    fuzz::require(false);
  }
  return 0;
}
