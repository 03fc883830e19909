/// Thousands of wrong meshes, none of which may be called homeomorphic where it is not; and good
/// ones in other words, which must be. The second checker is asked about those that are.

#include <sys/wait.h>

#include <cstdlib>
#include <fstream>

#include "app/certificate_file.h"
#include "certify/located_vertices.h"
#include "geometry/files/mesh_files.h"
#include "geometry/stopwatch.h"
#include "tests/support/specimens.h"
#include "tests/support/temporary_folder.h"

using namespace morskin;
using namespace morskin::support;

namespace {

/// Meshes written for the second checker, and its verdicts.
class SecondOpinion {
 public:
  /// @param limit  of proved meshes, and of others
  explicit SecondOpinion(std::size_t limit) : limit_(limit) {}

  /// @param kind   no more than its share are taken of each
  /// @param wrong  why a proof of the mesh would be false; empty if it would not
  void add(const IndexedMesh& mesh, const Specimen& of, const certify::Certificate& certificate,
           const std::string& kind, const std::string& wrong = {}) {
    constexpr std::size_t max_triangles = 500, shares = 8;
    const bool is_proved = certificate.is_homeomorphic;
    std::size_t& taken = taken_[is_proved ? kind : "not proved: " + kind];
    std::size_t& all = taken_[is_proved ? "proved" : "not proved"];
    if (mesh.triangles.size() > max_triangles || shares * taken > limit_ || all == limit_) return;
    ++taken;
    ++all;
    const std::string number = std::to_string(questions_.size());
    const auto balls = folder_.file(of.name + ".xyzw", skin::xyzw_text(of.points));
    const auto file =
        folder_.file(number + ".ply", geometry::serialized(mesh, geometry::MeshFormat::PlyBinary));
    const auto points = certify::locate_vertices(mesh, of.skin.surface);
    const auto witness = folder_.file(
        number + ".json",
        app::certificate_text(mesh, points, certificate.degree_vertices, of.skin, of.sizing));
    list_ += balls.string() + "\n" + file.string() + "\n" + witness.string() + "\n";
    questions_.push_back({of.name + ": " + kind, wrong, is_proved});
  }
  void check_that_it_agrees() const {
    const auto list = folder_.file("list", list_);
    const std::string verdicts = (folder_ / "verdicts").string();
    const std::string command = std::string(MORSKIN_PYTHON) + " certify/verify/verify.py @" +
                                list.string() + " > " + verdicts;
    double seconds = 0;
    int status = 0;
    geometry::timed(seconds, [&] { status = std::system(command.c_str()); });
    CHECK((status == 0 || WEXITSTATUS(status) == 1));  // 1: some are not proved
    std::ifstream lines(verdicts);
    std::size_t count = 0, proved = 0;
    for (std::string line; std::getline(lines, line); ++count) {
      const Question& asked = questions_.at(count);
      CAPTURE(asked.name);
      CAPTURE(line);
      const bool is_proved = line.find("\"homeomorphic\": true") != std::string::npos;
      proved += is_proved;
      if (asked.is_proved) CHECK(is_proved);
      if (!asked.wrong.empty()) CHECK_FALSE(is_proved);
    }
    CHECK(count == questions_.size());
    MESSAGE("the second checker proves " << proved << " of " << count << " meshes in " << seconds
                                         << " s");
  }

 private:
  struct Question {
    std::string name, wrong;
    bool is_proved;  ///< by the first checker
  };
  std::size_t limit_;
  TemporaryFolder folder_;
  std::string list_;
  std::vector<Question> questions_;
  std::map<std::string, std::size_t> taken_;
};

/// A mutant: one change of parts or none, and up to two others.
Mutant mutant(const IndexedMesh& mesh, const Specimen& good, Random& random) {
  Mutant result(mesh, good.skin.surface, random);
  const auto& steps = Mutant::steps();
  if (random.below(2) == 0) result.change(steps[random.below(Mutant::part_steps)]);
  const std::size_t others = result.history.empty() ? 1 + random.below(2) : random.below(2);
  for (std::size_t i = 0; i < others && !result.mesh.triangles.empty(); ++i) {
    const std::size_t k = random.below(steps.size() - Mutant::part_steps);
    result.change(steps[Mutant::part_steps + k]);
  }
  return result;
}

constexpr const char* another_skin = " of another skin";

/// By step, how many of the mutants that took it are proved.
class Tally {
 public:
  void add(const std::string& history, bool is_proved) {
    for (const Mutant::Step& step : Mutant::steps()) {
      if (history.find(step.name) != std::string::npos) add_to(counts_[step.name], is_proved);
    }
    if (history.ends_with(another_skin)) add_to(counts_[another_skin], is_proved);
    add_to(all_, is_proved);
  }
  std::size_t made() const { return all_.made; }
  std::string text() const {
    std::string table = text(all_) + " mutants are proved";
    for (const auto& [step, counts] : counts_) table += "\n  " + step + ": " + text(counts);
    return table;
  }

 private:
  struct Counts {
    std::size_t made = 0, proved = 0;
  };
  static void add_to(Counts& counts, bool is_proved) {
    ++counts.made;
    counts.proved += is_proved;
  }
  static std::string text(const Counts& counts) {
    return std::to_string(counts.proved) + " of " + std::to_string(counts.made);
  }
  std::map<std::string, Counts> counts_;
  Counts all_;
};

bool is_same(const IndexedMesh& a, const IndexedMesh& b) {
  return a.positions == b.positions && a.triangles == b.triangles;
}

/// Whether the law can be tried: the mesh's coordinates are numbers whose products are.
bool is_ordinary(const IndexedMesh& mesh) {
  constexpr double largest = 1e90;
  return std::ranges::all_of(mesh.positions, [&](const Point& x) {
    return (x.array().abs() < largest).all();  // false for NaN
  });
}

/// Makes so many mutants of specimens of successive seeds and checks the law on each.
void try_mutants(std::size_t count, std::size_t per_specimen, std::size_t verified) {
  Tally tally;
  SecondOpinion second(verified);
  for (unsigned seed = 0; tally.made() < count; ++seed) {
    const auto good = specimen(seed);
    constexpr std::size_t max_triangles = 1500;
    if (!good || good->mesh.triangles.size() > max_triangles) continue;
    Random random(seed);
    const auto other_skin = specimen("neighbour", nearly(good->points, random), good->sizing.C);
    second.add(good->mesh, *good, good->certify(good->mesh), "good");
    for (std::size_t i = 0; i < per_specimen && tally.made() < count; ++i) {
      const bool is_other = other_skin && random.below(6) == 0;
      const Mutant other = mutant(is_other ? other_skin->mesh : good->mesh, *good, random);
      CAPTURE(good->name);
      CAPTURE(i);
      CAPTURE(other.history);
      if (is_same(other.mesh, good->mesh)) continue;
      const certify::Certificate certificate = good->certify(other.mesh);
      tally.add(other.history + (is_other ? another_skin : ""), certificate.is_homeomorphic);
      if (!certificate.broken_by(certify::Claim::Manifold).empty() || !is_ordinary(other.mesh)) {
        CHECK_FALSE(certificate.is_homeomorphic);
        continue;
      }
      const std::string wrong = falsehood(other.mesh, *good, random);
      if (certificate.is_homeomorphic) CHECK(wrong == "");
      second.add(other.mesh, *good, certificate, other.history, wrong);
    }
  }
  MESSAGE(tally.text());
  second.check_that_it_agrees();
}

/// Turned about some axis, doubled or halved, and moved, in doubles.
template <class Points, class Position>
void move(Points& points, Position position, unsigned seed, double scale) {
  Random random(seed);
  const Eigen::AngleAxisd turn(random.between(0, 2 * M_PI), random.direction());
  const Vector shift = 100 * scale * random.direction();
  for (auto& p : points) position(p) = turn * position(p) + shift;
}

}  // namespace

TEST_CASE("no mutant is called homeomorphic where it is not") { try_mutants(2000, 40, 100); }

TEST_CASE("good meshes moved, turned, permuted or rounded are called homeomorphic") {
  for_seeds(60, [](unsigned seed) {
    const auto good = specimen(seed);
    if (!good || good->mesh.triangles.size() > 3000) return;
    CAPTURE(good->name);
    REQUIRE(good->certify(good->mesh).is_homeomorphic);
    Random random(seed);
    Mutant other(good->mesh, good->skin.surface, random);
    for (const Mutant::Step& step : Mutant::steps()) {
      if (std::string_view(step.name) == "permute") other.change(step);
    }
    CHECK(good->certify(other.mesh).is_homeomorphic);
    double rho = std::numeric_limits<double>::infinity();
    for (const auto& p : certify::locate_vertices(good->mesh, good->skin.surface)) {
      rho = std::min(rho, p.length_scale);
    }
    IndexedMesh rounded = good->mesh;
    for (Point& x : rounded.positions) {
      x = ((x / (1e-6 * rho)).array().round() * (1e-6 * rho)).matrix();
    }
    CHECK(good->certify(rounded).is_homeomorphic);
    WeightedPoints points = good->points;
    IndexedMesh moved = good->mesh;
    move(
        points, [](auto& p) -> Point& { return p.position; }, seed, rho);
    move(
        moved.positions, [](Point& p) -> Point& { return p; }, seed, rho);
    const auto skin = prepared(points);
    if (!skin) return;  // where it was nearly singular
    CHECK(certify::certify(moved, skin->surface, skin->topology, good->sizing).is_homeomorphic);
  });
}

TEST_SUITE("slow") {
  TEST_CASE("of a hundred thousand mutants none is called homeomorphic where it is not") {
    try_mutants(100000, 100, 2000);
  }
}
