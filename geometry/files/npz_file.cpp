// NPZ: NumPy's arrays, one file each in a ZIP archive, without compression. Written only.
//
//   vertices (n, 3) float64, faces (m, 3) uint32, normals (n, 3) float64
//   by vertex a column of each attribute (n), by triangle the same with face_ before its name
//   the arrays beside the mesh, texts as <U
//   numbers of the provenance as 0-d arrays; metadata, all of it as a JSON text

#include <archive.h>
#include <archive_entry.h>

#include <algorithm>
#include <bit>
#include <cstddef>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <type_traits>

#include "geometry/error.h"
#include "geometry/files/attribute_arrays.h"
#include "geometry/files/mesh_formats.h"
#include "geometry/files/provenance_json.h"
#include "geometry/files/text_lines.h"

namespace morskin::geometry::mesh_formats {
namespace {

static_assert(std::endian::native == std::endian::little);
static_assert(sizeof(Point) == 3 * sizeof(double));

/// A shape as Python spells it, "(12, 3)" or "(12,)".
std::string shape_of(std::size_t rows, std::optional<std::size_t> columns = {}) {
  std::string text = "(";
  text += std::to_string(rows);
  text += columns ? ", " + std::to_string(*columns) : ",";
  return text + ")";
}

/// An array in NumPy's format, version 1.0.
std::string npy(std::string_view type, const std::string& shape, const void* data,
                std::size_t size) {
  constexpr std::size_t alignment = 64, before = 10;
  std::string header =
      "{'descr': '" + std::string(type) + "', 'fortran_order': False, 'shape': " + shape + ", }";
  const std::size_t whole = (before + header.size() + 1 + alignment - 1) / alignment * alignment;
  header.resize(whole - before - 1, ' ');
  header += '\n';
  const auto length = static_cast<std::uint16_t>(header.size());
  std::string bytes = "\x93NUMPY\x01";
  bytes += '\0';
  bytes.append(reinterpret_cast<const char*>(&length), sizeof length);
  bytes += header;
  if (size > 0) bytes.append(static_cast<const char*>(data), size);
  return bytes;
}

template <class Number>
std::string npy(std::string_view type, const std::string& shape,
                const std::vector<Number>& numbers) {
  return npy(type, shape, numbers.data(), numbers.size() * sizeof(Number));
}

/// A 0-d array of ASCII, four bytes a character.
std::string npy_text(const std::string& text) {
  const std::vector<std::uint32_t> characters(text.begin(), text.end());
  return npy("<U" + std::to_string(text.size()), "()", characters);
}

/// A ZIP archive in memory; libarchive fails here only where memory is short.
class Archive {
 public:
  Archive() {
    require(archive_ != nullptr && entry_ != nullptr);
    require(::archive_write_set_format_zip(archive_.get()) == ARCHIVE_OK);
    require(::archive_write_zip_set_compression_store(archive_.get()) == ARCHIVE_OK);
    require(::archive_write_set_bytes_per_block(archive_.get(), 0) == ARCHIVE_OK);
    require(::archive_write_open(archive_.get(), &bytes_, nullptr, append, nullptr) == ARCHIVE_OK);
  }

  /// Adds an array. Without a time: the same bytes every time. @pre the name is new
  void add(const std::string& name, const std::string& bytes) {
    ::archive_entry_clear(entry_.get());
    ::archive_entry_set_pathname(entry_.get(), (name + ".npy").c_str());
    ::archive_entry_set_size(entry_.get(), static_cast<la_int64_t>(bytes.size()));
    ::archive_entry_set_filetype(entry_.get(), AE_IFREG);
    ::archive_entry_set_perm(entry_.get(), 0644);
    require(::archive_write_header(archive_.get(), entry_.get()) == ARCHIVE_OK);
    require(::archive_write_data(archive_.get(), bytes.data(), bytes.size()) ==
            static_cast<la_ssize_t>(bytes.size()));
  }

  /// The bytes of the whole. @pre called once, last
  std::string close() {
    require(::archive_write_close(archive_.get()) == ARCHIVE_OK);
    return std::move(bytes_);
  }

 private:
  static void require(bool has_worked) {
    if (!has_worked) throw std::bad_alloc();
  }
  static la_ssize_t append(archive* /*writer*/, void* bytes, const void* block, std::size_t size) {
    try {
      static_cast<std::string*>(bytes)->append(static_cast<const char*>(block), size);
    } catch (const std::exception&) {  // may not pass through C
      return -1;
    }
    return static_cast<la_ssize_t>(size);
  }
  struct Free {
    void operator()(archive* written) const { ::archive_write_free(written); }
    void operator()(archive_entry* entry) const { ::archive_entry_free(entry); }
  };

  std::string bytes_;
  std::unique_ptr<archive, Free> archive_{::archive_write_new()};
  std::unique_ptr<archive_entry, Free> entry_{::archive_entry_new()};
};

/// Texts as NumPy's, each as wide as the longest, padded with zeros.
std::string npy_texts(const std::string& shape, const std::vector<std::string>& texts) {
  std::size_t width = 1;
  for (const std::string& text : texts) width = std::max(width, text.size());
  std::vector<std::uint32_t> characters(width * texts.size(), 0);
  for (std::size_t i = 0; i < texts.size(); ++i) {
    std::ranges::transform(texts[i], characters.begin() + static_cast<std::ptrdiff_t>(i * width),
                           [](char c) { return static_cast<unsigned char>(c); });
  }
  return npy("<U" + std::to_string(width), shape, characters);
}

void add_array(Archive& archive, const NamedArray& array) {
  std::visit(
      [&]<class Value>(const std::vector<Value>& values) {
        const std::string shape = array.columns == 1
                                      ? shape_of(values.size())
                                      : shape_of(values.size() / array.columns, array.columns);
        if constexpr (std::is_same_v<Value, std::string>) {
          archive.add(array.name, npy_texts(shape, values));
        } else {
          constexpr std::string_view type = std::is_same_v<Value, double> ? "<f8"
                                            : sizeof(Value) == 4          ? "<i4"
                                                                          : "<i8";
          archive.add(array.name, npy(type, shape, values));
        }
      },
      array.values);
}

void add_provenance(Archive& archive, const Provenance& provenance) {
  for (const auto& [key, value, is_number] : provenance.entries) {
    const std::optional<double> number = is_number ? parse_double(value) : std::nullopt;
    if (number) archive.add(key, npy("<f8", "()", std::vector{*number}));
  }
  archive.add("metadata", npy_text(provenance_json(provenance).dump()));
}

}  // namespace

std::string npz(const IndexedMesh& mesh, const MeshAttributes& attributes) {
  Archive archive;
  archive.add("vertices", npy("<f8", shape_of(mesh.positions.size(), 3), mesh.positions));
  archive.add("faces", npy("<u4", shape_of(mesh.triangles.size(), 3), mesh.triangles));
  if (!attributes.normals.empty()) {
    archive.add("normals", npy("<f8", shape_of(mesh.positions.size(), 3), attributes.normals));
  }
  for (const NamedArray& array : attribute_arrays(attributes)) add_array(archive, array);
  for (const NamedArray& array : attributes.arrays) add_array(archive, array);
  add_provenance(archive, attributes.provenance);
  return archive.close();
}

}  // namespace morskin::geometry::mesh_formats
