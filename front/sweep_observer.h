#pragma once

#include <cstddef>
#include <functional>
#include <utility>

#include "front/departures.h"
#include "front/front.h"
#include "morse/critical_point.h"

namespace morskin::front {

/// The operations of section 4.1 that are counted.
enum class Operation { Creation, Creep, Wing, Bridge, Seal };

/// Watches a sweep. No callback may change the sweep; only the last two may coarsen and compact the
/// mesh behind the front. Every callback does nothing unless overridden.
class SweepObserver : public FrontMirror {
 public:
  void follow(const FrontChange&) override {}
  virtual void operation_done(Operation, const Front&) {}
  /// The front has come to a departure vertex.
  virtual void departed(const Departure&, const Front&) {}
  /// A departure has been marked, red or green, in the sphere of a critical point.
  virtual void marked(morse::CriticalId, const Departure&) {}
  /// No operation is under way. May change and compact the mesh behind the front.
  virtual void between_departures(Front&) {}
  /// The same, when nothing is left that the front can reach.
  virtual void finished(Front&) {}
};

/// Calls back after each operation with the number of triangles there are by then. Without
/// coarsening, triangles come in the order of their ids. With it they are fewer than were laid: of
/// a mesh that records births the number is of those laid.
class OperationObserver : public SweepObserver {
 public:
  using Callback = std::function<void(Operation, std::size_t triangles)>;
  explicit OperationObserver(Callback callback) : callback_(std::move(callback)) {}
  void operation_done(Operation operation, const Front& front) override {
    const surface::Mesh& mesh = front.mesh();
    callback_(operation, mesh.births ? mesh.births->laid() : mesh.surface.triangle_count());
  }

 private:
  Callback callback_;
};

}  // namespace morskin::front
