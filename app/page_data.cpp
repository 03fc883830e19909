#include "app/page_data.h"

#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <new>
#include <stdexcept>

#include "app/viewer_asset.h"
#include "geometry/error.h"
#include "geometry/files/base64.h"

namespace morskin::app {
namespace {

// Page data are little endian, whatever the machine.
static_assert(std::endian::native == std::endian::little);

std::string packed(const std::string& bytes) {
  z_stream stream{};
  constexpr int gzip_window = 15 + 16;
  if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, gzip_window, 9, Z_DEFAULT_STRATEGY) !=
      Z_OK) {
    throw std::bad_alloc();
  }
  // zlib counts in 32 bits, and no browser opens a larger page.
  if (bytes.size() > std::numeric_limits<uInt>::max() / 2) {
    deflateEnd(&stream);
    throw geometry::LimitReached(
        "too much for one page; show a part of it, or a coarser mesh (-C)");
  }
  std::string result(deflateBound(&stream, static_cast<uLong>(bytes.size())), '\0');
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
  stream.avail_in = static_cast<uInt>(bytes.size());
  stream.next_out = reinterpret_cast<Bytef*>(result.data());
  stream.avail_out = static_cast<uInt>(result.size());
  const int outcome = deflate(&stream, Z_FINISH);
  result.resize(stream.total_out);
  deflateEnd(&stream);
  if (outcome != Z_STREAM_END) throw std::bad_alloc();
  return result;
}

// JSON inside a page, without anything that resembles a tag.
std::string harmless(std::string json) {
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;) {
    json.replace(at, 1, "\\u003c");
  }
  return json;
}

}  // namespace

std::array<std::int32_t, 3> Grid::nearest(const geometry::Point& p) const {
  const geometry::Vector steps = (p - origin) / step;
  return {static_cast<std::int32_t>(std::lround(steps.x())),
          static_cast<std::int32_t>(std::lround(steps.y())),
          static_cast<std::int32_t>(std::lround(steps.z()))};
}

Grid grid_about(std::span<const geometry::Point> points, double wanted) {
  Grid grid;
  if (points.empty()) return grid;
  geometry::Point low = points.front(), high = low;
  for (const geometry::Point& p : points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const double extent = (high - low).maxCoeff();
  // A power of two, so that coordinates of the grid are exact.
  constexpr double max_steps = (1 << 24) - 2;
  const double coarsest = std::exp2(std::floor(std::log2(extent / 1024)));
  const double finest = std::exp2(std::ceil(std::log2(extent / max_steps)));
  const double step = std::exp2(std::floor(std::log2(wanted)));
  grid.step = std::max(std::min(step, coarsest), finest);
  if (!(grid.step > 0)) grid.step = 1;
  grid.origin = (low / grid.step).array().floor().matrix() * grid.step;
  return grid;
}

Grid grid_of(const geometry::IndexedMesh& mesh) {
  constexpr double min_edge_steps = 64;
  double shortest = std::numeric_limits<double>::infinity();
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double length = (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).norm();
      if (length > 0) shortest = std::min(shortest, length);
    }
  }
  return grid_about(mesh.positions, shortest / min_edge_steps);
}

void PageData::add_entry(const std::string& name, std::string_view kind, std::size_t count,
                         std::size_t planes) {
  entries_.push_back({{"name", name},
                      {"kind", kind},
                      {"at", bytes_.size()},
                      {"count", count},
                      {"planes", planes}});
}

void PageData::add(const std::string& name, const std::vector<std::uint32_t>& numbers) {
  std::uint32_t all = 0;
  for (const std::uint32_t n : numbers) all |= n;
  const auto planes = static_cast<std::size_t>(std::bit_width(all) + 7) / 8;
  add_entry(name, "unsigned", numbers.size(), planes);
  for (std::size_t k = 0; k < planes; ++k) {
    for (const std::uint32_t n : numbers) bytes_ += static_cast<char>(n >> 8 * k & 255);
  }
}

void PageData::add(const std::string& name, const std::vector<std::int32_t>& numbers) {
  std::vector<std::uint32_t> folded;
  folded.reserve(numbers.size());
  for (const std::int32_t n : numbers) {
    const auto twice = static_cast<std::uint32_t>(n) << 1;
    folded.push_back(n < 0 ? ~twice : twice);
  }
  add(name, folded);
  entries_.back()["kind"] = "signed";
}

void PageData::add(const std::string& name, const std::vector<std::uint8_t>& bytes) {
  add_entry(name, "unsigned", bytes.size(), 1);
  bytes_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
}

void PageData::add(const std::string& name, const std::vector<double>& numbers) {
  add_entry(name, "double", numbers.size(), 8);
  bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof numbers[0]);
}

void PageData::add(const std::string& name, const std::vector<float>& numbers) {
  add_entry(name, "float", numbers.size(), 4);
  bytes_.append(reinterpret_cast<const char*>(numbers.data()), numbers.size() * sizeof numbers[0]);
}

void PageData::add(const std::string& name, const std::string& text) {
  add_entry(name, "text", text.size(), 1);
  bytes_.append(text);
}

std::string PageData::page() const {
  nlohmann::ordered_json json = about;
  json["arrays"] = entries_;
  const std::string head =
      json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  std::string page;
  std::string_view rest = viewer_asset();
  const auto take_up_to = [&](std::string_view mark) {
    const std::size_t at = rest.find(mark);
    if (at == std::string_view::npos) throw std::logic_error("the viewer lacks its place for data");
    page += rest.substr(0, at);
    rest.remove_prefix(at + mark.size());
  };
  take_up_to("@ABOUT@");
  page += harmless(head);
  take_up_to("@DATA@");
  geometry::append_base64(page, packed(bytes_));
  page += rest;
  return page;
}

}  // namespace morskin::app
