#include "app/pictures/legend.h"
#include "app/pictures/png.h"
#include "app/pictures/raster.h"
#include "app/pictures/render.h"
#include "tests/support/png_reading.h"
#include "tests/support/test.h"

using namespace morskin;
using namespace morskin::pictures;
using namespace morskin::support;

namespace {

constexpr Colour red{1, 0, 0}, blue{0, 0, 1};

Camera front_camera(int size) { return camera_from(Vector::UnitZ(), Vector::UnitY(), size, size); }

std::size_t covered(const Image& image) {
  std::size_t count = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) {
      const Colour& c = image.at(x, y);
      count += c.r + c.g + c.b < 3;
    }
  }
  return count;
}

// How much of the picture is black, in pixels.
double blackness(const Image& image) {
  double sum = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) sum += 1 - image.at(x, y).g;
  }
  return sum;
}

Scene triangle_scene(const Vector& a, const Vector& b, const Vector& c, const Colour& colour) {
  MeshLayer layer;
  layer.mesh = {{a, b, c}, {{0, 1, 2}}};
  layer.coat.colour = layer.coat.back = colour;
  Scene scene;
  scene.meshes.push_back(layer);
  return scene;
}

}  // namespace

TEST_CASE("a ball's silhouette has the area pi r^2, but for its rim") {
  for_seeds<Random>(40, [&](Random& random) {
    const double radius = random.between(5, 40);
    Scene scene;
    scene.balls.push_back({random.in_cube(-8, 8), radius, red});
    const Image image = render(scene, front_camera(100), {.samples = 1, .shadows = false});
    // Pixels whose centres are inside: off by less than the length of the rim (Gauss's circle).
    CHECK(std::abs(static_cast<double>(covered(image)) - M_PI * radius * radius) < M_PI * radius);
  });
}

TEST_CASE("a triangle covers the samples inside it, at the depth of its plane") {
  for_seeds<Random>(300, [&](Random& random) {
    const Vector a = random.in_cube(-10, 50), b = random.in_cube(-10, 50),
                 c = random.in_cube(-10, 50);
    const Grid grid{40, 40};
    std::vector<int> visits(1600);
    const Vector normal = (b - a).cross(c - a);
    for_each_sample_of_triangle(grid, a, b, c, [&](int x, int y, double depth, double, double) {
      ++visits[static_cast<std::size_t>(40 * y + x)];
      const double height =
          a.z() - (normal.x() * (x + 0.5 - a.x()) + normal.y() * (y + 0.5 - a.y())) / normal.z();
      CHECK(depth == doctest::Approx(height).epsilon(1e-6));
    });
    for (int y = 0; y < 40; ++y) {
      for (int x = 0; x < 40; ++x) {
        const Vector p(x + 0.5, y + 0.5, 0);
        const double u = seen_area(p, b, c), v = seen_area(a, p, c), w = seen_area(a, b, p);
        const double least = std::min({std::abs(u), std::abs(v), std::abs(w)});
        if (least < 1e-6) continue;  // on an edge, where rounding may decide
        const bool is_inside = (u > 0) == (v > 0) && (v > 0) == (w > 0);
        CHECK(visits[static_cast<std::size_t>(40 * y + x)] == (is_inside ? 1 : 0));
      }
    }
  });
}

TEST_CASE("copies of a triangle are drawn once, and their edges with them") {
  // Each of the three triangles twice, with its own corners and turned; the last two face apart.
  const std::vector<Vector> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  geometry::IndexedMesh mesh;
  for (const auto& [a, b, c] : {std::array{0U, 1U, 2U},
                                {1U, 2U, 0U},
                                {0U, 1U, 3U},
                                {3U, 0U, 1U},
                                {0U, 3U, 1U},
                                {1U, 0U, 3U}}) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {p[a], p[b], p[c]});
    mesh.triangles.push_back({first, first + 1, first + 2});
  }
  CHECK(boundary_edges(mesh).size() == 5);
  drop_copies(mesh);
  CHECK(mesh.triangles ==
        std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}, {6, 7, 8}, {12, 13, 14}});
}

TEST_CASE("every sample of a stick lies on its cylinder, and no ray misses it") {
  for_seeds<Random>(200, [&](Random& random) {
    const Vector from = random.in_cube(5, 35), to = random.in_cube(5, 35);
    const double radius = random.between(0.5, 6);
    const Vector e = (to - from).normalized();
    std::size_t count = 0;
    for_each_sample_of_stick({40, 40}, from, to, radius,
                             [&](int x, int y, double depth, const Vector& normal) {
                               const Vector d = Vector(x + 0.5, y + 0.5, depth) - from;
                               const double t = d.dot(e);
                               CHECK((d - t * e).norm() == doctest::Approx(radius).epsilon(1e-6));
                               CHECK(normal.dot(e) == doctest::Approx(0).epsilon(1e-6));
                               CHECK(normal.z() > -1e-9);
                               ++count;
                             });
    // The side seen of a cylinder is a rectangle; lids would add half ellipses.
    const double flat = (to - from).head<2>().norm(), area = 2 * radius * flat;
    const bool is_all_in_view = std::min({from.x(), to.x(), from.y(), to.y()}) > radius &&
                                std::max({from.x(), to.x(), from.y(), to.y()}) < 40 - radius;
    if (is_all_in_view && flat > 2 * radius) {
      CHECK(std::abs(static_cast<double>(count) - area) < 2 * (2 * radius + flat));
    }
  });
}

TEST_CASE("what is nearer is seen, in whatever order things are drawn") {
  for_seeds<Random>(60, [&](Random& random) {
    // Two triangles that both cover the middle, red at height `z` there and blue at 0.
    const double z = (random.uniform() < 0.5 ? -1 : 1) * random.between(0.5, 10);
    const auto over_middle = [&](double height) {
      const double tilt = random.between(-0.5, 0.5), lean = random.between(-0.5, 0.5);
      const auto lifted = [&](double x, double y) {
        return Vector(x, y, height + tilt * x + lean * y);
      };
      return std::array{lifted(-15, -12), lifted(14, -13), lifted(1, 16)};
    };
    const auto r = over_middle(z), b = over_middle(0);
    Scene scene = triangle_scene(r[0], r[1], r[2], red);
    scene.meshes.push_back(triangle_scene(b[0], b[1], b[2], blue).meshes[0]);
    Scene other = scene;
    std::swap(other.meshes[0], other.meshes[1]);
    const Camera camera = front_camera(41);
    const Image image = render(scene, camera, {.samples = 1});
    CHECK((image.at(20, 20).r > image.at(20, 20).b) == (z > 0));
    CHECK(png(image) == png(render(other, camera, {.samples = 1})));
  });
}

TEST_CASE("the same scene gives the same bytes") {
  Random random(7);
  Scene scene;
  for (int i = 0; i < 30; ++i) {
    scene.balls.push_back({random.in_cube(-5, 5), random.between(0.5, 2), blue});
    scene.sticks.push_back({random.in_cube(-5, 5), random.in_cube(-5, 5), 0.3, red});
  }
  scene.lines.push_back({{Vector(-5, -5, 9), Vector(5, 5, 9)}, ink, 3});
  scene.labels.push_back({Vector::Zero(), "p_0 = ρ", Vector2(0, 0), 14});
  const Camera camera = front_camera(120).fitted(scene.extent());
  CHECK(png(render(scene, camera)) == png(render(scene, camera)));
}

TEST_CASE("a scene of nothing is the bare background") {
  const Image image = render({}, front_camera(20));
  CHECK(covered(image) == 0);
}

TEST_CASE("a fitted camera sees all points, and lengths across the view are true") {
  for_seeds<Random>(100, [&](Random& random) {
    std::vector<Point> points;
    for (int i = 0; i < 20; ++i) points.push_back(random.in_cube(-7, 9));
    const Camera camera =
        camera_from(random.direction(), random.direction(), 200, 120).fitted(points);
    for (const Point& p : points) {
      const Vector at = camera.seen(p);
      CHECK(at.x() >= 0);
      CHECK(at.x() <= 200);
      CHECK(at.y() >= 0);
      CHECK(at.y() <= 120);
      CHECK((at - camera.seen(points[0])).norm() ==
            doctest::Approx(camera.scale * (p - points[0]).norm()));
    }
  });
}

TEST_CASE("a line of a width and a length covers its area and two half disks") {
  for_seeds<Random>(100, [&](Random& random) {
    const Vector2 a(random.between(20, 80), random.between(20, 80)),
        b(random.between(20, 80), random.between(20, 80));
    const double width = random.between(1, 12);
    Image image(100, 100);
    draw_line(image, std::array{a, b}, {{0, 0, 0}, width});
    const double area = width * (b - a).norm() + M_PI * width * width / 4;
    CHECK(blackness(image) == doctest::Approx(area).epsilon(0.08));
  });
}

TEST_CASE("letters keep to their line, and all that figures use have a glyph of their own") {
  const Lettering box = lettering("\x01");
  const std::string used =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789.,:;-+=()[]/|<>'\"!?#%*";
  for (const char c : used) {
    CAPTURE(c);
    const Lettering line = lettering(std::string(1, c));
    REQUIRE(!line.strokes.empty());
    for (const Stroke& stroke : line.strokes) {
      REQUIRE(!stroke.empty());
      for (const Vector2& p : stroke) {
        CHECK(p.x() >= 0);
        CHECK(p.x() <= line.width + 1e-9);
        CHECK(p.y() >= -0.34);
        CHECK(p.y() <= 1.12);
      }
    }
    CHECK(line.strokes != box.strokes);
  }
  for (const char* c : {"ρ", "θ", "Å", "°", "×"}) CHECK(lettering(c).strokes != box.strokes);
  CHECK(lettering("R_{ab}").width < lettering("Rab").width);
  CHECK(lettering("R_{ab}").strokes.size() == lettering("Rab").strokes.size());
}

TEST_CASE("a legend's bar has each colour at its value, and its ticks stand below it") {
  const ColourScale scale{{red, white, blue}, 20, 60};
  CHECK(scale.at(20).r == red.r);
  CHECK(scale.at(10).r == red.r);
  CHECK(scale.at(40).g == white.g);
  CHECK(scale.at(99).b == blue.b);
  CHECK(scale.at(50).b == doctest::Approx((white.b + blue.b) / 2));
  const Image bare(400, 100);
  const Image image = with_legend(bare, {Legend::Bar{scale, "angle", {"20", "40", "60"}}, {}});
  CHECK(image.width() == 400);
  REQUIRE(image.height() > 100);
  // Along the middle of the bar the blue of the scale never falls.
  double last = 0;
  int coloured = 0;
  for (int x = 0; x < image.width(); ++x) {
    const Colour& c = image.at(x, 113);
    const bool is_of_scale = c.r == white.r || c.b == white.b;
    if (!is_of_scale || (c.r == c.b && c.g == c.r)) continue;
    CHECK(c.b >= last);
    last = c.b;
    ++coloured;
  }
  CHECK(coloured > 100);
}

TEST_CASE("a legend is as wide as its entries need, and a picture without one stays as it is") {
  const Image bare(60, 50, red);
  CHECK(png(with_legend(bare, {})) == png(bare));
  const std::vector<LegendEntry> entries{{Mark::Patch, red, "a patch"},
                                         {Mark::Dot, blue, "a dot of blue"},
                                         {Mark::Dashes, ink, "dashes"}};
  const Image narrow = with_legend(bare, {{}, entries});
  CHECK(narrow.width() > 60);
  const Image wide = with_legend(Image(900, 50, red), {{}, entries});
  CHECK(wide.width() == 900);
  // One row of entries in the wide picture, three in the narrow one.
  CHECK(narrow.height() - 50 == 3 * (wide.height() - 50));
  const Image twice = with_legend(Image(1800, 100, red), {{}, entries}, 2);
  CHECK(twice.height() == 2 * wide.height());
}

TEST_CASE("a PNG holds the picture's bytes") {
  Random random(3);
  Image image(37, 23);
  for (int y = 0; y < 23; ++y) {
    for (int x = 0; x < 37; ++x) {
      image.at(x, y) = {random.uniform(), random.uniform(), random.uniform()};
    }
  }
  const auto pixels = read_png(png(image));
  REQUIRE(pixels);
  CHECK(pixels->width == 37);
  CHECK(pixels->height == 23);
  CHECK(pixels->bytes == image.bytes());
}
