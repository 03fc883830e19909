#include "geometry/files/attribute_arrays.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "geometry/files/mesh_formats.h"

namespace morskin::geometry {
namespace {

void append_columns(std::vector<NamedArray>& to, const Attribute& attribute,
                    const std::string& prefix) {
  const std::size_t width = attribute.columns.size();
  for (std::size_t k = 0; k < width; ++k) {
    std::vector<double> numbers;
    for (std::size_t i = k; i < attribute.numbers.size(); i += width) {
      numbers.push_back(attribute.numbers[i]);
    }
    const std::string name = prefix + attribute.columns[k];
    if (attribute.is_whole) {
      to.push_back({name, std::vector<std::int32_t>(numbers.begin(), numbers.end())});
    } else {
      to.push_back({name, std::move(numbers)});
    }
  }
}

}  // namespace

std::vector<NamedArray> attribute_arrays(const MeshAttributes& attributes) {
  std::vector<NamedArray> arrays;
  for (const Attribute& attribute : attributes.vertices) {
    if (!mesh_formats::is_normal(attribute, attributes)) append_columns(arrays, attribute, "");
  }
  for (const Attribute& attribute : attributes.triangles) {
    append_columns(arrays, attribute, "face_");
  }
  return arrays;
}

}  // namespace morskin::geometry
