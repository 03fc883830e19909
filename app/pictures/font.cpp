#include "app/pictures/font.h"

#include <array>

namespace morskin::pictures {
namespace {

// A glyph's strokes, parted by spaces, as pairs of a digit x and a letter y: d is the baseline, j
// the height of small letters, m that of capitals, a the foot of descenders. Strokes are straight
// from point to point; after ~ they are rounded, after @ rounded and closed.
struct Glyph {
  std::string_view character, strokes;
};

constexpr int baseline = 'd', capital = 'm' - 'd';

constexpr std::array glyphs{
    Glyph{"A", "0d3m6d 1g5g"},
    Glyph{"B", "0d0m ~0m3m5m5i3i0i ~0i3i6i6d3d0d"},
    Glyph{"C", "~6k6m3m0m0d3d6d6f"},
    Glyph{"D", "0d0m ~0m2m6m6d2d0d"},
    Glyph{"E", "5m0m0d5d 0i4i"},
    Glyph{"F", "5m0m0d 0i4i"},
    Glyph{"G", "~6k6m3m0m0d3d6d6h 6h4h"},
    Glyph{"H", "0d0m 6d6m 0i6i"},
    Glyph{"I", "0d0m"},
    Glyph{"J", "~4m4f4d0d0f"},
    Glyph{"K", "0d0m 5m0g 2i6d"},
    Glyph{"L", "0m0d5d"},
    Glyph{"M", "0d0m3f6m6d"},
    Glyph{"N", "0d0m6d6m"},
    Glyph{"O", "@0d0m6m6d"},
    Glyph{"P", "0d0m ~0m4m6m6h4h0h"},
    Glyph{"Q", "@0d0m6m6d 4f6c"},
    Glyph{"R", "0d0m ~0m4m6m6h4h0h 3h6d"},
    Glyph{"S", "~6k6m3m0m0i6h6d3d0d0f"},
    Glyph{"T", "0m6m 3m3d"},
    Glyph{"U", "~0m0g0d6d6g6m"},
    Glyph{"V", "0m3d6m"},
    Glyph{"W", "0m2d4m6d8m"},
    Glyph{"X", "0d6m 0m6d"},
    Glyph{"Y", "0m3h6m 3h3d"},
    Glyph{"Z", "0m6m0d6d"},
    Glyph{"a", "@0d0j5j5d 5j5d"},
    Glyph{"b", "0d0m @0d0j5j5d"},
    Glyph{"c", "~5h5j3j0j0d3d5d5f"},
    Glyph{"d", "5d5m @0d0j5j5d"},
    Glyph{"e", "0g5g ~5g5j0j0d4d5e"},
    Glyph{"f", "~4m2m2j 2j2d 0j4j"},
    Glyph{"g", "@0d0j5j5d ~5j5c5a0a0b"},
    Glyph{"h", "0d0m ~0g0j5j5g 5g5d"},
    Glyph{"i", "0d0j 0l"},
    Glyph{"j", "~2j2c2a0a 2l"},
    Glyph{"k", "0d0m 4j0f 2h5d"},
    Glyph{"l", "0m0d"},
    Glyph{"m", "0d0j ~0g0j4j4g 4g4d ~4g4j8j8g 8g8d"},
    Glyph{"n", "0d0j ~0g0j5j5g 5g5d"},
    Glyph{"o", "@0d0j5j5d"},
    Glyph{"p", "0j0a @0d0j5j5d"},
    Glyph{"q", "5j5a @0d0j5j5d"},
    Glyph{"r", "0d0j ~0g0j4j"},
    Glyph{"s", "~5i5j2j0j0g5g5d2d0d0e"},
    Glyph{"t", "~2l2g2d5d 0j4j"},
    Glyph{"u", "~0j0g0d5d5g 5j5d"},
    Glyph{"v", "0j2d4j"},
    Glyph{"w", "0j2d4j6d8j"},
    Glyph{"x", "0j4d 0d4j"},
    Glyph{"y", "0j2d 4j1a"},
    Glyph{"z", "0j4j0d4d"},
    Glyph{"0", "@0d0m5m5d"},
    Glyph{"1", "0k2m2d"},
    Glyph{"2", "~0k0m5m5j0d 0d5d"},
    Glyph{"3", "~0k0m5m5i2i ~2i5i5d0d0f"},
    Glyph{"4", "4d4m0g5g"},
    Glyph{"5", "5m0m0i ~0i2j5j5d1d0e"},
    Glyph{"6", "@0d0i5i5d ~4m0m0g"},
    Glyph{"7", "0m5m2d"},
    Glyph{"8", "@0i0m5m5i @0d0i5i5d"},
    Glyph{"9", "@0h0m5m5h ~5k5d1d"},
    Glyph{".", "0d"},
    Glyph{",", "1d0b"},
    Glyph{":", "0d 0i"},
    Glyph{";", "1d0b 1i"},
    Glyph{"-", "0h3h"},
    Glyph{"+", "0h4h 2f2j"},
    Glyph{"=", "0g4g 0i4i"},
    Glyph{"(", "~2n0m0b2a"},
    Glyph{")", "~0n2m2b0a"},
    Glyph{"[", "2n0n0b2b"},
    Glyph{"]", "0n2n2b0b"},
    Glyph{"/", "0c4n"},
    Glyph{"|", "0b0n"},
    Glyph{"<", "4e0h4k"},
    Glyph{">", "0e4h0k"},
    Glyph{"'", "0m0k"},
    Glyph{"\"", "0m0k 2m2k"},
    Glyph{"!", "0m0g 0d"},
    Glyph{"?", "~0k0m5m5j2i2g 2d"},
    Glyph{"#", "1d2m 4d5m 0g6g 0j6j"},
    Glyph{"%", "0d6m @0j0m2m2j @4d4g6g6d"},
    Glyph{"*", "0h4l 0l4h 2g2m"},
    Glyph{"×", "0e4i 0i4e"},
    Glyph{"°", "@0k0m2m2k"},
    Glyph{"Å", "0d3k6d 1g5g @2k2n4n4k"},
    Glyph{"ρ", "~0a0g0j5j5d0d0g"},
    Glyph{"θ", "@0d0m5m5d 0i5i"},
};
constexpr std::string_view box = "0d0m4m4d0d";
constexpr double space = 4, gap = 2.2, subscript = 0.68, drop = 2.6;

// A quadratic spline that begins and ends at the first and the last point, tangent to the polygon.
Stroke rounded(const Stroke& corners, bool is_closed) {
  constexpr int pieces = 8;
  Stroke curve;
  const std::size_t n = corners.size();
  const std::size_t arcs = is_closed ? n : n - 2;
  for (std::size_t i = 0; i < arcs; ++i) {
    const Vector2 &a = corners[is_closed ? (i + n - 1) % n : i],
                  &b = corners[is_closed ? i : i + 1],
                  &c = corners[(is_closed ? i + 1 : i + 2) % n];
    const Vector2 from = is_closed || i > 0 ? Vector2((a + b) / 2) : a;
    const Vector2 to = is_closed || i + 1 < arcs ? Vector2((b + c) / 2) : c;
    for (int k = i == 0 ? 0 : 1; k <= pieces; ++k) {
      const double t = static_cast<double>(k) / pieces;
      curve.push_back((1 - t) * (1 - t) * from + 2 * t * (1 - t) * b + t * t * to);
    }
  }
  return curve;
}

std::vector<Stroke> strokes_of(std::string_view text) {
  std::vector<Stroke> strokes;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(' '), text.size());
    std::string_view word = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    const char kind = word.front();
    if (kind == '~' || kind == '@') word.remove_prefix(1);
    Stroke corners;
    for (std::size_t i = 0; i + 1 < word.size(); i += 2) {
      corners.emplace_back(word[i] - '0', word[i + 1] - baseline);
    }
    const bool is_rounded = (kind == '~' || kind == '@') && corners.size() > 2;
    strokes.push_back(is_rounded ? rounded(corners, kind == '@') : corners);
  }
  return strokes;
}

// The length in bytes of the UTF-8 character that begins with this byte.
std::size_t length_of(char first) {
  const auto byte = static_cast<unsigned char>(first);
  if (byte >= 0xF0) return 4;
  if (byte >= 0xE0) return 3;
  return byte >= 0xC0 ? 2 : 1;
}

void add(Lettering& line, std::string_view character, bool is_subscript) {
  const double scale = (is_subscript ? subscript : 1) / capital;
  if (character == " ") {
    line.width += space * scale;
    return;
  }
  std::string_view found = box;
  for (const Glyph& glyph : glyphs) {
    if (glyph.character == character) found = glyph.strokes;
  }
  double right = 0;
  for (Stroke& stroke : strokes_of(found)) {
    for (Vector2& p : stroke) {
      right = std::max(right, p.x());
      p *= scale;
      p.x() += line.width;
      if (is_subscript) p.y() -= drop / capital;
    }
    line.strokes.push_back(std::move(stroke));
  }
  line.width += (right + gap) * scale;
}

}  // namespace

Lettering lettering(std::string_view text) {
  Lettering line;
  bool is_subscript = false, is_braced = false;
  while (!text.empty()) {
    const std::size_t length = std::min(length_of(text.front()), text.size());
    const std::string_view character = text.substr(0, length);
    text.remove_prefix(length);
    if (character == "_" && !is_subscript) {
      is_subscript = true;
      is_braced = !text.empty() && text.front() == '{';
      if (is_braced) text.remove_prefix(1);
    } else if (character == "}" && is_braced) {
      is_subscript = is_braced = false;
    } else {
      add(line, character, is_subscript);
      is_subscript = is_subscript && is_braced;
    }
  }
  line.width = std::max(0.0, line.width - gap / capital);
  return line;
}

}  // namespace morskin::pictures
