// A mesher's hints may save the certificate a search, and may not change a word of it.

#include <cmath>

#include "certify/certificate.h"
#include "certify/located_vertices.h"
#include "tests/support/mesh_part.h"
#include "tests/support/meshes.h"

using namespace morskin;
using certify::Certificate;
using geometry::GluedTriangles;
using geometry::HalfEdgeId;
using geometry::IndexedMesh;
using skin::CellId;
using support::ball;

namespace {

/// Hints by name, each wrong in its own manner.
using Twins = std::vector<std::pair<std::string, std::vector<HalfEdgeId>>>;
using Cells = std::vector<std::pair<std::string, std::vector<CellId>>>;

Twins spoiled(const std::vector<HalfEdgeId>& twins, support::Random& random) {
  Twins all{{"as it is", twins},
            {"nothing", {}},
            {"too few", twins},
            {"too many", twins},
            {"two swapped", twins},
            {"one its own", twins},
            {"beyond the end", twins},
            {"none", std::vector(twins.size(), HalfEdgeId::none())},
            {"all the first", std::vector(twins.size(), HalfEdgeId{0U})},
            {"one by one", twins},
            {"two pairs crossed", twins},
            {"at random", twins}};
  const auto named = [&](const char* how) -> std::vector<HalfEdgeId>& {
    for (auto& [name, list] : all) {
      if (name == how) return list;
    }
    throw std::logic_error(how);
  };
  const std::size_t count = twins.size(), a = random.below(count);
  std::size_t b = a;
  while (b == a || twins[a].index() == b) b = random.below(count);
  named("too few").pop_back();
  named("too many").push_back(HalfEdgeId{0U});
  std::swap(named("two swapped")[a], named("two swapped")[b]);
  named("one its own")[a] = HalfEdgeId{a};
  named("beyond the end")[a] = HalfEdgeId{count};
  for (std::size_t h = 0; h < count; ++h) named("one by one")[h] = HalfEdgeId{h ^ 1U};
  for (HalfEdgeId& h : named("at random")) h = HalfEdgeId{random.below(count)};
  if (twins[a].index() < count && twins[b].index() < count) {  // mutual, but of other edges
    auto& list = named("two pairs crossed");
    list[a] = HalfEdgeId{b};
    list[b] = HalfEdgeId{a};
    list[twins[a].index()] = twins[b];
    list[twins[b].index()] = twins[a];
  }
  return all;
}

Cells spoiled(const std::vector<CellId>& cells, support::Random& random) {
  const std::size_t count = cells.size();
  Cells all{{"as it is", cells},
            {"nothing", {}},
            {"too few", cells},
            {"one other", cells},
            {"all the first", std::vector(count, CellId{0U})},
            {"beyond the end", std::vector(count, CellId::none())},
            {"every other beyond the end", cells},
            {"at random", cells}};
  all[2].second.pop_back();
  all[3].second[random.below(count)] = CellId{random.below(1000)};
  for (std::size_t v = 0; v < count; v += 2) all[6].second[v] = CellId{0xFFFFFFF0U};
  for (CellId& c : all[7].second) c = CellId{random.below(1000)};
  return all;
}

void check_same(const Certificate& one, const Certificate& other) {
  CHECK(one.certified == other.certified);
  CHECK(one.is_homeomorphic == other.is_homeomorphic);
  CHECK(one.reason == other.reason);
  CHECK(one.broken == other.broken);
  CHECK(one.components == other.components);
  CHECK(one.euler_characteristic == other.euler_characteristic);
  CHECK(one.genus == other.genus);
  CHECK(one.violations_L == other.violations_L);
  CHECK(one.violations_U == other.violations_U);
  CHECK(one.covering_degree_ok == other.covering_degree_ok);
  CHECK(one.restricted_delaunay_violations == other.restricted_delaunay_violations);
  CHECK(one.min_angle_deg == other.min_angle_deg);
  CHECK((one.volume == other.volume || (std::isnan(one.volume) && std::isnan(other.volume))));
}

/// A mesh, and others made from it in which something is wrong.
std::vector<std::pair<std::string, IndexedMesh>> good_and_bad(const IndexedMesh& good) {
  std::vector<std::pair<std::string, IndexedMesh>> all(6, {"good", good});
  all[1].first = "a hole";
  all[1].second.triangles.erase(all[1].second.triangles.begin() + 17);
  all[2].first = "one triangle the wrong way";
  std::swap(all[2].second.triangles[3][0], all[2].second.triangles[3][1]);
  all[3].first = "laid twice";
  all[3].second.append(good);
  all[4].first = "an unused vertex, one off the skin";
  all[4].second.positions.push_back(good.positions[0]);
  all[4].second.positions[5] *= 1.01;
  // Two sheets that touch along an edge: there is more than one way to glue them.
  all[5] = {"an edge twice", good};
  all[5].second.triangles = support::tetrahedron(0, 1, 2, 3);
  for (const auto& t : support::tetrahedron(0, 1, 4, 5)) all[5].second.triangles.push_back(t);
  all[5].second.positions.resize(6);
  return all;
}

}  // namespace

TEST_CASE("hints change nothing in a certificate, right or wrong") {
  const morskin::PreparedSkin skin =
      morskin::prepare_skin({ball(0, 0, 0, 1), ball(1.5, 0, 0, 1.2)});
  const IndexedMesh mesh = morskin::make_mesh(skin, support::uncertified()).mesh;
  support::Random random(1);
  for (const auto& one : good_and_bad(mesh)) {
    const std::string& kind = one.first;
    const IndexedMesh& certified_mesh = one.second;
    CAPTURE(kind);
    const auto certificate = [&](const certify::Hints& hints, unsigned threads) {
      return certify::certify(certified_mesh, hints, skin.surface, skin.topology, {},
                              geometry::Run(threads));
    };
    const Certificate expected = certificate({}, 1);
    CHECK(expected.certified == (kind == "good"));
    std::vector<CellId> cells;
    for (const auto& p : certify::locate_vertices(certified_mesh, skin.surface))
      cells.push_back(p.cell);
    const GluedTriangles glued =
        geometry::glued_triangles(certified_mesh.positions.size(), certified_mesh.triangles).mesh;
    for (const unsigned threads : {1U, 2U}) {
      for (const auto& twins : spoiled(glued.twins(), random)) {
        CAPTURE(twins.first);
        check_same(certificate({twins.second, cells}, threads), expected);
      }
      for (const auto& hinted : spoiled(cells, random)) {
        CAPTURE(hinted.first);
        check_same(certificate({{}, hinted.second}, threads), expected);
      }
    }
  }
}

TEST_CASE(
    "what is wrong where an edge occurs twice is told the same with twins that part the sheets") {
  const morskin::PreparedSkin skin = morskin::prepare_skin({ball(0, 0, 0, 1)});
  const auto both = [](std::uint32_t a, std::uint32_t b) {
    support::TriangleList list = support::tetrahedron(0, 1, 2, 3);
    for (const auto& t : support::tetrahedron(a, b, 4, 5)) list.push_back(t);
    return list;
  };
  const support::TriangleList parted = both(6, 7);
  const GluedTriangles apart = geometry::glued_triangles(8, parted).mesh;
  REQUIRE(apart.twins().size() == 24);
  IndexedMesh mesh{{}, both(0, 1)};
  for (std::uint32_t v = 0; v < 6; ++v)
    mesh.positions.emplace_back(std::cos(v), std::sin(v), 0.1 * v);
  REQUIRE(GluedTriangles::by_twins(6, mesh.triangles, apart.twins()).has_value());
  const auto certificate = [&](const certify::Hints& hints) {
    return certify::certify(mesh, hints, skin.surface, skin.topology, {}, geometry::Run(1));
  };
  const Certificate expected = certificate({});
  CHECK_FALSE(expected.holds(certify::Claim::Manifold));
  std::vector<HalfEdgeId> twins = apart.twins();
  check_same(certificate({twins, {}}), expected);
  // The sheets joined crosswise.
  const auto half_edge = [&](std::uint32_t from, std::uint32_t to) {
    std::size_t h = 0;
    while (apart.origin(HalfEdgeId{h}).value != from || apart.target(HalfEdgeId{h}).value != to)
      ++h;
    return HalfEdgeId{h};
  };
  for (const auto& [h, back] :
       {std::pair(half_edge(0, 1), half_edge(7, 6)), std::pair(half_edge(6, 7), half_edge(1, 0))}) {
    twins[h.index()] = back;
    twins[back.index()] = h;
  }
  REQUIRE(GluedTriangles::by_twins(6, mesh.triangles, twins).has_value());
  check_same(certificate({twins, {}}), expected);
}

TEST_CASE("a mesh glued by hinted twins is the one that a search for twins finds") {
  const IndexedMesh sphere = support::sphere_mesh(geometry::Point::Zero(), 1, 3);
  const std::size_t count = sphere.positions.size();
  const GluedTriangles found = geometry::glued_triangles(count, sphere.triangles).mesh;
  support::Random random(2);
  for (const auto& twins : spoiled(found.twins(), random)) {
    CAPTURE(twins.first);
    const auto glued = GluedTriangles::by_twins(count, sphere.triangles, twins.second);
    REQUIRE(glued.has_value() == (twins.first == "as it is"));
    if (!glued) continue;
    CHECK(geometry::fan_defect(*glued).value_or("") == "");
    CHECK(glued->twins() == found.twins());
    for (std::size_t v = 0; v < count; ++v) {
      CHECK(glued->outgoing(geometry::VertexId{v}) == found.outgoing(geometry::VertexId{v}));
    }
  }
}

TEST_CASE("hinted twins are refused where a triangle repeats a corner or turns") {
  const auto is_accepted = [](const support::TriangleList& list, std::vector<std::uint32_t> twins) {
    std::vector<HalfEdgeId> ids(twins.begin(), twins.end());
    return GluedTriangles::by_twins(4, list, ids).has_value();
  };
  CHECK(is_accepted({{0, 1, 2}, {1, 0, 2}}, {3, 5, 4, 0, 2, 1}));
  CHECK_FALSE(is_accepted({{0, 1, 2}, {0, 1, 2}}, {3, 4, 5, 0, 1, 2}));
  CHECK_FALSE(is_accepted({{0, 0, 1}}, {0, 2, 1}));
  CHECK_FALSE(is_accepted({{0, 1, 2}}, {0, 1, 2}));
  CHECK(is_accepted({}, {}));
}

TEST_CASE("a mesh comes with twins and cells that the certificate need not look for") {
  const morskin::PreparedSkin skin = morskin::prepare_skin(support::tetrahedron_balls(2.8));
  const morskin::MeshResult result = morskin::make_mesh(skin, support::uncertified());
  geometry::SurfaceMesh mesh = support::skin_mesh(skin.surface, result).surface;
  const std::size_t count = mesh.vertex_count();
  const geometry::SurfaceMesh::Lists lists = mesh.turned_into_lists();
  CHECK(lists.triangles == result.mesh.triangles);
  CHECK(GluedTriangles::by_twins(count, lists.triangles, lists.twins).has_value());
  for (std::size_t v = 0; v < result.cells.size(); ++v) {
    CHECK(skin.surface.is_in(result.mesh.positions[v], result.cells[v]));
  }
  CHECK_FALSE(skin.surface.is_in(result.mesh.positions[0], CellId::none()));
}
