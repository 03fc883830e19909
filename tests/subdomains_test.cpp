#include "front/subdomains.h"

#include "front/sweep_plan.h"
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

std::vector<Point> positions(const surface::Samples& samples) {
  std::vector<Point> result;
  for (const SurfacePoint& x : samples.points) result.push_back(x.position);
  return result;
}

/// Sweeps of the leaves of a dissection, each done.
class Boxes {
 public:
  Boxes(int depth, const surface::Surface& surface, const morse::Guide& guide,
        const SweepOptions& options = {}, const std::optional<CoarseningOptions>& coarsening = {})
      : disk_(surface, options.sizing),
        dissection_(positions(surface.samples()), depth),
        parts_(sweep_plan(dissection_, guide, surface.samples(), disk_)) {
    for (std::size_t k = dissection_.first_leaf(); k < dissection_.size(); ++k) {
      leaves_.push_back(std::make_unique<PartialSweep>(surface, guide, options, coarsening));
      leaves_.back()->run(parts_[k].region, bowls_of(parts_[k], guide.function, disk_));
    }
  }
  const std::vector<std::unique_ptr<PartialSweep>>& leaves() const { return leaves_; }
  /// Lets a sweep that has absorbed all go on over the whole surface.
  void finish(PartialSweep& sweep) const {
    std::vector<SurfacePoint> bowls;
    for (std::size_t k = 0; k < dissection_.first_leaf(); ++k) {
      bowls.insert(bowls.end(), parts_[k].minima.begin(), parts_[k].minima.end());
    }
    sweep.run({}, bowls);
  }

 private:
  TangentDisk disk_;
  Dissection dissection_;
  std::vector<SweepPart> parts_;
  std::vector<std::unique_ptr<PartialSweep>> leaves_;
};

}  // namespace

TEST_CASE("subdomains leave a closed mesh of the same surface that one front leaves") {
  for_skins(30, [&](const PreparedSkin& skin) {
    const MeshResult a = make_mesh(skin, {.sizing = {}, .fronts = 1}), b = make_mesh(skin);
    CHECK_MESSAGE(a.certificate.certified, a.certificate.reason);
    CHECK_MESSAGE(b.certificate.certified, b.certificate.reason);
    CHECK(std::abs(a.certificate.area - b.certificate.area) < 2e-3 * a.certificate.area);
  });
}

TEST_CASE("subdomains lay the same triangles for any number of threads") {
  for_guides(10, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const SweepResult a = sweep_subdomains(surface, guide, {}, {}, Run(1));
    CHECK(a.open_edges == 0);
    for (const unsigned threads : {2U, 3U, 8U}) {
      const SweepResult b = sweep_subdomains(surface, guide, {}, {}, Run(threads));
      CHECK(a.mesh.surface.triangle_list() == b.mesh.surface.triangle_list());
    }
  });
}

TEST_CASE("a surface in far too many subdomains closes all the same") {
  for_skins(40, [](const PreparedSkin& skin) {
    const morse::Guide guide = guide_for(skin);
    const std::size_t whole = sweep_once(skin.surface, guide).mesh.surface.triangle_count();
    for (const int depth : {1, 3, 5, 8}) {
      CAPTURE(depth);
      const SweepResult swept =
          sweep_subdomains(skin.surface, guide, {}, {}, Run(2), std::size_t{1} << depth);
      CHECK(swept.open_edges == 0);
      const double ratio =
          static_cast<double>(swept.mesh.surface.triangle_count()) / static_cast<double>(whole);
      CHECK(ratio > 0.9);
      CHECK(ratio < 1.1);
    }
  });
}

TEST_CASE("sweeps of four boxes absorbed in any bracketing leave the same bytes and counts") {
  const certify::Sizing coarse = sizing_for(0.35);
  const std::optional<CoarseningOptions> behind =
      CoarseningOptions{.sizing = coarse, .min_triangles = 300};
  for (const auto& coarsening : {std::optional<CoarseningOptions>(), behind}) {
    SweepOptions options{.record_births = true};
    if (coarsening) options.sizing = coarse.laid();
    for_skins(20, [&](const PreparedSkin& skin) {
      const morse::Guide guide = guide_for(skin, options.sizing);
      const auto mesh = [&](bool is_left_first) {
        Boxes boxes(2, skin.surface, guide, options, coarsening);
        const auto& leaves = boxes.leaves();
        for (std::size_t k = 1; k < 4; ++k) {
          if (is_left_first) {
            leaves[0]->absorb(*leaves[k]);
          } else {
            leaves[3 - k]->absorb(*leaves[4 - k]);
          }
        }
        boxes.finish(*leaves[0]);
        return leaves[0]->take_result();
      };
      const SweepResult a = mesh(true), b = mesh(false);
      CHECK(a.open_edges == 0);
      CHECK(surface::indexed_mesh(a.mesh) == surface::indexed_mesh(b.mesh));
      CHECK(std::ranges::equal(*a.mesh.births, *b.mesh.births));
      CHECK(a.operations.futile_outside_protecting == b.operations.futile_outside_protecting);
      CHECK(a.operations.creep == b.operations.creep);
      CHECK(a.operations.coarsen == b.operations.coarsen);
      CHECK((a.operations.coarsen > 0) == coarsening.has_value());
    });
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

TEST_CASE("the leaves of a dissection share out space, each with as many samples") {
  Random random(3);
  for (const int depth : {0, 1, 4, 7}) {
    std::vector<Point> samples;
    for (int i = 0; i < 1000; ++i) samples.push_back(5 * random.uniform() * random.direction());
    const Dissection dissection(samples, depth);
    CHECK(dissection.leaf_count() == std::size_t{1} << depth);
    std::vector<int> in_leaf(dissection.size(), 0);
    for (const Point& x : samples) {
      ++in_leaf[dissection.box_of(x, dissection.first_leaf())];
      int holders = 0;
      for (std::size_t k = dissection.first_leaf(); k < dissection.size(); ++k) {
        holders += dissection[k].contains(x, 1e-12);
      }
      CHECK(holders <= 1);
    }
    for (std::size_t k = dissection.first_leaf(); k < dissection.size(); ++k) {
      CHECK(std::abs(in_leaf[k] - 1000 / (1 << depth)) <= depth);
    }
    for (std::size_t k = 1; k < dissection.size(); ++k) {
      const geometry::Box &box = dissection[k], &around = dissection[Dissection::parent(k)];
      CHECK((box.low.array() >= around.low.array()).all());
      CHECK((box.high.array() <= around.high.array()).all());
    }
  }
  const Dissection of_nothing({}, 3), of_one({Point(1, 2, 3)}, 3);
  CHECK(of_nothing.leaf_count() == 8);
  CHECK(of_one.is_leaf(of_one.box_of(Point(9, 9, 9), 7)));
}

TEST_CASE("each minimum has its bowl in one part, and what other parts lay keeps off until then") {
  for_guides(60, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const TangentDisk disk(surface, {});
    const surface::Samples samples = surface.samples();
    const Dissection dissection(positions(samples), 3);
    const std::vector<SweepPart> parts = sweep_plan(dissection, guide, samples, disk);
    std::size_t bowls = 0;
    for (std::size_t k = 0; k < parts.size(); ++k) {
      bowls += parts[k].minima.size();
      if (!dissection.is_leaf(k)) continue;
      PartialSweep sweep(surface, guide, {}, {});
      sweep.run(parts[k].region, bowls_of(parts[k], guide.function, disk));
      const SweepResult swept = sweep.take_result();
      for (const SurfacePoint& p : swept.mesh.points) {
        CHECK(dissection[k].contains(p.position, 0));
        for (const auto& ball : parts[k].region.kept_bare) {
          CHECK((p.position - ball.centre).norm() >= ball.radius);
        }
      }
    }
    CHECK(bowls == guide.count(0));
    CHECK(parts[0].region.kept_bare.empty());
  });
}

TEST_CASE("a leaf without a minimum has a front of its own where the surface passes through") {
  // A row of balls along the direction of the sweep: one minimum, and most leaves have none.
  std::vector<geometry::WeightedPoint> row;
  for (int i = 0; i < 24; ++i) row.push_back({Point(0, 1.2 * i, 0), 2});
  const PreparedSkin skin = prepare_skin(row);
  const morse::Guide guide = guide_for(skin);
  CHECK(guide.count(0) == 1);
  const SweepResult swept = sweep_subdomains(skin.surface, guide, {}, {}, Run(2), 8);
  CHECK(swept.open_edges == 0);
  CHECK(swept.operations.creation >= 8);
  CHECK(swept.seam_triangles < swept.mesh.surface.triangle_count() / 3);
}

TEST_CASE("the samples of a skin stand for the integral of rho^-2 over it") {
  for (const char* name : {"1grm_model1.pdb", "caffeine.xyz"}) {
    CAPTURE(name);
    const PreparedSkin skin = prepare_skin(molecule(name, skin::Model::Vdw));
    const MeshResult result = make_mesh(skin);
    double integral = 0;
    for (const auto& t : result.mesh.triangles) {
      const Point &a = result.mesh.positions[t[0]], &b = result.mesh.positions[t[1]],
                  &c = result.mesh.positions[t[2]];
      const double rho = skin.surface.length_scale(a, result.cells[t[0]]);
      integral += (b - a).cross(c - a).norm() / 2 / (rho * rho);
    }
    const surface::Samples samples = skin.surface.samples();
    const double sampled = samples.each * static_cast<double>(samples.points.size());
    CHECK(sampled == doctest::Approx(integral).epsilon(0.1));
  }
}

TEST_CASE("a reversed Morse function has the same critical points with minima and maxima swapped") {
  for_guides(50, [](const skin::SkinSurface& surface, const morse::Guide& guide) {
    const auto reversed = morse::critical_points(surface, guide.function.reversed()).points;
    for (const auto& p : guide.points) {
      const auto same = std::find_if(reversed.begin(), reversed.end(), [&](const auto& q) {
        return (p.point.position - q.point.position).norm() < 1e-9 * p.point.length_scale &&
               2 - p.index == q.index;
      });
      REQUIRE(same != reversed.end());
      CHECK(same->value == doctest::Approx(-p.value));
      CHECK(std::abs(same->descending.dot(p.ascending)) == doctest::Approx(p.index == 1 ? 1 : 0));
    }
  });
}
