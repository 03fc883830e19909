#include "front/two_fronts.h"

#include "tests/support/meshes.h"

using namespace morskin;
using namespace morskin::front;
using namespace morskin::support;

namespace {

/// Tries a law for skins of random ball sets and the guides of sweeps over them.
template <class Law>
void for_guides(unsigned count, Law law) {
  for_skins(count, [&](const PreparedSkin& skin) { law(skin.surface, guide_for(skin)); });
}

}  // namespace

TEST_CASE("two fronts leave a closed mesh of the same surface that one front leaves") {
  for_skins(30, [&](const PreparedSkin& skin) {
    const MeshResult a = make_mesh(skin, {.sizing = {}, .fronts = 1}), b = make_mesh(skin);
    CHECK_MESSAGE(a.certificate.certified, a.certificate.reason);
    CHECK_MESSAGE(b.certificate.certified, b.certificate.reason);
    CHECK(std::abs(a.certificate.area - b.certificate.area) < 2e-3 * a.certificate.area);
  });
}

TEST_CASE("two fronts lay the same triangles in one thread as in two") {
  for_guides(10, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const SweepResult a = sweep_from_both_ends(surface, guide, {}, {}, Run(1));
    const SweepResult b = sweep_from_both_ends(surface, guide, {}, {}, Run(2));
    CHECK(a.mesh.surface.triangle_list() == b.mesh.surface.triangle_list());
    CHECK(a.open_edges == 0);
  });
}

TEST_CASE("three fronts absorbed in either bracketing leave the same bytes, births and counts") {
  const certify::Sizing coarse = sizing_for(0.35);
  const std::optional<CoarseningOptions> behind =
      CoarseningOptions{.sizing = coarse, .min_triangles = 300};
  for (const auto& coarsening : {std::optional<CoarseningOptions>(), behind}) {
    SweepOptions options{.record_births = true};
    if (coarsening) options.sizing = coarse.laid();
    std::size_t closed = 0, runs = 0;
    for_skins(30, [&](const PreparedSkin& skin) {
      const morse::Guide guide = guide_for(skin, options.sizing), reversed = guide.reversed();
      const auto [first, last] =
          std::ranges::minmax_element(guide.points, {}, &morse::CriticalPoint::value);
      const double low = first->value + (last->value - first->value) / 3;
      const double high = first->value + (last->value - first->value) * 2 / 3;
      const auto mesh = [&](bool is_left_first) {
        PartialSweep below(skin.surface, guide, options, {.high = low}, coarsening);
        PartialSweep between(skin.surface, guide, options, {.low = low, .high = high}, coarsening);
        PartialSweep above(skin.surface, reversed, options, {.high = -high}, coarsening);
        for (PartialSweep* part : {&below, &between, &above}) part->run();
        if (is_left_first) {
          below.absorb(between);
          below.absorb(above);
        } else {
          between.absorb(above);
          below.absorb(between);
        }
        below.finish();
        return below.take_result();
      };
      const SweepResult a = mesh(true), b = mesh(false);
      CHECK(indexed_mesh(a.mesh) == indexed_mesh(b.mesh));
      CHECK(std::ranges::equal(*a.mesh.births, *b.mesh.births));
      CHECK(a.operations.futile_outside_protecting == b.operations.futile_outside_protecting);
      CHECK(a.operations.creep == b.operations.creep);
      CHECK(a.operations.coarsen == b.operations.coarsen);
      CHECK((a.operations.coarsen > 0) == coarsening.has_value());
      ++runs;
      closed += a.open_edges == 0;
    });
    CHECK(closed == runs);
  }
}

TEST_CASE("the observers of a sweep are called in the order in which they are given") {
  struct Witness : SweepObserver {
    Witness(std::vector<int>& calls, int own) : calls_(calls), own_(own) {}
    void follow(const FrontChange&) override { calls_.push_back(own_); }
    void operation_done(Operation, const Front&) override { calls_.push_back(own_); }
    void departed(const Departure&, const Front&) override { calls_.push_back(own_); }
    void marked(morse::CriticalId, const Departure&) override { calls_.push_back(own_); }
    void between_departures(Front&) override { calls_.push_back(own_); }
    void finished(Front&) override { calls_.push_back(own_); }
    std::vector<int>& calls_;
    int own_;
  };
  for_guides(3, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    std::vector<int> calls;
    Witness first(calls, 0), second(calls, 1), third(calls, 2);
    sweep_once(surface, guide, {}, {}, {&first, &second, &third});
    CHECK(calls.size() > 1000);
    for (std::size_t i = 0; i < calls.size(); ++i) REQUIRE(calls[i] == static_cast<int>(i % 3));
  });
}

TEST_CASE("the middle level keeps out of the interval between a close minimum and maximum") {
  for_guides(200, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const double level = middle_level(surface, guide);
    for (const auto& p : guide.points) {
      for (const auto& q : guide.points) {
        if (p.index != 0 || q.index != 2) continue;
        const double close = std::min(p.point.length_scale, q.point.length_scale);
        if ((p.point.position - q.point.position).norm() > close) continue;
        CHECK_FALSE((p.value <= level && level <= q.value));
      }
    }
  });
}

TEST_CASE("a reversed Morse function has the same critical points with minima and maxima swapped") {
  for_guides(50, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const auto reversed = morse::critical_points(surface, guide.function.reversed()).points;
    for (const auto& p : guide.points) {
      const auto same = std::find_if(reversed.begin(), reversed.end(), [&](const auto& q) {
        return (p.point.position - q.point.position).norm() < 1e-9 * p.point.length_scale &&
               p.reversed().index == q.index;
      });
      REQUIRE(same != reversed.end());
      CHECK(same->value == doctest::Approx(p.reversed().value));
      CHECK(std::abs(same->descending.dot(p.reversed().descending)) ==
            doctest::Approx(p.index == 1 ? 1 : 0));
    }
  });
}

TEST_CASE("no value within a distance differs by more than a Morse function's most change") {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const geometry::Point from = 3 * random.direction(), x = 5 * random.direction();
    for (const auto& f : {morse::MorseFunction::height(random.direction()),
                          morse::MorseFunction::squared_distance(from),
                          morse::MorseFunction::squared_distance(from).reversed()}) {
      const double distance = random.between(0, 4);
      const geometry::Point y = x + distance * random.direction();
      CHECK(std::abs(f(y) - f(x)) <= f.max_change(x, distance) * (1 + 1e-12));
    }
  }
}
