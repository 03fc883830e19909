#include "app/figures/panels.h"

#include <cmath>
#include <utility>

namespace morskin::figures {

namespace {

int pixels(double length) { return static_cast<int>(std::lround(length)); }

}  // namespace

Colour colour_of_index(int index) {
  if (index == 0) return minimum_red;
  return index == 1 ? saddle_blue : maximum_green;
}

pictures::Legend critical_point_legend(std::vector<LegendEntry> others) {
  others.insert(others.begin(), {{Mark::Dot, minimum_red, "minimum"},
                                 {Mark::Dot, saddle_blue, "saddle"},
                                 {Mark::Dot, maximum_green, "maximum"}});
  return {{}, std::move(others)};
}

Image panel(const Scene& scene, const Camera& camera, double scale, const pictures::Style& style) {
  pictures::Style scaled = style;
  scaled.unit *= scale;
  return pictures::render(scene, camera.resized(scale), scaled);
}

Image captioned(std::span<const Image> panels, std::span<const std::string_view> captions,
                double scale, int columns) {
  std::vector<Image> with_captions;
  for (std::size_t i = 0; i < panels.size(); ++i) {
    const int strip = pixels(34 * scale);
    Image image(panels[i].width(), panels[i].height() + strip);
    image.paste(panels[i], 0, 0);
    draw_text(image, Vector2(image.width() / 2.0, image.height() - 12 * scale), captions[i],
              14 * scale, pictures::Align::Centre);
    with_captions.push_back(std::move(image));
  }
  return pictures::in_rows(with_captions, columns, pixels(18 * scale));
}

void frame(Image& image, const Camera& camera, const Camera& detail, double scale) {
  const Vector middle = camera.resized(scale).seen(detail.target);
  const double zoom = camera.scale * scale / detail.scale;
  const double w = zoom * detail.width / 2, h = zoom * detail.height / 2;
  const pictures::Box box{middle.x() - w, middle.y() - h, middle.x() + w, middle.y() + h};
  draw_box(image, box, {pictures::white, 4.5 * scale});
  draw_box(image, box, {pictures::ink, 2 * scale});
}

}  // namespace morskin::figures
