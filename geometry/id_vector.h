#pragma once

#include <vector>

namespace morskin::geometry {

/// A flat array indexed by a strong id. It is a plain table: what follows a mesh is VertexData and
/// TriangleData (mesh_data.h).
template <class Index, class T>
class IdVector : private std::vector<T> {
  using Base = std::vector<T>;

 public:
  using Base::assign, Base::back, Base::begin, Base::clear, Base::data, Base::emplace_back,
      Base::empty, Base::end, Base::insert, Base::push_back, Base::reserve, Base::resize,
      Base::size;
  using Base::Base;
  using typename Base::const_iterator, typename Base::iterator, typename Base::value_type;
  IdVector() = default;
  explicit IdVector(Base values) : Base(std::move(values)) {}

  T& operator[](Index i) { return Base::operator[](i.index()); }
  const T& operator[](Index i) const { return Base::operator[](i.index()); }
};

}  // namespace morskin::geometry
